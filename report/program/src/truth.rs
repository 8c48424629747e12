//! Exact results of functions.
//!
//! In: a scene. Out: a folder for `measured`, with its states and, for each function, every entry of every result to
//! 106 bits with the magnitude that errors are relative to. The folder `f32` in it has the same for the states rounded
//! to single precision, if they differ. The values are those of the expressions in the frames and with the parameters
//! of the description, before anything is regrouped or simplified.

use std::path::Path;
use std::{fs, io};

use homogen_codegen::Function;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Algorithm;
use homogen_codegen::space::{FrameId, Space, Variable};
use homogen_magnitude::{Magnitude, Measure};

use crate::scene::Scene;
use crate::states::in_single_precision;

/// A number of 106 bits with the magnitude of its terms; for every type, and so without a lower limit.
pub type Exact = Magnitude<OfEveryType>;

/// The type parameter of [`Exact`]: every type of number.
#[derive(Clone, Copy, Debug)]
pub struct OfEveryType;

impl Measure for OfEveryType {
    type Value = Double;
    const FLOOR: f64 = 0.0;

    fn nearest(value: Double) -> f64 {
        value.to_f64()
    }
}

/// Writes states and exact results to a folder.
///
/// # Errors
/// Errors of the robot's description; a file that cannot be written.
pub fn write(scene: &Scene, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let chain: Chain = chain::build(&scene.description, &scene.request)
        .map_err(as_one)?
        .identified();
    let single = folder.join("f32");
    if single.exists() {
        fs::remove_dir_all(&single)?;
    }
    write_of(scene, &chain, &scene.states, folder)?;
    if let Some(states) = in_single_precision(&scene.states) {
        write_of(scene, &chain, &states, &single)?;
    }
    Ok(())
}

fn write_of(scene: &Scene, chain: &Chain, states: &[f64], folder: &Path) -> io::Result<()> {
    let lengths = [Space::Coordinates, Space::Velocities].map(|space| scene.length(space));
    let [coordinates, velocities] = lengths;
    fs::create_dir_all(folder)?;
    fs::write(
        folder.join("lengths"),
        format!("{coordinates} {velocities}"),
    )?;
    save(&folder.join("states"), states)?;
    for &function in &scene.functions {
        let mut numbers = Vec::new();
        let evaluation = evaluation(chain, function);
        for state in states.chunks_exact(coordinates + 3 * velocities) {
            let exact = exact(&evaluation, function, coordinates, state);
            numbers.extend(exact.into_iter().flatten());
        }
        save(&folder.join(function.name()), &numbers)?;
    }
    Ok(())
}

/// The errors of a description as one error.
#[expect(clippy::needless_pass_by_value, reason = "for `map_err`")]
pub fn as_one(errors: Errors) -> Box<dyn std::error::Error> {
    errors.to_string().into()
}

/// A function in the frames and with the parameters of the description, before anything is simplified.
pub fn evaluation(chain: &Chain, function: Function) -> Evaluation<Exact> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function.build(&graph, &bodies, FrameId::FIRST, Algorithm::PLAIN);
    let results: Vec<Expr> = results.into_iter().map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

/// The number of an input in a state, for a robot with `coordinates` coordinates.
pub fn given(state: &[f64], coordinates: usize, input: Input) -> f64 {
    let (q, rates) = state.split_at(coordinates);
    match input {
        Input::Variable(Variable::Q, k) => q[usize::from(k)],
        // A state lists the others in their order; its torques are weights, changes and a wrench as well. Where a
        // function has both, the change is in proportion to the torques.
        Input::Variable(variable, k) => {
            let count = rates.len() / 3;
            let listed = match variable {
                Variable::Weights | Variable::Wrench => Variable::Tau,
                change if change.is_change() => Variable::Tau,
                other => other,
            };
            rates[(listed as usize - 1) * count + usize::from(k) % count.max(1)]
        }
        Input::Parameter(..) => unreachable!("no number was left open"),
    }
}

/// High part, low part and magnitude of each result at a state. The magnitude of results by division is the largest
/// result, since their terms may be far larger than the results; the same for results that are always zero.
pub fn exact(
    evaluation: &Evaluation<Exact>,
    function: Function,
    coordinates: usize,
    state: &[f64],
) -> Vec<[f64; 3]> {
    let results = evaluation.at(|input| Exact::given(given(state, coordinates, input)));
    let sizes = results.iter().map(|x| x.value().to_f64().abs());
    let largest = sizes.fold(0.0, f64::max);
    let divides = matches!(
        function,
        Function::ForwardDynamics
            | Function::ForwardDynamicsDerivatives
            | Function::MassMatrixInverse
    );
    let entry = |x: &Exact| {
        let (high, low) = x.value().bits();
        let whole = divides || x.size() == 0.0;
        let magnitude = if whole { largest } else { x.size() };
        [f64::from_bits(high), f64::from_bits(low), magnitude]
    };
    results.iter().map(entry).collect()
}

fn save(path: &Path, numbers: &[f64]) -> io::Result<()> {
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(path, bytes)
}

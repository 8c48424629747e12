//! What functions should return.
//!
//! In: a scene. Out: a folder with its states and, for each function, every entry of every result to
//! 106 bits with the magnitude that an error is measured by, as `measured` reads them. The values are
//! those of the expressions in the frames and with the parameters of the description, before
//! anything is regrouped or simplified.

use std::path::Path;
use std::{fs, io};

use homogen_codegen::Function;
use homogen_codegen::chain::frames::{Layout, arrange};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::{Double, Expr, Graph, Input, Node, Term};
use homogen_codegen::model::{self, Way};

use crate::scene::Scene;

/// Writes states and exact results to a folder.
///
/// # Errors
/// Where the robot has mistakes; where a file cannot be written.
pub fn write(scene: &Scene, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let chain: Chain = chain::build(&scene.description, &scene.request).map_err(told)?;
    fs::create_dir_all(folder)?;
    fs::write(folder.join("joints"), scene.joints.to_string())?;
    save(&folder.join("states"), &scene.states)?;
    for &function in &scene.functions {
        let mut numbers = Vec::new();
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
        let results = model::build(&graph, &bodies, function, 0, Way::PLAIN);
        let results: Vec<Expr> = results.into_iter().map(Term::expr).collect();
        for state in scene.states.chunks_exact(4 * scene.joints) {
            numbers.extend(
                exact(&graph, &results, function, state)
                    .into_iter()
                    .flatten(),
            );
        }
        save(&folder.join(function.name()), &numbers)?;
    }
    Ok(())
}

/// Mistakes as one error.
#[expect(clippy::needless_pass_by_value, reason = "for `map_err`")]
pub fn told(errors: Errors) -> Box<dyn std::error::Error> {
    errors.to_string().into()
}

/// A value to 106 bits, and the sum of the magnitudes that it was summed from.
#[derive(Clone, Copy)]
struct Summed {
    value: Double,
    magnitude: f64,
}

/// High part, low part and magnitude of each result at a state. What is found by division has the
/// largest result for its magnitude: its terms may be far larger than itself.
fn exact(graph: &Graph, results: &[Expr], function: Function, state: &[f64]) -> Vec<[f64; 3]> {
    let joints = state.len() / 4;
    let input = |input| {
        let (part, k) = match input {
            Input::Q(k) => (0, k),
            Input::Qd(k) => (1, k),
            Input::Qdd(k) => (2, k),
            Input::Tau(k) => (3, k),
            Input::Parameter(..) => unreachable!("no number was left open"),
        };
        state[part * joints + usize::from(k)]
    };
    let values = evaluate(graph, results, input);
    let largest = values
        .iter()
        .map(|x| x.value.to_f64().abs())
        .fold(0.0, f64::max);
    let divides = matches!(
        function,
        Function::ForwardDynamics | Function::MassMatrixInverse
    );
    let entry = |x: &Summed| {
        let (high, low) = x.value.bits();
        let magnitude = if divides { largest } else { x.magnitude };
        [f64::from_bits(high), f64::from_bits(low), magnitude]
    };
    values.iter().map(entry).collect()
}

fn evaluate(graph: &Graph, results: &[Expr], input: impl Fn(Input) -> f64) -> Vec<Summed> {
    let (needed, _) = graph.needed(results);
    let size = needed.last().map_or(0, |expr| expr.index() + 1);
    let zero = Summed {
        value: Double::ZERO,
        magnitude: 0.0,
    };
    let mut values = vec![zero; size];
    let alone = |value: Double| Summed {
        value,
        magnitude: value.to_f64().abs(),
    };
    for expr in needed {
        let at = |expr: Expr| values[expr.index()];
        values[expr.index()] = if let Some(value) = graph.value(expr) {
            alone(value)
        } else {
            match graph.node(expr) {
                Node::Literal(bits) => alone(Double::from(f64::from_bits(bits))),
                Node::Input(of) => alone(Double::from(input(of))),
                Node::Neg(a) => Summed {
                    value: -at(a).value,
                    ..at(a)
                },
                Node::Add(a, b) => Summed {
                    value: at(a).value + at(b).value,
                    magnitude: at(a).magnitude + at(b).magnitude,
                },
                Node::Sub(a, b) => Summed {
                    value: at(a).value - at(b).value,
                    magnitude: at(a).magnitude + at(b).magnitude,
                },
                Node::Mul(a, b) => Summed {
                    value: at(a).value * at(b).value,
                    magnitude: at(a).magnitude * at(b).magnitude,
                },
                Node::Div(a, b) => alone(at(a).value / at(b).value),
                Node::Sqrt(a) => alone(at(a).value.sqrt()),
                Node::Sin(a) => alone(at(a).value.sin_cos().0),
                Node::Cos(a) => alone(at(a).value.sin_cos().1),
            }
        };
    }
    let results = results.iter();
    results.map(|expr| values[expr.index()]).collect()
}

fn save(path: &Path, numbers: &[f64]) -> io::Result<()> {
    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    fs::write(path, bytes)
}

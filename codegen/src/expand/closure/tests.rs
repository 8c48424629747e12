//! Tests of loops of every type against laws of mechanics: the robots with closed loops, and evaluation of programs at
//! their states.
//!
//! Every expansion here is also compared with dense matrices.

mod data;
mod equations;
mod motion;
mod refused;
mod singular;

use std::path::Path;

use crate::chain::Chain;
use crate::closure::ALL;
use crate::description::{Description, inline};
use crate::error::Errors;
use crate::expand::understand;
use crate::expression::Input;
use crate::function::Function;
use crate::layout::Layout;
use crate::list::Id;
use crate::model::Algorithm;
use crate::plan::program_by;
use crate::request::Request;
use crate::schedule::{Program, run};
use crate::space::{FrameId, Variable};

/// Two arms on one trunk with axes in general directions and a joint of each type.
const ARMS: &str = "
pub struct Arms;
link base;
joint trunk: revolute([0.6, 0.0, 0.8]) { at: xyz(0.1, 0.2, 0.3) rpy(0.1, -0.2, 0.3) }
link trunk { mass: 2.0, com: [0.1, 0.0, 0.2], inertia: [0.02, 0.03, 0.04, 0.001, 0.002, 0.003] }
joint left_1: universal(x, [0.0, 0.8, 0.6]) { at: xyz(0.2, 0.1, 0.0) rpy(0.0, 0.5, 0.0) }
link left_1 { mass: 1.0, com: [0.1, 0.02, 0.0], inertia: [0.01, 0.01, 0.02] }
joint left_2: prismatic([0.0, 0.6, -0.8]) { at: xyz(0.3, 0.0, 0.1) }
link left_2 { mass: 0.7, com: [0.0, 0.1, 0.05], inertia: [0.01, 0.02, 0.01] }
joint left_3: spherical { at: xyz(0.0, 0.2, 0.1) rpy(0.2, 0.1, 0.0) }
link left_3 { mass: 0.5, com: [0.05, 0.0, 0.1], inertia: [0.004, 0.003, 0.002] }
joint right_1: planar([0.0, 0.6, 0.8]) { from: trunk, at: xyz(-0.2, 0.1, 0.1) }
link right_1 { mass: 0.9, com: [0.0, 0.1, 0.0], inertia: [0.01, 0.02, 0.02] }
joint right_2: screw(y, pitch: 0.05) { at: xyz(0.1, 0.1, 0.0) rpy(0.3, 0.0, 0.1) }
link right_2 { mass: 0.4, com: [0.1, 0.0, 0.02], inertia: [0.003, 0.002, 0.004] }
";

/// A four-bar, open at the pin.
const FOUR_BAR: &str = "
pub struct FourBar { gravity: [0.0, -9.81, 0.0] }
link ground;
joint a: revolute(z);
link crank { mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-4, 4e-4, 5e-4] }
joint b: revolute(z) { at: xyz(0.1, 0.0, 0.0) }
link coupler { mass: 0.8, com: [0.15, 0.0, 0.0], inertia: [1e-4, 6e-3, 6e-3] }
joint c: revolute(z) { from: ground, at: xyz(0.35, 0.0, 0.0) }
link rocker { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
";

const PIN: &str = "loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0), \
                   to_at: xyz(0.2, 0, 0) }";

fn described(text: &str) -> (Description, Request) {
    let mut errors = Errors::new();
    let item = inline::read(
        text.parse().expect("tokens"),
        Path::new("nowhere"),
        &mut errors,
    );
    assert!(errors.is_empty(), "{errors}");
    let item = item.expect("no mistakes, so a robot");
    (item.description.expect("it is in place"), item.request)
}

fn chain(text: &str) -> Result<Chain, String> {
    let (description, request) = described(text);
    understand(&description, &request).map_err(|errors| errors.to_string())
}

fn plain(chain: &Chain, function: Function) -> Program {
    program_by(
        chain,
        &[function],
        FrameId::FIRST,
        Layout::DESCRIBED,
        Algorithm::PLAIN,
    )
}

/// The results of a program for q, q̇, q̈ and τ.
fn values(program: &Program, state: [&[f64]; 4]) -> Vec<f64> {
    run(program, |input| match input {
        Input::Variable(variable, k) => {
            let place = Variable::ALL.iter().position(|other| *other == variable);
            state[place.expect("one of all")][usize::from(k)]
        }
        Input::Parameter(..) => unreachable!("no fields"),
    })
}

/// Numbers that fill (−1, 1) evenly.
fn numbers(count: usize, seed: usize) -> Vec<f64> {
    let number = |k: usize| {
        let k = u32::try_from(k + 17 * seed + 1).expect("few");
        2.0 * (f64::from(k) * 0.618_033_988_749_895).fract() - 1.0
    };
    (0..count).map(number).collect()
}

/// Coordinates whose quaternions have length 1.
fn upright(chain: &Chain, seed: usize) -> Vec<f64> {
    let spaces = chain.spaces();
    let mut q = numbers(spaces.coordinates.len(), seed);
    for first in spaces.quaternions() {
        let entries = &mut q[first.index()..][..4];
        let length = entries.iter().map(|x| x * x).sum::<f64>().sqrt();
        for entry in entries {
            *entry /= length;
        }
    }
    q
}

/// Each type of loop as it is written, with its number of residuals.
fn kinds() -> Vec<(String, usize)> {
    let inside = |word: &str, axes: usize| match (word, axes) {
        ("rod", _) => "(0.37)",
        (_, 0) => "",
        (_, 1) => "([0.48, 0.6, 0.64])",
        _ => "([0.0, 0.6, 0.8], y)",
    };
    (ALL.iter())
        .map(|kind| {
            let text = format!("{}{}", kind.word, inside(kind.word, kind.axes));
            (text, kind.rows.len())
        })
        .collect()
}

fn arms_held_by(kind: &str) -> String {
    let arms = ARMS.replace(
        "Arms;",
        "Arms { actuated(trunk, left_2, right_1, right_2) }",
    );
    format!(
        "{arms}loop held: {kind} {{ from: left_3, to: right_2, at: xyz(0.1, 0.0, 0.2) rpy(0.3, 0.1, 0.2), \
         to_at: xyz(0.0, 0.1, -0.1) rpy(0.0, 0.4, 0.1) }}"
    )
}

/// The four-bar with its crank at an angle, by the cosine rule.
fn closed_four_bar(crank: f64) -> [f64; 3] {
    let (sine, cosine) = crank.sin_cos();
    let [x, y] = [0.35 - 0.1 * cosine, -0.1 * sine];
    let distance = x.hypot(y);
    let inner = ((0.09 + distance * distance - 0.04) / (0.6 * distance)).acos();
    let coupler = y.atan2(x) + inner;
    let [dx, dy] = [0.3 * coupler.cos() - x, 0.3 * coupler.sin() - y];
    [crank, coupler - crank, dy.atan2(dx)]
}

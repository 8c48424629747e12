//! The states at which an expansion is checked.
//!
//! In: a chain. Out: states drawn from the hash of its description, the same on every platform: coordinates within
//! their limits, fields near their described values; and states with closed loops for robots with loops.

use super::closing;
use super::robot::Contradiction;
use crate::chain::Chain;
use crate::dense::{Dense, State};
use crate::expression::Double;
use crate::list::Id;
use crate::quaternion::normalize;
use crate::random::Random;
use crate::space::{Entry, Kind, Spaces, Variable};

/// A number of states.
pub(super) fn states(chain: &Chain, count: usize) -> Vec<State> {
    let mut random = seeded(chain);
    (0..count).map(|_| state(chain, &mut random)).collect()
}

/// The state with closed loops of that number; `None` for a robot without loops.
///
/// # Errors
/// Those of `at`.
pub(super) fn closed(
    chain: &Chain,
    number: usize,
    at: impl Fn(&State) -> Result<Dense, Contradiction>,
) -> Result<Option<State>, Contradiction> {
    /// Number of states from which a closed one is searched.
    const STARTS: usize = 8;
    if chain.loops.is_empty() {
        return Ok(None);
    }
    let starts = states(chain, STARTS * (number + 1)).into_iter();
    closing::closed(starts.skip(STARTS * number).collect(), chain, at)
}

/// Arguments over one space each, which take turns.
const FIRST: [&[Variable]; 3] = [
    &[Variable::Qd, Variable::Qdd, Variable::Tau],
    &[Variable::Actions],
    &[Variable::Weights],
];

fn state(chain: &Chain, random: &mut Random) -> State {
    let spaces = chain.spaces();
    let mut state = State::default();
    for coordinate in &spaces.coordinates {
        let [lower, upper] = reach(coordinate);
        let q = lower + (upper - lower) * random.unit();
        state.arguments[Variable::Q].push(q.into());
    }
    of_length_1(&mut state, spaces);
    for variables in FIRST {
        for _ in spaces.entries(variables[0].space()) {
            for &variable in variables {
                state.arguments[variable].push(drawn(variable, random));
            }
        }
    }
    // From numbers of their own, so that a further argument changes no carried test of another function.
    let mut own = Random(random.0);
    for variable in Variable::ALL {
        if state.arguments[variable].is_empty() {
            let entries = spaces.entries(variable.space()).iter();
            state.arguments[variable] = entries.map(|_| drawn(variable, &mut own)).collect();
        }
    }
    for (parameter, nominal) in chain.request.parameters.iter().zip(&chain.nominal) {
        let fields = parameter.near(nominal, || random.unit());
        state.fields.push(fields);
    }
    state
}

/// States without regard to limits, with fields as described: rotations of up to half a turn, lengths and times on the
/// scale of the robot's offsets and of gravity, so that no term of a torque is lost beside another.
pub(super) fn wide(chain: &Chain, count: usize) -> Vec<State> {
    let mut random = seeded(chain);
    let length = length(chain);
    let time = (length / 9.81).sqrt();
    (0..count)
        .map(|_| state_within(chain, &mut random, [length, time]))
        .collect()
}

fn state_within(chain: &Chain, random: &mut Random, [length, time]: [f64; 2]) -> State {
    let spaces = chain.spaces();
    let mut drawn = |kind: Kind| {
        let unit = if kind == Kind::Translation {
            length
        } else {
            1.0
        };
        3.0 * unit * (2.0 * random.unit() - 1.0)
    };
    let mut state = State {
        fields: chain.nominal.clone(),
        ..State::default()
    };
    for coordinate in &spaces.coordinates {
        state.arguments[Variable::Q].push(drawn(coordinate.kind).into());
    }
    of_length_1(&mut state, spaces);
    for velocity in &spaces.velocities {
        for (variable, unit) in [(Variable::Qd, time), (Variable::Qdd, time * time)] {
            let entry = drawn(velocity.kind) / unit;
            state.arguments[variable].push(entry.into());
        }
    }
    state
}

/// An entry of an argument.
fn drawn(variable: Variable, random: &mut Random) -> Double {
    let size = match variable {
        Variable::Qd => 2.0,
        Variable::Qdd => 5.0,
        Variable::Tau | Variable::Wrench | Variable::Actions => 10.0,
        _ => 1.0,
    };
    (2.0 * size * random.unit() - size).into()
}

/// Normalizes the quaternions among the coordinates.
fn of_length_1(state: &mut State, spaces: &Spaces) {
    for quaternion in spaces.quaternions() {
        normalize(&mut state.arguments[Variable::Q][quaternion.index()..][..4]);
    }
}

/// The longest offset between joints \[m\]; 1 m if there is none.
fn length(chain: &Chain) -> f64 {
    let hung = chain.joints.iter().filter(|joint| joint.parent.is_some());
    let offsets = hung.map(|joint| {
        let entries = joint.placement.translation.0;
        let entries = entries.map(|entry| chain.graph.value(entry).map_or(0.0, Double::to_f64));
        entries
            .iter()
            .map(|entry| entry * entry)
            .sum::<f64>()
            .sqrt()
    });
    let longest = offsets.fold(0.0, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// The range of a random coordinate: the described one, limited so that angles keep their digits.
fn reach(coordinate: &Entry) -> [f64; 2] {
    const FARTHEST: f64 = 1e6;
    match (coordinate.range, coordinate.kind) {
        (Some(ends), _) => ends.map(|end| end.clamp(-FARTHEST, FARTHEST)),
        (None, Kind::Rotation) => [-3.0, 3.0],
        (None, _) => [-1.0, 1.0],
    }
}

/// Random numbers seeded with the hash of a description and the names of its joints.
fn seeded(chain: &Chain) -> Random {
    let names = chain.joints.iter().flat_map(|joint| joint.name.bytes());
    Random(names.fold(chain.description.source.hash, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    }))
}

//! The states at which an expansion is checked.
//!
//! In: a chain. Out: states drawn from the hash of its description, the same on every machine:
//! coordinates within their limits, fields near what is described in their place; and states of a robot with loops
//! in which these are closed.

use super::closing;
use super::robot::Contradiction;
use crate::chain::Chain;
use crate::dense::{Dense, State};
use crate::expression::Double;
use crate::list::Id;
use crate::quaternion::normalize;
use crate::random::Random;
use crate::request::Request;
use crate::space::{Entry, Kind};

/// So many states.
pub(super) fn states(chain: &Chain, request: &Request, count: usize) -> Vec<State> {
    let mut random = seeded(chain);
    (0..count)
        .map(|_| state(chain, request, &mut random))
        .collect()
}

/// The state of that number whose loops are closed; none of a robot without loops.
///
/// # Errors
/// Those of `at`.
pub(super) fn closed(
    chain: &Chain,
    request: &Request,
    number: usize,
    at: impl Fn(&State) -> Result<Dense, Contradiction>,
) -> Result<Option<State>, Contradiction> {
    /// From how many states the way to a closed one is looked for.
    const STARTS: usize = 8;
    if chain.loops.is_empty() {
        return Ok(None);
    }
    let starts = states(chain, request, STARTS * (number + 1)).into_iter();
    closing::closed(starts.skip(STARTS * number).collect(), chain, at)
}

fn state(chain: &Chain, request: &Request, random: &mut Random) -> State {
    let spaces = chain.spaces();
    let mut state = State::default();
    for coordinate in &spaces.coordinates {
        let [lower, upper] = reach(coordinate);
        let q = lower + (upper - lower) * random.unit();
        state.q.push(q.into());
    }
    for quaternion in spaces.quaternions() {
        let q: &mut [Double] = &mut state.q;
        normalize(&mut q[quaternion.index()..][..4]);
    }
    for _ in &spaces.velocities {
        state.qd.push(4.0 * random.unit() - 2.0);
        state.qdd.push(10.0 * random.unit() - 5.0);
        state.tau.push(20.0 * random.unit() - 10.0);
    }
    for _ in &spaces.actions {
        state.actions.push(20.0 * random.unit() - 10.0);
    }
    for (parameter, nominal) in request.parameters.iter().zip(&chain.nominal) {
        let fields = parameter.near(nominal, || random.unit());
        state.fields.push(fields);
    }
    state
}

/// Where a coordinate is drawn from: what is described, as far as that is a range within which a
/// turn has digits.
fn reach(coordinate: &Entry) -> [f64; 2] {
    const FARTHEST: f64 = 1e6;
    match (coordinate.range, coordinate.kind) {
        (Some(ends), _) => ends.map(|end| end.clamp(-FARTHEST, FARTHEST)),
        (None, Kind::Turn) => [-3.0, 3.0],
        (None, _) => [-1.0, 1.0],
    }
}

/// From the hash of a description, and the names of its joints.
fn seeded(chain: &Chain) -> Random {
    let names = chain.joints.iter().flat_map(|joint| joint.name.bytes());
    Random(names.fold(chain.source.hash, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    }))
}

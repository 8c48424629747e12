//! Energies of links for each of their inertial parameters, at a few states.
//!
//! In: a chain and its numbers; the number of states for each body. Out: for each parameter and state, twice the
//! kinetic energy and the potential energy of a unit of it, each with the size of its terms. Both are quadratic and
//! linear in quantities in the link's own frame: T = ½ Tr(V J Vᵗ) with its velocity V, and −U = γ J e₄ with γ,
//! gravity and the height of the frame.

use super::blocks::LinkId;
use super::numbers::{MOMENTS, Numbers, PLACES, norm};
use crate::chain::{BodyId, Chain, Joint, Position};
use crate::dense::Matrix;
use crate::expression::Double;
use crate::list::{Id, List};
use crate::random::Random;
use crate::space::{CoordinateId, Kind, VelocityId};

/// Largest random angle \[rad\]. It separates joints that mimic one coordinate with nearly the same multiplier.
const FAR: f64 = 300.0;

/// The energies of all links at some states.
pub(super) struct Energies {
    /// For each state, the energies of each body that is needed there.
    states: Vec<List<BodyId, Option<LinkEnergies>>>,
    /// For each state, q̇ times the multiplier of each joint.
    rates: Vec<List<BodyId, Double>>,
    /// The body of each link.
    links: List<LinkId, BodyId>,
}

/// The energies of a link at a state.
struct LinkEnergies {
    /// Twice the kinetic energy of a unit of each parameter.
    kinetic: [Double; MOMENTS],
    /// The negative potential energy of a unit of m, q_x, q_y and q_z.
    height: [Double; 4],
    /// Sizes of rotation, translation, gravity and height.
    size: Size,
}

/// Sizes of the terms of a body's motion, in any axes.
#[derive(Clone, Copy)]
struct Size {
    angular: f64,
    linear: f64,
    gravity: f64,
    height: f64,
}

/// A body at a state, in its own frame.
struct BodyState {
    velocity: Matrix<Double>,
    gravity: [Double; 4],
    size: Size,
}

/// An entry of a column, with the size of its terms.
pub(super) type SizedEntry = (Double, f64);

impl Energies {
    /// The energies of links, with a number of states for each body.
    pub(super) fn of(
        chain: &Chain,
        numbers: &Numbers,
        links: &List<LinkId, BodyId>,
        often: &List<BodyId, usize>,
    ) -> Self {
        let most = often.iter().copied().max().unwrap_or(0);
        let length = numbers.length(chain);
        let spaces = chain.spaces();
        let mut ends: List<BodyId, Option<LinkId>> = chain.joints.map(|_| None);
        for (link, &body) in links.numbered() {
            ends[body] = Some(link);
        }
        // The same seed for all robots: the result must not change with a comment in a file.
        let mut random = Random(0);
        let mut drawn = |kind: Kind, angle: f64| {
            let translates = matches!(kind, Kind::Translation);
            let largest = if translates { 3.0 * length } else { angle };
            Double::from(largest * (2.0 * random.unit() - 1.0))
        };
        let mut energies = Self {
            states: Vec::new(),
            rates: Vec::new(),
            links: links.clone(),
        };
        for state in 0..most {
            let q = spaces.coordinates.map(|entry| drawn(entry.kind, FAR));
            let first = spaces.velocities.map(|entry| drawn(entry.kind, 3.0));
            let wanted = |body: BodyId| often[body] > state;
            energies
                .states
                .push(at(chain, numbers, &ends, wanted, &q, &first));
            let joints = chain.joints.iter().zip(&numbers.factors);
            let rates = joints.map(|(joint, &factor)| factor * first[joint.velocity]);
            energies.rates.push(rates.collect());
        }
        energies
    }

    /// Twice the kinetic energy of a unit of a link's parameter, and its negative potential energy, at the given
    /// numbers of states.
    pub(super) fn of_moment(
        &self,
        link: LinkId,
        moment: usize,
        [kinetic, potential]: [usize; 2],
    ) -> impl Iterator<Item = SizedEntry> {
        let body = self.links[link];
        let at = move |state: usize| {
            let found = self.states[state][body].as_ref();
            found.expect("it is looked at as often as is asked for")
        };
        let kinetic = (0..kinetic).map(move |state| {
            let LinkEnergies { kinetic, size, .. } = at(state);
            let size = match moment {
                0 => size.linear * size.linear,
                1..4 => size.linear * size.angular,
                _ => size.angular * size.angular,
            };
            (kinetic[moment], size)
        });
        let potential = (0..potential).map(move |state| {
            let LinkEnergies { height, size, .. } = at(state);
            match (height.get(moment), moment) {
                (Some(&height), 0) => (height, size.height),
                (Some(&height), _) => (height, size.gravity),
                (None, _) => (Double::ZERO, 0.0),
            }
        });
        kinetic.chain(potential)
    }

    /// The same for a unit of a joint's armature.
    pub(super) fn of_armature(
        &self,
        joint: BodyId,
        [kinetic, potential]: [usize; 2],
    ) -> impl Iterator<Item = SizedEntry> {
        let rates = self.rates[..kinetic].iter().map(move |rates| rates[joint]);
        let kinetic = rates
            .map(|rate| rate * rate)
            .map(|square| (square, square.to_f64()));
        kinetic.chain(std::iter::repeat_n((Double::ZERO, 0.0), potential))
    }
}

/// The energies of some bodies at q and q̇.
fn at(
    chain: &Chain,
    numbers: &Numbers,
    ends: &List<BodyId, Option<LinkId>>,
    wanted: impl Fn(BodyId) -> bool,
    q: &List<CoordinateId, Double>,
    first: &List<VelocityId, Double>,
) -> List<BodyId, Option<LinkEnergies>> {
    let mut moving: List<BodyId, Option<BodyState>> = List::new();
    for together in chain.joints.chunk_by(|_, next| is_taken(next)) {
        let k = moving.next();
        let bodies = (0..together.len()).map(|place| k.plus(place));
        if !bodies.clone().any(&wanted) {
            moving.extend(bodies.map(|_| None));
            continue;
        }
        let pose = displaced(numbers, together, k, q);
        let outer = together[0].parent.map(|parent| &moving[parent]);
        let mut found = match outer {
            Some(Some(outer)) => outer.seen_from(&pose),
            // The position of the base adds a constant to all potential energies.
            _ => BodyState::of_base(numbers).seen_from(&rotation(&pose, &numbers.placements[k])),
        };
        for (joint, body) in together.iter().zip(bodies.clone()) {
            let rate = numbers.factors[body] * first[joint.velocity];
            found.add(numbers.screws[body], rate);
        }
        // The last body of a joint with several velocities is the link.
        moving.extend(bodies.clone().skip(1).map(|_| None));
        moving.push(Some(found));
    }
    let energies = moving.numbered().map(|(body, moving)| {
        let link = ends[body]?;
        Some(moving.as_ref()?.seen_from(&numbers.links[link]).energies())
    });
    energies.collect()
}

fn is_taken(joint: &Joint) -> bool {
    matches!(joint.position, Position::Taken)
}

/// M of a joint's last body in the parent's frame: the product of its motions. For a joint without axes of its own, any
/// configuration of that product will do.
fn displaced(
    numbers: &Numbers,
    together: &[Joint],
    first: BodyId,
    q: &List<CoordinateId, Double>,
) -> Matrix<Double> {
    let mut pose = numbers.placements[first].clone();
    for (place, joint) in together.iter().enumerate() {
        let body = first.plus(place);
        let at = match (together[0].position, joint.position) {
            (_, Position::Along { coordinate, .. }) => numbers.factors[body] * q[coordinate],
            (Position::Manifold(_, first), _) => q[first.plus(place)],
            (_, _) => Double::ZERO,
        };
        pose = pose.times(&Matrix::displacement(numbers.screws[body], &at));
    }
    pose
}

/// The same pose, with its origin relative to the placement of the joint's frame.
fn rotation(pose: &Matrix<Double>, placement: &Matrix<Double>) -> Matrix<Double> {
    let mut rotation = pose.clone();
    let (to, from) = (pose.column(), placement.column());
    rotation.set_column([0, 1, 2].map(|k| to[k] - from[k]));
    rotation
}

impl BodyState {
    /// The base, at rest.
    fn of_base(numbers: &Numbers) -> Self {
        let [x, y, z] = numbers.gravity;
        Self {
            velocity: Matrix::zero(),
            gravity: [x, y, z, Double::ZERO],
            size: Size {
                angular: 0.0,
                linear: 0.0,
                gravity: norm(&numbers.gravity),
                height: 0.0,
            },
        }
    }

    /// The same motion in the frame at M: M⁻¹ V M and γ M.
    fn seen_from(&self, pose: &Matrix<Double>) -> Self {
        let offset = norm(&pose.column());
        let Size {
            angular,
            linear,
            gravity,
            height,
        } = self.size;
        Self {
            velocity: pose.inverse().times(&self.velocity).times(pose),
            gravity: [0, 1, 2, 3].map(|column| {
                let term = |row: usize| self.gravity[row] * pose.0[row][column];
                term(0) + term(1) + term(2) + term(3)
            }),
            size: Size {
                angular,
                linear: linear + angular * offset,
                gravity,
                height: height + gravity * offset,
            },
        }
    }

    /// Adds L times a velocity.
    fn add(&mut self, [u, b]: [[Double; 3]; 2], rate: Double) {
        let size = rate.to_f64().abs();
        self.size.angular += norm(&u) * size;
        self.size.linear += norm(&b) * size;
        self.velocity = self.velocity.plus(&Matrix::screw(u, b).scaled(&rate));
    }

    fn energies(&self) -> LinkEnergies {
        let Matrix(squares) = self.velocity.transposed().times(&self.velocity);
        let kinetic = PLACES.map(|(row, column)| {
            let entry = squares[row][column];
            if row == column { entry } else { entry + entry }
        });
        let [x, y, z, height] = self.gravity;
        LinkEnergies {
            kinetic,
            height: [height, x, y, z],
            size: self.size,
        }
    }
}

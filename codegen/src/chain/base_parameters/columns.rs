//! The regressor of a chain in numbers, at a few states, in dense matrices of frame 0.
//!
//! In: a chain, whose fields are what is described in their place. Out: columns of a link as some joints see
//! them. It decides nothing.

use crate::chain::{BodyId, Chain, Joint, Position};
use crate::dense::Matrix;
use crate::expression::{Double, Evaluation, Expr, Input};
use crate::joint::Motion;
use crate::list::{Id, List, id};
use crate::random::Random;
use crate::space::{CoordinateId, ParameterId, VelocityId};

/// How many inertial parameters a link has.
const PARAMETERS: usize = 10;

/// How many numbers say what a joint feels of its drive: armature, damping and friction.
const DRIVE: usize = 3;

/// The order in which columns of a link are taken, where not all are needed: off the diagonal first, the mass
/// last.
const ORDER: [usize; PARAMETERS] = [5, 6, 8, 4, 7, 9, 1, 2, 3, 0];

/// A parameter, and its column of the regressor.
pub type Column = (ParameterId, Vec<f64>);

/// Of how many joints on the way to a link columns are looked at, at most: half of them from the base outwards, half
/// from the link inwards.
const JOINTS: usize = 64;

id! {
    /// The number of a link that a joint moves: in every list that has an entry for each of [`Columns::links`].
    LinkId
}

/// A link that a joint moves.
pub struct Link {
    /// Which of the chain's joints does.
    joint: BodyId,
    /// That and those that are between it and the link it hangs on, from the base outwards.
    own: Vec<BodyId>,
    /// The link that it hangs on, with nothing but bodies of its own joint between; none for the base.
    pub parent: Option<LinkId>,
    /// The joints whose forces are looked at: those that move it, from the base outwards, or all where some follow
    /// others.
    path: Vec<BodyId>,
    /// At how many states it is looked at.
    states: usize,
}

/// The links of a chain, and their matrices at some states.
pub struct Columns {
    /// In the order of their joints.
    pub links: List<LinkId, Link>,
    /// Of each state, of each joint that is looked at there.
    states: Vec<List<BodyId, Option<At>>>,
    /// Of each state, the first and the second rates.
    rates: Vec<[List<VelocityId, f64>; 2]>,
    /// The velocity of each joint, and what its rate is times that.
    velocities: List<BodyId, (VelocityId, f64)>,
    /// Of each joint; none where drives are not identified.
    drives: Option<List<BodyId, [f64; DRIVE]>>,
    /// For each joint the one that carries the body it hangs on.
    parents: List<BodyId, Option<BodyId>>,
    inertias: List<BodyId, Matrix<f64>>,
}

/// What a body is at a state.
struct At {
    pose: Matrix<f64>,
    /// M of the link that it is.
    link: Matrix<f64>,
    /// L times the factor of the joint's rate.
    screw: Matrix<f64>,
    w: Matrix<f64>,
    /// Against gravity.
    h: Matrix<f64>,
}

impl Columns {
    pub fn of(chain: &Chain) -> Self {
        let links = links(chain);
        let numbers = Numbers::of(chain);
        // A joint is looked at as often as any link that it moves.
        let mut often = chain.joints.map(|_| 0);
        for link in &links {
            for &joint in link.path.iter().chain([&link.joint]) {
                often[joint] = link.states.max(often[joint]);
            }
        }
        let most = often.iter().copied().max().unwrap_or(0);
        // The same for all robots: what is found must not change with a comment in a file.
        let mut random = Random(0);
        let mut between = || 6.0 * random.unit() - 3.0;
        let mut rates = Vec::new();
        let states = (0..most).map(|state| {
            let q = chain.spaces.coordinates.map(|_| between());
            let both = [(); 2].map(|()| chain.spaces.velocities.map(|_| between()));
            let mut bodies: List<BodyId, Option<At>> = List::new();
            for together in chain.joints.chunk_by(|_, next| taken(next)) {
                let k = bodies.next();
                let parent = together[0].parent.map(|parent| bodies[parent].as_ref());
                if (0..together.len()).all(|place| often[k.plus(place)] <= state) {
                    bodies.extend(together.iter().map(|_| None));
                } else {
                    let found = numbers.joint(together, k, parent.flatten(), &q, &both);
                    bodies.extend(found.into_iter().map(Some));
                }
            }
            rates.push(both);
            bodies
        });
        let states = states.collect();
        let factors = numbers.screws.iter().map(|(.., factor)| *factor);
        let joints = || chain.joints.iter();
        Self {
            states,
            rates,
            velocities: joints().map(|joint| joint.velocity).zip(factors).collect(),
            drives: chain.identifies_drives.then_some(numbers.drives),
            parents: joints().map(|joint| joint.parent).collect(),
            inertias: numbers.inertias,
            links,
        }
    }

    /// What all is described as, in the order of the parameters.
    pub fn described(&self) -> List<ParameterId, f64> {
        let links = self.links.iter().flat_map(|link| {
            let Matrix(j) = &self.inertias[link.joint];
            PLACES.map(|(row, column)| j[row][column])
        });
        links
            .chain(self.drives.iter().flatten().flatten().copied())
            .collect()
    }

    /// The columns of a link, and of what the joints feel that move it against the one it hangs on.
    pub fn own(&self, link: LinkId) -> Vec<Column> {
        let mut of_link: Vec<Option<Column>> =
            self.of_link(link, link).into_iter().map(Some).collect();
        let ordered = ORDER.iter().filter_map(|&k| of_link[k].take());
        let mut columns: Vec<Column> = ordered.collect();
        if self.drives.is_some() {
            columns.extend(
                self.links[link]
                    .own
                    .iter()
                    .flat_map(|&joint| self.of_drive(joint, link)),
            );
        }
        columns
    }

    /// Those of what a joint feels, in the rows of what a link is looked at by.
    fn of_drive(&self, joint: BodyId, rows_of: LinkId) -> impl Iterator<Item = Column> {
        let rows = self.rows(rows_of);
        let (velocity, factor) = self.velocities[joint];
        let mut columns: [Vec<f64>; DRIVE] = Default::default();
        for [first, second] in &self.rates[..self.links[rows_of].states] {
            let (rate, second) = (factor * first[velocity], factor * second[velocity]);
            for row in &rows {
                let seen = if *row == velocity { factor } else { 0.0 };
                for (column, felt) in columns.iter_mut().zip([second, rate, rate.signum()]) {
                    column.push(seen * felt);
                }
            }
        }
        // Those of drives are behind those of all links.
        let before = PARAMETERS * self.links.len() + DRIVE * joint.index();
        (before..).map(ParameterId::new).zip(columns)
    }

    /// The velocities that a link is looked at by.
    fn rows(&self, link: LinkId) -> Vec<VelocityId> {
        let path = self.links[link].path.iter();
        let mut rows: Vec<VelocityId> = path.map(|&joint| self.velocities[joint].0).collect();
        rows.sort_unstable();
        rows.dedup();
        rows
    }

    /// The columns of a link in the rows of what another one is looked at by.
    pub fn of_link(&self, link: LinkId, rows_of: LinkId) -> Vec<Column> {
        let states = self.links[rows_of].states;
        let joint = self.links[link].joint;
        let inwards = std::iter::successors(Some(joint), |&joint| self.parents[joint]);
        let rows = self.rows(rows_of);
        // Of each row, what it moves inboard of the link.
        let mut movers = vec![Vec::new(); rows.len()];
        for mover in inwards {
            if let Ok(row) = rows.binary_search(&self.velocities[mover].0) {
                movers[row].push(mover);
            }
        }
        let mut columns: [Vec<f64>; PARAMETERS] = Default::default();
        for state in &self.states[..states] {
            let Some(body) = &state[joint] else { continue };
            for movers in &movers {
                let mut seen = [0.0; PARAMETERS];
                for mover in movers.iter().filter_map(|&mover| state[mover].as_ref()) {
                    for (entry, power) in seen.iter_mut().zip(powers(mover, body)) {
                        *entry += power;
                    }
                }
                for (column, entry) in columns.iter_mut().zip(seen) {
                    column.push(entry);
                }
            }
        }
        let before = PARAMETERS * link.index();
        (before..).map(ParameterId::new).zip(columns).collect()
    }
}

/// Where the parameters stand in J.
const PLACES: [(usize, usize); PARAMETERS] = [
    (3, 3),
    (0, 3),
    (1, 3),
    (2, 3),
    (0, 0),
    (0, 1),
    (0, 2),
    (1, 1),
    (1, 2),
    (2, 2),
];

/// L ⊗ skew\[H M E Mᵗ\] = Tr(Mᵗ Lᵗ H M E) of each parameter's E.
fn powers(mover: &At, body: &At) -> [f64; PARAMETERS] {
    let turned = mover.screw.transposed().times(&body.h);
    let Matrix(seen) = body.link.transposed().times(&turned).times(&body.link);
    PLACES.map(|(row, column)| {
        let mirrored = if row == column {
            0.0
        } else {
            seen[column][row]
        };
        seen[row][column] + mirrored
    })
}

fn taken(joint: &Joint) -> bool {
    matches!(joint.position, Position::Taken)
}

fn links(chain: &Chain) -> List<LinkId, Link> {
    let inwards =
        |joint: BodyId| std::iter::successors(Some(joint), |&joint| chain.joints[joint].parent);
    let is_link = |joint: &BodyId| chain.joints[*joint].link.is_some();
    let joints: List<LinkId, BodyId> = chain.joints.ids().filter(is_link).collect();
    let velocities = chain.spaces.velocities.len();
    let drive = if chain.identifies_drives { DRIVE } else { 0 };
    let links = joints.iter().map(|&joint| {
        let parent = inwards(joint).skip(1).find(is_link);
        let mut own: Vec<BodyId> = inwards(joint)
            .take_while(|&other| Some(other) != parent)
            .collect();
        own.reverse();
        // Twice as many numbers as there are columns.
        let (path, states) = if chain.all_lead() {
            let mut path: Vec<BodyId> = inwards(joint).collect();
            path.reverse();
            if path.len() > JOINTS {
                path.drain(JOINTS / 2..path.len() - JOINTS / 2);
            }
            let rows = 2 * (2 * PARAMETERS + drive * own.len());
            let states = rows.div_ceil(path.len());
            (path, states)
        } else {
            let rows = 2 * (PARAMETERS * joints.len() + drive * chain.joints.len());
            (chain.joints.ids().collect(), rows.div_ceil(velocities))
        };
        Link {
            joint,
            own,
            parent: parent.and_then(|parent| joints.find(|&other| other == parent)),
            path,
            states,
        }
    });
    links.collect()
}

/// The numbers of a chain.
struct Numbers {
    /// Of each joint.
    placements: List<BodyId, Matrix<f64>>,
    /// u and b, and what its rate is times that of its velocity.
    screws: List<BodyId, ([f64; 3], [f64; 3], f64)>,
    /// M of the link that it is, from the body's frame.
    links: List<BodyId, Matrix<f64>>,
    /// J in the link's frame.
    inertias: List<BodyId, Matrix<f64>>,
    /// What is felt beside that.
    drives: List<BodyId, [f64; DRIVE]>,
    /// H of the base that has the effect of gravity.
    falling: Matrix<f64>,
}

impl Numbers {
    fn of(chain: &Chain) -> Self {
        let described = |input| match input {
            Input::Parameter(field, entry) => {
                Double::from(chain.nominal[field.into()][usize::from(entry)])
            }
            Input::Variable(..) => unreachable!("a chain depends on no state"),
        };
        let numbers = |exprs: &[Expr]| -> Vec<f64> {
            let found = Evaluation::<Double>::of(&chain.graph, exprs).at(described);
            found.into_iter().map(Double::to_f64).collect()
        };
        let one = |expr| numbers(&[expr])[0];
        let screw = |joint: &Joint| {
            let axis = numbers(&joint.axis.0);
            let axis = [axis[0], axis[1], axis[2]];
            let factor = match joint.position {
                Position::Along { factor, .. } => one(factor),
                Position::Posture(..) | Position::Taken => 1.0,
            };
            match joint.motion {
                Motion::Revolute => (axis, [0.0; 3], factor),
                Motion::Prismatic => ([0.0; 3], axis, factor),
                Motion::Screw(pitch) => {
                    let pitch = one(pitch);
                    (axis, axis.map(|entry| entry * pitch), factor)
                }
            }
        };
        let link = |joint: &Joint| match &joint.link {
            Some((_, pose)) => placement(&numbers(&pose.entries())),
            None => Matrix::identity(),
        };
        let inertia = |joint: &Joint| {
            let [xx, yy, zz, xy, xz, yz, x, y, z, m] = joint.inertia.entries();
            let rows = [xx, xy, xz, x, xy, yy, yz, y, xz, yz, zz, z, x, y, z, m];
            let rows = numbers(&rows);
            let j = Matrix([0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| rows[row + column])));
            let back = link(joint).inverse();
            back.times(&j).times(&back.transposed())
        };
        let joints = || chain.joints.iter();
        let gravity = numbers(&chain.gravity.0);
        let mut falling = Matrix::zero();
        falling.set_column([0, 1, 2].map(|k| -gravity[k]));
        Self {
            placements: joints()
                .map(|joint| placement(&numbers(&joint.placement.entries())))
                .collect(),
            screws: joints().map(screw).collect(),
            links: joints().map(link).collect(),
            inertias: joints().map(inertia).collect(),
            drives: joints()
                .map(|joint| joint.drive.entries().map(one))
                .collect(),
            falling,
        }
    }

    /// The bodies of a joint, the first of them being number `k` of all, at q, q̇, q̈. Where a joint takes its bodies
    /// together, any place that its motions lead to will do for one.
    fn joint(
        &self,
        together: &[Joint],
        k: BodyId,
        outer: Option<&At>,
        q: &List<CoordinateId, f64>,
        [first, second]: &[List<VelocityId, f64>; 2],
    ) -> Vec<At> {
        let mut pose = self.placements[k].clone();
        for (place, joint) in together.iter().enumerate() {
            let (u, b, factor) = self.screws[k.plus(place)];
            let at = match (together[0].position, joint.position) {
                (_, Position::Along { coordinate, .. }) => factor * q[coordinate],
                (Position::Posture(_, first), _) => q[first.plus(place)],
                (_, _) => 0.0,
            };
            pose = pose.times(&displacement(u, b, at));
        }
        let still = Matrix::zero();
        let (w_outer, h_outer) = match outer {
            Some(outer) => {
                pose = outer.pose.times(&pose);
                (&outer.w, &outer.h)
            }
            None => (&still, &self.falling),
        };
        let screws = (0..together.len()).map(|place| {
            let (u, b, factor) = self.screws[k.plus(place)];
            pose.carries(&Matrix::screw(u, b)).scaled(&factor)
        });
        let screws: Vec<Matrix<f64>> = screws.collect();
        let sum = |rates: &List<VelocityId, f64>| {
            let each = together.iter().zip(&screws);
            each.fold(Matrix::zero(), |sum, (joint, screw)| {
                sum.plus(&screw.scaled(&rates[joint.velocity]))
            })
        };
        let own = sum(first);
        let drift = w_outer.times(&own).scaled(&2.0).plus(&own.times(&own));
        let w = w_outer.plus(&own);
        let h = h_outer.plus(&sum(second)).plus(&drift);
        let bodies = screws.into_iter().enumerate().map(|(place, screw)| At {
            link: pose.times(&self.links[k.plus(place)]),
            pose: pose.clone(),
            screw,
            w: w.clone(),
            h: h.clone(),
        });
        bodies.collect()
    }
}

/// Q so far along a screw: 1 + u̲ sin q + u̲² (1 − cos q), b q.
fn displacement(u: [f64; 3], b: [f64; 3], q: f64) -> Matrix<f64> {
    let turn = Matrix::screw(u, [0.0; 3]);
    // These sines are the same on every machine.
    let (sine, cosine) = Double::from(q).sin_cos();
    let mut displacement = Matrix::identity()
        .plus(&turn.scaled(&sine.to_f64()))
        .plus(&turn.times(&turn).scaled(&(1.0 - cosine.to_f64())));
    displacement.set_column(b.map(|entry| entry * q));
    displacement
}

fn placement(entries: &[f64]) -> Matrix<f64> {
    let mut placement = Matrix::identity();
    for (row, entries) in placement.0.iter_mut().zip(entries.chunks(4)) {
        row.copy_from_slice(entries);
    }
    placement
}

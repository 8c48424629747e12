//! Bounds for joints in a row, where bodies between them have little inertia or none.
//!
//! In: the bodies of a chain, and the bounds of each joint from its own two bodies. Out: bounds of each joint from the
//! two bodies at the ends of a row, and bounds of a body between from its joints. They hold in every configuration: the
//! angles between axes are constant where no joint between rotates.
//!
//! The bodies at the ends have the velocities ω, v and ω′, v′, and the joints together their difference: Σ a q̇ of
//! the revolute ones is ω′ − ω, and of the prismatic ones v′ − v of one point, but for what rotation adds at that
//! point. The part n of a joint's axis a that is orthogonal to all other axes belongs to that joint alone: q̇ = n·(ω′
//! − ω)/n².

use super::{AXES, Solid, Z, dot};
use crate::chain::BodyId;
use crate::list::List;

/// The longest row: at most five joints have independent axes in every configuration, two of them revolute.
const MOST: usize = 5;

/// The least n²; below it axes count as parallel.
const APART: f64 = 1e-12;

/// Factor for the rounding errors of n² and of the sums here, with a margin.
const SLACK: f64 = 1.0 + 1e-3;

/// Bounds each joint by all rows that it is in.
pub(super) fn slowed(
    joints: &mut List<BodyId, f64>,
    solids: &List<BodyId, Solid>,
    reaches: &List<BodyId, f64>,
) {
    let rows: Vec<Row<'_>> = solids
        .ids()
        .flat_map(|outer| Row::inwards(outer, solids, reaches))
        .collect();
    // Prismatic joints are bounded by bodies that rotate.
    demand(joints, &rows, |row, place, _| row.turning(place));
    demand(joints, &rows, Row::sliding);
}

/// Bounds each joint by its rows, from the bounds known of all.
fn demand<'a>(
    joints: &mut List<BodyId, f64>,
    rows: &[Row<'a>],
    most: impl Fn(&Row<'a>, usize, &List<BodyId, f64>) -> Option<f64>,
) {
    let known = joints.clone();
    for row in rows {
        for (place, &k) in row.joints.iter().enumerate() {
            if let Some(most) = most(row, place, &known) {
                joints[k] = joints[k].min(SLACK * most);
            }
        }
    }
}

/// For each body bounds of the squares of its ω and of the velocity of its origin: the smaller one of its own, and of
/// that from its parent body and their joint.
pub(super) fn carried(
    own: Vec<[f64; 2]>,
    joints: &List<BodyId, f64>,
    solids: &List<BodyId, Solid>,
    reaches: &List<BodyId, f64>,
) -> List<BodyId, [f64; 2]> {
    let mut all: List<BodyId, [f64; 2]> = List::new();
    for ((k, solid), own) in solids.numbered().zip(own) {
        let [rotations, translations] = solid.parent.map_or([0.0; 2], |parent| all[parent]);
        let rate = joints[k].sqrt();
        let across = product(reaches[k], rotations.sqrt());
        let shifts = translations.sqrt() + across;
        let carried = if solid.translates {
            [rotations, (shifts + rate) * (shifts + rate)]
        } else {
            let spins = rotations.sqrt() + rate;
            [spins * spins, shifts * shifts]
        };
        let known = !solid.free && !solid.screws;
        all.push([0, 1].map(|part| {
            if known {
                own[part].min(SLACK * carried[part])
            } else {
                own[part]
            }
        }));
    }
    all
}

/// A product that is zero if one factor is, even if the other is infinite.
fn product(reach: f64, rate: f64) -> f64 {
    if reach == 0.0 || rate == 0.0 {
        0.0
    } else {
        reach * rate
    }
}

/// Joints in a row from one body to another, the outermost first.
struct Row<'a> {
    joints: Vec<BodyId>,
    outer: &'a Solid,
    /// `None` if the row begins at the base.
    inner: Option<&'a Solid>,
    solids: &'a List<BodyId, Solid>,
    reaches: &'a List<BodyId, f64>,
}

impl<'a> Row<'a> {
    /// All rows of more than one joint that end at a body.
    fn inwards(
        outer: BodyId,
        solids: &'a List<BodyId, Solid>,
        reaches: &'a List<BodyId, f64>,
    ) -> Vec<Self> {
        let inwards = std::iter::successors(Some(outer), |k| solids[*k].parent);
        let one_axis = |k: &BodyId| !solids[*k].free && !solids[*k].screws;
        let joints: Vec<BodyId> = inwards.take_while(one_axis).take(MOST).collect();
        let rows = (2..=joints.len()).map(|count| {
            let joints = joints[..count].to_vec();
            let innermost = joints[count - 1];
            Self {
                inner: solids[innermost].parent.map(|parent| &solids[parent]),
                outer: &solids[outer],
                joints,
                solids,
                reaches,
            }
        });
        rows.collect()
    }

    fn translates(&self, place: usize) -> bool {
        self.solids[self.joints[place]].translates
    }

    /// The places of the prismatic joints, or of the revolute ones.
    fn places(&self, sliding: bool) -> Vec<usize> {
        let places = 0..self.joints.len();
        places
            .filter(|&place| self.translates(place) == sliding)
            .collect()
    }

    /// The axis of a joint in the frame of the body of one further in, if no joint between rotates.
    fn axis(&self, place: usize, from: usize) -> [f64; 3] {
        let outwards = self.joints[place..from].iter();
        outwards.fold(Z, |axis, &k| self.solids[k].turned(axis))
    }

    /// The axis of a joint in the frame of the outer body, if no joint between rotates.
    fn axis_outside(&self, place: usize) -> [f64; 3] {
        let inwards = self.joints[..place].iter().rev();
        inwards.fold(Z, |axis, &k| self.solids[k].turned_back(axis))
    }

    /// Bound of q̇² by twice the energy, for a revolute joint.
    fn turning(&self, place: usize) -> Option<f64> {
        let turning = self.places(false);
        if self.translates(place) {
            return None;
        }
        match *turning {
            [_] => {
                let inside = self.inner.map_or(0.0, |inner| {
                    inner.rotation(self.axis(place, self.joints.len()))
                });
                Some(self.outer.rotation(self.axis_outside(place)) + inside)
            }
            [outer, inner] => {
                let apart = of_cross(Z, self.axis(outer, inner));
                let anyhow =
                    |solid: &Solid| AXES.iter().map(|&axis| solid.rotation(axis)).sum::<f64>();
                let both = anyhow(self.outer) + self.inner.map_or(0.0, anyhow);
                (apart > APART).then(|| both / apart)
            }
            _ => None,
        }
    }

    /// The same for a prismatic joint.
    fn sliding(&self, place: usize, joints: &List<BodyId, f64>) -> Option<f64> {
        let sliding = self.places(true);
        let [first, .., last] = *sliding else {
            return (sliding == [place]).then(|| self.moved(1.0, joints));
        };
        let between = self.places(false);
        let apart = between.iter().all(|turns| !(first..last).contains(turns));
        if !self.translates(place) || !apart || sliding.len() > 3 {
            return None;
        }
        let others = sliding.iter().filter(|&&other| other != place);
        let others: Vec<[f64; 3]> = others.map(|&other| self.axis(other, last)).collect();
        let own = self.axis(place, last);
        let orthogonal = match *others {
            [other] => of_cross(own, other),
            [one, other] => {
                let normal = cross(one, other);
                let along = dot(own, normal);
                along * along / dot(normal, normal)
            }
            _ => return None,
        };
        (orthogonal > APART).then(|| self.moved(orthogonal, joints))
    }

    /// Bound of the prismatic joints together, divided by n²: the velocity of the outer body's centre of mass, seen
    /// from the inner body, with what rotation adds.
    fn moved(&self, apart: f64, joints: &List<BodyId, f64>) -> f64 {
        let mut distance = dot(self.outer.centre, self.outer.centre).sqrt();
        let mut across = 0.0;
        for (place, &k) in self.joints.iter().enumerate() {
            if !self.translates(place) {
                across += product(distance, joints[k].sqrt());
            }
            distance += self.reaches[k];
        }
        let inside = self.inner.map_or(0.0, |inner| inner.within(distance, true));
        let ends = self.outer.mass.recip() + inside;
        let speed = ends.sqrt() + across;
        speed * speed / apart
    }
}

impl Solid {
    /// A direction of this body's frame in that of its parent, if its joint does not rotate.
    fn turned(&self, axis: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|row| {
            dot(
                [0, 1, 2].map(|column| self.placement[3 * row + column]),
                axis,
            )
        })
    }

    /// The inverse of [`turned`](Self::turned).
    fn turned_back(&self, axis: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|column| dot([0, 1, 2].map(|row| self.placement[3 * row + column]), axis))
    }
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// |a × b|²: for unit vectors, the squared length of the part of one that is orthogonal to the other.
fn of_cross(a: [f64; 3], b: [f64; 3]) -> f64 {
    let product = cross(a, b);
    dot(product, product)
}

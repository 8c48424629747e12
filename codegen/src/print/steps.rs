//! Integration, difference, normalisation and the neutral configuration of a robot some of whose coordinates are no
//! angles and shifts.
//!
//! In: a [`Module`]. Out: which of these functions it has, their names, arguments, results and documentation in any
//! language, and the routines that files print. Robots whose coordinates are all added to have none.

use std::ops::Range;

#[cfg(feature = "files")]
use crate::expression::{Expr, Graph, Input, Term};
use crate::joint::Posture;
use crate::module::{DataMotion, Module};
#[cfg(feature = "files")]
use crate::real::Real;
use crate::schedule::Operation;
#[cfg(feature = "files")]
use crate::schedule::{Length, Names, Program, Readable, Routine, Stored, schedule_unfused};
use crate::space::Space;

/// A function of configurations alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// The configuration at which no joint has moved.
    Neutral,
    /// The configuration that velocities lead to.
    Integrate,
    /// The velocities that lead from one configuration to another.
    Difference,
    /// The configuration that is meant by coordinates.
    Normalize,
}

/// A joint that has coordinates.
pub(super) struct Own {
    pub motion: DataMotion,
    /// The places of its coordinates.
    pub coordinates: Range<usize>,
    /// The places of its velocities.
    pub velocities: Range<usize>,
}

/// Those of a robot.
pub(super) fn joints(module: &Module) -> impl Iterator<Item = Own> {
    let (mut coordinate, mut velocity) = (0, 0);
    let motions = module.data.motions.iter().map(move |&motion| {
        let (coordinates, velocities) = motion.counts();
        let own = Own {
            motion,
            coordinates: coordinate..coordinate + coordinates,
            velocities: velocity..velocity + velocities,
        };
        (coordinate, velocity) = (own.coordinates.end, own.velocities.end);
        own
    });
    motions.filter(|own| !own.coordinates.is_empty())
}

/// Whether anything that is printed for a robot has sines or cosines.
pub(super) fn has_angles(module: &Module) -> bool {
    let mut programs = module.functions.iter().map(|generated| &generated.program);
    programs.any(|program| !program.angles.is_empty()) || Step::Integrate.turns(module)
}

/// Whether anything that is printed for a robot has square roots.
pub(super) fn has_roots(module: &Module) -> bool {
    let programs = module.functions.iter().map(|generated| &generated.program);
    let mut steps = programs.flat_map(|program| &program.steps);
    steps.any(|step| matches!(step.operation, Operation::Sqrt(_))) || !Step::of(module).is_empty()
}

/// The configuration spaces of the joints whose coordinates are no angles and shifts.
fn postures(module: &Module) -> impl Iterator<Item = Posture> + '_ {
    let motions = module.data.motions.iter();
    motions.filter_map(|motion| match motion {
        DataMotion::Posture(posture) => Some(*posture),
        DataMotion::Along | DataMotion::Follows { .. } => None,
    })
}

impl Own {
    /// The place of its quaternion among its coordinates, if it has one.
    pub const fn quaternion(&self) -> Option<usize> {
        match self.motion {
            DataMotion::Posture(Posture::Spherical) => Some(0),
            DataMotion::Posture(Posture::Floating) => Some(3),
            _ => None,
        }
    }

    /// Its coordinates where it is as it was placed: zeros, and 0, 0, 0, 1 of a quaternion.
    fn neutral(&self) -> Vec<f64> {
        let mut q = vec![0.0; self.coordinates.len()];
        if let Some(first) = self.quaternion() {
            q[first + 3] = 1.0;
        }
        q
    }
}

/// The configuration at which every joint is where it was placed.
pub(super) fn neutral(module: &Module) -> Vec<f64> {
    joints(module).flat_map(|own| own.neutral()).collect()
}

impl Step {
    /// All of them.
    const ALL: [Self; 4] = [
        Self::Neutral,
        Self::Integrate,
        Self::Difference,
        Self::Normalize,
    ];

    /// Those of a robot.
    pub fn of(module: &Module) -> &'static [Self] {
        if postures(module).next().is_some() {
            &Self::ALL
        } else {
            &[]
        }
    }

    /// Whether sines or cosines enter it.
    pub fn turns(self, module: &Module) -> bool {
        match self {
            Self::Integrate => postures(module).next().is_some(),
            Self::Difference => postures(module).any(|posture| posture == Posture::Planar),
            Self::Neutral | Self::Normalize => false,
        }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Neutral => "neutral",
            Self::Integrate => "integrate",
            Self::Difference => "difference",
            Self::Normalize => "normalize",
        }
    }

    /// What it tells.
    pub const fn about(self) -> [&'static str; 2] {
        match self {
            Self::Neutral => [
                "Coordinates at which every joint stands where it was placed.",
                "Zeros, and 0, 0, 0, 1 of quaternions (x, y, z, w).",
            ],
            Self::Integrate => [
                "Where the robot gets to from `q` with velocities kept for one unit of time; of a time Δt, `v` is q̇ Δt.",
                "Bodies whose velocities are seen in their own axes move along the screw that they keep.",
            ],
            Self::Difference => [
                "The velocities that lead from `q0` to `q1` in one unit of time.",
                "Turns of bodies whose velocities are seen in their own axes are the shortest, half a turn at most.",
            ],
            Self::Normalize => [
                "The same coordinates with quaternions of length 1.",
                "None of them may be zero.",
            ],
        }
    }

    /// Its arguments, and what entries each has.
    pub const fn arguments(self) -> &'static [(&'static str, Space)] {
        match self {
            Self::Neutral => &[],
            Self::Integrate => &[("q", Space::Coordinates), ("v", Space::Velocities)],
            Self::Difference => &[("q0", Space::Coordinates), ("q1", Space::Coordinates)],
            Self::Normalize => &[("q", Space::Coordinates)],
        }
    }

    /// What entries its result has.
    pub const fn result(self) -> Space {
        match self {
            Self::Neutral | Self::Integrate | Self::Normalize => Space::Coordinates,
            Self::Difference => Space::Velocities,
        }
    }
}

#[cfg(feature = "files")]
impl Step {
    /// The operations, in an order; each is rounded for itself, so that results are the same on every processor.
    pub fn program(self, module: &Module) -> Program {
        let graph = Graph::new();
        let results: Vec<Expr> = joints(module)
            .flat_map(|own| self.of_joint(&own, &graph, module.scalar))
            .map(Term::expr)
            .collect();
        schedule_unfused(&graph, &results)
    }

    /// The entries of the result that belong to a joint.
    fn of_joint<'g>(self, own: &Own, graph: &'g Graph, real: Real) -> Vec<Term<'g>> {
        // Arguments are counted as fields are: no function of the state has these.
        let entry = |argument: u16, place: usize| {
            let place = u16::try_from(place).expect("fewer than 65,536 entries");
            graph.input(Input::Parameter(argument, place))
        };
        let coordinates = own.coordinates.clone();
        let first = |k: usize| entry(0, coordinates.start + k);
        let end = |k: usize| entry(1, coordinates.start + k);
        let v = |k: usize| entry(1, own.velocities.start + k);
        match (self, own.motion) {
            (Self::Neutral, _) => (own.neutral().into_iter())
                .map(|value| graph.constant(value))
                .collect(),
            (Self::Integrate, DataMotion::Posture(posture)) => posture.integrate(first, v, real),
            (Self::Difference, DataMotion::Posture(posture)) => posture.difference(first, end),
            (Self::Normalize, DataMotion::Posture(posture)) => posture.normalize(first),
            (Self::Integrate, _) => vec![first(0) + v(0)],
            (Self::Difference, _) => vec![end(0) - first(0)],
            (Self::Normalize, _) => vec![first(0)],
        }
    }

    /// The statements that compute it; its arguments, whose names are taken already, stand as its fields.
    pub fn routine(self, module: &Module, names: Names) -> Routine {
        let entries = self.arguments().iter().map(|&(name, space)| {
            let entries = 1..=module.spaces.len(space);
            entries.map(|k| format!("{name}_{k}")).collect()
        });
        let readable = Readable {
            arguments: &[],
            spaces: &module.spaces,
            fields: &entries.collect::<Vec<_>>(),
        };
        let program = (&self.program(module), Length::UNBOUNDED);
        Routine::of(program, &readable, names, Stored::AtTheEnd)
    }
}

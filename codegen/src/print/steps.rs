//! Functions of configurations: `neutral`, `integrate`, `difference` and `normalize` of robots with quaternions or
//! planar joints.
//!
//! In: a [`Module`]. Out: the functions that it has, their names, arguments, results and documentation, and their
//! routines. Robots whose coordinates are all added have none.

use std::ops::Range;

#[cfg(feature = "files")]
use crate::expression::{Expr, Graph, Input, Term};
use crate::joint::Manifold;
use crate::module::{DataMotion, Module};
#[cfg(feature = "files")]
use crate::real::Real;
use crate::schedule::Program;
#[cfg(feature = "files")]
use crate::schedule::{Length, Names, Readable, Routine, Stored, schedule_unfused};
use crate::space::Space;

/// Function of configurations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ConfigurationFunction {
    /// The neutral configuration.
    Neutral,
    /// The configuration after one unit of time at given velocities.
    Integrate,
    /// The velocities that lead from one configuration to another in one unit of time.
    Difference,
    /// The configuration with quaternions of length 1.
    Normalize,
}

/// Joint with coordinates of its own.
pub(super) struct JointRanges {
    pub motion: DataMotion,
    /// Indices of its coordinates.
    pub coordinates: Range<usize>,
    /// Indices of its velocities.
    pub velocities: Range<usize>,
}

/// Joints with coordinates of a robot.
pub(super) fn joints(module: &Module) -> impl Iterator<Item = JointRanges> {
    let (mut coordinate, mut velocity) = (0, 0);
    let motions = module.data.motions.iter().map(move |&motion| {
        let (coordinates, velocities) = motion.counts();
        let own = JointRanges {
            motion,
            coordinates: coordinate..coordinate + coordinates,
            velocities: velocity..velocity + velocities,
        };
        (coordinate, velocity) = (own.coordinates.end, own.velocities.end);
        own
    });
    motions.filter(|own| !own.coordinates.is_empty())
}

/// True if the generated code has sines or cosines.
pub(super) fn has_angles(module: &Module) -> bool {
    let mut programs = module.functions.iter().map(|generated| &generated.program);
    programs.any(|program| !program.angles.is_empty())
        || ConfigurationFunction::Integrate.turns(module)
}

/// True if the generated code has square roots.
pub(super) fn has_roots(module: &Module) -> bool {
    let mut programs = module.functions.iter().map(|generated| &generated.program);
    programs.any(Program::has_roots) || !ConfigurationFunction::of(module).is_empty()
}

/// True if the generated code takes the sign of a number.
#[cfg(feature = "files")]
pub(super) fn has_signs(module: &Module) -> bool {
    let mut programs = module.functions.iter().map(|generated| &generated.program);
    let mut steps = ConfigurationFunction::of(module).iter();
    programs.any(Program::has_signs) || steps.any(|step| step.program(module).has_signs())
}

/// Configuration spaces of the joints with planar or quaternion coordinates.
fn manifolds(module: &Module) -> impl Iterator<Item = Manifold> + '_ {
    let motions = module.data.motions.iter();
    motions.filter_map(|motion| match motion {
        DataMotion::Manifold(manifold) => Some(*manifold),
        DataMotion::Along | DataMotion::Mimic { .. } => None,
    })
}

impl JointRanges {
    /// Index of its quaternion among its coordinates, if it has one.
    pub fn quaternion(&self) -> Option<usize> {
        match self.motion {
            DataMotion::Manifold(manifold) => manifold.quaternion(),
            DataMotion::Along | DataMotion::Mimic { .. } => None,
        }
    }

    /// Coordinates at the placement of the joint: zeros, and 0, 0, 0, 1 of a quaternion.
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

impl ConfigurationFunction {
    /// All functions.
    pub const ALL: [Self; 4] = [
        Self::Neutral,
        Self::Integrate,
        Self::Difference,
        Self::Normalize,
    ];

    /// Functions of a robot.
    pub fn of(module: &Module) -> &'static [Self] {
        if manifolds(module).next().is_some() {
            &Self::ALL
        } else {
            &[]
        }
    }

    /// True if it needs sines or cosines.
    pub fn turns(self, module: &Module) -> bool {
        match self {
            Self::Integrate => manifolds(module).next().is_some(),
            Self::Difference => manifolds(module).any(|manifold| manifold == Manifold::Planar),
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

    /// Documentation.
    pub const fn about(self) -> [&'static str; 2] {
        match self {
            Self::Neutral => [
                "The neutral configuration, at which every joint is where it was placed.",
                "Zeros, and 0, 0, 0, 1 of quaternions (x, y, z, w).",
            ],
            Self::Integrate => [
                "The configuration after one unit of time from `q` at constant velocities `v`; for a time Δt, `v` is q̇ Δt.",
                "Bodies with velocities in their own axes move along a constant screw.",
            ],
            Self::Difference => [
                "The constant velocities that lead from `q0` to `q1` in one unit of time.",
                "Rotations of bodies with velocities in their own axes are the shortest, by π at most.",
            ],
            Self::Normalize => [
                "The same configuration with quaternions of length 1.",
                "Quaternions must not be zero.",
            ],
        }
    }

    /// Arguments and their spaces.
    pub const fn arguments(self) -> &'static [(&'static str, Space)] {
        match self {
            Self::Neutral => &[],
            Self::Integrate => &[("q", Space::Coordinates), ("v", Space::Velocities)],
            Self::Difference => &[("q0", Space::Coordinates), ("q1", Space::Coordinates)],
            Self::Normalize => &[("q", Space::Coordinates)],
        }
    }

    /// Space of the result.
    pub const fn result(self) -> Space {
        match self {
            Self::Neutral | Self::Integrate | Self::Normalize => Space::Coordinates,
            Self::Difference => Space::Velocities,
        }
    }
}

#[cfg(feature = "files")]
impl ConfigurationFunction {
    /// Operations without fused products, so that results are the same on every processor.
    pub fn program(self, module: &Module) -> Program {
        let graph = Graph::new();
        let results: Vec<Expr> = joints(module)
            .flat_map(|own| self.of_joint(&own, &graph, module.scalar))
            .map(Term::expr)
            .collect();
        schedule_unfused(&graph, &results)
    }

    /// Entries of the result for a joint.
    fn of_joint<'g>(self, own: &JointRanges, graph: &'g Graph, real: Real) -> Vec<Term<'g>> {
        // Arguments are inputs as fields are, since functions of the state do not have these arguments.
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
            (Self::Integrate, DataMotion::Manifold(manifold)) => manifold.integrate(first, v, real),
            (Self::Difference, DataMotion::Manifold(manifold)) => manifold.difference(first, end),
            (Self::Normalize, DataMotion::Manifold(manifold)) => manifold.normalize(first),
            (Self::Integrate, _) => vec![first(0) + v(0)],
            (Self::Difference, _) => vec![end(0) - first(0)],
            (Self::Normalize, _) => vec![first(0)],
        }
    }

    /// Routine; its arguments, whose names are reserved, are its fields.
    pub fn routine(self, module: &Module, names: Names) -> Routine {
        let entries = self.arguments().iter().map(|&(name, space)| {
            let entries = 1..=module.spaces.len(space);
            entries.map(|k| format!("{name}_{k}")).collect()
        });
        let readable = Readable {
            arguments: &[],
            spaces: &module.spaces,
            limbs: &[],
            fields: &entries.collect::<Vec<_>>(),
        };
        let program = (&self.program(module), Length::UNBOUNDED);
        Routine::of(program, &readable, names, Stored::AtTheEnd)
    }
}

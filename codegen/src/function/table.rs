//! The table of functions: what is known of each stands in its own file.
//!
//! In: a [`Function`]. Out: its name, what it is said to compute, arguments, result, price of dense
//! matrices, and its expressions. It knows none of it itself.

use super::dense::{Size, Tally};
use super::{
    Argument, Function, Shape, acceleration, bias, body_jacobian, forward_dynamics,
    forward_kinematics, geometric_jacobian, gravity, inverse_dynamics, mass_matrix,
    mass_matrix_inverse, spatial_jacobian, velocity,
};
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::model::{Scene, Way};

/// Everything that is known of a function.
pub(super) struct Definition {
    /// The name in generated code, in attributes and on the command line.
    pub(super) name: &'static str,
    /// What it computes, with the letters of the paper, by the names of frame 0 and of the frame that it
    /// is of.
    pub(super) sentence: fn(&str, &str) -> String,
    /// What it is a function of, in the order of its parameters.
    pub(super) arguments: &'static [Argument],
    /// The shape of its result.
    pub(super) shape: Shape,
    /// The unit of each number of its result, by which joints slide.
    pub(super) units: fn(&[bool]) -> Vec<&'static str>,
    /// Whether it solves for what forces do to accelerations.
    pub(super) solves: bool,
    /// The ways to compute it between which only the count decides.
    pub(super) ways: fn() -> Vec<Way>,
    /// What it costs by dense 4×4 matrices.
    pub(super) dense: fn(Size) -> Tally,
    /// Its results, in the order of its shape.
    pub(super) build: for<'g> fn(&Scene<'_, 'g>) -> Vec<Term<'g>>,
}

impl Definition {
    /// No alternatives.
    pub(super) fn one_way() -> Vec<Way> {
        vec![Way::PLAIN]
    }
}

impl Function {
    const fn definition(self) -> &'static Definition {
        match self {
            Self::ForwardKinematics => &forward_kinematics::DEFINITION,
            Self::SpatialJacobian => &spatial_jacobian::DEFINITION,
            Self::BodyJacobian => &body_jacobian::DEFINITION,
            Self::GeometricJacobian => &geometric_jacobian::DEFINITION,
            Self::Velocity => &velocity::DEFINITION,
            Self::Acceleration => &acceleration::DEFINITION,
            Self::InverseDynamics => &inverse_dynamics::DEFINITION,
            Self::Gravity => &gravity::DEFINITION,
            Self::Bias => &bias::DEFINITION,
            Self::MassMatrix => &mass_matrix::DEFINITION,
            Self::ForwardDynamics => &forward_dynamics::DEFINITION,
            Self::MassMatrixInverse => &mass_matrix_inverse::DEFINITION,
        }
    }

    /// The name in generated code, in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// The function of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|function| function.name() == name)
    }

    /// What it computes, with the letters of the paper; `base` is what frame 0 is called, `frame` the
    /// frame that it is of.
    pub(crate) fn sentence(self, base: &str, frame: &str) -> String {
        (self.definition().sentence)(base, frame)
    }

    /// What it is a function of, in the order of its parameters.
    #[must_use]
    pub const fn arguments(self) -> &'static [Argument] {
        self.definition().arguments
    }

    /// The shape of its result.
    #[must_use]
    pub const fn shape(self) -> Shape {
        self.definition().shape
    }

    /// The unit of each number of its result, 1 where it has none; `slides` says of each joint whether
    /// it is prismatic.
    #[must_use]
    pub fn units(self, slides: &[bool]) -> Vec<&'static str> {
        (self.definition().units)(slides)
    }

    /// Whether it solves for what forces do to accelerations.
    #[must_use]
    pub const fn solves(self) -> bool {
        self.definition().solves
    }

    /// Whether it is about a frame (the tip's, or a further one) rather than about the whole robot.
    #[must_use]
    pub const fn of_a_frame(self) -> bool {
        !matches!(self.shape(), Shape::Vector | Shape::Matrix)
    }

    /// The ways to compute it between which only the count decides.
    #[must_use]
    pub fn ways(self) -> Vec<Way> {
        (self.definition().ways)()
    }

    /// Multiplications and additions by dense 4×4 matrices, for so many joints, of which `path` lead to
    /// the frame that it is of. Divisions count as multiplications.
    #[must_use]
    pub fn dense(self, joints: usize, path: usize) -> (usize, usize) {
        let Tally { mul, add } = (self.definition().dense)(Size { joints, path });
        (mul, add)
    }

    /// Its results in the order of its shape; of the frame of that index where it is of one.
    #[must_use]
    pub fn build<'g>(
        self,
        graph: &'g Graph,
        bodies: &Bodies<'g>,
        frame: usize,
        way: Way,
    ) -> Vec<Term<'g>> {
        (self.definition().build)(&Scene::new(graph, bodies, frame, way))
    }
}

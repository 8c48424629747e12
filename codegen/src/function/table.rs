//! Methods of [`Function`] that read its [`Definition`].
//!
//! In: a [`Function`]. Out: name, documentation, arguments, result, cost by dense matrices, and expressions.

use super::Function;
use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::model::{Algorithm, Scene};
use crate::space::{FrameId, Outcome, Space, Spaces, Variable};

macro_rules! definitions {
    (
        $($variant:ident: $module:ident, $about:literal;)*
        { $($of_loops:ident: $of_loops_module:ident, $of_loops_about:literal;)* }
        { $($of_spheres:ident: $of_spheres_module:ident, $of_spheres_about:literal;)* }
    ) => {
        impl Function {
            const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$variant => &super::$module::DEFINITION,)*
                    $(Self::$of_loops => &super::$of_loops_module::DEFINITION,)*
                    $(Self::$of_spheres => &super::$of_spheres_module::DEFINITION,)*
                }
            }
        }
    };
}
every_function!(definitions);

impl Function {
    /// Name in generated code, in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// The function with this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let mut all = Self::every();
        all.find(|function| function.name() == name)
    }

    /// Names of all functions.
    pub fn names() -> Vec<&'static str> {
        Self::every().map(Self::name).collect()
    }

    /// All functions, of whatever robots.
    pub fn every() -> impl Iterator<Item = Self> {
        let additional = Self::OF_LOOPS.into_iter().chain(Self::OF_SPHERES);
        Self::ALL.into_iter().chain(additional)
    }

    /// True if it needs a robot with loops.
    #[must_use]
    pub fn is_of_loops(self) -> bool {
        Self::OF_LOOPS.contains(&self)
    }

    /// True if it is of collision spheres, which a request has to name.
    #[must_use]
    pub fn is_of_spheres(self) -> bool {
        Self::OF_SPHERES.contains(&self)
    }

    /// Sentence about its result, with the letters of the paper; `base` is the name of frame 0, `frame` that of the
    /// function's frame.
    #[must_use]
    pub fn sentence(self, base: &str, frame: &str) -> String {
        (self.definition().sentence)(base, frame)
    }

    /// Arguments in the order of parameters, without external wrenches.
    #[must_use]
    pub const fn arguments(self) -> &'static [Variable] {
        self.definition().arguments
    }

    fn has(self, property: Property) -> bool {
        self.definition().properties.contains(&property)
    }

    /// True if external wrenches enter it.
    #[must_use]
    pub fn takes_actions(self) -> bool {
        self.has(Property::External)
    }

    /// True if masses and inertias are part of its expressions; false for regressors, whose columns they multiply.
    #[cfg(feature = "files")]
    pub(crate) fn has_mass(self) -> bool {
        self.has(Property::Mass)
    }

    /// True if the runtime has batches of it: neither functions of loops nor functions with external wrenches.
    /// `acted`: the robot has external wrenches.
    #[must_use]
    pub fn has_batches(self, acted: bool) -> bool {
        !(self.is_of_loops() || acted && self.takes_actions())
    }

    /// Arguments in the order of parameters. `actions`: the robot has external wrenches.
    #[must_use]
    pub fn arguments_with(self, actions: bool) -> Vec<Variable> {
        let external = (actions && self.takes_actions()).then_some(Variable::Actions);
        self.arguments().iter().copied().chain(external).collect()
    }

    /// Result.
    #[must_use]
    pub const fn result(self) -> Outcome {
        self.definition().result
    }

    /// Spaces of its result and its arguments other than coordinates and velocities, each once; their lengths are
    /// parameters of its trait.
    pub(crate) fn further(self) -> Vec<Space> {
        let result = self.result().parts().flat_map(|(_, part)| part.over);
        let arguments = self.arguments().iter().map(|argument| argument.space());
        let mut further = Vec::new();
        for space in result.copied().chain(arguments) {
            let is_known = matches!(
                space,
                Space::Coordinates | Space::Velocities | Space::Wrench
            );
            if !is_known && !further.contains(&space) {
                further.push(space);
            }
        }
        further
    }

    /// True if its result solves an equation, without loops: forward dynamics, the inverse mass matrix, and derivatives.
    #[must_use]
    pub const fn solves(self) -> bool {
        matches!(self.truth(), Truth::Solution(_))
    }

    /// True if the inverse of the mass matrix is among its results; then it is the last.
    #[must_use]
    pub const fn inverts(self) -> bool {
        matches!(
            self.truth(),
            Truth::Solution(Given::MassMatrix | Given::TorqueDerivatives)
        )
    }

    /// True if it needs a robot with mass.
    #[must_use]
    pub const fn is_of_mass(self) -> bool {
        matches!(self.truth(), Truth::OfMass(_))
    }

    /// True if it depends on which joints are actuated.
    #[must_use]
    pub fn wants_actuators(self) -> bool {
        self.has(Property::Actuation)
    }

    /// True if it solves for the motion under the constraints of loops.
    #[must_use]
    pub const fn is_constrained(self) -> bool {
        matches!(self.truth(), Truth::Constrained(_))
    }

    /// True if it excludes armature and friction of joints.
    #[must_use]
    pub fn is_of_bodies(self) -> bool {
        self.has(Property::BodiesAlone)
    }

    /// Reference for the check of every expansion.
    pub(crate) const fn truth(self) -> Truth {
        self.definition().truth
    }

    /// True if it belongs to a frame, of the end effector or another link, and not to the whole robot.
    #[must_use]
    pub fn of_a_frame(self) -> bool {
        self.has(Property::Frame)
    }

    /// True if it needs a frame: it belongs to one, or its result ranges over all that are requested.
    #[must_use]
    pub fn needs_a_frame(self) -> bool {
        self.of_a_frame() || self.further().contains(&Space::Frames)
    }

    /// Equivalent algorithms, among which the one with the fewest operations is chosen.
    #[must_use]
    pub fn algorithms(self) -> Vec<Algorithm> {
        (self.definition().algorithms)()
    }

    /// Multiplications and additions by dense 4×4 matrices. `path`: the number of joints, of all `joints`, that lead to
    /// the frame of the function. Divisions and roots count as multiplications.
    #[must_use]
    pub fn dense(self, joints: usize, path: usize, spaces: &Spaces) -> (usize, usize) {
        let size = Size {
            joints,
            path,
            frames: spaces.len(Space::Frames),
            spheres: spaces.len(Space::Spheres),
            pairs: spaces.len(Space::Pairs),
        };
        let Tally { mul, add } = (self.definition().dense)(size);
        (mul, add)
    }

    /// Expressions of its results, in the order of its quantities. `frame` is read by functions of a frame.
    #[must_use]
    pub fn build<'g>(
        self,
        graph: &'g Graph,
        bodies: &Bodies<'g>,
        frame: FrameId,
        algorithm: Algorithm,
    ) -> Vec<Term<'g>> {
        (self.definition().build)(&Scene::new(graph, bodies, frame, algorithm))
    }
}

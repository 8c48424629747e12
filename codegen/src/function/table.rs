//! The table of functions: how what stands in the file of each is asked for.
//!
//! In: a [`Function`]. Out: its name, what it is said to compute, arguments, result, price of dense
//! matrices, and its expressions. It knows none of it itself.

use super::Function;
use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::model::{Scene, Way};
use crate::space::{FrameId, Outcome, Space, Variable};

macro_rules! definitions {
    (
        $($variant:ident: $module:ident, $about:literal;)*
        { $($of_loops:ident: $of_loops_module:ident, $of_loops_about:literal;)* }
    ) => {
        impl Function {
            const fn definition(self) -> &'static Definition {
                match self {
                    $(Self::$variant => &super::$module::DEFINITION,)*
                    $(Self::$of_loops => &super::$of_loops_module::DEFINITION,)*
                }
            }
        }
    };
}
every_function!(definitions);

impl Function {
    /// The name in generated code, in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.definition().name
    }

    /// The function of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter().chain(Self::OF_LOOPS);
        all.find(|function| function.name() == name)
    }

    /// The names of all.
    pub fn names() -> Vec<&'static str> {
        let all = Self::ALL.into_iter().chain(Self::OF_LOOPS);
        all.map(Self::name).collect()
    }

    /// Whether only a robot with loops can have it.
    #[must_use]
    pub fn is_of_loops(self) -> bool {
        Self::OF_LOOPS.contains(&self)
    }

    /// What it computes, with the letters of the paper; `base` is what frame 0 is called, `frame` the
    /// frame that it is of.
    #[must_use]
    pub fn sentence(self, base: &str, frame: &str) -> String {
        (self.definition().sentence)(base, frame)
    }

    /// What it is a function of, in the order of its parameters.
    #[must_use]
    pub const fn arguments(self) -> &'static [Variable] {
        self.definition().arguments
    }

    fn has(self, property: Property) -> bool {
        self.definition().properties.contains(&property)
    }

    /// Whether external forces enter it.
    #[must_use]
    pub fn takes_actions(self) -> bool {
        self.has(Property::External)
    }

    /// Whether masses and moments of inertia are numbers of it, and not factors of its result.
    #[cfg(feature = "files")]
    pub(crate) fn has_mass(self) -> bool {
        self.has(Property::Mass)
    }

    /// Whether the runtime has batches of it: of none of closed loops, nor of any that actions from outside enter.
    #[must_use]
    pub fn has_batches(self, acted: bool) -> bool {
        Self::ALL.contains(&self) && !(acted && self.takes_actions())
    }

    /// What it is a function of, where actions from outside are among the lists of a robot or not.
    #[must_use]
    pub fn arguments_with(self, actions: bool) -> Vec<Variable> {
        let taken = (actions && self.takes_actions()).then_some(Variable::Actions);
        self.arguments().iter().copied().chain(taken).collect()
    }

    /// Its result.
    #[must_use]
    pub const fn result(self) -> Outcome {
        self.definition().result
    }

    /// The spaces of its result beside those of coordinates and velocities, whose lengths its trait has to know.
    pub(crate) fn further(self) -> impl Iterator<Item = Space> {
        let over = self.result().parts().flat_map(|(_, part)| part.over);
        over.copied()
            .filter(|space| !matches!(space, Space::Coordinates | Space::Velocities))
    }

    /// Whether it solves for what forces do to accelerations of joints that no loop holds together.
    #[must_use]
    pub const fn solves(self) -> bool {
        matches!(self.truth(), Truth::Solution(_))
    }

    /// Whether an inverse of the mass matrix is among its results: then it is the last of them.
    #[must_use]
    pub const fn inverts(self) -> bool {
        matches!(
            self.truth(),
            Truth::Solution(Given::MassMatrix | Given::TorqueDerivatives)
        )
    }

    /// Whether it is of robots that have mass alone.
    #[must_use]
    pub const fn is_of_mass(self) -> bool {
        matches!(self.truth(), Truth::OfMass(_))
    }

    /// Whether it depends on which joints are actuated.
    #[must_use]
    pub fn wants_drives(self) -> bool {
        self.has(Property::Actuation)
    }

    /// Whether it solves for what forces and loops do together.
    #[must_use]
    pub const fn is_constrained(self) -> bool {
        matches!(self.truth(), Truth::Constrained(_))
    }

    /// Whether it is of moving bodies alone: armature and friction do not enter it.
    #[must_use]
    pub fn is_of_bodies(self) -> bool {
        self.has(Property::BodiesAlone)
    }

    /// What every expansion of it is held against.
    pub(crate) const fn truth(self) -> Truth {
        self.definition().truth
    }

    /// Whether it is about a frame (the tip's, or a further one) rather than about the whole robot.
    #[must_use]
    pub fn of_a_frame(self) -> bool {
        self.has(Property::Frame)
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

    /// Its results in the order of its quantities; of that frame where it is of one.
    #[must_use]
    pub fn build<'g>(
        self,
        graph: &'g Graph,
        bodies: &Bodies<'g>,
        frame: FrameId,
        way: Way,
    ) -> Vec<Term<'g>> {
        (self.definition().build)(&Scene::new(graph, bodies, frame, way))
    }
}

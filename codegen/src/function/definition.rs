//! What is known of a function, and how it is asked for.
//!
//! In: a [`Function`]. Out: its name, what it is said to compute, arguments, result, price of dense
//! matrices, and its expressions. It knows none of it itself: it stands in the function's own file.

use super::Function;
use super::tally::{Size, Tally};
use crate::dense::{Approximate, Dense};
use crate::expression::{Graph, Term};
use crate::layout::Bodies;
use crate::model::{Scene, Way};
use crate::space::{Quantity, Variable};

/// What the results of a function are held against, whatever way they were found.
#[derive(Clone, Copy)]
pub(crate) enum Truth {
    /// What dense matrices make of a state; of the frame of that index where it is of one.
    Value(fn(&Dense, usize) -> Vec<Approximate>),
    /// An equation that they solve, in which that is given.
    Solution(Given),
}

/// What a solution is found for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// τ, of which accelerations are the solution.
    Torques,
    /// M, of which each column of the inverse is one, from the diagonal up: each for another M.
    MassMatrix,
}

/// Everything that is known of a function.
pub(super) struct Definition {
    /// The name in generated code, in attributes and on the command line.
    pub(super) name: &'static str,
    /// What it computes, with the letters of the paper, by the names of frame 0 and of the frame that it
    /// is of.
    pub(super) sentence: fn(&str, &str) -> String,
    /// What it is a function of, in the order of its parameters.
    pub(super) arguments: &'static [Variable],
    /// Its result.
    pub(super) result: Quantity,
    /// Whether it is about a frame (the tip's, or a further one) rather than about the whole robot.
    pub(super) of_a_frame: bool,
    /// What every expansion is held against.
    pub(super) truth: Truth,
    /// The ways to compute it between which only the count decides.
    pub(super) ways: fn() -> Vec<Way>,
    /// What it costs by dense 4×4 matrices.
    pub(super) dense: fn(Size) -> Tally,
    /// Its results, in the order of its quantity.
    pub(super) build: for<'g> fn(&Scene<'_, 'g>) -> Vec<Term<'g>>,
}

impl Definition {
    /// No alternatives.
    pub(super) fn one_way() -> Vec<Way> {
        vec![Way::PLAIN]
    }
}

impl Function {
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
    pub const fn arguments(self) -> &'static [Variable] {
        self.definition().arguments
    }

    /// Its result.
    #[must_use]
    pub const fn result(self) -> Quantity {
        self.definition().result
    }

    /// Whether it solves for what forces do to accelerations.
    #[must_use]
    pub const fn solves(self) -> bool {
        self.given().is_some()
    }

    /// What it is a solution for, if it is one.
    #[must_use]
    pub const fn given(self) -> Option<Given> {
        match self.truth() {
            Truth::Value(_) => None,
            Truth::Solution(given) => Some(given),
        }
    }

    /// What every expansion of it is held against.
    pub(crate) const fn truth(self) -> Truth {
        self.definition().truth
    }

    /// Whether it is about a frame (the tip's, or a further one) rather than about the whole robot.
    #[must_use]
    pub const fn of_a_frame(self) -> bool {
        self.definition().of_a_frame
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

    /// Its results in the order of its quantity; of the frame of that index where it is of one.
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

//! The program of one layout and one algorithm.

use std::cell::RefCell;
use std::rc::Rc;

use crate::chain::{BodyId, Chain};
use crate::expression::{Expr, Graph, Input, Term};
use crate::function::Function;
use crate::layout::{Bodies, Layout, arrange};
use crate::list::List;
use crate::model::{
    ARTICULATED_INERTIA, Algorithm, articulated_motion, articulated_steps, equation,
    equation_at_rest, free_fall, torque_derivatives,
};
use crate::schedule::{Program, schedule};
use crate::simplify::simplify;
use crate::space::FrameId;

/// The bodies of a chain in the frames of a layout, as expressions of a graph. Frames are chosen here alone: bounds and
/// descriptions of a plan take its bodies from here.
#[must_use]
pub fn arranged<'g>(graph: &'g Graph, chain: &Chain, layout: Layout) -> Bodies<'g> {
    arrange(graph, chain, layout)
}

/// The program of functions in a layout, by an algorithm.
#[must_use]
pub fn program_by(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    layout: Layout,
    algorithm: Algorithm,
) -> Program {
    let (graph, results) = expressions_by(chain, functions, frame, layout, algorithm);
    schedule(&graph, &results)
}

/// Programs of a chain for bounds, each made once, when it is first needed.
pub struct Programs<'c> {
    chain: &'c Chain,
    made: RefCell<Vec<(ProgramKey, Rc<Program>)>>,
}

/// The inputs that determine a program.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ProgramKey {
    Function(Function, Layout, Algorithm),
    Equation(Layout, Algorithm, bool),
    EquationAtRest(Layout, Algorithm),
    TorqueDerivatives(Layout, Algorithm),
    FreeFall(Layout),
}

/// The programs of the recursion over articulated bodies, one step inwards at a time.
pub struct Recursion {
    /// Motion of the bodies at given velocities and accelerations.
    pub motion: Program,
    /// Change of frame of an inertia, from each body to its parent.
    pub inertias: List<BodyId, Program>,
    /// Change of frame of a wrench, from each body to its parent.
    pub actions: List<BodyId, Program>,
}

impl<'c> Programs<'c> {
    /// An empty cache of programs.
    #[must_use]
    pub fn of(chain: &'c Chain) -> Rc<Self> {
        Rc::new(Self {
            chain,
            made: RefCell::new(Vec::new()),
        })
    }

    /// The robot.
    #[must_use]
    pub const fn chain(&self) -> &'c Chain {
        self.chain
    }

    /// The program of a function of the whole robot.
    pub fn function(
        &self,
        function: Function,
        layout: Layout,
        algorithm: Algorithm,
    ) -> Rc<Program> {
        self.get(ProgramKey::Function(function, layout, algorithm), || {
            program_by(self.chain, &[function], FrameId::FIRST, layout, algorithm)
        })
    }

    /// The program of the equation of motion: the mass matrix, and the torques at q̈ = 0 with external wrenches, if
    /// there are any; with `has_residual` also the torques of given accelerations. Accelerations of a floating base are
    /// relative to its fall.
    pub fn equation(
        &self,
        layout: Layout,
        algorithm: Algorithm,
        has_residual: bool,
    ) -> Rc<Program> {
        self.get(
            ProgramKey::Equation(layout, algorithm, has_residual),
            || {
                compiled(self.chain, layout, |graph, bodies| {
                    equation(graph, bodies, algorithm, has_residual)
                })
            },
        )
    }

    /// The program of the derivatives of torques by q and q̇, at such accelerations.
    pub fn torque_derivatives(&self, layout: Layout, algorithm: Algorithm) -> Rc<Program> {
        self.get(ProgramKey::TorqueDerivatives(layout, algorithm), || {
            compiled(self.chain, layout, |graph, bodies| {
                torque_derivatives(graph, bodies, algorithm)
            })
        })
    }

    /// The program of the fall of a floating base: its acceleration, and the derivatives of it by q and q̇.
    pub fn free_fall(&self, layout: Layout) -> Rc<Program> {
        self.get(ProgramKey::FreeFall(layout), || {
            compiled(self.chain, layout, free_fall)
        })
    }

    /// The same as [`equation`](Self::equation) for the refinement of the inverse of the mass matrix.
    pub fn equation_at_rest(&self, layout: Layout, algorithm: Algorithm) -> Rc<Program> {
        self.get(ProgramKey::EquationAtRest(layout, algorithm), || {
            compiled(self.chain, layout, |graph, bodies| {
                equation_at_rest(graph, bodies, algorithm)
            })
        })
    }

    /// The programs of the recursion over articulated bodies; the arguments of a step are inputs.
    #[must_use]
    pub fn recursion(
        &self,
        layout: Layout,
        algorithm: Algorithm,
        given: impl Fn(usize) -> Input,
    ) -> Recursion {
        let graph = self.chain.graph.clone();
        let bodies = arranged(&graph, self.chain, layout);
        let motion = scheduled(&graph, &articulated_motion(&graph, &bodies, algorithm));
        let given = std::array::from_fn(|k| graph.input(given(k)));
        let steps = articulated_steps(&graph, &bodies, algorithm, &given).into_iter();
        let (inertias, actions) = steps
            .map(|step| {
                let (inertia, action) = step.split_at(ARTICULATED_INERTIA);
                (scheduled(&graph, inertia), scheduled(&graph, action))
            })
            .unzip();
        Recursion {
            motion,
            inertias,
            actions,
        }
    }

    fn get(&self, key: ProgramKey, make: impl FnOnce() -> Program) -> Rc<Program> {
        let made = self.made.borrow();
        let before = made.iter().find(|(other, _)| *other == key);
        if let Some((_, program)) = before {
            return Rc::clone(program);
        }
        drop(made);
        let program = Rc::new(make());
        self.made.borrow_mut().push((key, Rc::clone(&program)));
        program
    }
}

fn compiled(
    chain: &Chain,
    layout: Layout,
    results: impl for<'g> FnOnce(&'g Graph, &Bodies<'g>) -> Vec<Term<'g>>,
) -> Program {
    let graph = chain.graph.clone();
    let bodies = arranged(&graph, chain, layout);
    scheduled(&graph, &results(&graph, &bodies))
}

fn scheduled(graph: &Graph, results: &[Term<'_>]) -> Program {
    let results: Vec<Expr> = results.iter().map(|result| result.expr()).collect();
    let (graph, results) = simplify(graph, &results);
    schedule(&graph, &results)
}

/// The expressions of that program, with the graph that holds them.
#[must_use]
pub fn expressions_by(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    layout: Layout,
    algorithm: Algorithm,
) -> (Graph, Vec<Expr>) {
    let graph = chain.graph.clone();
    let bodies = arranged(&graph, chain, layout);
    let results: Vec<Expr> = (functions.iter())
        .flat_map(|&function| function.build(&graph, &bodies, frame, algorithm))
        .map(Term::expr)
        .collect();
    simplify(&graph, &results)
}

//! The cheapest among programs that compute the same by one form of forward dynamics.
//!
//! In: a chain, the functions that are requested together, a formulation, a processor. Out: for a form, the program
//! with the least cost, over all layouts of the frames and all algorithms or over some. Costs alone decide; callers
//! measure the error and note it in a [`ChosenProgram`].

use super::forward::ForwardForm;
use super::measured::MeasuredError;
use super::program::expressions_by;
use crate::chain::Chain;
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Algorithm;
use crate::processor::Processor;
use crate::real::Real;
use crate::schedule::{OperationCount, Program, schedule, schedule_unfused};
use crate::space::FrameId;

/// A program with its layout and algorithm.
pub(super) struct ChosenProgram {
    pub(super) program: Program,
    pub(super) layout: Layout,
    pub(super) algorithm: Algorithm,
    /// Its measured error, if the form was chosen by it.
    pub(super) error: MeasuredError,
}

/// The search for the cheapest program.
pub(super) struct Search<'a> {
    processor: Processor,
    pub(super) formulation: Formulation,
    pub(super) chain: &'a Chain,
    pub(super) functions: &'a [Function],
    frame: FrameId,
    pub(super) scalar: Real,
    layouts: Vec<Layout>,
    algorithms: Vec<Algorithm>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        processor: Processor,
        formulation: Formulation,
        chain: &'a Chain,
        functions: &'a [Function],
        frame: FrameId,
        scalar: Real,
    ) -> Self {
        let dynamic = functions.iter().any(|function| !function.needs_a_frame());
        Self {
            processor,
            formulation,
            chain,
            functions,
            frame,
            scalar,
            layouts: if dynamic {
                Layout::for_dynamics(chain)
            } else {
                Layout::for_kinematics(chain)
            },
            algorithms: algorithms(formulation, functions),
        }
    }

    /// The cheapest program in a form of forward dynamics, over all layouts and algorithms; its error has not been
    /// measured.
    pub(super) fn best(&self, form: ForwardForm) -> (usize, ChosenProgram) {
        self.within(form, &self.layouts, &self.algorithms, &mut Vec::new())
    }

    /// The cheapest program of each layout, the cheapest layout first; once, if layouts give the same program. Takes
    /// programs of this form that have been made.
    pub(super) fn by_cost(
        &self,
        form: ForwardForm,
        mut made: Vec<(usize, ChosenProgram)>,
    ) -> Vec<(usize, ChosenProgram)> {
        let layouts = self.layouts.chunks(1);
        let mut found: Vec<_> = layouts
            .map(|layout| self.within(form, layout, &self.algorithms, &mut made))
            .collect();
        found.sort_by_key(|(cost, _)| *cost);
        found.dedup_by(|(_, one), (_, other)| one.program == other.program);
        found
    }

    /// The program in the layout and by the algorithm of another one. Takes a program that has been made.
    pub(super) fn like(
        &self,
        other: &ChosenProgram,
        form: ForwardForm,
        made: &mut Vec<(usize, ChosenProgram)>,
    ) -> (usize, ChosenProgram) {
        self.within(form, &[other.layout], &[other.algorithm], made)
    }

    /// The same as [`best`](Self::best), over some layouts and algorithms. Takes programs that have been made.
    fn within(
        &self,
        form: ForwardForm,
        layouts: &[Layout],
        algorithms: &[Algorithm],
        made: &mut Vec<(usize, ChosenProgram)>,
    ) -> (usize, ChosenProgram) {
        // Articulated inertias must be those of physical bodies, and a refinement is as good as its residual: regrouped
        // parameters contain masses of heavy neighbours, and their rounding errors are of that size.
        let physical =
            form.forward != Forward::UNREFINED || self.formulation.parameters == Parameters::Raw;
        let mut best: Option<(usize, ChosenProgram)> = None;
        for &layout in layouts {
            let regroup = layout.regroup && !physical;
            let layout = Layout { regroup, ..layout };
            for &algorithm in algorithms {
                let scalar = self.scalar;
                let algorithm = Algorithm {
                    scalar,
                    ..form.along(algorithm)
                };
                let known = (made.iter())
                    .position(|(_, found)| (found.layout, found.algorithm) == (layout, algorithm));
                let found = match known {
                    Some(place) => made.swap_remove(place),
                    None => self.make(layout, algorithm),
                };
                if best.as_ref().is_none_or(|(least, _)| found.0 < *least) {
                    best = Some(found);
                }
            }
        }
        best.expect("there is at least one layout and one way")
    }

    /// The program of a layout and an algorithm, and its cost.
    fn make(&self, layout: Layout, algorithm: Algorithm) -> (usize, ChosenProgram) {
        let (chain, functions) = (self.chain, self.functions);
        let (graph, results) = expressions_by(chain, functions, self.frame, layout, algorithm);
        let schedule = match self.formulation.products {
            Products::Fused if self.processor.fuses(self.scalar) => schedule,
            Products::Fused | Products::Unfused => schedule_unfused,
        };
        let program = schedule(&graph, &results);
        let cost = OperationCount::of(&program).weight(self.processor, self.scalar);
        let found = ChosenProgram {
            program,
            layout,
            algorithm,
            error: MeasuredError::NONE,
        };
        (cost, found)
    }
}

/// The algorithms among which the operation count decides.
fn algorithms(formulation: Formulation, functions: &[Function]) -> Vec<Algorithm> {
    let apart = match formulation.frame {
        Frame::Link => functions
            .iter()
            .map(|&function| function.algorithms())
            .max_by_key(Vec::len)
            .unwrap_or_default(),
        Frame::Base => vec![Algorithm::IN_FRAME_0],
    };
    match formulation.angles {
        Angles::Apart => apart,
        Angles::Merged => {
            let merged = apart.iter().map(|&algorithm| Algorithm {
                angles: Angles::Merged,
                ..algorithm
            });
            merged.chain(apart.iter().copied()).collect()
        }
    }
}

//! Runs a scheduled program at many states.
//!
//! Each operation is done for several states at a time, and states are distributed over all cores; neither changes a
//! bit of the results.

use std::array::from_fn;
use std::num::NonZero;
use std::thread;

use super::super::options::Scalar;
use super::states::States;
use homogen_codegen::arithmetic::OwnSines;
use homogen_codegen::expression::Input;
use homogen_codegen::formulation::Sines;
use homogen_codegen::schedule::{Arithmetic, LANES, Lanes, Program, run};
use homogen_codegen::space::Variable;

/// A function, ready to be computed.
pub(super) struct Values<'p> {
    pub(super) program: &'p Program,
    pub(super) arguments: &'p [Variable],
    pub(super) scalar: Scalar,
    pub(super) sines: Sines,
}

impl Values<'_> {
    /// The results at each state, one state after the other; `f64`s, also for single precision.
    pub(super) fn at(&self, states: &States) -> Vec<f64> {
        let mut results = vec![0.0; states.count * self.program.results.len()];
        if results.is_empty() {
            return results;
        }
        match (self.scalar, self.sines) {
            (Scalar::F32, Sines::Own) => self.on_all_cores::<OwnSines<f32>>(states, &mut results),
            (Scalar::F64, Sines::Own) => self.on_all_cores::<OwnSines<f64>>(states, &mut results),
            (Scalar::F32, Sines::Platform) => self.on_all_cores::<f32>(states, &mut results),
            (Scalar::F64, Sines::Platform) => self.on_all_cores::<f64>(states, &mut results),
        }
        results
    }

    fn on_all_cores<T: Arithmetic + Copy + Into<f64>>(&self, states: &States, results: &mut [f64]) {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        // A share that is large enough for a thread, in whole packs.
        let share = states
            .count
            .div_ceil(cores)
            .max(16 * LANES)
            .next_multiple_of(LANES);
        let shares = results.chunks_mut(share * self.program.results.len());
        let shares = (0..).step_by(share).zip(shares);
        thread::scope(|scope| {
            for (first, results) in shares {
                if states.count <= share {
                    self.one_after_the_other::<T>(states, first, results);
                } else {
                    scope.spawn(move || self.one_after_the_other::<T>(states, first, results));
                }
            }
        });
    }

    fn one_after_the_other<T: Arithmetic + Copy + Into<f64>>(
        &self,
        states: &States,
        first: usize,
        results: &mut [f64],
    ) {
        let each = self.program.results.len();
        for (first, results) in (first..)
            .step_by(LANES)
            .zip(results.chunks_mut(LANES * each))
        {
            let last = first + results.len() / each - 1;
            let input = |input| match input {
                Input::Variable(wanted, k) => {
                    let index = self
                        .arguments
                        .iter()
                        .position(|&argument| argument == wanted);
                    let index = index.expect("a program reads the arguments of its function");
                    // If there are fewer states than lanes, the others repeat the last one.
                    Lanes(from_fn(|lane| {
                        let state = states.argument(index, (first + lane).min(last));
                        T::literal(state[usize::from(k)])
                    }))
                }
                Input::Parameter(..) => unreachable!("the command line has no run-time parameters"),
            };
            for (k, lanes) in run(self.program, input).into_iter().enumerate() {
                let of_states = results.iter_mut().skip(k).step_by(each);
                for (result, number) in of_states.zip(lanes.0) {
                    *result = number.into();
                }
            }
        }
    }
}

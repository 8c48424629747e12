//! Errors compared with their printed bounds, by true values that are read from the file independently.
//!
//! In: a [`Prepared`] robot, a function, a scalar type. Out: the largest ratio of error to bound of a result, at states
//! in the range of the bounds. Errors of reading the file are included.

use homogen_codegen::Function;
use homogen_codegen::accuracy::{self, Accuracy, RoundingModel};
use homogen_codegen::formulation::Formulation;
use homogen_codegen::range::Range;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{FrameId, Space, Variable};

use super::prepared::Prepared;
use crate::arguments::Arguments;
use crate::big::Big;
use crate::climb::{any, of_results};
use crate::oracle::frame_0;
use crate::programs::program_as;
use crate::states::Random;
use crate::tested::Tested;

/// Rounding errors of 256 bits where the true value is zero, in any unit.
const NEGLIGIBLE: f64 = 1e-50;

impl Prepared<'_> {
    /// The largest ratio of error to bound, and its result; `None` if the function has no bound, or no frame.
    #[must_use]
    pub fn share_of_bound<T: Tested>(
        &self,
        function: Function,
        states: usize,
        random: &mut Random,
    ) -> Option<(f64, String)> {
        let (chain, frame) = (self.chain(), FrameId::FIRST);
        let links = self.links_of(function, frame);
        if function.needs_a_frame() && links.is_empty() {
            return None;
        }
        let program =
            program_as(Formulation::default(), chain, &[function], frame, T::REAL).ok()?;
        let rounding = RoundingModel {
            scalar: T::REAL,
            ..RoundingModel::default()
        };
        let Accuracy::Within(bound) = accuracy::of(chain, &[function], &program, rounding)? else {
            return None;
        };
        let bounds = of_results(chain, function, &bound.bounds);
        let bounds = self.in_order(function, &bounds);
        let mut robot = self.dense().robot.clone();
        robot.frames = links.iter().map(|&link| self.dense().body(link)).collect();
        let mut worst = (0.0, String::new());
        for _ in 0..states {
            let state = self.within_range::<T>(random);
            let found = run::<T>(&program, |input| T::literal(self.input(input, &state)));
            let found: Vec<f64> = found.into_iter().map(T::to_f64).collect();
            let expected = frame_0::evaluate(&robot, function, 0, &state);
            let found = self.in_order(function, &found).into_iter();
            let results = found.zip(expected).zip(&bounds).enumerate();
            for (k, ((found, expected), bound)) in results {
                let error = (Big::new(found) - expected).abs().to_f64();
                if error > NEGLIGIBLE && error / bound > worst.0 {
                    let what =
                        format!("entry {k}, {found:e}, has error {error:e}, bound {bound:e}");
                    worst = (error / bound, what);
                }
            }
        }
        Some(worst)
    }

    /// Random arguments of the type within the range, often at its ends.
    fn within_range<T: Tested>(&self, random: &mut Random) -> Arguments {
        let range = Range::of(self.chain());
        let mut drawn = |space: Space, ranges: &[[f64; 2]]| {
            let mut numbers = vec![0.0; ranges.len()];
            for (k, &ends) in ranges.iter().enumerate() {
                numbers[self.place(space, k)] = any::<T>(ends, random);
            }
            numbers
        };
        let mut arguments = Arguments::default();
        for variable in [Variable::Q, Variable::Qd, Variable::Qdd] {
            arguments[variable] = drawn(variable.space(), &range.arguments[variable]);
        }
        arguments[Variable::Tau] = vec![0.0; arguments[Variable::Qd].len()];
        let actions = range.arguments[Variable::Actions].iter();
        arguments[Variable::Actions] = actions.map(|&ends| any::<T>(ends, random)).collect();
        arguments
    }
}

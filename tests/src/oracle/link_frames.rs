//! Values of the graph that the generator would print, in 256 bits.
//!
//! In: a chain, a layout and an algorithm. Out: an evaluation that starts from the literals of the description: no
//! number is rounded to the 106 bits of the generator or to `f64`.

use homogen_codegen::Function;
use homogen_codegen::chain::Chain;
use homogen_codegen::expression::Evaluation;
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::expressions_by;
use homogen_codegen::space::FrameId;

use super::state::State;
use crate::arguments::{Arguments, at};
use crate::big::Big;

/// Functions of a chain in the frames and with the parameters of a layout, by one algorithm; the results of one follow
/// those of the other.
#[must_use]
pub fn expressions(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    layout: Layout,
    algorithm: Algorithm,
) -> Evaluation<Big> {
    let (graph, results) = expressions_by(chain, functions, frame, layout, algorithm);
    Evaluation::of(&graph, &results)
}

/// A function in the frames of the description, by the plainest algorithm.
#[must_use]
pub fn truth(chain: &Chain, function: Function, frame: FrameId) -> Evaluation<Big> {
    expressions(
        chain,
        &[function],
        frame,
        Layout::DESCRIBED,
        Algorithm::PLAIN,
    )
}

/// The values of an evaluation for a chain without quaternions.
#[must_use]
pub fn evaluate(evaluation: &Evaluation<Big>, arguments: &Arguments) -> Vec<Big> {
    evaluation.at(|input| Big::new(at(arguments, input)))
}

/// The values of an evaluation at a state.
#[must_use]
pub fn evaluate_in(evaluation: &Evaluation<Big>, state: &State) -> Vec<Big> {
    evaluation.at(|input| at(state, input))
}

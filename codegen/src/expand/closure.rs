//! What loops close in every posture, and what they never can.
//!
//! In: a chain. Out: the same without the residuals that are zero whatever the joints do, as those across
//! the plane of a four-bar are; or a mistake for each that is some other number whatever they do, and for
//! each loop of which nothing is left. It never evaluates a posture.

use super::program::expressions_by;
use crate::chain::{Chain, Loop};
use crate::error::Errors;
use crate::expression::Double;
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Way;
use crate::space::{FrameId, Kind};
use crate::wording::quoted;

/// What digits that were rounded to make frames may leave of nothing [m, 1].
const ROUNDED: f64 = 1e-9;

/// The chain with the residuals that joints can change.
///
/// # Errors
/// Where a loop cannot close, or holds nothing.
pub fn settled(mut chain: Chain) -> Result<Chain, Errors> {
    if chain.loops.is_empty() {
        return Ok(chain);
    }
    let (layout, way) = (Layout::DESCRIBED, Way::PLAIN);
    let (graph, results) =
        expressions_by(&chain, &[Function::Constraint], FrameId::FIRST, layout, way);
    let values = results.iter().map(|&result| graph.value(result));
    let values: Vec<Option<f64>> = values.map(|value| value.map(Double::to_f64)).collect();
    let mut errors = chain.source.errors();
    let mut rest = &*values;
    for closed in &chain.loops {
        let (own, others) = rest.split_at(closed.rows.len());
        rest = others;
        for (row, value) in closed.rows.iter().zip(own) {
            let Some(value) = value.filter(|value| value.abs() > ROUNDED) else {
                continue;
            };
            let unit = if row.kind() == Kind::Slide { " m" } else { "" };
            errors.push_with_hint(
                closed.place,
                format!(
                    "loop {} cannot close: {} is {value}{unit} whatever the joints do",
                    quoted(&closed.name),
                    quoted(&row.name(&closed.name))
                ),
                "put it elsewhere by `at` or `to_at`, or give it a type that leaves this free",
            );
        }
        if own.iter().all(Option::is_some) && errors.is_empty() {
            let name = quoted(&closed.name);
            let message = format!("loop {name} holds nothing: it is closed whatever the joints do");
            errors.push_with_hint(closed.place, message, "leave it out");
        }
    }
    let mut constant = values.into_iter().map(|value| value.is_some());
    let mut closed = Vec::new();
    chain.close(|loops| {
        for Loop { name, rows, .. } in loops {
            rows.retain(|row| {
                let leaves = constant.next().unwrap_or(false);
                closed.extend(leaves.then(|| row.name(name)));
                !leaves
            });
        }
    });
    chain.report.closed = closed;
    errors.into_result(chain)
}

#[cfg(test)]
mod tests;

//! Names and shapes of results, as text, JSON, or columns of a table. Matrices of four rows are complete in each of
//! them.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::super::options::Scalar;
use homogen_codegen::chain::Chain;
use homogen_codegen::function::Function;
use homogen_codegen::space::{FrameId, Quantity, Space, Spaces};
use homogen_codegen::wording::visible;
use homogen_page::diagnostics::warnings;
use homogen_page::result::{by_name, dimensions, names_of_rows, rows, values};

/// Layout of the results of a function.
pub(super) struct Layout<'c> {
    chain: &'c Chain,
    function: Function,
    /// The frame of the function, if it has one.
    frame: FrameId,
    pub(super) scalar: Scalar,
    pub(super) results: Vec<Shaped>,
}

/// One result of a function.
pub(super) struct Shaped {
    /// The lengths of its nested arrays in a state, the outermost first.
    pub(super) lengths: Vec<usize>,
    quantity: Quantity,
}

impl<'c> Layout<'c> {
    pub(super) fn of(chain: &'c Chain, function: Function, frame: FrameId, scalar: Scalar) -> Self {
        let results = function.result().parts();
        let results = results.map(|(_, quantity)| Shaped {
            lengths: dimensions(&quantity, chain.spaces()),
            quantity,
        });
        Self {
            chain,
            function,
            frame,
            scalar,
            results: results.collect(),
        }
    }

    /// Number of numbers that a program computes for a state.
    fn each(&self) -> usize {
        self.function.result().size(self.chain.spaces())
    }

    /// The numbers of each result at some states, complete, one state after the other.
    pub(super) fn columns(&self, numbers: &[f64], states: usize) -> Vec<Vec<f64>> {
        let spaces = self.chain.spaces();
        let columns = self.results.iter();
        let columns = columns.map(|result| states * result.lengths.iter().product::<usize>());
        let mut columns: Vec<Vec<f64>> = columns.map(Vec::with_capacity).collect();
        for state in numbers.chunks(self.each().max(1)) {
            let parts = self.function.result().split(spaces, state);
            for ((column, result), numbers) in columns.iter_mut().zip(&self.results).zip(parts) {
                match rows(&result.quantity, spaces, numbers) {
                    Some(rows) => column.extend(rows.into_iter().flatten()),
                    None => column.extend_from_slice(numbers),
                }
            }
        }
        columns
    }

    /// As JSON, a list of numbers for each state.
    pub(super) fn in_json(&self, results: &[Vec<f64>]) -> Value {
        let chain = self.chain;
        let spaces = chain.spaces();
        let result = self.function.result();
        let names = |space| spaces.names(space).collect::<Value>();
        let mut answer = Map::new();
        answer.insert("function".into(), json!(self.function.name()));
        answer.insert("coordinates".into(), names(Space::Coordinates));
        answer.insert("velocities".into(), names(Space::Velocities));
        answer.insert("joints".into(), json!(chain.report.joints));
        for (key, space) in [
            ("constraints", Space::Constraints),
            ("frames", Space::Frames),
            ("spheres", Space::Spheres),
            ("pairs", Space::Pairs),
        ] {
            if (result.parts()).any(|(_, part)| part.over.contains(&space)) {
                answer.insert(key.into(), names(space));
            }
        }
        if self.function.of_a_frame() {
            answer.insert("base".into(), json!(chain.report.base));
            answer.insert("frame".into(), json!(chain.frames[self.frame].name));
        }
        let shapes = self.results.iter().map(|result| json!(result.lengths));
        answer.insert("shape".into(), by_name(result, shapes));
        if let Some(rows) = result.parts().find_map(|(_, part)| names_of_rows(&part)) {
            answer.insert("rows".into(), json!(rows));
        }
        answer.insert("warnings".into(), warnings(&chain.report.warnings));
        let results = results.iter();
        let results = results.map(|numbers| values(result, spaces, numbers));
        answer.insert("results".into(), results.collect());
        Value::Object(answer)
    }

    /// As text.
    pub(super) fn in_text(&self, results: &[Vec<f64>]) -> String {
        let spaces = self.chain.spaces();
        let function = self.function;
        let result = function.result();
        let mut text = String::new();
        for (index, numbers) in results.iter().enumerate() {
            for ((part, quantity), numbers) in result.parts().zip(result.split(spaces, numbers)) {
                // Writing to a string cannot fail.
                let _ = match part {
                    Some(part) => writeln!(text, "{part} of {} of state {index}", function.name()),
                    None => writeln!(text, "{} of state {index}", function.name()),
                };
                quantity_in_text(&mut text, spaces, &quantity, numbers);
            }
        }
        text
    }

    /// The numbers as the `f64`s that print alike: 0.1 in `f32` prints as 0.1, and not with the digits of the same
    /// number in `f64`.
    pub(super) fn shortest(&self, numbers: &[f64]) -> Vec<f64> {
        let numbers = numbers.iter();
        numbers
            .map(|&number| match self.scalar {
                #[expect(
                    clippy::cast_possible_truncation,
                    reason = "it was in single precision"
                )]
                Scalar::F32 => (number as f32).to_string().parse().unwrap_or(f64::NAN),
                Scalar::F64 => number,
            })
            .collect()
    }
}

fn quantity_in_text(text: &mut String, spaces: &Spaces, quantity: &Quantity, numbers: &[f64]) {
    if let Some(rows) = rows(quantity, spaces, numbers) {
        for row in rows {
            let row: Vec<String> = row.iter().map(|number| format!("{number:>24?}")).collect();
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", row.concat());
        }
    } else {
        for (k, number) in numbers.iter().enumerate() {
            let owner = quantity.owner(spaces, k);
            let entry = owner.map(|(space, entry)| &spaces.entries(space)[entry]);
            let name = entry.map_or(String::new(), |entry| format!("  {}", visible(&entry.name)));
            let _ = writeln!(text, "{number:>24?}{name}");
        }
    }
}

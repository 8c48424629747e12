//! Names and shapes of results, as text, JSON, or columns of a table. Matrices of four rows are complete in each of
//! them.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::super::json;
use super::super::options::Scalar;
use homogen_codegen::chain::Chain;
use homogen_codegen::function::Function;
use homogen_codegen::space::{Entity, FrameId, Outcome, Quantity, Space, Spaces};
use homogen_codegen::wording::visible;

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
        if (result.parts()).any(|(_, part)| part.over.contains(&Space::Constraints)) {
            answer.insert("constraints".into(), names(Space::Constraints));
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
        answer.insert("warnings".into(), json::warnings(&chain.report.warnings));
        let results = results.iter().map(|numbers| {
            let parts = result.parts().zip(result.split(spaces, numbers));
            let values =
                parts.map(
                    |((_, part), numbers)| match (rows(&part, spaces, numbers), numbers) {
                        (Some(rows), _) => json!(rows),
                        (None, [number]) if part.over.is_empty() => json!(number),
                        (None, numbers) => json!(numbers),
                    },
                );
            by_name(result, values)
        });
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

/// Names of the rows of a matrix with a column for each joint.
fn names_of_rows(quantity: &Quantity) -> Option<&'static [&'static str]> {
    const SIX: [&str; 6] = [
        "angular_x",
        "angular_y",
        "angular_z",
        "linear_x",
        "linear_y",
        "linear_z",
    ];
    match (quantity.over, quantity.entity) {
        ([], _) => None,
        (_, Entity::Screw | Entity::Momentum) => Some(&SIX),
        (_, Entity::Vector) => Some(&["x", "y", "z"]),
        _ => None,
    }
}

/// A value for each quantity: an object if there are several, or the only one.
fn by_name(result: Outcome, values: impl Iterator<Item = Value>) -> Value {
    let parts = result.parts().zip(values);
    parts.fold(Value::Null, |mut all, ((name, _), value)| match name {
        Some(name) => {
            all[name] = value;
            all
        }
        None => value,
    })
}

/// The rows and columns of a result: complete matrices of four rows, or columns for each joint.
fn dimensions(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut lengths = quantity.lengths(spaces);
    let dimensions = quantity.entity.dimensions();
    match (quantity.over, dimensions) {
        ([], [6] | [3, 4]) => lengths.extend([4, 4]),
        ([], dimensions) => lengths.extend(dimensions),
        (_, &[rows]) => lengths.insert(0, rows),
        _ => {}
    }
    lengths
}

/// The rows of a complete matrix; `None` for a vector.
fn rows(quantity: &Quantity, spaces: &Spaces, numbers: &[f64]) -> Option<Vec<Vec<f64>>> {
    let under = |last: [f64; 4]| {
        let rows = numbers.chunks(4).map(<[f64]>::to_vec);
        rows.chain([last.to_vec()]).collect()
    };
    // The vector of a skew-symmetric block, the last column, and the last row.
    let skew = |last: [f64; 3]| {
        let (w, v) = (&numbers[..3], &numbers[3..]);
        let [x, y, z] = last;
        vec![
            vec![0.0, -w[2], w[1], v[0]],
            vec![w[2], 0.0, -w[0], v[1]],
            vec![-w[1], w[0], 0.0, v[2]],
            vec![x, y, z, 0.0],
        ]
    };
    if let (&[_], &[each]) = (quantity.over, quantity.entity.dimensions()) {
        let row = |row: usize| numbers.iter().skip(row).step_by(each).copied().collect();
        return Some((0..each).map(row).collect());
    }
    Some(match quantity.entity {
        Entity::Number => {
            let &[_, columns] = &*quantity.lengths(spaces) else {
                return None;
            };
            numbers
                .chunks(columns.max(1))
                .map(<[f64]>::to_vec)
                .collect()
        }
        Entity::Pose => under([0.0, 0.0, 0.0, 1.0]),
        Entity::Acceleration => under([0.0; 4]),
        Entity::Velocity | Entity::Screw => skew([0.0; 3]),
        Entity::Momentum | Entity::Action => skew([-numbers[3], -numbers[4], -numbers[5]]),
        Entity::Point | Entity::Vector => return None,
    })
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

//! Shapes and names of results: complete matrices, columns for each joint, and the parts of a result.

use serde_json::{Value, json};

use homogen_codegen::space::{Entity, Outcome, Quantity, Spaces};

/// The values of a result at a state: matrices as lists of rows, parts by their names.
#[must_use]
pub fn values(result: Outcome, spaces: &Spaces, numbers: &[f64]) -> Value {
    let parts = result.parts().zip(result.split(spaces, numbers));
    let values = parts.map(
        |((_, part), numbers)| match (rows(&part, spaces, numbers), numbers) {
            (Some(rows), _) => match (part.over, part.entity.dimensions()) {
                ([_, _], &[each]) => json!(rows.chunks(each).collect::<Vec<_>>()),
                ([_], [3, 4]) => json!(rows.chunks(4).collect::<Vec<_>>()),
                _ => json!(rows),
            },
            (None, [number]) if part.over.is_empty() => json!(number),
            (None, numbers) => json!(numbers),
        },
    );
    by_name(result, values)
}

/// Names of the rows of a matrix with a column for each joint.
#[must_use]
pub fn names_of_rows(quantity: &Quantity) -> Option<&'static [&'static str]> {
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
pub fn by_name(result: Outcome, values: impl Iterator<Item = Value>) -> Value {
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
#[must_use]
pub fn dimensions(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut lengths = quantity.lengths(spaces);
    let dimensions = quantity.entity.dimensions();
    match (quantity.over, dimensions) {
        ([], [6]) | (_, [3, 4]) => lengths.extend([4, 4]),
        ([], dimensions) => lengths.extend(dimensions),
        (_, &[rows]) => lengths.insert(lengths.len() - 1, rows),
        _ => {}
    }
    lengths
}

/// The rows of a complete matrix, or of several, one after the other; `None` for a vector.
#[must_use]
pub fn rows(quantity: &Quantity, spaces: &Spaces, numbers: &[f64]) -> Option<Vec<Vec<f64>>> {
    let under = |last: [f64; 4]| {
        let matrices = numbers.chunks(12).flat_map(move |matrix| {
            let rows = matrix.chunks(4).map(<[f64]>::to_vec);
            rows.chain([last.to_vec()])
        });
        matrices.collect()
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
    if let (&[.., last], &[each]) = (quantity.over, quantity.entity.dimensions()) {
        let matrices = numbers.chunks((each * spaces.len(last)).max(1));
        let rows = matrices.flat_map(|matrix| {
            let row = |row: usize| matrix.iter().skip(row).step_by(each).copied().collect();
            (0..each).map(row).collect::<Vec<_>>()
        });
        return Some(rows.collect());
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
        Entity::Pose | Entity::Acceleration => under(quantity.entity.fourth_row()?),
        Entity::Velocity | Entity::Screw => skew([0.0; 3]),
        Entity::Momentum | Entity::Action => skew([-numbers[3], -numbers[4], -numbers[5]]),
        Entity::Point | Entity::Vector => return None,
    })
}

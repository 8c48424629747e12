//! The robot as data, taken at its word.
//!
//! In: the numbers that are printed for the generic recursions of the runtime. Out: a [`Robot`] of the
//! moving joints alone, to be held against the one that was described.

use crate::dense::{Approximate, Body, Matrix, Moved, Robot};
use crate::print::ChainData;

/// How many numbers a joint has, and a frame.
const JOINT: usize = 28;
const PLACEMENT: usize = 12;

/// The robot of some data, whose numbers are given one after the other.
pub(super) fn robot(data: &ChainData, numbers: &[Approximate]) -> Robot {
    let (joints, rest) = numbers.split_at(JOINT * data.parents.len());
    let (frames, gravity) = rest.split_at(PLACEMENT * data.frames.len());
    let mut bodies: Vec<Body> = (joints.chunks(JOINT).zip(&data.parents).enumerate())
        .map(|(k, (numbers, parent))| Body {
            parent: parent.map(usize::from),
            placement: placement(&numbers[..PLACEMENT]),
            screw: [three(&numbers[12..15]), three(&numbers[15..18])],
            moved: Moved::By(k),
            inertia: inertia(&numbers[18..]),
        })
        .collect();
    let nothing = [Approximate::exact(0.0); 3];
    let mut frame = |(numbers, body): (&[Approximate], Option<u16>)| {
        bodies.push(Body {
            parent: body.map(usize::from),
            placement: placement(numbers),
            screw: [nothing; 2],
            moved: Moved::Held(0.0),
            inertia: Matrix::zero(),
        });
        Some(bodies.len() - 1)
    };
    let frames = frames.chunks(PLACEMENT).zip(&data.frames);
    let frames = frames
        .map(|(numbers, (_, body))| frame((numbers, *body)))
        .collect();
    Robot {
        bodies,
        gravity: three(gravity),
        frames,
    }
}

fn three(numbers: &[Approximate]) -> [Approximate; 3] {
    [0, 1, 2].map(|k| numbers[k])
}

fn placement(numbers: &[Approximate]) -> Matrix<Approximate> {
    let mut placement = Matrix::identity();
    for (row, numbers) in placement.0.iter_mut().zip(numbers.chunks(4)) {
        row.copy_from_slice(numbers);
    }
    placement
}

/// J of xx, yy, zz, xy, xz, yz; the first moments; the mass.
fn inertia(numbers: &[Approximate]) -> Matrix<Approximate> {
    let place = |row: usize, column: usize| match (row.min(column), row.max(column)) {
        (0, 0) => 0,
        (1, 1) => 1,
        (2, 2) => 2,
        (0, 1) => 3,
        (0, 2) => 4,
        (1, 2) => 5,
        (3, 3) => 9,
        (k, _) => 6 + k,
    };
    Matrix([0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| numbers[place(row, column)])))
}

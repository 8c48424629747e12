//! Loop closures in frame 0, in 256 bits.
//!
//! In: a robot in matrices and its motion. Out: residuals, their Jacobian, their accelerations at q̈ = 0, and the
//! system of equations of q̈ and λ. Points and axes fixed to a frame have the rates W v and H v; a residual is a
//! product of two such vectors. The residuals of each type of loop are stated here independently of the engine.

use homogen_codegen::closure::Closure;

use super::momentum::unit_motions;
use super::motion::{Motion, Positions};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::{Loop, Robot};

/// A point or an axis in frame 0 with its first and second derivatives.
struct Moving([[Big; 3]; 3]);

/// A residual: a product of two vectors that is zero where the loop is closed.
#[derive(Clone, Copy)]
enum Row {
    /// An axis of A times the vector from A to B.
    Along(usize),
    /// An axis of A times an axis of B; a cosine to subtract if they are not perpendicular.
    Axes(usize, usize),
    /// The square of the vector from A to B.
    Length,
}

use Row::{Along, Axes, Length};

fn rows(kind: Closure) -> Vec<Row> {
    let point = [Along(0), Along(1), Along(2)];
    let parallel = [Axes(0, 2), Axes(1, 2)];
    let rotation = [Axes(0, 1), Axes(1, 2), Axes(2, 0)];
    match kind {
        Closure::Fixed => [point, rotation].concat(),
        Closure::Revolute => [&point[..], &parallel].concat(),
        Closure::Prismatic => [&point[..2], &rotation].concat(),
        Closure::Cylindrical => [&point[..2], &parallel].concat(),
        Closure::Universal => [&point[..], &[Axes(2, 2)]].concat(),
        Closure::Planar => [&point[2..], &parallel].concat(),
        Closure::Translation => rotation.to_vec(),
        Closure::Spherical => point.to_vec(),
        Closure::Rod { .. } => vec![Length],
        other => panic!("{other:?} is not defined here"),
    }
}

/// The residuals of all loops.
pub(super) fn residuals(robot: &Robot, positions: &Positions) -> Vec<Big> {
    let still = Motion::at(robot, positions, &rest(robot), &rest(robot));
    each(robot, |closed, row| {
        let product = derivative(closed, row, 0, positions, &still);
        match (row, closed.closure.length()) {
            (Length, Some(length)) => {
                let length = Big::new(length.value);
                (product - &length * &length) / (&length * Big::new(2.0))
            }
            (Axes(2, 2), _) => product - &closed.cosine,
            _ => product,
        }
    })
}

/// ∂(residual)/∂(velocity), row by row.
pub(super) fn jacobian(robot: &Robot, positions: &Positions) -> Vec<Big> {
    let motions: Vec<Motion> = unit_motions(robot, positions).collect();
    let rows = each(robot, |closed, row| {
        let rates = motions.iter();
        let rates = rates.map(|motion| rate(closed, row, 1, positions, motion));
        rates.collect::<Vec<Big>>()
    });
    rows.concat()
}

/// The acceleration of each residual at q̈ = 0.
pub(super) fn bias(robot: &Robot, positions: &Positions, coasting: &Motion) -> Vec<Big> {
    each(robot, |closed, row| {
        rate(closed, row, 2, positions, coasting)
    })
}

/// The matrix [M −Jᵗ; J 0] and the right-hand side of the equations of q̈ and λ; λ = 0 for a residual that no velocity
/// changes.
pub(super) fn system(
    mass_matrix: &[Vec<Big>],
    forces: Vec<Big>,
    jacobian: &[Big],
    bias: &[Big],
) -> (Vec<Vec<Big>>, Vec<Vec<Big>>) {
    let (count, rows) = (forces.len(), bias.len());
    let mut matrix = vec![vec![Big::zero(); count + rows]; count + rows];
    for (row, entries) in mass_matrix.iter().enumerate() {
        matrix[row][..count].clone_from_slice(entries);
        for k in 0..rows {
            matrix[row][count + k] = -&jacobian[k * count + row];
            matrix[count + k][row] = jacobian[k * count + row].clone();
        }
    }
    let zero = Big::zero();
    for k in 0..rows {
        if jacobian[k * count..][..count]
            .iter()
            .all(|entry| *entry == zero)
        {
            matrix[count + k][count + k] = Big::one();
        }
    }
    let right = forces.into_iter().chain(bias.iter().map(|bias| -bias));
    (matrix, right.map(|entry| vec![entry]).collect())
}

fn rest(robot: &Robot) -> Vec<Big> {
    vec![Big::zero(); robot.velocities()]
}

fn each<T>(robot: &Robot, of: impl Fn(&Loop, Row) -> T) -> Vec<T> {
    let loops = robot.loops.iter();
    let rows = loops.flat_map(|closed| {
        rows(closed.closure)
            .into_iter()
            .map(move |row| (closed, row))
    });
    rows.map(|(closed, row)| of(closed, row)).collect()
}

/// A derivative of a residual.
fn rate(closed: &Loop, row: Row, order: usize, positions: &Positions, motion: &Motion) -> Big {
    let product = derivative(closed, row, order, positions, motion);
    match (row, closed.closure.length()) {
        (Length, Some(length)) => product / Big::new(2.0 * length.value),
        _ => product,
    }
}

/// A derivative of a row's product, by the product rule.
fn derivative(
    closed: &Loop,
    row: Row,
    order: usize,
    positions: &Positions,
    motion: &Motion,
) -> Big {
    let moving = |end: usize, column: usize| {
        let (body, placement) = &closed.frames[end];
        let m = &positions.of_frame(*body) * placement;
        let rates = [Matrix::identity(), motion.w_of(*body), motion.h_of(*body)];
        Moving(rates.map(|rate| of_column(&(&rate * &m), column)))
    };
    let between = || {
        let [Moving(from), Moving(to)] = [moving(0, 3), moving(1, 3)];
        Moving(std::array::from_fn(|n| {
            std::array::from_fn(|k| &to[n][k] - &from[n][k])
        }))
    };
    let (Moving(one), Moving(other)) = match row {
        Along(k) => (moving(0, k), between()),
        Axes(i, j) => (moving(0, i), moving(1, j)),
        Length => (between(), between()),
    };
    let product = |i: usize, j: usize| {
        let pairs = one[i].iter().zip(&other[j]);
        pairs.fold(Big::zero(), |sum, (x, y)| sum + x * y)
    };
    match order {
        0 => product(0, 0),
        1 => product(1, 0) + product(0, 1),
        _ => product(2, 0) + product(1, 1) * Big::new(2.0) + product(0, 2),
    }
}

fn of_column(matrix: &Matrix, column: usize) -> [Big; 3] {
    std::array::from_fn(|row| matrix.0[row][column].clone())
}

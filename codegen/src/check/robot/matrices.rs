//! Matrices and directions.
//!
//! In: numbers with the uncertainty of their digits. Out: placements, rotations and the inertia of a payload.

use super::Approximate;
use crate::dense::Matrix;
use crate::expression::Arithmetic;
use crate::matrix::across::is_diagonal;

/// A placement by its origin and its roll, pitch and yaw.
pub(super) fn placed([x, y, z, roll, pitch, yaw]: [Approximate; 6]) -> Matrix<Approximate> {
    let rotations = [(2, yaw), (1, pitch), (0, roll)].into_iter();
    let rotations = rotations.map(|(axis, angle)| Matrix::rotation(axis, angle.sin_cos()));
    rotations.fold(Matrix::translation([x, y, z]), |placement, rotation| {
        placement.times(&rotation)
    })
}

/// J of a payload in the frame of its link: ∫rrᵗdm about its centre, plus m c cᵗ.
pub(super) fn loaded(
    [mass, x, y, z, xx, xy, xz, yy, yz, zz]: [Approximate; 10],
) -> Matrix<Approximate> {
    let half = (xx + yy + zz) * Approximate::exact(0.5);
    let at = |a, b| mass * a * b;
    let (one, two, three) = (at(x, y) - xy, at(x, z) - xz, at(y, z) - yz);
    Matrix([
        [at(x, x) + half - xx, one, two, mass * x],
        [one, at(y, y) + half - yy, three, mass * y],
        [two, three, at(z, z) + half - zz, mass * z],
        [mass * x, mass * y, mass * z, mass],
    ])
}

/// A direction with length 1.
pub(super) fn of_length_1(direction: [Approximate; 3]) -> [Approximate; 3] {
    let sizes = direction.iter().map(|entry| entry.size());
    let largest = Approximate::exact(sizes.fold(0.0, f64::max));
    let scaled = direction.map(|entry| entry / largest);
    let [x, y, z] = scaled;
    let length = (x * x + y * y + z * z).sqrt();
    scaled.map(|entry| entry / length)
}

/// The rotation by a quaternion x, y, z, w of any length.
pub(super) fn by_quaternion(entries: [Approximate; 4]) -> Matrix<Approximate> {
    let sizes = entries.iter().map(|entry| entry.size());
    let largest = Approximate::exact(sizes.fold(0.0, f64::max));
    let entries = entries.map(|entry| entry / largest);
    let squares = entries.map(|entry| entry * entry);
    let [x, y, z, w] = squares;
    let twice = Approximate::exact(2.0) / (x + y + z + w);
    by_products(entries, |a, b| a * b, twice)
}

/// R = 1 + 2 w v̲ + 2 v̲² of a quaternion v, w, from products of its entries; `twice` is 2 divided by the squared
/// length of the quaternion.
pub(super) fn by_products<T: Copy>(
    [x, y, z, w]: [T; 4],
    product: impl Fn(T, T) -> Approximate,
    twice: Approximate,
) -> Matrix<Approximate> {
    let one = Approximate::exact(1.0);
    let rows = [
        [
            one - (product(y, y) + product(z, z)) * twice,
            (product(x, y) - product(z, w)) * twice,
            (product(x, z) + product(y, w)) * twice,
        ],
        [
            (product(x, y) + product(z, w)) * twice,
            one - (product(x, x) + product(z, z)) * twice,
            (product(y, z) - product(x, w)) * twice,
        ],
        [
            (product(x, z) - product(y, w)) * twice,
            (product(y, z) + product(x, w)) * twice,
            one - (product(x, x) + product(y, y)) * twice,
        ],
    ];
    let mut rotation = Matrix::identity();
    for (row, entries) in rows.into_iter().enumerate() {
        for (column, entry) in entries.into_iter().enumerate() {
            rotation.0[row][column] = entry;
        }
    }
    rotation
}

/// A rotation that maps z to the normal (a, b, c) of a plane, and y to its product with (c², a², b²); with the x axis
/// if that is along the normal.
pub(super) fn across(normal: [Approximate; 3]) -> Matrix<Approximate> {
    let [a, b, c] = normal;
    let [one, zero] = [1.0, 0.0].map(Approximate::exact);
    let guide = if is_diagonal(normal.map(Approximate::to_f64)) {
        [one, zero, zero]
    } else {
        [c * c, a * a, b * b]
    };
    let y = of_length_1(cross(normal, guide));
    of_columns(&[cross(y, normal), y, normal])
}

/// A rotation that maps z to the axis of a loop. For a coordinate axis, x and y map to the next two; otherwise x maps
/// to the product of the axis with the coordinate axis that is farthest from it.
pub(super) fn with_z(axis: [Approximate; 3]) -> Matrix<Approximate> {
    let sizes = axis.map(Approximate::size);
    let alone = (0..3).find(|&k| sizes[(k + 1) % 3] == 0.0 && sizes[(k + 2) % 3] == 0.0);
    let mut x = [Approximate::literal(0.0); 3];
    if let Some(k) = alone {
        x[(k + 1) % 3] = Approximate::literal(1.0);
    } else {
        let least = (0..3).fold(
            0,
            |least, k| if sizes[k] < sizes[least] { k } else { least },
        );
        x[least] = Approximate::literal(1.0);
        x = of_length_1(cross(x, axis));
    }
    of_columns(&[x, cross(axis, x), axis])
}

fn of_columns(axes: &[[Approximate; 3]; 3]) -> Matrix<Approximate> {
    let mut rotation = Matrix::identity();
    for (column, axis) in axes.iter().enumerate() {
        for (row, entry) in axis.iter().enumerate() {
            rotation.0[row][column] = *entry;
        }
    }
    rotation
}

fn cross([ax, ay, az]: [Approximate; 3], [bx, by, bz]: [Approximate; 3]) -> [Approximate; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

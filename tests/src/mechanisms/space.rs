//! Vectors and rotations in `f64` for drawing robots.

use std::array::from_fn;

use crate::states::Random;

/// A vector.
pub type Vector = [f64; 3];

/// A rotation matrix, row by row.
pub type Rotation = [Vector; 3];

/// No rotation.
pub const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// a + b.
#[must_use]
pub fn plus(a: Vector, b: Vector) -> Vector {
    from_fn(|k| a[k] + b[k])
}

/// a − b.
#[must_use]
pub fn minus(a: Vector, b: Vector) -> Vector {
    from_fn(|k| a[k] - b[k])
}

/// s a.
#[must_use]
pub fn scaled(a: Vector, s: f64) -> Vector {
    a.map(|entry| s * entry)
}

/// a · b.
#[must_use]
pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// a × b.
#[must_use]
pub fn cross(a: Vector, b: Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, k)| a[i] * b[k] - a[k] * b[i])
}

/// |a|.
#[must_use]
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// a / |a|.
#[must_use]
pub fn unit(a: Vector) -> Vector {
    scaled(a, length(a).recip())
}

/// A unit vector perpendicular to a direction.
#[must_use]
pub fn across(direction: Vector) -> Vector {
    let [x, y, z] = direction.map(f64::abs);
    let other = if x <= y && x <= z {
        [1.0, 0.0, 0.0]
    } else if y <= z {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    unit(cross(direction, other))
}

/// R v.
#[must_use]
pub fn turned(rotation: &Rotation, v: Vector) -> Vector {
    rotation.map(|row| dot(row, v))
}

/// Rᵗ.
#[must_use]
pub fn back(rotation: &Rotation) -> Rotation {
    from_fn(|i| from_fn(|k| rotation[k][i]))
}

/// A B.
#[must_use]
pub fn product(a: &Rotation, b: &Rotation) -> Rotation {
    let columns = back(b).map(|column| turned(a, column));
    back(&columns)
}

/// Roll, pitch and yaw \[rad\].
#[must_use]
pub fn roll_pitch_yaw(rotation: &Rotation) -> Vector {
    let [a, b, c] = rotation;
    [
        c[1].atan2(c[2]),
        (-c[0]).atan2(a[0].hypot(b[0])),
        b[0].atan2(a[0]),
    ]
}

/// A random rotation.
pub fn any_rotation(random: &mut Random) -> Rotation {
    let direction = unit(from_fn(|_| random.normal()));
    let other = unit(cross(direction, unit(from_fn(|_| random.normal()))));
    [direction, other, cross(direction, other)]
}

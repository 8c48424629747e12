//! M, the position matrix (paper, eq. 1): the pose of a frame in another.

use std::array;
use std::ops::{Add, Mul};

use super::Vector;
use super::vector::towards_one;
use crate::expression::{Double, Graph, Term};
use crate::matrix::across::is_diagonal;

/// A rotation matrix R, by rows.
#[derive(Clone, Copy, Debug)]
pub struct Rotation<E>(pub [[E; 3]; 3]);

/// A position matrix M: R, t; 0, 1.
#[derive(Clone, Copy, Debug)]
pub struct Pose<E> {
    /// Axes of the frame, as columns in the axes of the other.
    pub rotation: Rotation<E>,
    /// Origin of the frame in the other \[m\].
    pub translation: Vector<E>,
}

impl<E: Copy> Rotation<E> {
    /// Applies a function to each entry.
    pub fn map<F>(self, mut f: impl FnMut(E) -> F) -> Rotation<F> {
        Rotation(self.0.map(|row| row.map(&mut f)))
    }

    /// A column: an axis of the frame.
    pub const fn column(self, k: usize) -> Vector<E> {
        Vector([self.0[0][k], self.0[1][k], self.0[2][k]])
    }

    /// The rotation with these columns.
    pub fn from_columns(columns: [Vector<E>; 3]) -> Self {
        Self(array::from_fn(|row| columns.map(|column| column.0[row])))
    }

    /// Rᵗ = R⁻¹.
    #[must_use]
    pub fn transposed(self) -> Self {
        Self::from_columns(self.0.map(Vector))
    }
}

impl<'g> Rotation<Term<'g>> {
    /// The identity.
    pub fn identity(graph: &'g Graph) -> Self {
        Self::about_z((graph.constant(0.0), graph.constant(1.0)))
    }

    /// A rotation about z by an angle with this sine and cosine.
    #[must_use]
    pub fn about_z((sine, cosine): (Term<'g>, Term<'g>)) -> Self {
        let graph = sine.graph();
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        Self([
            [cosine, -sine, zero],
            [sine, cosine, zero],
            [zero, zero, one],
        ])
    }

    /// A rotation whose third column is a direction. For a coordinate axis, the first two columns are the next two
    /// axes in turn.
    #[must_use]
    pub fn with_z(direction: Vector<Term<'g>>) -> Self {
        let graph = direction.x().graph();
        let axis = |k: usize| {
            let mut entries = [0.0; 3];
            entries[k] = 1.0;
            Vector::constant(graph, entries)
        };
        let size = |k: usize| direction.0[k].value().map_or(0.0, Double::to_f64);
        for k in 0..3 {
            let (next, last) = (axis((k + 1) % 3), axis((k + 2) % 3));
            if direction.0[(k + 1) % 3].is_zero() && direction.0[(k + 2) % 3].is_zero() {
                let last = if size(k) > 0.0 { last } else { -last };
                return Self::from_columns([next, last, direction]);
            }
        }
        let smallest = (0..3)
            .min_by(|&a, &b| size(a).abs().total_cmp(&size(b).abs()))
            .unwrap_or(0);
        let x = axis(smallest).cross(direction).normalized();
        let x = x.expect("an axis is not along its smallest entry");
        Self::from_columns([x, direction.cross(x), direction])
    }

    /// A rotation whose third column is a direction (a, b, c). The first is the orthogonal part of (c², a², b²),
    /// normalized: for a coordinate axis the next one in turn. It rotates no further than the direction does, except
    /// near ±(1, 1, 1): see [`across`](crate::matrix::across).
    #[must_use]
    pub fn across(direction: Vector<Term<'g>>) -> Self {
        let graph = direction.x().graph();
        let [a, b, c] = direction.0;
        let entries = direction
            .0
            .map(|entry| entry.value().map_or(0.0, Double::to_f64));
        let guide = if is_diagonal(entries) {
            Vector::constant(graph, [1.0, 0.0, 0.0])
        } else {
            Vector([c * c, a * a, b * b])
        };
        let y = direction.cross(guide).normalized();
        let y = y.expect("the guide is not along the direction");
        Self::from_columns([y.cross(direction), y, direction])
    }

    /// The rotation by a quaternion x, y, z, w of any length; `None` if it is zero, or depends on an input.
    #[must_use]
    pub fn of_quaternion(entries: [Term<'g>; 4]) -> Option<Self> {
        let mut size = 0.0_f64;
        for entry in entries {
            size = size.max(entry.value()?.to_f64().abs());
        }
        let graph = entries[0].graph();
        let scale = graph.constant(towards_one(size));
        let [x, y, z, w] = entries.map(|entry| entry * scale);
        let square = x * x + y * y + z * z + w * w;
        square.value().filter(|square| square.is_sharp())?;
        let (one, two) = (graph.constant(1.0), graph.constant(2.0));
        let twice = |product: Term<'g>| two * product / square;
        Some(Self([
            [
                one - twice(y * y + z * z),
                twice(x * y - z * w),
                twice(x * z + y * w),
            ],
            [
                twice(x * y + z * w),
                one - twice(x * x + z * z),
                twice(y * z - x * w),
            ],
            [
                twice(x * z - y * w),
                twice(y * z + x * w),
                one - twice(x * x + y * y),
            ],
        ]))
    }

    /// A rotation about x by an angle with this sine and cosine.
    #[must_use]
    pub fn about_x((sine, cosine): (Term<'g>, Term<'g>)) -> Self {
        let graph = sine.graph();
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        Self([
            [one, zero, zero],
            [zero, cosine, -sine],
            [zero, sine, cosine],
        ])
    }

    /// A rotation about y by an angle with this sine and cosine.
    #[must_use]
    pub fn about_y((sine, cosine): (Term<'g>, Term<'g>)) -> Self {
        let graph = sine.graph();
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        Self([
            [cosine, zero, sine],
            [zero, one, zero],
            [-sine, zero, cosine],
        ])
    }
}

impl<'g> Mul<Vector<Term<'g>>> for Rotation<Term<'g>> {
    type Output = Vector<Term<'g>>;

    fn mul(self, vector: Vector<Term<'g>>) -> Vector<Term<'g>> {
        Vector(self.0.map(|row| Vector(row).dot(vector)))
    }
}

impl Mul for Rotation<Term<'_>> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::from_columns(array::from_fn(|k| self * other.column(k)))
    }
}

/// The sum of any 3×3 matrices.
impl Add for Rotation<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(array::from_fn(|i| {
            array::from_fn(|j| self.0[i][j] + other.0[i][j])
        }))
    }
}

impl<E: Copy> Pose<E> {
    /// Applies a function to each entry.
    pub fn map<F: Copy>(self, mut f: impl FnMut(E) -> F) -> Pose<F> {
        Pose {
            rotation: self.rotation.map(&mut f),
            translation: self.translation.map(f),
        }
    }

    /// The upper three rows, one after the other.
    pub fn entries(self) -> [E; 12] {
        array::from_fn(|k| match (k / 4, k % 4) {
            (row, 3) => self.translation.0[row],
            (row, column) => self.rotation.0[row][column],
        })
    }
}

impl<'g> Pose<Term<'g>> {
    /// The identity.
    pub fn identity(graph: &'g Graph) -> Self {
        Self {
            rotation: Rotation::identity(graph),
            translation: Vector::zero(graph),
        }
    }

    /// The pose of a frame with parallel axes and another origin.
    #[must_use]
    pub fn translation(translation: Vector<Term<'g>>) -> Self {
        Self {
            rotation: Rotation::identity(translation.x().graph()),
            translation,
        }
    }

    /// The pose of a frame with the same origin and other axes.
    #[must_use]
    pub fn rotation(rotation: Rotation<Term<'g>>) -> Self {
        Self {
            rotation,
            translation: Vector::zero(rotation.0[0][0].graph()),
        }
    }

    /// M⁻¹ = (Rᵗ, −Rᵗt).
    #[must_use]
    pub fn inverse(self) -> Self {
        let rotation = self.rotation.transposed();
        Self {
            rotation,
            translation: -(rotation * self.translation),
        }
    }

    /// The coordinates in the other frame of a point of the frame.
    #[must_use]
    pub fn point(self, point: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.rotation * point + self.translation
    }
}

/// Mᵢₖ = Mᵢⱼ Mⱼₖ.
impl Mul for Pose<Term<'_>> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            rotation: self.rotation * other.rotation,
            translation: self.point(other.translation),
        }
    }
}

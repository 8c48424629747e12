//! Three numbers in the axes of one frame.

use std::array;
use std::ops::{Add, Mul, Neg, Sub};

use crate::expression::{Component, Graph, Quantity, Term};

/// A vector, or the coordinates of a point: x, y, z.
#[derive(Clone, Copy, Debug)]
pub struct Vector<E>(pub [E; 3]);

impl<E: Copy> Vector<E> {
    /// Applies a function to each entry.
    pub fn map<F>(self, f: impl FnMut(E) -> F) -> Vector<F> {
        Vector(self.0.map(f))
    }

    /// The first entry.
    pub const fn x(self) -> E {
        self.0[0]
    }

    /// The second entry.
    pub const fn y(self) -> E {
        self.0[1]
    }

    /// The third entry.
    pub const fn z(self) -> E {
        self.0[2]
    }
}

impl<'g> Vector<Term<'g>> {
    /// A constant vector.
    pub fn constant(graph: &'g Graph, entries: [f64; 3]) -> Self {
        Self(entries.map(|entry| graph.constant(entry)))
    }

    /// The zero vector.
    pub fn zero(graph: &'g Graph) -> Self {
        Self::constant(graph, [0.0; 3])
    }

    /// Scalar product.
    #[must_use]
    pub fn dot(self, other: Self) -> Term<'g> {
        let [x, y, z] = array::from_fn(|k| self.0[k] * other.0[k]);
        x + y + z
    }

    /// Vector product, v̲w.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        let [ax, ay, az] = self.0;
        let [bx, by, bz] = other.0;
        Self([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])
    }

    /// The vector of length 1 in its direction, scaled by a power of two before squares are computed. `None` if it
    /// depends on an input, is zero, or is a rounding error of larger numbers.
    #[must_use]
    pub fn normalized(self) -> Option<Self> {
        let mut size = 0.0_f64;
        for entry in self.0 {
            size = size.max(entry.value()?.to_f64().abs());
        }
        let scale = self.x().graph().constant(towards_one(size));
        let scaled = self * scale;
        let square = scaled.dot(scaled);
        square.value().filter(|square| square.is_sharp())?;
        let length = square.sqrt();
        Some(scaled.map(|entry| entry / length))
    }

    /// True if every entry is a constant that is zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.0.iter().all(|entry| entry.is_zero())
    }

    /// Labels it as a quantity.
    pub fn label(self, quantity: Quantity) {
        for (k, entry) in self.0.into_iter().enumerate() {
            entry.label(quantity.entry(Component::Along(k)));
        }
    }
}

/// A power of two that scales a number to about 1, within the range of exponents.
pub(super) fn towards_one(size: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    let exponent = (size.to_bits() & EXPONENT).clamp(1 << 52, 2045 << 52);
    f64::from_bits((2046 << 52) - exponent)
}

impl Add for Vector<Term<'_>> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(array::from_fn(|k| self.0[k] + other.0[k]))
    }
}

impl Sub for Vector<Term<'_>> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Neg for Vector<Term<'_>> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl<'g> Mul<Term<'g>> for Vector<Term<'g>> {
    type Output = Self;

    fn mul(self, factor: Term<'g>) -> Self {
        Self(self.0.map(|entry| entry * factor))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Double;

    #[test]
    fn a_unit_vector_normalized_again_is_known_as_well_as_before() {
        let graph = Graph::new();
        let described = Vector::constant(&graph, [0.6, 0.0, 0.8]);
        let mut direction = described.normalized().expect("a direction");
        let radius = |vector: Vector<Term<'_>>| vector.z().value().map_or(1.0, Double::radius);
        // The second result may be a different number of 106 bits.
        direction = direction.normalized().expect("a direction");
        let before = radius(direction);
        for _ in 0..100 {
            direction = direction.normalized().expect("a direction");
        }
        assert!(radius(direction) <= 1e3 * before, "{before:e}");
        assert!(before < 1e-30);
    }

    #[test]
    fn a_written_number_stays_exact_beside_an_equal_computed_one() {
        let graph = Graph::new();
        let written = graph.constant(1.0);
        let three = Vector::constant(&graph, [0.1, 0.2, 0.3]);
        let one = (three.x() + three.y()) / (three.x() + three.y());
        assert!(one.expr() == written.expr());
        assert!(written.value().is_some_and(|value| value.radius() == 0.0));
    }
}

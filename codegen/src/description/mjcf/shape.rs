//! Volumes and moments of inertia of solid and hollow shapes.
//!
//! Sizes are MuJoCo's: radii and half lengths \[m\]. Hollow capsules and cylinders include their ends. A hollow
//! ellipsoid is the layer between it and one that is 1 µm larger, and its area is Thomsen's approximation. Results are
//! in 106 bits.

use crate::description::spatial::{DoubleVector, exactly};
use crate::expression::Double;

/// A shape, with the sizes that it has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// Radius.
    Sphere,
    /// Radius, and half the distance between the centres of its ends; along z.
    Capsule,
    /// Radius, and half the length; along z.
    Cylinder,
    /// Semi-axes.
    Ellipsoid,
    /// Half the side lengths.
    Box,
}

impl Shape {
    /// The number of its sizes.
    pub(super) const fn sizes(self) -> usize {
        match self {
            Self::Sphere => 1,
            Self::Capsule | Self::Cylinder => 2,
            Self::Ellipsoid | Self::Box => 3,
        }
    }

    /// Its sizes when it is fitted to a box with these half side lengths, as in MuJoCo; those that it lacks are 0.
    pub(super) fn fitted(self, [a, b, c]: DoubleVector) -> DoubleVector {
        let [zero, two, three] = [0.0, 2.0, 3.0].map(exactly);
        let across = (a + b) / two;
        match self {
            Self::Sphere => [(a + b + c) / three, zero, zero],
            Self::Capsule => {
                let along = c - across / two;
                [
                    across,
                    if along.to_f64() > 0.0 { along } else { zero },
                    zero,
                ]
            }
            Self::Cylinder => [across, c, zero],
            Self::Ellipsoid | Self::Box => [a, b, c],
        }
    }

    /// Its sizes when it is the smallest whose bounding box contains a box with these half side lengths, as in MuJoCo;
    /// those that it lacks are 0.
    pub(super) fn around(self, [a, b, c]: DoubleVector) -> DoubleVector {
        let zero = Double::ZERO;
        let larger = |a: Double, b: Double| if (a - b).sign().to_f64() > 0.0 { a } else { b };
        let across = larger(a, b);
        match self {
            Self::Sphere => [larger(across, c), zero, zero],
            Self::Capsule => [across, c - across, zero],
            Self::Cylinder => [across, c, zero],
            Self::Ellipsoid | Self::Box => [a, b, c],
        }
    }

    /// The volume \[m³\], or the area of a hollow one \[m²\].
    pub(super) fn measure(self, [a, b, c]: DoubleVector, is_hollow: bool) -> Double {
        let [two, three, four, eight] = [2.0, 3.0, 4.0, 8.0].map(exactly);
        match (self, is_hollow) {
            (Self::Sphere, false) => four * Double::PI * a * a * a / three,
            (Self::Sphere, true) => four * Double::PI * a * a,
            (Self::Capsule, false) => Double::PI * (two * a * a * b + four * a * a * a / three),
            (Self::Capsule, true) => four * Double::PI * (a * a + a * b),
            (Self::Cylinder, false) => two * Double::PI * a * a * b,
            (Self::Cylinder, true) => Double::PI * (two * a * a + four * a * b),
            (Self::Ellipsoid, false) => four * Double::PI * a * b * c / three,
            (Self::Ellipsoid, true) => {
                let p = exactly(1.6075);
                let sum = power(a * b, p) + power(b * c, p) + power(c * a, p);
                four * Double::PI * power(sum / three, exactly(1.0) / p)
            }
            (Self::Box, false) => eight * a * b * c,
            (Self::Box, true) => eight * (a * b + b * c + c * a),
        }
    }

    /// The principal moments of inertia \[kg m²\] of a mass \[kg\] about the centre of mass.
    pub(super) fn moments(
        self,
        mass: Double,
        sizes: DoubleVector,
        is_hollow: bool,
    ) -> DoubleVector {
        let [a, b, c] = sizes;
        let [aa, bb, cc] = sizes.map(|size| size * size);
        let part = |numerator: f64, denominator: f64| exactly(numerator) / exactly(denominator);
        match (self, is_hollow) {
            (Self::Sphere, false) => [part(2.0, 5.0) * mass * aa; 3],
            (Self::Sphere, true) => [part(2.0, 3.0) * mass * aa; 3],
            (Self::Capsule, _) => capsule(mass, a, b, is_hollow),
            (Self::Cylinder, false) => {
                let across = mass * (aa / exactly(4.0) + bb / exactly(3.0));
                [across, across, mass * aa / exactly(2.0)]
            }
            (Self::Cylinder, true) => hollow_cylinder(mass, a, b),
            (Self::Ellipsoid, false) => quadratic(mass / exactly(5.0), [aa, bb, cc]),
            (Self::Ellipsoid, true) => {
                let larger = sizes.map(|size| size + exactly(1e-6));
                let volume = |[a, b, c]: DoubleVector| a * b * c;
                let density = mass / (volume(larger) - volume(sizes)) / exactly(5.0);
                let squares = larger.map(|size| size * size);
                let outer = quadratic(density * volume(larger), squares);
                let inner = quadratic(density * volume(sizes), [aa, bb, cc]);
                std::array::from_fn(|k| outer[k] - inner[k])
            }
            (Self::Box, false) => quadratic(mass / exactly(3.0), [aa, bb, cc]),
            (Self::Box, true) => {
                // Pairs of sides across x, y and z, by their areas.
                let areas = [b * c, c * a, a * b];
                let whole = areas[0] + areas[1] + areas[2];
                let mut squares = [Double::ZERO; 3];
                for (across, area) in areas.into_iter().enumerate() {
                    let mass = mass * area / whole;
                    for (k, square) in [aa, bb, cc].into_iter().enumerate() {
                        // ∫ x² dm: at the distance of the side, or spread over it.
                        let spread = if k == across { 1.0 } else { 3.0 };
                        squares[k] = squares[k] + mass * square / exactly(spread);
                    }
                }
                quadratic(exactly(1.0), squares)
            }
        }
    }
}

/// Moments about x, y and z from the second moments ∫x²dm, ∫y²dm and ∫z²dm, each times `factor`.
fn quadratic(factor: Double, [x, y, z]: DoubleVector) -> DoubleVector {
    [factor * (y + z), factor * (x + z), factor * (x + y)]
}

/// Moments of a cylinder between two half balls, solid or hollow.
fn capsule(mass: Double, radius: Double, half: Double, is_hollow: bool) -> DoubleVector {
    let rr = radius * radius;
    let [two, three, five, eight] = [2.0, 3.0, 5.0, 8.0].map(exactly);
    // Volumes or areas, divided by a common factor.
    let (ball, tube) = if is_hollow {
        (radius, half)
    } else {
        (two * radius / three, half)
    };
    let ball = mass * ball / (ball + tube);
    let tube = mass - ball;
    let (of_ball, center) = if is_hollow {
        (two / three, radius / two)
    } else {
        (two / five, three * radius / eight)
    };
    let along_tube = if is_hollow {
        tube * rr
    } else {
        tube * rr / two
    };
    let across_tube = along_tube / two + tube * half * half / three;
    let along_ball = of_ball * ball * rr;
    // Each half is moved along z by half the length of the tube.
    let across_ball = along_ball + ball * (half * half + two * half * center);
    let across = across_tube + across_ball;
    [across, across, along_tube + along_ball]
}

/// Moments of a tube with a disc at each end.
fn hollow_cylinder(mass: Double, radius: Double, half: Double) -> DoubleVector {
    let rr = radius * radius;
    let [two, three, four] = [2.0, 3.0, 4.0].map(exactly);
    let discs = mass * radius / (radius + two * half);
    let tube = mass - discs;
    let across = tube * (rr / two + half * half / three) + discs * (rr / four + half * half);
    [across, across, tube * rr + discs * rr / two]
}

/// xᵖ for x > 0.
fn power(x: Double, p: Double) -> Double {
    exponential(p * logarithm(x))
}

/// eˣ, by its series after halvings of x.
fn exponential(x: Double) -> Double {
    const HALVINGS: i32 = 10;
    /// Arguments are below 1 before the halvings: 2⁻¹⁰ⁿ/n! is below 2⁻¹¹⁰ here.
    const TERMS: i32 = 12;
    let halvings = HALVINGS + (x.exponent() + 1).max(0);
    let small = x.scaled(-halvings);
    let (mut sum, mut term) = (exactly(1.0), exactly(1.0));
    for n in 1..TERMS {
        term = term * small / exactly(f64::from(n));
        sum = sum + term;
    }
    for _ in 0..halvings {
        sum = sum * sum;
    }
    sum
}

/// ln x for x > 0, by iterations from n ln 2 with x ≈ 2ⁿ.
fn logarithm(x: Double) -> Double {
    const STEPS: usize = 9;
    // The error of the start is below 1/2.
    const LN_2: f64 = std::f64::consts::LN_2;
    let mut found = exactly(f64::from(x.exponent()) * LN_2);
    for _ in 0..STEPS {
        let at = exponential(found);
        found = found + exactly(2.0) * (x - at) / (x + at);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [f64; 3] = [0.3, 0.5, 0.7];

    fn values(entries: DoubleVector) -> [f64; 3] {
        entries.map(Double::to_f64)
    }

    fn near(found: f64, wanted: f64) {
        assert!(
            (found - wanted).abs() < 1e-14 * wanted.abs(),
            "{found} and {wanted}"
        );
    }

    #[test]
    fn powers_are_those_of_numbers() {
        for (x, p) in [
            (2.0, 0.5),
            (0.15, 1.6075),
            (9e-6, 1.6075),
            (1.0, 3.0),
            (123.5, 0.62),
        ] {
            near(power(exactly(x), exactly(p)).to_f64(), f64::powf(x, p));
        }
        let third = exactly(1.0) / exactly(3.0);
        let cube = power(exactly(5.0), third);
        let off = cube * cube * cube - exactly(5.0);
        assert!(off.to_f64().abs() < 1e-26, "{off:?}");
    }

    /// The volume of a shell is the derivative of the solid's by the size.
    #[test]
    fn hollow_shapes_are_derivatives_of_solid_ones() {
        let step = exactly(1.0).scaled(-53);
        for shape in [Shape::Sphere, Shape::Capsule, Shape::Cylinder, Shape::Box] {
            let sizes = SIZES.map(exactly);
            // The half length of a capsule ends at the centres of its half balls, so it does not grow.
            let grown = std::array::from_fn(|k| match (shape, k) {
                (Shape::Capsule, 1) => sizes[1],
                _ => sizes[k] + step,
            });
            let gain = shape.measure(grown, false) - shape.measure(sizes, false);
            near((gain / step).to_f64(), shape.measure(sizes, true).to_f64());
            let of = |sizes: DoubleVector| shape.moments(shape.measure(sizes, false), sizes, false);
            let (more, less) = (of(grown), of(sizes));
            let hollow = values(shape.moments(shape.measure(sizes, true), sizes, true));
            for k in 0..3 {
                near(((more[k] - less[k]) / step).to_f64(), hollow[k]);
            }
        }
    }

    #[test]
    fn a_ball_is_an_ellipsoid_and_a_capsule_without_length() {
        let mass = exactly(1.5);
        let r = exactly(0.3);
        for is_hollow in [false, true] {
            let ball = values(Shape::Sphere.moments(mass, [r; 3], is_hollow));
            let capsule = Shape::Capsule.moments(mass, [r, Double::ZERO, r], is_hollow);
            let ellipsoid = values(Shape::Ellipsoid.moments(mass, [r; 3], is_hollow));
            for k in 0..3 {
                near(values(capsule)[k], ball[k]);
                let thickness = if is_hollow { 1e-5 } else { 1e-14 };
                assert!((ellipsoid[k] - ball[k]).abs() < thickness * ball[k]);
            }
            let area = Shape::Sphere.measure([r; 3], is_hollow).to_f64();
            near(Shape::Ellipsoid.measure([r; 3], is_hollow).to_f64(), area);
        }
    }
}

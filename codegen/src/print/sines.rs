//! Sine and cosine of an angle, as statements that every language prints.
//!
//! In: a scalar type. Out: statements without branches: Cody-Waite reduction to |r| ≤ π/4 and minimax polynomials, the
//! same as in `homogen::trigonometry`, which derives the constants. The last step selects by bits and is printed by
//! each language: in odd quadrants sine and cosine are exchanged; sines of quadrants 2 and 3 and cosines of 1 and 2
//! change their sign.

use crate::real::Real;
use crate::schedule::{Operation, Statement, Value};

/// Name of the argument \[rad\].
pub(super) const ANGLE: &str = "angle";

/// Values that the last step reads: sine and cosine of the reduced angle, and a number whose two lowest bits are the
/// quadrant.
pub(super) const SINE: &str = "sine";
pub(super) const COSINE: &str = "cosine";
pub(super) const SHIFTED: &str = "shifted";

/// Accuracy and range of the sines.
pub(super) struct SineRange {
    /// Maximum magnitude \[rad\] with the error below; beyond, it grows with the angle.
    pub limit: &'static str,
    /// The same in turns.
    pub turns: &'static str,
    /// Error within that range \[ulp\].
    pub error: &'static str,
    /// Error beyond it, relative to |angle|.
    pub growth: &'static str,
    /// Magnitude from which results are meaningless \[rad\].
    pub end: &'static str,
}

/// Range for a scalar type.
pub(super) const fn range(real: Real) -> SineRange {
    match real {
        Real::F32 => SineRange {
            limit: "3200",
            turns: "509",
            error: "0.92",
            growth: "6e-8",
            end: "6e6",
        },
        Real::F64 | Real::Generic => SineRange {
            limit: "2e5",
            turns: "31,830",
            error: "0.9",
            growth: "1.2e-16",
            end: "1e15",
        },
    }
}

/// Statements from the angle to the values that the last step reads.
pub(super) fn statements(real: Real) -> Vec<Statement> {
    let mut steps = SineStatements::default();
    match real {
        Real::F32 => steps.single(),
        Real::F64 | Real::Generic => steps.double(),
    }
    steps.0
}

#[derive(Default)]
struct SineStatements(Vec<Statement>);

impl SineStatements {
    fn bind(&mut self, name: &str, operation: Operation<Value>) -> Value {
        self.0
            .push(Statement::Operation(name.to_owned(), operation));
        Value::Name(name.to_owned())
    }

    fn add(&mut self, name: &str, a: &Value, b: &Value) -> Value {
        self.bind(name, Operation::Add(a.clone(), b.clone()))
    }

    fn sub(&mut self, name: &str, a: &Value, b: &Value) -> Value {
        self.bind(name, Operation::Sub(a.clone(), b.clone()))
    }

    fn mul(&mut self, name: &str, a: &Value, b: &Value) -> Value {
        self.bind(name, Operation::Mul(a.clone(), b.clone()))
    }

    /// a b + c.
    fn mul_add(&mut self, name: &str, a: &Value, b: &Value, c: &Value) -> Value {
        self.bind(name, Operation::MulAdd(a.clone(), b.clone(), c.clone()))
    }

    /// a b − c.
    fn mul_sub(&mut self, name: &str, a: &Value, b: &Value, c: &Value) -> Value {
        self.bind(name, Operation::MulSub(a.clone(), b.clone(), c.clone()))
    }

    /// c − a b.
    fn neg_mul_add(&mut self, name: &str, a: &Value, b: &Value, c: &Value) -> Value {
        self.bind(name, Operation::NegMulAdd(a.clone(), b.clone(), c.clone()))
    }

    fn double(&mut self) {
        let angle = Value::Name(ANGLE.to_owned());
        // 1.5·2⁵²: the sum has no bits for a fraction, and its low bits hold the rounded integer.
        let round = number(6_755_399_441_055_744.0);
        let shifted = self.mul_add(
            SHIFTED,
            &angle,
            &number(core::f64::consts::FRAC_2_PI),
            &round,
        );
        let quadrants = self.sub("quadrants", &shifted, &round);
        // π/2 in parts of 36 bits: products with the first two are exact.
        let [high, middle, low] = [
            1.570_796_326_792_333_3,
            2.563_344_151_583_955_8e-12,
            1.056_299_906_698_742_8e-23,
        ]
        .map(number);
        let first = self.neg_mul_add("first", &quadrants, &high, &angle);
        let r = self.neg_mul_add("r", &quadrants, &middle, &first);
        let rounded = self.sub("rounded", &first, &r);
        let remainder = self.neg_mul_add("remainder", &quadrants, &middle, &rounded);
        let low = self.neg_mul_add("low", &quadrants, &low, &remainder);
        self.polynomials(
            (&r, &low),
            &[
                -0.166_666_666_666_666_3,
                0.008_333_333_333_321_84,
                -0.000_198_412_698_293_585_25,
                2.755_731_353_851_189_6e-6,
                -2.505_073_438_862_417_4e-8,
                1.589_543_323_477_850_6e-10,
            ],
            &[
                0.041_666_666_666_666_595,
                -0.001_388_888_888_887_330_7,
                2.480_158_728_896_523e-5,
                -2.755_731_420_307_937e-7,
                2.087_570_313_944_011e-9,
                -1.135_861_698_681_578_8e-11,
            ],
        );
    }

    fn single(&mut self) {
        let angle = Value::Name(ANGLE.to_owned());
        // 1.5·2²³.
        let round = number(12_582_912.0);
        let two_over_pi = single(core::f32::consts::FRAC_2_PI);
        let shifted = self.mul_add(SHIFTED, &angle, &two_over_pi, &round);
        let quadrants = self.sub("quadrants", &shifted, &round);
        // −quadrants, except that zero is +0: multiplied by the negative part it preserves an angle of −0.
        let opposite = self.sub("opposite", &round, &shifted);
        // π/2 in parts of 13 bits.
        let [high, middle, low] = [1.570_800_8, -4.454_516e-6, 6.077_100_6e-11].map(single);
        let first = self.neg_mul_add("first", &quadrants, &high, &angle);
        let r = self.mul_add("r", &opposite, &middle, &first);
        let rounded = self.sub("rounded", &first, &r);
        let remainder = self.mul_add("remainder", &opposite, &middle, &rounded);
        let low = self.neg_mul_add("low", &quadrants, &low, &remainder);
        self.polynomials(
            (&r, &low),
            &[-1.666_665_5e-1_f32, 8.332_187e-3, -1.951_789_6e-4].map(f64::from),
            &[4.166_664_6e-2_f32, -1.388_731e-3, 2.443_232_7e-5].map(f64::from),
        );
    }

    /// Sine and cosine of r + low, by the coefficients of r³, r⁵ … and of r⁴, r⁶ …
    fn polynomials(&mut self, (r, low): (&Value, &Value), sine: &[f64], cosine: &[f64]) {
        let [one, half] = [1.0, 0.5].map(number);
        let z = self.mul("z", r, r);
        let z_squared = self.mul("z_squared", &z, &z);
        let half = self.mul("half", &half, &z);
        // r − (−r³(s₃ + s₅r² + …) − (1 − r²/2) low): the subtraction preserves the sign of a zero r.
        let series = self.series("odd", sine, (&z, &z_squared));
        let cubic = self.mul("cubic", &z, r);
        let small = self.mul_sub("odd_low", &half, low, low);
        let small = self.neg_mul_add("odd_rest", &cubic, &series, &small);
        self.sub(SINE, r, &small);
        // (1 − r²/2) + (r⁴(c₄ + c₆r² + …) − r·low + the rounding error of the first part).
        let leading = self.sub("leading", &one, &half);
        let lost = self.sub("left", &one, &leading);
        let lost = self.sub("lost", &lost, &half);
        let series = self.series("even", cosine, (&z, &z_squared));
        let small = self.neg_mul_add("even_low", r, low, &lost);
        let small = self.mul_add("even_rest", &z_squared, &series, &small);
        self.add(COSINE, &leading, &small);
    }

    /// c₀ + c₁z + …, in independent pairs.
    fn series(
        &mut self,
        name: &str,
        coefficients: &[f64],
        (z, z_squared): (&Value, &Value),
    ) -> Value {
        let name = |part: &str| format!("{name}_{part}");
        let c: Vec<Value> = coefficients.iter().map(|&c| number(c)).collect();
        let near = self.mul_add(&name("near"), z, &c[1], &c[0]);
        let [_, _, rest @ ..] = &*c else {
            unreachable!("a series has more than two coefficients")
        };
        match rest {
            [last] => self.mul_add(&name("series"), z_squared, last, &near),
            [c_2, c_3, c_4, c_5] => {
                let middle = self.mul_add(&name("middle"), z, c_3, c_2);
                let far = self.mul_add(&name("far"), z, c_5, c_4);
                let outer = self.mul_add(&name("outer"), &far, z_squared, &middle);
                self.mul_add(&name("series"), &outer, z_squared, &near)
            }
            _ => unreachable!("three coefficients, or six"),
        }
    }
}

fn number(value: f64) -> Value {
    Value::Literal(value)
}

fn single(value: f32) -> Value {
    number(value.into())
}

#[cfg(test)]
pub(in crate::print) mod tests;

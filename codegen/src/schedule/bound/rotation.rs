//! Sines and cosines, and vectors that they rotate.
//!
//! In: angles, and sums of products. Out: pairs of values that are sine and cosine of one angle, given by the program
//! or computed as cos(q + φ) = c cos q − s sin q, and sums that are entries of a vector rotated by such a pair.

use super::reason::Reason;
use super::value::Value;
use crate::real::Real;
use crate::schedule::Operand;

/// Sine or cosine of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SineOrCosine {
    /// Index of the rotation: angles of the program first, then computed ones.
    pub angle: u32,
    /// True for the sine; for computed rotations the choice is arbitrary.
    pub sine: bool,
}

/// Entry c x + s y or c y − s x of a rotated vector (x, y).
#[derive(Clone, Copy, Debug)]
pub struct PlaneRotation {
    /// Index of the rotation.
    pub angle: u32,
    /// Factor of the cosine, and true if the product is subtracted.
    pub by_cosine: (Operand, bool),
    /// Factor of the sine, and true if the product is subtracted.
    pub by_sine: (Operand, bool),
}

impl PlaneRotation {
    /// The sum of two products as an entry of a rotated vector.
    pub fn of(
        place: impl Fn(Operand) -> Option<SineOrCosine>,
        first: [Operand; 2],
        first_minus: bool,
        second: [Operand; 2],
        second_minus: bool,
    ) -> Option<Self> {
        let orders = |pair: [Operand; 2]| [(pair[0], pair[1]), (pair[1], pair[0])];
        orders(first).into_iter().find_map(|(of_first, x)| {
            let one = place(of_first)?;
            orders(second).into_iter().find_map(|(of_second, y)| {
                let other = place(of_second)?;
                let (x, y) = ((x, first_minus), (y, second_minus));
                let (by_cosine, by_sine) = if one.sine { (y, x) } else { (x, y) };
                (one.angle == other.angle && one.sine != other.sine).then_some(Self {
                    angle: one.angle,
                    by_cosine,
                    by_sine,
                })
            })
        })
    }

    /// True if the other is the second entry of the same rotated vector.
    pub fn completes(&self, other: &Self) -> bool {
        let ((x, x_minus), (y, y_minus)) = (self.by_cosine, self.by_sine);
        let ((z, z_minus), (w, w_minus)) = (other.by_cosine, other.by_sine);
        let opposed = (x_minus == z_minus) != (y_minus == w_minus);
        self.angle == other.angle && (x, y) == (w, z) && opposed
    }

    /// Factors of cosine and sine if both are literals.
    fn numbers(&self) -> Option<[f64; 2]> {
        let number = |(operand, minus)| match operand {
            Operand::Literal(number) => Some(if minus { -number } else { number }),
            _ => None,
        };
        Some([number(self.by_cosine)?, number(self.by_sine)?])
    }
}

/// Rotations of a program up to the current step.
#[derive(Default)]
pub struct PlaneRotations {
    /// Sine and cosine of each angle of the program.
    given: Vec<([Value; 2], Option<Reason>)>,
    found: Vec<Shifted>,
}

/// Rotation by the sum of an angle of the program and a constant.
struct Shifted {
    angle: u32,
    /// Factors of cosine and sine of the angle in the cosine of this rotation.
    cosine: [f64; 2],
    /// Steps that are its sine, if known, and its cosine.
    steps: [Option<u32>; 2],
}

impl PlaneRotations {
    /// Adds an angle of the program.
    pub fn push(&mut self, angle: Value, reason: Option<Reason>, scalar: Real) {
        let both = match reason {
            None => [angle.sine(scalar), angle.cosine(scalar)],
            Some(_) => [Value::UNKNOWN; 2],
        };
        self.given.push((both, reason));
    }

    /// Sine of an angle of the program.
    pub fn sine(&self, angle: u32) -> Value {
        self.given[angle as usize].0[0]
    }

    /// Cosine of an angle of the program.
    pub fn cosine(&self, angle: u32) -> Value {
        self.given[angle as usize].0[1]
    }

    /// Reason why they have no bound.
    pub fn reason(&self, angle: u32) -> Option<Reason> {
        self.given[angle as usize].1
    }

    /// Operands that are sine and cosine of a rotation, and their length as a vector.
    pub fn pair(&self, angle: u32) -> ([Operand; 2], f64) {
        let given = u32::try_from(self.given.len()).expect("as many as joints");
        let Some(found) = angle.checked_sub(given) else {
            return ([Operand::Sin(angle), Operand::Cos(angle)], 1.0);
        };
        let found = &self.found[found as usize];
        let step = |k: Option<u32>| k.map_or(Operand::Literal(f64::INFINITY), Operand::Step);
        let [c, s] = found.cosine;
        (found.steps.map(step), (c * c + s * s).sqrt())
    }

    /// The sine or cosine that a step with two constant factors is: of the sum of the angle and a constant, if the
    /// factors are a cosine and a sine.
    pub fn place(&mut self, step: u32, rotation: &PlaneRotation) -> Option<SineOrCosine> {
        /// Larger than the deviation of a sum of squares from 1 by rounded literals.
        const NEARLY: f64 = 1e-9;
        let [c, s] = rotation.numbers()?;
        if (c * c + s * s - 1.0).abs() > NEARLY {
            return None;
        }
        let given = self.given.len();
        let angle = |at: usize| u32::try_from(given + at).expect("fewer than steps");
        // Orthogonal to a rotation whose sine is not known yet.
        let lacking = self.found.iter().position(|other| {
            let [p, r] = other.cosine;
            let across = [-r, p] == [c, s] || [r, -p] == [c, s];
            other.angle == rotation.angle && other.steps[0].is_none() && across
        });
        if let Some(at) = lacking {
            self.found[at].steps[0] = Some(step);
            let angle = angle(at);
            return Some(SineOrCosine { angle, sine: true });
        }
        self.found.push(Shifted {
            angle: rotation.angle,
            cosine: [c, s],
            steps: [None, Some(step)],
        });
        let angle = angle(self.found.len() - 1);
        Some(SineOrCosine { angle, sine: false })
    }
}

//! How far results are from what they should be.
//!
//! In: numbers of a type, and the same to 256 bits. Out: errors in units of rounding, component by
//! component or of a whole vector, backward errors of forward dynamics, and what a thousand of them
//! look like. It decides nothing: limits belong to the tests.
//!
//! An infinite error stands for a result that is infinite or NaN.

use std::marker::PhantomData;

use homogen_codegen::schedule::{Program, run};
use homogen_magnitude::{Magnitude, Measure};

use crate::arguments::{Arguments, at};
use crate::big::Big;
use crate::tested::Tested;

/// The results of a program in a type of number, as `f64`, which holds them exactly.
#[must_use]
pub fn results<T: Tested>(program: &Program, arguments: &Arguments) -> Vec<f64> {
    let found = run(program, |input| T::literal(at(arguments, input)));
    found.into_iter().map(T::to_f64).collect()
}

/// As a type of number sees it: what underflows is off by the type's floor.
#[derive(Clone, Copy, Debug)]
struct By<T>(PhantomData<T>);

impl<T: Tested> Measure for By<T> {
    type Value = f64;
    const FLOOR: f64 = T::FLOOR;

    fn nearest(value: f64) -> f64 {
        value
    }
}

/// S of each result: the same program on absolute values.
#[must_use]
pub fn sizes<T: Tested>(program: &Program, arguments: &Arguments) -> Vec<f64> {
    let found = run(program, |input| {
        Magnitude::<By<T>>::given(at(arguments, input))
    });
    found.into_iter().map(Magnitude::size).collect()
}

/// |error| / (u S) of each result.
///
/// # Panics
/// Where the lists are not equally long.
#[must_use]
pub fn scaled<T: Tested>(found: &[f64], exact: &[Big], sizes: &[f64]) -> Vec<f64> {
    assert_eq!((found.len(), sizes.len()), (exact.len(), exact.len()));
    let pairs = found.iter().zip(exact).zip(sizes);
    pairs
        .map(|((&found, exact), &size)| units::<T>(found, exact, size))
        .collect()
}

/// The largest error beside the largest result, in units of u; of a vector that is zero the error
/// beside the smallest normal number.
///
/// # Panics
/// Where the lists are not equally long.
#[must_use]
pub fn relative<T: Tested>(found: &[f64], exact: &[Big]) -> f64 {
    assert_eq!(found.len(), exact.len());
    let size = largest(exact.iter().map(|exact| exact.abs().to_f64())).max(T::FLOOR);
    let pairs = found.iter().zip(exact);
    largest(pairs.map(|(&found, exact)| units::<T>(found, exact, size)))
}

/// |error| in units of the last place of the exact value.
#[must_use]
pub fn ulps<T: Tested>(found: f64, exact: &Big) -> f64 {
    let size = exact.abs().to_f64().max(T::FLOOR);
    // The largest power of two that is no larger.
    let power = f64::from_bits(size.to_bits() & f64::INFINITY.to_bits());
    units::<T>(found, exact, 2.0 * power)
}

/// The backward error of forward dynamics, joint by joint: by how much the torques that the found
/// accelerations need miss those that were given, beside u (|τ| + S of the needed torques).
///
/// `needed` and `sizes` are results and S of the inverse dynamics at the found accelerations.
///
/// # Panics
/// Where the lists are not equally long.
#[must_use]
pub fn backward<T: Tested>(given: &[f64], needed: &[Big], sizes: &[f64]) -> Vec<f64> {
    let sizes = sizes.iter().zip(given);
    let sizes: Vec<f64> = sizes.map(|(size, tau)| size + tau.abs()).collect();
    scaled::<T>(given, needed, &sizes)
}

/// The larger of all, or infinity where one is NaN.
#[must_use]
pub fn largest(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, |most, error| {
        if error.is_nan() {
            f64::INFINITY
        } else {
            most.max(error)
        }
    })
}

/// |error| / (u size), at 256 bits: u times the smallest normal number is none of `f64`.
fn units<T: Tested>(found: f64, exact: &Big, size: f64) -> f64 {
    if found.is_finite() {
        let error = (Big::new(found) - exact).abs();
        (error / (Big::new(T::ROUNDOFF) * Big::new(size))).to_f64()
    } else {
        f64::INFINITY
    }
}

/// Errors at many arguments.
#[derive(Clone, Debug, Default)]
pub struct Distribution {
    errors: Vec<f64>,
    worst: Option<(f64, Arguments)>,
}

impl Distribution {
    /// Takes in the error at some arguments.
    pub fn note(&mut self, error: f64, arguments: &Arguments) {
        self.errors.push(error);
        if self.worst.as_ref().is_none_or(|(most, _)| error > *most) {
            self.worst = Some((error, arguments.clone()));
        }
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.errors.len()
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The error that a share of all does not exceed: 0.5 for the median, 0.99 for the 99th percentile.
    ///
    /// # Panics
    /// Where there are none, or the share is not between 0 and 1.
    #[must_use]
    pub fn quantile(&self, share: f64) -> f64 {
        assert!((0.0..=1.0).contains(&share), "{share} is no share");
        let mut sorted = self.errors.clone();
        sorted.sort_by(f64::total_cmp);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            clippy::cast_sign_loss,
            reason = "a place in a list of thousands"
        )]
        let place = (share * sorted.len() as f64).ceil() as usize;
        sorted[place.max(1) - 1]
    }

    /// The largest error, and where it was found.
    ///
    /// # Panics
    /// Where there are none.
    #[must_use]
    pub fn worst(&self) -> (f64, &Arguments) {
        let (error, arguments) = self.worst.as_ref().expect("something was measured");
        (*error, arguments)
    }
}

#[cfg(test)]
mod tests {
    use super::{Distribution, backward, largest, relative, scaled, ulps};
    use homogen_codegen::space::Variable;

    use crate::arguments::Arguments;
    use crate::big::Big;
    use crate::tested::{F32, F64, Tested};

    const U: f64 = F64::ROUNDOFF;

    #[test]
    fn errors_are_told_in_units_of_what_they_are_measured_by() {
        let exact = [3.0, -1.0].map(Big::new);
        let found = [3.0 + 8.0 * U, -1.0];
        assert_eq!(scaled::<F64>(&found, &exact, &[4.0, 1.0]), [2.0, 0.0]);
        assert_eq!(relative::<F64>(&found, &exact), 8.0 / 3.0);
        assert_eq!(ulps::<F64>(found[0], &exact[0]), 2.0);
        assert_eq!(ulps::<F32>(1.0 + f64::from(f32::EPSILON), &Big::one()), 1.0);
        let (given, needed) = ([3.0, -1.0], found.map(Big::new));
        assert_eq!(backward::<F64>(&given, &needed, &[1.0, 0.0]), [2.0, 0.0]);
    }

    #[test]
    fn what_is_not_finite_is_infinitely_wrong() {
        for found in [f64::NAN, f64::INFINITY] {
            assert_eq!(
                scaled::<F64>(&[found], &[Big::one()], &[1.0]),
                [f64::INFINITY]
            );
            assert_eq!(relative::<F64>(&[found], &[Big::one()]), f64::INFINITY);
        }
        assert_eq!(largest([f64::NAN, 1.0]), f64::INFINITY);
    }

    #[test]
    fn what_underflows_is_measured_too() {
        let smallest = f64::from_bits(1);
        let errors = scaled::<F64>(
            &[0.0, smallest],
            &[smallest, 0.0].map(Big::new),
            &[F64::FLOOR; 2],
        );
        assert_eq!(errors, [2.0, 2.0]);
        assert_eq!(relative::<F64>(&[0.0], &[Big::zero()]), 0.0);
    }

    #[test]
    fn a_distribution_knows_its_middle_and_its_worst() {
        let mut errors = Distribution::default();
        for k in [3.0, 1.0, 4.0, 2.0] {
            let mut arguments = Arguments::default();
            arguments[Variable::Q].push(k);
            errors.note(k, &arguments);
        }
        assert_eq!((errors.quantile(0.5), errors.quantile(0.99)), (2.0, 4.0));
        let (error, arguments) = errors.worst();
        assert_eq!((error, &arguments[Variable::Q][..]), (4.0, &[4.0][..]));
    }
}

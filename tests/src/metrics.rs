//! Measures of error.
//!
//! In: results in a type, and their true values in 256 bits. Out: errors in units of rounding, of single entries or of
//! a whole vector; backward errors of forward dynamics; distributions of many errors. Limits are up to the tests.
//!
//! The error of an infinite or NaN result is infinite.

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

/// Measures in a scalar type: underflow has an error of the type's floor.
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
/// If the lists differ in length.
#[must_use]
pub fn scaled<T: Tested>(found: &[f64], exact: &[Big], sizes: &[f64]) -> Vec<f64> {
    assert_eq!((found.len(), sizes.len()), (exact.len(), exact.len()));
    let pairs = found.iter().zip(exact).zip(sizes);
    pairs
        .map(|((&found, exact), &size)| units::<T>(found, exact, size))
        .collect()
}

/// The largest error relative to the largest result, in units of u; relative to the smallest normal number if the true
/// vector is zero.
///
/// # Panics
/// If the lists differ in length.
#[must_use]
pub fn relative<T: Tested>(found: &[f64], exact: &[Big]) -> f64 {
    assert_eq!(found.len(), exact.len());
    let size = largest(exact.iter().map(|exact| exact.abs().to_f64())).max(T::FLOOR);
    let pairs = found.iter().zip(exact);
    largest(pairs.map(|(&found, exact)| units::<T>(found, exact, size)))
}

/// |error| in ulps of the exact value.
#[must_use]
pub fn ulps<T: Tested>(found: f64, exact: &Big) -> f64 {
    let size = exact.abs().to_f64().max(T::FLOOR);
    // The largest power of two up to the size.
    let power = f64::from_bits(size.to_bits() & f64::INFINITY.to_bits());
    units::<T>(found, exact, 2.0 * power)
}

/// The backward error of forward dynamics for each joint: the difference between the given torques and those that the
/// computed accelerations need, relative to u (|τ| + S of the needed torques).
///
/// `needed` and `sizes` are results and S of the inverse dynamics at the computed accelerations.
///
/// # Panics
/// If the lists differ in length.
#[must_use]
pub fn backward<T: Tested>(given: &[f64], needed: &[Big], sizes: &[f64]) -> Vec<f64> {
    let sizes = sizes.iter().zip(given);
    let sizes: Vec<f64> = sizes.map(|(size, tau)| size + tau.abs()).collect();
    scaled::<T>(given, needed, &sizes)
}

/// The largest error; infinite if one is NaN.
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

/// |error| / (u size), in 256 bits, since u times the smallest normal number underflows in `f64`.
fn units<T: Tested>(found: f64, exact: &Big, size: f64) -> f64 {
    if found.is_finite() {
        let error = (Big::new(found) - exact).abs();
        (error / (Big::new(T::ROUNDOFF) * Big::new(size))).to_f64()
    } else {
        f64::INFINITY
    }
}

/// Errors at many states.
#[derive(Clone, Debug, Default)]
pub struct Distribution {
    errors: Vec<f64>,
    worst: Option<(f64, Arguments)>,
}

impl Distribution {
    /// Adds the error at a state.
    pub fn note(&mut self, error: f64, arguments: &Arguments) {
        self.errors.push(error);
        if self.worst.as_ref().is_none_or(|(most, _)| error > *most) {
            self.worst = Some((error, arguments.clone()));
        }
    }

    /// The number of errors.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.errors.len()
    }

    /// True if there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The error that a share of all does not exceed: 0.5 for the median, 0.99 for the 99th percentile.
    ///
    /// # Panics
    /// If there are none, or the share is not between 0 and 1.
    #[must_use]
    pub fn quantile(&self, share: f64) -> f64 {
        assert!((0.0..=1.0).contains(&share), "{share} is not in [0, 1]");
        let mut sorted = self.errors.clone();
        sorted.sort_by(f64::total_cmp);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_precision_loss,
            clippy::cast_sign_loss,
            reason = "an index in a list of thousands"
        )]
        let rank = (share * sorted.len() as f64).ceil() as usize;
        sorted[rank.max(1) - 1]
    }

    /// The largest error and its state.
    ///
    /// # Panics
    /// If there are none.
    #[must_use]
    pub fn worst(&self) -> (f64, &Arguments) {
        let (error, arguments) = self.worst.as_ref().expect("at least one error");
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
    fn each_measure_has_its_unit() {
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
    fn the_error_of_a_result_that_is_not_finite_is_infinite() {
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
    fn underflow_is_measured_in_units_of_the_floor() {
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
    fn a_distribution_has_quantiles_and_a_worst_state() {
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

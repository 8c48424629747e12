//! Measurement of a hard case and comparison with its limit.
//!
//! In: states, the worst inputs of earlier runs, and the errors of a state as a function. Out: a failed assertion with
//! the bits of the worst state, which can be added to those inputs.

use std::array::from_fn;

use homogen::{Real, Scalar};
use homogen_tests::big::Big;
use homogen_tests::rounding::{DOUBLE, SINGLE};
use homogen_tests::states::Random;
use homogen_tests::tested::{Flushed, Fused32, Fused64};

/// A type under test.
pub trait Number: Real {
    /// Its name.
    const NAME: &'static str;
    /// The unit roundoff u.
    const UNIT: f64;
    /// The largest loss by underflow.
    const UNDERFLOW: f64;
    /// The largest number.
    const LARGEST: f64;
    /// The smallest decimal exponent of a number of full precision, with room for a product with 10⁻⁸.
    const LEAST: f64;

    /// The exact value.
    fn big(self) -> Big {
        Big::new(self.to_f64())
    }

    /// The value rounded to the type.
    fn nearest(x: &Big) -> Self {
        Self::constant(x.to_f64())
    }
}

impl Number for f64 {
    const NAME: &'static str = "f64";
    const UNIT: f64 = DOUBLE;
    const UNDERFLOW: f64 = 5e-324;
    const LARGEST: f64 = f64::MAX;
    const LEAST: f64 = -300.0;
}

impl Number for f32 {
    const NAME: &'static str = "f32";
    const UNIT: f64 = SINGLE;
    const UNDERFLOW: f64 = 1.5e-45;
    const LARGEST: f64 = f32::MAX as f64;
    const LEAST: f64 = -30.0;
}

impl Number for Fused64 {
    const NAME: &'static str = "f64, fused";
    const UNIT: f64 = f64::UNIT;
    const UNDERFLOW: f64 = f64::UNDERFLOW;
    const LARGEST: f64 = f64::LARGEST;
    const LEAST: f64 = f64::LEAST;
}

impl Number for Fused32 {
    const NAME: &'static str = "f32, fused";
    const UNIT: f64 = f32::UNIT;
    const UNDERFLOW: f64 = f32::UNDERFLOW;
    const LARGEST: f64 = f32::LARGEST;
    const LEAST: f64 = f32::LEAST;
}

impl Number for Flushed {
    const NAME: &'static str = "f32, flushed";
    const UNIT: f64 = SINGLE;
    const UNDERFLOW: f64 = 1.2e-38;
    const LARGEST: f64 = f32::MAX as f64;
    const LEAST: f64 = -30.0;
}

/// Asserts that the errors of all states, and of the kept inputs, are within the limits. Inputs that are exact in f32
/// are for single precision, since a rotation rounded to f32 is not one in double precision.
///
/// # Panics
/// If an error exceeds its limit or is NaN.
pub fn hold<T: Number, const K: usize, const M: usize>(
    limits: [(&str, f64); M],
    kept: &[[u64; K]],
    states: &[[T; K]],
    errors: impl Fn(&[T; K]) -> [f64; M],
) {
    let kept = kept.iter().map(|bits| bits.map(f64::from_bits));
    let is_single = |x: &f64| f64::from(f32::constant(*x)).to_bits() == x.to_bits();
    let kept = kept.filter(|state| state.iter().all(is_single) == (T::UNIT == SINGLE));
    let kept = kept.map(|state| state.map(T::constant));
    let mut worst = [(-1.0, states[0]); M];
    for state in kept.chain(states.iter().copied()) {
        for ((name, _), (worst, found)) in limits.iter().zip(worst.iter_mut().zip(errors(&state))) {
            assert!(!found.is_nan(), "{name}: NaN at {}", hexadecimal(&state));
            if found > worst.0 {
                *worst = (found, state);
            }
        }
    }
    for ((name, limit), (found, state)) in limits.iter().zip(worst) {
        let place = hexadecimal(&state);
        println!("{name}, {}: {found:.2} of {limit} at {place}", T::NAME);
        assert!(found <= *limit, "{name}, {}: {found} at {place}", T::NAME);
    }
}

/// The bits of a state as numbers of f64.
fn hexadecimal<T: Number, const K: usize>(state: &[T; K]) -> String {
    let words = state.map(|x| format!("0x{:016x}", x.to_f64().to_bits()));
    format!("[{}]", words.join(", "))
}

/// |found − exact| in units of u · |`size`|, with an allowance for underflow.
pub fn units<T: Number>(found: T, exact: &Big, size: &Big) -> f64 {
    if !found.is_finite() {
        return f64::NAN;
    }
    let error = (found.big() - exact).abs();
    let unit = Big::new(T::UNIT) * size.abs();
    (error / (unit + Big::new(T::UNDERFLOW))).to_f64()
}

/// A number of either sign with a uniform decimal exponent in a range.
pub fn size<T: Number>(random: &mut Random, least: f64, most: f64) -> T {
    let power = least + (most - least) * 0.5 * (random.unit() + 1.0);
    let sign = if random.chance(2) { -1.0 } else { 1.0 };
    T::constant(sign * 10_f64.powf(power))
}

/// Three numbers in [−1, 1).
pub fn vector<T: Number>(random: &mut Random) -> [T; 3] {
    from_fn(|_| T::constant(random.unit()))
}

/// A unit vector: random, or one of the 26 with entries 0 and ±x.
pub fn direction<T: Number>(random: &mut Random) -> [T; 3] {
    loop {
        let v = if random.chance(3) {
            from_fn(|_| T::constant([-1.0, 0.0, 1.0][random.below(3)]))
        } else {
            vector(random)
        };
        if let Some(u) = homogen::vector::unit(v) {
            return u;
        }
    }
}

/// One test for each type. The runtime's geometry fuses nothing; only tests of generated functions use fused types.
#[macro_export]
macro_rules! in_every_type {
    ($($(#[$about:meta])* $case:ident => $generic:ident;)+) => {$(
        $(#[$about])*
        #[test]
        fn $case() {
            $generic::<f64>();
            $generic::<f32>();
            $generic::<homogen_tests::tested::Flushed>();
        }
    )+};
}

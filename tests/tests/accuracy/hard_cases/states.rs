//! States of the hard cases: random ones, some at rest, some with subnormal rates.

use homogen_codegen::space::Variable;
use homogen_tests::arguments::{self, Arguments};
use homogen_tests::effort::effort;
use homogen_tests::states::Random;

/// States changed by the case; then every sixth is brought to rest, and every sixth gets subnormal rates.
pub fn states(
    count: usize,
    joints: usize,
    mut change: impl FnMut(&mut Arguments, &mut Random),
) -> Vec<Arguments> {
    let mut random = Random::new(joints as u64);
    let each = |k: usize| {
        let mut arguments = arguments::random(joints, &mut random);
        change(&mut arguments, &mut random);
        match k % 6 {
            4 => arguments[Variable::Qd].fill(0.0),
            // Multiples of the smallest numbers of single and of double precision, 2⁻¹⁴⁹ and 2⁻¹⁰⁷⁴.
            5 => {
                let smallest = if k % 12 == 5 {
                    2_f64.powi(-149)
                } else {
                    5e-324
                };
                for rate in &mut arguments[Variable::Qd] {
                    *rate = smallest * (random.unit() * 8e6).round();
                }
            }
            _ => {}
        }
        arguments
    };
    (0..count).map(each).collect()
}

/// A third of the states; in the long form, all of them.
pub fn third(count: usize) -> usize {
    effort(count.div_ceil(3), count)
}

/// A number of either sign with a decimal exponent in a range, exact in single precision.
pub fn of_size(random: &mut Random, least: f64, most: f64) -> f64 {
    let exponent = least + (most - least) * (random.unit() + 1.0) / 2.0;
    let sign = if random.chance(2) { 1.0 } else { -1.0 };
    single(sign * 10_f64.powf(exponent))
}

/// The nearest number of single precision.
#[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
pub fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

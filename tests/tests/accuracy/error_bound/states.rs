//! Random states in the range of the bounds.
//!
//! In: a chain, its range, random numbers. Out: inputs that are exact in a type, ends of the range among them.

use homogen_codegen::chain::{Chain, Position};
use homogen_codegen::expression::Input;
use homogen_codegen::joint::Manifold;
use homogen_codegen::list::Id;
use homogen_codegen::range::Range;
use homogen_codegen::space::{Arguments, Variable};
use homogen_tests::effort::effort;
use homogen_tests::states::Random;
use homogen_tests::tested::Tested;

/// States for each robot and type: the limits of the tests are those of a thousand.
pub fn trials() -> usize {
    effort(250, 1000)
}

/// A number of the type nearest to another, within a range.
fn within<T: Tested>(x: f64, [lo, hi]: [f64; 2]) -> f64 {
    let near = T::literal(x).to_f64();
    let step = 2.0 * T::ROUNDOFF * near.abs();
    let back = if near > hi { near - step } else { near };
    T::literal(if back < lo { back + step } else { back }).to_f64()
}

/// Every input in its range, one in three at an end. Fields are of `f64`, all others exact in the type, quaternions
/// normalised but for that.
pub fn state<T: Tested>(
    chain: &Chain,
    range: &Range,
    random: &mut Random,
) -> impl Fn(Input) -> f64 + use<T> {
    let mut any = |[lo, hi]: [f64; 2]| match random.below(6) {
        0 => lo,
        1 => hi,
        // Three random numbers, for a full mantissa.
        _ => {
            let mut more = |less: f64| (0..3).fold(0.0, |x, _| random.unit() + less * x);
            lo + (hi - lo) * 0.5 * (1.0 + more(2.0_f64.powi(-24)))
        }
    };
    let mut rounded = |ranges: &[[f64; 2]]| -> Vec<f64> {
        let ranges = ranges.iter();
        ranges
            .map(|&range| within::<T>(any(range), range))
            .collect()
    };
    let mut arguments = Arguments::of(|variable| rounded(&range.arguments[variable]));
    for joint in &chain.joints {
        let first = match joint.position {
            Position::Manifold(Manifold::Spherical, first) => first.index(),
            Position::Manifold(Manifold::Floating, first) => first.index() + 3,
            _ => continue,
        };
        let quaternion = &mut arguments[Variable::Q][first..][..4];
        let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        for x in quaternion {
            *x = T::literal(*x / length).to_f64();
        }
    }
    let fields = range.fields.iter();
    let fields: Vec<Vec<f64>> = fields
        .map(|field| field.iter().map(|&range| any(range)).collect())
        .collect();
    move |input| match input {
        Input::Variable(variable, k) => arguments[variable][usize::from(k)],
        Input::Parameter(field, k) => fields[usize::from(field)][usize::from(k)],
    }
}

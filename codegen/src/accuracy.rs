//! How far rounding can take the results of a function, in words and numbers.
//!
//! In: a chain, functions, their program and the type of number. Out: an [`Accuracy`], what stands
//! beside the price: the worst of all results that share a unit. It never says less than "at most":
//! where nothing can be said that holds for every state of the range, it gives the reason.

use std::fmt;

use crate::chain::range::{self, Range};
use crate::chain::{Chain, Motion};
use crate::expression::Input;
use crate::function::{Argument, Function};
use crate::request::Real;
use crate::schedule::Program;
use crate::schedule::bound::{self, Value};

/// What is promised of the results of a function.
#[derive(Clone, Debug, PartialEq)]
pub enum Accuracy {
    /// In every state of a range, no result is farther from the exact one.
    Within {
        /// The worst for each unit, in the order in which the units come among the results.
        bounds: Vec<Bound>,
        /// The range in words.
        range: String,
    },
    /// In every state of a range, the accelerations found are the exact ones of torques and forces
    /// no farther from those given (backward error).
    Backward {
        /// As of [`Accuracy::Within`], of the torques and forces.
        bounds: Vec<Bound>,
        /// The range in words.
        range: String,
    },
    /// Nothing, for a reason.
    Unknown(&'static str),
}

/// The greatest error of the results of one unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The unit; 1 for a number without.
    pub unit: &'static str,
    /// In `f64`, where that was asked for.
    pub double: Option<f64>,
    /// In `f32`, where that was asked for.
    pub single: Option<f64>,
}

/// Bounds the errors of a program that computes some functions one after the other; for `f32` and
/// `f64` where any type is meant.
#[must_use]
pub fn of(chain: &Chain, functions: &[Function], program: &Program, scalar: Real) -> Accuracy {
    let inverts = |function: &Function| {
        matches!(
            function,
            Function::ForwardDynamics | Function::MassMatrixInverse
        )
    };
    if functions.iter().any(inverts) {
        return Accuracy::Unknown("it grows with the condition number of the mass matrix");
    }
    let range = Range::of(chain);
    let worst =
        |scalar: Real| bound::errors(program, scalar, &|input| value(&range, input, scalar));
    let slides = slides(chain);
    let units = functions
        .iter()
        .flat_map(|function| function.units(&slides));
    let Some(bounds) = by_unit(units, scalar, worst) else {
        return Accuracy::Unknown("a divisor may be zero, as far as ranges tell");
    };
    let mut arguments: Vec<Argument> = functions
        .iter()
        .flat_map(|function| function.arguments().iter().copied())
        .collect();
    arguments.sort_unstable();
    arguments.dedup();
    Accuracy::Within {
        bounds,
        range: range::words(chain, &arguments),
    }
}

/// Bounds the backward error of accelerations that are found by the factors of the mass matrix,
/// without refinement. The program computes the mass matrix and then the bias as that function does.
///
/// What a computed solution solves exactly is M + ΔM with |ΔM| ≤ γ |Lᵗ| D |L| (Higham, *Accuracy and
/// Stability of Numerical Algorithms*, 2002, theorem 10.4), of which an entry is at most
/// γ √(Mᵢᵢ Mⱼⱼ), since M is positive definite.
#[must_use]
pub fn of_accelerations(chain: &Chain, program: &Program, scalar: Real) -> Accuracy {
    let range = Range::of(chain);
    let count = chain.joints.len();
    // Factors and two substitutions, 3n + 1; quotients as products with a reciprocal, 3; the
    // difference of torques and bias, 1; and 1 for all products of these.
    let roundings = chain.joints.iter().map(|_| 3.0).sum::<f64>() + 6.0;
    let worst = |scalar: Real| -> Vec<f64> {
        let results = bound::results(program, scalar, &|input| value(&range, input, scalar));
        let (mass, bias) = results.split_at(count * count);
        let size = |k: usize| mass[k * count + k].reach();
        let lost = roundings * scalar.roundoff();
        let row = |i: usize| {
            let entries = range.qdd.iter().enumerate();
            let entries = entries.map(|(j, [_, most])| {
                let solved = lost * (size(i) * size(j)).sqrt();
                (mass[i * count + j].error + solved) * most
            });
            bias[i].error + entries.sum::<f64>()
        };
        (0..count).map(row).collect()
    };
    let units = Function::InverseDynamics.units(&slides(chain));
    match by_unit(units, scalar, worst) {
        Some(bounds) => Accuracy::Backward {
            bounds,
            range: range::words(chain, &[Argument::Q, Argument::Qd, Argument::Qdd]),
        },
        None => Accuracy::Unknown("a divisor may be zero, as far as ranges tell"),
    }
}

/// The worst error for each unit, for `f32` and `f64` where any type is meant; none where there is
/// no bound.
fn by_unit(
    units: impl IntoIterator<Item = &'static str>,
    scalar: Real,
    worst: impl Fn(Real) -> Vec<f64>,
) -> Option<Vec<Bound>> {
    let double = (scalar != Real::F32).then(|| worst(Real::F64));
    let single = (scalar != Real::F64).then(|| worst(Real::F32));
    let mut bounds: Vec<Bound> = Vec::new();
    for (k, unit) in units.into_iter().enumerate() {
        let at = |errors: &Option<Vec<f64>>| errors.as_ref().map(|errors| errors[k]);
        let (double, single) = (at(&double), at(&single));
        if [double, single].into_iter().flatten().any(f64::is_infinite) {
            return None;
        }
        match bounds.iter_mut().find(|bound| bound.unit == unit) {
            Some(bound) => {
                bound.double = larger(bound.double, double);
                bound.single = larger(bound.single, single);
            }
            None => bounds.push(Bound {
                unit,
                double,
                single,
            }),
        }
    }
    Some(bounds)
}

/// Which joints slide.
fn slides(chain: &Chain) -> Vec<bool> {
    let joints = chain.joints.iter();
    joints
        .map(|joint| matches!(joint.motion, Motion::Prismatic))
        .collect()
}

fn value(range: &Range, input: Input, scalar: Real) -> Value {
    match (range.get(input), input) {
        // A field is of `f64`, and rounded when it is read.
        (Some([lo, hi]), Input::Parameter(..)) => Value::between(lo, hi).rounded(scalar.roundoff()),
        (Some([lo, hi]), _) => Value::between(lo, hi),
        (None, _) => Value::UNKNOWN,
    }
}

fn larger(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.zip(b).map(|(a, b)| a.max(b))
}

impl fmt::Display for Accuracy {
    /// One line: `at most 3.4e-14 N m in f64, 1.8e-5 N m in f32; q and q̇ within their limits`.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, bounds, range) = match self {
            Self::Within { bounds, range } => ("", bounds, range),
            Self::Backward { bounds, range } => ("as if τ were off by ", bounds, range),
            Self::Unknown(reason) => return write!(out, "no bound: {reason}"),
        };
        let worst = |name: &str, of: fn(&Bound) -> Option<f64>| {
            let sizes = bounds.iter();
            let sizes: Vec<String> = sizes
                .filter_map(|bound| {
                    let size = upwards(of(bound)?);
                    Some(match bound.unit {
                        "1" => size,
                        unit => format!("{size} {unit}"),
                    })
                })
                .collect();
            (!sizes.is_empty()).then(|| format!("{} in {name}", sizes.join(" and ")))
        };
        let (double, single) = (
            worst("f64", |bound| bound.double),
            worst("f32", |bound| bound.single),
        );
        let said: Vec<String> = double.into_iter().chain(single).collect();
        write!(out, "{what}at most {}", said.join(", "))?;
        if !range.is_empty() {
            write!(out, "; {range}")?;
        }
        Ok(())
    }
}

/// Two digits, never less than the number.
fn upwards(size: f64) -> String {
    let near = |size: f64| format!("{size:.1e}");
    let text = near(size);
    match text.parse::<f64>() {
        Ok(printed) if printed < size => near(size * 1.05),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::{Accuracy, Bound, upwards};

    #[test]
    fn two_digits_are_never_less_than_the_number() {
        for size in [0.0, 1.0, 1.04e-15, 1.06e-15, 9.99e-7, 9.51e-7, 4.4e-16] {
            let text = upwards(size);
            let printed: f64 = text.parse().expect("a number");
            assert!((size..=1.11 * size).contains(&printed), "{size:e}: {text}");
        }
    }

    #[test]
    fn a_bound_is_a_line() {
        let bound = |unit, double, single| Bound {
            unit,
            double,
            single,
        };
        let within = |bounds| Accuracy::Within {
            bounds,
            range: "q within its limits".to_owned(),
        };
        let pose = within(vec![
            bound("1", Some(1.34e-15), Some(7.2e-7)),
            bound("m", Some(2e-15), Some(1e-6)),
        ]);
        assert_eq!(
            pose.to_string(),
            "at most 1.4e-15 and 2.0e-15 m in f64, 7.2e-7 and 1.0e-6 m in f32; q within its limits"
        );
        let single = within(vec![bound("N m", None, Some(3.1e-5))]);
        assert_eq!(
            single.to_string(),
            "at most 3.1e-5 N m in f32; q within its limits"
        );
        let backward = Accuracy::Backward {
            bounds: vec![
                bound("N m", Some(2.1e-12), None),
                bound("N", Some(3e-12), None),
            ],
            range: "q within its limits".to_owned(),
        };
        assert_eq!(
            backward.to_string(),
            "as if τ were off by at most 2.1e-12 N m and 3.0e-12 N in f64; q within its limits"
        );
        let unknown = Accuracy::Unknown("nobody knows");
        assert_eq!(unknown.to_string(), "no bound: nobody knows");
    }
}

//! How far rounding can take the results of a function, in words and numbers.
//!
//! In: a chain, functions, their program and the type of number. Out: an [`Accuracy`], what stands
//! beside the price: the worst of all results that share a unit. It never says less than "at most":
//! where nothing can be said that holds for every state of the range, it gives the reason.

mod articulated;
mod solved;

use std::fmt;

pub use self::articulated::of_articulated;
pub use self::solved::{of_accelerations, of_inverse};
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
    /// In every state of a range, what is found is the exact solution for something that is no farther
    /// from what was given (backward error).
    Backward {
        /// What was given.
        given: Given,
        /// As of [`Accuracy::Within`], of what was given.
        bounds: Vec<Bound>,
        /// The range in words.
        range: String,
    },
    /// Nothing, for a reason.
    Unknown(&'static str),
}

/// What a solution is found for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// τ, of which accelerations are the solution.
    Torques,
    /// M, of which each column of the inverse is one, from the diagonal up.
    MassMatrix,
}

/// The greatest error of the results of one unit; infinite where there is no bound in the type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The unit; 1 for a number without.
    pub unit: &'static str,
    /// In `f64`, where that was asked for.
    pub double: Option<f64>,
    /// In `f32`, where that was asked for.
    pub single: Option<f64>,
}

impl Given {
    /// Its letter.
    #[must_use]
    pub const fn letter(self) -> &'static str {
        match self {
            Self::Torques => "τ",
            Self::MassMatrix => "M",
        }
    }
}

/// Bounds the errors of a program that computes some functions one after the other, for `f32` and
/// `f64` where any type is meant; of those that invert a mass matrix it says nothing.
#[must_use]
pub fn of(
    chain: &Chain,
    functions: &[Function],
    program: &Program,
    scalar: Real,
) -> Option<Accuracy> {
    let range = Range::of(chain);
    let slides = slides(chain);
    let evaluated = |function: &Function| {
        !matches!(
            function,
            Function::ForwardDynamics | Function::MassMatrixInverse
        )
    };
    let results = functions.iter().flat_map(|function| {
        let units = function.units(&slides).into_iter();
        units.map(|unit| evaluated(function).then_some(unit))
    });
    let (kept, units): (Vec<usize>, Vec<&str>) = results
        .enumerate()
        .filter_map(|(k, unit)| Some((k, unit?)))
        .unzip();
    if units.is_empty() {
        return None;
    }
    let worst = |scalar: Real| {
        let errors = bound::errors(program, scalar, &|input| value(&range, input, scalar));
        kept.iter().map(|&k| errors[k]).collect()
    };
    let mut arguments: Vec<Argument> = (functions.iter().copied())
        .filter(evaluated)
        .flat_map(Function::arguments)
        .copied()
        .collect();
    arguments.sort_unstable();
    arguments.dedup();
    Some(match by_unit(units, scalar, worst) {
        Some(bounds) => Accuracy::Within {
            bounds,
            range: range::words(chain, &arguments),
        },
        None => Accuracy::Unknown("a divisor may be zero, as far as ranges tell"),
    })
}

/// The worst error for each unit, for `f32` and `f64` where any type is meant; none where there is
/// no bound in any.
fn by_unit(
    units: impl IntoIterator<Item = &'static str>,
    scalar: Real,
    worst: impl Fn(Real) -> Vec<f64>,
) -> Option<Vec<Bound>> {
    // Where one result has no bound, the type has none.
    let all = |scalar: Real| {
        let errors = worst(scalar);
        let bounded = errors.iter().all(|error| error.is_finite());
        bounded.then_some(errors)
    };
    let double = (scalar != Real::F32).then(|| all(Real::F64));
    let single = (scalar != Real::F64).then(|| all(Real::F32));
    if ![&double, &single]
        .into_iter()
        .flatten()
        .any(Option::is_some)
    {
        return None;
    }
    let mut bounds: Vec<Bound> = Vec::new();
    for (k, unit) in units.into_iter().enumerate() {
        let at = |errors: &Option<Option<Vec<f64>>>| {
            let errors = errors.as_ref()?;
            Some(errors.as_ref().map_or(f64::INFINITY, |errors| errors[k]))
        };
        let (double, single) = (at(&double), at(&single));
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

/// What is promised of a solution, where something is.
fn backward(chain: &Chain, given: Given, bounds: Option<Vec<Bound>>) -> Accuracy {
    let arguments: &[Argument] = match given {
        Given::Torques => &[Argument::Q, Argument::Qd, Argument::Qdd],
        Given::MassMatrix => &[Argument::Q],
    };
    match bounds {
        Some(bounds) => Accuracy::Backward {
            given,
            bounds,
            range: range::words(chain, arguments),
        },
        None => Accuracy::Unknown("ranges and inertias tell none"),
    }
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
    /// One line: `at most 3.4e-14 N m in f64, 1.8e-5 N m in f32; q and q̇ within their limits`. Whatever
    /// the type, f64 has a bound where f32 has one.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (bounds, range) = match self {
            Self::Within { bounds, range } => (bounds, range),
            Self::Backward {
                given,
                bounds,
                range,
            } => {
                write!(out, "as if {} were off by ", given.letter())?;
                (bounds, range)
            }
            Self::Unknown(reason) => return write!(out, "no bound: {reason}"),
        };
        let worst = |name: &str, of: fn(&Bound) -> Option<f64>| {
            let sizes: Option<Vec<f64>> = bounds.iter().map(of).collect();
            let sizes = sizes.filter(|sizes| !sizes.is_empty())?;
            if sizes.iter().any(|size| size.is_infinite()) {
                return Some(format!("no bound in {name}"));
            }
            let sizes = sizes.into_iter().map(upwards).zip(bounds);
            let sizes: Vec<String> = sizes
                .map(|(size, bound)| match bound.unit {
                    "1" => size,
                    unit => format!("{size} {unit}"),
                })
                .collect();
            Some(format!("{} in {name}", sizes.join(" and ")))
        };
        let (double, single) = (
            worst("f64", |bound| bound.double),
            worst("f32", |bound| bound.single),
        );
        let said: Vec<String> = double.into_iter().chain(single).collect();
        write!(out, "at most {}", said.join(", "))?;
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
    use super::{Accuracy, Bound, Given, upwards};

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
        let backward = |given, bounds| Accuracy::Backward {
            given,
            bounds,
            range: "q within its limits".to_owned(),
        };
        let torques = vec![
            bound("N m", Some(2.1e-12), None),
            bound("N", Some(3e-12), None),
        ];
        assert_eq!(
            backward(Given::Torques, torques).to_string(),
            "as if τ were off by at most 2.1e-12 N m and 3.0e-12 N in f64; q within its limits"
        );
        let moments = vec![bound("kg m²", Some(1e-15), Some(f64::INFINITY))];
        assert_eq!(
            backward(Given::MassMatrix, moments).to_string(),
            "as if M were off by at most 1.0e-15 kg m² in f64, no bound in f32; q within its limits"
        );
        let unknown = Accuracy::Unknown("nobody knows");
        assert_eq!(unknown.to_string(), "no bound: nobody knows");
    }
}

//! What is promised of results, and how a promise is made of the worst errors.
//!
//! In: the worst error of each result, whose it is, and what a program computes with. Out: an
//! [`Accuracy`]: the worst of each joint's results that share a unit, with the range in words. It bounds
//! nothing itself.

use std::collections::BTreeMap;

use crate::chain::Chain;
use crate::expression::Input;
use crate::formulation::Sines;
use crate::function::Function;
use crate::range::{self, Range};
use crate::real::{Real, Trigonometry};
use crate::request::Request;
use crate::schedule::bound::{self, Conditions, Reason, Value};
use crate::schedule::{Operand, Program};
use crate::space::{FieldId, Space, Variable};

/// What is promised of the results of a function.
#[derive(Clone, Debug, PartialEq)]
pub enum Accuracy {
    /// In every state of a range, no result is farther from the exact one.
    Within(Promise),
    /// In every state of a range, what is found is the exact solution for something that is no farther
    /// from what was given (backward error).
    Backward(Perturbed, Promise),
    /// In every state of a range, no entry (i, j) of the inverse of the mass matrix is farther from the exact one
    /// than so many times √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ); a bound for each row.
    BesideDiagonal(Promise),
    /// Nothing, for a reason.
    Unknown(&'static str),
}

/// What a solution is exact for, but for a backward error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Perturbed {
    /// τ, of which accelerations are the solution.
    Torques,
    /// M, of which each column of the inverse is one, from the diagonal up: each for another M.
    MassMatrix,
    /// Forces and torques of 1, each of which a column of the inverse is one for, from the diagonal up.
    UnitForces,
    /// ∂τ/∂q and ∂τ/∂q̇ at the accelerations found, of which each column of the derivatives of accelerations is one.
    TorqueDerivatives,
}

/// Bounds, and what they are for.
#[derive(Clone, Debug, PartialEq)]
pub struct Promise {
    /// The worst for each joint and unit, in the order of the results.
    pub bounds: Vec<Bound>,
    /// The range in words.
    pub range: String,
    /// Why one of the types has no bound.
    pub lacks: Option<&'static str>,
}

/// The greatest error of the results of one joint and unit; infinite where there is no bound in the
/// type.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The joint whose they are: entry, row of a matrix or column of a Jacobian; the residual, where they are
    /// of loops; none where they are of a frame.
    pub joint: Option<String>,
    /// The unit; 1 for a number without.
    pub unit: &'static str,
    /// In `f64`, where that was asked for.
    pub double: Option<f64>,
    /// In `f32`, where that was asked for.
    pub single: Option<f64>,
}

/// What a program computes with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Means {
    /// The type of number; `f32` and `f64` where any is meant.
    pub scalar: Real,
    /// Its sines and cosines.
    pub trigonometry: Trigonometry,
}

impl Means {
    /// What the programs of a request compute with.
    #[must_use]
    pub const fn of(request: &Request) -> Self {
        Self {
            scalar: request.scalar,
            trigonometry: match request.formulation.sines {
                Sines::Own => request.trigonometry,
                Sines::Platform => Trigonometry::Other,
            },
        }
    }
}

/// The worst error of each result, or why there is none.
pub(super) type Worst = Result<Vec<f64>, &'static str>;

/// The entry, of a joint or a loop, and the unit of a result.
pub(super) type Owner = (Option<(Space, usize)>, &'static str);

/// Those of all results of a function.
pub(super) fn owners(chain: &Chain, function: Function) -> Vec<Owner> {
    let (quantity, spaces) = (function.result(), chain.spaces());
    let units = quantity.units(spaces).into_iter().enumerate();
    units
        .map(|(k, unit)| (quantity.owner(spaces, k), unit))
        .collect()
}

/// The worst error for each owner, for `f32` and `f64` where any type is meant.
///
/// Every error is a sum of products of sizes with powers of the roundoff, and of the smallest normal
/// number: a bound in `f32` times the ratio of both roundoffs is one in `f64`.
pub(super) fn promise(
    chain: &Chain,
    means: Means,
    owners: &[Owner],
    worst: impl Fn(Real) -> Worst,
) -> Result<Promise, &'static str> {
    let (double, single) = match means.scalar {
        Real::F64 => (Some(worst(Real::F64)), None),
        Real::F32 => (None, Some(worst(Real::F32))),
        Real::Generic => {
            let single = worst(Real::F32);
            let ratio = Real::F64.roundoff() / Real::F32.roundoff();
            let double = match &single {
                Ok(errors) => Ok(errors.iter().map(|error| error * ratio).collect()),
                Err(_) => worst(Real::F64),
            };
            (Some(double), Some(single))
        }
    };
    let (found, lacking): (Vec<_>, Vec<_>) = [&double, &single]
        .into_iter()
        .flatten()
        .partition(|worst| worst.is_ok());
    let lacks = lacking
        .first()
        .and_then(|worst| worst.as_ref().err().copied());
    if let (true, Some(reason)) = (found.is_empty(), lacks) {
        return Err(reason);
    }
    let at = |errors: &Option<Worst>, k: usize| {
        let errors = errors.as_ref()?;
        Some(errors.as_ref().map_or(f64::INFINITY, |errors| errors[k]))
    };
    let mut order: Vec<Owner> = Vec::new();
    let mut all: BTreeMap<Owner, [Option<f64>; 2]> = BTreeMap::new();
    for (k, &owner) in owners.iter().enumerate() {
        let found = [at(&double, k), at(&single, k)];
        let both = all.entry(owner).or_insert_with(|| {
            order.push(owner);
            found
        });
        for (most, found) in both.iter_mut().zip(found) {
            *most = most.zip(found).map(|(a, b)| a.max(b));
        }
    }
    let bounds = order.into_iter().map(|owner @ (of, unit)| {
        let [double, single] = all[&owner];
        Bound {
            joint: of.map(|(space, entry)| chain.spaces().entries(space)[entry].name.clone()),
            unit,
            double,
            single,
        }
    });
    Ok(Promise {
        bounds: bounds.collect(),
        range: String::new(),
        lacks,
    })
}

impl Accuracy {
    /// Without what is said of `f32` beside `f64`, for a reason.
    #[must_use]
    pub fn without_single(self, reason: &'static str) -> Self {
        let without = |mut promise: Promise| {
            for bound in &mut promise.bounds {
                bound.single = bound.single.map(|_| f64::INFINITY);
            }
            promise.lacks = promise.lacks.or(Some(reason));
            promise
        };
        match self {
            Self::Within(promise) => Self::Within(without(promise)),
            Self::Backward(of, promise) => Self::Backward(of, without(promise)),
            Self::BesideDiagonal(promise) => Self::BesideDiagonal(without(promise)),
            Self::Unknown(reason) => Self::Unknown(reason),
        }
    }
}

impl Promise {
    /// With the range of some arguments, and of the fields and sines that programs read.
    pub(super) fn within(
        self,
        chain: &Chain,
        arguments: &[Variable],
        programs: &[&Program],
        means: Means,
    ) -> Self {
        let reads = |field: FieldId| {
            let mut operands = programs.iter().flat_map(|program| program.operands());
            operands.any(|operand| match operand {
                Operand::Input(Input::Parameter(of, _)) => field == of.into(),
                _ => false,
            })
        };
        let mut range = range::words(chain, arguments, reads);
        let turns = programs.iter().any(|program| !program.angles.is_empty());
        if turns && means.trigonometry == Trigonometry::Other {
            let between = if range.is_empty() { "" } else { ", " };
            range.push_str(between);
            range.push_str("sines within 1 unit in the last place");
        }
        Self { range, ..self }
    }
}

/// What is promised of a solution, where something is.
pub(super) fn backward(
    chain: &Chain,
    perturbed: Perturbed,
    programs: &[&Program],
    means: Means,
    worst: impl Fn(Real) -> Worst,
) -> Accuracy {
    let of = match perturbed {
        Perturbed::Torques | Perturbed::UnitForces => Function::InverseDynamics,
        Perturbed::MassMatrix => Function::MassMatrix,
        Perturbed::TorqueDerivatives => Function::InverseDynamicsDerivatives,
    };
    let arguments = match perturbed {
        Perturbed::UnitForces => vec![Variable::Q],
        _ => of.arguments_with(chain.spaces().actions() > 0),
    };
    match promise(chain, means, &owners(chain, of), worst) {
        Ok(promise) => Accuracy::Backward(
            perturbed,
            promise.within(chain, &arguments, programs, means),
        ),
        Err(reason) => Accuracy::Unknown(reason),
    }
}

/// What is promised of the rows of an inverse of the mass matrix, where something is.
pub(super) fn beside_diagonal(
    chain: &Chain,
    programs: &[&Program],
    means: Means,
    worst: impl Fn(Real) -> Worst,
) -> Accuracy {
    let rows = chain.spaces().velocities.len();
    let owners: Vec<Owner> = (0..rows)
        .map(|row| (Some((Space::Velocities, row)), "1"))
        .collect();
    match promise(chain, means, &owners, worst) {
        Ok(promise) => {
            Accuracy::BesideDiagonal(promise.within(chain, &[Variable::Q], programs, means))
        }
        Err(reason) => Accuracy::Unknown(reason),
    }
}

/// What a program computes in a range.
pub(super) fn computed(
    program: &Program,
    range: &Range,
    means: Means,
    scalar: Real,
) -> Vec<bound::Found> {
    let input = |input: Input| value(range, input, scalar);
    let conditions = Conditions {
        scalar,
        angles: means.trigonometry.reach(scalar),
        range: &input,
        quaternions: &range.quaternions,
    };
    bound::results(program, &conditions)
}

/// The error of a result, or why it has no bound.
pub(super) fn error(found: bound::Found) -> Result<f64, &'static str> {
    if found.value.error.is_finite() {
        Ok(found.value.error)
    } else {
        Err(found.reason.unwrap_or(Reason::Divisor).words())
    }
}

pub(super) fn value(range: &Range, input: Input, scalar: Real) -> Value {
    match (range.get(input), input) {
        // A field is of `f64`, and rounded when it is read.
        (Some([lo, hi]), Input::Parameter(..)) => Value::between(lo, hi).rounded(scalar),
        (Some([lo, hi]), _) => Value::between(lo, hi),
        (None, _) => Value::UNKNOWN,
    }
}

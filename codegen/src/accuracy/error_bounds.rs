//! Error bounds by joint and unit, and how they are made of the worst error of each result.
//!
//! In: the worst error of each result, the joint it belongs to, and the arithmetic of a program. Out: an
//! [`Accuracy`]: the worst of each joint's results that share a unit, with the range in words.

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

/// An error bound of the results of a function.
#[derive(Clone, Debug, PartialEq)]
pub enum Accuracy {
    /// Forward error: in every state of a range, no result is farther from the exact one.
    Within(ErrorBounds),
    /// Backward error: in every state of a range, the result is the exact solution for data that differ by no more
    /// from the given ones.
    Backward(Perturbed, ErrorBounds),
    /// In every state of a range, no entry (i, j) of the inverse of the mass matrix is farther from the exact one
    /// than so many times √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ); a bound for each row.
    BesideDiagonal(ErrorBounds),
    /// No bound, for a reason.
    Unknown(&'static str),
}

/// The data of a backward error, for which a solution is exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Perturbed {
    /// τ, of which accelerations are the solution.
    Torques,
    /// M, of which each column of the inverse solves a system, from the diagonal up; ΔM differs by column.
    MassMatrix,
    /// Forces and torques of 1, the right side of a column of the inverse, from the diagonal up.
    UnitForces,
    /// ∂τ/∂q and ∂τ/∂q̇ at the accelerations found, the right sides of the derivatives of accelerations.
    TorqueDerivatives,
}

/// Error bounds with the range in which they hold.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorBounds {
    /// The worst for each joint and unit, in the order of the results.
    pub bounds: Vec<Bound>,
    /// The range in words.
    pub range: String,
    /// Reason why one of the types has no bound.
    pub lacks: Option<&'static str>,
}

/// The largest error of the results of one joint and unit; infinite if there is no bound in the type.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The joint of the results: of an entry, a row of a matrix or a column of a Jacobian. For results of loops the
    /// residual; `None` for results of a frame.
    pub joint: Option<String>,
    /// The unit; 1 for a dimensionless number.
    pub unit: &'static str,
    /// In `f64`, if requested.
    pub double: Option<f64>,
    /// In `f32`, if requested.
    pub single: Option<f64>,
}

/// The arithmetic of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RoundingModel {
    /// The type of numbers; for a generic scalar, `f32` and `f64`.
    pub scalar: Real,
    /// Its sine and cosine.
    pub trigonometry: Trigonometry,
}

impl RoundingModel {
    /// The arithmetic of the programs of a request.
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

/// The worst error of each result, or the reason why there is no bound.
pub(super) type Worst = Result<Vec<f64>, &'static str>;

/// The entry, of a joint or a loop, and the unit of a result.
pub(super) type Owner = (Option<(Space, usize)>, &'static str);

/// The owner of each result of a function.
pub(super) fn owners(chain: &Chain, function: Function) -> Vec<Owner> {
    let (quantity, spaces) = (function.result(), chain.spaces());
    let units = quantity.units(spaces).into_iter().enumerate();
    units
        .map(|(k, unit)| (quantity.owner(spaces, k), unit))
        .collect()
}

/// The worst error for each owner; in `f32` and `f64` for generic scalars.
///
/// Every error is a sum of products of sizes with powers of the roundoff, and of the smallest normal
/// number: a bound in `f32` times the ratio of both roundoffs is one in `f64`.
pub(super) fn error_bounds(
    chain: &Chain,
    rounding: RoundingModel,
    owners: &[Owner],
    worst: impl Fn(Real) -> Worst,
) -> Result<ErrorBounds, &'static str> {
    let (double, single) = match rounding.scalar {
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
    let (found, unbounded): (Vec<_>, Vec<_>) = [&double, &single]
        .into_iter()
        .flatten()
        .partition(|worst| worst.is_ok());
    let lacks = unbounded
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
    Ok(ErrorBounds {
        bounds: bounds.collect(),
        range: String::new(),
        lacks,
    })
}

impl Accuracy {
    /// Removes the bound in `f32`, for a reason.
    #[must_use]
    pub fn without_single(self, reason: &'static str) -> Self {
        let without = |mut error_bounds: ErrorBounds| {
            for bound in &mut error_bounds.bounds {
                bound.single = bound.single.map(|_| f64::INFINITY);
            }
            error_bounds.lacks = error_bounds.lacks.or(Some(reason));
            error_bounds
        };
        match self {
            Self::Within(error_bounds) => Self::Within(without(error_bounds)),
            Self::Backward(of, error_bounds) => Self::Backward(of, without(error_bounds)),
            Self::BesideDiagonal(error_bounds) => Self::BesideDiagonal(without(error_bounds)),
            Self::Unknown(reason) => Self::Unknown(reason),
        }
    }
}

impl ErrorBounds {
    /// Adds the range of some arguments, and of the fields and sines that the programs read.
    pub(super) fn within(
        self,
        chain: &Chain,
        arguments: &[Variable],
        programs: &[&Program],
        rounding: RoundingModel,
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
        if turns && rounding.trigonometry == Trigonometry::Other {
            let between = if range.is_empty() { "" } else { ", " };
            range.push_str(between);
            range.push_str("sines within 1 unit in the last place");
        }
        Self { range, ..self }
    }
}

/// Bounds a solution by its backward error.
pub(super) fn backward(
    chain: &Chain,
    perturbed: Perturbed,
    programs: &[&Program],
    rounding: RoundingModel,
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
    match error_bounds(chain, rounding, &owners(chain, of), worst) {
        Ok(error_bounds) => Accuracy::Backward(
            perturbed,
            error_bounds.within(chain, &arguments, programs, rounding),
        ),
        Err(reason) => Accuracy::Unknown(reason),
    }
}

/// Bounds the rows of an inverse of the mass matrix in relation to its diagonal.
pub(super) fn beside_diagonal(
    chain: &Chain,
    programs: &[&Program],
    rounding: RoundingModel,
    worst: impl Fn(Real) -> Worst,
) -> Accuracy {
    let rows = chain.spaces().velocities.len();
    let owners: Vec<Owner> = (0..rows)
        .map(|row| (Some((Space::Velocities, row)), "1"))
        .collect();
    match error_bounds(chain, rounding, &owners, worst) {
        Ok(error_bounds) => {
            Accuracy::BesideDiagonal(error_bounds.within(chain, &[Variable::Q], programs, rounding))
        }
        Err(reason) => Accuracy::Unknown(reason),
    }
}

/// Bounds each result of a program in a range.
pub(super) fn computed(
    program: &Program,
    range: &Range,
    rounding: RoundingModel,
    scalar: Real,
) -> Vec<bound::ResultBound> {
    let input = |input: Input| value(range, input, scalar);
    let conditions = Conditions {
        scalar,
        angles: rounding.trigonometry.reach(scalar),
        range: &input,
        quaternions: &range.quaternions,
    };
    bound::results(program, &conditions)
}

/// The error of a result, or the reason why it has no bound.
pub(super) fn error(found: bound::ResultBound) -> Result<f64, &'static str> {
    if found.value.error.is_finite() {
        Ok(found.value.error)
    } else {
        Err(found.reason.unwrap_or(Reason::Divisor).words())
    }
}

/// All results of a program, or the reason why one of them has no bound.
pub(super) fn values(found: Vec<bound::ResultBound>) -> Result<Vec<Value>, &'static str> {
    let found = found.into_iter();
    found
        .map(|found| error(found).map(|_| found.value))
        .collect()
}

pub(super) fn value(range: &Range, input: Input, scalar: Real) -> Value {
    match (range.get(input), input) {
        // A field is an `f64`, and is rounded when it is read.
        (Some([lo, hi]), Input::Parameter(..)) => Value::between(lo, hi).rounded(scalar),
        (Some([lo, hi]), _) => Value::between(lo, hi),
        (None, _) => Value::UNKNOWN,
    }
}

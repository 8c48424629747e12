//! Checks of the arguments of inverse kinematics.
//!
//! In: limits, tolerances, a rest configuration, targets, a start. Out: the targets with exact rotations, or the error of
//! the call. It never evaluates the robot.

use crate::error::{Error, finite};
use crate::ik::Solver;
use crate::matrix::Pose;
use crate::matrix::rotation::{self, defect, from_quaternion, to_quaternion};
use crate::scalar::Real;

/// Largest defect of a rotation that counts as rounding of printed digits: 10⁻⁶, or 3 √ε where that is more.
fn tolerance<T: Real>() -> T {
    let least = T::constant(3.0) * T::EPSILON.sqrt();
    T::constant(1e-6).max(least)
}

/// The targets, each with the rotation of its unit quaternion where its matrix is not orthogonal to rounding.
pub(super) fn targets<T: Real, const K: usize>(
    targets: &[Pose<T>; K],
) -> Result<[Pose<T>; K], Error> {
    let mut checked = *targets;
    for target in &mut checked {
        finite(
            "an entry of the translation of a target",
            &target.translation(),
        )?;
        rotation::check(target.rotation(), tolerance())?;
        if defect(target.rotation()) > T::constant(64.0) * T::EPSILON {
            let rotation = from_quaternion(to_quaternion(target.rotation()));
            *target = Pose::new(rotation, target.translation());
        }
    }
    Ok(checked)
}

/// Rejects empty limits and NaN.
pub(super) fn check<T: Real, const N: usize>(
    solver: &Solver<T, N>,
    start: &[T; N],
) -> Result<(), Error> {
    for (coordinate, [least, most]) in solver.limits.iter().enumerate() {
        let infinite = T::constant(f64::INFINITY);
        // False for NaN.
        let holds_a_number = least <= most && *least < infinite && *most > -infinite;
        if !holds_a_number {
            return Err(Error::EmptyRange {
                coordinate,
                least: least.to_f64(),
                most: most.to_f64(),
            });
        }
    }
    finite("an entry of the start", start)?;
    finite(
        "an entry of the rest configuration",
        solver.rest.iter().flatten(),
    )?;
    finite("the length scale", [&solver.length_scale])?;
    for (quantity, tolerance) in [
        ("the orientation tolerance", solver.orientation_tolerance),
        ("the position tolerance", solver.position_tolerance),
    ] {
        // An infinite tolerance is allowed: any error is within it.
        if tolerance.to_f64().is_nan() {
            let value = f64::NAN;
            return Err(Error::NotFinite { quantity, value });
        }
    }
    Ok(())
}

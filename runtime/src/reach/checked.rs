//! What inverse kinematics can begin with.
//!
//! In: limits, tolerances, a posture, targets, a start. Out: the targets with rotations in them, or the error of the
//! call. It never looks at the robot.

use crate::error::{Error, finite};
use crate::matrix::Pose;
use crate::matrix::rotation::{self, defect, from_quaternion, to_quaternion};
use crate::reach::Reach;
use crate::scalar::Real;

/// How far a rotation may be from orthogonal in its last written digits, 10⁻⁶, or 3 √ε where that is more.
fn tolerance<T: Real>() -> T {
    let least = T::constant(3.0) * T::EPSILON.sqrt();
    T::constant(1e-6).max(least)
}

/// The targets, each with the rotation of its unit quaternion where more than rounding keeps it from being one.
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
            let turn = from_quaternion(to_quaternion(target.rotation()));
            *target = Pose::new(turn, target.translation());
        }
    }
    Ok(checked)
}

/// Refuses limits that no number is within, and what is not a number.
pub(super) fn check<T: Real, const N: usize>(
    reach: &Reach<T, N>,
    start: &[T; N],
) -> Result<(), Error> {
    for (coordinate, [least, most]) in reach.limits.iter().enumerate() {
        let infinite = T::constant(f64::INFINITY);
        // A NaN is not within anything.
        let holds_a_number = least <= most && *least < infinite && *most > -infinite;
        if !holds_a_number {
            return Err(Error::NoRange {
                coordinate,
                least: least.to_f64(),
                most: most.to_f64(),
            });
        }
    }
    finite("an entry of the start", start)?;
    finite("an entry of the posture", reach.posture.iter().flatten())?;
    finite("the radius", [&reach.radius])?;
    for (quantity, tolerance) in [
        ("the tolerance of angles", reach.turn),
        ("the tolerance of distances", reach.shift),
    ] {
        // It may be infinite, where nothing is asked.
        if tolerance.to_f64().is_nan() {
            let value = f64::NAN;
            return Err(Error::NotFinite { quantity, value });
        }
    }
    Ok(())
}

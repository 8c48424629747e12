//! Placements as a translation and roll, pitch and yaw.
//!
//! A placement that was written so keeps its digits. Others are multiplied in 106 bits, with right angles as they are
//! understood.

use super::numbers;
use crate::chain::{angle, axis_rotation};
use crate::description::spatial::{DoubleMatrix, Pose};
use crate::description::{Axis, Number, Step};
use crate::error::Place;
use crate::expression::Double;
use crate::number::computed;

/// A placement, in the words of both formats.
pub(super) struct Placed {
    /// The translation; `None` if it is zero.
    pub(super) xyz: Option<String>,
    /// Rotations about fixed axes x, y and z, in this order; `None` if there is none.
    pub(super) rpy: Option<String>,
}

/// The placement of some steps.
pub(super) fn placed(steps: &[Step]) -> Placed {
    let (position, angles) = as_written(steps).unwrap_or_else(|| of_pose(&pose(steps)));
    let is_zero = |numbers: &[Number; 3]| numbers.iter().all(|number| number.value == 0.0);
    let angles = Some(angles).filter(|angles| !is_zero(angles));
    Placed {
        xyz: Some(position)
            .filter(|position| !is_zero(position))
            .map(|position| numbers::texts(&position)),
        rpy: angles.map(|angles| angles.each_ref().map(numbers::angle).join(" ")),
    }
}

/// The pose of some steps, with right angles and zeros as they are understood.
pub(super) fn pose(steps: &[Step]) -> Pose {
    let understood: Vec<Step> = steps.iter().map(understood).collect();
    Pose::of(&understood)
}

/// Translation and angles, if the steps are a translation followed by rotations about z, y and x.
fn as_written(steps: &[Step]) -> Option<([Number; 3], [Number; 3])> {
    let mut position = [Number::default(); 3];
    let mut angles = [Number::default(); 3];
    let mut before = 0;
    for step in steps {
        let (order, axis) = match step {
            Step::Translate(offset) if before == 0 => {
                position = *offset;
                (1, None)
            }
            Step::Rotate(Axis::Z, angle) => (2, Some((2, angle))),
            Step::Rotate(Axis::Y, angle) => (3, Some((1, angle))),
            Step::Rotate(Axis::X, angle) => (4, Some((0, angle))),
            Step::Translate(_) | Step::Quaternion(_) => return None,
        };
        if order <= before {
            return None;
        }
        if let Some((k, angle)) = axis {
            angles[k] = *angle;
        }
        before = order;
    }
    Some((position, angles))
}

/// Translation and angles of a pose.
fn of_pose(pose: &Pose) -> ([Number; 3], [Number; 3]) {
    let number = |value: Double| {
        let value = if value.is_zero() { Double::ZERO } else { value };
        computed(value, Place::Unknown)
    };
    let rotation: DoubleMatrix = pose
        .rotation
        .map(|row| row.map(|entry| if entry.is_zero() { Double::ZERO } else { entry }));
    let angles = axis_rotation::of_numbers(&rotation);
    (pose.position.map(number), angles.map(Number::from))
}

/// A step with right angles and residues as the chain understands them.
fn understood(step: &Step) -> Step {
    match step {
        Step::Translate(offset) => Step::Translate(offset.map(without_residue)),
        Step::Rotate(axis, written) => match angle::quarters(written) {
            Some(quarters) => quarter_turns(*axis, quarters),
            None => *step,
        },
        Step::Quaternion(entries) => {
            let right = angle::right_angles(entries).or_else(|| angle::exact_right_angles(entries));
            if let Some(squares) = right {
                // The entries of such a quaternion have one magnitude, or are zero.
                return Step::Quaternion(squares.map(|square| of_sign(square.signum())));
            }
            let is_large = entries.iter().any(|entry| entry.value.abs() >= 0.5);
            Step::Quaternion(if is_large {
                entries.map(without_residue)
            } else {
                *entries
            })
        }
    }
}

fn without_residue(number: Number) -> Number {
    if angle::is_residue(&number) {
        Number::default()
    } else {
        number
    }
}

/// Rotation by quarter turns, as a quaternion of whole numbers.
fn quarter_turns(axis: Axis, quarters: i64) -> Step {
    let (sine, cosine) = match quarters.rem_euclid(4) {
        0 => (0, 1),
        1 => (1, 1),
        2 => (1, 0),
        _ => (-1, 1),
    };
    let [mut x, mut y, mut z] = [of_sign(0); 3];
    match axis {
        Axis::X => x = of_sign(sine),
        Axis::Y => y = of_sign(sine),
        Axis::Z => z = of_sign(sine),
    }
    Step::Quaternion([x, y, z, of_sign(cosine)])
}

/// −1, 0 or 1.
fn of_sign(sign: i64) -> Number {
    match sign {
        0 => Number::default(),
        1.. => Number::from(1.0),
        ..0 => Number::from(-1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(value: f64, resolution: f64) -> Number {
        Number {
            value,
            resolution,
            ..Number::default()
        }
    }

    #[test]
    fn roll_pitch_and_yaw_keep_their_digits() {
        let steps = [
            Step::Translate([written(0.1, 0.1), written(0.0, 1.0), written(-0.25, 0.01)]),
            Step::Rotate(Axis::Z, written(1.2345, 1e-4)),
            Step::Rotate(Axis::Y, written(0.0, 1.0)),
            Step::Rotate(Axis::X, written(-0.3, 0.1)),
        ];
        let Placed { xyz, rpy } = placed(&steps);
        assert_eq!(xyz.as_deref(), Some("0.1 0 -0.25"));
        assert_eq!(rpy.as_deref(), Some("-0.3 0 1.2345"));
    }

    #[test]
    fn quaternions_of_right_angles_become_right_angles() {
        let entries = [0.707, 0.0, 0.0, 0.707].map(|entry| written(entry, 1e-3));
        let about_x = Step::Quaternion(entries);
        assert_eq!(
            placed(&[about_x]).rpy.as_deref(),
            Some("1.5707963267948966 0 0")
        );
        let twice = placed(&[about_x, about_x]);
        assert_eq!(twice.rpy.as_deref(), Some("3.141592653589793 0 0"));
        let back = [-0.707, 0.0, 0.0, 0.707].map(|entry| written(entry, 1e-3));
        assert!(placed(&[about_x, Step::Quaternion(back)]).rpy.is_none());
    }

    #[test]
    fn any_order_of_steps_gives_the_same_pose() {
        let steps = [
            Step::Rotate(Axis::X, written(0.7, 0.1)),
            Step::Translate([written(0.1, 0.1), written(0.2, 0.1), written(0.3, 0.1)]),
            Step::Rotate(Axis::Y, written(-1.2, 0.1)),
            Step::Rotate(Axis::X, written(2.5, 0.1)),
        ];
        let (position, [roll, pitch, yaw]) = of_pose(&pose(&steps));
        let again = pose(&[
            Step::Translate(position),
            Step::Rotate(Axis::Z, yaw),
            Step::Rotate(Axis::Y, pitch),
            Step::Rotate(Axis::X, roll),
        ]);
        let before = pose(&steps);
        let pairs = again
            .rotation
            .iter()
            .flatten()
            .zip(before.rotation.iter().flatten());
        for (a, b) in pairs.chain(again.position.iter().zip(&before.position)) {
            assert!((*a - *b).to_f64().abs() < 4e-16);
        }
    }
}

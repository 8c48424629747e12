//! Roll, pitch and yaw of a rotation.
//!
//! In: a rotation matrix of numbers. Out: the angles with Rz(yaw) Ry(pitch) Rx(roll) equal to it.

use crate::expression::{Double, Term};
use crate::matrix::Rotation;

/// Cosine of the pitch below which roll and yaw are about one axis; the yaw is zero then. The error of doing so is as
/// large as that of the angles of a smaller cosine.
const LOCKED: f64 = 1e-16;

/// The angles \[rad\]; entries that are known at run time only count as zero.
pub(super) fn roll_pitch_yaw(rotation: &Rotation<Term<'_>>) -> [f64; 3] {
    let known = |entry: Term<'_>| entry.value().unwrap_or(Double::ZERO);
    of_numbers(&rotation.0.map(|row| row.map(known)))
}

/// The angles \[rad\] of a matrix of numbers.
pub(crate) fn of_numbers(rotation: &[[Double; 3]; 3]) -> [f64; 3] {
    let entry = |row: usize, column: usize| rotation[row][column];
    let (y, z) = (entry(2, 1), entry(2, 2));
    let cosine = (y * y + z * z).sqrt();
    let pitch = angle(-entry(2, 0), cosine);
    if cosine.to_f64() < LOCKED {
        [angle(-entry(1, 2), entry(1, 1)), pitch, 0.0]
    } else {
        [angle(y, z), pitch, angle(entry(1, 0), entry(0, 0))]
    }
}

/// The angle with that sine and cosine, or multiples of both: the result of the platform's library and one Newton step,
/// after which it is the same on all platforms.
fn angle(sine: Double, cosine: Double) -> f64 {
    let found = sine.to_f64().atan2(cosine.to_f64());
    let (s, c) = Double::from(found).sin_cos();
    let length = (sine * sine + cosine * cosine).sqrt();
    let off = (sine * c - cosine * s) / length;
    if off.is_known() {
        (Double::from(found) + off).to_f64()
    } else {
        found
    }
}

#[cfg(test)]
mod tests {
    use super::roll_pitch_yaw;
    use crate::expression::Graph;
    use crate::matrix::Rotation;

    #[test]
    fn angles_give_the_rotation_that_they_are_found_from() {
        let quarter = std::f64::consts::FRAC_PI_2;
        for angles in [
            [0.0, 0.0, 0.0],
            [0.3, -0.2, 0.5],
            [-3.0, 1.4, 2.5],
            [quarter, 0.0, -quarter],
            [0.7, quarter, 0.0],
            [-0.7, -quarter, 0.0],
        ] {
            let graph = Graph::new();
            let [roll, pitch, yaw] = angles.map(|angle| graph.constant(angle).sin_cos());
            let turn = Rotation::about_z(yaw) * Rotation::about_y(pitch) * Rotation::about_x(roll);
            let found = roll_pitch_yaw(&turn);
            for (found, angle) in found.iter().zip(angles) {
                assert!((found - angle).abs() < 1e-15, "{found} for {angles:?}");
            }
        }
    }
}

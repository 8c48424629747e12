//! Roll, pitch and yaw of a turn.
//!
//! In: a rotation matrix of numbers. Out: the angles of Rz(yaw) Ry(pitch) Rx(roll) that gives it. It never
//! looks at who asks.

use crate::expression::{Double, Term};
use crate::matrix::Rotation;

/// Below this cosine of the pitch, roll and yaw turn about one axis, and all of it is roll.
const LOCKED: f64 = 1e-9;

/// The angles \[rad\]; zero of what is known at run time only.
pub(super) fn roll_pitch_yaw(rotation: &Rotation<Term<'_>>) -> [f64; 3] {
    let entry = |row: usize, column: usize| rotation.0[row][column].value().unwrap_or(Double::ZERO);
    let (y, z) = (entry(2, 1), entry(2, 2));
    let cosine = (y * y + z * z).sqrt();
    let pitch = angle(-entry(2, 0), cosine);
    if cosine.to_f64() < LOCKED {
        [angle(-entry(1, 2), entry(1, 1)), pitch, 0.0]
    } else {
        [angle(y, z), pitch, angle(entry(1, 0), entry(0, 0))]
    }
}

/// The angle of that sine and cosine, or of multiples of both: what the platform has for it, and a step of
/// Newton's, after which it is the same on all of them.
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
    fn angles_give_the_turn_that_they_are_found_from() {
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

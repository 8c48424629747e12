//! Jacobians and their rates.
//!
//! In: a robot in matrices, its positions and motion. Out: columns, entry by entry.

use super::motion::{JointScrew, Motion, Positions};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// The columns M L₍₀₎ M⁻¹; zero for velocities that do not move the frame.
pub(super) fn jacobian(
    robot: &Robot,
    positions: &Positions,
    frame: Option<usize>,
    m: &Matrix,
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for JointScrew { body, velocity, l } in &positions.screws {
        if moves(*body) {
            columns[*velocity] = &columns[*velocity] + &(&(m * l) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}

/// The rates of the columns M L₍₀₎ M⁻¹ of a frame with pose M and velocity W: M (V L − L V) M⁻¹, where V is the
/// velocity of the body less W; zero for velocities that do not move the frame.
pub(super) fn jacobian_rate(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
    frame: Option<usize>,
    (m, w): (&Matrix, &Matrix),
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for JointScrew { body, velocity, l } in &positions.screws {
        if moves(*body) {
            let v = &motion.w[*body] - w;
            let rate = &(&v * l) - &(l * &v);
            columns[*velocity] = &columns[*velocity] + &(&(m * &rate) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}

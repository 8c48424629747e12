//! Jacobians and their rates, as the screws of velocities seen from a frame.
//!
//! In: a robot in matrices, where it is and how it moves. Out: columns, entry by entry.

use super::motion::{Freedom, Motion, Positions};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// The columns M L₍₀₎ M⁻¹; null for the velocities that do not move the frame.
pub(super) fn jacobian(
    robot: &Robot,
    positions: &Positions,
    frame: Option<usize>,
    m: &Matrix,
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for Freedom { body, velocity, l } in &positions.freedoms {
        if moves(*body) {
            columns[*velocity] = &columns[*velocity] + &(&(m * l) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}

/// The rates of the columns M L₍₀₎ M⁻¹, of a frame that moves by M and W: M (V L − L V) M⁻¹ where V is the
/// velocity of the body less W; null for the velocities that do not move the frame.
pub(super) fn jacobian_rate(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
    frame: Option<usize>,
    (m, w): (&Matrix, &Matrix),
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for Freedom { body, velocity, l } in &positions.freedoms {
        if moves(*body) {
            let v = &motion.w[*body] - w;
            let rate = &(&v * l) - &(l * &v);
            columns[*velocity] = &columns[*velocity] + &(&(m * &rate) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}

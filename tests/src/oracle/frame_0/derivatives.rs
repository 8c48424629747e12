//! Derivatives of torques by differences, at 256 bits, and the Coriolis matrix by its definition.
//!
//! In: a robot in matrices and its state. Out: matrices, row by row, a row a force. No formula for a derivative
//! is known: of q all that a joint carries is moved along its screw, by so little that as many digits are lost
//! to the step as to rounding, which leaves some 48; of q̇, in which torques are of the second degree but for the
//! sign that Coulomb friction has, differences are exact.

use super::motion::{Freedom, Motion, Positions};
use super::torques::{carried, outside, pseudo_product, torques};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::exponential;
use crate::oracle::robot::Robot;

/// 2⁻⁸⁴.
const STEP: f64 = 5.169_878_828_456_423e-26;

/// ∂τ/∂q and ∂τ/∂q̇ under actions from outside.
pub(super) fn of_torques(
    robot: &Robot,
    positions: &Positions,
    motion: [&[Big]; 2],
    actions: &[f64],
) -> [Vec<Big>; 2] {
    [
        by_coordinate(robot, positions, motion, actions),
        by_rate(robot, positions, motion),
    ]
}

/// ∂τ/∂q under actions from outside.
pub(super) fn by_coordinate(
    robot: &Robot,
    positions: &Positions,
    [qd, qdd]: [&[Big]; 2],
    actions: &[f64],
) -> Vec<Big> {
    by_columns(robot, positions, |freedom| {
        let [more, less] = [STEP, -STEP].map(|step| {
            let along = exponential(&freedom.l, &Big::new(step));
            let moved = displaced(robot, positions, freedom.body, &along);
            let torques = torques(robot, &moved, &Motion::at(robot, &moved, qd, qdd));
            let both = torques.into_iter().zip(outside(robot, &moved, actions));
            both.map(|(torque, outside)| torque - outside)
                .collect::<Vec<Big>>()
        });
        let pairs = more.into_iter().zip(less);
        pairs.map(|(x, y)| (x - y) / Big::new(2.0 * STEP)).collect()
    })
}

/// Where all is after a displacement of what a body carries.
fn displaced(robot: &Robot, positions: &Positions, joint: usize, by: &Matrix) -> Positions {
    let (back, transposed) = (by.inverse(), by.transposed());
    let is_carried = |body: usize| robot.upwards(Some(body)).any(|inner| inner == joint);
    let each = |of: &[Matrix], moved: &dyn Fn(&Matrix) -> Matrix| {
        let bodies = of.iter().enumerate();
        let bodies = bodies.map(|(body, matrix)| {
            if is_carried(body) {
                moved(matrix)
            } else {
                matrix.clone()
            }
        });
        bodies.collect()
    };
    let freedoms = positions.freedoms.iter().map(|freedom| Freedom {
        l: if is_carried(freedom.body) {
            &(by * &freedom.l) * &back
        } else {
            freedom.l.clone()
        },
        ..*freedom
    });
    Positions {
        m: each(&positions.m, &|m| by * m),
        j: each(&positions.j, &|j| &(by * j) * &transposed),
        freedoms: freedoms.collect(),
    }
}

/// ∂τ/∂q̇.
fn by_rate(robot: &Robot, positions: &Positions, [qd, qdd]: [&[Big]; 2]) -> Vec<Big> {
    let count = qd.len();
    let columns = (0..count).map(|m| -> Vec<Big> {
        let [more, less] = [1.0, -1.0].map(|step| {
            let mut qd = qd.to_vec();
            qd[m] = &qd[m] + Big::new(step);
            let mut motion = Motion::at(robot, positions, &qd, qdd);
            motion.driven.fill(Big::zero());
            for drive in &robot.drives {
                let taken = &mut motion.driven[drive.velocity];
                *taken = &*taken + drive.takes_smoothly(&qd, qdd);
            }
            torques(robot, positions, &motion)
        });
        let pairs = more.into_iter().zip(less);
        pairs.map(|(x, y)| (x - y) * Big::new(0.5)).collect()
    });
    let columns: Vec<Vec<Big>> = columns.collect();
    let rows = (0..count).flat_map(|row| columns.iter().map(move |column| column[row].clone()));
    rows.collect()
}

/// C: what the joints feel of Σ (L̇ₘ + Lₘ W) q̇ₘ, which is H at q̈ = 0, for each q̇ₘ.
pub(super) fn coriolis(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    by_columns(robot, positions, |along| {
        let (l, w) = (&along.l, &motion.w[along.body]);
        let rate = &(w * l) - &(l * w);
        let actions = (0..robot.bodies.len()).map(|body| {
            if !robot.upwards(Some(body)).any(|inner| inner == along.body) {
                return Matrix::zero();
            }
            let moved = &(&rate + &(l * &motion.w[body])) * &positions.j[body];
            &moved - &moved.transposed()
        });
        let actions = carried(robot, actions.collect());
        let mut felt = vec![Big::zero(); robot.velocities()];
        for Freedom { body, velocity, l } in &positions.freedoms {
            felt[*velocity] = &felt[*velocity] + pseudo_product(l, &actions[*body]);
        }
        felt
    })
}

/// A square matrix, row by row, by its columns, each the sum of those of all that a velocity moves.
fn by_columns(
    robot: &Robot,
    positions: &Positions,
    column: impl Fn(&Freedom) -> Vec<Big>,
) -> Vec<Big> {
    let count = robot.velocities();
    let mut matrix = vec![Big::zero(); count * count];
    for freedom in &positions.freedoms {
        for (row, entry) in column(freedom).into_iter().enumerate() {
            let sum = &mut matrix[row * count + freedom.velocity];
            *sum = &*sum + entry;
        }
    }
    matrix
}

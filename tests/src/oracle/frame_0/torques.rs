//! Torques by Newton–Euler, and the mass matrix by Lagrange.
//!
//! In: a robot in matrices, its positions and motion, external wrenches. Out: sums of L ⊗ Φ and of Tr(L J Lᵗ).

use super::motion::{JointScrew, Motion, Positions};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// τ = Σ L ⊗ Σ Φ over the screws of a velocity and the bodies that each carries (Newton–Euler), plus armature, damping
/// and friction.
pub(super) fn torques(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let actions = carried(robot, actions(robot, positions, motion).collect());
    let mut torques = motion.actuator_torques.clone();
    for JointScrew { body, velocity, l } in &positions.screws {
        let torque = pseudo_product(l, &actions[*body]);
        torques[*velocity] = &torques[*velocity] + torque;
    }
    torques
}

/// Σ L ⊗ Φ of external wrenches over the screws of a velocity that carry the link on which the wrench acts.
pub(super) fn external(robot: &Robot, positions: &Positions, actions: &[f64]) -> Vec<Big> {
    let mut torques = vec![Big::zero(); robot.velocities()];
    let (bodies, in_frame_0) = &robot.external;
    for (&link, entries) in bodies.iter().zip(actions.chunks(6)) {
        let [c, f] = [0, 3].map(|first| [0, 1, 2].map(|k| Big::new(entries[first + k])));
        let mut phi = Matrix::screw(&c, &f);
        for (entry, of_force) in phi.0[3].iter_mut().zip(&f) {
            *entry = -of_force;
        }
        if !in_frame_0 {
            let m = &positions.m[link];
            phi = &(m * &phi) * &m.transposed();
        }
        for JointScrew { body, velocity, l } in &positions.screws {
            if robot.upwards(Some(link)).any(|carrier| carrier == *body) {
                let torque = pseudo_product(l, &phi);
                torques[*velocity] = &torques[*velocity] + torque;
            }
        }
    }
    torques
}

/// M\[i\]\[m\] = Σ Tr(Lᵢ Σ J Lₘᵗ) over the screws of both velocities, and over the bodies that both screws carry
/// (Lagrange).
pub(super) fn mass_matrix(robot: &Robot, positions: &Positions) -> Vec<Vec<Big>> {
    let inertias = carried(robot, positions.j.clone());
    let carries = |outer: usize, inner: usize| robot.upwards(Some(outer)).any(|body| body == inner);
    let count = robot.velocities();
    let mut rows = vec![vec![Big::zero(); count]; count];
    for one in &positions.screws {
        for other in &positions.screws {
            let outermost = if carries(one.body, other.body) {
                one.body
            } else if carries(other.body, one.body) {
                other.body
            } else {
                continue;
            };
            let product = &one.l * &inertias[outermost];
            let entry = (&product * &other.l.transposed()).trace();
            let sum = &mut rows[one.velocity][other.velocity];
            *sum = &*sum + entry;
        }
    }
    for actuator in &robot.actuators {
        let entry = &mut rows[actuator.velocity][actuator.velocity];
        *entry = &*entry + actuator.armature();
    }
    rows
}

/// Each body's matrix, plus those of all bodies that it carries.
pub(super) fn carried(robot: &Robot, mut each: Vec<Matrix>) -> Vec<Matrix> {
    for (index, body) in robot.bodies.iter().enumerate().rev() {
        if let Some(parent) = body.parent {
            each[parent] = &each[parent] + &each[index];
        }
    }
    each
}

/// Φ = skew[(H − H_g) J] of each body.
pub(super) fn actions(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
) -> impl Iterator<Item = Matrix> {
    motion.h.iter().zip(&positions.j).map(|(h, j)| {
        let moved = &(h - &robot.gravity) * j;
        &moved - &moved.transposed()
    })
}

/// L ⊗ Φ = u · c + b · f.
pub(super) fn pseudo_product(l: &Matrix, phi: &Matrix) -> Big {
    let dot = |x: [Big; 3], y: [Big; 3]| {
        let pairs = x.into_iter().zip(y);
        pairs.fold(Big::zero(), |sum, (x, y)| sum + x * y)
    };
    dot(l.vector(), phi.vector()) + dot(l.column(), phi.column())
}

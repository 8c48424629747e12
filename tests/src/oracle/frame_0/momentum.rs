//! Total mass, centre of mass, and momentum.
//!
//! In: a robot in matrices, its positions and motion. Out: sums over the bodies that joints move.

use super::motion::{Motion, Positions};
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// The bodies that joints move; others are not part of the robot's mass.
pub(super) fn moved(robot: &Robot) -> impl Iterator<Item = usize> {
    let mut moves: Vec<bool> = Vec::new();
    for body in &robot.bodies {
        let carried = body.parent.is_some_and(|parent| moves[parent]);
        moves.push(carried || body.motion.moves());
    }
    let bodies = moves.into_iter().enumerate();
    bodies.filter_map(|(body, moves)| moves.then_some(body))
}

/// The mass of all bodies that joints move \[kg\].
#[must_use]
pub fn mass(robot: &Robot) -> f64 {
    let masses = moved(robot).map(|body| robot.bodies[body].inertia.0[3][3].to_f64());
    masses.sum()
}

/// Σ J over the bodies that joints move.
fn inertia(robot: &Robot, positions: &Positions) -> Matrix {
    moved(robot).fold(Matrix::zero(), |sum, body| &sum + &positions.j[body])
}

/// Σ X J over the bodies that joints move, where X is W or H of each body.
pub(super) fn moments(robot: &Robot, positions: &Positions, of: &[Matrix]) -> Matrix {
    moved(robot).fold(Matrix::zero(), |sum, body| {
        &sum + &(&of[body] * &positions.j[body])
    })
}

/// The centre of mass: the last column of Σ J has the first moments and the mass.
pub(super) fn mass_center(robot: &Robot, positions: &Positions) -> [Big; 3] {
    let inertia = inertia(robot, positions);
    inertia.column().map(|moment| moment / &inertia.0[3][3])
}

/// The velocity of the centre of mass, from Σ W J.
pub(super) fn by_mass(robot: &Robot, positions: &Positions, moments: &Matrix) -> Vec<Big> {
    let mass = &inertia(robot, positions).0[3][3];
    let column = moments.column();
    column.map(|momentum| momentum / mass).to_vec()
}

/// skew\[X\] with the centre of mass as reference point.
pub(super) fn about_mass_center(
    robot: &Robot,
    positions: &Positions,
    moments: &Matrix,
) -> Vec<Big> {
    let skew = moments - &moments.transposed();
    let back = Matrix::translation(&mass_center(robot, positions).map(|entry| -entry));
    let seen = &(&back * &skew) * &back.transposed();
    [seen.vector(), seen.column()].concat()
}

/// The motions at unit velocity of each degree of freedom alone.
pub(super) fn unit_motions<'r>(
    robot: &'r Robot,
    positions: &'r Positions,
) -> impl Iterator<Item = Motion> + use<'r> {
    let rest = vec![Big::zero(); robot.velocities()];
    (0..robot.velocities()).map(move |k| {
        let mut unit = rest.clone();
        unit[k] = Big::one();
        Motion::at(robot, positions, &unit, &rest)
    })
}

//! The regressor Y of τ = Y π, and those of the energies.
//!
//! In: a robot in matrices and its motion. Out: Y, row by row.

use super::motion::{JointScrew, Motion, Positions};
use super::torques::pseudo_product;
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// Y of τ = Y π, row by row. Each link that a joint moves has ten columns: the torques of Φ = skew[(H − H_g) J] for a J
/// that is 1 at one entry and its mirror image.
pub(super) fn regressor(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let units = units();
    let links = (0..robot.bodies.len()).filter(|&body| robot.bodies[body].link);
    let columns = links.flat_map(|body| {
        let h = &motion.h[body] - &robot.gravity;
        let m = &positions.m[body];
        units.iter().map(move |unit| {
            let j = &(m * unit) * &m.transposed();
            let moved = &h * &j;
            (body, &moved - &moved.transposed())
        })
    });
    let columns: Vec<(usize, Matrix)> = columns.collect();
    let row = |velocity: usize| {
        let screws = positions
            .screws
            .iter()
            .filter(move |one| one.velocity == velocity);
        let screws: Vec<&JointScrew> = screws.collect();
        let entries = columns.iter().map(|(body, action)| {
            let carries = |one: &&&JointScrew| {
                robot
                    .upwards(Some(*body))
                    .any(|carrier| carrier == one.body)
            };
            let carriers = screws.iter().filter(carries);
            carriers.fold(Big::zero(), |sum, one| sum + pseudo_product(&one.l, action))
        });
        entries.collect::<Vec<Big>>()
    };
    (0..robot.velocities()).flat_map(row).collect()
}

/// A J for each parameter that is 1 at one entry and its mirror image.
fn units() -> Vec<Matrix> {
    let first = [(3, 3), (0, 3), (1, 3), (2, 3)];
    let second = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let units = first.into_iter().chain(second).map(|(row, column)| {
        let is = |i, j| (i, j) == (row, column) || (j, i) == (row, column);
        Matrix::of(|i, j| Big::new(f64::from(u8::from(is(i, j)))))
    });
    units.collect()
}

/// A number for each parameter of the links: a function of a link and of J at unit value of the parameter.
fn of_each(robot: &Robot, positions: &Positions, of: impl Fn(usize, &Matrix) -> Big) -> Vec<Big> {
    let units = units();
    let links = (0..robot.bodies.len()).filter(|&body| robot.bodies[body].link);
    let numbers = links.flat_map(|body| {
        let m = &positions.m[body];
        let inertias = units.iter().map(|unit| &(m * unit) * &m.transposed());
        inertias.map(|j| of(body, &j)).collect::<Vec<Big>>()
    });
    numbers.collect()
}

/// The row y of T = y π.
pub(super) fn kinetic_energy_regressor(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
    qd: &[Big],
) -> Vec<Big> {
    let half = Big::new(0.5);
    let mut energies = of_each(robot, positions, |body, j| {
        let w = &motion.w[body];
        (&(w * j) * &w.transposed()).trace() * &half
    });
    if robot.identifies_actuators {
        for actuator in &robot.actuators {
            let rate = actuator.rate(qd);
            energies.extend([&rate * &rate * &half, Big::zero(), Big::zero()]);
        }
    }
    energies
}

/// The row y of U = y π.
pub(super) fn potential_energy_regressor(robot: &Robot, positions: &Positions) -> Vec<Big> {
    let mut energies = of_each(robot, positions, |_, j| -(&robot.gravity * j).trace());
    if robot.identifies_actuators {
        energies.resize(energies.len() + 3 * robot.actuators.len(), Big::zero());
    }
    energies
}

/// Rows of a regressor, with three more columns for each velocity of a joint if actuator parameters are identified.
pub(super) fn with_columns_of_actuators(
    robot: &Robot,
    of_links: Vec<Big>,
    [qd, qdd]: [&[Big]; 2],
) -> Vec<Big> {
    if !robot.identifies_actuators {
        return of_links;
    }
    let columns = robot.actuators.iter().flat_map(|actuator| {
        let columns = actuator.columns(qd, qdd).into_iter();
        columns.map(|column| (actuator.velocity, column))
    });
    let columns: Vec<(usize, Big)> = columns.collect();
    let rows = of_links
        .chunks(of_links.len() / qd.len().max(1))
        .enumerate();
    let rows = rows.flat_map(|(row, of_links)| {
        let of_actuators = columns.iter().map(move |(velocity, column)| {
            if *velocity == row {
                column.clone()
            } else {
                Big::zero()
            }
        });
        of_links.iter().cloned().chain(of_actuators)
    });
    rows.collect()
}

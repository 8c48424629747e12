//! Derivatives of torques by central differences in 256 bits, and the Coriolis matrix by its definition.
//!
//! In: a robot in matrices and its state. Out: matrices, row by row, a row for each torque. By q: all that a joint
//! carries is displaced along its screw by 2⁻⁸⁴, where truncation and rounding errors are equal and some 48 decimal
//! digits remain. By q̇: differences are exact, since torques are quadratic in q̇ but for the sign in Coulomb friction.

use homogen_codegen::space::Variable;

use super::motion::{JointScrew, Motion, Positions};
use super::product;
use super::torques::{carried, external, mass_matrix, pseudo_product, torques};
use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::exponential;
use crate::oracle::robot::Robot;
use crate::oracle::solve::solve;

/// 2⁻⁸⁴.
const STEP: f64 = 5.169_878_828_456_423e-26;

/// 2⁻⁴², for differences of first derivatives: some 25 decimal digits remain.
const LONG_STEP: f64 = 2.273_736_754_432_320_6e-13;

/// The gradient of λᵀτ by q, q̇ and q̈ under external wrenches.
pub(super) fn torque_gradient(
    robot: &Robot,
    positions: &Positions,
    [qd, qdd, lambda]: [&[Big]; 3],
    actions: &[f64],
) -> [Vec<Big>; 3] {
    let [by_q, by_qd] = of_torques(robot, positions, [qd, qdd], actions);
    let inertias = mass_matrix(robot, positions).concat();
    [by_q, by_qd, inertias].map(|matrix| contracted(&matrix, lambda))
}

/// The gradient of λᵀq̈ by q, q̇ and τ: with y = M⁻¹ λ, that of −yᵀτ by q and q̇ at constant q̈, and y.
pub(super) fn acceleration_gradient(
    robot: &Robot,
    positions: &Positions,
    [qd, tau, lambda]: [&[Big]; 3],
    actions: &[f64],
) -> [Vec<Big>; 3] {
    let rest = vec![Big::zero(); qd.len()];
    let bias = torques(robot, positions, &Motion::at(robot, positions, qd, &rest));
    let external = external(robot, positions, actions);
    let net = tau.iter().zip(bias).zip(external);
    let net = net.map(|((tau, bias), external)| tau - (bias - external));
    let right = net
        .zip(lambda)
        .map(|(net, lambda)| vec![net, lambda.clone()]);
    let found = solve(mass_matrix(robot, positions), right.collect());
    let column = |k: usize| -> Vec<Big> { found.iter().map(|row| row[k].clone()).collect() };
    let [qdd, y] = [0, 1].map(column);
    let [by_q, by_qd] = of_torques(robot, positions, [qd, &qdd], actions);
    let [by_q, by_qd] = [by_q, by_qd].map(|matrix| {
        let products = contracted(&matrix, &y);
        products.iter().map(|entry| -entry).collect()
    });
    [by_q, by_qd, y]
}

/// (∂τ/∂q) δq + (∂τ/∂q̇) δq̇ under external wrenches.
pub(super) fn torque_change(
    robot: &Robot,
    positions: &Positions,
    motion: [&[Big]; 2],
    arguments: &Arguments,
) -> Vec<Big> {
    let matrices = of_torques(robot, positions, motion, &arguments[Variable::Actions]);
    let changes = [Variable::QChange, Variable::QdChange].map(|of| &arguments[of]);
    let parts = [0, 1].map(|k| product(&matrices[k], changes[k]));
    parts[0].iter().zip(&parts[1]).map(|(a, b)| a + b).collect()
}

/// The derivatives of a gradient along a direction: of all its parts along a change of q, and of the second along one
/// of q̇. The gradient is a function of positions and q̇.
pub(super) fn along(
    robot: &Robot,
    positions: &Positions,
    (qd, direction): (&[Big], &[f64]),
    gradient: impl Fn(&Positions, &[Big]) -> [Vec<Big>; 3],
) -> Vec<Big> {
    let [more, less] = [LONG_STEP, -LONG_STEP].map(|step| {
        let mut moved = positions.clone();
        for k in 0..positions.screws.len() {
            let screw = &moved.screws[k];
            let along = exponential(&screw.l, &Big::new(step * direction[screw.velocity]));
            moved = displaced(robot, &moved, screw.body, &along);
        }
        gradient(&moved, qd)
    });
    let [faster, slower] = [1.0, -1.0].map(|step| {
        let changed = qd.iter().zip(direction);
        let changed = changed.map(|(rate, along)| rate + Big::new(step * along));
        let [_, by_qd, _] = gradient(positions, &changed.collect::<Vec<Big>>());
        by_qd
    });
    let difference = |more: &[Big], less: &[Big], step: f64| -> Vec<Big> {
        let pairs = more.iter().zip(less);
        pairs.map(|(x, y)| (x - y) / Big::new(2.0 * step)).collect()
    };
    let block = |k: usize| difference(&more[k], &less[k], LONG_STEP);
    [
        block(0),
        block(1),
        difference(&faster, &slower, 1.0),
        block(2),
    ]
    .concat()
}

/// λᵀ A.
pub(super) fn contracted(matrix: &[Big], lambda: &[Big]) -> Vec<Big> {
    let column = |column: usize| {
        let entries = matrix[column..].iter().step_by(lambda.len());
        let terms = entries.zip(lambda).map(|(entry, weight)| entry * weight);
        terms.fold(Big::zero(), |sum, term| sum + term)
    };
    (0..lambda.len()).map(column).collect()
}

/// ∂τ/∂q and ∂τ/∂q̇ under external wrenches.
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

/// ∂τ/∂q under external wrenches.
pub(super) fn by_coordinate(
    robot: &Robot,
    positions: &Positions,
    [qd, qdd]: [&[Big]; 2],
    actions: &[f64],
) -> Vec<Big> {
    by_columns(robot, positions, |screw| {
        let [more, less] = [STEP, -STEP].map(|step| {
            let along = exponential(&screw.l, &Big::new(step));
            let moved = displaced(robot, positions, screw.body, &along);
            let torques = torques(robot, &moved, &Motion::at(robot, &moved, qd, qdd));
            let both = torques.into_iter().zip(external(robot, &moved, actions));
            both.map(|(torque, external)| torque - external)
                .collect::<Vec<Big>>()
        });
        let pairs = more.into_iter().zip(less);
        pairs.map(|(x, y)| (x - y) / Big::new(2.0 * STEP)).collect()
    })
}

/// The positions after a displacement of all that a joint carries.
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
    let screws = positions.screws.iter().map(|screw| JointScrew {
        l: if is_carried(screw.body) {
            &(by * &screw.l) * &back
        } else {
            screw.l.clone()
        },
        ..*screw
    });
    Positions {
        m: each(&positions.m, &|m| by * m),
        j: each(&positions.j, &|j| &(by * j) * &transposed),
        screws: screws.collect(),
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
            motion.actuator_torques.fill(Big::zero());
            for actuator in &robot.actuators {
                let sum = &mut motion.actuator_torques[actuator.velocity];
                *sum = &*sum + actuator.smooth_torque(&qd, qdd);
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

/// C: column m has the torques of Σ (L̇ₘ + Lₘ W), the factor of q̇ₘ in H at q̈ = 0.
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
        let mut column = vec![Big::zero(); robot.velocities()];
        for JointScrew { body, velocity, l } in &positions.screws {
            column[*velocity] = &column[*velocity] + pseudo_product(l, &actions[*body]);
        }
        column
    })
}

/// A square matrix, row by row, from its columns; the column of a velocity is the sum of those of its screws.
fn by_columns(
    robot: &Robot,
    positions: &Positions,
    column: impl Fn(&JointScrew) -> Vec<Big>,
) -> Vec<Big> {
    let count = robot.velocities();
    let mut matrix = vec![Big::zero(); count * count];
    for screw in &positions.screws {
        for (row, entry) in column(screw).into_iter().enumerate() {
            let sum = &mut matrix[row * count + screw.velocity];
            *sum = &*sum + entry;
        }
    }
    matrix
}

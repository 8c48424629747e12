//! True values by the definitions of Part II of the paper: dense 4×4 matrices in frame 0, in 256 bits.
//!
//! In: a robot in matrices and the arguments, whose quaternions are normalised. Out: the function's true value. No
//! structure of a matrix is used, so it is slow (about 1 ms per joint).

mod closure;
mod derivatives;
mod jacobian;
mod momentum;
mod motion;
mod regressor;
mod sizes;
mod torques;

use std::mem;

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use super::matrix::Matrix;
use super::robot::Robot;
use super::solve::solve;
use super::state::exact;
use crate::arguments::Arguments;
use crate::big::Big;
use jacobian::{jacobian, jacobian_rate};
pub use momentum::mass;
use momentum::{about_mass_center, by_mass, mass_center, moments, moved, unit_motions};
use motion::{Motion, Positions};
use regressor::{
    kinetic_energy_regressor, potential_energy_regressor, regressor, with_columns_of_actuators,
};
pub use sizes::torque_sizes;
use torques::{external, mass_matrix, torques};

/// The Hessians, of which [`hessian_along`] has the value along a direction.
pub const HESSIANS: [Function; 2] = [
    Function::InverseDynamicsHessian,
    Function::ForwardDynamicsHessian,
];

/// Every function with a true value here that takes milliseconds: all but the base regressor, whose columns the engine
/// selects, and the [`HESSIANS`].
pub fn functions() -> impl Iterator<Item = Function> {
    let all = Function::ALL.into_iter();
    all.filter(|function| *function != Function::BaseRegressor && !HESSIANS.contains(function))
}

/// The true value of a Hessian: for each of its matrices the sum of the rows, times the entries of a direction.
///
/// # Panics
/// If the function is none of the [`HESSIANS`], or the mass matrix is singular where it is inverted.
#[must_use]
pub fn hessian_along(
    robot: &Robot,
    function: Function,
    arguments: &Arguments,
    direction: &[f64],
) -> Vec<Big> {
    let mut state = exact(arguments, robot.quaternions());
    let mut taken = |variable| mem::take(&mut state[variable]);
    let [q, qd, weights] = [Variable::Q, Variable::Qd, Variable::Weights].map(&mut taken);
    let positions = Positions::at(robot, &q);
    let actions = &arguments[Variable::Actions];
    let (gradient, motion): (Gradient, Vec<Big>) = match function {
        Function::InverseDynamicsHessian => (derivatives::torque_gradient, taken(Variable::Qdd)),
        Function::ForwardDynamicsHessian => {
            (derivatives::acceleration_gradient, taken(Variable::Tau))
        }
        other => panic!("{} is no Hessian", other.name()),
    };
    derivatives::along(robot, &positions, (&qd, direction), |positions, qd| {
        gradient(robot, positions, [qd, &motion, &weights], actions)
    })
}

type Gradient = fn(&Robot, &Positions, [&[Big]; 3], &[f64]) -> [Vec<Big>; 3];

/// The product of a matrix, by rows, and a list of numbers.
fn product(matrix: &[Big], numbers: &[f64]) -> Vec<Big> {
    let row = |row: &[Big]| {
        let terms = row.iter().zip(numbers);
        terms.fold(Big::zero(), |sum, (entry, &number)| {
            sum + entry * Big::new(number)
        })
    };
    matrix.chunks(numbers.len().max(1)).map(row).collect()
}

/// The true value of a function; `frame` is the index of its frame, for functions of a frame.
///
/// # Panics
/// If there is no such frame, the mass matrix is singular where it is inverted, or the function has no true value
/// here.
#[must_use]
#[expect(
    clippy::too_many_lines,
    reason = "one arm for each function, which is its definition"
)]
pub fn evaluate(
    robot: &Robot,
    function: Function,
    frame: usize,
    arguments: &Arguments,
) -> Vec<Big> {
    let mut state = exact(arguments, robot.quaternions());
    let variables = [
        Variable::Q,
        Variable::Qd,
        Variable::Qdd,
        Variable::Tau,
        Variable::Weights,
    ];
    let [q, qd, qdd, tau, weights] = variables.map(|variable| mem::take(&mut state[variable]));
    let rest = vec![Big::zero(); robot.velocities()];
    let positions = Positions::at(robot, &q);
    let moving = |qd: &[Big], qdd: &[Big]| Motion::at(robot, &positions, qd, qdd);
    let bias = || torques(robot, &positions, &moving(&qd, &rest));
    let at = || robot.frames[frame];
    let less_external = |torques: Vec<Big>| {
        let external = external(robot, &positions, &arguments[Variable::Actions]);
        let both = torques.into_iter().zip(external);
        both.map(|(torque, external)| torque - external)
            .collect::<Vec<Big>>()
    };
    match function {
        Function::ForwardKinematics => positions.of_frame(at()).rows(),
        Function::FramePoses => {
            let frames = robot.frames.iter();
            frames
                .flat_map(|&frame| positions.of_frame(frame).rows())
                .collect()
        }
        Function::SpatialJacobian => jacobian(robot, &positions, at(), &Matrix::identity()),
        Function::BodyJacobian => {
            jacobian(robot, &positions, at(), &positions.of_frame(at()).inverse())
        }
        Function::GeometricJacobian => {
            let tip = positions.of_frame(at()).column().map(|entry| -entry);
            jacobian(robot, &positions, at(), &Matrix::translation(&tip))
        }
        Function::SpatialJacobianRate => {
            let motion = moving(&qd, &rest);
            let still = Matrix::zero();
            jacobian_rate(
                robot,
                &positions,
                &motion,
                at(),
                (&Matrix::identity(), &still),
            )
        }
        Function::BodyJacobianRate => {
            let motion = moving(&qd, &rest);
            let back = positions.of_frame(at()).inverse();
            jacobian_rate(
                robot,
                &positions,
                &motion,
                at(),
                (&back, &motion.w_of(at())),
            )
        }
        Function::GeometricJacobianRate => {
            let motion = moving(&qd, &rest);
            let tip = positions.of_frame(at()).column();
            let rate = (&motion.w_of(at()) * &Matrix::translation(&tip)).column();
            let of_origin = Matrix::screw(&[(); 3].map(|()| Big::zero()), &rate);
            let back = Matrix::translation(&tip.map(|entry| -entry));
            jacobian_rate(robot, &positions, &motion, at(), (&back, &of_origin))
        }
        Function::JacobianDerivative => {
            let tip = positions.of_frame(at()).column();
            let back = Matrix::translation(&tip.clone().map(|entry| -entry));
            unit_motions(robot, &positions)
                .flat_map(|motion| {
                    let rate = (&motion.w_of(at()) * &Matrix::translation(&tip)).column();
                    let of_origin = Matrix::screw(&[(); 3].map(|()| Big::zero()), &rate);
                    jacobian_rate(robot, &positions, &motion, at(), (&back, &of_origin))
                })
                .collect()
        }
        Function::ForwardKinematicsHessian => {
            let derivatives = evaluate(robot, Function::JacobianDerivative, frame, arguments);
            let (count, wrench) = (rest.len(), &arguments[Variable::Wrench]);
            let power = |row: usize, column: usize| {
                let terms = derivatives[6 * (count * column + row)..].iter().zip(wrench);
                terms.fold(Big::zero(), |sum, (rate, force)| {
                    sum + rate * Big::new(*force)
                })
            };
            let places = (0..count * count).map(|k| (k / count, k % count));
            places.map(|(row, column)| power(row, column)).collect()
        }
        Function::AccelerationBias => moving(&qd, &rest).h_of(at()).rows(),
        Function::TipVelocity => {
            let w = moving(&qd, &rest).w_of(at());
            [w.vector(), w.column()].concat()
        }
        Function::TipAcceleration => {
            let motion = moving(&qd, &qdd);
            motion.h_of(at()).rows()
        }
        Function::InverseDynamics => {
            let motion = moving(&qd, &qdd);
            less_external(torques(robot, &positions, &motion))
        }
        Function::Gravity => torques(robot, &positions, &moving(&rest, &rest)),
        Function::Bias => bias(),
        Function::MassMatrix => mass_matrix(robot, &positions).concat(),
        Function::ForwardDynamics => {
            let tau = tau.into_iter().zip(less_external(bias()));
            let net = tau.map(|(tau, bias)| vec![tau - bias]).collect();
            solve(mass_matrix(robot, &positions), net).concat()
        }
        Function::MassMatrixInverse => {
            let unit =
                |i: usize| (0..rest.len()).map(move |j| Big::new(f64::from(u8::from(i == j))));
            let identity = (0..rest.len()).map(|i| unit(i).collect()).collect();
            solve(mass_matrix(robot, &positions), identity).concat()
        }
        Function::KineticEnergy => {
            let motion = moving(&qd, &rest);
            let links = motion.w.iter().zip(&positions.j);
            let energies = links.map(|(w, j)| (&(w * j) * &w.transposed()).trace());
            let actuators = robot.actuators.iter();
            let actuators = actuators.map(|actuator| {
                let rate = &qd[actuator.velocity];
                actuator.armature() * rate * rate
            });
            let twice = energies.chain(actuators);
            vec![twice.fold(Big::zero(), |sum, energy| sum + energy) * Big::new(0.5)]
        }
        Function::PotentialEnergy => {
            let links = moved(robot).map(|body| &positions.j[body]);
            let energies = links.map(|j| (&robot.gravity * j).trace());
            vec![energies.fold(Big::zero(), |sum, energy| sum - energy)]
        }
        Function::Regressor => {
            let motion = moving(&qd, &qdd);
            let of_links = regressor(robot, &positions, &motion);
            with_columns_of_actuators(robot, of_links, [&qd, &qdd])
        }
        Function::KineticEnergyRegressor => {
            let motion = moving(&qd, &rest);
            kinetic_energy_regressor(robot, &positions, &motion, &qd)
        }
        Function::PotentialEnergyRegressor => potential_energy_regressor(robot, &positions),
        Function::ForwardDynamicsParameterDerivatives => {
            let qdd = evaluate(robot, Function::ForwardDynamics, frame, arguments);
            let of_links = regressor(robot, &positions, &moving(&qd, &qdd));
            let rows = with_columns_of_actuators(robot, of_links, [&qd, &qdd]);
            let rows = rows.chunks(rows.len() / qd.len().max(1));
            let right = rows.map(|row| row.iter().map(|entry| -entry).collect());
            solve(mass_matrix(robot, &positions), right.collect()).concat()
        }
        Function::CenterOfMass => mass_center(robot, &positions).to_vec(),
        Function::CenterOfMassVelocity => {
            let motion = moving(&qd, &rest);
            by_mass(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CenterOfMassJacobian => unit_motions(robot, &positions)
            .flat_map(|motion| by_mass(robot, &positions, &moments(robot, &positions, &motion.w)))
            .collect(),
        Function::TotalMomentum => {
            let motion = moving(&qd, &rest);
            let moments = moments(robot, &positions, &motion.w);
            let gamma = &moments - &moments.transposed();
            [gamma.vector(), gamma.column()].concat()
        }
        Function::CentroidalMomentum => {
            let motion = moving(&qd, &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CentroidalMomentumMatrix => unit_motions(robot, &positions)
            .flat_map(|motion| {
                let moments = moments(robot, &positions, &motion.w);
                about_mass_center(robot, &positions, &moments)
            })
            .collect(),
        Function::CentroidalMomentumBias => {
            let motion = moving(&qd, &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.h))
        }
        Function::InverseDynamicsDerivatives => derivatives::of_torques(
            robot,
            &positions,
            [&qd, &qdd],
            &arguments[Variable::Actions],
        )
        .concat(),
        Function::InverseDynamicsVjp => derivatives::torque_gradient(
            robot,
            &positions,
            [&qd, &qdd, &weights],
            &arguments[Variable::Actions],
        )
        .concat(),
        Function::ForwardDynamicsVjp => derivatives::acceleration_gradient(
            robot,
            &positions,
            [&qd, &tau, &weights],
            &arguments[Variable::Actions],
        )
        .concat(),
        Function::InverseDynamicsJvp => {
            let value = less_external(torques(robot, &positions, &moving(&qd, &qdd)));
            let inertias = mass_matrix(robot, &positions).concat();
            let change = derivatives::torque_change(robot, &positions, [&qd, &qdd], arguments);
            let further = product(&inertias, &arguments[Variable::QddChange]);
            let change = change.iter().zip(&further).map(|(a, b)| a + b);
            value.into_iter().chain(change).collect()
        }
        Function::ForwardDynamicsJvp => {
            let value = evaluate(robot, Function::ForwardDynamics, frame, arguments);
            let by_motion = derivatives::torque_change(robot, &positions, [&qd, &value], arguments);
            let forces = arguments[Variable::TauChange].iter().zip(by_motion);
            let forces = forces.map(|(&all, by_motion)| vec![Big::new(all) - by_motion]);
            let change = solve(mass_matrix(robot, &positions), forces.collect());
            value.into_iter().chain(change.concat()).collect()
        }
        Function::InverseDynamicsHessian | Function::ForwardDynamicsHessian => {
            let count = robot.velocities();
            let units = (0..count).map(|row| {
                let unit = (0..count).map(|k| if k == row { 1.0 } else { 0.0 });
                hessian_along(robot, function, arguments, &unit.collect::<Vec<f64>>())
            });
            let rows: Vec<Vec<Big>> = units.collect();
            let block = |k: usize| {
                rows.iter()
                    .flat_map(move |row| row[k * count..][..count].to_vec())
            };
            (0..4).flat_map(block).collect()
        }
        Function::ForwardDynamicsDerivatives => {
            let qdd = evaluate(robot, Function::ForwardDynamics, frame, arguments);
            let motion = [&*qd, &*qdd];
            let found =
                derivatives::of_torques(robot, &positions, motion, &arguments[Variable::Actions])
                    .map(|partial| {
                        let rows = partial.chunks(rest.len().max(1));
                        let right = rows.map(|row| row.iter().map(|entry| -entry).collect());
                        solve(mass_matrix(robot, &positions), right.collect()).concat()
                    });
            let dtau = evaluate(robot, Function::MassMatrixInverse, frame, arguments);
            [found.concat(), dtau].concat()
        }
        Function::GravityDerivative => {
            derivatives::by_coordinate(robot, &positions, [&rest, &rest], &[])
        }
        Function::CoriolisMatrix => {
            let motion = moving(&qd, &rest);
            derivatives::coriolis(robot, &positions, &motion)
        }
        Function::Constraint => closure::residuals(robot, &positions),
        Function::ConstraintJacobian => closure::jacobian(robot, &positions),
        Function::ConstraintBias => closure::bias(robot, &positions, &moving(&qd, &rest)),
        Function::ConstrainedForwardDynamics => {
            let tau = tau.into_iter().zip(bias());
            let (matrix, right) = closure::system(
                &mass_matrix(robot, &positions),
                tau.map(|(tau, bias)| tau - bias).collect(),
                &closure::jacobian(robot, &positions),
                &closure::bias(robot, &positions, &moving(&qd, &rest)),
            );
            solve(matrix, right).concat()
        }
        other => panic!("{} has no oracle", other.name()),
    }
}

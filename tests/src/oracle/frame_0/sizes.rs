//! Sizes of the terms that torques are sums of, as measures of rounding errors.
//!
//! In: a robot in matrices and the arguments. Out: a size for each velocity.

use std::mem;

use homogen_codegen::space::Variable;

use super::motion::{JointScrew, Motion, Positions};
use super::torques::actions;
use crate::arguments::Arguments;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;
use crate::oracle::state::exact;

/// For each velocity, the sum over the bodies that it moves of |u| times the couple of the body's Φ about the joint's
/// origin, plus |b| times its force.
///
/// It measures rounding errors of long chains, where S is useless: S grows as the product of |sin| + |cos| of all
/// angles, and sums of torques do not.
#[must_use]
pub fn torque_sizes(robot: &Robot, arguments: &Arguments) -> Vec<f64> {
    let mut state = exact(arguments, robot.quaternions());
    let [q, qd, qdd] =
        [Variable::Q, Variable::Qd, Variable::Qdd].map(|variable| mem::take(&mut state[variable]));
    let positions = Positions::at(robot, &q);
    let motion = Motion::at(robot, &positions, &qd, &qdd);
    // `f64` is enough for a measure. Couple and force of Φ, direction and moment of L, about the origin of frame 0.
    let parts = |matrix: &Matrix| {
        [matrix.vector(), matrix.column()].map(|vector| vector.map(|x| x.to_f64()))
    };
    let actions: Vec<_> = actions(robot, &positions, &motion)
        .map(|action| parts(&action))
        .collect();
    let size = |screw: &JointScrew, body: usize| {
        let origin = positions.m[screw.body].column().map(|x| x.to_f64());
        let ([u, b], [c, f]) = (parts(&screw.l), actions[body]);
        // About the joint's origin: b + u × o, c − o × f.
        let (b, c) = (sum(b, cross(u, origin)), sum(c, cross(f, origin)));
        length(u) * length(c) + length(b) * length(f)
    };
    let mut sizes = vec![0.0; robot.velocities()];
    for screw in &positions.screws {
        let bodies = (screw.body..actions.len()).filter(|&body| {
            let mut carriers = robot.upwards(Some(body));
            carriers.any(|carrier| carrier == screw.body)
        });
        sizes[screw.velocity] += bodies.map(|body| size(screw, body)).sum::<f64>();
    }
    sizes
}

fn cross([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> [f64; 3] {
    [y * c - z * b, z * a - x * c, x * b - y * a]
}

fn sum(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| x[k] + y[k])
}

fn length(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

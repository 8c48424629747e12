//! What torques are made of, however much of it cancels.
//!
//! In: a robot in matrices and the arguments. Out: a size for each velocity, in the precision of a measure.

use std::mem;

use homogen_codegen::space::Variable;

use super::motion::{Freedom, Motion, Positions};
use super::torques::actions;
use crate::arguments::Arguments;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;
use crate::oracle::state::exact;

/// For each velocity, the sum of the sizes of what the bodies it moves ask of it: |u| times the couple of
/// each body's Φ about the joint's origin, and |b| times its force.
///
/// It measures rounding where S cannot: S of a long chain grows as the product of |sin| + |cos| of all
/// its angles, which no sum of torques does.
#[must_use]
pub fn torque_sizes(robot: &Robot, arguments: &Arguments) -> Vec<f64> {
    let mut state = exact(arguments, robot.quaternions());
    let [q, qd, qdd] =
        [Variable::Q, Variable::Qd, Variable::Qdd].map(|variable| mem::take(&mut state[variable]));
    let positions = Positions::at(robot, &q);
    let motion = Motion::at(robot, &positions, &qd, &qdd);
    // A measure needs no more than `f64`: of Φ the couple and the force, of L the direction and the
    // rest, about the origin of frame 0.
    let parts = |matrix: &Matrix| {
        [matrix.vector(), matrix.column()].map(|vector| vector.map(|x| x.to_f64()))
    };
    let actions: Vec<_> = actions(robot, &positions, &motion)
        .map(|action| parts(&action))
        .collect();
    let asked = |freedom: &Freedom, body: usize| {
        let origin = positions.m[freedom.body].column().map(|x| x.to_f64());
        let ([u, b], [c, f]) = (parts(&freedom.l), actions[body]);
        // About the joint's origin: b + u × o, c − o × f.
        let (b, c) = (sum(b, cross(u, origin)), sum(c, cross(f, origin)));
        length(u) * length(c) + length(b) * length(f)
    };
    let mut sizes = vec![0.0; robot.velocities()];
    for freedom in &positions.freedoms {
        let bodies = (freedom.body..actions.len()).filter(|&body| {
            let mut carriers = robot.upwards(Some(body));
            carriers.any(|carrier| carrier == freedom.body)
        });
        sizes[freedom.velocity] += bodies.map(|body| asked(freedom, body)).sum::<f64>();
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

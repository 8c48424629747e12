//! Errors of results of random robots, relative to the size of their terms.
//!
//! In: a result and a state, both in the coordinates of a [`Dense`]. Out: the largest relative error. Limits are up to
//! the caller.
//!
//! | result | relative to |
//! |---|---|
//! | rotation | 1 |
//! | translation | the robot's size |
//! | rates | the sum of the joints' rates |
//! | torque | the sum of the terms of its bodies, actuators and external wrenches |
//! | entry of the mass matrix | the root of the two diagonal entries |
//! | derivative of a torque | all masses at the end of all lever arms |
//!
//! Torques and entries of the mass matrix can vanish where lever arms cancel. So their sizes include all masses at a
//! hundredth of the robot's size and the like part of all second moments, or all of both if the recursions run in
//! frame 0.
//!
//! Solutions with the mass matrix are verified backwards: the torques of the accelerations, and M M⁻¹, relative to the
//! terms that they are sums of.

mod weighted;

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;
use crate::oracle::robot as oracle;

use super::dense::Dense;

/// True values for a robot, and the sizes to compare errors with.
pub struct Measure {
    robot: oracle::Robot,
    /// The size of the robot \[m\].
    reach: f64,
    /// Speed of a point for a unit of a joint's rate: the longest lever arm \[m\].
    arm: f64,
    /// The largest sum of factors of mimic joints.
    gain: f64,
    /// A lower bound of first moments, which can vanish [kg m].
    first: f64,
    /// A lower bound of second moments, which can vanish [kg m²].
    second: f64,
    gravity: f64,
    /// The mass of all bodies \[kg\].
    mass: f64,
    /// The sum of their second moments [kg m²].
    moments: f64,
}

/// The variable of a derivative.
#[derive(Clone, Copy)]
enum Change {
    Coordinate,
    Rate,
}

impl Measure {
    /// The measure for functions of the frame of a link, of those of several, or of the whole robot.
    #[must_use]
    pub fn of(dense: &Dense, links: &[usize], in_frame_0: bool) -> Self {
        let mut robot = dense.robot.clone();
        robot.frames = links.iter().map(|&link| dense.body(link)).collect();
        let gravity = robot.gravity.column().map(|entry| entry.to_f64().abs());
        let reach = dense.reach;
        let share = if in_frame_0 { 1.0 } else { 0.01 };
        let first = share * reach * dense.mass;
        Self {
            robot,
            reach,
            arm: reach + dense.translation,
            gain: dense.gain,
            first,
            second: share * (share * reach * reach * dense.mass + dense.second),
            gravity: gravity.into_iter().sum(),
            mass: dense.mass,
            moments: dense.second,
        }
    }

    /// The largest relative error of a result.
    ///
    /// # Panics
    /// For a function that has no measure.
    #[must_use]
    pub fn error(&self, function: Function, found: &[f64], arguments: &Arguments) -> f64 {
        let rates = self.gain * sum(&arguments[Variable::Qd]);
        let expected = |function| frame_0::evaluate(&self.robot, function, 0, arguments);
        let compared = |size: &dyn Fn(usize) -> f64| largest(found, &expected(function), size);
        let count = arguments[Variable::Qd].len();
        match function {
            Function::InverseDynamics | Function::Bias | Function::Gravity => {
                let mut at = arguments.clone();
                if function != Function::InverseDynamics {
                    at[Variable::Qdd].fill(0.0);
                    at[Variable::Actions].clear();
                }
                if function == Function::Gravity {
                    at[Variable::Qd].fill(0.0);
                }
                let sizes = self.torques(&at);
                compared(&|k| sizes[k])
            }
            Function::MassMatrix => {
                let expected = expected(function);
                let roots = self.roots(&expected, count);
                largest(found, &expected, &|k| roots[k / count] * roots[k % count])
            }
            Function::ForwardDynamics => {
                self.torque_residual(found, arguments, &expected(Function::MassMatrix))
            }
            Function::MassMatrixInverse => {
                self.identity_residual(found, count, &expected(Function::MassMatrix))
            }
            Function::KineticEnergy => {
                let size = rates * rates * (self.first * self.arm + self.second);
                compared(&|_| size + expected(function)[0].to_f64())
            }
            Function::PotentialEnergy => {
                let size = self.gravity * self.mass * self.reach;
                compared(&|_| size)
            }
            Function::Regressor => {
                let sizes = self.columns(arguments);
                let columns = found.len() / count.max(1);
                compared(&|k| sizes[self.kind(k % columns.max(1))])
            }
            Function::KineticEnergyRegressor => compared(&|k| {
                rates * rates * [self.arm * self.arm, self.arm, 1.0, 1.0][self.kind(k)]
            }),
            Function::PotentialEnergyRegressor => {
                compared(&|k| self.gravity * [self.reach, 1.0, 0.0, 0.0][self.kind(k)])
            }
            Function::CenterOfMass => compared(&|_| self.reach),
            Function::CenterOfMassVelocity => compared(&|_| rates * self.arm),
            Function::CenterOfMassJacobian => compared(&|_| self.arm),
            Function::TotalMomentum | Function::CentroidalMomentum => {
                compared(&|k| rates * self.momentum(k))
            }
            Function::CentroidalMomentumMatrix => compared(&|k| self.momentum(k % 6)),
            Function::CentroidalMomentumBias => compared(&|k| rates * rates * self.momentum(k)),
            Function::InverseDynamicsDerivatives => {
                let sizes = self.changes(arguments);
                compared(&|k| sizes[k / (count * count)])
            }
            Function::ForwardDynamicsDerivatives => {
                let (by_motion, inverse) = found.split_at(2 * count * count);
                let matrix = expected(Function::MassMatrix);
                let residual = self.identity_residual(inverse, count, &matrix);
                residual.max(self.derivative_residual(by_motion, arguments, &matrix))
            }
            Function::GravityDerivative => {
                let mut at = arguments.clone();
                at[Variable::Qd].fill(0.0);
                at[Variable::Qdd].fill(0.0);
                at[Variable::Actions].clear();
                let size = self.change(&at, Change::Coordinate);
                compared(&|_| size)
            }
            Function::CoriolisMatrix => {
                let size = self.change(arguments, Change::Rate);
                compared(&|_| size)
            }
            other => self.kinematic_error(other, found, arguments),
        }
    }

    /// The same of functions of poses and of motions.
    fn kinematic_error(&self, function: Function, found: &[f64], arguments: &Arguments) -> f64 {
        let rates = self.gain * sum(&arguments[Variable::Qd]);
        let expected = || frame_0::evaluate(&self.robot, function, 0, arguments);
        let compared = |size: &dyn Fn(usize) -> f64| largest(found, &expected(), size);
        match function {
            Function::ForwardKinematics | Function::FramePoses => {
                compared(&|k| if k % 4 == 3 { self.reach } else { 1.0 })
            }
            Function::TipVelocity => compared(&|k| rates * if k < 3 { 1.0 } else { self.arm }),
            Function::TipAcceleration => {
                let rates = self.gain * sum(&arguments[Variable::Qdd]) + rates * rates;
                compared(&|k| self.acceleration(k, rates))
            }
            Function::SpatialJacobian | Function::BodyJacobian | Function::GeometricJacobian => {
                compared(&|k| self.gain * if k % 6 < 3 { 1.0 } else { self.arm })
            }
            Function::SpatialJacobianRate
            | Function::BodyJacobianRate
            | Function::GeometricJacobianRate => {
                compared(&|k| rates * if k % 6 < 3 { 1.0 } else { self.arm })
            }
            Function::JacobianDerivative => {
                let gain = self.gain * self.gain;
                compared(&|k| gain * if k % 6 < 3 { 1.0 } else { self.arm })
            }
            Function::ForwardKinematicsHessian => {
                let (couple, force) = arguments[Variable::Wrench].split_at(3);
                let size = self.gain * self.gain * (sum(couple) + self.arm * sum(force));
                compared(&|_| size)
            }
            Function::AccelerationBias => compared(&|k| self.acceleration(k, rates * rates)),
            other => self.weighted_error(other, found, arguments),
        }
    }

    /// The order of the moment of mass that a parameter is, and 3 for armature, damping and friction.
    fn kind(&self, parameter: usize) -> usize {
        let of_links = 10 * self.robot.bodies.iter().filter(|body| body.link).count();
        match parameter % 10 {
            _ if parameter >= of_links => 3,
            0 => 0,
            1..4 => 1,
            _ => 2,
        }
    }

    /// Sizes of the columns of the regressor, by the kind of their parameters.
    fn columns(&self, at: &Arguments) -> [f64; 4] {
        // A unit mass at the end of a lever arm, or unit moments; armature, damping and friction.
        let first = self.gain * sum(&at[Variable::Qd]);
        let rates = sum(&at[Variable::Qdd]) + first * first;
        [
            (self.gravity + rates * self.arm) * self.arm,
            self.gravity + rates * self.arm,
            rates,
            rates + first + 1.0,
        ]
    }

    /// Accelerations caused by one rounding error of each torque's terms, relative to the accelerations of a state.
    #[must_use]
    pub fn rounding_of_accelerations(&self, arguments: &Arguments) -> f64 {
        let evaluate = |function| frame_0::evaluate(&self.robot, function, 0, arguments);
        let sizes = self.torques(arguments).into_iter();
        let matrix = evaluate(Function::MassMatrix);
        let inertias = matrix.iter().step_by(arguments[Variable::Qd].len() + 1);
        let found = evaluate(Function::ForwardDynamics);
        let found = found.iter().map(|qdd| qdd.to_f64().abs());
        let rounded = sizes
            .zip(inertias)
            .map(|(size, m)| 0.5 * f64::EPSILON * size / m.to_f64());
        rounded.fold(0.0, f64::max) / found.fold(0.0, f64::max)
    }

    /// Size of an entry of an acceleration, for angular accelerations of this size; gravity is included, since
    /// recursions subtract it at the end.
    fn acceleration(&self, entry: usize, rates: f64) -> f64 {
        if entry % 4 == 3 {
            rates * self.arm + self.gravity
        } else {
            rates
        }
    }

    /// Size of an entry of the momentum at unit rates, about any reference point within the robot's size.
    fn momentum(&self, entry: usize) -> f64 {
        let linear = self.mass * self.arm;
        if entry < 3 {
            linear * self.reach + self.moments
        } else {
            linear
        }
    }

    /// Sizes of torques.
    fn torques(&self, at: &Arguments) -> Vec<f64> {
        let rates = self.gain * sum(&at[Variable::Qd]);
        let rates = self.gain * sum(&at[Variable::Qdd]) + rates * rates;
        let floor = self.first * (self.gravity + rates * self.arm) + self.second * rates;
        let floor = self.gain * (floor + self.external(at));
        let mut sizes = frame_0::torque_sizes(&self.robot, at);
        for actuator in &self.robot.actuators {
            let k = actuator.velocity;
            sizes[k] += actuator.size(at[Variable::Qd][k], at[Variable::Qdd][k]);
        }
        sizes.into_iter().map(|size| size + floor).collect()
    }

    /// Size of the moments of external wrenches about any reference point within the robot's size.
    fn external(&self, at: &Arguments) -> f64 {
        let sizes = at[Variable::Actions].chunks(6).map(|action| {
            let (couple, force) = action.split_at(3);
            sum(couple) + self.arm * sum(force)
        });
        sizes.sum()
    }

    /// Sizes of ∂τ/∂q and of ∂τ/∂q̇, damping included.
    fn changes(&self, at: &Arguments) -> [f64; 2] {
        let damping = self.robot.actuators.iter();
        let damping = damping.map(|actuator| actuator.damping().to_f64());
        [
            self.change(at, Change::Coordinate),
            self.change(at, Change::Rate) + damping.sum::<f64>(),
        ]
    }

    /// Size of ∂τ/∂q or of ∂τ/∂q̇: all masses at the end of all lever arms.
    fn change(&self, at: &Arguments, of: Change) -> f64 {
        let rates = self.gain * sum(&at[Variable::Qd]);
        let inertia = self.mass * self.arm * self.arm + self.second;
        let size = match of {
            Change::Coordinate => {
                let rates = self.gain * sum(&at[Variable::Qdd]) + rates * rates;
                self.mass * self.arm * self.gravity + inertia * rates + self.external(at)
            }
            Change::Rate => inertia * rates,
        };
        self.gain * self.gain * size
    }

    /// Roots of the diagonal of the mass matrix.
    fn roots(&self, matrix: &[Big], count: usize) -> Vec<f64> {
        let diagonal = (0..count).map(|k| matrix[k * count + k].to_f64());
        diagonal
            .map(|entry| (entry.max(0.0) + self.gain * self.gain * self.second).sqrt())
            .collect()
    }

    /// τ less the torques of the computed accelerations, relative to the size of both.
    fn torque_residual(&self, qdd: &[f64], arguments: &Arguments, matrix: &[Big]) -> f64 {
        let roots = self.roots(matrix, qdd.len());
        let opposed = product(qdd, &roots);
        let mut at = arguments.clone();
        at[Variable::Qdd].fill(0.0);
        let sizes = self.torques(&at);
        at[Variable::Qdd] = qdd.to_vec();
        let torques = frame_0::evaluate(&self.robot, Function::InverseDynamics, 0, &at);
        largest(&at[Variable::Tau], &torques, &|k| {
            sizes[k] + roots[k] * opposed + at[Variable::Tau][k].abs()
        })
    }

    /// M ∂q̈ + ∂τ of inverse dynamics, which is zero for exact derivatives of accelerations, relative to its terms.
    ///
    /// The size of ∂τ is that at accelerations as large as rounding errors of torques cause. Where the terms of M⁻¹ ∂τ
    /// cancel, only their own accuracy is required.
    fn derivative_residual(&self, found: &[f64], arguments: &Arguments, matrix: &[Big]) -> f64 {
        let count = arguments[Variable::Qd].len();
        let evaluate = |function, at: &Arguments| frame_0::evaluate(&self.robot, function, 0, at);
        let mut at = arguments.clone();
        let qdd = evaluate(Function::ForwardDynamics, arguments);
        at[Variable::Qdd] = qdd.iter().map(Big::to_f64).collect();
        let needed = evaluate(Function::InverseDynamicsDerivatives, &at);
        let inverse = evaluate(Function::MassMatrixInverse, arguments);

        let roots = self.roots(matrix, count);
        let opposed = product(&at[Variable::Qdd], &roots);
        let sizes = self.torques(&at);
        let off = (0..count).map(|k| {
            let size = |j: usize| sizes[j] + roots[j] * opposed + at[Variable::Tau][j].abs();
            let row = inverse[k * count..].iter().take(count).enumerate();
            row.map(|(j, entry)| entry.to_f64().abs() * size(j)).sum()
        });
        let off = off.collect();
        at[Variable::Qdd] = off;
        let sizes = self.changes(&at);
        let rows = inverse.chunks(count).zip(&roots);
        let inverted = rows.map(|(row, root)| {
            let row = row.iter().map(|entry| entry.abs().to_f64());
            root * row.sum::<f64>()
        });
        let inverted: f64 = inverted.sum();
        let mut worst: f64 = 0.0;
        for (k, needed) in needed.iter().enumerate() {
            let (of, i, m) = (k / (count * count), k / count % count, k % count);
            let column = found[of * count * count + m..].iter().step_by(count);
            let column: Vec<f64> = column.take(count).copied().collect();
            let terms = matrix[i * count..].iter().zip(&column);
            let rest = terms.fold(needed.clone(), |sum, (entry, x)| sum + entry * Big::new(*x));
            let size =
                sizes[of] * (1.0 + roots[i] * inverted) + roots[i] * product(&column, &roots);
            let rest = rest.abs().to_f64();
            worst = worst.max(if rest == 0.0 { 0.0 } else { rest / size });
        }
        worst
    }

    /// M M⁻¹ − 1, relative to its terms.
    fn identity_residual(&self, inverse: &[f64], count: usize, matrix: &[Big]) -> f64 {
        let roots = self.roots(matrix, count);
        let mut worst: f64 = 0.0;
        for j in 0..count {
            let column: Vec<f64> = (0..count).map(|k| inverse[k * count + j]).collect();
            let size = product(&column, &roots);
            for (i, row) in matrix.chunks(count).enumerate() {
                let one = f64::from(u8::from(i == j));
                let terms = row.iter().zip(&column);
                let off = terms.fold(Big::new(-one), |sum, (entry, x)| sum + entry * Big::new(*x));
                worst = worst.max(off.abs().to_f64() / (one + roots[i] * size));
            }
        }
        worst
    }
}

/// The largest error relative to the size of its entry; an entry of size 0 must have no error.
fn largest(found: &[f64], expected: &[Big], size: &dyn Fn(usize) -> f64) -> f64 {
    assert_eq!(found.len(), expected.len(), "the same shape");
    let errors = found.iter().zip(expected).enumerate().map(|(k, (x, y))| {
        let error = (Big::new(*x) - y).abs().to_f64();
        if error == 0.0 { 0.0 } else { error / size(k) }
    });
    errors.fold(0.0, f64::max)
}

fn sum(entries: &[f64]) -> f64 {
    entries.iter().map(|entry| entry.abs()).sum()
}

/// Σ |x y|.
fn product(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x * y).abs()).sum()
}

//! How wrong a result is, in units of what it is made of.
//!
//! In: a result and a state, both by the coordinates of a [`Dense`]. Out: its largest error. Of a
//! rotation the unit is 1, of an offset the robot's reach, of rates the sum of the joints' rates; of the
//! torque of a joint the sum of the sizes of what its bodies ask of it, of an entry of the mass
//! matrix the root of the two on its diagonal. Both of these can vanish where lever arms cancel, so
//! that all masses at a hundredth of the reach stand beside them, and as much of all second moments; where
//! the recursions run in frame 0, all of both. What drives and actions from outside are comes on top. A derivative of torques is measured by all masses at the end of
//! all lever arms. What solves with the mass matrix is not compared but put back: the torques of the
//! accelerations, and the matrix times its inverse, beside the magnitudes that they are sums of.
//!
//! It decides nothing: what is wrong is for whoever asks.

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;
use crate::oracle::robot as oracle;

use super::dense::Dense;

/// The truth about a robot and what to measure by.
pub struct Measure {
    robot: oracle::Robot,
    /// What an offset is measured by.
    reach: f64,
    /// What the rate of a point is measured by for a unit of the rate of a joint.
    slide: f64,
    /// What a unit of the rate of a joint turns others by that follow it, all together.
    gain: f64,
    /// What stands for first moments that vanish [kg m].
    first: f64,
    /// What stands for second moments that vanish [kg m²].
    second: f64,
    gravity: f64,
    /// What all bodies weigh together \[kg\].
    mass: f64,
    /// The sum of their second moments [kg m²].
    moments: f64,
}

/// With respect to what a torque changes.
#[derive(Clone, Copy)]
enum Change {
    Coordinate,
    Rate,
}

impl Measure {
    /// Of a link's frame, where a function is of one.
    #[must_use]
    pub fn of(dense: &Dense, link: Option<usize>, in_frame_0: bool) -> Self {
        let mut robot = dense.robot.clone();
        robot.frames = link.iter().map(|&link| dense.body(link)).collect();
        let gravity = robot.gravity.column().map(|entry| entry.to_f64().abs());
        let reach = dense.reach;
        let share = if in_frame_0 { 1.0 } else { 0.01 };
        let first = share * reach * dense.mass;
        Self {
            robot,
            reach,
            slide: reach + dense.slide,
            gain: dense.gain,
            first,
            second: share * (share * reach * reach * dense.mass + dense.second),
            gravity: gravity.into_iter().sum(),
            mass: dense.mass,
            moments: dense.second,
        }
    }

    /// The largest error of a result.
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
            Function::ForwardKinematics => compared(&|k| if k % 4 == 3 { self.reach } else { 1.0 }),
            Function::Velocity => compared(&|k| rates * if k < 3 { 1.0 } else { self.slide }),
            Function::Acceleration => {
                let rates = self.gain * sum(&arguments[Variable::Qdd]) + rates * rates;
                compared(&|k| self.moved(k, rates))
            }
            Function::SpatialJacobian | Function::BodyJacobian | Function::GeometricJacobian => {
                compared(&|k| self.gain * if k % 6 < 3 { 1.0 } else { self.slide })
            }
            Function::SpatialJacobianRate
            | Function::BodyJacobianRate
            | Function::GeometricJacobianRate => {
                compared(&|k| rates * if k % 6 < 3 { 1.0 } else { self.slide })
            }
            Function::AccelerationBias => compared(&|k| self.moved(k, rates * rates)),
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
                self.lacking(found, arguments, &expected(Function::MassMatrix))
            }
            Function::MassMatrixInverse => {
                self.off_identity(found, count, &expected(Function::MassMatrix))
            }
            Function::KineticEnergy => {
                let size = rates * rates * (self.first * self.slide + self.second);
                compared(&|_| size + expected(function)[0].to_f64())
            }
            Function::PotentialEnergy => {
                let size = self.gravity * self.mass * self.reach;
                compared(&|_| size)
            }
            Function::Regressor => {
                // A mass within reach, or first or second moments, moved and felt at a lever.
                let first = rates;
                let rates = sum(&arguments[Variable::Qdd]) + rates * rates;
                let columns = expected(function).len() / count.max(1);
                let of_links = 10 * self.robot.bodies.iter().filter(|body| body.link).count();
                compared(&|k| match k % columns.max(1) {
                    column if column >= of_links => rates + first + 1.0,
                    column if column % 10 == 0 => (self.gravity + rates * self.slide) * self.slide,
                    column if column % 10 < 4 => self.gravity + rates * self.slide,
                    _ => rates,
                })
            }
            Function::CenterOfMass => compared(&|_| self.reach),
            Function::CenterOfMassVelocity => compared(&|_| rates * self.slide),
            Function::CenterOfMassJacobian => compared(&|_| self.slide),
            Function::Momentum | Function::CentroidalMomentum => {
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
                let off = self.off_identity(inverse, count, &matrix);
                off.max(self.unanswered(by_motion, arguments, &matrix))
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
            other => panic!("{} has no measure", other.name()),
        }
    }

    /// What one rounding of all that torques are made of is, as accelerations, beside those of a state.
    #[must_use]
    pub fn drowned(&self, arguments: &Arguments) -> f64 {
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

    /// What an entry of an acceleration is made of, where turns are accelerated so much: a point may fall as well, and what
    /// holds it is taken off at the end.
    fn moved(&self, entry: usize, rates: f64) -> f64 {
        if entry % 4 == 3 {
            rates * self.slide + self.gravity
        } else {
            rates
        }
    }

    /// What the momentum of a unit rate is made of: its entry of that number, about whichever pole within
    /// reach.
    fn momentum(&self, entry: usize) -> f64 {
        let linear = self.mass * self.slide;
        if entry < 3 {
            linear * self.reach + self.moments
        } else {
            linear
        }
    }

    /// What torques are made of.
    fn torques(&self, at: &Arguments) -> Vec<f64> {
        let rates = self.gain * sum(&at[Variable::Qd]);
        let rates = self.gain * sum(&at[Variable::Qdd]) + rates * rates;
        let floor = self.first * (self.gravity + rates * self.slide) + self.second * rates;
        let floor = self.gain * (floor + self.pushed(at));
        let mut sizes = frame_0::torque_sizes(&self.robot, at);
        for drive in &self.robot.drives {
            let k = drive.velocity;
            sizes[k] += drive.size(at[Variable::Qd][k], at[Variable::Qdd][k]);
        }
        sizes.into_iter().map(|size| size + floor).collect()
    }

    /// What actions from outside are about whichever pole within reach.
    fn pushed(&self, at: &Arguments) -> f64 {
        let sizes = at[Variable::Actions].chunks(6).map(|action| {
            let (couple, force) = action.split_at(3);
            sum(couple) + self.slide * sum(force)
        });
        sizes.sum()
    }

    /// What a unit of a coordinate may change a torque by, and what one of a rate, friction and all.
    fn changes(&self, at: &Arguments) -> [f64; 2] {
        let damping = self.robot.drives.iter();
        let damping = damping.map(|drive| drive.damping().to_f64());
        [
            self.change(at, Change::Coordinate),
            self.change(at, Change::Rate) + damping.sum::<f64>(),
        ]
    }

    /// What a unit of a coordinate, or of its rate, may change a torque by: all masses at the end of all
    /// lever arms.
    fn change(&self, at: &Arguments, of: Change) -> f64 {
        let rates = self.gain * sum(&at[Variable::Qd]);
        let inertia = self.mass * self.slide * self.slide + self.second;
        let size = match of {
            Change::Coordinate => {
                let rates = self.gain * sum(&at[Variable::Qdd]) + rates * rates;
                self.mass * self.slide * self.gravity + inertia * rates + self.pushed(at)
            }
            Change::Rate => inertia * rates,
        };
        self.gain * self.gain * size
    }

    /// The roots of the diagonal of the mass matrix.
    fn roots(&self, matrix: &[Big], count: usize) -> Vec<f64> {
        let diagonal = (0..count).map(|k| matrix[k * count + k].to_f64());
        diagonal
            .map(|entry| (entry.max(0.0) + self.gain * self.gain * self.second).sqrt())
            .collect()
    }

    /// τ less the torques of the accelerations found.
    fn lacking(&self, qdd: &[f64], arguments: &Arguments, matrix: &[Big]) -> f64 {
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

    /// M times derivatives of accelerations, and what inverse dynamics changes by, beside what that is for
    /// accelerations as large as those that torques may be off by. Derivatives are M⁻¹ times what torques change by:
    /// where large terms of that product cancel, no more is asked than that each term is right.
    fn unanswered(&self, found: &[f64], arguments: &Arguments, matrix: &[Big]) -> f64 {
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

    /// M times its inverse, less 1.
    fn off_identity(&self, inverse: &[f64], count: usize, matrix: &[Big]) -> f64 {
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

/// The largest error beside the size of its entry. An entry made of nothing must be nothing.
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

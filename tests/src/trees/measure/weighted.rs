//! Sizes and errors of derivatives that are contracted with weights λ or along a direction, and of products with M⁻¹.
//!
//! Sizes of sums are those of their terms. Results of forward dynamics are compared with the true ones; their sizes are
//! those of what the rounding of M and of τ makes of y = M⁻¹ λ and of q̈, or of y itself.

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use super::{Change, Measure, largest, product, sum};
use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;

/// Solutions with M, and the growth of roundings in them.
struct Solutions {
    /// A state with the sizes of q̈ and of its rounding as q̈, and those of y as λ.
    at: Arguments,
    /// The sizes of y and of its rounding.
    y: Vec<f64>,
    /// The absolute values of M⁻¹, by rows.
    inverse: Vec<f64>,
    /// Σ |M⁻¹| by which a rounding of M grows.
    inverted: f64,
}

impl Measure {
    /// The error of a function with weights or a direction.
    ///
    /// # Panics
    /// If there is no measure for it.
    pub(super) fn weighted_error(
        &self,
        function: Function,
        found: &[f64],
        arguments: &Arguments,
    ) -> f64 {
        let expected = || frame_0::evaluate(&self.robot, function, 0, arguments);
        match function {
            Function::InverseDynamicsVjp => {
                let (sizes, count) = (self.torque_gradient(arguments), found.len() / 3);
                largest(found, &expected(), &|k| sizes[k / count])
            }
            Function::ForwardDynamicsVjp => {
                let sizes = self.acceleration_gradient(arguments);
                largest(found, &expected(), &|k| sizes[k])
            }
            Function::InverseDynamicsJvp => {
                let (mut sizes, inertia) = (self.torques(arguments), self.inertia());
                let change = self.change_of_torques(arguments)
                    + inertia * self.gain * sum(&arguments[Variable::QddChange]);
                sizes.resize(found.len(), change);
                largest(found, &expected(), &|k| sizes[k])
            }
            Function::ForwardDynamicsJvp => {
                let sizes = self.changes_of_accelerations(arguments);
                largest(found, &expected(), &|k| sizes[k])
            }
            Function::ForwardDynamicsParameterDerivatives => {
                let count = arguments[Variable::Qd].len();
                let sizes = self.accelerations_by_parameters(arguments);
                let parameters = found.len() / count.max(1);
                largest(found, &expected(), &|k| {
                    sizes[k / parameters][self.kind(k % parameters)]
                })
            }
            Function::InverseDynamicsHessian => {
                self.hessian_error(function, found, arguments, Variable::Tau)
            }
            Function::ForwardDynamicsHessian => {
                self.hessian_error(function, found, arguments, Variable::Qdd)
            }
            other => panic!("{} has no measure", other.name()),
        }
    }

    /// For each acceleration the sizes of its derivatives by parameters of each kind.
    fn accelerations_by_parameters(&self, at: &Arguments) -> Vec<[f64; 4]> {
        let count = at[Variable::Qd].len();
        let Solutions {
            at,
            inverse,
            inverted,
            ..
        } = self.solutions(at);
        let sizes = self.columns(&at);
        let rows = inverse.chunks(count.max(1));
        rows.map(|row| sizes.map(|size| size * sum(row) * self.gain * (1.0 + inverted)))
            .collect()
    }

    /// Sizes of the gradient of λᵀτ by q, q̇ and q̈.
    fn torque_gradient(&self, at: &Arguments) -> [f64; 3] {
        let [by_q, by_qd] = self.changes(at);
        let weights = self.gain * sum(&at[Variable::Weights]);
        [by_q, by_qd, self.inertia()].map(|size| size * weights)
    }

    /// Size of the entries of M.
    fn inertia(&self) -> f64 {
        let of_bodies = self.gain * self.gain * (self.mass * self.arm * self.arm + self.second);
        let armatures = self.robot.actuators.iter();
        let armatures = armatures.map(|actuator| actuator.armature().to_f64());
        of_bodies + armatures.sum::<f64>()
    }

    /// Size of the change of torques along those of q and q̇.
    fn change_of_torques(&self, at: &Arguments) -> f64 {
        let [by_q, by_qd] = self.changes(at);
        self.gain * (by_q * sum(&at[Variable::QChange]) + by_qd * sum(&at[Variable::QdChange]))
    }

    /// Sizes of accelerations, and of their changes.
    fn changes_of_accelerations(&self, at: &Arguments) -> Vec<f64> {
        let Solutions {
            at,
            inverse,
            inverted,
            ..
        } = self.solutions(at);
        let count = at[Variable::Qd].len();
        let of_motion = self.change_of_torques(&at);
        let forces = at[Variable::TauChange].iter();
        let forces: Vec<f64> = forces.map(|force| of_motion + force.abs()).collect();
        let rows = inverse.chunks(count.max(1));
        let changes = rows.map(|row| product(row, &forces) * (1.0 + inverted));
        let changes: Vec<f64> = changes.collect();
        [at[Variable::Qdd].clone(), changes].concat()
    }

    /// Sizes of the entries of the gradient of λᵀq̈ by q, q̇ and τ.
    fn acceleration_gradient(&self, at: &Arguments) -> Vec<f64> {
        let count = at[Variable::Qd].len();
        let Solutions { at, y, .. } = self.solutions(at);
        let [by_q, by_qd, _] = self.torque_gradient(&at);
        [vec![by_q; count], vec![by_qd; count], y].concat()
    }

    /// The error of a Hessian, whose matrices are multiplied from the left by an argument that the function does not
    /// have.
    fn hessian_error(
        &self,
        function: Function,
        found: &[f64],
        arguments: &Arguments,
        along: Variable,
    ) -> f64 {
        let count = arguments[Variable::Qd].len();
        let direction = &arguments[along];
        let expected = frame_0::hessian_along(&self.robot, function, arguments, direction);
        let found = found.chunks(count * count).flat_map(|matrix| {
            let column = move |column: usize| {
                let entries = matrix[column..].iter().step_by(count);
                let terms = entries.zip(direction);
                let terms = terms.map(|(entry, along)| Big::new(*entry) * Big::new(*along));
                terms.fold(Big::zero(), |sum, term| sum + term)
            };
            (0..count).map(column)
        });
        let directions = sum(direction);
        let sizes = if function == Function::ForwardDynamicsHessian {
            self.second_changes_of_accelerations(arguments, directions)
        } else {
            let sizes = self.second_changes(arguments, directions);
            sizes.map(|size| vec![size; count]).concat()
        };
        let pairs = found.zip(expected).zip(sizes);
        let errors = pairs.map(|((found, expected), size)| {
            let error = (found - expected).abs().to_f64();
            if error == 0.0 { 0.0 } else { error / size }
        });
        errors.fold(0.0, f64::max)
    }

    /// Sizes of the second derivatives of λᵀτ along a direction: by q and q, q and q̇, q̇ and q̇, q and q̈.
    fn second_changes(&self, at: &Arguments, direction: f64) -> [f64; 4] {
        let [by_q, by_qd] = [Change::Coordinate, Change::Rate].map(|of| self.change(at, of));
        let inertia = self.gain * self.gain * (self.mass * self.arm * self.arm + self.second);
        let weights = self.gain * sum(&at[Variable::Weights]) * direction;
        [by_q, by_qd, inertia, inertia].map(|size| size * weights)
    }

    /// The same of λᵀq̈, by q and q, q and q̇, q̇ and q̇, q and τ: each entry.
    fn second_changes_of_accelerations(&self, at: &Arguments, direction: f64) -> Vec<f64> {
        let Solutions {
            at,
            inverse,
            inverted,
            ..
        } = self.solutions(at);
        let count = at[Variable::Qd].len();
        let [q_q, q_qd, qd_qd, q_qdd] = self.second_changes(&at, direction);
        let columns = (0..count).map(|k| {
            let column: f64 = inverse[k..].iter().step_by(count).sum();
            q_qdd * column * (1.0 + inverted)
        });
        let by_tau: Vec<f64> = columns.collect();
        let [by_q, by_qd] = self.changes(&at).map(|size| size * sum(&by_tau));
        let blocks = [q_q + 2.0 * by_q, q_qd + by_qd, qd_qd];
        [blocks.map(|size| vec![size; count]).concat(), by_tau].concat()
    }

    fn solutions(&self, arguments: &Arguments) -> Solutions {
        let count = arguments[Variable::Qd].len();
        let evaluate = |function| frame_0::evaluate(&self.robot, function, 0, arguments);
        let matrix = evaluate(Function::MassMatrix);
        let inverse = evaluate(Function::MassMatrixInverse);
        let inverse: Vec<f64> = inverse.iter().map(|entry| entry.abs().to_f64()).collect();
        let roots = self.roots(&matrix, count);
        let times_inverse = |right: &[f64]| -> Vec<f64> {
            let rows = inverse.chunks(count);
            rows.map(|row| product(row, right)).collect()
        };
        let rounded = |solution: &[f64], right: &[f64]| -> Vec<f64> {
            let opposed = product(solution, &roots);
            let right = right.iter().zip(&roots);
            let right: Vec<f64> = right.map(|(size, root)| size + root * opposed).collect();
            let off = times_inverse(&right).into_iter().zip(solution);
            off.map(|(off, x)| off + x.abs()).collect()
        };
        let mut at = arguments.clone();
        let found = evaluate(Function::ForwardDynamics);
        at[Variable::Qdd] = found.iter().map(Big::to_f64).collect();
        let torques = self.torques(&at).into_iter().zip(&at[Variable::Tau]);
        let torques: Vec<f64> = torques.map(|(size, tau)| size + tau.abs()).collect();
        at[Variable::Qdd] = rounded(&at[Variable::Qdd], &torques);
        let weights: Vec<f64> = at[Variable::Weights].iter().map(|w| w.abs()).collect();
        let y = times_inverse(&weights);
        let y = rounded(&y, &vec![0.0; count]);
        at[Variable::Weights].clone_from(&y);
        let rows = inverse.chunks(count).zip(&roots);
        let inverted = rows.map(|(row, root)| root * sum(row)).sum();
        Solutions {
            at,
            y,
            inverse,
            inverted,
        }
    }
}

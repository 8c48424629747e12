//! Generated functions of a robot with closed loops, and states in which the loops are closed.
//!
//! In: a description. Out: results of its programs; coordinates that close the loops and rates that keep them closed,
//! found by those programs in `f64`. The judge verifies them.

use homogen_codegen::chain::{Chain, Position};
use homogen_codegen::description::Description;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::{expand, understand};
use homogen_codegen::joint::Manifold;
use homogen_codegen::list::Id;
use homogen_codegen::module::Module;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{Space, Variable};
use homogen_codegen::{Function, Real};

use crate::arguments::{Arguments, at};
use crate::states::Random;
use crate::tested::{F32, Tested};
use homogen_codegen::expression::Arithmetic;

/// The functions of loops.
pub const FUNCTIONS: [Function; 5] = [
    Function::Constraint,
    Function::ConstraintJacobian,
    Function::ConstraintBias,
    Function::ConstrainedForwardDynamics,
    Function::ActuatedInverseDynamics,
];

/// A robot as generated in a scalar type.
pub struct Programs {
    /// The chain after reductions.
    pub chain: Chain,
    module: Module,
    scalar: Real,
}

impl Programs {
    /// Generates the functions of loops.
    ///
    /// # Errors
    /// Errors of the generator.
    pub fn of(description: &Description, request: &Request, scalar: Real) -> Result<Self, Errors> {
        let request = Request {
            scalar,
            functions: FUNCTIONS.map(|function| vec![function]).to_vec(),
            ..request.clone()
        };
        Ok(Self {
            chain: understand(description, &request)?,
            module: expand(description, &request)?,
            scalar,
        })
    }

    /// The result of a function, computed in the scalar type.
    ///
    /// # Panics
    /// For a function that was not generated.
    #[must_use]
    pub fn run(&self, function: Function, arguments: &Arguments) -> Vec<f64> {
        let mut generated = self.module.functions.iter();
        let generated = generated.find(|generated| generated.functions == [function]);
        let program = &generated.expect("it was asked for").program;
        match self.scalar {
            Real::F32 => {
                let found = run(program, |input| F32::literal(at(arguments, input)));
                found.into_iter().map(F32::to_f64).collect()
            }
            Real::F64 | Real::Generic => run(program, |input| at(arguments, input)),
        }
    }

    /// The number of velocities.
    #[must_use]
    pub fn velocities(&self) -> usize {
        self.chain.spaces().len(Space::Velocities)
    }

    /// A random state near the configuration of the drawing, with closed loops; `None` if no residual below `most` is
    /// found. Newton steps with Levenberg–Marquardt damping.
    pub fn closed(&self, size: f64, most: f64, random: &mut Random) -> Option<Arguments> {
        let n = self.velocities();
        let mut list = |size: f64| -> Vec<f64> { (0..n).map(|_| size * random.odd()).collect() };
        let mut arguments = Arguments::of(|variable| match variable {
            Variable::Q => self.moved(&self.neutral(), &list(size)),
            Variable::Qd => list(2.0),
            Variable::Qdd => vec![0.0; n],
            Variable::Tau => list(4.0),
            _ => Vec::new(),
        });
        let mut damping = 1.0;
        let mut open = self.run(Function::Constraint, &arguments);
        for _ in 0..60 {
            let squares = dot(&open, &open);
            if squares < 1e-30 {
                break;
            }
            let step = self.step(&arguments, &open, damping * squares.min(1.0));
            let mut tried = arguments.clone();
            tried[Variable::Q] = self.moved(&arguments[Variable::Q], &step);
            let left = self.run(Function::Constraint, &tried);
            if dot(&left, &left) < squares {
                (arguments, open) = (tried, left);
                damping *= 0.25;
            } else {
                damping *= 8.0;
            }
        }
        for _ in 0..4 {
            let jacobian = self.run(Function::ConstraintJacobian, &arguments);
            let opening: Vec<f64> = jacobian
                .chunks(n)
                .map(|row| dot(row, &arguments[Variable::Qd]))
                .collect();
            let step = self.step(&arguments, &opening, 0.0);
            for (rate, step) in arguments[Variable::Qd].iter_mut().zip(step) {
                *rate += step;
            }
        }
        let is_closed = open.iter().all(|residual| residual.abs() <= most);
        is_closed.then_some(arguments)
    }

    /// The configuration of the drawing.
    fn neutral(&self) -> Vec<f64> {
        let spaces = self.chain.spaces();
        let mut q = vec![0.0; spaces.len(Space::Coordinates)];
        for first in spaces.quaternions() {
            q[first.index() + 3] = 1.0;
        }
        q
    }

    /// The damped least-squares step that reduces the residuals.
    fn step(&self, arguments: &Arguments, residuals: &[f64], damping: f64) -> Vec<f64> {
        let n = self.velocities();
        let jacobian = self.run(Function::ConstraintJacobian, arguments);
        let rows: Vec<&[f64]> = jacobian.chunks(n).collect();
        let mut matrix: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                (0..n)
                    .map(|k| rows.iter().map(|row| row[i] * row[k]).sum())
                    .collect()
            })
            .collect();
        let most = (0..n).map(|k| matrix[k][k]).fold(0.0, f64::max);
        for (k, row) in matrix.iter_mut().enumerate() {
            row[k] += most * damping.max(1e-9);
        }
        let right = (0..n).map(|k| {
            let terms = rows.iter().zip(residuals);
            -terms.map(|(row, residual)| row[k] * residual).sum::<f64>()
        });
        solved(matrix, right.collect())
    }

    /// Configuration after a unit of time, to first order.
    fn moved(&self, q: &[f64], velocities: &[f64]) -> Vec<f64> {
        let mut moved = q.to_vec();
        for joint in &self.chain.joints {
            let by = &velocities[joint.velocity.index()..];
            match joint.position {
                Position::Along { coordinate, .. } => moved[coordinate.index()] += by[0],
                Position::Manifold(Manifold::Spherical, first) => {
                    let entries = &mut moved[first.index()..][..4];
                    let [x, y, z, w] = [0, 1, 2, 3].map(|k| entries[k]);
                    let rates = [
                        w * by[0] + y * by[2] - z * by[1],
                        w * by[1] + z * by[0] - x * by[2],
                        w * by[2] + x * by[1] - y * by[0],
                        -(x * by[0] + y * by[1] + z * by[2]),
                    ];
                    for (entry, rate) in entries.iter_mut().zip(rates) {
                        *entry += 0.5 * rate;
                    }
                    let length = dot(entries, entries).sqrt();
                    for entry in entries {
                        *entry /= length;
                    }
                }
                Position::Taken => {}
                Position::Manifold(..) => unreachable!("no other joint is drawn"),
            }
        }
        moved
    }
}

/// The solution x of A x = y for a positive definite A.
fn solved(mut a: Vec<Vec<f64>>, mut y: Vec<f64>) -> Vec<f64> {
    let count = y.len();
    for k in 0..count {
        for i in k + 1..count {
            let factor = a[i][k] / a[k][k];
            let (above, below) = a.split_at_mut(i);
            for (entry, of_pivot) in below[0].iter_mut().zip(&above[k]).skip(k) {
                *entry -= factor * of_pivot;
            }
            y[i] -= factor * y[k];
        }
    }
    for k in (0..count).rev() {
        let later: f64 = (k + 1..count).map(|j| a[k][j] * y[j]).sum();
        y[k] = (y[k] - later) / a[k][k];
    }
    y
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

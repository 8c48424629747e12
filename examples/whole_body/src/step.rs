//! A step of whole-body control: torques and contact forces for an acceleration of the base, within the limits of ground
//! and actuators.
//!
//! In: the equation of motion of a robot whose first six velocities are those of its floating base, its feet, and the
//! desired acceleration of the base. Out: torques and contact forces, by one quadratic program that
//! [Clarabel](https://clarabel.org) solves.

use std::array::from_fn;

use clarabel::algebra::CscMatrix;
use clarabel::solver::SupportedConeT::{NonnegativeConeT, ZeroConeT};
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus};
use homogen::Screw;

/// Number of velocities of a floating base.
pub const BASE: usize = 6;

/// The equation of motion M q̈ + bias = τ + Σ Jᵗ f at a state.
#[derive(Clone, Copy, Debug)]
pub struct Equation<const N: usize> {
    /// M.
    pub mass_matrix: [[f64; N]; N],
    /// The bias torques of q̇ and gravity \[N m, N\].
    pub bias: [f64; N],
}

/// A foot in contact.
#[derive(Clone, Copy, Debug)]
pub struct Contact<const N: usize> {
    /// The geometric Jacobian of its frame.
    pub jacobian: [Screw<f64>; N],
    /// The rate of the Jacobian.
    pub rate: [Screw<f64>; N],
}

/// Limits of ground and actuators.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Coefficient of friction, in each of two directions of the ground.
    pub friction: f64,
    /// Largest torque of a joint \[N m\].
    pub torque: f64,
}

/// The result of a step.
#[derive(Clone, Copy, Debug)]
pub struct Step<const N: usize, const K: usize> {
    /// τ \[N m\], zero for the base.
    pub tau: [f64; N],
    /// The force on each foot, in the axes of frame 0 with z upwards \[N\].
    pub forces: [[f64; 3]; K],
}

/// Weights of the accelerations of joints, and of forces, relative to those of the base: small, so that they only choose
/// among equally good motions of the base.
const EASE: f64 = 1e-5;
/// Gain of the velocity of a foot in contact [1/s].
const STAND: f64 = 50.0;

/// The step with the desired acceleration of the base, or the nearest feasible one.
///
/// # Errors
/// The status of the solver if it finds no solution.
pub fn step<const N: usize, const K: usize>(
    equation: &Equation<N>,
    contacts: &[Contact<N>; K],
    qd: &[f64; N],
    wanted: &[f64; BASE],
    limits: Limits,
) -> Result<Step<N, K>, SolverStatus> {
    let mut rows = Rows::default();
    // The base has no actuator.
    for i in 0..BASE {
        rows.add(torque(equation, contacts, i, 1.0), -equation.bias[i]);
    }
    // Feet in contact do not accelerate.
    for contact in contacts {
        for axis in 0..3 {
            let entries = contact.jacobian.iter().enumerate();
            let entries = entries.map(|(j, screw)| (j, screw.b()[axis]));
            let sum = |screws: &[Screw<f64>; N]| -> f64 {
                let terms = screws.iter().zip(qd);
                terms.map(|(screw, rate)| screw.b()[axis] * rate).sum()
            };
            let rest = -sum(&contact.rate) - STAND * sum(&contact.jacobian);
            rows.add(entries.collect(), rest);
        }
    }
    let equal = rows.bounds.len();
    // Contact forces push, and are within the friction cone.
    for k in 0..K {
        let [x, y, z] = force_of::<N>(k);
        rows.add(vec![(z, -1.0)], 0.0);
        for along in [x, y] {
            for sign in [1.0, -1.0] {
                rows.add(vec![(along, sign), (z, -limits.friction)], 0.0);
            }
        }
    }
    for i in BASE..N {
        for sign in [1.0, -1.0] {
            let most = limits.torque - sign * equation.bias[i];
            rows.add(torque(equation, contacts, i, sign), most);
        }
    }
    let x = rows.solve(N + 3 * K, equal, wanted)?;

    let tau = from_fn(|i| {
        if i < BASE {
            return 0.0;
        }
        let terms = torque(equation, contacts, i, 1.0).into_iter();
        equation.bias[i] + terms.map(|(j, entry)| entry * x[j]).sum::<f64>()
    });
    let forces = from_fn(|k| force_of::<N>(k).map(|entry| x[entry]));
    Ok(Step { tau, forces })
}

/// The indices of the force of a foot among the unknowns: behind all accelerations.
fn force_of<const N: usize>(foot: usize) -> [usize; 3] {
    [0, 1, 2].map(|axis| N + 3 * foot + axis)
}

/// The coefficients of accelerations and forces in a torque, without the bias; times a sign.
fn torque<const N: usize, const K: usize>(
    equation: &Equation<N>,
    contacts: &[Contact<N>; K],
    row: usize,
    sign: f64,
) -> Vec<(usize, f64)> {
    let inertias = equation.mass_matrix[row].iter().enumerate();
    let inertias = inertias.map(|(j, entry)| (j, sign * entry));
    let forces = contacts.iter().enumerate().flat_map(|(k, contact)| {
        let lever = contact.jacobian[row].b();
        let places = force_of::<N>(k).into_iter().zip(lever);
        places
            .map(|(place, entry)| (place, -sign * entry))
            .collect::<Vec<_>>()
    });
    inertias.chain(forces).collect()
}

/// Rows of A and entries of b in A x + s = b.
#[derive(Default)]
struct Rows {
    /// Row, column and entry.
    entries: Vec<(usize, usize, f64)>,
    bounds: Vec<f64>,
}

impl Rows {
    fn add(&mut self, row: Vec<(usize, f64)>, bound: f64) {
        let number = self.bounds.len();
        let row = row.into_iter();
        self.entries
            .extend(row.map(|(column, entry)| (number, column, entry)));
        self.bounds.push(bound);
    }

    /// x with equations in the first rows, and upper bounds in the others.
    fn solve(
        self,
        unknowns: usize,
        equal: usize,
        wanted: &[f64; BASE],
    ) -> Result<Vec<f64>, SolverStatus> {
        let weights = (0..unknowns).map(|k| if k < BASE { 1.0 } else { EASE });
        let diagonal = (0..unknowns).collect::<Vec<_>>();
        let weights = CscMatrix::new_from_triplets(
            unknowns,
            unknowns,
            diagonal.clone(),
            diagonal,
            weights.collect(),
        );
        let pull = (0..unknowns).map(|k| wanted.get(k).map_or(0.0, |wanted| -wanted));
        let pull: Vec<f64> = pull.collect();
        let count = self.bounds.len();
        let rows = CscMatrix::new_from_triplets(
            count,
            unknowns,
            self.entries.iter().map(|entry| entry.0).collect(),
            self.entries.iter().map(|entry| entry.1).collect(),
            self.entries.iter().map(|entry| entry.2).collect(),
        );
        let cones = [ZeroConeT(equal), NonnegativeConeT(count - equal)];
        let settings = DefaultSettings {
            verbose: false,
            ..DefaultSettings::default()
        };
        let solver = DefaultSolver::new(&weights, &pull, &rows, &self.bounds, &cones, settings);
        let mut solver = solver.map_err(|_| SolverStatus::NumericalError)?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ok(solver.solution.x),
            status => Err(status),
        }
    }
}

//! Accelerations under loop constraints, by their definition, in 256 bits: J q̈ + γ = 0, and M q̈ + h − τ does no work
//! in any motion that the loops allow.
//!
//! In: a robot in dense matrices of frame 0, the residuals to use, a state. Out: q̈, and the pivots of the residuals.
//! The rank is found by elimination with the largest relative pivot first.

use homogen_codegen::Function;

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;
use crate::oracle::robot::Robot;

/// Relative pivot below which a residual depends on others.
const DEPENDENT: f64 = 1e-7;

/// Size below which a residual's own diagonal entry is negligible, relative to the largest.
const NEGLIGIBLE: f64 = 1e-3;

/// The equations of motion and of the loops at a state.
pub struct Equations {
    /// M, row by row.
    pub mass_matrix: Vec<Vec<Big>>,
    /// h.
    pub bias: Vec<Big>,
    /// The residuals.
    pub residuals: Vec<Big>,
    /// J, row by row.
    pub jacobian: Vec<Vec<Big>>,
    /// γ.
    pub jacobian_bias: Vec<Big>,
}

/// Accelerations at some torques.
pub struct Accelerations {
    /// q̈.
    pub qdd: Vec<Big>,
    /// The largest of the terms that its entries are sums of: M⁻¹ (τ − h) and M⁻¹ Jᵗ λ.
    pub largest_term: f64,
    /// The pivots of J M⁻¹ Jᵗ.
    pub pivots: Pivots,
}

/// Pivots of the residuals, relative to their diagonal entries.
#[derive(Clone, Copy, Debug)]
pub struct Pivots {
    /// The number of independent residuals.
    pub rank: usize,
    /// The smallest pivot of the independent ones.
    pub least: f64,
    /// The largest pivot of the dependent ones; 0 if there are none.
    pub left: f64,
}

impl Equations {
    /// The equations with all residuals of the description.
    #[must_use]
    pub fn at(robot: &Robot, arguments: &Arguments) -> Self {
        let of = |function| frame_0::evaluate(robot, function, 0, arguments);
        let bias = of(Function::Bias);
        let rows = |entries: Vec<Big>| entries.chunks(bias.len()).map(<[Big]>::to_vec).collect();
        Self {
            mass_matrix: rows(of(Function::MassMatrix)),
            residuals: of(Function::Constraint),
            jacobian: rows(of(Function::ConstraintJacobian)),
            jacobian_bias: of(Function::ConstraintBias),
            bias,
        }
    }

    /// The accelerations at these torques.
    #[must_use]
    pub fn accelerations(&self, tau: &[f64]) -> Accelerations {
        let forces = tau
            .iter()
            .zip(&self.bias)
            .map(|(tau, bias)| Big::new(*tau) - bias);
        let free = self.solved(&forces.collect::<Vec<_>>());
        let moved: Vec<Vec<Big>> = self.jacobian.iter().map(|row| self.solved(row)).collect();
        let wanted = self.jacobian.iter().zip(&self.jacobian_bias);
        let wanted: Vec<Big> = wanted
            .map(|(row, bias)| -(dot(row, &free) + bias))
            .collect();
        let (multipliers, pivots) = eliminated(products(&self.jacobian, &moved), wanted);
        let mut largest_term = free
            .iter()
            .fold(0.0, |most: f64, term| most.max(size(term)));
        let mut qdd = free;
        for (moved, multiplier) in moved.iter().zip(&multipliers) {
            for (entry, moved) in qdd.iter_mut().zip(moved) {
                let term = moved * multiplier;
                largest_term = largest_term.max(size(&term));
                *entry = &*entry + term;
            }
        }
        Accelerations {
            qdd,
            largest_term,
            pivots,
        }
    }

    /// The pivots of J Jᵗ, with the columns of these velocities alone.
    #[must_use]
    pub fn pivots_of(&self, velocities: &[usize]) -> Pivots {
        let only = |row: &Vec<Big>| {
            velocities
                .iter()
                .map(|&k| row[k].clone())
                .collect::<Vec<Big>>()
        };
        let rows: Vec<Vec<Big>> = self.jacobian.iter().map(only).collect();
        eliminated(products(&rows, &rows), vec![Big::zero(); rows.len()]).1
    }

    fn solved(&self, right: &[Big]) -> Vec<Big> {
        let right = right.iter().map(|entry| vec![entry.clone()]).collect();
        crate::oracle::solve::solve(self.mass_matrix.clone(), right).concat()
    }
}

fn products(rows: &[Vec<Big>], others: &[Vec<Big>]) -> Vec<Vec<Big>> {
    let row = |row: &Vec<Big>| others.iter().map(|other| dot(row, other)).collect();
    rows.iter().map(row).collect()
}

/// λ of S λ = y, by elimination with the largest relative pivot first; 0 for dependent residuals.
fn eliminated(mut s: Vec<Vec<Big>>, mut y: Vec<Big>) -> (Vec<Big>, Pivots) {
    let count = y.len();
    let own: Vec<f64> = (0..count).map(|k| s[k][k].to_f64()).collect();
    // A negligible residual depends on others, however large its relative pivot.
    let negligible = NEGLIGIBLE * own.iter().copied().fold(0.0, f64::max);
    let share = |s: &[Vec<Big>], k: usize| {
        let whole = own[k].max(negligible);
        if whole > 0.0 {
            s[k][k].to_f64() / whole
        } else {
            0.0
        }
    };
    let mut open: Vec<usize> = (0..count).collect();
    let mut order = Vec::new();
    let mut pivots = Pivots {
        rank: 0,
        least: 1.0,
        left: 0.0,
    };
    while let Some(&k) = open
        .iter()
        .max_by(|&&a, &&b| share(&s, a).total_cmp(&share(&s, b)))
    {
        let pivot = share(&s, k);
        if pivot < DEPENDENT {
            pivots.left = pivot.abs();
            break;
        }
        pivots.least = pivots.least.min(pivot);
        pivots.rank += 1;
        open.retain(|&other| other != k);
        order.push(k);
        let row = s[k].clone();
        let right = y[k].clone();
        for &i in &open {
            let factor = &s[i][k] / &row[k];
            for (entry, of_pivot) in s[i].iter_mut().zip(&row) {
                *entry = &*entry - &factor * of_pivot;
            }
            y[i] = &y[i] - &factor * &right;
        }
    }
    let mut found = vec![Big::zero(); count];
    for (place, &k) in order.iter().enumerate().rev() {
        let later = order[place + 1..].iter();
        let rest = later.fold(y[k].clone(), |rest, &j| rest - &s[k][j] * &found[j]);
        found[k] = rest / &s[k][k];
    }
    (found, pivots)
}

fn size(number: &Big) -> f64 {
    number.to_f64().abs()
}

/// a · b.
#[must_use]
pub fn dot(a: &[Big], b: &[Big]) -> Big {
    let products = a.iter().zip(b).map(|(a, b)| a * b);
    products.fold(Big::zero(), |sum, product| sum + product)
}

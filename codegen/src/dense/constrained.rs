//! What loops close, by products of 4×4 matrices: entries of the M of one frame that another sees, of
//! W M and of H M; and the motion that they leave.
//!
//! In: a [`Dense`]. Out: residuals, what velocities change them by, their accelerations, the forces of driven
//! joints, and q̈ and λ of M q̈ + h = τ + Jᵗ λ, J q̈ + γ = 0 by elimination, row after row of the loops, without
//! what depends on rows before them: of a pivot d beside the whole a the reciprocal is 1/d less its part of
//! 1/(1 + (d/εa)²)⁴.

use super::{Approximate, Dense, Matrix, Motion};
use crate::closure::Row;
use crate::expression::Arithmetic;
use crate::list::List;
use crate::space::VelocityId;

type Scalar = Approximate;

impl Dense {
    /// The residuals of all loops.
    pub(crate) fn residuals(&self) -> Vec<Scalar> {
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let seen = a.inverse().times(&b);
            let rows = closed.rows.iter();
            rows.map(move |&row| match row {
                Row::Along(k) => seen.0[k][3],
                Row::Product(i, j) => seen.0[i][j],
                Row::Inclined => seen.0[2][2] - closed.size,
                Row::Distance => {
                    let [x, y, z] = point(&seen);
                    let square = x * x + y * y + z * z;
                    (square - closed.size * closed.size) / (closed.size + closed.size)
                }
            })
        });
        rows.collect()
    }

    /// What each velocity changes each residual by, row by row.
    pub(crate) fn residual_rates(&self) -> Vec<List<VelocityId, Scalar>> {
        let zero = Scalar::exact(0.0);
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let back = a.inverse();
            let seen = back.times(&b);
            let mut rates = vec![self.state.qd.map(|_| zero); closed.rows.len()];
            for (frame, sign) in [(closed.frames[0], -1.0), (closed.frames[1], 1.0)] {
                for (k, screw) in self.moving(frame) {
                    let changed = back
                        .carries(screw)
                        .scaled(&Scalar::exact(sign))
                        .times(&seen);
                    for (rates, &row) in rates.iter_mut().zip(&closed.rows) {
                        rates[*k] = rates[*k] + change(row, closed.size, &seen, &changed);
                    }
                }
            }
            rates
        });
        rows.collect()
    }

    /// The acceleration of each residual where no velocity changes.
    pub(crate) fn residual_bias(&self) -> Vec<Scalar> {
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let back = a.inverse();
            let seen = back.times(&b);
            let motions = closed
                .frames
                .map(|frame| self.motion(frame, Motion::Coasting));
            let [(w_a, h_a), (w_b, h_b)] = &motions;
            let minus = |one: &Matrix<Scalar>, other: &Matrix<Scalar>| {
                one.plus(&other.scaled(&Scalar::exact(-1.0)))
            };
            // H_b = H_a + H + 2 W_a W of what B does against A.
            let w = minus(w_b, w_a);
            let twice = w_a.times(&w).scaled(&Scalar::exact(2.0));
            let h = minus(&minus(h_b, h_a), &twice);
            let [first, second] = [w, h].map(|matrix| back.carries(&matrix).times(&seen));
            let rows = closed.rows.iter();
            rows.map(move |&row| {
                let bias = change(row, closed.size, &seen, &second);
                if row != Row::Distance {
                    return bias;
                }
                let [x, y, z] = point(&first);
                bias + (x * x + y * y + z * z) / closed.size
            })
        });
        rows.collect()
    }

    /// q̈, and behind it λ, where that part ε of the whole is nothing.
    pub(crate) fn constrained(&self, vanishing: f64) -> Vec<Scalar> {
        let (rows, bias) = (self.residual_rates(), self.residual_bias());
        let held = self.torques(Motion::Coasting).into_iter();
        let forces = held.zip(Scalar::exactly(&self.state.tau));
        let forces: Vec<Scalar> = forces.map(|(held, tau)| tau - held).collect();
        let matrix = || self.mass_matrix().rows().map(Vec::from).collect();
        let solved = |forces: &[Scalar]| solve(matrix(), forces.to_vec());
        let free = solved(&forces);
        let moved: Vec<Vec<Scalar>> = rows.iter().map(|row| solved(row)).collect();
        let matrix: Vec<Vec<Scalar>> = (rows.iter())
            .map(|row| moved.iter().map(|moved| dot(row, moved)).collect())
            .collect();
        let mut multipliers: Vec<Scalar> = (rows.iter().zip(&bias))
            .map(|(row, bias)| -(dot(row, &free) + *bias))
            .collect();
        self.eliminate(matrix, &mut multipliers, vanishing);
        let mut accelerations = free;
        for (moved, multiplier) in moved.iter().zip(&multipliers) {
            for (acceleration, moved) in accelerations.iter_mut().zip(moved) {
                *acceleration = *acceleration + *moved * *multiplier;
            }
        }
        [accelerations, multipliers].concat()
    }

    /// τ of the velocities that are driven in the motion of the state, of which λ gives the others what they
    /// need: by the normal equations of that.
    pub(crate) fn driven(&self, vanishing: f64) -> Vec<Scalar> {
        let needed = self.torques(Motion::Driven);
        let driven = |k: VelocityId| self.posture.actuated().contains(&k);
        let passive: Vec<VelocityId> = needed.ids().filter(|&k| !driven(k)).collect();
        let rows = self.residual_rates();
        let some = |of: &List<VelocityId, Scalar>| -> Vec<Scalar> {
            passive.iter().map(|&k| of[k]).collect()
        };
        let own: Vec<Vec<Scalar>> = rows.iter().map(&some).collect();
        let mut multipliers: Vec<Scalar> = own.iter().map(|row| dot(row, &some(&needed))).collect();
        let matrix = own
            .iter()
            .map(|row| own.iter().map(|other| dot(row, other)).collect());
        self.eliminate(matrix.collect(), &mut multipliers, vanishing);
        let torque = |k: VelocityId| {
            let held = rows.iter().zip(&multipliers);
            held.fold(needed[k], |torque, (row, multiplier)| {
                torque - row[k] * *multiplier
            })
        };
        needed
            .ids()
            .map(|k| {
                if driven(k) {
                    torque(k)
                } else {
                    Scalar::exact(0.0)
                }
            })
            .collect()
    }

    /// λ of S λ = y in the place of y, row after row.
    fn eliminate(&self, mut matrix: Vec<Vec<Scalar>>, y: &mut [Scalar], vanishing: f64) {
        let wholes = self.wholes(&matrix);
        let mut reciprocals = Vec::new();
        for k in 0..y.len() {
            let reciprocal = reciprocal(matrix[k][k], wholes[k] * Scalar::exact(vanishing));
            reciprocals.push(reciprocal);
            for i in k + 1..y.len() {
                let factor = matrix[i][k] * reciprocal;
                let (above, below) = matrix.split_at_mut(i);
                for (entry, of_pivot) in below[0].iter_mut().zip(&above[k]).skip(k + 1) {
                    *entry = *entry - factor * *of_pivot;
                }
                y[i] = y[i] - factor * y[k];
            }
        }
        for k in (0..y.len()).rev() {
            let later = (k + 1..y.len()).map(|j| matrix[k][j] * y[j]);
            let left = later.fold(y[k], |sum, term| sum - term);
            y[k] = left * reciprocals[k];
        }
    }

    /// For each row the sum of the diagonal over the rows of its loop that measure the same.
    fn wholes(&self, matrix: &[Vec<Scalar>]) -> Vec<Scalar> {
        let mut wholes = Vec::new();
        for closed in self.loops() {
            let first = wholes.len();
            for row in &closed.rows {
                let same = |(_, other): &(usize, &Row)| other.kind() == row.kind();
                let rows = closed.rows.iter().enumerate().filter(same);
                let entries = rows.map(|(k, _)| matrix[first + k][first + k]);
                let sum = entries.reduce(|sum, entry| sum + entry);
                wholes.push(sum.unwrap_or(Scalar::exact(0.0)));
            }
        }
        wholes
    }
}

/// (1 − p⁴)/d, where p = t²/(d² + t²) is the part that `small`, t, has of both: 1/d, or nothing where d is
/// nothing beside t. Not a quotient by d itself, of which the roundings of literals may leave nothing known.
fn reciprocal(d: Scalar, small: Scalar) -> Scalar {
    let (square, small) = (d * d, small * small);
    let sum = square + small;
    if sum.size() == 0.0 {
        return Scalar::exact(0.0);
    }
    let (one, part) = (Scalar::exact(1.0), small / sum);
    d / sum * (one + part) * (one + part * part)
}

fn point(matrix: &Matrix<Scalar>) -> [Scalar; 3] {
    [0, 1, 2].map(|k| matrix.0[k][3])
}

/// What a row changes by where the matrix of B changes so.
fn change(row: Row, size: Scalar, seen: &Matrix<Scalar>, changed: &Matrix<Scalar>) -> Scalar {
    match row {
        Row::Along(k) => changed.0[k][3],
        Row::Product(i, j) => changed.0[i][j],
        Row::Inclined => changed.0[2][2],
        Row::Distance => dot(&point(seen), &point(changed)) / size,
    }
}

fn dot(a: &[Scalar], b: &[Scalar]) -> Scalar {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(Scalar::literal(0.0), |sum, product| sum + product)
}

/// x of A x = y, where A is positive definite.
fn solve(mut a: Vec<Vec<Scalar>>, mut y: Vec<Scalar>) -> Vec<Scalar> {
    let count = y.len();
    for k in 0..count {
        for i in k + 1..count {
            let factor = a[i][k] / a[k][k];
            let (above, below) = a.split_at_mut(i);
            for (entry, of_pivot) in below[0].iter_mut().zip(&above[k]).skip(k) {
                *entry = *entry - factor * *of_pivot;
            }
            y[i] = y[i] - factor * y[k];
        }
    }
    for k in (0..count).rev() {
        let later = (k + 1..count).map(|j| a[k][j] * y[j]);
        y[k] = later.fold(y[k], |sum, term| sum - term) / a[k][k];
    }
    y
}

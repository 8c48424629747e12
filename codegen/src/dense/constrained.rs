//! Closed loops, by products of 4×4 matrices: entries of M of frame B in frame A, of W M and of H M; and the
//! constrained motion.
//!
//! In: a [`Dense`]. Out: residuals, their derivatives by velocities, their accelerations, the forces of actuated
//! joints, and q̈ and λ of M q̈ + h = τ + Jᵗ λ, J q̈ + γ = 0 by elimination of one row of the loops after the other,
//! without the parts that depend on rows before them: for a pivot d relative to the whole a, the reciprocal is 1/d if
//! d is far above ε a, and negligible if d is far below it or if roundings of the description leave no digit of a.

use super::{Approximate, Dense, Matrix, MotionOrder};
use crate::closure::ResidualKind;
use crate::expression::Arithmetic;
use crate::list::{self, List};
use crate::space::{Variable, VelocityId};

/// The equations of the loops: each row of J times a matrix, and the products with the rows of J.
struct Equations {
    moved: Vec<Vec<Approximate>>,
    matrix: Vec<Vec<Approximate>>,
}

impl Dense {
    /// The residuals of all loops.
    pub(crate) fn residuals(&self) -> Vec<Approximate> {
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let seen = a.inverse().times(&b);
            let rows = closed.rows.iter();
            rows.map(move |&row| match row {
                ResidualKind::Along(k) => seen.0[k][3],
                ResidualKind::Product(i, j) => seen.0[i][j],
                ResidualKind::Inclined => seen.0[2][2] - closed.size,
                ResidualKind::Distance => {
                    let [x, y, z] = point(&seen);
                    let square = x * x + y * y + z * z;
                    (square - closed.size * closed.size) / (closed.size + closed.size)
                }
            })
        });
        rows.collect()
    }

    /// Each residual's size relative to the largest change by a velocity of 1 of a residual of its loop with its unit.
    pub(crate) fn relative_residuals(&self) -> Vec<f64> {
        let rates = self.residual_rates().into_iter();
        let rates: Vec<f64> = rates
            .map(|row| {
                row.iter()
                    .fold(0.0, |most: f64, rate| most.max(rate.to_f64().abs()))
            })
            .collect();
        let residuals = self.residuals();
        let mut shares = Vec::with_capacity(residuals.len());
        for closed in self.loops() {
            let first = shares.len();
            for row in &closed.rows {
                let alike = closed.rows.iter().zip(&rates[first..]);
                let alike = alike.filter(|(other, _)| other.kind() == row.kind());
                let most = alike.fold(0.0, |most: f64, (_, rate)| most.max(*rate));
                let size = residuals[shares.len()].to_f64().abs();
                shares.push(if size > 0.0 { size / most } else { 0.0 });
            }
        }
        shares
    }

    /// The derivative of each residual by each velocity, by rows.
    pub(crate) fn residual_rates(&self) -> Vec<List<VelocityId, Approximate>> {
        let zero = Approximate::exact(0.0);
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let back = a.inverse();
            let seen = back.times(&b);
            let mut rates = vec![List::filled(zero, self.state.velocities()); closed.rows.len()];
            for (frame, sign) in [(closed.frames[0], -1.0), (closed.frames[1], 1.0)] {
                for (k, screw) in self.moving(frame) {
                    let changed = back
                        .carries(screw)
                        .scaled(&Approximate::exact(sign))
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

    /// The acceleration of each residual at constant velocities.
    pub(crate) fn residual_bias(&self) -> Vec<Approximate> {
        let rows = self.loops().iter().flat_map(|closed| {
            let [a, b] = closed.frames.map(|frame| self.pose(frame));
            let back = a.inverse();
            let seen = back.times(&b);
            let motions = closed
                .frames
                .map(|frame| self.motion(frame, MotionOrder::Coasting));
            let [(w_a, h_a), (w_b, h_b)] = &motions;
            let minus = |one: &Matrix<Approximate>, other: &Matrix<Approximate>| {
                one.plus(&other.scaled(&Approximate::exact(-1.0)))
            };
            // H_b = H_a + H + 2 W_a W with the motion of B relative to A.
            let w = minus(w_b, w_a);
            let twice = w_a.times(&w).scaled(&Approximate::exact(2.0));
            let h = minus(&minus(h_b, h_a), &twice);
            let [first, second] = [w, h].map(|matrix| back.carries(&matrix).times(&seen));
            let rows = closed.rows.iter();
            rows.map(move |&row| {
                let bias = change(row, closed.size, &seen, &second);
                if row != ResidualKind::Distance {
                    return bias;
                }
                let [x, y, z] = point(&first);
                bias + (x * x + y * y + z * z) / closed.size
            })
        });
        rows.collect()
    }

    /// q̈ followed by λ, where parts below ε of the whole count as zero.
    pub(crate) fn constrained(&self, zero_pivot: f64) -> Vec<Approximate> {
        let (rows, bias) = (self.residual_rates(), self.residual_bias());
        let held = self.torques(MotionOrder::Coasting).into_iter();
        let forces = held.zip(self.state.of_velocities(Variable::Tau));
        let forces: Vec<Approximate> = forces.map(|(held, tau)| tau - held).collect();
        let mut accelerations = self.free(&forces);
        let Equations { moved, matrix } = self.by_mass_matrix(&rows);
        let mut multipliers: Vec<Approximate> = (rows.iter().zip(&bias))
            .map(|(row, bias)| -(dot(row, &accelerations) + *bias))
            .collect();
        self.eliminate(matrix, &mut multipliers, zero_pivot);
        for (moved, multiplier) in moved.iter().zip(&multipliers) {
            for (acceleration, moved) in accelerations.iter_mut().zip(moved) {
                *acceleration = *acceleration + *moved * *multiplier;
            }
        }
        [accelerations, multipliers].concat()
    }

    /// q̈ with open loops.
    fn free(&self, forces: &[Approximate]) -> Vec<Approximate> {
        let matrix = self.mass_matrix().rows().map(Vec::from).collect();
        solve(matrix, forces.to_vec())
    }

    /// J M⁻¹ Jᵗ.
    fn by_mass_matrix(&self, rows: &[List<VelocityId, Approximate>]) -> Equations {
        let moved: Vec<Vec<Approximate>> = rows.iter().map(|row| self.free(row)).collect();
        let matrix = rows
            .iter()
            .map(|row| moved.iter().map(|moved| dot(row, moved)).collect());
        Equations {
            matrix: matrix.collect(),
            moved,
        }
    }

    /// J Jᵗ of the velocities without an actuator.
    fn by_passive(&self, rows: &[List<VelocityId, Approximate>]) -> Equations {
        let moved: Vec<Vec<Approximate>> = rows.iter().map(|row| self.passive(row)).collect();
        let row = |row: &Vec<Approximate>| moved.iter().map(|other| dot(row, other)).collect();
        Equations {
            matrix: moved.iter().map(row).collect(),
            moved,
        }
    }

    /// The entries of the velocities without an actuator.
    fn passive(&self, of: &List<VelocityId, Approximate>) -> Vec<Approximate> {
        let passive = of
            .ids()
            .filter(|k| !self.configuration.actuated().contains(k));
        passive.map(|k| of[k]).collect()
    }

    /// τ of the actuated velocities for the motion of the state, where λ balances the others: by the normal equations.
    pub(crate) fn actuated(&self, zero_pivot: f64) -> Vec<Approximate> {
        let needed = self.torques(MotionOrder::Accelerated);
        let rows = self.residual_rates();
        let Equations { moved, matrix } = self.by_passive(&rows);
        let passive = self.passive(&needed);
        let mut multipliers: Vec<Approximate> =
            moved.iter().map(|row| dot(row, &passive)).collect();
        self.eliminate(matrix, &mut multipliers, zero_pivot);
        let torque = |k: VelocityId| {
            let held = rows.iter().zip(&multipliers);
            held.fold(needed[k], |torque, (row, multiplier)| {
                torque - row[k] * *multiplier
            })
        };
        let is_actuated = |k: VelocityId| self.configuration.actuated().contains(&k);
        needed
            .ids()
            .map(|k| {
                if is_actuated(k) {
                    torque(k)
                } else {
                    Approximate::exact(0.0)
                }
            })
            .collect()
    }

    /// The pivot of each row relative to the whole, for accelerations: below ε if the row depends on those before it,
    /// far above ε otherwise.
    pub(crate) fn independence(&self, zero_pivot: f64) -> Vec<f64> {
        let rows = self.residual_rates();
        let Equations { matrix, .. } = self.by_mass_matrix(&rows);
        let mut nothing = vec![Approximate::exact(0.0); rows.len()];
        self.eliminate(matrix, &mut nothing, zero_pivot)
    }

    /// J M⁻¹ Jᵗ, with each row and column divided by the square root of its whole; zeros where roundings of the
    /// description leave no digit of the whole.
    pub(crate) fn scaled_schur_complement(&self) -> Vec<Vec<f64>> {
        let Equations { matrix, .. } = self.by_mass_matrix(&self.residual_rates());
        let wholes = self.wholes(&matrix).into_iter();
        let scales: Vec<f64> = wholes
            .map(|whole| {
                if is_known(whole) {
                    whole.to_f64().sqrt().recip()
                } else {
                    0.0
                }
            })
            .collect();
        let rows = matrix.iter().zip(&scales);
        rows.map(|(row, by_row)| {
            let entries = row.iter().zip(&scales);
            entries
                .map(|(entry, by_column)| entry.to_f64() * by_row * by_column)
                .collect()
        })
        .collect()
    }

    /// Changes the order in which residuals are eliminated.
    pub(crate) fn eliminate_in(&mut self, order: Vec<usize>) {
        self.configuration.eliminate_in(order);
    }

    /// The relative change of a solution, to its largest entry, if ε is halved or doubled, or if rounding changes
    /// each pivot by a part of the whole.
    pub(crate) fn sensitivity(
        &mut self,
        solution: impl Fn(&Self, f64) -> Vec<Approximate>,
        (zero_pivot, rounding): (f64, f64),
    ) -> f64 {
        let mut at = |times: f64, disturbance: f64| {
            self.disturbance = disturbance;
            solution(self, times * zero_pivot)
        };
        let whole = at(1.0, 0.0);
        let others = [at(0.5, 0.0), at(2.0, 0.0), at(1.0, rounding)];
        self.disturbance = 0.0;
        let largest = whole.iter().map(|entry| entry.size()).fold(0.0, f64::max);
        let changes = others.iter().map(|other| {
            let pairs = other.iter().zip(&whole);
            pairs.map(|(a, b)| (*a - *b).size()).fold(0.0, f64::max)
        });
        let change = changes.fold(0.0, f64::max);
        if change > 0.0 { change / largest } else { 0.0 }
    }

    /// The number of velocities that change a residual.
    pub(crate) fn held(&self) -> usize {
        let rows = self.residual_rates();
        let velocities = list::ids(self.state.velocities());
        let changes = |k: &VelocityId| rows.iter().any(|row| row[*k].size() > row[*k].error);
        velocities.filter(changes).count()
    }

    /// Solves S λ = y in place of y, row after row in the order of elimination; returns the pivots relative to the
    /// wholes.
    fn eliminate(
        &self,
        mut matrix: Vec<Vec<Approximate>>,
        y: &mut [Approximate],
        zero_pivot: f64,
    ) -> Vec<f64> {
        let (wholes, order) = (self.wholes(&matrix), self.configuration.elimination());
        let mut reciprocals = vec![Approximate::exact(0.0); y.len()];
        let mut shares = vec![0.0; y.len()];
        for (place, &k) in order.iter().enumerate() {
            let whole = wholes[k];
            let pivot = matrix[k][k] + whole * Approximate::exact(self.disturbance);
            if is_known(whole) {
                reciprocals[k] = reciprocal(pivot, whole * Approximate::exact(zero_pivot));
                shares[k] = pivot.size() / whole.size();
            }
            let later = &order[place + 1..];
            for &i in later {
                let factor = matrix[i][k] * reciprocals[k];
                for &j in later {
                    matrix[i][j] = matrix[i][j] - factor * matrix[k][j];
                }
                y[i] = y[i] - factor * y[k];
            }
        }
        for (place, &k) in order.iter().enumerate().rev() {
            let later = order[place + 1..].iter().map(|&j| matrix[k][j] * y[j]);
            let left = later.fold(y[k], |sum, term| sum - term);
            y[k] = left * reciprocals[k];
        }
        shares
    }

    /// For each row the sum of the diagonal over the rows of its loop with the same unit.
    fn wholes(&self, matrix: &[Vec<Approximate>]) -> Vec<Approximate> {
        let mut wholes = Vec::new();
        for closed in self.loops() {
            let first = wholes.len();
            for row in &closed.rows {
                let same = |(_, other): &(usize, &ResidualKind)| other.kind() == row.kind();
                let rows = closed.rows.iter().enumerate().filter(same);
                let entries = rows.map(|(k, _)| matrix[first + k][first + k]);
                let sum = entries.reduce(|sum, entry| sum + entry);
                wholes.push(sum.unwrap_or(Approximate::exact(0.0)));
            }
        }
        wholes
    }
}

/// True if roundings of the description leave a digit.
fn is_known(whole: Approximate) -> bool {
    whole.size() > whole.error || whole.error.is_infinite()
}

/// (1 − p⁴)/d, where p = t²/(d² + t²) is the share of t, `small`: 1/d, or 0 if d is negligible relative to t. It
/// avoids a quotient by d itself, of which the roundings of literals may leave no digit.
fn reciprocal(d: Approximate, small: Approximate) -> Approximate {
    let (square, small) = (d * d, small * small);
    let sum = square + small;
    if sum.size() == 0.0 {
        return Approximate::exact(0.0);
    }
    let (one, part) = (Approximate::exact(1.0), small / sum);
    d / sum * (one + part) * (one + part * part)
}

fn point(matrix: &Matrix<Approximate>) -> [Approximate; 3] {
    [0, 1, 2].map(|k| matrix.0[k][3])
}

/// The change of a residual for a change of the pose of B.
fn change(
    row: ResidualKind,
    size: Approximate,
    seen: &Matrix<Approximate>,
    changed: &Matrix<Approximate>,
) -> Approximate {
    match row {
        ResidualKind::Along(k) => changed.0[k][3],
        ResidualKind::Product(i, j) => changed.0[i][j],
        ResidualKind::Inclined => changed.0[2][2],
        ResidualKind::Distance => dot(&point(seen), &point(changed)) / size,
    }
}

fn dot(a: &[Approximate], b: &[Approximate]) -> Approximate {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(Approximate::literal(0.0), |sum, product| sum + product)
}

/// x of A x = y, where A is positive definite.
fn solve(mut a: Vec<Vec<Approximate>>, mut y: Vec<Approximate>) -> Vec<Approximate> {
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

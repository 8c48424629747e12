//! Exciting motions for identification: Fourier series whose regressor has a small condition number (Swevers et al.,
//! "Optimal robot excitation and identification", 1997).
//!
//! In: a robot with limits, its regressor Y, and the gradient of uᵀ Y v by a state. Out: a periodic motion within the
//! limits of position and velocity, and the condition number after each iteration.
//!
//! The singular values σ of the stacked regressor W have ∂σ = uᵀ ∂W v, with the singular vectors u and v. For one state,
//! Y v are the torques of a robot whose parameters are v: ∂(uᵀ Y v) is a vector–Jacobian product of inverse dynamics.

use std::array::from_fn;
use std::f64::consts::TAU;

use homogen::Robot;
use homogen_random::Random;
use nalgebra::{DMatrix, DVector};

use crate::motion::Desired;

/// Torques that are linear in `P` unknown parameters.
pub trait Regression<const N: usize, const P: usize> {
    /// Y(q, q̇, q̈), a row for each torque.
    fn rows(&self, state: &Desired<N>) -> [[f64; P]; N];

    /// The gradient of uᵀ Y v by q, q̇ and q̈.
    fn gradient(&self, state: &Desired<N>, u: &[f64; N], v: &[f64; P]) -> Desired<N>;
}

/// A periodic motion: each coordinate is a mean plus harmonics.
#[derive(Clone, Debug)]
pub struct Series<const N: usize> {
    /// The period \[s\].
    pub period: f64,
    /// Number of harmonics.
    pub harmonics: u32,
    /// For each coordinate in turn, the factors of the basis functions \[rad\].
    pub factors: DVector<f64>,
}

impl<const N: usize> Series<N> {
    /// The basis functions 1, sin(kωt)/k and cos(kωt)/k with their first and second derivatives by time. Divided by k, all
    /// harmonics have the same rates, and factors one scale.
    fn basis(&self, t: f64) -> Vec<[f64; 3]> {
        let harmonics = (1..=self.harmonics).flat_map(|k| {
            let share = 1.0 / f64::from(k);
            let rate = TAU / self.period / share;
            let (sin, cos) = (rate * t).sin_cos();
            let derivatives = |value, slope| [value, rate * slope, -rate * rate * value];
            [derivatives(sin, cos), derivatives(cos, -sin)].map(|entry| entry.map(|x| x * share))
        });
        std::iter::once([1.0, 0.0, 0.0]).chain(harmonics).collect()
    }

    /// The motion at a time \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> Desired<N> {
        let basis = self.basis(t);
        let of = |order: usize, joint: usize| {
            let factors = self.factors.iter().skip(joint * basis.len());
            basis.iter().zip(factors).map(|(b, x)| b[order] * x).sum()
        };
        from_fn(|order| from_fn(|joint| of(order, joint)))
    }

    /// `count` times, evenly over a period.
    fn times(&self, count: u32) -> impl Iterator<Item = f64> {
        let step = self.period / f64::from(count);
        (0..count).map(move |k| step * f64::from(k))
    }

    /// Adds the gradient by a state at a time to that by the factors.
    fn add_gradient(&self, t: f64, state: &Desired<N>, gradient: &mut DVector<f64>) {
        let basis = self.basis(t);
        for joint in 0..N {
            for (function, values) in basis.iter().enumerate() {
                gradient[joint * basis.len() + function] += (0..3)
                    .map(|order| values[order] * state[order][joint])
                    .sum::<f64>();
            }
        }
    }
}

/// The logarithm of the condition number of a motion's regressor, at `count` times of its period, and its gradient by
/// the factors.
///
/// The gradient is undefined where singular values are equal, and where a rate with Coulomb friction changes its sign.
///
/// # Panics
/// If a number is NaN.
pub fn condition<const N: usize, const P: usize>(
    robot: &impl Regression<N, P>,
    motion: &Series<N>,
    count: u32,
) -> (f64, DVector<f64>) {
    let states: Vec<_> = motion.times(count).map(|t| (t, motion.at(t))).collect();
    let rows: Vec<_> = states.iter().map(|(_, state)| robot.rows(state)).collect();
    let stacked =
        DMatrix::from_row_iterator(N * rows.len(), P, rows.iter().flatten().flatten().copied());
    let decomposition = stacked.svd(false, true);
    let vectors = decomposition.v_t.expect("they are asked for");
    // In descending order.
    let values = decomposition.singular_values;
    let mut gradient = DVector::zeros(motion.factors.len());
    for (sign, k) in [(1.0, 0), (-1.0, P - 1)] {
        let v: [f64; P] = from_fn(|j| vectors[(k, j)]);
        for ((t, state), rows) in states.iter().zip(&rows) {
            // ∂ ln σ = uᵀ ∂W v / σ with u = W v / σ.
            let u = rows.map(|row| {
                let torque: f64 = row.iter().zip(&v).map(|(y, v)| y * v).sum();
                sign * torque / values[k].powi(2)
            });
            motion.add_gradient(*t, &robot.gradient(state, &u, &v), &mut gradient);
        }
    }
    ((values[0] / values[P - 1]).ln(), gradient)
}

/// The design of an exciting motion.
#[derive(Clone, Copy, Debug)]
pub struct Design {
    /// The period \[s\].
    pub period: f64,
    /// Number of harmonics.
    pub harmonics: u32,
    /// Number of times in a period at which regressor and limits are evaluated.
    pub samples: u32,
    /// Share of the limits that the motion may use.
    pub share: f64,
    /// Weight of the logarithmic barriers of the limits.
    pub barrier: f64,
    /// Maximum number of iterations.
    pub iterations: usize,
}

/// The objective of a design at a motion: ln of the condition number plus barriers.
struct Cost {
    value: f64,
    gradient: DVector<f64>,
    condition: f64,
}

impl Design {
    /// A motion whose condition number is small, within the limits, and the condition numbers at the beginning and after
    /// each iteration. It starts from small random harmonics about the middle of the limits, and ends at a local minimum,
    /// or at a step of Coulomb friction which the gradient does not see.
    ///
    /// # Panics
    /// If a joint has no limits or the start is not within them, or if its regressor is singular.
    pub fn solve<R, const N: usize, const P: usize>(
        &self,
        robot: &R,
        random: &mut Random,
    ) -> (Series<N>, Vec<f64>)
    where
        R: Robot<N> + Regression<N, P>,
    {
        let limits = [R::LOWER, R::UPPER, R::MAX_VELOCITY];
        assert!(
            limits.as_flattened().iter().all(|limit| limit.is_finite()),
            "a joint has no limits of position or velocity; give it limits in the description"
        );
        let mut motion = self.start::<R, N>(random);
        let mut cost = self
            .cost(robot, &motion)
            .expect("small harmonics are within the limits");
        assert!(
            cost.value.is_finite(),
            "the regressor is singular: leave out parameters that torques do not determine"
        );
        let mut conditions = vec![cost.condition];
        // The method of Broyden, Fletcher, Goldfarb and Shanno: `inverse` approximates the inverse Hessian.
        let identity = DMatrix::identity(motion.factors.len(), motion.factors.len());
        let mut inverse = &identity * 1e-2;
        for _ in 0..self.iterations {
            let direction = -&inverse * &cost.gradient;
            let slope = direction.dot(&cost.gradient);
            // Line search: halve the step until it is within the limits and the cost decreases enough.
            let tried = (0..20)
                .map(|halvings| 0.5_f64.powi(halvings))
                .find_map(|share| {
                    let factors = &motion.factors + &direction * share;
                    let next = Series {
                        factors,
                        ..motion.clone()
                    };
                    let next_cost = self.cost(robot, &next)?;
                    (next_cost.value < cost.value + 1e-4 * share * slope)
                        .then_some((next, next_cost))
                });
            let Some((next, next_cost)) = tried else {
                break;
            };
            let moved = &next.factors - &motion.factors;
            let changed = &next_cost.gradient - &cost.gradient;
            let curvature = moved.dot(&changed);
            // Otherwise the update would not be positive definite.
            if curvature > 0.0 {
                let left = &identity - &moved * changed.transpose() / curvature;
                inverse =
                    &left * inverse * left.transpose() + &moved * moved.transpose() / curvature;
            }
            (motion, cost) = (next, next_cost);
            conditions.push(cost.condition);
        }
        (motion, conditions)
    }

    /// Small random harmonics about the middle of the limits.
    fn start<R: Robot<N>, const N: usize>(&self, random: &mut Random) -> Series<N> {
        let factors = (0..N).flat_map(|joint| {
            let middle = 0.5 * (R::LOWER[joint] + R::UPPER[joint]);
            let small: Vec<f64> = (0..2 * self.harmonics)
                .map(|_| 0.1 * random.odd())
                .collect();
            std::iter::once(middle).chain(small)
        });
        let factors: Vec<f64> = factors.collect();
        Series {
            period: self.period,
            harmonics: self.harmonics,
            factors: DVector::from_vec(factors),
        }
    }

    /// The cost of a motion; `None` outside the limits.
    fn cost<R, const N: usize, const P: usize>(&self, robot: &R, motion: &Series<N>) -> Option<Cost>
    where
        R: Robot<N> + Regression<N, P>,
    {
        let mut barrier = 0.0;
        let mut barrier_gradient = DVector::zeros(motion.factors.len());
        for t in motion.times(self.samples) {
            let [q, qd, _] = motion.at(t);
            let mut by = [[0.0; N]; 3];
            for joint in 0..N {
                let range = [R::LOWER[joint], R::UPPER[joint]];
                let rates = [-R::MAX_VELOCITY[joint], R::MAX_VELOCITY[joint]];
                for (order, x, [lower, upper]) in [(0, q[joint], range), (1, qd[joint], rates)] {
                    let half = 0.5 * self.share * (upper - lower);
                    let off = (x - 0.5 * (lower + upper)) / half;
                    let room = 1.0 - off * off;
                    if room <= 0.0 {
                        return None;
                    }
                    barrier -= room.ln();
                    by[order][joint] = 2.0 * off / (room * half);
                }
            }
            motion.add_gradient(t, &by, &mut barrier_gradient);
        }
        let weight = self.barrier / f64::from(self.samples);
        let (logarithm, gradient) = condition(robot, motion, self.samples);
        Some(Cost {
            value: logarithm + weight * barrier,
            gradient: gradient + barrier_gradient * weight,
            condition: logarithm.exp(),
        })
    }
}

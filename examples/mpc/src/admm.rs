//! Model-predictive control with bounds, by the alternating direction method of multipliers with a cached gain: the
//! algorithm of TinyMPC (Nguyen, Schoedel, Alavilli, Plancher and Manchester, ICRA 2024, arXiv 2310.16985).
//!
//! In: A, B, weights and bounds; then, each control step, a state. Out: the input to apply. Nothing allocates, and a step
//! has a bounded number of iterations, each of which is products of small matrices.
//!
//! Minimises Σ ½ xᵀ Q x + ½ uᵀ R u over a horizon. Each iteration solves the problem without bounds, with ρ added to all
//! weights, moves the result into the bounds, and adds the difference to the multipliers. The gain of the first part is
//! that of an infinite horizon, so that only its constant parts change.

use core::array::from_fn;

/// A problem with `X` states and `U` inputs.
#[derive(Clone, Copy, Debug)]
pub struct Problem<const X: usize, const U: usize> {
    /// ∂x⁺/∂x.
    pub a: [[f32; X]; X],
    /// ∂x⁺/∂u.
    pub b: [[f32; U]; X],
    /// The diagonal of Q.
    pub state_weights: [f32; X],
    /// The diagonal of R.
    pub input_weights: [f32; U],
    /// Bounds of x.
    pub state_bounds: Bounds<X>,
    /// Bounds of u.
    pub input_bounds: Bounds<U>,
}

/// Bounds of the entries of a vector.
#[derive(Clone, Copy, Debug)]
pub struct Bounds<const N: usize> {
    /// The least values.
    pub lower: [f32; N],
    /// The largest values.
    pub upper: [f32; N],
    /// ρ, the weights of differences from the bounds; 0 for an entry without bounds.
    pub penalties: [f32; N],
}

/// The controller: the cached matrices, and the last solution, where the next step starts. `H` is the number of inputs
/// ahead.
#[derive(Clone, Debug)]
pub struct Controller<const X: usize, const U: usize, const H: usize> {
    problem: Problem<X, U>,
    /// K of u = −K x − d.
    gain: [[f32; X]; U],
    /// (R + ρ + Bᵗ P B)⁻¹.
    inverse: [[f32; U]; U],
    /// A − B K.
    closed: [[f32; X]; X],
    /// d of each step.
    shifts: [[f32; U]; H],
    /// Inputs within the bounds, and the sums of what was outside.
    inputs: [Bounded<U>; H],
    /// The same for the states after each input.
    states: [Bounded<X>; H],
}

/// Entries within their bounds, and their scaled multipliers.
#[derive(Clone, Copy, Debug)]
struct Bounded<const N: usize> {
    value: [f32; N],
    multiplier: [f32; N],
}

impl<const N: usize> Bounded<N> {
    const ZERO: Self = Self {
        value: [0.0; N],
        multiplier: [0.0; N],
    };

    /// Moves `free` into the bounds, and returns how far it is from them and from the last value.
    fn update(&mut self, free: &[f32; N], bounds: &Bounds<N>) -> f32 {
        let mut residual: f32 = 0.0;
        for (i, free) in free.iter().enumerate() {
            if bounds.penalties[i] == 0.0 {
                continue;
            }
            let sum = free + self.multiplier[i];
            let value = sum.max(bounds.lower[i]).min(bounds.upper[i]);
            let off = (free - value).abs();
            let moved = (value - self.value[i]).abs();
            residual = residual.max(off).max(moved);
            self.value[i] = value;
            self.multiplier[i] = sum - value;
        }
        residual
    }

    /// The linear cost of the difference from the bounds: −ρ (value − multiplier).
    fn cost(&self, bounds: &Bounds<N>) -> [f32; N] {
        from_fn(|i| bounds.penalties[i] * (self.multiplier[i] - self.value[i]))
    }
}

/// An input, and the iterations that it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found<const U: usize> {
    /// The first input, within its bounds.
    pub input: [f32; U],
    /// Number of iterations.
    pub iterations: u32,
    /// Largest distance of inputs and states from their bounds, or from those of the last iteration.
    pub residual: f32,
}

impl<const X: usize, const U: usize, const H: usize> Controller<X, U, H> {
    /// The controller of a problem; `None` if the recursion for its gain does not converge in `iterations`, or for NaN.
    #[must_use]
    pub fn new(problem: &Problem<X, U>, iterations: u32) -> Option<Self> {
        let Problem { a, b, .. } = problem;
        let input_weight = |i: usize| problem.input_weights[i] + problem.input_bounds.penalties[i];
        let state_weight = |i: usize| problem.state_weights[i] + problem.state_bounds.penalties[i];
        let mut gain = [[0.0; X]; U];
        // P, of the cost ½ xᵀ P x from a state on.
        let mut ahead: [[f32; X]; X] =
            from_fn(|i| from_fn(|j| if i == j { state_weight(i) } else { 0.0 }));
        for _ in 0..iterations {
            let left = transposed_product(b, &ahead);
            let mut twice = product(&left, b);
            for (i, row) in twice.iter_mut().enumerate() {
                row[i] += input_weight(i);
            }
            let inverse = inverted(twice)?;
            let next = product(&inverse, &product(&left, a));
            let reduced = product(b, &next);
            let closed: [[f32; X]; X] = from_fn(|i| from_fn(|j| a[i][j] - reduced[i][j]));
            let after = transposed_product(a, &product(&ahead, &closed));
            ahead = from_fn(|i| {
                from_fn(|j| {
                    let own = if i == j { state_weight(i) } else { 0.0 };
                    0.5 * (after[i][j] + after[j][i]) + own
                })
            });
            let pairs = gain.as_flattened().iter().zip(next.as_flattened());
            let change = pairs.fold(0.0_f32, |most, (old, new)| most.max((old - new).abs()));
            let size = next
                .as_flattened()
                .iter()
                .fold(0.0_f32, |most, x| most.max(x.abs()));
            gain = next;
            // Rounding in single precision changes the gain of an arm by up to 6e-5 of its largest entry.
            if change <= 1e-4 * size {
                return Some(Self {
                    problem: *problem,
                    gain,
                    inverse,
                    closed,
                    shifts: [[0.0; U]; H],
                    inputs: [Bounded::ZERO; H],
                    states: [Bounded::ZERO; H],
                });
            }
        }
        None
    }

    /// The gain K of u = −K x where no bound is near.
    #[must_use]
    pub fn gain(&self) -> &[[f32; X]; U] {
        &self.gain
    }

    /// Changes the bounds of the inputs.
    pub fn bound_inputs(&mut self, lower: [f32; U], upper: [f32; U]) {
        let bounds = &mut self.problem.input_bounds;
        (bounds.lower, bounds.upper) = (lower, upper);
    }

    /// The input at a state, in at most `most` iterations, fewer if the residual is at most `tolerance`.
    pub fn step(&mut self, state: &[f32; X], most: u32, tolerance: f32) -> Found<U> {
        let mut found = Found {
            input: self.inputs[0].value,
            iterations: 0,
            residual: f32::INFINITY,
        };
        while found.iterations < most && found.residual > tolerance {
            found.residual = self.forward(state);
            self.backward();
            found.iterations += 1;
        }
        found.input = self.inputs[0].value;
        found
    }

    /// Inputs and states without bounds, then moved into them; the residual.
    fn forward(&mut self, state: &[f32; X]) -> f32 {
        let Problem { a, b, .. } = &self.problem;
        let mut x = *state;
        let mut residual: f32 = 0.0;
        for k in 0..H {
            let feedback = times(&self.gain, &x);
            let u = from_fn(|i| -feedback[i] - self.shifts[k][i]);
            let (free, forced) = (times(a, &x), times(b, &u));
            x = from_fn(|i| free[i] + forced[i]);
            let of_inputs = self.inputs[k].update(&u, &self.problem.input_bounds);
            let of_states = self.states[k].update(&x, &self.problem.state_bounds);
            residual = residual.max(of_inputs).max(of_states);
        }
        residual
    }

    /// The constant parts d, from the end.
    fn backward(&mut self) {
        let Problem {
            state_bounds,
            input_bounds,
            ..
        } = &self.problem;
        let mut ahead = self.states[H - 1].cost(state_bounds);
        for k in (0..H).rev() {
            let own = self.inputs[k].cost(input_bounds);
            let pushed = transposed_times(&self.problem.b, &ahead);
            self.shifts[k] = times(&self.inverse, &from_fn(|i| pushed[i] + own[i]));
            if k > 0 {
                let at_state = self.states[k - 1].cost(state_bounds);
                let carried = transposed_times(&self.closed, &ahead);
                let by_gain = transposed_times(&self.gain, &own);
                ahead = from_fn(|i| at_state[i] + carried[i] - by_gain[i]);
            }
        }
    }
}

/// M x.
#[must_use]
pub fn times<const N: usize, const M: usize>(matrix: &[[f32; M]; N], x: &[f32; M]) -> [f32; N] {
    from_fn(|i| matrix[i].iter().zip(x).map(|(m, x)| m * x).sum())
}

/// Mᵗ x.
fn transposed_times<const N: usize, const M: usize>(
    matrix: &[[f32; M]; N],
    x: &[f32; N],
) -> [f32; M] {
    let mut sum = [0.0; M];
    for (row, x) in matrix.iter().zip(x) {
        for (sum, m) in sum.iter_mut().zip(row) {
            *sum += m * x;
        }
    }
    sum
}

/// L R.
fn product<const N: usize, const K: usize, const M: usize>(
    left: &[[f32; K]; N],
    right: &[[f32; M]; K],
) -> [[f32; M]; N] {
    left.map(|row| transposed_times(right, &row))
}

/// Lᵗ R.
fn transposed_product<const N: usize, const K: usize, const M: usize>(
    left: &[[f32; N]; K],
    right: &[[f32; M]; K],
) -> [[f32; M]; N] {
    from_fn(|i| transposed_times(right, &from_fn(|k| left[k][i])))
}

/// The inverse of a symmetric positive definite matrix by Gauss and Jordan, which needs no pivots there; `None` for others.
fn inverted<const N: usize>(mut matrix: [[f32; N]; N]) -> Option<[[f32; N]; N]> {
    for k in 0..N {
        let pivot = matrix[k][k];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return None;
        }
        matrix[k][k] = 1.0;
        matrix[k] = matrix[k].map(|entry| entry / pivot);
        let row = matrix[k];
        for (i, other) in matrix.iter_mut().enumerate() {
            if i != k {
                let factor = other[k];
                other[k] = 0.0;
                *other = from_fn(|j| other[j] - factor * row[j]);
            }
        }
    }
    Some(matrix)
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Controller, Problem, inverted, product};

    /// A mass of 1 kg, pushed by a force for 0.1 s.
    fn mass(force: f32, rate: f32) -> Problem<2, 1> {
        let infinite = f32::INFINITY;
        Problem {
            a: [[1.0, 0.1], [0.0, 1.0]],
            b: [[0.01], [0.1]],
            state_weights: [10.0, 0.1],
            input_weights: [0.1],
            state_bounds: Bounds {
                lower: [-infinite, -rate],
                upper: [infinite, rate],
                penalties: [0.0, 5.0],
            },
            input_bounds: Bounds {
                lower: [-force],
                upper: [force],
                penalties: [0.5],
            },
        }
    }

    fn controller(problem: &Problem<2, 1>) -> Controller<2, 1, 20> {
        Controller::new(problem, 500).expect("the force moves it")
    }

    /// The cost of inputs, with that of an infinite horizon without bounds behind them.
    fn cost(
        problem: &Problem<2, 1>,
        start: [f32; 2],
        inputs: &[f32],
        [tail]: [[f32; 2]; 1],
    ) -> f32 {
        let mut x = start;
        let mut total = 0.0;
        for k in 0..400 {
            let u = inputs
                .get(k)
                .copied()
                .unwrap_or_else(|| -tail[0] * x[0] - tail[1] * x[1]);
            total += 10.0 * x[0] * x[0] + 0.1 * x[1] * x[1] + 0.1 * u * u;
            let [[a, b], [c, d]] = problem.a;
            x = [
                a * x[0] + b * x[1] + 0.01 * u,
                c * x[0] + d * x[1] + 0.1 * u,
            ];
        }
        total
    }

    #[test]
    fn no_change_of_the_inputs_within_their_bounds_costs_less() {
        let problem = mass(1.0, 100.0);
        let start = [1.0, 0.0];
        let mut controller = controller(&problem);
        let found = controller.step(&start, 5000, 1e-6);
        assert!(found.residual <= 1e-6, "{found:?}");
        let inputs = controller.inputs.map(|input| input.value[0]);
        assert!(inputs.iter().any(|u| *u == -1.0), "{inputs:?}");
        let mut free = problem;
        free.input_bounds.penalties = [0.0];
        free.state_bounds.penalties = [0.0; 2];
        let tail = *self::controller(&free).gain();
        let least = cost(&problem, start, &inputs, tail);
        for k in 0..inputs.len() {
            for step in [-0.02, 0.02] {
                let mut changed = inputs;
                changed[k] = (changed[k] + step).clamp(-1.0, 1.0);
                let other = cost(&problem, start, &changed, tail);
                assert!(other >= least - 2e-3 * least, "{k}: {other} {least}");
            }
        }
    }

    #[test]
    fn rates_stay_within_their_bounds() {
        let problem = mass(5.0, 0.5);
        let mut controller = controller(&problem);
        let mut x = [1.0, 0.0];
        let mut fastest: f32 = 0.0;
        for _ in 0..60 {
            let [u] = controller.step(&x, 100, 1e-4).input;
            x = [x[0] + 0.1 * x[1] + 0.01 * u, x[1] + 0.1 * u];
            fastest = fastest.max(x[1].abs());
        }
        assert!(x[0].abs() < 0.01, "{x:?}");
        assert!((0.45..0.51).contains(&fastest), "{fastest}");
    }

    #[test]
    fn a_gain_that_is_not_found_is_no_controller() {
        let mut problem = mass(1.0, 1.0);
        assert!(Controller::<2, 1, 5>::new(&problem, 2).is_none());
        problem.a[0][0] = f32::NAN;
        assert!(Controller::<2, 1, 5>::new(&problem, 500).is_none());
    }

    #[test]
    fn a_matrix_times_its_inverse_is_one() {
        let matrix = [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.5, -1.0, 2.0]];
        let one = product(&matrix, &inverted(matrix).expect("positive definite"));
        for (i, row) in one.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                assert!((entry - f32::from(u8::from(i == j))).abs() < 1e-6);
            }
        }
        assert!(inverted([[1.0, 2.0], [2.0, 1.0]]).is_none());
    }
}

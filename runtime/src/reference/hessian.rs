//! Second derivatives of λᵀτ by sums over the bodies that each joint carries.
//!
//! In: a [`Chain`], a state, and weights λ of the torques. Out: a [`TorqueHessian`]. With Λ = Σ λ L of the joints that
//! carry a body, λᵀτ = Σ Tr((H − H_g) J Λᵗ). A motion of joint a changes Λ, W and Ẇ of all bodies that it carries, as
//! they see them, by Ψλ, Ψ̇ and Ψ̈ + Ψ̇ W − W Ψ̇, with [Λ, L], [W, L] and [Ẇ, L] + [W, Ψ̇] of its parent body, where
//! [A, B] = A B − B A. All that a joint b outboard of it adds to λᵀτ is bilinear in those changes and in the sums of J,
//! W J, (H − H_g) J, Λ J and W J Λᵗ over the bodies that b carries.

use super::dense::gravity_matrix;
use super::derivatives::{carried, commutator};
use super::motion::{DegreeOfFreedom, Motion};
use crate::robot::chain::Chain;
use crate::robot::derivatives::TorqueHessian;
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// Second derivatives of λᵀτ, where τ are the torques [N m] and forces \[N\] that produce q̈.
///
/// `weights` are λ; as a virtual displacement [rad or m] they make λᵀτ a work \[J\]. Damping,
/// armature and Coulomb friction have no second derivatives.
#[must_use]
pub fn inverse_dynamics_hessian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
    weights: &[T; N],
) -> TorqueHessian<N, T> {
    let motion = Motion::at(chain, q, qd, qdd);
    let sums = Sums::of(chain, &motion, weights);
    let zero = || [[T::zero(); N]; N];
    let mut found = TorqueHessian {
        dq_dq: zero(),
        dq_dqd: zero(),
        dqd_dqd: zero(),
        dq_dqdd: zero(),
    };
    for outer in motion.positions.degrees_of_freedom() {
        let b = Change::of(chain, &motion, &sums, outer);
        for inner in motion.positions.degrees_of_freedom() {
            let same = inner.body == outer.body;
            if !chain.carries(inner.body, Some(outer.body)) {
                continue;
            }
            let a = Change::of(chain, &motion, &sums, inner);
            let mut add = |matrix: fn(&mut TorqueHessian<N, T>) -> &mut [[T; N]; N],
                           row: &Change<T>,
                           column: &Change<T>,
                           entry: T| {
                let row = matrix(&mut found).get_mut(row.of.velocity);
                if let Some(sum) = row.and_then(|row| row.get_mut(column.of.velocity)) {
                    *sum += entry;
                }
            };
            let none = Matrix4::zeros();
            let by_q = sums.by_q(&b, &a.weights, &a.first, &a.second);
            add(|of| &mut of.dq_dq, &a, &b, by_q);
            add(
                |of| &mut of.dq_dqd,
                &a,
                &b,
                sums.by_qd(&b, &a.weights, &a.first),
            );
            add(
                |of| &mut of.dq_dqdd,
                &a,
                &b,
                trace(&(b.of.l * sums.j[outer.body]), &a.weights),
            );
            let mut by_qd = sums.by_qd(&b, &none, &a.of.l);
            if same {
                // The screws of one joint do not move each other's.
                by_qd -= trace(&sums.momenta[outer.body], &commutator(&a.of.l, &b.of.l));
            }
            add(|of| &mut of.dqd_dqd, &a, &b, by_qd);
            if !same {
                add(|of| &mut of.dq_dq, &b, &a, by_q);
                add(|of| &mut of.dqd_dqd, &b, &a, by_qd);
                let by_q_and_qd = sums.by_q(&b, &none, &a.of.l, &a.by_rate);
                add(|of| &mut of.dq_dqd, &b, &a, by_q_and_qd);
                add(
                    |of| &mut of.dq_dqdd,
                    &b,
                    &a,
                    sums.by_q(&b, &none, &none, &a.of.l),
                );
            }
        }
    }
    found
}

/// The changes that one degree of freedom makes.
struct Change<T> {
    of: DegreeOfFreedom<T>,
    /// Ψλ.
    weights: Matrix4<T>,
    /// Ψ̇.
    first: Matrix4<T>,
    /// Ψ̈.
    second: Matrix4<T>,
    /// L̇ + Ψ̇.
    by_rate: Matrix4<T>,
}

impl<T: RealField + Copy> Change<T> {
    fn of<const N: usize, const F: usize, const Q: usize, const B: usize>(
        chain: &Chain<N, F, Q, B>,
        motion: &Motion<T, B>,
        sums: &Sums<T, B>,
        of: DegreeOfFreedom<T>,
    ) -> Self {
        let h_g = gravity_matrix::<T>(chain.gravity);
        let rest = (Matrix4::zeros(), Matrix4::zeros(), Matrix4::zeros());
        let (w, h, lambda) = chain.parent(of.body).map_or(rest, |parent| {
            (motion.w[parent], motion.h[parent], sums.lambda[parent])
        });
        let first = commutator(&w, &of.l);
        Self {
            weights: commutator(&lambda, &of.l),
            second: commutator(&(h - h_g - w * w), &of.l) + commutator(&w, &first),
            by_rate: commutator(&motion.w[of.body], &of.l) + first,
            first,
            of,
        }
    }
}

/// Λ of each body, and sums over all bodies that each joint carries.
struct Sums<T, const B: usize> {
    lambda: [Matrix4<T>; B],
    /// J.
    j: [Matrix4<T>; B],
    /// W J.
    flows: [Matrix4<T>; B],
    /// (H − H_g) J.
    forces: [Matrix4<T>; B],
    /// Λ J.
    momenta: [Matrix4<T>; B],
    /// W J Λᵗ.
    mixed: [Matrix4<T>; B],
}

impl<T: RealField + Copy, const B: usize> Sums<T, B> {
    fn of<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        motion: &Motion<T, B>,
        weights: &[T; N],
    ) -> Self {
        let mut lambda = [Matrix4::zeros(); B];
        for i in 0..B {
            let outer = chain
                .parent(i)
                .map_or_else(Matrix4::zeros, |parent| lambda[parent]);
            let own = motion.positions.of_joint(i).filter_map(|of| {
                let weight = weights.get(of.velocity)?;
                Some(of.l * *weight)
            });
            lambda[i] = own.fold(outer, |sum, own| sum + own);
        }
        let j = motion.positions.j;
        let h_g = gravity_matrix::<T>(chain.gravity);
        Self {
            j: carried(chain, j),
            flows: carried(chain, from_fn(|i| motion.w[i] * j[i])),
            forces: carried(chain, from_fn(|i| (motion.h[i] - h_g) * j[i])),
            momenta: carried(chain, from_fn(|i| lambda[i] * j[i])),
            mixed: carried(
                chain,
                from_fn(|i| motion.w[i] * j[i] * lambda[i].transpose()),
            ),
            lambda,
        }
    }

    /// The derivative of ∂(λᵀτ)/∂q_b if Λ, W and Ẇ change by Ψλ, Ψ̇ and Ψ̈ + Ψ̇ W − W Ψ̇ in all bodies.
    fn by_q(
        &self,
        b: &Change<T>,
        weights: &Matrix4<T>,
        first: &Matrix4<T>,
        second: &Matrix4<T>,
    ) -> T {
        let (k, l) = (b.of.body, b.of.l);
        let (j, flow, momentum) = (self.j[k], self.flows[k], self.momenta[k]);
        let moved = |sum: Matrix4<T>| l * sum + sum * l.transpose();
        let two: T = nalgebra::convert(2.0);
        let force = b.second * j + b.first * flow * two + moved(self.forces[k]);
        let impulse = b.weights * j + moved(momentum);
        let turned = trace(&(first * flow), &b.weights)
            + (commutator(first, &l) * self.mixed[k]).trace()
            - trace(&(b.first * momentum), first)
            + trace(&momentum, &commutator(first, &b.first));
        trace(&force, weights) + trace(&impulse, second) + turned * two
    }

    /// The same for ∂(λᵀτ)/∂q̇_b, which does not depend on Ẇ of other bodies.
    fn by_qd(&self, b: &Change<T>, weights: &Matrix4<T>, first: &Matrix4<T>) -> T {
        let (k, l) = (b.of.body, b.of.l);
        let two: T = nalgebra::convert(2.0);
        let force = b.by_rate * self.j[k] + l * self.flows[k] * two;
        let turned =
            trace(&self.momenta[k], &commutator(first, &l)) - trace(&(l * self.momenta[k]), first);
        trace(&force, weights) + turned * two
    }
}

/// Tr(A Bᵗ).
fn trace<T: RealField + Copy>(a: &Matrix4<T>, b: &Matrix4<T>) -> T {
    (a * b.transpose()).trace()
}

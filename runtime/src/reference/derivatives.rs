//! Derivatives of joint torques and forces, and the Coriolis matrix, by the product rule.
//!
//! In: a [`Chain`] and a state. Out: matrices, a row for each torque or force. A motion along L moves all bodies
//! that the joint carries, so that ∂L' = L L' − L' L and ∂J = L J + J Lᵗ. ∂W and ∂H follow from their composition,
//! and ∂τ from τ = Tr(Σ (H − H_g) J Lᵗ), term by term (Part II, Lagrange).

use super::dense::gravity_matrix;
use super::motion::{DegreeOfFreedom, Motion};
use crate::robot::chain::Chain;
use crate::robot::derivatives::TorqueDerivatives;
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// ∂τ/∂q and ∂τ/∂q̇ of the torques [N m] and forces \[N\] that produce q̈.
///
/// ∂τ/∂q̇ includes damping. Coulomb friction has the derivative zero, except at q̇ = 0 where it is undefined.
#[must_use]
pub fn inverse_dynamics_derivatives<
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
) -> TorqueDerivatives<N, T> {
    let motion = Motion::at(chain, q, qd, qdd);
    let matrix = |of: Of| {
        by_columns(&motion, |along| {
            change(chain, &motion, [qd, qdd], along, of)
        })
    };
    let mut dqd = matrix(Of::Rate);
    for dof in motion.positions.degrees_of_freedom() {
        let row = dqd.get_mut(dof.velocity);
        if let Some(entry) = row.and_then(|row| row.get_mut(dof.velocity)) {
            *entry += dof.damping();
        }
    }
    TorqueDerivatives {
        dq: matrix(Of::Coordinate),
        dqd,
    }
}

/// ∂τ/∂q of the torques and forces that hold the robot against gravity.
#[must_use]
pub fn gravity_derivative<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; N]; N] {
    let rest = [T::zero(); N];
    inverse_dynamics_derivatives(chain, q, &rest, &rest).dq
}

/// C(q, q̇) of τ = M q̈ + C q̇ + gravity, with Ṁ − 2C skew-symmetric.
///
/// C\[i\]\[m\] = Tr(Σ (L̇ₘ + Lₘ W) J Lᵢᵗ) over the bodies that both joints carry, with L̇ₘ = W Lₘ − Lₘ W and W of
/// the body that joint m moves. It follows from H = Σ (L̇ₘ + Lₘ W) q̇ₘ at q̈ = 0. If each joint has one velocity,
/// C consists of the Christoffel symbols of M. Friction is not included; armatures are constant and add nothing.
#[must_use]
pub fn coriolis_matrix<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [[T; N]; N] {
    let motion = Motion::at(chain, q, qd, &[T::zero(); N]);
    by_columns(&motion, |along| {
        let rate = commutator(&motion.w[along.body], &along.l);
        let flows = from_fn(|body| {
            if chain.carries(along.body, Some(body)) {
                (rate + along.l * motion.w[body]) * motion.positions.j[body]
            } else {
                Matrix4::zeros()
            }
        });
        let flows: [Matrix4<T>; B] = carried(chain, flows);
        by_velocity(&motion, |of| (flows[of.body] * of.l.transpose()).trace())
    })
}

/// The variable of a derivative.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Coordinate,
    Rate,
}

/// A matrix by its columns: each is the sum over all degrees of freedom with the same velocity.
fn by_columns<T: RealField + Copy, const N: usize, const B: usize>(
    motion: &Motion<T, B>,
    column: impl Fn(&DegreeOfFreedom<T>) -> [T; N],
) -> [[T; N]; N] {
    let mut matrix = [[T::zero(); N]; N];
    for along in motion.positions.degrees_of_freedom() {
        for (row, entry) in matrix.iter_mut().zip(column(&along)) {
            if let Some(sum) = row.get_mut(along.velocity) {
                *sum += entry;
            }
        }
    }
    matrix
}

/// The derivative of the torques by one degree of freedom: by its coordinate, or by its rate.
fn change<T: RealField + Copy, const N: usize, const F: usize, const Q: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    motion: &Motion<T, B>,
    [qd, qdd]: [&[T; N]; 2],
    along: &DegreeOfFreedom<T>,
    of: Of,
) -> [T; N] {
    let j = &motion.positions.j;
    let is_carried = |body: usize| chain.carries(along.body, Some(body));
    // The derivative of a screw of a body.
    let change_of = |l: &Matrix4<T>, body: usize| {
        if of == Of::Coordinate && is_carried(body) {
            commutator(&along.l, l)
        } else {
            Matrix4::zeros()
        }
    };
    let two: T = nalgebra::convert(2.0);
    let mut change_of_w = [Matrix4::zeros(); B];
    let mut change_of_h = [Matrix4::zeros(); B];
    for i in (0..B).filter(|&i| is_carried(i)) {
        let still = || (Matrix4::zeros(), Matrix4::zeros(), Matrix4::zeros());
        let outer = |p: usize| (motion.w[p], change_of_w[p], change_of_h[p]);
        let (w, change_w, change_h) = chain.parent(i).map_or_else(still, outer);
        // H = H_parent + Σ L q̈ + (Σ L q̇)² + 2 W_parent Σ L q̇.
        let own = motion.w[i] - w;
        let (mut rate, mut second) = (Matrix4::zeros(), Matrix4::zeros());
        for DegreeOfFreedom { velocity, l, .. } in motion.positions.of_joint(i) {
            let [first, then] = [qd, qdd].map(|of| of.get(velocity).copied());
            rate += change_of(&l, i) * first.unwrap_or(T::zero());
            second += change_of(&l, i) * then.unwrap_or(T::zero());
        }
        if of == Of::Rate && i == along.body {
            rate = along.l;
        }
        change_of_w[i] = change_w + rate;
        change_of_h[i] =
            change_h + second + (rate * own + own * rate) + (change_w * own + w * rate) * two;
    }
    // (H − H_g) J of each body and its change, then the sums over the bodies that each joint carries.
    let h_g = gravity_matrix::<T>(chain.gravity);
    let flow: [Matrix4<T>; B] = from_fn(|i| (motion.h[i] - h_g) * j[i]);
    let change: [Matrix4<T>; B] = from_fn(|i| {
        let change_of_j = if of == Of::Coordinate && is_carried(i) {
            along.l * j[i] + j[i] * along.l.transpose()
        } else {
            Matrix4::zeros()
        };
        change_of_h[i] * j[i] + (motion.h[i] - h_g) * change_of_j
    });
    let (flow, change) = (carried(chain, flow), carried(chain, change));
    by_velocity(motion, |at| {
        let change_of_l = change_of(&at.l, at.body);
        (change[at.body] * at.l.transpose() + flow[at.body] * change_of_l.transpose()).trace()
    })
}

/// The sums over the bodies that each joint carries; children come after their parents.
pub(super) fn carried<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    mut each: [Matrix4<T>; B],
) -> [Matrix4<T>; B] {
    for i in (0..B).rev() {
        if let Some(parent) = chain.parent(i) {
            let own = each[i];
            each[parent] += own;
        }
    }
    each
}

/// The sum for each velocity over all degrees of freedom with it.
fn by_velocity<T: RealField + Copy, const N: usize, const B: usize>(
    motion: &Motion<T, B>,
    of: impl Fn(&DegreeOfFreedom<T>) -> T,
) -> [T; N] {
    let mut sums = [T::zero(); N];
    for dof in motion.positions.degrees_of_freedom() {
        if let Some(sum) = sums.get_mut(dof.velocity) {
            *sum += of(&dof);
        }
    }
    sums
}

/// A B − B A.
pub(super) fn commutator<T: RealField + Copy>(a: &Matrix4<T>, b: &Matrix4<T>) -> Matrix4<T> {
    a * b - b * a
}

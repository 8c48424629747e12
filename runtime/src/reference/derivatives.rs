//! Derivatives of joint forces and torques, and the Coriolis matrix, by the rule for products.
//!
//! In: a [`Chain`] and a state. Out: matrices, a row for each torque or force. A motion along L moves what the
//! joint carries, so that ∂L' = L L' − L' L and ∂J = L J + J Lᵗ; W and H follow as they are composed, and τ of a
//! joint is Tr(Σ (H − H_g) J Lᵗ), term by term (Part II, Lagrange).

use super::dense::gravity_matrix;
use super::motion::{Freedom, Motion};
use crate::robot::chain::Chain;
use crate::robot::derivatives::TorqueDerivatives;
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// ∂τ/∂q and ∂τ/∂q̇ of the torques [N m] and forces \[N\] that produce q̈.
///
/// Of drives ∂τ/∂q̇ has the damping; the sign of q̇, which Coulomb friction has, changes only where it steps.
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
    for freedom in motion.positions.freedoms() {
        let row = dqd.get_mut(freedom.velocity);
        if let Some(entry) = row.and_then(|row| row.get_mut(freedom.velocity)) {
            *entry += freedom.damping();
        }
    }
    TorqueDerivatives {
        dq: matrix(Of::Coordinate),
        dqd,
    }
}

/// ∂τ/∂q of what holds the robot against gravity.
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
/// C\[i\]\[m\] = Tr(Σ (L̇ₘ + Lₘ W) J Lᵢᵗ) over the bodies that both joints carry, with L̇ₘ = W Lₘ − Lₘ W of
/// the body that joint m moves: of H at q̈ = 0, which is Σ (L̇ₘ + Lₘ W) q̇ₘ, what joint i feels. Where each
/// joint has one velocity it holds the Christoffel symbols of M. Friction is not in it, and armatures, which do not
/// change, add nothing.
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
        felt(&motion, |of| (flows[of.body] * of.l.transpose()).trace())
    })
}

/// With respect to what.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Coordinate,
    Rate,
}

/// A matrix by its columns, each the sum of those of all that a velocity moves.
fn by_columns<T: RealField + Copy, const N: usize, const B: usize>(
    motion: &Motion<T, B>,
    column: impl Fn(&Freedom<T>) -> [T; N],
) -> [[T; N]; N] {
    let mut matrix = [[T::zero(); N]; N];
    for along in motion.positions.freedoms() {
        for (row, entry) in matrix.iter_mut().zip(column(&along)) {
            if let Some(sum) = row.get_mut(along.velocity) {
                *sum += entry;
            }
        }
    }
    matrix
}

/// What the torques change by along the motion that a velocity gives to a body, or with the velocity.
fn change<T: RealField + Copy, const N: usize, const F: usize, const Q: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    motion: &Motion<T, B>,
    [qd, qdd]: [&[T; N]; 2],
    along: &Freedom<T>,
    of: Of,
) -> [T; N] {
    let j = &motion.positions.j;
    let is_carried = |body: usize| chain.carries(along.body, Some(body));
    // What is moved along L, of the screws.
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
        for Freedom { velocity, l, .. } in motion.positions.of(i) {
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
    // (H − H_g) J of each body and its change, then the sums over all that each joint carries.
    let h_g = gravity_matrix::<T>(chain.gravity);
    let flow: [Matrix4<T>; B] = from_fn(|i| (motion.h[i] - h_g) * j[i]);
    let change: [Matrix4<T>; B] = from_fn(|i| {
        let turned = if of == Of::Coordinate && is_carried(i) {
            along.l * j[i] + j[i] * along.l.transpose()
        } else {
            Matrix4::zeros()
        };
        change_of_h[i] * j[i] + (motion.h[i] - h_g) * turned
    });
    let (flow, change) = (carried(chain, flow), carried(chain, change));
    felt(motion, |at| {
        let turned = change_of(&at.l, at.body);
        (change[at.body] * at.l.transpose() + flow[at.body] * turned.transpose()).trace()
    })
}

/// The sums over all that each joint carries: children come after their parents.
fn carried<T: RealField + Copy, const N: usize, const F: usize, const Q: usize, const B: usize>(
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

/// What each velocity has of all that it moves.
fn felt<T: RealField + Copy, const N: usize, const B: usize>(
    motion: &Motion<T, B>,
    of: impl Fn(&Freedom<T>) -> T,
) -> [T; N] {
    let mut felt = [T::zero(); N];
    for freedom in motion.positions.freedoms() {
        if let Some(sum) = felt.get_mut(freedom.velocity) {
            *sum += of(&freedom);
        }
    }
    felt
}

/// A B − B A.
fn commutator<T: RealField + Copy>(a: &Matrix4<T>, b: &Matrix4<T>) -> Matrix4<T> {
    a * b - b * a
}

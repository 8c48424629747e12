//! Kinetic and potential energy, at run time.
//!
//! In: a [`Chain`] and its state. Out: traces of dense products, summed over the bodies.

use super::sum;
use crate::reference::dense::gravity_matrix;
use crate::reference::motion::{Motion, Positions};
use crate::robot::chain::Chain;
use nalgebra::RealField;

/// The kinetic energy Σ ½ Tr(W J Wᵗ) \[J\] (22), and ½ q̇² of each armature.
#[must_use]
pub fn kinetic_energy<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> T {
    let rest = [T::zero(); N];
    let motion = Motion::at(chain, q, qd, &rest);
    let half: T = nalgebra::convert(0.5);
    let bodies = sum((0..B).map(|i| {
        let w = motion.w[i];
        half * (w * motion.positions.j[i] * w.transpose()).trace()
    }));
    let armatures = motion.positions.degrees_of_freedom().map(|dof| {
        let rate = qd.get(dof.velocity).copied().unwrap_or(T::zero());
        half * dof.armature() * rate * rate
    });
    bodies + sum(armatures)
}

/// The potential energy Σ −Tr(H_g J) \[J\], zero at the origin of frame 0 (§ 4.5).
#[must_use]
pub fn potential_energy<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> T {
    let h_g = gravity_matrix::<T>(chain.gravity);
    let positions = Positions::at(chain, q);
    sum(positions.j.iter().map(|j| -(h_g * j).trace()))
}

//! Kinetic and potential energy and their regressors, at run time.
//!
//! In: a [`Chain`] and its state. Out: traces of dense products, summed over the bodies, or one for each parameter.

use super::dynamics::{PARAMETERS, assert_count, unit_inertia};
use super::sum;
use crate::reference::dense::gravity_matrix;
use crate::reference::motion::{Motion, Positions};
use crate::robot::chain::Chain;
use core::array::from_fn;
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

/// The row y of T = y π, where T is the kinetic energy \[J\] (22), for the parameters π of [`regressor`](super::regressor):
/// those of bodies and, if `P` is large enough, of actuators, of which armatures have ½ q̇².
///
/// # Panics
///
/// If `P` is neither 10 B nor 10 B plus three for each velocity of a joint.
#[must_use]
pub fn kinetic_energy_regressor<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const P: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [T; P] {
    let motion = Motion::at(chain, q, qd, &[T::zero(); N]);
    let positions = &motion.positions;
    assert_count::<P, B>(positions.degrees_of_freedom().count());
    let half: T = nalgebra::convert(0.5);
    let mut energies = [T::zero(); P];
    for (parameter, energy) in energies.iter_mut().take(PARAMETERS * B).enumerate() {
        let w = motion.w[parameter / PARAMETERS];
        *energy = half * (w * unit_inertia(positions, parameter) * w.transpose()).trace();
    }
    if P > PARAMETERS * B {
        for (k, dof) in positions.degrees_of_freedom().enumerate() {
            let rate = dof.rate(qd);
            energies[PARAMETERS * B + 3 * k] = half * rate * rate;
        }
    }
    energies
}

/// The row y of U = y π, where U is the potential energy \[J\] (§ 4.5), for the parameters π of
/// [`regressor`](super::regressor).
///
/// # Panics
///
/// If `P` is neither 10 B nor 10 B plus three for each velocity of a joint.
#[must_use]
pub fn potential_energy_regressor<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const P: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [T; P] {
    let h_g = gravity_matrix::<T>(chain.gravity);
    let positions = Positions::at(chain, q);
    assert_count::<P, B>(positions.degrees_of_freedom().count());
    from_fn(|parameter| {
        if parameter < PARAMETERS * B {
            -(h_g * unit_inertia(&positions, parameter)).trace()
        } else {
            T::zero()
        }
    })
}

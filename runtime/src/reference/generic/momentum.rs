//! The centre of mass and the momentum of the bodies that joints move, at run time.
//!
//! In: a [`Chain`] and its state. Out: columns and skew parts of Σ J, Σ W J and Σ H J, in frame 0 or about the centre of
//! mass.

use crate::matrix::{Action, Momentum, Point};
use crate::reference::dense::{axial, column};
use crate::reference::motion::{Motion, Positions};
use crate::robot::chain::Chain;
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// The centre of mass of the bodies that joints move \[m\], in frame 0: the last column of Σ J is ∫P dm (16).
///
/// NaN without mass.
#[must_use]
pub fn center_of_mass<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> Point<T> {
    let j = total(&Positions::at(chain, q));
    Point(column(&j).map(|moment| moment / j[(3, 3)]))
}

/// The velocity of the centre of mass [m/s], in the axes of frame 0: the last column of Σ W J is ∫Ṗ dm.
#[must_use]
pub fn center_of_mass_velocity<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> [T; 3] {
    let motion = Motion::at(chain, q, qd, &[T::zero(); N]);
    let mass = total(&motion.positions)[(3, 3)];
    column(&moments(&motion)).map(|momentum| momentum / mass)
}

/// The Jacobian of the centre of mass: its velocity at a unit rate of each joint, in the axes of frame 0.
#[must_use]
pub fn center_of_mass_jacobian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; 3]; N] {
    from_fn(|i| center_of_mass_velocity(chain, q, &unit(i)))
}

/// Γ₍₀₎ = skew[Σ W J] of the bodies that joints move [kg m²/s, kg m/s], reference point at the origin of frame 0 (20).
#[must_use]
pub fn momentum<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Momentum<T> {
    let moments = moments(&Motion::at(chain, q, qd, &[T::zero(); N]));
    let gamma = moments - moments.transpose();
    Momentum::new(axial(&gamma), column(&gamma))
}

/// Γ of the bodies that joints move, about their centre of mass [kg m²/s, kg m/s], in the axes of frame 0.
#[must_use]
pub fn centroidal_momentum<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Momentum<T> {
    let motion = Motion::of(
        chain,
        Positions::at_first_body(chain, q),
        qd,
        &[T::zero(); N],
    );
    let gamma = about_center(&motion.positions, &moments(&motion));
    Momentum::new(axial(&gamma), column(&gamma))
}

/// Γ about the centre of mass at a unit rate of each joint [kg m², kg m, kg], in the axes of frame 0.
#[must_use]
pub fn centroidal_momentum_matrix<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [Momentum<T>; N] {
    from_fn(|i| centroidal_momentum(chain, q, &unit(i)))
}

/// Φ = skew[Σ H J] at q̈ = 0 without gravity, about the centre of mass [N m, N], in the axes of frame 0: the rate of
/// the centroidal momentum matrix times q̇.
#[must_use]
pub fn centroidal_momentum_bias<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
) -> Action<T> {
    let motion = Motion::of(
        chain,
        Positions::at_first_body(chain, q),
        qd,
        &[T::zero(); N],
    );
    let each = motion.h.iter().zip(&motion.positions.j);
    let forces = each.fold(Matrix4::zeros(), |sum, (h, j)| sum + h * j);
    let phi = about_center(&motion.positions, &forces);
    Action::new(axial(&phi), column(&phi))
}

/// Σ J.
fn total<T: RealField + Copy, const B: usize>(positions: &Positions<T, B>) -> Matrix4<T> {
    positions.j.iter().fold(Matrix4::zeros(), |sum, j| sum + j)
}

/// Σ W J.
fn moments<T: RealField + Copy, const B: usize>(motion: &Motion<T, B>) -> Matrix4<T> {
    let each = motion.w.iter().zip(&motion.positions.j);
    each.fold(Matrix4::zeros(), |sum, (w, j)| sum + w * j)
}

/// skew[X] of X = Σ W J or Σ H J about the centre of mass (17).
fn about_center<T: RealField + Copy, const B: usize>(
    positions: &Positions<T, B>,
    x: &Matrix4<T>,
) -> Matrix4<T> {
    let j = total(positions);
    let back = Matrix4::new_translation(&(-j.fixed_view::<3, 1>(0, 3) / j[(3, 3)]));
    back * (x - x.transpose()) * back.transpose()
}

/// A unit rate of one joint.
fn unit<T: RealField + Copy, const N: usize>(joint: usize) -> [T; N] {
    from_fn(|i| if i == joint { T::one() } else { T::zero() })
}

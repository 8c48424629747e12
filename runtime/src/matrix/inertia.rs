//! J, the pseudo-inertia matrix, and Newton–Euler in one line.
//!
//! In: second moments, or the usual tensor with mass and centre of mass. Out: momenta, wrenches,
//! weights and energies of a body. Nothing is checked; [`Inertia::check`] rejects a non-physical inertia.

use super::acceleration::Acceleration;
use super::action::Action;
use super::momentum::Momentum;
use super::screw::Screw;
use super::vector::{
    add, axial, cross, dot, matrix_product, outer, product, scale, sub, underscore,
};
use super::velocity::Velocity;
use crate::scalar::Scalar;
use core::array::from_fn;
use core::ops::{Add, Sub};

/// The pseudo-inertia Jᵢ₍ₖ₎ = ∫ P Pᵗ dm = (∫ p pᵗ dm, q; qᵗ, m) of body i in frame (k)
/// (§ 4.3, (16)).
///
/// The 3×3 block holds second moments ∫ x² dm, ∫ x y dm … [kg m²] (not the usual moments of
/// inertia), q is the mass times the position of its centre [kg m], m the mass \[kg\].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inertia<T> {
    second_moments: [T; 6],
    q: [T; 3],
    mass: T,
}

impl<T> Inertia<T> {
    /// J from ∫xx, ∫yy, ∫zz, ∫xy, ∫xz, ∫yz dm [kg m²] in this order, q [kg m] and the mass \[kg\];
    /// nothing is checked, so that it can be a constant.
    #[inline]
    #[must_use]
    pub const fn new(second_moments: [T; 6], q: [T; 3], mass: T) -> Self {
        Self {
            second_moments,
            q,
            mass,
        }
    }
}

impl<T: Copy> Inertia<T> {
    /// q = ∫ p dm = m · centre of mass [kg m].
    #[inline]
    #[must_use]
    pub const fn q(&self) -> [T; 3] {
        self.q
    }

    /// m \[kg\].
    #[inline]
    #[must_use]
    pub const fn mass(&self) -> T {
        self.mass
    }

    /// ∫ p pᵗ dm [kg m²], as rows.
    #[inline]
    #[must_use]
    pub const fn second_moments(&self) -> [[T; 3]; 3] {
        let [xx, yy, zz, xy, xz, yz] = self.second_moments;
        [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    }
}

impl<T: Scalar> Inertia<T> {
    /// A body without mass.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        let zero = T::constant(0.0);
        Self::new([zero; 6], [zero; 3], zero)
    }

    /// P Pᵗ dm, the inertia of a particle of `mass` \[kg\] at `position` \[m\]: the integrand of J (§ 4.3).
    #[inline]
    #[must_use]
    pub fn of_particle(mass: T, position: [T; 3]) -> Self {
        let q = scale(mass, position);
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = outer(q, position);
        Self::new([xx, yy, zz, xy, xz, yz], q, mass)
    }

    /// J from the usual inertia tensor about the origin of the frame [kg m²], its rows with products
    /// of inertia −∫ x y dm off the diagonal: I_xx = (−J_xx + J_yy + J_zz)/2 … (§ 4.3).
    ///
    /// SPACELIB: `jtoJ`.
    #[inline]
    #[must_use]
    pub fn from_tensor_at_origin(mass: T, center_of_mass: [T; 3], tensor: &[[T; 3]; 3]) -> Self {
        let [xx, yy, zz, xy, xz, yz] = second_moments_of(tensor);
        Self::new([xx, yy, zz, xy, xz, yz], scale(mass, center_of_mass), mass)
    }

    /// J from the usual inertia tensor about the centre of mass [kg m²], axes parallel to the
    /// frame's, as URDF and data sheets give it: second moments about the centre plus m c cᵗ.
    ///
    /// SPACELIB: `jtoJ`, and the change of frame after it.
    ///
    /// ```
    /// use homogen::Inertia;
    /// // A rod of 1 kg and 1 m along x that begins at the origin.
    /// let third = 1.0 / 12.0;
    /// let tensor = [[0.0, 0.0, 0.0], [0.0, third, 0.0], [0.0, 0.0, third]];
    /// let rod = Inertia::from_tensor_at_center_of_mass(1.0, [0.5, 0.0, 0.0], &tensor);
    /// assert!((rod.second_moments()[0][0] - 1.0 / 3.0_f64).abs() < 1e-16);
    /// ```
    #[inline]
    #[must_use]
    pub fn from_tensor_at_center_of_mass(
        mass: T,
        center_of_mass: [T; 3],
        tensor: &[[T; 3]; 3],
    ) -> Self {
        let central = second_moments_of(tensor);
        let particle = Self::of_particle(mass, center_of_mass);
        Self::new(
            from_fn(|k| central[k] + particle.second_moments[k]),
            particle.q,
            mass,
        )
    }

    /// The centre of mass q / m \[m\]; meaningless (not finite) for a body without mass.
    #[inline]
    #[must_use]
    pub fn center_of_mass(&self) -> [T; 3] {
        self.q.map(|q| q / self.mass)
    }

    /// The usual inertia tensor about the origin of the frame [kg m²], as rows: J_xx = I_yy + I_zz,
    /// J_xy = −I_xy … (§ 4.3).
    #[inline]
    #[must_use]
    pub fn tensor_at_origin(&self) -> [[T; 3]; 3] {
        tensor_of(self.second_moments)
    }

    /// The usual inertia tensor about the centre of mass [kg m²], axes parallel to the frame's.
    ///
    /// The body must have mass.
    #[inline]
    #[must_use]
    pub fn tensor_at_center_of_mass(&self) -> [[T; 3]; 3] {
        tensor_of(self.central_second_moments())
    }

    /// Second moments about the centre of mass: ∫ p pᵗ dm − q qᵗ/m, as xx, yy, zz, xy, xz, yz.
    #[inline]
    pub(crate) fn central_second_moments(&self) -> [T; 6] {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = outer(self.q, self.center_of_mass());
        let shift = [xx, yy, zz, xy, xz, yz];
        from_fn(|k| self.second_moments[k] - shift[k])
    }

    /// Γ = skew[W J] = W J − J Wᵗ, the momentum of the body at velocity `w` (20), (26).
    ///
    /// SPACELIB: `skew`.
    #[inline]
    #[must_use]
    pub fn momentum(&self, w: &Velocity<T>) -> Momentum<T> {
        let (about, along) = self.skew(&underscore(w.omega()), w.v());
        Momentum::new(about, along)
    }

    /// Φ = skew[H J] = H J − J Hᵗ, the wrench that gives the body the acceleration `h` (18), (25).
    ///
    /// `h` is relative to an inertial frame; `self` and `h` are written in any one frame.
    ///
    /// SPACELIB: `skew`.
    ///
    /// ```
    /// use homogen::{Acceleration, Inertia};
    /// let body = Inertia::from_tensor_at_origin(2.0, [0.0; 3], &[[0.3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.4]]);
    /// let phi = body.action(&Acceleration::from_parts([0.0, 0.0, 10.0], [0.0; 3], [0.0, 5.0, 0.0]));
    /// assert_eq!((phi.c(), phi.f()), ([0.0, 0.0, 4.0], [0.0, 10.0, 0.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn action(&self, h: &Acceleration<T>) -> Action<T> {
        let (about, along) = self.skew(h.g(), h.a());
        Action::new(about, along)
    }

    /// Φ = H_g J − J H_gᵗ, the weight under the acceleration of gravity `g` [m/s²], any vector in the
    /// frame of J (§ 4.5).
    #[inline]
    #[must_use]
    pub fn weight(&self, g: [T; 3]) -> Action<T> {
        Action::new(cross(self.q, g), scale(self.mass, g))
    }

    /// The kinetic energy t = ½ Tr(W J Wᵗ) = ½ W ⊗ Γ \[J\] at velocity `w` (22).
    ///
    /// SPACELIB: `trac_ljlt4`, as [`Inertia::coupling`].
    #[inline]
    #[must_use]
    pub fn kinetic_energy(&self, w: &Velocity<T>) -> T {
        T::constant(0.5) * w.pseudo_scalar_product(&self.momentum(w))
    }

    /// Tr(Lᵢ J Lₘᵗ) = Lᵢ ⊗ skew\[Lₘ J\], the entry that the body adds to the mass matrix of the joints i
    /// and m that carry it (Part II); symmetric in the two screws.
    ///
    /// SPACELIB: `trac_ljlt4`.
    #[inline]
    #[must_use]
    pub fn coupling(&self, l_i: &Screw<T>, l_m: &Screw<T>) -> T {
        let momentum = self.momentum(&l_m.velocity(T::constant(1.0)));
        dot(l_i.u(), momentum.gamma()) + dot(l_i.b(), momentum.rho())
    }

    /// The potential energy p = −Tr(H_g J) = −g · q \[J\], zero at the origin of the frame (§ 4.5).
    #[inline]
    #[must_use]
    pub fn potential_energy(&self, g: [T; 3]) -> T {
        -dot(g, self.q)
    }

    /// The 4×4 matrix (∫ p pᵗ dm, q; qᵗ, m), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        let [xx, yy, zz, xy, xz, yz] = self.second_moments;
        let [x, y, z] = self.q;
        [
            [xx, xy, xz, x],
            [xy, yy, yz, y],
            [xz, yz, zz, z],
            [x, y, z, self.mass],
        ]
    }

    /// skew[(X, x; 0, 0) J], as its blocks: 2 axial(X ∫ppᵗ + x qᵗ) and X q + m x.
    #[inline]
    fn skew(&self, block: &[[T; 3]; 3], column: [T; 3]) -> ([T; 3], [T; 3]) {
        let left = matrix_product(block, &self.second_moments());
        let right = outer(column, self.q);
        let sum = from_fn(|i| add(left[i], right[i]));
        (
            scale(T::constant(2.0), axial(&sum)),
            add(product(block, self.q), scale(self.mass, column)),
        )
    }
}

/// Second moments xx, yy, zz, xy, xz, yz from the usual tensor.
#[inline]
fn second_moments_of<T: Scalar>(tensor: &[[T; 3]; 3]) -> [T; 6] {
    let half = T::constant(0.5);
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = *tensor;
    [
        half * (yy + zz - xx),
        half * (xx + zz - yy),
        half * (xx + yy - zz),
        -xy,
        -xz,
        -yz,
    ]
}

/// The usual tensor from second moments xx, yy, zz, xy, xz, yz.
#[inline]
fn tensor_of<T: Scalar>([xx, yy, zz, xy, xz, yz]: [T; 6]) -> [[T; 3]; 3] {
    [
        [yy + zz, -xy, -xz],
        [-xy, xx + zz, -yz],
        [-xz, -yz, xx + yy],
    ]
}

impl<T: Scalar> Add for Inertia<T> {
    type Output = Self;

    /// The inertia of two bodies joined, both in one frame.
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(
            from_fn(|k| self.second_moments[k] + other.second_moments[k]),
            add(self.q, other.q),
            self.mass + other.mass,
        )
    }
}

impl<T: Scalar> Sub for Inertia<T> {
    type Output = Self;

    /// The inertia of a body without a `part`, both in one frame.
    #[inline]
    fn sub(self, part: Self) -> Self {
        Self::new(
            from_fn(|k| self.second_moments[k] - part.second_moments[k]),
            sub(self.q, part.q),
            self.mass - part.mass,
        )
    }
}

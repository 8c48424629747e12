//! Every function of a robot, at run time, as the paper writes it (feature `nalgebra`).
//!
//! In: a [`Chain`] and a state. Out: what generated code returns, by dense 4×4 products in frame 0
//! (Part II). It is the reference: short enough to be compared with the paper line by line, free of
//! any simplification, and therefore slow. It shares nothing with the code generator.
//!
//! ```
//! use homogen::{Chain, Inertia, Joint, Pose, Screw, generic};
//!
//! // A pendulum: 2 kg at 0.5 m below a hinge about y, in the frame of the hinge.
//! let hinge = Screw::new([0.0, 1.0, 0.0], [0.0; 3]);
//! let bob = Inertia::of_particle(2.0, [0.0, 0.0, -0.5]);
//! let chain = Chain::new(
//!     [Joint::new("hinge", None, Pose::identity(), hinge, bob)],
//!     [],
//!     [0.0, 0.0, -9.81],
//! );
//! let horizontal = core::f64::consts::FRAC_PI_2;
//! let [torque] = generic::gravity(&chain, &[horizontal]);
//! assert!((torque - 9.81).abs() < 1e-14);
//! ```

use crate::matrix::{Acceleration, Pose, Screw, Velocity};
use crate::robot;
use crate::robot::chain::{Chain, Frame};
use core::array::from_fn;
use nalgebra::{Cholesky, Const, Matrix4, RealField, SMatrix, SVector};

/// M₀,frame.
///
/// SPACELIB: what its programs for serial robots compute as direct kinematics.
#[must_use]
pub fn forward_kinematics<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
) -> Pose<T> {
    let m = Positions::at(chain, q).of_frame(frame);
    Pose::new(block(&m), column(&m))
}

/// L₁ … L_N in frame 0, pole at its origin; zero for joints that do not move the frame.
#[must_use]
pub fn spatial_jacobian<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |_| Matrix4::identity())
}

/// L₁ … L_N in `frame`, pole at its origin.
#[must_use]
pub fn body_jacobian<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |m_0_frame| inverse(m_0_frame))
}

/// L₁ … L_N with the axes of frame 0, pole at the origin of `frame`.
#[must_use]
pub fn geometric_jacobian<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
) -> [Screw<T>; N] {
    jacobian(chain, frame, q, |m_0_frame| {
        // The frame with the axes of (0) and its origin in that of `frame`, seen from there.
        Matrix4::new_translation(&-m_0_frame.fixed_view::<3, 1>(0, 3))
    })
}

/// W₀,frame₍₀₎ [rad/s, m/s].
#[must_use]
pub fn velocity<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
    qd: &[T; N],
) -> Velocity<T> {
    let rest = [T::zero(); N];
    let w = Motion::at(chain, q, qd, &rest).w_of(frame.body);
    Velocity::new(vector_of(&w), column(&w))
}

/// H₀,frame₍₀₎ [rad/s², m/s²], without gravity.
#[must_use]
pub fn acceleration<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
) -> Acceleration<T> {
    let h = Motion::at(chain, q, qd, qdd).h_of(frame.body);
    Acceleration::new(block(&h), column(&h))
}

/// The torques [N m] and forces \[N\] of the joints that produce q̈ (Part II, Newton–Euler).
///
/// The action through joint i is the sum of Φ = skew[(H − H_g) J] over the bodies it carries, its
/// torque the pseudo scalar product L ⊗ Φ.
#[must_use]
pub fn inverse_dynamics<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
) -> [T; N] {
    let motion = Motion::at(chain, q, qd, qdd);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    // Φ of each body, then the sum carried by each joint: children come after their parents.
    let mut phi: [Matrix4<T>; N] = from_fn(|i| {
        let (h, j) = (motion.h[i] - h_g, positions.j[i]);
        h * j - j * h.transpose()
    });
    for i in (0..N).rev() {
        if let Some(parent) = chain.parent(i) {
            let carried = phi[i];
            phi[parent] += carried;
        }
    }
    from_fn(|i| pseudo_scalar_product(&positions.l[i], &phi[i]))
}

/// Inverse dynamics at rest: what holds the robot against gravity [N m, N].
///
/// As virtual work: −Σ Tr(H_g Jₕ Lₘᵗ) over the bodies h that joint m carries (Part II, Lagrange).
#[must_use]
pub fn gravity<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> [T; N] {
    let rest = [T::zero(); N];
    bias(chain, q, &rest)
}

/// Inverse dynamics at q̈ = 0: C\[m\] = Tr(Σ (H̃ₕ − H_g) Jₕ Lₘᵗ) over the bodies h that joint m
/// carries (Part II, Lagrange).
#[must_use]
pub fn bias<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
) -> [T; N] {
    let rest = [T::zero(); N];
    let motion = Motion::at(chain, q, qd, &rest);
    let (positions, h_g) = (&motion.positions, gravity_matrix::<T>(chain.gravity));
    from_fn(|m| {
        sum((0..N).filter(|h| chain.carries(m, Some(*h))).map(|h| {
            let work = (motion.h[h] - h_g) * positions.j[h] * positions.l[m].transpose();
            work.trace()
        }))
    })
}

/// The joint-space inertia M\[i\]\[m\] = Tr(Σ Lᵢ Jₕ Lₘᵗ), over the bodies h that both joints carry
/// (Part II, Lagrange).
#[must_use]
pub fn mass_matrix<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> [[T; N]; N] {
    let positions = Positions::at(chain, q);
    let carries = |joint: usize, body: usize| chain.carries(joint, Some(body));
    from_fn(|i| {
        from_fn(|m| {
            sum((0..N)
                .filter(|h| carries(i, *h) && carries(m, *h))
                .map(|h| (positions.l[i] * positions.j[h] * positions.l[m].transpose()).trace()))
        })
    })
}

/// The joint accelerations [rad/s², m/s²] that the torques \[N m\] and forces \[N\] `tau` produce:
/// M q̈ = τ − bias, solved by Cholesky.
///
/// NaN where M is not positive definite.
#[must_use]
pub fn forward_dynamics<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    tau: &[T; N],
) -> [T; N] {
    let bias = bias(chain, q, qd);
    let lacking: SVector<T, N> = SVector::from_fn(|i, _| tau[i] - bias[i]);
    let found = factored(chain, q).map(|factors| factors.solve(&lacking));
    from_fn(|i| found.map_or(nan(), |found| found[i]))
}

/// The inverse of the joint-space inertia matrix, by Cholesky.
///
/// NaN where M is not positive definite.
#[must_use]
pub fn mass_matrix_inverse<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> [[T; N]; N] {
    let found = factored(chain, q).map(|factors| factors.inverse());
    from_fn(|i| from_fn(|m| found.map_or(nan(), |found| found[(i, m)])))
}

fn factored<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> Option<Cholesky<T, Const<N>>> {
    let rows = mass_matrix(chain, q);
    SMatrix::<T, N, N>::from_fn(|i, m| rows[i][m]).cholesky()
}

fn nan<T: RealField>() -> T {
    nalgebra::convert(f64::NAN)
}

/// The kinetic energy Σ ½ Tr(W J Wᵗ) \[J\] (22).
#[must_use]
pub fn kinetic_energy<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
) -> T {
    let rest = [T::zero(); N];
    let motion = Motion::at(chain, q, qd, &rest);
    let half: T = nalgebra::convert(0.5);
    sum((0..N).map(|i| {
        let w = motion.w[i];
        half * (w * motion.positions.j[i] * w.transpose()).trace()
    }))
}

/// The potential energy Σ −Tr(H_g J) \[J\], zero at the origin of frame 0 (§ 4.5).
#[must_use]
pub fn potential_energy<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> T {
    let h_g = gravity_matrix::<T>(chain.gravity);
    let positions = Positions::at(chain, q);
    sum(positions.j.iter().map(|j| -(h_g * j).trace()))
}

/// What depends on q alone, in frame 0.
struct Positions<T, const N: usize> {
    /// M₀ᵢ.
    m: [Matrix4<T>; N],
    /// Lᵢ₍₀₎.
    l: [Matrix4<T>; N],
    /// Jᵢ₍₀₎.
    j: [Matrix4<T>; N],
}

impl<T: RealField + Copy, const N: usize> Positions<T, N> {
    /// M₀ᵢ = M₀,parent · placement · exp(Lᵢ qᵢ), and the frame changes to frame 0.
    fn at<const F: usize>(chain: &Chain<N, F>, q: &[T; N]) -> Self {
        let mut m = [Matrix4::identity(); N];
        for (i, joint) in chain.joints.iter().enumerate() {
            let m_0_parent = chain.parent(i).map_or_else(Matrix4::identity, |p| m[p]);
            let l = dense(joint.screw.to_matrix());
            m[i] = m_0_parent * dense(joint.placement.to_matrix()) * exponential(&l, q[i]);
        }
        let l = from_fn(|i| m[i] * dense(chain.joints[i].screw.to_matrix()) * inverse(&m[i]));
        let j = from_fn(|i| m[i] * dense(chain.joints[i].inertia.to_matrix()) * m[i].transpose());
        Self { m, l, j }
    }

    /// M₀,frame.
    fn of_frame(&self, frame: &Frame) -> Matrix4<T> {
        let carrier = frame.body.and_then(|i| self.m.get(i));
        carrier.copied().unwrap_or_else(Matrix4::identity) * dense(frame.placement.to_matrix())
    }
}

/// What depends on the rates as well, in frame 0.
struct Motion<T, const N: usize> {
    positions: Positions<T, N>,
    /// W₀ᵢ₍₀₎.
    w: [Matrix4<T>; N],
    /// H₀ᵢ₍₀₎.
    h: [Matrix4<T>; N],
}

impl<T: RealField + Copy, const N: usize> Motion<T, N> {
    /// Of one joint W = L q̇ and H = L q̈ + L² q̇² (Part II); composed by (12) and (13).
    fn at<const F: usize>(chain: &Chain<N, F>, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> Self {
        let positions = Positions::at(chain, q);
        let mut w = [Matrix4::zeros(); N];
        let mut h = [Matrix4::zeros(); N];
        let two: T = nalgebra::convert(2.0);
        for i in 0..N {
            let (w_0_parent, h_0_parent) = chain
                .parent(i)
                .map_or_else(|| (Matrix4::zeros(), Matrix4::zeros()), |p| (w[p], h[p]));
            let l = positions.l[i];
            let w_joint = l * qd[i];
            let h_joint = l * qdd[i] + l * l * (qd[i] * qd[i]);
            w[i] = w_0_parent + w_joint;
            h[i] = h_0_parent + h_joint + w_0_parent * w_joint * two;
        }
        Self { positions, w, h }
    }

    fn w_of(&self, body: Option<usize>) -> Matrix4<T> {
        let w = body.and_then(|i| self.w.get(i));
        w.copied().unwrap_or_else(Matrix4::zeros)
    }

    fn h_of(&self, body: Option<usize>) -> Matrix4<T> {
        let h = body.and_then(|i| self.h.get(i));
        h.copied().unwrap_or_else(Matrix4::zeros)
    }
}

/// The columns M L₍₀₎ M⁻¹, M being the change of frame that `m_from_0` makes of M₀,frame.
fn jacobian<T: RealField + Copy, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    frame: &Frame,
    q: &[T; N],
    m_from_0: impl Fn(&Matrix4<T>) -> Matrix4<T>,
) -> [Screw<T>; N] {
    let positions = Positions::at(chain, q);
    let m = m_from_0(&positions.of_frame(frame));
    from_fn(|i| {
        let l = if chain.carries(i, frame.body) {
            m * positions.l[i] * inverse(&m)
        } else {
            Matrix4::zeros()
        };
        Screw::new(vector_of(&l), column(&l))
    })
}

/// exp(L φ) = I + L φ + L² (1 − cos φ) + L³ (φ − sin φ), the series of § 5 summed by u̲ⁿ⁺² = −u̲ⁿ.
///
/// 1 − cos φ is 2 sin²(φ/2), which keeps all its digits. The block u̲ φ + u̲³ (φ − sin φ) of the first
/// and last terms is u̲ sin φ, and is written so.
fn exponential<T: RealField + Copy>(l: &Matrix4<T>, phi: T) -> Matrix4<T> {
    let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
    let (sine, half_sine) = (phi.sin(), (half * phi).sin());
    let versine = two * half_sine * half_sine;
    let (square, cube) = (l * l, l * l * l);
    let rotation = Matrix4::identity() + l * sine + square * versine;
    let translation = l * phi + square * versine + cube * (phi - sine);
    let mut q = rotation;
    for i in 0..3 {
        q[(i, 3)] = translation[(i, 3)];
    }
    q
}

/// M⁻¹ = (Rᵗ, −Rᵗ t; 0, 1) (§ 2.2).
fn inverse<T: RealField + Copy>(m: &Matrix4<T>) -> Matrix4<T> {
    let rotation = m.fixed_view::<3, 3>(0, 0).transpose();
    let translation = -(rotation * m.fixed_view::<3, 1>(0, 3));
    let mut inverse = rotation.to_homogeneous();
    inverse.fixed_view_mut::<3, 1>(0, 3).copy_from(&translation);
    inverse
}

/// L ⊗ Φ = u · c + b · f (Part II).
fn pseudo_scalar_product<T: RealField + Copy>(l: &Matrix4<T>, phi: &Matrix4<T>) -> T {
    let (u, b, c, f) = (vector_of(l), column(l), vector_of(phi), column(phi));
    u[0] * c[0] + u[1] * c[1] + u[2] * c[2] + b[0] * f[0] + b[1] * f[1] + b[2] * f[2]
}

/// H_g (§ 4.5).
fn gravity_matrix<T: RealField + Copy>(gravity: [f64; 3]) -> Matrix4<T> {
    dense(Acceleration::gravity(gravity).to_matrix())
}

/// A constant 4×4 matrix, rounded to T.
fn dense<T: RealField + Copy>(rows: [[f64; 4]; 4]) -> Matrix4<T> {
    Matrix4::from_fn(|i, j| nalgebra::convert(rows[i][j]))
}

/// The upper left block, as rows.
fn block<T: RealField + Copy>(x: &Matrix4<T>) -> [[T; 3]; 3] {
    from_fn(|i| from_fn(|j| x[(i, j)]))
}

/// The upper three entries of the last column.
fn column<T: RealField + Copy>(x: &Matrix4<T>) -> [T; 3] {
    from_fn(|i| x[(i, 3)])
}

/// The vector of the skew upper left block.
fn vector_of<T: RealField + Copy>(x: &Matrix4<T>) -> [T; 3] {
    [x[(2, 1)], x[(0, 2)], x[(1, 0)]]
}

fn sum<T: RealField + Copy>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::zero(), |sum, term| sum + term)
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::ForwardKinematics<N, T>
    for Chain<N, F>
{
    fn forward_kinematics(&self, q: &[T; N]) -> Pose<T> {
        forward_kinematics(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::SpatialJacobian<N, T>
    for Chain<N, F>
{
    fn spatial_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        spatial_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::BodyJacobian<N, T>
    for Chain<N, F>
{
    fn body_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        body_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::GeometricJacobian<N, T>
    for Chain<N, F>
{
    fn geometric_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        geometric_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Velocity<N, T> for Chain<N, F> {
    fn velocity(&self, q: &[T; N], qd: &[T; N]) -> Velocity<T> {
        velocity(self, &self.tip(), q, qd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Acceleration<N, T>
    for Chain<N, F>
{
    fn acceleration(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> Acceleration<T> {
        acceleration(self, &self.tip(), q, qd, qdd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::InverseDynamics<N, T>
    for Chain<N, F>
{
    fn inverse_dynamics(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> [T; N] {
        inverse_dynamics(self, q, qd, qdd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Gravity<N, T> for Chain<N, F> {
    fn gravity(&self, q: &[T; N]) -> [T; N] {
        gravity(self, q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Bias<N, T> for Chain<N, F> {
    fn bias(&self, q: &[T; N], qd: &[T; N]) -> [T; N] {
        bias(self, q, qd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::MassMatrix<N, T> for Chain<N, F> {
    fn mass_matrix(&self, q: &[T; N]) -> [[T; N]; N] {
        mass_matrix(self, q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::ForwardDynamics<N, T>
    for Chain<N, F>
{
    fn forward_dynamics(&self, q: &[T; N], qd: &[T; N], tau: &[T; N]) -> [T; N] {
        forward_dynamics(self, q, qd, tau)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::MassMatrixInverse<N, T>
    for Chain<N, F>
{
    fn mass_matrix_inverse(&self, q: &[T; N]) -> [[T; N]; N] {
        mass_matrix_inverse(self, q)
    }
}

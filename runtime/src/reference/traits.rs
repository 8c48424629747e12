//! The robot as data has every function, as generated robots have.
//!
//! In: a [`Chain`]. Out: the traits of [`robot`] for it, each by the function of its name in
//! [`generic`], of the tip where a function is of a frame. It computes nothing itself.

use super::generic;
use crate::matrix::{Acceleration, Pose, Screw, Velocity};
use crate::robot;
use crate::robot::chain::Chain;
use nalgebra::RealField;

impl<T: RealField + Copy, const N: usize, const F: usize> robot::ForwardKinematics<N, T>
    for Chain<N, F>
{
    fn forward_kinematics(&self, q: &[T; N]) -> Pose<T> {
        generic::forward_kinematics(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::SpatialJacobian<N, T>
    for Chain<N, F>
{
    fn spatial_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        generic::spatial_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::BodyJacobian<N, T>
    for Chain<N, F>
{
    fn body_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        generic::body_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::GeometricJacobian<N, T>
    for Chain<N, F>
{
    fn geometric_jacobian(&self, q: &[T; N]) -> [Screw<T>; N] {
        generic::geometric_jacobian(self, &self.tip(), q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Velocity<N, T> for Chain<N, F> {
    fn velocity(&self, q: &[T; N], qd: &[T; N]) -> Velocity<T> {
        generic::velocity(self, &self.tip(), q, qd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Acceleration<N, T>
    for Chain<N, F>
{
    fn acceleration(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> Acceleration<T> {
        generic::acceleration(self, &self.tip(), q, qd, qdd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::InverseDynamics<N, T>
    for Chain<N, F>
{
    fn inverse_dynamics(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> [T; N] {
        generic::inverse_dynamics(self, q, qd, qdd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Gravity<N, T> for Chain<N, F> {
    fn gravity(&self, q: &[T; N]) -> [T; N] {
        generic::gravity(self, q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::Bias<N, T> for Chain<N, F> {
    fn bias(&self, q: &[T; N], qd: &[T; N]) -> [T; N] {
        generic::bias(self, q, qd)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::MassMatrix<N, T> for Chain<N, F> {
    fn mass_matrix(&self, q: &[T; N]) -> [[T; N]; N] {
        generic::mass_matrix(self, q)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::ForwardDynamics<N, T>
    for Chain<N, F>
{
    fn forward_dynamics(&self, q: &[T; N], qd: &[T; N], tau: &[T; N]) -> [T; N] {
        generic::forward_dynamics(self, q, qd, tau)
    }
}

impl<T: RealField + Copy, const N: usize, const F: usize> robot::MassMatrixInverse<N, T>
    for Chain<N, F>
{
    fn mass_matrix_inverse(&self, q: &[T; N]) -> [[T; N]; N] {
        generic::mass_matrix_inverse(self, q)
    }
}

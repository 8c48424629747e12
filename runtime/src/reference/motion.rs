//! Where the bodies of a robot are, and how they move.
//!
//! In: a [`Chain`] and its state. Out: M, L and J, and with the rates W and H, of every body as dense
//! matrices in frame 0 (Part II, open chains). It knows no forces.

use super::dense::{dense, exponential, inverse};
use crate::robot::chain::{Chain, Frame};
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// What depends on q alone, in frame 0.
pub(super) struct Positions<T, const N: usize> {
    /// M₀ᵢ.
    pub(super) m: [Matrix4<T>; N],
    /// Lᵢ₍₀₎.
    pub(super) l: [Matrix4<T>; N],
    /// Jᵢ₍₀₎.
    pub(super) j: [Matrix4<T>; N],
}

impl<T: RealField + Copy, const N: usize> Positions<T, N> {
    /// M₀ᵢ = M₀,parent · placement · exp(Lᵢ qᵢ), and the frame changes to frame 0.
    pub(super) fn at<const F: usize>(chain: &Chain<N, F>, q: &[T; N]) -> Self {
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
    pub(super) fn pose_of(&self, frame: &Frame) -> Matrix4<T> {
        let carrier = frame.body.and_then(|i| self.m.get(i));
        carrier.copied().unwrap_or_else(Matrix4::identity) * dense(frame.placement.to_matrix())
    }
}

/// What depends on the rates as well, in frame 0.
pub(super) struct Motion<T, const N: usize> {
    pub(super) positions: Positions<T, N>,
    /// W₀ᵢ₍₀₎.
    pub(super) w: [Matrix4<T>; N],
    /// H₀ᵢ₍₀₎.
    pub(super) h: [Matrix4<T>; N],
}

impl<T: RealField + Copy, const N: usize> Motion<T, N> {
    /// Of one joint W = L q̇ and H = L q̈ + L² q̇² (Part II); composed by (12) and (13).
    pub(super) fn at<const F: usize>(
        chain: &Chain<N, F>,
        q: &[T; N],
        qd: &[T; N],
        qdd: &[T; N],
    ) -> Self {
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

    pub(super) fn velocity_of(&self, body: Option<usize>) -> Matrix4<T> {
        let w = body.and_then(|i| self.w.get(i));
        w.copied().unwrap_or_else(Matrix4::zeros)
    }

    pub(super) fn acceleration_of(&self, body: Option<usize>) -> Matrix4<T> {
        let h = body.and_then(|i| self.h.get(i));
        h.copied().unwrap_or_else(Matrix4::zeros)
    }
}

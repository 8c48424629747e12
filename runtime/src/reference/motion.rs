//! Where the bodies of a robot are, and how they move.
//!
//! In: a [`Chain`] and its state. Out: M, L and J, and with the rates W and H, of every body as dense
//! matrices in frame 0 (Part II, open chains). It knows no forces.

use super::dense::{dense, exponential, inverse, turned};
use crate::matrix::Screw;
use crate::robot::chain::{Chain, Frame};
use crate::robot::drive::{Drive, VELOCITIES};
use crate::robot::joint::{Joint, Motion as Allowed};
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// The most velocities of a joint.
const MOST: usize = VELOCITIES;

/// What depends on q alone, in frame 0.
pub(super) struct Positions<T, const B: usize> {
    /// M₀ᵢ.
    pub(super) m: [Matrix4<T>; B],
    /// Jᵢ₍₀₎.
    pub(super) j: [Matrix4<T>; B],
    /// Lᵢ₍₀₎ of each velocity of the joint, and of the multiplier times it where another's moves it.
    l: [[Matrix4<T>; MOST]; B],
    /// Where the velocities of the joint begin, and how many they are.
    velocities: [(usize, usize); B],
    /// What drives each of them, and what the joint makes of it.
    drives: [([Drive; MOST], T); B],
}

/// A motion that one velocity gives to a body, and to all that it carries.
pub(super) struct Freedom<T> {
    /// The body.
    pub(super) body: usize,
    /// The place of the velocity.
    pub(super) velocity: usize,
    /// L₍₀₎.
    pub(super) l: Matrix4<T>,
    /// What drives the joint there.
    pub(super) drive: Drive,
    /// What the joint's own rate is times the velocity.
    pub(super) multiplier: T,
}

impl<T: RealField + Copy, const B: usize> Positions<T, B> {
    /// M₀ᵢ = M₀,parent · placement · Q of the joint, and the frame changes to frame 0.
    pub(super) fn at<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
    ) -> Self {
        Self::from(chain, q, Matrix4::identity())
    }

    /// The same from a frame with the axes of frame 0 and its origin where the first body has its own: what is far
    /// from frame 0 keeps its digits there.
    pub(super) fn at_first_body<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
    ) -> Self {
        let far = Self::at(chain, q);
        let origin = far.m.first().map(|m| -m.fixed_view::<3, 1>(0, 3));
        let back = origin.map_or_else(Matrix4::identity, |back| Matrix4::new_translation(&back));
        Self::from(chain, q, back)
    }

    /// The same from a frame in which frame 0 is at a pose.
    fn from<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
        frame_0: Matrix4<T>,
    ) -> Self {
        let mut m = [Matrix4::identity(); B];
        for (i, joint) in chain.joints.iter().enumerate() {
            let m_0_parent = chain.parent(i).map_or(frame_0, |p| m[p]);
            let own = q.get(chain.coordinates(i)).unwrap_or(&[]);
            m[i] = m_0_parent * dense(joint.placement.to_matrix()) * displacement(joint, own);
        }
        let l = from_fn(|i| {
            let screws = screws(&chain.joints[i]);
            screws.map(|screw| m[i] * screw * inverse(&m[i]))
        });
        let j = from_fn(|i| m[i] * dense(chain.joints[i].inertia.to_matrix()) * m[i].transpose());
        let velocities = from_fn(|i| {
            let velocities = chain.velocities(i);
            (velocities.start, velocities.len().min(MOST))
        });
        let drives = from_fn(|i| {
            let multiplier = match chain.joints[i].motion {
                Allowed::Following { multiplier, .. } => nalgebra::convert(multiplier),
                _ => T::one(),
            };
            (chain.joints[i].drives, multiplier)
        });
        Self {
            m,
            j,
            l,
            velocities,
            drives,
        }
    }

    /// M₀,frame.
    pub(super) fn pose_of(&self, frame: &Frame) -> Matrix4<T> {
        let carrier = frame.body.and_then(|i| self.m.get(i));
        carrier.copied().unwrap_or_else(Matrix4::identity) * dense(frame.placement.to_matrix())
    }

    /// What each velocity moves: several bodies, where joints follow others.
    pub(super) fn freedoms(&self) -> impl Iterator<Item = Freedom<T>> {
        (0..B).flat_map(|body| self.of(body))
    }

    /// What the velocities of one joint do to its body.
    pub(super) fn of(&self, body: usize) -> impl Iterator<Item = Freedom<T>> {
        let (start, count) = self.velocities[body];
        (0..count).map(move |k| Freedom {
            body,
            velocity: start + k,
            l: self.l[body][k],
            drive: self.drives[body].0[k],
            multiplier: self.drives[body].1,
        })
    }
}

/// What depends on the rates as well, in frame 0.
pub(super) struct Motion<T, const B: usize> {
    pub(super) positions: Positions<T, B>,
    /// W₀ᵢ₍₀₎.
    pub(super) w: [Matrix4<T>; B],
    /// H₀ᵢ₍₀₎.
    pub(super) h: [Matrix4<T>; B],
}

impl<T: RealField + Copy, const B: usize> Motion<T, B> {
    /// Of one joint W = Σ L q̇ and H = Σ L q̈ + W², because its screws are constant in the frame of the
    /// moved body: of one velocity that is L q̈ + L² q̇² (Part II). Composed by (12) and (13).
    pub(super) fn at<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
        qd: &[T; N],
        qdd: &[T; N],
    ) -> Self {
        Self::of(chain, Positions::at(chain, q), qd, qdd)
    }

    /// The same, seen from wherever the positions are.
    pub(super) fn of<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        positions: Positions<T, B>,
        qd: &[T; N],
        qdd: &[T; N],
    ) -> Self {
        let mut w = [Matrix4::zeros(); B];
        let mut h = [Matrix4::zeros(); B];
        let two: T = nalgebra::convert(2.0);
        for i in 0..B {
            let (w_0_parent, h_0_parent) = chain
                .parent(i)
                .map_or_else(|| (Matrix4::zeros(), Matrix4::zeros()), |p| (w[p], h[p]));
            let along = |rates: &[T; N]| {
                let each = positions.of(i);
                each.fold(Matrix4::zeros(), |sum, freedom| {
                    sum + freedom.l * rates.get(freedom.velocity).copied().unwrap_or(T::zero())
                })
            };
            let w_joint = along(qd);
            let h_joint = along(qdd) + w_joint * w_joint;
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

impl<T: RealField + Copy> Freedom<T> {
    /// What its drive takes of the velocity's torque: armature q̈ + damping q̇ + friction sign q̇ at the
    /// joint's own rate, times the multiplier.
    pub(super) fn driven<const N: usize>(&self, qd: &[T; N], qdd: &[T; N]) -> T {
        let Drive {
            armature,
            damping,
            friction,
        } = self.drive;
        let numbers: [T; 3] = [armature, damping, friction].map(nalgebra::convert);
        let of_each = self.of_drives(qd, qdd).into_iter().zip(numbers);
        of_each.fold(T::zero(), |sum, (of_one, number)| sum + of_one * number)
    }

    /// The same of an armature of 1, of a damping of 1 and of a friction of 1.
    pub(super) fn of_drives<const N: usize>(&self, qd: &[T; N], qdd: &[T; N]) -> [T; 3] {
        let own = |rates: &[T; N]| {
            let rate = rates.get(self.velocity).copied().unwrap_or(T::zero());
            self.multiplier * rate
        };
        let rate = own(qd);
        let sign = if rate > T::zero() {
            T::one()
        } else if rate < T::zero() {
            -T::one()
        } else {
            T::zero()
        };
        [own(qdd), rate, sign].map(|felt| self.multiplier * felt)
    }

    /// Viscous friction as the velocity feels it.
    pub(super) fn damping(&self) -> T {
        let damping: T = nalgebra::convert(self.drive.damping);
        self.multiplier * self.multiplier * damping
    }

    /// The armature as the velocity feels it.
    pub(super) fn armature(&self) -> T {
        let armature: T = nalgebra::convert(self.drive.armature);
        self.multiplier * self.multiplier * armature
    }
}

/// Q of a joint at its coordinates; of one that follows another, at those of the other. None where there
/// are not as many as there should be.
fn displacement<T: RealField + Copy>(joint: &Joint, q: &[T]) -> Matrix4<T> {
    let l = dense(joint.screw.to_matrix());
    match (joint.motion, q) {
        (Allowed::Along, &[q]) => exponential(&l, q),
        (Allowed::Following { multiplier, .. }, &[q]) => {
            exponential(&l, q * nalgebra::convert(multiplier))
        }
        (Allowed::Planar, &[x, y, angle]) => {
            let about_z = dense(Screw::new([0.0, 0.0, 1.0], [0.0; 3]).to_matrix());
            let turn = exponential(&about_z, angle);
            Matrix4::new_translation(&[x, y, T::zero()].into()) * turn
        }
        (Allowed::Spherical, &[x, y, z, w]) => turned([x, y, z], w),
        (Allowed::Floating, &[x, y, z, v_x, v_y, v_z, w]) => {
            Matrix4::new_translation(&[x, y, z].into()) * turned([v_x, v_y, v_z], w)
        }
        _ => Matrix4::identity(),
    }
}

/// L of each velocity of a joint in the frame of its body, times the multiplier where it follows another.
fn screws<T: RealField + Copy>(joint: &Joint) -> [Matrix4<T>; MOST] {
    let own = dense(joint.screw.to_matrix());
    let axis = |k: usize| from_fn(|i| if i == k { 1.0 } else { 0.0 });
    let turn = |k| dense(Screw::new(axis(k), [0.0; 3]).to_matrix());
    let slide = |k| dense(Screw::new([0.0; 3], axis(k)).to_matrix());
    let none = Matrix4::zeros();
    match joint.motion {
        Allowed::Along => [own, none, none, none, none, none],
        Allowed::Following { multiplier, .. } => {
            let times = own * nalgebra::convert::<f64, T>(multiplier);
            [times, none, none, none, none, none]
        }
        Allowed::Planar => [slide(0), slide(1), turn(2), none, none, none],
        Allowed::Spherical => [turn(0), turn(1), turn(2), none, none, none],
        Allowed::Floating => [slide(0), slide(1), slide(2), turn(0), turn(1), turn(2)],
    }
}

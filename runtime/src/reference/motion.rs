//! Poses, velocities and accelerations of the bodies of a robot.
//!
//! In: a [`Chain`] and its state. Out: M, L and J of every body, and with rates W and H, as dense matrices
//! in frame 0 (Part II, open chains).

use super::dense::{dense, exponential, inverse, turned};
use crate::matrix::Screw;
use crate::robot::actuator::{JointActuator, VELOCITIES};
use crate::robot::chain::{Chain, Frame};
use crate::robot::joint::{Joint, Motion as Allowed};
use core::array::from_fn;
use nalgebra::{Matrix4, RealField};

/// Quantities that depend on q alone, in frame 0.
pub(super) struct Positions<T, const B: usize> {
    /// M₀ᵢ.
    pub(super) m: [Matrix4<T>; B],
    /// Jᵢ₍₀₎.
    pub(super) j: [Matrix4<T>; B],
    /// Lᵢ₍₀₎ of each velocity of the joint; of a mimic joint, times its multiplier.
    l: [[Matrix4<T>; VELOCITIES]; B],
    /// The index of the joint's first velocity, and their number.
    velocities: [(usize, usize); B],
    /// Armature and friction of each velocity, and the multiplier of the joint; 1 if it is no mimic joint.
    actuators: [([JointActuator; VELOCITIES], T); B],
}

/// The motion of a body at one velocity of its joint. Mimic joints share a velocity with the mimicked joint.
#[derive(Clone, Copy)]
pub(super) struct DegreeOfFreedom<T> {
    /// The index of the body.
    pub(super) body: usize,
    /// The index of the velocity.
    pub(super) velocity: usize,
    /// L₍₀₎ of the velocity.
    pub(super) l: Matrix4<T>,
    /// Armature and friction of the joint.
    pub(super) actuator: JointActuator,
    /// The joint's own rate divided by the velocity.
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

    /// The same in a frame with the axes of frame 0 and its origin at that of the first body, for accuracy far from
    /// frame 0.
    pub(super) fn at_first_body<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
    ) -> Self {
        let far = Self::at(chain, q);
        let origin = far.m.first().map(|m| -m.fixed_view::<3, 1>(0, 3));
        let back = origin.map_or_else(Matrix4::identity, |back| Matrix4::new_translation(&back));
        Self::from(chain, q, back)
    }

    /// The same in a frame in which frame 0 has the pose `frame_0`.
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
            (velocities.start, velocities.len().min(VELOCITIES))
        });
        let actuators = from_fn(|i| {
            let multiplier = match chain.joints[i].motion {
                Allowed::Mimic { multiplier, .. } => nalgebra::convert(multiplier),
                _ => T::one(),
            };
            (chain.joints[i].actuators, multiplier)
        });
        Self {
            m,
            j,
            l,
            velocities,
            actuators,
        }
    }

    /// M₀,frame.
    pub(super) fn pose_of(&self, frame: &Frame) -> Matrix4<T> {
        let carrier = frame.body.and_then(|i| self.m.get(i));
        carrier.copied().unwrap_or_else(Matrix4::identity) * dense(frame.placement.to_matrix())
    }

    /// The degrees of freedom of all bodies; with mimic joints, several have the same velocity.
    pub(super) fn degrees_of_freedom(&self) -> impl Iterator<Item = DegreeOfFreedom<T>> {
        (0..B).flat_map(|body| self.of_joint(body))
    }

    /// The degrees of freedom of one joint.
    pub(super) fn of_joint(&self, body: usize) -> impl Iterator<Item = DegreeOfFreedom<T>> {
        let (start, count) = self.velocities[body];
        (0..count).map(move |k| DegreeOfFreedom {
            body,
            velocity: start + k,
            l: self.l[body][k],
            actuator: self.actuators[body].0[k],
            multiplier: self.actuators[body].1,
        })
    }
}

/// Quantities that depend on the rates as well, in frame 0.
pub(super) struct Motion<T, const B: usize> {
    pub(super) positions: Positions<T, B>,
    /// W₀ᵢ₍₀₎.
    pub(super) w: [Matrix4<T>; B],
    /// H₀ᵢ₍₀₎.
    pub(super) h: [Matrix4<T>; B],
}

impl<T: RealField + Copy, const B: usize> Motion<T, B> {
    /// For one joint, W = Σ L q̇ and H = Σ L q̈ + W², because its screws are constant in the frame of the
    /// moved body; with one velocity H = L q̈ + L² q̇² (Part II). Composed by (12) and (13).
    pub(super) fn at<const N: usize, const F: usize, const Q: usize>(
        chain: &Chain<N, F, Q, B>,
        q: &[T; Q],
        qd: &[T; N],
        qdd: &[T; N],
    ) -> Self {
        Self::of(chain, Positions::at(chain, q), qd, qdd)
    }

    /// The same in the frame of `positions`.
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
                let each = positions.of_joint(i);
                each.fold(Matrix4::zeros(), |sum, dof| {
                    sum + dof.l * rates.get(dof.velocity).copied().unwrap_or(T::zero())
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

impl<T: RealField + Copy> DegreeOfFreedom<T> {
    /// The torque of armature and friction at the velocity: armature q̈ + damping q̇ + friction sign q̇ at the
    /// joint's own rate, times the multiplier.
    pub(super) fn actuator_torque<const N: usize>(&self, qd: &[T; N], qdd: &[T; N]) -> T {
        let JointActuator {
            armature,
            damping,
            friction,
        } = self.actuator;
        let numbers: [T; 3] = [armature, damping, friction].map(nalgebra::convert);
        let of_each = self.unit_actuator_torques(qd, qdd).into_iter().zip(numbers);
        of_each.fold(T::zero(), |sum, (of_one, number)| sum + of_one * number)
    }

    /// The torques of an armature of 1, of a damping of 1 and of a friction of 1.
    pub(super) fn unit_actuator_torques<const N: usize>(
        &self,
        qd: &[T; N],
        qdd: &[T; N],
    ) -> [T; 3] {
        let rate = self.rate(qd);
        let sign = if rate > T::zero() {
            T::one()
        } else if rate < T::zero() {
            -T::one()
        } else {
            T::zero()
        };
        [self.rate(qdd), rate, sign].map(|torque| self.multiplier * torque)
    }

    /// The rate of the joint itself, from q̇, or its second rate from q̈.
    pub(super) fn rate<const N: usize>(&self, rates: &[T; N]) -> T {
        let rate = rates.get(self.velocity).copied().unwrap_or(T::zero());
        self.multiplier * rate
    }

    /// Viscous friction, reflected to the velocity.
    pub(super) fn damping(&self) -> T {
        let damping: T = nalgebra::convert(self.actuator.damping);
        self.multiplier * self.multiplier * damping
    }

    /// The armature, reflected to the velocity.
    pub(super) fn armature(&self) -> T {
        let armature: T = nalgebra::convert(self.actuator.armature);
        self.multiplier * self.multiplier * armature
    }
}

/// Q of a joint at its coordinates, or those of the mimicked joint. The identity if their number is wrong.
fn displacement<T: RealField + Copy>(joint: &Joint, q: &[T]) -> Matrix4<T> {
    let l = dense(joint.screw.to_matrix());
    match (joint.motion, q) {
        (Allowed::Along, &[q]) => exponential(&l, q),
        (Allowed::Mimic { multiplier, .. }, &[q]) => {
            exponential(&l, q * nalgebra::convert(multiplier))
        }
        (Allowed::Planar, &[x, y, angle]) => {
            let about_z = dense(Screw::new([0.0, 0.0, 1.0], [0.0; 3]).to_matrix());
            let rotation = exponential(&about_z, angle);
            Matrix4::new_translation(&[x, y, T::zero()].into()) * rotation
        }
        (Allowed::Spherical, &[x, y, z, w]) => turned([x, y, z], w),
        (Allowed::Floating, &[x, y, z, v_x, v_y, v_z, w]) => {
            Matrix4::new_translation(&[x, y, z].into()) * turned([v_x, v_y, v_z], w)
        }
        _ => Matrix4::identity(),
    }
}

/// L of each velocity of a joint in the frame of its body; of a mimic joint, times its multiplier.
fn screws<T: RealField + Copy>(joint: &Joint) -> [Matrix4<T>; VELOCITIES] {
    let own = dense(joint.screw.to_matrix());
    let axis = |k: usize| from_fn(|i| if i == k { 1.0 } else { 0.0 });
    let rotation = |k| dense(Screw::new(axis(k), [0.0; 3]).to_matrix());
    let translation = |k| dense(Screw::new([0.0; 3], axis(k)).to_matrix());
    let none = Matrix4::zeros();
    match joint.motion {
        Allowed::Along => [own, none, none, none, none, none],
        Allowed::Mimic { multiplier, .. } => {
            let multiple = own * nalgebra::convert::<f64, T>(multiplier);
            [multiple, none, none, none, none, none]
        }
        Allowed::Planar => [
            translation(0),
            translation(1),
            rotation(2),
            none,
            none,
            none,
        ],
        Allowed::Spherical => [rotation(0), rotation(1), rotation(2), none, none, none],
        Allowed::Floating => [
            translation(0),
            translation(1),
            translation(2),
            rotation(0),
            rotation(1),
            rotation(2),
        ],
    }
}

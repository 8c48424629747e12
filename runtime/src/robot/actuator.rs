//! Armature and friction of a joint as data.
//!
//! In: numbers. Out: a [`JointActuator`], as a constant. [`crate::generic`] computes its torque.

/// The largest number of velocities of a joint.
pub(crate) const VELOCITIES: usize = 6;

/// Armature, damping and friction at one velocity of a joint.
///
/// They add armature · q̈ + damping · q̇ + friction · sign q̇ to the torque; the sign is 0 at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointActuator {
    /// Inertia of the motor's rotor, reflected to the joint: times the square of the gear ratio [kg m²; kg for a
    /// prismatic joint].
    pub armature: f64,
    /// Viscous friction [N m s/rad, N s/m].
    pub damping: f64,
    /// Coulomb friction [N m, N].
    pub friction: f64,
}

impl JointActuator {
    /// No armature and no friction.
    pub const NONE: Self = Self::new(0.0, 0.0, 0.0);

    /// An armature [kg m²; kg for a prismatic joint], viscous friction `damping` [N m s/rad, N s/m] and Coulomb
    /// friction `friction` [N m, N].
    #[inline]
    #[must_use]
    pub const fn new(armature: f64, damping: f64, friction: f64) -> Self {
        Self {
            armature,
            damping,
            friction,
        }
    }
}

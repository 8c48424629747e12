//! What drives a joint beside its bodies: the motor's inertia and friction.
//!
//! In: numbers. Out: a [`Drive`], as a constant. What it does to a motion is for [`crate::generic`].

/// The most velocities that a joint has.
pub(crate) const VELOCITIES: usize = 6;

/// What one velocity of a joint meets beside the bodies.
///
/// The joint takes armature q̈ + damping q̇ + friction sign q̇ more; the sign is 0 at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// Inertia that the joint feels beside that of the bodies: of the rotor of its motor, times the square
    /// of the ratio between them [kg m², of a slide kg].
    pub armature: f64,
    /// Viscous friction [N m s/rad, N s/m].
    pub damping: f64,
    /// Coulomb friction [N m, N].
    pub friction: f64,
}

impl Drive {
    /// No drive.
    pub const NONE: Self = Self::new(0.0, 0.0, 0.0);

    /// An armature [kg m², of a slide kg], viscous friction `damping` [N m s/rad, N s/m] and Coulomb friction
    /// `friction` [N m, N].
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

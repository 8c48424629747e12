//! Γ, the momentum matrix (paper, eq. 15).

use super::{Inertia, Pose, Vector, Velocity};
use crate::expression::Term;

/// A momentum Γ: γ̲, ρ; −ρᵗ, 0.
#[derive(Clone, Copy, Debug)]
pub struct Momentum<E> {
    /// Angular momentum about the origin of the frame [kg m²/s].
    pub gamma: Vector<E>,
    /// Linear momentum [kg m/s].
    pub rho: Vector<E>,
}

impl<'g> Momentum<Term<'g>> {
    /// Γ = skew\[W J\] (eqs. 20 and 26).
    #[must_use]
    pub fn of(w: Velocity<Term<'g>>, j: Inertia<Term<'g>>) -> Self {
        let (gamma, rho) = j.skew(w.omega, w.v);
        Self { gamma, rho }
    }

    /// M Γ Mᵗ (eq. 17).
    #[must_use]
    pub fn change_frame(self, pose: Pose<Term<'g>>) -> Self {
        let rho = pose.rotation * self.rho;
        Self {
            gamma: pose.rotation * self.gamma + pose.translation.cross(rho),
            rho,
        }
    }
}

//! Whether a robot as data can be a robot.
//!
//! In: a [`Chain`] as it was written. Out: nothing, or what is wrong with the first joint or frame
//! that is. It never repairs anything.

use super::chain::Chain;
use crate::error::{Error, finite};
use crate::matrix::{Pose, Screw};

impl<const N: usize, const F: usize> Chain<N, F> {
    /// Refuses a chain that the recursions cannot be right for: parents must come before children,
    /// placements be poses, screws have unit vectors, and bodies be possible, to within `tolerance`.
    ///
    /// # Errors
    ///
    /// [`Error::NotATree`], or those of [`Pose::checked`], [`Screw::checked`] and
    /// [`Inertia::check`](crate::Inertia::check); the first one found.
    pub fn check(&self, tolerance: f64) -> Result<(), Error> {
        finite("a component of gravity", &self.gravity)?;
        for (i, joint) in self.joints.iter().enumerate() {
            if let Some(parent) = joint.parent.filter(|parent| *parent >= i) {
                let joint = joint.name;
                return Err(Error::NotATree { joint, parent });
            }
            let place = &joint.placement;
            Pose::checked(*place.rotation(), place.translation(), tolerance)?;
            Screw::checked(joint.screw.u(), joint.screw.b(), tolerance)?;
            joint.inertia.check(tolerance)?;
        }
        for frame in &self.frames {
            if let Some(parent) = frame.body.filter(|body| *body >= N) {
                let joint = frame.name;
                return Err(Error::NotATree { joint, parent });
            }
            let place = &frame.placement;
            Pose::checked(*place.rotation(), place.translation(), tolerance)?;
        }
        Ok(())
    }
}

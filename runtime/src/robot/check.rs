//! Checks of a robot as data.
//!
//! In: a [`Chain`]. Out: nothing, or the error of the first wrong joint or frame. It never repairs anything.

use super::chain::Chain;
use super::joint::Motion;
use crate::error::{Error, finite};
use crate::matrix::{Pose, Screw};

impl<const N: usize, const F: usize, const Q: usize, const B: usize> Chain<N, F, Q, B> {
    /// Rejects a chain for which the recursions are wrong. These must hold, to within `tolerance`:
    ///
    /// - parents come before children, and frames are on existing bodies;
    /// - placements are poses, screws have unit vectors, inertias are physical;
    /// - mimicked joints move along a screw with a coordinate of their own;
    /// - all joints together have `Q` coordinates and `N` velocities;
    /// - gravity and the multipliers of mimic joints are finite.
    ///
    /// # Errors
    ///
    /// [`Error::ParentAfterChild`], [`Error::InvalidMimic`], [`Error::WrongCount`], or those of [`Pose::checked`],
    /// [`Screw::checked`] and [`Inertia::check`](crate::Inertia::check); the first one found.
    pub fn check(&self, tolerance: f64) -> Result<(), Error> {
        finite("a component of gravity", &self.gravity)?;
        for (i, joint) in self.joints.iter().enumerate() {
            if let Some(parent) = joint.parent.filter(|parent| *parent >= i) {
                let joint = joint.name;
                return Err(Error::ParentAfterChild { joint, parent });
            }
            let place = &joint.placement;
            Pose::checked(*place.rotation(), place.translation(), tolerance)?;
            if let Motion::Mimic {
                mimicked,
                multiplier,
            } = joint.motion
            {
                finite("a multiplier", &[multiplier])?;
                let other = self.joints.get(mimicked);
                if other.is_none_or(|other| other.motion != Motion::Along) {
                    let joint = joint.name;
                    return Err(Error::InvalidMimic { joint, mimicked });
                }
            }
            if matches!(joint.motion, Motion::Along | Motion::Mimic { .. }) {
                Screw::checked(joint.screw.u(), joint.screw.b(), tolerance)?;
            }
            joint.inertia.check(tolerance)?;
        }
        for frame in &self.frames {
            if let Some(parent) = frame.body.filter(|body| *body >= B) {
                let joint = frame.name;
                return Err(Error::ParentAfterChild { joint, parent });
            }
            let place = &frame.placement;
            Pose::checked(*place.rotation(), place.translation(), tolerance)?;
        }
        self.check_counts()
    }

    fn check_counts(&self) -> Result<(), Error> {
        let count = |own: fn(Motion) -> usize| {
            let each = self.joints.iter().map(|joint| own(joint.motion));
            each.sum::<usize>()
        };
        let lists = [
            ("coordinates", Q, count(Motion::coordinates)),
            ("velocities", N, count(Motion::velocities)),
        ];
        for (quantity, stated, found) in lists {
            if stated != found {
                return Err(Error::WrongCount {
                    quantity,
                    stated,
                    found,
                });
            }
        }
        Ok(())
    }
}

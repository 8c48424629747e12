//! The collision spheres of the described robot.
//!
//! In: the collision geometry of the description, and the bodies of the links. Out: frames at the centres of the
//! spheres, as bodies fixed to the links, and the radii.

use std::collections::HashMap;

use super::{Approximate, Contradiction, RobotReader, fixed};
use crate::chain::Chain;
use crate::dense::{BodyId, DenseBody};
use crate::list::List;
use crate::space::{FrameId, SphereId};

impl RobotReader<'_> {
    /// The spheres, with their frames as bodies fixed to the links.
    pub(super) fn spheres(
        &self,
        chain: &Chain,
        attached: &HashMap<&str, BodyId>,
        bodies: &mut List<BodyId, DenseBody>,
        frames: &mut List<FrameId, Option<BodyId>>,
    ) -> Result<List<SphereId, (FrameId, Approximate)>, Contradiction> {
        let mut spheres = List::new();
        for collision in &self.description.collisions {
            let name = self.description[collision.link].name.text.as_str();
            let (true, Some(sphere)) = (self.request.collision, &collision.sphere) else {
                continue;
            };
            let link = attached.get(name).copied();
            if link.is_none() && name != chain.report.base {
                continue;
            }
            let placement = self.placement(name, &sphere.origin)?;
            let frame = frames.push(Some(bodies.push(fixed(link, placement))));
            spheres.push((frame, Approximate::written(sphere.radius.exact())));
        }
        if spheres.len() == chain.spheres.len() {
            Ok(spheres)
        } else {
            Err(Contradiction(
                "how many collision spheres there are".to_owned(),
            ))
        }
    }
}

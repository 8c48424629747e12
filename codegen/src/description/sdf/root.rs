//! The root of the tree: the world, if a joint or the pose of the base needs it; and links for named frames.

use std::collections::HashSet;

use super::frames::{Role, WORLD_FRAME, is_nothing};
use super::index::FrameIndex;
use super::reading::Sdf;
use super::scope::WORLD;
use crate::description::{Link, Name};

impl Sdf<'_> {
    /// Adds a link without mass for each named frame.
    pub(super) fn add_frames(&mut self) {
        for frame in (0..self.frames.all.len()).map(FrameIndex) {
            let own = self.frames.get(frame);
            if own.role != Role::Named {
                continue;
            }
            let name = own.name.clone();
            let place = name.place;
            let around = self.frames.get(own.parent);
            let link = self.frames.link_of(frame);
            let is_on_same = self.frames.link_of(own.parent) == link;
            // A frame that is placed in another one of the same link is joined to that one.
            let (parent, origin) = match (link, around.role) {
                (Some(_), Role::Link(_) | Role::Named) if is_on_same => {
                    (around.name.clone(), own.steps.clone())
                }
                (Some(link), _) => {
                    let parent = self.link_name(link).clone();
                    (parent, self.between(self.link_frame(link), frame))
                }
                (None, _) => {
                    let parent = self.world_name(place);
                    (parent, self.between(WORLD_FRAME, frame))
                }
            };
            let joint = self.joint_names.fresh(&name.text);
            self.weld(joint, &parent, &name, origin, place);
            self.links.push(Link {
                name,
                inertial: None,
            });
        }
    }

    /// Adds the world, if something is joined to it or the base does not stand at its origin.
    pub(super) fn add_world(&mut self) {
        let carried: HashSet<&str> = self.joints.iter().map(|joint| &*joint.child.text).collect();
        let bases = self.link_frames.iter().enumerate();
        let mut bases = bases.filter(|(link, _)| !carried.contains(&*self.links[*link].name.text));
        let base = match (bases.next(), bases.next()) {
            (Some((link, frame)), None) => Some((link, *frame)),
            _ => None,
        };
        if let Some((link, frame)) = base {
            let origin = self.between(WORLD_FRAME, frame);
            if self.has_world || !is_nothing(&origin) {
                let name = self.links[link].name.clone();
                let world = self.world_name(name.place);
                let joint = self.joint_names.fresh(&name.text);
                self.weld(joint, &world, &name, origin, name.place);
            }
        }
        if self.has_world {
            let world = Link {
                name: Name::from(WORLD),
                inertial: None,
            };
            self.links.insert(0, world);
        }
    }
}

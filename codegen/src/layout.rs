//! Layout: the frame of each body, anywhere along its joint's axis and at any angle about it (structure rule 6), and
//! the regrouping of inertial parameters to base parameters (structure rule 4).
//!
//! In: a [`Chain`] and a [`Layout`]. Out: [`Bodies`] whose joints with one coordinate move about or along z, placed so
//! that as many entries of the placements as possible are 0 or 1. Which layout is best is decided by the operation
//! count of each function.

mod bodies;
mod frames;
mod regroup;
#[cfg(test)]
mod tests;

pub use bodies::{Bodies, Body, Closed};

use crate::chain::{Chain, Position};
use crate::expression::{Double, Graph};
use crate::matrix::Pose;

/// A choice of the frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Puts x along the common normal of a joint's axis and the next one's, and the origin at its foot (modified
    /// Denavit–Hartenberg), instead of the described frame.
    pub normals: bool,
    /// The origin of a body on a prismatic joint.
    pub sliding: Sliding,
    /// Rotates the frame of a last body so that its centre of mass lies in the xz plane.
    pub rotate_ends: bool,
    /// Regroups the inertial parameters.
    pub regroup: bool,
}

/// The origin of a body on a prismatic joint, which is free to choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sliding {
    /// The origin of the description.
    AsDescribed,
    /// The origin of its parent body.
    AtParent,
    /// The origin of its first child body.
    AtChild,
    /// Its centre of mass, after regrouping.
    AtMassCenter,
}

impl Layout {
    /// Frames and parameters of the description.
    pub const DESCRIBED: Self = Self {
        normals: false,
        sliding: Sliding::AsDescribed,
        rotate_ends: false,
        regroup: false,
    };

    /// Layouts to compare for functions that need no inertia.
    #[must_use]
    pub fn for_kinematics(chain: &Chain) -> Vec<Self> {
        let sliding = Self::sliding(
            chain,
            &[Sliding::AsDescribed, Sliding::AtParent, Sliding::AtChild],
        );
        Self::all(&sliding, &[false], false)
    }

    /// Layouts to compare for dynamics, for which base parameters suffice.
    #[must_use]
    pub fn for_dynamics(chain: &Chain) -> Vec<Self> {
        let sliding = Self::sliding(
            chain,
            &[
                Sliding::AsDescribed,
                Sliding::AtParent,
                Sliding::AtChild,
                Sliding::AtMassCenter,
            ],
        );
        Self::all(&sliding, &[false, true], true)
    }

    fn sliding(chain: &Chain, all: &[Sliding]) -> Vec<Sliding> {
        let translates = chain.joints.iter().any(|joint| {
            joint.motion.translates() && matches!(joint.position, Position::Along { .. })
        });
        if translates {
            all.to_vec()
        } else {
            vec![Sliding::AsDescribed]
        }
    }

    fn all(sliding: &[Sliding], turns: &[bool], regroup: bool) -> Vec<Self> {
        let mut layouts = Vec::new();
        for normals in [false, true] {
            for &sliding in sliding {
                for &rotate_ends in turns {
                    layouts.push(Self {
                        normals,
                        sliding,
                        rotate_ends,
                        regroup,
                    });
                }
            }
        }
        layouts
    }
}

/// Gives each body its frame. The graph is the chain's own, or a copy of it.
#[must_use]
pub fn arrange<'g>(graph: &'g Graph, chain: &Chain, layout: Layout) -> Bodies<'g> {
    let mut bodies = bodies::aligned(graph, chain);
    let all = bodies.bodies.ids();
    if layout.normals {
        for k in all.clone() {
            let child = bodies
                .first_child(k)
                .filter(|_| bodies.bodies[k].has_own_axis());
            if let Some(child) = child.filter(|&child| bodies.bodies[child].has_own_axis()) {
                let to = frames::common_normal(&bodies.bodies[child].placement);
                bodies.move_frame(k, to);
            }
        }
    }
    for k in all.clone() {
        if bodies.bodies[k].translates_alone() {
            let offset = match layout.sliding {
                Sliding::AtParent => {
                    let placement = bodies.bodies[k].placement;
                    Some(-(placement.rotation.transposed() * placement.translation))
                }
                Sliding::AtChild => bodies
                    .first_child(k)
                    .map(|child| bodies.bodies[child].placement.translation),
                Sliding::AsDescribed | Sliding::AtMassCenter => None,
            };
            if let Some(offset) = offset {
                bodies.move_frame(k, Pose::translation(offset));
            }
        }
    }
    for k in all.clone().rev() {
        let body = bodies.bodies[k];
        if layout.sliding == Sliding::AtMassCenter
            && body.translates_alone()
            && body.inertia.mass.value().is_some_and(Double::is_sharp)
        {
            let center = body.inertia.q.map(|entry| entry / body.inertia.mass);
            bodies.move_frame(k, Pose::translation(center));
        }
        if layout.regroup && body.has_own_axis() {
            regroup::pass_inboard(&mut bodies, k);
        }
    }
    if layout.rotate_ends {
        for k in all.clone() {
            let body = bodies.bodies[k];
            let end = bodies.first_child(k).is_none();
            if end
                && body.rotates_alone()
                && let Some(turn) = frames::towards_mass_center(&body.inertia)
            {
                bodies.move_frame(k, turn);
            }
        }
    }
    for body in &mut bodies.bodies {
        if body.rotates_alone() {
            let rotation = body.placement.rotation;
            if let Some((offset, rest)) = frames::split_offset(rotation) {
                body.offset = Some(offset);
                body.placement.rotation = rest;
            }
        }
    }
    bodies
}

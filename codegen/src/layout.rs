//! Which frame each body gets: anywhere along its joint's axis and at any angle about it (structure
//! rule 6); and which body counts mass that no joint can feel (structure rule 4).
//!
//! In: a [`Chain`] and a [`Layout`]. Out: [`Bodies`] whose joints of one coordinate move about or along z,
//! placed so that as many entries of the placements as possible are 0 or 1. It never decides which layout
//! is best: that is counted, function by function.

mod bodies;
mod frames;
mod regroup;
#[cfg(test)]
mod tests;

pub use bodies::{Bodies, Body, Closed};

use crate::chain::{Chain, Position};
use crate::expression::{Double, Graph};
use crate::matrix::Pose;

/// A way to choose the frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Put x along the common normal of a joint's axis and the next one's, and the origin at its
    /// foot (modified Denavit–Hartenberg), instead of where the description has them.
    pub normals: bool,
    /// Where the origin of a sliding body goes.
    pub sliding: Sliding,
    /// Turn the frame of a last body so that its centre of mass lies in the xz plane.
    pub turn_ends: bool,
    /// Regroup the inertial parameters.
    pub regroup: bool,
}

/// Where the origin of a sliding body goes, which may be anywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sliding {
    /// Where the description has it.
    AsDescribed,
    /// At the origin of the body it hangs on.
    AtParent,
    /// At the origin of the first body that hangs on it.
    AtChild,
    /// At its centre of mass, after regrouping.
    AtMassCenter,
}

impl Layout {
    /// Frames and parameters as the description has them.
    pub const DESCRIBED: Self = Self {
        normals: false,
        sliding: Sliding::AsDescribed,
        turn_ends: false,
        regroup: false,
    };

    /// Layouts worth counting for functions that need no inertia.
    #[must_use]
    pub fn for_kinematics(chain: &Chain) -> Vec<Self> {
        let seats = Self::seats(
            chain,
            &[Sliding::AsDescribed, Sliding::AtParent, Sliding::AtChild],
        );
        Self::all(&seats, &[false], false)
    }

    /// Layouts worth counting for dynamics that base parameters suffice for.
    #[must_use]
    pub fn for_dynamics(chain: &Chain) -> Vec<Self> {
        let seats = Self::seats(
            chain,
            &[
                Sliding::AsDescribed,
                Sliding::AtParent,
                Sliding::AtChild,
                Sliding::AtMassCenter,
            ],
        );
        Self::all(&seats, &[false, true], true)
    }

    fn seats(chain: &Chain, all: &[Sliding]) -> Vec<Sliding> {
        let slides = chain
            .joints
            .iter()
            .any(|joint| joint.motion.slides() && matches!(joint.position, Position::Along { .. }));
        if slides {
            all.to_vec()
        } else {
            vec![Sliding::AsDescribed]
        }
    }

    fn all(seats: &[Sliding], turns: &[bool], regroup: bool) -> Vec<Self> {
        let mut layouts = Vec::new();
        for normals in [false, true] {
            for &sliding in seats {
                for &turn_ends in turns {
                    layouts.push(Self {
                        normals,
                        sliding,
                        turn_ends,
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
        if bodies.bodies[k].slides_alone() {
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
            && body.slides_alone()
            && body.inertia.mass.value().is_some_and(Double::is_sharp)
        {
            let center = body.inertia.q.map(|entry| entry / body.inertia.mass);
            bodies.move_frame(k, Pose::translation(center));
        }
        if layout.regroup && body.has_own_axis() {
            regroup::pass_inboard(&mut bodies, k);
        }
    }
    if layout.turn_ends {
        for k in all.clone() {
            let body = bodies.bodies[k];
            let end = bodies.first_child(k).is_none();
            if end
                && body.turns_alone()
                && let Some(turn) = frames::towards_mass_center(&body.inertia)
            {
                bodies.move_frame(k, turn);
            }
        }
    }
    for body in &mut bodies.bodies {
        if body.turns_alone() {
            let rotation = body.placement.rotation;
            if let Some((offset, rest)) = frames::split_offset(rotation) {
                body.offset = Some(offset);
                body.placement.rotation = rest;
            }
        }
    }
    bodies
}

//! Where links end up: those that are fixed to each other in one body.
//!
//! In: the description and its tree, from the base to the ends. Out: every link's seat, and the bodies that
//! joints move, with the inertia of all that sits in them.

use super::displacement::{direction, held_at};
use super::{Body, Moved, Reader, Seat};
use crate::chain::BodyId;
use crate::chain::tree::{Branch, Tree};
use crate::description::{Description, LinkId};
use crate::expression::Term;
use crate::joint::Posture;
use crate::list::List;
use crate::matrix::{Inertia, Pose, Rotation, Vector};

/// Gives every link its seat, and every joint that moves its bodies.
pub(super) fn seat<'g>(
    description: &Description,
    tree: &Tree,
    reader: &mut Reader<'g, '_>,
) -> (List<LinkId, Option<Seat<'g>>>, List<BodyId, Body<'g>>) {
    let graph = reader.graph;
    let mut bodies = List::new();
    let mut seats = List::filled(None, description.links.len());
    seats[tree.base] = Some(Seat {
        body: None,
        pose: reader.base(),
    });
    for branch in &tree.branches {
        let joint = &description[branch.joint];
        let parent = seats[branch.parent].expect("parents come before children");
        let pose = parent.pose * reader.origin(description, branch);
        let axes = reader.axes(joint);
        let seat = if let Some(held) = branch.held {
            Seat {
                body: parent.body,
                pose: pose * held_at(graph, joint.kind, axes, reader.number(&held)),
            }
        } else {
            let (last, link) = moved(
                description,
                branch,
                (parent.body, pose),
                axes,
                &mut bodies,
                reader,
            );
            bodies[last].link = Some((branch.child, link));
            Seat {
                body: Some(last),
                pose: link,
            }
        };
        reader.note(description, branch);
        if let Some(body) = seat.body
            && let Some(inertia) = reader.inertia(&description[branch.child])
        {
            bodies[body].inertia = bodies[body].inertia + inertia.change_frame(seat.pose);
        }
        seats[branch.child] = Some(seat);
    }
    (seats, bodies)
}

/// Adds the bodies that a joint moves; the last of them, and where the link that it carries is in that.
fn moved<'g>(
    description: &Description,
    branch: &Branch,
    (mut parent, mut placement): (Option<BodyId>, Pose<Term<'g>>),
    axes: [Vector<Term<'g>>; 2],
    bodies: &mut List<BodyId, Body<'g>>,
    reader: &mut Reader<'g, '_>,
) -> (BodyId, Pose<Term<'g>>) {
    let (graph, joint) = (reader.graph, &description[branch.joint]);
    let (kind, name) = (joint.kind, &joint.name.text);
    let mut link = Pose::identity(graph);
    let mut moved = Moved::Own;
    if let Some(follow) = branch.follows {
        reader.note_follower(description, branch.joint, follow);
        let offset = graph.number(follow.offset);
        placement = placement * held_at(graph, kind, axes, offset);
        moved = Moved::Follows {
            leader: follow.leader,
            factor: graph.number(follow.multiplier),
        };
    } else {
        reader.report.joints.push(name.clone());
    }
    if let Some(posture) = kind.posture() {
        moved = Moved::Posture(posture);
        if posture == Posture::Planar {
            let rotation = Rotation::across(axes[0]);
            reader.note_plane(name, &rotation);
            let turn = Pose::rotation(rotation);
            placement = placement * turn;
            link = turn.inverse();
        }
    }
    for (place, (velocity, freedom)) in kind.velocities(name).enumerate() {
        let axis = direction(graph, freedom, axes);
        let body = bodies.push(Body {
            joint: branch.joint,
            velocity,
            parent,
            motion: reader.motion(kind, freedom),
            placement,
            axis,
            link: None,
            inertia: Inertia::zero(graph),
            moved,
            drive: reader.drive(joint, place),
        });
        (parent, placement) = (Some(body), Pose::identity(graph));
        if kind.posture().is_some() {
            moved = Moved::Taken;
        }
    }
    (parent.expect("joints that move have velocities"), link)
}

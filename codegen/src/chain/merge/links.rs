//! The body of each link, and its pose there.
//!
//! In: the description and its tree, from the base to the ends. Out: the place of every link, and the bodies that
//! joints move, with the inertia of all links merged into them.

use super::displacement::{direction, held_at};
use super::{Attachment, MergedBody, Moved, TermReader};
use crate::chain::BodyId;
use crate::chain::tree::{Branch, Tree};
use crate::description::{Description, LinkId};
use crate::expression::Term;
use crate::joint::Manifold;
use crate::list::List;
use crate::matrix::{Inertia, Pose, Rotation, Vector};

/// The place of every link, and the bodies of every moving joint.
pub(super) fn attach<'g>(
    description: &Description,
    tree: &Tree,
    reader: &mut TermReader<'g, '_>,
) -> (
    List<LinkId, Option<Attachment<'g>>>,
    List<BodyId, MergedBody<'g>>,
) {
    let graph = reader.graph;
    let mut bodies = List::new();
    let mut attachments = List::filled(None, description.links.len());
    attachments[tree.base] = Some(Attachment {
        body: None,
        pose: reader.base(),
    });
    for branch in &tree.branches {
        let joint = &description[branch.joint];
        let parent = attachments[branch.parent].expect("parents come before children");
        let pose = parent.pose * reader.origin(description, branch);
        let axes = reader.axes(joint);
        let attachment = if let Some(held) = branch.held {
            Attachment {
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
            Attachment {
                body: Some(last),
                pose: link,
            }
        };
        reader.note(description, branch);
        if let Some(body) = attachment.body
            && let Some(inertia) = reader.inertia(&description[branch.child])
        {
            bodies[body].inertia = bodies[body].inertia + inertia.change_frame(attachment.pose);
        }
        attachments[branch.child] = Some(attachment);
    }
    (attachments, bodies)
}

/// Adds the bodies that a joint moves. Returns the last of them, and the pose of the child link in it.
fn moved<'g>(
    description: &Description,
    branch: &Branch,
    (mut parent, mut placement): (Option<BodyId>, Pose<Term<'g>>),
    axes: [Vector<Term<'g>>; 2],
    bodies: &mut List<BodyId, MergedBody<'g>>,
    reader: &mut TermReader<'g, '_>,
) -> (BodyId, Pose<Term<'g>>) {
    let (graph, joint) = (reader.graph, &description[branch.joint]);
    let (kind, name) = (joint.kind, &joint.name.text);
    let mut link = Pose::identity(graph);
    let mut moved = Moved::Own;
    if let Some(law) = branch.mimics {
        reader.note_mimic(description, branch.joint, law);
        let offset = graph.number(law.offset);
        placement = placement * held_at(graph, kind, axes, offset);
        moved = Moved::Mimic {
            mimicked: law.mimicked,
            factor: graph.number(law.multiplier),
        };
    } else {
        reader.report.joints.push(name.clone());
    }
    if let Some(manifold) = kind.manifold() {
        moved = Moved::Manifold(manifold);
        if manifold == Manifold::Planar {
            let rotation = Rotation::across(axes[0]);
            reader.note_plane(name, &rotation);
            let frame = Pose::rotation(rotation);
            placement = placement * frame;
            link = frame.inverse();
        }
    }
    for (place, (velocity, degree_of_freedom)) in kind.velocities(name).enumerate() {
        let axis = direction(graph, degree_of_freedom, axes);
        let body = bodies.push(MergedBody {
            joint: branch.joint,
            velocity,
            parent,
            motion: reader.motion(kind, degree_of_freedom),
            placement,
            axis,
            link: None,
            inertia: Inertia::zero(graph),
            moved,
            actuator: reader.actuator(joint, place),
        });
        (parent, placement) = (Some(body), Pose::identity(graph));
        if kind.manifold().is_some() {
            moved = Moved::Taken;
        }
    }
    (parent.expect("joints that move have velocities"), link)
}

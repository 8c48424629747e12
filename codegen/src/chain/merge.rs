//! Merging of links on fixed and locked joints with their parents into one body.
//!
//! In: the description and its tree. Out: a [`Chain`] whose bodies move relative to each other, with the inertia of all
//! links merged into them. Struct fields become inputs here, and are scalars like all others from here on.

mod actuator;
mod closure;
mod collision;
mod displacement;
mod inertia;
mod links;
mod listed;
mod reader;

use std::rc::Rc;

use super::tree::Tree;
use super::{BodyId, Chain, Frame, Report, limbs};
use crate::description::{Description, JointId, LinkId};
use crate::expression::{Graph, Term};
use crate::joint::{ActuatorTerms, Manifold, Motion, entry};
use crate::list::List;
use crate::matrix::{Inertia, Pose, Vector};
use crate::request::Request;
use crate::space::{ACTION, Entry, FieldId, FrameId, Kind};

/// The place of a link: its body, and its pose there.
#[derive(Clone, Copy)]
struct Attachment<'g> {
    body: Option<BodyId>,
    pose: Pose<Term<'g>>,
}

/// A body moved by one degree of freedom of a joint; only that of the last is a link.
struct MergedBody<'g> {
    joint: JointId,
    velocity: String,
    parent: Option<BodyId>,
    motion: Motion,
    placement: Pose<Term<'g>>,
    axis: Vector<Term<'g>>,
    /// The link that it is, and M of the link's frame in the body's.
    link: Option<(LinkId, Pose<Term<'g>>)>,
    inertia: Inertia<Term<'g>>,
    moved: Moved<'g>,
    actuator: ActuatorTerms<Term<'g>>,
}

/// The coordinate that moves a body.
#[derive(Clone, Copy)]
enum Moved<'g> {
    /// A coordinate of its own.
    Own,
    /// The coordinate of a mimicked joint, times a factor.
    Mimic { mimicked: JointId, factor: Term<'g> },
    /// Coordinates that move it together with all later bodies of its joint.
    Manifold(Manifold),
    /// None: the first body of its joint has the displacement.
    Taken,
}

/// Merges links that do not move relative to each other.
pub fn merge(description: &Rc<Description>, request: &Rc<Request>, tree: &Tree) -> Chain {
    let graph = Graph::new();
    let mut reader = TermReader {
        graph: &graph,
        request,
        nominal: List::filled(Vec::new(), request.parameters.len()),
        report: Report::default(),
    };
    let name = |link: LinkId| description[link].name.text.clone();
    let (attachments, bodies) = links::attach(description, tree, &mut reader);
    let frame = |link: LinkId| {
        let attachment = attachments[link]?;
        Some(Frame {
            name: name(link),
            body: attachment.body,
            placement: attachment.pose.map(Term::expr),
        })
    };
    let frames = tree.tip.iter().chain(&tree.frames);
    let frames: List<FrameId, Frame> = frames.filter_map(|&link| frame(link)).collect();
    let external = tree.external.iter().filter_map(|&link| frame(link));
    let external: Vec<Frame> = external.collect();
    let loops = closure::closed(description, &attachments, &mut reader);
    let (spheres, links_of_spheres) =
        collision::spheres(description, request, &attachments, &mut reader);
    let gravity = reader.gravity().map(Term::expr);
    reader.report.base = name(tree.base);
    let modelled = attachments
        .ids()
        .filter(|&link| attachments[link].is_some());
    reader.report.links = modelled.map(name).collect();
    reader.report.dropped = tree.dropped.iter().map(|&link| name(link)).collect();
    let (joints, mut spaces) = listed::listed(description, bodies, &graph);
    spaces.wrench = wrench(str::to_owned).into();
    spaces.actions = actions(&external);
    spaces.frames = frames.map(|frame| Entry {
        name: frame.name.clone(),
        kind: Kind::Frame,
        range: None,
    });
    let pairs = collision::pairs(&spheres, &links_of_spheres, &joints, &tree.collision_pairs);
    spaces.spheres = collision::entries(&spheres);
    spaces.pairs = collision::pair_entries(&pairs, &spaces.spheres);
    spaces.limbs = limbs::limbs(&joints, external.iter().map(|frame| frame.body));
    let TermReader {
        nominal, report, ..
    } = reader;
    Chain {
        description: Rc::clone(description),
        request: Rc::clone(request),
        nominal,
        joints,
        spaces,
        loops,
        elimination: Vec::new(),
        actuated: List::new(),
        frames,
        external,
        spheres,
        pairs,
        has_tip: tree.tip.is_some(),
        gravity,
        report,
        identifies_actuators: false,
        base_parameters: None,
        graph,
    }
}

/// The entries of the external wrenches on some links.
fn actions(external: &[Frame]) -> Vec<Entry> {
    let entries = external.iter();
    entries
        .flat_map(|link| wrench(|name| entry(&link.name, name)))
        .collect()
}

/// The entries of a wrench.
fn wrench(name: impl Fn(&str) -> String) -> [Entry; ACTION.len()] {
    ACTION.map(|(entry, kind)| Entry {
        name: name(entry),
        kind,
        range: None,
    })
}

/// Converts numbers to scalars, and records corrections in a report.
struct TermReader<'g, 'r> {
    graph: &'g Graph,
    request: &'r Request,
    /// Values of the description for the numbers that are struct fields.
    nominal: List<FieldId, Vec<f64>>,
    report: Report,
}

//! Fixed and locked joints vanish: what they connect becomes one body.
//!
//! In: the description and its tree. Out: a [`Chain`] whose bodies move against each other, with
//! the mass of all that is fixed to them. Struct fields enter here as inputs; from here on they are
//! scalars like all others. It never drops a mass.

mod closure;
mod displacement;
mod drive;
mod inertia;
mod listed;
mod reader;
mod seat;

use std::rc::Rc;

use super::tree::Tree;
use super::{BodyId, Chain, Frame, Report};
use crate::description::{Description, JointId, LinkId};
use crate::expression::{Graph, Term};
use crate::joint::{Drive, Motion, Posture, entry};
use crate::list::List;
use crate::matrix::{Inertia, Pose, Vector};
use crate::request::Request;
use crate::space::{ACTION, Entry, FieldId};

/// Where a link ended up: in which body, and where in it.
#[derive(Clone, Copy)]
struct Seat<'g> {
    body: Option<BodyId>,
    pose: Pose<Term<'g>>,
}

/// A body beyond one freedom of a joint; only that beyond the last is a link.
struct Body<'g> {
    joint: JointId,
    velocity: String,
    parent: Option<BodyId>,
    motion: Motion,
    placement: Pose<Term<'g>>,
    axis: Vector<Term<'g>>,
    /// The link that it is, and M from its frame to the link's.
    link: Option<(LinkId, Pose<Term<'g>>)>,
    inertia: Inertia<Term<'g>>,
    moved: Moved<'g>,
    drive: Drive<Term<'g>>,
}

/// What moves a body.
#[derive(Clone, Copy)]
enum Moved<'g> {
    /// A coordinate of its own.
    Own,
    /// That of another joint, times a factor.
    Follows { leader: JointId, factor: Term<'g> },
    /// Coordinates that move it with all that come after it of its joint.
    Posture(Posture),
    /// The body before it.
    Taken,
}

/// Merges what does not move.
pub fn merge(description: &Rc<Description>, request: &Rc<Request>, tree: &Tree) -> Chain {
    let graph = Graph::new();
    let mut reader = Reader {
        graph: &graph,
        request,
        nominal: List::filled(Vec::new(), request.parameters.len()),
        report: Report::default(),
    };
    let name = |link: LinkId| description[link].name.text.clone();
    let (seats, bodies) = seat::seat(description, tree, &mut reader);
    let frame = |link: LinkId| {
        let seat = seats[link]?;
        Some(Frame {
            name: name(link),
            body: seat.body,
            placement: seat.pose.map(Term::expr),
        })
    };
    let frames = tree.tip.iter().chain(&tree.frames);
    let frames = frames.filter_map(|&link| frame(link)).collect();
    let external = tree.external.iter().filter_map(|&link| frame(link));
    let external: Vec<Frame> = external.collect();
    let loops = closure::closed(description, &seats, &mut reader);
    let gravity = reader.gravity().map(Term::expr);
    reader.report.base = name(tree.base);
    let modelled = seats.ids().filter(|&link| seats[link].is_some());
    reader.report.links = modelled.map(name).collect();
    reader.report.dropped = tree.dropped.iter().map(|&link| name(link)).collect();
    let (joints, mut spaces) = listed::listed(description, bodies, &graph);
    spaces.actions = actions(&external);
    let Reader {
        nominal, report, ..
    } = reader;
    Chain {
        description: Rc::clone(description),
        request: Rc::clone(request),
        nominal,
        joints,
        spaces,
        loops,
        actuated: List::new(),
        frames,
        external,
        has_tip: tree.tip.is_some(),
        gravity,
        report,
        identifies_drives: false,
        base_parameters: None,
        graph,
    }
}

/// The entries of the actions on some links.
fn actions(external: &[Frame]) -> Vec<Entry> {
    let entries = external.iter().flat_map(|link| {
        ACTION.map(|(name, kind)| Entry {
            name: entry(&link.name, name),
            kind,
            range: None,
        })
    });
    entries.collect()
}

/// Turns what was written into scalars, and keeps account of it.
struct Reader<'g, 'r> {
    graph: &'g Graph,
    request: &'r Request,
    /// What is described where struct fields stand.
    nominal: List<FieldId, Vec<f64>>,
    report: Report,
}

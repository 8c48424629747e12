//! What a description means: bodies that move against each other, by one velocity each.
//!
//! In: a [`Description`] and a [`Request`]. Out: a [`Chain`] of the moving joints, parents before
//! children, in which everything that is held still is part of the body that carries it; every
//! mistake that takes two items to see is found here. It never chooses what is cheap: where frames go
//! and mass sits is for [`layout`](crate::layout).

mod angle;
pub mod base_parameters;
mod check;
mod closure;
mod drive;
mod external;
mod limits;
mod merge;
mod mimic;
mod names;
mod numbers;
pub mod physical;
mod root;
mod shape;
#[cfg(test)]
pub(crate) mod tests;
mod tree;
mod turn;

use std::rc::Rc;

use crate::closure::Row;
use crate::description::Description;
use crate::error::{Complaint, Errors, Place};
use crate::expression::{Expr, Graph, Term};
use crate::joint::drive::Part;
use crate::joint::{Drive, Motion, Posture};
use crate::list::{Id, List, id};
use crate::matrix::{Inertia, Pose, Vector};
use crate::request::{Parameter, Request};
use crate::space::{CoordinateId, Entry, FieldId, FrameId, Kind, Spaces, VelocityId};

id! {
    /// The number of a body among those of a [`Chain`], and of what moves it: in every list that has an entry for
    /// each of [`Chain::joints`].
    BodyId
}

/// The moving joints of a robot and the bodies they carry.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The description that it is of, with a free root where one was asked for.
    pub description: Rc<Description>,
    /// What was asked for of that.
    pub request: Rc<Request>,
    /// The scalars of all that follows: numbers, and the run-time parameters.
    pub graph: Graph,
    /// The freedoms of the joints, parents before children.
    pub joints: List<BodyId, Joint>,
    /// The lists that arguments and results are over.
    spaces: Spaces,
    /// The joints that close loops, in the order of the description.
    pub loops: Vec<Loop>,
    /// Which velocities are driven, where loops move the others.
    pub actuated: List<VelocityId, bool>,
    /// The frames asked for: the tip first, where there is one.
    pub frames: List<FrameId, Frame>,
    /// The links on which something acts from outside.
    pub external: Vec<Frame>,
    /// Whether the first of `frames` is the tip.
    pub has_tip: bool,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Expr>,
    /// What the description says of the numbers that struct fields stand for, in the order of the
    /// request's parameters.
    pub nominal: List<FieldId, Vec<f64>>,
    /// What became of the description on the way.
    pub report: Report,
    /// Whether behind the inertial parameters of links there are those of drives: where any is modelled.
    pub identifies_drives: bool,
    /// The combinations of inertial parameters that torques determine; `None` where nobody has asked for them
    /// ([`Chain::identified`]).
    pub base_parameters: Option<base_parameters::BaseParameters>,
}

/// A freedom of a joint and the body it moves: of a joint with several, all but the last body carry
/// nothing but the next.
#[derive(Clone, Debug)]
pub struct Joint {
    /// What its velocity is called: as the joint, where that has no other.
    pub name: String,
    /// The name of the joint it is of.
    pub of: String,
    /// Where that stands.
    pub place: Place,
    /// The joint that carries the body it hangs on; none for the fixed base.
    pub parent: Option<BodyId>,
    /// The motion it allows.
    pub motion: Motion,
    /// M from the parent body's frame to this body's at q = 0.
    pub placement: Pose<Expr>,
    /// Direction of the axis in this body's frame, through its origin; of length 1.
    pub axis: Vector<Expr>,
    /// The link that the body is, and M from the body's frame to the link's; none for one between two velocities
    /// of a joint.
    pub link: Option<(String, Pose<Expr>)>,
    /// J of the body in its frame, with all that is fixed to it.
    pub inertia: Inertia<Expr>,
    /// What its displacement is a function of.
    pub position: Position,
    /// Its place among the velocities.
    pub velocity: VelocityId,
    /// What is modelled of its drive.
    pub drive: Drive<Expr>,
}

/// What the displacement of a body against the one it hangs on is a function of.
#[derive(Clone, Copy, Debug)]
pub enum Position {
    /// An entry of q, times a factor: along the axis. The factor is not 1 of a joint that follows another
    /// in another measure, and is that of its rates as well.
    Along {
        /// The entry.
        coordinate: CoordinateId,
        /// The factor, a number.
        factor: Expr,
    },
    /// The entries of q from here on, with all that come after it of its joint.
    Posture(Posture, CoordinateId),
    /// Nothing: the first of its joint has taken it along. All of them have the same frame, and their
    /// velocities are seen in it.
    Taken,
}

/// A frame fixed to a body.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The link whose frame it is.
    pub name: String,
    /// The joint that carries the body; none for the fixed base.
    pub body: Option<BodyId>,
    /// M from the body's frame to this one.
    pub placement: Pose<Expr>,
}

/// A joint that closes a loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its name.
    pub name: String,
    /// Where that stands.
    pub place: Place,
    /// What its kind is called.
    pub word: &'static str,
    /// The frames that it holds together, A and B, each called as the link is that it is fixed to.
    pub frames: [Frame; 2],
    /// What it closes.
    pub rows: Vec<Row>,
    /// The length of a rod \[m\]; of a joint with two axes, the cosine of their angle.
    pub size: Expr,
}

/// What was merged, held, left out or repaired.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// The link taken as fixed.
    pub base: String,
    /// The links that are modelled, in the order of the description.
    pub links: Vec<String>,
    /// The joints that move, in the order of their coordinates.
    pub joints: Vec<String>,
    /// Links that became part of the body of another: (link, link that carries it).
    pub merged: Vec<(String, String)>,
    /// Joints that follow others, in the order of the description.
    pub mimicked: Vec<Mimicked>,
    /// Joints held still, with their coordinate.
    pub locked: Vec<(String, f64)>,
    /// Links that were taken off, or that the base leaves behind.
    pub dropped: Vec<String>,
    /// Angles taken for right angles, and residues taken for zero.
    pub snapped: Vec<Snapped>,
    /// Quaternions taken for rotations by right angles.
    pub turned: Vec<Turned>,
    /// What loops would close, and is closed whatever the robot does, by name.
    pub closed: Vec<String>,
    /// Residuals that depend on others where the loops are closed, by name.
    pub dependent: Vec<String>,
    /// The planes of planar joints whose axis is not z.
    pub planes: Vec<Plane>,
    /// Doubts, each with its place.
    pub warnings: Vec<Complaint>,
}

/// The plane in which a planar joint moves, in the frame that the joint's is at q = 0.
#[derive(Clone, Debug)]
pub struct Plane {
    /// The joint.
    pub joint: String,
    /// The direction of its coordinate `x`, of length 1.
    pub x: [f64; 3],
    /// The direction of its coordinate `y`, of length 1.
    pub y: [f64; 3],
}

impl Plane {
    /// `x along z, y along x`.
    #[must_use]
    pub fn text(&self) -> String {
        let [x, y] = [self.x, self.y].map(direction);
        format!("x along {x}, y along {y}")
    }
}

/// A direction by the name of the axis that it is, or by its entries.
fn direction(entries: [f64; 3]) -> String {
    for (k, name) in ["x", "y", "z"].into_iter().enumerate() {
        let others = entries[(k + 1) % 3].abs() + entries[(k + 2) % 3].abs();
        if others < f64::EPSILON {
            let sign = if entries[k] < 0.0 { "−" } else { "" };
            return format!("{sign}{name}");
        }
    }
    let entries = entries.map(|entry| format!("{entry:.4}"));
    format!("[{}]", entries.join(", "))
}

/// A joint that follows another: multiplier · q + offset.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimicked {
    /// The joint.
    pub joint: String,
    /// The joint whose coordinate q is.
    pub leader: String,
    /// What q is multiplied by.
    pub multiplier: f64,
    /// What is added [rad or m].
    pub offset: f64,
}

/// A number that was taken for a multiple of a right angle, or a residue that was taken for zero.
#[derive(Clone, Debug)]
pub struct Snapped {
    /// The joint or link it belongs to.
    pub item: String,
    /// As written: an angle \[rad\], or an entry of an offset \[m\] or of an axis, times a power of two where that is
    /// of quite another length than 1.
    pub written: f64,
    /// Quarter turns; 0 of a residue, whatever it is an entry of.
    pub quarters: i64,
    /// Where it stands.
    pub place: Place,
}

/// A quaternion x, y, z, w that was taken for a rotation by right angles.
#[derive(Clone, Debug)]
pub struct Turned {
    /// The joint or link it belongs to.
    pub item: String,
    /// As written.
    pub written: [f64; 4],
    /// What the entries mean: of each four times the square, with the sign of the entry; 1 of ½, 2 of √½, 4 of 1.
    pub squares: [i64; 4],
    /// Where it stands.
    pub place: Place,
}

impl Report {
    /// How many angles and quaternions were taken for right angles, and how many residues for zero.
    #[must_use]
    pub fn right_angles_and_residues(&self) -> (usize, usize) {
        let residues = self.snapped.iter().filter(|number| number.quarters == 0);
        let residues = residues.count();
        let angles = self.snapped.len() - residues;
        (angles + self.turned.len(), residues)
    }
}

impl Chain {
    /// The lists that arguments and results are over.
    #[must_use]
    pub const fn spaces(&self) -> &Spaces {
        &self.spaces
    }

    /// The struct field of that number.
    #[must_use]
    pub fn field(&self, field: FieldId) -> &Parameter {
        &self.request.parameters[field.index()]
    }

    /// The same chain with its base parameters, which the base regressor is over.
    #[must_use]
    pub fn identified(mut self) -> Self {
        let found = base_parameters::base_parameters(&self);
        let leaders = found
            .columns()
            .map(|leader| self.spaces.parameters[leader].clone());
        self.spaces.base_parameters = leaders.collect();
        self.base_parameters = Some(found);
        self
    }

    /// Changes what its loops close, and the list of it.
    pub fn close(&mut self, change: impl FnOnce(&mut [Loop])) {
        change(&mut self.loops);
        self.spaces.constraints = closure::entries(&self.loops);
    }

    /// The first of `joints` that a velocity moves by itself: not one that follows it.
    #[must_use]
    pub fn mover(&self, velocity: VelocityId) -> BodyId {
        let of = &self.spaces.velocities[velocity].name;
        let mover = self.joints.find(|joint| joint.name == *of);
        mover.expect("each velocity has a joint that is called as it is")
    }

    /// Whether every body has a velocity of its own, and none follows another.
    #[must_use]
    pub fn all_lead(&self) -> bool {
        self.joints.len() == self.spaces.velocities.len()
    }

    /// The most joints that stand in a row.
    #[must_use]
    pub fn longest(&self) -> usize {
        let mut before: List<BodyId, usize> = List::new();
        for joint in &self.joints {
            before.push(1 + joint.parent.map_or(0, |parent| before[parent]));
        }
        before.into_iter().max().unwrap_or(0)
    }

    /// Whether so many joints stand in a row that accelerations are left to articulated bodies: from here on a
    /// mass matrix takes ten times as many operations with its factors, and each further joint as many again as
    /// there are joints.
    #[must_use]
    pub fn is_long(&self) -> bool {
        const LONG: usize = 48;
        self.all_lead() && self.longest() >= LONG
    }

    /// Whether joints feel more than their bodies: an armature or friction, or a field that may be one.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        let is_there = |entry: Expr| !self.graph.term(entry).is_zero();
        let mut drives = self.joints.iter().flat_map(|joint| joint.drive.entries());
        drives.any(is_there)
    }

    /// L of a joint in its body's frame: u, b.
    #[must_use]
    pub fn screw(&self, joint: &Joint) -> [Term<'_>; 6] {
        let axis = joint.axis.map(|entry| self.graph.term(entry));
        joint.motion.screw(axis).entries()
    }

    /// How many joints move a frame.
    #[must_use]
    pub fn joints_to(&self, frame: FrameId) -> usize {
        let mut at = self.frames.get(frame).and_then(|frame| frame.body);
        let mut count = 0;
        while let Some(joint) = at {
            count += 1;
            at = self.joints[joint].parent;
        }
        count
    }
}

/// The inertial parameters of a link, in the order of [`Space::Parameters`](crate::space::Space).
fn parameters(link: &str) -> impl Iterator<Item = Entry> {
    let names = [
        ["m"].as_slice(),
        &["q_x", "q_y", "q_z"],
        &["J_xx", "J_xy", "J_xz", "J_yy", "J_yz", "J_zz"],
    ];
    let orders = (0..).zip(names);
    orders.flat_map(move |(order, names)| {
        names.iter().map(move |name| Entry {
            name: format!("{link}.{name}"),
            kind: Kind::Moment(order),
            range: None,
        })
    })
}

/// What is identified of a joint's drive, in the order of [`Drive::entries`].
fn of_drive(joint: &Joint) -> impl Iterator<Item = Entry> {
    let slides = matches!(joint.motion, Motion::Prismatic);
    let parts = [Part::Armature, Part::Damping, Part::Friction];
    parts
        .into_iter()
        .zip([2, 1, 0])
        .map(move |(part, order)| Entry {
            name: format!("{}.{}", joint.name, part.word()),
            kind: Kind::Drive { order, slides },
            range: None,
        })
}

/// Understands a description as the request wants it.
///
/// # Errors
/// All the mistakes that are found.
pub fn build(description: &Description, request: &Request) -> Result<Chain, Errors> {
    let described = Request {
        gravity: request.gravity.or(description.gravity),
        ..request.clone()
    };
    let (description, request) = root::freed(description, &described);
    let (description, request) = (&description, &request);
    let beside = |errors: Errors| errors.beside(description.warnings.iter().cloned());
    let tree = check::check(description, request).map_err(beside)?;
    let merged = merge::merge(description, request, &tree);
    let chain = numbers::check_merged(merged).map_err(beside)?;
    let chain = closure::check_merged(chain, request).map_err(beside)?;
    let mut chain = physical::check(description, request, &tree, chain)?;
    let links = chain.joints.iter().filter_map(|joint| joint.link.as_ref());
    let mut parameters: List<_, Entry> = links.flat_map(|(link, _)| parameters(link)).collect();
    chain.identifies_drives =
        request.models_friction() || request.models_armature() || chain.is_driven();
    if chain.identifies_drives {
        parameters.extend(chain.joints.iter().flat_map(of_drive));
    }
    chain.spaces.parameters = parameters;
    Ok(chain)
}

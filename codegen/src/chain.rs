//! Interpretation of a description: a tree of bodies with one velocity each.
//!
//! In: a [`Description`] and a [`Request`]. Out: a [`Chain`] of the moving joints, parents before children. Links on
//! fixed or locked joints are merged with the body that carries them. Every error that takes two items to see is found
//! here. Frames and inertial parameters are chosen later, by [`layout`](crate::layout).

mod actuator;
pub(crate) mod angle;
pub(crate) mod axis_rotation;
pub mod base_parameters;
mod check;
mod closure;
mod collision;
mod external;
mod limbs;
mod limits;
mod merge;
mod mimic;
mod names;
mod numbers;
pub mod physical;
mod root;
pub(crate) mod shape;
#[cfg(test)]
pub(crate) mod tests;
pub(crate) mod tree;

use std::rc::Rc;

use crate::closure::ResidualKind;
use crate::description::Description;
use crate::error::{Diagnostic, Errors, Place};
use crate::expression::{Expr, Graph, Term};
use crate::joint::actuator::ActuatorQuantity;
use crate::joint::{ActuatorTerms, Manifold, Motion};
use crate::list::{Id, List, id};
use crate::matrix::{Inertia, Pose, Vector};
use crate::request::{Parameter, Request};
use crate::space::{CoordinateId, Entry, FieldId, FrameId, Kind, Spaces, SphereId, VelocityId};

id! {
    /// The number of a body of a [`Chain`] and of the joint that moves it: an index of every list with an entry for
    /// each of [`Chain::joints`].
    BodyId
}

/// The moving joints of a robot and the bodies they carry.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The description, with a floating root if one was requested.
    pub description: Rc<Description>,
    /// The request.
    pub request: Rc<Request>,
    /// The graph of all scalars below: numbers and run-time parameters.
    pub graph: Graph,
    /// The degrees of freedom of the joints, parents before children.
    pub joints: List<BodyId, Joint>,
    /// The lists that arguments and results range over.
    spaces: Spaces,
    /// The joints that close loops, in the order of the description.
    pub loops: Vec<Loop>,
    /// The residuals of all loops in the order in which they are eliminated: loop by loop, independent ones first.
    pub elimination: Vec<usize>,
    /// The velocities with an actuator; loops move the others.
    pub actuated: List<VelocityId, bool>,
    /// The requested frames: the tip first, if there is one.
    pub frames: List<FrameId, Frame>,
    /// The links with an external wrench.
    pub external: Vec<Frame>,
    /// The collision spheres, if they are requested.
    pub spheres: List<SphereId, Sphere>,
    /// The pairs of spheres that have distances.
    pub pairs: Vec<[SphereId; 2]>,
    /// True if the first of `frames` is the tip.
    pub has_tip: bool,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Expr>,
    /// The description's values of the numbers that are struct fields, in the order of the request's parameters.
    pub nominal: List<FieldId, Vec<f64>>,
    /// Merged, locked and left out items, and warnings.
    pub report: Report,
    /// True if armature, damping and friction of joints follow the inertial parameters of links: if any is modelled.
    pub identifies_actuators: bool,
    /// The combinations of inertial parameters that torques determine; `None` until requested
    /// ([`Chain::identified`]).
    pub base_parameters: Option<base_parameters::BaseParameters>,
}

/// A degree of freedom of a joint and the body it moves. If a joint has several, all bodies but the last have no
/// inertia and carry the next.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The name of its velocity: that of the joint, if it has only one.
    pub name: String,
    /// The name of its joint in the description.
    pub of: String,
    /// The place of that joint in the description.
    pub place: Place,
    /// The joint that carries the parent body; `None` for the fixed base.
    pub parent: Option<BodyId>,
    /// Its type of motion.
    pub motion: Motion,
    /// M of this body's frame in the parent body's, at q = 0.
    pub placement: Pose<Expr>,
    /// Direction of the axis in this body's frame, through its origin; unit length.
    pub axis: Vector<Expr>,
    /// The link that the body is, and M of the link's frame in the body's; `None` for a body between two velocities
    /// of a joint.
    pub link: Option<(String, Pose<Expr>)>,
    /// J of the body in its frame, with all links merged into it.
    pub inertia: Inertia<Expr>,
    /// The coordinates that determine its displacement.
    pub position: Position,
    /// Its index among the velocities.
    pub velocity: VelocityId,
    /// Its armature, damping and friction.
    pub actuator: ActuatorTerms<Expr>,
}

/// The coordinates that determine the displacement of a body relative to its parent.
#[derive(Clone, Copy, Debug)]
pub enum Position {
    /// An entry of q times a factor, along the axis. The factor also applies to velocities. It differs from 1 for mimic
    /// joints only.
    Along {
        /// The entry.
        coordinate: CoordinateId,
        /// The factor, a constant.
        factor: Expr,
    },
    /// The entries of q from here on, together for all bodies of the joint.
    Manifold(Manifold, CoordinateId),
    /// None: the first body of the joint already has the whole displacement. All bodies of the joint have the same
    /// frame, and their velocities are in its axes.
    Taken,
}

/// A frame fixed to a body.
#[derive(Clone, Debug)]
pub struct Frame {
    /// The link whose frame it is.
    pub name: String,
    /// The joint that carries the body; `None` for the fixed base.
    pub body: Option<BodyId>,
    /// M of this frame in the body's frame.
    pub placement: Pose<Expr>,
}

/// A collision sphere.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// The frame at its centre, with the name of its link.
    pub frame: Frame,
    /// The radius \[m\].
    pub radius: Expr,
}

/// A joint that closes a loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its name.
    pub name: String,
    /// The place in the description.
    pub place: Place,
    /// The name of its type.
    pub word: &'static str,
    /// The frames A and B that it joins, each with the name of its link.
    pub frames: [Frame; 2],
    /// Its residuals.
    pub rows: Vec<ResidualKind>,
    /// The length of a rod \[m\]; for a universal loop, the cosine of the angle between its axes.
    pub size: Expr,
}

/// Links and joints that were merged, locked, left out or corrected.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// The link that is the base.
    pub base: String,
    /// The links that are modelled, in the order of the description.
    pub links: Vec<String>,
    /// The moving joints, in the order of their coordinates.
    pub joints: Vec<String>,
    /// Links merged into another: (link, link that carries it).
    pub merged: Vec<(String, String)>,
    /// Mimic joints, in the order of the description.
    pub mimicked: Vec<MimicJoint>,
    /// Locked joints, with their coordinate.
    pub locked: Vec<(String, f64)>,
    /// Links that were detached, or that are not carried by the chosen base.
    pub dropped: Vec<String>,
    /// Angles taken for right angles, and residues taken for zero.
    pub snapped: Vec<Snapped>,
    /// Quaternions taken for rotations by right angles.
    pub turned: Vec<Turned>,
    /// Residuals of loops that are zero in every configuration, by name.
    pub closed: Vec<String>,
    /// Residuals that depend on others when the loops are closed, by name.
    pub dependent: Vec<String>,
    /// The planes of planar joints whose axis is not z.
    pub planes: Vec<Plane>,
    /// Warnings, each with its place.
    pub warnings: Vec<Diagnostic>,
}

/// The plane in which a planar joint moves, in the joint's frame at q = 0.
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

/// A direction, as the name of its axis or by its entries.
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

/// A mimic joint: its coordinate is multiplier · q + offset.
#[derive(Clone, Debug, PartialEq)]
pub struct MimicJoint {
    /// The joint.
    pub joint: String,
    /// The mimicked joint, whose coordinate is q.
    pub mimicked: String,
    /// The multiplier.
    pub multiplier: f64,
    /// The offset [rad or m].
    pub offset: f64,
}

/// A number that was taken for a multiple of a right angle, or a residue that was taken for zero.
#[derive(Clone, Debug)]
pub struct Snapped {
    /// The joint or link with the number.
    pub item: String,
    /// As written: an angle \[rad\], or an entry of an offset \[m\] or of an axis. An axis whose length is far from 1
    /// is scaled by a power of two.
    pub written: f64,
    /// Quarter turns; 0 for a residue.
    pub quarters: i64,
    /// The place in the description.
    pub place: Place,
}

/// A quaternion x, y, z, w that was taken for a rotation by right angles.
#[derive(Clone, Debug)]
pub struct Turned {
    /// The joint or link with the quaternion.
    pub item: String,
    /// As written.
    pub written: [f64; 4],
    /// Four times the square of each exact entry, with the sign of the entry: 1 for ½, 2 for √½, 4 for 1.
    pub squares: [i64; 4],
    /// The place in the description.
    pub place: Place,
}

impl Report {
    /// The numbers of angles and quaternions taken for right angles, and of residues taken for zero.
    #[must_use]
    pub fn right_angles_and_residues(&self) -> (usize, usize) {
        let residues = self.snapped.iter().filter(|number| number.quarters == 0);
        let residues = residues.count();
        let angles = self.snapped.len() - residues;
        (angles + self.turned.len(), residues)
    }
}

impl Chain {
    /// The lists that arguments and results range over.
    #[must_use]
    pub const fn spaces(&self) -> &Spaces {
        &self.spaces
    }

    /// The struct field with a number.
    #[must_use]
    pub fn field(&self, field: FieldId) -> &Parameter {
        &self.request.parameters[field.index()]
    }

    /// The same chain with its base parameters, which the base regressor ranges over.
    #[must_use]
    pub fn identified(mut self) -> Self {
        let found = base_parameters::base_parameters(&self);
        let leading = found
            .columns()
            .map(|parameter| self.spaces.parameters[parameter].clone());
        self.spaces.base_parameters = leading.collect();
        self.base_parameters = Some(found);
        self
    }

    /// Changes the residuals of its loops, and updates the list of residuals. They are eliminated in that order.
    pub fn close(&mut self, change: impl FnOnce(&mut [Loop])) {
        change(&mut self.loops);
        self.spaces.constraints = closure::entries(&self.loops);
        self.elimination = (0..self.spaces.constraints.len()).collect();
    }

    /// The first of `joints` with a velocity, which is no mimic joint.
    #[must_use]
    pub fn mover(&self, velocity: VelocityId) -> BodyId {
        let of = &self.spaces.velocities[velocity].name;
        let mover = self.joints.find(|joint| joint.name == *of);
        mover.expect("each velocity has a joint that is called as it is")
    }

    /// True if every body has a velocity of its own, so that there is no mimic joint.
    #[must_use]
    pub fn all_lead(&self) -> bool {
        self.joints.len() == self.spaces.velocities.len()
    }

    /// Largest number of joints in a row.
    #[must_use]
    pub fn longest(&self) -> usize {
        let mut before: List<BodyId, usize> = List::new();
        for joint in &self.joints {
            before.push(1 + joint.parent.map_or(0, |parent| before[parent]));
        }
        before.into_iter().max().unwrap_or(0)
    }

    /// True if so many joints are in a row that accelerations are left to articulated bodies. From here on a mass
    /// matrix with its factors takes ten times as many operations, and each further joint adds as many as there are
    /// joints.
    #[must_use]
    pub fn is_long(&self) -> bool {
        const LONG: usize = 48;
        self.all_lead() && self.longest() >= LONG
    }

    /// True if some joint has an armature, damping or friction, or a field that sets one.
    #[must_use]
    pub fn has_actuator_terms(&self) -> bool {
        let is_there = |entry: Expr| !self.graph.term(entry).is_zero();
        let mut actuators = self
            .joints
            .iter()
            .flat_map(|joint| joint.actuator.entries());
        actuators.any(is_there)
    }

    /// L of a joint in its body's frame: u, b.
    #[must_use]
    pub fn screw(&self, joint: &Joint) -> [Term<'_>; 6] {
        let axis = joint.axis.map(|entry| self.graph.term(entry));
        joint.motion.screw(axis).entries()
    }

    /// Number of joints that move a frame.
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

/// The identified parameters of a joint's armature, damping and friction, in the order of [`ActuatorTerms::entries`].
fn of_actuator(joint: &Joint) -> impl Iterator<Item = Entry> {
    let translates = matches!(joint.motion, Motion::Prismatic);
    let quantities = [
        ActuatorQuantity::Armature,
        ActuatorQuantity::Damping,
        ActuatorQuantity::Friction,
    ];
    quantities
        .into_iter()
        .zip([2, 1, 0])
        .map(move |(quantity, order)| Entry {
            name: format!("{}.{}", joint.name, quantity.word()),
            kind: Kind::Actuator { order, translates },
            range: None,
        })
}

/// Interprets a description for a request.
///
/// # Errors
/// All mistakes that are found.
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
    chain.identifies_actuators =
        request.models_friction() || request.models_armature() || chain.has_actuator_terms();
    if chain.identifies_actuators {
        parameters.extend(chain.joints.iter().flat_map(of_actuator));
    }
    chain.spaces.parameters = parameters;
    Ok(chain)
}

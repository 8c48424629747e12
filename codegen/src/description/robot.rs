//! A robot as described: links, joints and placements.

use std::ops::Index;
use std::path::PathBuf;

use proc_macro2::Span;

use super::FileFormat;
use super::unmodelled::Unmodelled;
use crate::closure::Closure;
use crate::error::{Diagnostic, Errors, Place};
use crate::joint::JointKind;
use crate::joint::actuator::Actuator;
use crate::list::{Id, id};
use crate::name::Name;
use crate::number::Number;

/// A robot as it was described: links and joints in the order of the text.
#[derive(Clone, Debug)]
pub struct Description {
    /// The robot's name.
    pub name: Name,
    /// The source of the text.
    pub source: Source,
    /// The links, in the order of the text.
    pub links: Vec<Link>,
    /// The joints, in the order of the text.
    pub joints: Vec<Joint>,
    /// The joints that close loops, in the order of the text.
    pub loops: Vec<Loop>,
    /// Configurations with names, in the order of the text.
    pub configurations: Vec<Configuration>,
    /// The collision geometry, in the order of the text; it is used on request only.
    pub collisions: Vec<Collision>,
    /// Acceleration of gravity in the frame of the root link [m/s²], if the file has one.
    pub gravity: Option<[Number; 3]>,
    /// Warnings.
    pub warnings: Vec<Diagnostic>,
    /// Mechanics that are warnings unless the request models them.
    pub unmodelled: Unmodelled,
}

id! {
    /// The number of a link of a [`Description`].
    LinkId
}

id! {
    /// The number of a joint of a [`Description`].
    JointId
}

impl Index<LinkId> for Description {
    type Output = Link;

    fn index(&self, link: LinkId) -> &Link {
        &self.links[Id::index(link)]
    }
}

impl Index<JointId> for Description {
    type Output = Joint;

    fn index(&self, joint: JointId) -> &Joint {
        &self.joints[Id::index(joint)]
    }
}

/// Source of a description.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// The file's name as the user wrote it, without folders of this machine; `None` for tokens.
    pub file: Option<String>,
    /// The format that it was read as; `None` for tokens.
    pub format: Option<FileFormat>,
    /// The token that named the file, for the compiler's messages.
    pub anchor: Option<Span>,
    /// The names of included files, indexed by the numbers in places.
    pub included: Vec<String>,
    /// The paths of further files that were read: included files and meshes. A change of one of them changes the robot.
    pub beside: Vec<PathBuf>,
    /// FNV-1a hash (64 bits) of the text in UTF-8, including the further files; 0 for tokens.
    pub hash: u64,
}

impl Source {
    /// An empty list of errors for this source.
    #[must_use]
    pub fn errors(&self) -> Errors {
        let mut errors = Errors::new();
        if let Some(file) = &self.file {
            errors.set_file(file.clone(), self.anchor);
            errors.set_included(self.included.clone());
        }
        errors
    }
}

/// A rigid body and its frame.
#[derive(Clone, Debug)]
pub struct Link {
    /// The link's name.
    pub name: Name,
    /// Mass and inertia; `None` if the file has none.
    pub inertial: Option<Inertial>,
}

/// A shape for collision checks, fixed to a link.
#[derive(Clone, Debug)]
pub struct Collision {
    /// The link.
    pub link: LinkId,
    /// The sphere; `None` for another shape.
    pub sphere: Option<Sphere>,
    /// The mistakes in it: only a request for spheres makes them errors.
    pub errors: Errors,
    /// Its place in the text.
    pub place: Place,
}

/// A sphere.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// From the link's frame to the centre [m, rad].
    pub origin: Vec<Step>,
    /// The radius \[m\].
    pub radius: Number,
}

/// Mass, centre of mass and inertia tensor of a link.
#[derive(Clone, Debug)]
pub struct Inertial {
    /// From the link's frame to the frame at the centre of mass, in whose axes the tensor is [m, rad].
    pub origin: Vec<Step>,
    /// Mass \[kg\].
    pub mass: Number,
    /// Inertia tensor about the centre of mass [kg m²]: xx, xy, xz, yy, yz, zz.
    pub inertia: [Number; 6],
    /// Its place in the text.
    pub place: Place,
}

/// An elementary motion of a frame along or about its own axes; a placement is a product of such steps, from left to
/// right.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    /// Translation along x, y and z \[m\].
    Translate([Number; 3]),
    /// Rotation about one axis \[rad\].
    Rotate(Axis, Number),
    /// Rotation by a quaternion x, y, z, w of any length but 0.
    Quaternion([Number; 4]),
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// A joint between two links.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The joint's name.
    pub name: Name,
    /// The joint's type.
    pub kind: JointKind,
    /// The parent link.
    pub parent: Name,
    /// The child link, which the joint moves.
    pub child: Name,
    /// From the parent's frame to the child's frame at q = 0.
    pub origin: Vec<Step>,
    /// Direction of the axis in the child's frame, through its origin, not rounded: as written if its length is between
    /// 0.98 and 2, otherwise scaled by a power of two to a length in [1, 2). A length other than 1 that the digits do
    /// not explain is a warning. Unused for a fixed joint.
    pub axis: [Number; 3],
    /// The second axis of a joint that has two, in the same form.
    pub second_axis: [Number; 3],
    /// Limits, if the file has some; only for a joint with one coordinate.
    pub limits: Option<Limits>,
    /// The mimicked joint, if this one has no coordinate of its own.
    pub mimic: Option<Mimic>,
    /// Armature, rotors, damping and friction; modelled only on request.
    pub actuator: Actuator,
    /// Its place in the text.
    pub place: Place,
}

#[cfg(feature = "formats")]
impl Joint {
    /// A fixed joint, which places a link on another.
    pub(super) fn fixed(name: Name, parent: &Name, child: &Name, origin: Vec<Step>) -> Self {
        let place = name.place;
        let zero = super::number::computed(crate::expression::Double::ZERO, place);
        Self {
            name,
            kind: JointKind::Fixed,
            parent: parent.clone(),
            child: child.clone(),
            origin,
            axis: [zero; 3],
            second_axis: [zero; 3],
            limits: None,
            mimic: None,
            actuator: Actuator::default(),
            place,
        }
    }
}

/// A joint that closes a loop between two links of the tree: it joins frame A on the first link to frame B on the
/// second.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The loop's name.
    pub name: Name,
    /// The type of the joint.
    pub closure: Closure,
    /// The link of frame A.
    pub from: Name,
    /// The link of frame B.
    pub to: Name,
    /// From the frame of the first link to frame A.
    pub at: Vec<Step>,
    /// From the frame of the second link to frame B.
    pub to_at: Vec<Step>,
    /// The directions that become z of A and of B. Equal if the joint has one axis, unused if it has none.
    pub axes: [[Number; 3]; 2],
}

/// A configuration with a name.
#[derive(Clone, Debug)]
pub struct Configuration {
    /// Its name.
    pub name: Name,
    /// The joints that move, mimic joints among them, each with its coordinates [rad, m, quaternions x, y, z, w].
    pub joints: Vec<(Name, Vec<Number>)>,
}

/// Coordinate of a mimic joint: multiplier · q + offset.
#[derive(Clone, Debug)]
pub struct Mimic {
    /// The mimicked joint, which may itself be a mimic joint.
    pub mimicked: Name,
    /// Multiplier \[1, m/rad or rad/m\].
    pub multiplier: Number,
    /// Offset [rad or m].
    pub offset: Number,
    /// Its place in the text.
    pub place: Place,
}

/// Limits of a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Lower limit [rad or m].
    pub lower: f64,
    /// Upper limit [rad or m].
    pub upper: f64,
    /// Maximum velocity [rad/s or m/s]; infinite if the file has none.
    pub velocity: f64,
    /// Maximum torque or force \[N m or N\], used only as a constant; infinite if the file has none.
    pub effort: f64,
}

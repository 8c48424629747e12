//! A robot as it was described: links, joints and where everything stands.

use std::ops::Index;
use std::path::PathBuf;

use proc_macro2::Span;

use super::unmodelled::Unmodelled;
use crate::closure::Closure;
use crate::error::{Complaint, Errors, Place};
use crate::joint::JointKind;
use crate::joint::drive::Parts;
use crate::list::{Id, id};
use crate::name::Name;
use crate::number::Number;

/// A robot as it was described: links and joints in the order of the text.
#[derive(Clone, Debug)]
pub struct Description {
    /// The robot's name.
    pub name: Name,
    /// Where the text came from.
    pub source: Source,
    /// The links, in the order of the text.
    pub links: Vec<Link>,
    /// The joints, in the order of the text.
    pub joints: Vec<Joint>,
    /// The joints that close loops, in the order of the text.
    pub loops: Vec<Loop>,
    /// Acceleration of gravity in the frame of the root [m/s²], where the text gives one.
    pub gravity: Option<[Number; 3]>,
    /// Doubts that do not stop the work.
    pub warnings: Vec<Complaint>,
    /// What is doubted unless it is asked for.
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

/// Where a description came from.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// The file's name as the user gave it, without the folders of this machine; none for tokens.
    pub file: Option<String>,
    /// The token that named the file, for the compiler's messages.
    pub anchor: Option<Span>,
    /// The names of the files that it includes, by their numbers in places.
    pub included: Vec<String>,
    /// The paths of other files that were read with it: those that it includes, and meshes. A change of one of them
    /// changes the robot.
    pub beside: Vec<PathBuf>,
    /// FNV-1a hash (64 bits) of the file's text in UTF-8, and of the others'; 0 for tokens.
    pub hash: u64,
}

impl Source {
    /// No mistakes yet, of this text.
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
    /// Mass and inertia; none where the text gives none.
    pub inertial: Option<Inertial>,
}

/// Mass, centre of mass and inertia tensor of a link.
#[derive(Clone, Debug)]
pub struct Inertial {
    /// From the link's frame to the frame whose origin is the centre of mass and in whose axes
    /// the tensor is given [m, rad].
    pub origin: Vec<Step>,
    /// Mass \[kg\].
    pub mass: Number,
    /// The usual inertia tensor about the centre of mass [kg m²]: xx, xy, xz, yy, yz, zz.
    pub inertia: [Number; 6],
    /// Where it stands.
    pub place: Place,
}

/// One elementary motion of a frame along or about its own axes; a placement is a product of them
/// from left to right.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    /// Along x, y and z \[m\].
    Translate([Number; 3]),
    /// About one axis \[rad\].
    Rotate(Axis, Number),
    /// By a quaternion x, y, z, w of any length but 0.
    Turn([Number; 4]),
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

/// A pair of links and the motion it allows.
#[derive(Clone, Debug)]
pub struct Joint {
    /// The joint's name.
    pub name: Name,
    /// What it allows.
    pub kind: JointKind,
    /// The link it hangs on.
    pub parent: Name,
    /// The link it carries.
    pub child: Name,
    /// From the parent's frame to the child's frame at q = 0.
    pub origin: Vec<Step>,
    /// Direction of the axis in the child's frame, through its origin, not rounded: as written where its length is
    /// between 0.98 and 2, and else times the power of two that makes it 1 to 2. Another length than 1 that digits
    /// do not excuse is a warning. Unused for a fixed joint.
    pub axis: [Number; 3],
    /// The second axis of a joint that has two, likewise.
    pub second_axis: [Number; 3],
    /// Range of the coordinate and bound of its rate, where given; of a joint with one coordinate alone.
    pub limits: Option<Limits>,
    /// The joint whose coordinate moves it, where it has none of its own.
    pub mimic: Option<Mimic>,
    /// What its drive adds to the bodies; modelled where it is asked for.
    pub drive: Parts,
    /// Where the joint is described.
    pub place: Place,
}

/// A joint between two links that both hang on the base by other joints: frame A is fixed to the first
/// of them, frame B to the second, and the joint holds them together.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The loop's name.
    pub name: Name,
    /// What the joint leaves free.
    pub closure: Closure,
    /// The link of frame A.
    pub from: Name,
    /// The link of frame B.
    pub to: Name,
    /// From the frame of the one link to where the joint is on it.
    pub at: Vec<Step>,
    /// The same of the other link.
    pub to_at: Vec<Step>,
    /// The directions that are z of A and z of B, there; both the same where the joint has one axis, and
    /// unused where it has none.
    pub axes: [[Number; 3]; 2],
}

/// What a joint makes of the coordinate of another: multiplier · q + offset.
#[derive(Clone, Debug)]
pub struct Mimic {
    /// The joint that has the coordinate, or makes it of that of a third.
    pub leader: Name,
    /// What it is multiplied by: \[1, m/rad or rad/m\].
    pub multiplier: Number,
    /// What is added then [rad or m].
    pub offset: Number,
    /// Where that is said.
    pub place: Place,
}

/// Limits of a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Smallest value [rad or m].
    pub lower: f64,
    /// Largest value [rad or m].
    pub upper: f64,
    /// Largest rate [rad/s or m/s]; infinite where not given.
    pub velocity: f64,
    /// Largest torque or force \[N m or N\], which nothing is computed of; infinite where not given.
    pub effort: f64,
}

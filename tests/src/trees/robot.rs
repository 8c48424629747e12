//! A random robot as its file has it, number by number, and a request.
//!
//! In: the choices of [`grow`](super::grow). Out: the robot that all other modules here read. A link has the number of
//! its joint; the root is link 0. Numbers stay when other joints are removed, so that a smaller robot is at the same
//! states.

use crate::big::Big;

use super::movement::Movement;
use super::written::{Reading, Written};

/// A description and a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// The inertial of link 0, which has no effect on a fixed base.
    pub root: Option<Inertial>,
    /// Joints and links, in the order of the text.
    pub bodies: Vec<Body>,
    /// The request.
    pub options: Options,
    /// The reader that reads it.
    pub front_end: FrontEnd,
}

/// A joint and the link that it carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The number of both.
    pub id: usize,
    /// The parent link.
    pub parent: usize,
    /// The motion that it allows.
    pub kind: Kind,
    /// Its pose in the parent's frame.
    pub at: Placement,
    /// Its axis, in its own frame.
    pub axis: [Written; 3],
    /// The mimicked joint, if it is a mimic joint.
    pub mimic: Option<Mimic>,
    /// `None` if the link has no inertial.
    pub inertial: Option<Inertial>,
}

/// The motion that a joint allows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A rotation within limits.
    Revolute,
    /// A rotation.
    Continuous,
    /// A translation.
    Prismatic,
    /// Rotation and translation, coupled by a pitch.
    Screw(Written),
    /// Rotation and translation along one axis.
    Cylindrical,
    /// Two rotations, the second about this axis.
    Universal([Written; 3]),
    /// Three translations.
    Translation,
    /// Motion in the plane perpendicular to the axis.
    Planar,
    /// Any rotation.
    Spherical,
    /// Any motion.
    Floating,
    /// None.
    Fixed,
}

/// Displacement of a mimic joint: multiplier times the coordinate of the mimicked joint, plus offset.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// The number of the mimicked joint.
    pub mimicked: usize,
    /// The multiplier.
    pub multiplier: Written,
    /// The offset.
    pub offset: Written,
}

/// `xyz`, then `rpy`, then rotations about axes 0, 1 and 2, which only an inline description can have.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// A translation.
    pub xyz: [Written; 3],
    /// Roll, pitch and yaw.
    pub rpy: [Written; 3],
    /// Further rotations, about the rotated axes.
    pub turns: Vec<(usize, Written)>,
}

/// Mass, centre of mass and inertia tensor: xx, xy, xz, yy, yz, zz.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertial {
    /// The pose of the centre of mass and of the axes of the tensor.
    pub at: Placement,
    /// Mass.
    pub mass: Written,
    /// The tensor about the centre of mass.
    pub tensor: [Written; 6],
}

/// The reader of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrontEnd {
    /// URDF.
    Urdf,
    /// An inline description, as tokens of Rust.
    Inline,
    /// URDF, with numbers that have lost their digits afterwards, as a program makes them.
    Computed,
}

/// A request.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The base link, fixed or floating.
    pub base: usize,
    /// True if the base is floating.
    pub floating: bool,
    /// The end effector's link.
    pub tip: Option<usize>,
    /// True if all joints that do not move the end effector are locked.
    pub path_only: bool,
    /// Locked joints; at zero if there is no position.
    pub lock: Vec<(usize, Option<Written>)>,
    /// Dropped links.
    pub drop: Vec<usize>,
    /// Further frames.
    pub frames: Vec<usize>,
    /// Gravity, if not the default.
    pub gravity: Option<[Written; 3]>,
    /// True if angles are exactly as written.
    pub exact: bool,
    /// Struct fields and their values, padded with zeros.
    pub fields: Vec<(Field, [f64; NUMBERS])>,
    /// Joints with armature, damping and friction, the same for each of their velocities.
    pub actuators: Vec<(usize, [f64; 3])>,
    /// Links with external wrenches, and whether the wrenches are in frame 0.
    pub external: (Vec<usize>, bool),
}

/// The length of the longest field.
pub const NUMBERS: usize = 10;

/// The parameter that a struct field replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The mass of a link.
    Mass(usize),
    /// The centre of mass of a link.
    Center(usize),
    /// The inertia of a link.
    Inertia(usize),
    /// A load on a link.
    Payload(usize),
    /// The origin of a joint.
    Origin(usize),
    /// The placement of a joint.
    Placement(usize),
    /// Gravity.
    Gravity,
}

impl Robot {
    /// The body of a number; `None` for the root.
    #[must_use]
    pub fn body(&self, id: usize) -> Option<&Body> {
        self.bodies.iter().find(|body| body.id == id)
    }

    /// A link and its ancestors, up to the root.
    pub fn upwards(&self, id: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(id), |&id| self.body(id).map(|body| body.parent))
    }

    /// True if a joint is below the base, with no dropped link between.
    #[must_use]
    pub fn models(&self, joint: usize) -> bool {
        let base = self.options.base;
        let mut below = self.upwards(joint).take_while(|&link| link != base);
        let reaches = self.upwards(joint).skip(1).any(|link| link == base);
        reaches && below.all(|link| !self.options.drop.contains(&link))
    }

    /// The position of a fixed or locked joint; `None` for others.
    #[must_use]
    pub fn locked(&self, body: &Body) -> Option<Big> {
        if body.kind == Kind::Fixed {
            return Some(Big::zero());
        }
        let mut locks = self.options.lock.iter();
        let (_, at) = locks.find(|(joint, _)| *joint == body.id)?;
        Some(at.as_ref().map_or_else(Big::zero, Written::number))
    }

    /// The joint that a joint mimics, if it does.
    #[must_use]
    pub fn mimicked<'r>(&'r self, body: &'r Body) -> Option<(&'r Body, &'r Mimic)> {
        let mimic = body.mimic.as_ref()?;
        if self.locked(body).is_some() {
            return None;
        }
        Some((self.body(mimic.mimicked)?, mimic))
    }

    /// A joint and the chain of joints that it mimics.
    pub fn mimic_chain<'r>(&'r self, body: &'r Body) -> impl Iterator<Item = &'r Body> {
        std::iter::successors(Some(body), |body| {
            self.mimicked(body).map(|(mimicked, _)| mimicked)
        })
    }

    /// True if a joint that mimics none has coordinates: it is modelled, not locked, and needed.
    #[must_use]
    pub fn is_free(&self, body: &Body) -> bool {
        if !self.models(body.id) || self.locked(body).is_some() {
            return false;
        }
        let Some(tip) = self.options.tip.filter(|_| self.options.path_only) else {
            return true;
        };
        let mut path = self.upwards(tip).filter_map(|link| self.body(link));
        path.any(|on_path| {
            self.models(on_path.id)
                && self
                    .mimic_chain(on_path)
                    .any(|mimicked| mimicked.id == body.id)
        })
    }

    /// The numbers of the joints with coordinates, in the order of the text.
    pub fn moving(&self) -> impl Iterator<Item = usize> {
        let own = |body: &&Body| self.mimicked(body).is_none() && self.is_free(body);
        self.bodies.iter().filter(own).map(|body| body.id)
    }

    /// True if a joint between the base and a link moves.
    #[must_use]
    pub fn moves(&self, link: usize) -> bool {
        let mut below = self.upwards(link).take_while(|&at| at != self.options.base);
        let moves = |body: &Body| Movement::of(self, body).is_motion();
        self.options.floating || below.any(|at| self.body(at).is_some_and(moves))
    }

    /// Armature, damping and friction of joints that move, with the numbers of the joints.
    pub fn actuators(&self) -> impl Iterator<Item = (usize, [f64; 3])> {
        let moves = |body: &Body| {
            body.kind != Kind::Fixed && self.models(body.id) && Movement::of(self, body).is_motion()
        };
        let actuators = self.options.actuators.iter().copied();
        actuators.filter(move |(id, _)| self.body(*id).is_some_and(moves))
    }

    /// The links that move and have external wrenches.
    pub fn acted_on(&self) -> impl Iterator<Item = usize> {
        let links = self.options.external.0.iter().copied();
        let is_there = |id: usize| id == self.options.base || self.models(id);
        links.filter(move |&id| is_there(id) && self.moves(id))
    }

    /// The value of the field for a parameter, if there is one.
    #[must_use]
    pub fn field(&self, of: Field) -> Option<[f64; NUMBERS]> {
        let mut fields = self.options.fields.iter();
        fields
            .find(|(field, _)| *field == of)
            .map(|(_, value)| *value)
    }

    /// The interpretation of its angles.
    #[must_use]
    pub fn reading(&self) -> Reading {
        match (self.front_end, self.options.exact) {
            (FrontEnd::Computed, _) => Reading::Computed,
            (_, true) => Reading::Exact,
            (_, false) => Reading::Digits,
        }
    }
}

impl Kind {
    /// True if it has one coordinate, so that it can mimic and be mimicked.
    #[must_use]
    pub const fn has_one_coordinate(&self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Continuous | Self::Prismatic | Self::Screw(_)
        )
    }

    /// The suffixes of its coordinates' and velocities' names behind the name of the joint.
    #[must_use]
    pub const fn entries(&self) -> [&'static [&'static str]; 2] {
        match self {
            Self::Fixed => [&[], &[]],
            Self::Revolute | Self::Continuous | Self::Prismatic | Self::Screw(_) => [&[""], &[""]],
            Self::Cylindrical => [&[".angle", ".shift"]; 2],
            Self::Universal(_) => [&[".first", ".second"]; 2],
            Self::Translation => [&[".x", ".y", ".z"]; 2],
            Self::Planar => [&[".x", ".y", ".angle"], &[".vx", ".vy", ".wz"]],
            Self::Spherical => [&[".qx", ".qy", ".qz", ".qw"], &[".wx", ".wy", ".wz"]],
            Self::Floating => [
                &[".x", ".y", ".z", ".qx", ".qy", ".qz", ".qw"],
                &[".vx", ".vy", ".vz", ".wx", ".wy", ".wz"],
            ],
        }
    }
}

impl Placement {
    /// No displacement.
    #[must_use]
    pub fn none() -> Self {
        Self {
            xyz: zeros(),
            rpy: zeros(),
            turns: Vec::new(),
        }
    }

    /// Its numbers.
    pub fn numbers(&mut self) -> impl Iterator<Item = &mut Written> {
        let turns = self.turns.iter_mut().map(|(_, angle)| angle);
        self.xyz.iter_mut().chain(&mut self.rpy).chain(turns)
    }
}

impl Field {
    /// The number of its link or joint.
    #[must_use]
    pub const fn of(self) -> Option<usize> {
        match self {
            Self::Mass(id)
            | Self::Center(id)
            | Self::Inertia(id)
            | Self::Payload(id)
            | Self::Origin(id)
            | Self::Placement(id) => Some(id),
            Self::Gravity => None,
        }
    }
}

/// A zero vector.
#[must_use]
pub fn zeros<const N: usize>() -> [Written; N] {
    [(); N].map(|()| Written::zero())
}

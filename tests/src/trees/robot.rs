//! A robot as its file has it, number by number, and what is asked of it.
//!
//! In: what [`grow`](super::grow) draws. Out: the noun that everything else here reads. The link a
//! joint carries has the joint's number, the root is link 0; numbers stay when others are taken
//! away, so that a smaller robot moves as the one before. It computes nothing but who carries whom.

use crate::big::Big;

use super::movement::Movement;
use super::written::{Reading, Written};

/// A description and a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    /// What link 0 weighs, which nothing feels.
    pub root: Option<Inertial>,
    /// In the order of the text.
    pub bodies: Vec<Body>,
    /// What is asked.
    pub asked: Asked,
    /// Through which reader it goes.
    pub door: Door,
}

/// A joint and the link that it carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The number of both.
    pub id: usize,
    /// The link it hangs on.
    pub parent: usize,
    /// What it allows.
    pub kind: Kind,
    /// From the parent's frame to its own.
    pub at: Placement,
    /// In its own frame.
    pub axis: [Written; 3],
    /// The joint that moves this one, where one does.
    pub mimic: Option<Mimic>,
    /// None where the link is described without.
    pub inertial: Option<Inertial>,
}

/// What a joint allows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A rotation within limits.
    Revolute,
    /// A rotation.
    Continuous,
    /// A translation.
    Prismatic,
    /// Both, with a pitch.
    Screw(Written),
    /// Both, each by itself.
    Cylindrical,
    /// Two rotations, the other one about this axis.
    Universal([Written; 3]),
    /// Three translations.
    Translation,
    /// A plane across the axis.
    Planar,
    /// Any rotation.
    Spherical,
    /// Any motion.
    Floating,
    /// Nothing.
    Fixed,
}

/// Multiplier times the coordinate of another joint, and an offset.
#[derive(Clone, Debug, PartialEq)]
pub struct Mimic {
    /// The number of the other.
    pub leader: usize,
    /// What its coordinate is multiplied by.
    pub multiplier: Written,
    /// What is added then.
    pub offset: Written,
}

/// `xyz`, then `rpy`, then what only a text in Rust can say: turns about axes 0, 1 and 2.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// A translation.
    pub xyz: [Written; 3],
    /// Roll, pitch and yaw.
    pub rpy: [Written; 3],
    /// Rotations about the turned axes.
    pub turns: Vec<(usize, Written)>,
}

/// Mass, centre of mass and inertia tensor: xx, xy, xz, yy, yz, zz.
#[derive(Clone, Debug, PartialEq)]
pub struct Inertial {
    /// Of the centre of mass, and of the axes of the tensor.
    pub at: Placement,
    /// Mass.
    pub mass: Written,
    /// About the centre of mass.
    pub tensor: [Written; 6],
}

/// Which reader takes the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Door {
    /// URDF.
    Urdf,
    /// Tokens of Rust.
    Inline,
    /// URDF, then a description whose numbers have lost their digits, as a program makes them.
    Computed,
}

/// A request.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Asked {
    /// The link taken as fixed, or as free.
    pub base: usize,
    /// Whether it is free.
    pub floating: bool,
    /// The link that poses are of.
    pub tip: Option<usize>,
    /// Whether all that does not move the tip is held.
    pub path_only: bool,
    /// Joints held, some at a coordinate.
    pub lock: Vec<(usize, Option<Written>)>,
    /// Links taken off.
    pub drop: Vec<usize>,
    /// Further frames.
    pub frames: Vec<usize>,
    /// Where it is not the usual one.
    pub gravity: Option<[Written; 3]>,
    /// Whether every angle is what it says.
    pub exact: bool,
    /// Struct fields and what is in them, with zeros behind.
    pub fields: Vec<(Field, [f64; NUMBERS])>,
    /// Joints with a drive: armature, damping and friction at each of their velocities.
    pub drives: Vec<(usize, [f64; 3])>,
    /// Links on which the surroundings act, and whether they do in frame 0.
    pub external: (Vec<usize>, bool),
}

/// As many numbers as the longest field holds.
pub const NUMBERS: usize = 10;

/// What a struct field stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The mass of a link.
    Mass(usize),
    /// The centre of mass of a link.
    Center(usize),
    /// The inertia of a link.
    Inertia(usize),
    /// What a link carries besides.
    Payload(usize),
    /// The origin of a joint.
    Origin(usize),
    /// The placement of a joint.
    Placement(usize),
    /// Gravity.
    Gravity,
}

impl Robot {
    /// The body of that number; none for the root.
    #[must_use]
    pub fn body(&self, id: usize) -> Option<&Body> {
        self.bodies.iter().find(|body| body.id == id)
    }

    /// A link and those that it hangs on, up to the root.
    pub fn upwards(&self, id: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(id), |&id| self.body(id).map(|body| body.parent))
    }

    /// Whether a joint hangs on the base, with no link between them that was dropped.
    #[must_use]
    pub fn models(&self, joint: usize) -> bool {
        let base = self.asked.base;
        let mut below = self.upwards(joint).take_while(|&link| link != base);
        let reaches = self.upwards(joint).skip(1).any(|link| link == base);
        reaches && below.all(|link| !self.asked.drop.contains(&link))
    }

    /// Where a joint is held by its kind or by what is asked; none where it is not.
    #[must_use]
    pub fn locked(&self, body: &Body) -> Option<Big> {
        if body.kind == Kind::Fixed {
            return Some(Big::zero());
        }
        let mut locks = self.asked.lock.iter();
        let (_, at) = locks.find(|(joint, _)| *joint == body.id)?;
        Some(at.as_ref().map_or_else(Big::zero, Written::number))
    }

    /// The joint that a joint follows, where it does.
    #[must_use]
    pub fn leader<'r>(&'r self, body: &'r Body) -> Option<(&'r Body, &'r Mimic)> {
        let mimic = body.mimic.as_ref()?;
        if self.locked(body).is_some() {
            return None;
        }
        Some((self.body(mimic.leader)?, mimic))
    }

    /// A joint and those that move it, up to the one that has a coordinate.
    pub fn leaders<'r>(&'r self, body: &'r Body) -> impl Iterator<Item = &'r Body> {
        std::iter::successors(Some(body), |body| {
            self.leader(body).map(|(leader, _)| leader)
        })
    }

    /// Whether a joint that is modelled and follows none has a coordinate, or is held.
    #[must_use]
    pub fn is_free(&self, body: &Body) -> bool {
        if !self.models(body.id) || self.locked(body).is_some() {
            return false;
        }
        let Some(tip) = self.asked.tip.filter(|_| self.asked.path_only) else {
            return true;
        };
        let mut path = self.upwards(tip).filter_map(|link| self.body(link));
        path.any(|on_path| {
            self.models(on_path.id) && self.leaders(on_path).any(|leader| leader.id == body.id)
        })
    }

    /// The numbers of the joints that have coordinates, in the order of the text.
    pub fn moving(&self) -> impl Iterator<Item = usize> {
        let own = |body: &&Body| self.leader(body).is_none() && self.is_free(body);
        self.bodies.iter().filter(own).map(|body| body.id)
    }

    /// Whether a joint between the base and a link moves.
    #[must_use]
    pub fn moves(&self, link: usize) -> bool {
        let mut below = self.upwards(link).take_while(|&at| at != self.asked.base);
        let moves = |body: &Body| Movement::of(self, body).is_motion();
        self.asked.floating || below.any(|at| self.body(at).is_some_and(moves))
    }

    /// The drives of joints that move, with the numbers of the joints.
    pub fn drives(&self) -> impl Iterator<Item = (usize, [f64; 3])> {
        let moves = |body: &Body| {
            body.kind != Kind::Fixed && self.models(body.id) && Movement::of(self, body).is_motion()
        };
        let drives = self.asked.drives.iter().copied();
        drives.filter(move |(id, _)| self.body(*id).is_some_and(moves))
    }

    /// The links that move and on which the surroundings act.
    pub fn acted_on(&self) -> impl Iterator<Item = usize> {
        let links = self.asked.external.0.iter().copied();
        let is_there = |id: usize| id == self.asked.base || self.models(id);
        links.filter(move |&id| is_there(id) && self.moves(id))
    }

    /// What is in the field that stands for something, where one does.
    #[must_use]
    pub fn field(&self, of: Field) -> Option<[f64; NUMBERS]> {
        let mut fields = self.asked.fields.iter();
        fields
            .find(|(field, _)| *field == of)
            .map(|(_, value)| *value)
    }

    /// What its angles mean.
    #[must_use]
    pub fn reading(&self) -> Reading {
        match (self.door, self.asked.exact) {
            (Door::Computed, _) => Reading::Computed,
            (_, true) => Reading::Exact,
            (_, false) => Reading::Digits,
        }
    }
}

impl Kind {
    /// Whether it has one coordinate, so that it can lead and follow.
    #[must_use]
    pub const fn has_one_coordinate(&self) -> bool {
        matches!(
            self,
            Self::Revolute | Self::Continuous | Self::Prismatic | Self::Screw(_)
        )
    }

    /// What its coordinates are called behind the name of the joint, and its velocities.
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
    /// Where it is already.
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
    /// The link or joint that it is of.
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

/// A vector that is zero.
#[must_use]
pub fn zeros<const N: usize>() -> [Written; N] {
    [(); N].map(|()| Written::zero())
}

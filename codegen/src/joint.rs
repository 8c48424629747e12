//! Joint types.
//!
//! Each type is a [`Definition`] in a file of its own. A joint is a list of degrees of freedom ([`Freedom`]), with one
//! velocity each. Either they are in series and each has its own coordinate, or a [`Posture`] defines the coordinates
//! of all together. [`Motion`] is the motion of one degree of freedom.

mod continuous;
mod cylindrical;
pub mod drive;
mod fixed;
mod floating;
mod motion;
mod planar;
mod posture;
mod prismatic;
mod revolute;
mod screw;
mod spherical;
mod translation;
mod universal;

pub use drive::Drive;
pub use motion::Motion;
pub use posture::Posture;

use crate::number::Number;
use crate::space::Kind;

/// Type of a joint.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum JointKind {
    /// Rotation within limits \[rad\].
    Revolute,
    /// Rotation without limits \[rad\].
    Continuous,
    /// Translation \[m\].
    Prismatic,
    /// Rotation \[rad\] with a translation of `pitch` metres per radian.
    Screw {
        /// Translation per radian [m/rad].
        pitch: Number,
    },
    /// Rotation \[rad\] and translation \[m\] about and along one axis, each with its own coordinate.
    Cylindrical,
    /// Rotation about one axis and then about a second one, which the first rotation moves \[rad\].
    Universal,
    /// Translation along x, y and z of the joint's frame \[m\].
    Translation,
    /// Translation in the plane across the axis \[m\] and rotation about the axis \[rad\].
    Planar,
    /// Any rotation, as a quaternion of unit length.
    Spherical,
    /// Any motion: translation \[m\] and a quaternion of unit length.
    Floating,
    /// No motion.
    Fixed,
}

/// Properties of a joint type.
pub struct Definition {
    /// Its name in all formats.
    pub word: &'static str,
    /// Its degrees of freedom from the parent link outwards: one for each velocity.
    pub freedoms: &'static [Freedom],
    /// Coordinates of all degrees of freedom together; `None` if each has a coordinate of its own.
    pub posture: Option<Posture>,
    /// Makes the type; the argument is the pitch of a screw.
    make: fn(Number) -> JointKind,
}

/// A degree of freedom: a motion with one velocity.
#[derive(Clone, Copy, Debug)]
pub struct Freedom {
    /// Name of its velocity, and of its coordinate if it has one, within the joint.
    pub name: &'static str,
    /// Type of motion.
    pub movement: Movement,
    /// Direction of the axis.
    pub along: Along,
}

/// Motion of one degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Movement {
    /// Rotation about a direction.
    Turn,
    /// Translation along it.
    Slide,
    /// Both, in a fixed ratio.
    Helix,
}

/// A direction in the frame of the moved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The joint's axis.
    Axis,
    /// Its second axis.
    Second,
    /// An axis of the frame: x, y or z. z is the joint's own axis if it has one.
    Frame(usize),
}

/// All types, in the order of messages.
pub const ALL: [&Definition; 11] = [
    &revolute::DEFINITION,
    &continuous::DEFINITION,
    &prismatic::DEFINITION,
    &screw::DEFINITION,
    &cylindrical::DEFINITION,
    &universal::DEFINITION,
    &translation::DEFINITION,
    &planar::DEFINITION,
    &spherical::DEFINITION,
    &floating::DEFINITION,
    &fixed::DEFINITION,
];

impl Freedom {
    const fn rotation(name: &'static str, along: Along) -> Self {
        let movement = Movement::Turn;
        Self {
            name,
            movement,
            along,
        }
    }

    const fn translation(name: &'static str, along: Along) -> Self {
        let movement = Movement::Slide;
        Self {
            name,
            movement,
            along,
        }
    }
}

impl Definition {
    /// True if a joint of this type moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        !self.freedoms.is_empty()
    }

    /// Number of axes in a description.
    #[must_use]
    pub fn axes(&self) -> usize {
        let along = |direction| self.freedoms.iter().any(|one| one.along == direction);
        match () {
            () if along(Along::Second) => 2,
            () if along(Along::Axis) || self.posture == Some(Posture::Planar) => 1,
            () => 0,
        }
    }

    /// A joint of this type; `pitch` is called for a screw.
    ///
    /// # Errors
    /// The error of `pitch`.
    pub fn with_pitch<E>(&self, pitch: impl FnOnce() -> Result<Number, E>) -> Result<JointKind, E> {
        let helical = |freedom: &Freedom| freedom.movement == Movement::Helix;
        let pitch = if self.freedoms.iter().any(helical) {
            pitch()?
        } else {
            Number::default()
        };
        Ok((self.make)(pitch))
    }
}

impl JointKind {
    /// Properties of its type.
    #[must_use]
    pub const fn definition(self) -> &'static Definition {
        match self {
            Self::Revolute => &revolute::DEFINITION,
            Self::Continuous => &continuous::DEFINITION,
            Self::Prismatic => &prismatic::DEFINITION,
            Self::Screw { .. } => &screw::DEFINITION,
            Self::Cylindrical => &cylindrical::DEFINITION,
            Self::Universal => &universal::DEFINITION,
            Self::Translation => &translation::DEFINITION,
            Self::Planar => &planar::DEFINITION,
            Self::Spherical => &spherical::DEFINITION,
            Self::Floating => &floating::DEFINITION,
            Self::Fixed => &fixed::DEFINITION,
        }
    }

    /// Its name.
    #[must_use]
    pub const fn word(self) -> &'static str {
        self.definition().word
    }

    /// True if it moves.
    #[must_use]
    pub const fn moves(self) -> bool {
        self.definition().moves()
    }

    /// True if it has more than one velocity.
    #[must_use]
    pub const fn has_several(self) -> bool {
        self.freedoms().len() > 1
    }

    /// Its degrees of freedom, from the parent link outwards.
    #[must_use]
    pub const fn freedoms(self) -> &'static [Freedom] {
        self.definition().freedoms
    }

    /// Coordinates of all its degrees of freedom together; `None` if they are in series.
    #[must_use]
    pub const fn posture(self) -> Option<Posture> {
        self.definition().posture
    }

    /// Translation per radian of a screw [m/rad].
    #[must_use]
    pub const fn pitch(self) -> Option<Number> {
        match self {
            Self::Screw { pitch } => Some(pitch),
            _ => None,
        }
    }

    /// Names of the velocities of a joint: that of the joint if there is only one.
    pub fn velocities(self, joint: &str) -> impl Iterator<Item = (String, Freedom)> {
        let freedoms = self.freedoms();
        freedoms.iter().map(move |&freedom| {
            let name = match freedoms {
                [_] => joint.to_owned(),
                _ => entry(joint, freedom.name),
            };
            (name, freedom)
        })
    }

    /// Names of the coordinates of a joint, with the kind of each.
    #[must_use]
    pub fn coordinates(self, joint: &str) -> Vec<(String, Kind)> {
        if let Some(posture) = self.posture() {
            let entries = posture.coordinates().iter();
            return entries
                .map(|&(name, kind)| (entry(joint, name), kind))
                .collect();
        }
        let velocities = self.velocities(joint);
        velocities
            .map(|(name, freedom)| (name, freedom.movement.kind()))
            .collect()
    }
}

impl Movement {
    /// Kind of its coordinate.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Slide => Kind::Slide,
            Self::Turn | Self::Helix => Kind::Turn,
        }
    }
}

/// The name of one of several entries of a joint.
#[must_use]
pub fn entry(joint: &str, name: &str) -> String {
    format!("{joint}.{name}")
}

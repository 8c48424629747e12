//! Joint types.
//!
//! Each type is a [`Definition`] in a file of its own. A joint is a list of degrees of freedom ([`DegreeOfFreedom`]), with one
//! velocity each. Either they are in series and each has its own coordinate, or a [`Manifold`] defines the coordinates
//! of all together. [`Motion`] is the motion of one degree of freedom.

pub mod actuator;
mod continuous;
mod cylindrical;
mod fixed;
mod floating;
mod manifold;
mod motion;
mod planar;
mod prismatic;
mod revolute;
mod screw;
mod spherical;
mod translation;
mod universal;

pub use actuator::ActuatorTerms;
pub use manifold::Manifold;
pub use motion::Motion;

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
    pub degrees_of_freedom: &'static [DegreeOfFreedom],
    /// Coordinates of all degrees of freedom together; `None` if each has a coordinate of its own.
    pub manifold: Option<Manifold>,
    /// Makes the type; the argument is the pitch of a screw.
    make: fn(Number) -> JointKind,
}

/// A degree of freedom: a motion with one velocity.
#[derive(Clone, Copy, Debug)]
pub struct DegreeOfFreedom {
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
    Rotation,
    /// Translation along it.
    Translation,
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

impl DegreeOfFreedom {
    const fn rotation(name: &'static str, along: Along) -> Self {
        let movement = Movement::Rotation;
        Self {
            name,
            movement,
            along,
        }
    }

    const fn translation(name: &'static str, along: Along) -> Self {
        let movement = Movement::Translation;
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
        !self.degrees_of_freedom.is_empty()
    }

    /// Number of axes in a description.
    #[must_use]
    pub fn axes(&self) -> usize {
        let along = |direction| {
            self.degrees_of_freedom
                .iter()
                .any(|one| one.along == direction)
        };
        match () {
            () if along(Along::Second) => 2,
            () if along(Along::Axis) || self.manifold == Some(Manifold::Planar) => 1,
            () => 0,
        }
    }

    /// A joint of this type; `pitch` is called for a screw.
    ///
    /// # Errors
    /// The error of `pitch`.
    pub fn with_pitch<E>(&self, pitch: impl FnOnce() -> Result<Number, E>) -> Result<JointKind, E> {
        let helical =
            |degree_of_freedom: &DegreeOfFreedom| degree_of_freedom.movement == Movement::Helix;
        let pitch = if self.degrees_of_freedom.iter().any(helical) {
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
        self.degrees_of_freedom().len() > 1
    }

    /// Its degrees of freedom, from the parent link outwards.
    #[must_use]
    pub const fn degrees_of_freedom(self) -> &'static [DegreeOfFreedom] {
        self.definition().degrees_of_freedom
    }

    /// Coordinates of all its degrees of freedom together; `None` if they are in series.
    #[must_use]
    pub const fn manifold(self) -> Option<Manifold> {
        self.definition().manifold
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
    pub fn velocities(self, joint: &str) -> impl Iterator<Item = (String, DegreeOfFreedom)> {
        let degrees_of_freedom = self.degrees_of_freedom();
        degrees_of_freedom.iter().map(move |&degree_of_freedom| {
            let name = match degrees_of_freedom {
                [_] => joint.to_owned(),
                _ => entry(joint, degree_of_freedom.name),
            };
            (name, degree_of_freedom)
        })
    }

    /// Names of the coordinates of a joint, with the kind of each.
    #[must_use]
    pub fn coordinates(self, joint: &str) -> Vec<(String, Kind)> {
        if let Some(manifold) = self.manifold() {
            let entries = manifold.coordinates().iter();
            return entries
                .map(|&(name, kind)| (entry(joint, name), kind))
                .collect();
        }
        let velocities = self.velocities(joint);
        velocities
            .map(|(name, degree_of_freedom)| (name, degree_of_freedom.movement.kind()))
            .collect()
    }
}

impl Movement {
    /// Kind of its coordinate.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Translation => Kind::Translation,
            Self::Rotation | Self::Helix => Kind::Rotation,
        }
    }
}

/// The name of one of several entries of a joint.
#[must_use]
pub fn entry(joint: &str, name: &str) -> String {
    format!("{joint}.{name}")
}

//! The joints that a description can have.
//!
//! A shared noun, and the table of all kinds: what is known of one stands in its own file, as a
//! [`Definition`]. A joint is a row of [`Freedom`]s with one velocity each; either they come one after
//! the other and each has a coordinate of its own, or a [`Posture`] says where all of them together
//! have taken the body. How bodies move by one freedom is said by [`Motion`].

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

/// What a joint allows.
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
    /// Rotation about one axis and then about another, which the first one turns \[rad\].
    Universal,
    /// Translation along x, y and z of the joint's frame \[m\].
    Translation,
    /// Translation in the plane across the axis \[m\] and rotation about the axis \[rad\].
    Planar,
    /// Any rotation, as a quaternion of unit length.
    Spherical,
    /// Any motion: translation \[m\] and a quaternion of unit length.
    Floating,
    /// Nothing.
    Fixed,
}

/// What is known of a kind of joint.
pub struct Definition {
    /// What it is called in every reader.
    pub word: &'static str,
    /// What it allows, from the link it hangs on outwards: one for each velocity.
    pub freedoms: &'static [Freedom],
    /// What says where all freedoms together have taken the body; none where each has its own
    /// coordinate.
    pub posture: Option<Posture>,
    /// Makes it; a helical freedom asks for the pitch.
    make: fn(Number) -> JointKind,
}

/// A motion with one velocity.
#[derive(Clone, Copy, Debug)]
pub struct Freedom {
    /// The name of its velocity, and of its coordinate where it has one, beside others of the same joint.
    pub name: &'static str,
    /// What it does.
    pub movement: Movement,
    /// About or along which direction.
    pub along: Along,
}

/// What a freedom does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Movement {
    /// Turn about a direction.
    Turn,
    /// Slide along it.
    Slide,
    /// Do both, in a fixed ratio.
    Helix,
}

/// A direction in the frame of the moved body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The joint's axis.
    Axis,
    /// Its second axis.
    Second,
    /// An axis of the frame: x, y or z, of which the last is the joint's own where it has one.
    Frame(usize),
}

/// All kinds, in the order in which messages list them.
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
    const fn turn(name: &'static str, along: Along) -> Self {
        let movement = Movement::Turn;
        Self {
            name,
            movement,
            along,
        }
    }

    const fn slide(name: &'static str, along: Along) -> Self {
        let movement = Movement::Slide;
        Self {
            name,
            movement,
            along,
        }
    }
}

impl Definition {
    /// Whether a joint of this kind moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        !self.freedoms.is_empty()
    }

    /// How many axes a description gives it.
    #[must_use]
    pub fn axes(&self) -> usize {
        let along = |direction| self.freedoms.iter().any(|one| one.along == direction);
        match () {
            () if along(Along::Second) => 2,
            () if along(Along::Axis) || self.posture == Some(Posture::Planar) => 1,
            () => 0,
        }
    }

    /// A joint of this kind; `pitch` is asked for where there is a helical freedom.
    ///
    /// # Errors
    /// That of `pitch`.
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
    /// What is known of its kind.
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

    /// What it is called.
    #[must_use]
    pub const fn word(self) -> &'static str {
        self.definition().word
    }

    /// Whether it moves.
    #[must_use]
    pub const fn moves(self) -> bool {
        self.definition().moves()
    }

    /// Whether it has more than one velocity.
    #[must_use]
    pub const fn has_several(self) -> bool {
        self.freedoms().len() > 1
    }

    /// What it allows, from the link it hangs on outwards.
    #[must_use]
    pub const fn freedoms(self) -> &'static [Freedom] {
        self.definition().freedoms
    }

    /// What says where all its freedoms together have taken the body, where they are not one after the
    /// other.
    #[must_use]
    pub const fn posture(self) -> Option<Posture> {
        self.definition().posture
    }

    /// The translation per radian of a helical freedom [m/rad].
    #[must_use]
    pub const fn pitch(self) -> Option<Number> {
        match self {
            Self::Screw { pitch } => Some(pitch),
            _ => None,
        }
    }

    /// What the velocities of a joint are called: as the joint is where it has one.
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

    /// What the coordinates of a joint are called, and what each of them is.
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
    /// What its coordinate measures.
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

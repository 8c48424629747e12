//! The joints that a description can have.
//!
//! A shared noun, and the table of all kinds: what is known of one stands in its own file, as a
//! [`Definition`]. A joint is a row of [`Freedom`]s with one coordinate each, one after the other about
//! or along its axis; how bodies move by one of them is said by [`Motion`].

mod continuous;
mod cylindrical;
mod fixed;
mod motion;
mod prismatic;
mod revolute;
mod screw;

pub use motion::Motion;

use crate::number::Number;

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
    /// Nothing.
    Fixed,
}

/// What is known of a kind of joint.
pub struct Definition {
    /// What it is called in every reader.
    pub word: &'static str,
    /// What it allows, from the link it hangs on outwards, each with the name of its coordinate beside
    /// others of the same joint.
    pub freedoms: &'static [(&'static str, Freedom)],
    /// Makes it; a helical freedom asks for the pitch.
    make: fn(Number) -> JointKind,
}

/// A motion with one coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Freedom {
    /// Turn about the axis.
    Turn,
    /// Slide along it.
    Slide,
    /// Do both, in a fixed ratio.
    Helix,
}

/// All kinds, in the order in which messages list them.
pub const ALL: [&Definition; 6] = [
    &revolute::DEFINITION,
    &continuous::DEFINITION,
    &prismatic::DEFINITION,
    &screw::DEFINITION,
    &cylindrical::DEFINITION,
    &fixed::DEFINITION,
];

impl Definition {
    /// Whether a joint of this kind moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        !self.freedoms.is_empty()
    }

    /// A joint of this kind; `pitch` is asked for where there is a helical freedom.
    ///
    /// # Errors
    /// That of `pitch`.
    pub fn with_pitch<E>(&self, pitch: impl FnOnce() -> Result<Number, E>) -> Result<JointKind, E> {
        let helical = |(_, freedom): &(_, Freedom)| *freedom == Freedom::Helix;
        let pitch = if self.freedoms.iter().any(helical) {
            pitch()?
        } else {
            Number::default()
        };
        Ok((self.make)(pitch))
    }
}

impl JointKind {
    const fn definition(self) -> &'static Definition {
        match self {
            Self::Revolute => &revolute::DEFINITION,
            Self::Continuous => &continuous::DEFINITION,
            Self::Prismatic => &prismatic::DEFINITION,
            Self::Screw { .. } => &screw::DEFINITION,
            Self::Cylindrical => &cylindrical::DEFINITION,
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

    /// Whether it has more than one coordinate.
    #[must_use]
    pub const fn has_several(self) -> bool {
        self.freedoms().len() > 1
    }

    /// What it allows, from the link it hangs on outwards.
    #[must_use]
    pub const fn freedoms(self) -> &'static [(&'static str, Freedom)] {
        self.definition().freedoms
    }

    /// The translation per radian of a helical freedom [m/rad].
    #[must_use]
    pub const fn pitch(self) -> Option<Number> {
        match self {
            Self::Screw { pitch } => Some(pitch),
            _ => None,
        }
    }

    /// What the coordinates of a joint are called: as the joint is where it has one.
    pub fn coordinates(self, joint: &str) -> impl Iterator<Item = (String, Freedom)> {
        let freedoms = self.freedoms();
        freedoms.iter().map(move |&(name, freedom)| {
            let name = match freedoms {
                [_] => joint.to_owned(),
                _ => format!("{joint}.{name}"),
            };
            (name, freedom)
        })
    }
}

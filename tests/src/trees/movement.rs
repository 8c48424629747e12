//! The source of a joint's motion: its own coordinates, those of a mimicked joint, or none.
//!
//! In: a [`Robot`], and one of its bodies. Out: the joint whose coordinate moves it, at the end of a chain of mimic
//! joints, with factor and offset in 256 bits.

use crate::big::Big;

use super::robot::{Body, Robot};

/// The source of a joint's motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Movement {
    /// Its own coordinates.
    Own,
    /// The coordinate of the mimicked joint, by factor · coordinate + offset.
    As {
        /// The number of the mimicked joint.
        mimicked: usize,
        /// The factor.
        factor: Big,
        /// The offset.
        offset: Big,
    },
    /// None: it is locked at this displacement.
    Held(Big),
}

impl Movement {
    /// The source of motion of a joint.
    #[must_use]
    pub fn of(robot: &Robot, body: &Body) -> Self {
        let (mut first, mut factor, mut offset) = (body, Big::one(), Big::zero());
        while let Some((mimicked, mimic)) = robot.mimicked(first) {
            offset = offset + &factor * mimic.offset.number();
            factor = factor * mimic.multiplier.number();
            first = mimicked;
        }
        if robot.is_free(first) {
            return match first.id {
                id if id == body.id => Self::Own,
                _ if factor == Big::zero() => Self::Held(offset),
                mimicked => Self::As {
                    mimicked,
                    factor,
                    offset,
                },
            };
        }
        // A joint that is not modelled, or not on the path, is at its locked position, or at zero.
        Self::Held(factor * robot.locked(first).unwrap_or_else(Big::zero) + offset)
    }

    /// True if the joint moves.
    #[must_use]
    pub const fn is_motion(&self) -> bool {
        !matches!(self, Self::Held(_))
    }
}

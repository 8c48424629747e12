//! What moves a joint: itself, another, or nothing.
//!
//! In: a [`Robot`], and one of its bodies. Out: the joint whose coordinate moves it, through all that stand
//! between them, at 256 bits. It knows neither screws nor matrices.

use crate::big::Big;

use super::robot::{Body, Robot};

/// What moves a joint.
#[derive(Clone, Debug, PartialEq)]
pub enum Movement {
    /// Its own coordinates.
    Own,
    /// That of another, times a factor and from an offset on.
    As {
        /// The number of the other.
        leader: usize,
        /// The factor.
        factor: Big,
        /// The offset.
        offset: Big,
    },
    /// Nothing: it stands there.
    Held(Big),
}

impl Movement {
    /// Of a joint.
    #[must_use]
    pub fn of(robot: &Robot, body: &Body) -> Self {
        let (mut first, mut factor, mut offset) = (body, Big::one(), Big::zero());
        while let Some((leader, mimic)) = robot.leader(first) {
            offset = offset + &factor * mimic.offset.number();
            factor = factor * mimic.multiplier.number();
            first = leader;
        }
        if robot.is_free(first) {
            return match first.id {
                id if id == body.id => Self::Own,
                _ if factor == Big::zero() => Self::Held(offset),
                leader => Self::As {
                    leader,
                    factor,
                    offset,
                },
            };
        }
        // What is not there, or off the path, stands where it is locked, or at zero.
        Self::Held(factor * robot.locked(first).unwrap_or_else(Big::zero) + offset)
    }

    /// Whether it moves.
    #[must_use]
    pub const fn is_motion(&self) -> bool {
        !matches!(self, Self::Held(_))
    }
}

//! Labels: the entry of a matrix of the paper that a value is.
//!
//! In: block, bodies, frame, component. Out: the label as data, and its identifier in generated code, which is made
//! only here.

use std::fmt;

use crate::list::Id;

/// A block of a matrix, or another quantity whose entries have names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Block {
    /// An axis of M: the column with this index.
    Axis(usize),
    /// The origin of M.
    Origin,
    /// ω of W.
    AngularVelocity,
    /// v of W.
    LinearVelocity,
    /// ω̇ of H.
    AngularAcceleration,
    /// a of H.
    LinearAcceleration,
    /// u of L.
    Direction,
    /// b of L.
    Moment,
    /// J, all of it.
    Inertia,
    /// The first moment in J, by the mass of the robot.
    MassCenter,
    /// c of Φ.
    Couple,
    /// f of Φ.
    Force,
    /// A pivot of the mass matrix, or D of an articulated body.
    Pivot,
    /// An entry of L in M = Lᵗ D L.
    Factor,
}

/// The number of a body or a velocity in names, from 1; 0 for the parent of the first body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Numeral(pub usize);

impl Numeral {
    /// The number of the parent of the first body.
    pub const BASE: Self = Self(0);
}

impl<I: Id> From<I> for Numeral {
    fn from(id: I) -> Self {
        Self(id.number())
    }
}

impl fmt::Display for Numeral {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(out)
    }
}

/// The bodies of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LabelledBodies {
    /// A body, alone or with all that it carries.
    Body(Numeral),
    /// A body relative to frame 0.
    FromBase(Numeral),
    /// Frame n relative to a body's frame.
    TipFrom(Numeral),
    /// Row and column.
    Pair(Numeral, Numeral),
}

/// A vector or matrix of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Quantity {
    /// Its letter and part.
    pub block: Block,
    /// Its bodies.
    pub of: LabelledBodies,
    /// The frame of its axes, if the name has one.
    pub frame: Option<Numeral>,
}

/// An entry of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// The number itself.
    Scalar,
    /// An entry of a vector, by its axis.
    Along(usize),
    /// A second moment, by its two axes.
    Second(usize, usize),
    /// The mass of an inertia.
    Mass,
}

/// The entry of a quantity that a value is, or the opposite of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Label {
    /// The quantity.
    pub quantity: Quantity,
    /// The entry.
    pub component: Component,
    /// True if the value is the opposite of the entry.
    pub negative: bool,
}

impl Block {
    /// The quantity of a block.
    #[must_use]
    pub const fn of(self, of: LabelledBodies) -> Quantity {
        Quantity {
            block: self,
            of,
            frame: None,
        }
    }
}

impl Quantity {
    /// The same in the axes of a frame.
    #[must_use]
    pub const fn seen_in(self, frame: Numeral) -> Self {
        Self {
            frame: Some(frame),
            ..self
        }
    }

    /// An entry.
    #[must_use]
    pub const fn entry(self, component: Component) -> Label {
        Label {
            quantity: self,
            component,
            negative: false,
        }
    }
}

impl Label {
    /// The label of the value with the other sign.
    #[must_use]
    pub const fn opposite(self) -> Self {
        Self {
            negative: !self.negative,
            ..self
        }
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// The identifier, not necessarily unique in a program: `w_0_3_in_3_x`, `minus_d_2`.
impl fmt::Display for Label {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Quantity { block, of, frame } = self.quantity;
        let (letter, part) = match block {
            Block::Axis(k) => ("m", AXES[k]),
            Block::Origin => ("m", "t"),
            Block::AngularVelocity => ("w", ""),
            Block::LinearVelocity => ("w", "v"),
            Block::AngularAcceleration => ("wd", ""),
            Block::LinearAcceleration => ("h", ""),
            Block::Direction => ("l", "u"),
            Block::Moment => ("l", "b"),
            Block::Inertia => ("j", ""),
            Block::MassCenter => ("c", ""),
            Block::Couple => ("phi", "c"),
            Block::Force => ("phi", "f"),
            Block::Pivot => ("d", ""),
            Block::Factor => ("l", ""),
        };
        let minus = if self.negative { "minus_" } else { "" };
        write!(out, "{minus}{letter}")?;
        match of {
            LabelledBodies::Body(i) => write!(out, "_{i}")?,
            LabelledBodies::FromBase(i) => write!(out, "_0_{i}")?,
            LabelledBodies::TipFrom(i) => write!(out, "_{i}_n")?,
            LabelledBodies::Pair(k, i) => write!(out, "_{k}_{i}")?,
        }
        if let Some(frame) = frame {
            write!(out, "_in_{frame}")?;
        }
        match self.component {
            Component::Scalar => Ok(()),
            Component::Along(k) => write!(out, "_{part}{}", AXES[k]),
            Component::Second(i, k) => write!(out, "_{}{}", AXES[i], AXES[k]),
            Component::Mass => out.write_str("_m"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Block, Component, LabelledBodies, Numeral};

    #[test]
    fn identifiers_say_letter_bodies_frame_and_entry() {
        let w = Block::LinearVelocity
            .of(LabelledBodies::FromBase(Numeral(12)))
            .seen_in(Numeral(3));
        let j = Block::Inertia
            .of(LabelledBodies::Body(Numeral(2)))
            .seen_in(Numeral(0));
        for (label, name) in [
            (w.entry(Component::Along(1)), "w_0_12_in_3_vy"),
            (
                w.entry(Component::Along(1)).opposite(),
                "minus_w_0_12_in_3_vy",
            ),
            (
                Block::Axis(2)
                    .of(LabelledBodies::TipFrom(Numeral(4)))
                    .entry(Component::Along(0)),
                "m_4_n_zx",
            ),
            (j.entry(Component::Second(0, 1)), "j_2_in_0_xy"),
            (j.entry(Component::Mass), "j_2_in_0_m"),
            (
                Block::Pivot
                    .of(LabelledBodies::Body(Numeral(7)))
                    .entry(Component::Scalar),
                "d_7",
            ),
            (
                Block::Factor
                    .of(LabelledBodies::Pair(Numeral(3), Numeral(1)))
                    .entry(Component::Scalar),
                "l_3_1",
            ),
        ] {
            assert_eq!(label.to_string(), name);
            assert_eq!(label.opposite().opposite(), label);
        }
    }
}

//! Motion of a body by one coordinate, about or along an axis of its own frame: its screw, and the part of an inertia
//! that it leaves unchanged.

use super::Movement;
use crate::expression::{Expr, Term};
use crate::matrix::{Inertia, Screw, Symmetric, Vector};
use crate::space::Kind;

/// Motion of a body relative to its parent.
#[derive(Clone, Copy, Debug)]
pub enum Motion {
    /// Rotation about the axis.
    Revolute,
    /// Translation along it.
    Prismatic,
    /// Both, with a translation per angle [m/rad].
    Screw(Expr),
}

impl Motion {
    /// The motion of a degree of freedom; `pitch` is called for a screw.
    #[must_use]
    pub fn of(movement: Movement, pitch: impl FnOnce() -> Expr) -> Self {
        match movement {
            Movement::Rotation => Self::Revolute,
            Movement::Translation => Self::Prismatic,
            Movement::Helix => Self::Screw(pitch()),
        }
    }

    /// Kind of its coordinate.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Prismatic => Kind::Translation,
            Self::Revolute | Self::Screw(_) => Kind::Rotation,
        }
    }

    /// True if the body keeps its orientation.
    #[must_use]
    pub const fn translates(self) -> bool {
        matches!(self, Self::Prismatic)
    }

    /// Translation along the axis at a coordinate, if there is one.
    pub fn translation<'g>(self, q: impl FnOnce() -> Term<'g>) -> Option<Term<'g>> {
        match self {
            Self::Revolute => None,
            Self::Prismatic => Some(q()),
            Self::Screw(pitch) => {
                let q = q();
                Some(q.graph().term(pitch) * q)
            }
        }
    }

    /// L about or along a unit axis through the origin.
    #[must_use]
    pub fn screw(self, axis: Vector<Term<'_>>) -> Screw<Term<'_>> {
        let graph = axis.x().graph();
        let zero = Vector::zero(graph);
        match self {
            Self::Revolute => Screw { u: axis, b: zero },
            Self::Prismatic => Screw { u: zero, b: axis },
            Self::Screw(pitch) => Screw {
                u: axis,
                b: axis * graph.term(pitch),
            },
        }
    }

    /// The part of an inertia that does not change with the coordinate, in the frame of the parent, for the axis z:
    /// * a rotation about z moves no mass that lies on z: m, ∫z, ∫z²;
    /// * a translation along z changes no second moment of a body without mass and first moments;
    /// * a screw does both, so that only ∫z² of such a body remains.
    #[must_use]
    pub fn invariant(self, inertia: Inertia<Term<'_>>) -> Inertia<Term<'_>> {
        let mut part = Inertia::zero(inertia.mass.graph());
        let [_, _, zz, ..] = inertia.second.0;
        let zero = part.mass;
        let on_axis = Symmetric([zero, zero, zz, zero, zero, zero]);
        match self {
            Self::Revolute => {
                part.mass = inertia.mass;
                part.q.0[2] = inertia.q.z();
                part.second = on_axis;
            }
            Self::Prismatic => part.second = inertia.second,
            Self::Screw(_) => part.second = on_axis,
        }
        part
    }
}

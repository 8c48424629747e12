//! How a body moves by one coordinate, about or along an axis of its own frame.
//!
//! In: the axis, or an inertia. Out: the screw of the motion, and the part of an inertia that it leaves as it
//! is.

use super::Movement;
use crate::expression::{Expr, Term};
use crate::matrix::{Inertia, Screw, Symmetric, Vector};
use crate::space::Kind;

/// What a body may do against the one it hangs on.
#[derive(Clone, Copy, Debug)]
pub enum Motion {
    /// Turn about the axis.
    Revolute,
    /// Slide along it.
    Prismatic,
    /// Do both, with a translation per angle [m/rad].
    Screw(Expr),
}

impl Motion {
    /// That of a freedom, where a helical one has this pitch.
    #[must_use]
    pub fn of(movement: Movement, pitch: impl FnOnce() -> Expr) -> Self {
        match movement {
            Movement::Turn => Self::Revolute,
            Movement::Slide => Self::Prismatic,
            Movement::Helix => Self::Screw(pitch()),
        }
    }

    /// What its coordinate measures.
    #[must_use]
    pub const fn kind(self) -> Kind {
        match self {
            Self::Prismatic => Kind::Slide,
            Self::Revolute | Self::Screw(_) => Kind::Turn,
        }
    }

    /// Whether the body keeps its axes.
    #[must_use]
    pub const fn slides(self) -> bool {
        matches!(self, Self::Prismatic)
    }

    /// How far it slides along its axis at a coordinate, where it does.
    pub fn slide<'g>(self, q: impl FnOnce() -> Term<'g>) -> Option<Term<'g>> {
        match self {
            Self::Revolute => None,
            Self::Prismatic => Some(q()),
            Self::Screw(pitch) => {
                let q = q();
                Some(q.graph().term(pitch) * q)
            }
        }
    }

    /// L about or along an axis of length 1 through the origin.
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

    /// The part of an inertia that is the same in every position, seen from the body that carries it, where
    /// the axis is z:
    /// * turning about z moves no mass that lies on z: m, ∫z, ∫z²;
    /// * sliding along z changes no second moment of a body without mass and first moments;
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

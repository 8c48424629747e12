//! Rotation of a body about its z axis: a sum of coordinates, and a constant.
//!
//! In: the bodies and the state. Out: the rotation of each body relative to its parent. If angles are merged, a frame
//! leaves its rotation to its child bodies, if all their axes are parallel to its own, and the last of them applies the
//! sum. A sum of coordinates is rounded to the digits of the largest, which a product of rotations is not: it is used
//! only on request.

use super::state::State;
use crate::chain::BodyId;
use crate::expression::{Graph, Term};
use crate::formulation::Angles;
use crate::layout::{Bodies, Body};
use crate::list::List;

/// A rotation about z.
#[derive(Clone, Copy, Default)]
pub struct AxisRotation<'g> {
    /// The sum of the coordinates; `None` without rotation.
    sum: Option<Term<'g>>,
    /// Sine and cosine of the constant.
    constant: Option<(Term<'g>, Term<'g>)>,
}

impl<'g> AxisRotation<'g> {
    /// A rotation by a coordinate, and by a constant with this sine and cosine.
    pub const fn by(coordinate: Term<'g>, constant: Option<(Term<'g>, Term<'g>)>) -> Self {
        Self {
            sum: Some(coordinate),
            constant,
        }
    }

    /// The inverse rotation.
    pub fn reversed(self) -> Self {
        Self {
            sum: self.sum.map(|sum| -sum),
            constant: self.constant.map(|(sine, cosine)| (-sine, cosine)),
        }
    }

    /// Both rotations, about the same axis.
    pub fn and(self, other: Self) -> Self {
        Self {
            sum: match (self.sum, other.sum) {
                (Some(a), Some(b)) => Some(a + b),
                (a, b) => a.or(b),
            },
            constant: match (self.constant, other.constant) {
                (Some(a), Some(b)) => Some(product(a, b)),
                (a, b) => a.or(b),
            },
        }
    }

    /// Sine and cosine. Adding the constant to the angle would cost less, but lose digits to the rounding of a large
    /// angle.
    pub fn sine_and_cosine(self, graph: &'g Graph) -> (Term<'g>, Term<'g>) {
        match (self.sum.map(Term::sin_cos), self.constant) {
            (Some(angle), Some(constant)) => product(angle, constant),
            (angle, constant) => angle
                .or(constant)
                .unwrap_or_else(|| (graph.constant(0.0), graph.constant(1.0))),
        }
    }
}

/// The rotation of body `k`, including that which the frame of its parent left to it.
pub fn of_body<'g>(
    body: &Body<'g>,
    k: BodyId,
    state: &State<'g>,
    outer: Option<AxisRotation<'g>>,
) -> AxisRotation<'g> {
    let own = if body.rotates_alone() {
        AxisRotation::by(state.q(k), body.offset)
    } else {
        AxisRotation::default()
    };
    // With a rotation of the parent the axes are parallel: only their direction is open.
    let same = body.placement.rotation.0[2][2]
        .value()
        .is_some_and(|cosine| cosine.to_f64() > 0.0);
    match outer {
        Some(outer) if same => outer.and(own),
        Some(outer) => outer.reversed().and(own),
        None => own,
    }
}

/// The rotation that each body's frame leaves to its child bodies, if it does.
pub fn left_to_carried<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    angles: Angles,
    leaves: impl Fn(BodyId) -> bool,
) -> List<BodyId, Option<AxisRotation<'g>>> {
    let mut left = List::filled(None, bodies.bodies.len());
    if angles == Angles::Merged {
        let leaves = |&(k, body): &(BodyId, &Body<'g>)| body.has_own_axis() && leaves(k);
        for (k, body) in bodies.bodies.numbered().filter(leaves) {
            let outer = body.parent.and_then(|parent| left[parent]);
            left[k] = Some(of_body(body, k, state, outer));
        }
    }
    left
}

/// True if the axis of a body's joint is parallel to that of the joint before it.
pub fn is_parallel(body: &Body<'_>) -> bool {
    let axis = body.placement.rotation.column(2);
    body.has_own_axis() && axis.x().is_zero() && axis.y().is_zero()
}

/// Sine and cosine of a sum of two angles.
fn product<'g>(
    (sine, cosine): (Term<'g>, Term<'g>),
    (by_sine, by_cosine): (Term<'g>, Term<'g>),
) -> (Term<'g>, Term<'g>) {
    (
        sine * by_cosine + cosine * by_sine,
        cosine * by_cosine - sine * by_sine,
    )
}

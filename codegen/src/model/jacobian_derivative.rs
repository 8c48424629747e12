//! The derivatives of the geometric Jacobian's columns by the coordinates: the kinematic Hessian.
//!
//! In: the path from the base to a frame. Out: ∂L/∂q for each coordinate and each column, or the power of each against a
//! wrench. A motion along a screw (u, b)
//! turns the screws of all joints outboard, ∂u' = u × u' and ∂b' = u × b', since the reference point at the frame moves
//! with them; it leaves the screws of joints inboard, whose b' follow the reference point, ∂b' = u' × b. So the part of
//! b is symmetric, but between the velocities of one joint, each of which turns the screws of all.

use super::carry::{DisplacedJoint, Path};
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::Square;
use crate::matrix::{Action, Screw, Vector};

/// The six entries of ∂L/∂q, each a matrix with a row for each coordinate and a column for each screw. The screws have
/// the axes of frame 0, and the reference point is at the origin of the frame at the end.
pub fn geometric<'g>(path: &Path<'g>) -> [Square<BodyId, Term<'g>>; 6] {
    let zero = path.end.translation.x().graph().constant(0.0);
    let mut entries = [(); 6].map(|()| Square::filled(zero, path.count));
    for (place, change) in changes(&screws(path)) {
        let change = match change {
            ScrewDerivative::Turned(axis, screw) => Screw {
                u: axis.cross(screw.u),
                b: axis.cross(screw.b),
            },
            ScrewDerivative::Followed(axis, b) => Screw {
                u: Vector::zero(zero.graph()),
                b: axis.cross(b),
            },
        };
        for (entry, matrix) in change.entries().into_iter().zip(&mut entries) {
            matrix[place] = entry;
        }
    }
    entries
}

/// The powers of ∂L/∂q against a wrench at the frame's origin in the axes of frame 0, with a row for each screw and a
/// column for each coordinate: c · (u × u') + f · (u × b') = u · (u' × c + b' × f).
pub fn contracted<'g>(path: &Path<'g>, wrench: Action<Term<'g>>) -> Square<BodyId, Term<'g>> {
    let zero = path.end.translation.x().graph().constant(0.0);
    let mut powers = Square::filled(zero, path.count);
    for ((coordinate, screw), change) in changes(&screws(path)) {
        powers[(screw, coordinate)] = match change {
            ScrewDerivative::Turned(axis, screw) => {
                axis.dot(screw.u.cross(wrench.c) + screw.b.cross(wrench.f))
            }
            ScrewDerivative::Followed(axis, b) => axis.dot(b.cross(wrench.f)),
        };
    }
    powers
}

/// The derivative of a screw by a coordinate.
enum ScrewDerivative<'g> {
    /// A rotation about an axis that carries the screw and its reference point.
    Turned(Vector<Term<'g>>, Screw<Term<'g>>),
    /// A motion b of the reference point alone, of a screw with this axis.
    Followed(Vector<Term<'g>>, Vector<Term<'g>>),
}

type Placed<'g> = (DisplacedJoint<'g>, Screw<Term<'g>>);

/// The joints, each with its screw in the axes of frame 0 and with the reference point at the frame.
fn screws<'g>(path: &Path<'g>) -> Vec<Placed<'g>> {
    let placed = path.outwards_from_end().into_iter();
    placed
        .map(|(joint, pose)| (joint, joint.screw.change_frame(pose)))
        .collect()
}

/// The derivatives that are not zero by structure, each with its coordinate and its screw.
fn changes<'g>(screws: &[Placed<'g>]) -> Vec<((BodyId, BodyId), ScrewDerivative<'g>)> {
    let mut changes = Vec::new();
    for (k, (joint, screw)) in screws.iter().enumerate() {
        // Those of the same joint that are further outboard have its displacement.
        let own = screws[k + 1..]
            .iter()
            .take_while(|(next, _)| next.taken)
            .count();
        // Its own axis stays.
        let itself = ScrewDerivative::Followed(screw.u, screw.b);
        changes.push(((joint.body, joint.body), itself));
        for (further, (other, outer)) in screws[k + 1..].iter().enumerate() {
            changes.push((
                (joint.body, other.body),
                ScrewDerivative::Turned(screw.u, *outer),
            ));
            let change = if further < own {
                ScrewDerivative::Turned(outer.u, *screw)
            } else {
                ScrewDerivative::Followed(screw.u, outer.b)
            };
            changes.push(((other.body, joint.body), change));
        }
    }
    changes
}

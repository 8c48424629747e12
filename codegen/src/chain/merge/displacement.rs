//! Directions of a joint's motions, and the pose across a locked joint.
//!
//! In: its axes, as scalars. Out: a direction in the frame of the moved body, and the pose of the frame after the joint
//! in the frame before it.

use crate::expression::{Graph, Term};
use crate::joint::{Along, DegreeOfFreedom, JointKind, Movement};
use crate::matrix::{Pose, Rotation, Vector};

/// The direction of a degree of freedom, in the frame of the moved body.
pub(super) fn direction<'g>(
    graph: &'g Graph,
    degree_of_freedom: DegreeOfFreedom,
    [axis, second]: [Vector<Term<'g>>; 2],
) -> Vector<Term<'g>> {
    match degree_of_freedom.along {
        Along::Axis => axis,
        Along::Second => second,
        Along::Frame(k) => {
            let mut entries = [0.0; 3];
            entries[k] = 1.0;
            Vector::constant(graph, entries)
        }
    }
}

/// The displacement of a joint that is held at a coordinate, or with all coordinates zero.
pub(super) fn held_at<'g>(
    graph: &'g Graph,
    kind: JointKind,
    axes: [Vector<Term<'g>>; 2],
    q: Term<'g>,
) -> Pose<Term<'g>> {
    let rotation = |axis: Vector<Term<'g>>| {
        // R = 1 + u̲ sin φ + u̲² (1 − cos φ)
        let (sine, cosine) = q.sin_cos();
        let versine = graph.constant(1.0) - cosine;
        let [x, y, z] = axis.0;
        let outer = |a: Term<'g>, b: Term<'g>| a * b * versine;
        Pose::rotation(Rotation([
            [
                cosine + outer(x, x),
                outer(x, y) - z * sine,
                outer(x, z) + y * sine,
            ],
            [
                outer(x, y) + z * sine,
                cosine + outer(y, y),
                outer(y, z) - x * sine,
            ],
            [
                outer(x, z) - y * sine,
                outer(y, z) + x * sine,
                cosine + outer(z, z),
            ],
        ]))
    };
    let displacement = |degree_of_freedom: &DegreeOfFreedom| {
        let axis = direction(graph, *degree_of_freedom, axes);
        match degree_of_freedom.movement {
            Movement::Rotation => rotation(axis),
            Movement::Translation => Pose::translation(axis * q),
            Movement::Helix => {
                let pitch = kind.pitch().unwrap_or_default();
                Pose {
                    translation: axis * (q * graph.number(pitch.exact())),
                    ..rotation(axis)
                }
            }
        }
    };
    let degrees_of_freedom = kind.degrees_of_freedom().iter();
    degrees_of_freedom
        .map(displacement)
        .fold(Pose::identity(graph), |pose, next| pose * next)
}

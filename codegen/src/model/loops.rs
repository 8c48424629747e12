//! Loops: entries of M of frame B in frame A, their velocities and their accelerations.
//!
//! In: the bodies and a state. Out: a residual for each row of each loop; for each row and velocity, the derivative
//! of the residual; and for each row its acceleration at q̈ = 0. All matrices are in frame A of the loop, so that
//! only the joints between A and B enter, wherever the loop is in the robot: M, the product of the matrices along the
//! loop, W and H by the composition rules (paper, eqs. 10 and 11), and W M and H M, the first and the second
//! derivative of M.

use super::carry::{self, DisplacedJoint};
use super::state::State;
use super::{Algorithm, Scene};
use crate::chain::BodyId;
use crate::closure::ResidualKind;
use crate::expression::Term;
use crate::layout::{Bodies, Closed};
use crate::list::List;
use crate::matrix::{Acceleration, Pose, Screw, Vector, Velocity};
use crate::space::VelocityId;

/// Pose and motion of frame B in frame A.
struct Seen<'g> {
    /// M of B.
    pose: Pose<Term<'g>>,
    /// The joints between A and B, in the order of the path, with the bodies of one joint together: each body, and
    /// the screw of B for its velocity.
    joints: Vec<Vec<(BodyId, Screw<Term<'g>>)>>,
}

/// The residuals of all rows.
pub(crate) fn residuals<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    each(scene, |closed, seen| {
        let rows = closed.rows.iter();
        rows.map(|&row| residual(row, closed.size, seen.pose))
            .collect()
    })
}

/// For each row, its derivative by each velocity.
pub(crate) fn jacobian<'g>(scene: &Scene<'_, 'g>) -> Vec<List<VelocityId, Term<'g>>> {
    each(scene, |closed, seen| {
        let rows = closed.rows.iter();
        rows.map(|&row| {
            let mut entries = List::filled(scene.state.zero(), scene.bodies.bodies.len());
            for &(body, screw) in seen.joints.iter().flatten() {
                entries[body] = rate(row, closed.size, seen.pose, screw);
            }
            scene.forces(&entries)
        })
        .collect()
    })
}

/// The acceleration of each row at q̈ = 0.
pub(crate) fn bias<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    each(scene, |closed, seen| {
        let (w, h) = motion(&seen, &scene.state);
        let rows = closed.rows.iter();
        rows.map(|&row| second_rate(row, closed.size, seen.pose, w, h))
            .collect()
    })
}

/// For each row the first row of its loop with the same unit, which shares its threshold of zero.
pub(crate) fn alike(bodies: &Bodies<'_>) -> Vec<usize> {
    let mut first = Vec::new();
    for closed in &bodies.loops {
        let start = first.len();
        for row in &closed.rows {
            let same = |other: &ResidualKind| other.kind() == row.kind();
            let place = closed.rows.iter().position(same);
            first.push(start + place.expect("a row is like itself"));
        }
    }
    first
}

fn each<'g, T>(scene: &Scene<'_, 'g>, of: impl Fn(&Closed<'g>, Seen<'g>) -> Vec<T>) -> Vec<T> {
    let loops = scene.bodies.loops.iter();
    loops
        .flat_map(|closed| {
            let seen = seen(scene.bodies, closed, &scene.state, scene.algorithm);
            of(closed, seen)
        })
        .collect()
}

/// Frame B of a loop in frame A: from A inwards to the body that carries both, and out to B.
fn seen<'g>(
    bodies: &Bodies<'g>,
    closed: &Closed<'g>,
    state: &State<'g>,
    algorithm: Algorithm,
) -> Seen<'g> {
    let both = carry::carrier(bodies, closed.frames);
    let [a, b] = closed
        .frames
        .map(|frame| carry::path_beyond(bodies, both, frame, state, algorithm));
    let together = |_: &DisplacedJoint<'g>, next: &DisplacedJoint<'g>| next.taken;
    let mut pose = a.end.inverse();
    let mut joints = Vec::new();
    let mut pass = |joints_of_one: &[DisplacedJoint<'g>], pose: Pose<Term<'g>>, away: bool| {
        let seen = joints_of_one.iter().map(|joint| {
            let screw = joint.screw.change_frame(pose);
            let screw = if away {
                screw
            } else {
                Screw {
                    u: -screw.u,
                    b: -screw.b,
                }
            };
            (joint.body, screw)
        });
        joints.push(seen.collect());
    };
    for of_one in a.joints.chunk_by(together).rev() {
        pass(of_one, pose, false);
        let first = &of_one[0];
        pose = pose * first.displacement().inverse() * first.placement.inverse();
    }
    for of_one in b.joints.chunk_by(together) {
        let first = &of_one[0];
        pose = pose * first.placement * first.displacement();
        pass(of_one, pose, true);
    }
    Seen {
        pose: pose * b.end,
        joints,
    }
}

/// W and H of B relative to A at q̈ = 0: H = W² for each joint alone.
fn motion<'g>(seen: &Seen<'g>, state: &State<'g>) -> (Velocity<Term<'g>>, Acceleration<Term<'g>>) {
    let graph = state.graph;
    let mut w = Velocity::zero(graph);
    let mut h = Acceleration::linear(Vector::zero(graph));
    for of_one in &seen.joints {
        let own = of_one
            .iter()
            .map(|&(body, screw)| Velocity::of_screw(screw, state.qd(body)));
        let own = own.fold(Velocity::zero(graph), |sum, own| sum + own);
        // Of 2 W W the skew part of the rotation is ω × ω'; the rest is in the square of the sum.
        h = Acceleration {
            omega: h.omega + own.omega,
            omega_dot: h.omega_dot + w.omega.cross(own.omega),
            a: h.a + (w.omega + w.omega + own.omega).cross(own.v),
        };
        w = w + own;
    }
    (w, h)
}

fn residual<'g>(row: ResidualKind, size: Term<'g>, pose: Pose<Term<'g>>) -> Term<'g> {
    let (r, t) = (pose.rotation.0, pose.translation);
    match row {
        ResidualKind::Along(k) => t.0[k],
        ResidualKind::Product(i, j) => r[i][j],
        ResidualKind::Inclined => r[2][2] - size,
        ResidualKind::Distance => (t.dot(t) - size * size) * half_of_reciprocal(size),
    }
}

/// The derivative of a row if B moves along a screw: its entry of L M.
fn rate<'g>(
    row: ResidualKind,
    size: Term<'g>,
    pose: Pose<Term<'g>>,
    screw: Screw<Term<'g>>,
) -> Term<'g> {
    let t = pose.translation;
    let rotated = |i: usize, j: usize| screw.u.cross(pose.rotation.column(j)).0[i];
    match row {
        ResidualKind::Along(k) => (screw.u.cross(t) + screw.b).0[k],
        ResidualKind::Product(i, j) => rotated(i, j),
        ResidualKind::Inclined => rotated(2, 2),
        ResidualKind::Distance => {
            let half = half_of_reciprocal(size);
            t.dot(screw.b) * (half + half)
        }
    }
}

/// The acceleration of a row: its entry of H M.
fn second_rate<'g>(
    row: ResidualKind,
    size: Term<'g>,
    pose: Pose<Term<'g>>,
    w: Velocity<Term<'g>>,
    h: Acceleration<Term<'g>>,
) -> Term<'g> {
    let t = pose.translation;
    let accelerated = |i: usize, j: usize| Vector(h.g()[i]).dot(pose.rotation.column(j));
    match row {
        ResidualKind::Along(k) => Vector(h.g()[k]).dot(t) + h.a.0[k],
        ResidualKind::Product(i, j) => accelerated(i, j),
        ResidualKind::Inclined => accelerated(2, 2),
        ResidualKind::Distance => {
            let half = half_of_reciprocal(size);
            let velocity = w.omega.cross(t) + w.v;
            (t.dot(h.point(t)) + velocity.dot(velocity)) * (half + half)
        }
    }
}

fn half_of_reciprocal(size: Term<'_>) -> Term<'_> {
    size.graph().constant(0.5) / size
}

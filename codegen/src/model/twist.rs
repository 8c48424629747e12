//! W₀,ₕ₍₀₎ and H₀,ₕ₍₀₎, by the composition rules (paper, eqs. 10 and 11): passed inwards from link to link, so that no
//! pose is needed; or, with matrices in frame 0, composed outwards, so that parallel axes, which are most often at the
//! base, meet in the sums.

use super::carry::{DisplacedJoint, Path};
use super::newton_euler::{BodyMotion, beyond};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::{LabelledBodies, Term};
use crate::formulation::Frame;
use crate::matrix::{Acceleration, Pose, Vector, Velocity};

/// W of the frame at the end of a path: ω, v₀.
pub fn velocity<'g>(path: &Path<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let own = |joint: &DisplacedJoint<'g>| Velocity::of_screw(joint.screw, state.qd(joint.body));
    let (rest, joints) = (Velocity::zero(state.graph), path.joints.iter());
    let w = match path.frame {
        Frame::Base => joints.fold(rest, |w, joint| w + own(joint)),
        Frame::Link => joints.rev().fold(rest, |w, joint| {
            let w = joint.motion_inboard(own(joint) + w);
            let index = joint.outer_frame_number();
            w.label(LabelledBodies::TipFrom(index), index);
            w
        }),
    };
    [w.omega.0, w.v.0].concat()
}

/// H of the frame at the end of a path, where `second` is q̈ of a joint; by rows of (G, a₀).
pub fn acceleration<'g>(
    path: &Path<'g>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
) -> Vec<Term<'g>> {
    let rest = Acceleration::linear(Vector::zero(state.graph));
    let h = match path.frame {
        Frame::Base => {
            let motion = path
                .joints
                .iter()
                .fold(BodyMotion::still(rest), |outer, joint| {
                    beyond(outer, joint, state.qd(joint.body), second(joint.body))
                });
            motion.h
        }
        Frame::Link => inwards(path, state, second, rest),
    };
    h.entries().to_vec()
}

/// H of the frame at the end of a path, by rows of (G, a₀), from the accelerations of the dynamics, in which the base
/// accelerates against gravity: both then share the operations.
pub fn acceleration_with_dynamics<'g>(
    path: &Path<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
) -> Vec<Term<'g>> {
    let base = BodyMotion::still(Acceleration::linear(-gravity));
    let motion = path.joints.iter().fold(base, |outer, joint| {
        beyond(outer, joint, state.qd(joint.body), second(joint.body))
    });
    let identity = || Pose::identity(state.graph);
    let pose = path
        .outwards()
        .last()
        .map_or_else(identity, |&(_, pose)| pose);
    let mut h = inboard(motion.h, pose);
    h.a = h.a + gravity;
    h.entries().to_vec()
}

/// H of the frame at the end of a path, from there to the base.
fn inwards<'g>(
    path: &Path<'g>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
    rest: Acceleration<Term<'g>>,
) -> Acceleration<Term<'g>> {
    let (mut w, mut h) = (Velocity::zero(state.graph), rest);
    // All bodies of a joint with several velocities have the frame of the last: W of the joint is their sum.
    for together in path.joints.chunk_by(|_, next| next.taken).rev() {
        let mut own = together.iter().map(|joint| {
            let (rate, second) = (state.qd(joint.body), second(joint.body));
            let (u, b) = (joint.screw.u * second, joint.screw.b * second);
            (Velocity::of_screw(joint.screw, rate), u, b)
        });
        let first = own.next().expect("chunks are not empty");
        let (own, u, b) = own.fold(first, |(sum, u, b), (own, next_u, next_b)| {
            (sum + own, u + next_u, b + next_b)
        });
        // Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ by its parts: the skew part of 2 W W is ω×ω', the rest is in
        // the square of the sum.
        let two = state.graph.constant(2.0);
        h = Acceleration {
            omega: own.omega + h.omega,
            omega_dot: u + h.omega_dot + own.omega.cross(w.omega),
            a: b + own.omega.cross(own.v) + h.a + own.omega.cross(w.v) * two,
        };
        w = own + w;
        let joint = &together[0];
        h = inboard(inboard(h, joint.displacement()), joint.placement);
        w = joint.motion_inboard(w);
    }
    h
}

/// M H M⁻¹, with G computed before the rotation, where it is sparser.
fn inboard<'g>(h: Acceleration<Term<'g>>, pose: Pose<Term<'g>>) -> Acceleration<Term<'g>> {
    let pole = -(pose.rotation.transposed() * pose.translation);
    h.move_pole(pole).rotate(pose.rotation)
}

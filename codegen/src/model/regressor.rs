//! Regressors: torques and energies as linear functions of the inertial parameters of each link and of armature, damping
//! and friction, τ = Y π.
//!
//! In: the joints, the frames of the links, and the motion. Out: Y, or λᵗ Y for some velocities λ. Φ = skew\[H J\] is
//! linear in J, and the power of each of its parts along L, or along the motion at λ, is computed in the frame of the
//! link: L is passed outwards, one screw a joint, instead of ten wrenches inwards. ½ Tr(W J Wᵗ) and −Tr(H_g J) are
//! linear in J too.

use super::carry::{DisplacedJoint, Joints};
use super::gradient::Lambda;
use super::moving;
use super::newton_euler::{BodyMotion, beyond};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Acceleration, Pose, Vector, Velocity};

/// Number of inertial parameters of a link.
pub const PARAMETERS: usize = 10;

/// The motion of a link, as the powers of its inertial parameters need it.
pub struct LinkMotion<'g> {
    /// The pose of the link's frame in its body's.
    pose: Pose<Term<'g>>,
    /// G, in the link's frame.
    g: [[Term<'g>; 3]; 3],
    /// The differences of its diagonal, in each of which one square of ω cancels: ω_y² − ω_x², ω_x² − ω_z² and
    /// ω_z² − ω_y².
    differences: [Term<'g>; 3],
    /// The acceleration of the frame's origin.
    a: Vector<Term<'g>>,
}

impl<'g> LinkMotion<'g> {
    /// The motion of a link on a body with the given H.
    fn of(pose: Pose<Term<'g>>, h: Acceleration<Term<'g>>) -> Self {
        let h = h.move_pole(pose.translation);
        let h = h.rotate(pose.rotation.transposed());
        let g = h.g();
        let [xx, yy, zz] = h.omega.0.map(|entry| entry * entry);
        Self {
            pose,
            g,
            differences: [yy - xx, xx - zz, zz - yy],
            a: h.a,
        }
    }
}

/// The motion of each body that is a link, at the given q̈.
pub fn motions<'g>(
    joints: &Joints<'g>,
    links: &List<BodyId, Option<Pose<Term<'g>>>>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
) -> List<BodyId, Option<LinkMotion<'g>>> {
    let mut all = List::new();
    for (k, joint) in joints.numbered() {
        all.push(moved(&all, joint, gravity, state, second(k)));
    }
    let each = all.iter().zip(links);
    each.map(|(moving, link)| Some(LinkMotion::of((*link)?, moving.h)))
        .collect()
}

/// The motion of a body, after those inboard of it.
fn moved<'g>(
    all: &List<BodyId, BodyMotion<'g>>,
    joint: &DisplacedJoint<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    second: Term<'g>,
) -> BodyMotion<'g> {
    let base = BodyMotion::still(Acceleration::linear(-gravity));
    let outer = joint.parent.map_or(base, |parent| all[parent]);
    let moving = beyond(outer, joint, state.qd(joint.body), second);
    let (index, frame) = joint.numbers();
    moving.h.label(index, frame);
    moving
}

/// The columns of Y, one after the other, over the torques of each body: ten for each body that is a link, whose frame
/// has a pose in the body's.
pub fn regressor<'g>(
    joints: &Joints<'g>,
    links: &List<BodyId, Option<Pose<Term<'g>>>>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
) -> Vec<List<BodyId, Term<'g>>> {
    let mut columns = Vec::new();
    let mut all = List::new();
    // The motion of a body at a unit velocity of each joint inboard of it, in its frame.
    let mut motions: List<BodyId, Vec<(BodyId, Velocity<Term<'g>>)>> = List::new();
    for (k, joint) in joints.numbered() {
        all.push(moved(&all, joint, gravity, state, second(k)));
        let inboard = joint.parent.map_or(&[][..], |parent| &motions[parent]);
        let inboard = inboard
            .iter()
            .map(|&(row, motion)| (row, joint.motion_outboard(motion)));
        let own = Velocity {
            omega: joint.screw.u,
            v: joint.screw.b,
        };
        let moved: Vec<_> = inboard.chain([(k, own)]).collect();
        if let Some(pose) = links[k] {
            let link = LinkMotion::of(pose, all[k].h);
            let mut own = vec![List::filled(state.zero(), joints.len()); PARAMETERS];
            for &(row, motion) in &moved {
                for (column, power) in own.iter_mut().zip(powers(motion, &link)) {
                    column[row] = power;
                }
            }
            columns.extend(own);
        }
        motions.push(moved);
    }
    columns
}

/// λᵗ Y of the inertial parameters, for velocities λ of the bodies: the power of each part of Φ along the motion of its
/// link.
pub fn along<'g>(
    joints: &Joints<'g>,
    links: &List<BodyId, Option<LinkMotion<'g>>>,
    state: &State<'g>,
    weights: &List<BodyId, Term<'g>>,
) -> Vec<Term<'g>> {
    let lambda = Lambda::of(joints, state, weights);
    let links = links.iter().zip(&lambda.bodies);
    let powers = links.filter_map(|(link, &motion)| Some(powers(motion, link.as_ref()?)));
    powers.flatten().collect()
}

/// The columns of armature, damping and friction, three for each joint: q̈, q̇ and its sign.
pub fn of_actuators<'g>(
    joints: &Joints<'g>,
    state: &State<'g>,
    second: impl Fn(BodyId) -> Term<'g>,
) -> Vec<List<BodyId, Term<'g>>> {
    let of_each = joints.ids().flat_map(|k| {
        let rate = state.qd(k);
        [second(k), rate, rate.sign()].map(|entry| {
            let mut column = List::filled(state.zero(), joints.len());
            column[k] = entry;
            column
        })
    });
    of_each.collect()
}

/// The kinetic energy of each parameter of the links at 1.
pub fn kinetic_energy<'g>(
    joints: &Joints<'g>,
    links: &List<BodyId, Option<Pose<Term<'g>>>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    let mut velocities: List<BodyId, Velocity<Term<'g>>> = List::new();
    let mut energies = Vec::new();
    for (k, joint) in joints.numbered() {
        let outer = joint.parent.map(|parent| velocities[parent]);
        let outer = outer.unwrap_or_else(|| Velocity::zero(state.graph));
        let w = moving::beyond(outer, joint, state.qd(k));
        if let Some(link) = links[k] {
            energies.extend(kinetic_energies(w.seen_from(link)));
        }
        velocities.push(w);
    }
    energies
}

/// The kinetic energy of armature, damping and friction at 1, three for each joint: ½ q̇² of the first.
pub fn kinetic_energy_of_actuators<'g>(joints: &Joints<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let of_each = joints.ids().flat_map(|k| {
        let rate = state.qd(k);
        [
            state.constant(0.5) * (rate * rate),
            state.zero(),
            state.zero(),
        ]
    });
    of_each.collect()
}

/// The potential energy of each parameter of the links at 1: gravity along the position of a link for its mass, along
/// its axes for first moments, and nothing for second moments.
pub fn potential_energy<'g>(
    joints: &Joints<'g>,
    links: &List<BodyId, Option<Pose<Term<'g>>>>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    // Gravity in the axes of each body, and its potential at the body's origin.
    let mut all: List<BodyId, (Vector<Term<'g>>, Term<'g>)> = List::new();
    let mut energies = Vec::new();
    for (k, joint) in joints.numbered() {
        let base = (gravity, state.zero());
        let (outer, height) = joint.parent.map_or(base, |parent| all[parent]);
        let before = joint.placement.rotation.transposed() * outer;
        let own = joint.vector_outboard(outer);
        let step = joint.placement.translation.dot(outer) + joint.offset().dot(before);
        let here = height - step;
        if let Some(link) = links[k] {
            let [x, y, z] = (link.rotation.transposed() * own).0;
            energies.push(here - link.translation.dot(own));
            energies.extend([-x, -y, -z]);
            energies.extend([state.zero(); PARAMETERS - 4]);
        }
        all.push((own, here));
    }
    energies
}

/// ½ Tr(W J Wᵗ) for a J with one entry 1, and its mirror image, in the order of [`powers`].
fn kinetic_energies(w: Velocity<Term<'_>>) -> [Term<'_>; PARAMETERS] {
    let (omega, v) = (w.omega, w.v);
    let half = omega.x().graph().constant(0.5);
    let [x, y, z] = omega.0;
    let [xx, yy, zz] = omega.0.map(|entry| entry * entry);
    let [qx, qy, qz] = v.cross(omega).0;
    [
        half * v.dot(v),
        qx,
        qy,
        qz,
        half * (yy + zz),
        -(x * y),
        -(x * z),
        half * (xx + zz),
        -(y * z),
        half * (xx + yy),
    ]
}

/// L ⊗ skew\[H J\] for a J with one entry 1, and its mirror image: m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz,
/// J_zz. L is that of the link's body.
fn powers<'g>(l: Velocity<Term<'g>>, link: &LinkMotion<'g>) -> [Term<'g>; PARAMETERS] {
    let LinkMotion {
        pose,
        g,
        differences: [yx, xz, zy],
        a,
    } = *link;
    let l = l.seen_from(pose);
    let column = |k: usize| Vector(g.map(|row| row[k]));
    let [[_, gxy, gxz], [gyx, _, gyz], [gzx, gzy, _]] = g;
    let (u, b) = (l.omega, l.v);
    let [ux, uy, uz] = u.0;
    let lever = a.cross(u).0;
    let first = |k: usize| column(k).dot(b) + lever[k];
    [
        a.dot(b),
        first(0),
        first(1),
        first(2),
        uz * gyx - uy * gzx,
        ux * gzx - uy * gzy + uz * yx,
        uz * gyz - ux * gyx + uy * xz,
        ux * gzy - uz * gxy,
        uy * gxy - uz * gxz + ux * zy,
        uy * gxz - ux * gyz,
    ]
}

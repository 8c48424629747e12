//! Which frame each body gets: anywhere along its joint's axis and at any angle about it (structure
//! rule 6).
//!
//! In: a [`Chain`] and a [`Layout`]. Out: [`Bodies`] whose joints all move about or along z, placed
//! so that as many entries of the placements as possible are 0 or 1. It never decides which layout
//! is best: that is counted, function by function.

use super::{Chain, Motion, regroup};
use crate::expression::{Double, Graph, Term};
use crate::matrix::{Inertia, Pose, Rotation, Symmetric, Vector};

/// The bodies of a chain with their frames.
#[derive(Clone, Debug)]
pub struct Bodies<'g> {
    /// In the order of q, parents before children.
    pub bodies: Vec<Body<'g>>,
    /// The frames asked for: the joint whose body carries it, and M from that body to it.
    pub frames: Vec<(Option<usize>, Pose<Term<'g>>)>,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Term<'g>>,
}

/// A body whose joint moves it about or along the z axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Body<'g> {
    /// The body it hangs on; none for the fixed base.
    pub parent: Option<usize>,
    /// What its joint lets it do.
    pub motion: Motion,
    /// M from the parent's frame to this one at q + offset = 0.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of what is added to q to give the angle about z.
    pub offset: Option<(Term<'g>, Term<'g>)>,
    /// J of the body in its frame.
    pub inertia: Inertia<Term<'g>>,
}

/// A way to choose the frames.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Put x along the common normal of a joint's axis and the next one's, and the origin at its
    /// foot (modified Denavit–Hartenberg), instead of where the description has them.
    pub normals: bool,
    /// Where the origin of a sliding body goes.
    pub sliding: Sliding,
    /// Turn the frame of a last body so that its centre of mass lies in the xz plane.
    pub turn_ends: bool,
    /// Regroup the inertial parameters.
    pub regroup: bool,
}

/// Where the origin of a sliding body goes, which may be anywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sliding {
    /// Where the description has it.
    AsDescribed,
    /// At the origin of the body it hangs on.
    AtParent,
    /// At the origin of the first body that hangs on it.
    AtChild,
    /// At its centre of mass, after regrouping.
    AtMassCenter,
}

impl Layout {
    /// Frames and parameters as the description has them.
    pub const DESCRIBED: Self = Self {
        normals: false,
        sliding: Sliding::AsDescribed,
        turn_ends: false,
        regroup: false,
    };

    /// Layouts worth counting for functions that need no inertia.
    #[must_use]
    pub fn for_kinematics(chain: &Chain) -> Vec<Self> {
        let seats = Self::seats(
            chain,
            &[Sliding::AsDescribed, Sliding::AtParent, Sliding::AtChild],
        );
        Self::all(&seats, &[false], false)
    }

    /// Layouts worth counting for dynamics that base parameters suffice for.
    #[must_use]
    pub fn for_dynamics(chain: &Chain) -> Vec<Self> {
        let seats = Self::seats(
            chain,
            &[
                Sliding::AsDescribed,
                Sliding::AtParent,
                Sliding::AtChild,
                Sliding::AtMassCenter,
            ],
        );
        Self::all(&seats, &[false, true], true)
    }

    fn seats(chain: &Chain, all: &[Sliding]) -> Vec<Sliding> {
        let slides = chain
            .joints
            .iter()
            .any(|joint| matches!(joint.motion, Motion::Prismatic));
        if slides {
            all.to_vec()
        } else {
            vec![Sliding::AsDescribed]
        }
    }

    fn all(seats: &[Sliding], turns: &[bool], regroup: bool) -> Vec<Self> {
        let mut layouts = Vec::new();
        for normals in [false, true] {
            for &sliding in seats {
                for &turn_ends in turns {
                    layouts.push(Self {
                        normals,
                        sliding,
                        turn_ends,
                        regroup,
                    });
                }
            }
        }
        layouts
    }
}

/// Gives each body its frame. The graph is the chain's own, or a copy of it.
#[must_use]
pub fn arrange<'g>(graph: &'g Graph, chain: &Chain, layout: Layout) -> Bodies<'g> {
    let mut bodies = aligned(graph, chain);
    let count = bodies.bodies.len();
    if layout.normals {
        for k in 0..count {
            if let Some(child) = bodies.first_child(k) {
                let to = common_normal(&bodies.bodies[child].placement);
                bodies.move_frame(k, to);
            }
        }
    }
    for k in 0..count {
        if matches!(bodies.bodies[k].motion, Motion::Prismatic) {
            let offset = match layout.sliding {
                Sliding::AtParent => {
                    let placement = bodies.bodies[k].placement;
                    Some(-(placement.rotation.transposed() * placement.translation))
                }
                Sliding::AtChild => bodies
                    .first_child(k)
                    .map(|child| bodies.bodies[child].placement.translation),
                Sliding::AsDescribed | Sliding::AtMassCenter => None,
            };
            if let Some(offset) = offset {
                bodies.move_frame(k, Pose::translation(offset));
            }
        }
    }
    for k in (0..count).rev() {
        let body = bodies.bodies[k];
        if layout.sliding == Sliding::AtMassCenter
            && matches!(body.motion, Motion::Prismatic)
            && body.inertia.mass.value().is_some_and(Double::is_sharp)
        {
            let center = body.inertia.q.map(|entry| entry / body.inertia.mass);
            bodies.move_frame(k, Pose::translation(center));
        }
        if layout.regroup {
            regroup::pass_inboard(&mut bodies.bodies, k);
        }
    }
    if layout.turn_ends {
        for k in 0..count {
            let body = bodies.bodies[k];
            let end = bodies.first_child(k).is_none();
            if end
                && !matches!(body.motion, Motion::Prismatic)
                && let Some(turn) = towards_mass_center(&body.inertia)
            {
                bodies.move_frame(k, turn);
            }
        }
    }
    for body in &mut bodies.bodies {
        if !matches!(body.motion, Motion::Prismatic) {
            split_offset(body);
        }
    }
    bodies
}

impl<'g> Bodies<'g> {
    /// The first body that hangs on body `k`.
    fn first_child(&self, k: usize) -> Option<usize> {
        (k + 1..self.bodies.len()).find(|&child| self.bodies[child].parent == Some(k))
    }

    /// Replaces frame `k` by one seen from it at `to`, which the joint's motion must not move.
    fn move_frame(&mut self, k: usize, to: Pose<Term<'g>>) {
        let from = to.inverse();
        let body = &mut self.bodies[k];
        body.placement = body.placement * to;
        body.inertia = body.inertia.change_frame(from);
        for child in &mut self.bodies[k + 1..] {
            if child.parent == Some(k) {
                child.placement = from * child.placement;
            }
        }
        for (body, placement) in &mut self.frames {
            if *body == Some(k) {
                *placement = from * *placement;
            }
        }
    }
}

/// The bodies as described, each frame turned so that its joint's axis is z.
fn aligned<'g>(graph: &'g Graph, chain: &Chain) -> Bodies<'g> {
    let term = |expr| graph.term(expr);
    let turns: Vec<Pose<Term<'g>>> = (chain.joints.iter())
        .map(|joint| Pose::rotation(z_along(joint.axis.map(term))))
        .collect();
    let seen_from = |parent: Option<usize>, pose: Pose<Term<'g>>| match parent {
        Some(parent) => turns[parent].inverse() * pose,
        None => pose,
    };
    let bodies = (chain.joints.iter().zip(&turns))
        .map(|(joint, &turn)| Body {
            parent: joint.parent,
            motion: joint.motion,
            placement: seen_from(joint.parent, joint.placement.map(term) * turn),
            offset: None,
            inertia: joint.inertia.map(term).change_frame(turn.inverse()),
        })
        .collect();
    let frames = (chain.frames.iter())
        .map(|frame| (frame.body, seen_from(frame.body, frame.placement.map(term))))
        .collect();
    Bodies {
        bodies,
        frames,
        gravity: chain.gravity.map(term),
    }
}

/// A rotation whose third column is the given direction, made of the axes themselves where it can.
fn z_along(direction: Vector<Term<'_>>) -> Rotation<Term<'_>> {
    let graph = direction.x().graph();
    let axis = |k: usize| {
        let mut entries = [0.0; 3];
        entries[k] = 1.0;
        Vector::constant(graph, entries)
    };
    let size = |k: usize| direction.0[k].value().map_or(0.0, Double::to_f64);
    for k in 0..3 {
        let (next, last) = (axis((k + 1) % 3), axis((k + 2) % 3));
        if direction.0[(k + 1) % 3].is_zero() && direction.0[(k + 2) % 3].is_zero() {
            let last = if size(k) > 0.0 { last } else { -last };
            return Rotation::from_columns([next, last, direction]);
        }
    }
    let smallest = (0..3)
        .min_by(|&a, &b| size(a).abs().total_cmp(&size(b).abs()))
        .unwrap_or(0);
    let x = axis(smallest).cross(direction).normalized();
    let x = x.expect("an axis is not along its smallest entry");
    Rotation::from_columns([x, direction.cross(x), direction])
}

/// Squared sine of the angle below which two axes have no normal that is worth having: its foot
/// stands so far away that digits are lost there, and for an angle of some 1e-16 all of them. Six
/// degrees.
const NEARLY_PARALLEL: f64 = 0.01;

/// From a frame to the one whose x is the common normal of its z and the z of `next`, and whose
/// origin is the foot of that normal.
fn common_normal<'g>(next: &Pose<Term<'g>>) -> Pose<Term<'g>> {
    let direction = next.rotation.column(2);
    let graph = direction.x().graph();
    let zero = graph.constant(0.0);
    let [x, y, cosine] = direction.0;
    let to = next.translation;
    if x.is_zero() && y.is_zero() {
        // Parallel: the normal points to the next axis; its foot may be anywhere.
        let normal = Vector([to.x(), to.y(), zero]).normalized();
        return normal.map_or_else(
            || Pose::identity(graph),
            |normal| Pose::rotation(about_z_towards(normal)),
        );
    }
    let square = x * x + y * y;
    let apart = square
        .value()
        .is_some_and(|square| square.to_f64() >= NEARLY_PARALLEL);
    // z × z' = (−y, x, 0); the foot is where the distance of the two lines is least.
    let normal = Vector([-y, x, zero]).normalized().filter(|_| apart);
    let Some(normal) = normal else {
        return Pose::identity(graph);
    };
    let along = to.z() - cosine * direction.dot(to);
    let foot = Vector([zero, zero, along / square]);
    Pose {
        rotation: about_z_towards(normal),
        translation: foot,
    }
}

/// About z, so that x comes to point in a direction of the xy plane.
fn about_z_towards(direction: Vector<Term<'_>>) -> Rotation<Term<'_>> {
    Rotation::about_z((direction.y(), direction.x()))
}

/// About z, so that q_y vanishes; or, where the centre of mass is on the axis, J_xy. None where
/// that is so already, or where it depends on a run-time parameter.
fn towards_mass_center<'g>(inertia: &Inertia<Term<'g>>) -> Option<Pose<Term<'g>>> {
    let [x, y, _] = inertia.q.0;
    let Symmetric([xx, yy, _, xy, ..]) = inertia.second;
    let zero = x.graph().constant(0.0);
    for entry in [x, y, xx, yy, xy] {
        entry.value()?;
    }
    let direction = if !(x.is_zero() && y.is_zero()) {
        Vector([x, y, zero])
    } else if !xy.is_zero() {
        half(Vector([xx - yy, xy + xy, zero]).normalized()?)
    } else {
        return None;
    };
    let direction = direction.normalized()?;
    Some(Pose::rotation(about_z_towards(direction)))
}

/// Along the bisector of x and a direction of the xy plane: tan ψ/2 = s / (1 + c), or (1 − c) / s where
/// 1 + c would cancel.
fn half(direction: Vector<Term<'_>>) -> Vector<Term<'_>> {
    let [cosine, sine, zero] = direction.0;
    let one = zero.graph().constant(1.0);
    let negative = |term: Term<'_>| term.value().is_some_and(|value| value.to_f64() < 0.0);
    match (negative(cosine), negative(sine)) {
        (false, _) => Vector([one + cosine, sine, zero]),
        (true, false) => Vector([sine, one - cosine, zero]),
        (true, true) => Vector([-sine, cosine - one, zero]),
    }
}

/// Takes a rotation about z off the right side of the placement and adds it to q, where that leaves
/// fewer products: R = R' Rz(β).
fn split_offset(body: &mut Body<'_>) {
    let rotation = body.placement.rotation;
    let simple = |entry: Term<'_>| {
        entry
            .value()
            .is_some_and(|value| value.is_zero() || value.is_one() || (-value).is_one())
    };
    if rotation.0.iter().flatten().all(|&entry| simple(entry)) {
        return;
    }
    let [[xx, xy, xz], _, [zx, zy, _]] = rotation.0;
    let (sine, cosine) = if xz.is_zero() {
        (-xy, xx)
    } else {
        let zero = xz.graph().constant(0.0);
        match Vector([zx, zy, zero]).normalized() {
            Some(direction) => (direction.x(), direction.y()),
            None => return,
        }
    };
    if sine.is_zero() || cosine.is_zero() {
        return;
    }
    body.offset = Some((sine, cosine));
    body.placement.rotation = rotation * Rotation::about_z((-sine, cosine));
}

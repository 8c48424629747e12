//! Bodies of each joint, and closed loops.
//!
//! In: the joints that are modelled, and their motions. Out: bodies in chains, with the indices of their coordinates
//! and velocities and with armature, damping and friction; the two frames of each loop.

use std::collections::BTreeMap;

use homogen_codegen::closure::Closure;
use homogen_codegen::description::{self, Joint, Name, Step};
use homogen_codegen::joint::JointKind;

use super::kept::Moves;
use super::written::{axis, big};
use super::{Body, Loop, Reader, Robot};
use crate::big::Big;
use crate::oracle::actuator::Actuator;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::{Manifold, Motion, across, translation_screw, with_z};

impl<'d> Reader<'d> {
    /// Adds the bodies below the base, branch after branch, siblings as described. Returns the link of each.
    pub(super) fn add_bodies(
        &self,
        base: &'d str,
        tip: Option<&'d str>,
        robot: &mut Robot,
    ) -> Vec<&'d str> {
        let kept = self.kept(base);
        let moves = self.moves(&kept, tip);
        // The first coordinate and velocity of each joint with its own, in the order of the bodies.
        let mut places = BTreeMap::new();
        let (mut coordinates, mut velocities) = if self.request.floating {
            Manifold::Floating.counts()
        } else {
            (0, 0)
        };
        for joint in &kept {
            let name = joint.name.text.as_str();
            if matches!(moves[name], Moves::Own) {
                places.insert(name, (coordinates, velocities));
                let (more_coordinates, more_velocities) = match manifold(joint.kind) {
                    Some(manifold) => manifold.counts(),
                    None => (screws(joint).len(), screws(joint).len()),
                };
                coordinates += more_coordinates;
                velocities += more_velocities;
            }
        }

        let mut links = Vec::new();
        if self.request.floating {
            links.push(base);
            robot.bodies.push(Body {
                parent: None,
                placement: Matrix::identity(),
                motion: Motion::Manifold {
                    manifold: Manifold::Floating,
                    coordinate: 0,
                    velocity: 0,
                },
                inertia: self.inertia(base),
                link: true,
            });
            // It has no actuator.
            let nothing = || [(); 3].map(|()| Big::zero());
            let actuators = (0..6).map(|velocity| Actuator::new(velocity, Big::one(), nothing()));
            robot.actuators.extend(actuators);
        }
        for joint in kept {
            let on = joint.parent.text.as_str();
            let mut parent = links.iter().position(|&link| link == on);
            let mut placement = self.placement(&joint.origin);
            let parts = parts(joint, &moves[joint.name.text.as_str()], &places);
            let last = parts.len() - 1;
            let moved = parts.iter().any(|(_, motion)| motion.moves());
            for (k, (rotation, motion)) in parts.into_iter().enumerate() {
                // Intermediate bodies are no links.
                let child = joint.child.text.as_str();
                links.push(if k == last { child } else { "" });
                let inertia = if k == last {
                    self.inertia(child)
                } else {
                    Matrix::zero()
                };
                let actuators = Actuator::of(self.request, joint, k, &motion);
                robot.actuators.extend(actuators);
                robot.bodies.push(Body {
                    parent,
                    placement: &placement * &rotation,
                    motion,
                    inertia,
                    link: moved && k == last,
                });
                (parent, placement) = (Some(robot.bodies.len() - 1), Matrix::identity());
            }
        }
        links
    }

    pub(super) fn closed_loop(
        &self,
        described: &description::Loop,
        body_of: impl Fn(&str) -> Option<usize>,
    ) -> Loop {
        use Closure::{Fixed, Rod, Spherical, Translation};
        let closure = described.closure;
        let has_axes = !matches!(closure, Fixed | Rod { .. } | Spherical | Translation);
        let axes = has_axes.then(|| described.axes.each_ref().map(axis));
        let frame = |link: &Name, at: &[Step], end: usize| {
            let rotation = axes.as_ref().map(|axes| with_z(&axes[end]));
            let rotation = rotation.unwrap_or_else(Matrix::identity);
            (body_of(&link.text), &self.placement(at) * &rotation)
        };
        let products = axes.iter().flat_map(|[one, other]| one.iter().zip(other));
        Loop {
            closure,
            frames: [
                frame(&described.from, &described.at, 0),
                frame(&described.to, &described.to_at, 1),
            ],
            cosine: products.fold(Big::zero(), |sum, (x, y)| sum + x * y),
        }
    }
}

/// The bodies of a joint, one after the other: a rotation in front of each, and its motion.
fn parts(
    joint: &Joint,
    moves: &Moves<'_>,
    places: &BTreeMap<&str, (usize, usize)>,
) -> Vec<(Matrix, Motion)> {
    let place = |name: &str| places[name];
    if let (Some(manifold), Moves::Own) = (manifold(joint.kind), moves) {
        let (coordinate, velocity) = place(&joint.name.text);
        let motion = Motion::Manifold {
            manifold,
            coordinate,
            velocity,
        };
        if manifold != Manifold::Planar {
            return vec![(Matrix::identity(), motion)];
        }
        let rotation = across(&axis(&joint.axis));
        let back = rotation.inverse();
        return vec![(rotation, motion), (back, Motion::none())];
    }
    let along = |screw, (coordinate, velocity), factor: &Big, offset: &Big| Motion::Along {
        screw,
        coordinate,
        velocity,
        factor: factor.clone(),
        offset: offset.clone(),
    };
    let screws = screws(joint).into_iter().enumerate();
    let motions = screws.map(|(k, screw)| match moves {
        Moves::Own => {
            let (coordinate, velocity) = place(&joint.name.text);
            let places = (coordinate + k, velocity + k);
            along(screw, places, &Big::one(), &Big::zero())
        }
        Moves::As {
            mimicked,
            factor,
            offset,
        } => along(screw, place(mimicked), factor, offset),
        Moves::Not(at) => Motion::Held {
            screw,
            at: at.clone(),
        },
    });
    motions.map(|motion| (Matrix::identity(), motion)).collect()
}

/// The configuration space of a joint whose velocities are in the axes of the moved body.
fn manifold(kind: JointKind) -> Option<Manifold> {
    Some(match kind {
        JointKind::Planar => Manifold::Planar,
        JointKind::Spherical => Manifold::Spherical,
        JointKind::Floating => Manifold::Floating,
        _ => return None,
    })
}

/// L of each motion of a joint that is a sequence of motions along screws through the origin of its frame; zero for
/// other joints.
fn screws(joint: &Joint) -> Vec<Matrix> {
    let nothing = [(); 3].map(|()| Big::zero());
    let rotation = |written| Matrix::screw(&axis(written), &nothing);
    let translation = |written| Matrix::screw(&nothing, &axis(written));
    match joint.kind {
        JointKind::Revolute | JointKind::Continuous => vec![rotation(&joint.axis)],
        JointKind::Prismatic => vec![translation(&joint.axis)],
        JointKind::Cylindrical => vec![rotation(&joint.axis), translation(&joint.axis)],
        JointKind::Screw { pitch } => {
            vec![&rotation(&joint.axis) + &translation(&joint.axis).times(&big(&pitch))]
        }
        JointKind::Universal => vec![rotation(&joint.axis), rotation(&joint.second_axis)],
        JointKind::Translation => (0..3).map(translation_screw).collect(),
        _ => vec![Matrix::zero()],
    }
}

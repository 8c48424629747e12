//! The bodies of each joint, and the loops between them.
//!
//! In: the joints that are kept, and what moves them. Out: bodies one on the other, with their places among coordinates
//! and velocities and what drives them; the two frames of each loop.

use std::collections::BTreeMap;

use homogen_codegen::closure::Closure;
use homogen_codegen::description::{self, Joint, Name, Step};
use homogen_codegen::joint::JointKind;

use super::kept::Moves;
use super::written::{axis, big};
use super::{Body, Loop, Reader, Robot};
use crate::big::Big;
use crate::oracle::drive::Drive;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::{self, Motion, Posture, across, with_z};

impl<'d> Reader<'d> {
    /// Adds what hangs on the base: branch after branch, siblings as described.
    pub(super) fn hang(
        &self,
        base: &'d str,
        tip: Option<&'d str>,
        robot: &mut Robot,
    ) -> Vec<&'d str> {
        let kept = self.kept(base);
        let moves = self.moves(&kept, tip);
        // The first coordinate and velocity of each joint that has its own, in the order of the bodies.
        let mut places = BTreeMap::new();
        let (mut coordinates, mut velocities) = if self.request.floating {
            Posture::Floating.counts()
        } else {
            (0, 0)
        };
        for joint in &kept {
            let name = joint.name.text.as_str();
            if matches!(moves[name], Moves::Own) {
                places.insert(name, (coordinates, velocities));
                let (more_coordinates, more_velocities) = match posture(joint.kind) {
                    Some(posture) => posture.counts(),
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
                motion: Motion::Posture {
                    posture: Posture::Floating,
                    coordinate: 0,
                    velocity: 0,
                },
                inertia: self.inertia(base),
                link: true,
            });
            // Nothing drives it.
            let nothing = || [(); 3].map(|()| Big::zero());
            let drives = (0..6).map(|velocity| Drive::new(velocity, Big::one(), nothing()));
            robot.drives.extend(drives);
        }
        for joint in kept {
            let on = joint.parent.text.as_str();
            let mut parent = links.iter().position(|&link| link == on);
            let mut placement = self.placement(&joint.origin);
            let parts = parts(joint, &moves[joint.name.text.as_str()], &places);
            let last = parts.len() - 1;
            let moved = parts.iter().any(|(_, motion)| motion.moves());
            for (k, (turn, motion)) in parts.into_iter().enumerate() {
                // What moves by a part of a joint's velocities is no link.
                let child = joint.child.text.as_str();
                links.push(if k == last { child } else { "" });
                let inertia = if k == last {
                    self.inertia(child)
                } else {
                    Matrix::zero()
                };
                let drives = Drive::of(self.request, joint, k, &motion);
                robot.drives.extend(drives);
                robot.bodies.push(Body {
                    parent,
                    placement: &placement * &turn,
                    motion,
                    inertia,
                    link: moved && k == last,
                });
                (parent, placement) = (Some(robot.bodies.len() - 1), Matrix::identity());
            }
        }
        links
    }

    pub(super) fn held(
        &self,
        described: &description::Loop,
        seat: impl Fn(&str) -> Option<usize>,
    ) -> Loop {
        use Closure::{Fixed, Rod, Spherical, Translation};
        let closure = described.closure;
        let has_axes = !matches!(closure, Fixed | Rod { .. } | Spherical | Translation);
        let axes = has_axes.then(|| described.axes.each_ref().map(axis));
        let frame = |link: &Name, at: &[Step], end: usize| {
            let turn = axes.as_ref().map(|axes| with_z(&axes[end]));
            let turn = turn.unwrap_or_else(Matrix::identity);
            (seat(&link.text), &self.placement(at) * &turn)
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

/// The bodies that a joint moves, one on the other: a turn in front of each, and what moves it.
fn parts(
    joint: &Joint,
    moves: &Moves<'_>,
    places: &BTreeMap<&str, (usize, usize)>,
) -> Vec<(Matrix, Motion)> {
    let place = |name: &str| places[name];
    if let (Some(posture), Moves::Own) = (posture(joint.kind), moves) {
        let (coordinate, velocity) = place(&joint.name.text);
        let motion = Motion::Posture {
            posture,
            coordinate,
            velocity,
        };
        if posture != Posture::Planar {
            return vec![(Matrix::identity(), motion)];
        }
        let turn = across(&axis(&joint.axis));
        let back = turn.inverse();
        return vec![(turn, motion), (back, Motion::none())];
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
            leader,
            factor,
            offset,
        } => along(screw, place(leader), factor, offset),
        Moves::Not(at) => Motion::Held {
            screw,
            at: at.clone(),
        },
    });
    motions.map(|motion| (Matrix::identity(), motion)).collect()
}

/// What a joint is whose velocities are seen in the moved frame.
fn posture(kind: JointKind) -> Option<Posture> {
    Some(match kind {
        JointKind::Planar => Posture::Planar,
        JointKind::Spherical => Posture::Spherical,
        JointKind::Floating => Posture::Floating,
        _ => return None,
    })
}

/// L of each motion of a joint whose motions come one after the other, through the origin of its frame;
/// null of what does not move, or moves in another way.
fn screws(joint: &Joint) -> Vec<Matrix> {
    let nothing = [(); 3].map(|()| Big::zero());
    let turn = |written| Matrix::screw(&axis(written), &nothing);
    let slide = |written| Matrix::screw(&nothing, &axis(written));
    match joint.kind {
        JointKind::Revolute | JointKind::Continuous => vec![turn(&joint.axis)],
        JointKind::Prismatic => vec![slide(&joint.axis)],
        JointKind::Cylindrical => vec![turn(&joint.axis), slide(&joint.axis)],
        JointKind::Screw { pitch } => {
            vec![&turn(&joint.axis) + &slide(&joint.axis).times(&big(&pitch))]
        }
        JointKind::Universal => vec![turn(&joint.axis), turn(&joint.second_axis)],
        JointKind::Translation => (0..3).map(motion::slide).collect(),
        _ => vec![Matrix::zero()],
    }
}

//! Collision spheres: their centres, and the distances of pairs with their derivatives.
//!
//! In: a scene with spheres. Out: scalars. Joints that carry all spheres of all pairs change no distance: distances and
//! their derivatives are computed in the frame of the last body that carries them, so that a robot far from the origin of
//! frame 0 loses no digits. A distance changes with q̇ by the power of a unit force along the line of centres: with its
//! wrench Φ, a row of the Jacobian is L ⊗ Φ for the joints that carry the first sphere alone, and −L ⊗ Φ for those that
//! carry the second alone.

use std::collections::{BTreeMap, BTreeSet};

use super::Scene;
use super::carry::{Path, carrier, path_beyond};
use super::pose;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Action, Screw, Vector};
use crate::space::SphereId;

/// The centres in frame 0.
pub(crate) fn centers<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let frames = scene.bodies.spheres.iter();
    let centers = frames.map(|&(frame, _)| center(scene, &scene.link_path_to(frame)));
    centers.flat_map(|center| center.0).collect()
}

/// The distances of all pairs.
pub(crate) fn distances<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let paths = paths(scene);
    let centers = paths.iter().map(|(&k, path)| (k, center(scene, path)));
    let centers: BTreeMap<SphereId, Vector<Term<'g>>> = centers.collect();
    let pairs = scene.bodies.pairs.iter();
    let distances = pairs.map(|&[a, b]| {
        let radii = [a, b].map(|k| scene.bodies.spheres[k].1);
        length(centers[&a] - centers[&b]) - (radii[0] + radii[1])
    });
    distances.collect()
}

/// The derivatives of the distances by q, a row for each pair.
pub(crate) fn jacobian<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let seen = paths(scene).into_iter();
    let seen = seen.map(|(k, path)| (k, CarriedSphere::of(&path)));
    let seen: BTreeMap<SphereId, CarriedSphere<'g>> = seen.collect();
    let zero = scene.state.zero();
    let pairs = scene.bodies.pairs.iter();
    let rows = pairs.flat_map(|[a, b]| {
        let (first, second) = (&seen[a], &seen[b]);
        let offset = first.center - second.center;
        let normal = offset * (zero.graph().constant(1.0) / length(offset));
        let force = Action {
            c: first.center.cross(normal),
            f: normal,
        };
        let mut row: List<BodyId, Term<'g>> = List::filled(zero, scene.bodies.bodies.len());
        for (&body, &screw) in &first.screws {
            if !second.screws.contains_key(&body) {
                row[body] = force.along(screw);
            }
        }
        for (&body, &screw) in &second.screws {
            if !first.screws.contains_key(&body) {
                row[body] = -force.along(screw);
            }
        }
        scene.forces(&row)
    });
    rows.collect()
}

/// A sphere in the frame that its path begins at.
struct CarriedSphere<'g> {
    center: Vector<Term<'g>>,
    /// L of the joints that move it.
    screws: BTreeMap<BodyId, Screw<Term<'g>>>,
}

impl<'g> CarriedSphere<'g> {
    fn of(path: &Path<'g>) -> Self {
        let placed = path.outwards();
        let end = path.end.translation;
        let screws = placed.iter();
        Self {
            center: placed.last().map_or(end, |(_, pose)| pose.point(end)),
            screws: screws
                .map(|(joint, pose)| (joint.body, joint.screw.change_frame(*pose)))
                .collect(),
        }
    }
}

/// The paths to all spheres that are in pairs, from the last body that carries all of them.
fn paths<'g>(scene: &Scene<'_, 'g>) -> BTreeMap<SphereId, Path<'g>> {
    let bodies = scene.bodies;
    // A sphere is in several pairs.
    let spheres: BTreeSet<SphereId> = bodies.pairs.iter().flatten().copied().collect();
    let frame = |k: SphereId| bodies.spheres[k].0;
    let from = carrier(bodies, spheres.iter().map(|&k| frame(k)));
    let path = |k| path_beyond(bodies, from, frame(k), &scene.state, scene.algorithm);
    spheres.into_iter().map(|k| (k, path(k))).collect()
}

/// The origin of the frame at the end of a path.
fn center<'g>(scene: &Scene<'_, 'g>, path: &Path<'g>) -> Vector<Term<'g>> {
    let entries = pose::forward_kinematics(path, scene.algorithm.pose);
    Vector([3, 7, 11].map(|k| entries[k]))
}

fn length(offset: Vector<Term<'_>>) -> Term<'_> {
    offset.dot(offset).sqrt()
}

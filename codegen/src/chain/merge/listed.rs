//! The merged bodies in the order of their joints, and the lists of coordinates and velocities.
//!
//! In: the bodies, each with its joint and its coordinate. Out: the joints of a chain with their indices in those
//! lists, and the lists, with units and limits. A mimic joint has the indices of the joint that it mimics.

use std::collections::HashMap;

use super::{MergedBody, Moved};
use crate::chain::{self, BodyId, Position, limits};
use crate::description::Description;
use crate::expression::{Graph, Term};
use crate::list::List;
use crate::space::{CoordinateId, Entry, Spaces, VelocityId};

/// The bodies with their indices in the lists of coordinates and velocities, and those lists.
pub(super) fn listed(
    description: &Description,
    bodies: List<BodyId, MergedBody<'_>>,
    graph: &Graph,
) -> (List<BodyId, chain::Joint>, Spaces) {
    let mut spaces = Spaces::default();
    // For each joint with one coordinate, its indices among coordinates and velocities.
    let mut movers = HashMap::new();
    let mut places = Vec::with_capacity(bodies.len());
    for body in &bodies {
        let described = &description[body.joint];
        let (coordinate, velocity) = (spaces.coordinates.next(), spaces.velocities.next());
        places.push((coordinate, velocity));
        // Formats do not say which of several coordinates limits belong to.
        let one = described.limits.filter(|_| !described.kind.has_several());
        let entry = |name: String, kind, range| Entry { name, kind, range };
        match body.moved {
            Moved::Mimic { .. } => continue,
            Moved::Own => {
                movers.insert(body.joint, (coordinate, velocity));
                let (name, kind) = (body.velocity.clone(), body.motion.kind());
                let range = one.and_then(limits::reach);
                spaces.coordinates.push(entry(name, kind, range));
            }
            Moved::Manifold(_) => {
                let names = described.kind.coordinates(&described.name.text).into_iter();
                let entries = names.map(|(name, kind)| entry(name, kind, None));
                spaces.coordinates.extend(entries);
            }
            Moved::Taken => {}
        }
        let (name, kind) = (body.velocity.clone(), body.motion.kind());
        let range = one.and_then(limits::rates);
        spaces.velocities.push(entry(name, kind, range));
    }
    let one = graph.constant(1.0).expr();
    let joint = |(body, (coordinate, velocity)): (MergedBody<'_>, (CoordinateId, VelocityId))| {
        let described = &description[body.joint];
        let (position, velocity) = match body.moved {
            Moved::Own => {
                let factor = one;
                (Position::Along { coordinate, factor }, velocity)
            }
            Moved::Mimic { mimicked, factor } => {
                let (coordinate, velocity) = movers[&mimicked];
                let factor = factor.expr();
                (Position::Along { coordinate, factor }, velocity)
            }
            Moved::Manifold(manifold) => (Position::Manifold(manifold, coordinate), velocity),
            Moved::Taken => (Position::Taken, velocity),
        };
        chain::Joint {
            name: body.velocity,
            of: described.name.text.clone(),
            place: described.name.place,
            parent: body.parent,
            motion: body.motion,
            placement: body.placement.map(Term::expr),
            axis: body.axis.map(Term::expr),
            link: body.link.map(|(link, pose)| {
                let name = description[link].name.text.clone();
                (name, pose.map(Term::expr))
            }),
            inertia: body.inertia.map(Term::expr),
            position,
            velocity,
            actuator: body.actuator.map(Term::expr),
        }
    };
    let joints = bodies.into_iter().zip(places).map(joint).collect();
    (joints, spaces)
}

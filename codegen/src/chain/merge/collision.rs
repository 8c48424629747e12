//! Collision spheres, and the pairs of them that have distances.
//!
//! In: the collision geometry of a description, and the place of each link. Out: the spheres in the bodies of their
//! links, and pairs of spheres of the links that are named, or of all bodies that no joint joins. Spheres that do not move
//! relative to each other are no pair. Other shapes are left out with a warning.

use std::collections::BTreeMap;

use super::{Attachment, TermReader};
use crate::chain::{BodyId, Frame, Joint, Sphere};
use crate::description::{Description, LinkId};
use crate::error::Diagnostic;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::Pose;
use crate::request::Request;
use crate::space::{Entry, Kind, SphereId};
use crate::wording::{list, quoted};

/// The spheres of all modelled links, if they are requested, with the link of each.
pub(super) fn spheres<'g>(
    description: &Description,
    request: &Request,
    attachments: &List<LinkId, Option<Attachment<'g>>>,
    reader: &mut TermReader<'g, '_>,
) -> (List<SphereId, Sphere>, List<SphereId, LinkId>) {
    let (mut spheres, mut links) = (List::new(), List::new());
    if !request.collision {
        return (spheres, links);
    }
    let mut others = Vec::new();
    for collision in &description.collisions {
        let link = collision.link;
        let Some(attachment) = attachments[link] else {
            continue;
        };
        let name = &description[link].name.text;
        let Some(sphere) = &collision.sphere else {
            others.push(collision);
            continue;
        };
        let placement = attachment.pose * reader.placement(name, &sphere.origin);
        let placement = Pose::translation(placement.translation);
        links.push(link);
        spheres.push(Sphere {
            frame: Frame {
                name: name.clone(),
                body: attachment.body,
                placement: placement.map(Term::expr),
            },
            radius: reader.number(&sphere.radius).expr(),
        });
    }
    if let Some(first) = others.first() {
        // Those of one link stand together.
        let mut links: Vec<LinkId> = others.iter().map(|other| other.link).collect();
        links.dedup();
        let names = links
            .iter()
            .map(|&link| quoted(&description[link].name.text));
        let names: Vec<String> = names.collect();
        let names = list(names.iter().map(String::as_str));
        reader.report.warnings.push(Diagnostic {
            place: first.place,
            message: format!("not modelled: collision geometry of {names} that is no sphere"),
            hint: Some("distances do not know it: cover it with spheres".to_owned()),
        });
    }
    (spheres, links)
}

/// The pairs of spheres that have distances.
pub(super) fn pairs(
    spheres: &List<SphereId, Sphere>,
    links: &List<SphereId, LinkId>,
    joints: &List<BodyId, Joint>,
    named: &[[LinkId; 2]],
) -> Vec<[SphereId; 2]> {
    let body = |k: SphereId| spheres[k].frame.body;
    let are_asked = |a: SphereId, b: SphereId| {
        if named.is_empty() {
            !are_joined(joints, body(a), body(b))
        } else {
            named.contains(&[links[a], links[b]]) || named.contains(&[links[b], links[a]])
        }
    };
    let mut pairs = Vec::new();
    for a in spheres.ids() {
        let later = spheres.ids().filter(|&b| b > a && body(a) != body(b));
        pairs.extend(later.filter(|&b| are_asked(a, b)).map(|b| [a, b]));
    }
    pairs
}

/// True if a joint joins two bodies.
fn are_joined(joints: &List<BodyId, Joint>, a: Option<BodyId>, b: Option<BodyId>) -> bool {
    let carries = |outer: Option<BodyId>, body: Option<BodyId>| {
        body.is_some_and(|body| before_joint(joints, body) == outer)
    };
    carries(a, b) || carries(b, a)
}

/// The body that the joint of another one begins at; `None` for the base.
fn before_joint(joints: &List<BodyId, Joint>, mut body: BodyId) -> Option<BodyId> {
    let of = &joints[body].of;
    while let Some(parent) = joints[body].parent.filter(|&k| joints[k].of == *of) {
        body = parent;
    }
    joints[body].parent
}

/// The entries of spheres: the name of the link, with a number if it has several.
pub(super) fn entries(spheres: &List<SphereId, Sphere>) -> List<SphereId, Entry> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for sphere in spheres {
        *counts.entry(&sphere.frame.name).or_default() += 1;
    }
    let mut numbers: BTreeMap<&str, usize> = BTreeMap::new();
    let entries = spheres.iter().map(|sphere| {
        let link = sphere.frame.name.as_str();
        let number = numbers.entry(link).or_default();
        *number += 1;
        let name = if counts[link] == 1 {
            link.to_owned()
        } else {
            format!("{link}_{number}")
        };
        entry(name)
    });
    entries.collect()
}

/// The entries of pairs: the names of both spheres.
pub(super) fn pair_entries(pairs: &[[SphereId; 2]], spheres: &List<SphereId, Entry>) -> Vec<Entry> {
    let pairs = pairs.iter();
    let names = pairs.map(|[a, b]| format!("{}/{}", spheres[*a].name, spheres[*b].name));
    names.map(entry).collect()
}

fn entry(name: String) -> Entry {
    Entry {
        name,
        kind: Kind::Frame,
        range: None,
    }
}

//! Requests for collision spheres.
//!
//! In: the request, and the collision geometry of the description. Out: the pairs of links that are named; an error for
//! functions of spheres that are not modelled, for spheres that no function reads, and for each mistake in the geometry.

use std::collections::BTreeMap;

use super::names::Names;
use super::tree::Tree;
use crate::description::{Description, LinkId};
use crate::error::Errors;
use crate::function::Function;
use crate::request::Request;
use crate::wording::quoted;

/// Maximum number of pairs: each is a statement or more of straight-line code.
const MOST: usize = 20_000;

/// Checks the request; returns the pairs of links that are named and exist.
pub fn check(
    description: &Description,
    request: &Request,
    tree: &Tree,
    links: &Names<'_, LinkId>,
    errors: &mut Errors,
) -> Vec<[LinkId; 2]> {
    let asked = request.functions.iter().flatten();
    let of_spheres = asked.clone().find(|function| function.is_of_spheres());
    let place = description.name.place;
    if !request.collision {
        if let Some(function) = of_spheres {
            let name = quoted(function.name());
            errors.push_with_hint(
                place,
                format!("{name} is of collision spheres, which are not modelled"),
                "ask for them: collision",
            );
        }
        return Vec::new();
    }
    if of_spheres.is_none() && !request.functions.is_empty() {
        let names = Function::OF_SPHERES.map(|function| quoted(function.name()));
        errors.push_with_hint(
            place,
            "collision spheres are modelled, but no function reads them",
            format!(
                "leave `collision` out, or generate one of {}",
                names.join(", ")
            ),
        );
    }
    for collision in &description.collisions {
        errors.append(collision.errors.clone());
    }
    let counts = counts(description);
    if counts.is_empty() && errors.is_empty() {
        errors.push_with_hint(
            place,
            "the description has no collision spheres",
            "write them in links of a URDF: \
             <collision><origin xyz=\"0 0 0.1\"/><geometry><sphere radius=\"0.05\"/></geometry></collision>",
        );
    }
    let mut pairs = Vec::new();
    let mut number = 0;
    for names in &request.collision_pairs {
        let [Some(a), Some(b)] = names.each_ref().map(|name| links.find(name, errors)) else {
            continue;
        };
        for (link, name) in [a, b].iter().zip(names) {
            let called = quoted(&name.text);
            if tree.dropped.contains(link) {
                errors.push(name.place, format!("link {called} is not modelled"));
            } else if !counts.contains_key(link) && !counts.is_empty() {
                let message = format!("link {called} has no collision sphere");
                errors.push(name.place, message);
            }
        }
        if !tree.move_apart([a, b]) {
            let [a, b] = names.each_ref().map(|name| quoted(&name.text));
            let message = format!("links {a} and {b} do not move relative to each other");
            errors.push(names[0].place, message);
        }
        let count = |link| counts.get(&link).copied().unwrap_or_default();
        number += count(a) * count(b);
        pairs.push([a, b]);
    }
    if request.collision_pairs.is_empty() {
        let all: usize = counts.values().sum();
        number = all * all.saturating_sub(1) / 2;
    }
    if number > MOST {
        errors.push_with_hint(
            place,
            format!("there are {number} pairs of collision spheres, more than {MOST}"),
            "name the pairs of links whose distances matter: collision(hand: base)",
        );
    }
    pairs
}

/// The number of spheres of each link that has some.
fn counts(description: &Description) -> BTreeMap<LinkId, usize> {
    let mut counts = BTreeMap::new();
    for collision in &description.collisions {
        if collision.sphere.is_some() {
            *counts.entry(collision.link).or_default() += 1;
        }
    }
    counts
}

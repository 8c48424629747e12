//! Requests for collision spheres.
//!
//! In: the request, and the collision geometry of the description. Out: the pairs of links that are named; an error for
//! functions of spheres that are not modelled, for spheres that no function reads, and for each mistake in the geometry.

use super::names::Names;
use crate::description::{Description, LinkId};
use crate::error::Errors;
use crate::function::Function;
use crate::request::Request;
use crate::wording::quoted;

/// Checks the request; returns the pairs of links that are named and exist.
pub fn check(
    description: &Description,
    request: &Request,
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
    let mut spheres = description.collisions.iter();
    if spheres.all(|collision| collision.sphere.is_none()) && errors.is_empty() {
        errors.push_with_hint(
            place,
            "the description has no collision spheres",
            "write them in links of a URDF: \
             <collision><origin xyz=\"0 0 0.1\"/><geometry><sphere radius=\"0.05\"/></geometry></collision>",
        );
    }
    let mut pairs = Vec::new();
    for names in &request.collision_pairs {
        if let [Some(a), Some(b)] = names.each_ref().map(|name| links.find(name, errors)) {
            pairs.push([a, b]);
        }
    }
    pairs
}

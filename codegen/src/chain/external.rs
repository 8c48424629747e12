//! Links with an external wrench.
//!
//! In: the links that are named, the tree. Out: an error for each link on which a wrench changes nothing, and for
//! wrenches that no requested function reads. The place of a wrench in its body follows from
//! [`merge`](super::merge).

use super::names::Names;
use super::tree::Tree;
use crate::description::{Description, LinkId};
use crate::error::Errors;
use crate::list::List;
use crate::request::Request;
use crate::wording::quoted;

/// Checks all links that are named; returns those that exist, in the order of the request.
pub fn check(
    description: &Description,
    request: &Request,
    tree: &Tree,
    links: &Names<'_, LinkId>,
    errors: &mut Errors,
) -> Vec<LinkId> {
    let mut moves = List::filled(false, description.links.len());
    for branch in &tree.branches {
        moves[branch.child] = moves[branch.parent] || branch.held.is_none();
    }
    let mut found = Vec::new();
    for (k, name) in request.external.iter().enumerate() {
        let Some(link) = links.find(name, errors) else {
            continue;
        };
        let called = quoted(&name.text);
        let mut before = request.external[..k].iter();
        if tree.dropped.contains(&link) {
            errors.push(name.place, format!("link {called} is not modelled"));
        } else if before.any(|other| other.text == name.text) {
            let message = format!("the external wrench on link {called} is requested twice");
            errors.push(name.place, message);
        } else if !moves[link] {
            errors.push_with_hint(
                name.place,
                format!("link {called} does not move: a wrench on it changes nothing"),
                "leave it out, or choose a base above the link in the tree",
            );
        }
        found.push(link);
    }
    let mut functions = request.functions.iter().flatten();
    if let Some(first) = request.external.first()
        && !request.functions.is_empty()
        && !functions.any(|function| function.takes_actions())
    {
        errors.push_with_hint(
            first.place,
            "external wrenches enter inverse and forward dynamics and their derivatives, but none of these is generated",
            "leave them out, or generate inverse_dynamics or forward_dynamics",
        );
    } else if request.external.is_empty() && request.external_in_frame_0 {
        errors.push_with_hint(
            description.name.place,
            "external_in_frame_0 is set, but there are no external wrenches",
            "name the links on which they act with external",
        );
    }
    found
}

//! Reports links, joints or loops with the same name.
//!
//! A link and a joint may share a name, as in many files.

use std::collections::HashMap;

use super::{Description, Name};
use crate::error::{Errors, Place};
use crate::wording::quoted;

/// Reports repeated names of links and of joints.
pub(super) fn check(description: &Description, errors: &mut Errors) {
    let links = description.links.iter().map(|link| &link.name);
    let joints = description.joints.iter().map(|joint| &joint.name);
    check_kind("link", links, errors);
    check_kind("joint", joints, errors);
}

/// Reports repeated names of loops, including those added to a file.
pub(super) fn check_loops(description: &Description, errors: &mut Errors) {
    let loops = description.loops.iter().map(|described| &described.name);
    check_kind("loop", loops, errors);
}

fn check_kind<'d>(kind: &str, names: impl Iterator<Item = &'d Name>, errors: &mut Errors) {
    let mut seen: HashMap<&str, Place> = HashMap::new();
    for name in names {
        let Some(first) = seen.insert(&name.text, name.place) else {
            continue;
        };
        let message = format!("there is another {kind} {}", quoted(&name.text));
        match first {
            Place::File { line, .. } => {
                let hint = format!("the other one is in line {line}");
                errors.push_with_hint(name.place, message, hint);
            }
            Place::Included { .. } | Place::Token(_) | Place::Unknown => {
                errors.push(name.place, message);
            }
        }
    }
}

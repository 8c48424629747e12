//! Limits of joints with several coordinates, of which the formats know one pair.
//!
//! In: the description and its tree. Out: a doubt for each such joint that moves and has limits: they
//! are left out.

use super::tree::Tree;
use crate::description::Description;
use crate::error::Complaint;
use crate::wording::quoted;

/// What is left out.
pub fn doubts(description: &Description, tree: &Tree) -> Vec<Complaint> {
    let moving = tree.branches.iter().filter(|branch| branch.held.is_none());
    let joints = moving.map(|branch| &description.joints[branch.joint]);
    let limited = joints.filter(|joint| joint.limits.is_some() && joint.kind.has_several());
    limited
        .map(|joint| Complaint {
            place: joint.place,
            message: format!(
                "joint {} is {} and has limits, which are not modelled: of which coordinate is not said",
                quoted(&joint.name.text),
                joint.kind.word()
            ),
            hint: Some("leave them out, or use two joints".to_owned()),
        })
        .collect()
}

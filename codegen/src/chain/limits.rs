//! Limits: ranges of coordinates and velocities. Formats have one pair of limits a joint, even for joints with several
//! coordinates.
//!
//! In: limits, or the description and its tree. Out: a range, or a warning for each joint with several coordinates that
//! moves and has limits: they are left out.

use super::tree::Tree;
use crate::description::{Description, Limits};
use crate::error::Diagnostic;
use crate::wording::quoted;

/// The range of the coordinate: one point if both limits are equal, unless both are zero, which in a URDF stands for
/// limits that were not written.
pub fn reach(limits: Limits) -> Option<[f64; 2]> {
    let [lower, upper] = [limits.lower, limits.upper];
    let finite = lower.is_finite() && upper.is_finite() && (upper - lower).is_finite();
    let written = lower != 0.0 || upper != 0.0;
    (finite && written && lower <= upper).then_some([lower, upper])
}

/// The range of the velocity.
pub fn rates(limits: Limits) -> Option<[f64; 2]> {
    let rate = limits.velocity;
    (rate > 0.0 && rate.is_finite()).then_some([-rate, rate])
}

/// Warnings about limits that are left out.
pub fn warnings(description: &Description, tree: &Tree) -> Vec<Diagnostic> {
    let moving = tree.branches.iter().filter(|branch| branch.held.is_none());
    let joints = moving.map(|branch| &description[branch.joint]);
    let limited = joints.filter(|joint| joint.limits.is_some() && joint.kind.has_several());
    limited
        .map(|joint| Diagnostic {
            place: joint.place,
            message: format!(
                "joint {} is {} and has limits, which are not modelled: they do not name a coordinate",
                quoted(&joint.name.text),
                joint.kind.word()
            ),
            hint: Some("leave them out, or use two joints".to_owned()),
        })
        .collect()
}

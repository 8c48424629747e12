//! `<limit>` and `<safety_controller>`: limits of position, velocity and effort.
//!
//! Soft limits that are narrower than the limits are noted for a warning.

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Limits, number};
use crate::joint::JointKind;

/// The limits, if there are any. Position limits are ignored for a continuous joint. They are ignored with a warning if
/// the lower one is above the upper one: simulators write this for a joint without limits.
pub(super) fn read<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    kind: Option<JointKind>,
    subject: &str,
) -> Option<Limits> {
    let node = reader.only(children, "limit", subject)?;
    let mut bound = |name: &str, otherwise: f64| {
        let Some(attribute) = node.attribute_node(name) else {
            return otherwise;
        };
        number::read_bound(reader.value(&attribute).trim()).unwrap_or_else(|refusal| {
            let place = reader.value_place(&attribute);
            reader.refuse(place, &format!("the {name} limit of {subject}"), &refusal);
            otherwise
        })
    };
    let velocity = bound("velocity", f64::INFINITY);
    // A malformed or zero effort means no limit, because files write 0 for unknown.
    let effort = node.attribute("effort").map(|text| text.trim().parse());
    let effort = effort.and_then(Result::ok).filter(|most| *most > 0.0);
    let effort = effort.unwrap_or(f64::INFINITY);
    let unlimited = Limits {
        lower: f64::NEG_INFINITY,
        upper: f64::INFINITY,
        velocity,
        effort,
    };
    match kind {
        None | Some(JointKind::Fixed) => return Some(unlimited),
        Some(JointKind::Continuous) => {
            let is_limit = |bound: &f64| bound.is_finite() && *bound != 0.0;
            let ends = [bound("lower", 0.0), bound("upper", 0.0)];
            if ends.iter().any(is_limit) {
                reader.unmodelled.limits(reader.place(node), subject);
            }
            return Some(unlimited);
        }
        Some(_) => {}
    }
    // Missing limits are zero, as URDF defines.
    let (lower, upper) = (bound("lower", 0.0), bound("upper", 0.0));
    if lower > upper {
        reader.warn(
            reader.place(node),
            format!(
                "the lower limit of {subject}, {lower}, is above the upper one, {upper}: read as \
                 unlimited"
            ),
            Some("swap them if the joint has limits".to_owned()),
        );
        return Some(unlimited);
    }
    Some(Limits {
        lower,
        upper,
        velocity,
        effort,
    })
}

/// Notes soft limits that are narrower than the limits, which are the range of the coordinate.
pub(super) fn soft<'t>(
    reader: &mut Reader<'_, 't>,
    children: &[Node<'_, 't>],
    limits: Option<Limits>,
    kind: Option<JointKind>,
    subject: &str,
) {
    let Some(node) = reader.only(children, "safety_controller", subject) else {
        return;
    };
    if !kind.is_some_and(JointKind::moves) {
        return;
    }
    let soft = ["soft_lower_limit", "soft_upper_limit"].map(|name| {
        let written = node
            .attribute(name)
            .and_then(|text| text.trim().parse().ok());
        written.unwrap_or(0.0)
    });
    let [lower, upper]: [f64; 2] = soft;
    // Missing limits are zero, as URDF defines; if both are missing, there are none.
    let is_written = lower < upper;
    let (least, most) = limits.map_or((f64::NEG_INFINITY, f64::INFINITY), |limits| {
        (limits.lower, limits.upper)
    });
    if is_written && (lower > least || upper < most) {
        reader.unmodelled.soft_limits(reader.place(node), subject);
    }
}

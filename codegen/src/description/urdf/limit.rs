//! `<limit>` and `<safety_controller>`: the range of a coordinate and of its rate.
//!
//! In: the elements of a joint. Out: [`Limits`], as far as they could be read, and complaints; a note of soft limits that
//! are narrower. It never looks at the axis.

use roxmltree::Node;

use crate::description::xml::element::Reader;
use crate::description::{Limits, number};
use crate::joint::JointKind;

/// The limits, where there are any. Those of the angle mean nothing for a continuous joint, and
/// nothing for any other where the lower one is above the upper one, by which simulators say that
/// there are none.
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
    // Nothing is computed of it: what is no number, or zero, says nothing.
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
            let says = |bound: &f64| bound.is_finite() && *bound != 0.0;
            let ends = [bound("lower", 0.0), bound("upper", 0.0)];
            if ends.iter().any(says) {
                reader.unmodelled.limits(reader.place(node), subject);
            }
            return Some(unlimited);
        }
        Some(_) => {}
    }
    // A limit that is not written is zero, says URDF.
    let (lower, upper) = (bound("lower", 0.0), bound("upper", 0.0));
    if lower > upper {
        reader.warn(
            reader.place(node),
            format!(
                "the lower limit of {subject}, {lower}, is above the upper one, {upper}: taken as \
                 without limits"
            ),
            Some("swap them, if they are meant".to_owned()),
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

/// Takes note of soft limits that are narrower than the limits, which are the range of the coordinate.
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
    // A limit that is not written is zero, says URDF; both are where nothing is said.
    let is_said = lower < upper;
    let (least, most) = limits.map_or((f64::NEG_INFINITY, f64::INFINITY), |limits| {
        (limits.lower, limits.upper)
    });
    if is_said && (lower > least || upper < most) {
        reader.unmodelled.soft_limits(reader.place(node), subject);
    }
}

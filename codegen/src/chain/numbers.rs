//! Checks that the numbers of a description are finite and in a possible range.
//!
//! In: the description, the request and the tree, or the merged chain. Out: an error for each number that is infinite
//! or NaN, and for each body or placement that overflowed. Readers refuse most of these at their place; a description
//! can also come from elsewhere.

use super::Chain;
use super::tree::Tree;
use crate::description::{Description, Number, Step};
use crate::error::{Errors, Place};
use crate::expression::{Double, Expr};
use crate::request::Request;
use crate::wording::quoted;

/// 2⁵⁰ rad: beyond, the spacing of `f64` is too coarse for a quarter turn.
const LARGEST_ANGLE: f64 = 1_125_899_906_842_624.0;

/// Larger than any length, mass or inertia in any unit. A length of 1 beside it still has digits in 106 bits. The
/// product of six such numbers is finite; a torque is the product of a mass and two lengths, and solving for
/// accelerations squares masses.
pub(super) const LARGEST: f64 = 1e30;

/// Rejects numbers that are not finite, axes of length zero, angles without digits, and numbers so large that they
/// would overflow.
pub fn check(description: &Description, request: &Request, tree: &Tree, errors: &mut Errors) {
    if let Some(gravity) = &request.gravity {
        let mut account = Account {
            place: Place::Unknown,
            what: "gravity".to_owned(),
            errors,
        };
        account.numbers(gravity);
    }
    check_loops(description, errors);
    for branch in &tree.branches {
        let joint = &description[branch.joint];
        let what = format!("joint {}", quoted(&joint.name.text));
        let mut account = Account {
            place: joint.place,
            what,
            errors,
        };
        account.steps(&joint.origin);
        let axes = [joint.axis, joint.second_axis];
        for axis in axes.iter().take(joint.kind.definition().axes()) {
            account.numbers(axis);
            if axis.iter().all(|entry| entry.value == 0.0) {
                account.refuse(axis[0].place, "has an axis without a direction");
            }
        }
        account.numbers(joint.kind.pitch().as_slice());
        if let Some(mimic) = &joint.mimic {
            account.numbers(&[mimic.multiplier, mimic.offset]);
        }
        if let Some(held) = &branch.held {
            account.angle(held);
        }
        let link = &description[branch.child];
        if let Some(inertial) = &link.inertial {
            let mut account = Account {
                place: inertial.place,
                what: format!("link {}", quoted(&link.name.text)),
                errors,
            };
            account.steps(&inertial.origin);
            account.numbers(&inertial.inertia);
            account.numbers(std::slice::from_ref(&inertial.mass));
        }
    }
}

/// The same for loops.
fn check_loops(description: &Description, errors: &mut Errors) {
    for described in &description.loops {
        let mut account = Account {
            place: described.name.place,
            what: format!("loop {}", quoted(&described.name.text)),
            errors,
        };
        account.steps(&described.at);
        account.steps(&described.to_at);
        account.numbers(described.closure.length().as_slice());
        for axis in described
            .axes
            .iter()
            .take(described.closure.definition().axes)
        {
            account.numbers(axis);
            if axis.iter().all(|entry| entry.value == 0.0) {
                account.refuse(axis[0].place, "has an axis without a direction");
            }
        }
    }
}

/// Rejects placements and inertias that overflowed.
///
/// # Errors
/// One error for each such joint.
pub fn check_merged(chain: Chain) -> Result<Chain, Errors> {
    let mut errors = chain.description.source.errors();
    let is_known = |expr: &Expr| chain.graph.value(*expr).is_none_or(Double::is_known);
    for joint in &chain.joints {
        let inertia = joint.inertia.entries();
        let mut numbers = joint.placement.entries().into_iter().chain(inertia);
        if !numbers.all(|expr| is_known(&expr)) {
            errors.push_with_hint(
                joint.place,
                format!(
                    "bodies fixed to joint {} have numbers too large for 64 bits",
                    quoted(&joint.name)
                ),
                "give lengths in m, masses in kg and inertias in kg m²",
            );
        }
    }
    errors.into_result(chain)
}

/// Errors of one item.
struct Account<'e> {
    place: Place,
    what: String,
    errors: &'e mut Errors,
}

impl Account<'_> {
    fn refuse(&mut self, place: Place, reason: &str) {
        let place = match place {
            Place::Unknown => self.place,
            known => known,
        };
        self.errors.push(place, format!("{} {reason}", self.what));
    }

    fn numbers(&mut self, numbers: &[Number]) {
        for number in numbers {
            if !number.value.is_finite() {
                self.refuse(number.place, "has a number that is not finite");
            } else if number.value.abs() > LARGEST {
                self.refuse(number.place, "has a number that is too large");
            }
        }
    }

    fn angle(&mut self, angle: &Number) {
        self.numbers(std::slice::from_ref(angle));
        if angle.value.is_finite() && angle.value.abs() > LARGEST_ANGLE {
            self.refuse(
                angle.place,
                "has an angle so large that its digits do not resolve a revolution",
            );
        }
    }

    fn steps(&mut self, steps: &[Step]) {
        for step in steps {
            match step {
                Step::Translate(offset) => self.numbers(offset),
                Step::Rotate(_, angle) => self.angle(angle),
                Step::Quaternion(entries) => {
                    self.numbers(entries);
                    if entries.iter().all(|entry| entry.value == 0.0) {
                        self.refuse(entries[0].place, "has a quaternion that is zero");
                    }
                }
            }
        }
    }
}

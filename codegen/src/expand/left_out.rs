//! Functions that are left out when all functions of a robot were requested.
//!
//! In: the reason why a function is refused. Out: the entry for comments and the command line.

use crate::check::is_fault;
use crate::error::Errors;
use crate::function::Function;
use crate::module::LeftOut;

/// The functions that need a frame, left out because no tip is named.
pub(super) fn functions_with_a_frame() -> LeftOut {
    let all = Function::ALL.into_iter();
    let with_a_frame = all.filter(|function| function.needs_a_frame());
    LeftOut {
        functions: with_a_frame
            .map(|function| function.name().to_owned())
            .collect(),
        reason: "the robot has more than one end, and none is named as the tip".to_owned(),
        hint: Some("name a link as the tip, or further frames".to_owned()),
        is_fault: false,
    }
}

/// Adds a function that the robot cannot have to the others with the same reason.
pub(super) fn leave_out(left_out: &mut Vec<LeftOut>, function: String, refusal: &Errors) {
    let reasons = refusal.diagnostics().iter();
    let reasons: Vec<String> = reasons.map(|reason| refusal.locate(reason)).collect();
    let reason = reasons.join("; ");
    if let Some(same) = left_out.iter_mut().find(|other| other.reason == reason) {
        same.functions.push(function);
    } else {
        let mut hints = refusal.diagnostics().iter();
        left_out.push(LeftOut {
            functions: vec![function],
            reason,
            hint: hints.find_map(|diagnostic| diagnostic.hint.clone()),
            is_fault: is_fault(refusal),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::leave_out;
    use crate::check::fault;
    use crate::error::{Errors, Place};

    #[test]
    fn a_fault_is_distinguished_from_functions_that_a_robot_cannot_have() {
        let mut unknown = Errors::new();
        unknown.push(Place::Unknown, "nothing has mass");
        let mut left_out = Vec::new();
        leave_out(
            &mut left_out,
            "regressor".to_owned(),
            &fault("entry 0 would be 1"),
        );
        leave_out(&mut left_out, "center_of_mass".to_owned(), &unknown);
        leave_out(
            &mut left_out,
            "center_of_mass_jacobian".to_owned(),
            &unknown,
        );
        let reported = left_out
            .iter()
            .map(|left_out| (left_out.functions.len(), left_out.is_fault));
        assert_eq!(reported.collect::<Vec<_>>(), [(1, true), (2, false)]);
    }
}

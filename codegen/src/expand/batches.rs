//! Which functions have no batches, though batches are asked for.
//!
//! In: the functions of a module. Out: the names that their batches would have, with the reason: a doubt where the
//! functions were named, a mistake where the request is strict, and left out where all that there are were meant. It
//! never decides which functions there are.

use crate::chain::Chain;
use crate::error::{Complaint, Errors, Place};
use crate::function::Function;
use crate::module::{About, GeneratedFunction, LeftOut};
use crate::wording::list;

/// Tells of missing batches.
///
/// # Errors
/// Where functions were named and the request is strict.
pub(super) fn tell(
    functions: &[GeneratedFunction],
    chain: &Chain,
    about: &mut About,
) -> Result<(), Errors> {
    let missing = missing(functions, chain.spaces().actions() > 0);
    let request = &chain.request;
    if request.functions.is_empty() {
        about.left_out.extend(missing);
        return Ok(());
    }
    let mut errors = Errors::new();
    for LeftOut {
        functions,
        reason,
        hint,
        ..
    } in missing
    {
        let functions = list(functions.iter().map(String::as_str));
        let message = format!("there is no {functions}: {reason}");
        let complaint = |message| Complaint {
            place: Place::Unknown,
            message,
            hint,
        };
        if request.strict {
            errors.record(complaint(format!("{message} (refused: strict)")));
        } else {
            about.warnings.push(complaint(message));
        }
    }
    errors.into_result(())
}

/// The batches that are missing, those for the same reason together; `acted` where actions from outside enter.
fn missing(functions: &[GeneratedFunction], acted: bool) -> Vec<LeftOut> {
    let mut missing: Vec<LeftOut> = Vec::new();
    for generated in functions {
        let Some((reason, hint)) = reason(generated, acted) else {
            continue;
        };
        let name = format!("{}_batch", generated.name());
        match missing.iter_mut().find(|other| other.reason == reason) {
            Some(same) => same.functions.push(name),
            None => missing.push(LeftOut {
                functions: vec![name],
                reason: reason.to_owned(),
                hint: hint.map(str::to_owned),
                is_fault: false,
            }),
        }
    }
    missing
}

/// Why a function has no batches, and what could be done; none where it has.
fn reason(
    generated: &GeneratedFunction,
    acted: bool,
) -> Option<(&'static str, Option<&'static str>)> {
    match *generated.functions {
        [function] if generated.frame.is_none() => match function {
            _ if function.has_batches(acted) => None,
            _ if Function::ALL.contains(&function) => Some((
                "functions that actions from outside enter have no batches",
                None,
            )),
            _ => Some(("functions of closed loops have no batches", None)),
        },
        [_] => {
            let hint = "derive another robot with that link as the tip";
            Some(("functions of further frames have no batches", Some(hint)))
        }
        _ => {
            let hint = "ask for each by itself besides";
            Some((
                "functions that share their work have no batches",
                Some(hint),
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::expand;
    use crate::description::{Description, Name, read_text};
    use crate::error::{Errors, Place};
    use crate::function::Function;
    use crate::module::Module;
    use crate::request::Request;

    fn two_link() -> Description {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");
        let text = std::fs::read_to_string(path).expect("it is in the repository");
        read_text(&text, "two_link.urdf", None, &mut Errors::new()).expect("a robot")
    }

    fn named(text: &str) -> Name {
        Name {
            text: text.to_owned(),
            place: Place::Unknown,
        }
    }

    /// Batches of functions alone and together, of a further frame, under actions.
    fn pushed() -> Request {
        use Function::{Bias, BodyJacobian, Gravity, InverseDynamics, MassMatrix};
        Request {
            functions: vec![
                vec![Gravity],
                vec![MassMatrix, Bias],
                vec![InverseDynamics],
                vec![BodyJacobian],
            ],
            frames: vec![named("fore")],
            external: vec![named("fore")],
            batch: true,
            ..Request::default()
        }
    }

    fn doubts(request: &Request) -> Module {
        expand(&two_link(), request).expect("an arm")
    }

    #[test]
    fn what_has_no_batch_though_it_was_asked_for_is_named_with_the_reason() {
        let doubts = doubts(&pushed()).about.located_warnings();
        let expected = [
            "there is no mass_matrix_and_bias_batch: functions that share their work have no batches",
            "there is no inverse_dynamics_batch: functions that actions from outside enter have no batches",
            "there is no body_jacobian_of_fore_batch: functions of further frames have no batches",
        ];
        assert_eq!(doubts, expected);
        let strict = Request {
            strict: true,
            ..pushed()
        };
        let refused = expand(&two_link(), &strict)
            .expect_err("strict")
            .to_string();
        let lines: Vec<&str> = refused
            .lines()
            .filter(|line| line.starts_with("error: "))
            .collect();
        let expected = expected.map(|doubt| format!("error: {doubt} (refused: strict)"));
        assert_eq!(lines, expected, "{refused}");
    }

    #[test]
    fn of_all_functions_it_is_told_where_they_are_listed() {
        let all = Request {
            functions: Vec::new(),
            ..pushed()
        };
        let about = doubts(&all).about;
        assert!(about.warnings.is_empty(), "{:?}", about.warnings);
        let mut missing = about.left_out.iter();
        let acted = missing
            .find(|missing| missing.reason.contains("actions"))
            .expect("there are some");
        let expected = [
            "inverse_dynamics_batch",
            "forward_dynamics_batch",
            "inverse_dynamics_derivatives_batch",
            "forward_dynamics_derivatives_batch",
        ];
        assert_eq!(acted.functions, expected);
    }

    #[test]
    fn nothing_is_said_where_all_have_batches_or_none_was_asked_for() {
        let gravity = Request {
            functions: vec![vec![Function::Gravity], vec![Function::BodyJacobian]],
            batch: true,
            ..Request::default()
        };
        let without = Request {
            batch: false,
            ..pushed()
        };
        for request in [gravity, without] {
            let about = doubts(&request).about;
            assert!(about.warnings.is_empty() && about.left_out.is_empty());
        }
    }
}

//! Functions without batches, although batches are requested.
//!
//! In: the functions of a module. Out: the names that their batches would have, with the reason: a warning if the
//! functions were named, an error if the request is strict, and an entry of what is left out if all functions were
//! requested.

use crate::chain::Chain;
use crate::error::{Diagnostic, Errors, Place};
use crate::function::Function;
use crate::module::{About, GeneratedFunction, LeftOut};
use crate::wording::list;

/// Reports missing batches.
///
/// # Errors
/// If functions were named and the request is strict.
pub(super) fn report(
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
        let diagnostic = |message| Diagnostic {
            place: Place::Unknown,
            message,
            hint,
        };
        if request.strict {
            errors.record(diagnostic(format!("{message} (refused: strict)")));
        } else {
            about.warnings.push(diagnostic(message));
        }
    }
    errors.into_result(())
}

/// The missing batches, grouped by reason; `acted` if external wrenches are an argument.
fn missing(functions: &[GeneratedFunction], has_external: bool) -> Vec<LeftOut> {
    let mut missing: Vec<LeftOut> = Vec::new();
    for generated in functions {
        let Some((reason, hint)) = reason(generated, has_external) else {
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

/// The reason why a function has no batch, and a hint; `None` if it has one.
fn reason(
    generated: &GeneratedFunction,
    has_external: bool,
) -> Option<(&'static str, Option<&'static str>)> {
    match *generated.functions {
        [function] if generated.frame.is_none() => match function {
            _ if function.has_batches(has_external) => None,
            _ if Function::ALL.contains(&function) => {
                Some(("functions with external wrenches have no batches", None))
            }
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

    /// Batches of functions alone and together, of a further frame, with external wrenches.
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

    fn module(request: &Request) -> Module {
        expand(&two_link(), request).expect("an arm")
    }

    #[test]
    fn a_requested_batch_that_does_not_exist_is_named_with_the_reason() {
        let warnings = module(&pushed()).about.located_warnings();
        let expected = [
            "there is no mass_matrix_and_bias_batch: functions that share their work have no batches",
            "there is no inverse_dynamics_batch: functions with external wrenches have no batches",
            "there is no body_jacobian_of_fore_batch: functions of further frames have no batches",
        ];
        assert_eq!(warnings, expected);
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
        let expected = expected.map(|warning| format!("error: {warning} (refused: strict)"));
        assert_eq!(lines, expected, "{refused}");
    }

    #[test]
    fn missing_batches_of_all_functions_are_listed_as_left_out() {
        let all = Request {
            functions: Vec::new(),
            ..pushed()
        };
        let about = module(&all).about;
        assert!(about.warnings.is_empty(), "{:?}", about.warnings);
        let mut missing = about.left_out.iter();
        let with_external = missing
            .find(|missing| missing.reason.contains("external wrenches"))
            .expect("there are some");
        let expected = [
            "inverse_dynamics_batch",
            "forward_dynamics_batch",
            "inverse_dynamics_derivatives_batch",
            "inverse_dynamics_vjp_batch",
            "inverse_dynamics_jvp_batch",
            "inverse_dynamics_hessian_batch",
            "forward_dynamics_derivatives_batch",
            "forward_dynamics_vjp_batch",
            "forward_dynamics_jvp_batch",
            "forward_dynamics_hessian_batch",
            "forward_dynamics_parameter_derivatives_batch",
        ];
        assert_eq!(with_external.functions, expected);
    }

    #[test]
    fn there_is_no_report_if_all_have_batches_or_none_was_requested() {
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
            let about = module(&request).about;
            assert!(about.warnings.is_empty() && about.left_out.is_empty());
        }
    }
}

//! `joint hip: composite(yaw: revolute(z) { limits: […] }, roll: revolute(x)) { from: …, to: …, at: … }`.
//!
//! A composite is written as one joint and read as several in series, with the names `hip.yaw` and `hip.roll`. Massless
//! links with the names of their joints are between them. The placement `at` of the whole comes before that of the
//! first motion.

use syn::parse::ParseStream;
use syn::{Token, token};

use super::body;
use super::joint::{self, InlineJoint, KEYS};
use crate::description::Name;
use crate::description::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use crate::error::Errors;
use crate::joint::actuator::ActuatorQuantity;
use crate::joint::entry;
use crate::wording::quoted;

/// The word for the type.
pub(in crate::description) const WORD: &str = "composite";

/// The keys of one motion: all except those that name links.
const OF_ONE: [&str; 6] = ["at", "limits", "velocity", "mimic", "multiplier", "offset"];

/// True if a composite follows.
pub(super) fn is_next(input: ParseStream) -> bool {
    tokens::word(&input.fork()).is_ok_and(|word| word == WORD)
}

/// Reads a composite after its name.
pub(super) fn read(
    name: &Name,
    input: ParseStream,
    errors: &mut Errors,
) -> Parsed<Vec<InlineJoint>> {
    let subject = format!("joint {}", quoted(&name.text));
    let word = tokens::word(input)?;
    let mut joints = if input.peek(token::Paren) {
        motions(name, &tokens::parentheses(input)?, errors)
    } else {
        Vec::new()
    };
    if joints.is_empty() && errors.is_empty() {
        let message = format!("{subject} has no motions");
        let hint = "write composite(yaw: revolute(z), roll: revolute(x))";
        tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
    }
    body::end(input, &subject)?;
    let (mut from, mut to, mut at) = (None, None, Vec::new());
    let actuator = ActuatorQuantity::ALL.map(ActuatorQuantity::word);
    let keys: Vec<&str> = KEYS.into_iter().chain(actuator).collect();
    tokens::fields(input, &subject, &keys, errors, |key, input| {
        match key {
            "from" => from = Some(tokens::name(input)?),
            "to" => to = Some(tokens::name(input)?),
            "at" => at = joint::placement(input, &subject)?,
            _ => {
                let message = format!(
                    "{subject} has the key {} for all of its motions",
                    quoted(key)
                );
                let hint = format!("write it after one of them: yaw: revolute(z) {{ {key}: … }}");
                return Err(diagnostic_with_hint(input.span(), message, hint));
            }
        }
        Ok(())
    })?;
    if let Some(first) = joints.first_mut() {
        at.append(&mut first.origin);
        first.origin = at;
        first.from = from;
    }
    if let Some(last) = joints.last_mut() {
        last.to = to;
        last.is_between = false;
    }
    Ok(joints)
}

/// `yaw: revolute(z) { limits: […] }, roll: revolute(x)`: each motion's parent is the child of the one before.
fn motions(whole: &Name, input: ParseStream, errors: &mut Errors) -> Vec<InlineJoint> {
    let mut joints: Vec<InlineJoint> = Vec::new();
    while !input.is_empty() {
        match motion(whole, input, errors) {
            Ok(mut joint) => {
                joint.from = joints.last().and_then(|before| before.to.clone());
                joints.push(joint);
                if !input.is_empty() && !input.peek(Token![,]) {
                    let message = "expected `,` between two motions";
                    tokens::push(errors, diagnostic(input.span(), message));
                }
            }
            Err(diagnostic) => tokens::push(errors, diagnostic),
        }
        tokens::skip(input, |token| tokens::is_punctuation(token, ','));
    }
    joints
}

/// One motion, with the link that it moves.
fn motion(whole: &Name, input: ParseStream, errors: &mut Errors) -> Parsed<InlineJoint> {
    let Name { text, place } = joint::named(input)?;
    let name = Name {
        text: entry(&whole.text, &text),
        place,
    };
    let mut joint = joint::of(name, &OF_ONE, input, errors)?;
    joint.to = Some(joint.name().clone());
    joint.is_between = true;
    Ok(joint)
}

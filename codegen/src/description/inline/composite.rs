//! `joint hip: composite(yaw: revolute(z) { limits: […] }, roll: revolute(x)) { from: …, to: …, at: … }`.
//!
//! In: tokens. Out: the joints that it is composed of, from the link that it hangs on outwards, each called by
//! both names, `hip.yaw`, and all but the last with a link without mass, called as the joint. The first
//! stands where the whole does, and where it is itself told to. What is composed knows nothing of it
//! afterwards: a composite is a way of writing.

use syn::parse::ParseStream;
use syn::{Token, token};

use super::body;
use super::joint::{self, Joint, KEYS};
use crate::description::Name;
use crate::description::tokens::{self, Parsed, complaint, complaint_with_hint};
use crate::error::Errors;
use crate::joint::drive::Part;
use crate::joint::entry;
use crate::wording::quoted;

/// What it is called.
pub(in crate::description) const WORD: &str = "composite";

/// The keys of one motion: all but those that name links.
const OF_ONE: [&str; 6] = ["at", "limits", "velocity", "mimic", "multiplier", "offset"];

/// Whether a composite stands there.
pub(super) fn is_next(input: ParseStream) -> bool {
    tokens::word(&input.fork()).is_ok_and(|word| word == WORD)
}

/// Reads a composite behind its name.
pub(super) fn read(name: Name, input: ParseStream, errors: &mut Errors) -> Parsed<Vec<Joint>> {
    let subject = format!("joint {}", quoted(&name.text));
    let word = tokens::word(input)?;
    let mut joints = if input.peek(token::Paren) {
        motions(&name, &tokens::parentheses(input)?, errors)
    } else {
        Vec::new()
    };
    if joints.is_empty() && errors.is_empty() {
        let message = format!("{subject} is composed of nothing");
        let hint = "write composite(yaw: revolute(z), roll: revolute(x))";
        tokens::push(errors, complaint_with_hint(word.span(), message, hint));
    }
    body::end(input, &subject)?;
    let (mut from, mut to, mut at) = (None, None, Vec::new());
    let drive = Part::ALL.map(Part::word);
    let keys: Vec<&str> = KEYS.into_iter().chain(drive).collect();
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
                let hint = format!("write it behind one: yaw: revolute(z) {{ {key}: … }}");
                return Err(complaint_with_hint(input.span(), message, hint));
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

/// `yaw: revolute(z) { limits: […] }, roll: revolute(x)`: each on the link that the one before it carries.
fn motions(whole: &Name, input: ParseStream, errors: &mut Errors) -> Vec<Joint> {
    let mut joints: Vec<Joint> = Vec::new();
    while !input.is_empty() {
        match motion(whole, input, errors) {
            Ok(mut joint) => {
                joint.from = joints.last().and_then(|before| before.to.clone());
                joints.push(joint);
                if !input.is_empty() && !input.peek(Token![,]) {
                    let message = "expected `,` between two motions";
                    tokens::push(errors, complaint(input.span(), message));
                }
            }
            Err(complaint) => tokens::push(errors, complaint),
        }
        tokens::skip(input, |token| tokens::is_punctuation(token, ','));
    }
    joints
}

/// One of them, with the link that it carries.
fn motion(whole: &Name, input: ParseStream, errors: &mut Errors) -> Parsed<Joint> {
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

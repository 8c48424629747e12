//! Settings that say which forces are modelled beside those of bodies and of gravity.
//!
//! In: a key and what follows it. Out: drives of joints, and links on which the surroundings act, as part
//! of a [`Request`]. It never knows whether there is such a joint or link.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::{Ident, Token, token};

use super::in_parentheses;
use crate::description::tokens::{self, Parsed, complaint_with_hint};
use crate::joint::drive::Part;
use crate::request::Request;
use crate::wording::quoted;

/// The keys.
pub(super) const KEYS: [&str; 7] = [
    "friction", "damping", "armature", "rotor", "ratio", "rotors", "external",
];

/// Reads what follows one of them.
pub(super) fn read(input: ParseStream, key: &Ident, request: &mut Request) -> Parsed<()> {
    let text = key.to_string();
    match (text.as_str(), Part::from_word(&text)) {
        ("rotors", _) => request.rotors = true,
        ("friction", _) if !has_value(input) => request.friction = true,
        (_, Some(part)) => {
            let content = in_parentheses(input, key, &format!("{key}(joint = 0.1)"))?;
            let said = tokens::list(&content, |input| {
                let name = tokens::name(input)?;
                tokens::separator(input, key)?;
                let subject = format!("the {key} of joint {}", quoted(&name.text));
                Ok((name, part, tokens::one_or_more(input, &subject)?))
            })?;
            request.drives.extend(said);
        }
        (_, None) => {
            let content = in_parentheses(input, key, "external(gripper)")?;
            tokens::list(&content, |input| external(input, request))?;
        }
    }
    Ok(())
}

/// A link, or `frame = 0`.
fn external(input: ParseStream, request: &mut Request) -> Parsed<()> {
    let name = tokens::name(input)?;
    if !input.peek(Token![=]) && !input.peek(Token![:]) {
        request.external.push(name);
        return Ok(());
    }
    let hint = "write external(gripper), or external(gripper, frame = 0)";
    let word = Ident::new("frame", Span::call_site());
    tokens::separator(input, &word)?;
    let span = input.span();
    let zero = tokens::number(input, "the frame of the actions")?.value == 0.0;
    if name.text == "frame" && zero {
        request.external_in_frame_0 = true;
        return Ok(());
    }
    let message = "actions are in the frames of their links, or all in frame 0";
    Err(complaint_with_hint(span, message, hint))
}

/// Whether more than the word is there.
fn has_value(input: ParseStream) -> bool {
    input.peek(token::Paren) || input.peek(Token![=]) || input.peek(Token![:])
}

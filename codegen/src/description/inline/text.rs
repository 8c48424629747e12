//! Inline descriptions as texts by themselves, for programs that are not written in Rust.
//!
//! In: a text in the grammar of `chain!`. Out: a [`Description`] whose places are lines and columns of the text. The
//! struct at its beginning, whose name is that of the robot, may be left out. Settings are rejected: they are options
//! where the text is read.

use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Ident, Token, Visibility, token};

use super::contents::{Contents, add, assemble, entries};
use crate::description::fingerprint::fingerprint;
use crate::description::tokens::{self, Parsed};
use crate::description::{Description, Inertial, Name, Number, Source, Step};
use crate::error::{Errors, Place};
use crate::joint::actuator::ActuatorQuantity;
use crate::wording::quoted;

/// Words that an inline description begins with.
const BEGINNINGS: [&str; 3] = ["link", "pub", "struct"];

/// Name of a robot without a struct.
const UNNAMED: &str = "robot";

/// True if a text begins as an inline description, and as no Denavit–Hartenberg table.
pub(in crate::description) fn is_inline(text: &str) -> bool {
    let mut rest = text.trim_start_matches('\u{feff}').trim_start();
    loop {
        let end = match rest {
            _ if rest.starts_with("//") => "\n",
            _ if rest.starts_with("/*") => "*/",
            _ => break,
        };
        let Some(at) = rest.find(end) else {
            return false;
        };
        rest = rest[at + end.len()..].trim_start();
    }
    let is_letter = |letter: char| letter.is_alphanumeric() || letter == '_';
    let word = rest.split(|letter| !is_letter(letter)).next();
    word.is_some_and(|word| BEGINNINGS.contains(&word))
}

/// Reads the text of `file`, which is a name for messages.
///
/// A description returned together with errors is partial.
pub(in crate::description) fn read(
    text: &str,
    file: &str,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, None);
    let mut found = Errors::new();
    let description = in_tokens(text.trim_start_matches('\u{feff}'), &mut found);
    errors.append(found.placed(in_text));
    description.map(|mut description| {
        each_place(&mut description, &mut |place| *place = in_text(*place));
        for warning in &mut description.warnings {
            warning.place = in_text(warning.place);
        }
        note_actuators(&mut description);
        description.source = Source {
            file: Some(file.to_owned()),
            hash: fingerprint(text.as_bytes()),
            ..Source::default()
        };
        description
    })
}

/// The same with the places of tokens.
fn in_tokens(text: &str, errors: &mut Errors) -> Option<Description> {
    let tokens = match text.parse::<TokenStream>() {
        Ok(tokens) => tokens,
        Err(reason) => {
            let message = "this is no word, number, string or bracket with its counterpart";
            errors.push(Place::Token(reason.span()), message);
            return None;
        }
    };
    if let Err(diagnostic) = tokens::check_depth(&tokens) {
        tokens::push(errors, diagnostic);
        return None;
    }
    let mut found = None;
    let parser = |input: ParseStream| {
        match parts(input, errors) {
            Ok(parts) => found = Some(parts),
            Err(diagnostic) => tokens::push(errors, diagnostic),
        }
        tokens::skip(input, |_| false);
        Ok(())
    };
    // Errors were reported where they were found.
    let _ = parser.parse2(tokens);
    let (ident, contents) = found?;
    for setting in &contents.settings.seen {
        errors.push_with_hint(
            Place::Token(setting.span()),
            format!(
                "the setting {} stands in a text",
                quoted(&setting.to_string())
            ),
            "a text has links, joints and loops; give settings as options where it is read",
        );
    }
    let mut description = assemble(contents.elements, &ident, errors);
    add(&mut description, contents.loops, errors);
    Some(description)
}

/// Notes friction and inertias of actuators, which a request models as it does those of any file.
fn note_actuators(description: &mut Description) {
    for joint in &description.joints {
        let subject = format!("joint {}", quoted(&joint.name.text));
        let quantities = ActuatorQuantity::ALL.into_iter();
        let (resisting, inertias): (Vec<ActuatorQuantity>, Vec<ActuatorQuantity>) = quantities
            .filter(|&quantity| !joint.actuator.of(quantity).is_empty())
            .partition(|quantity| quantity.resists());
        let unmodelled = &mut description.unmodelled;
        if !resisting.is_empty() {
            let words = resisting.into_iter().map(ActuatorQuantity::word).collect();
            unmodelled.friction(joint.place, &subject, words);
        }
        if !inertias.is_empty() {
            unmodelled.armature(joint.place, &subject);
        }
    }
}

/// The name of the struct, if there is one, and everything in its braces and behind it.
fn parts(input: ParseStream, errors: &mut Errors) -> Parsed<(Ident, Contents)> {
    let mut contents = Contents::default();
    let mut ident = Ident::new(UNNAMED, input.span());
    input.call(Attribute::parse_outer)?;
    input.parse::<Visibility>()?;
    if input.peek(Token![struct]) {
        input.parse::<Token![struct]>()?;
        ident = input.call(Ident::parse_any)?;
        if input.peek(token::Brace) {
            entries(&tokens::braces(input)?, &mut contents, errors);
        }
    }
    entries(input, &mut contents, errors);
    Ok((ident, contents))
}

/// The line and the column of a token.
fn in_text(place: Place) -> Place {
    let Place::Token(span) = place else {
        return place;
    };
    let start = span.start();
    let [line, column] = [start.line, start.column + 1];
    let [line, column] = [line, column].map(|number| u32::try_from(number).unwrap_or(u32::MAX));
    Place::File { line, column }
}

/// All places of a description without its warnings.
fn each_place(description: &mut Description, change: &mut impl FnMut(&mut Place)) {
    change(&mut description.name.place);
    for link in &mut description.links {
        change(&mut link.name.place);
        if let Some(Inertial {
            origin,
            mass,
            inertia,
            place,
        }) = &mut link.inertial
        {
            steps(origin, change);
            numbers([mass], change);
            numbers(inertia, change);
            change(place);
        }
    }
    for joint in &mut description.joints {
        names(
            [&mut joint.name, &mut joint.parent, &mut joint.child],
            change,
        );
        steps(&mut joint.origin, change);
        numbers(joint.axis.iter_mut().chain(&mut joint.second_axis), change);
        if let Some(mimic) = &mut joint.mimic {
            names([&mut mimic.mimicked], change);
            numbers([&mut mimic.multiplier, &mut mimic.offset], change);
            change(&mut mimic.place);
        }
        for quantity in ActuatorQuantity::ALL {
            let mut terms = joint.actuator.of(quantity).to_vec();
            numbers(&mut terms, change);
            joint.actuator.say(quantity, terms);
        }
        change(&mut joint.place);
    }
    for closing in &mut description.loops {
        names(
            [&mut closing.name, &mut closing.from, &mut closing.to],
            change,
        );
        steps(&mut closing.at, change);
        steps(&mut closing.to_at, change);
        numbers(closing.axes.iter_mut().flatten(), change);
    }
}

fn names<'n>(names: impl IntoIterator<Item = &'n mut Name>, change: &mut impl FnMut(&mut Place)) {
    names.into_iter().for_each(|name| change(&mut name.place));
}

fn numbers<'n>(
    numbers: impl IntoIterator<Item = &'n mut Number>,
    change: &mut impl FnMut(&mut Place),
) {
    let numbers = numbers.into_iter();
    numbers.for_each(|number| change(&mut number.place));
}

fn steps(steps: &mut [Step], change: &mut impl FnMut(&mut Place)) {
    for step in steps {
        match step {
            Step::Translate(entries) => numbers(entries, change),
            Step::Rotate(_, angle) => numbers([angle], change),
            Step::Quaternion(entries) => numbers(entries, change),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::is_inline;
    use crate::chain::Chain;
    use crate::description::read_text;
    use crate::error::Errors;
    use crate::expand::understand;
    use crate::request::Request;

    /// The robot of a text, or all messages about it.
    fn chain(text: &str) -> Result<Chain, String> {
        let mut errors = Errors::new();
        let read = read_text(text, "<text>", None, &mut errors);
        let found = match read {
            Some(description) => errors.into_result(description),
            None => Err(errors),
        };
        let chain = found.and_then(|robot| understand(&robot, &Request::default()));
        chain.map_err(|errors| errors.to_string())
    }

    #[test]
    fn inline_descriptions_are_told_from_tables() {
        for text in [
            "link base;",
            "// an arm\n/* of two\nlinks */ struct Arm;\nlink base;",
            "\u{feff}\n\npub struct Arm { }",
        ] {
            assert!(is_inline(text), "{text}");
        }
        for text in [
            "# link base;\nconvention modified\njoint kind a alpha d theta",
            "convention standard",
            "joint kind a alpha d theta",
            "linkage",
            "// nothing",
            "",
        ] {
            assert!(!is_inline(text), "{text}");
        }
    }

    #[test]
    fn a_text_is_a_robot_with_or_without_a_struct() {
        let parts = "link ceiling; joint hinge: revolute(y);\nlink bob { mass: 1.0, com: [0, 0, -0.5], inertia: [0, 0, 0] }";
        let alone = chain(parts).unwrap();
        let named = chain(&format!("/// Swings.\npub struct Pendulum;\n{parts}")).unwrap();
        let names = [alone, named].map(|chain| chain.description.name.text.clone());
        assert_eq!(names, ["robot", "Pendulum"]);
    }

    #[test]
    fn friction_is_modelled_on_request_as_that_of_a_file() {
        let text = "link a;\njoint j: revolute(y) { damping: 0.1, armature: 0.2 }\nlink b { mass: 1.0, inertia: [0, 0, 0] }";
        let chain = chain(text).unwrap();
        let warnings: Vec<&str> = chain
            .report
            .warnings
            .iter()
            .map(|of| &*of.message)
            .collect();
        let found = warnings.join("\n");
        assert!(
            found.contains("not modelled: damping of joint \"j\""),
            "{found}"
        );
        assert!(
            found.contains("not modelled: the armature of joint \"j\""),
            "{found}"
        );
    }

    #[test]
    fn mistakes_have_lines_and_columns_of_the_text() {
        for (text, messages) in [
            (
                "link a;\njoint j: revolte(y);\nlink b;",
                "error: <text>:2:10: ",
            ),
            ("link a;\nlink b { mass: 1.0", "error: <text>:2:8: "),
            ("link a;\nlink a;", "error: <text>:2:6: "),
            (
                "struct A {\n  tip: b }\nlink a;\njoint j: revolute(y);\nlink b;",
                "error: <text>:2:3: the setting \"tip\" stands in a text\n",
            ),
            (
                "link a;\njoint j: revolute(y);\nlink b { mass: 1.0, inertia: [1.0, 1.0, 9.0] }\njoint k: revolute(x);\nlink c { mass: -1.0 }",
                "error: <text>:5:",
            ),
        ] {
            let found = chain(text).unwrap_err();
            assert!(found.starts_with(messages), "{found}");
        }
    }
}

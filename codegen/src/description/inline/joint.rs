//! `joint NAME: revolute(z) { from: …, to: …, at: …, limits: […], velocity: … }`.
//!
//! In: tokens. Out: a joint whose links may still be open. The axis is `x`, `y`, `z`, `-z` and so
//! on, or a vector (of another length than 1 with a doubt); a screw joint adds `pitch: 0.01`, in metres per radian.

use syn::parse::ParseStream;
use syn::{Token, token};

use super::body;
use crate::description::kind;
use crate::description::tokens::{self, Parsed, complaint, complaint_with_hint};
use crate::description::{Axis, Limits, Name, Number, Step, axis, number};
use crate::error::{Complaint, Errors, Place};
use crate::joint::{Definition, JointKind};
use crate::wording::{known, quoted};

/// A joint, its links known as far as they were named.
pub(super) struct Joint {
    name: Name,
    motion: Option<Motion>,
    pub(super) from: Option<Name>,
    pub(super) to: Option<Name>,
    origin: Vec<Step>,
    limits: Option<Limits>,
    /// What is doubtful about it.
    pub(super) doubts: Vec<Complaint>,
}

/// What a joint allows, and along or about which axis.
struct Motion {
    kind: JointKind,
    axis: [Number; 3],
    doubt: Option<Complaint>,
}

/// Reads a joint behind the word `joint`.
pub(super) fn read(input: ParseStream, errors: &mut Errors) -> Parsed<Joint> {
    let name = tokens::name(input)?;
    let subject = format!("joint {}", quoted(&name.text));
    if !input.peek(Token![:]) {
        let hint = "write joint elbow: revolute(z)";
        let message = format!("expected `:` after {subject}");
        return Err(complaint_with_hint(input.span(), message, hint));
    }
    input.parse::<Token![:]>()?;
    let mut motion = motion(input, &subject, errors)?;
    body::end(input, &subject)?;
    let doubt = motion.as_mut().and_then(|motion| motion.doubt.take());
    let mut joint = Joint {
        name,
        motion,
        doubts: doubt.into_iter().collect(),
        from: None,
        to: None,
        origin: Vec::new(),
        limits: None,
    };
    let mut range = Range::default();
    let keys = ["from", "to", "at", "limits", "velocity"];
    tokens::fields(input, &subject, &keys, errors, |key, input| {
        match key {
            "from" => joint.from = Some(tokens::name(input)?),
            "to" => joint.to = Some(tokens::name(input)?),
            "at" => joint.origin = placement(input, &subject)?,
            _ => range.read(key, input, &subject)?,
        }
        Ok(())
    })?;
    joint.limits = range.finish();
    Ok(joint)
}

impl Joint {
    /// The joint between its links; complains where one is not known.
    pub(super) fn finish(self, errors: &mut Errors) -> Option<crate::description::Joint> {
        let subject = format!("joint {}", quoted(&self.name.text));
        let place = self.name.place;
        if self.from.is_none() {
            let message = format!("{subject} hangs on no link");
            let hint = "name it, from: base, or write the link before the joint";
            errors.push_with_hint(place, message, hint);
        }
        if self.to.is_none() {
            let message = format!("{subject} carries no link");
            let hint = "name it, to: upper, or write the link after the joint";
            errors.push_with_hint(place, message, hint);
        }
        let (parent, child) = (self.from?, self.to?);
        if parent.text == child.text {
            let message = format!("{subject} joins link {} to itself", quoted(&child.text));
            errors.push(place, message);
        }
        let motion = self.motion.unwrap_or_else(|| Motion {
            kind: JointKind::Fixed,
            axis: [1.0, 0.0, 0.0].map(|value| number::computed(value, place)),
            doubt: None,
        });
        Some(crate::description::Joint {
            name: self.name,
            kind: motion.kind,
            parent,
            child,
            origin: self.origin,
            axis: motion.axis,
            limits: self.limits,
            place,
        })
    }
}

/// `revolute(z)`, `screw(z, pitch: 0.01)`, `fixed`; none where it was refused.
fn motion(input: ParseStream, subject: &str, errors: &mut Errors) -> Parsed<Option<Motion>> {
    let word = tokens::word(input)?;
    let kind = match kind::read(&word.to_string(), subject) {
        Ok(kind) => kind,
        Err((message, hint)) => {
            tokens::push(errors, complaint_with_hint(word.span(), message, hint));
            if input.peek(token::Paren) {
                let content = tokens::parentheses(input)?;
                tokens::skip(&content, |_| false);
            }
            return Ok(None);
        }
    };
    let x = [1.0, 0.0, 0.0].map(|value| number::computed(value, Place::Token(word.span())));
    if !input.peek(token::Paren) {
        if !kind.moves() {
            let kind = JointKind::Fixed;
            return Ok(Some(Motion {
                kind,
                axis: x,
                doubt: None,
            }));
        }
        let message = format!("{subject} has no axis");
        let hint = format!("write {word}(z)");
        tokens::push(errors, complaint_with_hint(word.span(), message, hint));
        return Ok(None);
    }
    let content = tokens::parentheses(input)?;
    let motion = in_parentheses(&content, kind, subject);
    tokens::skip(&content, |_| false);
    Ok(motion
        .map_err(|complaint| tokens::push(errors, complaint))
        .ok())
}

fn in_parentheses(input: ParseStream, kind: &Definition, subject: &str) -> Parsed<Motion> {
    if !kind.moves() {
        let message = format!("{subject} is fixed and has no axis");
        return Err(complaint(input.span(), message));
    }
    let (axis, doubt) = direction(input, subject)?;
    let kind = kind.with_pitch(|| -> Parsed<Number> {
        let hint = "write screw(z, pitch: 0.01), in metres per radian";
        let missing = || complaint_with_hint(input.span(), format!("{subject} has no pitch"), hint);
        input.parse::<Token![,]>().map_err(|_| missing())?;
        let key = tokens::word(input).map_err(|_| missing())?;
        if key != "pitch" {
            return Err(missing());
        }
        tokens::separator(input, &key)?;
        tokens::number(input, &format!("the pitch of {subject}"))
    })?;
    if !input.is_empty() {
        let message = format!("expected `)` after the axis of {subject}");
        return Err(complaint(input.span(), message));
    }
    Ok(Motion { kind, axis, doubt })
}

/// `z`, `-z`, or a vector; and a doubt where that is not of length 1.
fn direction(input: ParseStream, subject: &str) -> Parsed<([Number; 3], Option<Complaint>)> {
    let span = input.span();
    let subject = format!("the axis of {subject}");
    if input.peek(token::Bracket) {
        let numbers = tokens::vector(input, &subject)?;
        let say = |remark: axis::Remark| {
            complaint_with_hint(span, format!("{subject} {}", remark.what), remark.hint)
        };
        return match axis::unit(numbers) {
            Ok((axis, doubt)) => Ok((axis, doubt.map(say))),
            Err(refusal) => Err(say(refusal)),
        };
    }
    let sign = if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        -1.0
    } else {
        1.0
    };
    let word = tokens::word(input).ok().map(|word| word.to_string());
    let axis = match word.as_deref() {
        Some("x") => [sign, 0.0, 0.0],
        Some("y") => [0.0, sign, 0.0],
        Some("z") => [0.0, 0.0, sign],
        _ => {
            let message = format!("{subject} is neither x, y, z nor a vector");
            let hint = "write revolute(z), revolute(-z) or revolute([0.0, 0.6, 0.8])";
            return Err(complaint_with_hint(span, message, hint));
        }
    };
    let axis = axis.map(|value| number::computed(value, Place::Token(span)));
    Ok((axis, None))
}

/// `xyz(…) rpy(…)`, or any other product of steps, from left to right.
fn placement(input: ParseStream, subject: &str) -> Parsed<Vec<Step>> {
    let mut steps = Vec::new();
    while !input.is_empty() && !input.peek(Token![,]) {
        let word = tokens::word(input)?;
        let text = word.to_string();
        let part = format!("{text} of {subject}");
        match text.as_str() {
            "xyz" => steps.push(Step::Translate(tokens::arguments(input, &part)?)),
            "rpy" => steps.extend(body::roll_pitch_yaw(tokens::arguments(input, &part)?)),
            "rx" => steps.push(turn(Axis::X, input, &part)?),
            "ry" => steps.push(turn(Axis::Y, input, &part)?),
            "rz" => steps.push(turn(Axis::Z, input, &part)?),
            _ => {
                let message = format!("{subject} is placed by the unknown step {}", quoted(&text));
                let hint = known(&text, "steps", &["xyz", "rpy", "rx", "ry", "rz"]);
                return Err(complaint_with_hint(word.span(), message, hint));
            }
        }
    }
    Ok(steps)
}

fn turn(axis: Axis, input: ParseStream, subject: &str) -> Parsed<Step> {
    let [angle] = tokens::arguments(input, subject)?;
    Ok(Step::Rotate(axis, angle))
}

/// What was given of the limits.
#[derive(Default)]
pub(super) struct Range {
    ends: Option<[f64; 2]>,
    velocity: Option<f64>,
}

impl Range {
    /// Reads the value of `limits` or `velocity`.
    pub(super) fn read(&mut self, key: &str, input: ParseStream, subject: &str) -> Parsed<()> {
        let span = input.span();
        if key == "velocity" {
            let subject = format!("the velocity limit of {subject}");
            self.velocity = Some(tokens::number(input, &subject)?.value);
            return Ok(());
        }
        let numbers: [Number; 2] = tokens::vector(input, &format!("limits of {subject}"))?;
        let [lower, upper] = numbers.map(|number| number.value);
        if lower > upper {
            return Err(complaint(
                span,
                format!("the lower limit of {subject}, {lower}, is above the upper one, {upper}"),
            ));
        }
        self.ends = Some([lower, upper]);
        Ok(())
    }

    /// The limits, where any were given.
    pub(super) fn finish(self) -> Option<Limits> {
        if self.ends.is_none() && self.velocity.is_none() {
            return None;
        }
        let [lower, upper] = self.ends.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        Some(Limits {
            lower,
            upper,
            velocity: self.velocity.unwrap_or(f64::INFINITY),
        })
    }
}

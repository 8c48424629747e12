//! `joint NAME: revolute(z) { from: …, to: …, at: …, limits: […], velocity: … }`.
//!
//! The axis is `x`, `y`, `z`, `-z` and so on, or a vector; a length other than 1 is a warning. A screw joint adds
//! `pitch: 0.01` in metres per radian, a universal joint its second axis; translation, spherical and floating joints
//! have none. A mimic joint has `mimic: other, multiplier: -1.0, offset: 0.1`; armature and friction are `armature: 0.01` and
//! `damping: 0.5`.

use syn::parse::ParseStream;
use syn::{Token, token};

use super::body;
use crate::description::kind;
use crate::description::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use crate::description::{Axis, Limits, Mimic, Name, Number, Step, axis, number};
use crate::error::{Diagnostic, Errors, Place};
use crate::joint::actuator::{Actuator, ActuatorQuantity};
use crate::joint::{Definition, JointKind};
use crate::wording::{known, quoted};

/// The keys of a joint, except those of armature, rotors and friction.
pub(in crate::description) const KEYS: [&str; 8] = [
    "from",
    "to",
    "at",
    "limits",
    "velocity",
    "mimic",
    "multiplier",
    "offset",
];

/// The steps of a placement.
pub(in crate::description) const STEPS: [&str; 5] = ["xyz", "rpy", "rx", "ry", "rz"];

/// A joint with the links named so far.
pub(super) struct InlineJoint {
    name: Name,
    motion: Option<InlineMotion>,
    pub(super) from: Option<Name>,
    pub(super) to: Option<Name>,
    pub(super) origin: Vec<Step>,
    limits: Option<Limits>,
    mimic: Option<Mimic>,
    /// Armature, rotors, damping and friction.
    pub(super) actuator: Actuator,
    /// True if the child link is a massless one between two motions, which has no entry in the text.
    pub(super) is_between: bool,
    /// Warnings.
    pub(super) warnings: Vec<Diagnostic>,
}

/// The type of a joint, with its axes.
struct InlineMotion {
    kind: JointKind,
    axes: [[Number; 3]; 2],
    warnings: Vec<Diagnostic>,
}

/// `NAME:`.
pub(super) fn named(input: ParseStream) -> Parsed<Name> {
    let name = tokens::name(input)?;
    if !input.peek(Token![:]) {
        let hint = "write joint elbow: revolute(z)";
        let message = format!("expected `:` after joint {}", quoted(&name.text));
        return Err(diagnostic_with_hint(input.span(), message, hint));
    }
    input.parse::<Token![:]>()?;
    Ok(name)
}

/// Reads type, axes and keys of a joint: some of [`KEYS`], and those of armature, rotors and friction.
pub(super) fn of(
    name: Name,
    keys: &[&str],
    input: ParseStream,
    errors: &mut Errors,
) -> Parsed<InlineJoint> {
    let subject = format!("joint {}", quoted(&name.text));
    let mut motion = motion(input, &subject, errors)?;
    body::end(input, &subject)?;
    let warnings = motion
        .as_mut()
        .map(|motion| std::mem::take(&mut motion.warnings));
    let mut joint = InlineJoint {
        name,
        motion,
        warnings: warnings.unwrap_or_default(),
        from: None,
        to: None,
        origin: Vec::new(),
        limits: None,
        mimic: None,
        actuator: Actuator::default(),
        is_between: false,
    };
    let mut limits = InlineLimits::default();
    let mut mimic_keys = MimicKeys::default();
    let actuator = ActuatorQuantity::ALL.map(ActuatorQuantity::word);
    let keys: Vec<&str> = keys.iter().copied().chain(actuator).collect();
    tokens::fields(input, &subject, &keys, errors, |key, input| {
        if let Some(quantity) = ActuatorQuantity::from_word(key) {
            let subject = format!("the {key} of {subject}");
            joint
                .actuator
                .say(quantity, tokens::one_or_more(input, &subject)?);
            return Ok(());
        }
        match key {
            "from" => joint.from = Some(tokens::name(input)?),
            "to" => joint.to = Some(tokens::name(input)?),
            "at" => joint.origin = placement(input, &subject)?,
            "mimic" | "multiplier" | "offset" => mimic_keys.read(key, input, &subject)?,
            _ => limits.read(key, input, &subject)?,
        }
        Ok(())
    })?;
    joint.limits = limits.finish();
    joint.mimic = mimic_keys.finish(&joint.name, errors);
    Ok(joint)
}

impl InlineJoint {
    /// The joint's name.
    pub(super) const fn name(&self) -> &Name {
        &self.name
    }

    /// The joint with its links; a missing link is an error.
    pub(super) fn finish(self, errors: &mut Errors) -> Option<crate::description::Joint> {
        let subject = format!("joint {}", quoted(&self.name.text));
        let place = self.name.place;
        if self.from.is_none() {
            let message = format!("{subject} has no parent link");
            let hint = "name it, from: base, or write the link before the joint";
            errors.push_with_hint(place, message, hint);
        }
        if self.to.is_none() {
            let message = format!("{subject} has no child link");
            let hint = "name it, to: upper, or write the link after the joint";
            errors.push_with_hint(place, message, hint);
        }
        let (parent, child) = (self.from?, self.to?);
        if parent.text == child.text {
            let message = format!("{subject} joins link {} to itself", quoted(&child.text));
            errors.push(place, message);
        }
        let motion = self.motion.unwrap_or_else(|| InlineMotion {
            kind: JointKind::Fixed,
            axes: [along_x(place); 2],
            warnings: Vec::new(),
        });
        let [axis, second_axis] = motion.axes;
        Some(crate::description::Joint {
            name: self.name,
            kind: motion.kind,
            parent,
            child,
            origin: self.origin,
            axis,
            second_axis,
            limits: self.limits,
            mimic: self.mimic,
            actuator: self.actuator,
            place,
        })
    }
}

/// `revolute(z)`, `screw(z, pitch: 0.01)`, `fixed`; `None` after a reported error.
fn motion(input: ParseStream, subject: &str, errors: &mut Errors) -> Parsed<Option<InlineMotion>> {
    let word = tokens::word(input)?;
    let kind = match kind::read(&word.to_string(), subject) {
        Ok(kind) => kind,
        Err((message, hint)) => {
            tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
            if input.peek(token::Paren) {
                let content = tokens::parentheses(input)?;
                tokens::skip(&content, |_| false);
            }
            return Ok(None);
        }
    };
    if !input.peek(token::Paren) {
        if kind.axes() == 0 {
            return Ok(Some(InlineMotion {
                kind: kind.with_pitch(|| Ok::<_, Diagnostic>(Number::default()))?,
                axes: [along_x(Place::Token(word.span())); 2],
                warnings: Vec::new(),
            }));
        }
        let message = format!("{subject} has no axis");
        let axes = ["z", "x, y"][kind.axes() - 1];
        let hint = format!("write {word}({axes})");
        tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
        return Ok(None);
    }
    let content = tokens::parentheses(input)?;
    let motion = in_parentheses(&content, kind, subject);
    tokens::skip(&content, |_| false);
    Ok(motion
        .map_err(|diagnostic| tokens::push(errors, diagnostic))
        .ok())
}

fn in_parentheses(input: ParseStream, kind: &Definition, subject: &str) -> Parsed<InlineMotion> {
    if kind.axes() == 0 {
        let message = format!("{subject} is {} and has no axis", kind.word);
        return Err(diagnostic(input.span(), message));
    }
    let (axis, warning) = direction(input, subject)?;
    let mut axes = [axis; 2];
    let mut warnings: Vec<Diagnostic> = warning.into_iter().collect();
    if kind.axes() == 2 {
        let hint = format!("write {}(x, y)", kind.word);
        let missing = format!("{subject} has no second axis");
        let span = input.span();
        input
            .parse::<Token![,]>()
            .map_err(|_| diagnostic_with_hint(span, missing, hint))?;
        let (second, warning) = direction(input, subject)?;
        axes[1] = second;
        warnings.extend(warning);
    }
    let kind = kind.with_pitch(|| -> Parsed<Number> {
        let hint = "write screw(z, pitch: 0.01), in metres per radian";
        let missing =
            || diagnostic_with_hint(input.span(), format!("{subject} has no pitch"), hint);
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
        return Err(diagnostic(input.span(), message));
    }
    Ok(InlineMotion {
        kind,
        axes,
        warnings,
    })
}

fn along_x(place: Place) -> [Number; 3] {
    [1.0, 0.0, 0.0].map(|value| number::computed(value, place))
}

/// `z`, `-z`, or a vector; with a warning if its length is not 1.
pub(super) fn direction(
    input: ParseStream,
    subject: &str,
) -> Parsed<([Number; 3], Option<Diagnostic>)> {
    let span = input.span();
    let subject = format!("the axis of {subject}");
    if input.peek(token::Bracket) {
        let numbers = tokens::vector(input, &subject)?;
        let say = |remark: axis::Remark| {
            diagnostic_with_hint(span, format!("{subject} {}", remark.what), remark.hint)
        };
        return match axis::direction(numbers) {
            Ok((axis, warning)) => Ok((axis, warning.map(say))),
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
            let message = format!("{subject} must be x, y, z or a vector");
            let hint = "write revolute(z), revolute(-z) or revolute([0.0, 0.6, 0.8])";
            return Err(diagnostic_with_hint(span, message, hint));
        }
    };
    let axis = axis.map(|value| number::computed(value, Place::Token(span)));
    Ok((axis, None))
}

/// `xyz(…) rpy(…)`, or another product of steps, from left to right.
pub(super) fn placement(input: ParseStream, subject: &str) -> Parsed<Vec<Step>> {
    let mut steps = Vec::new();
    while !input.is_empty() && !input.peek(Token![,]) {
        let word = tokens::word(input)?;
        let text = word.to_string();
        let part = format!("{text} of {subject}");
        match text.as_str() {
            "xyz" => steps.push(Step::Translate(tokens::arguments(input, &part)?)),
            "rpy" => steps.extend(body::roll_pitch_yaw(tokens::arguments(input, &part)?)),
            "rx" => steps.push(rotation(Axis::X, input, &part)?),
            "ry" => steps.push(rotation(Axis::Y, input, &part)?),
            "rz" => steps.push(rotation(Axis::Z, input, &part)?),
            _ => {
                let message = format!(
                    "{subject} has the unknown step {} in its placement",
                    quoted(&text)
                );
                let hint = known(&text, "steps", &STEPS);
                return Err(diagnostic_with_hint(word.span(), message, hint));
            }
        }
    }
    Ok(steps)
}

fn rotation(axis: Axis, input: ParseStream, subject: &str) -> Parsed<Step> {
    let [angle] = tokens::arguments(input, subject)?;
    Ok(Step::Rotate(axis, angle))
}

/// The keys of a mimic joint read so far.
#[derive(Default)]
struct MimicKeys {
    mimicked: Option<Name>,
    multiplier: Option<Number>,
    offset: Option<Number>,
}

impl MimicKeys {
    /// Reads the value of `mimic`, `multiplier` or `offset`.
    fn read(&mut self, key: &str, input: ParseStream, subject: &str) -> Parsed<()> {
        let number = || tokens::number(input, &format!("the {key} of {subject}"));
        match key {
            "mimic" => self.mimicked = Some(tokens::name(input)?),
            "multiplier" => self.multiplier = Some(number()?),
            _ => self.offset = Some(number()?),
        }
        Ok(())
    }

    /// The mimic joint, if `mimic` was written.
    fn finish(self, joint: &Name, errors: &mut Errors) -> Option<Mimic> {
        let place = joint.place;
        let Some(mimicked) = self.mimicked else {
            if self.multiplier.is_some() || self.offset.is_some() {
                errors.push_with_hint(
                    place,
                    format!(
                        "joint {} has a multiplier or an offset, but no mimicked joint",
                        quoted(&joint.text)
                    ),
                    "name it: mimic: finger",
                );
            }
            return None;
        };
        Some(Mimic {
            place: mimicked.place,
            mimicked,
            multiplier: self.multiplier.unwrap_or(number::computed(1.0, place)),
            offset: self.offset.unwrap_or(number::computed(0.0, place)),
        })
    }
}

/// The limits read so far.
#[derive(Default)]
pub(super) struct InlineLimits {
    ends: Option<[f64; 2]>,
    velocity: Option<f64>,
}

impl InlineLimits {
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
            return Err(diagnostic(
                span,
                format!("the lower limit of {subject}, {lower}, is above the upper one, {upper}"),
            ));
        }
        self.ends = Some([lower, upper]);
        Ok(())
    }

    /// The limits, if there are any.
    pub(super) fn finish(self) -> Option<Limits> {
        if self.ends.is_none() && self.velocity.is_none() {
            return None;
        }
        let [lower, upper] = self.ends.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        Some(Limits {
            lower,
            upper,
            velocity: self.velocity.unwrap_or(f64::INFINITY),
            effort: f64::INFINITY,
        })
    }
}

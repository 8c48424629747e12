//! Mass, centre of mass and inertia, in the braces of a link or of a row of a table.
//!
//! A mass without inertia is an error; a point mass is written with zeros.

use syn::parse::ParseStream;
use syn::{Token, token};

use crate::description::tokens::{self, Parsed, diagnostic};
use crate::description::{Axis, Inertial, Name, Number, Step, number};
use crate::error::{Errors, Place};

/// The keys of mass and inertia.
pub(in crate::description) const INERTIA: [&str; 4] = ["mass", "com", "inertia", "inertia_rpy"];

/// The inertia keys read so far.
#[derive(Default)]
pub(super) struct Inertia {
    mass: InlineValue<Number>,
    center: InlineValue<[Number; 3]>,
    tensor: InlineValue<[Number; 6]>,
    rotation: InlineValue<[Number; 3]>,
}

/// A value that may be missing or malformed.
#[derive(Default)]
struct InlineValue<T> {
    given: bool,
    read: Option<T>,
}

impl<T> InlineValue<T> {
    fn set(&mut self, read: impl FnOnce() -> Parsed<T>) -> Parsed<()> {
        self.given = true;
        self.read = Some(read()?);
        Ok(())
    }
}

impl Inertia {
    /// Reads the value of one of the keys.
    pub(super) fn read(&mut self, key: &str, input: ParseStream, subject: &str) -> Parsed<()> {
        match key {
            "mass" => self.mass.set(|| {
                let subject = format!("the mass of {subject}");
                let span = input.span();
                let mass = tokens::number(input, &subject)?;
                if mass.value < 0.0 {
                    let message = format!("{subject} is negative: {}", mass.value);
                    return Err(diagnostic(span, message));
                }
                Ok(mass)
            }),
            "com" => self
                .center
                .set(|| tokens::vector(input, &format!("the centre of mass of {subject}"))),
            "inertia" => self.tensor.set(|| tensor(input, subject)),
            _ => self
                .rotation
                .set(|| tokens::vector(input, &format!("inertia_rpy of {subject}"))),
        }
    }

    /// The inertia, if any of its keys was written.
    pub(super) fn finish(
        self,
        name: &Name,
        subject: &str,
        errors: &mut Errors,
    ) -> Option<Inertial> {
        let rest = self.center.given || self.tensor.given || self.rotation.given;
        if rest && !self.mass.given {
            let message = format!("{subject} has an inertia but no mass");
            errors.push_with_hint(name.place, message, "add mass: 1.0");
        }
        if self.mass.given && !self.tensor.given {
            let message = format!("{subject} has a mass but no inertia");
            let hint = "add inertia: [0.01, 0.01, 0.01], with zeros for a point mass";
            errors.push_with_hint(name.place, message, hint);
        }
        let mut origin: Vec<Step> = self.center.read.map(Step::Translate).into_iter().collect();
        if let Some(angles) = self.rotation.read {
            origin.extend(roll_pitch_yaw(angles));
        }
        Some(Inertial {
            origin,
            mass: self.mass.read?,
            inertia: self.tensor.read?,
            place: name.place,
        })
    }
}

/// Three principal moments, or xx, xy, xz, yy, yz, zz.
fn tensor(input: ParseStream, subject: &str) -> Parsed<[Number; 6]> {
    let subject = format!("the inertia of {subject}");
    let (span, numbers) = tokens::numbers(input, &subject)?;
    match numbers[..] {
        [xx, yy, zz] => {
            let zero = number::computed(0.0, Place::Token(span));
            Ok([xx, zero, zero, yy, zero, zz])
        }
        [xx, xy, xz, yy, yz, zz] => Ok([xx, xy, xz, yy, yz, zz]),
        _ => Err(diagnostic(
            span,
            format!(
                "{subject} has {} numbers instead of 3 (xx, yy, zz) or 6 (xx, xy, xz, yy, yz, zz)",
                numbers.len()
            ),
        )),
    }
}

/// Rotations about the fixed axes x, y, z, written as rotations about moving axes in reverse order.
pub(super) fn roll_pitch_yaw([roll, pitch, yaw]: [Number; 3]) -> [Step; 3] {
    [
        Step::Rotate(Axis::Z, yaw),
        Step::Rotate(Axis::Y, pitch),
        Step::Rotate(Axis::X, roll),
    ]
}

/// Reports an error unless braces or an end follow.
pub(super) fn end(input: ParseStream, subject: &str) -> Parsed<()> {
    let ends = input.is_empty() || input.peek(Token![;]) || input.peek(Token![,]);
    if ends || input.peek(token::Brace) {
        return Ok(());
    }
    let message = format!("expected `{{` or `;` after {subject}");
    Err(diagnostic(input.span(), message))
}

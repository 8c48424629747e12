//! What the user asks for of a description: which part of it, which functions, which numbers stay
//! free at run time.
//!
//! In: attributes of a derive, calls of the builder, options of the command line. Out: one
//! [`Request`], the same whichever door it came through. It never looks at the description.

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;

use crate::description::{Name, Number};
use crate::error::{Complaint, Place};
use crate::formulation::Formulation;
use crate::function::Function;
use crate::processor::Processor;
use crate::real::{Real, Trigonometry};
use crate::wording::quoted;

/// Everything that is asked for.
#[derive(Clone, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a word of its own")]
pub struct Request {
    /// The link taken as fixed; the root where none is named.
    pub base: Option<Name>,
    /// Free the base: it moves anyhow, as the joint `root`, against a frame 0 that is no link's.
    pub floating: bool,
    /// The link whose frame poses and Jacobians are of; the last one where there is only one.
    pub tip: Option<Name>,
    /// Lock every joint that does not move the tip.
    pub path_only: bool,
    /// Joints held still, at zero or at a given value; their bodies stay as mass.
    pub lock: Vec<(Name, Option<Number>)>,
    /// Links taken off with all that they carry, and with their mass.
    pub drop: Vec<Name>,
    /// Further links whose frames are computed.
    pub frames: Vec<Name>,
    /// Acceleration of gravity in the base frame [m/s²]; (0, 0, −9.81) where none is given.
    pub gravity: Option<[Number; 3]>,
    /// Keep `1.5708` as written instead of taking it for π/2.
    pub exact: bool,
    /// Refuse what is doubtful, such as inertias that no body can have, instead of warning.
    pub strict: bool,
    /// What to generate: each item becomes one Rust function, and an item of several functions
    /// (`all_of(…)`) one that shares their work and returns a tuple.
    pub functions: Vec<Vec<Function>>,
    /// How they are computed.
    pub formulation: Formulation,
    /// The processor that they are computed on.
    pub processor: Processor,
    /// Take slices of states besides, for all kinds of vectors: `gravity_batch` beside `gravity`.
    pub batch: bool,
    /// The type of number in the generated code.
    pub scalar: Real,
    /// Which sines and cosines the generated code calls.
    pub trigonometry: Trigonometry,
    /// Struct fields that stay free at run time.
    pub parameters: Vec<Parameter>,
    /// The path under which the generated code finds the runtime crate; `::homogen` where none.
    pub runtime: Option<TokenStream>,
}

/// A struct field that takes the place of a number of the description at run time.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The field.
    pub field: Ident,
    /// The number it stands for.
    pub target: Target,
    /// The least and the greatest that each of its entries is meant to be, in the unit of what it
    /// stands for; by default from zero to twice what is described, to both sides where it is a
    /// vector. Error bounds are for these; nothing checks it at run time.
    pub range: Option<[f64; 2]>,
}

/// What a struct field can stand for.
#[derive(Clone, Debug)]
pub enum Target {
    /// The mass of a link \[kg\]; one number. The inertia about the centre of mass stays as described;
    /// a link described without one is a point of mass at its origin.
    MassOf(Name),
    /// The centre of mass of a link in the link's frame \[m\]; three numbers.
    CenterOfMassOf(Name),
    /// The acceleration of gravity in the base frame [m/s²]; three numbers.
    Gravity,
    /// The translation from the parent's frame to the joint's \[m\]; three numbers.
    OriginOf(Name),
}

impl Request {
    /// What to generate: what is named, or every function where nothing is.
    #[must_use]
    pub fn items(&self) -> Vec<Vec<Function>> {
        if self.functions.is_empty() {
            Function::ALL.map(|function| vec![function]).to_vec()
        } else {
            self.functions.clone()
        }
    }

    /// What the struct fields contradict: two of one name, two for one number, gravity given here and
    /// there. Each complaint stands at the later one.
    #[must_use]
    pub fn clashes(&self) -> Vec<Complaint> {
        let mut clashes = Vec::new();
        for (index, parameter) in self.parameters.iter().enumerate() {
            let Parameter { field, target, .. } = parameter;
            let place = Place::Token(field.span());
            let mut complain = |message: String, hint: &str| {
                clashes.push(Complaint {
                    place,
                    message,
                    hint: Some(hint.to_owned()),
                });
            };
            let before = &self.parameters[..index];
            if before
                .iter()
                .any(|other| other.field.unraw() == field.unraw())
            {
                let message = format!("two fields are called `{field}`");
                complain(message, "give one of them another name");
            }
            if let Some(other) = before.iter().find(|other| other.target.is(target)) {
                let (what, other) = (target.words(), &other.field);
                let message = format!("field `{field}` stands for {what}, as `{other}` does");
                complain(message, "leave out one of them");
            }
            if matches!(target, Target::Gravity) && self.gravity.is_some() {
                let message = format!("gravity is given as a vector and in field `{field}`");
                complain(message, "leave out one of them");
            }
        }
        clashes
    }

    /// Whether a struct field stands for the mass of a link.
    #[must_use]
    pub fn weighs(&self, link: &Name) -> bool {
        let mut targets = self.parameters.iter().map(|parameter| &parameter.target);
        targets.any(|target| matches!(target, Target::MassOf(name) if name.text == link.text))
    }
}

impl Parameter {
    /// The name of the field.
    #[must_use]
    pub fn name(&self) -> String {
        self.field.unraw().to_string()
    }

    /// The names of its entries: the field's, and behind it an axis where there are three.
    #[must_use]
    pub fn entries(&self) -> Vec<String> {
        let name = self.name();
        match self.target.entries() {
            1 => vec![name],
            _ => ["x", "y", "z"]
                .map(|axis| format!("{name}_{axis}"))
                .to_vec(),
        }
    }
}

impl Target {
    /// The unit of its numbers.
    #[must_use]
    pub const fn unit(&self) -> &'static str {
        match self {
            Self::MassOf(_) => "kg",
            Self::CenterOfMassOf(_) | Self::OriginOf(_) => "m",
            Self::Gravity => "m/s²",
        }
    }

    /// The range that one number stands for: from zero to it, to both sides where entries have signs.
    #[must_use]
    pub const fn range_up_to(&self, most: f64) -> [f64; 2] {
        match self {
            Self::MassOf(_) => [0.0, most],
            Self::CenterOfMassOf(_) | Self::OriginOf(_) | Self::Gravity => [-most, most],
        }
    }

    /// What is wrong with a range of its entries, and what to write instead.
    #[must_use]
    pub fn refusal(&self, [least, most]: [f64; 2]) -> Option<[&'static str; 2]> {
        let example = match self {
            Self::MassOf(_) => "write range = 0.0..=3.0, or range = 3.0 for the same",
            Self::CenterOfMassOf(_) | Self::OriginOf(_) => {
                "write range = 0.5, or range = -0.5..=0.5 for the same"
            }
            Self::Gravity => "write range = 12.0, or range = -12.0..=12.0 for the same",
        };
        let problem = if !(least.is_finite() && most.is_finite()) {
            "is not finite"
        } else if least > most {
            "is empty"
        } else if matches!(self, Self::MassOf(_)) && least < 0.0 {
            "has negative masses"
        } else {
            return None;
        };
        Some([problem, example])
    }

    /// Whether both are the same number.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::MassOf(one), Self::MassOf(other))
            | (Self::CenterOfMassOf(one), Self::CenterOfMassOf(other))
            | (Self::OriginOf(one), Self::OriginOf(other)) => one.text == other.text,
            (Self::Gravity, Self::Gravity) => true,
            _ => false,
        }
    }

    /// What it is in a sentence.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::MassOf(link) => format!("the mass of link {}", quoted(&link.text)),
            Self::CenterOfMassOf(link) => {
                format!("the centre of mass of link {}", quoted(&link.text))
            }
            Self::Gravity => "gravity".to_owned(),
            Self::OriginOf(joint) => format!("the origin of joint {}", quoted(&joint.text)),
        }
    }

    /// How many numbers the field holds.
    #[must_use]
    pub const fn entries(&self) -> usize {
        match self {
            Self::MassOf(_) => 1,
            Self::CenterOfMassOf(_) | Self::Gravity | Self::OriginOf(_) => 3,
        }
    }
}

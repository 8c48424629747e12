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
use crate::joint::drive::{Part, Parts};
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
    /// Joints that are driven, where loops move the others.
    pub actuated: Vec<Name>,
    /// Further links whose frames are computed.
    pub frames: Vec<Name>,
    /// Links on which the surroundings act, an action each.
    pub external: Vec<Name>,
    /// Whether those actions are in frame 0, and not each in its link's.
    pub external_in_frame_0: bool,
    /// Model the damping and the friction that are described.
    pub friction: bool,
    /// Model the rotors that are described.
    pub rotors: bool,
    /// What is said of the drives of joints, in place of what is described.
    pub drives: Vec<(Name, Part, Vec<Number>)>,
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
    /// The inertia that a joint feels beside that of the bodies [kg m² or kg]; one number, for each of its
    /// velocities.
    ArmatureOf(Name),
    /// The viscous friction of a joint [N m s/rad or N s/m]; one number, as before.
    DampingOf(Name),
    /// The Coulomb friction of a joint [N m or N]; one number, as before.
    FrictionOf(Name),
}

impl Request {
    /// What to generate: what is named, or every function where nothing is; of a robot that has loops
    /// those of loops as well.
    #[must_use]
    pub fn items(&self, has_loops: bool) -> Vec<Vec<Function>> {
        if self.functions.is_empty() {
            // Nothing can be known of drives that are not named.
            let has = |function: &Function| !self.actuated.is_empty() || !function.wants_drives();
            let of_loops = Function::OF_LOOPS.into_iter().filter(|_| has_loops);
            let of_loops = of_loops.filter(has);
            let all = Function::ALL.into_iter().chain(of_loops);
            all.map(|function| vec![function]).collect()
        } else {
            self.functions.clone()
        }
    }

    /// Whether nothing but poses, Jacobians and motions of frames is asked for, which no mass changes.
    #[must_use]
    pub fn is_of_frames_alone(&self) -> bool {
        let mut functions = self.functions.iter().flatten();
        !self.functions.is_empty() && functions.all(|function| function.of_a_frame())
    }

    /// Whether damping and friction are modelled: those that are described, too, as soon as any of them is
    /// asked for.
    #[must_use]
    pub fn models_friction(&self) -> bool {
        self.friction || self.speaks_of(Part::resists)
    }

    /// Whether inertias of drives are modelled, in the same way.
    #[must_use]
    pub fn models_armature(&self) -> bool {
        self.rotors || self.speaks_of(|part| !part.resists())
    }

    fn speaks_of(&self, is: impl Fn(Part) -> bool) -> bool {
        let mut drives = self.drives.iter();
        let mut fields = self.parameters.iter();
        drives.any(|(_, part, _)| is(*part))
            || fields.any(|field| field.target.drives().is_some_and(|(_, part)| is(part)))
    }

    /// Models what was said of a joint.
    pub fn model(&mut self, drive: &Parts) {
        for part in Part::ALL {
            let said = !drive.of(part).is_empty();
            self.friction |= said && part.resists();
            self.rotors |= said && !part.resists();
        }
    }

    /// What is to be modelled of a joint's drive, where the description says this of it.
    #[must_use]
    pub fn drive<'r>(&'r self, joint: &str, described: &'r Parts, part: Part) -> &'r [Number] {
        let modelled = if part.resists() {
            self.models_friction()
        } else {
            self.models_armature()
        };
        let mut drives = self.drives.iter();
        let asked = drives.find(|(name, of, _)| *of == part && name.text == joint);
        match asked {
            Some((_, _, numbers)) => numbers,
            None if modelled => described.of(part),
            None => &[],
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
            Self::ArmatureOf(_) => "kg m² or kg",
            Self::DampingOf(_) => "N m s/rad or N s/m",
            Self::FrictionOf(_) => "N m or N",
            Self::CenterOfMassOf(_) | Self::OriginOf(_) => "m",
            Self::Gravity => "m/s²",
        }
    }

    /// The joint and the part of its drive, where it is of one.
    #[must_use]
    pub const fn drives(&self) -> Option<(&Name, Part)> {
        match self {
            Self::ArmatureOf(joint) => Some((joint, Part::Armature)),
            Self::DampingOf(joint) => Some((joint, Part::Damping)),
            Self::FrictionOf(joint) => Some((joint, Part::Friction)),
            _ => None,
        }
    }

    /// The range that one number stands for: from zero to it, to both sides where entries have signs.
    #[must_use]
    pub const fn range_up_to(&self, most: f64) -> [f64; 2] {
        match self {
            Self::MassOf(_) | Self::ArmatureOf(_) | Self::DampingOf(_) | Self::FrictionOf(_) => {
                [0.0, most]
            }
            Self::CenterOfMassOf(_) | Self::OriginOf(_) | Self::Gravity => [-most, most],
        }
    }

    /// What is wrong with a range of its entries, and what to write instead.
    #[must_use]
    pub fn refusal(&self, [least, most]: [f64; 2]) -> Option<[&'static str; 2]> {
        let example = match self {
            Self::MassOf(_) | Self::ArmatureOf(_) | Self::DampingOf(_) | Self::FrictionOf(_) => {
                "write range = 0.0..=3.0, or range = 3.0 for the same"
            }
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
        } else if self.drives().is_some() && least < 0.0 {
            "has negative numbers"
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
            | (Self::OriginOf(one), Self::OriginOf(other))
            | (Self::ArmatureOf(one), Self::ArmatureOf(other))
            | (Self::DampingOf(one), Self::DampingOf(other))
            | (Self::FrictionOf(one), Self::FrictionOf(other)) => one.text == other.text,
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
            Self::ArmatureOf(joint) | Self::DampingOf(joint) | Self::FrictionOf(joint) => {
                let part = self.drives().map_or("", |(_, part)| part.word());
                format!("the {part} of joint {}", quoted(&joint.text))
            }
        }
    }

    /// How many numbers the field holds.
    #[must_use]
    pub const fn entries(&self) -> usize {
        match self {
            Self::MassOf(_) | Self::ArmatureOf(_) | Self::DampingOf(_) | Self::FrictionOf(_) => 1,
            Self::CenterOfMassOf(_) | Self::Gravity | Self::OriginOf(_) => 3,
        }
    }
}

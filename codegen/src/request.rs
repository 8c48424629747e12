//! What the user asks for of a description: which part of it, which functions, which numbers stay
//! free at run time.
//!
//! In: attributes of a derive, calls of the builder, options of the command line. Out: one
//! [`Request`], the same whichever door it came through. It never looks at the description.

#[doc(hidden)]
pub mod setting;
mod target;

pub use target::{Parameter, Target, TargetOf};

use proc_macro2::TokenStream;
use syn::ext::IdentExt;

use crate::error::{Complaint, Place};
use crate::formulation::Formulation;
use crate::function::Function;
use crate::joint::drive::{Motor, Part, Parts};
use crate::name::Name;
use crate::number::Number;
use crate::processor::Processor;
use crate::real::{Real, Trigonometry};
use crate::schedule::Length;

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
    /// Loops that are closed beside those of the description, each as behind the word `loop` of attributes.
    pub loops: Vec<String>,
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
    /// Write warnings into comments alone, and do not report them to the compiler.
    pub quiet: bool,
    /// What to generate: each item becomes one Rust function, and an item of several functions
    /// (`all_of(…)`) one that shares their work and returns a tuple.
    pub functions: Vec<Vec<Function>>,
    /// How they are computed.
    pub formulation: Formulation,
    /// The processor that they are computed on.
    pub processor: Processor,
    /// Take slices of states besides, for all kinds of vectors: `gravity_batch` beside `gravity`.
    pub batch: bool,
    /// The most statements of one compiled function, beyond which it is cut into sections; where none is given,
    /// what was measured to be best.
    pub section: Option<usize>,
    /// Offer to compute once what depends on fields alone.
    pub prepare: bool,
    /// The type of number in the generated code.
    pub scalar: Real,
    /// Which sines and cosines the generated code calls.
    pub trigonometry: Trigonometry,
    /// Struct fields that stay free at run time.
    pub parameters: Vec<Parameter>,
    /// The path under which the generated code finds the runtime crate; `::homogen` where none.
    pub runtime: Option<TokenStream>,
    /// Whether it becomes a file, which has a reviewer: what only that one reads is found as well.
    pub review: bool,
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

    /// Whether a function is to be generated: where it is named, or where none is.
    #[must_use]
    pub fn asks_for(&self, function: Function) -> bool {
        self.functions.is_empty()
            || self
                .functions
                .iter()
                .flatten()
                .any(|named| *named == function)
    }

    /// How long a function is that compilers see. One that takes slices of states stays whole: it is inlined
    /// where it is compiled for vectors.
    #[must_use]
    pub fn length(&self) -> Length {
        match self.section {
            _ if self.batch => Length::UNBOUNDED,
            Some(most) => Length::at_most(most),
            None => Length::default(),
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

    /// The motors of a joint beside the one whose rotor and ratio are parts, which what is asked for replaces all.
    #[must_use]
    pub fn further_motors<'r>(&self, joint: &str, described: &'r Parts) -> &'r [Motor] {
        let is_replaced = |(name, part, _): &(Name, Part, Vec<Number>)| {
            matches!(part, Part::Rotor | Part::Ratio) && name.text == joint
        };
        if self.models_armature() && !self.drives.iter().any(is_replaced) {
            described.further()
        } else {
            &[]
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
        self.has(|target| matches!(target, Target::MassOf(name) if name.text == link.text))
    }

    /// Whether a struct field stands for the inertia of a link.
    #[must_use]
    pub fn spreads(&self, link: &Name) -> bool {
        self.has(|target| matches!(target, Target::InertiaOf(name) if name.text == link.text))
    }

    /// Whether a struct field stands for a payload on a link.
    #[must_use]
    pub fn loads(&self, link: &Name) -> bool {
        self.has(|target| matches!(target, Target::PayloadOn(name) if name.text == link.text))
    }

    fn has(&self, is: impl Fn(&Target) -> bool) -> bool {
        self.parameters
            .iter()
            .any(|parameter| is(&parameter.target))
    }
}

//! Request: which part of a description, which functions, and which numbers stay free at run time.
//!
//! All front ends build the same [`Request`]: attributes of a derive, calls of the builder, options of the command
//! line. Names in it are not resolved yet.

mod for_c;
#[doc(hidden)]
pub mod setting;
mod target;

pub use for_c::{ForC, Integrator};
pub use target::{Parameter, Target, TargetOf};

use proc_macro2::TokenStream;
use syn::ext::IdentExt;

use crate::error::{Diagnostic, Place};
use crate::formulation::Formulation;
use crate::function::Function;
use crate::joint::actuator::{Actuator, ActuatorQuantity, Motor};
use crate::name::Name;
use crate::number::Number;
use crate::processor::Processor;
use crate::real::{Real, Trigonometry};
use crate::schedule::Length;

/// A request of the user, as all front ends pass it on; [`Builder`](crate::Builder) sets it.
#[doc(hidden)]
#[derive(Clone, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each is a key of its own")]
pub struct Request {
    /// Names and values of the arguments of a xacro file.
    pub arguments: Vec<(Name, String)>,
    /// Names and folders of ROS packages, relative to the folder that paths begin at.
    pub packages: Vec<(Name, String)>,
    /// The fixed link; the root by default.
    pub base: Option<Name>,
    /// Floating base: the base moves by the joint `root` relative to frame 0, the world.
    pub floating: bool,
    /// The end effector: the link of poses and Jacobians; by default the last link, if there is only one.
    pub tip: Option<Name>,
    /// Lock every joint that does not move the end effector.
    pub path_only: bool,
    /// Locked joints, at 0 or at a coordinate [rad or m]; their bodies stay as mass.
    pub lock: Vec<(Name, Option<Number>)>,
    /// Links that are removed with all their descendants, and with their mass.
    pub drop: Vec<Name>,
    /// Loops in addition to those of the description, each written as after the word `loop` of attributes.
    pub loops: Vec<String>,
    /// Actuated joints of a robot with loops.
    pub actuated: Vec<Name>,
    /// Further links with functions of their frame.
    pub frames: Vec<Name>,
    /// Model the collision spheres of the description.
    pub collision: bool,
    /// Pairs of links whose spheres have distances; every pair that a joint does not join, if none is named.
    pub collision_pairs: Vec<[Name; 2]>,
    /// Links with an external wrench each.
    pub external: Vec<Name>,
    /// True if these wrenches are in frame 0, and not in the links' frames.
    pub external_in_frame_0: bool,
    /// Model damping and friction of the description.
    pub friction: bool,
    /// Model rotors of the description.
    pub rotors: bool,
    /// Armature, rotors, damping and friction of joints that replace those of the description.
    pub actuators: Vec<(Name, ActuatorQuantity, Vec<Number>)>,
    /// Acceleration of gravity in the base frame [m/s²]; (0, 0, −9.81) by default.
    pub gravity: Option<[Number; 3]>,
    /// Keep `1.5708` as written instead of taking it for π/2.
    pub exact: bool,
    /// Make warnings errors, such as those of non-physical inertias.
    pub strict: bool,
    /// Write warnings only into comments, and do not report them to the compiler.
    pub quiet: bool,
    /// The items to generate. Each item becomes one function; an item of several (`all_of(…)`) shares their work and
    /// returns a tuple.
    pub functions: Vec<Vec<Function>>,
    /// Algorithms and frames of the functions.
    pub formulation: Formulation,
    /// The processor that the functions run on.
    pub processor: Processor,
    /// Add functions of slices of states: `gravity_batch` beside `gravity`.
    pub batch: bool,
    /// Maximum number of statements of one compiled function, beyond which it is cut into sections; the measured
    /// optimum by default, which is lower with batches.
    pub section: Option<usize>,
    /// Add `prepare`, which computes once what depends only on fields.
    pub prepare: bool,
    /// Parts of a file in C beside its functions.
    pub for_c: ForC,
    /// The type of numbers in the generated code.
    pub scalar: Real,
    /// The same bits on every processor: no product is fused with a sum.
    pub reproducible: bool,
    /// The sines and cosines that the generated code calls.
    pub trigonometry: Trigonometry,
    /// Struct fields whose numbers stay free at run time.
    pub parameters: Vec<Parameter>,
    /// The path of the runtime crate in the generated code; `::homogen` by default.
    pub runtime: Option<TokenStream>,
    /// True for a file, which has a reviewer's comments and tests in addition.
    pub review: bool,
}

impl Request {
    /// The items to generate: those that are named, or every function if none is, including those of loops if the robot
    /// has loops.
    #[must_use]
    pub fn items(&self, has_loops: bool) -> Vec<Vec<Function>> {
        if self.functions.is_empty() {
            // Functions of actuated joints need their names.
            let has =
                |function: &Function| !self.actuated.is_empty() || !function.wants_actuators();
            let of_loops = Function::OF_LOOPS.into_iter().filter(|_| has_loops);
            let of_loops = of_loops.filter(has);
            let of_spheres = Function::OF_SPHERES.into_iter();
            let of_spheres = of_spheres.filter(|_| self.collision);
            let all = Function::ALL.into_iter().chain(of_loops);
            let all = all.chain(of_spheres);
            all.map(|function| vec![function]).collect()
        } else {
            self.functions.clone()
        }
    }

    /// True if a function is generated: it is named, or none is.
    #[must_use]
    pub fn asks_for(&self, function: Function) -> bool {
        self.functions.is_empty()
            || self
                .functions
                .iter()
                .flatten()
                .any(|named| *named == function)
    }

    /// Maximum length of compiled functions; shorter with batches, whose functions compile in quadratic time.
    #[must_use]
    pub fn length(&self) -> Length {
        match self.section {
            Some(most) => Length::at_most(most),
            None if self.batch => Length::OF_BATCHES,
            None => Length::default(),
        }
    }

    /// True if only poses, Jacobians and motions of frames are requested, which do not depend on masses.
    #[must_use]
    pub fn is_of_frames_alone(&self) -> bool {
        let mut functions = self.functions.iter().flatten();
        !self.functions.is_empty() && functions.all(|function| function.needs_a_frame())
    }

    /// True if damping and friction are modelled. Setting one value also models all those of the description.
    #[must_use]
    pub fn models_friction(&self) -> bool {
        self.friction || self.sets(ActuatorQuantity::resists)
    }

    /// True if armatures and rotors are modelled, in the same way.
    #[must_use]
    pub fn models_armature(&self) -> bool {
        self.rotors || self.sets(|quantity| !quantity.resists())
    }

    fn sets(&self, is: impl Fn(ActuatorQuantity) -> bool) -> bool {
        let mut actuators = self.actuators.iter();
        let mut fields = self.parameters.iter();
        actuators.any(|(_, quantity, _)| is(*quantity))
            || fields.any(|field| {
                field
                    .target
                    .actuators()
                    .is_some_and(|(_, quantity)| is(quantity))
            })
    }

    /// Models the terms that an inline description has for a joint.
    pub fn model(&mut self, actuator: &Actuator) {
        for quantity in ActuatorQuantity::ALL {
            let is_set = !actuator.of(quantity).is_empty();
            self.friction |= is_set && quantity.resists();
            self.rotors |= is_set && !quantity.resists();
        }
    }

    /// The values of a quantity for a joint: those of the request, or else those of the description if they are
    /// modelled.
    #[must_use]
    pub fn actuator<'r>(
        &'r self,
        joint: &str,
        described: &'r Actuator,
        quantity: ActuatorQuantity,
    ) -> &'r [Number] {
        let modelled = if quantity.resists() {
            self.models_friction()
        } else {
            self.models_armature()
        };
        let mut actuators = self.actuators.iter();
        let asked = actuators.find(|(name, of, _)| *of == quantity && name.text == joint);
        match asked {
            Some((_, _, numbers)) => numbers,
            None if modelled => described.of(quantity),
            None => &[],
        }
    }

    /// The motors of a joint beyond the first; empty if the request replaces them.
    #[must_use]
    pub fn further_motors<'r>(&self, joint: &str, described: &'r Actuator) -> &'r [Motor] {
        let is_replaced = |(name, quantity, _): &(Name, ActuatorQuantity, Vec<Number>)| {
            matches!(quantity, ActuatorQuantity::Rotor | ActuatorQuantity::Ratio)
                && name.text == joint
        };
        if self.models_armature() && !self.actuators.iter().any(is_replaced) {
            described.further()
        } else {
            &[]
        }
    }

    /// Errors of fields: two with one name, two for one number, gravity set twice. Each is reported at the later one.
    #[must_use]
    pub fn clashes(&self) -> Vec<Diagnostic> {
        let mut clashes = Vec::new();
        for (index, parameter) in self.parameters.iter().enumerate() {
            let Parameter { field, target, .. } = parameter;
            let place = Place::Token(field.span());
            let mut complain = |message: String, hint: &str| {
                clashes.push(Diagnostic {
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
                let message = format!("two fields have the name `{field}`");
                complain(message, "rename one of them");
            }
            if let Some(other) = before.iter().find(|other| other.target.is(target)) {
                let (what, other) = (target.words(), &other.field);
                let message = format!("field `{field}` stands for {what}, as `{other}` does");
                complain(message, "leave out one of them");
            }
            if matches!(target, Target::Gravity) && self.gravity.is_some() {
                let message = format!("gravity is both a vector and the field `{field}`");
                complain(message, "leave out one of them");
            }
        }
        clashes
    }

    /// True if a field stands for the mass of a link.
    #[must_use]
    pub fn weighs(&self, link: &Name) -> bool {
        self.has(|target| matches!(target, Target::MassOf(name) if name.text == link.text))
    }

    /// True if a field stands for the inertia of a link.
    #[must_use]
    pub fn spreads(&self, link: &Name) -> bool {
        self.has(|target| matches!(target, Target::InertiaOf(name) if name.text == link.text))
    }

    /// True if a field stands for a payload on a link.
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

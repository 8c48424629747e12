//! What is generated for a robot: functions with their programs, the spaces that they are over, the robot as data.
//!
//! In: nothing, these are nouns. A [`Module`] is made by [`expand`](crate::expand), annotated by the check and the bounds, and
//! printed by a language. It knows no stage.

mod data;
mod review;

pub use data::{ChainData, DataMotion, LoopData, LoopsData};
pub use review::{Origins, Review, Sum, Vector};

use crate::accuracy::Accuracy;
use crate::description::Source;
use crate::error::Complaint;
use crate::formulation::Sines;
use crate::function::Function;
use crate::layout::Layout;
use crate::real::Real;
use crate::request::Parameter;
use crate::schedule::{Length, Price, Program};
use crate::space::{Space, Spaces, Variable};

/// All that is generated for a robot.
#[derive(Clone, Debug)]
pub struct Module {
    /// What the comments say.
    pub about: About,
    /// What arguments and results are over.
    pub spaces: Spaces,
    /// The functions, in the order of the request.
    pub functions: Vec<GeneratedFunction>,
    /// The robot as data.
    pub data: ChainData,
    /// Largest torque or force of each velocity \[N m, N\]; infinite where the description has none.
    pub efforts: Vec<f64>,
    /// What base parameters are described as \[kg, kg m, kg m²\].
    pub base_values: Vec<f64>,
    /// Whether functions take slices of states besides.
    pub batch: bool,
    /// How long a function is that compilers see.
    pub length: Length,
    /// The type of number.
    pub scalar: Real,
    /// Where sines and cosines come from.
    pub sines: Sines,
    /// The fields that programs read, in the order in which
    /// [`Input::Parameter`](crate::expression::Input) counts them.
    pub parameters: Vec<Parameter>,
    /// The same functions with what depends on fields alone computed once, where that is asked for.
    pub prepared: Option<Prepared>,
    /// What the reviewer of a file reads, where it becomes one.
    pub review: Option<Review>,
}

/// A robot in two parts: what its fields make of it, and what is left of its functions.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// What depends on fields alone.
    pub once: Program,
    /// What that costs.
    pub price: Price,
    /// What its results would like to be called, none twice.
    pub names: Vec<String>,
    /// The functions, in the order of the module, which read those results as the only field.
    pub functions: Vec<GeneratedFunction>,
}

impl Module {
    /// The values of the base parameters, where a function asks for them.
    pub(crate) fn base_parameters(&self) -> Option<&[f64]> {
        let mut functions = self
            .functions
            .iter()
            .flat_map(|generated| &generated.functions);
        let asked = functions.any(|function| {
            let mut parts = function.result().parts();
            parts.any(|(_, part)| part.over.contains(&Space::BaseParameters))
        });
        asked.then_some(&self.base_values)
    }
}

/// What comments say about a robot.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// The robot's name.
    pub robot: String,
    /// The files that it was read from.
    pub source: Source,
    /// The link whose frame is frame 0.
    pub base: String,
    /// The link whose frame poses and Jacobians are of.
    pub tip: String,
    /// What is modelled and what is not: `2 links merged`, `gravity only along −z`.
    pub facts: Vec<String>,
    /// Whether joints feel more than their bodies: an armature or friction.
    pub driven: bool,
    /// The words of the formulation that was asked for, where it is not the default.
    pub formulation: Vec<String>,
    /// Warnings about the description and the request.
    pub warnings: Vec<Complaint>,
    /// Functions that the robot cannot have, where all that it can have were asked for.
    pub left_out: Vec<LeftOut>,
}

impl About {
    /// The warnings without their hints, each a line with its place.
    #[must_use]
    pub fn located_warnings(&self) -> Vec<String> {
        let places = self.source.errors();
        let warnings = self.warnings.iter();
        warnings.map(|warning| places.locate(warning)).collect()
    }
}

/// Functions that a robot cannot have, for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Their names.
    pub functions: Vec<String>,
    /// Why, a sentence with its place.
    pub reason: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// Whether the engine is at fault, and not the robot.
    pub is_fault: bool,
}

/// One generated function, a method of the robot's type where the language has such.
#[derive(Clone, Debug)]
pub struct GeneratedFunction {
    /// What it computes; several functions share their work and are returned as a tuple.
    pub functions: Vec<Function>,
    /// The link whose frame it is about, where that is not the tip.
    pub frame: Option<String>,
    /// Where the frames stand that its matrices are in.
    pub layout: Layout,
    /// The operations.
    pub program: Program,
    /// What they cost.
    pub price: Price,
    /// How far rounding can take their results: those that are evaluated, and each that solves
    /// something.
    pub accuracy: Vec<Accuracy>,
}

impl GeneratedFunction {
    /// Its name, as far as nothing else is called so.
    #[must_use]
    pub fn name(&self) -> String {
        name(&self.functions, self.frame.as_deref())
    }

    /// What its functions together are functions of.
    #[must_use]
    pub fn arguments(&self, spaces: &Spaces) -> Vec<Variable> {
        arguments(&self.functions, spaces.actions() > 0)
    }
}

/// What several functions together are functions of, where actions from outside are among it or not.
pub(crate) fn arguments(functions: &[Function], actions: bool) -> Vec<Variable> {
    let each = functions.iter();
    Variable::together(each.map(|function| function.arguments_with(actions)))
}

/// `mass_matrix_and_bias`, `forward_kinematics_of_camera`.
pub(crate) fn name(functions: &[Function], frame: Option<&str>) -> String {
    let names: Vec<_> = functions.iter().map(|function| function.name()).collect();
    let name = names.join("_and_");
    match frame {
        Some(frame) => format!("{name}_of_{frame}"),
        None => name,
    }
}

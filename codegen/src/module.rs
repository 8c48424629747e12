//! The module: everything that is generated for a robot, in no particular language.
//!
//! [`expand`](crate::expand) makes a [`Module`]: functions with their programs, their spaces, and the robot as data.
//! The check and the bounds annotate it, and a language prints it.

mod data;
mod review;

pub use data::{ChainData, DataMotion, LoopData, LoopsData};
pub use review::{Origins, Review, Sum, TestVector};

use crate::accuracy::Accuracy;
use crate::description::Source;
use crate::error::Diagnostic;
use crate::formulation::Sines;
use crate::function::Function;
use crate::layout::Layout;
use crate::real::Real;
use crate::request::Parameter;
use crate::schedule::{Length, OperationCount, Program};
use crate::space::{Space, Spaces, Variable};

/// Everything that is generated for a robot.
#[derive(Clone, Debug)]
pub struct Module {
    /// Facts for comments.
    pub about: About,
    /// Spaces of arguments and results.
    pub spaces: Spaces,
    /// The functions, in the order of the request.
    pub functions: Vec<GeneratedFunction>,
    /// The robot as data.
    pub data: ChainData,
    /// Largest torque or force of each velocity \[N m, N\]; infinite where the description has none.
    pub efforts: Vec<f64>,
    /// The radius of each collision sphere \[m\].
    pub radii: Vec<f64>,
    /// Configurations with names, in the order of the description.
    pub configurations: Vec<NamedConfiguration>,
    /// Values of the base parameters by the description \[kg, kg m, kg m²\].
    pub base_values: Vec<f64>,
    /// True if functions for slices of states are generated as well.
    pub batch: bool,
    /// Length of functions in the generated code.
    pub length: Length,
    /// Scalar type.
    pub scalar: Real,
    /// True if results have the same bits on every processor.
    pub reproducible: bool,
    /// Source of sines and cosines.
    pub sines: Sines,
    /// Fields that programs read, in the order in which [`Input::Parameter`](crate::expression::Input) counts them.
    pub parameters: Vec<Parameter>,
    /// The same functions with everything precomputed that depends on fields alone, if `prepare` was requested.
    pub prepared: Option<Prepared>,
    /// Material for the reviewer of a file, if the module becomes one.
    pub review: Option<Review>,
}

/// Configuration with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedConfiguration {
    /// Its name in the description.
    pub name: String,
    /// Its coordinates [rad, m, quaternions x, y, z, w].
    pub q: Vec<f64>,
}

/// Prepared robot: the part that depends on fields, and the rest of each function.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Program that depends on fields alone.
    pub once: Program,
    /// Its operation counts.
    pub operation_count: OperationCount,
    /// Preferred names of its results, all different.
    pub names: Vec<String>,
    /// Functions in the order of the module; they read the results of `once` as their only field.
    pub functions: Vec<GeneratedFunction>,
}

impl Module {
    /// Values of the base parameters, if a function ranges over them.
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

/// Facts about a robot for comments.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// Name of the robot.
    pub robot: String,
    /// Files of the description.
    pub source: Source,
    /// Link whose frame is frame 0.
    pub base: String,
    /// Link of the end effector.
    pub tip: String,
    /// Simplifications of the model: `2 links merged`, `gravity only along −z`.
    pub facts: Vec<String>,
    /// True if a joint has armature or friction.
    pub actuated: bool,
    /// Words of the requested formulation, if it is not the default.
    pub formulation: Vec<String>,
    /// Warnings about the description and the request.
    pub warnings: Vec<Diagnostic>,
    /// Functions that the robot can't have, if all functions were requested.
    pub left_out: Vec<LeftOut>,
}

impl About {
    /// Warnings without hints, a line each with its place.
    #[must_use]
    pub fn located_warnings(&self) -> Vec<String> {
        let places = self.source.errors();
        let warnings = self.warnings.iter();
        warnings.map(|warning| places.locate(warning)).collect()
    }
}

/// Functions that a robot can't have for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Names of the functions.
    pub functions: Vec<String>,
    /// Reason, as a sentence with its place.
    pub reason: String,
    /// Hint for the user.
    pub hint: Option<String>,
    /// True if the cause is a fault of the engine and not the robot.
    pub is_fault: bool,
}

/// A generated function: a method of the robot's type if the language has methods.
#[derive(Clone, Debug)]
pub struct GeneratedFunction {
    /// Functions that it computes; several share their work and are returned as a tuple.
    pub functions: Vec<Function>,
    /// Link of its frame, if that is not the end effector.
    pub frame: Option<String>,
    /// Frames of its matrices.
    pub layout: Layout,
    /// Operations.
    pub program: Program,
    /// Operation counts.
    pub operation_count: OperationCount,
    /// Error bounds: one for the results that are evaluated, and one for each that solves an equation.
    pub accuracy: Vec<Accuracy>,
    /// The largest error found, if the algorithm was chosen by it.
    pub found: Option<FoundError>,
}

/// The largest error of a function that solves an equation, in the states by which its algorithm was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundError {
    /// The type in which it was measured: `f64` for generic code.
    pub scalar: Real,
    /// The error, relative to the largest result \[1\].
    pub relative: f64,
    /// Number of random states, within the limits of the joints and at any angles.
    pub random: usize,
    /// Number of further states, uphill from the worst of them.
    pub uphill: usize,
}

impl GeneratedFunction {
    /// Name of its method, before the resolution of clashes.
    #[must_use]
    pub fn name(&self) -> String {
        name(&self.functions, self.frame.as_deref())
    }

    /// Union of the arguments of its functions.
    #[must_use]
    pub fn arguments(&self, spaces: &Spaces) -> Vec<Variable> {
        arguments(&self.functions, spaces.actions() > 0)
    }
}

/// Union of the arguments of several functions. `actions`: the robot has external wrenches.
pub(crate) fn arguments(functions: &[Function], actions: bool) -> Vec<Variable> {
    let each = functions.iter();
    Variable::together(each.map(|function| function.arguments_with(actions)))
}

/// `mass_matrix_and_bias`, `forward_kinematics_of_camera`.
#[must_use]
pub fn name(functions: &[Function], frame: Option<&str>) -> String {
    let names: Vec<_> = functions.iter().map(|function| function.name()).collect();
    let name = names.join("_and_");
    match frame {
        Some(frame) => format!("{name}_of_{frame}"),
        None => name,
    }
}

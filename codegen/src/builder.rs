//! Front end for build scripts.
//!
//! The methods of [`Builder`] have the names of the derive's keys. It writes a readable Rust file to `OUT_DIR` that
//! needs only `core`, a C file with its header, or a package for Python. Nothing is read or written before
//! [`Builder::write`], [`Builder::to_tokens`] or [`Builder::to_source`].

mod c;
mod command;
mod cpp;
mod file;
mod llvm;
mod output;
mod plain_python;
mod python;
#[cfg(test)]
mod tests;

pub use c::header_beside;
pub use command::FORMAT;
#[doc(hidden)]
pub use command::Language;
pub use python::{module_of, write_folder};

use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::parse::Parse;

use crate::description::{Description, Name, Number};
use crate::error::{Errors, Place};
use crate::expand;
use crate::formulation::Formulation;
use crate::function::Function;
use crate::joint::actuator::ActuatorQuantity;
use crate::module::Module;
use crate::print::rust::CoreFunctions;
use crate::print::rust::in_every_edition;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Integrator, Parameter, Request, Target};

/// Reads a robot and writes its functions.
///
/// In a build script:
///
/// ```no_run
/// # fn main() -> Result<(), homogen_codegen::error::Errors> {
/// use homogen_codegen::{Builder, Function::*, Real};
///
/// Builder::from_urdf("arm.urdf")
///     .tip("tool0")
///     .scalar(Real::F32)
///     .generate([InverseDynamics, Gravity])
///     .write("arm.rs")?;
/// # Ok(())
/// # }
/// ```
///
/// In the crate: `include!(concat!(env!("OUT_DIR"), "/arm.rs"));`.
///
/// Nothing is read before [`write`](Self::write), [`write_c`](Self::write_c), [`to_source`](Self::to_source),
/// [`to_c`](Self::to_c) or [`to_tokens`](Self::to_tokens). All errors of the file and of the options are then reported
/// at once. Options have the names of the keys of `#[derive(Robot)]`:
///
/// ```
/// use homogen_codegen::{Builder, Function, Real, Target};
///
/// let source = Builder::from_urdf("../robots/quadruped.urdf")
///     .name("Leg")
///     .base("base")
///     .tip("hr_foot")
///     .path_only() // the other legs stay, as mass
///     .gravity([0.0, 0.0, -9.81])
///     .damping("hr_knee", [0.05])
///     .rotor("hr_knee", 2e-5, 9.0)
///     .external("hr_foot") // the ground acts on it
///     .parameter_within("boot", Target::MassOf("hr_foot".into()), 0.0..=0.5)
///     .scalar(Real::F32)
///     .generate([Function::InverseDynamics])
///     .all_of([Function::MassMatrix, Function::Bias])
///     .to_source()?
///     .to_string();
/// assert!(source.contains("pub fn inverse_dynamics("));
/// assert!(source.contains("actions: &[[f32; 6]; 1]"));
/// assert!(source.contains("pub fn mass_matrix_and_bias("));
/// # Ok::<(), homogen_codegen::error::Errors>(())
/// ```
#[derive(Clone)]
#[must_use = "nothing is generated before `write`, `to_tokens` or `to_source`"]
pub struct Builder {
    origin: Origin,
    name: Option<Ident>,
    request: Request,
    core_functions: CoreFunctions,
    /// True if files are restricted to ASCII.
    ascii: bool,
    /// Errors of options; reported together with all others.
    mistakes: Errors,
    expand: Expand,
}

/// Source of the description.
#[derive(Clone)]
enum Origin {
    File(PathBuf),
    Description(Box<Description>),
}

/// All stages before printing.
type Expand = fn(&Description, &Request) -> Result<Module, Errors>;

impl Builder {
    /// A robot in a URDF or xacro file; relative paths begin at the folder of the build script's package.
    pub fn from_urdf(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot in an MJCF file, the format of MuJoCo, with the files that it includes; relative paths begin at the
    /// folder of the build script's package.
    pub fn from_mjcf(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot in an SDF file, the format of Gazebo and Drake, with the models that it includes; relative paths begin at
    /// the folder of the build script's package.
    pub fn from_sdf(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot in a file with a Denavit–Hartenberg table.
    pub fn from_denavit_hartenberg(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot with a description that is already read.
    pub fn from_description(description: Description) -> Self {
        Self::new(Origin::Description(Box::new(description)))
    }

    fn new(origin: Origin) -> Self {
        Self {
            origin,
            name: None,
            request: Request::default(),
            core_functions: CoreFunctions::default(),
            ascii: false,
            mistakes: Errors::new(),
            expand: expand::expand,
        }
    }

    /// An argument of a xacro file. It stands for the environment variable of the same name, too.
    pub fn argument(self, name: impl Into<String>, value: impl Into<String>) -> Self {
        let argument = (named(name), value.into());
        self.with(|asked| asked.arguments.push(argument))
    }

    /// The folder of a ROS package, for `$(find name)` in a xacro file; by default packages are found near the file.
    pub fn package(self, name: impl Into<String>, folder: impl Into<String>) -> Self {
        let package = (named(name), folder.into());
        self.with(|asked| asked.packages.push(package))
    }

    /// Replaces the whole request.
    pub fn request(self, request: Request) -> Self {
        Self { request, ..self }
    }

    /// The request that the calls have made, and the mistakes in them.
    #[doc(hidden)]
    #[must_use]
    pub fn into_request(self) -> (Request, Errors) {
        (self.request, self.mistakes)
    }

    fn with(mut self, ask: impl FnOnce(&mut Request)) -> Self {
        ask(&mut self.request);
        self
    }

    /// The name of the generated struct; the robot's own by default. The name of a primitive type of Rust, such as
    /// `f64`, gets an underscore.
    pub fn name(mut self, name: &str) -> Self {
        self.name = self.parsed(name);
        self
    }

    /// The fixed link; the root by default.
    pub fn base(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.base = Some(named(link)))
    }

    /// Makes the base floating: it moves by the joint `root`.
    pub fn floating(self) -> Self {
        self.with(|asked| asked.floating = true)
    }

    /// The end effector: the link of poses and Jacobians.
    pub fn tip(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.tip = Some(named(link)))
    }

    /// Locks every joint that does not move the end effector.
    pub fn path_only(self) -> Self {
        self.with(|asked| asked.path_only = true)
    }

    /// Locks a joint at 0; the bodies that it moves stay as mass.
    pub fn lock(self, joint: impl Into<String>) -> Self {
        self.with(|asked| asked.lock.push((named(joint), None)))
    }

    /// Locks a joint at a coordinate, in rad or m.
    pub fn lock_at(self, joint: impl Into<String>, coordinate: f64) -> Self {
        let held = (named(joint), Some(coordinate.into()));
        self.with(|asked| asked.lock.push(held))
    }

    /// Removes a link with all its descendants, and with their mass.
    pub fn drop(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.drop.push(named(link)))
    }

    /// Adds a joint that closes a loop between two links of the tree, written as after the word `loop` in attributes:
    /// `"pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0) }"`.
    pub fn closed(self, text: impl Into<String>) -> Self {
        self.with(|asked| asked.loops.push(text.into()))
    }

    /// The actuated joints of a robot with loops.
    pub fn actuated<J: Into<String>>(self, joints: impl IntoIterator<Item = J>) -> Self {
        self.with(|asked| asked.actuated.extend(joints.into_iter().map(named)))
    }

    /// Further links with functions of their frame.
    pub fn frames<L: Into<String>>(self, links: impl IntoIterator<Item = L>) -> Self {
        self.with(|asked| asked.frames.extend(links.into_iter().map(named)))
    }

    /// Models the collision spheres of the description: their centres, and the distances of those on links that no joint
    /// joins.
    pub fn collision(self) -> Self {
        self.with(|asked| asked.collision = true)
    }

    /// The same, with the distances of spheres on two links; further calls add further pairs of links.
    pub fn collision_between(self, first: impl Into<String>, second: impl Into<String>) -> Self {
        let pair = [named(first), named(second)];
        self.collision()
            .with(|asked| asked.collision_pairs.push(pair))
    }

    /// The acceleration of gravity in the base frame, in m/s²; (0, 0, −9.81) by default.
    pub fn gravity(self, gravity: [f64; 3]) -> Self {
        self.with(|asked| asked.gravity = Some(gravity.map(Number::from)))
    }

    /// A link with an external wrench: inverse and forward dynamics and their derivatives take `actions`, a wrench for
    /// each such link in the order of these calls, in the link's frame.
    pub fn external(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.external.push(named(link)))
    }

    /// The external wrenches are in frame 0: in its axes, with the moment about its origin.
    pub fn external_in_frame_0(self) -> Self {
        self.with(|asked| asked.external_in_frame_0 = true)
    }

    /// Models the damping and friction of the description.
    pub fn friction(self) -> Self {
        self.with(|asked| asked.friction = true)
    }

    /// Models the rotors of the description, with their gears.
    pub fn rotors(self) -> Self {
        self.with(|asked| asked.rotors = true)
    }

    /// Viscous friction of a joint, in N m s/rad or N s/m: one number, or one for each of its velocities. All friction
    /// of the description is then modelled, too.
    pub fn damping(self, joint: &str, damping: impl AsRef<[f64]>) -> Self {
        self.actuator(joint, ActuatorQuantity::Damping, damping.as_ref())
    }

    /// Coulomb friction of a joint, in N m or N: multiplied by the sign of the velocity, zero at rest.
    pub fn coulomb_friction(self, joint: &str, friction: impl AsRef<[f64]>) -> Self {
        self.actuator(joint, ActuatorQuantity::Friction, friction.as_ref())
    }

    /// Inertia at a joint in addition to the bodies, in kg m² or kg. All rotors of the description are then modelled,
    /// too.
    pub fn armature(self, joint: &str, armature: impl AsRef<[f64]>) -> Self {
        self.actuator(joint, ActuatorQuantity::Armature, armature.as_ref())
    }

    /// A rotor, by its inertia in kg m² and its turns for one of the joint: the inertia is multiplied by the square of
    /// the ratio.
    pub fn rotor(self, joint: &str, inertia: f64, ratio: f64) -> Self {
        let with_inertia = self.actuator(joint, ActuatorQuantity::Rotor, &[inertia]);
        with_inertia.actuator(joint, ActuatorQuantity::Ratio, &[ratio])
    }

    fn actuator(self, joint: &str, quantity: ActuatorQuantity, numbers: &[f64]) -> Self {
        let numbers = numbers.iter().copied().map(Number::from).collect();
        self.with(|asked| asked.actuators.push((joint.into(), quantity, numbers)))
    }

    /// Keeps `1.5708` as written instead of taking it for π/2.
    pub fn exact(self) -> Self {
        self.with(|asked| asked.exact = true)
    }

    /// Makes warnings errors, such as those of non-physical inertias.
    pub fn strict(self) -> Self {
        self.with(|asked| asked.strict = true)
    }

    /// Writes warnings only into comments, and does not report them to cargo.
    pub fn quiet(self) -> Self {
        self.with(|asked| asked.quiet = true)
    }

    /// The type of numbers; without the runtime [`Real::Generic`] becomes `f64`.
    pub fn scalar(self, scalar: Real) -> Self {
        self.with(|asked| asked.scalar = scalar)
    }

    /// The same bits on every processor: no product is fused with a sum, and vectors are still chosen at run time. A
    /// file for `core` alone is always so.
    pub fn reproducible(self) -> Self {
        self.with(|asked| asked.reproducible = true)
    }

    /// Adds functions of slices of states, `gravity_batch` beside `gravity`, on the widest vectors of the processor at
    /// run time. It needs [`runtime`](Self::runtime), with its feature `batch`.
    pub fn batch(self) -> Self {
        self.with(|asked| asked.batch = true)
    }

    /// Functions, each a method of its own.
    pub fn generate(self, functions: impl IntoIterator<Item = Function>) -> Self {
        let functions = functions.into_iter().map(|function| vec![function]);
        self.with(|asked| asked.functions.extend(functions))
    }

    /// Functions that become one method: they share their work and return a tuple.
    pub fn all_of(self, functions: impl IntoIterator<Item = Function>) -> Self {
        self.with(|asked| asked.functions.push(functions.into_iter().collect()))
    }

    /// Algorithms and frames of the functions; the engine chooses the rest.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), homogen_codegen::error::Errors> {
    /// use homogen_codegen::formulation::{Formulation, Parameters};
    /// use homogen_codegen::{Builder, Function::InverseDynamics};
    ///
    /// Builder::from_urdf("arm.urdf")
    ///     .formulation(Formulation::default().with_parameters(Parameters::Raw))
    ///     .generate([InverseDynamics])
    ///     .write("arm.rs")?;
    /// # Ok(())
    /// # }
    /// ```
    pub fn formulation(self, formulation: Formulation) -> Self {
        self.with(|asked| asked.formulation = formulation)
    }

    /// The processor that the functions run on: it decides which operations are used, and the comments state its
    /// cycles.
    pub fn processor(self, processor: Processor) -> Self {
        self.with(|asked| asked.processor = processor)
    }

    /// Computes once what depends only on fields: `arm.prepare()` returns a value with the same functions, which
    /// compute the rest. In C it is `arm_prepare` with a struct to fill. The functions of [`Builder::extern_c`] are
    /// those of the robot itself.
    pub fn prepare(self) -> Self {
        self.with(|asked| asked.prepare = true)
    }

    /// Maximum number of statements of one compiled function: a longer one is cut into sections that are called one
    /// after the other, with identical results. By default, functions of more than 8000 statements are cut into
    /// sections of at most 2000. Functions of slices of states are never cut.
    pub fn section(self, most: NonZeroUsize) -> Self {
        self.with(|asked| asked.section = Some(most.get()))
    }

    /// Adds a public field to the struct that replaces a number of the description.
    ///
    /// Error bounds hold for a mass from 0 to twice the described one (to 1 kg if that is 0), for entries of vectors up
    /// to twice the largest described one (up to 1), and for a payload of up to 1 kg whose centre of mass is up to 0.25
    /// m away along each axis.
    pub fn parameter(self, field: &str, target: Target) -> Self {
        self.field(field, target, None)
    }

    /// As [`parameter`](Self::parameter), with a range of each entry: `0.0..=3.0`; of a payload it is the range of its
    /// mass.
    ///
    /// Error bounds hold for this range; it is not checked at run time.
    pub fn parameter_within(
        mut self,
        field: &str,
        target: Target,
        range: RangeInclusive<f64>,
    ) -> Self {
        let ends = [*range.start(), *range.end()];
        if let Some([problem, hint]) = target.refusal(ends) {
            let message = format!("the range of field `{field}` {problem}");
            self.mistakes.push_with_hint(Place::Unknown, message, hint);
        }
        self.field(field, target, Some(ends))
    }

    fn field(mut self, field: &str, target: Target, range: Option<[f64; 2]>) -> Self {
        if let Some(field) = self.parsed(field) {
            self.request.parameters.push(Parameter {
                field: in_every_edition(field),
                target,
                range,
            });
        }
        self
    }

    /// The path of a function from an angle \[rad\] to its sine and cosine.
    ///
    /// By default the file has its own: code without branches in the type of its numbers, whose doc comment states
    /// error and range (3200 rad in `f32`, 2e5 rad in `f64`). `"::libm::sincosf"` and `"::libm::sincos"` accept any
    /// angle (the first computes in double precision), and `"crate::sines::table"` may be any function of your own.
    pub fn sin_cos(mut self, path: &str) -> Self {
        self.core_functions.sin_cos = self.path(path);
        self
    }

    /// Adds `CasADi`'s external interface to a file in C: `casadi.external("arm_casadi_gravity", library)`, with Jacobian,
    /// gradient and Hessian of functions whose derivatives are among the [`generated`](Self::generate) ones.
    pub fn casadi(self) -> Self {
        self.with(|asked| asked.for_c.casadi = true)
    }

    /// Adds time steps by a rule to a file in C: `arm_step`, and as far as derivatives of forward dynamics are
    /// [generated](Self::generate) `arm_step_derivatives` (A and B) and `arm_step_hessian`. The implicit midpoint rule is
    /// an equation for the velocities after a step: `arm_midpoint_residual`, `arm_midpoint_configuration` and, with the
    /// derivatives of inverse dynamics and the mass matrix, `arm_midpoint_derivatives`.
    pub fn steps(self, rule: Integrator) -> Self {
        self.with(|asked| asked.for_c.steps = Some(rule))
    }

    /// Adds these steps to a file in C as discrete dynamics of acados, for `dyn_ext_fun_type = 'generic'`:
    /// `arm_acados_fun`, `arm_acados_fun_jac` and, with the Hessian, `arm_acados_fun_jac_hess`. The first parameter of
    /// the model is the duration of a step \[s\].
    pub fn acados(self) -> Self {
        self.with(|asked| asked.for_c.acados = true)
    }

    /// Adds functions for C beside the methods, with names of this prefix and the method: `arm_gravity`. A second
    /// underscore is inserted where the name could belong to another robot, as `mobile_base_regressor` could be the
    /// base regressor of `mobile_`.
    ///
    /// [`Builder::write_c_header`] writes the header that declares them. They are `#[no_mangle]`, which compilers since
    /// Rust 1.82 accept and `forbid(unsafe_code)` rejects: their names must be unique in the program.
    pub fn extern_c(mut self, prefix: &str) -> Self {
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if prefix.starts_with(|c: char| c.is_ascii_digit()) || !prefix.chars().all(letter) {
            let message = format!("`{prefix}` cannot begin a name in C");
            self.mistakes.push(Place::Unknown, message);
        }
        self.core_functions.c_prefix = Some(prefix.to_owned());
        self
    }

    /// Restricts files to ASCII: other letters are spelled in comments (`theta`, `q_dot`, `m^2`), and written as
    /// `\u{…}` in names of joints.
    ///
    /// Names that become names of functions, such as that of a further frame, must then be ASCII.
    pub fn ascii(mut self) -> Self {
        self.ascii = true;
        self
    }

    /// Writes the code of the derive, for a crate with the runtime at `path` (`::homogen`), with typed matrices and
    /// traits.
    pub fn runtime(mut self, path: &str) -> Self {
        self.request.runtime = self.path(path);
        self
    }

    fn path(&mut self, text: &str) -> Option<TokenStream> {
        let path: Option<syn::Path> = self.parsed(text);
        path.map(ToTokens::into_token_stream)
    }

    /// A piece of Rust, or an error.
    fn parsed<T: Parse>(&mut self, text: &str) -> Option<T> {
        let parsed = syn::parse_str(text);
        if let Err(reason) = &parsed {
            let message = format!("`{text}` is not valid Rust for this option: {reason}");
            self.mistakes.push(Place::Unknown, message);
        }
        parsed.ok()
    }
}

fn named(text: impl Into<String>) -> Name {
    Name::from(text.into())
}

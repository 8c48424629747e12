//! The door for build scripts.
//!
//! In: calls, in the vocabulary of the derive's attributes. Out: a readable file in `OUT_DIR` that
//! needs `core` and nothing else, one in C with its header, or a package for Python. It never reads or writes anything
//! before [`Builder::write`], [`Builder::to_tokens`] or [`Builder::to_source`].

mod c;
mod command;
mod file;
mod llvm;
mod output;
mod python;
#[cfg(test)]
mod tests;

pub use c::header_beside;
pub use command::FORMAT;
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
use crate::joint::drive::Part;
use crate::module::Module;
use crate::print::rust::Library;
use crate::print::rust::in_every_edition;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Parameter, Request, Target};

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
/// [`to_c`](Self::to_c) or [`to_tokens`](Self::to_tokens); then every mistake of the file and of the options is told
/// at once. Options are in the vocabulary of the attributes of `#[derive(Robot)]`:
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
    library: Library,
    /// Whether files are ASCII.
    ascii: bool,
    /// Options that are not what they should be; told with all other mistakes.
    mistakes: Errors,
    expand: Expand,
}

/// Where the description comes from.
#[derive(Clone)]
enum Origin {
    File(PathBuf),
    Description(Box<Description>),
}

/// All stages but the last.
type Expand = fn(&Description, &Request) -> Result<Module, Errors>;

impl Builder {
    /// A robot in a URDF file; a relative path begins at the package of the build script.
    pub fn from_urdf(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot in an MJCF file, the format of MuJoCo, which is read with the files that it includes; a relative path
    /// begins at the package of the build script.
    pub fn from_mjcf(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot in a file with a Denavit–Hartenberg table.
    pub fn from_denavit_hartenberg(path: impl Into<PathBuf>) -> Self {
        Self::new(Origin::File(path.into()))
    }

    /// A robot that is described already.
    pub fn from_description(description: Description) -> Self {
        Self::new(Origin::Description(Box::new(description)))
    }

    fn new(origin: Origin) -> Self {
        Self {
            origin,
            name: None,
            request: Request::default(),
            library: Library::default(),
            ascii: false,
            mistakes: Errors::new(),
            expand: expand::expand,
        }
    }

    /// All that a request says, in place of what was said before.
    pub fn request(self, request: Request) -> Self {
        Self { request, ..self }
    }

    fn with(mut self, ask: impl FnOnce(&mut Request)) -> Self {
        ask(&mut self.request);
        self
    }

    /// The name of the struct that is written; the robot's own where none is given. One of a type that Rust has, such
    /// as `f64`, gets an underscore.
    pub fn name(mut self, name: &str) -> Self {
        self.name = self.parsed(name);
        self
    }

    /// The link taken as fixed; the root where none is named.
    pub fn base(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.base = Some(named(link)))
    }

    /// Frees the base: it moves anyhow, as the joint `root`, and is no longer taken as fixed.
    pub fn floating(self) -> Self {
        self.with(|asked| asked.floating = true)
    }

    /// The link whose frame poses and Jacobians are of.
    pub fn tip(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.tip = Some(named(link)))
    }

    /// Locks every joint that does not move the tip.
    pub fn path_only(self) -> Self {
        self.with(|asked| asked.path_only = true)
    }

    /// Holds a joint still at zero; the bodies it carries stay as mass.
    pub fn lock(self, joint: impl Into<String>) -> Self {
        self.with(|asked| asked.lock.push((named(joint), None)))
    }

    /// Holds a joint still at a coordinate, in rad or m.
    pub fn lock_at(self, joint: impl Into<String>, coordinate: f64) -> Self {
        let held = (named(joint), Some(coordinate.into()));
        self.with(|asked| asked.lock.push(held))
    }

    /// Takes a link off with all that it carries, and with their mass.
    pub fn drop(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.drop.push(named(link)))
    }

    /// Closes a loop by a joint between two links that hang on the base anyhow, told as behind the word
    /// `loop` of attributes: `"pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0) }"`.
    pub fn closed(self, text: impl Into<String>) -> Self {
        self.with(|asked| asked.loops.push(text.into()))
    }

    /// The joints that are driven, where loops move the others.
    pub fn actuated<J: Into<String>>(self, joints: impl IntoIterator<Item = J>) -> Self {
        self.with(|asked| asked.actuated.extend(joints.into_iter().map(named)))
    }

    /// Further links whose frames the functions of a frame are generated for.
    pub fn frames<L: Into<String>>(self, links: impl IntoIterator<Item = L>) -> Self {
        self.with(|asked| asked.frames.extend(links.into_iter().map(named)))
    }

    /// The acceleration of gravity in the base frame, in m/s²; (0, 0, −9.81) where none is given.
    pub fn gravity(self, gravity: [f64; 3]) -> Self {
        self.with(|asked| asked.gravity = Some(gravity.map(Number::from)))
    }

    /// A link on which the surroundings act: inverse and forward dynamics and their derivatives take
    /// `actions`, one for each such link in the order of these calls, in the link's frame.
    pub fn external(self, link: impl Into<String>) -> Self {
        self.with(|asked| asked.external.push(named(link)))
    }

    /// All these actions are in frame 0: in its axes, with the couple about its origin.
    pub fn external_in_frame_0(self) -> Self {
        self.with(|asked| asked.external_in_frame_0 = true)
    }

    /// Models the damping and the friction that the description has.
    pub fn friction(self) -> Self {
        self.with(|asked| asked.friction = true)
    }

    /// Models the rotors that the description has, with their gears.
    pub fn rotors(self) -> Self {
        self.with(|asked| asked.rotors = true)
    }

    /// Viscous friction of a joint, in N m s/rad or N s/m: one number, or one for each of its velocities.
    /// With it all friction is modelled that the description has.
    pub fn damping(self, joint: &str, damping: impl AsRef<[f64]>) -> Self {
        self.drive(joint, Part::Damping, damping.as_ref())
    }

    /// Coulomb friction of a joint, in N m or N: what it takes times the sign of the rate, nothing at rest.
    pub fn coulomb_friction(self, joint: &str, friction: impl AsRef<[f64]>) -> Self {
        self.drive(joint, Part::Friction, friction.as_ref())
    }

    /// Inertia that a joint feels beside that of the bodies, in kg m² or kg. With it all rotors are modelled
    /// that the description has.
    pub fn armature(self, joint: &str, armature: impl AsRef<[f64]>) -> Self {
        self.drive(joint, Part::Armature, armature.as_ref())
    }

    /// A rotor, by its inertia in kg m² and its turns for each of the joint: the joint feels the inertia
    /// times the square of the ratio.
    pub fn rotor(self, joint: &str, inertia: f64, ratio: f64) -> Self {
        let with_inertia = self.drive(joint, Part::Rotor, &[inertia]);
        with_inertia.drive(joint, Part::Ratio, &[ratio])
    }

    fn drive(self, joint: &str, part: Part, numbers: &[f64]) -> Self {
        let numbers = numbers.iter().copied().map(Number::from).collect();
        self.with(|asked| asked.drives.push((joint.into(), part, numbers)))
    }

    /// Keeps `1.5708` as written instead of taking it for π/2.
    pub fn exact(self) -> Self {
        self.with(|asked| asked.exact = true)
    }

    /// Refuses what is doubtful, such as inertias that no body can have, instead of warning.
    pub fn strict(self) -> Self {
        self.with(|asked| asked.strict = true)
    }

    /// Writes warnings into comments alone, and does not report them to cargo.
    pub fn quiet(self) -> Self {
        self.with(|asked| asked.quiet = true)
    }

    /// The type of number; without the runtime [`Real::Generic`] is taken for `f64`.
    pub fn scalar(self, scalar: Real) -> Self {
        self.with(|asked| asked.scalar = scalar)
    }

    /// Takes slices of states besides, `gravity_batch` beside `gravity`, on the widest vectors of the processor
    /// that runs. It takes [`runtime`](Self::runtime), with its feature `batch`.
    pub fn batch(self) -> Self {
        self.with(|asked| asked.batch = true)
    }

    /// Functions, each a method of its own.
    pub fn generate(self, functions: impl IntoIterator<Item = Function>) -> Self {
        let functions = functions.into_iter().map(|function| vec![function]);
        self.with(|asked| asked.functions.extend(functions))
    }

    /// Functions that become one method: they share their work and are returned as a tuple.
    pub fn all_of(self, functions: impl IntoIterator<Item = Function>) -> Self {
        self.with(|asked| asked.functions.push(functions.into_iter().collect()))
    }

    /// How the functions are computed; what is not chosen is left to the engine.
    ///
    /// ```no_run
    /// # fn main() -> Result<(), homogen_codegen::error::Errors> {
    /// use homogen_codegen::formulation::{Formulation, Parameters};
    /// use homogen_codegen::{Builder, Function::InverseDynamics};
    ///
    /// Builder::from_urdf("arm.urdf")
    ///     .formulation(Formulation { parameters: Parameters::Raw, ..Formulation::default() })
    ///     .generate([InverseDynamics])
    ///     .write("arm.rs")?;
    /// # Ok(())
    /// # }
    /// ```
    pub fn formulation(self, formulation: Formulation) -> Self {
        self.with(|asked| asked.formulation = formulation)
    }

    /// The processor that the functions run on; it decides which operations are chosen, and the price
    /// tells its cycles.
    pub fn processor(self, processor: Processor) -> Self {
        self.with(|asked| asked.processor = processor)
    }

    /// Computes once what depends on fields alone: `arm.prepare()` gives a value with the same functions, of
    /// which each computes the rest. In C it is `arm_prepare` and a struct for it to fill; the functions of
    /// [`Builder::extern_c`] are those of the robot itself.
    pub fn prepare(self) -> Self {
        self.with(|asked| asked.prepare = true)
    }

    /// The most statements of one compiled function: a longer one is cut into sections that are called one after
    /// the other, with the same bits. Without this, functions of more than 8000 statements are cut into sections
    /// of at most 2000. A function that takes slices of states besides is never cut.
    pub fn section(self, most: NonZeroUsize) -> Self {
        self.with(|asked| asked.section = Some(most.get()))
    }

    /// A public field of the struct that takes the place of a number of the description.
    ///
    /// Error bounds are for a mass from zero to twice what is described (to 1 kg where that is
    /// nothing), for entries of vectors of up to twice the largest that is described (of up to 1); for a
    /// payload of up to 1 kg, whose centre is up to 0.25 m off along each axis.
    pub fn parameter(self, field: &str, target: Target) -> Self {
        self.field(field, target, None)
    }

    /// The same, with the range that each of its entries is meant to have: `0.0..=3.0`; of a payload its mass.
    ///
    /// Error bounds are for this range; nothing checks it at run time.
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
    /// Where none is given the file brings its own: straight code in the type of its numbers, whose
    /// doc comment tells error and range (3200 rad in `f32`, 2e5 rad in `f64`). `"::libm::sincosf"`
    /// and `"::libm::sincos"` are ready for any angle (the first computes in double precision), and
    /// `"crate::sines::table"` may be whatever suits the processor.
    pub fn sin_cos(mut self, path: &str) -> Self {
        self.library.sin_cos = self.path(path);
        self
    }

    /// Functions for C beside the methods, whose names are this and the method's: `arm_gravity`. Where both together
    /// could be those of another robot, as `mobile_base_regressor` could be the base regressor of `mobile_`, a second
    /// underscore stands between them.
    ///
    /// [`Builder::write_c_header`] writes the header that declares them. They are `#[no_mangle]`,
    /// which compilers from Rust 1.82 on take and `forbid(unsafe_code)` does not: nothing else in the
    /// program may have their names.
    pub fn extern_c(mut self, prefix: &str) -> Self {
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
        if prefix.starts_with(|c: char| c.is_ascii_digit()) || !prefix.chars().all(letter) {
            let message = format!("no name in C begins with `{prefix}`");
            self.mistakes.push(Place::Unknown, message);
        }
        self.library.c_prefix = Some(prefix.to_owned());
        self
    }

    /// Files without a character beyond ASCII: letters of other alphabets are spelt in comments (`theta`, `q_dot`,
    /// `m^2`), and stand as `\u{…}` in names of joints.
    ///
    /// What gives functions their names, such as a further frame, has to be ASCII then.
    pub fn ascii(mut self) -> Self {
        self.ascii = true;
        self
    }

    /// Writes what the derive would: code for a crate that has the runtime, at `path`
    /// (`::homogen`), with typed matrices and traits.
    pub fn runtime(mut self, path: &str) -> Self {
        self.request.runtime = self.path(path);
        self
    }

    fn path(&mut self, text: &str) -> Option<TokenStream> {
        let path: Option<syn::Path> = self.parsed(text);
        path.map(ToTokens::into_token_stream)
    }

    /// A part of Rust, or a mistake.
    fn parsed<T: Parse>(&mut self, text: &str) -> Option<T> {
        let parsed = syn::parse_str(text);
        if let Err(reason) = &parsed {
            let message = format!("`{text}` is not what an option wants: {reason}");
            self.mistakes.push(Place::Unknown, message);
        }
        parsed.ok()
    }
}

fn named(text: impl Into<String>) -> Name {
    Name::from(text.into())
}

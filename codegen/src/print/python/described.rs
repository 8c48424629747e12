//! The class of a robot, as Python sees it.
//!
//! In: a [`Module`]. Out: the names, shapes and texts of its methods and attributes, which the extension and
//! its stub share. It never writes a language.

use proc_macro2::Ident;
use syn::ext::IdentExt;

use super::names::{in_module, unscoped};
use crate::module::{GeneratedFunction, Module};
use crate::print::documentation;
use crate::print::rust::names::{self as rust, ident, of_methods, type_name};
use crate::print::rust::{Item, under};
use crate::print::steps::Step;
use crate::real::Real;
use crate::request::Parameter;
use crate::space::{ACTION, Entity, Outcome, Quantity, Space, Spaces, Variable};

/// The class.
pub(super) struct Class<'l> {
    pub listing: &'l Module,
    /// What Python imports.
    pub module: &'l str,
    /// What it is called in Python.
    pub name: String,
    /// What the struct is called in Rust.
    pub robot: Ident,
    /// What is said of it.
    pub about: Vec<String>,
    pub methods: Vec<Method>,
    /// The fields, each by its name in Python.
    pub fields: Vec<(String, &'l Parameter)>,
    /// The names of entries, each as an attribute.
    pub names: Vec<(&'static str, &'static str, Space)>,
}

/// A function of the robot.
pub(super) struct Method {
    /// Its name, in both languages.
    pub name: Ident,
    /// What is said of it.
    pub about: Vec<String>,
    /// Its arguments, and their last axes.
    pub arguments: Vec<(&'static str, Vec<usize>)>,
    /// What it returns.
    pub results: Vec<Returned>,
    /// What the tuple of several results is called.
    pub tuple: Option<String>,
}

/// One array that a function returns.
pub(super) struct Returned {
    /// Its name beside arguments.
    pub name: Ident,
    /// Its name in a tuple.
    pub field: String,
    /// Its last axes.
    pub last: Vec<usize>,
    /// What it is among several.
    pub about: Option<&'static str>,
    /// What its rows are.
    rows: Option<&'static str>,
}

/// What NumPy calls a type of number.
pub(super) const fn dtype(real: Real) -> &'static str {
    match real {
        Real::F32 => "float32",
        Real::F64 | Real::Generic => "float64",
    }
}

impl<'l> Class<'l> {
    pub fn of(listing: &'l Module, item: &Item, module: &'l str, options: &str) -> Self {
        let mut names = in_module(module);
        let name = names.alone(&item.ident.unraw().to_string());
        let of_methods = of_methods(listing);
        let methods = listing.functions.iter().zip(&of_methods);
        // The neutral configuration is an attribute.
        let steps = Step::of(listing)
            .iter()
            .filter(|step| **step != Step::Neutral);
        let steps = steps.map(|&step| Method::of_step(step, &listing.spaces));
        let methods: Vec<_> = methods
            .map(|(generated, name)| {
                let mut tuple = |wish: &str| names.alone(&type_name(wish));
                Method::of(listing, generated, name, &mut tuple)
            })
            .chain(steps)
            .collect();
        let mut attributes = unscoped();
        for method in &methods {
            attributes.take(&method.name.to_string());
        }
        for own in OWN {
            attributes.take(own);
        }
        // The extension has functions of these names.
        for word in rust::KEYWORDS {
            attributes.take(word);
        }
        let fields = listing.parameters.iter();
        let fields = fields.map(|field| (attributes.fresh(&field.name()), field));
        Self {
            listing,
            module,
            name,
            robot: item.ident.clone(),
            about: documentation::of_robot(listing, &format!("Options: {options}.")),
            fields: fields.collect(),
            names: NAMES
                .into_iter()
                .filter(|(.., space)| is_spoken_of(listing, *space))
                .collect(),
            methods,
        }
    }

    /// What NumPy calls its type of number.
    pub fn dtype(&self) -> &'static str {
        dtype(self.listing.scalar)
    }

    /// The lowest and the highest of each entry of a space, infinite where nothing is said.
    pub fn limits(&self, space: Space) -> Vec<[f64; 2]> {
        let entries = self.listing.spaces.entries(space).iter();
        let unknown = [f64::NEG_INFINITY, f64::INFINITY];
        entries
            .map(|entry| entry.range.unwrap_or(unknown))
            .collect()
    }
}

impl Method {
    /// A function of the request.
    fn of(
        listing: &Module,
        generated: &GeneratedFunction,
        name: &Ident,
        tuple: &mut dyn FnMut(&str) -> String,
    ) -> Self {
        let spaces = &listing.spaces;
        let is_alone = generated.functions.len() == 1;
        let returned = |name: String, field: String, about, quantity: Quantity| Returned {
            name: ident(&name),
            field,
            last: last(&quantity, spaces),
            about,
            rows: rows(&quantity),
        };
        let results = generated.functions.iter().flat_map(|function| {
            let function_name = function.name().to_owned();
            match function.result() {
                Outcome::One(quantity) => {
                    vec![returned(
                        function_name.clone(),
                        function_name,
                        None,
                        quantity,
                    )]
                }
                Outcome::Parts(parts) => parts
                    .iter()
                    .map(|part| {
                        let name = format!("{function_name}_{}", part.name);
                        let field = if is_alone {
                            part.name.to_owned()
                        } else {
                            name.clone()
                        };
                        returned(name, field, Some(part.about), part.quantity)
                    })
                    .collect(),
            }
        });
        let results: Vec<_> = results.collect();
        let arguments = generated.arguments(spaces).into_iter();
        let mut method = Self {
            name: name.clone(),
            about: documentation::of_function(listing, generated, None, None),
            arguments: arguments
                .map(|argument| (argument.name(), last_of_argument(argument, spaces)))
                .collect(),
            tuple: (results.len() > 1).then(|| tuple(&name.to_string())),
            results,
        };
        // Behind what is computed, and the empty line after it.
        method.insert_shapes(match generated.functions.len() {
            1 => 2,
            several => several + 3,
        });
        method
    }

    /// A function of postures alone.
    fn of_step(step: Step, spaces: &Spaces) -> Self {
        let last = |space| vec![spaces.len(space)];
        let result = Returned {
            name: ident(step.name()),
            field: step.name().to_owned(),
            last: last(step.result()),
            about: None,
            rows: None,
        };
        let arguments = step.arguments().iter();
        let mut method = Self {
            name: ident(step.name()),
            about: step.about().map(str::to_owned).into(),
            arguments: arguments
                .map(|&(name, space)| (name, last(space)))
                .collect(),
            results: vec![result],
            tuple: None,
        };
        method.about.insert(1, String::new());
        method.insert_shapes(2);
        method
    }

    /// Says at a line what the shapes are.
    fn insert_shapes(&mut self, at: usize) {
        let at = at.min(self.about.len());
        let shapes = self.shapes().into_iter().chain([String::new()]);
        let _ = self.about.splice(at..at, shapes);
    }

    /// The shapes of what it takes and returns.
    fn shapes(&self) -> Vec<String> {
        let arguments = self.arguments.iter();
        let arguments = arguments
            .map(|(argument, last)| format!("{argument} {}", shape(last)))
            .collect::<Vec<_>>();
        let mut lines = vec![format!("Shapes: {}.", arguments.join(", "))];
        match (&self.tuple, &*self.results) {
            (Some(tuple), results) => {
                lines.push(format!("Returns {tuple}:"));
                lines.extend(results.iter().map(|result| format!("- {}", result.told())));
            }
            (None, results) => {
                lines.extend(
                    results
                        .iter()
                        .map(|result| format!("Returns {}.", result.shaped())),
                );
            }
        }
        lines
    }
}

impl Returned {
    /// Its name, shape and meaning.
    pub fn told(&self) -> String {
        let about = self
            .about
            .map_or(String::new(), |about| format!("; {about}"));
        format!(
            "{} {}{}",
            self.field,
            self.shaped(),
            about.trim_end_matches('.')
        )
    }

    /// Whether it is a number of each state.
    pub fn is_number(&self) -> bool {
        self.last.is_empty()
    }

    /// Its shape, and what its rows are.
    fn shaped(&self) -> String {
        let shape = shape(&self.last);
        self.rows
            .map_or_else(|| shape.clone(), |rows| format!("{shape}: {rows}"))
    }
}

/// What the rows of a quantity are.
fn rows(quantity: &Quantity) -> Option<&'static str> {
    let of_each = !quantity.over.is_empty();
    Some(match (quantity.entity, of_each) {
        (Entity::Number, _) => return None,
        (Entity::Pose, _) => "the 4×4 matrix",
        (Entity::Acceleration, _) => "the 4×4 matrix (G, a)",
        (Entity::Velocity, _) => "ω, then v",
        (Entity::Point | Entity::Vector, false) => "x, y, z",
        (Entity::Point | Entity::Vector, true) => "a row for each velocity: x, y, z",
        (Entity::Momentum, false) => "γ, then ρ: angular first",
        (Entity::Momentum, true) => "a row for each velocity: γ, then ρ, angular first",
        (Entity::Action, _) => "c, then f: couple first",
        (Entity::Screw, _) => "a row for each velocity: the screw u, b, angular first",
    })
}

/// The attributes that every class has, and those of what only some robots have.
const NAMES: [(&str, &str, Space); 5] = [
    (
        "coordinate_names",
        "What the entries of q are called.",
        Space::Coordinates,
    ),
    (
        "velocity_names",
        "What the entries of qd, qdd and tau are called.",
        Space::Velocities,
    ),
    (
        "constraint_names",
        "What the residuals of loops are called.",
        Space::Constraints,
    ),
    (
        "parameter_names",
        "What the inertial parameters are called.",
        Space::Parameters,
    ),
    (
        "base_parameter_names",
        "The parameter that leads each base parameter.",
        Space::BaseParameters,
    ),
];

/// The other names that a class has.
const OWN: [&str; 12] = [
    "NQ",
    "NV",
    "coordinate_names",
    "velocity_names",
    "constraint_names",
    "parameter_names",
    "base_parameter_names",
    "base_parameters",
    "coordinate_limits",
    "velocity_limits",
    "neutral",
    "new",
];

/// Whether arguments or results are over a space.
fn is_spoken_of(listing: &Module, space: Space) -> bool {
    let mut functions = listing
        .functions
        .iter()
        .flat_map(|generated| &generated.functions);
    matches!(space, Space::Coordinates | Space::Velocities)
        || functions.any(|function| {
            let mut parts = function.result().parts();
            parts.any(|(_, part)| part.over.contains(&space))
        })
}

fn last(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut last = quantity.lengths(spaces);
    match quantity.entity {
        entity if !under(entity).is_empty() => last.extend([4, 4]),
        entity => last.extend(entity.dimensions()),
    }
    last
}

fn last_of_argument(argument: Variable, spaces: &Spaces) -> Vec<usize> {
    match argument {
        Variable::Actions => vec![spaces.actions(), ACTION.len()],
        _ => vec![spaces.len(argument.space())],
    }
}

/// The shape of as many states as there are, with these last axes.
fn shape(last: &[usize]) -> String {
    let last: Vec<String> = last.iter().map(|length| format!(", {length}")).collect();
    format!("(...{})", last.concat())
}

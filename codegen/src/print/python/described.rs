//! The class of a robot in Python.
//!
//! In: a [`Module`]. Out: names, shapes and documentation of its methods and attributes, which the extension and its
//! stub share.

use proc_macro2::Ident;
use syn::ext::IdentExt;

use super::names::{in_module, unscoped};
use crate::module::{GeneratedFunction, Module};
use crate::print::documentation;
use crate::print::rust::Item;
use crate::print::rust::names::{self as rust, ident, of_methods, type_name};
use crate::print::steps::ConfigurationFunction;
use crate::real::Real;
use crate::request::Parameter;
use crate::space::{ACTION, Entity, Outcome, Quantity, Space, Spaces, Variable};

/// Class of a robot.
pub(super) struct Class<'m> {
    pub module: &'m Module,
    /// Name for `import`.
    pub import_name: &'m str,
    /// Name in Python.
    pub name: String,
    /// Name of the struct in Rust.
    pub robot: Ident,
    /// Documentation.
    pub about: Vec<String>,
    pub methods: Vec<Method>,
    /// Fields with their names in Python.
    pub fields: Vec<(String, &'m Parameter)>,
    /// Attributes with names of entries: attribute, documentation and space.
    pub names: Vec<(&'static str, &'static str, Space)>,
}

/// Method of the class.
pub(super) struct Method {
    /// Name in both languages.
    pub name: Ident,
    /// Documentation.
    pub about: Vec<String>,
    /// Arguments and their last axes.
    pub arguments: Vec<(&'static str, Vec<usize>)>,
    /// Results.
    pub results: Vec<Returned>,
    /// Name of the tuple, if there are several results.
    pub tuple: Option<String>,
}

/// Array that a method returns.
pub(super) struct Returned {
    /// Name of a local variable, distinct from arguments.
    pub name: Ident,
    /// Name in a tuple.
    pub field: String,
    /// Last axes.
    pub last: Vec<usize>,
    /// Documentation among several results.
    pub about: Option<&'static str>,
    /// Contents of its rows.
    rows: Option<&'static str>,
}

/// Name of a scalar type in NumPy.
pub(super) const fn dtype(real: Real) -> &'static str {
    match real {
        Real::F32 => "float32",
        Real::F64 | Real::Generic => "float64",
    }
}

impl<'m> Class<'m> {
    pub fn of(module: &'m Module, item: &Item, import_name: &'m str, options: &str) -> Self {
        let mut names = in_module(import_name);
        let name = names.alone(&item.ident.unraw().to_string());
        let of_methods = of_methods(module);
        let methods = module.functions.iter().zip(&of_methods);
        // The neutral configuration is an attribute.
        let steps = ConfigurationFunction::of(module)
            .iter()
            .filter(|step| **step != ConfigurationFunction::Neutral);
        let steps = steps.map(|&step| Method::of_step(step, &module.spaces));
        let methods: Vec<_> = methods
            .map(|(generated, name)| {
                let mut tuple = |wish: &str| names.alone(&type_name(wish));
                Method::of(module, generated, name, &mut tuple)
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
        let fields = module.parameters.iter();
        let fields = fields.map(|field| (attributes.fresh(&field.name()), field));
        Self {
            module,
            import_name,
            name,
            robot: item.ident.clone(),
            about: documentation::of_robot(module, &format!("Options: {options}.")),
            fields: fields.collect(),
            names: NAMES
                .into_iter()
                .filter(|(.., space)| is_ranged_over(module, *space))
                .collect(),
            methods,
        }
    }

    /// Name of its scalar type in NumPy.
    pub fn dtype(&self) -> &'static str {
        dtype(self.module.scalar)
    }

    /// Lower and upper limit of each entry of a space, infinite where the description has none.
    pub fn limits(&self, space: Space) -> Vec<[f64; 2]> {
        let entries = self.module.spaces.entries(space).iter();
        let unknown = [f64::NEG_INFINITY, f64::INFINITY];
        entries
            .map(|entry| entry.range.unwrap_or(unknown))
            .collect()
    }
}

impl Method {
    /// Method of a requested function.
    fn of(
        module: &Module,
        generated: &GeneratedFunction,
        name: &Ident,
        tuple: &mut dyn FnMut(&str) -> String,
    ) -> Self {
        let spaces = &module.spaces;
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
                Outcome::Parts(_, parts) => parts
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
            about: documentation::of_function(module, generated, None, None),
            arguments: arguments
                .map(|argument| (argument.name(), last_of_argument(argument, spaces)))
                .collect(),
            tuple: (results.len() > 1).then(|| tuple(&name.to_string())),
            results,
        };
        // After the sentence about the results, and an empty line.
        method.insert_shapes(match generated.functions.len() {
            1 => 2,
            several => several + 3,
        });
        method
    }

    /// Method of a function of configurations.
    fn of_step(step: ConfigurationFunction, spaces: &Spaces) -> Self {
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

    /// Inserts the shapes at a line of the documentation.
    fn insert_shapes(&mut self, at: usize) {
        let at = at.min(self.about.len());
        let shapes = self.shapes().into_iter().chain([String::new()]);
        let _ = self.about.splice(at..at, shapes);
    }

    /// Shapes of its arguments and results.
    fn shapes(&self) -> Vec<String> {
        let arguments = self.arguments.iter();
        let arguments = arguments
            .map(|(argument, last)| format!("{argument} {}", shape(last)))
            .collect::<Vec<_>>();
        let mut lines = vec![format!("Shapes: {}.", arguments.join(", "))];
        match (&self.tuple, &*self.results) {
            (Some(tuple), results) => {
                lines.push(format!("Returns {tuple}:"));
                lines.extend(
                    results
                        .iter()
                        .map(|result| format!("- {}", result.documented())),
                );
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
    /// Name, shape and documentation.
    pub fn documented(&self) -> String {
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

    /// True for one number a state.
    pub fn is_number(&self) -> bool {
        self.last.is_empty()
    }

    /// Shape and contents of the rows.
    fn shaped(&self) -> String {
        let shape = shape(&self.last);
        self.rows
            .map_or_else(|| shape.clone(), |rows| format!("{shape}: {rows}"))
    }
}

/// Contents of the rows of a quantity.
fn rows(quantity: &Quantity) -> Option<&'static str> {
    let of_each = !quantity.over.is_empty();
    Some(match (quantity.entity, of_each) {
        (Entity::Number, _) => return None,
        (Entity::Pose, false) => "the 4×4 matrix",
        (Entity::Pose, true) => "the 4×4 matrix of each frame",
        (Entity::Acceleration, _) => "the 4×4 matrix (G, a)",
        (Entity::Velocity, _) => "ω, then v",
        (Entity::Point | Entity::Vector, false) => "x, y, z",
        (Entity::Point | Entity::Vector, true) => "a row for each degree of freedom: x, y, z",
        (Entity::Momentum, false) => "γ, then ρ: angular first",
        (Entity::Momentum, true) => "a row for each degree of freedom: γ, then ρ, angular first",
        (Entity::Action, _) => "c, then f: couple first",
        (Entity::Screw, _) => "a row for each degree of freedom: the screw u, b, angular first",
    })
}

/// Attributes with names of entries; some robots have only the first two.
const NAMES: [(&str, &str, Space); 5] = [
    (
        "coordinate_names",
        "Names of the entries of q.",
        Space::Coordinates,
    ),
    (
        "velocity_names",
        "Names of the entries of qd, qdd and tau.",
        Space::Velocities,
    ),
    (
        "constraint_names",
        "Names of the residuals of loops.",
        Space::Constraints,
    ),
    (
        "parameter_names",
        "Names of the inertial parameters.",
        Space::Parameters,
    ),
    (
        "base_parameter_names",
        "The leading inertial parameter of each base parameter.",
        Space::BaseParameters,
    ),
];

/// Other names of a class.
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

/// True if arguments or results range over a space.
fn is_ranged_over(module: &Module, space: Space) -> bool {
    let mut functions = module
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
        entity if entity.fourth_row().is_some() => last.extend([4, 4]),
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

/// Shape for any number of states with these last axes.
fn shape(last: &[usize]) -> String {
    let last: Vec<String> = last.iter().map(|length| format!(", {length}")).collect();
    format!("(...{})", last.concat())
}

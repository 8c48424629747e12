//! What stands above generated code, in whatever language.
//!
//! In: [`About`] a robot, the price of a function and its error. Out: lines that tell what is computed,
//! in which frame and unit, from which source, what is modelled, what it costs and how exact it is;
//! and the same for the head of a file. It never says anything that the module does not hold.

mod error;

use std::fmt::Write;

use super::steps::Step;
use crate::function::Function;
use crate::module::{About, GeneratedFunction, LeftOut, Module};
use crate::real::Real;
use crate::request::Target;
use crate::schedule::{Price, sections};
use crate::space::{Entry, Kind, Outcome, Space, Spaces, Variable};
use crate::wording::{code, list};

/// For which angles a function without the runtime is precise.
pub(super) enum Angles {
    /// Up to this one.
    UpTo(&'static str),
    /// Those for which the function at this path is.
    As(String),
}

impl Angles {
    /// Those for which the sines are precise that code brings along.
    pub fn own(real: Real) -> Self {
        Self::UpTo(match real {
            Real::F32 => "3200 rad",
            Real::F64 | Real::Generic => "2e5 rad",
        })
    }
}

/// What is said of a function; `angles` where its results are plain arrays, and what has been done `once` of
/// a robot that is prepared.
pub(super) fn of_function(
    module: &Module,
    generated: &GeneratedFunction,
    angles: Option<&Angles>,
    once: Option<&Price>,
) -> Vec<String> {
    let about = &module.about;
    let base = frame_0(module);
    let frame = generated.frame.as_deref().unwrap_or(&about.tip);
    let mut lines = Vec::new();
    match &*generated.functions {
        [function] => lines.push(function.sentence(&base, &code(frame))),
        several => {
            lines.push("Several functions that share their work, in this order:".to_owned());
            lines.push(String::new());
            let sentences = several.iter().zip(1..);
            lines.extend(sentences.map(|(function, number)| {
                format!("{number}. {}", function.sentence(&base, &code(frame)))
            }));
        }
    }
    lines.push(String::new());
    let of = generated.arguments(&module.spaces);
    lines.push(arguments(&of));
    lines.extend(postures(&module.spaces, &of));
    lines.extend(residuals(&module.spaces, generated));
    lines.extend(left_open(&module.spaces, generated));
    if let Some(angles) = angles {
        let results = generated.functions.iter();
        let results = results.flat_map(|function| function.result().parts());
        let layouts = results.filter_map(|(_, result)| result.entity.layout());
        lines.extend(layouts.map(str::to_owned));
        lines.push(if generated.program.angles.is_empty() {
            format!("{HUGE}.")
        } else {
            range(angles)
        });
    }
    lines.push(origin(module));
    lines.extend(facts(about));
    let of_bodies = |function: &Function| function.is_of_bodies();
    if about.driven && generated.functions.iter().any(of_bodies) {
        lines.push("Momenta and the Coriolis matrix are of bodies alone: friction and armature are not in them.".to_owned());
    }
    if module.spaces.parameters.iter().any(is_of_a_drive)
        && generated.functions.contains(&Function::Regressor)
    {
        lines.push("Behind the parameters of all links π has armature, damping and friction of each velocity of a joint, zero or not.".to_owned());
    }
    lines.push(String::new());
    lines.push(format!("{}.", generated.price));
    lines.extend(apart(module, generated));
    lines.extend(once.map(|once| format!("Done before, once for all functions: {once}.")));
    for accuracy in &generated.accuracy {
        let said = error::lines(accuracy);
        // A list is a paragraph of its own.
        let list = said.len() > 1;
        lines.extend(list.then(String::new));
        lines.extend(said);
    }
    lines
}

/// What is said of a function of configurations; `angles` where its result is a plain array.
pub(super) fn of_step(module: &Module, step: Step, angles: Option<&Angles>) -> Vec<String> {
    let mut lines = step.about().map(str::to_owned).to_vec();
    if let Some(angles) = angles.filter(|_| step.turns(module)) {
        lines.extend([String::new(), range(angles)]);
    }
    lines
}

/// That a function is compiled in sections, where it is.
fn apart(module: &Module, generated: &GeneratedFunction) -> Option<String> {
    let sections = sections(&generated.program, module.length)?;
    Some(format!(
        "Compiled in {} sections of at most {} statements, called one after the other; what waits for a later one \
         stands in an array of {} numbers.",
        sections.sections.len(),
        module.length.of_section(),
        sections.work
    ))
}

/// What frame 0 is: that of the base, or one that a field places the base in.
fn frame_0(module: &Module) -> String {
    let mut fields = module.parameters.iter();
    match fields.find(|field| field.target.places_base()) {
        Some(field) => format!(
            "the world that `{}` places {} in",
            field.field,
            code(&module.about.base)
        ),
        None => code(&module.about.base),
    }
}

/// What is said of the method that computes once what depends on fields alone.
pub(super) fn of_prepare(price: &Price) -> Vec<String> {
    vec![
        "The same robot with all that depends on its fields alone computed, for loops in which they stay \
         as they are."
            .to_owned(),
        String::new(),
        "Results are the same, bit for bit; what is left of each function, its doc comment tells."
            .to_owned(),
        String::new(),
        format!("{price}."),
    ]
}

/// What is said of the struct that it returns.
pub(super) fn of_prepared(robot: &str) -> Vec<String> {
    vec![format!(
        "What [`{robot}::prepare`] makes of the fields of a [`{robot}`]: the same functions, for less."
    )]
}

/// What a function computes, in a line.
#[cfg(feature = "files")]
pub(super) fn title(module: &Module, generated: &GeneratedFunction) -> String {
    let about = &module.about;
    let base = frame_0(module);
    let frame = code(generated.frame.as_deref().unwrap_or(&about.tip));
    match &*generated.functions {
        [function] => function.sentence(&base, &frame),
        _ => "Several functions that share their work, in this order:".to_owned(),
    }
}

/// What is said of the robot as data.
pub(super) fn of_chain(module: &Module) -> Vec<String> {
    let title = "The same robot as data, for the generic recursions at run time.".to_owned();
    let mut lines = vec![title, String::new()];
    lines.extend(of_robot(module, ""));
    lines
}

/// What is said of the robot with its loops as data.
pub(super) fn of_mechanism(module: &Module) -> Vec<String> {
    let names: Vec<String> = module.spaces.names(Space::Constraints).map(code).collect();
    vec![
        "The same robot as data, with what closes its loops.".to_owned(),
        String::new(),
        format!("Residuals: {}.", names.join(", ")),
    ]
}

const fn is_of_a_drive(entry: &Entry) -> bool {
    matches!(entry.kind, Kind::Drive { .. })
}

/// What is said of the values of base parameters.
pub(super) fn of_base_parameters(module: &Module) -> Vec<String> {
    let names: Vec<String> = (module.spaces.names(Space::BaseParameters))
        .map(code)
        .collect();
    let driven = module.spaces.base_parameters.iter().any(is_of_a_drive);
    let units = if driven {
        "kg, kg m, kg m², of drives N m s and N m, of those that slide N s/m and N"
    } else {
        "kg, kg m, kg m²"
    };
    let mut lines = vec![
        format!("The base parameters π of τ = Y π with the base regressor Y; {units}."),
        String::new(),
        format!("Each by the one that leads it: {}.", names.join(", ")),
        "What is grouped with each, `homogen base-parameters` tells.".to_owned(),
    ];
    if !module.parameters.is_empty() {
        lines.push("Fields are what is described in their place.".to_owned());
    }
    lines
}

/// What is said of a robot, and of what was asked for where that is told.
pub(super) fn of_robot(module: &Module, asked: &str) -> Vec<String> {
    let mut lines = vec![origin(module)];
    lines.extend((!asked.is_empty()).then(|| asked.to_owned()));
    lines.extend(facts(&module.about));
    lines.extend(left_out(&module.about));
    lines
}

/// What is said of a field.
pub(super) fn of_field(target: &Target) -> String {
    match target {
        Target::MassOf(link) => format!("Mass of {} in kg.", code(&link.text)),
        Target::CenterOfMassOf(link) => {
            format!(
                "Centre of mass of {0} in the frame of {0}, in m.",
                code(&link.text)
            )
        }
        Target::InertiaOf(link) => format!(
            "I_xx, I_xy, I_xz, I_yy, I_yz, I_zz of {} about its centre of mass, in the axes of its inertial, in \
             kg m².",
            code(&link.text)
        ),
        Target::PayloadOn(link) => format!(
            "What {} carries: its mass in kg, its centre of mass in that link's frame, in m, and I_xx, I_xy, \
             I_xz, I_yy, I_yz, I_zz about it in the axes of that frame, in kg m².",
            code(&link.text)
        ),
        Target::ArmatureOf(joint) => format!(
            "Inertia that {} feels beside that of the bodies, in kg m² or kg.",
            code(&joint.text)
        ),
        Target::DampingOf(joint) => format!(
            "Viscous friction of {}, in N m s/rad or N s/m.",
            code(&joint.text)
        ),
        Target::FrictionOf(joint) => {
            format!("Coulomb friction of {}, in N m or N.", code(&joint.text))
        }
        Target::Gravity => "Acceleration of gravity in the base frame, in m/s².".to_owned(),
        Target::BasePosition => {
            "Where the origin of the base is in frame 0, whose axes are those of the base, in m."
                .to_owned()
        }
        Target::BasePlacement => {
            "The frame of the base in frame 0: x, y, z in m, then roll, pitch, yaw in rad; gravity is seen in frame 0."
                .to_owned()
        }
        Target::PlacementOf(joint) => format!(
            "The frame of {} in its parent's: x, y, z in m, then roll, pitch, yaw in rad about the parent's x, y \
             and z, in this order.",
            code(&joint.text)
        ),
        Target::OriginOf(joint) => format!(
            "Translation from the parent's frame to that of {}, in m.",
            code(&joint.text)
        ),
    }
}

/// What is said at the head of a file, for which this was asked.
pub(super) fn head(module: &Module, asked: &str) -> Vec<String> {
    let version = env!("CARGO_PKG_VERSION");
    let mut lines = vec![format!(
        "@generated by homogen-codegen {version}; do not edit."
    )];
    lines.extend(of_robot(module, asked));
    lines
}

/// What is said of the price and the error of a function at the head of a file.
pub(super) fn price(generated: &GeneratedFunction, name: &str) -> Vec<String> {
    let mut lines = vec![format!("{name}: {}.", generated.price)];
    let said = generated.accuracy.iter().flat_map(error::lines);
    lines.extend(said.map(|line| match line.strip_prefix("Error") {
        Some(rest) => format!("    error{rest}"),
        None => format!("    {line}"),
    }));
    lines
}

/// Results of arguments that are no numbers or have no digits left.
const HUGE: &str = "NaN, infinite and huge arguments give what IEEE arithmetic makes of them";

/// For which angles a result is precise, and what it is for others.
fn range(angles: &Angles) -> String {
    match angles {
        Angles::UpTo(range) => format!("Precise for angles up to {range}; {HUGE}."),
        Angles::As(path) => {
            let path = code(path);
            format!("Precise for angles that {path} is precise for; {HUGE}.")
        }
    }
}

/// Arguments with their units.
fn arguments(arguments: &[Variable]) -> String {
    let units = |argument: &Variable| {
        let [turning, sliding] = [Kind::Turn, Kind::Slide].map(|kind| argument.unit(kind));
        match argument {
            Variable::Actions => format!("{} (c, f) in {turning}, {sliding}", argument.letter()),
            _ => format!("{} in {turning} or {sliding}", argument.letter()),
        }
    };
    let all = arguments.iter().map(units);
    format!("{}.", all.collect::<Vec<_>>().join(", "))
}

/// What quaternions must be, and in whose axes those velocities are that are no rates of coordinates.
fn postures(spaces: &Spaces, arguments: &[Variable]) -> Vec<String> {
    let mut lines = Vec::new();
    let reads = |space: Space| arguments.iter().any(|argument| argument.space() == space);
    if reads(Space::Coordinates) && spaces.quaternions().next().is_some() {
        lines.push(
            "Quaternions (x, y, z, w) have length 1; one of length 1 + ε stands for a matrix that is off \
             by 4 ε from a rotation."
                .to_owned(),
        );
    }
    let seen: Vec<String> = (spaces.names(Space::Velocities))
        .filter(|name| spaces.names(Space::Coordinates).all(|other| other != *name))
        .map(code)
        .collect();
    if reads(Space::Velocities) && !seen.is_empty() {
        let seen = seen.join(", ");
        lines.push(format!("In the axes of the body that they move: {seen}."));
    }
    lines
}

/// The residuals of loops in their order, where a result is over them.
fn residuals(spaces: &Spaces, generated: &GeneratedFunction) -> Option<String> {
    let results = generated.functions.iter().map(|function| function.result());
    let mut parts = results.flat_map(Outcome::parts);
    let over = parts.any(|(_, part)| part.over.contains(&Space::Constraints));
    let names: Vec<String> = spaces.names(Space::Constraints).map(code).collect();
    over.then(|| format!("Residuals: {}.", names.join(", ")))
}

/// Which functions know nothing of the loops of a robot that has some.
fn left_open(spaces: &Spaces, generated: &GeneratedFunction) -> Option<String> {
    let open = generated.functions.iter();
    let open: Vec<_> = open.filter(|function| !function.is_of_loops()).collect();
    if spaces.len(Space::Constraints) == 0 || open.is_empty() {
        return None;
    }
    let by = if generated.functions.len() > 1 {
        let names: Vec<String> = open.iter().map(|function| code(function.name())).collect();
        format!(" by {}", list(names.iter().map(String::as_str)))
    } else {
        String::new()
    };
    let instead = if open.iter().any(|function| function.solves()) {
        let held = code(Function::ConstrainedForwardDynamics.name());
        format!("; {held} holds them together")
    } else {
        String::new()
    };
    Some(format!(
        "Loops are left open{by}: what counts is the tree of joints that hangs on the base{instead}."
    ))
}

/// Robot, file and coordinates.
fn origin(module: &Module) -> String {
    let about = &module.about;
    let mut line = format!("Robot {}", code(&about.robot));
    if let Some(file) = &about.source.file {
        let hash = about.source.hash;
        // Writing to a string cannot fail.
        let _ = write!(line, " from {} (FNV-1a {hash:016x})", code(file));
    }
    let entries = module.spaces.coordinates.iter();
    let names: Vec<_> = entries.map(|entry| code(&entry.name)).collect();
    match &*names {
        [] => line.push_str(", without joints."),
        names => {
            let _ = write!(line, "; q: {}.", names.join(", "));
        }
    }
    line
}

/// What is modelled, how it is computed where that was asked for, and what is doubted, a line each.
fn facts(about: &About) -> Vec<String> {
    let warnings = about.located_warnings();
    let lines = [
        ("Modelled", &about.facts, "; "),
        ("Formulation", &about.formulation, ", "),
        ("Doubts", &warnings, "; "),
    ];
    let lines = lines.into_iter().filter(|(_, items, _)| !items.is_empty());
    lines
        .map(|(title, items, between)| format!("{title}: {}.", items.join(between)))
        .collect()
}

/// What the robot has not, where everything that it can have was asked for, and why, a line each.
fn left_out(about: &About) -> impl Iterator<Item = String> {
    let missing = about.left_out.iter();
    missing.map(
        |LeftOut {
             functions, reason, ..
         }| {
            let functions: Vec<String> = functions.iter().map(|name| code(name)).collect();
            let functions = list(functions.iter().map(String::as_str));
            format!("Left out: {functions} ({reason}).")
        },
    )
}

#[cfg(test)]
mod tests {
    use super::arguments;
    use crate::space::Variable;

    #[test]
    fn arguments_are_told_with_their_units() {
        assert_eq!(
            arguments(&Variable::ALL),
            "q in rad or m, q̇ in rad/s or m/s, q̈ in rad/s² or m/s², τ in N m or N, Φ (c, f) in N m, N."
        );
        assert_eq!(arguments(&[Variable::Q]), "q in rad or m.");
    }
}

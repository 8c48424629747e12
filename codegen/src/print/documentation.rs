//! Text of the comments above generated code, the same in every language.
//!
//! In: a [`Module`]. Out: lines for a function (result, frame, units, source, model, cost, error bounds), for a robot,
//! its fields and its data, and for the head of a file.

mod error;

use std::fmt::Write;

use super::steps::ConfigurationFunction;
use crate::function::Function;
use crate::module::{self, About, GeneratedFunction, LeftOut, Module};
use crate::real::Real;
use crate::request::Target;
use crate::schedule::{Arranged, OperationCount};
use crate::space::{Entry, Kind, Order, Outcome, Space, Spaces, Variable};
use crate::wording::{code, list};

/// Angles for which the sines of a function without the runtime are accurate.
pub(super) enum SineAngles {
    /// Up to this magnitude.
    UpTo(&'static str),
    /// As far as those of the function at this path.
    As(String),
}

impl SineAngles {
    /// Range of the sines that generated code carries itself.
    pub fn own(real: Real) -> Self {
        Self::UpTo(match real {
            Real::F32 => "3200 rad",
            Real::F64 | Real::Generic => "2e5 rad",
        })
    }
}

/// Comment of a function. `plain`: angles and the order of six numbers, given if the results are plain arrays. `once`: operations done by `prepare`, for
/// functions of a prepared robot.
pub(super) fn of_function(
    module: &Module,
    generated: &GeneratedFunction,
    plain: Option<(&SineAngles, Order)>,
    once: Option<&OperationCount>,
) -> Vec<String> {
    let about = &module.about;
    let frame = generated.frame.as_deref().unwrap_or(&about.tip);
    let mut lines = sentences(module, &generated.functions, frame);
    lines.push(String::new());
    let order = plain.map_or(Order::AngularFirst, |(_, order)| order);
    lines.push(arguments(&generated.arguments(&module.spaces), order));
    lines.extend(remarks(&module.spaces, &generated.functions));
    if let Some((angles, _)) = plain {
        let results = generated.functions.iter();
        let results = results.flat_map(|function| function.result().parts());
        let layouts = results.filter_map(|(_, result)| result.entity.layout(order));
        lines.extend(layouts);
        lines.push(if generated.program.angles.is_empty() {
            format!("{HUGE}.")
        } else {
            range(angles)
        });
    }
    lines.push(origin(module));
    lines.extend(facts(about));
    let of_bodies = |function: &Function| function.is_of_bodies();
    if about.actuated && generated.functions.iter().any(of_bodies) {
        lines.push(
            "Momenta and the Coriolis matrix do not include friction and armature.".to_owned(),
        );
    }
    if module.spaces.parameters.iter().any(is_of_actuator)
        && generated.functions.contains(&Function::Regressor)
    {
        lines.push("After the parameters of all links, π has armature, damping and friction of each degree of freedom of a joint, zero or not.".to_owned());
    }
    lines.push(String::new());
    lines.push(format!("{}.", generated.operation_count));
    lines.extend(split(module, generated));
    lines
        .extend(once.map(|once| format!("Computed once by `prepare`, for all functions: {once}.")));
    lines.extend(generated.found.iter().map(error::found));
    for accuracy in &generated.accuracy {
        let bounds = error::lines(accuracy);
        // A list is a paragraph of its own.
        let list = bounds.len() > 1;
        lines.extend(list.then(String::new));
        lines.extend(bounds);
    }
    lines
}

/// Meaning of functions of a frame, a sentence each.
pub(super) fn sentences(module: &Module, functions: &[Function], frame: &str) -> Vec<String> {
    let base = frame_0(module);
    let mut lines = Vec::new();
    match functions {
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
    lines
}

/// Lines about quaternions, velocities of bodies, frames and loops in functions.
pub(super) fn remarks(spaces: &Spaces, functions: &[Function]) -> Vec<String> {
    let of = module::arguments(functions, spaces.actions() > 0);
    let mut lines = quaternions(spaces, &of);
    lines.extend(entries(spaces, functions, Space::Frames, "Frames"));
    lines.extend(entries(spaces, functions, Space::Spheres, "Spheres"));
    lines.extend(entries(spaces, functions, Space::Pairs, "Pairs"));
    lines.extend(entries(spaces, functions, Space::Constraints, "Residuals"));
    lines.extend(open_loops(spaces, functions));
    lines
}

/// Comment of a function of configurations; `angles`: given if its result is a plain array.
pub(super) fn of_step(
    module: &Module,
    step: ConfigurationFunction,
    angles: Option<&SineAngles>,
) -> Vec<String> {
    let mut lines = step.about().map(str::to_owned).to_vec();
    if let Some(angles) = angles.filter(|_| step.turns(module)) {
        lines.extend([String::new(), range(angles)]);
    }
    lines
}

/// Line about the sections of a long function.
fn split(module: &Module, generated: &GeneratedFunction) -> Option<String> {
    if module.length.holds(&generated.program) {
        return None;
    }
    let arranged = Arranged::of(&generated.program, &module.spaces.limbs, module.length);
    let sections = arranged.sections?;
    Some(format!(
        "Compiled in {} sections of at most {} statements, called in order; values for later sections are in an array \
         of {} numbers.",
        sections.sections.len(),
        module.length.of_section(),
        sections.work
    ))
}

/// Name of frame 0: the base, or the world if a field places the base in it.
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

/// Comment of the method that computes everything that depends on fields alone.
pub(super) fn of_prepare(operation_count: &OperationCount) -> Vec<String> {
    vec![
        "The same robot with everything precomputed that depends only on its fields, for loops in which they do not \
         change."
            .to_owned(),
        String::new(),
        "Results are the same, bit for bit. The doc comment of each function has its remaining cost."
            .to_owned(),
        String::new(),
        format!("{operation_count}."),
    ]
}

/// Comment of the struct that `prepare` returns.
pub(super) fn of_prepared(robot: &str) -> Vec<String> {
    vec![format!(
        "A [`{robot}`] after [`{robot}::prepare`]: the same functions with fewer operations."
    )]
}

/// First line of a function's comment.
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

/// Comment of the robot as data.
pub(super) fn of_chain(module: &Module) -> Vec<String> {
    let title = "The same robot as data, for the generic recursions at run time.".to_owned();
    let mut lines = vec![title, String::new()];
    lines.extend(of_robot(module, ""));
    lines
}

/// Comment of the robot with its loops as data.
pub(super) fn of_mechanism(module: &Module) -> Vec<String> {
    let names: Vec<String> = module.spaces.names(Space::Constraints).map(code).collect();
    vec![
        "The same robot as data, with its closed loops.".to_owned(),
        String::new(),
        format!("Residuals: {}.", names.join(", ")),
    ]
}

const fn is_of_actuator(entry: &Entry) -> bool {
    matches!(entry.kind, Kind::Actuator { .. })
}

/// Comment of the values of base parameters.
pub(super) fn of_base_parameters(module: &Module) -> Vec<String> {
    let names: Vec<String> = (module.spaces.names(Space::BaseParameters))
        .map(code)
        .collect();
    let actuators = module.spaces.base_parameters.iter().any(is_of_actuator);
    let units = if actuators {
        "kg, kg m, kg m²; damping in N m s/rad or N s/m, friction in N m or N"
    } else {
        "kg, kg m, kg m²"
    };
    let mut lines = vec![
        format!("The base parameters π of τ = Y π with the base regressor Y; {units}."),
        String::new(),
        format!(
            "The leading inertial parameter of each: {}.",
            names.join(", ")
        ),
        "`homogen base-parameters` prints the linear combinations.".to_owned(),
    ];
    if !module.parameters.is_empty() {
        lines.push("Fields enter with their described values.".to_owned());
    }
    lines
}

/// Lines about a robot, and the request if `asked` is not empty.
pub(super) fn of_robot(module: &Module, asked: &str) -> Vec<String> {
    let mut lines = vec![origin(module)];
    lines.extend((!asked.is_empty()).then(|| asked.to_owned()));
    lines.extend(facts(&module.about));
    lines.extend(left_out(&module.about));
    lines
}

/// Comment of a run-time field.
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
            "Payload on {}: its mass in kg, its centre of mass in that link's frame, in m, and I_xx, I_xy, \
             I_xz, I_yy, I_yz, I_zz about it in the axes of that frame, in kg m².",
            code(&link.text)
        ),
        Target::ArmatureOf(joint) => format!(
            "Armature of {}, the inertia of its motor reflected to the joint, in kg m² or kg.",
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
            "Position of the base's origin in frame 0, in m; the axes of both frames are parallel."
                .to_owned()
        }
        Target::BasePlacement => {
            "Pose of the base in frame 0: x, y, z in m, then roll, pitch, yaw in rad; gravity is in frame 0."
                .to_owned()
        }
        Target::PlacementOf(joint) => format!(
            "Pose of the frame of {} in its parent's: x, y, z in m, then roll, pitch, yaw in rad about the parent's x, y \
             and z, in this order.",
            code(&joint.text)
        ),
        Target::OriginOf(joint) => format!(
            "Translation from the parent's frame to that of {}, in m.",
            code(&joint.text)
        ),
    }
}

/// Head of a file: version, robot and the request `asked`.
pub(super) fn head(module: &Module, asked: &str) -> Vec<String> {
    let version = env!("CARGO_PKG_VERSION");
    let mut lines = vec![format!(
        "@generated by homogen-codegen {version}; do not edit."
    )];
    lines.extend(of_robot(module, asked));
    lines
}

/// Cost and error bounds of a function, for the head of a file.
pub(super) fn operation_count(generated: &GeneratedFunction, name: &str) -> Vec<String> {
    let mut lines = vec![format!("{name}: {}.", generated.operation_count)];
    let found = generated.found.iter().map(error::found);
    let bounds = generated.accuracy.iter().flat_map(error::lines);
    lines.extend(
        found
            .chain(bounds)
            .map(|line| match line.strip_prefix("Error") {
                Some(rest) => format!("    error{rest}"),
                None => format!("    {line}"),
            }),
    );
    lines
}

/// Results outside of the accurate range.
const HUGE: &str = "NaN, infinite and huge arguments follow IEEE 754 arithmetic";

/// Line about the angles for which results are accurate.
fn range(angles: &SineAngles) -> String {
    match angles {
        SineAngles::UpTo(range) => format!("Accurate for angles up to {range}; {HUGE}."),
        SineAngles::As(path) => {
            let path = code(path);
            format!("Accurate for angles for which {path} is accurate; {HUGE}.")
        }
    }
}

/// Arguments with their units; those of weights are in the function's sentence.
fn arguments(arguments: &[Variable], order: Order) -> String {
    let units = |argument: &Variable| {
        let [rotation, translation] =
            [Kind::Rotation, Kind::Translation].map(|kind| argument.unit(kind));
        match argument {
            Variable::Wrench | Variable::Actions => {
                let [first, second] = order.halves(["c", "f"]);
                let [of_first, of_second] = order.halves([rotation, translation]);
                let letter = argument.letter();
                format!("{letter} ({first}, {second}) in {of_first}, {of_second}")
            }
            _ => format!("{} in {rotation} or {translation}", argument.letter()),
        }
    };
    let all = arguments.iter();
    let all = all
        .filter(|&&argument| argument != Variable::Weights)
        .map(units);
    format!("{}.", all.collect::<Vec<_>>().join(", "))
}

/// Lines about quaternions and about velocities in body axes.
fn quaternions(spaces: &Spaces, arguments: &[Variable]) -> Vec<String> {
    let mut lines = Vec::new();
    let reads = |space: Space| arguments.iter().any(|argument| argument.space() == space);
    if reads(Space::Coordinates) && spaces.quaternions().next().is_some() {
        lines.push(
            "Quaternions (x, y, z, w) must have length 1; at length 1 + ε the rotation matrix is off by 4 ε."
                .to_owned(),
        );
    }
    let body: Vec<String> = (spaces.names(Space::Velocities))
        .filter(|name| spaces.names(Space::Coordinates).all(|other| other != *name))
        .map(code)
        .collect();
    if reads(Space::Velocities) && !body.is_empty() {
        let body = body.join(", ");
        lines.push(format!("Velocities in the axes of the moved body: {body}."));
    }
    lines
}

/// The entries of a space in their order, if a result ranges over them.
fn entries(spaces: &Spaces, functions: &[Function], space: Space, called: &str) -> Option<String> {
    let results = functions.iter().map(|function| function.result());
    let mut parts = results.flat_map(Outcome::parts);
    let over = parts.any(|(_, part)| part.over.contains(&space));
    let names: Vec<String> = spaces.names(space).map(code).collect();
    over.then(|| match &names[..] {
        [first, .., last] if names.len() > MOST_NAMES => {
            format!("{called}: {}, {first} to {last}.", names.len())
        }
        _ => format!("{called}: {}.", names.join(", ")),
    })
}

/// Maximum number of names in a line; of more there are the first and the last.
const MOST_NAMES: usize = 64;

/// Line about functions that ignore the loops of the robot.
fn open_loops(spaces: &Spaces, functions: &[Function]) -> Option<String> {
    let open = functions.iter();
    let open: Vec<_> = open.filter(|function| !function.is_of_loops()).collect();
    if spaces.len(Space::Constraints) == 0 || open.is_empty() {
        return None;
    }
    let by = if functions.len() > 1 {
        let names: Vec<String> = open.iter().map(|function| code(function.name())).collect();
        format!(" by {}", list(names.iter().map(String::as_str)))
    } else {
        String::new()
    };
    let instead = if open.iter().any(|function| function.solves()) {
        let held = code(Function::ConstrainedForwardDynamics.name());
        format!("; {held} keeps them closed")
    } else {
        String::new()
    };
    Some(format!(
        "Loops are ignored{by}: the robot is computed as the tree of its joints{instead}."
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

/// Lines about the model, the formulation if it was chosen by the user, and warnings.
fn facts(about: &About) -> Vec<String> {
    let warnings = about.located_warnings();
    let lines = [
        ("Modelled", &about.facts, "; "),
        ("Formulation", &about.formulation, ", "),
        ("Warnings", &warnings, "; "),
    ];
    let lines = lines.into_iter().filter(|(_, items, _)| !items.is_empty());
    lines
        .map(|(title, items, between)| format!("{title}: {}.", items.join(between)))
        .collect()
}

/// Lines about the functions that the robot can't have, with reasons, if all functions were requested.
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
    use crate::space::{Order, Variable};

    #[test]
    fn arguments_have_their_units() {
        assert_eq!(
            arguments(&Variable::ALL, Order::AngularFirst),
            "q in rad or m, q̇ in rad/s or m/s, q̈ in rad/s² or m/s², τ in N m or N, δq in rad or m, \
             δq̇ in rad/s or m/s, δq̈ in rad/s² or m/s², δτ in N m or N, Φ (c, f) in N m, N, Φ (c, f) in N m, N."
        );
        assert_eq!(
            arguments(&[Variable::Q], Order::AngularFirst),
            "q in rad or m."
        );
        assert_eq!(
            arguments(&[Variable::Actions], Order::LinearFirst),
            "Φ (f, c) in N, N m."
        );
    }
}

//! A random robot as the text of a reader, and as the reader's result.
//!
//! In: a [`Robot`]. Out: URDF, or the tokens of `chain!`; the description and the request for the generator; a report
//! of the robot for a person. It never computes with a number.

use std::fmt::{self, Write};
use std::path::Path;

use homogen_codegen::description::{self, Description, Number, Step, inline};
use homogen_codegen::error::Errors;
use homogen_codegen::joint::actuator::ActuatorQuantity;
use homogen_codegen::request::{Parameter, Request, Target};
use quote::format_ident;

use super::robot::{Body, Field, FrontEnd, Inertial, Kind, Options, Placement, Robot};
use super::written::Written;

/// The description and the request, read from the robot's text.
///
/// # Errors
/// Errors of the reader.
///
/// # Panics
/// If the text cannot be split into tokens.
pub fn read(robot: &Robot) -> Result<(Description, Request), Errors> {
    let mut errors = Errors::new();
    let found = match robot.front_end {
        FrontEnd::Urdf => description::read_text(&urdf(robot), "tree.urdf", None, &mut errors)
            .map(|description| (description, request(&robot.options))),
        FrontEnd::Computed => description::read_text(&urdf(robot), "tree.urdf", None, &mut errors)
            .map(|description| (computed(description), request(&robot.options))),
        FrontEnd::Inline => {
            let tokens = chain(robot).parse().expect("the text is tokens");
            let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
            item.and_then(|item| {
                let request = Request {
                    exact: robot.options.exact,
                    parameters: parameters(&robot.options),
                    ..item.request
                };
                item.description.map(|description| (description, request))
            })
        }
    };
    match found {
        Some((description, request)) => {
            errors.into_result((description, with_loads(robot, request)))
        }
        None => Err(errors),
    }
}

/// The description with numbers as a program computes them, without digits.
fn computed(mut description: Description) -> Description {
    let unwritten = |number: &mut Number| number.resolution = 0.0;
    let unplaced = |steps: &mut Vec<Step>| {
        for step in steps {
            match step {
                Step::Translate(offset) => offset.iter_mut().for_each(unwritten),
                Step::Rotate(_, angle) => unwritten(angle),
                Step::Quaternion(entries) => entries.iter_mut().for_each(unwritten),
            }
        }
    };
    for joint in &mut description.joints {
        unplaced(&mut joint.origin);
        joint.axis.iter_mut().for_each(unwritten);
        joint.second_axis.iter_mut().for_each(unwritten);
        if let Some(mimic) = &mut joint.mimic {
            unwritten(&mut mimic.multiplier);
            unwritten(&mut mimic.offset);
        }
    }
    for inertial in description
        .links
        .iter_mut()
        .filter_map(|link| link.inertial.as_mut())
    {
        unplaced(&mut inertial.origin);
        inertial.inertia.iter_mut().for_each(unwritten);
        unwritten(&mut inertial.mass);
    }
    description
}

fn request(options: &Options) -> Request {
    let link = |id: usize| format!("link{id}").as_str().into();
    let number = |word: &Written| Number {
        value: word.value(),
        ..Number::default()
    };
    let lock = options.lock.iter().map(|(joint, at)| {
        let name = format!("joint{joint}").as_str().into();
        (name, at.as_ref().map(number))
    });
    Request {
        base: (options.base > 0).then(|| link(options.base)),
        floating: options.floating,
        tip: options.tip.map(link),
        path_only: options.path_only,
        lock: lock.collect(),
        drop: options.drop.iter().map(|&id| link(id)).collect(),
        frames: options.frames.iter().map(|&id| link(id)).collect(),
        gravity: (options.gravity.as_ref()).map(|gravity| gravity.each_ref().map(number)),
        exact: options.exact,
        parameters: parameters(options),
        ..Request::default()
    }
}

/// The request with armature, damping and friction of joints and external wrenches on links.
fn with_loads(robot: &Robot, mut request: Request) -> Request {
    for (id, numbers) in robot.actuators() {
        let quantities = [
            ActuatorQuantity::Armature,
            ActuatorQuantity::Damping,
            ActuatorQuantity::Friction,
        ];
        request.actuators.extend(
            quantities
                .into_iter()
                .zip(numbers)
                .map(|(quantity, value)| {
                    let number = Number {
                        value,
                        ..Number::default()
                    };
                    (format!("joint{id}").as_str().into(), quantity, vec![number])
                }),
        );
    }
    let acted_on = robot.acted_on();
    request.external = acted_on
        .map(|id| format!("link{id}").as_str().into())
        .collect();
    request.external_in_frame_0 = robot.options.external.1 && !request.external.is_empty();
    request
}

fn parameters(options: &Options) -> Vec<Parameter> {
    let fields = options.fields.iter().enumerate();
    let parameter = |(index, (field, _)): (usize, &(Field, _))| Parameter {
        field: format_ident!("field_{index}"),
        target: match field {
            Field::Mass(id) => Target::MassOf(format!("link{id}").as_str().into()),
            Field::Center(id) => Target::CenterOfMassOf(format!("link{id}").as_str().into()),
            Field::Inertia(id) => Target::InertiaOf(format!("link{id}").as_str().into()),
            Field::Payload(id) => Target::PayloadOn(format!("link{id}").as_str().into()),
            Field::Placement(id) => Target::PlacementOf(format!("joint{id}").as_str().into()),
            Field::Origin(id) => Target::OriginOf(format!("joint{id}").as_str().into()),
            Field::Gravity => Target::Gravity,
        },
        range: None,
    };
    fields.map(parameter).collect()
}

/// The text in URDF, which has no rotations behind roll, pitch and yaw.
#[must_use]
pub fn urdf(robot: &Robot) -> String {
    let mut text = "<robot name=\"tree\">\n".to_owned();
    text.push_str(&urdf_link(0, robot.root.as_ref()));
    for body in &robot.bodies {
        text.push_str(&urdf_joint(body));
        text.push_str(&urdf_link(body.id, body.inertial.as_ref()));
    }
    text.push_str("</robot>\n");
    text
}

fn urdf_link(id: usize, inertial: Option<&Inertial>) -> String {
    let Some(inertial) = inertial else {
        return format!("  <link name=\"link{id}\"/>\n");
    };
    let names = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
    let tensor = names.iter().zip(&inertial.tensor);
    let tensor: Vec<String> = tensor
        .map(|(name, entry)| format!("{name}=\"{entry}\""))
        .collect();
    format!(
        "  <link name=\"link{id}\"><inertial>{}<mass value=\"{}\"/><inertia {}/></inertial></link>\n",
        urdf_origin(&inertial.at),
        inertial.mass,
        tensor.join(" "),
    )
}

fn urdf_joint(body: &Body) -> String {
    let kind = match &body.kind {
        Kind::Revolute => "revolute",
        Kind::Continuous => "continuous",
        Kind::Prismatic => "prismatic",
        Kind::Screw(_) => "screw",
        Kind::Cylindrical => "cylindrical",
        Kind::Universal(_) => "universal",
        Kind::Translation => "translation",
        Kind::Planar => "planar",
        Kind::Spherical => "spherical",
        Kind::Floating => "floating",
        Kind::Fixed => "fixed",
    };
    let axis = format!("<axis xyz=\"{}\"/>", words(&body.axis, " "));
    let motion = match &body.kind {
        Kind::Fixed | Kind::Translation | Kind::Spherical | Kind::Floating => String::new(),
        Kind::Screw(pitch) => format!("{axis}<thread pitch=\"{pitch}\"/>"),
        Kind::Revolute => format!("{axis}<limit lower=\"-4\" upper=\"4\" velocity=\"4\"/>"),
        Kind::Universal(second) => format!("{axis}<axis2 xyz=\"{}\"/>", words(second, " ")),
        Kind::Continuous | Kind::Prismatic | Kind::Cylindrical | Kind::Planar => axis,
    };
    let mimic = body.mimic.as_ref().map(|mimic| {
        format!(
            "<mimic joint=\"joint{}\" multiplier=\"{}\" offset=\"{}\"/>",
            mimic.mimicked, mimic.multiplier, mimic.offset
        )
    });
    format!(
        "  <joint name=\"joint{0}\" type=\"{kind}\"><parent link=\"link{1}\"/>\
         <child link=\"link{0}\"/>{2}{motion}{3}</joint>\n",
        body.id,
        body.parent,
        urdf_origin(&body.at),
        mimic.unwrap_or_default(),
    )
}

fn urdf_origin(at: &Placement) -> String {
    assert!(at.turns.is_empty(), "URDF has roll, pitch and yaw alone");
    let mut text = String::new();
    for (name, vector) in [("xyz", &at.xyz), ("rpy", &at.rpy)] {
        if !vector.iter().all(Written::is_zero) {
            let _ = write!(text, " {name}=\"{}\"", words(vector, " "));
        }
    }
    if text.is_empty() {
        return text;
    }
    format!("<origin{text}/>")
}

/// The text for `chain!` with all settings except fields and `exact`.
#[must_use]
pub fn chain(robot: &Robot) -> String {
    let mut text = format!("struct Tree {{ {} }}\n", settings(&robot.options));
    text.push_str(&chain_link(0, robot.root.as_ref()));
    for body in &robot.bodies {
        let axis = words(&body.axis, ", ");
        let motion = match &body.kind {
            Kind::Revolute => format!("revolute([{axis}])"),
            Kind::Continuous => format!("continuous([{axis}])"),
            Kind::Prismatic => format!("prismatic([{axis}])"),
            Kind::Screw(pitch) => format!("screw([{axis}], pitch: {pitch})"),
            Kind::Cylindrical => format!("cylindrical([{axis}])"),
            Kind::Universal(second) => {
                format!("universal([{axis}], [{}])", words(second, ", "))
            }
            Kind::Planar => format!("planar([{axis}])"),
            Kind::Translation => "translation".to_owned(),
            Kind::Spherical => "spherical".to_owned(),
            Kind::Floating => "floating".to_owned(),
            Kind::Fixed => "fixed".to_owned(),
        };
        let mut at = format!(
            "xyz({}) rpy({})",
            words(&body.at.xyz, ", "),
            words(&body.at.rpy, ", ")
        );
        for (axis, angle) in &body.at.turns {
            let _ = write!(at, " r{}({angle})", ["x", "y", "z"][*axis]);
        }
        if let Some(mimic) = &body.mimic {
            let _ = write!(
                at,
                ", mimic: joint{}, multiplier: {}, offset: {}",
                mimic.mimicked, mimic.multiplier, mimic.offset
            );
        }
        let _ = writeln!(
            text,
            "joint joint{0}: {motion} {{ from: link{1}, to: link{0}, at: {at} }}",
            body.id, body.parent
        );
        text.push_str(&chain_link(body.id, body.inertial.as_ref()));
    }
    text
}

fn chain_link(id: usize, inertial: Option<&Inertial>) -> String {
    let Some(inertial) = inertial else {
        return format!("link link{id};\n");
    };
    assert!(
        inertial.at.turns.is_empty(),
        "inertia_rpy is three angles alone"
    );
    format!(
        "link link{id} {{ mass: {}, com: [{}], inertia: [{}], inertia_rpy: [{}] }}\n",
        inertial.mass,
        words(&inertial.at.xyz, ", "),
        words(&inertial.tensor, ", "),
        words(&inertial.at.rpy, ", "),
    )
}

fn settings(options: &Options) -> String {
    let mut settings = Vec::new();
    let links = |ids: &[usize]| {
        let ids: Vec<String> = ids.iter().map(|id| format!("link{id}")).collect();
        ids.join(", ")
    };
    if options.base > 0 {
        settings.push(format!("base: link{}", options.base));
    }
    if options.floating {
        settings.push("floating".to_owned());
    }
    if let Some(tip) = options.tip {
        settings.push(format!("tip: link{tip}"));
    }
    if options.path_only {
        settings.push("path_only".to_owned());
    }
    let locks = options.lock.iter().map(|(joint, at)| match at {
        Some(at) => format!("joint{joint} = {at}"),
        None => format!("joint{joint}"),
    });
    let locks: Vec<String> = locks.collect();
    if !locks.is_empty() {
        settings.push(format!("lock({})", locks.join(", ")));
    }
    if !options.drop.is_empty() {
        settings.push(format!("drop({})", links(&options.drop)));
    }
    if !options.frames.is_empty() {
        settings.push(format!("frames({})", links(&options.frames)));
    }
    if let Some(gravity) = &options.gravity {
        settings.push(format!("gravity: [{}]", words(gravity, ", ")));
    }
    settings.join(", ")
}

fn words(numbers: &[Written], between: &str) -> String {
    let words: Vec<String> = numbers.iter().map(Written::to_string).collect();
    words.join(between)
}

/// The text of the robot, and its request in the words of attributes.
impl fmt::Display for Robot {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.front_end {
            FrontEnd::Urdf => write!(out, "{}", urdf(self))?,
            FrontEnd::Computed => writeln!(out, "{}(read, then without digits)", urdf(self))?,
            FrontEnd::Inline => write!(out, "{}", chain(self))?,
        }
        if self.front_end != FrontEnd::Inline {
            writeln!(out, "#[robot({})]", settings(&self.options))?;
        }
        if self.options.exact {
            writeln!(out, "exact")?;
        }
        for (field, value) in &self.options.fields {
            writeln!(out, "field {field:?} = {value:?}")?;
        }
        for (joint, [armature, damping, friction]) in self.actuators() {
            let numbers =
                format!("armature {armature:?}, damping {damping:?}, friction {friction:?}");
            writeln!(out, "joint{joint}: {numbers}")?;
        }
        let frame = if self.options.external.1 {
            "frame 0"
        } else {
            "its frame"
        };
        for link in self.acted_on() {
            writeln!(out, "external wrench on link{link} in {frame}")?;
        }
        Ok(())
    }
}

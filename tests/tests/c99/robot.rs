//! What is written in both languages.
//!
//! In: descriptions. Out: robots with what is asked of them. It never compiles anything.

use homogen_codegen::description::{Description, Name, read_file, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::formulation::Sines;
use homogen_codegen::print::c::Source;
use homogen_codegen::request::{Parameter, Request};
use homogen_codegen::space::{Spaces, Variable};
use homogen_codegen::{Builder, Function, Processor, Real, Target};
use quote::format_ident;

/// One function as it is asked for: several that share their work, the frame that it is of.
pub struct Asked {
    /// What it computes.
    pub functions: Vec<Function>,
    /// Its name in Rust, and in C behind the prefix.
    pub name: String,
    /// Whether it is that of the robot once prepared.
    pub prepared: bool,
}

/// A robot and what is asked of it.
pub struct Robot {
    /// The name of its files.
    pub name: String,
    /// What is called.
    pub asked: Vec<Asked>,
    /// What arguments and results are over.
    pub spaces: Spaces,
    /// The fields and how many numbers each has.
    pub fields: Vec<(String, usize)>,
    description: Description,
    request: Request,
}

/// The link whose frame poses are of, where a robot has more than one end.
fn tip(robot: &str) -> Option<Name> {
    (robot == "quadruped").then(|| named("hr_foot"))
}

fn named(text: &str) -> Name {
    Name {
        text: text.to_owned(),
        ..Name::default()
    }
}

impl Robot {
    fn new(name: &str, description: Description, request: Request) -> Self {
        let chain = understand(&description, &request);
        let chain = chain
            .unwrap_or_else(|errors| panic!("{errors}"))
            .identified();
        let mut asked = Vec::new();
        for functions in request.items(!chain.loops.is_empty()) {
            let names: Vec<_> = functions.iter().map(|function| function.name()).collect();
            let name = names.join("_and_");
            let of_a_frame = functions.iter().all(|function| function.of_a_frame());
            let frames = request.frames.iter().filter(|_| of_a_frame);
            let further = frames.map(|frame| format!("{name}_of_{}", frame.text));
            let names: Vec<_> = [name.clone()].into_iter().chain(further).collect();
            for prepared in [false, true]
                .into_iter()
                .take(1 + usize::from(request.prepare))
            {
                asked.extend(names.iter().map(|name| Asked {
                    functions: functions.clone(),
                    name: name.clone(),
                    prepared,
                }));
            }
        }
        let fields = request.parameters.iter();
        let fields = fields.map(|field| (field.field.to_string(), field.target.entries()));
        Self {
            name: name.to_owned(),
            asked,
            spaces: chain.spaces().clone(),
            fields: fields.collect(),
            description,
            request,
        }
    }

    /// One of those that ship, with all functions.
    pub fn that_ships(name: &str) -> Self {
        let functions = Function::ALL.into_iter().map(|function| vec![function]);
        let request = Request {
            tip: tip(name),
            functions: functions.collect(),
            ..Request::default()
        };
        Self::new(name, described(name), request)
    }

    /// Two links with numbers that are free at run time, one of them never read, and a further frame; and the
    /// same once prepared.
    pub fn with_fields() -> Self {
        let field = |name: &str, target| Parameter {
            field: format_ident!("{name}"),
            target,
            range: None,
        };
        let request = Request {
            tip: Some(named("tip")),
            frames: vec![named("fore")],
            parameters: vec![
                field("payload", Target::MassOf("tip".into())),
                field("center", Target::CenterOfMassOf("tip".into())),
                field("tensor", Target::InertiaOf("fore".into())),
                field("load", Target::PayloadOn("fore".into())),
                field("double", Target::Gravity),
                field("reach", Target::OriginOf("elbow".into())),
            ],
            functions: vec![
                vec![Function::ForwardKinematics],
                vec![Function::InverseDynamics],
                vec![Function::MassMatrix, Function::Bias],
                vec![Function::KineticEnergy, Function::PotentialEnergy],
                vec![Function::ForwardDynamics],
            ],
            prepare: true,
            ..Request::default()
        };
        Self::new("fields", described("two_link"), request)
    }

    /// The same with the sines of the library.
    pub fn with_platform_sines(mut self) -> Self {
        self.request.formulation.sines = Sines::Platform;
        self
    }

    /// One whose coordinates are not its velocities, with all functions.
    pub fn with_every_kind_of_joint() -> Self {
        let link = |name: &str| {
            format!(
                r#"<link name="{name}"><inertial><origin xyz="0.1 0.02 -0.03"/><mass value="2"/>
                <inertia ixx="0.05" ixy="0.001" ixz="0.002" iyy="0.06" iyz="0.003" izz="0.07"/>
                </inertial></link>"#
            )
        };
        let joint = |kind: &str, [parent, child]: [&str; 2], more: &str| {
            format!(
                r#"<joint name="to {child}" type="{kind}"><parent link="{parent}"/>
                <child link="{child}"/><origin xyz="0.2 0.1 0.3" rpy="0.3 -0.2 0.5"/>
                <axis xyz="0 0 1"/>{more}</joint>"#
            )
        };
        let follows = r#"<mimic joint="to fore" multiplier="-0.7" offset="0.1"/>"#;
        let text = [
            r#"<robot name="every joint"><link name="world"/>"#.to_owned(),
            ["trunk", "upper", "slab", "fore", "hand"]
                .map(link)
                .concat(),
            joint("floating", ["world", "trunk"], ""),
            joint("spherical", ["trunk", "upper"], ""),
            joint("planar", ["upper", "slab"], ""),
            joint("continuous", ["slab", "fore"], ""),
            joint("continuous", ["fore", "hand"], follows),
            "</robot>".to_owned(),
        ];
        let functions = Function::ALL.into_iter().map(|function| vec![function]);
        let request = Request {
            functions: functions.collect(),
            ..Request::default()
        };
        Self::new(
            "every_joint",
            read("every_joint.urdf", &text.concat()),
            request,
        )
    }

    /// A slider-crank that a rod holds as well, with all functions of loops and one of others.
    pub fn with_loops() -> Self {
        let link = |name: &str, at: f64| {
            format!(
                r#"<link name="{name}"><inertial><origin xyz="{at} 0.01 0"/><mass value="0.5"/>
                <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.004" iyz="0" izz="0.005"/></inertial></link>"#
            )
        };
        let joint = |kind: &str, [parent, child]: [&str; 2], x: f64, axis: &str| {
            format!(
                r#"<joint name="to {child}" type="{kind}"><parent link="{parent}"/>
                <child link="{child}"/><origin xyz="{x} 0 0"/><axis xyz="{axis}"/>
                <limit lower="-9" upper="9" velocity="9" effort="9"/></joint>"#
            )
        };
        let text = [
            r#"<robot name="slider crank"><link name="ground"/>"#.to_owned(),
            link("crank", 0.05),
            link("rod", 0.15),
            link("slider", 0.0),
            joint("continuous", ["ground", "crank"], 0.0, "0 0 1"),
            joint("continuous", ["crank", "rod"], 0.1, "0 0 1"),
            joint("prismatic", ["ground", "slider"], 0.0, "1 0 0"),
            r#"<loop_joint name="pin" type="revolute"><axis xyz="0 0 1"/>
                <link1 link="rod" xyz="0.3 0 0"/><link2 link="slider"/></loop_joint>
            <loop_joint name="stay" type="rod"><rod length="0.4"/>
                <link1 link="ground" xyz="0 0.2 0"/><link2 link="slider"/></loop_joint></robot>"#
                .to_owned(),
        ];
        let functions = Function::OF_LOOPS.into_iter();
        let functions = functions.chain([Function::ForwardDynamics]);
        let request = Request {
            actuated: vec![named("to crank")],
            functions: functions.map(|function| vec![function]).collect(),
            ..Request::default()
        };
        let description = read("slider_crank.urdf", &text.concat());
        Self::new("slider_crank", description, request)
    }

    /// A pendulum with a bob that can be changed.
    pub fn pendulum() -> Self {
        let text = r#"<robot name="pendulum">
            <link name="stand"/>
            <link name="rod"/>
            <joint name="hinge" type="revolute">
                <parent link="stand"/><child link="rod"/>
                <origin rpy="1.5708 0 0"/><axis xyz="0 0 1"/>
                <limit lower="-3" upper="3" velocity="5" effort="10"/>
            </joint>
            <link name="bob"><inertial><origin xyz="0.5 0 0"/><mass value="1"/>
                <inertia ixx="0" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
            <joint name="weld" type="fixed"><parent link="rod"/><child link="bob"/></joint>
        </robot>"#;
        let request = Request {
            parameters: vec![Parameter {
                field: format_ident!("bob"),
                target: Target::MassOf("bob".into()),
                range: None,
            }],
            functions: vec![
                vec![Function::ForwardKinematics],
                vec![Function::InverseDynamics],
                vec![Function::KineticEnergy],
            ],
            ..Request::default()
        };
        Self::new("pendulum", read("pendulum.urdf", text), request)
    }

    /// The same for a processor.
    pub fn on(mut self, processor: Processor) -> Self {
        self.request.processor = processor;
        self
    }

    /// What is asked for, in a type of number.
    pub fn request(&self, real: Real) -> Request {
        Request {
            scalar: real,
            ..self.request.clone()
        }
    }

    /// The description.
    pub const fn description(&self) -> &Description {
        &self.description
    }

    fn builder(&self, real: Real) -> Builder {
        let builder = Builder::from_description(self.description.clone());
        builder.request(self.request(real)).name("Arm")
    }

    /// Its file in Rust.
    pub fn rust(&self, real: Real) -> String {
        let source = self.builder(real).to_source();
        source
            .unwrap_or_else(|errors| panic!("{errors}"))
            .to_string()
    }

    /// Its files in C, with `arm.h` for the header.
    pub fn source(&self, real: Real) -> Source {
        let source = self.builder(real).to_c("arm.h");
        source.unwrap_or_else(|errors| panic!("{errors}"))
    }

    /// How many numbers a state has: of each argument, then of each field.
    pub fn inputs(&self) -> usize {
        let arguments = Variable::ALL.into_iter();
        let arguments = arguments.map(|variable| self.spaces.len(variable.space()));
        arguments.sum::<usize>() + self.fields.iter().map(|(_, size)| size).sum::<usize>()
    }

    /// How many numbers all functions return together.
    pub fn outputs(&self) -> usize {
        let functions = self.asked.iter().flat_map(|asked| &asked.functions);
        let sizes = functions.map(|function| function.result().size(&self.spaces));
        let [coordinates, velocities] =
            [Variable::Q, Variable::Qd].map(|of| self.spaces.len(of.space()));
        let steps = if self.has_steps() {
            3 * coordinates + velocities
        } else {
            0
        };
        sizes.sum::<usize>() + steps
    }

    /// Whether it has functions of configurations, which are asked for with no field.
    pub fn has_steps(&self) -> bool {
        self.spaces.quaternions().next().is_some()
    }
}

fn described(robot: &str) -> Description {
    let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let description = read_file(path.as_ref(), None, &mut errors);
    description.unwrap_or_else(|| panic!("{errors}"))
}

fn read(file: &str, text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read_text(text, file, None, &mut errors);
    description.unwrap_or_else(|| panic!("{errors}"))
}

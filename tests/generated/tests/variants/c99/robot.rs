//! Robots that are printed in both languages.
//!
//! In: descriptions. Out: robots with requests, and their files.

use std::cell::OnceCell;
use std::fmt::Write;

use homogen_codegen::description::{Description, Name, read_file, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::formulation::Sines;
use homogen_codegen::module::Module;
use homogen_codegen::print::c::CSource;
use homogen_codegen::request::{Parameter, Request};
use homogen_codegen::space::{Spaces, Variable};
use homogen_codegen::{Builder, Function, Processor, Real, Target};
use quote::format_ident;

/// A generated function, of one function or of several that share their work, in one frame.
pub struct Call {
    /// The functions that it computes.
    pub functions: Vec<Function>,
    /// Its name in Rust, and in C behind the prefix.
    pub name: String,
    /// True for the method of the prepared robot.
    pub prepared: bool,
}

/// A robot with its request.
pub struct Robot {
    /// The name of its files.
    pub name: String,
    /// The generated functions.
    pub calls: Vec<Call>,
    /// The spaces of arguments and results.
    pub spaces: Spaces,
    /// The fields, each with its number of entries.
    pub fields: Vec<(String, usize)>,
    description: Description,
    request: Request,
    /// Modules in `f32` and in `f64`, each expanded once for both languages.
    modules: [OnceCell<Module>; 2],
}

/// The end effector of a robot with more than one end.
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
        let mut calls = Vec::new();
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
                calls.extend(names.iter().map(|name| Call {
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
            calls,
            spaces: chain.spaces().clone(),
            fields: fields.collect(),
            description,
            request,
            modules: Default::default(),
        }
    }

    /// A robot that ships, with all functions.
    pub fn shipped(name: &str) -> Self {
        let functions = Function::ALL.into_iter().map(|function| vec![function]);
        let request = Request {
            tip: tip(name),
            functions: functions.collect(),
            ..Request::default()
        };
        Self::new(name, described(name), request)
    }

    /// Two links with several fields, one of them never read, a further frame, and `prepare`.
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

    /// The same robot with the sines of the C library.
    pub fn with_platform_sines(mut self) -> Self {
        self.request.formulation.sines = Sines::Platform;
        self
    }

    /// A robot with fewer velocities than coordinates, with some functions.
    pub fn with_quaternions(functions: impl Fn(&Function) -> bool) -> Self {
        let mimic = r#"<mimic joint="to fore" multiplier="-0.7" offset="0.1"/>"#;
        let joints = [
            ("floating", ["world", "trunk"], ""),
            ("spherical", ["trunk", "upper"], ""),
            ("planar", ["upper", "slab"], ""),
            ("continuous", ["slab", "fore"], ""),
            ("continuous", ["fore", "hand"], mimic),
        ];
        Self::with_joints("every_joint", &joints, functions)
    }

    /// A ball joint and a hinge, with all functions.
    pub fn with_a_ball_joint() -> Self {
        let joints = [
            ("spherical", ["world", "upper"], ""),
            ("continuous", ["upper", "fore"], ""),
        ];
        Self::with_joints("ball_joint", &joints, |_| true)
    }

    /// A robot in URDF: types of joints with their links and further elements.
    fn with_joints(
        name: &str,
        joints: &[(&str, [&str; 2], &str)],
        functions: impl Fn(&Function) -> bool,
    ) -> Self {
        let mut text = format!(r#"<robot name="{name}"><link name="world"/>"#);
        for (kind, [parent, child], more) in joints {
            // Writing to a string cannot fail.
            let _ = write!(
                text,
                r#"<link name="{child}"><inertial><origin xyz="0.1 0.02 -0.03"/><mass value="2"/>
                <inertia ixx="0.05" ixy="0.001" ixz="0.002" iyy="0.06" iyz="0.003" izz="0.07"/>
                </inertial></link><joint name="to {child}" type="{kind}"><parent link="{parent}"/>
                <child link="{child}"/><origin xyz="0.2 0.1 0.3" rpy="0.3 -0.2 0.5"/>
                <axis xyz="0 0 1"/>{more}</joint>"#
            );
        }
        text.push_str("</robot>");
        let functions = Function::ALL.into_iter().filter(functions);
        let request = Request {
            functions: functions.map(|function| vec![function]).collect(),
            ..Request::default()
        };
        Self::new(name, read(&format!("{name}.urdf"), &text), request)
    }

    /// A slider-crank with an additional rod, with all functions of loops and forward dynamics.
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

    /// A pendulum with a field for the mass of its bob.
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

    /// The same robot for a processor.
    pub fn on(mut self, processor: Processor) -> Self {
        self.request.processor = processor;
        self
    }

    /// The request, in a scalar type.
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

    fn module(&self, real: Real) -> &Module {
        let [single, double] = &self.modules;
        let module = if real == Real::F32 { single } else { double };
        module.get_or_init(|| {
            let module = self.builder(real).c_module();
            module.unwrap_or_else(|errors| panic!("{errors}"))
        })
    }

    /// Its file in Rust, without a processor.
    pub fn rust(&self, real: Real) -> String {
        self.builder(real).source(self.module(real)).to_string()
    }

    /// Its files in C, with `arm.h` for the header.
    pub fn source(&self, real: Real) -> CSource {
        self.builder(real).c(self.module(real), "arm.h")
    }

    /// The number of inputs of a state: those of each argument, then those of each field.
    pub fn inputs(&self) -> usize {
        let arguments = Variable::ALL.into_iter();
        let arguments = arguments.map(|variable| self.spaces.len(variable.space()));
        arguments.sum::<usize>() + self.fields.iter().map(|(_, size)| size).sum::<usize>()
    }

    /// The number of results of all functions.
    pub fn outputs(&self) -> usize {
        let functions = self.calls.iter().flat_map(|call| &call.functions);
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

    /// True if it has `integrate` and the like, which the programs call only without fields.
    pub fn has_steps(&self) -> bool {
        self.spaces.quaternions().next().is_some()
    }
}

fn described(robot: &str) -> Description {
    let path = format!("{}/../../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let description = read_file(path.as_ref(), None, &mut errors);
    description.unwrap_or_else(|| panic!("{errors}"))
}

fn read(file: &str, text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read_text(text, file, None, &mut errors);
    description.unwrap_or_else(|| panic!("{errors}"))
}

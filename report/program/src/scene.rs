//! The measured scenes: robots with their states, formulations and simpler models.
//!
//! In: the folder of the robots. Out: scenes, each with its variants. To add a formulation, add a line to
//! [`formulations`]; to add a simpler model, one to `simplified.rs`.

use std::path::Path;

use homogen_codegen::Function::{
    self, Bias, CentroidalMomentumMatrix, CoriolisMatrix, ForwardDynamics,
    ForwardDynamicsDerivatives, ForwardKinematics, GeometricJacobian, Gravity, InverseDynamics,
    InverseDynamicsDerivatives, MassMatrix, MassMatrixInverse, Regressor,
};
use homogen_codegen::chain;
use homogen_codegen::description::{self, Description, Name};
use homogen_codegen::error::Errors;
use homogen_codegen::formulation::{Angles, Forward, Frame, Parameters, Products, Sines};
use homogen_codegen::request::Request;
use homogen_codegen::space::{Space, Spaces};
use homogen_plot::Color;

use crate::simplified;
use crate::states::{Range, states};

/// The functions of the report.
pub const FUNCTIONS: [Function; 8] = [
    ForwardKinematics,
    GeometricJacobian,
    Gravity,
    InverseDynamics,
    Bias,
    MassMatrix,
    MassMatrixInverse,
    ForwardDynamics,
];

/// Further functions of controllers, planners and estimators, for robots that are compared with other programs.
const FURTHER: [Function; 5] = [
    InverseDynamicsDerivatives,
    ForwardDynamicsDerivatives,
    CoriolisMatrix,
    Regressor,
    CentroidalMomentumMatrix,
];

/// A robot in some states, with the compared functions and variants.
pub struct Scene {
    /// Its name in files and programs.
    pub name: String,
    /// Its title in the report.
    pub title: String,
    /// The robot.
    pub description: Description,
    /// The request, with its tip and its locked joints.
    pub request: Request,
    /// The measured functions.
    pub functions: Vec<Function>,
    /// The measured variants.
    pub variants: Vec<Variant>,
    /// True if the recursions of the runtime are measured as well.
    pub generic: bool,
    /// The lists that its arguments and results range over.
    pub spaces: Spaces,
    /// The joints that move, in the order of their coordinates.
    pub joints: Vec<String>,
    /// q, q̇, q̈ and τ of [`STATES`](crate::states::STATES) states, one after the other.
    pub states: Vec<f64>,
}

/// A formulation or a simpler model.
#[derive(Clone)]
pub struct Variant {
    /// Its name in files and programs.
    pub name: &'static str,
    /// Its title in the report.
    pub title: &'static str,
    /// The change of description and request.
    pub change: fn(&mut Description, &mut Request),
    /// The types of number that it is measured in.
    pub scalars: &'static [Scalar],
    /// The type of `measured` that replaces `f64`, if any.
    pub number: Option<&'static str>,
    /// The joints that move; all if empty.
    pub joints: &'static [usize],
    /// The function that replaces the measured one, if any.
    pub instead: Option<Function>,
    /// The functions that it changes; all if empty.
    pub functions: &'static [Function],
    /// Its colour in the figures.
    pub color: Color,
}

/// A type of number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Scalar {
    /// Double precision.
    F64,
    /// Single precision.
    F32,
}

impl Scalar {
    /// Its name in Rust.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }
}

impl Variant {
    /// The default of the engine.
    pub const DEFAULT: Self = Self {
        name: "default",
        title: "default",
        change: |_, _| {},
        scalars: &[Scalar::F64, Scalar::F32],
        number: None,
        joints: &[],
        instead: None,
        functions: &[],
        color: Color::Blue,
    };

    /// True if it is measured for a function.
    pub fn serves(&self, function: Function) -> bool {
        self.functions.is_empty() || self.functions.contains(&function)
    }
}

/// The compared formulations.
pub fn formulations() -> Vec<Variant> {
    let variant = |name, title, color, functions, change| Variant {
        name,
        title,
        change,
        functions,
        color,
        scalars: &[Scalar::F64],
        ..Variant::DEFAULT
    };
    vec![
        Variant::DEFAULT,
        variant(
            "frame_0",
            "frame 0",
            Color::Black,
            &RECURSIONS,
            |_, request| {
                request.formulation.frame = Frame::Base;
            },
        ),
        variant(
            "raw",
            "raw parameters",
            Color::Sky,
            &DYNAMICS,
            |_, request| {
                request.formulation.parameters = Parameters::Raw;
            },
        ),
        variant("unfused", "unfused", Color::Green, &[], |_, request| {
            request.formulation.products = Products::Unfused;
        }),
        variant(
            "platform_sines",
            "platform sines",
            Color::Orange,
            &[],
            |_, request| {
                request.formulation.sines = Sines::Platform;
            },
        ),
        Variant {
            number: Some("Libm"),
            ..variant(
                "libm_sines",
                "sines of libm",
                Color::Brown,
                &SINES,
                |_, request| {
                    request.formulation.sines = Sines::Platform;
                },
            )
        },
        variant(
            "refined_1",
            "refined once",
            Color::Purple,
            &[ForwardDynamics],
            |_, request| {
                request.formulation.forward = Some(Forward::MassMatrix { refinements: 1 });
            },
        ),
        variant(
            "refined_2",
            "refined twice",
            Color::Olive,
            &[ForwardDynamics],
            |_, request| {
                request.formulation.forward = Some(Forward::MassMatrix { refinements: 2 });
            },
        ),
        variant(
            "articulated",
            "articulated bodies",
            Color::Vermilion,
            &[ForwardDynamics],
            |_, request| {
                request.formulation.forward = Some(Forward::Articulated);
            },
        ),
    ]
}

/// Sums of the angles of parallel axes, for the functions that they change.
fn merged(functions: &'static [Function]) -> Variant {
    Variant {
        name: "merged",
        title: "merged angles",
        change: |_, request| request.formulation.angles = Angles::Merged,
        functions,
        color: Color::Wine,
        scalars: &[Scalar::F64],
        ..Variant::DEFAULT
    }
}

/// The mass matrix and its factors without refinement, where the engine would choose another formulation.
fn unrefined() -> Variant {
    Variant {
        name: "refined_0",
        title: "unrefined",
        change: |_, request| request.formulation.forward = Some(Forward::UNREFINED),
        functions: &SOLUTIONS,
        color: Color::Sky,
        scalars: &[Scalar::F64],
        ..Variant::DEFAULT
    }
}

/// The formulations that are compared with other programs.
const BESIDE_PEERS: [&str; 4] = ["default", "platform_sines", "refined_1", "articulated"];

/// A robot that is not in the repository, for comparison with other programs: with a floating base, or with a fixed
/// base and all joints locked that do not move the tip. It is measured with our sines, with the platform's sines that
/// the others use, and in formulations with more accuracy or fewer operations.
///
/// # Errors
/// A file that cannot be read or has errors.
pub fn beside_peers(
    [name, title, tip]: [&str; 3],
    path: &Path,
    floating: bool,
) -> Result<Scene, Errors> {
    let request = Request {
        floating,
        path_only: !floating,
        ..to(tip)
    };
    let mut scene = Scene::read(name, title, path, request)?;
    scene.states = states(&scene.spaces, Range::WIDE);
    scene.functions = FUNCTIONS.into_iter().chain(FURTHER).collect();
    let variants = formulations().into_iter();
    scene.variants = variants
        .filter(|variant| BESIDE_PEERS.contains(&variant.name))
        .chain([unrefined()])
        .collect();
    scene.generic = true;
    Ok(scene)
}

/// The functions that are measured in frame 0, as in the paper; matrices of joints grow out of proportion there.
const RECURSIONS: [Function; 5] = [
    ForwardKinematics,
    GeometricJacobian,
    Gravity,
    InverseDynamics,
    Bias,
];

/// The functions for a comparison of sines: the one with the fewest operations, the most used, the one with the most.
const SINES: [Function; 3] = [ForwardKinematics, InverseDynamics, ForwardDynamics];

/// The solutions of the equation of motion.
const SOLUTIONS: [Function; 2] = [MassMatrixInverse, ForwardDynamics];

const DYNAMICS: [Function; 6] = [
    Gravity,
    InverseDynamics,
    Bias,
    MassMatrix,
    MassMatrixInverse,
    ForwardDynamics,
];

/// The robots of the repository, each in random states.
///
/// # Errors
/// A file that cannot be read.
pub fn robots(root: &Path) -> Result<Vec<Scene>, Errors> {
    [
        (
            "two_link",
            "Two links",
            "tip",
            vec![merged(&FUNCTIONS[..3])],
        ),
        ("ur5_class", "UR5 class", "tool0", vec![merged(&FUNCTIONS)]),
        ("panda_class", "Panda class", "link8", Vec::new()),
        (
            "quadruped",
            "Quadruped",
            "fl_foot",
            vec![merged(&FUNCTIONS)],
        ),
    ]
    .into_iter()
    .map(|(name, title, tip, more)| {
        let path = root.join("robots").join(name).with_extension("urdf");
        let mut scene = Scene::read(name, title, &path, to(tip))?;
        scene.states = states(&scene.spaces, Range::WIDE);
        scene.functions = FUNCTIONS.to_vec();
        scene.variants = formulations();
        scene.variants.extend(more);
        scene.generic = true;
        Ok(scene)
    })
    .collect()
}

/// A robot whose coordinates are not its velocities, to check that everything runs with it.
///
/// # Errors
/// A file that cannot be read.
pub fn free(root: &Path) -> Result<Scene, Errors> {
    let request = Request {
        floating: true,
        ..to("fl_foot")
    };
    let path = root.join("robots/quadruped.urdf");
    let mut scene = Scene::read("free", "Quadruped with a floating base", &path, request)?;
    scene.states = states(&scene.spaces, Range::WIDE);
    scene.functions = FUNCTIONS.to_vec();
    scene.variants = vec![Variant::DEFAULT];
    scene.generic = true;
    Ok(scene)
}

/// The scenes with simpler models.
///
/// # Errors
/// A file that cannot be read.
pub fn models(root: &Path) -> Result<Vec<Scene>, Errors> {
    let path = root.join("robots/panda_class.urdf");
    let scene = |name, title, range, variants| {
        let scene = Scene::read(name, title, &path, to("link8"))?;
        Ok(Scene {
            states: states(&scene.spaces, range),
            functions: vec![InverseDynamics],
            variants,
            ..scene
        })
    };
    Ok(vec![
        scene("lively", "any motion", Range::WIDE, simplified::anywhere())?,
        scene(
            "slow",
            "at a hundredth of the speed",
            Range::SLOW,
            simplified::slow(),
        )?,
        scene(
            "plane",
            "in a vertical plane",
            Range::PLANE,
            simplified::in_a_plane(),
        )?,
    ])
}

impl Scene {
    /// A robot without states and functions.
    ///
    /// # Errors
    /// A file that cannot be read or has errors.
    pub fn read(name: &str, title: &str, path: &Path, request: Request) -> Result<Self, Errors> {
        let mut errors = Errors::new();
        let description = match description::read_file(path, None, &mut errors) {
            Some(description) => errors.into_result(description)?,
            None => return Err(errors),
        };
        let chain = chain::build(&description, &request)?.identified();
        Ok(Self {
            name: name.to_owned(),
            title: title.to_owned(),
            description,
            request,
            functions: Vec::new(),
            variants: Vec::new(),
            generic: false,
            spaces: chain.spaces().clone(),
            joints: chain.report.joints,
            states: Vec::new(),
        })
    }

    /// Number of entries of a list.
    pub fn length(&self, space: Space) -> usize {
        self.spaces.len(space)
    }

    /// The robot and the request of a variant.
    pub fn of(&self, variant: &Variant) -> (Description, Request) {
        let (mut description, mut request) = (self.description.clone(), self.request.clone());
        (variant.change)(&mut description, &mut request);
        (description, request)
    }
}

/// A request with a tip only.
fn to(tip: &str) -> Request {
    Request {
        tip: Some(Name::from(tip)),
        ..Request::default()
    }
}

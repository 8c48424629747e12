//! The robots whose bounds are compared with errors.
//!
//! In: a name, options. Out: descriptions with requests, and chains.

use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Description, Name, read_file, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::formulation::Formulation;
use homogen_codegen::request::{Parameter, Request, Target};
use homogen_tests::actuators::with_actuators;
use homogen_tests::subjects::{Subject, subject};
use quote::format_ident;

use crate::error_bound::jointed;

/// A parameter that is a field, and its link or joint.
pub type Free = (fn(Name) -> Target, &'static str);

/// A robot and its options.
#[derive(Clone, Copy)]
pub struct Asked {
    pub robot: &'static str,
    pub tip: &'static str,
    pub formulation: Formulation,
    /// Links whose masses are fields.
    pub loads: &'static [&'static str],
    /// Other parameters that are fields.
    pub free: &'static [Free],
    /// True if its joints have armature, damping and friction, and its end effector an external wrench.
    pub has_actuators: bool,
    /// True if its base is floating.
    pub floating: bool,
    /// The largest allowed ratio of a bound to the worst measured error.
    pub farthest: f64,
}

/// A robot with default options. The largest ratio of a bound to the worst error is 129, for the bias of the
/// seven-joint arm: rounding errors of opposite signs cancel, and a bound must assume that they do not.
pub fn asked(robot: &'static str, tip: &'static str) -> Asked {
    Asked {
        robot,
        tip,
        formulation: Formulation::default(),
        loads: &[],
        free: &[],
        has_actuators: false,
        floating: false,
        farthest: 150.0,
    }
}

/// The description and request of a robot that ships, of one with other types of joints, or of a hard case by its
/// label.
pub fn described(asked: Asked) -> (Description, Request) {
    let (description, request) = as_asked(asked);
    let chain = chain::build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    ((*chain.description).clone(), (*chain.request).clone())
}

fn as_asked(asked: Asked) -> (Description, Request) {
    if asked.robot.contains('/') {
        let Subject {
            description,
            request,
        } = subject(asked.robot);
        let formulation = asked.formulation;
        return (
            description,
            Request {
                formulation,
                ..request
            },
        );
    }
    let mut errors = Errors::new();
    let description = if let Some(text) = jointed::text(asked.robot) {
        read_text(&text, asked.robot, None, &mut errors)
    } else {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots");
        let folder = if has_spheres(asked) {
            concat!(env!("CARGO_MANIFEST_DIR"), "/robots")
        } else {
            folder
        };
        let path = format!("{folder}/{}.urdf", asked.robot);
        read_file(path.as_ref(), None, &mut errors)
    };
    let description = description.unwrap_or_else(|| panic!("{errors}"));
    let loads = asked.loads.iter().map(|&link| Parameter {
        field: format_ident!("{link}"),
        target: Target::MassOf(Name::from(link)),
        range: None,
    });
    let others = asked.free.iter().zip(0..);
    let others = others.map(|(&(target, of), k)| Parameter {
        field: format_ident!("field_{k}"),
        target: target(Name::from(of)),
        range: None,
    });
    let request = Request {
        tip: Some(Name::from(asked.tip)),
        parameters: loads.chain(others).collect(),
        formulation: asked.formulation,
        floating: asked.floating,
        collision: has_spheres(asked),
        ..Request::default()
    };
    let request = if asked.has_actuators {
        Request {
            external: vec![Name::from(asked.tip)],
            ..with_actuators(&description, request)
        }
    } else {
        request
    };
    (description, request)
}

/// True for the robot that is covered with spheres.
fn has_spheres(asked: Asked) -> bool {
    asked.robot == "two_arms"
}

pub fn chain_of(asked: Asked) -> Chain {
    let (description, request) = described(asked);
    chain::build(&description, &request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified()
}

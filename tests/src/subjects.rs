//! Robots without a file that are hard cases of arithmetic, each with a short label.
//!
//! In: a label such as `planar/12` or `heavy_tip/1e6`. Out: a description and a request. Labels are in the table of
//! worst inputs, so their robots must not change. Lengths are in metres, masses in kilograms; rods are thin and uniform
//! unless stated otherwise.

use std::path::Path;

use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{
    Axis, Description, Inertial, Joint, Link, Name, Number, Source, Step, Unmodelled, read_file,
};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::joint::JointKind;
use homogen_codegen::joint::actuator::Actuator;
use homogen_codegen::request::Request;

/// A robot and a request.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The input of the generator.
    pub description: Description,
    /// The request for it.
    pub request: Request,
}

/// The robot of a label.
///
/// | label | robot |
/// |---|---|
/// | `planar/N` | N rods of 1 m and 1 kg with axes along y; straight along x at q = 0 |
/// | `floating/N` | the same without gravity |
/// | `lift/N` | the same on a prismatic joint along z |
/// | `spatial/N` | N links of 0.5 m with axes at right angles and no zero among their parameters |
/// | `tilted/N` | the same with axes at 0.9 rad, whose sine is not an exact number |
/// | `twisted/T` | six of them with axes at T rad |
/// | `heavy_tip/M`, `heavy_base/M` | six rods, the last or the first of M kg |
/// | `shrinking/N`, `growing/N` | N rods of 1 kg, each a quarter or four times as long as the one before |
/// | `short_link/L` | five rods, the third of L |
/// | `massless_wrist/I` | three rods and a hand on three joints about one line, whose first two links have no mass and I kg m² about the line |
/// | `spherical_wrist/I` | the same with the second axis perpendicular, singular only at q₅ = 0 |
/// | `thin_rod/I` | six rods, with axes along y and z alternately, and I kg m² about their own axis |
/// | `rolling_rod/I` | the same, with the last joint about the rod's own axis |
/// | `waist_with_arm/0` | a humanoid's waist of three joints in light links, a torso, and an arm of seven |
/// | `panda_class/D`, `quadruped/0` … | a robot that ships, its first joint D to the side and up |
/// | `floating_FILE/D` | the same without gravity |
/// | `payload/M` | the arm of seven joints with M kg at 10 m from its hand |
///
/// # Panics
/// If there is no such robot.
#[must_use]
pub fn subject(label: &str) -> Subject {
    let (family, parameter) = label.split_once('/').expect("family/parameter");
    let number: f64 = parameter.parse().expect("a number");
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "counts of links are small integers"
    )]
    let count = number as usize;
    let powers =
        |base: f64| (0..count).map(move |k| base.powf(f64::from(u32::try_from(k).expect("few"))));
    let description = match family {
        "planar" | "floating" => planar(&vec![1.0; count], &vec![1.0; count]),
        "lift" => lifted(planar(&vec![1.0; count], &vec![1.0; count])),
        "spatial" => spatial(count, std::f64::consts::FRAC_PI_2),
        "tilted" => spatial(count, 0.9),
        "twisted" => spatial(6, number),
        "heavy_tip" => planar(&[1.0; 6], &[1.0, 1.0, 1.0, 1.0, 1.0, number]),
        "heavy_base" => planar(&[1.0; 6], &[number, 1.0, 1.0, 1.0, 1.0, 1.0]),
        "shrinking" => planar(&powers(0.25).collect::<Vec<_>>(), &vec![1.0; count]),
        "growing" => planar(&powers(4.0).collect::<Vec<_>>(), &vec![1.0; count]),
        "short_link" => planar(&[1.0, 1.0, number, 1.0, 1.0], &[1.0; 5]),
        "massless_wrist" => wrist(number, [1.0, 0.0, 0.0]),
        "spherical_wrist" => wrist(number, [0.0, 1.0, 0.0]),
        "thin_rod" => thin_rods(number, [0.0, 0.0, 1.0]),
        "rolling_rod" => thin_rods(number, [1.0, 0.0, 0.0]),
        "waist_with_arm" => waist_with_arm(),
        "payload" => with_payload(shipped("panda_class"), number),
        file => {
            let mut description = shipped(file.strip_prefix("floating_").unwrap_or(file));
            let aside = Step::Translate([number, 0.0, number].map(exactly));
            description.joints[0].origin.insert(0, aside);
            description
        }
    };
    let mut request = Request::default();
    if family.starts_with("floating") {
        request.gravity = Some([0.0; 3].map(exactly));
    }
    if family == "quadruped" {
        request.tip = Some("hr_foot".into());
    }
    Subject {
        description,
        request,
    }
}

impl Subject {
    /// The chain of the robot.
    ///
    /// # Panics
    /// If it is rejected.
    #[must_use]
    pub fn chain(&self) -> Chain {
        chain::build(&self.description, &self.request)
            .unwrap_or_else(|errors| panic!("{errors}"))
            .identified()
    }
}

/// A joint and its link.
struct Segment {
    at: Vec<Step>,
    kind: JointKind,
    axis: [f64; 3],
    body: Body,
}

#[derive(Clone, Copy)]
struct Body {
    mass: f64,
    center: [f64; 3],
    /// xx, xy, xz, yy, yz, zz about the centre of mass.
    tensor: [f64; 6],
}

fn planar(lengths: &[f64], masses: &[f64]) -> Description {
    let mut before = 0.0;
    let segments = lengths.iter().zip(masses).map(|(&length, &mass)| {
        let along = [before, 0.0, 0.0];
        before = length;
        revolute(
            vec![translation(along)],
            [0.0, 1.0, 0.0],
            rod(length, mass, 0.0),
        )
    });
    robot(segments.collect(), [lengths[lengths.len() - 1], 0.0, 0.0])
}

/// A rod along x; `about_itself` is the moment of inertia about its own axis.
fn rod(length: f64, mass: f64, about_itself: f64) -> Body {
    let across = mass * length * length / 12.0;
    Body {
        mass,
        center: [length / 2.0, 0.0, 0.0],
        tensor: [about_itself, 0.0, 0.0, across, 0.0, across],
    }
}

fn lifted(mut description: Description) -> Description {
    description.joints[0].parent = "carriage".into();
    description.links.push(link("carriage", None));
    let lift = Joint {
        name: "lift".into(),
        kind: JointKind::Prismatic,
        parent: "link0".into(),
        child: "carriage".into(),
        axis: [0.0, 0.0, 1.0].map(exactly),
        second_axis: [Number::default(); 3],
        mimic: None,
        origin: Vec::new(),
        limits: None,
        actuator: Actuator::default(),
        place: Place::Unknown,
    };
    description.joints.insert(0, lift);
    description
}

fn spatial(count: usize, twist: f64) -> Description {
    let segments = (0..count).map(|k| {
        let mut at = Vec::new();
        if k > 0 {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            at.push(translation([0.5, 0.1, -0.05]));
            at.push(Step::Rotate(Axis::X, exactly(sign * twist)));
        }
        let body = Body {
            mass: 1.0,
            center: [0.23, 0.04, -0.03],
            tensor: [0.011, 0.002, -0.003, 0.031, 0.001, 0.029],
        };
        revolute(at, [0.0, 0.0, 1.0], body)
    });
    robot(segments.collect(), [0.5, 0.1, -0.05])
}

fn wrist(about_axis: f64, second: [f64; 3]) -> Description {
    let arm = |axis, at| revolute(vec![translation(at)], axis, rod(0.4, 2.0, 1e-3));
    let massless = |axis: [f64; 3], at| {
        let [x, y, z] = axis.map(|entry| entry * about_axis);
        let body = Body {
            mass: 0.0,
            center: [0.0; 3],
            tensor: [x, 0.0, 0.0, y, 0.0, z],
        };
        revolute(vec![translation(at)], axis, body)
    };
    let (along, across) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let (here, end) = ([0.0; 3], [0.4, 0.0, 0.0]);
    let segments = vec![
        arm([0.0, 0.0, 1.0], here),
        arm(across, here),
        arm(across, end),
        massless(along, end),
        massless(second, here),
        revolute(Vec::new(), along, rod(0.2, 0.5, 1e-3)),
    ];
    robot(segments, [0.2, 0.0, 0.0])
}

fn thin_rods(about_itself: f64, last: [f64; 3]) -> Description {
    let axes = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let segments = (0..6).map(|k| {
        let axis = if k == 5 { last } else { axes[k % 2] };
        let at = if k == 0 { 0.0 } else { 0.5 };
        revolute(
            vec![translation([at, 0.0, 0.0])],
            axis,
            rod(0.5, 1.0, about_itself),
        )
    });
    robot(segments.collect(), [0.5, 0.0, 0.0])
}

/// Three joints with small links about one point, as gears and motors have them, inboard of a heavy torso and an arm.
fn waist_with_arm() -> Description {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let body = |mass, center, [xx, yy, zz]: [f64; 3]| Body {
        mass,
        center,
        tensor: [xx, 0.01 * yy, -0.02 * zz, yy, 0.015 * xx, zz],
    };
    let small = |mass: f64| {
        body(
            mass,
            [0.01, -0.005, 0.02],
            [3e-4, 4e-4, 2e-4].map(|of| of * mass),
        )
    };
    let segments = [
        ([0.0, 0.0, 0.1], z, small(0.3)),
        ([0.0, 0.0, 0.02], x, small(0.3)),
        ([0.0; 3], y, body(8.0, [0.01, 0.0, 0.18], [0.1, 0.08, 0.03])),
        ([0.0, 0.12, 0.25], y, small(0.4)),
        ([0.0, 0.03, 0.0], x, small(0.4)),
        (
            [0.0, 0.0, -0.1],
            z,
            body(0.8, [0.0, 0.0, -0.06], [2e-3, 2e-3, 4e-4]),
        ),
        (
            [0.01, 0.0, -0.15],
            y,
            body(0.6, [0.0, 0.005, -0.05], [1e-3, 1e-3, 2e-4]),
        ),
        ([0.0, 0.0, -0.14], z, small(0.1)),
        ([0.0; 3], x, small(0.1)),
        (
            [0.0; 3],
            y,
            body(0.4, [0.0, 0.01, -0.06], [5e-4, 4e-4, 1e-4]),
        ),
    ];
    let segments = segments.map(|(at, axis, body)| revolute(vec![translation(at)], axis, body));
    robot(segments.into(), [0.0, 0.0, -0.1])
}

fn with_payload(mut description: Description, mass: f64) -> Description {
    let hand = description
        .links
        .iter_mut()
        .rev()
        .find(|link| link.name.text == "link8");
    hand.expect("the arm has a hand").inertial = Some(inertial(Body {
        mass,
        center: [10.0, 0.3, -0.2],
        tensor: [4.0, 0.5, -0.3, 5.0, 0.7, 6.0],
    }));
    description
}

fn shipped(name: &str) -> Description {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
    let mut errors = Errors::new();
    let description = read_file(&folder.join(format!("{name}.urdf")), None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

fn revolute(at: Vec<Step>, axis: [f64; 3], body: Body) -> Segment {
    Segment {
        at,
        kind: JointKind::Continuous,
        axis,
        body,
    }
}

/// A serial robot, and a massless end effector.
fn robot(segments: Vec<Segment>, end: [f64; 3]) -> Description {
    let count = segments.len();
    let mut links = vec![link("link0", None)];
    let mut joints = Vec::new();
    let weld = Segment {
        at: vec![translation(end)],
        kind: JointKind::Fixed,
        axis: [0.0, 0.0, 1.0],
        body: Body {
            mass: 0.0,
            center: [0.0; 3],
            tensor: [0.0; 6],
        },
    };
    for (k, segment) in segments.into_iter().chain([weld]).enumerate() {
        let fixed = k == count;
        let child = if fixed {
            "tip".to_owned()
        } else {
            format!("link{}", k + 1)
        };
        links.push(link(&child, (!fixed).then_some(segment.body)));
        joints.push(Joint {
            name: Name::from(&*format!("joint{}", k + 1)),
            kind: segment.kind,
            parent: Name::from(&*format!("link{k}")),
            child: Name::from(&*child),
            origin: segment.at,
            axis: segment.axis.map(exactly),
            second_axis: [Number::default(); 3],
            mimic: None,
            limits: None,
            actuator: Actuator::default(),
            place: Place::Unknown,
        });
    }
    Description {
        name: "chain".into(),
        source: Source::default(),
        links,
        joints,
        loops: Vec::new(),
        configurations: Vec::new(),
        collisions: Vec::new(),
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    }
}

fn link(name: &str, body: Option<Body>) -> Link {
    Link {
        name: name.into(),
        inertial: body.map(inertial),
    }
}

fn inertial(body: Body) -> Inertial {
    Inertial {
        origin: vec![translation(body.center)],
        mass: exactly(body.mass),
        inertia: body.tensor.map(exactly),
        place: Place::Unknown,
    }
}

fn translation(t: [f64; 3]) -> Step {
    Step::Translate(t.map(exactly))
}

/// A number that was not read from text.
fn exactly(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}

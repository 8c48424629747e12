//! Robots with residues in place of zeros, as exporters write them. Each of them once gave wrong numbers or NaN, or was
//! refused as a fault of the engine.
//!
//! Every function, by the engine's choice and with its own check, is compared with the dense matrices of [`frame_0`] in
//! 256 bits; with and without `exact`, by which no residue counts as zero, then in every layout.

use std::fmt::Write;

use homogen_codegen::check::Check;
use homogen_codegen::description::{Description, Number, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::formulation::Angles;
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::FrameId;
use homogen_codegen::{Function, Real};
use homogen_tests::arguments;
use homogen_tests::big::Big;
use homogen_tests::oracle::frame_0;
use homogen_tests::oracle::robot::Robot;
use homogen_tests::programs::program;
use homogen_tests::states::Random;

/// Size, in any unit, below which a result may be zero.
const LEAST: f64 = 1e-40;

/// Relative to the largest entry of a result; larger than the effect of residues that count as zero.
const TOLERANCE: f64 = 1e-12;

const STATES: usize = 2;

/// Oblique, so that every joint has gravity torques.
const GRAVITY: [f64; 3] = [1.1, -2.3, 8.7];

/// Functions that are computed in every layout: they contain poses of frames, and first and second moments of bodies.
const IN_EVERY_LAYOUT: [Function; 3] = [
    Function::SpatialJacobian,
    Function::InverseDynamics,
    Function::MassMatrix,
];

/// Joints from link to link, as `(type and axis, origin)`, and the inertials of the links that they carry.
struct Arm<'t> {
    joints: &'t [(&'t str, &'t str)],
    inertials: &'t [&'t str],
}

/// An ordinary body.
const BODY: &str = r#"<origin xyz="0.02 -0.03 0.1" rpy="0.1 0.2 0.3"/><mass value="1.7"/>
    <inertia ixx="0.021" ixy="0.003" ixz="0.001" iyy="0.033" iyz="-0.002" izz="0.042"/>"#;

const ABOUT_Z: &str = r#"continuous"><axis xyz="0 0 1"/>"#;
const FIXED: &str = r#"fixed">"#;

impl Arm<'_> {
    fn description(&self) -> Description {
        let mut text = r#"<robot name="arm"><link name="l0"/>"#.to_owned();
        for (k, (joint, inertial)) in self.joints.iter().zip(self.inertials).enumerate() {
            let (kind, origin) = joint;
            let next = k + 1;
            // Writing to a string cannot fail.
            let _ = write!(
                text,
                r#"<link name="l{next}"><inertial>{inertial}</inertial></link>
                <joint name="j{next}" type="{kind}<parent link="l{k}"/><child link="l{next}"/>
                <origin {origin}/></joint>"#
            );
        }
        text += "</robot>";
        let mut errors = Errors::new();
        let description = read_text(&text, "arm.urdf", None, &mut errors);
        assert!(errors.is_empty(), "{errors}");
        description.expect("no mistakes, so a description")
    }

    /// Compares every function with its true value.
    fn holds(&self) {
        let description = self.description();
        for exact in [false, true] {
            let gravity = GRAVITY.map(|value| Number {
                value,
                ..Number::default()
            });
            let request = Request {
                exact,
                gravity: Some(gravity),
                ..Request::default()
            };
            hold(&description, &request);
        }
    }
}

fn hold(description: &Description, request: &Request) {
    let chain = understand(description, request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified();
    let check = Check::of(&chain);
    let check = check.unwrap_or_else(|errors| panic!("{errors}"));
    let robot = Robot::of(description, request);
    for function in frame_0::functions() {
        let functions = [function];
        let chosen = program(&chain, &functions, FrameId::FIRST, Real::F64)
            .and_then(|chosen| {
                check.judge_program(&functions, FrameId::FIRST, &chosen, Real::F64)?;
                Ok(chosen)
            })
            .unwrap_or_else(|errors| panic!("{errors}"));
        compare(&robot, function, &chosen);
        if !(request.exact && IN_EVERY_LAYOUT.contains(&function)) {
            continue;
        }
        let layouts = if function.needs_a_frame() {
            Layout::for_kinematics(&chain)
        } else {
            Layout::for_dynamics(&chain)
        };
        for layout in layouts {
            for angles in [Angles::Apart, Angles::Merged] {
                let algorithm = Algorithm {
                    angles,
                    ..Algorithm::PLAIN
                };
                let program = program_by(&chain, &functions, FrameId::FIRST, layout, algorithm);
                compare(&robot, function, &program);
            }
        }
    }
}

fn compare(robot: &Robot, function: Function, program: &Program) {
    let mut random = Random::new(1);
    for _ in 0..STATES {
        let arguments = arguments::random(robot.velocities(), &mut random);
        let found = run::<f64>(program, |input| arguments::at(&arguments, input));
        let expected = frame_0::evaluate(robot, function, 0, &arguments);
        let expected: Vec<f64> = expected.iter().map(Big::to_f64).collect();
        let size = expected
            .iter()
            .fold(LEAST, |size: f64, x| size.max(x.abs()));
        for (x, y) in found.iter().zip(&expected) {
            // False for NaN.
            let near = (x - y).abs() <= TOLERANCE * size;
            assert!(near, "{function:?}: {found:?} instead of {expected:?}");
        }
    }
}

#[test]
fn residues_in_roll_pitch_and_yaw_of_joints_are_computed() {
    Arm {
        joints: &[
            (ABOUT_Z, r#"xyz="0.1 0.2 0.3""#),
            (
                ABOUT_Z,
                r#"xyz="0.3 0 0.05" rpy="-1.6653e-16 1.1102e-16 0.5""#,
            ),
            (
                ABOUT_Z,
                r#"xyz="0.2 0.1 0" rpy="1.5708 -4.9e-10 2.2204e-16""#,
            ),
            (ABOUT_Z, r#"xyz="0 0.1 0.2" rpy="-2e-15 3.7e-9 -1.5708""#),
        ],
        inertials: &[BODY; 4],
    }
    .holds();
}

#[test]
fn a_residue_in_the_inertial_rpy_is_computed() {
    let tilted = r#"<origin rpy="0 0 2e-16"/><mass value="0.3"/>
        <inertia ixx="0.06" ixy="0" ixz="-7e-13" iyy="0.05" iyz="0" izz="0.04"/>"#;
    let rotated = r#"<origin rpy="-3.4e-9 1e-17 1e-13"/><mass value="0.3"/>
        <inertia ixx="0.06" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.04"/>"#;
    for inertial in [tilted, rotated] {
        Arm {
            joints: &[
                (ABOUT_Z, r#"xyz="0.1 0 0" rpy="1.1 0 0""#),
                (ABOUT_Z, r#"rpy="0.7 0 0""#),
            ],
            inertials: &[BODY, inertial],
        }
        .holds();
    }
}

#[test]
fn a_last_link_with_its_centre_of_mass_on_its_axis_is_computed() {
    for product in ["1e-9", "-3e-13", "1e-18"] {
        let inertial = format!(
            r#"<origin xyz="0 0 0.05"/><mass value="0.4"/><inertia ixx="1e-3" ixy="{product}"
            ixz="0" iyy="2e-3" iyz="0" izz="5e-4"/>"#
        );
        Arm {
            joints: &[
                (ABOUT_Z, r#"xyz="0.1 0 0" rpy="1.1 0 0""#),
                (ABOUT_Z, r#"xyz="0 0.2 0.1" rpy="0.7 0 0""#),
            ],
            inertials: &[BODY, &inertial],
        }
        .holds();
    }
}

#[test]
fn a_last_link_with_its_centre_of_mass_nearly_on_its_axis_is_computed() {
    let inertial = r#"<origin xyz="1e-9 -3e-17 0.05"/><mass value="0.4"/>
        <inertia ixx="1e-3" ixy="1e-9" ixz="0" iyy="2e-3" iyz="1e-12" izz="5e-4"/>"#;
    Arm {
        joints: &[
            (ABOUT_Z, r#"xyz="0.1 0 0" rpy="1.1 0 0""#),
            (ABOUT_Z, r#"xyz="0 0.2 0.1" rpy="0.7 0 0""#),
        ],
        inertials: &[BODY, inertial],
    }
    .holds();
}

#[test]
fn coaxial_joints_with_offsets_that_cancel_but_for_rounding_are_computed() {
    // 0.1 + 0.2 − 0.30000000000000004, and an oblique angle between axes.
    for [first, second, third] in [
        ["0.1 0.1 0", "0.2 0.2 0", "-0.30000000000000004 -0.3 0.2"],
        ["0.1 0.3 0.4", "0.2 -0.1 0", "-0.3 -0.2 0"],
        ["0.1 0.1 0", "0.2 0.2 0", "-0.3 -0.300000000007 0.2"],
    ] {
        let placed = [first, second, third].map(|xyz| format!(r#"xyz="{xyz}""#));
        Arm {
            joints: &[
                (ABOUT_Z, r#"xyz="0.5 0 0" rpy="0.4 0 0""#),
                (FIXED, &placed[0]),
                (FIXED, &placed[1]),
                (ABOUT_Z, &placed[2]),
                (ABOUT_Z, r#"xyz="0.3 0 0" rpy="1.5708 0 0""#),
            ],
            inertials: &[BODY; 5],
        }
        .holds();
    }
}

#[test]
fn coaxial_joints_behind_a_rotation_and_its_inverse_are_computed() {
    Arm {
        joints: &[
            (ABOUT_Z, r#"xyz="0.5 0 0" rpy="0.4 0 0""#),
            (FIXED, r#"xyz="0.3 0.1 -0.2" rpy="0 0 0.9""#),
            // −Rᵗ t, rounded to 17 digits.
            (
                ABOUT_Z,
                r#"xyz="-0.26481568166882836 0.17283707200004 0.2" rpy="0 0 -0.9""#,
            ),
            (ABOUT_Z, r#"xyz="0.3 0 0" rpy="-1.5708 0 0""#),
        ],
        inertials: &[BODY; 4],
    }
    .holds();
}

#[test]
fn a_right_angle_in_two_and_three_parts_is_computed() {
    for (angle, parts) in [
        ("0.7853981633974483", 2),
        ("0.5235987755982988", 3),
        ("0.785398", 2),
    ] {
        let placed = format!(r#"xyz="0 0 0.1" rpy="{angle} 0 0""#);
        let mut joints = vec![(ABOUT_Z, r#"xyz="0.5 0 0""#)];
        joints.extend(vec![(FIXED, placed.as_str()); parts]);
        joints.push((ABOUT_Z, r#"xyz="0.2 0 0""#));
        joints.push((ABOUT_Z, r#"rpy="1.5708 0 0""#));
        Arm {
            inertials: &vec![BODY; joints.len()],
            joints: &joints,
        }
        .holds();
    }
}

#[test]
fn an_axis_nearly_along_a_coordinate_axis_is_computed() {
    for axis in ["1e-16 0 1", "-3.1e-9 1e-17 1", "0 1 -8.26e-16"] {
        let about = format!(r#"continuous"><axis xyz="{axis}"/>"#);
        Arm {
            joints: &[
                (&about, r#"xyz="0.5 0 0""#),
                (&about, r#"xyz="0 0 -0.1""#),
                (ABOUT_Z, r#"xyz="0.1 0 0" rpy="0 1e-14 0""#),
            ],
            inertials: &[BODY; 3],
        }
        .holds();
    }
}

/// The angles of both joints are summed; once the second one had the wrong sign.
#[test]
fn parallel_axes_of_nearly_unit_length_rotate_the_same_way() {
    let about = r#"continuous"><axis xyz="1 -8.26e-16 0"/>"#;
    let point = r#"<origin xyz="0 0.3 0"/><mass value="0.002"/>
        <inertia ixx="1e-5" ixy="0" ixz="0" iyy="1e-5" iyz="0" izz="1e-5"/>"#;
    Arm {
        joints: &[(about, r#"xyz="0 0 0""#), (about, r#"xyz="0 0 -0.1""#)],
        inertials: &[BODY, point],
    }
    .holds();
}

/// A residue of 1e-27 beside 1 is lost when a frame is rotated and rotated back, which is no error.
#[test]
fn residues_of_residues_pass_the_engines_own_check() {
    let skew = "-0.7101073486962786 0.5405173861892916 -0.45120783299344247";
    let along = format!(r#"prismatic"><axis xyz="{skew}"/>"#);
    let about = format!(r#"continuous"><axis xyz="{skew}"/>"#);
    for placed in [
        r#"rpy="-3.141592653589793 0 1.237934e-17""#,
        r#"rpy="0 -2e-18 -1e-9""#,
        r#"xyz="-2e-17 0 0" rpy="0 -3 0""#,
    ] {
        for motion in [&along, &about] {
            Arm {
                joints: &[
                    (motion, placed),
                    (FIXED, r#"rpy="1.237934e-17 0 9e-15""#),
                    (ABOUT_Z, r#"xyz="0.7 -8e-12 0""#),
                ],
                inertials: &[BODY; 3],
            }
            .holds();
        }
    }
}

#[test]
fn massless_links_and_thin_rods_between_others_are_computed() {
    let massless = r#"<mass value="0"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>"#;
    let rod = r#"<origin xyz="1e-16 0 0.2" rpy="0 1e-12 0"/><mass value="0.5"/>
        <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0"/>"#;
    Arm {
        joints: &[
            (ABOUT_Z, r#"xyz="0.5 0 0""#),
            (ABOUT_Z, r#"rpy="1.5707963 0 0""#),
            (ABOUT_Z, r#"xyz="0 1e-17 0" rpy="-1.5707963 0 0""#),
            (ABOUT_Z, r#"xyz="0.2 0 0" rpy="1.57079 0 0""#),
        ],
        inertials: &[BODY, massless, rod, BODY],
    }
    .holds();
}

#[test]
fn angles_of_thousands_of_full_turns_are_computed() {
    Arm {
        joints: &[
            (ABOUT_Z, r#"xyz="0.1 0.2 0.3" rpy="12345.678 0 -1000.1""#),
            (ABOUT_Z, r#"xyz="0.3 0 0.05" rpy="0 999999.25 0""#),
            (ABOUT_Z, r#"xyz="0.3 0 0.05" rpy="15707.963268 0 0""#),
        ],
        inertials: &[BODY; 3],
    }
    .holds();
}

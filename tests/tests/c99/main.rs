//! The C of a robot against the Rust file of the same, bit for bit, and against every compiler at hand.
//!
//! The two share the routine and nothing of its spelling: each is compiled by itself, with a program that
//! reads states and writes results, and runs as a process of its own.

mod compilers;
mod fused;
mod programs;
mod robot;
mod states;

use homogen_codegen::Real;

use compilers::{C, Folder, rust};
use robot::Robot;

/// How many states each function is called with.
const STATES: usize = 10_000;

/// Compiles a robot in both languages, and compares what they give.
fn agree(robot: &Robot) {
    let states = states::nasty(robot.inputs(), STATES);
    for real in [Real::F32, Real::F64] {
        let folder = Folder::new(&format!("{}_{real:?}", robot.name));
        let states = states::bytes(&states, real);
        let expected = rust(&folder, robot, real).run(&states);
        folder.write_c(robot, real);
        for compiler in C::all() {
            let object = compiler.object(&folder, "arm.c", &[]);
            compiler.alone(&folder, &object);
            if compiler.runs_here() {
                let found = compiler.program(&folder, &object).run(&states);
                let what = format!("{} by {compiler}", robot.name);
                states::same(&found, &expected, robot.outputs(), real, &what);
            }
        }
    }
}

macro_rules! gives_the_bits_of_rust {
    ($($(#[$long:meta])? $name:ident;)*) => {$(
        #[test]
        $(#[$long])?
        fn $name() {
            agree(&Robot::that_ships(stringify!($name)));
        }
    )*};
}
gives_the_bits_of_rust! {
    two_link;
    scara;
    panda_class;
    #[ignore = "a minute of compilers, for what the others show"]
    stanford;
    #[ignore = "a minute of compilers, for what the others show"]
    stanford_general;
    #[ignore = "a minute of compilers, for what the others show"]
    puma560;
    #[ignore = "a minute of compilers, for what the others show"]
    puma560_general;
    #[ignore = "a minute of compilers, for what the others show"]
    ur5_class;
    #[ignore = "a minute of compilers, for what the others show"]
    quadruped;
}

#[test]
fn fields_frames_and_functions_that_share_their_work() {
    agree(&Robot::with_fields());
}

#[test]
fn joints_with_quaternions_and_joints_that_follow_others() {
    agree(&Robot::with_every_kind_of_joint());
}

#[test]
fn a_robot_with_loops() {
    agree(&Robot::with_loops());
}

/// As standard output has them.
#[test]
fn header_and_source_are_one_text_where_one_follows_the_other() {
    let folder = Folder::new("whole");
    folder.write_c(&Robot::with_fields(), Real::F32);
    for compiler in C::all() {
        compiler.alone(&folder, &compiler.object(&folder, "whole.c", &[]));
    }
}

/// Their last bits are the machine's own.
#[test]
fn sines_of_the_platform() {
    let robot = Robot::that_ships("two_link");
    let folder = Folder::new("platform");
    let states = states::everyday(robot.inputs(), 100);
    let states = states::bytes(&states, Real::F64);
    let expected = states::numbers(&rust(&folder, &robot, Real::F64).run(&states));
    folder.write_c(&robot.with_platform_sines(), Real::F64);
    for compiler in C::that_run() {
        let object = compiler.object(&folder, "arm.c", &[]);
        let found = states::numbers(&compiler.program(&folder, &object).run(&states));
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            let error = (found - expected).abs();
            assert!(
                error < 1e-12 * (1.0 + expected.abs()),
                "{found}, not {expected}"
            );
        }
    }
}

#[test]
fn what_would_change_the_bits_is_refused() {
    let folder = Folder::new("refused");
    let associative = [
        "-fassociative-math",
        "-fno-signed-zeros",
        "-fno-trapping-math",
    ];
    for real in [Real::F32, Real::F64] {
        folder.write_c(&Robot::that_ships("two_link"), real);
        for compiler in C::that_run() {
            let said = compiler.refusal(&folder, &["-ffast-math"]);
            assert!(said.contains("compile without -ffast-math"), "{said}");
        }
        for compiler in C::all().iter().filter(|compiler| compiler.is_gcc()) {
            let said = compiler.refusal(&folder, &associative);
            assert!(said.contains("compile without -ffast-math"), "{said}");
        }
    }
}

/// Qualified as functions of a graphics processor are, which call each other and nothing else.
#[test]
fn it_is_code_for_a_gpu() {
    let folder = Folder::new("gpu");
    for real in [Real::F32, Real::F64] {
        folder.write_c(&Robot::that_ships("two_link"), real);
        let Some(text) = compilers::ptx(&folder) else {
            println!("not tested without a clang that has the target nvptx64");
            return;
        };
        assert!(
            text.contains(".visible .func arm_inverse_dynamics"),
            "{text}"
        );
        assert!(
            !text.contains(".extern") && !text.contains("fma."),
            "{text}"
        );
    }
}

/// Both files of a small robot, to be read.
#[test]
fn a_pendulum_with_a_field() {
    let source = Robot::pendulum().source(Real::F32);
    insta::assert_snapshot!(format!("{}\n{}", source.header, source.text));
}

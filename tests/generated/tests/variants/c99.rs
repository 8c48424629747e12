//! C files compared with the Rust file of the same robot, bit for bit, with every compiler that is installed.
//!
//! Both come from the same routine, printed independently. Each is compiled by itself with a program that reads states
//! and writes results, and runs as a process of its own.

mod compilers;
mod fused;
#[path = "../../long.rs"]
mod long;
mod midpoint;
mod programs;
mod robot;
mod states;

use homogen_codegen::{Function, Real};

use compilers::{C, Effort, Folder, rust};
use long::LONG;
use robot::Robot;

/// Compiles a robot in both languages and compares the results.
fn agree(robot: &Robot, effort: Effort) {
    agree_in(&[Real::F32, Real::F64], robot, effort);
}

/// The same in some types of numbers.
fn agree_in(types: &[Real], robot: &Robot, effort: Effort) {
    let options = effort.of_c();
    let states = states::nasty(robot.inputs(), effort.states());
    for &real in types {
        let folder = Folder::new(&format!("{}_{real:?}{}", robot.name, options.concat()));
        let states = states::bytes(&states, real);
        let expected = rust(&folder, robot, real, effort).run(&states);
        folder.write_c(robot, real);
        for compiler in C::all() {
            let object = compiler.object(&folder, "arm.c", options);
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
            agree(&Robot::shipped(stringify!($name)), Effort::Optimised);
        }
    )*};
}
gives_the_bits_of_rust! {
    two_link;
    scara;
    #[ignore = "a minute of compilers; other robots show the same"]
    panda_class;
    #[ignore = "a minute of compilers; other robots show the same"]
    stanford;
    #[ignore = "a minute of compilers; other robots show the same"]
    stanford_general;
    #[ignore = "a minute of compilers; other robots show the same"]
    puma560;
    #[ignore = "a minute of compilers; other robots show the same"]
    puma560_general;
    #[ignore = "a minute of compilers; other robots show the same"]
    ur5_class;
    #[ignore = "a minute of compilers; other robots show the same"]
    quadruped;
}

#[test]
fn fields_frames_and_functions_generated_together_give_the_bits_of_rust() {
    agree(&Robot::with_fields(), Effort::Optimised);
}

#[test]
fn quaternions_and_mimic_joints_give_the_bits_of_rust() {
    // The long functions of a smaller robot show the same, and the other type is compared every night.
    let is_compared = |function: &Function| !LONG.contains(function);
    let robot = Robot::with_quaternions(is_compared);
    agree_in(&[Real::F64], &robot, Effort::Quick);
    agree(&Robot::with_a_ball_joint(), Effort::Quick);
}

#[test]
fn a_robot_with_seven_joints_gives_the_bits_of_rust() {
    // The other type is compared every night.
    let robot = Robot::shipped("panda_class");
    agree_in(&[Real::F32], &robot, Effort::Quick);
}

#[test]
#[ignore = "a minute of compilers; unoptimised code shows the same"]
fn optimised_quaternions_and_mimic_joints_give_the_bits_of_rust() {
    agree(&Robot::with_quaternions(|_| true), Effort::Optimised);
}

#[test]
fn loops_give_the_bits_of_rust() {
    agree(&Robot::with_loops(), Effort::Optimised);
}

/// Functions compiled for several kinds of processor, one of which is chosen when the program starts.
#[test]
fn the_choice_of_a_processor_changes_no_bit() {
    chosen("scara");
}

#[test]
#[ignore = "a minute of compilers; a smaller robot shows the same"]
fn the_choice_of_a_processor_changes_no_bit_of_seven_joints() {
    chosen("panda_class");
}

/// Compares the results of a robot whose functions choose a processor with those in Rust.
fn chosen(robot: &str) {
    let robot = Robot::shipped(robot);
    let effort = Effort::Optimised;
    let states = states::nasty(robot.inputs(), effort.states());
    for real in [Real::F32, Real::F64] {
        let folder = Folder::new(&format!("{}_chosen_{real:?}", robot.name));
        let states = states::bytes(&states, real);
        let expected = rust(&folder, &robot, real, effort).run(&states);
        folder.write_c(&robot, real);
        for compiler in C::that_run() {
            let object = compiler.object(&folder, "arm.c", &["-DHOMOGEN_DISPATCH"]);
            assert_eq!(Folder::has_symbol(&object, "x86_64_v3"), compiler.clones());
            let found = compiler.program(&folder, &object).run(&states);
            let what = format!("{compiler} with a choice");
            states::same(&found, &expected, robot.outputs(), real, &what);
        }
    }
}

/// The command line prints them so to standard output.
#[test]
fn header_and_source_compile_as_one_text() {
    let folder = Folder::new("whole");
    folder.write_c(&Robot::with_fields(), Real::F32);
    for compiler in C::all() {
        compiler.alone(&folder, &compiler.object(&folder, "whole.c", &[]));
    }
}

/// Their last bits differ between machines.
#[test]
fn the_platforms_sines_give_the_numbers_of_rust() {
    let robot = Robot::shipped("two_link");
    let folder = Folder::new("platform");
    let states = states::everyday(robot.inputs(), 100);
    let states = states::bytes(&states, Real::F64);
    let expected =
        states::numbers(&rust(&folder, &robot, Real::F64, Effort::Optimised).run(&states));
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
fn options_that_change_the_bits_are_refused() {
    let folder = Folder::new("refused");
    let associative = [
        "-fassociative-math",
        "-fno-signed-zeros",
        "-fno-trapping-math",
    ];
    for real in [Real::F32, Real::F64] {
        folder.write_c(&Robot::shipped("two_link"), real);
        for compiler in C::that_run() {
            let message = compiler.refusal(&folder, &["-ffast-math"]);
            assert!(message.contains("compile without -ffast-math"), "{message}");
        }
        for compiler in C::all().iter().filter(|compiler| compiler.is_gcc()) {
            let message = compiler.refusal(&folder, &associative);
            assert!(message.contains("compile without -ffast-math"), "{message}");
        }
    }
}

/// Processors with numbers of half precision round those, too, and the others as before; x87 rounds none.
#[test]
fn numbers_must_be_rounded_to_their_types() {
    let folder = Folder::new("rounded");
    folder.write_c(&Robot::shipped("two_link"), Real::F64);
    let options = |method: &'static str| {
        let undefined = "-U__FLT_EVAL_METHOD__";
        ["-Wno-builtin-macro-redefined", undefined, method]
    };
    for compiler in C::all().iter().filter(|compiler| compiler.is_gcc()) {
        compiler.accept(&folder, &options("-D__FLT_EVAL_METHOD__=16"));
        let message = compiler.refusal(&folder, &options("-D__FLT_EVAL_METHOD__=2"));
        assert!(message.contains("-mfpmath=sse"), "{message}");
    }
}

/// With qualifiers of a graphics processor's functions, which call only each other.
#[test]
fn the_code_compiles_for_a_gpu() {
    let folder = Folder::new("gpu");
    for real in [Real::F32, Real::F64] {
        folder.write_c(&Robot::shipped("two_link"), real);
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

/// Both files of a small robot, for review.
#[test]
fn a_pendulum_with_a_field() {
    let source = Robot::pendulum().source(Real::F32);
    insta::assert_snapshot!(format!("{}\n{}", source.header, source.text));
}

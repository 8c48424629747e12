//! C for processors that fuse products with sums, compared bit for bit with its program run in numbers that round a
//! product and a sum once, with the runtime's sines on such processors.

use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Arithmetic, Input};
use homogen_codegen::real::Trigonometry;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::Variable;
use homogen_codegen::{Processor, Real};
use homogen_tests::tested::{Fused32, Fused64};

use crate::c99::compilers::{C, Folder};
use crate::c99::robot::Robot;
use crate::c99::states;

const STATES: usize = 1000;

/// The numbers of all results at all states, in the machine's bytes.
fn expected(robot: &Robot, real: Real, states: &[f64]) -> Vec<u8> {
    let request = Request {
        trigonometry: Trigonometry::Own,
        ..robot.request(real)
    };
    let module = expand(robot.description(), &request).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(
        module
            .functions
            .iter()
            .any(|generated| generated.operation_count.fused > 0)
    );
    let joints = robot.spaces.velocities.len();
    let mut bytes = Vec::new();
    for state in states.chunks_exact(robot.inputs()) {
        for generated in &module.functions {
            let input = |input: Input| match input {
                Input::Variable(variable, k) => {
                    let before = Variable::ALL.into_iter().position(|of| of == variable);
                    state[before.expect("one of them") * joints + usize::from(k)]
                }
                Input::Parameter(..) => panic!("it has no fields"),
            };
            match real {
                Real::F32 => {
                    let numbers = run(&generated.program, |of| Fused32::literal(input(of)));
                    bytes.extend(numbers.iter().flat_map(|one| one.0.to_ne_bytes()));
                }
                Real::F64 | Real::Generic => {
                    let numbers = run(&generated.program, |of| Fused64::literal(input(of)));
                    bytes.extend(numbers.iter().flat_map(|one| one.0.to_ne_bytes()));
                }
            }
        }
    }
    bytes
}

/// Compiler options that fuse: by the library's function on every machine, by the instruction if this machine has it.
fn options(real: Real) -> Vec<Vec<&'static str>> {
    let library = match real {
        Real::F32 => "-DHOMOGEN_FMAF=fmaf",
        Real::F64 | Real::Generic => "-DHOMOGEN_FMA=fma",
    };
    let mut options = vec![vec![library, "-include", "math.h"]];
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("fma") {
        options.push(vec!["-mfma"]);
    }
    #[cfg(target_arch = "aarch64")]
    options.push(vec![]);
    options
}

#[test]
fn c_for_fusing_processors_rounds_product_and_sum_once() {
    rounds_once("scara");
}

#[test]
#[ignore = "a minute of compilers; other robots show the same"]
fn c_of_seven_joints_rounds_product_and_sum_once() {
    rounds_once("panda_class");
}

fn rounds_once(name: &str) {
    let robot = Robot::shipped(name).on(Processor::X86_64V3);
    for real in [Real::F32, Real::F64] {
        let folder = Folder::new(&format!("fused_{name}_{real:?}"));
        folder.write_c(&robot, real);
        let states = states::everyday(robot.inputs(), STATES);
        let expected = expected(&robot, real, &states);
        let bytes = states::bytes(&states, real);
        for options in options(real) {
            for compiler in C::that_run() {
                let object = compiler.object(&folder, "arm.c", &options);
                let found = compiler.program(&folder, &object).run(&bytes);
                let what = format!("{compiler} {options:?}");
                states::same(&found, &expected, robot.outputs(), real, &what);
            }
        }
        for compiler in C::all() {
            compiler.alone(&folder, &compiler.object(&folder, "arm.c", &[]));
        }
    }
}

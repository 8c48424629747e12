//! A firmware that measures the C of CasADi like the controller.
//!
//! In: the functions by `report/peer` and a C compiler, which `build.rs` links by the variable `PEER`. Out: over
//! semihosting the bits of every result, and instructions and stack of every function, for `run.sh --peer`.
#![no_std]
#![no_main]

#[path = "../clock.rs"]
mod clock;
#[allow(dead_code, reason = "nothing but integers is reported here")]
#[path = "../report.rs"]
mod report;
#[path = "../stack.rs"]
mod stack;

use core::cell::Cell;
use core::hint::black_box;
use core::panic::PanicInfo;

use controller::{EVERYDAY, JOINTS, Joints, State, TRUSTED, states};
use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};

use clock::Clock;
use report::Line;

/// The length of the longest result, of an arm with six joints or more.
const LONGEST: usize = JOINTS * JOINTS;

/// Declares functions of `CasADi`: arguments, results, and work space, which these functions do not need.
macro_rules! peers {
    ($($name:ident)*) => {
        #[expect(unsafe_code, reason = "C has no types that could be checked")]
        // SAFETY: these are C's pointers to pointers to float, of which the functions read as many as
        // the arm has joints, and write as many as the result has; null is what they are given for
        // work space by `CasADi`'s own callers where they ask for none.
        unsafe extern "C" {
            $(safe fn $name(
                arguments: &[&Joints; 3],
                results: &[&Cell<[f32; LONGEST]>; 1],
                integers: Option<&Cell<i64>>,
                numbers: Option<&Cell<f32>>,
                memory: i32,
            ) -> i32;)*
        }
    };
}
peers! {
    peer_forward_kinematics peer_geometric_jacobian peer_gravity peer_inverse_dynamics
    peer_mass_matrix peer_forward_dynamics
}

#[entry]
fn main() -> ! {
    if let Some(clock) = Clock::start() {
        run(&clock);
        debug::exit(EXIT_SUCCESS);
    }
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

fn run(clock: &Clock) {
    examine("forward_kinematics", clock, 12, |arguments, results| {
        peer_forward_kinematics(arguments, results, None, None, 0)
    });
    examine(
        "geometric_jacobian",
        clock,
        6 * JOINTS,
        |arguments, results| peer_geometric_jacobian(arguments, results, None, None, 0),
    );
    examine("gravity", clock, JOINTS, |arguments, results| {
        peer_gravity(arguments, results, None, None, 0)
    });
    examine("inverse_dynamics", clock, JOINTS, |arguments, results| {
        peer_inverse_dynamics(arguments, results, None, None, 0)
    });
    examine(
        "mass_matrix",
        clock,
        JOINTS * JOINTS,
        |arguments, results| peer_mass_matrix(arguments, results, None, None, 0),
    );
    examine("forward_dynamics", clock, JOINTS, |arguments, results| {
        peer_forward_dynamics(arguments, results, None, None, 0)
    });
}

/// Prints results and costs of one function, over the states whose errors are measured: the least and the most
/// instructions of the realistic states, the most of all, and the depth of the stack.
fn examine(
    name: &str,
    clock: &Clock,
    length: usize,
    function: impl Fn(&[&Joints; 3], &[&Cell<[f32; LONGEST]>; 1]) -> i32,
) {
    let (mut least, mut most, mut worst, mut deepest) = (u32::MAX, 0, 0, 0);
    for (index, state) in states().iter().take(TRUSTED).enumerate() {
        let State {
            q, qd, qdd, tau, ..
        } = state;
        // The third argument of forward dynamics is the torques.
        let third = if name == "forward_dynamics" { tau } else { qdd };
        let arguments = [q, qd, third];
        let result = Cell::new([0.0; LONGEST]);
        let results = [&result];
        function(&arguments, &results);
        words(name, &result.get(), length);
        let call = || {
            black_box(function(black_box(&arguments), black_box(&results)));
        };
        deepest = deepest.max(stack::depth(call));
        let duration = clock.one(call);
        worst = worst.max(duration);
        if index < EVERYDAY {
            least = least.min(duration);
            most = most.max(duration);
        }
    }
    let mut line = Line::new();
    line.text("cost ").text(name);
    for count in [least, most, worst] {
        line.text(" ").integer(count);
    }
    line.text(" ").integer(deepest);
    line.print();
}

/// Prints the bits of a result, one line a number.
fn words(name: &str, result: &[f32], length: usize) {
    for number in result.iter().take(length) {
        let mut line = Line::new();
        line.text("result ").text(name);
        line.text(" ").integer(number.to_bits());
        line.print();
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

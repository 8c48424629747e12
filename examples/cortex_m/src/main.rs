//! The firmware: runs the controller over a table of states, and prints results and costs.
//!
//! In: [`states`], and the results of the host for them. Out: over semihosting torques, differences, instructions and
//! stack of every function, for `run.sh`; and a status, 0 if every bit is as expected and all calls of a function take
//! the same time.
#![no_std]
#![no_main]

mod clock;
mod expected;
mod function;
mod report;
mod stack;

use core::panic::PanicInfo;

use controller::{
    computed_torque, forward_dynamics, forward_kinematics, geometric_jacobian, gravity,
    inverse_dynamics, mass_matrix, states,
};
use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};

use clock::Clock;
use function::examine;
use report::Line;

#[entry]
fn main() -> ! {
    let passed = Clock::start().is_some_and(|clock| run(&clock));
    debug::exit(if passed { EXIT_SUCCESS } else { EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

/// True if everything is as expected.
fn run(clock: &Clock) -> bool {
    let states = states();
    for (i, state) in states.iter().enumerate() {
        torques("hold", i, &gravity(&state.q));
        torques("follow", i, &computed_torque(state));
    }
    let passed = [
        examine(
            "forward_kinematics",
            clock,
            &states,
            &expected::FORWARD_KINEMATICS,
            |state| forward_kinematics(&state.q),
        ),
        examine(
            "geometric_jacobian",
            clock,
            &states,
            &expected::GEOMETRIC_JACOBIAN,
            |state| geometric_jacobian(&state.q),
        ),
        examine("gravity", clock, &states, &expected::GRAVITY, |state| {
            gravity(&state.q)
        }),
        examine(
            "inverse_dynamics",
            clock,
            &states,
            &expected::INVERSE_DYNAMICS,
            |state| inverse_dynamics(&state.q, &state.qd, &state.qdd),
        ),
        examine(
            "computed_torque",
            clock,
            &states,
            &expected::COMPUTED_TORQUE,
            computed_torque,
        ),
        examine(
            "mass_matrix",
            clock,
            &states,
            &expected::MASS_MATRIX,
            |state| mass_matrix(&state.q),
        ),
        examine(
            "forward_dynamics",
            clock,
            &states,
            &expected::FORWARD_DYNAMICS,
            |state| forward_dynamics(&state.q, &state.qd, &state.tau),
        ),
    ];
    passed.iter().all(|passed| *passed)
}

fn torques(what: &str, state: usize, torques: &[f32]) {
    let mut line = Line::new();
    line.text(what).text(" ").integer(state);
    for torque in torques {
        line.text(" ").number(*torque);
    }
    line.print();
}

/// Never reached, and so never linked; `run.sh` checks this.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

//! The firmware: moves a simulated arm to a goal at 1 kHz, and prints the instructions of control steps.
//!
//! In: nothing. Out: over semihosting instructions, iterations and errors; a status, 0 if the goal is reached.
//! Run by QEMU with `-icount shift=0` an instruction lasts 1 ns, and the timer is exact to 40 instructions.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use cortex_m_semihosting::hprintln;
use mpc::arm::{GOAL, ITERATIONS, Joints, RATE, Reach, START, STEPS, linearised, simulated};

/// The processor of QEMU's board runs at 25 MHz of its time, 40 ns a step of the timer.
const PER_STEP: u32 = 40;
/// The largest count of the timer, 24 bits.
const FULL: u32 = 0x00ff_ffff;
/// Cycles of a core with 480 MHz in a millisecond.
const BUDGET: u32 = 480_000;

#[entry]
fn main() -> ! {
    let reached = Peripherals::take().is_some_and(|peripherals| {
        let mut timer = peripherals.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(FULL);
        timer.clear_current();
        timer.enable_counter();
        run()
    });
    debug::exit(if reached { EXIT_SUCCESS } else { EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

/// The result of a call, and its instructions.
fn timed<R>(call: impl FnOnce() -> R) -> (R, u32) {
    let start = SYST::get_current();
    let result = black_box(call());
    // The timer counts down.
    let steps = start.wrapping_sub(SYST::get_current()) & FULL;
    (result, steps * PER_STEP)
}

/// The largest magnitude.
fn largest(numbers: impl Iterator<Item = f32>) -> f32 {
    numbers.fold(0.0, |most, x| most.max(x.abs()))
}

/// Instructions or iterations of control steps.
#[derive(Default)]
struct Count {
    sum: u32,
    most: u32,
}

impl Count {
    fn add(&mut self, value: u32) {
        self.sum += value;
        self.most = self.most.max(value);
    }
}

/// True if the arm reaches the goal.
fn run() -> bool {
    let (_, linearisation) = timed(|| linearised(black_box(&GOAL)));
    let (reach, preparation) = timed(|| Reach::new(black_box(&GOAL)));
    let Some(mut reach) = reach else {
        hprintln!("the gain is not found");
        return false;
    };
    hprintln!("A and B: {} instructions", linearisation);
    hprintln!("A, B and the gain: {} instructions", preparation);

    let (mut q, mut qd): (Joints, Joints) = (START, [0.0; 7]);
    let (mut instructions, mut iterations) = (Count::default(), Count::default());
    let mut fastest: f32 = 0.0;
    for _ in 0..STEPS {
        let ((tau, found), taken) = timed(|| reach.torques(black_box(&q), &qd, ITERATIONS));
        instructions.add(taken);
        iterations.add(found.iterations);
        let next = simulated(&q, &qd, &tau);
        (q, qd) = (next.q, next.qd);
        fastest = fastest.max(largest(qd.into_iter()));
    }
    hprintln!(
        "a control step: {} instructions on average, {} at most, in {} iterations at most",
        instructions.sum / u32::from(STEPS),
        instructions.most,
        iterations.most
    );
    hprintln!(
        "an iteration: {} instructions",
        instructions.sum / iterations.sum
    );
    hprintln!(
        "at 1 kHz a core with 480 MHz has {} cycles a step: {} of a hundred at one instruction a cycle",
        BUDGET,
        100 * instructions.most / BUDGET
    );
    let off = largest(q.iter().zip(&GOAL).map(|(q, goal)| q - goal));
    hprintln!(
        "largest rate {:.3} rad/s, limit {:.3}; {:.6} rad from the goal",
        fastest,
        RATE,
        off
    );
    off < 1e-3
}

/// A mistake of this program ends it with a status.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

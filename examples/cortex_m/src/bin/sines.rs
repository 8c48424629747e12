//! A firmware that compares sines: those of a generated file, those of the runtime for angles of any size, those of
//! `libm`, and those of a user.
//!
//! In: angles. Out: over semihosting, for each function the least and the largest number of instructions of a call.
//! `libm` computes single precision in double, by routines of the compiler if the processor has no double precision;
//! its time depends on the angle.
#![no_std]
#![no_main]

#[path = "../clock.rs"]
mod clock;
#[allow(dead_code, reason = "nothing but integers is reported here")]
#[path = "../report.rs"]
mod report;

use core::hint::black_box;
use core::panic::PanicInfo;

use controller::sines;
use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use homogen::trigonometry::single;

use clock::Clock;
use report::Line;

/// Angles of joints, and larger ones.
const ANGLES: [f32; 12] = [
    0.0, 0.1, -0.7, 1.5, -2.2, 3.1, 4.0, -5.5, 7.0, 30.0, -400.0, 3000.0,
];

#[entry]
fn main() -> ! {
    if let Some(clock) = Clock::start() {
        compare(&clock);
        debug::exit(EXIT_SUCCESS);
    }
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

fn compare(clock: &Clock) {
    say(clock, "own", own);
    say(clock, "any", any);
    say(clock, "libm", libm);
    say(clock, "user", user);
}

fn say(clock: &Clock, name: &str, function: impl Fn(f32) -> (f32, f32)) {
    let (mut least, mut most) = (u32::MAX, 0);
    for angle in &ANGLES {
        let duration = clock.one(|| {
            black_box(function(*black_box(angle)));
        });
        least = least.min(duration);
        most = most.max(duration);
    }
    let mut line = Line::new();
    line.text("sines ").text(name);
    line.text(" ").integer(least).text(" ").integer(most);
    line.print();
}

/// The same text as in a generated file, whose function is private.
#[inline(never)]
fn own(angle: f32) -> (f32, f32) {
    single::sin_cos_moderate(angle)
}

#[inline(never)]
fn any(angle: f32) -> (f32, f32) {
    single::sin_cos(angle)
}

#[inline(never)]
fn libm(angle: f32) -> (f32, f32) {
    libm::sincosf(angle)
}

#[inline(never)]
fn user(angle: f32) -> (f32, f32) {
    sines::quick(angle)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    debug::exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}

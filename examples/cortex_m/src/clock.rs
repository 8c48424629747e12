//! The duration of calls, by the system timer of the Cortex-M.
//!
//! In: a call. Out: its duration, in instructions under QEMU and in cycles on a board. A thousand calls are timed, so
//! that the timer's step is negligible, and the cost of the loop is subtracted.

use core::sync::atomic::{Ordering, compiler_fence};

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// The processors of QEMU's boards run at 25 MHz, and `-icount shift=0` makes an instruction last
/// 1 ns. A board's timer steps once a cycle: there this is 1.
const PER_STEP: u32 = 40;

/// Number of repetitions of a call.
const CALLS: u32 = 1000;

/// The cost of a call of [`nothing`]: a branch, `nop`, and the return.
const NOTHING: u32 = 3;

/// The largest count of the timer, 24 bits.
const FULL: u32 = 0x00ff_ffff;

/// The running timer.
pub struct Clock(());

impl Clock {
    /// Starts the timer; `None` if it is running already.
    pub fn start() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(FULL);
        timer.clear_current();
        timer.enable_counter();
        Some(Self(()))
    }

    /// The duration of one call, from its branch to its return.
    #[expect(clippy::unused_self, reason = "proof that the timer runs")]
    pub fn one(&self, call: impl Fn()) -> u32 {
        let calls = thousand(call).wrapping_sub(thousand(nothing)) * PER_STEP;
        // Rounded, because the first and the last step of the timer are incomplete.
        (calls + CALLS / 2) / CALLS + NOTHING
    }
}

/// The number of timer steps during a thousand calls; the timer counts down.
#[inline(never)]
fn thousand(call: impl Fn()) -> u32 {
    let start = SYST::get_current();
    compiler_fence(Ordering::SeqCst);
    for _ in 0..CALLS {
        call();
    }
    compiler_fence(Ordering::SeqCst);
    start.wrapping_sub(SYST::get_current()) & FULL
}

/// The call to compare with.
#[inline(never)]
fn nothing() {
    cortex_m::asm::nop();
}

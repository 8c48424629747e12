//! How long calls take, by the timer that every Cortex-M has.
//!
//! In: a call. Out: its duration, in instructions under QEMU and in cycles on a board. It counts a
//! thousand calls, so that the timer's step does not show, and takes off what the loop costs.

use core::sync::atomic::{Ordering, compiler_fence};

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// The processors of QEMU's boards run at 25 MHz, and `-icount shift=0` makes an instruction last
/// 1 ns. A board's timer steps once a cycle: there this is 1.
const PER_STEP: u32 = 40;

/// How often a call is repeated.
const CALLS: u32 = 1000;

/// The call of [`nothing`]: a branch, `nop`, and the way back.
const NOTHING: u32 = 3;

/// The largest count of the timer, 24 bits.
const FULL: u32 = 0x00ff_ffff;

/// The timer, running.
pub struct Clock(());

impl Clock {
    /// Starts the timer; none the second time.
    pub fn start() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(FULL);
        timer.clear_current();
        timer.enable_counter();
        Some(Self(()))
    }

    /// The duration of one call, from its branch to its return.
    pub fn one(&self, call: impl Fn()) -> u32 {
        let calls = self.thousand(call).wrapping_sub(self.thousand(nothing)) * PER_STEP;
        // Rounded: the timer's first and last steps are partly others'.
        (calls + CALLS / 2) / CALLS + NOTHING
    }

    /// The timer's steps during a thousand calls; it counts down.
    #[inline(never)]
    fn thousand(&self, call: impl Fn()) -> u32 {
        let start = SYST::get_current();
        compiler_fence(Ordering::SeqCst);
        for _ in 0..CALLS {
            call();
        }
        compiler_fence(Ordering::SeqCst);
        start.wrapping_sub(SYST::get_current()) & FULL
    }
}

/// The call to compare with.
#[inline(never)]
fn nothing() {
    cortex_m::asm::nop();
}

//! The arm's functions for C: the generated file, and nothing of one's own.
//!
//! In: nothing. Out: the static library `libarm.a`, whose header the build script writes.
#![no_std]

include!(concat!(env!("OUT_DIR"), "/arm.rs"));

/// Never reached; a library without a standard library must still have one.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

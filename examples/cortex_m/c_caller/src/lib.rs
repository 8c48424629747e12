//! The arm's functions for C: only the generated file. The build script writes the header of the static library
//! `libarm.a`.
#![no_std]

include!(concat!(env!("OUT_DIR"), "/arm.rs"));

/// Never reached; required without a standard library.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

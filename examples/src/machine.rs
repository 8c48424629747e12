//! Where and with what a program runs.
//!
//! In: nothing. Out: a line to stand beside every time that is printed.

use std::fs;

/// The compiler and its version.
pub const COMPILER: &str = env!("EXAMPLES_RUSTC");

/// Processor, compiler and flags.
#[must_use]
pub fn describe() -> String {
    format!("{} · {COMPILER} · {}", processor(), env!("EXAMPLES_FLAGS"))
}

/// The processor's own name, and how many threads it offers.
#[must_use]
pub fn processor() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{}, {cores} of its threads", processor_name())
}

/// The processor's own name where the system tells it, else its architecture.
#[must_use]
pub fn processor_name() -> String {
    let told = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = told.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split_once(':'));
    name.map_or(std::env::consts::ARCH, |(_, name)| name.trim())
        .to_owned()
}

//! Processor, compiler and flags of a program, as a line that is printed beside its times.

use std::fs;

/// The compiler and its version.
pub const COMPILER: &str = env!("EXAMPLES_RUSTC");

/// Processor, compiler and flags.
#[must_use]
pub fn describe() -> String {
    format!("{} · {COMPILER} · {}", processor(), env!("EXAMPLES_FLAGS"))
}

/// The processor's name and its number of threads.
#[must_use]
pub fn processor() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!("{}, {cores} of its threads", processor_name())
}

/// The processor's name if the system reports it, otherwise its architecture.
#[must_use]
pub fn processor_name() -> String {
    let reported = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let line = reported.lines().find(|line| line.starts_with("model name"));
    let name = line.and_then(|line| line.split_once(':'));
    name.map_or(std::env::consts::ARCH, |(_, name)| name.trim())
        .to_owned()
}

//! Fuzzing: feeds damaged descriptions to the readers and reports the outcomes.
//!
//! `cargo run -p homogen-tests --bin fire -- [--long] [--seed N] [--from N] [--only N]`, not in release, since only
//! debug builds detect integer overflow.
//!
//! In: a seed; 10,000 inputs, or 100,000 with `--long`. Out: how many were refused, understood and expanded, the
//! longest time, the largest memory, and every input with a fault (a panic, or too much time or memory) with its
//! number; exit status of failure if there is one. `--only N` prints one input before it is read.
//!
//! Linux reports the time on the processor and the peak of memory. On other systems the time is that of the clock,
//! and memory is not measured.

use std::fs;
use std::panic;
use std::process::ExitCode;
use std::thread;
use std::time::Instant;

use homogen_tests::fire::{Input, Outcome, attempt, input};

/// Limits for one input, in seconds and bytes.
const SECONDS: f64 = 2.0;
const BYTES: u64 = 200 << 20;

/// Stack of the thread that reads: smaller than the default of a main thread.
const STACK: usize = 1 << 20;

struct Arguments {
    count: u64,
    seed: u64,
    from: u64,
    only: Option<u64>,
}

impl Arguments {
    fn read() -> Result<Self, String> {
        let mut arguments = Self {
            count: 10_000,
            seed: 1,
            from: 0,
            only: None,
        };
        let mut words = std::env::args().skip(1);
        while let Some(word) = words.next() {
            let mut number = || {
                let next = words.next().and_then(|number| number.parse().ok());
                next.ok_or_else(|| format!("{word} needs a number"))
            };
            match word.as_str() {
                "--long" => arguments.count = 100_000,
                "--seed" => arguments.seed = number()?,
                "--from" => arguments.from = number()?,
                "--only" => arguments.only = Some(number()?),
                other => return Err(format!("there is no option {other}")),
            }
        }
        Ok(arguments)
    }
}

fn main() -> ExitCode {
    let arguments = match Arguments::read() {
        Ok(arguments) => arguments,
        Err(message) => {
            eprintln!("error: {message}");
            return ExitCode::from(2);
        }
    };
    if arguments.only.is_none() {
        // A panic is printed with the input that caused it.
        panic::set_hook(Box::new(|_| {}));
    }
    let thread = thread::Builder::new().stack_size(STACK);
    let fired = thread.spawn(move || fire(&arguments));
    match fired.map(thread::JoinHandle::join) {
        Ok(Ok(true)) => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}

/// True if no input had a fault.
fn fire(arguments: &Arguments) -> bool {
    let mut outcomes = [0_u32; 3];
    let mut faults = 0_u32;
    let (mut longest, mut largest) = ((0.0, 0), (0, 0));
    let numbers = match arguments.only {
        Some(only) => only..only + 1,
        None => arguments.from..arguments.count,
    };
    for number in numbers {
        if number % 1000 == 0 {
            eprintln!("from {number} on");
        }
        let input = input(arguments.seed, number);
        if arguments.only.is_some() {
            show(&input);
        }
        let before = memory(true);
        let start = Clock::start();
        let outcome = attempt(arguments.seed, number, &input);
        let seconds = start.seconds();
        let bytes = memory(false).saturating_sub(before);
        if seconds > longest.0 {
            longest = (seconds, number);
        }
        if bytes > largest.0 {
            largest = (bytes, number);
        }
        let fault = match outcome {
            Err(fault) => Some(fault),
            Ok(_) if seconds > SECONDS => Some(format!("took {seconds:.1} s")),
            Ok(_) if bytes > BYTES => Some(format!("took {} MB", bytes >> 20)),
            Ok(outcome) => {
                outcomes[outcome as usize] += 1;
                None
            }
        };
        if let Some(fault) = fault {
            faults += 1;
            let fault: String = fault.chars().take(2000).collect();
            println!("{number} ({:?}): {fault}", input.language);
        }
    }
    let [refused, expanded, understood] =
        [Outcome::Refused, Outcome::Expanded, Outcome::Understood]
            .map(|outcome| outcomes[outcome as usize]);
    println!("{refused} refused, {understood} understood, {expanded} expanded, {faults} faults");
    println!("longest {:.2} s (input {})", longest.0, longest.1);
    println!("largest {} MB (input {})", largest.0 >> 20, largest.1);
    faults == 0
}

fn show(input: &Input) {
    println!(
        "{:?}\n{}",
        input.language,
        String::from_utf8_lossy(&input.bytes)
    );
}

/// Measures the thread's time on the processor, or else the time of the clock.
struct Clock {
    wall: Instant,
    processor: Option<u64>,
}

impl Clock {
    fn start() -> Self {
        Self {
            wall: Instant::now(),
            processor: processor_time(),
        }
    }

    fn seconds(&self) -> f64 {
        match (self.processor, processor_time()) {
            (Some(start), Some(end)) => std::time::Duration::from_nanos(end - start).as_secs_f64(),
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

/// Nanoseconds that this thread has spent on the processor; `None` where that is unknown.
fn processor_time() -> Option<u64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split(' ').next()?.parse().ok()
}

/// Memory of the process in bytes: the present one if `reset`, which also resets the peak; otherwise the peak since
/// then. 0 where that is unknown.
fn memory(reset: bool) -> u64 {
    if reset && fs::write("/proc/self/clear_refs", "5").is_err() {
        return 0;
    }
    let key = if reset { "VmRSS:" } else { "VmHWM:" };
    let text = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(key));
    let kilobytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok());
    kilobytes.unwrap_or(0) << 10
}

//! Times per call of some programs, measured side by side.
//!
//! In: batches of calls, one a program. Out: median and quartiles of the time per call of each. The batches take
//! turns, so that a clock that drifts or a neighbour that wakes up meets all alike; only their
//! ratios should be carried to another machine.

use std::time::{Duration, Instant};

/// The spread of the time per call, in ns.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// A quarter of the batches took less.
    pub lower: f64,
    /// Half of them did.
    pub median: f64,
    /// A quarter took more.
    pub upper: f64,
}

/// Runs all in turns, `batches` times each. A batch repeats its `calls` until it takes at least
/// `shortest`, so that reading the clock does not count. One that takes less than [`SLOW`] is run once
/// before the clock starts, for what the programs before it leave of its states and its code in the
/// caches is not its time.
pub fn alternate(
    batches: usize,
    calls: u32,
    shortest: Duration,
    programs: &[&dyn Fn()],
) -> Vec<Spread> {
    let turns: Vec<Turn> = programs.iter().map(|run| turn(run, shortest)).collect();
    let mut times = vec![Vec::with_capacity(batches); programs.len()];
    for _ in 0..batches {
        for ((batch, turn), times) in programs.iter().zip(&turns).zip(&mut times) {
            if turn.warm {
                batch();
            }
            let calls = f64::from(turn.repeats) * f64::from(calls);
            times.push(time(batch, turn.repeats).as_secs_f64() * 1e9 / calls);
        }
    }
    times.into_iter().map(spread).collect()
}

/// A batch that takes this long takes a hundred times what its states take to come from memory: some
/// hundred kB, at some 10 GB/s.
pub const SLOW: Duration = Duration::from_millis(5);

/// How a program's turn goes.
struct Turn {
    /// How often its batch is run on the clock.
    repeats: u32,
    /// Whether it is run once before.
    warm: bool,
}

/// Repeats a batch until it takes long enough.
fn turn(batch: &dyn Fn(), shortest: Duration) -> Turn {
    let warm = time(batch, 1) < SLOW;
    let mut repeats = 1;
    while time(batch, repeats) < shortest {
        repeats *= 2;
    }
    Turn { repeats, warm }
}

fn time(batch: &dyn Fn(), repeats: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..repeats {
        batch();
    }
    start.elapsed()
}

fn spread(mut times: Vec<f64>) -> Spread {
    times.sort_by(f64::total_cmp);
    let at = |quarter: usize| times[(times.len() - 1) * quarter / 4];
    Spread {
        lower: at(1),
        median: at(2),
        upper: at(3),
    }
}

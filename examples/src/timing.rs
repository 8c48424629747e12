//! Times per call of some programs, measured side by side.
//!
//! In: batches of calls, one a program. Out: median and quartiles of the time per call of each. The batches take
//! turns, so that a drifting clock or other load affects all of them. Only ratios are comparable between
//! machines.

use std::time::{Duration, Instant};

/// The spread of the time per call, in ns.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Lower quartile.
    pub lower: f64,
    /// Median.
    pub median: f64,
    /// Upper quartile.
    pub upper: f64,
}

/// Runs all programs in turns, `batches` times each. A batch repeats its `calls` until it takes at least
/// `shortest`, so that reading the clock is negligible. A batch that takes less than [`SLOW`] is run once before
/// the clock starts, because the other programs evict its states and code from the caches.
pub fn alternate(
    batches: usize,
    calls: u32,
    shortest: Duration,
    programs: &[&dyn Fn()],
) -> Vec<Spread> {
    let settings: Vec<Settings> = programs
        .iter()
        .map(|run| settings_of(run, shortest))
        .collect();
    let mut times = vec![Vec::with_capacity(batches); programs.len()];
    for _ in 0..batches {
        for ((batch, settings), times) in programs.iter().zip(&settings).zip(&mut times) {
            if settings.warm {
                batch();
            }
            let calls = f64::from(settings.repeats) * f64::from(calls);
            times.push(time(batch, settings.repeats).as_secs_f64() * 1e9 / calls);
        }
    }
    times.into_iter().map(spread).collect()
}

/// The duration of a batch from which no warm run is needed: a hundred times the transfer of its states from
/// memory, some hundred kB at some 10 GB/s.
pub const SLOW: Duration = Duration::from_millis(5);

/// Repetitions of a batch in each turn.
struct Settings {
    /// Number of runs of the batch on the clock.
    repeats: u32,
    /// True if it is run once before the clock starts.
    warm: bool,
}

/// Doubles the repetitions until they take at least `shortest`.
fn settings_of(batch: &dyn Fn(), shortest: Duration) -> Settings {
    let warm = time(batch, 1) < SLOW;
    let mut repeats = 1;
    while time(batch, repeats) < shortest {
        repeats *= 2;
    }
    Settings { repeats, warm }
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

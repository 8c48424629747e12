//! A progress line on the terminal: after a second, the elapsed time and the share of the work. Other streams are not
//! written to, and the line is removed at the end.

use std::io::{IsTerminal, Write, stderr};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Shows progress until it is dropped.
pub(super) struct Progress {
    counted: Arc<Counted>,
    running: Option<(Sender<()>, JoinHandle<()>)>,
}

/// Numbers of all and of finished states.
#[derive(Default)]
struct Counted {
    done: AtomicUsize,
    all: AtomicUsize,
}

impl Progress {
    pub(super) fn start() -> Self {
        let counted = Arc::new(Counted::default());
        let running = stderr().is_terminal().then(|| {
            let (sender, receiver) = channel();
            let counted = Arc::clone(&counted);
            (sender, spawn(move || show(&receiver, &counted)))
        });
        Self { counted, running }
    }

    /// Sets the number of states.
    pub(super) fn of(&self, states: usize) {
        self.counted.all.store(states, Ordering::Relaxed);
    }

    /// Adds finished states.
    pub(super) fn add(&self, states: usize) {
        self.counted.done.fetch_add(states, Ordering::Relaxed);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.running.take() {
            drop(sender);
            // A failed progress line is not an error.
            let _ = thread.join();
        }
    }
}

/// Counts the seconds until the other end of the channel is closed.
fn show(receiver: &Receiver<()>, counted: &Counted) {
    let start = Instant::now();
    let mut shown = false;
    while receiver.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
        let _ = write!(
            stderr(),
            "\r{}\x1b[K",
            counted.line(start.elapsed().as_secs())
        );
        let _ = stderr().flush();
        shown = true;
    }
    if shown {
        // To the beginning of the line, and clear it.
        let _ = write!(stderr(), "\r\x1b[K");
    }
}

impl Counted {
    /// The text after `seconds`.
    fn line(&self, seconds: u64) -> String {
        let (done, all) = (
            self.done.load(Ordering::Relaxed),
            self.all.load(Ordering::Relaxed),
        );
        match all {
            0 => format!("working, {seconds} s"),
            _ => format!("{done} of {all} states, {seconds} s"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_counted_where_there_are_some() {
        let counted = Counted::default();
        assert_eq!(counted.line(3), "working, 3 s");
        counted.all.store(20, Ordering::Relaxed);
        counted.done.fetch_add(7, Ordering::Relaxed);
        assert_eq!(counted.line(4), "7 of 20 states, 4 s");
    }
}

//! A line that says that the program is still at work.
//!
//! In: nothing. Out: after a second, on a terminal, the time that has passed. It never touches a
//! stream that is not a terminal, and leaves no trace.

use std::io::{IsTerminal, Write, stderr};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Shows progress until it is dropped.
pub(super) struct Progress {
    running: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    pub(super) fn start() -> Self {
        let running = stderr().is_terminal().then(|| {
            let (sender, receiver) = channel();
            (sender, spawn(move || show(&receiver)))
        });
        Self { running }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((sender, thread)) = self.running.take() {
            drop(sender);
            // A line that could not be shown is no reason to fail.
            let _ = thread.join();
        }
    }
}

/// Counts the seconds until the other end of the channel is gone.
fn show(receiver: &Receiver<()>) {
    let start = Instant::now();
    let mut shown = false;
    while receiver.recv_timeout(Duration::from_secs(1)) == Err(RecvTimeoutError::Timeout) {
        let _ = write!(stderr(), "\rworking, {} s", start.elapsed().as_secs());
        let _ = stderr().flush();
        shown = true;
    }
    if shown {
        // To the beginning of the line, and clear it.
        let _ = write!(stderr(), "\r\x1b[K");
    }
}

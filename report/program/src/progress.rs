//! A bar that says how far the work is.
//!
//! In: how many steps there are, and each step as it is done. Out: one line on standard error, on a
//! terminal; a line a stage elsewhere.

use std::io::{IsTerminal, Write, stderr};
use std::time::Instant;

/// Steps done of steps to do.
pub struct Progress {
    done: usize,
    steps: usize,
    start: Instant,
    terminal: bool,
}

const WIDTH: usize = 30;

impl Progress {
    /// Nothing done yet.
    pub fn new(steps: usize) -> Self {
        Self {
            done: 0,
            steps,
            start: Instant::now(),
            terminal: stderr().is_terminal(),
        }
    }

    /// Says what begins now.
    pub fn stage(&self, what: &str) {
        if self.terminal {
            self.show(what);
        } else {
            eprintln!("{:4} s  {what}", self.start.elapsed().as_secs());
        }
    }

    /// One more step is done.
    pub fn advance(&mut self, what: &str) {
        self.done += 1;
        if self.terminal {
            self.show(what);
        }
    }

    fn show(&self, what: &str) {
        let full = (WIDTH * self.done / self.steps.max(1)).min(WIDTH);
        let bar = "█".repeat(full) + &"░".repeat(WIDTH - full);
        let seconds = self.start.elapsed().as_secs();
        // To the beginning of the line, and clear what is left of the last one.
        let _ = write!(stderr(), "\r{bar} {seconds:3} s  {what}\x1b[K");
        let _ = stderr().flush();
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.terminal {
            let _ = write!(stderr(), "\r\x1b[K");
        }
    }
}

//! A progress bar.
//!
//! In: the number of steps, and each finished step. Out: one line on standard error if it is a terminal, otherwise a
//! line for each stage.

use std::io::{IsTerminal, Write, stderr};
use std::time::Instant;

/// Number of finished steps and of all steps.
pub struct Progress {
    done: usize,
    steps: usize,
    start: Instant,
    terminal: bool,
}

const WIDTH: usize = 30;

impl Progress {
    /// No step finished.
    pub fn new(steps: usize) -> Self {
        Self {
            done: 0,
            steps,
            start: Instant::now(),
            terminal: stderr().is_terminal(),
        }
    }

    /// Shows the name of a new stage.
    pub fn stage(&self, what: &str) {
        if self.terminal {
            self.show(what);
        } else {
            eprintln!("{:4} s  {what}", self.start.elapsed().as_secs());
        }
    }

    /// Counts a finished step.
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
        // Carriage return, and clear the rest of the line.
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

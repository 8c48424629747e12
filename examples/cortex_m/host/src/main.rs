//! What the controller should compute, and whether its image is what it should be.
//!
//! `host expected` writes the results that the firmware compares its own with, `host states` the
//! states for C.
//! `host judge FOLDER…` reads what was seen of each board's firmware, and prints a table or what is
//! wrong, `host budget FOLDER…` the budget lowered to that; `host sines FOLDER…` prints the table of
//! the firmware that compares sines. It never builds or runs anything itself.

mod arm;
mod budget;
mod c_states;
mod error;
mod expected;
mod image;
mod judge;
mod magnitude;
mod sines;

use std::env;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args().skip(1).collect();
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    let answer = match &*arguments {
        ["expected"] => Ok(expected::text()),
        ["states"] => Ok(c_states::text()),
        ["judge", arm, budget, boards @ ..] => judge::judge(arm, budget, boards),
        ["budget", arm, budget, boards @ ..] => judge::lowered(arm, budget, boards),
        ["sines", boards @ ..] => sines::table(boards),
        _ => Err(
            "usage: host expected | host states | host (judge | budget) ARM BUDGET FOLDER... | host sines FOLDER..."
                .to_owned(),
        ),
    };
    match answer {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(wrong) => {
            eprintln!("{wrong}");
            ExitCode::FAILURE
        }
    }
}

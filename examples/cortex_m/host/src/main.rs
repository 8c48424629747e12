//! What the controller should compute, and whether its image is what it should be.
//!
//! `host expected` writes the results that the firmware compares its own with, `host states` the
//! states for C.
//! `host judge FOLDER…` reads what was seen of each board's firmware, and prints a table or what is
//! wrong, `host budget FOLDER…` the budget lowered to that; `host sines FOLDER…` prints the table of
//! the firmware that compares sines, `host peer FOLDER BOARD…` the one beside the peer, `host c99 FOLDER
//! BOARD…` the one of the generated C. It never builds or runs anything itself.

mod arm;
mod budget;
mod c99;
mod c_states;
mod error;
mod expected;
mod image;
mod judge;
mod peer;
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
        ["peer", arm, seen, boards @ ..] => {
            peer::table(arm, seen, boards).map(|[table, behind]| {
                // The table goes to a file of all arms, and this to the one who reads what comes of it.
                eprint!("{behind}");
                table
            })
        }
        ["c99", arm, seen, boards @ ..] => c99::table(arm, seen, boards),
        ["sines", boards @ ..] => sines::table(boards),
        _ => Err(
            "usage: host expected | host states | host (judge | budget) ARM BUDGET FOLDER... | \
             host sines FOLDER... | host (peer | c99) ARM FOLDER BOARD..."
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

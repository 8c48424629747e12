//! Expected results of the controller, and checks of its image. It does not build or run firmware.
//!
//! | command | output |
//! |---|---|
//! | `host expected` | the results for the firmware to compare with |
//! | `host states` | the states for C |
//! | `host judge FOLDER…` | a table of the observations of each board's firmware, or the errors |
//! | `host budget FOLDER…` | the budget, lowered to these observations |
//! | `host sines FOLDER…` | the table of the firmware that compares sines |
//! | `host peer FOLDER BOARD…` | the table beside the C of CasADi |
//! | `host c99 FOLDER BOARD…` | the table of the generated C |

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
                // The table goes to a file of all arms, this to the terminal.
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

//! The binary `homogen`.
//!
//! In: arguments and standard streams. Out: an exit code. Everything else is in
//! [`homogen_cli`], so that tests can call it.

use std::process::ExitCode;

fn main() -> ExitCode {
    homogen_cli::run(
        std::env::args_os(),
        &mut std::io::stdin().lock(),
        &mut std::io::stdout().lock(),
        // Not locked: the line that shows progress is written from another thread.
        &mut std::io::stderr(),
    )
}

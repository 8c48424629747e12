//! The binary `homogen`. Everything else is in [`homogen_cli`], so that tests can call it.

use std::process::ExitCode;

fn main() -> ExitCode {
    homogen_cli::run(
        std::env::args_os(),
        &mut std::io::stdin().lock(),
        &mut std::io::stdout().lock(),
        // Not locked, because another thread writes the progress.
        &mut std::io::stderr(),
    )
}

//! `homogen completions`: the completion script of a shell, generated from the options of all commands.

use clap::{Args, Command};
use clap_complete::{Shell, generate};

use super::{Answer, Outcome};

/// Write the script by which a shell completes commands and options
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen completions bash > ~/.local/share/bash-completion/completions/homogen
  homogen completions zsh > ~/.zfunc/_homogen
  homogen completions fish > ~/.config/fish/completions/homogen.fish")]
pub(super) struct Completions {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

impl Completions {
    #[expect(
        clippy::unnecessary_wraps,
        reason = "a command can fail, though this one does not"
    )]
    pub(super) fn run(&self, program: &mut Command) -> Outcome {
        let mut script = Vec::new();
        generate(self.shell, program, "homogen", &mut script);
        Ok(Answer {
            output: String::from_utf8_lossy(&script).into_owned(),
            ..Answer::default()
        })
    }
}

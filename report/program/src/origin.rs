//! Date and commit of a report.
//!
//! In: the folder of the repository. Out: the UTC date, and the commit, as `date` and `git` print them.

use std::path::Path;
use std::process::Command;

/// Date and commit of a measurement.
pub struct Origin {
    /// The UTC date, as `2026-01-31`.
    pub date: String,
    /// The short hash of the commit, followed by "with changes" if files differ from it.
    pub commit: String,
}

impl Origin {
    /// Today, and the commit of a repository.
    pub fn of(root: &Path) -> Self {
        let unknown = || "unknown".to_owned();
        Self {
            date: printed(Command::new("date").args(["-u", "+%F"])).unwrap_or_else(unknown),
            commit: commit(root).unwrap_or_else(unknown),
        }
    }
}

/// The commit; files that reports write are not counted as changes.
fn commit(root: &Path) -> Option<String> {
    let git = |arguments: &[&str]| printed(Command::new("git").arg("-C").arg(root).args(arguments));
    let hash = git(&["rev-parse", "--short=8", "HEAD"])?;
    let measured = [".", ":!report/*.md", ":!report/*.svg"];
    let changes = git(&[&["status", "--porcelain", "--"][..], &measured].concat())?;
    Some(if changes.is_empty() {
        hash
    } else {
        hash + ", with changes"
    })
}

/// The output of a command that succeeds.
fn printed(command: &mut Command) -> Option<String> {
    let output = command.output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    output.status.success().then_some(text)
}

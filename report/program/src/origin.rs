//! Date and commit of a report.
//!
//! In: the folder of the repository. Out: the UTC date, and the commit that git reports.

use std::path::Path;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

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
        let now = SystemTime::now().duration_since(UNIX_EPOCH);
        Self {
            date: date(now.map_or(0, |elapsed| elapsed.as_secs() / 86_400)),
            commit: commit(root),
        }
    }
}

/// The commit; files that reports write are not counted as changes.
fn commit(root: &Path) -> String {
    let git = |arguments: &[&str]| {
        let mut command = Command::new("git");
        let output = command.arg("-C").arg(root).args(arguments).output().ok()?;
        let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
        output.status.success().then_some(text)
    };
    let Some(hash) = git(&["rev-parse", "--short=8", "HEAD"]) else {
        return "unknown".to_owned();
    };
    let measured = [".", ":!report/*.md", ":!report/*.svg"];
    match git(&[&["status", "--porcelain", "--"][..], &measured].concat()) {
        Some(changes) if changes.is_empty() => hash,
        _ => hash + ", with changes",
    }
}

/// The date of a number of days after 1970-01-01, in the Gregorian calendar. Years are counted from March, so that
/// February 29 is their last day.
fn date(days: u64) -> String {
    const DAYS_OF_400_YEARS: u64 = 146_097;
    let days = days + 719_468; // since 0000-03-01
    let (era, day) = (days / DAYS_OF_400_YEARS, days % DAYS_OF_400_YEARS);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153; // from March = 0
    let (day, month, next) = match month {
        0..10 => (day - (153 * month + 2) / 5 + 1, month + 3, 0),
        _ => (day - (153 * month + 2) / 5 + 1, month - 9, 1),
    };
    format!("{:04}-{month:02}-{day:02}", 400 * era + year + next)
}

#[cfg(test)]
mod tests {
    #[test]
    fn dates_are_those_of_the_calendar() {
        for (days, date) in [
            (0, "1970-01-01"),
            (59, "1970-03-01"),
            (11_016, "2000-02-29"),
            (11_017, "2000-03-01"),
            (20_453, "2025-12-31"),
            (20_454, "2026-01-01"),
        ] {
            assert_eq!(super::date(days), date);
        }
    }
}

//! The checks of the firmware on every board.
//!
//! In: for each board a folder with `log` (the output of the firmware), `symbols` and `code` (its image), and the budget.
//! Out: the rows of a table, or all errors.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use crate::budget::{Budget, Cost};
use crate::error;
use crate::image::{self, Functions};

/// The functions in the order of the table.
const FUNCTIONS: [&str; 8] = [
    "forward_kinematics",
    "geometric_jacobian",
    "gravity",
    GRAVITY_ALONE,
    "inverse_dynamics",
    "computed_torque",
    "mass_matrix",
    "forward_dynamics",
];

/// The row of `gravity` with the text of the sines, as in a firmware with this function only.
const GRAVITY_ALONE: &str = "gravity_and_sines";

/// The largest allowed error, in units of rounding.
const ERROR: f64 = 20.0;

/// The largest difference between the instructions of a call and those of the function, for loading arguments.
const ARGUMENTS: u32 = 8;

/// Checks the boards with observations in `folders`, each with the name of its board.
///
/// # Errors
/// All errors, a line each.
pub fn judge(arm: &str, budget: &str, folders: &[&str]) -> Result<String, String> {
    let budget = Budget::read(&read(Path::new(budget))?, arm)?;
    let mut wrong = Vec::new();
    let boards = observe(&budget, folders, &mut wrong)?;
    let mut table = String::new();
    for function in FUNCTIONS {
        let known = error::FUNCTIONS.contains(&function);
        let error =
            known.then(|| error::worst(function, |_, state| error::controller(function, state)));
        // NaN does not pass.
        if error.is_some_and(|error| error.is_nan() || error > ERROR) {
            wrong.push(format!("{function} is off by {error:?} units of rounding"));
        }
        row(&mut table, arm, function, &boards, error);
    }
    unless(&wrong, table)
}

/// The arm's lines of the budget, lowered to the costs of the boards in `folders`.
///
/// # Errors
/// All errors, a line each.
pub fn lowered(arm: &str, budget: &str, folders: &[&str]) -> Result<String, String> {
    let budget = Budget::read(&read(Path::new(budget))?, arm)?;
    let mut wrong = Vec::new();
    let boards = observe(&budget, folders, &mut wrong)?;
    let lines = FUNCTIONS.map(|function| {
        let costs = boards.iter().map(|board| board.cost(function));
        budget.lowered(arm, function, costs.reduce(Cost::max).unwrap_or_default())
    });
    unless(&wrong, lines.concat())
}

fn observe(
    budget: &Budget,
    folders: &[&str],
    wrong: &mut Vec<String>,
) -> Result<Vec<Board>, String> {
    let boards = folders
        .iter()
        .map(|folder| Board::observe(Path::new(folder), budget, wrong));
    boards.collect()
}

fn unless(wrong: &[String], answer: String) -> Result<String, String> {
    if wrong.is_empty() {
        Ok(answer)
    } else {
        Err(wrong.join("\n"))
    }
}

fn row(table: &mut String, arm: &str, function: &str, boards: &[Board], error: Option<f64>) {
    let cell = |number: fn(&Cost) -> u32| {
        let cells = boards
            .iter()
            .map(|board| number(&board.cost(function)).to_string());
        cells.collect::<Vec<_>>().join(" / ")
    };
    let error = error.map_or_else(|| "–".to_owned(), |error| format!("{error:.1}"));
    // Writing to a string cannot fail.
    let _ = writeln!(
        table,
        "| {arm} | `{function}` | {} | {} | {} | {error} |",
        cell(|cost| cost.instructions),
        cell(|cost| cost.text),
        cell(|cost| cost.stack),
    );
}

/// The observations of one board.
pub struct Board {
    functions: Functions,
    log: String,
}

impl Board {
    /// Reads a folder; errors of the image are appended to `wrong`.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn read(folder: &Path, wrong: &mut Vec<String>) -> Result<Self, String> {
        let [log, symbols, code] = ["log", "symbols", "code"].map(|file| read(&folder.join(file)));
        let functions = image::read(&symbols?, &code?, wrong);
        let log = log?;
        Ok(Self { functions, log })
    }

    fn observe(folder: &Path, budget: &Budget, wrong: &mut Vec<String>) -> Result<Self, String> {
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        let mut here = Vec::new();
        let board = Self::read(folder, &mut here)?;
        for function in FUNCTIONS {
            if function != GRAVITY_ALONE {
                board.check(function, &mut here);
            }
            budget.check(&name, function, board.cost(function), &mut here);
        }
        wrong.extend(here.into_iter().map(|what| format!("{name}: {what}")));
        Ok(board)
    }

    /// Adds an error unless the bits are those of the host, and every call takes the instructions of the image.
    fn check(&self, function: &str, wrong: &mut Vec<String>) {
        match *self.reported("differences", function) {
            [0] => {}
            [different] => wrong.push(format!(
                "{function}: {different} results are not the host's"
            )),
            _ => wrong.push(format!(
                "{function}: no results in the output of the firmware"
            )),
        }
        let &[least, most, _] = &*self.reported("cost", function) else {
            wrong.push(format!("{function}: no cost in the output of the firmware"));
            return;
        };
        if least != most {
            wrong.push(format!(
                "{function}: from {least} to {most} instructions a call"
            ));
        }
        // Plus the branch to it.
        let listed = image::instructions(&self.functions, function) + 1;
        if !(listed..=listed + ARGUMENTS).contains(&most) {
            wrong.push(format!(
                "{function}: {listed} instructions are listed, {most} were counted"
            ));
        }
    }

    /// The cost of a function.
    pub fn cost(&self, function: &str) -> Cost {
        if function == GRAVITY_ALONE {
            let gravity = self.cost("gravity");
            let text = gravity.text + self.text("sin_cos");
            return Cost { text, ..gravity };
        }
        let cost = self.reported("cost", function);
        Cost {
            instructions: cost.get(1).copied().unwrap_or_default(),
            text: self.text(function),
            stack: cost.get(2).copied().unwrap_or_default(),
        }
    }

    /// The instructions of sines and cosines in a call, without calls and returns.
    pub fn inside_sines(&self, function: &str) -> u32 {
        let calls = self.functions.get(function).map_or(0, |function| {
            let calls = function.calls.iter().filter(|name| *name == "sin_cos");
            u32::try_from(calls.count()).unwrap_or_default()
        });
        calls * image::instructions(&self.functions, "sin_cos").saturating_sub(1)
    }

    fn text(&self, function: &str) -> u32 {
        let function = self.functions.get(function);
        function.map_or(0, |function| function.bytes)
    }

    /// The numbers of the line that begins with these words.
    pub fn reported(&self, what: &str, function: &str) -> Vec<u32> {
        let start = format!("{what} {function} ");
        let line = self.log.lines().find_map(|line| line.strip_prefix(&start));
        let numbers = line.unwrap_or_default().split_whitespace();
        numbers.filter_map(|number| number.parse().ok()).collect()
    }
}

/// The text of a file.
pub fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|reason| format!("cannot read {}: {reason}", path.display()))
}

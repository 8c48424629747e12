//! `homogen check`: how a description is read.
//!
//! Prints the order of q, the modelled links, and what was merged, locked, left out or read as a right angle; and every
//! warning with line and column.

use std::fmt::Write;
use std::io::Read;

use clap::Args;

use super::options::{Asked, Format, Robot};
use super::{Answer, Outcome, json, options};
use homogen_codegen::chain::{Chain, Report};
use homogen_codegen::expand::{self, configurations};
use homogen_codegen::module::NamedConfiguration;
use homogen_codegen::request::setting::FRAMES;
use homogen_codegen::wording::visible;
use homogen_page::diagnostics::line_and_column;
use homogen_page::report::{described, report, root, tip};

/// Print what was read, merged, locked, left out or read as exact, and every warning with its place
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen check arm.urdf --tip tool0 --format json")]
pub(super) struct Check {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    frames: Asked<FRAMES>,
    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

impl Check {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let description = self.robot.description(input)?;
        let request = self.frames.and(self.robot.request());
        let chain = expand::understand(&description, &request)?;
        let output = match self.format {
            Format::Text => in_text(&chain),
            Format::Json => json::answer(report(&chain)),
        };
        Ok(Answer {
            output,
            ..Answer::default()
        })
    }
}

/// A multiple of π/2 in words.
fn meant(quarters: i64) -> String {
    let sign = if quarters < 0 { "−" } else { "" };
    match (quarters.unsigned_abs(), quarters % 2 == 0) {
        (0, _) => "0".to_owned(),
        (1, _) => format!("{sign}π/2"),
        (2, _) => format!("{sign}π"),
        (turns, true) => format!("{sign}{} π", turns / 2),
        (turns, false) => format!("{sign}{turns} π/2"),
    }
}

/// The constraints of loops, and those that always hold.
fn loops(chain: &Chain, line: &mut impl FnMut(String)) {
    for closed in &chain.loops {
        let [from, to] = closed.frames.each_ref().map(|frame| &frame.name);
        let rows: Vec<String> = (closed.rows.iter())
            .map(|row| row.name(&closed.name))
            .collect();
        let (name, kind, rows) = (&closed.name, closed.word, rows.join(", "));
        line(format!(
            "loop {name}: {kind}, joins {from} and {to}: {rows}"
        ));
    }
    if !chain.report.closed.is_empty() {
        let names = chain.report.closed.join(", ");
        line(format!("  hold in every configuration: {names}"));
    }
    if !chain.report.dependent.is_empty() {
        let names = chain.report.dependent.join(", ");
        line(format!(
            "  implied by the others if the loops are closed: {names}"
        ));
    }
}

/// `1 joint`, `2 joints`.
fn counted(number: usize, one: &str, several: &str) -> String {
    match number {
        1 => format!("1 {one}"),
        _ => format!("{number} {several}"),
    }
}

/// Numbers that were read as right angles and zeros.
fn repaired(report: &Report, line: &mut impl FnMut(String)) {
    let (right_angles, residues) = report.right_angles_and_residues();
    line(counted(
        right_angles,
        "angle read as a right angle",
        "angles read as right angles",
    ));
    if residues > 0 {
        line(counted(
            residues,
            "residue read as zero",
            "residues read as zero",
        ));
    }
    for number in &report.snapped {
        let (row, column) = line_and_column(number.place);
        let (item, written, meant) = (&number.item, number.written, meant(number.quarters));
        line(format!("  {row}:{column}: {written} of {item} is {meant}"));
    }
    for quaternion in &report.turned {
        let (row, column) = line_and_column(quaternion.place);
        let written = quaternion.written.map(|entry| entry.to_string()).join(" ");
        let meant = quaternion.squares.map(root).join(" ");
        let item = &quaternion.item;
        line(format!("  {row}:{column}: {written} of {item} is {meant}"));
    }
}

fn in_text(chain: &Chain) -> String {
    let description = &chain.description;
    let report = &chain.report;
    let mut text = String::new();
    let mut line = |line: String| {
        text.push_str(&visible(&line));
        text.push('\n');
    };
    let from = match &description.source.file {
        Some(file) => format!(" from {file}"),
        None => String::new(),
    };
    line(format!("robot {}{from}", description.name.text));
    if let Some(format) = description.source.format {
        line(format!("format {}", format.name()));
    }
    line(format!("base {}", report.base));
    match tip(chain) {
        Some(tip) => line(format!("tip {tip}")),
        None => line("no tip: there is more than one end, and --tip is missing".to_owned()),
    }
    let joints = counted(report.joints.len(), "joint", "joints");
    line(format!("{joints}, in the order of q:"));
    let mut k = 0;
    for (joint, mass) in described(chain) {
        let (parent, child) = (&joint.parent.text, &joint.child.text);
        let (name, kind) = (&joint.name.text, joint.kind.word());
        let names = joint.kind.coordinates(name).into_iter();
        let names: Vec<String> = names.map(|(name, _)| name).collect();
        let mimic_of = report.mimicked.iter().find(|mimic| mimic.joint == *name);
        let coordinates = match (mimic_of, &*names) {
            (Some(mimic), _) => {
                let offset = match mimic.offset {
                    0.0 => String::new(),
                    offset => format!(" + {offset}"),
                };
                format!(" ({} of {}{offset})", mimic.multiplier, mimic.mimicked)
            }
            (None, [_]) => String::new(),
            (None, names) => format!(" ({})", names.join(", ")),
        };
        let plane = report.planes.iter().find(|plane| plane.joint == *name);
        let plane = plane.map_or(String::new(), |plane| format!(", {}", plane.text()));
        let place = match mimic_of {
            Some(_) => "   ".to_owned(),
            None => format!("{k:3}"),
        };
        line(format!(
            "  {place}  {name}: {kind}{coordinates}{plane}, from {parent} to {child}, carries {mass} kg"
        ));
        k += if mimic_of.is_some() { 0 } else { names.len() };
    }
    for NamedConfiguration { name, q } in configurations(chain) {
        let q: Vec<String> = q.iter().map(f64::to_string).collect();
        line(format!("configuration {name}: {}", q.join(" ")));
    }
    loops(chain, &mut line);
    line(counted(
        report.links.len(),
        "link modelled",
        "links modelled",
    ));
    line(counted(report.merged.len(), "link merged", "links merged"));
    for (link, into) in &report.merged {
        line(format!("  {link} into {into}"));
    }
    line(counted(
        report.locked.len(),
        "joint locked",
        "joints locked",
    ));
    for (joint, at) in &report.locked {
        line(format!("  {joint} at {at}"));
    }
    line(counted(
        report.dropped.len(),
        "link left out",
        "links left out",
    ));
    for link in &report.dropped {
        line(format!("  {link}"));
    }
    repaired(report, &mut line);
    line(counted(report.warnings.len(), "warning", "warnings"));
    let _ = write!(text, "{}", options::warnings(chain));
    text
}

#[cfg(test)]
mod tests;

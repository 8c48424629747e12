//! Tables as text files.
//!
//! Reads a [`Description`] from a line with the convention, a line with the names of columns, and a line for each
//! joint, from base to end effector. Lengths are in metres, angles in radians, and `pi/2` is an exact right angle.
//! Inertias are about the centre of mass, in the axes of the row's frame. `#` begins a comment, and `-` is an empty
//! cell. A missing convention is an error.
//!
//! ```text
//! convention modified
//! joint     kind      a  alpha  d     theta  mass  cx   cy cz  ixx  ixy ixz iyy  iyz izz
//! shoulder  revolute  0  0      0.4   0      3.2   0.1  0  0   0.1  0   0   0.1  0   0.1
//! tool      fixed     0  pi/2   0.1   0      -
//! ```

use proc_macro2::Span;

use super::rows::{Convention, Row, assemble};
use crate::description::fingerprint::fingerprint;
use crate::description::kind;
use crate::description::number::{self, Refusal};
use crate::description::position::Positions;
use crate::description::{
    Description, FileFormat, Inertial, Limits, Name, Number, Source, Step, Unmodelled, constant,
    names,
};
use crate::error::{Errors, Place};
use crate::joint::JointKind;
use crate::wording::{known, list, quoted};

/// The columns; the first [`REQUIRED`] are required.
pub(in crate::description) const COLUMNS: [&str; 21] = [
    "joint", "kind", "a", "alpha", "d", "theta", "pitch", "link", "lower", "upper", "velocity",
    "mass", "cx", "cy", "cz", "ixx", "ixy", "ixz", "iyy", "iyz", "izz",
];

/// Number of required columns.
const REQUIRED: usize = 6;

/// Maximum number of rows, which bounds memory.
const MOST_ROWS: usize = 10_000;

/// Maximum number of lines, including empty ones.
const MOST_LINES: usize = 100_000;

/// Hint for missing names of columns.
const HEADER: &str = "name the columns first: joint kind a alpha d theta";

/// A word of a line, with its place.
#[derive(Clone, Copy)]
struct Cell<'t> {
    text: &'t str,
    place: Place,
}

/// Reads the text of the table `file`; `anchor` is the token that named the file.
///
/// A description returned together with errors is partial.
pub fn read(
    text: &str,
    file: &str,
    anchor: Option<Span>,
    errors: &mut Errors,
) -> Option<Description> {
    errors.set_file(file, anchor);
    let positions = Positions::new(text.strip_prefix('\u{feff}').unwrap_or(text));
    let mut convention = None;
    let mut columns: Option<Vec<&str>> = None;
    let mut rows = Vec::new();
    if let Some((offset, _)) = positions.text().match_indices('\n').nth(MOST_LINES) {
        let message = format!("the table has more than {MOST_LINES} lines");
        errors.push(positions.place(offset), message);
        return None;
    }
    let mut joints = 0;
    for cells in lines_of(&positions) {
        let first = cells[0];
        if first.text == "convention" {
            if convention.is_some() {
                errors.push(first.place, "the convention is named twice");
            }
            convention = Some(read_convention(&cells, errors));
        } else if let Some(columns) = &columns {
            joints += 1;
            if joints > MOST_ROWS {
                let message = format!("the table has more than {MOST_ROWS} rows");
                errors.push(first.place, message);
                return None;
            }
            rows.extend(row(columns, &cells, errors));
        } else {
            columns = Some(read_columns(&cells, errors)?);
        }
    }
    if columns.is_none() {
        errors.push_with_hint(Place::Unknown, "the table has no columns", HEADER);
        return None;
    }
    let Some(convention) = convention else {
        errors.push_with_hint(
            Place::Unknown,
            "the table names no convention",
            "write a line: convention modified, or convention standard",
        );
        return None;
    };
    let start = Place::File { line: 1, column: 1 };
    let (links, joints) = assemble(convention, rows, start);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let description = Description {
        name: Name {
            text: if matches!(stem, "" | "-") {
                "robot"
            } else {
                stem
            }
            .to_owned(),
            place: Place::Unknown,
        },
        source: Source {
            file: Some(file.to_owned()),
            format: Some(FileFormat::Table),
            anchor,
            hash: fingerprint(text.as_bytes()),
            ..Source::default()
        },
        links,
        joints,
        loops: Vec::new(),
        configurations: Vec::new(),
        collisions: Vec::new(),
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    };
    names::check(&description, errors);
    Some(description)
}

/// The words of each line that has some; at most one word more than a row may have.
fn lines_of<'t>(positions: &Positions<'t>) -> impl Iterator<Item = Vec<Cell<'t>>> {
    let text = positions.text();
    let mut end = 0;
    text.split_inclusive('\n').filter_map(move |line| {
        let start = end;
        end += line.len();
        let line = line.split('#').next().unwrap_or_default();
        let mut rest = 0;
        let cells: Vec<_> = line
            .split_whitespace()
            .take(COLUMNS.len() + 1)
            .map(|word| {
                let offset = rest + line[rest..].find(word).unwrap_or(0);
                rest = offset + word.len();
                Cell {
                    text: word,
                    place: positions.place(start + offset),
                }
            })
            .collect();
        (!cells.is_empty()).then_some(cells)
    })
}

fn read_convention(cells: &[Cell<'_>], errors: &mut Errors) -> Convention {
    let (name, place) = match cells {
        [_, name] => (name.text, name.place),
        [word, ..] => ("", word.place),
        [] => ("", Place::Unknown),
    };
    Convention::from_name(name).unwrap_or_else(|(message, hint)| {
        if name.is_empty() {
            let hint = "write convention modified, or convention standard";
            errors.push_with_hint(place, "expected one convention", hint);
        } else {
            errors.push_with_hint(place, message, hint);
        }
        Convention::Modified
    })
}

/// The names of the columns; `None` if the line has none.
fn read_columns<'t>(cells: &[Cell<'t>], errors: &mut Errors) -> Option<Vec<&'t str>> {
    let columns: Vec<&str> = cells.iter().map(|cell| cell.text).collect();
    if !columns.contains(&"joint") {
        errors.push_with_hint(cells[0].place, "this line has no names of columns", HEADER);
        return None;
    }
    for (n, cell) in cells.iter().enumerate() {
        if !COLUMNS.contains(&cell.text) {
            errors.push_with_hint(
                cell.place,
                format!("unknown column {}", quoted(cell.text)),
                known(cell.text, "columns", &COLUMNS),
            );
        } else if columns[..n].contains(&cell.text) {
            let message = format!("column {} occurs twice", quoted(cell.text));
            errors.push(cell.place, message);
        }
    }
    let missing: Vec<&str> = COLUMNS[..REQUIRED]
        .iter()
        .copied()
        .filter(|column| !columns.contains(column))
        .collect();
    if !missing.is_empty() {
        let noun = if missing.len() == 1 {
            "column"
        } else {
            "columns"
        };
        let message = format!("the table lacks the {noun} {}", list(missing));
        errors.push_with_hint(cells[0].place, message, HEADER);
    }
    Some(columns)
}

/// State of the reader in a row.
struct RowReader<'r, 't> {
    columns: &'r [&'t str],
    cells: &'r [Cell<'t>],
    subject: String,
    errors: &'r mut Errors,
}

/// Reads a row; `None` if its name or type is missing or wrong.
fn row(columns: &[&str], cells: &[Cell<'_>], errors: &mut Errors) -> Option<Row> {
    let mut reader = RowReader {
        columns,
        cells,
        subject: String::new(),
        errors,
    };
    let Some(joint) = reader.cell("joint").map(name) else {
        let message = "the joint of this row has no name";
        reader.errors.push(cells[0].place, message);
        return None;
    };
    reader.subject = format!("joint {}", quoted(&joint.text));
    if let Some(extra) = cells.get(columns.len()) {
        let message = format!(
            "the row of {} has more than {} cells",
            reader.subject,
            columns.len()
        );
        reader.errors.push(extra.place, message);
    }
    let kind = reader.kind(joint.place);
    let [a, alpha, d, theta] = ["a", "alpha", "d", "theta"].map(|column| {
        let number = reader.number(column);
        if number.is_none() && reader.columns.contains(&column) && reader.cell(column).is_none() {
            let message = format!("{} has no {column}", reader.subject);
            reader.errors.push(joint.place, message);
        }
        number.unwrap_or_else(|| number::computed(0.0, joint.place))
    });
    let inertial = reader.inertial(joint.place);
    let limits = reader.limits();
    Some(Row {
        link: reader.cell("link").map(name),
        joint,
        kind: kind?,
        a,
        alpha,
        d,
        theta,
        inertial,
        limits,
    })
}

fn name(cell: Cell<'_>) -> Name {
    Name {
        text: cell.text.to_owned(),
        place: cell.place,
    }
}

impl<'t> RowReader<'_, 't> {
    /// The cell of a column; `None` if it is `-` or missing.
    fn cell(&self, column: &str) -> Option<Cell<'t>> {
        let index = self.columns.iter().position(|name| *name == column)?;
        self.cells
            .get(index)
            .copied()
            .filter(|cell| cell.text != "-")
    }

    fn refuse(&mut self, column: &str, place: Place, refusal: &Refusal) {
        let message = format!("{column} of {} {}", self.subject, refusal.what);
        match refusal.hint {
            Some(hint) => self.errors.push_with_hint(place, message, hint),
            None => self.errors.push(place, message),
        }
    }

    /// The number in a column; `None` if it is empty or malformed.
    fn number(&mut self, column: &str) -> Option<Number> {
        let cell = self.cell(column)?;
        constant::read(cell.text, cell.place)
            .map_err(|refusal| self.refuse(column, cell.place, &refusal))
            .ok()
    }

    fn kind(&mut self, place: Place) -> Option<JointKind> {
        let Some(cell) = self.cell("kind") else {
            if self.columns.contains(&"kind") {
                let message = format!("{} has no kind", self.subject);
                self.errors.push(place, message);
            }
            return None;
        };
        match kind::of_one_axis(cell.text, &self.subject) {
            Ok(kind) => kind
                .with_pitch(|| {
                    if self.cell("pitch").is_none() {
                        let message = format!("{} has no pitch", self.subject);
                        let hint = "add a column pitch, in metres per radian";
                        self.errors.push_with_hint(cell.place, message, hint);
                    }
                    self.number("pitch").ok_or(())
                })
                .ok(),
            Err((message, hint)) => {
                self.errors.push_with_hint(cell.place, message, hint);
                None
            }
        }
    }

    fn inertial(&mut self, place: Place) -> Option<Inertial> {
        const CENTER: [&str; 3] = ["cx", "cy", "cz"];
        const TENSOR: [&str; 6] = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
        let given = |column: &&str| self.cell(column).is_some();
        let count = TENSOR.iter().filter(|column| given(column)).count();
        let Some(cell) = self.cell("mass") else {
            if count > 0 || CENTER.iter().any(given) {
                let message = format!("the link of {} has an inertia but no mass", self.subject);
                self.errors.push(place, message);
            }
            return None;
        };
        if count < TENSOR.len() {
            let message = format!("the link of {} has a mass but no inertia", self.subject);
            let hint = "fill the columns ixx to izz, with zeros for a point mass";
            self.errors.push_with_hint(cell.place, message, hint);
        }
        let mass = self.number("mass");
        if let Some(mass) = mass
            && mass.value < 0.0
        {
            let message = format!("mass of {} is negative: {}", self.subject, mass.value);
            self.errors.push(mass.place, message);
        }
        let zero = number::computed(0.0, cell.place);
        let center = CENTER.map(|column| self.number(column).unwrap_or(zero));
        let tensor = TENSOR.map(|column| self.number(column).unwrap_or(zero));
        Some(Inertial {
            origin: vec![Step::Translate(center)],
            mass: mass?,
            inertia: tensor,
            place: cell.place,
        })
    }

    fn limits(&mut self) -> Option<Limits> {
        let place = self.cell("lower").or(self.cell("upper"));
        let place = place.or(self.cell("velocity"))?.place;
        let mut bound = |column: &str, otherwise: f64| {
            let Some(cell) = self.cell(column) else {
                return otherwise;
            };
            let read = number::read_bound(cell.text)
                .or_else(|_| constant::read(cell.text, cell.place).map(|number| number.value));
            read.unwrap_or_else(|refusal| {
                self.refuse(column, cell.place, &refusal);
                otherwise
            })
        };
        let lower = bound("lower", f64::NEG_INFINITY);
        let upper = bound("upper", f64::INFINITY);
        let velocity = bound("velocity", f64::INFINITY);
        if lower > upper {
            let subject = &self.subject;
            let message =
                format!("the lower limit of {subject}, {lower}, is above the upper one, {upper}");
            self.errors.push(place, message);
        }
        Some(Limits {
            lower,
            upper,
            velocity,
            effort: f64::INFINITY,
        })
    }
}

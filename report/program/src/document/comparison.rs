//! Both builds of a function beside the fastest other program.
//!
//! In: all measurements. Out: rows of a table with times, their ratios and errors, for the page and the details.

use std::fmt::Write;

use homogen_codegen::Function;

use super::cells::{fastest, find, in_units, precise_time};
use super::{Measured, many};
use crate::many::{FUNCTION, Many, OTHERS, name_of};
use crate::measure::Point;
use crate::peers::{MAKERS, title};
use crate::program::Flags;
use crate::scene::{Scalar, Scene, Variant};

/// The largest accepted ratio of the times without flags and native, of functions that take [`LONG`].
pub const BAR: f64 = 1.15;
/// The shortest time for which the bar holds \[ns\].
pub const LONG: f64 = 40.0;

/// The head of the table.
pub const HEAD: &str = "\
| robot | function | ours, without flags | ours, native | fastest other | its time | without flags / other | native / other | error, ours [u] | error, other [u] |
|---|---|---:|---:|---|---:|---:|---:|---:|---:|
";

/// A function of a robot in `f64`, on one thread.
pub struct Comparison<'a> {
    robot: &'a str,
    function: String,
    without_flags: Option<&'a Point>,
    native: Option<&'a Point>,
    other: Option<&'a Point>,
}

impl<'a> Comparison<'a> {
    /// One state a call.
    pub fn of(measured: &Measured<'a>, scene: &'a Scene, function: Function) -> Self {
        let name = Variant::DEFAULT.name;
        let ours = |flags| find(measured, scene, function, name, Scalar::F64, flags);
        let others = MAKERS
            .into_iter()
            .filter_map(|maker| fastest(measured, scene, function, maker, Scalar::F64));
        Self {
            robot: &scene.title,
            function: function.name().to_owned(),
            without_flags: ours(Flags::Without),
            native: ours(Flags::Native),
            other: faster(others),
        }
    }

    /// Many states a call; times are those of a state.
    pub fn of_many(many: &'a Many<'a>, scene: &'a Scene) -> Self {
        let ours = |flags| many::fastest(many, scene, false, Scalar::F64, flags);
        let others = OTHERS
            .iter()
            .filter_map(|other| many.find(scene, other.name, false, Scalar::F64, Flags::Native));
        Self {
            robot: &scene.title,
            function: format!("{}_batch", FUNCTION.name()),
            without_flags: ours(Flags::Without),
            native: ours(Flags::Native),
            other: faster(others),
        }
    }

    /// True if the bar of flags holds for it.
    pub fn is_long(&self) -> bool {
        self.native.is_some_and(|point| point.time[1] > LONG)
    }

    /// Time without flags / native.
    pub fn of_flags(&self) -> Option<f64> {
        Some(self.without_flags?.time[1] / self.native?.time[1])
    }

    /// Time of ours / time of the fastest other program.
    pub fn of_others(&self, flags: Flags) -> Option<f64> {
        let ours = match flags {
            Flags::Without => self.without_flags,
            Flags::Native => self.native,
        };
        Some(ours?.time[1] / self.other?.time[1])
    }

    /// Its row.
    pub fn row(&self) -> String {
        let ratio = |ratio: Option<f64>| ratio.map_or_else(dash, |ratio| format!("{ratio:.2}"));
        let error = |point: Option<&Point>| {
            point.map_or_else(dash, |point| in_units(point.worst / (f64::EPSILON / 2.0)))
        };
        let mut row = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(
            row,
            "| {} | `{}` | {} | {} | {} | {} | {} | {} | {} | {} |",
            self.robot,
            self.function,
            precise_time(self.without_flags),
            precise_time(self.native),
            self.other.map_or("–", |point| title(name_of(point))),
            precise_time(self.other),
            ratio(self.of_others(Flags::Without)),
            ratio(self.of_others(Flags::Native)),
            error(self.native),
            error(self.other),
        );
        row
    }
}

/// Number of comparisons with functions that take [`LONG`], the largest ratio of flags among them, and the largest
/// ratios to other programs of all.
pub fn in_short(comparisons: &[Comparison<'_>]) -> String {
    let largest = |ratios: &mut dyn Iterator<Item = f64>| ratios.reduce(f64::max);
    let long: Vec<_> = comparisons.iter().filter(|one| one.is_long()).collect();
    let mut text = String::new();
    if let Some(ratio) = largest(&mut long.iter().filter_map(|one| one.of_flags())) {
        let slow = long.iter().filter_map(|one| one.of_flags());
        let slow = slow.filter(|ratio| *ratio > BAR).count();
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "- Without flags / native: at most {ratio:.2} among the {} functions above {LONG} ns; the bar is {BAR}, {}.",
            long.len(),
            if slow == 0 {
                "met by all".to_owned()
            } else {
                format!("exceeded by {slow}")
            },
        );
    }
    for (flags, title) in [(Flags::Without, "Without flags"), (Flags::Native, "Native")] {
        let ratios = || comparisons.iter().filter_map(|one| one.of_others(flags));
        if let Some(ratio) = largest(&mut ratios()) {
            let compared = ratios().count();
            let _ = writeln!(
                text,
                "- {title} / fastest other program: at most {ratio:.2} among the {compared} functions that others have."
            );
        }
    }
    text
}

fn faster<'a>(points: impl Iterator<Item = &'a Point>) -> Option<&'a Point> {
    points.min_by(|a, b| a.time[1].total_cmp(&b.time[1]))
}

fn dash() -> String {
    "–".to_owned()
}

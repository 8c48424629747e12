//! The cells of the tables.
//!
//! In: all measurements, and a program. Out: its operation count or its measurement, and the text of a time and an error;
//! a dash if there is none.

use homogen_codegen::Function;
use homogen_codegen::schedule::OperationCount;

use super::Measured;
use crate::measure::Point;
use crate::program::Flags;
use crate::scene::{Scalar, Scene};

/// The operation count of a program.
pub fn operation_count(
    measured: &Measured<'_>,
    scene: &Scene,
    variant: &str,
    function: Function,
) -> OperationCount {
    let mut operation_counts = measured.operation_counts.iter();
    let found = operation_counts
        .find(|(name, v, f, _)| *name == scene.name && *v == variant && *f == function);
    found
        .map(|(.., operation_count)| *operation_count)
        .unwrap_or_default()
}

/// The measurement of a homogen program.
pub fn find<'a>(
    measured: &Measured<'a>,
    scene: &Scene,
    function: Function,
    variant: &str,
    scalar: Scalar,
    flags: Flags,
) -> Option<&'a Point> {
    measured.points.iter().find(|point| {
        point.scene == scene.name
            && point.function == function
            && point.key.variant == variant
            && point.key.scalar == scalar
            && point.key.flags == flags
    })
}

/// The fastest implementation of a function by another program.
pub fn fastest<'a>(
    measured: &Measured<'a>,
    scene: &Scene,
    function: Function,
    maker: &str,
    scalar: Scalar,
) -> Option<&'a Point> {
    let points = measured.points.iter().filter(|point| {
        let who = point.key.variant.split_once('/');
        point.scene == scene.name
            && point.function == function
            && point.key.scalar == scalar
            && who.is_some_and(|(who, _)| who == maker)
    });
    points.min_by(|a, b| a.time[1].total_cmp(&b.time[1]))
}

/// The median of its time \[ns\].
pub fn time(point: Option<&Point>) -> String {
    point.map_or_else(|| "–".to_owned(), |point| format!("{:.0}", point.time[1]))
}

/// The same with a digit more below 10 ns.
pub fn precise_time(point: Option<&Point>) -> String {
    match point {
        Some(point) if point.time[1] < 9.95 => format!("{:.1}", point.time[1]),
        other => time(other),
    }
}

/// The worst error in units of the roundoff of its type.
pub fn units(point: Option<&Point>) -> String {
    errors(point, |point| vec![point.worst])
}

/// Median, 99th percentile and maximum of the error of the worst entry, in the same units.
pub fn spread(point: Option<&Point>) -> String {
    errors(point, |point| vec![point.median, point.rare, point.worst])
}

fn errors(point: Option<&Point>, of: impl Fn(&Point) -> Vec<f64>) -> String {
    let Some(point) = point else {
        return "–".to_owned();
    };
    let unit = match point.key.scalar {
        Scalar::F64 => f64::EPSILON / 2.0,
        Scalar::F32 => f64::from(f32::EPSILON) / 2.0,
    };
    let errors = of(point).into_iter().map(|error| in_units(error / unit));
    format!("{} u", errors.collect::<Vec<_>>().join(", "))
}

/// An error with two or three digits.
pub fn in_units(number: f64) -> String {
    match number {
        few if few < 99.5 => format!("{few:.1}"),
        many if many < 1e4 => format!("{many:.0}"),
        lots => format!("{lots:.0e}"),
    }
}

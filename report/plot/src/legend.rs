//! Samples of curves with their labels, in rows.
//!
//! In: curves and where the rows begin and end. Out: SVG, and how many rows it took.

use super::symbol::{line, symbol, text};
use super::{Curve, Style};

/// The distance between rows, in pixels.
pub(super) const ROW: f64 = 20.0;

/// Draws from the left to the right end, and on below; says how many rows.
pub(super) fn draw(svg: &mut String, curves: &[Curve], [left, right]: [f64; 2], top: f64) -> u32 {
    let (mut x, mut y, mut rows) = (left, top, 1);
    for curve in curves {
        if curve.label.is_empty() || matches!(curve.style, Style::Named(_)) {
            continue;
        }
        // Letters of 13 px are at most 7 px wide on average.
        let letters = u32::try_from(curve.label.chars().count()).unwrap_or(0);
        let point = matches!(curve.style, Style::Points(_));
        let sample = if point { 16.0 } else { 30.0 };
        let width = sample + 6.9 * f64::from(letters) + 16.0;
        if x > left && x + width > right + 18.0 {
            (x, y, rows) = (left, y + ROW, rows + 1);
        }
        let color = curve.color.code();
        if let Style::Points(shape) = curve.style {
            svg.push_str(&symbol([x + 5.0, y - 4.5], shape, color));
        } else {
            let dash = match curve.style {
                Style::Dashed => "\" stroke-width=\"2.5\" stroke-dasharray=\"7 4",
                _ => "\" stroke-width=\"2.5",
            };
            line(
                svg,
                [x, y - 4.0],
                [x + 24.0, y - 4.0],
                &format!("{color}{dash}"),
            );
        }
        text(svg, [x + sample, y], "start", "", &curve.label);
        x += width;
    }
    rows
}

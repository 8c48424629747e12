//! Panels side by side under one legend.
//!
//! In: panels with titles, and samples of what their curves stand for. Out: one SVG as wide as all
//! others.

use super::panel::Frame;
use super::symbol::text;
use super::{Curve, Panel, WIDTH, card, legend};

/// A title and a legend above panels in columns.
#[derive(Clone, Debug)]
pub struct Grid {
    /// The first line.
    pub title: String,
    /// The legend of colours and symbols, as curves whose points are not drawn.
    pub legend: Vec<Curve>,
    /// Number of panels side by side.
    pub columns: usize,
    /// Row by row, each with its title.
    pub panels: Vec<(String, Panel)>,
}

/// Room for ticks and labels beside a panel, in pixels.
const LEFT: f64 = 74.0;
const RIGHT: f64 = 14.0;
const ABOVE: f64 = 24.0;
const BELOW: f64 = 46.0;

/// The text of the SVG.
#[must_use]
pub fn draw(grid: &Grid) -> String {
    let mut svg = String::new();
    let rows = legend::draw(&mut svg, &grid.legend, [24.0, WIDTH - 24.0], 56.0);
    let columns = u32::try_from(grid.columns).unwrap_or(1);
    let width = (WIDTH - 16.0) / f64::from(columns);
    let mut top = if grid.legend.is_empty() {
        44.0
    } else {
        50.0 + legend::ROW * f64::from(rows)
    };
    for row in grid.panels.chunks(grid.columns) {
        let mut left = 8.0;
        for (title, panel) in row {
            let area = [
                left + LEFT,
                top + ABOVE,
                left + width - RIGHT,
                top + panel.height - BELOW,
            ];
            let bold = "font-weight=\"bold\"";
            text(&mut svg, [area[0], top + 16.0], "start", bold, title);
            Frame::of(panel, area).draw(panel, &mut svg);
            left += width;
        }
        top += row
            .iter()
            .map(|(_, panel)| panel.height)
            .fold(0.0, f64::max);
    }
    card(&grid.title, top + 8.0, &svg)
}

//! Small plots as SVG text.
//!
//! In: panels of curves with labelled axes, or a map of numbers. Out: one SVG, 800 px wide, on a white card, so that it
//! reads the same on a dark page; in the colours of Okabe and Ito, which the colour-blind can tell
//! apart. It computes nothing but ticks and pixels, and needs no other crate.

mod axis;
pub mod grid;
pub mod heat;
mod label;
mod legend;
mod panel;
mod symbol;

use std::path::{Path, PathBuf};
use std::{env, fs, io};

use panel::Frame;
pub use symbol::Shape;
use symbol::text;

/// A title above panels that stand one below the other.
#[derive(Clone, Debug)]
pub struct Page {
    /// The first line.
    pub title: String,
    /// From top to bottom.
    pub panels: Vec<Panel>,
}

/// Curves over common axes.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// In the order of drawing.
    pub curves: Vec<Curve>,
    /// Vertical lines with a label above: where on the x axis, and the label.
    pub marks: Vec<(f64, String)>,
    /// The height of the panel with its labels, in pixels.
    pub height: f64,
    /// True for equal lengths of a unit on both axes; both are then extended to fill the panel.
    pub to_scale: bool,
}

/// The quantity along an axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// Quantity and unit.
    pub label: &'static str,
    /// The scale from numbers to lengths.
    pub scale: Scale,
}

/// A scale from numbers to lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// In proportion.
    Linear,
    /// In proportion, with ticks at multiples of a number.
    Every(f64),
    /// By powers of ten; numbers that are not positive are left out.
    Log,
    /// By powers of two, which are written out.
    Doubling,
}

/// A line through points.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Text in the legend; no entry if empty.
    pub label: String,
    /// x and y in the units of the axes; points that are not finite interrupt the line.
    pub points: Vec<[f64; 2]>,
    /// Its colour.
    pub color: Color,
    /// The style of the curve.
    pub style: Style,
}

/// The palette of Okabe and Ito, without the yellow that white swallows, and some darker ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Color {
    /// Black.
    Black,
    /// Orange.
    Orange,
    /// Sky blue.
    Sky,
    /// Bluish green.
    Green,
    /// Blue.
    Blue,
    /// Vermilion.
    Vermilion,
    /// Reddish purple.
    Purple,
    /// Wine, darker than all but black.
    Wine,
    /// Brown, between orange and black.
    Brown,
    /// Olive, between yellow and green.
    Olive,
    /// Grey, for what stays in the background.
    Grey,
}

/// The style of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Style {
    /// A line.
    Line,
    /// A dashed line.
    Dashed,
    /// A hair line.
    Thin,
    /// A heavy line with a dot on each point: links and joints.
    Links,
    /// Dots joined by a thin line.
    Dots,
    /// Symbols alone.
    Points(Shape),
    /// Symbols alone, with the label beside each.
    Named(Shape),
}

/// The path that the program was called with, or `target/<name>.svg`.
#[must_use]
pub fn path_from_arguments(name: &str) -> PathBuf {
    env::args_os().nth(1).map_or_else(
        || Path::new("target").join(name).with_extension("svg"),
        PathBuf::from,
    )
}

/// Draws `page` and writes it to `path`, whose folder is made if it is missing.
///
/// # Errors
///
/// When the file cannot be written.
pub fn write(path: &Path, page: &Page) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, draw(page))
}

/// The text of the SVG.
#[must_use]
pub fn draw(page: &Page) -> String {
    let heights: f64 = page.panels.iter().map(|panel| panel.height).sum();
    let mut svg = String::new();
    let mut top = TITLE;
    for panel in &page.panels {
        let area = [LEFT, top + ABOVE, WIDTH - RIGHT, top + panel.height - BELOW];
        Frame::of(panel, area).draw(panel, &mut svg);
        legend::draw(&mut svg, &panel.curves, [area[0], area[2]], area[1] - 11.0);
        top += panel.height;
    }
    card(&page.title, heights + TITLE + 12.0, &svg)
}

const WIDTH: f64 = 800.0;
const TITLE: f64 = 42.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 24.0;
/// Room for the legend above a panel, and for ticks and label below it, in pixels.
const ABOVE: f64 = 30.0;
const BELOW: f64 = 46.0;
const INK: &str = "#1f2328";

/// A drawing under a title, on a white card of a given height.
fn card(title: &str, height: f64, content: &str) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
         width=\"{WIDTH}\" height=\"{height}\" font-family=\"Helvetica, Arial, sans-serif\" \
         font-size=\"13\" fill=\"{INK}\">\n\
         <rect x=\"0.5\" y=\"0.5\" width=\"{}\" height=\"{}\" rx=\"8\" fill=\"#ffffff\" \
         stroke=\"#c8ccd0\"/>\n",
        WIDTH - 1.0,
        height - 1.0,
    );
    let bold = "font-size=\"16\" font-weight=\"bold\"";
    text(&mut svg, [24.0, 28.0], "start", bold, title);
    svg + content + "</svg>\n"
}

impl Color {
    fn code(self) -> &'static str {
        match self {
            Self::Black => "#000000",
            Self::Orange => "#e69f00",
            Self::Sky => "#56b4e9",
            Self::Green => "#009e73",
            Self::Blue => "#0072b2",
            Self::Vermilion => "#d55e00",
            Self::Purple => "#cc79a7",
            Self::Wine => "#882255",
            Self::Brown => "#8c564b",
            Self::Olive => "#a0a000",
            Self::Grey => "#9aa0a6",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Color, Curve, Page, Panel, Scale, Style, draw};

    /// A gap in the data interrupts the line, and no coordinate is NaN.
    #[test]
    fn gaps_interrupt_a_curve() {
        let axis = |label| Axis {
            label,
            scale: Scale::Linear,
        };
        let curve = Curve {
            label: "a < b".into(),
            points: vec![
                [0.0, 0.0],
                [1.0, 1.0],
                [2.0, f64::NAN],
                [3.0, 1.0],
                [4.0, 2.0],
            ],
            color: Color::Blue,
            style: Style::Line,
        };
        let svg = draw(&Page {
            title: "gaps".into(),
            panels: vec![Panel {
                x: axis("time [s]"),
                y: axis("angle [rad]"),
                curves: vec![curve],
                marks: vec![(2.0, "here".into())],
                height: 200.0,
                to_scale: false,
            }],
        });
        assert_eq!(svg.matches("<polyline").count(), 2);
        assert!(svg.contains("a &lt; b") && !svg.contains("NaN") && !svg.contains("inf"));
    }
}

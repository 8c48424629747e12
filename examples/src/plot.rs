//! Small plots as SVG text.
//!
//! In: panels of curves with labelled axes. Out: one SVG, 800 px wide, on a white card, so that it
//! reads the same on a dark page; in the colours of Okabe and Ito, which the colour-blind can tell
//! apart. It computes nothing but ticks and pixels, and needs no other crate.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

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
    /// Whether a unit is as long on both axes; both are then extended to fill the panel.
    pub to_scale: bool,
}

/// What runs along an axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// Quantity and unit.
    pub label: &'static str,
    /// How numbers become lengths.
    pub scale: Scale,
}

/// How numbers become lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// In proportion.
    Linear,
    /// In proportion, with ticks at multiples of a number.
    Every(f64),
    /// By powers of ten; numbers that are not positive are left out.
    Log,
}

/// A line through points.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What stands in the legend; nothing when empty.
    pub label: String,
    /// x and y in the units of the axes; points that are not finite interrupt the line.
    pub points: Vec<[f64; 2]>,
    /// Its colour.
    pub color: Color,
    /// How it is drawn.
    pub style: Style,
}

/// The palette of Okabe and Ito, without the yellow that white swallows.
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
    /// Grey, for what stays in the background.
    Grey,
}

/// How a curve is drawn.
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
    let height = heights + TITLE + 12.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" \
         width=\"{WIDTH}\" height=\"{height}\" font-family=\"Helvetica, Arial, sans-serif\" \
         font-size=\"13\" fill=\"{INK}\">\n\
         <rect x=\"0.5\" y=\"0.5\" width=\"{}\" height=\"{}\" rx=\"8\" fill=\"#ffffff\" \
         stroke=\"#c8ccd0\"/>\n",
        WIDTH - 1.0,
        height - 1.0,
    );
    text(
        &mut svg,
        [LEFT, 28.0],
        "start",
        "font-size=\"16\" font-weight=\"bold\"",
        &page.title,
    );
    let mut top = TITLE;
    for panel in &page.panels {
        Frame::of(panel, top).draw(panel, &mut svg);
        top += panel.height;
    }
    svg.push_str("</svg>\n");
    svg
}

const WIDTH: f64 = 800.0;
const TITLE: f64 = 42.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 24.0;
/// Room for the legend above a panel, and for ticks and label below it, in pixels.
const ABOVE: f64 = 30.0;
const BELOW: f64 = 46.0;
const INK: &str = "#1f2328";

/// Where a panel lies on the page, and what its axes span.
struct Frame {
    /// Left, top, right and bottom of the area of the curves, in pixels.
    area: [f64; 4],
    x: Span,
    y: Span,
}

/// The range of an axis; of its logarithms on a logarithmic one.
struct Span {
    low: f64,
    high: f64,
    scale: Scale,
}

impl Span {
    fn of(scale: Scale, values: impl Iterator<Item = f64>, margin: f64) -> Self {
        let position = |x: f64| if scale == Scale::Log { x.log10() } else { x };
        let (low, high) = values
            .map(position)
            .filter(|x| x.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
                (low.min(x), high.max(x))
            });
        let (low, high) = if low > high { (0.0, 1.0) } else { (low, high) };
        let (low, high) = match scale {
            Scale::Log => (low.floor(), high.ceil()),
            _ => (low - margin * (high - low), high + margin * (high - low)),
        };
        // A constant needs some room as well.
        let (low, high) = if high > low {
            (low, high)
        } else {
            (low - 1.0, high + 1.0)
        };
        Self { low, high, scale }
    }

    /// From 0 at the low end to 1 at the high one.
    fn fraction(&self, x: f64) -> f64 {
        let x = if self.scale == Scale::Log {
            x.log10()
        } else {
            x
        };
        (x - self.low) / (self.high - self.low)
    }

    /// Ticks and what is written there.
    fn ticks(&self, room: f64) -> Vec<(f64, String)> {
        let step = match self.scale {
            Scale::Every(step) => step,
            Scale::Log => ((self.high - self.low) * 28.0 / room).ceil().max(1.0),
            Scale::Linear => round_step((self.high - self.low) * 60.0 / room),
        };
        let first = (self.low / step - 1e-9).ceil();
        (0..200)
            .map(|k| (first + f64::from(k)) * step)
            .take_while(|x| *x <= self.high + 1e-9 * step)
            .map(|x| match self.scale {
                Scale::Log => (10_f64.powf(x), format!("10{}", superscript(x))),
                _ => (x, number(x, step)),
            })
            .collect()
    }
}

/// The next larger 1, 2 or 5 times a power of ten.
fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|digit| digit * power)
        .into_iter()
        .find(|step| *step >= least)
        .unwrap_or(least)
}

/// `x` with as many decimals as `step` has, and a true minus sign.
fn number(x: f64, step: f64) -> String {
    let decimals = (0..8)
        .find(|d| {
            let scaled = step * 10_f64.powi(*d);
            (scaled - scaled.round()).abs() < 1e-6
        })
        .unwrap_or(8);
    // What is left of zero after additions is zero.
    let x = if x.abs() < 1e-9 * step { 0.0 } else { x };
    let decimals = usize::try_from(decimals).unwrap_or(0);
    format!("{x:.decimals$}").replace('-', "−")
}

/// A whole number, raised.
fn superscript(x: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    format!("{x:.0}").chars().map(raised).collect()
}

impl Frame {
    fn of(panel: &Panel, top: f64) -> Self {
        let area = [LEFT, top + ABOVE, WIDTH - RIGHT, top + panel.height - BELOW];
        let points = || panel.curves.iter().flat_map(|curve| &curve.points);
        let margin = if panel.to_scale { 0.05 } else { 0.0 };
        let mut x = Span::of(panel.x.scale, points().map(|p| p[0]), margin);
        let mut y = Span::of(panel.y.scale, points().map(|p| p[1]), 0.06);
        if !panel.marks.is_empty() {
            // The labels of the marks stand above the curves.
            y.high += 0.18 * (y.high - y.low);
        }
        if panel.to_scale {
            let per_pixel = |span: &Span, pixels: f64| (span.high - span.low) / pixels;
            let (width, height) = (area[2] - area[0], area[3] - area[1]);
            let unit = per_pixel(&x, width).max(per_pixel(&y, height));
            for (span, pixels) in [(&mut x, width), (&mut y, height)] {
                let lacking = 0.5 * (unit * pixels - (span.high - span.low));
                (span.low, span.high) = (span.low - lacking, span.high + lacking);
            }
        }
        Self { area, x, y }
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [left, top, right, bottom] = self.area;
        [
            left + self.x.fraction(x) * (right - left),
            bottom - self.y.fraction(y) * (bottom - top),
        ]
    }

    fn draw(&self, panel: &Panel, svg: &mut String) {
        self.draw_axes(panel, svg);
        for (x, label) in &panel.marks {
            let [left, top, _, bottom] = self.area;
            let [x, _] = self.at([*x, self.y.low]);
            line(
                svg,
                [x, top],
                [x, bottom],
                "#6b7177\" stroke-dasharray=\"2 3",
            );
            let (x, anchor) = if x - left < 40.0 {
                (x + 4.0, "start")
            } else {
                (x - 4.0, "end")
            };
            text(
                svg,
                [x, top + 14.0],
                anchor,
                "font-size=\"11\" fill=\"#4a5056\"",
                label,
            );
        }
        for curve in &panel.curves {
            self.draw_curve(curve, svg);
        }
        self.draw_legend(panel, svg);
    }

    fn draw_axes(&self, panel: &Panel, svg: &mut String) {
        let [left, top, right, bottom] = self.area;
        for (x, label) in self.x.ticks(right - left) {
            let [x, _] = self.at([x, f64::NAN]);
            line(svg, [x, top], [x, bottom], "#e6e8ea");
            text(svg, [x, bottom + 17.0], "middle", "", &label);
        }
        for (y, label) in self.y.ticks(1.6 * (bottom - top)) {
            let [_, y] = self.at([f64::NAN, y]);
            line(svg, [left, y], [right, y], "#e6e8ea");
            text(svg, [left - 8.0, y + 4.5], "end", "", &label);
        }
        let (width, height) = (right - left, bottom - top);
        let _ = writeln!(
            svg,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" \
             stroke=\"#8c9298\"/>"
        );
        text(
            svg,
            [0.5 * (left + right), bottom + 36.0],
            "middle",
            "",
            panel.x.label,
        );
        let middle = 0.5 * (top + bottom);
        let turned = format!("transform=\"rotate(-90 18 {middle})\"");
        text(svg, [18.0, middle], "middle", &turned, panel.y.label);
    }

    fn draw_curve(&self, curve: &Curve, svg: &mut String) {
        let stroke = curve.color.code();
        let attributes = match curve.style {
            Style::Line => "stroke-width=\"2\"",
            Style::Dashed => "stroke-width=\"2\" stroke-dasharray=\"7 4\"",
            Style::Thin => "stroke-width=\"1\"",
            Style::Links => "stroke-width=\"4\" stroke-linecap=\"round\"",
            Style::Dots => "stroke-width=\"1.2\"",
        };
        let pixels: Vec<[f64; 2]> = curve.points.iter().map(|point| self.at(*point)).collect();
        for part in pixels.split(|[x, y]| !(x.is_finite() && y.is_finite())) {
            let mut points = String::new();
            for [x, y] in part {
                let _ = write!(points, "{x:.2},{y:.2} ");
            }
            let points = points.trim_end();
            if !points.is_empty() {
                let _ = writeln!(
                    svg,
                    "<polyline points=\"{points}\" fill=\"none\" stroke=\"{stroke}\" \
                     stroke-linejoin=\"round\" {attributes}/>"
                );
            }
            if matches!(curve.style, Style::Links | Style::Dots) {
                for [x, y] in part {
                    let _ = writeln!(
                        svg,
                        "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" fill=\"#ffffff\" \
                         stroke=\"{stroke}\" stroke-width=\"2\"/>"
                    );
                }
            }
        }
    }

    /// Samples and labels in one row above the area.
    fn draw_legend(&self, panel: &Panel, svg: &mut String) {
        let (mut x, y) = (self.area[0], self.area[1] - 11.0);
        for curve in panel.curves.iter().filter(|curve| !curve.label.is_empty()) {
            let dash = if curve.style == Style::Dashed {
                "\" stroke-width=\"2.5\" stroke-dasharray=\"7 4"
            } else {
                "\" stroke-width=\"2.5"
            };
            let stroke = format!("{}{dash}", curve.color.code());
            line(svg, [x, y - 4.0], [x + 24.0, y - 4.0], &stroke);
            text(svg, [x + 30.0, y], "start", "", &curve.label);
            // Letters of 13 px are at most 8 px wide on average.
            let letters = u32::try_from(curve.label.chars().count()).unwrap_or(0);
            x += 30.0 + 8.0 * f64::from(letters) + 18.0;
        }
    }
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
            Self::Grey => "#9aa0a6",
        }
    }
}

fn line(svg: &mut String, [x_1, y_1]: [f64; 2], [x_2, y_2]: [f64; 2], stroke: &str) {
    let _ = writeln!(
        svg,
        "<line x1=\"{x_1:.2}\" y1=\"{y_1:.2}\" x2=\"{x_2:.2}\" y2=\"{y_2:.2}\" stroke=\"{stroke}\"/>"
    );
}

fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, attributes: &str, content: &str) {
    let content = content.replace('&', "&amp;").replace('<', "&lt;");
    let _ = writeln!(
        svg,
        "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\" {attributes}>{content}</text>"
    );
}

#[cfg(test)]
mod tests {
    use super::{Axis, Color, Curve, Page, Panel, Scale, Span, Style, draw, number, round_step};

    #[test]
    fn steps_are_round() {
        for (least, step) in [(0.013, 0.02), (0.2, 0.2), (3.0, 5.0), (70.0, 100.0)] {
            assert!((round_step(least) / step - 1.0_f64).abs() < 1e-12);
        }
    }

    #[test]
    fn numbers_have_the_decimals_of_their_step() {
        assert_eq!(number(-0.1 - 0.2, 0.1), "−0.3");
        assert_eq!(number(1e-17, 0.5), "0.0");
        assert_eq!(number(90.0, 90.0), "90");
    }

    #[test]
    fn powers_of_ten_span_whole_decades() {
        let span = Span::of(Scale::Log, [2e-3, 40.0, 0.0].into_iter(), 0.0);
        let ticks: Vec<String> = span
            .ticks(600.0)
            .into_iter()
            .map(|(_, label)| label)
            .collect();
        assert_eq!(ticks, ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹", "10²"]);
    }

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

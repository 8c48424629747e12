//! One panel: axes, curves and marks.
//!
//! In: a [`Panel`] and the area of its curves in pixels. Out: SVG. It draws no legend, which may
//! stand elsewhere.

use std::fmt::Write as _;

use super::axis::Span;
use super::symbol::{Shape, line, symbol, text};
use super::{Curve, Panel, Scale, Style, label};

/// The place of a panel on the page, and the ranges of its axes.
pub(super) struct Frame {
    /// Left, top, right and bottom of the area of the curves, in pixels.
    area: [f64; 4],
    x: Span,
    y: Span,
}

impl Frame {
    /// Inside that area.
    pub fn of(panel: &Panel, area: [f64; 4]) -> Self {
        let points = || panel.curves.iter().flat_map(|curve| &curve.points);
        let symbols = |curve: &Curve| matches!(curve.style, Style::Points(_) | Style::Named(_));
        let symbols = panel.curves.iter().any(symbols);
        // A symbol needs room on all sides, a line above and below.
        let margin = |scale, line| match (symbols, scale) {
            (true, Scale::Log) => 0.35,
            (true, _) => 0.05,
            (false, Scale::Log) => 0.0,
            (false, _) => line,
        };
        let to_scale = if panel.to_scale { 0.05 } else { 0.0 };
        let in_x = margin(panel.x.scale, to_scale);
        let in_y = margin(panel.y.scale, 0.06);
        let mut x = Span::of(panel.x.scale, points().map(|p| p[0]), in_x);
        let mut y = Span::of(panel.y.scale, points().map(|p| p[1]), in_y);
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

    /// Axes, curves and marks.
    pub fn draw(&self, panel: &Panel, svg: &mut String) {
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
        let symbols = panel.curves.iter();
        let symbols =
            symbols.filter(|curve| matches!(curve.style, Style::Points(_) | Style::Named(_)));
        let symbols: Vec<_> = symbols
            .flat_map(|curve| &curve.points)
            .map(|point| self.at(*point))
            .collect();
        let named = panel
            .curves
            .iter()
            .filter(|curve| matches!(curve.style, Style::Named(_)));
        let named: Vec<_> = named
            .flat_map(|curve| {
                curve
                    .points
                    .iter()
                    .map(|point| (self.at(*point), &*curve.label))
            })
            .collect();
        label::draw(svg, &named, &symbols, self.area);
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
        let beside = left - 60.0;
        let turned = format!("transform=\"rotate(-90 {beside} {middle})\"");
        text(svg, [beside, middle], "middle", &turned, panel.y.label);
    }

    fn draw_curve(&self, curve: &Curve, svg: &mut String) {
        let stroke = curve.color.code();
        let attributes = match curve.style {
            Style::Line => "stroke-width=\"2\"",
            Style::Dashed => "stroke-width=\"2\" stroke-dasharray=\"7 4\"",
            Style::Thin => "stroke-width=\"1\"",
            Style::Links => "stroke-width=\"4\" stroke-linecap=\"round\"",
            Style::Dots => "stroke-width=\"1.2\"",
            Style::Points(_) | Style::Named(_) => "",
        };
        let pixels: Vec<[f64; 2]> = curve.points.iter().map(|point| self.at(*point)).collect();
        for part in pixels.split(|[x, y]| !(x.is_finite() && y.is_finite())) {
            let mut points = String::new();
            for [x, y] in part {
                let _ = write!(points, "{x:.2},{y:.2} ");
            }
            let points = points.trim_end();
            let joined = !matches!(curve.style, Style::Points(_) | Style::Named(_));
            if joined && part.len() > 1 {
                let _ = writeln!(
                    svg,
                    "<polyline points=\"{points}\" fill=\"none\" stroke=\"{stroke}\" \
                     stroke-linejoin=\"round\" {attributes}/>"
                );
            }
            for at in part {
                match curve.style {
                    Style::Links | Style::Dots => {
                        let hollow = Shape::Circle { filled: false };
                        svg.push_str(&symbol(*at, hollow, stroke));
                    }
                    Style::Points(shape) | Style::Named(shape) => {
                        svg.push_str(&symbol(*at, shape, stroke));
                    }
                    Style::Line | Style::Dashed | Style::Thin => {}
                }
            }
        }
    }
}

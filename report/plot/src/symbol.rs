//! The smallest parts: lines, words and the symbols of points.
//!
//! In: pixels. Out: SVG elements.

use std::fmt::Write as _;

/// The symbol of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Round.
    Circle {
        /// Full of its colour, or of white.
        filled: bool,
    },
    /// With a tip above.
    Triangle {
        /// Full of its colour, or of white.
        filled: bool,
    },
    /// Standing on an edge.
    Square {
        /// Full of its colour, or of white.
        filled: bool,
    },
    /// Standing on a corner.
    Diamond {
        /// Full of its colour, or of white.
        filled: bool,
    },
}

pub(super) fn symbol([x, y]: [f64; 2], shape: Shape, stroke: &str) -> String {
    let fill = |filled| if filled { stroke } else { "#ffffff" };
    let ink = |filled| {
        format!(
            "fill=\"{}\" stroke=\"{stroke}\" stroke-width=\"2\"",
            fill(filled)
        )
    };
    match shape {
        Shape::Circle { filled } => {
            format!(
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\" {}/>\n",
                ink(filled)
            )
        }
        Shape::Triangle { filled } => format!(
            "<path d=\"M{x:.2} {:.2}l4.6 8h-9.2z\" {}/>\n",
            y - 5.0,
            ink(filled)
        ),
        Shape::Square { filled } => format!(
            "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"7\" height=\"7\" {}/>\n",
            x - 3.5,
            y - 3.5,
            ink(filled)
        ),
        Shape::Diamond { filled } => format!(
            "<path d=\"M{x:.2} {:.2}l4.6 4.6l-4.6 4.6l-4.6-4.6z\" {}/>\n",
            y - 4.6,
            ink(filled)
        ),
    }
}

pub(super) fn line(svg: &mut String, [x_1, y_1]: [f64; 2], [x_2, y_2]: [f64; 2], stroke: &str) {
    let _ = writeln!(
        svg,
        "<line x1=\"{x_1:.2}\" y1=\"{y_1:.2}\" x2=\"{x_2:.2}\" y2=\"{y_2:.2}\" stroke=\"{stroke}\"/>"
    );
}

pub(super) fn text(
    svg: &mut String,
    [x, y]: [f64; 2],
    anchor: &str,
    attributes: &str,
    content: &str,
) {
    let content = content.replace('&', "&amp;").replace('<', "&lt;");
    let _ = writeln!(
        svg,
        "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\" {attributes}>{content}</text>"
    );
}

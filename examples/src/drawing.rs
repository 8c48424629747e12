//! Panels of quantities over time, a curve for each joint.
//!
//! In: samples. Out: a panel of a plot.

use homogen_plot::{Axis, Color, Curve, Panel, Scale, Style};

/// A colour for each of seven joints.
const COLORS: [Color; 7] = [
    Color::Blue,
    Color::Vermilion,
    Color::Green,
    Color::Orange,
    Color::Purple,
    Color::Sky,
    Color::Black,
];

/// A curve for each entry of the samples, over time \[s\].
pub fn joints<const N: usize>(
    label: &'static str,
    samples: impl IntoIterator<Item = (f64, [f64; N])>,
) -> Panel {
    let samples: Vec<(f64, [f64; N])> = samples.into_iter().collect();
    let curve = |joint: usize| Curve {
        label: format!("joint {}", joint + 1),
        points: samples
            .iter()
            .map(|(t, entries)| [*t, entries[joint]])
            .collect(),
        color: COLORS[joint % COLORS.len()],
        style: Style::Line,
    };
    over_time(label, (0..N).map(curve).collect())
}

/// Curves over time \[s\].
#[must_use]
pub fn over_time(label: &'static str, curves: Vec<Curve>) -> Panel {
    let axis = |label, scale| Axis { label, scale };
    Panel {
        x: axis("time [s]", Scale::Linear),
        y: axis(label, Scale::Linear),
        curves,
        marks: Vec::new(),
        height: 300.0,
        to_scale: false,
    }
}

//! The figures.
//!
//! In: the measurements. Out: plots for `homogen_plot`. Colours are programs, symbols are types of numbers; full symbols
//! are compiled for this processor, hollow ones without flags.

mod many;

pub use many::many;

use homogen_codegen::Function;
use homogen_plot::grid::Grid;
use homogen_plot::{Axis, Color, Curve, Panel, Scale, Shape, Style};

use crate::growth::{self, Grown};
use crate::measure::{Key, Point};
use crate::program::Flags;
use crate::scene::{Scalar, Scene};
use crate::source::GENERIC;

const TIME: Axis = Axis {
    label: "time per call [ns]",
    scale: Scale::Log,
};
const ERROR: Axis = Axis {
    label: "worst error, relative",
    scale: Scale::Log,
};

/// All functions of a scene, each in all its programs.
pub fn trade(title: &str, scene: &Scene, functions: &[Function], points: &[Point]) -> Grid {
    let of = |function: Function| -> Vec<&Point> {
        let all = points.iter();
        all.filter(|point| point.scene == scene.name && point.function == function)
            .collect()
    };
    let panel = |&function: &Function| {
        let points = of(function);
        let mut curves = vec![front(&points)];
        // Ours is drawn last, on top.
        let peers = points.iter().filter(|point| point.key.is_of_a_peer());
        let ours = points.iter().filter(|point| !point.key.is_of_a_peer());
        curves.extend(peers.chain(ours).map(|point| dot(scene, point)));
        (title_of(function), panel(TIME, ERROR, curves, 226.0))
    };
    Grid {
        title: title.to_owned(),
        legend: legend(scene, points),
        columns: 2,
        panels: functions.iter().map(panel).collect(),
    }
}

/// The simpler models of a robot, each scene in a panel, with their names beside the points.
pub fn models(scenes: &[Scene], points: &[Point]) -> Grid {
    let of = |scene: &Scene| -> Vec<&Point> {
        let all = points.iter().filter(|point| point.scene == scene.name);
        all.filter(|point| point.key.flags == Flags::Native)
            .collect()
    };
    let longest = scenes.iter().flat_map(&of).map(|point| point.time[1]);
    let longest = longest.fold(0.0, f64::max);
    let panel = |scene: &Scene| {
        let points = of(scene);
        let height = if points.len() > 4 { 330.0 } else { 190.0 };
        let named = points.into_iter().map(|point| {
            let variant = scene.variants.iter().find(|v| v.name == point.key.variant);
            let title = variant.map_or("", |variant| variant.title);
            let (color, label) = match point.key.scalar {
                Scalar::F64 => (Color::Blue, title.to_owned()),
                Scalar::F32 => (Color::Vermilion, format!("{title} in f32")),
            };
            Curve {
                label,
                points: vec![[point.time[1], point.worst]],
                color,
                style: Style::Named(shape(&point.key)),
            }
        });
        // One scale for all.
        let corners = Curve {
            label: String::new(),
            points: vec![[0.0, 1e-15], [f64::NAN; 2], [1.1 * longest, 0.5]],
            color: Color::Grey,
            style: Style::Thin,
        };
        let curves = std::iter::once(corners).chain(named).collect();
        (
            scene.title.clone(),
            panel(LINEAR_TIME, ERROR, curves, height),
        )
    };
    Grid {
        title: "Simpler models of the Panda-class arm: inverse dynamics".into(),
        legend: Vec::new(),
        columns: 1,
        panels: scenes.iter().map(panel).collect(),
    }
}

const LINEAR_TIME: Axis = Axis {
    label: "time per call, native [ns]",
    scale: Scale::Linear,
};

/// The formulations of a function in `f64`, with their names beside the points of this processor.
pub fn formulations(panels: &[(&Scene, Function)], points: &[Point]) -> Grid {
    let draw = |&(scene, function): &(&Scene, Function)| {
        let points = points.iter().filter(|point| {
            point.scene == scene.name
                && point.function == function
                && point.key.scalar == Scalar::F64
                && point.key.variant != GENERIC
                && !point.key.is_of_a_peer()
        });
        let curves = points.map(|point| {
            let variant = scene.variants.iter().find(|v| v.name == point.key.variant);
            let native = point.key.flags == Flags::Native;
            let shape = shape(&point.key);
            Curve {
                label: variant.map_or("", |variant| variant.title).to_owned(),
                style: if native {
                    Style::Named(shape)
                } else {
                    Style::Points(shape)
                },
                ..dot(scene, point)
            }
        });
        let title = format!("{}: {}", scene.title, title_of(function));
        (title, panel(EITHER_TIME, ERROR, curves.collect(), 236.0))
    };
    Grid {
        title: "Formulations in f64; hollow: without flags".into(),
        legend: Vec::new(),
        columns: 1,
        panels: panels.iter().map(draw).collect(),
    }
}

const EITHER_TIME: Axis = Axis {
    label: "time per call [ns]",
    scale: Scale::Linear,
};

/// Growth with the number of joints.
pub fn growth(grown: &[Grown]) -> Grid {
    let curves = |value: fn(&Grown) -> Option<f64>| -> Vec<Curve> {
        let curve = |(k, function): (usize, &Function)| {
            let of = grown.iter().filter(|grown| grown.function == *function);
            Curve {
                label: function.name().to_owned(),
                points: of
                    .filter_map(|grown| Some([count(grown.joints), value(grown)?]))
                    .collect(),
                color: COLORS[k],
                style: Style::Dots,
            }
        };
        growth::FUNCTIONS.iter().enumerate().map(curve).collect()
    };
    let axis = |label| Axis {
        label,
        scale: Scale::Log,
    };
    let joints = Axis {
        label: "moving joints",
        scale: Scale::Doubling,
    };
    let titled = |title: &str, label, value| {
        (
            title.to_owned(),
            panel(joints, axis(label), curves(value), 250.0),
        )
    };
    Grid {
        title: "Chains of 1 to 64 joints".into(),
        legend: curves(|_| None),
        columns: 2,
        panels: vec![
            titled("operations", "mul and add", |grown| {
                Some(count(grown.operation_count.mul + grown.operation_count.add))
            }),
            titled("time per call", "time [ns]", |grown| grown.call),
            titled("expansion", "time [s]", |grown| Some(grown.expansion)),
            titled("compilation, optimised", "time [s]", |grown| {
                grown.compilation
            }),
        ],
    }
}

const COLORS: [Color; 5] = [
    Color::Green,
    Color::Sky,
    Color::Blue,
    Color::Orange,
    Color::Vermilion,
];

/// A count as a coordinate.
pub fn count(number: usize) -> f64 {
    f64::from(u32::try_from(number).unwrap_or(u32::MAX))
}

fn panel(x: Axis, y: Axis, curves: Vec<Curve>, height: f64) -> Panel {
    Panel {
        x,
        y,
        curves,
        marks: Vec::new(),
        height,
        to_scale: false,
    }
}

fn title_of(function: Function) -> String {
    function.name().replace('_', " ")
}

fn dot(scene: &Scene, point: &Point) -> Curve {
    Curve {
        label: String::new(),
        points: vec![[point.time[1], point.worst]],
        color: color(scene, &point.key.variant),
        style: Style::Points(shape(&point.key)),
    }
}

fn shape(key: &Key) -> Shape {
    let filled = key.flags == Flags::Native;
    match key.scalar {
        Scalar::F64 if key.is_of_a_peer() => Shape::Square { filled },
        Scalar::F32 if key.is_of_a_peer() => Shape::Diamond { filled },
        Scalar::F64 => Shape::Circle { filled },
        Scalar::F32 => Shape::Triangle { filled },
    }
}

/// The colour of a program: of a variant by the scene's table, of the reference grey, of others by their makers.
fn color(scene: &Scene, variant: &str) -> Color {
    if variant == GENERIC {
        return Color::Grey;
    }
    if let Some((maker, _)) = variant.split_once('/') {
        return match maker {
            "pinocchio" => Color::Wine,
            "plain" => Color::Black,
            _ => Color::Green,
        };
    }
    let ours = scene.variants.iter().find(|ours| ours.name == variant);
    ours.map_or(Color::Grey, |ours| ours.color)
}

fn legend(scene: &Scene, points: &[Point]) -> Vec<Curve> {
    let sample = |label: &str, color, style| Curve {
        label: label.to_owned(),
        points: Vec::new(),
        color,
        style,
    };
    let full = |filled| Style::Points(Shape::Circle { filled });
    let mut legend: Vec<Curve> = scene
        .variants
        .iter()
        .map(|variant| sample(variant.title, color(scene, variant.name), full(true)))
        .collect();
    if scene.generic {
        legend.push(sample(
            "generic recursion of the runtime crate",
            Color::Grey,
            full(true),
        ));
    }
    let mut of_scene = points.iter().filter(|point| point.scene == scene.name);
    let with_peers = of_scene.any(|point| point.key.is_of_a_peer());
    if with_peers {
        let square = Style::Points(Shape::Square { filled: true });
        legend.push(sample("Pinocchio", Color::Wine, square));
        legend.push(sample("CasADi C", Color::Black, square));
        legend.push(sample("CasADi C, tuned", Color::Green, square));
    }
    legend.push(sample("f64", Color::Black, full(true)));
    legend.push(sample(
        "f32",
        Color::Black,
        Style::Points(Shape::Triangle { filled: true }),
    ));
    if with_peers {
        let diamond = Style::Points(Shape::Diamond { filled: true });
        legend.push(sample("f32 of other programs", Color::Black, diamond));
    }
    legend.push(sample("hollow: without flags", Color::Black, full(false)));
    legend.push(sample("Pareto front of ours", Color::Grey, Style::Dashed));
    legend
}

/// The Pareto front of our programs, as a staircase.
fn front(points: &[&Point]) -> Curve {
    let ours = points.iter().filter(|point| !point.key.is_of_a_peer());
    let mut all: Vec<[f64; 2]> = ours.map(|point| [point.time[1], point.worst]).collect();
    all.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    for [time, error] in all {
        match stairs.last() {
            Some([_, least]) if *least <= error => {}
            Some([_, least]) => stairs.extend([[time, *least], [time, error]]),
            None => stairs.push([time, error]),
        }
    }
    Curve {
        label: String::new(),
        points: stairs,
        color: Color::Grey,
        style: Style::Dashed,
    }
}

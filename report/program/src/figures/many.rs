//! The figure about many states.
//!
//! In: the measurements. Out: for each robot a panel of one thread and one of all. Colours and symbols are those of the
//! other figures.

use homogen_plot::grid::Grid;
use homogen_plot::{Axis, Color, Curve, Panel, Scale, Shape, Style};

use super::{ERROR, panel, shape};
use crate::document::many::limit;
use crate::many::{ALL, Implementation, LIMIT, Many, OTHERS, OURS, name_of};
use crate::measure::Point;
use crate::scene::Scalar;

const TIME: Axis = Axis {
    label: "time per state [ns]",
    scale: Scale::Log,
};

/// All robots.
pub fn many(many: &Many<'_>) -> Grid {
    let mut panels: Vec<(String, Panel)> = Vec::new();
    for (scene, operation_count) in many.scenes.iter().zip(&many.operation_counts) {
        for (all, threads) in [(false, "one thread"), (true, "all threads")] {
            let points: Vec<&Point> = (many.points.iter())
                .filter(|point| point.scene == scene.name && name_of(point) != LIMIT.0)
                .filter(|point| point.key.variant.ends_with(ALL) == all)
                .collect();
            let errors = || points.iter().map(|point| point.worst);
            let span = [
                errors().fold(f64::INFINITY, f64::min),
                errors().fold(0.0, f64::max),
            ];
            let limits = [Scalar::F64, Scalar::F32].into_iter().filter_map(|scalar| {
                let time = limit(many, scene, operation_count, all, scalar)?;
                let color = Color::Grey;
                Some(curve(
                    "",
                    color,
                    Style::Dashed,
                    span.map(|error| [time, error]).to_vec(),
                ))
            });
            let mut curves: Vec<Curve> = limits.collect();
            // Ours is drawn last, on top.
            let (ours, others): (Vec<&Point>, Vec<&Point>) =
                points.iter().partition(|point| !point.key.is_of_a_peer());
            curves.extend(others.into_iter().chain(ours).map(dot));
            let title = format!("{}, {threads}", scene.title);
            panels.push((title, panel(TIME, ERROR, curves, 226.0)));
        }
    }
    Grid {
        title: "Many states: time per state of inverse dynamics against worst error".into(),
        legend: legend(many),
        columns: 2,
        panels,
    }
}

fn dot(point: &Point) -> Curve {
    let mut implementations = OURS.iter().chain(&OTHERS);
    let implementation =
        implementations.find(|implementation| implementation.name == name_of(point));
    let color = implementation.map_or(Color::Grey, |implementation| implementation.color);
    curve(
        "",
        color,
        Style::Points(shape(&point.key)),
        vec![[point.time[1], point.worst]],
    )
}

fn legend(many: &Many<'_>) -> Vec<Curve> {
    let ran = |implementation: &&Implementation| {
        many.points
            .iter()
            .any(|point| name_of(point) == implementation.name)
    };
    let sample = |label: &str, color, style| curve(label, color, style, Vec::new());
    let of = |implementation: &Implementation, shape| {
        sample(
            implementation.title,
            implementation.color,
            Style::Points(shape),
        )
    };
    let circle = |filled| Shape::Circle { filled };
    let square = Shape::Square { filled: true };
    let mut legend: Vec<Curve> = (OURS.iter().filter(ran))
        .map(|implementation| of(implementation, circle(true)))
        .collect();
    let mut colors = Vec::new();
    for implementation in OTHERS.iter().filter(ran) {
        // The variants of CasADi's C have one colour.
        if !colors.contains(&implementation.color) {
            colors.push(implementation.color);
            legend.push(of(implementation, square));
        }
    }
    let black = |label, shape| sample(label, Color::Black, Style::Points(shape));
    legend.push(black("f64", circle(true)));
    legend.push(black("f32", Shape::Triangle { filled: true }));
    if !colors.is_empty() {
        legend.push(black(
            "f32 of other programs",
            Shape::Diamond { filled: true },
        ));
    }
    legend.push(black("hollow: without flags", circle(false)));
    legend.push(sample(
        "limits, f64 right of f32",
        Color::Grey,
        Style::Dashed,
    ));
    legend
}

fn curve(label: &str, color: Color, style: Style, points: Vec<[f64; 2]>) -> Curve {
    Curve {
        label: label.to_owned(),
        points,
        color,
        style,
    }
}

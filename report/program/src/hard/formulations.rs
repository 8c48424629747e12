//! Dynamics of hard robots in each formulation.
//!
//! In: nothing. Out: a row for a function of a robot in hard states, a column for a formulation and a type.

use homogen_codegen::formulation::{Formulation, Forward, Frame, Parameters};
use homogen_codegen::{Function, Real};
use homogen_plot::heat::Map;

use super::{FAST, Hard, MANY_TURNS, STRAIGHT, Truth};
use Function::{ForwardDynamics, Gravity, InverseDynamics};

fn cases() -> Vec<(Function, Hard)> {
    let balanced = |x| std::f64::consts::FRAC_PI_2 + x / 1024.0;
    let inverse = |title, label| (InverseDynamics, Hard::new(title, label));
    let forward = |title, label| (ForwardDynamics, Hard::new(title, label));
    let with = |(function, hard), change: fn(Hard) -> Hard| (function, change(hard));
    let straight = |case| with(case, |hard| hard.at(STRAIGHT));
    vec![
        inverse("arm at its base", "panda_class/0"),
        inverse("arm 100 m away", "panda_class/100"),
        inverse("arm 10 km away", "panda_class/1e4"),
        inverse("8 joints, nothing zero", "spatial/8"),
        inverse("payload of 1 t", "payload/1e3"),
        with(inverse("angles to 10⁵ rad", "panda_class/0"), |hard| {
            hard.at(MANY_TURNS)
        }),
        with(inverse("rates to 10⁴ rad/s", "panda_class/0"), |hard| {
            hard.moving(FAST)
        }),
        (
            Gravity,
            Hard::new("nearly balanced", "planar/6").at(balanced),
        ),
        forward("arm at its base", "panda_class/0"),
        forward("8 rods", "planar/8"),
        straight(forward("8 rods, straight", "planar/8")),
        straight(forward("16 rods, straight", "planar/16")),
        forward("payload of 1 t", "payload/1e3"),
        forward("tip of 1 t", "heavy_tip/1e3"),
        forward("tip of 1000 t", "heavy_tip/1e6"),
        forward("base of 1000 t", "heavy_base/1e6"),
        forward("shrinking rods", "shrinking/8"),
        forward("growing rods", "growing/8"),
        forward("a rod of 0.1 mm", "short_link/1e-4"),
        forward("thin rods", "thin_rod/0"),
    ]
}

/// The columns: a title, a formulation, a type.
fn formulations() -> Vec<(&'static str, Formulation, Real)> {
    let default = Formulation::default();
    let forward = |forward| Formulation {
        forward: Some(forward),
        ..default
    };
    let refined = |refinements| forward(Forward::MassMatrix { refinements });
    let frame_0 = Formulation {
        frame: Frame::Base,
        ..default
    };
    let raw = Formulation {
        parameters: Parameters::Raw,
        ..default
    };
    vec![
        ("default", default, Real::F64),
        ("frame 0", frame_0, Real::F64),
        ("raw", raw, Real::F64),
        ("not refined", refined(0), Real::F64),
        ("refined once", refined(1), Real::F64),
        ("refined twice", refined(2), Real::F64),
        (
            "articulated bodies",
            forward(Forward::Articulated),
            Real::F64,
        ),
        ("default f32", default, Real::F32),
    ]
}

/// How many states each error is the worst of.
const STATES: usize = 200;

/// Measures all of them.
pub fn map() -> Map {
    let formulations = formulations();
    let rows = cases().into_iter().map(|(function, hard)| {
        let of = match function {
            ForwardDynamics => "forward",
            Gravity => "gravity",
            _ => "inverse",
        };
        let truths =
            [Real::F64, Real::F32].map(|scalar| Truth::of(&hard, function, scalar, STATES));
        let cell = |(_, formulation, scalar): &(&str, Formulation, Real)| {
            let solves = function == ForwardDynamics;
            if formulation.forward.is_some() && !solves {
                return None;
            }
            truths[usize::from(*scalar == Real::F32)].worst(*formulation)
        };
        let cells = formulations.iter().map(cell).collect();
        (format!("{of}: {}", hard.title), cells)
    });
    Map {
        title: "Hard cases: worst error of dynamics by formulation".into(),
        unit: "units of rounding".into(),
        rows: rows.collect(),
        columns: formulations
            .iter()
            .map(|(title, ..)| (*title).to_owned())
            .collect(),
        scale: [0.0, 8.0],
    }
}

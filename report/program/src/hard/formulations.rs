//! Dynamics of hard robots in each formulation.
//!
//! A row is a function of a robot in difficult states, a column a formulation and a type.

use homogen_codegen::formulation::{Formulation, Forward, Frame, Parameters};
use homogen_codegen::{Function, Real};
use homogen_plot::heat::Map;

use super::{FAST, Hard, MANY_TURNS, STRAIGHT, Truth};
use Function::{ForwardDynamics, Gravity, InverseDynamics};

fn cases() -> Vec<(Function, Hard)> {
    let balanced = |x| std::f64::consts::FRAC_PI_2 + x / 1024.0;
    let inverse = [
        Hard::new("arm at its base", "panda_class/0"),
        Hard::new("arm 100 m away", "panda_class/100"),
        Hard::new("arm 10 km away", "panda_class/1e4"),
        Hard::new("8 joints, nothing zero", "spatial/8"),
        Hard::new("payload of 1 t", "payload/1e3"),
        Hard::new("angles to 10⁵ rad", "panda_class/0").at(MANY_TURNS),
        Hard::new("rates to 10⁴ rad/s", "panda_class/0").moving(FAST),
    ];
    let gravity = [Hard::new("nearly balanced", "planar/6").at(balanced)];
    let forward = [
        Hard::new("arm at its base", "panda_class/0"),
        Hard::new("8 rods", "planar/8"),
        Hard::new("8 rods, straight", "planar/8").at(STRAIGHT),
        Hard::new("16 rods, straight", "planar/16").at(STRAIGHT),
        Hard::new("payload of 1 t", "payload/1e3"),
        Hard::new("tip of 1 t", "heavy_tip/1e3"),
        Hard::new("tip of 1000 t", "heavy_tip/1e6"),
        Hard::new("base of 1000 t", "heavy_base/1e6"),
        Hard::new("shrinking rods", "shrinking/8"),
        Hard::new("growing rods", "growing/8"),
        Hard::new("a rod of 0.1 mm", "short_link/1e-4"),
        Hard::new("thin rods", "thin_rod/0"),
    ];
    let inverse = inverse.map(|hard| (InverseDynamics, hard));
    let gravity = gravity.map(|hard| (Gravity, hard));
    let forward = forward.map(|hard| (ForwardDynamics, hard));
    inverse.into_iter().chain(gravity).chain(forward).collect()
}

/// The columns: a title, a formulation, a type.
fn formulations() -> Vec<(&'static str, Formulation, Real)> {
    let default = Formulation::default();
    let forward = |forward| default.with_forward(forward);
    let refined = |refinements| forward(Forward::MassMatrix { refinements });
    let frame_0 = default.with_frame(Frame::Base);
    let raw = default.with_parameters(Parameters::Raw);
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

/// Number of states; each error is the worst of these.
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
        let truth = Truth::of(&hard, function, STATES);
        let cell = |(_, formulation, scalar): &(&str, Formulation, Real)| {
            let solves = function == ForwardDynamics;
            if formulation.forward.is_some() && !solves {
                return None;
            }
            truth.worst(*formulation, *scalar)
        };
        let cells = formulations.iter().map(cell).collect();
        (format!("{of}: {}", hard.title), cells)
    });
    Map {
        title: "Hard cases: worst error of dynamics by formulation".into(),
        unit: "units of roundoff".into(),
        rows: rows.collect(),
        columns: formulations
            .iter()
            .map(|(title, ..)| (*title).to_owned())
            .collect(),
        scale: [0.0, 8.0],
    }
}

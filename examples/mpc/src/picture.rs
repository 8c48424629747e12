//! Draws the motion of the firmware, simulated on this machine.
//!
//! In: the path of the picture, `target/mpc.svg` if there is none. Out: an SVG with coordinates less the goal, rates, torques
//! over their limits and iterations over time.

use std::io;

use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use mpc::arm::{GOAL, ITERATIONS, JOINTS, Joints, Panda, Reach, START, STEPS, simulated};

const COLORS: [Color; JOINTS] = [
    Color::Blue,
    Color::Vermilion,
    Color::Green,
    Color::Orange,
    Color::Purple,
    Color::Sky,
    Color::Black,
];

/// A control step.
struct Sample {
    /// \[s\]
    time: f64,
    q: Joints,
    qd: Joints,
    tau: Joints,
    iterations: u32,
}

fn main() -> io::Result<()> {
    let path = plot::path_from_arguments("mpc");
    plot::write(&path, &page(&samples()))?;
    println!("drawn in {}", path.display());
    Ok(())
}

fn samples() -> Vec<Sample> {
    let mut reach = Reach::new(&GOAL).expect("the gain exists");
    let (mut q, mut qd) = (START, [0.0; JOINTS]);
    let step = |k: u16| {
        let (tau, found) = reach.torques(&q, &qd, ITERATIONS);
        let sample = Sample {
            time: 1e-3 * f64::from(k),
            q,
            qd,
            tau,
            iterations: found.iterations,
        };
        let next = simulated(&q, &qd, &tau);
        (q, qd) = (next.q, next.qd);
        sample
    };
    (0..STEPS).map(step).collect()
}

fn page(samples: &[Sample]) -> Page {
    let panel = |label, curves| Panel {
        x: Axis {
            label: "time [s]",
            scale: Scale::Linear,
        },
        y: Axis {
            label,
            scale: Scale::Linear,
        },
        curves,
        marks: Vec::new(),
        height: 240.0,
        to_scale: false,
    };
    let curve = |label: String, color, of: &dyn Fn(&Sample) -> f64| Curve {
        label,
        points: samples
            .iter()
            .step_by(2)
            .map(|sample| [sample.time, of(sample)])
            .collect(),
        color,
        style: Style::Line,
    };
    let joints = |of: fn(&Sample, usize) -> f64| {
        (0..JOINTS)
            .map(|i| {
                curve(format!("joint {}", i + 1), COLORS[i], &|sample| {
                    of(sample, i)
                })
            })
            .collect()
    };
    let iterations = curve(String::new(), Color::Blue, &|sample| {
        f64::from(sample.iterations)
    });
    Page {
        title: "Model-predictive control within limits of rates and torques".to_owned(),
        panels: vec![
            panel(
                "distance from the goal [rad]",
                joints(|sample, i| f64::from(sample.q[i] - GOAL[i])),
            ),
            panel("rates [rad/s]", joints(|sample, i| f64::from(sample.qd[i]))),
            panel(
                "torques over their limits",
                joints(|sample, i| f64::from(sample.tau[i]) / Panda::MAX_EFFORT[i]),
            ),
            panel("iterations", vec![iterations]),
        ],
    }
}

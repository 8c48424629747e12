//! Operational-space control: the flange of an arm follows a circle, upright, while its elbow moves aside.
//!
//! The controller is that of `homogen_examples::control`, written for any robot; the arm is simulated at 1 kHz. For six
//! seconds its elbow moves to another configuration by null-space motions, which do not move the flange. Draws the errors
//! of the flange and the joints over time to `target/operational_space.svg` or to the path given.

use std::array::from_fn;
use std::f64::consts::TAU;
use std::io;

use homogen::step::{Integrator, NextState, Step};
use homogen::{Pose, Robot};
use homogen_examples::control::{Gains, Task, apart, operational_space};
use homogen_examples::drawing::{joints, over_time};
use homogen_examples::motion::largest;
use homogen_plot::{self as plot, Color, Curve, Page, Style};

#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(
    forward_kinematics,
    geometric_jacobian,
    geometric_jacobian_rate,
    mass_matrix_inverse,
    bias,
    forward_dynamics
))]
struct Panda;

type Vector = [f64; 7];

/// Period of the controller and step of the simulation, and length of the run \[s\].
const PERIOD: f64 = 1e-3;
const END: f64 = 6.0;
/// Radius of the circle \[m\], and time of one round \[s\].
const RADIUS: f64 = 0.1;
const ROUND: f64 = 2.0;
const START: Vector = [0.0, -0.4, 0.0, -2.2, 0.0, 1.8, 0.8];
/// The desired configuration, with another elbow by the first three joints.
const NULL_SPACE_TARGET: Vector = [0.7, -0.5, -0.8, -2.2, 0.5, 1.8, 0.8];
const GAINS: Gains = Gains::critical(20.0);

fn main() -> io::Result<()> {
    let run = simulate();
    println!("Panda-class arm, flange on a circle of {RADIUS} m, once in {ROUND} s");
    println!(
        "  largest error of the flange   {:.4} mm, {:.4} mrad",
        1e3 * run.worst(3..6),
        1e3 * run.worst(0..3)
    );
    println!(
        "  elbow (joint 3) moved by      {:.3} rad",
        run.samples[run.samples.len() - 1].q[2] - START[2]
    );
    let path = plot::path_from_arguments("operational_space");
    plot::write(&path, &run.page())?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// A circle in a vertical plane, from rest, with the initial axes of the flange.
fn task(t: f64) -> Task {
    let pose = Panda.forward_kinematics(&START);
    // The angle accelerates over the first round.
    let (angle, rate, second) = if t < ROUND {
        let pace = TAU / (2.0 * ROUND * ROUND);
        (pace * t * t, 2.0 * pace * t, 2.0 * pace)
    } else {
        let pace = TAU / ROUND;
        (pace * (t - 0.5 * ROUND), pace, 0.0)
    };
    let (s, c) = angle.sin_cos();
    let [x, y, z] = pose.translation();
    let at = [x, y + RADIUS * s, z + RADIUS * (c - 1.0)];
    let velocity = [0.0, RADIUS * c * rate, -RADIUS * s * rate];
    let acceleration = [
        0.0,
        RADIUS * (c * second - s * rate * rate),
        -RADIUS * (s * second + c * rate * rate),
    ];
    let linear = |part: [f64; 3]| from_fn(|i| if i < 3 { 0.0 } else { part[i - 3] });
    Task {
        pose: Pose::new(*pose.rotation(), at),
        velocity: linear(velocity),
        acceleration: linear(acceleration),
    }
}

struct Sample {
    t: f64,
    q: Vector,
    error: [f64; 6],
}

struct Run {
    samples: Vec<Sample>,
}

fn simulate() -> Run {
    let (mut q, mut qd) = (START, [0.0; 7]);
    let times = (0_u32..).map(|k| f64::from(k) * PERIOD);
    let samples = times.take_while(|t| *t <= END).map(|t| {
        let task = task(t);
        let error = apart(&Panda.forward_kinematics(&q), &task.pose);
        let sample = Sample { t, q, error };
        let tau = operational_space(&Panda, &q, &qd, &task, &NULL_SPACE_TARGET, GAINS);
        NextState { q, qd } = Panda.step(Integrator::Rk4, &q, &qd, &tau, PERIOD);
        sample
    });
    Run {
        samples: samples.collect(),
    }
}

impl Run {
    /// The largest of some entries of the error [rad, m].
    fn worst(&self, entries: std::ops::Range<usize>) -> f64 {
        largest(
            self.samples
                .iter()
                .flat_map(|sample| sample.error[entries.clone()].to_vec()),
        )
    }

    fn page(&self) -> Page {
        let drawn = || self.samples.iter().step_by(20);
        let error = |label: &str, first: usize, color| Curve {
            label: label.to_owned(),
            points: drawn()
                .map(|sample| {
                    [
                        sample.t,
                        1e3 * largest(sample.error[first..first + 3].to_vec()),
                    ]
                })
                .collect(),
            color,
            style: Style::Line,
        };
        Page {
            title: "A flange on a circle, while the elbow swings aside".to_owned(),
            panels: vec![
                over_time(
                    "error of the flange",
                    vec![
                        error("place [mm]", 3, Color::Blue),
                        error("axes [mrad]", 0, Color::Vermilion),
                    ],
                ),
                joints("joints [rad]", drawn().map(|sample| (sample.t, sample.q))),
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{START, simulate};

    #[test]
    fn the_flange_stays_on_its_circle_while_the_elbow_moves() {
        let run = simulate();
        assert!(run.worst(3..6) < 2e-4, "{}", run.worst(3..6));
        assert!(run.worst(0..3) < 1e-3, "{}", run.worst(0..3));
        let last = run.samples[run.samples.len() - 1].q;
        assert!((last[2] - START[2]).abs() > 0.2, "{}", last[2]);
    }
}

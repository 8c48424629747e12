//! A computed-torque controller tracks a trajectory at 1 kHz on a simulated arm.
//!
//! The arm holds 2 kg. For four seconds the controller's model holds nothing; then it is told, by
//! setting one field, and the errors fall two hundredfold. Draws errors and torques against time, to
//! `target/computed_torque.svg` or to the path given.

use std::io;
use std::time::{Duration, Instant};

use homogen::Robot;
use homogen_examples::machine;
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use nalgebra::{Cholesky, SMatrix, SVector};

/// The arm as the controller believes it to be, and as it is.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(inverse_dynamics, all_of(mass_matrix, bias)))]
struct Panda {
    /// What the flange holds \[kg\].
    #[robot(mass_of = "link8")]
    payload: f64,
}

type Vector = [f64; 7];

/// Period of the controller and step of the simulation \[s\].
const PERIOD: f64 = 1e-3;
/// Length of the run, and when the model is told the payload \[s\].
const END: f64 = 8.0;
const TOLD: f64 = 4.0;
const PAYLOAD: f64 = 2.0;
/// Gains of a critically damped error with a natural frequency of 20 rad/s [1/s², 1/s].
const KP: f64 = 400.0;
const KD: f64 = 40.0;

fn main() -> io::Result<()> {
    let run = simulate();
    let samples = f64::from(u32::try_from(run.samples.len()).expect("a few thousand"));
    println!("Panda-class arm with {PAYLOAD} kg, computed torque at 1 kHz, RK4 at 1 kHz");
    let [before, after] = run.worst();
    println!(
        "  largest error, payload unknown   {:8.4} mrad",
        1e3 * before
    );
    println!(
        "  largest error, payload known     {:8.4} mrad",
        1e3 * after
    );
    println!(
        "  controller: {:.2} µs a period; simulation: {:.1} µs a step of four forward dynamics",
        1e6 * run.controller.as_secs_f64() / samples,
        1e6 * run.simulation.as_secs_f64() / samples,
    );
    println!("  {}", machine::describe());
    let path = plot::path_from_arguments("computed_torque");
    plot::write(&path, &run.page())?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// Where the arm should be, smooth and at rest in the beginning.
fn desired(t: f64) -> [Vector; 3] {
    const CENTER: Vector = [0.0, -0.3, 0.0, -1.9, 0.0, 1.7, 0.0];
    const REACH: Vector = [0.5, 0.3, -0.4, 0.35, 0.5, -0.4, 0.6];
    const RATE: Vector = [1.6, 2.4, 2.0, 2.8, 2.2, 3.0, 2.6];
    let of = |f: &dyn Fn(f64, f64) -> f64| std::array::from_fn(|i| f(REACH[i], RATE[i]));
    let moved: Vector = of(&|a, w| a * (1.0 - (w * t).cos()));
    [
        std::array::from_fn(|i| CENTER[i] + moved[i]),
        of(&|a, w| a * w * (w * t).sin()),
        of(&|a, w| a * w * w * (w * t).cos()),
    ]
}

/// τ that gives the model the acceleration q̈_d + K_d ė + K_p e.
fn control(model: &Panda, t: f64, q: &Vector, qd: &Vector) -> Vector {
    let [q_d, qd_d, qdd_d] = desired(t);
    let wanted = std::array::from_fn(|i| qdd_d[i] + KD * (qd_d[i] - qd[i]) + KP * (q_d[i] - q[i]));
    model.inverse_dynamics(q, qd, &wanted)
}

/// q̈ from M q̈ = τ − bias.
fn forward_dynamics(arm: &Panda, q: &Vector, qd: &Vector, tau: &Vector) -> Vector {
    let (mass, bias) = arm.mass_matrix_and_bias(q, qd);
    let mass = SMatrix::<f64, 7, 7>::from_fn(|i, j| mass[i][j]);
    let force = SVector::<f64, 7>::from_fn(|i, _| tau[i] - bias[i]);
    let factors = Cholesky::new(mass).expect("the masses are positive");
    factors.solve(&force).into()
}

/// One step of Runge and Kutta's method under a torque that is held.
fn step(arm: &Panda, q: &mut Vector, qd: &mut Vector, tau: &Vector) {
    let after =
        |x: &Vector, h: f64, d: &Vector| -> Vector { std::array::from_fn(|i| x[i] + h * d[i]) };
    let rate = |q: &Vector, qd: &Vector| (*qd, forward_dynamics(arm, q, qd, tau));
    let half = 0.5 * PERIOD;
    let (v_1, a_1) = rate(q, qd);
    let (v_2, a_2) = rate(&after(q, half, &v_1), &after(qd, half, &a_1));
    let (v_3, a_3) = rate(&after(q, half, &v_2), &after(qd, half, &a_2));
    let (v_4, a_4) = rate(&after(q, PERIOD, &v_3), &after(qd, PERIOD, &a_3));
    for i in 0..7 {
        q[i] += PERIOD / 6.0 * (v_1[i] + 2.0 * (v_2[i] + v_3[i]) + v_4[i]);
        qd[i] += PERIOD / 6.0 * (a_1[i] + 2.0 * (a_2[i] + a_3[i]) + a_4[i]);
    }
}

struct Sample {
    t: f64,
    error: Vector,
    tau: Vector,
}

/// What happened, and the time the two programs took.
struct Run {
    samples: Vec<Sample>,
    controller: Duration,
    simulation: Duration,
}

fn simulate() -> Run {
    let arm = Panda { payload: PAYLOAD };
    let mut model = Panda { payload: 0.0 };
    let [mut q, mut qd, _] = desired(0.0);
    let mut run = Run {
        samples: Vec::new(),
        controller: Duration::ZERO,
        simulation: Duration::ZERO,
    };
    for t in (0_u32..)
        .map(|k| f64::from(k) * PERIOD)
        .take_while(|t| *t <= END)
    {
        if t >= TOLD {
            model.payload = PAYLOAD;
        }
        let start = Instant::now();
        let tau = control(&model, t, &q, &qd);
        let between = Instant::now();
        let [q_d, ..] = desired(t);
        let error = std::array::from_fn(|i| q_d[i] - q[i]);
        run.samples.push(Sample { t, error, tau });
        step(&arm, &mut q, &mut qd, &tau);
        run.controller += between - start;
        run.simulation += between.elapsed();
    }
    run
}

impl Run {
    /// The largest errors of any joint \[rad\]: before the model knows, and a second later.
    fn worst(&self) -> [f64; 2] {
        let worst = |from: f64, to: f64| {
            let samples = self.samples.iter().filter(|s| (from..=to).contains(&s.t));
            let errors = samples.flat_map(|s| s.error);
            errors.map(f64::abs).fold(0.0, f64::max)
        };
        [worst(0.0, TOLD), worst(TOLD + 1.0, END)]
    }

    fn page(&self) -> Page {
        Page {
            title: "Computed torque on a seven-joint arm that holds 2 kg".to_owned(),
            panels: vec![
                self.panel("tracking error [mrad]", |s| s.error.map(|e| 1e3 * e)),
                self.panel("joint torque [N m]", |s| s.tau),
            ],
        }
    }

    fn panel(&self, label: &'static str, of: impl Fn(&Sample) -> Vector) -> Panel {
        const COLORS: [Color; 7] = [
            Color::Blue,
            Color::Vermilion,
            Color::Green,
            Color::Orange,
            Color::Purple,
            Color::Sky,
            Color::Black,
        ];
        let axis = |label, scale| Axis { label, scale };
        let curve = |joint: usize| Curve {
            label: format!("joint {}", joint + 1),
            points: (self.samples.iter().step_by(20))
                .map(|s| [s.t, of(s)[joint]])
                .collect(),
            color: COLORS[joint],
            style: Style::Line,
        };
        Panel {
            x: axis("time [s]", Scale::Every(1.0)),
            y: axis(label, Scale::Linear),
            curves: (0..7).map(curve).collect(),
            marks: vec![(TOLD, "the model learns of the payload".to_owned())],
            height: 300.0,
            to_scale: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::simulate;

    #[test]
    fn a_model_that_knows_the_payload_tracks_two_hundred_times_better() {
        let [before, after] = simulate().worst();
        assert!(before > 5e-3, "{before}");
        assert!(after < before / 200.0, "{before} {after}");
    }
}

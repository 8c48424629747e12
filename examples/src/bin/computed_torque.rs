//! A computed-torque controller tracks a trajectory at 1 kHz on a simulated arm.
//!
//! The arm holds 2 kg. For four seconds the controller's model has no payload; then one field is set, and the
//! errors fall by a factor of 200. Draws errors and torques over time to `target/computed_torque.svg` or to the
//! path given.

use std::io;
use std::time::{Duration, Instant};

use homogen::Robot;
use homogen::step::{Integrator, NextState, Step};
use homogen_examples::control::{Gains, computed_torque};
use homogen_examples::drawing::joints;
use homogen_examples::machine;
use homogen_examples::motion::{Waves, largest};
use homogen_plot::{self as plot, Page, Panel};

/// The arm, as the controller's model and as the simulated robot.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(inverse_dynamics, forward_dynamics))]
struct Panda {
    /// The mass at the flange \[kg\].
    #[robot(mass_of = "link8")]
    payload: f64,
}

type Vector = [f64; 7];

/// Period of the controller and step of the simulation \[s\].
const PERIOD: f64 = 1e-3;
/// Length of the run, and the time at which the model gets the payload \[s\].
const END: f64 = 8.0;
const UPDATED: f64 = 4.0;
const PAYLOAD: f64 = 2.0;
const GAINS: Gains = Gains::critical(20.0);
/// The desired motion.
const MOTION: Waves<7> = Waves {
    from: [0.0, -0.3, 0.0, -1.9, 0.0, 1.7, 0.0],
    reach: [0.5, 0.3, -0.4, 0.35, 0.5, -0.4, 0.6],
    rate: [1.6, 2.4, 2.0, 2.8, 2.2, 3.0, 2.6],
};

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

struct Sample {
    t: f64,
    error: Vector,
    tau: Vector,
}

/// The samples of a run, and the time of controller and simulation.
struct Run {
    samples: Vec<Sample>,
    controller: Duration,
    simulation: Duration,
}

fn simulate() -> Run {
    let arm = Panda { payload: PAYLOAD };
    let mut model = Panda { payload: 0.0 };
    let [mut q, mut qd, _] = MOTION.at(0.0);
    let mut run = Run {
        samples: Vec::new(),
        controller: Duration::ZERO,
        simulation: Duration::ZERO,
    };
    for t in (0_u32..)
        .map(|k| f64::from(k) * PERIOD)
        .take_while(|t| *t <= END)
    {
        if t >= UPDATED {
            model.payload = PAYLOAD;
        }
        let start = Instant::now();
        let desired = MOTION.at(t);
        let tau = computed_torque(&model, &q, &qd, &desired, GAINS);
        let between = Instant::now();
        let [q_d, ..] = desired;
        let error = std::array::from_fn(|i| q_d[i] - q[i]);
        run.samples.push(Sample { t, error, tau });
        NextState { q, qd } = arm.step(Integrator::Rk4, &q, &qd, &tau, PERIOD);
        run.controller += between - start;
        run.simulation += between.elapsed();
    }
    run
}

impl Run {
    /// The largest errors of any joint \[rad\]: before the model has the payload, and a second later.
    fn worst(&self) -> [f64; 2] {
        let worst = |from: f64, to: f64| {
            let samples = self.samples.iter().filter(|s| (from..=to).contains(&s.t));
            largest(samples.flat_map(|s| s.error))
        };
        [worst(0.0, UPDATED), worst(UPDATED + 1.0, END)]
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
        let drawn = self.samples.iter().step_by(20);
        Panel {
            marks: vec![(UPDATED, "the model gets the payload".to_owned())],
            ..joints(label, drawn.map(|s| (s.t, of(s))))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::simulate;

    #[test]
    fn a_model_with_the_payload_tracks_two_hundred_times_better() {
        let [before, after] = simulate().worst();
        assert!(before > 5e-3, "{before}");
        assert!(after < before / 200.0, "{before} {after}");
    }
}

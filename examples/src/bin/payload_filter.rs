//! An arm estimates its payload while it moves: an extended Kalman filter on generated derivatives.
//!
//! The controller follows a motion by computed torque with the estimated mass; after three seconds the arm picks up
//! 2 kg, unknown to the controller. Draws the estimate and the tracking errors to `target/payload_filter.svg` or to the
//! path given.

use std::array::from_fn;
use std::io;

use homogen::Robot;
use homogen::step::{Integrator, NextState, Step};
use homogen_examples::control::{Gains, computed_torque};
use homogen_examples::drawing::{joints, over_time};
use homogen_examples::filter::{Deviations, Estimate};
use homogen_examples::motion::Waves;
use homogen_plot::{self as plot, Color, Curve, Page, Style};
use homogen_random::Random;

#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(inverse_dynamics, forward_dynamics, forward_dynamics_derivatives))]
struct Panda {
    /// The mass at the flange \[kg\].
    #[robot(mass_of = "link8")]
    payload: f64,
}

type Vector = [f64; 7];

/// Period of the controller, the filter and the simulation, and length of the run \[s\].
const PERIOD: f64 = 2e-3;
const END: f64 = 8.0;
/// The mass that the arm picks up \[kg\], and the time \[s\].
const PAYLOAD: f64 = 2.0;
const TAKEN: f64 = 3.0;
/// Standard deviation of the encoders \[rad\].
const ENCODER: f64 = 1e-4;
const MOTION: Waves<7> = Waves {
    from: [0.0, -0.3, 0.0, -1.9, 0.0, 1.7, 0.0],
    reach: [0.4, 0.25, -0.3, 0.3, 0.4, -0.3, 0.4],
    rate: [1.6, 2.4, 2.0, 2.8, 2.2, 3.0, 2.6],
};

fn main() -> io::Result<()> {
    let run = simulate();
    println!("Panda-class arm that picks up {PAYLOAD} kg after {TAKEN} s");
    let end = &run[run.len() - 1];
    println!(
        "  estimate at the end  {:.4} kg, standard deviation {:.4}",
        end.mass, end.standard_deviation
    );
    println!(
        "  within a tenth       {:.2} s after it is picked up",
        settled(&run) - TAKEN
    );
    let path = plot::path_from_arguments("payload_filter");
    plot::write(&path, &page(&run))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

struct Sample {
    t: f64,
    mass: f64,
    standard_deviation: f64,
    error: Vector,
}

fn held(t: f64) -> f64 {
    if t < TAKEN { 0.0 } else { PAYLOAD }
}

fn simulate() -> Vec<Sample> {
    let mut random = Random::new(3);
    let [mut q, mut qd, _] = MOTION.at(0.0);
    let noise = Deviations {
        encoder: ENCODER,
        model: 0.02,
        drift: 0.5,
        mass: 0.5,
    };
    let mut estimate = Estimate::new(q, 0.0, noise);
    let mut samples = Vec::new();
    for t in (0_u32..)
        .map(|k| f64::from(k) * PERIOD)
        .take_while(|t| *t <= END)
    {
        let read = from_fn(|i| q[i] + ENCODER * random.normal());
        estimate.correct(&read);
        let [coordinates, rates] = estimate.state;
        let desired = MOTION.at(t);
        let model = Panda {
            payload: estimate.mass,
        };
        let gains = Gains::critical(15.0);
        let tau = computed_torque(&model, &coordinates, &rates, &desired, gains);
        samples.push(Sample {
            t,
            mass: estimate.mass,
            standard_deviation: estimate.mass_deviation(),
            error: from_fn(|i| desired[0][i] - q[i]),
        });
        estimate.predict(PERIOD, &tau, |payload| Panda { payload });
        let robot = Panda { payload: held(t) };
        NextState { q, qd } = robot.step(Integrator::Rk4, &q, &qd, &tau, PERIOD);
    }
    samples
}

/// The time from which the estimate is within a tenth of the payload \[s\].
fn settled(run: &[Sample]) -> f64 {
    let off = run
        .iter()
        .rev()
        .find(|sample| (sample.mass - held(sample.t)).abs() > 0.1 * PAYLOAD);
    off.map_or(0.0, |sample| sample.t)
}

fn page(run: &[Sample]) -> Page {
    let drawn = || run.iter().step_by(10);
    let curve = |label: &str, color, style, of: fn(&Sample) -> f64| Curve {
        label: label.to_owned(),
        points: drawn().map(|sample| [sample.t, of(sample)]).collect(),
        color,
        style,
    };
    Page {
        title: "An arm estimates its payload while it moves".to_owned(),
        panels: vec![
            over_time(
                "payload [kg]",
                vec![
                    curve("payload", Color::Black, Style::Dashed, |sample| {
                        held(sample.t)
                    }),
                    curve("estimate", Color::Blue, Style::Line, |sample| sample.mass),
                    curve(
                        "two standard deviations",
                        Color::Sky,
                        Style::Thin,
                        |sample| sample.mass + 2.0 * sample.standard_deviation,
                    ),
                    curve("", Color::Sky, Style::Thin, |sample| {
                        sample.mass - 2.0 * sample.standard_deviation
                    }),
                ],
            ),
            joints(
                "tracking error [mrad]",
                drawn().map(|sample| (sample.t, sample.error.map(|error| 1e3 * error))),
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use homogen_examples::motion::largest;

    use super::{END, PAYLOAD, TAKEN, held, settled, simulate};

    #[test]
    fn the_mass_is_found_and_the_errors_vanish() {
        let run = simulate();
        assert!(settled(&run) - TAKEN < 1.5, "{}", settled(&run));
        let end = &run[run.len() - 1];
        assert!(
            (end.mass - PAYLOAD).abs() < 0.1 && end.standard_deviation < 0.1,
            "{} {}",
            end.mass,
            end.standard_deviation
        );
        let errors = |from: f64| {
            let samples = run
                .iter()
                .filter(|sample| (from..from + 1.0).contains(&sample.t));
            largest(samples.flat_map(|sample| sample.error))
        };
        assert!(
            errors(END - 1.0) < errors(TAKEN),
            "{} {}",
            errors(END - 1.0),
            errors(TAKEN)
        );
        // Before the arm picks up the mass, the estimate is near zero.
        let before = run.iter().filter(|sample| (1.0..TAKEN).contains(&sample.t));
        assert!(
            before
                .clone()
                .all(|sample| (sample.mass - held(sample.t)).abs() < 0.15)
        );
    }
}

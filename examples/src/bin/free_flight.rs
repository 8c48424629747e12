//! Free flight of two bodies: momentum and energy over 100 000 steps.
//!
//! `cargo run --release -p homogen-examples --bin free_flight [picture.svg]`
//!
//! Two bodies joined by a hinge with a spring rotate and translate in space without external forces, so momentum and
//! energy are constant. The integrator does not enforce this: the drift is its error, falls with the fourth power of
//! the step, and ends at rounding. It corresponds to SPACELIB's program TEST.

use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use std::array::from_fn;
use std::error::Error;
use two_bodies::{Bodies, State};

#[path = "free_flight/two_bodies.rs"]
mod two_bodies;

/// Duration of the flight \[s\].
const DURATION: f64 = 10.0;

/// Number of steps of the fine integration.
const STEPS: u32 = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let bodies = Bodies::example();
    let flight = fly(&bodies, DURATION, STEPS, STEPS / 500);
    let [momentum, energy] = worst(&flight);
    println!("two bodies, one hinge with a spring, {DURATION} s of free flight");
    println!("  {STEPS} steps: relative drift of momentum {momentum:.1e}, of energy {energy:.1e}");
    let counts = [100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000];
    let mut drifts: Vec<(u32, [f64; 2])> = counts
        .iter()
        .map(|steps| (*steps, worst(&fly(&bodies, DURATION, *steps, 1))))
        .collect();
    let slope = (drifts[2].1[0] / drifts[4].1[0]).log2() / 2.0;
    println!(
        "  the drift of momentum falls with the step to the power {slope:.2}, down to rounding"
    );
    drifts.push((STEPS, [momentum, energy]));
    let path = plot::path_from_arguments("free_flight");
    plot::write(&path, &page(&flight, &drifts))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// One moment of the flight.
struct Moment {
    time: f64,
    state: State,
    /// Relative drift of momentum and energy since the beginning.
    drift: [f64; 2],
}

/// A flight of `duration` \[s\] in `steps` equal steps, one moment in every `every`.
fn fly(bodies: &Bodies, duration: f64, steps: u32, every: u32) -> Vec<Moment> {
    let h = duration / f64::from(steps);
    let mut state = bodies.start();
    let before = bodies.constants(&state);
    let mut flight = Vec::new();
    for k in 0..=steps {
        if k % every == 0 {
            flight.push(Moment {
                time: f64::from(k) * h,
                state,
                drift: before.drift(&bodies.constants(&state)),
            });
        }
        state = bodies.step(&state, h);
    }
    flight
}

fn worst(flight: &[Moment]) -> [f64; 2] {
    let drifts = flight.iter().map(|moment| moment.drift);
    drifts.fold([0.0; 2], |worst, drift| from_fn(|k| drift[k].max(worst[k])))
}

fn page(flight: &[Moment], drifts: &[(u32, [f64; 2])]) -> Page {
    let linear = |label| Axis {
        label,
        scale: Scale::Linear,
    };
    let log = |label| Axis {
        label,
        scale: Scale::Log,
    };
    let over_time = |label: &str, color, style, value: &dyn Fn(&Moment) -> f64| Curve {
        label: label.into(),
        points: flight
            .iter()
            .map(|moment| [moment.time, value(moment)])
            .collect(),
        color,
        style,
    };
    let over_steps = |label: &str, color, value: &dyn Fn(u32, [f64; 2]) -> f64, style| Curve {
        label: label.into(),
        points: drifts
            .iter()
            .map(|(steps, drift)| [f64::from(*steps), value(*steps, *drift)])
            .collect(),
        color,
        style,
    };
    let panel = |x, y, curves, height| Panel {
        x,
        y,
        curves,
        marks: Vec::new(),
        height,
        to_scale: false,
    };
    let fourth_order = |steps: u32, _| {
        let drift = drifts[0].1[0] * (f64::from(drifts[0].0) / f64::from(steps)).powi(4);
        // The line ends at rounding.
        if drift > 1e-16 { drift } else { f64::NAN }
    };
    Page {
        title: "Free flight of two bodies with a spring between them".into(),
        panels: vec![
            panel(
                linear("time [s]"),
                linear("motion"),
                vec![
                    over_time("ω_x [rad/s]", Color::Blue, Style::Line, &|m| {
                        m.state.rates.w.omega()[0]
                    }),
                    over_time("ω_y [rad/s]", Color::Orange, Style::Line, &|m| {
                        m.state.rates.w.omega()[1]
                    }),
                    over_time("ω_z [rad/s]", Color::Green, Style::Line, &|m| {
                        m.state.rates.w.omega()[2]
                    }),
                    over_time("hinge [rad]", Color::Black, Style::Dashed, &|m| {
                        m.state.rates.angle
                    }),
                ],
                250.0,
            ),
            panel(
                linear("time [s], in 100 000 steps"),
                log("relative drift"),
                vec![
                    over_time("momentum Γ", Color::Blue, Style::Line, &|m| m.drift[0]),
                    over_time("energy", Color::Vermilion, Style::Line, &|m| m.drift[1]),
                ],
                230.0,
            ),
            panel(
                log("steps for the whole flight"),
                log("largest relative drift"),
                vec![
                    over_steps("momentum Γ", Color::Blue, &|_, drift| drift[0], Style::Dots),
                    over_steps(
                        "energy",
                        Color::Vermilion,
                        &|_, drift| drift[1],
                        Style::Dots,
                    ),
                    over_steps(
                        "fourth power of the step",
                        Color::Grey,
                        &fourth_order,
                        Style::Dashed,
                    ),
                ],
                280.0,
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::two_bodies::{Bodies, Rates, State};
    use super::{DURATION, fly, worst};
    use homogen::{Inertia, Pose, Screw, Velocity};
    use std::array::from_fn;

    /// Two bodies of revolution about their hinge: the angle between them oscillates like two flywheels on a
    /// spring, and their common axis precesses about the momentum like that of a top.
    #[test]
    fn two_flywheels_on_one_axis_are_a_top_and_a_pendulum() {
        let body = |mass, height, [across, about]: [f64; 2]| {
            let tensor = [[across, 0.0, 0.0], [0.0, across, 0.0], [0.0, 0.0, about]];
            Inertia::from_tensor_at_center_of_mass(mass, [0.0, 0.0, height], &tensor)
        };
        let bodies = Bodies {
            first: body(4.0, 0.1, [0.3, 0.2]),
            second: body(2.0, 0.2, [0.15, 0.1]),
            placement: Pose::from_translation([0.0, 0.0, 0.3]),
            hinge: Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]),
            stiffness: 6.0,
        };
        // The common centre of mass, which must not move, and the moment of inertia about it across the axis.
        let height = (4.0 * 0.1 + 2.0 * 0.5) / 6.0;
        let across = 0.3 + 0.15 + 4.0 * 2.0 / 6.0 * (0.5 - 0.1_f64).powi(2);
        let omega = [0.9, -0.4, 1.5];
        let (angle, rate) = (0.7, -0.5);
        let rates = Rates {
            w: Velocity::new(omega, [-omega[1] * height, omega[0] * height, 0.0]),
            angle,
            rate,
        };
        let slope = bodies.slope(&rates);
        let pose = Pose::identity();
        let mut state = State { pose, rates, slope };
        let (steps, h) = (4000_u32, 1e-3);
        for _ in 0..steps {
            state = bodies.step(&state, h);
        }
        let time = f64::from(steps) * h;
        let swing = (6.0_f64 * (1.0 / 0.2 + 1.0 / 0.1)).sqrt();
        let (s, c) = (swing * time).sin_cos();
        let expected = angle * c + rate / swing * s;
        assert!((state.rates.angle - expected).abs() < 1e-9);

        // γ about the centre of mass, and z rotated about it by |γ| t over the moment of inertia.
        let about = 0.2 * omega[2] + 0.1 * (omega[2] + rate);
        let gamma = [across * omega[0], across * omega[1], about];
        let size = gamma.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [x, y, z] = gamma.map(|x| x / size);
        let (s, c) = (size * time / across).sin_cos();
        let expected = [
            x * z * (1.0 - c) + y * s,
            y * z * (1.0 - c) - x * s,
            c + z * z * (1.0 - c),
        ];
        let axis: [f64; 3] = from_fn(|k| state.pose.rotation()[k][2]);
        for (found, known) in axis.into_iter().zip(expected) {
            assert!((found - known).abs() < 1e-9, "{axis:?} is not {expected:?}");
        }
        assert!(expected[2] < 0.9, "it hardly moves");
    }

    /// Hard case 30, a tenth of the flight of the program: momentum is constant to 1e-12.
    #[test]
    fn free_flight() {
        let [momentum, energy] = worst(&fly(&Bodies::example(), 0.1 * DURATION, 5000, 1));
        println!("momentum {momentum:e}, energy {energy:e}");
        assert!(momentum <= 1e-12 && energy <= 1e-12);
    }

    /// The drift is an error of the integration, not of the equations: it falls with the fourth power.
    #[test]
    fn drift_falls_with_the_fourth_power_of_the_step() {
        let [coarse, fine] =
            [500, 1000].map(|steps| worst(&fly(&Bodies::example(), DURATION, steps, 1)));
        for k in 0..2 {
            let order = (coarse[k] / fine[k]).log2();
            assert!((3.5..5.5).contains(&order), "order {order}");
        }
    }

    /// The bodies move relative to each other, so that the constants are a meaningful test.
    #[test]
    fn the_bodies_exchange_momentum() {
        let flight = fly(&Bodies::example(), DURATION, 1000, 1);
        assert!((flight[1000].time - DURATION).abs() < 1e-9);
        let angles = flight.iter().map(|moment| moment.state.rates.angle);
        assert!(angles.fold(0.0, f64::min) < -0.5);
    }
}

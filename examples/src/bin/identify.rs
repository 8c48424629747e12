//! Identifies the payload and the friction of an arm from noisy torques of one motion.
//!
//! The arm holds 1.3 kg beside the axis of its flange, and every joint has friction; the model has neither. Torques are
//! measured a hundred times a second with noise of 0.2 N m. Ten parameters of the last link with its payload and two of
//! each joint's friction are fitted to them. Draws the torques of another motion with and without the identified
//! parameters, and friction over rate, to `target/identify.svg` or to the path given.

use std::array::from_fn;
use std::io;

use homogen::Robot;
use homogen::identify::Fit;
use homogen_examples::drawing::over_time;
use homogen_examples::motion::{Desired, Waves};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Shape, Style};
use homogen_random::Random;

/// The real arm.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(damping(
    joint1 = 1.4,
    joint2 = 1.1,
    joint3 = 0.9,
    joint4 = 0.8,
    joint5 = 0.35,
    joint6 = 0.3,
    joint7 = 0.25
))]
#[robot(friction(
    joint1 = 1.9,
    joint2 = 1.6,
    joint3 = 1.2,
    joint4 = 1.1,
    joint5 = 0.6,
    joint6 = 0.5,
    joint7 = 0.4
))]
#[robot(generate(inverse_dynamics))]
struct Arm {
    /// The mass at the flange \[kg\].
    #[robot(mass_of = "link8")]
    payload: f64,
    /// Its position in the flange's frame \[m\].
    #[robot(com_of = "link8")]
    at: [f64; 3],
}

/// The model: no payload and no friction, but regressor columns for both.
#[derive(Robot)]
#[robot(
    urdf = "../robots/panda_class.urdf",
    tip = "link8",
    damping(joint1 = 0)
)]
#[robot(generate(inverse_dynamics, regressor))]
struct Model;

type Vector = [f64; 7];

/// The number of unknowns: ten parameters of the last link, damping and friction of each joint.
const UNKNOWN: usize = 10 + 2 * 7;
const PAYLOAD: f64 = 1.3;
const AT: [f64; 3] = [0.04, -0.02, 0.07];
/// Standard deviation of a measured torque \[N m\].
const NOISE: f64 = 0.2;
/// Time between two measurements, and duration of the motion \[s\].
const PERIOD: f64 = 0.01;
const END: f64 = 20.0;

/// The exciting motion, and another one for validation.
const EXCITING: Waves<7> = Waves {
    from: [-0.6, -0.9, -0.5, -2.4, -0.6, 1.2, -0.8],
    reach: [0.6, 0.5, 0.7, 0.4, 0.8, 0.6, 0.9],
    rate: [1.3, 1.7, 2.1, 2.3, 2.9, 3.1, 3.7],
};
const OTHER: Waves<7> = Waves {
    from: [0.2, -0.2, 0.3, -1.6, 0.1, 2.0, 0.4],
    reach: [-0.4, 0.4, -0.5, -0.3, 0.6, -0.5, 0.5],
    rate: [1.9, 1.5, 1.2, 2.6, 2.2, 2.4, 3.3],
};

fn main() -> io::Result<()> {
    let found = identify();
    let names = [
        "mass [kg]",
        "centre, x [m]",
        "centre, y [m]",
        "centre, z [m]",
    ];
    println!(
        "Panda-class arm that holds {PAYLOAD} kg: {} measured torques, noise of {NOISE} N m",
        found.fit.rows()
    );
    println!(
        "  excitation (condition number of the regressor)  {:.0}",
        found.fit.condition()
    );
    println!(
        "  what the fit leaves                             {:.3} N m",
        found.fit.standard_deviation()
    );
    for (k, name) in names.iter().enumerate() {
        let (identified, true_value) = (found.load[k], truth()[k]);
        println!("  {name:14} {identified:8.4}, is {true_value:7.4}");
    }
    for (joint, [damping, friction]) in found.friction.iter().enumerate() {
        println!(
            "  joint {}: damping {damping:6.3} N m s, friction {friction:6.3} N m",
            joint + 1
        );
    }
    let [before, after] = found.unexplained();
    println!(
        "  of another motion's torques {before:.2} N m are not explained before, {after:.2} N m after"
    );
    let path = plot::path_from_arguments("identify");
    plot::write(&path, &found.page())?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// The mass of the payload and its position in the frame of the last link; the flange is 107 mm along its axis.
fn truth() -> [f64; 4] {
    let [x, y, z] = AT;
    [PAYLOAD, x, y, z + 0.107]
}

/// Measured torques: those of the arm, with noise.
fn measured(waves: &Waves<7>, t: f64, random: &mut Random) -> (Desired<7>, Vector) {
    let desired = waves.at(t);
    let [q, qd, qdd] = &desired;
    let arm = Arm {
        payload: PAYLOAD,
        at: AT,
    };
    let exact = arm.inverse_dynamics(q, qd, qdd);
    let tau = from_fn(|i| exact[i] + NOISE * random.normal());
    (desired, tau)
}

/// The regressor columns of the unknowns.
fn columns([q, qd, qdd]: &Desired<7>) -> [[f64; UNKNOWN]; 7] {
    Model.regressor(q, qd, qdd).map(|row| {
        from_fn(|k| match k {
            0..10 => row[60 + k],
            // Behind the ten of each link: armature, damping and friction of each joint.
            _ => row[70 + 3 * ((k - 10) / 2) + 1 + k % 2],
        })
    })
}

/// The result of the identification.
struct Found {
    fit: Fit<f64, UNKNOWN>,
    /// Differences of the parameters from the model.
    parameters: [f64; UNKNOWN],
    /// The mass and its centre in the frame of the last link.
    load: [f64; 4],
    /// Damping and friction of each joint.
    friction: [[f64; 2]; 7],
}

fn moments() -> impl Iterator<Item = f64> {
    (0_u32..)
        .map(|k| f64::from(k) * PERIOD)
        .take_while(|t| *t < END)
}

fn identify() -> Found {
    let mut random = Random::new(1);
    let mut fit = Fit::new();
    for t in moments() {
        let (desired, tau) = measured(&EXCITING, t, &mut random);
        let [q, qd, qdd] = &desired;
        let known = Model.inverse_dynamics(q, qd, qdd);
        fit.add(&columns(&desired), &from_fn(|i| tau[i] - known[i]));
    }
    let parameters = fit.parameters().expect("the motion excites all of them");
    let [mass, x, y, z, ..] = parameters;
    Found {
        fit,
        parameters,
        load: [mass, x / mass, y / mass, z / mass],
        friction: from_fn(|joint| [parameters[10 + 2 * joint], parameters[11 + 2 * joint]]),
    }
}

impl Found {
    /// Torques of another motion minus those of the model; and the part that the identified parameters explain.
    fn looked_at(&self) -> Vec<(f64, Desired<7>, Vector, Vector)> {
        let mut random = Random::new(2);
        let samples = moments().map(|t| {
            let (desired, tau) = measured(&OTHER, t, &mut random);
            let [q, qd, qdd] = &desired;
            let known = Model.inverse_dynamics(q, qd, qdd);
            let rows = columns(&desired);
            let explained =
                rows.map(|row| row.iter().zip(&self.parameters).map(|(y, x)| y * x).sum());
            (t, desired, from_fn(|i| tau[i] - known[i]), explained)
        });
        samples.collect()
    }

    /// Root mean square of the residual torques in the other motion \[N m\]: of the model, and of the identified one.
    fn unexplained(&self) -> [f64; 2] {
        let samples = self.looked_at();
        let mean = |of: &dyn Fn(f64, f64) -> f64| {
            let each = samples.iter().flat_map(|(_, _, rest, explained)| {
                rest.iter()
                    .zip(explained)
                    .map(|(rest, explained)| of(*rest, *explained).powi(2))
            });
            let squares: Vec<f64> = each.collect();
            let count = u32::try_from(squares.len()).expect("a few thousand");
            (squares.iter().sum::<f64>() / f64::from(count)).sqrt()
        };
        [
            mean(&|rest, _| rest),
            mean(&|rest, explained| rest - explained),
        ]
    }

    fn page(&self) -> Page {
        let samples = self.looked_at();
        let over =
            |label: &str, joint: usize, color, style, of: fn(&Vector, &Vector, usize) -> f64| {
                Curve {
                    label: label.to_owned(),
                    points: samples
                        .iter()
                        .take(800)
                        .map(|(t, _, rest, explained)| [*t, of(rest, explained, joint)])
                        .collect(),
                    color,
                    style,
                }
            };
        Page {
            title: "Residual torques of an arm, before and after identification".to_owned(),
            panels: vec![
                over_time(
                    "joint 2: torque minus that of the model [N m]",
                    vec![
                        over("measured", 1, Color::Grey, Style::Thin, |rest, _, k| {
                            rest[k]
                        }),
                        over(
                            "identified payload and friction",
                            1,
                            Color::Blue,
                            Style::Line,
                            |_, found, k| found[k],
                        ),
                        over(
                            "residual",
                            1,
                            Color::Vermilion,
                            Style::Thin,
                            |rest, found, k| rest[k] - found[k],
                        ),
                    ],
                ),
                self.friction_over_rate(&samples),
            ],
        }
    }

    /// Friction of joint 1, whose vertical axis has no gravity torque.
    fn friction_over_rate(&self, samples: &[(f64, Desired<7>, Vector, Vector)]) -> Panel {
        let [damping, friction] = self.friction[0];
        let line = |sign: f64| Curve {
            label: if sign > 0.0 {
                "identified damping and friction".to_owned()
            } else {
                String::new()
            },
            points: [0.0, 0.9]
                .map(|rate| [sign * rate, sign * (friction + damping * rate)])
                .to_vec(),
            color: Color::Blue,
            style: Style::Line,
        };
        let points = samples.iter().map(|(_, [_, qd, _], rest, explained)| {
            let rubs = damping * qd[0]
                + friction * f64::from(i8::from(qd[0] > 0.0) - i8::from(qd[0] < 0.0));
            [qd[0], rest[0] - explained[0] + rubs]
        });
        let axis = |label| Axis {
            label,
            scale: Scale::Linear,
        };
        Panel {
            x: axis("rate of joint 1 [rad/s]"),
            y: axis("friction of joint 1 [N m]"),
            curves: vec![
                Curve {
                    label: "measured, minus all other torques".to_owned(),
                    points: points.step_by(10).collect(),
                    color: Color::Grey,
                    style: Style::Points(Shape::Circle { filled: false }),
                },
                line(1.0),
                line(-1.0),
            ],
            marks: Vec::new(),
            height: 300.0,
            to_scale: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{NOISE, identify, truth};

    const DAMPING: [f64; 7] = [1.4, 1.1, 0.9, 0.8, 0.35, 0.3, 0.25];
    const FRICTION: [f64; 7] = [1.9, 1.6, 1.2, 1.1, 0.6, 0.5, 0.4];

    #[test]
    fn identified_parameters_are_the_true_ones() {
        let found = identify();
        assert!(found.fit.condition() < 2000.0, "{}", found.fit.condition());
        assert!((found.fit.standard_deviation() / NOISE - 1.0).abs() < 0.03);
        // Within five standard deviations; for the centre, those of its first moment over the mass.
        let standard_deviations = found.fit.standard_deviations().expect("all are excited");
        let [mass, x, y, z] = truth();
        let expected = [mass, mass * x, mass * y, mass * z];
        for (k, expected) in expected.into_iter().enumerate() {
            assert!(
                (found.parameters[k] - expected).abs() < 5.0 * standard_deviations[k],
                "{k}"
            );
        }
        for joint in 0..7 {
            for (k, expected) in [DAMPING[joint], FRICTION[joint]].into_iter().enumerate() {
                let place = 10 + 2 * joint + k;
                let off = (found.parameters[place] - expected).abs();
                assert!(
                    off < 5.0 * standard_deviations[place],
                    "joint {joint}: {off}"
                );
            }
        }
        assert!(
            standard_deviations
                .iter()
                .all(|standard_deviation| *standard_deviation < 0.1)
        );
    }

    #[test]
    fn torques_of_another_motion_are_explained_to_the_noise() {
        let [model, found] = identify().unexplained();
        assert!(model > 10.0 * NOISE, "{model}");
        assert!((found / NOISE - 1.0).abs() < 0.05, "{found}");
    }
}

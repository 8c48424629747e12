//! Identifies the payload and the friction of an arm from noisy torques of a motion that it designs for the purpose.
//!
//! The arm holds 1.3 kg beside the axis of its flange, and every joint has friction; the model has neither. Torques are
//! measured a hundred times a second with noise of 0.2 N m. Ten parameters of the last link with its payload and two of
//! each joint's friction are fitted to them: along a motion chosen by hand, and along a Fourier series whose regressor has
//! a small condition number, by [`homogen_examples::excitation`]. Draws the condition number of each iteration, the
//! designed motion, the torques of another motion with and without the parameters identified along it, and friction over
//! rate, to `target/identify.svg` or to the path given.

use std::array::from_fn;
use std::io;
use std::ops::Range;

use homogen::identify::Fit;
use homogen::{Inertia, Payload, Robot};
use homogen_examples::drawing::{joints, over_time};
use homogen_examples::excitation::{Design, Regression, Series};
use homogen_examples::motion::{Desired, Waves, largest};
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

/// The model with another body on its last link, whose torques are linear in the body's parameters.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(inverse_dynamics_vjp))]
struct Loaded {
    #[robot(payload_on = "link7")]
    body: Payload,
}

type Vector = [f64; 7];
type Parameters = [f64; UNKNOWN];

/// The number of unknowns: ten parameters of the last link, damping and friction of each joint.
const UNKNOWN: usize = 10 + 2 * 7;
/// Damping \[N m s\] and friction \[N m\] of the arm's joints.
const DAMPING: Vector = [1.4, 1.1, 0.9, 0.8, 0.35, 0.3, 0.25];
const FRICTION: Vector = [1.9, 1.6, 1.2, 1.1, 0.6, 0.5, 0.4];
const PAYLOAD: f64 = 1.3;
const AT: [f64; 3] = [0.04, -0.02, 0.07];
/// Standard deviation of a measured torque \[N m\].
const NOISE: f64 = 0.2;
/// Time between two measurements, and duration of the motion \[s\].
const PERIOD: f64 = 0.01;
const END: f64 = 20.0;

/// Seed of the small motion that the design starts from.
const SEED: u64 = 3;
const DESIGN: Design = Design {
    period: 6.0,
    harmonics: 5,
    samples: 50,
    share: 0.95,
    barrier: 0.02,
    iterations: 150,
};

/// The exciting motion by hand, and another one for validation.
const BY_HAND: Waves<7> = Waves {
    from: [-0.6, -0.9, -0.5, -2.4, -0.6, 1.2, -0.8],
    reach: [0.6, 0.5, 0.7, 0.4, 0.8, 0.6, 0.7],
    rate: [1.3, 1.7, 2.1, 2.3, 2.9, 3.1, 3.7],
};
const OTHER: Waves<7> = Waves {
    from: [0.2, -0.2, 0.3, -1.6, 0.1, 2.0, 0.4],
    reach: [-0.4, 0.4, -0.5, -0.3, 0.6, -0.5, 0.5],
    rate: [1.9, 1.5, 1.2, 2.6, 2.2, 2.4, 3.3],
};

fn main() -> io::Result<()> {
    let (motion, conditions) = design();
    let before = identify(|t| BY_HAND.at(t));
    let after = identify(|t| motion.at(t));
    println!(
        "Panda-class arm that holds {PAYLOAD} kg: {} measured torques, noise of {NOISE} N m",
        after.fit.rows()
    );
    println!("                               by hand  designed");
    let row = |name: &str, [by_hand, designed]: [f64; 2]| {
        println!("  {name:28}{by_hand:10.5}{designed:10.5}");
    };
    let found = [&before, &after];
    row("condition number", found.map(|found| found.fit.condition()));
    row(
        "residual [N m]",
        found.map(|found| found.fit.standard_deviation()),
    );
    for (name, parameters) in GROUPS {
        println!("  {name}");
        let most = |of: fn(&Found) -> Parameters| {
            found.map(|found| largest(parameters.clone().map(|k| of(found)[k])))
        };
        row("  largest error", most(Found::errors));
        row(
            "  largest standard deviation",
            most(Found::standard_deviations),
        );
    }
    let [unexplained, explained] = after.unexplained();
    println!(
        "  of another motion's torques {unexplained:.2} N m are not explained before, {explained:.2} N m after"
    );
    let path = plot::path_from_arguments("identify");
    plot::write(&path, &after.page(&motion, &conditions))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// The designed motion, and its condition number after each iteration.
fn design() -> (Series<7>, Vec<f64>) {
    DESIGN.solve(&Model, &mut Random::new(SEED))
}

/// The parameters in groups of one unit.
const GROUPS: [(&str, Range<usize>); 4] = [
    ("mass [kg]", 0..1),
    ("first moments [kg m]", 1..4),
    ("second moments [kg m²]", 4..10),
    ("damping [N m s] and friction [N m]", 10..UNKNOWN),
];

/// The true parameters: those of the payload in the frame of the last link, whose flange is 107 mm along its axis, and
/// friction.
fn truth() -> Parameters {
    let [x, y, z] = AT;
    let body = Inertia::of_particle(PAYLOAD, [x, y, z + 0.107]);
    let ([q_x, q_y, q_z], [[xx, xy, xz], [_, yy, yz], [_, _, zz]]) =
        (body.q(), body.second_moments());
    let load = [PAYLOAD, q_x, q_y, q_z, xx, xy, xz, yy, yz, zz];
    from_fn(|k| match k {
        0..10 => load[k],
        _ => [DAMPING, FRICTION][k % 2][(k - 10) / 2],
    })
}

/// Measured torques: those of the arm, with noise.
fn measured(state: &Desired<7>, random: &mut Random) -> Vector {
    let [q, qd, qdd] = state;
    let arm = Arm {
        payload: PAYLOAD,
        at: AT,
    };
    let exact = arm.inverse_dynamics(q, qd, qdd);
    from_fn(|i| exact[i] + NOISE * random.normal())
}

/// The regressor columns of the unknowns.
fn columns([q, qd, qdd]: &Desired<7>) -> [Parameters; 7] {
    Model.regressor(q, qd, qdd).map(|row| {
        from_fn(|k| match k {
            0..10 => row[60 + k],
            // Behind the ten of each link: armature, damping and friction of each joint.
            _ => row[70 + 3 * ((k - 10) / 2) + 1 + k % 2],
        })
    })
}

impl Regression<7, UNKNOWN> for Model {
    fn rows(&self, state: &Desired<7>) -> [Parameters; 7] {
        columns(state)
    }

    /// The gradient by inverse dynamics, which are linear in the parameters of a body. They are given by its mass and
    /// centre, and `v` may have no mass: 2 kg at the origin are added, and their torques are subtracted.
    fn gradient(&self, [q, qd, qdd]: &Desired<7>, u: &Vector, v: &Parameters) -> Desired<7> {
        let [mass, x, y, z, xx, xy, xz, yy, yz, zz, joints @ ..] = v;
        let with_mass = |mass| Inertia::new([*xx, *yy, *zz, *xy, *xz, *yz], [*x, *y, *z], mass);
        let of = |body: Payload| Loaded { body }.inverse_dynamics_vjp(q, qd, qdd, u);
        let with = of(payload(&with_mass(mass + 2.0)));
        let without = of(Payload::of_point(2.0, [0.0; 3]));
        [
            from_fn(|i| with.dq[i] - without.dq[i]),
            // The slope of Coulomb friction is zero.
            from_fn(|i| with.dqd[i] - without.dqd[i] + u[i] * joints[2 * i]),
            from_fn(|i| with.dqdd[i] - without.dqdd[i]),
        ]
    }
}

/// A body by its mass, centre and inertia about that.
fn payload(body: &Inertia<f64>) -> Payload {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.tensor_at_center_of_mass();
    Payload {
        mass: body.mass(),
        center: body.center_of_mass(),
        inertia: [xx, xy, xz, yy, yz, zz],
    }
}

/// The result of the identification.
struct Found {
    fit: Fit<f64, UNKNOWN>,
    /// Differences of the parameters from the model.
    parameters: Parameters,
}

fn moments() -> impl Iterator<Item = f64> {
    (0_u32..)
        .map(|k| f64::from(k) * PERIOD)
        .take_while(|t| *t < END)
}

fn identify(motion: impl Fn(f64) -> Desired<7>) -> Found {
    let mut random = Random::new(1);
    let mut fit = Fit::new();
    for desired in moments().map(motion) {
        let tau = measured(&desired, &mut random);
        let [q, qd, qdd] = &desired;
        let known = Model.inverse_dynamics(q, qd, qdd);
        fit.add(&columns(&desired), &from_fn(|i| tau[i] - known[i]));
    }
    let parameters = fit.parameters().expect("the motion excites all of them");
    Found { fit, parameters }
}

impl Found {
    fn errors(&self) -> Parameters {
        from_fn(|k| self.parameters[k] - truth()[k])
    }

    fn standard_deviations(&self) -> Parameters {
        let standard_deviations = self.fit.standard_deviations();
        standard_deviations.expect("the motion excites all of them")
    }

    /// Torques of another motion minus those of the model; and the part that the identified parameters explain.
    fn looked_at(&self) -> Vec<(f64, Desired<7>, Vector, Vector)> {
        let mut random = Random::new(2);
        let samples = moments().map(|t| {
            let desired = OTHER.at(t);
            let tau = measured(&desired, &mut random);
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

    fn page(&self, motion: &Series<7>, conditions: &[f64]) -> Page {
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
            title: "Identification of an arm along a motion designed for it".to_owned(),
            panels: vec![
                condition_over_iterations(conditions),
                joints(
                    "designed motion [rad]",
                    moments()
                        .take_while(|t| *t <= DESIGN.period)
                        .map(|t| (t, motion.at(t)[0])),
                ),
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
        let [damping, friction] = [self.parameters[10], self.parameters[11]];
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

fn condition_over_iterations(conditions: &[f64]) -> Panel {
    let points = conditions.iter().zip(0_u32..);
    let points = points.map(|(condition, iteration)| [f64::from(iteration), *condition]);
    Panel {
        x: Axis {
            label: "iteration",
            scale: Scale::Linear,
        },
        y: Axis {
            label: "condition number",
            scale: Scale::Log,
        },
        curves: vec![Curve {
            label: String::new(),
            points: points.collect(),
            color: Color::Blue,
            style: Style::Line,
        }],
        marks: Vec::new(),
        height: 220.0,
        to_scale: false,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use super::{
        BY_HAND, DESIGN, Found, Model, NOISE, Regression, SEED, Series, design, identify, moments,
    };
    use homogen_examples::excitation::{Design, condition};
    use homogen_random::Random;

    static DESIGNED: LazyLock<(Series<7>, Vec<f64>)> = LazyLock::new(design);

    fn along_design() -> Found {
        identify(|t| DESIGNED.0.at(t))
    }

    #[test]
    fn gradient_of_the_regressor_is_that_of_differences() {
        let mut random = Random::new(4);
        let mut draw = || random.odd();
        for _ in 0..20 {
            let state = std::array::from_fn(|_| std::array::from_fn(|_| draw()));
            let (u, v) = (
                std::array::from_fn(|_| draw()),
                std::array::from_fn(|_| draw()),
            );
            let value = |state| {
                let rows = Model.rows(&state).into_iter().zip(u);
                rows.map(|(row, u)| u * row.iter().zip(&v).map(|(y, v)| y * v).sum::<f64>())
                    .sum::<f64>()
            };
            let gradient = Model.gradient(&state, &u, &v);
            for (order, by) in gradient.iter().enumerate() {
                for (joint, by) in by.iter().enumerate() {
                    let [more, less] = [1e-5, -1e-5].map(|step| {
                        let mut state = state;
                        state[order][joint] += step;
                        value(state)
                    });
                    assert!((by - (more - less) / 2e-5).abs() < 1e-7, "{order} {joint}");
                }
            }
        }
    }

    #[test]
    fn gradient_of_the_condition_number_is_that_of_differences() {
        let (motion, _): (Series<7>, _) = Design {
            iterations: 3,
            ..DESIGN
        }
        .solve(&Model, &mut Random::new(SEED));
        let (_, gradient) = condition(&Model, &motion, DESIGN.samples);
        let largest = gradient.amax();
        for (k, by) in gradient.iter().enumerate() {
            let [more, less] = [1e-6, -1e-6].map(|step| {
                let mut moved = motion.clone();
                moved.factors[k] += step;
                condition(&Model, &moved, DESIGN.samples).0
            });
            let difference = (more - less) / 2e-6;
            assert!(
                (by - difference).abs() < 1e-6 * largest,
                "{k}: {by} {difference}"
            );
        }
    }

    #[test]
    fn motions_are_within_the_limits_and_the_designed_one_has_a_small_condition_number() {
        let (motion, conditions) = &*DESIGNED;
        let by_hand = moments().map(|t| BY_HAND.at(t));
        for [q, qd, _] in by_hand.chain(moments().map(|t| motion.at(t))) {
            for joint in 0..7 {
                assert!(Model::LOWER[joint] < q[joint] && q[joint] < Model::UPPER[joint]);
                assert!(qd[joint].abs() < Model::MAX_VELOCITY[joint]);
            }
        }
        let [by_hand, designed] =
            [identify(|t| BY_HAND.at(t)), along_design()].map(|found| found.fit.condition());
        // Observed: 114 and 34.
        assert!(designed < 40.0 && by_hand > 100.0, "{by_hand} {designed}");
        assert!(conditions[0] > 10.0 * designed, "{}", conditions[0]);
    }

    #[test]
    fn identified_parameters_are_the_true_ones() {
        let found = along_design();
        assert!((found.fit.standard_deviation() / NOISE - 1.0).abs() < 0.03);
        let standard_deviations = found.standard_deviations();
        for (k, error) in found.errors().into_iter().enumerate() {
            let standard_deviation = standard_deviations[k];
            assert!(error.abs() < 5.0 * standard_deviation, "{k}: {error}");
            assert!(standard_deviation < 0.05, "{k}: {standard_deviation}");
        }
    }

    #[test]
    fn torques_of_another_motion_are_explained_to_the_noise() {
        let [model, found] = along_design().unexplained();
        assert!(model > 10.0 * NOISE, "{model}");
        assert!((found / NOISE - 1.0).abs() < 0.05, "{found}");
    }
}

//! Whole-body control of a quadruped that sways, turns and squats: a quadratic program a step distributes the load on
//! its feet.
//!
//! The step of `step.rs` is written for any robot on a floating base. The robot is simulated in steps of 0.2 ms on
//! springs with friction, and controlled at 500 Hz. The sway grows until the feet of one side carry no load: then the
//! trunk lags, and the feet do not slip. Draws the errors of the trunk and the loads of the feet to
//! `target/whole_body.svg` or to the path given.

mod step;

use std::array::from_fn;
use std::f64::consts::TAU;
use std::io;

use homogen::{Action, Robot, Screw, vector};
use homogen_examples::drawing::over_time;
use homogen_examples::motion::largest;
use homogen_plot::{self as plot, Color, Curve, Page, Style};
use step::{BASE, Contact, Equation, Limits, Step, step};

#[derive(Robot)]
#[robot(urdf = "../../robots/quadruped.urdf", floating)]
#[robot(frames("base", "fl_foot", "fr_foot", "hl_foot", "hr_foot"))]
#[robot(external("fl_foot", "fr_foot", "hl_foot", "hr_foot", frame = 0))]
#[robot(generate(
    frame_poses,
    geometric_jacobian,
    geometric_jacobian_rate,
    all_of(mass_matrix, bias),
    forward_dynamics
))]
struct Quadruped;

const COORDINATES: usize = 19;
const VELOCITIES: usize = 18;
const FEET: usize = 4;

/// Period of the controller, steps of the simulation in it, and length of the run \[s\].
const PERIOD: f64 = 2e-3;
const STEPS: u32 = 10;
const END: f64 = 3.4;
/// Stiffness and damping of the ground under a foot [N/m, N s/m].
const GROUND: [f64; 2] = [2e4, 80.0];
/// The controller's coefficient of friction; that of the ground is a little larger.
const LIMITS: Limits = Limits {
    friction: 0.4,
    torque: 2.7,
};
const FRICTION: f64 = 0.5;
/// Gains of the trunk's errors, and of their rates [1/s², 1/s].
const GAINS: [f64; 2] = [400.0, 40.0];
/// Knees bent, hips above the feet \[rad\].
const LEG: [f64; 3] = [0.0, 0.6, -1.2];

type Coordinates = [f64; COORDINATES];
type Velocities = [f64; VELOCITIES];
type Vector = [f64; 3];

/// The desired position, velocity and acceleration of the trunk: x, y, z and the angle about z.
fn motion(t: f64) -> [[f64; 4]; 3] {
    let wave = |size: f64, rate: f64| {
        let (s, c) = (TAU * rate * t).sin_cos();
        let rate = TAU * rate;
        [size * (1.0 - c), size * rate * s, size * rate * rate * c]
    };
    // The lateral sway grows with time.
    let [w, wd, wdd] = wave(0.016, 1.5);
    let sway = [t * w, w + t * wd, 2.0 * wd + t * wdd];
    let (squat, turn) = (wave(-0.015, 0.5), wave(0.1, 0.25));
    [0, 1, 2].map(|k| [0.0, sway[k], squat[k], turn[k]])
}

struct Sample {
    t: f64,
    /// The error of the trunk \[rad, m\].
    error: [f64; BASE],
    /// The loads of the feet that the controller computed \[N\].
    forces: [Vector; FEET],
    /// The slip of the feet \[m\].
    slip: f64,
}

fn simulate() -> Vec<Sample> {
    let mut q = standing();
    let at_rest = q;
    let mut qd = [0.0; VELOCITIES];
    let mut ground = feet(&q).map(|[x, y, _]| [x, y]);
    let begin = ground;
    let times = (0_u32..).map(|k| f64::from(k) * PERIOD);
    let samples = times.take_while(|t| *t <= END).map(|t| {
        let (step, error) = control(t, &at_rest, &q, &qd);
        for _ in 0..STEPS {
            advance(&mut q, &mut qd, &step.tau, &mut ground);
        }
        let slips = ground.iter().zip(&begin);
        let slips = slips.flat_map(|(now, then)| [now[0] - then[0], now[1] - then[1]]);
        Sample {
            t,
            error,
            forces: step.forces,
            slip: largest(slips),
        }
    });
    samples.collect()
}

/// The configuration at rest, with the ground compressed by the weight.
fn standing() -> Coordinates {
    let mut q = Quadruped.neutral();
    for leg in q[7..].chunks_exact_mut(3) {
        leg.copy_from_slice(&LEG);
    }
    let (_, bias) = Quadruped.mass_matrix_and_bias(&q, &[0.0; VELOCITIES]);
    let sag = bias[2] / (4.0 * GROUND[0]);
    q[2] = -feet(&q)[0][2] - sag;
    q
}

fn feet(q: &Coordinates) -> [Vector; FEET] {
    let [_, feet @ ..] = Quadruped.frame_poses(q);
    feet.map(|pose| pose.translation())
}

fn jacobians(q: &Coordinates) -> [[Screw<f64>; VELOCITIES]; FEET] {
    [
        Quadruped.geometric_jacobian_of_fl_foot(q),
        Quadruped.geometric_jacobian_of_fr_foot(q),
        Quadruped.geometric_jacobian_of_hl_foot(q),
        Quadruped.geometric_jacobian_of_hr_foot(q),
    ]
}

fn contacts(q: &Coordinates, qd: &Velocities) -> [Contact<VELOCITIES>; FEET] {
    let rates = [
        Quadruped.geometric_jacobian_rate_of_fl_foot(q, qd),
        Quadruped.geometric_jacobian_rate_of_fr_foot(q, qd),
        Quadruped.geometric_jacobian_rate_of_hl_foot(q, qd),
        Quadruped.geometric_jacobian_rate_of_hr_foot(q, qd),
    ];
    let jacobians = jacobians(q);
    from_fn(|k| Contact {
        jacobian: jacobians[k],
        rate: rates[k],
    })
}

/// The control step for the motion of the trunk, and the error of the trunk.
fn control(
    t: f64,
    at_rest: &Coordinates,
    q: &Coordinates,
    qd: &Velocities,
) -> (Step<VELOCITIES, FEET>, [f64; BASE]) {
    let [place, rate, second] = motion(t);
    let mut there = *at_rest;
    for k in 0..3 {
        there[k] += place[k];
    }
    let (sine, cosine) = (0.5 * place[3]).sin_cos();
    there[3..7].copy_from_slice(&[0.0, 0.0, sine, cosine]);
    let apart = Quadruped.difference(q, &there);
    let error: [f64; BASE] = from_fn(|i| apart[i]);

    // In the axes of the trunk, like its velocities.
    let [axes, ..] = Quadruped.frame_poses(q);
    let turned = |v: [f64; 4]| -> [f64; BASE] {
        let turned: Vector = from_fn(|i| (0..3).map(|k| axes.rotation()[k][i] * v[k]).sum());
        from_fn(|i| {
            if i < 3 {
                turned[i]
            } else if i < 5 {
                0.0
            } else {
                v[3]
            }
        })
    };
    let (rate, second) = (turned(rate), turned(second));
    let dragged = vector::cross([qd[3], qd[4], qd[5]], [qd[0], qd[1], qd[2]]);
    let wanted = from_fn(|i| {
        let dragged = if i < 3 { dragged[i] } else { 0.0 };
        second[i] - dragged + GAINS[0] * error[i] + GAINS[1] * (rate[i] - qd[i])
    });
    let (mass_matrix, bias) = Quadruped.mass_matrix_and_bias(q, qd);
    let equation = Equation { mass_matrix, bias };
    let step = step(&equation, &contacts(q, qd), qd, &wanted, LIMITS);
    (step.expect("four feet can always stand"), error)
}

/// One step of the simulation; the anchor of a slipping foot moves with it.
fn advance(
    q: &mut Coordinates,
    qd: &mut Velocities,
    tau: &Velocities,
    ground: &mut [[f64; 2]; FEET],
) {
    let step = PERIOD / f64::from(STEPS);
    let [stiffness, damping] = GROUND;
    let (places, jacobians) = (feet(q), jacobians(q));
    let actions = from_fn(|k| {
        let place = places[k];
        let velocity: Vector = from_fn(|axis| {
            let terms = jacobians[k].iter().zip(&*qd);
            terms.map(|(screw, rate)| screw.b()[axis] * rate).sum()
        });
        let push = (-stiffness * place[2] - damping * velocity[2]).max(0.0);
        let push = if place[2] < 0.0 { push } else { 0.0 };
        let drag: [f64; 2] =
            from_fn(|axis| -stiffness * (place[axis] - ground[k][axis]) - damping * velocity[axis]);
        let share = (FRICTION * push / drag[0].hypot(drag[1])).min(1.0);
        if share < 1.0 {
            ground[k] = from_fn(|axis| place[axis] + share * drag[axis] / stiffness);
        }
        let force = [share * drag[0], share * drag[1], push];
        Action::new(vector::cross(place, force), force)
    });
    let qdd = Quadruped.forward_dynamics(q, qd, tau, &actions);
    for (rate, second) in qd.iter_mut().zip(&qdd) {
        *rate += step * second;
    }
    let moved = qd.map(|rate| step * rate);
    *q = Quadruped.integrate(q, &moved);
}

fn main() -> io::Result<()> {
    let samples = simulate();
    let worst = |entries: std::ops::Range<usize>| {
        largest(
            samples
                .iter()
                .flat_map(|sample| sample.error[entries.clone()].to_vec()),
        )
    };
    println!("Quadruped on four feet, {END} s, a quadratic program every two milliseconds");
    println!(
        "  trunk off by at most   {:.2} mm, {:.2} mrad",
        1e3 * worst(0..3),
        1e3 * worst(3..6)
    );
    println!(
        "  feet slipped by        {:.3} mm",
        1e3 * largest(samples.iter().map(|sample| sample.slip))
    );
    let path = plot::path_from_arguments("whole_body");
    plot::write(&path, &page(&samples))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

fn page(samples: &[Sample]) -> Page {
    let drawn = || samples.iter().step_by(5);
    let curve = |label: &str, color, of: &dyn Fn(&Sample) -> f64| Curve {
        label: label.to_owned(),
        points: drawn().map(|sample| [sample.t, of(sample)]).collect(),
        color,
        style: Style::Line,
    };
    let feet = [
        ("front left", Color::Blue),
        ("front right", Color::Vermilion),
        ("hind left", Color::Green),
        ("hind right", Color::Orange),
    ];
    let carried = feet
        .into_iter()
        .enumerate()
        .map(|(k, (label, color))| curve(label, color, &move |sample| sample.forces[k][2]));
    let asked = curve("asked of all, sideways", Color::Black, &|sample| {
        sample.forces.iter().map(|force| force[1]).sum()
    });
    Page {
        title: "A quadruped that sways more and more, on feet that must not slip".to_owned(),
        panels: vec![
            over_time(
                "trunk from where it should be",
                vec![
                    curve("place [mm]", Color::Blue, &|sample| {
                        1e3 * largest(sample.error[..3].to_vec())
                    }),
                    curve("axes [mrad]", Color::Vermilion, &|sample| {
                        1e3 * largest(sample.error[3..].to_vec())
                    }),
                ],
            ),
            over_time("force of the ground [N]", carried.chain([asked]).collect()),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{LIMITS, simulate};
    use homogen_examples::motion::largest;

    #[test]
    fn the_trunk_follows_its_motion_and_the_feet_do_not_slip() {
        let samples = simulate();
        for sample in &samples {
            for [x, y, z] in sample.forces {
                let most = LIMITS.friction * z + 1e-6;
                assert!(
                    z > -1e-6 && x.abs() <= most && y.abs() <= most,
                    "{x} {y} {z} at {}",
                    sample.t
                );
            }
            assert!(sample.slip < 2e-3, "{} at {}", sample.slip, sample.t);
            // Until the feet of one side carry no load.
            let most = if sample.t < 2.9 { 5e-4 } else { 0.05 };
            assert!(
                largest(sample.error) < most,
                "{:?} at {}",
                sample.error,
                sample.t
            );
        }
        let sideways =
            |sample: &super::Sample| sample.forces.iter().map(|force| force[1]).sum::<f64>();
        assert!(
            largest(samples.iter().map(sideways)) > 8.0,
            "the test is too easy"
        );
    }
}

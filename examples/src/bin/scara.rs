//! A SCARA robot that carries its tool along a straight line: direct and inverse kinematics, and the
//! forces and torques of the motion.
//!
//! `cargo run --release -p homogen-examples --bin scara [picture.svg]`
//!
//! The inverse is the closed form of two parallel axes; rates follow from the generated Jacobian,
//! accelerations from H at q̈ = 0, forces and torques from the generated inverse dynamics.

use std::f64::consts::PI;
use std::io;

use homogen::{Point, Robot};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};

/// Reach of the inner and of the outer arm, and the height of the tool at q₃ = 0 \[m\].
const REACH: [f64; 2] = [0.425, 0.375];
const HEIGHT: f64 = 0.677;

/// Start and end of the line \[m\].
const LINE: [[f64; 3]; 2] = [[0.55, -0.30, 0.60], [0.35, 0.40, 0.53]];

/// Duration of the motion \[s\] and its time steps.
const DURATION: f64 = 0.6;
const STEPS: u32 = 300;

#[derive(Robot)]
#[robot(
    urdf = "../robots/scara.urdf",
    tip = "tool",
    generate(forward_kinematics, geometric_jacobian, acceleration, inverse_dynamics)
)]
struct Scara;

/// One moment of the motion.
struct Moment {
    time: f64,
    q: [f64; 4],
    torques: [f64; 4],
    /// Distance of the tool from its desired position \[m\].
    miss: f64,
}

fn main() -> io::Result<()> {
    let motion = motion();
    let miss = motion
        .iter()
        .fold(0.0, |most: f64, moment| most.max(moment.miss));
    let peak = |joint: usize| {
        motion.iter().fold(0.0, |most: f64, moment| {
            most.max(moment.torques[joint].abs())
        })
    };
    println!(
        "A line of {:.3} m in {DURATION} s, {STEPS} steps.",
        length()
    );
    println!("The tool stays within {miss:.1e} m of it.");
    println!(
        "Largest torques: shoulder {:.1} N m, elbow {:.1} N m; lift {:.1} N.",
        peak(0),
        peak(1),
        peak(2)
    );
    let path = plot::path_from_arguments("scara");
    plot::write(&path, &page(&motion))?;
    println!("Drawn in {}.", path.display());
    Ok(())
}

fn length() -> f64 {
    let [from, to] = LINE;
    (0..3)
        .map(|k| (to[k] - from[k]).powi(2))
        .sum::<f64>()
        .sqrt()
}

/// The coordinates at which the tool is at a point, with its x axis at the angle `yaw` to that of the base and the
/// elbow to the right; `None` if the point is out of reach.
fn inverse([x, y, z]: [f64; 3], yaw: f64) -> Option<[f64; 4]> {
    let [inner, outer] = REACH;
    let cosine = (x * x + y * y - inner * inner - outer * outer) / (2.0 * inner * outer);
    if cosine.abs() > 1.0 {
        return None;
    }
    // z points down from the elbow on: angles have the opposite sign.
    let elbow = -cosine.acos();
    let shoulder = y.atan2(x) - (outer * (-elbow).sin()).atan2(inner + outer * cosine);
    Some([shoulder, elbow, HEIGHT - z, shoulder - elbow - yaw])
}

fn motion() -> Vec<Moment> {
    (0..=STEPS)
        .map(|step| {
            let time = DURATION * f64::from(step) / f64::from(STEPS);
            moment(time)
        })
        .collect()
}

fn moment(time: f64) -> Moment {
    // From rest to rest: s = 10 τ³ − 15 τ⁴ + 6 τ⁵.
    let t = time / DURATION;
    let along = t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t);
    let rate = 30.0 * t * t * (1.0 - t).powi(2) / DURATION;
    let second = 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t) / DURATION.powi(2);
    let [from, to] = LINE;
    let span: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
    let place: [f64; 3] = std::array::from_fn(|k| from[k] + span[k] * along);

    let q = inverse(place, 0.0).expect("the line is within reach");
    let pose = Scara.forward_kinematics(&q);
    let qd = rates(&q, span.map(|s| s * rate));
    // J q̈ = a − (acceleration of the tip at q̈ = 0).
    let h = Scara.acceleration(&q, &qd, &[0.0; 4]);
    let tip = Point(pose.translation());
    let drift = (h * tip).0;
    let qdd = rates(&q, std::array::from_fn(|k| span[k] * second - drift[k]));
    let found = pose.translation();
    let miss = (0..3)
        .map(|k| (found[k] - place[k]).powi(2))
        .sum::<f64>()
        .sqrt();
    Moment {
        time,
        q,
        torques: Scara.inverse_dynamics(&q, &qd, &qdd),
        miss,
    }
}

/// The rates of the joints for a velocity of the tool without rotation.
fn rates(q: &[f64; 4], [x, y, z]: [f64; 3]) -> [f64; 4] {
    let columns = Scara.geometric_jacobian(q);
    let ([ax, ay, _], [bx, by, _]) = (columns[0].b(), columns[1].b());
    let determinant = ax * by - bx * ay;
    let shoulder = (x * by - bx * y) / determinant;
    let elbow = (ax * y - x * ay) / determinant;
    [shoulder, elbow, -z, shoulder - elbow]
}

fn page(motion: &[Moment]) -> Page {
    let over_time = |label, curves| Panel {
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
        height: 230.0,
        to_scale: false,
    };
    let curve = |label: &str, of: &dyn Fn(&Moment) -> f64, color, style| Curve {
        label: label.into(),
        points: motion
            .iter()
            .map(|moment| [moment.time, of(moment)])
            .collect(),
        color,
        style,
    };
    let angle = |joint: usize| move |moment: &Moment| moment.q[joint] * 180.0 / PI;
    let torque = |joint: usize| move |moment: &Moment| moment.torques[joint];
    Page {
        title: "SCARA: a straight line from rest to rest".into(),
        panels: vec![
            over_time(
                "angle [°]",
                vec![
                    curve("shoulder", &angle(0), Color::Blue, Style::Line),
                    curve("elbow", &angle(1), Color::Vermilion, Style::Line),
                    curve("roll", &angle(3), Color::Green, Style::Dashed),
                ],
            ),
            over_time(
                "torque, force",
                vec![
                    curve("shoulder [N m]", &torque(0), Color::Blue, Style::Line),
                    curve("elbow [N m]", &torque(1), Color::Vermilion, Style::Line),
                    curve("lift [N]", &torque(2), Color::Black, Style::Dashed),
                ],
            ),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{DURATION, LINE, REACH, Scara, inverse, moment, motion};

    /// z and i z, for rotations in the plane.
    type Complex = [f64; 2];

    fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
        [a * c - b * d, a * d + b * c]
    }

    /// First and second derivatives at a time, by differences of sixth order.
    fn derivatives(time: f64) -> [[f64; 4]; 2] {
        let step = 2e-3;
        let pairs = [1.0, 2.0, 3.0].map(|k| [k, -k].map(|k| moment(time + k * step).q));
        let here = moment(time).q;
        let sum = |weights: [f64; 3], of: &dyn Fn(f64, f64, f64) -> f64, k: usize| -> f64 {
            let terms = weights.iter().zip(&pairs);
            terms.map(|(w, [p, m])| w * of(p[k], here[k], m[k])).sum()
        };
        let first = |p: f64, _: f64, m: f64| p - m;
        let second = |p: f64, at: f64, m: f64| (p - at) + (m - at);
        [
            std::array::from_fn(|k| sum([0.75, -0.15, 1.0 / 60.0], &first, k) / step),
            std::array::from_fn(|k| sum([1.5, -0.15, 1.0 / 90.0], &second, k) / step.powi(2)),
        ]
    }

    /// The torques of masses in a plane by d'Alembert's principle, with the numbers at the head of `scara.urdf`. The
    /// angles of inner arm, outer arm and flange are relative to the base.
    fn closed_form(q: [f64; 4], qd: [f64; 4], qdd: [f64; 4]) -> [f64; 4] {
        let absolute = |q: [f64; 4]| [q[0], q[0] - q[1], q[0] - q[1] - q[3]];
        let (at, rate, second) = (absolute(q), absolute(qd), absolute(qdd));
        let unit = at.map(|angle| [angle.cos(), angle.sin()]);
        // Mass, and the coordinates of its centre along each link.
        let [inner, outer] = REACH;
        let bodies = [
            (14.0, [0.18, 0.0, 0.0]),
            (8.0, [inner, 0.16, 0.0]),
            (2.2, [inner, outer, 0.0]),
            (0.8, [inner, outer, 0.005]),
        ];
        let spins = [0.46667, 0.22327 + 0.00099, 0.00049];
        let mut along = [0.0; 3];
        for j in 0..3 {
            along[j] = spins[j] * second[j];
            for (mass, reach) in &bodies {
                // p̈ = Σ r (i φ̈ − φ̇²) e^{iφ}, and ∂p/∂φ = i r e^{iφ}.
                let accelerations = (0..3).map(|k| {
                    let [x, y] = times([-rate[k].powi(2), second[k]], unit[k]);
                    [reach[k] * x, reach[k] * y]
                });
                let p = accelerations.fold([0.0; 2], |sum, a| [sum[0] + a[0], sum[1] + a[1]]);
                let way = times([0.0, reach[j]], unit[j]);
                along[j] += mass * (p[0] * way[0] + p[1] * way[1]);
            }
        }
        let [inner, outer, flange] = along;
        let lift = 3.0 * (qdd[2] - 9.81);
        [inner + outer + flange, -outer - flange, lift, -flange]
    }

    #[test]
    fn the_torques_are_those_of_masses_in_a_plane() {
        let mut largest = 0.0_f64;
        for k in 1..=9 {
            let time = 0.1 * f64::from(k) * DURATION;
            let moment = moment(time);
            let [qd, qdd] = derivatives(time);
            let known = closed_form(moment.q, qd, qdd);
            for (found, known) in moment.torques.into_iter().zip(known) {
                assert!((found - known).abs() < 1e-6, "{found} is not {known}");
                largest = largest.max(known.abs());
            }
        }
        assert!(largest > 50.0, "{largest}");
    }

    #[test]
    fn the_inverse_undoes_the_direct_kinematics() {
        for (place, yaw) in [(LINE[0], 0.3), (LINE[1], -1.1), ([0.1, 0.5, 0.6], 2.0)] {
            let q = inverse(place, yaw).expect("within reach");
            let pose = Scara.forward_kinematics(&q);
            for (found, wanted) in pose.translation().into_iter().zip(place) {
                assert!((found - wanted).abs() < 1e-15);
            }
            let x = pose.rotation().map(|row| row[0]);
            assert!((x[0] - yaw.cos()).abs() < 1e-15 && (x[1] - yaw.sin()).abs() < 1e-15);
        }
        assert!(inverse([0.9, 0.0, 0.6], 0.0).is_none());
    }

    #[test]
    fn the_work_of_the_torques_lowers_the_tool() {
        // From rest to rest, the work of the joints is the change of potential energy of the quill and the flange,
        // 3 kg, which move down.
        let motion = motion();
        let work: f64 = motion
            .windows(2)
            .map(|pair| {
                let force = |k: usize| 0.5 * (pair[0].torques[k] + pair[1].torques[k]);
                (0..4)
                    .map(|k| force(k) * (pair[1].q[k] - pair[0].q[k]))
                    .sum::<f64>()
            })
            .sum();
        let gained = 3.0 * 9.81 * (LINE[1][2] - LINE[0][2]);
        assert!(
            (work - gained).abs() < 1e-3 * gained.abs(),
            "{work} for {gained}"
        );
    }

    #[test]
    fn the_motion_rests_at_both_ends() {
        for time in [0.0, DURATION] {
            let hold = moment(time).torques;
            assert!((hold[2] + 3.0 * 9.81).abs() < 1e-9, "{hold:?}");
            assert!(hold[0].abs() < 1e-9 && hold[1].abs() < 1e-9, "{hold:?}");
        }
    }
}

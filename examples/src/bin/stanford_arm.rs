//! The Stanford arm along a motion: direct kinematics and inverse dynamics.
//!
//! `cargo run --release -p homogen-examples --bin stanford_arm [picture.svg]`
//!
//! The arm of Part II moves from one configuration to another in two seconds. Torques come from Newton–Euler and from
//! Lagrange's equations; the work of the joints is compared with the energy of the arm.

use homogen::open_chain::{self, motions};
use homogen::worked_examples::stanford_arm::{self, OFFSET, SHOULDER};
use homogen::{Action, Chain, lagrange};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use std::array::from_fn;
use std::error::Error;

/// \[s\].
const DURATION: f64 = 2.0;

/// An even number, for Simpson's rule.
const STEPS: u32 = 400;

/// Coordinates [rad, m] at the beginning and at the end.
const FROM: [f64; 6] = [-0.2, 0.5, 0.35, 0.0, 0.6, 0.0];
const TO: [f64; 6] = [0.5, 1.9, 0.75, 1.2, -0.7, 0.9];

/// One moment of the motion.
struct Moment {
    time: f64,
    q: [f64; 6],
    qd: [f64; 6],
    /// By Newton–Euler and by Lagrange [N m, N].
    torques: [[f64; 6]; 2],
    /// Kinetic and potential energy \[J\].
    energy: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let chain = stanford_arm::chain();
    let motion = motion(&chain);
    println!("Stanford arm, {DURATION} s from rest to rest");
    for moment in [motion.first(), motion.last()].into_iter().flatten() {
        let [x, y, z] = stanford_arm::tool_pose(&moment.q).translation();
        println!(
            "  tool at {x:.3} {y:.3} {z:.3} m after {:.1} s",
            moment.time
        );
    }
    for (i, joint) in chain.joints.iter().enumerate() {
        let torques = motion.iter().map(|moment| moment.torques[0][i].abs());
        let unit = if i == 2 { "N" } else { "N m" };
        println!(
            "  {:8} up to {:6.2} {unit}",
            joint.name,
            torques.fold(0.0, f64::max)
        );
    }
    println!(
        "  Newton–Euler and Lagrange differ by {:.1e} at most",
        disagreement(&motion)
    );
    let [work, gain] = balance(&motion);
    println!("  work of the joints {work:.9} J, energy gained {gain:.9} J");
    let path = plot::path_from_arguments("stanford_arm");
    plot::write(&path, &page(&motion))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

fn motion(chain: &Chain<6, 1>) -> Vec<Moment> {
    let free = [Action::zero(); 6];
    (0..=STEPS)
        .map(|k| {
            let time = DURATION * f64::from(k) / f64::from(STEPS);
            let [s, s_d, s_dd] = smooth(time / DURATION);
            let span: [f64; 6] = from_fn(|i| TO[i] - FROM[i]);
            let q = from_fn(|i| FROM[i] + span[i] * s);
            let qd = span.map(|x| x * s_d / DURATION);
            let qdd = span.map(|x| x * s_dd / (DURATION * DURATION));
            let motions = motions(chain, &q, &qd, &qdd);
            let inertias = open_chain::inertias(chain, &motions.map(|motion| motion.pose));
            let bodies = inertias.iter().zip(&motions);
            Moment {
                time,
                q,
                qd,
                torques: [
                    open_chain::inverse_dynamics(chain, &q, &qd, &qdd, &free),
                    lagrange::inverse_dynamics(chain, &q, &qd, &qdd, &free),
                ],
                energy: bodies
                    .map(|(j, motion)| {
                        j.kinetic_energy(&motion.velocity) + j.potential_energy(chain.gravity)
                    })
                    .sum(),
            }
        })
        .collect()
}

/// A path from 0 to 1 without velocity and acceleration at both ends, and its first two derivatives.
fn smooth(x: f64) -> [f64; 3] {
    [
        x * x * x * (10.0 + x * (6.0 * x - 15.0)),
        30.0 * x * x * (1.0 - x) * (1.0 - x),
        60.0 * x * (1.0 - x) * (1.0 - 2.0 * x),
    ]
}

/// The largest difference of the two formulations of the dynamics [N m, N].
fn disagreement(motion: &[Moment]) -> f64 {
    let joints = motion.iter().flat_map(|moment| {
        let [newton, energy] = moment.torques;
        (0..6).map(move |i| (newton[i] - energy[i]).abs())
    });
    joints.fold(0.0, f64::max)
}

/// The work of the joints, by Simpson's rule, and the energy gained \[J\].
fn balance(motion: &[Moment]) -> [f64; 2] {
    let power = |moment: &Moment| -> f64 {
        let joints = moment.torques[0].iter().zip(&moment.qd);
        joints.map(|(torque, rate)| torque * rate).sum()
    };
    let h = DURATION / f64::from(STEPS);
    let work = motion
        .windows(3)
        .step_by(2)
        .map(|m| h / 3.0 * (power(&m[0]) + 4.0 * power(&m[1]) + power(&m[2])))
        .sum();
    let energy = |moment: Option<&Moment>| moment.map_or(f64::NAN, |moment| moment.energy);
    [work, energy(motion.last()) - energy(motion.first())]
}

/// Base, shoulder, boom, wrist and tool, seen along y \[m\].
fn side_view(q: &[f64; 6]) -> Vec<[f64; 2]> {
    let boom = stanford_arm::boom_pose(q);
    let (s_1, _) = q[0].sin_cos();
    let tool = stanford_arm::tool_pose(q).translation();
    let wrist = boom.translation();
    vec![
        [0.0, 0.0],
        [0.0, SHOULDER],
        [-OFFSET * s_1, SHOULDER],
        [wrist[0], wrist[2]],
        [tool[0], tool[2]],
    ]
}

fn page(motion: &[Moment]) -> Page {
    let axis = |label| Axis {
        label,
        scale: Scale::Linear,
    };
    let torque = |label: &str, joint: usize, color, style| Curve {
        label: label.into(),
        points: motion
            .iter()
            .map(|moment| [moment.time, moment.torques[0][joint]])
            .collect(),
        color,
        style,
    };
    let over_time = |label, curves| Panel {
        x: axis("time [s]"),
        y: axis(label),
        curves,
        marks: Vec::new(),
        height: 230.0,
        to_scale: false,
    };
    Page {
        title: "Stanford arm: two seconds from rest to rest".into(),
        panels: vec![
            Panel {
                x: axis("x [m]"),
                y: axis("z [m]"),
                curves: skeletons(motion),
                marks: Vec::new(),
                height: 420.0,
                to_scale: true,
            },
            over_time(
                "torque, force",
                vec![
                    torque("waist [N m]", 0, Color::Blue, Style::Line),
                    torque("shoulder [N m]", 1, Color::Vermilion, Style::Line),
                    torque("boom [N]", 2, Color::Black, Style::Dashed),
                ],
            ),
            over_time(
                "torque [N m]",
                vec![
                    torque("forearm", 3, Color::Blue, Style::Line),
                    torque("wrist", 4, Color::Orange, Style::Line),
                    torque("hand", 5, Color::Green, Style::Dashed),
                ],
            ),
        ],
    }
}

/// The arm at some times, and the path of the tool.
fn skeletons(motion: &[Moment]) -> Vec<Curve> {
    let skeleton = |moment: &Moment, label: &str, color, style| Curve {
        label: label.into(),
        points: side_view(&moment.q),
        color,
        style,
    };
    let between = motion.iter().skip(1).step_by(40);
    let mut curves: Vec<Curve> = between
        .map(|moment| skeleton(moment, "", Color::Grey, Style::Thin))
        .collect();
    curves.push(Curve {
        label: "way of the tool".into(),
        points: motion
            .iter()
            .filter_map(|m| side_view(&m.q).last().copied())
            .collect(),
        color: Color::Orange,
        style: Style::Dashed,
    });
    let ends = [motion.first(), motion.last()].into_iter().flatten();
    let looks = [("start", Color::Blue), ("end", Color::Vermilion)];
    curves.extend(
        ends.zip(looks)
            .map(|(moment, (label, color))| skeleton(moment, label, color, Style::Links)),
    );
    curves
}

#[cfg(test)]
mod tests {
    use super::{balance, disagreement, motion, smooth, stanford_arm};

    #[test]
    fn work_becomes_energy() {
        let motion = motion(&stanford_arm::chain());
        let [work, gain] = balance(&motion);
        assert!((work - gain).abs() < 1e-8, "{work} J but {gain} J");
        assert!(gain.abs() > 1.0);
    }

    #[test]
    fn both_formulations_of_the_dynamics_agree() {
        let difference = disagreement(&motion(&stanford_arm::chain()));
        assert!(difference > 0.0 && difference < 1e-13, "{difference}");
    }

    #[test]
    fn the_motion_is_smooth() {
        let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        assert!(close(smooth(0.0), [0.0; 3]) && close(smooth(1.0), [1.0, 0.0, 0.0]));
        let h = 1e-4;
        for x in [0.2, 0.5, 0.9] {
            let ([before, ..], [after, ..]) = (smooth(x - h), smooth(x + h));
            let [at, slope, second] = smooth(x);
            assert!(((after - before) / (2.0 * h) - slope).abs() < 1e-6);
            assert!(((after - 2.0 * at + before) / (h * h) - second).abs() < 1e-5);
        }
    }
}

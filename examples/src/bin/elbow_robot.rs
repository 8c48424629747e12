//! Direct and inverse kinematics of an elbow robot: Newton–Raphson along a circle, and from one start to random poses.
//!
//! `cargo run --release -p homogen-examples --bin elbow_robot [picture.svg]`
//!
//! Six revolute joints: waist, shoulder, elbow and a wrist of three axes through one point. A pose is reached by
//! closing the loop from the base through the robot and back from the pose, with the solver of closed loops.

use homogen::loop_closure::{self, ClosedChain, NotClosed, Position};
use homogen::robot::ForwardKinematics;
use homogen::{Chain, Frame, Inertia, Joint, Pose, Screw, open_chain, rotation};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};
use homogen_random::Random;
use std::array::from_fn;
use std::error::Error;
use std::f64::consts::TAU;

/// Points of the circle.
const POINTS: u32 = 180;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn main() -> Result<(), Box<dyn Error>> {
    let robot = robot();
    let way = follow_circle(&robot)?;
    let most = way.iter().map(|found| found.iterations).max();
    let residual = way.iter().map(|found| found.residual).fold(0.0, f64::max);
    println!("elbow robot, the tool on a circle of 240 mm in {POINTS} points");
    println!(
        "  each from the one before: at most {} steps, residual {residual:.1e}",
        most.unwrap_or(0)
    );
    let trials = from_anywhere(&robot, 1000);
    let mut steps: Vec<usize> = trials
        .iter()
        .flatten()
        .map(|found| found.iterations)
        .collect();
    steps.sort_unstable();
    println!(
        "  1000 random poses from one start: {} reached, half of them in {} steps or fewer",
        steps.len(),
        steps.get(steps.len() / 2).copied().unwrap_or(0)
    );
    let beyond = ClosedChain::tip_at(robot, Pose::from_translation([1.5, 0.0, 0.4]));
    if let Err(error) = loop_closure::position(&beyond, &[None; 6], &START) {
        println!("  a pose 1.5 m away: {error}");
    }
    let path = plot::path_from_arguments("elbow_robot");
    plot::write(&path, &page(&robot, &way))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

/// A regular configuration with the elbow up \[rad\].
const START: [f64; 6] = [0.1, -0.7, 1.3, 0.2, -0.6, 0.1];

/// The robot, stretched out along x at q = 0, without masses.
fn robot() -> Chain<6, 1> {
    let joint = |name, parent, at, axis| {
        let (placement, about) = (Pose::from_translation(at), Screw::revolute(axis, [0.0; 3]));
        Joint::new(name, parent, placement, about, Inertia::zero())
    };
    Chain::new(
        [
            joint("waist", None, [0.0, 0.0, 0.0], Z),
            joint("shoulder", Some(0), [0.0, 0.0, 0.4], Y),
            joint("elbow", Some(1), [0.42, 0.0, 0.0], Y),
            joint("roll", Some(2), [0.38, 0.0, 0.0], X),
            joint("pitch", Some(3), [0.0; 3], Y),
            joint("hand", Some(4), [0.0; 3], X),
        ],
        [Frame::new(
            "tool",
            Some(5),
            Pose::from_translation([0.1, 0.0, 0.0]),
        )],
        [0.0, 0.0, -9.81],
    )
}

/// A circle in an inclined plane, with the tool pointing forward and down.
fn target(point: u32) -> Pose<f64> {
    let (s, c) = (TAU * f64::from(point) / f64::from(POINTS)).sin_cos();
    Pose::new(
        rotation::from_axis_angle(Y, 1.3),
        [0.5 + 0.06 * s, 0.12 * c, 0.45 + 0.12 * s],
    )
}

/// The coordinates at every point of the circle.
fn follow_circle(robot: &Chain<6, 1>) -> Result<Vec<Position<f64, 6>>, NotClosed> {
    let mut q = START;
    (0..=POINTS)
        .map(|point| {
            let closed = ClosedChain::tip_at(*robot, target(point));
            let found = loop_closure::position(&closed, &[None; 6], &q)?;
            q = found.q;
            Ok(found)
        })
        .collect()
}

/// Random poses that the robot can reach, all from the same start.
fn from_anywhere(robot: &Chain<6, 1>, poses: u32) -> Vec<Result<Position<f64, 6>, NotClosed>> {
    let mut random = Random::new(1);
    (0..poses)
        .map(|_| {
            let q: [f64; 6] = from_fn(|_| 2.5 * random.unit());
            let closed = ClosedChain::tip_at(*robot, robot.forward_kinematics(&q));
            loop_closure::position(&closed, &[None; 6], &START)
        })
        .collect()
}

/// Base, shoulder, elbow, wrist and tool, seen obliquely \[m\].
fn oblique_view(robot: &Chain<6, 1>, q: &[f64; 6]) -> Vec<[f64; 2]> {
    let [_, shoulder, elbow, wrist, ..] = open_chain::poses(robot, q);
    let tool = robot.forward_kinematics(q);
    [Pose::identity(), shoulder, elbow, wrist, tool]
        .map(|pose| {
            let [x, y, z] = pose.translation();
            [x + 0.5 * y, z + 0.25 * y]
        })
        .to_vec()
}

fn page(robot: &Chain<6, 1>, way: &[Position<f64, 6>]) -> Page {
    let axis = |label| Axis {
        label,
        scale: Scale::Linear,
    };
    let skeleton = |found: &Position<f64, 6>, label: &str, color, style| Curve {
        label: label.into(),
        points: oblique_view(robot, &found.q),
        color,
        style,
    };
    let mut arm: Vec<Curve> = way
        .iter()
        .step_by(15)
        .map(|found| skeleton(found, "", Color::Grey, Style::Thin))
        .collect();
    arm.extend(
        way.iter()
            .take(1)
            .map(|found| skeleton(found, "robot", Color::Blue, Style::Links)),
    );
    let tool = way
        .iter()
        .filter_map(|found| oblique_view(robot, &found.q).last().copied());
    arm.push(Curve {
        label: "way of the tool".into(),
        points: tool.collect(),
        color: Color::Vermilion,
        style: Style::Line,
    });
    let looks = [
        (Color::Blue, Style::Line),
        (Color::Orange, Style::Line),
        (Color::Green, Style::Line),
        (Color::Vermilion, Style::Dashed),
        (Color::Sky, Style::Dashed),
        (Color::Black, Style::Dashed),
    ];
    let over_circle = |value: &dyn Fn(&Position<f64, 6>) -> f64| {
        way.iter()
            .zip(0_u32..)
            .map(|(found, k)| [360.0 * f64::from(k) / f64::from(POINTS), value(found)])
            .collect()
    };
    let joints = robot.joints.iter().zip(looks).enumerate();
    let joints = joints.map(|(i, (joint, (color, style)))| Curve {
        label: joint.name.into(),
        points: over_circle(&|found| found.q[i].to_degrees()),
        color,
        style,
    });
    let panel = |x, label, curves, height, to_scale| Panel {
        x,
        y: axis(label),
        curves,
        marks: Vec::new(),
        height,
        to_scale,
    };
    let along = Axis {
        label: "place on the circle [°]",
        scale: Scale::Every(45.0),
    };
    Page {
        title: "Elbow robot: a circle by Newton–Raphson".into(),
        panels: vec![
            panel(axis("x + 0.5 y [m]"), "z + 0.25 y [m]", arm, 420.0, true),
            panel(along, "joint angle [°]", joints.collect(), 270.0, false),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{POINTS, follow_circle, from_anywhere, robot, target};
    use homogen::robot::ForwardKinematics;
    use std::f64::consts::TAU;

    /// The rotation about z, y or x, as an explicit matrix.
    fn rotation(axis: char, angle: f64) -> [[f64; 3]; 3] {
        let (s, c) = angle.sin_cos();
        match axis {
            'z' => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
            'y' => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
            _ => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        }
    }

    fn product(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
        a.map(|row| std::array::from_fn(|j| (0..3).map(|k| row[k] * b[k][j]).sum()))
    }

    /// Rows of R and the position of the tool, from the lengths of the robot: the arm in its vertical plane, rotated
    /// by the waist, and 0.1 m along the hand.
    fn closed_form(q: &[f64; 6]) -> ([[f64; 3]; 3], [f64; 3]) {
        let (upper, fore) = (q[1], q[1] + q[2]);
        let out = 0.42 * upper.cos() + 0.38 * fore.cos();
        let up = 0.4 - 0.42 * upper.sin() - 0.38 * fore.sin();
        let axes = [
            ('z', q[0]),
            ('y', fore),
            ('x', q[3]),
            ('y', q[4]),
            ('x', q[5]),
        ];
        let r = axes[1..]
            .iter()
            .fold(rotation('z', q[0]), |r, (axis, angle)| {
                product(r, rotation(*axis, *angle))
            });
        let (s, c) = q[0].sin_cos();
        let wrist = [c * out, s * out, up];
        (r, std::array::from_fn(|k| wrist[k] + 0.1 * r[k][0]))
    }

    fn apart(a: ([[f64; 3]; 3], [f64; 3]), b: ([[f64; 3]; 3], [f64; 3])) -> f64 {
        let pairs = a.0.as_flattened().iter().zip(b.0.as_flattened());
        let all = pairs.chain(a.1.iter().zip(&b.1));
        all.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    }

    #[test]
    fn the_direct_kinematics_are_the_closed_form() {
        let robot = robot();
        for trial in from_anywhere(&robot, 100).into_iter().flatten() {
            let pose = robot.forward_kinematics(&trial.q);
            let found = (*pose.rotation(), pose.translation());
            assert!(apart(found, closed_form(&trial.q)) < 4e-15);
        }
    }

    #[test]
    fn the_inverse_kinematics_lead_to_the_circle_by_the_closed_form() {
        let way = follow_circle(&robot()).expect("the circle is within reach");
        for (found, point) in way.iter().zip(0_u32..) {
            let (s, c) = (TAU * f64::from(point) / f64::from(POINTS)).sin_cos();
            let circle = [0.5 + 0.06 * s, 0.12 * c, 0.45 + 0.12 * s];
            let error = apart(closed_form(&found.q), (rotation('y', 1.3), circle));
            assert!(error < 8e-15, "{error:e} at {point}");
        }
    }

    #[test]
    fn the_tool_is_on_the_circle() {
        let robot = robot();
        let way = follow_circle(&robot).expect("the circle is within reach");
        for (found, point) in way.iter().zip(0..) {
            let reached = robot.forward_kinematics(&found.q).to_matrix();
            let target = target(point).to_matrix();
            for (a, b) in reached.as_flattened().iter().zip(target.as_flattened()) {
                assert!((a - b).abs() < 4e-15, "at {point}");
            }
            assert!(point == 0 || found.iterations <= 8);
        }
        // The closed circle ends at its start.
        let (first, last) = (&way[0].q, &way[usize::try_from(POINTS).expect("small")].q);
        assert!(first.iter().zip(last).all(|(a, b)| (a - b).abs() < 1e-13));
    }

    #[test]
    fn most_poses_are_reached_from_one_start() {
        let trials = from_anywhere(&robot(), 200);
        let reached = trials.iter().filter(|trial| trial.is_ok()).count();
        assert!(reached >= 160, "{reached} of 200");
        assert!(trials.iter().flatten().all(|found| found.residual < 1e-14));
    }
}

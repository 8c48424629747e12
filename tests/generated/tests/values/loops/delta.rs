//! A Delta robot, compared with spheres: the balls of the platform are at the distance of a forearm from the elbows.

use std::array::from_fn;
use std::f64::consts::TAU;

use homogen::loop_closure::{ClosureOutcome, project, regularity};

use super::{difference, largest};

homogen::chain! {
    /// Arms of 0.2 m on a base of 0.1 m, forearms of 0.45 m to a platform of 0.05 m. The platform only translates, as
    /// with parallelograms of forearms, for each of which one bar stands.
    pub struct Delta {
        generate(
            constraint, constraint_jacobian, constraint_bias, constrained_forward_dynamics,
            inverse_dynamics, actuated_inverse_dynamics,
        ),
        actuated(arm_1, arm_2, arm_3)
    }
    link base;
    joint arm_1: revolute(y) { at: rz(0) xyz(0.1, 0.0, 0.0) }
    link arm_1 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint elbow_1: universal(y, x) { at: xyz(0.2, 0.0, 0.0) }
    link forearm_1 { mass: 0.1, com: [0.0, 0.0, -0.22], inertia: [2e-3, 2e-3, 1e-5] }
    joint arm_2: revolute(y) { from: base, at: rz(2*pi/3) xyz(0.1, 0.0, 0.0) }
    link arm_2 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint elbow_2: universal(y, x) { at: xyz(0.2, 0.0, 0.0) }
    link forearm_2 { mass: 0.1, com: [0.0, 0.0, -0.22], inertia: [2e-3, 2e-3, 1e-5] }
    joint arm_3: revolute(y) { from: base, at: rz(4*pi/3) xyz(0.1, 0.0, 0.0) }
    link arm_3 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint elbow_3: universal(y, x) { at: xyz(0.2, 0.0, 0.0) }
    link forearm_3 { mass: 0.1, com: [0.0, 0.0, -0.22], inertia: [2e-3, 2e-3, 1e-5] }
    joint p: translation { from: base }
    link platform { mass: 0.5, com: [0.0, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
    loop ball_1: spherical { from: platform, to: forearm_1, at: rz(0) xyz(0.05, 0.0, 0.0), to_at: xyz(0.0, 0.0, -0.45) }
    loop ball_2: spherical { from: platform, to: forearm_2, at: rz(2*pi/3) xyz(0.05, 0.0, 0.0), to_at: xyz(0.0, 0.0, -0.45) }
    loop ball_3: spherical { from: platform, to: forearm_3, at: rz(4*pi/3) xyz(0.05, 0.0, 0.0), to_at: xyz(0.0, 0.0, -0.45) }
}

homogen::chain! {
    /// The same with massless forearms.
    pub struct Light { generate(constraint, constraint_jacobian, constraint_bias, constrained_forward_dynamics) }
    link base;
    joint arm_1: revolute(y) { at: rz(0) xyz(0.1, 0.0, 0.0) }
    link arm_1 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint arm_2: revolute(y) { from: base, at: rz(2*pi/3) xyz(0.1, 0.0, 0.0) }
    link arm_2 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint arm_3: revolute(y) { from: base, at: rz(4*pi/3) xyz(0.1, 0.0, 0.0) }
    link arm_3 { mass: 0.3, com: [0.08, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    joint p: translation { from: base }
    link platform { mass: 0.5, com: [0.0, 0.0, 0.0], inertia: [1e-3, 1e-3, 1e-3] }
    loop bar_1: rod(0.45) { from: arm_1, to: platform, at: xyz(0.2, 0.0, 0.0), to_at: rz(0) xyz(0.05, 0.0, 0.0) }
    loop bar_2: rod(0.45) { from: arm_2, to: platform, at: xyz(0.2, 0.0, 0.0), to_at: rz(2*pi/3) xyz(0.05, 0.0, 0.0) }
    loop bar_3: rod(0.45) { from: arm_3, to: platform, at: xyz(0.2, 0.0, 0.0), to_at: rz(4*pi/3) xyz(0.05, 0.0, 0.0) }
}

const PLATFORM: [[f64; 3]; 4] = [
    [0.0, 0.0, -0.4],
    [0.05, -0.08, -0.45],
    [-0.1, 0.03, -0.35],
    [0.02, 0.1, -0.5],
];

/// The angles of an arm and of its forearm at a position of the platform. In the arm's plane, the sphere about the ball
/// is a circle, which intersects the elbow's circle twice; this is the outer intersection.
fn leg(k: u32, p: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = (f64::from(k) * TAU / 3.0).sin_cos();
    // The ball relative to the shoulder, in the plane of the arm.
    let x = cosine * p[0] + sine * p[1] + 0.05 - 0.1;
    let y = -sine * p[0] + cosine * p[1];
    let z = p[2];
    // |0.2 (cos θ, −sin θ) − (x, z)|² = 0.45² − y²
    let (a, b) = (x, -z);
    let c = (0.04 + x * x + z * z + y * y - 0.2025) / 0.4;
    let theta = b.atan2(a) - (c / a.hypot(b)).acos();
    // The forearm's direction in the arm's axes is (−cos b sin a, sin b, −cos b cos a).
    let (ts, tc) = theta.sin_cos();
    let [dx, dz] = [(x - 0.2 * tc) / 0.45, (z + 0.2 * ts) / 0.45];
    let [ex, ez] = [tc * dx - ts * dz, ts * dx + tc * dz];
    [theta, (-ex).atan2(-ez), (y / 0.45).asin()]
}

fn closed(p: [f64; 3]) -> [f64; 12] {
    let legs = [0, 1, 2].map(|k| leg(k, p));
    from_fn(|k| if k < 9 { legs[k / 3][k % 3] } else { p[k - 9] })
}

fn light(q: &[f64; 12]) -> [f64; 6] {
    [q[0], q[3], q[6], q[9], q[10], q[11]]
}

#[test]
fn loops_are_closed_at_the_intersections_of_spheres() {
    for p in PLATFORM {
        let q = closed(p);
        assert!(
            largest(&Delta.constraint(&q)) < 5e-16,
            "{p:?}: {:?}",
            Delta.constraint(&q)
        );
        assert!(largest(&Light.constraint(&light(&q))) < 5e-16, "{p:?}");
        // Nine equations for twelve joints: the three degrees of freedom of the platform.
        let regular = regularity(&Delta.constraint_jacobian(&q));
        assert_eq!(regular.rank, 9);
        assert_eq!(regularity(&Light.constraint_jacobian(&light(&q))).rank, 3);
    }
}

#[test]
fn projection_finds_the_forward_kinematics() {
    for p in PLATFORM {
        let q = closed(p);
        let start = from_fn(|k| q[k] + [0.05, -0.04, 0.03][k % 3]);
        let found = project(&Delta, &start, 1e-15);
        assert_eq!(found.outcome, ClosureOutcome::Closed, "{found:?}");
        let platform = [found.q[9], found.q[10], found.q[11]];
        assert!(difference(&found.q, &closed(platform)) < 1e-13, "{found:?}");
    }
}

#[test]
fn rates_and_accelerations_are_those_of_the_closed_form() {
    const STEP: f64 = 1e-3;
    for p in PLATFORM {
        // The platform moves on a parabola; the spheres determine the joints.
        let at = |t: f64| -> [f64; 12] {
            closed(from_fn(|k| {
                p[k] + [0.3, -0.2, 0.25][k] * t + [0.5, 0.4, -0.6][k] * t * t
            }))
        };
        let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| at(k * STEP));
        let qd: [f64; 12] = from_fn(|k| (8.0 * (d[k] - b[k]) - (e[k] - a[k])) / (12.0 * STEP));
        let qdd: [f64; 12] = from_fn(|k| {
            (16.0 * (d[k] + b[k]) - (e[k] + a[k]) - 30.0 * c[k]) / (12.0 * STEP * STEP)
        });
        let jacobian = Delta.constraint_jacobian(&c);
        let bias = Delta.constraint_bias(&c, &qd);
        for (row, bias) in jacobian.iter().zip(bias) {
            let product = |x: &[f64; 12]| row.iter().zip(x).map(|(j, x)| j * x).sum::<f64>();
            assert!(product(&qd).abs() < 1e-10, "{}", product(&qd));
            assert!(
                (product(&qdd) + bias).abs() < 1e-7,
                "{} {bias}",
                product(&qdd)
            );
        }
        // The torques of the open tree for this motion cause it in the closed robot too.
        let tau = Delta.inverse_dynamics(&c, &qd, &qdd);
        let found = Delta.constrained_forward_dynamics(&c, &qd, &tau).qdd;
        assert!(
            difference(&found, &qdd) < 1e-6 * largest(&qdd),
            "{found:?} {qdd:?}"
        );
    }
}

#[test]
fn massless_forearms_keep_their_length() {
    let q = light(&closed(PLATFORM[1]));
    let tau = [0.4, 0.1, -0.2, 0.0, 0.0, 0.0];
    let found = Light.constrained_forward_dynamics(&q, &[0.0; 6], &tau).qdd;
    let jacobian = Light.constraint_jacobian(&q);
    let bias = Light.constraint_bias(&q, &[0.0; 6]);
    for (row, bias) in jacobian.iter().zip(bias) {
        let left = bias + row.iter().zip(&found).map(|(j, x)| j * x).sum::<f64>();
        assert!(left.abs() < 1e-13, "{left}");
    }
}

//! Loops of any shape: mobility of known mechanisms, several loops, and inverse kinematics.

use crate::sample::{Random, agree, largest};
use homogen::loop_closure::{
    ClosedChain, Closure, acceleration, matrix, mobility, position, rank, velocity,
};
use homogen::open_chain::{motions, poses};
use homogen::worked_examples::stanford_arm;
use homogen::{Chain, Frame, Inertia, Joint, Pose, Real, Screw};
use std::array::from_fn;

fn revolute(axis: [f64; 3], point: [f64; 3]) -> Screw<f64> {
    Screw::revolute(axis, point)
}

/// One loop of joints whose screws are given in the base, closed at q = 0.
fn ring<const N: usize>(screws: [Screw<f64>; N]) -> ClosedChain<N, 0, 1> {
    let joint = |i: usize| {
        let (parent, here) = (i.checked_sub(1), Pose::from_translation([0.0; 3]));
        Joint::new("joint", parent, here, screws[i], Inertia::zero())
    };
    ClosedChain::tip_at_base(Chain::new(from_fn(joint), [], [0.0; 3]))
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

#[test]
fn mobility_of_known_mechanisms() {
    let four_bar =
        ring([[0.0; 3], [0.0, 1.0, 0.0], [2.0, 1.5, 0.0], [3.0, 0.0, 0.0]].map(|p| revolute(Z, p)));
    assert_eq!(mobility(&four_bar, &[0.0; 4]), 1);

    // All axes through one point: spherical, although the count 4 − 6 is negative.
    let tilted = [0.6, 0.0, 0.8];
    let spherical = ring([X, Y, Z, tilted].map(|u| revolute(u, [0.0; 3])));
    assert_eq!(mobility(&spherical, &[0.0; 4]), 1);

    // Sarrus' straight-line linkage: three hinges along x and three along y.
    let sarrus = ring([
        revolute(X, [0.0, 0.0, 0.0]),
        revolute(X, [0.0, 1.0, 1.0]),
        revolute(X, [0.0, 0.0, 2.0]),
        revolute(Y, [0.0, 0.0, 2.0]),
        revolute(Y, [1.0, 0.0, 1.0]),
        revolute(Y, [0.0, 0.0, 0.0]),
    ]);
    assert_eq!(
        (rank(&sarrus, &[0.0; 6]), mobility(&sarrus, &[0.0; 6])),
        (5, 1)
    );

    // Six random hinges have mobility 0, seven have 1.
    let mut random = Random::new(3);
    let hinges: [Screw<f64>; 7] = from_fn(|_| revolute(random.unit(), random.numbers()));
    assert_eq!(mobility(&ring(hinges), &[0.0; 7]), 1);
    assert_eq!(mobility(&ring::<6>(from_fn(|i| hinges[i])), &[0.0; 6]), 0);
    assert_eq!(mobility(&ring([revolute(Z, [0.0; 3]); 5]), &[0.0; 5]), 4);
}

/// Mobility does not depend on the unit of length and on the pose of the base.
#[test]
fn mobility_does_not_depend_on_units() {
    for scale in [1e-9, 1e-3, 1.0, 1e3, 1e9] {
        let points = [[0.0; 2], [0.0, 1.0], [2.0, 1.5], [3.0, 0.0]];
        let lengths = [[0.0, 0.0], [0.0, 1.0], [2.0, 0.5], [1.0, -1.5]];
        let joint = |i: usize| {
            let [x, y] = lengths[i].map(|x| x * scale);
            let parent = i.checked_sub(1);
            let placement = Pose::from_translation([x, y, 0.0]);
            Joint::new(
                "joint",
                parent,
                placement,
                revolute(Z, [0.0; 3]),
                Inertia::zero(),
            )
        };
        let [x, y] = points[3].map(|x| x * scale);
        let end = Frame::new("end", Some(3), Pose::from_translation([-x, -y, 0.0]));
        let closed = ClosedChain::tip_at_base(Chain::new(from_fn(joint), [end], [0.0; 3]));
        assert_eq!(mobility(&closed, &[0.0; 4]), 1, "at {scale}");
    }
}

/// Two loops: a four-bar linkage with a second rod from its coupler to a slider.
fn two_loops() -> ClosedChain<7, 4, 2> {
    let at = |x, y| Pose::from_translation([x, y, 0.0]);
    let hinge = revolute(Z, [0.0; 3]);
    let joint = |name, parent, placement, screw| {
        Joint::new(name, parent, placement, screw, Inertia::zero())
    };
    let chain = Chain::<7, 4>::new(
        [
            joint("crank", None, at(0.0, 0.0), hinge),
            joint("coupler", Some(0), at(0.5, 0.0), hinge),
            joint("rocker", None, at(2.0, 0.0), hinge),
            joint("pin", Some(1), at(2.0, 0.0), hinge),
            joint("rod", Some(1), at(1.0, 0.5), hinge),
            joint("slide", None, at(0.0, 2.0), Screw::prismatic(X)),
            joint("wrist", Some(5), at(0.0, 0.0), hinge),
        ],
        [
            Frame::new("end of the rocker", Some(2), at(0.0, 1.5)),
            Frame::new("end of the coupler", Some(3), at(0.0, 0.0)),
            Frame::new("end of the rod", Some(4), at(0.0, 1.75)),
            Frame::new("slider", Some(6), at(0.0, 0.0)),
        ],
        [0.0; 3],
    );
    let frame = |i: usize| chain.frames[i];
    ClosedChain {
        chain,
        closures: [
            Closure {
                left: frame(1),
                right: frame(0),
            },
            Closure {
                left: frame(2),
                right: frame(3),
            },
        ],
    }
}

#[test]
fn two_loops_share_their_joints() {
    let closed = two_loops();
    let mut q = [0.0_f64; 7];
    let step = 0.01;
    let mut before = None;
    for k in 0..628 {
        let crank = step * f64::from(k);
        let driving = |x: f64| from_fn(|i| (i == 0).then_some(x));
        let found = position(&closed, &driving(crank), &q).expect("a crank-rocker");
        q = found.q;
        assert!(!found.is_singular);
        assert_eq!(mobility(&closed, &q), 1);
        let rates = velocity(&closed, &q, &driving(1.0));
        let second = acceleration(&closed, &q, &rates.values, &driving(0.0));
        for closure in &closed.closures {
            // Both faces of the cut have the same position, velocity and acceleration.
            let motions = motions(&closed.chain, &q, &rates.values, &second.values);
            let [left, right] = [closure.left, closure.right].map(|frame| {
                let motion = motions[frame.body.expect("not of the base")];
                (
                    motion.pose * frame.placement,
                    motion.velocity,
                    motion.acceleration,
                )
            });
            agree(
                left.0.to_matrix().as_flattened(),
                right.0.to_matrix().as_flattened(),
                32.0,
                4.0,
            );
            agree(
                left.1.to_matrix().as_flattened(),
                right.1.to_matrix().as_flattened(),
                64.0,
                4.0,
            );
            agree(
                left.2.to_matrix().as_flattened(),
                right.2.to_matrix().as_flattened(),
                256.0,
                16.0,
            );
        }
        // The rates are those of the positions, to second order in the step.
        if let Some((q_0, qd_0)) = before.replace((q, rates.values)) {
            let (q_0, qd_0): ([f64; 7], [f64; 7]) = (q_0, qd_0);
            for i in 0..7 {
                let mean = 0.5 * (rates.values[i] + qd_0[i]);
                assert!((q[i] - q_0[i] - step * mean).abs() < 1e-5);
            }
        }
    }
}

fn inverse_kinematics<T: Real>() {
    let chain = stanford_arm::chain();
    let mut worst = 0;
    for seed in 0..300 {
        let mut random = Random::new(seed);
        // Away from the wrist's and the shoulder's singular positions.
        let sign = if random.number::<f64>() < 0.0 {
            -1.0
        } else {
            1.0
        };
        let q: [f64; 6] = [
            random.number(),
            sign * (0.8 + 0.5 * random.number::<f64>()),
            0.6 + 0.2 * random.number::<f64>(),
            random.number(),
            sign * (0.8 + 0.5 * random.number::<f64>()),
            random.number(),
        ];
        let target = stanford_arm::tool_pose(&q);
        let closed = ClosedChain::tip_at(chain, target);
        let start: [T; 6] = from_fn(|i| T::constant(q[i] + 0.2 * random.number::<f64>()));
        let found = position(&closed, &[None; 6], &start).expect("within reach");
        worst = worst.max(found.iterations);
        assert!(!found.is_singular);
        let reached = stanford_arm::tool_pose(&found.q);
        let target = target.to_matrix().map(|row| row.map(T::constant));
        agree(
            reached.to_matrix().as_flattened(),
            target.as_flattened(),
            64.0,
            1.0,
        );
    }
    println!("at most {worst} steps");
}

#[test]
fn inverse_kinematics_is_a_closed_loop() {
    inverse_kinematics::<f64>();
    inverse_kinematics::<f32>();
}

/// At the singular position of the wrist two axes coincide, and A is flagged.
#[test]
fn a_singular_wrist_is_flagged() {
    let q = [0.3_f64, 0.8, 0.6, 0.2, 0.0, -0.4];
    let closed = ClosedChain::tip_at(stanford_arm::chain(), stanford_arm::tool_pose(&q));
    assert_eq!(rank(&closed, &q), 5);
    let found = position(&closed, &[None; 6], &q).expect("it is there already");
    assert!(found.is_singular && found.residual < 1e-15);
}

#[test]
fn a_pose_beyond_reach_is_an_error() {
    let target = Pose::from_translation([1.0, 0.0, 9.0]);
    let mut chain = stanford_arm::chain();
    // The boom cannot extend: the length of the arm is fixed.
    chain.joints[2].screw = revolute(Z, [0.0; 3]);
    let closed = ClosedChain::tip_at(chain, target);
    let start = [0.1_f64, 0.8, 0.5, 0.3, 0.4, 0.2];
    let error = position(&closed, &[None; 6], &start).expect_err("out of reach");
    assert!(error.residual > 0.1);
    assert!(error.to_string().contains("do not close"));
}

/// The columns of A are the derivatives of the displacements by which the loops are open.
#[test]
fn columns_move_the_cut_apart() {
    let closed = two_loops();
    let mut random = Random::new(5);
    for _ in 0..50 {
        let q: [f64; 7] = random.numbers();
        let qd: [f64; 7] = random.numbers();
        let a = matrix(&closed, &q);
        let motions = motions(&closed.chain, &q, &qd, &[0.0; 7]);
        let poses = poses(&closed.chain, &q);
        for (closure, a) in closed.closures.iter().zip(&a) {
            let body = |frame: &Frame| frame.body.expect("not of the base");
            let m_0_right = poses[body(&closure.right)] * closure.right.placement;
            let w = motions[body(&closure.left)].velocity - motions[body(&closure.right)].velocity;
            let w = m_0_right.inverse().change_frame(&w);
            let ([p, q, r], [x, y, z]) = (w.omega(), w.v());
            let apart = a.map(|row| row.iter().zip(&qd).map(|(a, x)| a * x).sum::<f64>());
            agree(&apart, &[p, q, r, x, y, z], 64.0, largest(&apart).max(4.0));
        }
    }
}

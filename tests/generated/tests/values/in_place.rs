//! Inline descriptions of what the files in robots/ do not have: screws, chains of prismatic joints, oblique axes,
//! branches in the middle, tables, settings and their combinations.
//!
//! Generated code is compared with the generic recursions, in units of rounding as in `agreement`.

use homogen::{Chain, chain, generic};
use homogen_robots::with_every_function;
use homogen_tests::effort::effort;
use homogen_tests::functions::{Block, EveryFunction, evaluate};
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(25, 100)
}

/// The worst is 35 u.
const LIMIT: f64 = 64.0;

/// For results that cancel in the recursions in frame 0: the worst is 620 u, or 1.3e-14.
const LIMIT_OF_DIFFERENCES: f64 = 1024.0;

fn limit(block: &str) -> f64 {
    match block {
        "centroidal_momentum_bias c"
        | "centroidal_momentum_bias f"
        | "coriolis_matrix"
        | "gravity_derivative"
        | "inverse_dynamics_derivatives" => LIMIT_OF_DIFFERENCES,
        _ => LIMIT,
    }
}

/// Declares a robot with the functions that are compared.
macro_rules! robot {
    ([$($function:ident),*] $(#[$about:meta])* $name:ident { $($settings:tt)* } $($parts:tt)*) => {
        chain! {
            $(#[$about])*
            struct $name {
                $($settings)*, generate($($function),*)
            }
            $($parts)*
        }
    };
}

fn agree<R, const N: usize, const F: usize>(robot: &R, chain: &Chain<N, F>)
where
    R: EveryFunction<N, f64>,
{
    let mut random = Random::new(4);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let state = State::random(&mut random);
        worst.note(&evaluate(robot, &state), &evaluate(chain, &state));
    }
    println!("{worst}");
    worst.assert_each_within(limit);
}

fn names<const N: usize, const F: usize>(chain: &Chain<N, F>) -> [&'static str; N] {
    chain.joints.map(|joint| joint.name)
}

with_every_function! { robot!
    /// A pillar drill, whose quill goes down by 5 mm per turn.
    Drill { gravity: [0.5, 0.0, -9.5] }
    link base;
    joint pillar: revolute(z) { at: xyz(0.0, 0.0, 1.2) }
    link arm { mass: 8.0, com: [0.3, 0.01, 0.0], inertia: [0.1, 0.02, 0.0, 0.4, 0.0, 0.4] }
    joint quill: screw(-z, pitch: 0.005) { at: xyz(0.6, 0.0, 0.0) }
    link spindle { mass: 1.5, com: [0.002, 0.001, -0.1], inertia: [0.01, 0.01, 0.003] }
    joint tilt: screw([0.6, 0.0, 0.8], pitch: -0.12) { at: xyz(0.0, 0.1, -0.2) rpy(0.1, 0.2, 0.3) }
    link bit { mass: 0.3, com: [0.0, 0.02, -0.05], inertia: [0.001, 0.002, 0.001] }
}

with_every_function! { robot!
    /// Three prismatic joints and a wrist, on a wall.
    Gantry { gravity: [-9.81, 0.0, 0.0] }
    link base;
    joint x: prismatic(x);
    link bridge { mass: 30.0, com: [0.0, 0.5, 0.0], inertia: [2.0, 0.1, 2.0] }
    joint y: prismatic(y) { at: xyz(0.0, 0.0, 0.2) }
    link carriage { mass: 12.0, com: [0.02, 0.0, 0.1], inertia: [0.3, 0.2, 0.3] }
    joint z: prismatic([0.0, -0.6, 0.8]) { at: xyz(0.1, 0.0, 0.0) }
    link ram { mass: 6.0, com: [0.0, 0.01, -0.3], inertia: [0.2, 0.2, 0.01] }
    joint wrist: revolute(z) { at: xyz(0.0, 0.0, -0.6) }
    link gripper { mass: 1.0, com: [0.05, 0.0, -0.1], inertia: [0.004, 0.003, 0.002] }
}

with_every_function! { robot!
    /// A boring mill with two cylindrical joints, the first with an oblique axis.
    Mill { gravity: [0.2, -9.7, 1.0] }
    link base;
    joint table: prismatic(x) { at: xyz(0.0, 0.0, 0.4) }
    link saddle { mass: 20.0, com: [0.1, 0.02, 0.0], inertia: [0.4, 0.5, 0.6] }
    joint spindle: cylindrical([0.48, 0.6, -0.64]) { at: xyz(0.2, 0.3, 0.1) rpy(0.1, -0.4, 0.2) }
    link head { mass: 4.0, com: [0.03, -0.02, 0.1], inertia: [0.03, 0.001, 0.002, 0.04, 0.003, 0.05] }
    joint facing: cylindrical(y) { at: xyz(0.05, 0.02, 0.3) rx(0.3) }
    link tool { mass: 0.6, com: [0.01, 0.04, -0.02], inertia: [0.002, 0.003, 0.001] }
}

with_every_function! { robot!
    /// No two axes at a right angle, and no gravity.
    Oblique { gravity: none, tip: c }
    link base;
    joint one: revolute([0.6, 0.0, 0.8]) { at: xyz(0.1, 0.2, 0.3) rpy(0.4, 0.5, 0.6) }
    link a { mass: 2.0, com: [0.1, 0.2, 0.0], inertia: [0.03, 0.001, 0.002, 0.04, 0.003, 0.05] }
    joint two: revolute([0.48, 0.6, -0.64]) { at: xyz(0.3, -0.2, 0.1) rx(0.7) rz(1.1) }
    link b { mass: 1.5, com: [0.0, 0.1, 0.1], inertia: [0.02, 0.002, 0.001, 0.03, 0.001, 0.04] }
    joint three: revolute(y) { at: ry(0.9) xyz(0.2, 0.1, 0.1) }
    link c { mass: 1.0, com: [0.1, 0.0, 0.1], inertia: [0.01, 0.001, 0.0, 0.02, 0.002, 0.025] }
}

with_every_function! { robot!
    /// A trunk with a head and two arms that branch in the middle; the eye is a further frame.
    Torso { tip: left_hand, frames(eye, pelvis) }
    link pelvis;
    joint waist: revolute(z) { from: pelvis, to: trunk, at: xyz(0.0, 0.0, 0.2) }
    joint neck: revolute(y) { from: trunk, to: head, at: xyz(0.0, 0.0, 0.5) }
    joint gaze: fixed { from: head, to: eye, at: xyz(0.1, 0.03, 0.1) rpy(0.1, 0.2, 0.3) }
    joint left_shoulder: revolute(x) { from: trunk, to: left_arm, at: xyz(0.0, 0.2, 0.4) }
    joint left_elbow: revolute(y) { from: left_arm, to: left_hand, at: xyz(0.0, 0.1, -0.3) }
    joint right_shoulder: revolute(-x) { from: trunk, to: right_arm, at: xyz(0.0, -0.2, 0.4) }
    joint right_wrist: prismatic(z) { from: right_arm, to: right_hand, at: xyz(0.0, 0.0, -0.3) }
    link trunk { mass: 20.0, com: [0.01, 0.0, 0.2], inertia: [0.6, 0.01, 0.02, 0.5, 0.0, 0.3] }
    link head { mass: 4.0, com: [0.02, 0.0, 0.1], inertia: [0.02, 0.02, 0.01] }
    link eye { mass: 0.1, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    link left_arm { mass: 3.0, com: [0.0, 0.05, -0.15], inertia: [0.03, 0.03, 0.004] }
    link left_hand { mass: 1.0, com: [0.0, 0.0, -0.1], inertia: [0.004, 0.004, 0.001] }
    link right_arm { mass: 3.0, com: [0.0, -0.05, -0.15], inertia: [0.03, 0.03, 0.004] }
    link right_hand { mass: 1.0, com: [0.0, 0.0, -0.1], inertia: [0.004, 0.004, 0.001] }
}

with_every_function! { robot!
    /// The same from the trunk up, without its right arm and with a locked neck.
    Bust { base: trunk, tip: left_hand, drop(right_arm), lock(neck = 0.3), frames(head) }
    link pelvis;
    joint waist: revolute(z) { from: pelvis, to: trunk }
    joint neck: revolute(y) { from: trunk, to: head, at: xyz(0.0, 0.0, 0.5) }
    joint left_shoulder: revolute(x) { from: trunk, to: left_arm, at: xyz(0.0, 0.2, 0.4) }
    joint left_elbow: revolute(y) { from: left_arm, to: left_hand, at: xyz(0.0, 0.1, -0.3) }
    joint right_shoulder: revolute(-x) { from: trunk, to: right_arm, at: xyz(0.0, -0.2, 0.4) }
    link trunk { mass: 20.0, com: [0.01, 0.0, 0.2], inertia: [0.6, 0.5, 0.3] }
    link head { mass: 4.0, com: [0.02, 0.0, 0.1], inertia: [0.02, 0.02, 0.01] }
    link left_arm { mass: 3.0, com: [0.0, 0.05, -0.15], inertia: [0.03, 0.03, 0.004] }
    link left_hand { mass: 1.0, com: [0.0, 0.0, -0.1], inertia: [0.004, 0.004, 0.001] }
    link right_arm { mass: 3.0, com: [0.0, -0.05, -0.15], inertia: [0.03, 0.03, 0.004] }
}

with_every_function! { robot!
    /// An arm whose second branch has a mass and no coordinate.
    OnePath { tip: hand, path_only, exact }
    link base;
    joint shoulder: revolute(z) { from: base, to: upper, at: rx(-4.7124) }
    joint elbow: revolute(z) { from: upper, to: hand, at: xyz(0.4, 0.0, 0.0) }
    joint boom: prismatic(y) { from: upper, to: camera, at: xyz(0.2, 0.0, 0.1) }
    link upper { mass: 2.0, com: [0.2, 0.0, 0.0], inertia: [0.002, 0.03, 0.03] }
    link hand { mass: 1.0, com: [0.1, 0.01, 0.0], inertia: [0.001, 0.01, 0.01] }
    link camera { mass: 0.5, com: [0.0, 0.0, 0.02], inertia: [0.001, 0.001, 0.001] }
}

with_every_function! { robot!
    /// Modified Denavit–Hartenberg parameters.
    Table { }
    denavit_hartenberg(modified) {
        one: revolute { a: 0.0, alpha: 0.0, d: 0.3, mass: 3.0, com: [0.0, 0.02, 0.1], inertia: [0.02, 0.02, 0.01] }
        two: revolute { a: 0.1, alpha: -pi/2, d: 0.0, mass: 2.0, com: [0.2, 0.0, 0.01], inertia: [0.01, 0.03, 0.03] }
        three: prismatic { a: 0.4, alpha: pi/2, theta: 0.0, mass: 1.0, com: [0.0, 0.0, 0.1], inertia: [0.01, 0.01, 0.01] }
    }
}

#[test]
fn screws_agree_with_the_recursions() {
    agree(&Drill, &Drill::chain());
}

#[test]
fn cylindrical_joints_have_two_coordinates() {
    let chain = Mill::chain();
    agree(&Mill, &chain);
    assert_eq!(
        names(&chain),
        [
            "table",
            "spindle.angle",
            "spindle.shift",
            "facing.angle",
            "facing.shift"
        ]
    );
}

#[test]
fn chains_of_prismatic_joints_agree_with_the_recursions() {
    agree(&Gantry, &Gantry::chain());
}

#[test]
fn oblique_axes_without_gravity_agree_with_the_recursions() {
    agree(&Oblique, &Oblique::chain());
    assert_eq!(Oblique::chain().gravity, [0.0; 3]);
    assert_eq!(Oblique.gravity(&[1.0, 2.0, 3.0]), [0.0; 3]);
}

#[test]
fn branches_and_further_frames_agree_with_the_recursions() {
    let chain = Torso::chain();
    agree(&Torso, &chain);
    let order = "waist neck left_shoulder left_elbow right_shoulder right_wrist";
    assert_eq!(names(&chain).join(" "), order);

    let mut random = Random::new(5);
    let mut worst = Worst::in_units_of(DOUBLE);
    let eye = chain.frame("eye").expect("a frame of the request");
    for _ in 0..count() {
        let State { q, qd, qdd } = &State::<f64, 6>::random(&mut random);
        let m = [
            Torso.forward_kinematics_of_eye(q),
            generic::forward_kinematics(&chain, &eye, q),
        ];
        let w = [
            Torso.velocity_of_eye(q, qd),
            generic::velocity(&chain, &eye, q, qd),
        ];
        let h = [
            Torso.acceleration_of_eye(q, qd, qdd),
            generic::acceleration(&chain, &eye, q, qd, qdd),
        ];
        let l = [
            Torso.geometric_jacobian_of_eye(q),
            generic::geometric_jacobian(&chain, &eye, q),
        ];
        let [result, expected] = [0, 1].map(|k| {
            [
                Block::new("M", m[k].to_matrix().concat()),
                Block::new("W", w[k].to_matrix().concat()),
                Block::new("H", h[k].to_matrix().concat()),
                Block::new("L", l[k].map(|column| column.to_matrix().concat()).concat()),
            ]
        });
        worst.note(&result, &expected);
        // The frame of the base does not move.
        assert_eq!(Torso.velocity_of_pelvis(q, qd).v(), [0.0; 3]);
    }
    worst.assert_within(LIMIT);
}

#[test]
fn a_part_of_a_robot_agrees_with_the_recursions() {
    let chain = Bust::chain();
    agree(&Bust, &chain);
    assert_eq!(names(&chain), ["left_shoulder", "left_elbow"]);
    let head = chain.frame("head").expect("a frame of the request");
    assert_eq!(head.body, None);
    let m = Bust.forward_kinematics_of_head(&[0.0_f64; 2]);
    assert_eq!(
        (m.rotation()[0][0], m.translation()),
        (0.3_f64.cos(), [0.0, 0.0, 0.5])
    );
}

#[test]
fn the_path_to_the_end_effector_alone_has_coordinates() {
    let chain = OnePath::chain();
    agree(&OnePath, &chain);
    assert_eq!(names(&chain), ["shoulder", "elbow"]);
    let carried: f64 = chain.joints.iter().map(|joint| joint.inertia.mass()).sum();
    assert_eq!(carried, 3.5);
    // With `exact`, a rounded right angle is an ordinary angle.
    assert_eq!(
        chain.joints[0].placement.rotation()[2][2],
        (-4.7124_f64).cos()
    );
}

#[test]
fn a_table_agrees_with_the_recursions() {
    agree(&Table, &Table::chain());
}

//! Inverse kinematics of three arms: success rate, time, and the outcome of targets that no arm reaches.
//!
//! Each arm is sent from the middle of its limits to ten thousand poses of random coordinates within them, and to as
//! many poses in the same directions at a distance of 3 m. A target is reached to within 1e-6 rad and 1e-6 m.

use std::time::Instant;

use homogen::ik::{Outcome, Solver};
use homogen::robot::{ForwardKinematics, GeometricJacobian};
use homogen::{Pose, Robot, chain, vector};
use homogen_random::Random;

const TARGETS: u16 = 10_000;

/// A distance from the base that is larger than the length of any of the arms \[m\].
const BEYOND: f64 = 3.0;

#[derive(Robot)]
#[robot(
    urdf = "../robots/panda_class.urdf",
    tip = "link8",
    generate(forward_kinematics, geometric_jacobian)
)]
struct Panda;

#[derive(Robot)]
#[robot(
    urdf = "../robots/ur5_class.urdf",
    tip = "tool0",
    generate(forward_kinematics, geometric_jacobian)
)]
struct Ur5;

chain! {
    /// Seven joints without an offset between their axes; lengths and limits of the KUKA LBR iiwa 14 R820 (data sheet).
    struct Iiwa { tip: flange, generate(forward_kinematics, geometric_jacobian) }
    link base;
    joint a1: revolute(z) { at: xyz(0.0, 0.0, 0.36), limits: [-17*pi/18, 17*pi/18] }
    link one;
    joint a2: revolute(y) { limits: [-2*pi/3, 2*pi/3] }
    link two;
    joint a3: revolute(z) { at: xyz(0.0, 0.0, 0.42), limits: [-17*pi/18, 17*pi/18] }
    link three;
    joint a4: revolute(-y) { limits: [-2*pi/3, 2*pi/3] }
    link four;
    joint a5: revolute(z) { at: xyz(0.0, 0.0, 0.4), limits: [-17*pi/18, 17*pi/18] }
    link five;
    joint a6: revolute(y) { limits: [-2*pi/3, 2*pi/3] }
    link six;
    joint a7: revolute(z) { at: xyz(0.0, 0.0, 0.126), limits: [-35*pi/36, 35*pi/36] }
    link flange;
}

/// Outcomes of some targets.
#[derive(Default)]
struct Tally {
    met: usize,
    out_of_reach: usize,
    stalled: usize,
    evaluations: f64,
    microseconds: Vec<f64>,
}

impl Tally {
    fn print(mut self, what: &str) {
        self.microseconds.sort_by(f64::total_cmp);
        let time = |part: usize| self.microseconds[(self.microseconds.len() - 1) * part / 100];
        println!(
            "  {what:12} {:6} met {:6} out of reach {:4} stalled  {:6.1} evaluations  {:6.1} µs median {:7.1} µs at 99 %",
            self.met,
            self.out_of_reach,
            self.stalled,
            self.evaluations / f64::from(TARGETS),
            time(50),
            time(99),
        );
    }
}

fn send<R, const N: usize>(name: &str, arm: &R)
where
    R: Robot<N> + ForwardKinematics<N> + GeometricJacobian<N>,
{
    println!("{name}");
    let solver = Solver::of(arm);
    let limits = solver.limits;
    let middle = limits.map(|[least, most]| 0.5 * (least + most));
    for far in [false, true] {
        let mut random = Random::new(1);
        let mut tally = Tally::default();
        for _ in 0..TARGETS {
            let q =
                limits.map(|[least, most]| 0.5 * (least + most + random.unit() * (most - least)));
            let mut target: Pose<f64> = arm.forward_kinematics(&q);
            if far {
                let there = target.translation();
                let beyond = vector::scale(BEYOND / vector::norm(there), there);
                target = Pose::new(*target.rotation(), beyond);
            }
            let start = Instant::now();
            let found = solver
                .solve(arm, &target, &middle)
                .expect("a pose and limits");
            tally.microseconds.push(start.elapsed().as_secs_f64() * 1e6);
            let evaluations = u32::try_from(found.evaluations).expect("a few hundred");
            tally.evaluations += f64::from(evaluations);
            match found.outcome {
                Outcome::Converged => tally.met += 1,
                Outcome::OutOfReach => tally.out_of_reach += 1,
                _ => tally.stalled += 1,
            }
        }
        tally.print(if far { "beyond" } else { "reachable" });
    }
}

fn main() {
    send("Panda", &Panda);
    send("UR5", &Ur5);
    send("iiwa", &Iiwa);
}

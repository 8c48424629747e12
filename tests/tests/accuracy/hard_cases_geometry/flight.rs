//! Drift over many steps: bodies in free flight, and arms that fall without torques.
//!
//! In: generated forward dynamics, integrated by the Runge–Kutta method of fourth order. Out: the drift of momentum and
//! energy, its order in the step, and its floor by rounding. The drift is computed in f64 from the states as they are.

use std::array::from_fn;

use homogen::open_chain::motions;
use homogen::robot::ForwardDynamics;
use homogen::vector::{norm, sub};
use homogen::{Chain, Momentum, Robot};
use homogen_tests::states::Random;
use homogen_tests::tested::{Flushed, Fused32, Fused64};

use crate::hard_cases_geometry::measure::Number;

homogen::chain! {
    /// A box in free flight on six joints with massless links, and a boom on a hinge with a skew axis.
    struct Flight { gravity: [0.0, 0.0, 0.0], generate(forward_dynamics) }
    link space;
    joint x: prismatic(x) { from: space }
    link along_x { mass: 0.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint y: prismatic(y) {}
    link along_y { mass: 0.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint z: prismatic(z) {}
    link along_z { mass: 0.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint yaw: revolute(z) {}
    link turned { mass: 0.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint pitch: revolute(y) {}
    link tilted { mass: 0.0, com: [0.0, 0.0, 0.0], inertia: [0.0, 0.0, 0.0] }
    joint roll: revolute(x) {}
    link hull { mass: 12.0, com: [0.0, 0.0, 0.0], inertia: [0.5, 0.8, 1.1] }
    joint hinge: revolute([0.0, 0.6, 0.8]) { at: xyz(0.3, 0.2, 0.1) }
    link boom { mass: 3.0, com: [0.45, 0.0, 0.0], inertia: [0.01, 0.21, 0.21] }
}

/// Two links under gravity.
#[derive(Robot)]
#[robot(urdf = "../robots/two_link.urdf", generate(forward_dynamics))]
struct Pendulum;

/// Seven joints under gravity.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", generate(forward_dynamics))]
struct Arm;

/// q and q̇.
type State<T, const N: usize> = [[T; N]; 2];

/// Energy, and γ and ρ in frame 0, of a state.
fn constants<T: Number, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    state: &State<T, N>,
) -> (f64, [[f64; 3]; 2]) {
    let [q, qd] = state.map(|v| v.map(T::to_f64));
    let motions = motions(chain, &q, &qd, &[0.0; N]);
    let (mut energy, mut momentum) = (0.0, Momentum::zero());
    for (joint, motion) in chain.joints.iter().zip(motions) {
        let inertia = motion.pose.change_frame(&joint.inertia);
        energy += inertia.kinetic_energy(&motion.velocity);
        energy += inertia.potential_energy(chain.gravity);
        momentum = momentum + inertia.momentum(&motion.velocity);
    }
    (energy, [momentum.gamma(), momentum.rho()])
}

/// A Runge–Kutta step.
fn step<T: Number, R: ForwardDynamics<N, T>, const N: usize>(
    robot: &R,
    state: &State<T, N>,
    h: T,
) -> State<T, N> {
    let slope =
        |[q, qd]: &State<T, N>| [*qd, robot.forward_dynamics(q, qd, &[T::constant(0.0); N])];
    let after = |h: T, slope: &State<T, N>| -> State<T, N> {
        from_fn(|i| from_fn(|k| state[i][k] + h * slope[i][k]))
    };
    let (half, two) = (T::constant(0.5) * h, T::constant(2.0));
    let k_1 = slope(state);
    let k_2 = slope(&after(half, &k_1));
    let k_3 = slope(&after(half, &k_2));
    let k_4 = slope(&after(h, &k_3));
    let mean = from_fn(|i| {
        from_fn(|k| (k_1[i][k] + two * (k_2[i][k] + k_3[i][k]) + k_4[i][k]) / T::constant(6.0))
    });
    after(h, &mean)
}

/// A robot, its description, its initial state, and the duration \[s\].
struct Motion<'a, R, const N: usize, const F: usize> {
    robot: &'a R,
    chain: &'a Chain<N, F>,
    start: State<f64, N>,
    duration: f64,
}

/// A conserved quantity.
#[derive(Clone, Copy)]
enum Constant {
    Energy,
    Momentum,
}

impl<R, const N: usize, const F: usize> Motion<'_, R, N, F> {
    /// The largest relative drift over so many equal steps.
    fn drift<T: Number>(&self, of: Constant, steps: u32) -> f64
    where
        R: ForwardDynamics<N, T>,
    {
        let mut state: State<T, N> = self.start.map(|v| v.map(T::constant));
        let before = constants(self.chain, &state);
        let h = T::constant(self.duration / f64::from(steps));
        let mut worst = 0.0_f64;
        // Twenty samples show the drift.
        let every = steps.div_ceil(20);
        for k in 1..=steps {
            state = step(self.robot, &state, h);
            if k % every == 0 || k == steps {
                let now = constants(self.chain, &state);
                let drift = match of {
                    Constant::Energy => (now.0 / before.0 - 1.0).abs(),
                    Constant::Momentum => (now.1.iter().zip(before.1))
                        .map(|(now, before)| norm(sub(*now, before)) / norm(before))
                        .fold(0.0, f64::max),
                };
                assert!(drift.is_finite(), "after {k} of {steps} steps");
                worst = worst.max(drift);
            }
        }
        worst
    }

    /// Asserts that the drift falls with the fourth power of the step between 2^coarse and 2^fine steps, down to a
    /// floor of at most `floor` u, beyond which smaller steps only add rounding errors.
    fn check<T: Number>(&self, name: &str, of: Constant, powers: [u32; 2], floor: f64)
    where
        R: ForwardDynamics<N, T>,
    {
        let [coarse, fine] = powers;
        let finest = if T::UNIT < 1e-10 { 16 } else { 11 };
        let drifts: Vec<f64> = (coarse..=finest)
            .map(|power| self.drift::<T>(of, 1 << power))
            .collect();
        let span = (fine - coarse) as usize;
        let order = (drifts[0] / drifts[span]).log2() / f64::from(fine - coarse);
        let least = (0..drifts.len()).min_by(|&i, &j| drifts[i].total_cmp(&drifts[j]));
        let least = least.expect("some steps");
        let units = drifts[least] / T::UNIT;
        let steps = 1_u64 << (coarse as usize + least);
        println!(
            "{name} {}: order {order:.2}, floor {units:.1} u at {steps} steps",
            T::NAME
        );
        assert!(
            (3.5..5.5).contains(&order),
            "{name}: order {order}, {drifts:?}"
        );
        assert!(units <= floor, "{name}: floor {units} u, {drifts:?}");
        assert!(
            least >= span && least + 1 < drifts.len(),
            "{name}: no floor in {drifts:?}"
        );
    }
}

fn flight_of(chain: &Chain<7, 1>) -> Motion<'_, Flight, 7, 1> {
    Motion {
        robot: &Flight,
        chain,
        start: [
            [0.1, -0.2, 0.3, 0.2, 0.1, -0.3, 0.8],
            [0.1, -0.05, 0.08, -0.6, 0.9, 1.5, -1.5],
        ],
        duration: 1.0,
    }
}

/// Hard case 30. The floors are 59 and 74 u in f64, 5 and 7 u in f32, fused or not; the limits are about four times as
/// large.
#[test]
fn free_flight() {
    let chain = Flight::chain();
    let flight = flight_of(&chain);
    for (name, of) in [
        ("flight, energy", Constant::Energy),
        ("flight, momentum", Constant::Momentum),
    ] {
        flight.check::<f64>(name, of, [3, 9], 256.0);
        flight.check::<f32>(name, of, [2, 4], 24.0);
        flight.check::<Flushed>(name, of, [2, 4], 24.0);
        flight.check::<Fused64>(name, of, [3, 9], 256.0);
        flight.check::<Fused32>(name, of, [2, 4], 24.0);
    }
    for momentum in [
        flight.drift::<f64>(Constant::Momentum, 100_000),
        flight.drift::<Fused64>(Constant::Momentum, 100_000),
    ] {
        println!("flight, momentum after 100 000 steps: {momentum:e}");
        assert!(momentum <= 1e-12, "{momentum:e}");
    }
}

/// Slow flight is straight: no velocity changes by a bit.
fn slow<T: Number>() {
    let chain = Flight::chain();
    let [q, _] = flight_of(&chain).start.map(|v| v.map(T::constant));
    let mut random = Random::new(14);
    for k in 0..100 {
        let fastest = if k == 0 {
            T::constant(0.0)
        } else {
            T::MIN_POSITIVE
        };
        let qd = from_fn(|_| fastest * T::constant(random.unit()));
        let mut state = [q, qd];
        for _ in 0..10 {
            state = step(&Flight, &state, T::constant(1e-3));
        }
        assert_eq!(state, [q, qd], "{}", T::NAME);
    }
}

crate::in_every_type! {
    /// Hard case 30 with zero and subnormal velocities.
    free_flight_slow => slow;
}

/// Hard case 31, from rest and from a throw. The floors are 150 u (pendulum) and 68 u (arm) in f64, 30 u and 4 u in
/// f32, fused or not; the limits are about four times as large.
#[test]
fn energy_drift_chain() {
    let chain = Pendulum::chain();
    let pendulum = Motion {
        robot: &Pendulum,
        chain: &chain,
        start: [[0.4, 0.9], [0.0, 0.0]],
        duration: 0.5,
    };
    pendulum.check::<f64>("pendulum", Constant::Energy, [6, 12], 512.0);
    pendulum.check::<f32>("pendulum", Constant::Energy, [4, 6], 128.0);
    pendulum.check::<Flushed>("pendulum", Constant::Energy, [4, 6], 128.0);
    pendulum.check::<Fused64>("pendulum", Constant::Energy, [6, 12], 512.0);
    pendulum.check::<Fused32>("pendulum", Constant::Energy, [4, 6], 128.0);
    let chain = Arm::chain();
    let arm = Motion {
        robot: &Arm,
        chain: &chain,
        start: [
            [0.3, -0.6, 0.2, -1.9, 0.4, 1.6, 0.8],
            [0.5, -0.3, 0.4, 0.2, -0.6, 0.7, 0.1],
        ],
        duration: 0.4,
    };
    arm.check::<f64>("arm", Constant::Energy, [5, 9], 256.0);
    arm.check::<f32>("arm", Constant::Energy, [4, 6], 16.0);
    arm.check::<Flushed>("arm", Constant::Energy, [4, 6], 16.0);
    arm.check::<Fused64>("arm", Constant::Energy, [5, 9], 256.0);
    arm.check::<Fused32>("arm", Constant::Energy, [4, 6], 16.0);
}

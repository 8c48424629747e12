//! Robots whose joints have several velocities or mimic others: compared with the generic recursions, and laws of
//! mechanics between the results of one robot.
//!
//! Derivatives come from generated code on dual numbers along an integrated motion, since velocities are not
//! derivatives of coordinates. Errors are in units of rounding times the largest value of any state.

use std::array::from_fn;

use homogen::robot::{ForwardDynamics, MassMatrixInverse};
use homogen::{Acceleration, Chain, Pose, Real, Scalar, Screw, Velocity, vector};
use homogen_robots::for_every_jointed_robot;
use homogen_robots::jointed::{Brick, EveryJoint, FreeQuadruped, Gripper};
use homogen_tests::cholesky::least_pivot;
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::functions::{Block, EveryFunction, evaluate};
use homogen_tests::rounding::{DOUBLE, SINGLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(25, 100)
}

/// The dense products of the recursions in frame 0 have larger errors than generated code: the worst is 82 u, or 9e-15;
/// of derivatives, which have the factors of mimic joints twice, 589 u.
const DOUBLE_LIMIT: f64 = 1024.0;

/// In single precision the arguments' quaternions are rounded: the worst is 62 u.
const SINGLE_LIMIT: f64 = 192.0;

/// For laws of mechanics: the worst is 13 u.
const LAW_LIMIT: f64 = 64.0;

/// All functions that are tested here.
trait Robot<const N: usize, const Q: usize>:
    EveryFunction<N, f64, Q>
    + EveryFunction<N, f32, Q>
    + EveryFunction<N, Dual, Q>
    + ForwardDynamics<N, f64, Q>
    + MassMatrixInverse<N, f64, Q>
{
}

impl<R, const N: usize, const Q: usize> Robot<N, Q> for R where
    R: EveryFunction<N, f64, Q>
        + EveryFunction<N, f32, Q>
        + EveryFunction<N, Dual, Q>
        + ForwardDynamics<N, f64, Q>
        + MassMatrixInverse<N, f64, Q>
{
}

/// Results of every function in a type, as `f64`.
fn widened<R, T: Real, const N: usize, const Q: usize>(
    robot: &R,
    state: &State<f64, N, Q>,
) -> Vec<Block<f64>>
where
    R: EveryFunction<N, T, Q>,
{
    let blocks = evaluate(robot, &state.to::<T>()).into_iter();
    blocks.map(|block| block.map(T::to_f64)).collect()
}

fn agree_with_the_recursions<R, const N: usize, const F: usize, const Q: usize, const B: usize>(
    robot: &R,
    chain: &Chain<N, F, Q, B>,
) where
    R: Robot<N, Q>,
{
    assert_eq!(chain.check(1e-9), Ok(()));
    let mut random = Random::new(1);
    let mut double = Worst::in_units_of(DOUBLE);
    let mut single = Worst::in_units_of(SINGLE);
    for _ in 0..count() {
        let state = State::of(chain, &mut random);
        let expected = evaluate(chain, &state);
        double.note(&widened::<_, f64, N, Q>(robot, &state), &expected);
        single.note(&widened::<_, f32, N, Q>(robot, &state), &expected);
    }
    println!("double precision\n{double}\nsingle precision\n{single}");
    double.assert_within(DOUBLE_LIMIT);
    single.assert_within(SINGLE_LIMIT);
}

/// q that moves by `v`, with its derivative.
fn moving<const N: usize, const F: usize, const Q: usize, const B: usize>(
    chain: &Chain<N, F, Q, B>,
    q: &[f64; Q],
    v: &[f64; N],
) -> [Dual; Q] {
    chain.integrate(&Dual::pairs(q, &[0.0; Q]), &Dual::pairs(&[0.0; N], v))
}

fn slopes<const M: usize>(duals: [Dual; M]) -> [f64; M] {
    duals.map(|dual| dual.slope)
}

fn unit<const N: usize>(k: usize) -> [f64; N] {
    from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Ṁ M⁻¹ of a pose: ω, and the velocity of the point at the origin.
fn rate(pose: &Pose<Dual>) -> [[f64; 3]; 2] {
    let rotation = pose.rotation().map(|row| row.map(|entry| entry.value));
    let derivative = pose.rotation().map(slopes);
    let w: [[f64; 3]; 3] = from_fn(|i| from_fn(|j| dot(&derivative[i], &rotation[j])));
    let omega = [
        (w[2][1] - w[1][2]) / 2.0,
        (w[0][2] - w[2][0]) / 2.0,
        (w[1][0] - w[0][1]) / 2.0,
    ];
    let t = pose.translation();
    let lever = vector::cross(omega, t.map(|entry| entry.value));
    [omega, vector::sub(slopes(t), lever)]
}

fn obey_the_laws<R, const N: usize, const F: usize, const Q: usize, const B: usize>(
    robot: &R,
    chain: &Chain<N, F, Q, B>,
) where
    R: Robot<N, Q>,
{
    let mut random = Random::new(2);
    let mut found = Worst::in_units_of(DOUBLE);
    let mut note = |name: &str, left: &[f64], right: &[f64]| {
        let block = |entries: &[f64]| [Block::new(name, entries.iter().copied())];
        found.note(&block(left), &block(right));
    };
    for _ in 0..count() {
        let State { q, qd, qdd } = State::of(chain, &mut random);
        let mass: [[f64; N]; N] = robot.mass_matrix(&q);
        let bias: [f64; N] = robot.bias(&q, &qd);
        let tau: [f64; N] = robot.inverse_dynamics(&q, &qd, &qdd);
        let sum: [f64; N] = from_fn(|i| dot(&mass[i], &qdd) + bias[i]);
        note("M q̈ + bias = τ", &sum, &tau);
        let transposed: [[f64; N]; N] = from_fn(|k| mass.map(|row| row[k]));
        assert_eq!(mass, transposed, "M is symmetric");
        assert!(least_pivot(mass) > 0.0, "M is positive definite: {mass:?}");

        // The power of the torques is the rate of the energy.
        let kinetic: f64 = robot.kinetic_energy(&q, &qd);
        let product: [f64; N] = from_fn(|i| dot(&mass[i], &qd));
        note("½ q̇ᵗ M q̇", &[0.5 * dot(&product, &qd)], &[kinetic]);
        let along = moving(chain, &q, &qd);
        let gained = robot.kinetic_energy(&along, &Dual::pairs(&qd, &qdd));
        let lifted = robot.potential_energy(&along);
        let power = dot(&tau, &qd);
        note("Ė = τ · q̇", &[gained.slope + lifted.slope], &[power]);

        let gravity: [f64; N] = robot.gravity(&q);
        let spatial: [Screw<f64>; N] = robot.spatial_jacobian(&q);
        for k in 0..N {
            let by_one = moving(chain, &q, &unit(k));
            let risen = robot.potential_energy(&by_one);
            note("∂U = gravity", &[risen.slope], &[gravity[k]]);
            let [omega, v] = rate(&robot.forward_kinematics(&by_one));
            let column = [spatial[k].u(), spatial[k].b()].concat();
            note("L = ∂M M⁻¹", &column, &[omega, v].concat());
        }
        let w: Velocity<f64> = robot.velocity(&q, &qd);
        let entries = [w.omega(), w.v()].concat();
        note(
            "W = Ṁ M⁻¹",
            &entries,
            &rate(&robot.forward_kinematics(&along)).concat(),
        );
        let in_time: Velocity<Dual> = robot.velocity(&along, &Dual::pairs(&qd, &qdd));
        let w_dot = Velocity::new(slopes(in_time.omega()), slopes(in_time.v()));
        let h: Acceleration<f64> = robot.acceleration(&q, &qd, &qdd);
        let expected = Acceleration::from_velocity_derivative(&w, &w_dot);
        let entries = |h: Acceleration<f64>| [h.g().as_flattened(), &h.a()].concat();
        note("H = Ẇ + W²", &entries(h), &entries(expected));

        // Forward dynamics inverts inverse dynamics.
        let again: [f64; N] = robot.forward_dynamics(&q, &qd, &tau);
        let needed: [f64; N] = robot.inverse_dynamics(&q, &qd, &again);
        note("τ(q̈(τ)) = τ", &needed, &tau);
        let inverse: [[f64; N]; N] = robot.mass_matrix_inverse(&q);
        let condition = largest(mass.as_flattened()) * largest(inverse.as_flattened());
        for (i, row) in inverse.iter().enumerate() {
            let product: [f64; N] = from_fn(|k| dot(row, &transposed[k]));
            let off: [f64; N] = from_fn(|k| product[k] - unit::<N>(i)[k]);
            assert!(
                largest(&off) < 16.0 * DOUBLE * condition,
                "M⁻¹ M − 1: {off:?}"
            );
        }
    }
    println!("{found}");
    found.assert_within(LAW_LIMIT);
}

fn largest(entries: &[f64]) -> f64 {
    entries
        .iter()
        .fold(0.0, |most, entry| most.max(entry.abs()))
}

macro_rules! joints {
    ($name:ident, $robot:ident, $velocities:literal, $coordinates:literal) => {
        mod $name {
            use super::*;

            #[test]
            fn agrees_with_the_recursions() {
                agree_with_the_recursions::<_, $velocities, 1, $coordinates, _>(
                    &$robot,
                    &$robot::chain(),
                );
            }

            #[test]
            fn obeys_the_laws() {
                obey_the_laws::<_, $velocities, 1, $coordinates, _>(&$robot, &$robot::chain());
            }
        }
    };
}
for_every_jointed_robot!(joints);

/// (γ, ρ) in frame 0 of a vector over the velocities of a floating base: M q̇, or τ.
fn in_0<T: Scalar, const N: usize>(q: &[T], list: &[T; N]) -> [T; 6] {
    let quaternion = [q[6], q[3], q[4], q[5]];
    let rotation = homogen::rotation::from_quaternion(quaternion);
    let rho = vector::product(&rotation, [list[0], list[1], list[2]]);
    let about_base = vector::product(&rotation, [list[3], list[4], list[5]]);
    let gamma = vector::add(about_base, vector::cross([q[0], q[1], q[2]], rho));
    [gamma[0], gamma[1], gamma[2], rho[0], rho[1], rho[2]]
}

/// The wrench on a floating base changes the total momentum; torques between bodies do not.
#[test]
fn the_rate_of_momentum_is_the_wrench_on_the_base() {
    let chain = FreeQuadruped::chain();
    let mut random = Random::new(3);
    let mut found = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let State { q, qd, qdd } = State::of(&chain, &mut random);
        let along = moving(&chain, &q, &qd);
        let mass = FreeQuadruped.mass_matrix(&along);
        let rates = Dual::pairs(&qd, &qdd);
        let momenta: [Dual; 18] = mass.map(|row| {
            let terms = row.into_iter().zip(rates).map(|(m, rate)| m * rate);
            terms.fold(Dual::new(0.0, 0.0), |sum, term| sum + term)
        });
        let gained = slopes(in_0(&along, &momenta));
        let tau = FreeQuadruped.inverse_dynamics(&q, &qd, &qdd);
        let gravity = FreeQuadruped.gravity(&q);
        let wrench = in_0(&q, &from_fn::<f64, 18, _>(|k| tau[k] - gravity[k]));
        let block = |entries: [f64; 6]| [Block::new("momentum", entries)];
        found.note(&block(gained), &block(wrench));
    }
    println!("{found}");
    found.assert_within(LAW_LIMIT);
}

/// The position of the base changes no bit of the torques.
#[test]
fn a_base_a_thousand_kilometres_away_loses_no_accuracy() {
    let chain = FreeQuadruped::chain();
    let mut random = Random::new(4);
    for _ in 0..count() {
        let State { q, qd, qdd } = State::of(&chain, &mut random);
        let mut far = q;
        for entry in &mut far[..3] {
            *entry += 1e6;
        }
        assert_eq!(
            FreeQuadruped.inverse_dynamics(&far, &qd, &qdd),
            FreeQuadruped.inverse_dynamics(&q, &qd, &qdd)
        );
        assert_eq!(
            FreeQuadruped.mass_matrix(&far),
            FreeQuadruped.mass_matrix(&q)
        );
        assert_eq!(
            FreeQuadruped.forward_dynamics(&far, &qd, &qdd),
            FreeQuadruped.forward_dynamics(&q, &qd, &qdd)
        );
        assert_eq!(
            FreeQuadruped.inverse_dynamics_derivatives(&far, &qd, &qdd),
            FreeQuadruped.inverse_dynamics_derivatives(&q, &qd, &qdd)
        );
        assert_eq!(
            FreeQuadruped.centroidal_momentum(&far, &qd),
            FreeQuadruped.centroidal_momentum(&q, &qd)
        );
        assert_eq!(
            FreeQuadruped.centroidal_momentum_matrix(&far),
            FreeQuadruped.centroidal_momentum_matrix(&q)
        );
        assert_eq!(
            FreeQuadruped.centroidal_momentum_bias(&far, &qd),
            FreeQuadruped.centroidal_momentum_bias(&q, &qd)
        );
        // Poses in frame 0 are rounded to the distance.
        let here: Pose<f64> = FreeQuadruped.forward_kinematics(&q);
        let there: Pose<f64> = FreeQuadruped.forward_kinematics(&far);
        assert_eq!(there.rotation(), here.rotation());
        let moved = |pose: Pose<f64>, q: [f64; 19]| {
            let [x, y, z, ..] = q;
            vector::sub(pose.translation(), [x, y, z])
        };
        let off = vector::sub(moved(there, far), moved(here, q));
        assert!(largest(&off) <= 4.0 * DOUBLE * 1e6, "{off:?}");
    }
}

/// A step of fourth order: classical Runge–Kutta for velocities, which do not depend on a free body's position; for the
/// position, the screw of the velocities within the step (Magnus expansion).
fn step(q: &[f64; 7], qd: &[f64; 6], h: f64) -> ([f64; 7], [f64; 6]) {
    let rate = |qd: &[f64; 6]| Brick.forward_dynamics(q, qd, &[0.0; 6]);
    let plus = |rate: &[f64; 6], by: f64| -> [f64; 6] { from_fn(|k| qd[k] + by * rate[k]) };
    let first = rate(qd);
    let second = rate(&plus(&first, h / 2.0));
    let third = rate(&plus(&second, h / 2.0));
    let fourth = rate(&plus(&third, h));
    let change: [f64; 6] = from_fn(|k| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0);
    let end = plus(&change, h);
    // The middle by Hermite's cubic, of the same order.
    let last = rate(&end);
    let middle: [f64; 6] = from_fn(|k| qd[k].midpoint(end[k]) + h / 8.0 * (first[k] - last[k]));
    let split = |x: &[f64; 6]| ([x[3], x[4], x[5]], [x[0], x[1], x[2]]);
    let ((w, v), (w_end, v_end)) = (split(qd), split(&end));
    let angular = vector::cross(w, w_end);
    let linear = vector::add(vector::cross(w, v_end), vector::cross(v, w_end));
    let bracket = [
        linear[0], linear[1], linear[2], angular[0], angular[1], angular[2],
    ];
    let screw: [f64; 6] =
        from_fn(|k| h / 6.0 * (qd[k] + 4.0 * middle[k] + end[k]) + h * h / 12.0 * bracket[k]);
    (Brick.integrate(q, &screw), end)
}

/// The largest relative change of momentum and of energy over a duration, in so many steps.
fn drifts(steps: u32, time: f64) -> [f64; 2] {
    let mut q: [f64; 7] = Brick.neutral();
    let mut qd = [0.3, -0.2, 0.5, 1.0, 3.0, -0.5];
    let momentum = |q: &[f64; 7], qd: &[f64; 6]| {
        let mass: [[f64; 6]; 6] = Brick.mass_matrix(q);
        in_0(q, &mass.map(|row| dot(&row, qd)))
    };
    let energy = |q: &[f64; 7], qd: &[f64; 6]| Brick.kinetic_energy(q, qd);
    let (first, whole) = (momentum(&q, &qd), energy(&q, &qd));
    let size = largest(&first);
    let mut worst = [0.0f64; 2];
    for _ in 0..steps {
        (q, qd) = step(&q, &qd, time / f64::from(steps));
        let now = momentum(&q, &qd);
        let off: [f64; 6] = from_fn(|k| now[k] - first[k]);
        worst[0] = worst[0].max(largest(&off) / size);
        worst[1] = worst[1].max((energy(&q, &qd) - whole).abs() / whole);
    }
    let square: f64 = q[3..].iter().map(|entry| entry * entry).sum();
    assert!(
        (square - 1.0).abs() < 1e-15,
        "a quaternion of length² {square}"
    );
    worst
}

/// Long steps show the order of the method, short ones the rounding errors.
#[test]
fn a_tumbling_body_keeps_its_momentum_and_energy_for_100_000_steps() {
    let (long, half) = (drifts(400, 20.0), drifts(800, 20.0));
    for (long, half) in long.into_iter().zip(half) {
        let order = (long / half).log2();
        println!("{long:.1e}, {half:.1e} with half the step: order {order:.2}");
        assert!((3.7..5.5).contains(&order), "order {order}");
    }
    let [momentum, energy] = drifts(100_000, 10.0);
    println!("{momentum:.1e} and {energy:.1e} in 100,000 steps");
    assert!(
        momentum < 4e-12 && energy < 4e-12,
        "{momentum:e}, {energy:e}"
    );
}

//! Derivatives of torques and accelerations, and the Coriolis matrix, compared with generated code on dual numbers,
//! laws of mechanics, the generic recursions, and Pinocchio.
//!
//! Errors of solutions are relative to the inverse of the mass matrix times the torques that cancel.

use std::array::from_fn;

use homogen::robot::{
    ForwardDynamics, ForwardDynamicsDerivatives, ForwardDynamicsHessian, ForwardDynamicsJvp,
    ForwardDynamicsVjp, InverseDynamicsHessian, InverseDynamicsJvp, InverseDynamicsVjp,
};
use homogen::{
    AccelerationGradient, AccelerationHessian, Chain, TorqueChange, TorqueHessian, generic,
};
use homogen_robots::for_every_robot;
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, TwoLink,
    Ur5Class,
};
use homogen_tests::dual::Dual;
use homogen_tests::effort::effort;
use homogen_tests::functions::{Block, EveryFunction};
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};
use serde_json::Value;

/// States of each robot.
fn count() -> usize {
    effort(10, 100)
}

/// Both sides are sums of some hundred terms.
const LIMIT: f64 = 64.0;

/// For solutions; the worst is 38 u, of the two links.
const LIMIT_OF_SOLUTIONS: f64 = 128.0;

/// For Pinocchio's numbers, relative to the largest entry.
const TOLERANCE: f64 = 1e-11;

type Matrix<const N: usize> = [[f64; N]; N];

/// A robot whose code runs on `f64` and on dual numbers.
trait Differentiable<const N: usize>:
    EveryFunction<N, f64>
    + EveryFunction<N, Dual>
    + ForwardDynamics<N>
    + ForwardDynamics<N, Dual>
    + ForwardDynamicsDerivatives<N>
    + ForwardDynamicsDerivatives<N, Dual>
    + ForwardDynamicsHessian<N>
    + ForwardDynamicsJvp<N>
    + ForwardDynamicsVjp<N>
    + InverseDynamicsHessian<N>
    + InverseDynamicsJvp<N>
    + InverseDynamicsVjp<N>
{
}

impl<R, const N: usize> Differentiable<N> for R where
    R: EveryFunction<N, f64>
        + EveryFunction<N, Dual>
        + ForwardDynamics<N>
        + ForwardDynamics<N, Dual>
        + ForwardDynamicsDerivatives<N>
        + ForwardDynamicsDerivatives<N, Dual>
        + ForwardDynamicsHessian<N>
        + ForwardDynamicsJvp<N>
        + ForwardDynamicsVjp<N>
        + InverseDynamicsHessian<N>
        + InverseDynamicsJvp<N>
        + InverseDynamicsVjp<N>
{
}

/// The matrix whose columns are the derivatives along each coordinate.
fn columns<const N: usize>(column: impl Fn([f64; N]) -> [Dual; N]) -> Matrix<N> {
    let columns: Matrix<N> = from_fn(|k| {
        let unit = from_fn(|i| if i == k { 1.0 } else { 0.0 });
        column(unit).map(|dual| dual.slope)
    });
    transposed(&columns)
}

fn transposed<const N: usize>(matrix: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|k| matrix[k][i]))
}

fn note<const N: usize>(found: &mut Worst, name: &str, matrix: &Matrix<N>, expected: &Matrix<N>) {
    let block = |matrix: &Matrix<N>| [Block::new(name, matrix.as_flattened().to_vec())];
    found.note(&block(matrix), &block(expected));
}

/// The largest difference.
fn off<const N: usize>(matrix: &[[f64; N]], expected: &[[f64; N]]) -> f64 {
    let pairs = matrix.as_flattened().iter().zip(expected.as_flattened());
    pairs.fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}

/// Compares the derivatives of torques, and dτ/dt of a motion.
fn of_torques<R: Differentiable<N>, const N: usize>(
    robot: &R,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Worst,
) {
    let still = [0.0; N];
    let [fixed, moving, acceleration] = [q, qd, qdd].map(|list| Dual::pairs(list, &still));
    let (along_q, along_qd) = (|d| Dual::pairs(q, &d), |d| Dual::pairs(qd, &d));
    let by = robot.inverse_dynamics_derivatives(q, qd, qdd);
    let dq = columns(|d| robot.inverse_dynamics(&along_q(d), &moving, &acceleration));
    let dqd = columns(|d| robot.inverse_dynamics(&fixed, &along_qd(d), &acceleration));
    note(found, "∂τ/∂q", &by.dq, &dq);
    note(found, "∂τ/∂q̇", &by.dqd, &dqd);
    let gravity = columns(|d| robot.gravity(&along_q(d)));
    note(found, "∂gravity/∂q", &robot.gravity_derivative(q), &gravity);

    // dτ/dt = ∂τ/∂q q̇ + ∂τ/∂q̇ q̈ at constant q̈.
    let in_time = robot.inverse_dynamics(&Dual::pairs(q, qd), &Dual::pairs(qd, qdd), &acceleration);
    let sum: [f64; N] = from_fn(|i| dot(&by.dq[i], qd) + dot(&by.dqd[i], qdd));
    found.note(
        &[Block::new("dτ/dt", sum)],
        &[Block::new("dτ/dt", in_time.map(|dual| dual.slope))],
    );
}

/// τ and its change along a direction, compared with dual numbers and with the generic recursions.
fn along_directions<R: Differentiable<N>, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Worst,
) {
    let [by_q, by_qd, by_qdd] = &directions([q, qd, qdd]);
    let [at, moving, accelerated] =
        [(q, by_q), (qd, by_qd), (qdd, by_qdd)].map(|(x, by)| Dual::pairs(x, by));
    let expected = robot.inverse_dynamics(&at, &moving, &accelerated);
    let generated = robot.inverse_dynamics_jvp(q, qd, qdd, by_q, by_qd, by_qdd);
    let generic = generic::inverse_dynamics_jvp(chain, q, qd, qdd, by_q, by_qd, by_qdd);
    for TorqueChange { value, change } in [generated, generic] {
        let of = |name, found| [Block::new(name, found)];
        found.note(&of("τ", value), &of("τ", expected.map(|dual| dual.value)));
        found.note(
            &of("δτ", change),
            &of("δτ", expected.map(|dual| dual.slope)),
        );
    }
}

/// Changes of q, q̇ and q̈ or τ.
fn directions<const N: usize>([q, qd, qdd]: [&[f64; N]; 3]) -> [[f64; N]; 3] {
    [
        from_fn(|k| 0.5 * qd[N - 1 - k]),
        from_fn(|k| q[k] - qdd[N - 1 - k]),
        from_fn(|k| 0.3 * q[N - 1 - k] + qd[k]),
    ]
}

/// The Hessian of λᵀτ, compared with first derivatives on dual numbers and with the generic recursions.
fn of_weighted_torques<R: Differentiable<N>, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Worst,
) {
    let still = [0.0; N];
    let lambda: [f64; N] = from_fn(|k| q[N - 1 - k] - 0.5 * qd[k]);
    let weighted = |matrix: [[Dual; N]; N]| contracted(&slopes(matrix), &lambda);
    let [fixed, moving, acceleration] = [q, qd, qdd].map(|list| Dual::pairs(list, &still));
    let first = robot.inverse_dynamics_derivatives(q, qd, qdd);
    let matrices = [first.dq, first.dqd, robot.mass_matrix(q)];
    let expected = matrices.map(|matrix| contracted(&matrix, &lambda));
    let generated = robot.inverse_dynamics_vjp(q, qd, qdd, &lambda);
    let generic = generic::inverse_dynamics_vjp(chain, q, qd, qdd, &lambda);
    for by in [generated, generic] {
        let parts = ["∂(λᵀτ)/∂q", "∂(λᵀτ)/∂q̇", "∂(λᵀτ)/∂q̈"]
            .into_iter()
            .zip(expected);
        for ((name, expected), part) in parts.zip([by.dq, by.dqd, by.dqdd]) {
            found.note(&[Block::new(name, part)], &[Block::new(name, expected)]);
        }
    }
    let by =
        |q: &[Dual; N], qd: &[Dual; N]| robot.inverse_dynamics_derivatives(q, qd, &acceleration);
    let along = |k: usize| Dual::pairs(q, &unit(k));
    let expected = TorqueHessian {
        dq_dq: from_fn(|k| weighted(by(&along(k), &moving).dq)),
        dq_dqd: from_fn(|k| weighted(by(&along(k), &moving).dqd)),
        dqd_dqd: from_fn(|k| weighted(by(&fixed, &Dual::pairs(qd, &unit(k))).dqd)),
        dq_dqdd: from_fn(|k| weighted(robot.mass_matrix(&along(k)))),
    };
    let generated = robot.inverse_dynamics_hessian(q, qd, qdd, &lambda);
    let generic = generic::inverse_dynamics_hessian(chain, q, qd, qdd, &lambda);
    for found_by in [generated, generic] {
        for ((name, block), (_, expected)) in blocks(&found_by).into_iter().zip(blocks(&expected)) {
            note(found, name, block, expected);
        }
    }
}

/// λᵀ A.
fn contracted<const N: usize>(matrix: &Matrix<N>, lambda: &[f64; N]) -> [f64; N] {
    from_fn(|k| {
        matrix
            .iter()
            .zip(lambda)
            .map(|(row, weight)| row[k] * weight)
            .sum()
    })
}

fn slopes<const N: usize>(matrix: [[Dual; N]; N]) -> Matrix<N> {
    matrix.map(|row| row.map(|dual| dual.slope))
}

fn unit<const N: usize>(k: usize) -> [f64; N] {
    from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

/// The worst difference of the gradient and the Hessian of λᵀq̈ from first derivatives on numbers and on dual numbers,
/// and from the generic recursions, in units of rounding.
fn of_weighted_accelerations<R: Differentiable<N>, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, qd, qdd }: &State<f64, N>,
) -> f64 {
    let still = [0.0; N];
    let tau = from_fn(|k| 3.0 * qdd[N - 1 - k]);
    let lambda: [f64; N] = from_fn(|k| q[N - 1 - k] - 0.5 * qd[k]);
    let [fixed, moving, torque] = [q, qd, &tau].map(|list| Dual::pairs(list, &still));
    let first = robot.forward_dynamics_derivatives(q, qd, &tau);
    let expected = AccelerationGradient {
        dq: contracted(&first.dq, &lambda),
        dqd: contracted(&first.dqd, &lambda),
        dtau: contracted(&first.dtau, &lambda),
    };
    let weighted = |matrix: [[Dual; N]; N]| contracted(&slopes(matrix), &lambda);
    let along =
        |k: usize| robot.forward_dynamics_derivatives(&Dual::pairs(q, &unit(k)), &moving, &torque);
    let faster =
        |k: usize| robot.forward_dynamics_derivatives(&fixed, &Dual::pairs(qd, &unit(k)), &torque);
    let second = AccelerationHessian {
        dq_dq: from_fn(|k| weighted(along(k).dq)),
        dq_dqd: from_fn(|k| weighted(along(k).dqd)),
        dqd_dqd: from_fn(|k| weighted(faster(k).dqd)),
        dq_dtau: from_fn(|k| weighted(along(k).dtau)),
    };
    // The rounding of M is magnified twice, in y = M⁻¹ λ and in q̈, and the derivatives of τ once more by M⁻¹.
    let (mass, mobility) = (
        largest(&generic::mass_matrix(chain, q)),
        largest(&first.dtau),
    );
    let accelerations = generic::forward_dynamics(chain, q, qd, &tau);
    let y = [mobility * largest(&[lambda]); N];
    let of_torques = generic::inverse_dynamics_derivatives(chain, q, qd, &accelerations);
    let changes = largest(&of_torques.dq) + largest(&of_torques.dqd);
    let twice = generic::inverse_dynamics_hessian(chain, q, qd, &accelerations, &y);
    let changes_twice = blocks(&twice).map(|(_, block)| largest(block));
    let changes_twice = changes_twice.iter().sum::<f64>() * (1.0 + mobility * changes);
    let lost = 1.0 + mass * mobility;
    let mut worst = 0.0_f64;
    let mut note = |found: f64, size: f64| worst = worst.max(found / size);
    for found in [
        robot.forward_dynamics_vjp(q, qd, &tau, &lambda),
        generic::forward_dynamics_vjp(chain, q, qd, &tau, &lambda),
    ] {
        let size = lost * y[0];
        note(off(&[found.dq], &[expected.dq]), size * (changes + mass));
        note(off(&[found.dqd], &[expected.dqd]), size * (changes + mass));
        note(off(&[found.dtau], &[expected.dtau]), size);
    }
    let [by_q, by_qd, by_tau] = &directions([q, qd, qdd]);
    let [at, faster, harder] =
        [(q, by_q), (qd, by_qd), (&tau, by_tau)].map(|(x, by)| Dual::pairs(x, by));
    let expected = robot.forward_dynamics(&at, &faster, &harder);
    let size = lost
        * mobility
        * (changes + mass)
        * (largest(&[*by_q]) + largest(&[*by_qd]) + largest(&[*by_tau]));
    for found in [
        robot.forward_dynamics_jvp(q, qd, &tau, by_q, by_qd, by_tau),
        generic::forward_dynamics_jvp(chain, q, qd, &tau, by_q, by_qd, by_tau),
    ] {
        let value = expected.map(|dual| dual.value);
        note(
            off(&[found.value], &[value]),
            lost * largest(&[value]) + mobility * largest(&[tau]),
        );
        note(
            off(&[found.change], &[expected.map(|dual| dual.slope)]),
            size,
        );
    }
    for found in [
        robot.forward_dynamics_hessian(q, qd, &tau, &lambda),
        generic::forward_dynamics_hessian(chain, q, qd, &tau, &lambda),
    ] {
        for (found, expected) in [
            (found.dq_dq, second.dq_dq),
            (found.dq_dqd, second.dq_dqd),
            (found.dqd_dqd, second.dqd_dqd),
            (found.dq_dtau, second.dq_dtau),
        ] {
            note(off(&found, &expected), lost * lost * changes_twice);
        }
    }
    worst / DOUBLE
}

/// The matrices of a Hessian, with their names.
fn blocks<const N: usize>(of: &TorqueHessian<N>) -> [(&'static str, &Matrix<N>); 4] {
    [
        ("∂²(λᵀτ)/∂q∂q", &of.dq_dq),
        ("∂²(λᵀτ)/∂q∂q̇", &of.dq_dqd),
        ("∂²(λᵀτ)/∂q̇∂q̇", &of.dqd_dqd),
        ("∂²(λᵀτ)/∂q∂q̈", &of.dq_dqdd),
    ]
}

/// The Coriolis matrix: Ṁ = C + Cᵗ, C q̇ = bias − gravity, and the Christoffel symbols: 2 C = ∂bias/∂q̇.
fn of_coriolis<R: Differentiable<N>, const N: usize>(
    robot: &R,
    State { q, qd, .. }: &State<f64, N>,
    found: &mut Worst,
) {
    let matrix: Matrix<N> = robot.coriolis_matrix(q, qd);
    let rate = robot.mass_matrix(&Dual::pairs(q, qd));
    let rate = rate.map(|row| row.map(|dual| dual.slope));
    let back = transposed(&matrix);
    let sum = from_fn(|i| from_fn(|k| matrix[i][k] + back[i][k]));
    note(found, "C + Cᵗ = Ṁ", &sum, &rate);

    let (bias, gravity) = (robot.bias(q, qd), robot.gravity(q));
    let sum: [f64; N] = from_fn(|i| dot(&matrix[i], qd) + gravity[i]);
    let name = "C q̇ + gravity = bias";
    found.note(&[Block::new(name, sum)], &[Block::new(name, bias)]);

    let fixed = Dual::pairs(q, &[0.0; N]);
    let twice = columns(|d| robot.bias(&fixed, &Dual::pairs(qd, &d)));
    let double = matrix.map(|row| row.map(|entry| entry + entry));
    note(found, "2 C = ∂bias/∂q̇", &double, &twice);
}

/// The worst difference of the derivatives of accelerations from dual numbers and from the generic recursions, in units
/// of rounding.
fn of_accelerations<R: Differentiable<N>, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, qd, qdd }: &State<f64, N>,
) -> f64 {
    let still = [0.0; N];
    let tau = from_fn(|k| 3.0 * qdd[N - 1 - k]);
    let [fixed, moving, torque] = [q, qd, &tau].map(|list| Dual::pairs(list, &still));
    let by = robot.forward_dynamics_derivatives(q, qd, &tau);
    let expected = generic::forward_dynamics_derivatives(chain, q, qd, &tau);
    let dq = columns(|d| robot.forward_dynamics(&Dual::pairs(q, &d), &moving, &torque));
    let dqd = columns(|d| robot.forward_dynamics(&fixed, &Dual::pairs(qd, &d), &torque));
    let dtau = columns(|d| robot.forward_dynamics(&fixed, &moving, &Dual::pairs(&tau, &d)));
    // Relative to M⁻¹ times the torques that cancel: those of the bias, M times the result, and M times the error of q̈
    // that M⁻¹ allows.
    let mass = largest(&generic::mass_matrix(chain, q));
    let bias = generic::inverse_dynamics_derivatives(chain, q, qd, &still);
    let qdd = largest(&[generic::forward_dynamics(chain, q, qd, &tau)]);
    let error = mass * largest(&expected.dtau) * mass * qdd;
    let found = [
        (by.dq, [expected.dq, dq], largest(&bias.dq) + error),
        (by.dqd, [expected.dqd, dqd], largest(&bias.dqd)),
        (by.dtau, [expected.dtau, dtau], 1.0),
    ];
    let found = found.map(|(matrix, both, needed)| {
        let size = largest(&expected.dtau) * (needed + mass * largest(&both[0]));
        let errors = both.map(|expected| off(&matrix, &expected));
        errors[0].max(errors[1]) / size
    });
    found.into_iter().fold(0.0, f64::max) / DOUBLE
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn largest<const N: usize>(rows: &[[f64; N]]) -> f64 {
    let entries = rows.as_flattened().iter();
    entries.fold(0.0, |most, entry| most.max(entry.abs()))
}

/// A matrix of a state in a file.
fn matrix_of<const N: usize>(state: &Value, name: &str) -> Matrix<N> {
    from_fn(|i| from_fn(|k| state[name][i][k].as_f64().expect("a number")))
}

fn agree_with_pinocchio<R: Differentiable<N>, const N: usize>(
    robot: &R,
    states: &Value,
    derivatives: &Value,
) {
    let list = |state: &Value, name: &str| -> [f64; N] {
        from_fn(|k| state[name][k].as_f64().expect("a number"))
    };
    let expected = derivatives["states"].as_array().expect("states");
    assert_eq!(expected.len(), 4);
    for (at, expected) in states["states"]
        .as_array()
        .expect("states")
        .iter()
        .zip(expected)
    {
        let [q, qd, qdd, tau] = ["q", "v", "a", "torque"].map(|name| list(at, name));
        let needed = robot.inverse_dynamics_derivatives(&q, &qd, &qdd);
        let made = robot.forward_dynamics_derivatives(&q, &qd, &tau);
        for (name, found) in [
            ("tau_dq", needed.dq),
            ("tau_dv", needed.dqd),
            ("gravity_dq", robot.gravity_derivative(&q)),
            ("ddq_dq", made.dq),
            ("ddq_dv", made.dqd),
            ("ddq_dtau", made.dtau),
            ("coriolis", robot.coriolis_matrix(&q, &qd)),
        ] {
            let expected = matrix_of(expected, name);
            // A SCARA's gravity is nearly zero for Pinocchio.
            let error = off(&found, &expected) / largest(&expected).max(1e-3);
            assert!(error < TOLERANCE, "{name}: {error:e}");
        }
    }
}

macro_rules! derivatives {
    ($name:ident, $robot:ident) => {
        #[test]
        fn $name() {
            let chain = $robot::chain();
            let mut random = Random::new(21);
            let mut torques = Worst::in_units_of(DOUBLE);
            let mut accelerations: f64 = 0.0;
            for _ in 0..count() {
                let state = State::random(&mut random);
                of_torques(&$robot, &state, &mut torques);
                of_weighted_torques(&$robot, &chain, &state, &mut torques);
                along_directions(&$robot, &chain, &state, &mut torques);
                of_coriolis(&$robot, &state, &mut torques);
                let found = of_accelerations(&$robot, &chain, &state);
                let weighted = of_weighted_accelerations(&$robot, &chain, &state);
                accelerations = accelerations.max(found).max(weighted);
            }
            println!("{torques}accelerations {accelerations:.1} u");
            torques.assert_within(LIMIT);
            assert!(
                accelerations <= LIMIT_OF_SOLUTIONS,
                "{accelerations} u of derivatives of accelerations"
            );

            let read = |text: &str| serde_json::from_str::<Value>(text).expect("JSON");
            let states = include_str!(concat!("../../../reference/", stringify!($name), ".json"));
            let derivatives = include_str!(concat!(
                "../../../reference/",
                stringify!($name),
                "_derivatives.json"
            ));
            agree_with_pinocchio(&$robot, &read(states), &read(derivatives));
        }
    };
}
for_every_robot!(derivatives);

//! Batches compared with single states, bit for bit: every function, on vectors of every length, in batches of many
//! sizes, also of a robot with more coordinates than velocities.
//!
//! In: robots derived with the word `batch`, and random states, one with NaN and one with huge angles among them.
//! Columns are compared with the same numbers by states.

use std::fmt::Debug;

use homogen::batch::{Batch, BatchError, ColumnsError, Vectors};
use homogen::robot::{Batched, InverseDynamics};
use homogen::{
    Acceleration, AccelerationChange, AccelerationDerivatives, AccelerationGradient,
    AccelerationHessian, Action, Momentum, Point, Pose, Robot, Scalar, Screw, TorqueChange,
    TorqueDerivatives, TorqueGradient, TorqueHessian, Velocity, chain,
};
use homogen_random::Random;

/// The two-link arm with a field.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/two_link.urdf",
    tip = "fore",
    batch,
    generate(all)
)]
struct TwoLink {
    #[robot(mass_of = "fore")]
    payload: f64,
}

chain! {
    /// A ball joint, a prismatic joint, and a hand that mimics the latter.
    struct Puppet { tip: hand, batch, generate(all) }
    link base;
    joint ball: spherical { from: base, to: arm, at: xyz(0.1, 0.0, 0.2) rpy(0.1, 0.2, 0.3) }
    link arm { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
    joint slider: prismatic(x) { from: arm, to: rod, at: xyz(0.0, 0.1, 0.3) }
    link rod { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.001, 0.01, 0.01] }
    joint wrist: revolute(y) { from: rod, to: hand, at: xyz(0.2, 0.0, 0.0), mimic: slider, multiplier: 4.0 }
    link hand { mass: 0.4, com: [0.0, 0.0, 0.05], inertia: [0.002, 0.002, 0.001] }
}

/// Seven joints: four entries are moved at a time, and some of them twice.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/panda_class.urdf",
    tip = "link8",
    generate(inverse_dynamics),
    batch
)]
struct Arm;

/// The same arm, without fused products on any processor.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/panda_class.urdf",
    tip = "link8",
    generate(inverse_dynamics),
    batch,
    reproducible
)]
struct Reproducible;

/// The same arm in sections, each a function of its own.
#[derive(Robot)]
#[robot(
    urdf = "../../robots/panda_class.urdf",
    tip = "link8",
    generate(inverse_dynamics),
    batch,
    section = 60
)]
struct InSections;

/// The same arm behind a call that is not marked as inlined.
struct Called(Arm);

impl Batched for Called {}

impl<T: Scalar> InverseDynamics<7, T> for Called {
    fn inverse_dynamics(&self, q: &[T; 7], qd: &[T; 7], qdd: &[T; 7]) -> [T; 7] {
        self.0.inverse_dynamics(q, qd, qdd)
    }
}

/// The number of states.
const COUNT: usize = 40;

/// Sizes of batches: empty, one, and around multiples of packs.
const SIZES: [usize; 15] = [0, 1, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 32, 33, COUNT];

const VECTORS: [Vectors; 2] = [Vectors::Bits256, Vectors::Bits512];

/// The arguments of all states.
struct States<T, const N: usize, const Q: usize> {
    q: Vec<[T; Q]>,
    qd: Vec<[T; N]>,
    qdd: Vec<[T; N]>,
    tau: Vec<[T; N]>,
    weights: Vec<[T; N]>,
    q_change: Vec<[T; N]>,
    qd_change: Vec<[T; N]>,
    qdd_change: Vec<[T; N]>,
    tau_change: Vec<[T; N]>,
    wrench: Vec<[T; 6]>,
}

/// Random states; the sixth has NaN coordinates, the twelfth angles of 7e6 rad.
fn states<T: Copy, const N: usize, const Q: usize>(number: fn(f64) -> T) -> States<T, N, Q> {
    let mut random = Random::new(5);
    let mut numbers = || std::array::from_fn(|_| number(3.0 * random.unit() - 1.5));
    let mut q: Vec<[T; Q]> = (0..COUNT).map(|_| numbers()).collect();
    q[5] = [number(f64::NAN); Q];
    q[11] = q[11].map(|_| number(7e6));
    let mut random = Random::new(6);
    let [qd, qdd, tau, weights] = [(); 4].map(|()| list(&mut random, number));
    let wrench = list(&mut random, number);
    let [q_change, qd_change, qdd_change, tau_change] = [(); 4].map(|()| list(&mut random, number));
    States {
        q,
        qd,
        qdd,
        tau,
        weights,
        q_change,
        qd_change,
        qdd_change,
        tau_change,
        wrench,
    }
}

fn list<T, const N: usize>(random: &mut Random, number: fn(f64) -> T) -> Vec<[T; N]> {
    let mut state = |_| std::array::from_fn(|_| number(4.0 * random.unit() - 2.0));
    (0..COUNT).map(&mut state).collect()
}

/// The numbers of a result one by one, in the order of columns.
trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl Numbers for f64 {
    fn numbers(&self) -> Vec<f64> {
        vec![*self]
    }
}

impl<X: Numbers, const K: usize> Numbers for [X; K] {
    fn numbers(&self) -> Vec<f64> {
        self.iter().flat_map(Numbers::numbers).collect()
    }
}

macro_rules! numbers {
    ($($kind:ty: $result:ident => $($part:expr),*;)*) => {$(
        impl Numbers for $kind {
            fn numbers(&self) -> Vec<f64> {
                let $result = self;
                [$($part.numbers()),*].concat()
            }
        }
    )*};
}
numbers! {
    Pose<f64>: m => m.rotation(), m.translation();
    Screw<f64>: l => l.u(), l.b();
    Velocity<f64>: w => w.omega(), w.v();
    Acceleration<f64>: h => h.g(), h.a();
    Momentum<f64>: gamma => gamma.gamma(), gamma.rho();
    Action<f64>: phi => phi.c(), phi.f();
    Point<f64>: p => p.0;
    TorqueDerivatives<N, f64>: d => d.dq, d.dqd;
    AccelerationDerivatives<N, f64>: d => d.dq, d.dqd, d.dtau;
    TorqueChange<N, f64>: c => c.value, c.change;
    AccelerationChange<N, f64>: c => c.value, c.change;
    TorqueGradient<N, f64>: g => g.dq, g.dqd, g.dqdd;
    AccelerationGradient<N, f64>: g => g.dq, g.dqd, g.dtau;
    AccelerationHessian<N, f64>: h => h.dq_dq, h.dq_dqd, h.dqd_dqd, h.dq_dtau;
    TorqueHessian<N, f64>: h => h.dq_dq, h.dq_dqd, h.dqd_dqd, h.dq_dqdd;
}

/// The first entries of all states, then the second ones, and so on.
fn columns_of<T: Copy, const K: usize>(states: &[[T; K]]) -> [Vec<T>; K] {
    std::array::from_fn(|k| states.iter().map(|state| state[k]).collect())
}

/// Asserts equal digits and equal signs of zeros; NaN equals NaN.
fn same(what: &str, found: &[impl Debug], expected: &[impl Debug]) {
    let size = expected.len();
    assert_eq!(found.len(), size);
    for (state, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_eq!(
            format!("{found:?}"),
            format!("{expected:?}"),
            "{what}, state {state} of {size}"
        );
    }
}

/// Compares every function in every size on vectors of every length, and refusals of slices that are too short.
macro_rules! compare {
    ($(
        $(#[doc = $about:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {
        fn compare(robot: &Subject, states: &States<Number, N, Q>) {
            $({
                let state = |i: usize| robot.$method($(&states.$argument[i]),*);
                let alone: Vec<_> = (0..COUNT).map(state).collect();
                for (size, vectors) in SIZES.iter().flat_map(|size| VECTORS.map(|most| (*size, most))) {
                    let what = format!("{} on {vectors:?}", stringify!($method));
                    let mut results: Vec<_> = alone[..size].iter().rev().copied().collect();
                    let batch = Batch::of(robot).at_most(vectors);
                    batch.$method($(&states.$argument[..size],)* &mut results).expect("as long");
                    same(&what, &results, &alone[..size]);
                }
                $(let $argument = columns_of(&states.$argument);)*
                let wanted: Vec<Vec<f64>> = alone.iter().map(Numbers::numbers).collect();
                let count = wanted[0].len();
                for (size, vectors) in SIZES.iter().flat_map(|size| VECTORS.map(|most| (*size, most))) {
                    let mut results = vec![vec![0.5; size]; count];
                    let mut columns: Vec<&mut [f64]> = results.iter_mut().map(Vec::as_mut_slice).collect();
                    let batch = Batch::of(robot).at_most(vectors).columns();
                    let done = batch.$method($($argument.each_ref().map(|column| &column[..size]),)* &mut columns);
                    assert_eq!(done, Ok(()));
                    let found = (0..size).map(|state| results.iter().map(|column| column[state]).collect());
                    let found: Vec<Vec<f64>> = found.collect();
                    same(&format!("columns of {} on {vectors:?}", stringify!($method)), &found, &wanted[..size]);
                }
                for (columns, length) in [(count + 1, COUNT), (count - 1, COUNT), (count, COUNT - 1)] {
                    let mut results = vec![vec![0.5; length]; columns];
                    let mut results: Vec<&mut [f64]> = results.iter_mut().map(Vec::as_mut_slice).collect();
                    let arguments = Batch::of(robot).columns();
                    let refusal = arguments.$method($($argument.each_ref().map(Vec::as_slice),)* &mut results);
                    let expected = if columns == count {
                        ColumnsError::Length { argument: "results", column: 0, length, expected: COUNT }
                    } else {
                        ColumnsError::Count { columns, expected: count }
                    };
                    assert_eq!(refusal, Err(expected));
                    assert!(results.iter().all(|column| column.iter().all(|number| *number == 0.5)));
                }
                let arguments = [$(stringify!($argument),)* "results"];
                for wrong in arguments {
                    let length = |argument| COUNT - usize::from(argument == wrong);
                    let mut results = vec![alone[0]; length("results")];
                    let refusal = Batch::of(robot).$method(
                        $(&states.$argument[..length(stringify!($argument))],)*
                        &mut results,
                    );
                    let argument = if wrong == "q" { arguments[1] } else { wrong };
                    let (length, expected) = (length(argument), length("q"));
                    assert_eq!(refusal, Err(BatchError { argument, length, expected }));
                    same("refused", &results, &vec![alone[0]; results.len()]);
                }
            })*
        }
    };
}

type Subject = TwoLink;
type Number = f64;
const N: usize = 2;
const Q: usize = 2;
homogen::every_function!(compare);

#[test]
fn every_function_of_a_batch_gives_the_bits_of_each_state() {
    compare(&TwoLink { payload: 1.3 }, &states(|value| value));
}

#[test]
fn single_precision_and_quaternions_give_the_bits_of_each_state() {
    let number = <f32 as Scalar>::constant;
    let States { q, qd, .. } = states::<f32, 4, 5>(number);
    for vectors in VECTORS {
        let batch = Batch::of(&Puppet).at_most(vectors);
        let mut poses = vec![Puppet.forward_kinematics(&q[0]); COUNT];
        assert_eq!(batch.forward_kinematics(&q, &mut poses), Ok(()));
        let alone: Vec<_> = q.iter().map(|q| Puppet.forward_kinematics(q)).collect();
        same("pose", &poses, &alone);

        let mut bias = vec![[0.0; 4]; COUNT];
        assert_eq!(batch.bias(&q, &qd, &mut bias), Ok(()));
        let each = q.iter().zip(&qd);
        let alone: Vec<_> = each.map(|(q, qd)| Puppet.bias(q, qd)).collect();
        same("bias", &bias, &alone);
    }
}

/// Compares inverse dynamics of one robot in one type, on vectors of every length, in batches of every size.
macro_rules! compare_inverse_dynamics {
    ($robot:expr, $number:ident) => {{
        let (robot, number) = ($robot, <$number as Scalar>::constant);
        let States { q, qd, qdd, .. } = states::<$number, 7, 7>(number);
        let alone: Vec<[$number; 7]> = (0..COUNT)
            .map(|i| robot.inverse_dynamics(&q[i], &qd[i], &qdd[i]))
            .collect();
        for (size, vectors) in SIZES
            .iter()
            .flat_map(|size| VECTORS.map(|most| (*size, most)))
        {
            let what = format!("inverse dynamics on {vectors:?}");
            let mut tau = vec![[number(0.5); 7]; size];
            let batch = Batch::of(&robot).at_most(vectors);
            let done = batch.inverse_dynamics(&q[..size], &qd[..size], &qdd[..size], &mut tau);
            assert_eq!(done, Ok(()));
            same(&what, &tau, &alone[..size]);
        }
    }};
}

#[test]
fn functions_in_registers_in_sections_or_not_inlined_give_the_bits_of_each_state() {
    assert_eq!(<Arm as Batched>::INLINED, ["inverse_dynamics"]);
    assert!(<Called as Batched>::INLINED.is_empty());
    compare_inverse_dynamics!(Arm, f64);
    compare_inverse_dynamics!(Arm, f32);
    compare_inverse_dynamics!(InSections, f64);
    compare_inverse_dynamics!(InSections, f32);
    compare_inverse_dynamics!(Called(Arm), f64);
    compare_inverse_dynamics!(Called(Arm), f32);
    compare_inverse_dynamics!(Reproducible, f64);
    compare_inverse_dynamics!(Reproducible, f32);
}

#[test]
fn a_robots_own_batches_give_the_bits_of_each_state_on_all_cores() {
    let States { q, qd, qdd, .. } = states::<f64, 4, 5>(|value| value);
    let many = |list: &[[f64; 4]]| list.iter().cycle().take(5003).copied().collect::<Vec<_>>();
    let q: Vec<_> = q.iter().cycle().take(5003).copied().collect();
    let (qd, qdd) = (many(&qd), many(&qdd));
    let mut tau = many(&[[0.0; 4]]);
    assert_eq!(
        Puppet.inverse_dynamics_batch(&q, &qd, &qdd, &mut tau),
        Ok(())
    );
    let alone: Vec<_> = (0..q.len())
        .map(|i| Puppet.inverse_dynamics(&q[i], &qd[i], &qdd[i]))
        .collect();
    same("inverse dynamics", &tau, &alone);
    let columns = [columns_of(&qd), columns_of(&qdd)];
    let [qd, qdd] = columns
        .each_ref()
        .map(|columns| columns.each_ref().map(Vec::as_slice));
    let q_columns = columns_of(&q);
    let q_columns = q_columns.each_ref().map(Vec::as_slice);
    // A column-major array of shape (5003, 4).
    let mut results = vec![0.0; 4 * 5003];
    let mut results: Vec<&mut [f64]> = results.chunks_mut(5003).collect();
    let batch = Batch::of(&Puppet).columns();
    assert_eq!(
        batch.inverse_dynamics(q_columns, qd, qdd, &mut results),
        Ok(())
    );
    let found: Vec<[f64; 4]> = (0..5003)
        .map(|i| std::array::from_fn(|k| results[k][i]))
        .collect();
    same("inverse dynamics of columns", &found, &alone);
    let shorter = [qd[0], qd[1], &qd[2][1..], qd[3]];
    let refusal = batch.inverse_dynamics(q_columns, shorter, qdd, &mut results);
    assert_eq!(
        refusal.map_err(|error| error.to_string()),
        Err("column 2 of `qd` has 5002 states, the first of `q` has 5003".to_owned())
    );
    let refusal = batch.inverse_dynamics(q_columns, qd, qdd, &mut results[1..]);
    assert_eq!(
        refusal.map_err(|error| error.to_string()),
        Err("`results` has 3 columns, a result has 4 numbers".to_owned())
    );
    assert_eq!(
        Puppet
            .gravity_batch(&q, &mut tau[1..])
            .map_err(|error| error.to_string()),
        Err("`results` has 5002 states, `q` has 5003".to_owned())
    );
}

//! Batches against the functions of one state, bit for bit: every function, on vectors of every length, for
//! batches of every size; and some of a robot with more coordinates than velocities.
//!
//! In: robots that are derived with the word `batch`, and random states, one without numbers and one with
//! angles beyond any turn among them. What is fused is held against one state of fused numbers.

use std::fmt::Debug;

use homogen::batch::{Batch, BatchError, Packed, Vectors};
use homogen::{Fused, Pack, Robot, chain};
use homogen_random::Random;

/// The two-link arm, with a field.
#[derive(Robot)]
#[robot(urdf = "../robots/two_link.urdf", tip = "fore", batch)]
struct TwoLink {
    #[robot(mass_of = "fore")]
    payload: f64,
}

chain! {
    /// A ball joint, and a slider that turns a hand along.
    struct Puppet { tip: hand, batch }
    link base;
    joint ball: spherical { from: base, to: arm, at: xyz(0.1, 0.0, 0.2) rpy(0.1, 0.2, 0.3) }
    link arm { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
    joint slider: prismatic(x) { from: arm, to: rod, at: xyz(0.0, 0.1, 0.3) }
    link rod { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.001, 0.01, 0.01] }
    joint wrist: revolute(y) { from: rod, to: hand, at: xyz(0.2, 0.0, 0.0), mimic: slider, multiplier: 4.0 }
    link hand { mass: 0.4, com: [0.0, 0.0, 0.05], inertia: [0.002, 0.002, 0.001] }
}

/// How many states there are.
const COUNT: usize = 40;

/// Sizes of batches: none, one, and around those of packs and of several packs.
const SIZES: [usize; 15] = [0, 1, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 32, 33, COUNT];

const VECTORS: [Vectors; 3] = [Vectors::OfTarget, Vectors::Bits256, Vectors::Bits512];

/// Whether a batch of fused numbers fuses, on vectors of some length.
fn fuses(vectors: Vectors) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let has = std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma");
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let has = false;
    let compiled = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
    compiled || has && vectors != Vectors::OfTarget
}

/// The arguments of many calls.
struct States<T, const N: usize, const Q: usize> {
    q: Vec<[T; Q]>,
    qd: Vec<[T; N]>,
    qdd: Vec<[T; N]>,
    tau: Vec<[T; N]>,
}

/// Random states; the sixth has no number in it, the twelfth angles of a million turns.
fn states<T: Copy, const N: usize, const Q: usize>(number: fn(f64) -> T) -> States<T, N, Q> {
    let mut random = Random::new(5);
    let mut numbers = || std::array::from_fn(|_| number(3.0 * random.unit() - 1.5));
    let mut q: Vec<[T; Q]> = (0..COUNT).map(|_| numbers()).collect();
    q[5] = [number(f64::NAN); Q];
    q[11] = q[11].map(|_| number(7e6));
    let mut random = Random::new(6);
    let mut list = || -> Vec<[T; N]> {
        let state = |_| std::array::from_fn(|_| number(4.0 * random.unit() - 2.0));
        (0..COUNT).map(state).collect()
    };
    let (qd, qdd, tau) = (list(), list(), list());
    States { q, qd, qdd, tau }
}

/// A state as packs of one lane.
fn fused<T: Copy, const N: usize>(state: &[T; N]) -> [Pack<Fused<T>, 1>; N] {
    state.map(|entry| Pack([Fused(entry)]))
}

/// All digits count, and the sign of a zero; not a number is not a number.
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

/// Every function in every size, on vectors of every length, and refused where a slice is too short.
macro_rules! compare {
    ($(
        $(#[doc = $about:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {
        fn compare(robot: &Subject, states: &States<Number, N, Q>) {
            $({
                let state = |i: usize| robot.$method($(&states.$argument[i]),*);
                let alone: Vec<_> = (0..COUNT).map(state).collect();
                let state = |i: usize| robot.$method($(&fused(&states.$argument[i])),*).lane(0);
                let all_fused: Vec<_> = (0..COUNT).map(state).collect();
                for (size, vectors) in SIZES.iter().flat_map(|size| VECTORS.map(|most| (*size, most))) {
                    let what = format!("{} on {vectors:?}", stringify!($method));
                    let other = || alone[..size].iter().rev().copied().collect::<Vec<_>>();

                    let mut results = other();
                    let batch = Batch::of(robot).at_most(vectors);
                    batch.$method($(&states.$argument[..size],)* &mut results).expect("as long");
                    same(&what, &results, &alone[..size]);

                    let mut results = other();
                    let batch = Batch::fused(robot).at_most(vectors);
                    batch.$method($(&states.$argument[..size],)* &mut results).expect("as long");
                    let expected = if fuses(vectors) { &all_fused } else { &alone };
                    same(&format!("fused {what}"), &results, &expected[..size]);
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
fn every_function_of_many_states_is_that_of_each() {
    compare(&TwoLink { payload: 1.3 }, &states(|value| value));
}

#[test]
fn results_of_single_precision_and_of_quaternions_are_those_of_each_state() {
    let number = <f32 as homogen::Scalar>::constant;
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

#[test]
fn a_robot_has_batches_of_its_own_on_all_cores() {
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
    assert_eq!(
        Puppet
            .gravity_batch(&q, &mut tau[1..])
            .map_err(|error| error.to_string()),
        Err("`results` has a length of 5002, and `q` of 5003".to_owned())
    );
}

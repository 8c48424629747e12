//! Time and bits of every function of the robots that ship.
//!
//! In: nothing. Out: a line for each function: robot, function, nanoseconds a call, a hash of the bits of its results.
//! `report/flags.py` compiles this program in several ways, runs them in turns and compares them.

use std::fmt::{Debug, Write};
use std::hint::black_box;
use std::mem::MaybeUninit;
use std::time::Instant;

/// Number of states.
const STATES: usize = 32;

/// Numbers in [−1.5, 1.5], by a linear congruential generator.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = (self.0.wrapping_mul(6_364_136_223_846_793_005))
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).expect("32 bits")) / f64::from(u32::MAX) * 3.0 - 1.5
    }

    fn list<const N: usize>(&mut self) -> Vec<[f64; N]> {
        (0..STATES)
            .map(|_| std::array::from_fn(|_| self.next()))
            .collect()
    }
}

/// FNV-1a of a text that has every digit.
struct Digest(u64);

impl Write for Digest {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        for byte in text.bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        Ok(())
    }
}

/// Calls a function with its frame so many bytes further below the place of its result.
#[inline(never)]
fn below<const BYTES: usize, R>(call: &dyn Fn(usize) -> R, state: usize) -> R {
    let between = MaybeUninit::<[u8; BYTES]>::uninit();
    black_box(&between);
    call(state)
}

/// Prints the line of a function: the time is the least of 100 rounds over all states at each of four distances between
/// the arrays of the function and its result. On an AMD EPYC some functions take up to three times as long at one distance
/// as at another, and no flag decides it.
fn measure<R: Debug>(robot: &str, function: &str, call: &dyn Fn(usize) -> R) {
    let mut digest = Digest(0xcbf2_9ce4_8422_2325);
    for state in 0..STATES {
        write!(digest, "{:?}", call(state)).expect("a digest takes everything");
    }
    let least = least(call)
        .min(least(&|state| below::<400, R>(call, state)))
        .min(least(&|state| below::<1104, R>(call, state)))
        .min(least(&|state| below::<1968, R>(call, state)));
    println!("{robot} {function} {least} {:016x}", digest.0);
}

/// Nanoseconds a call: the least of 100 rounds.
fn least<R>(call: &dyn Fn(usize) -> R) -> f64 {
    let time = || {
        let start = Instant::now();
        for _ in 0..4 {
            for state in 0..STATES {
                // By reference: a moved result would be loaded again, after its stores.
                black_box(&call(black_box(state)));
            }
        }
        start.elapsed().as_secs_f64() * 1e9 / 128.0
    };
    (0..100).map(|_| time()).fold(f64::INFINITY, f64::min)
}

/// Arguments of all states.
struct States<const N: usize> {
    q: Vec<[f64; N]>,
    qd: Vec<[f64; N]>,
    qdd: Vec<[f64; N]>,
    tau: Vec<[f64; N]>,
    weights: Vec<[f64; N]>,
    q_change: Vec<[f64; N]>,
    qd_change: Vec<[f64; N]>,
    qdd_change: Vec<[f64; N]>,
    tau_change: Vec<[f64; N]>,
    wrench: Vec<[f64; 6]>,
}

impl<const N: usize> States<N> {
    fn random() -> Self {
        let mut random = Random(1);
        let [q, qd, qdd, tau, weights] = [(); 5].map(|()| random.list());
        let wrench = random.list();
        let [q_change, qd_change, qdd_change, tau_change] = [(); 4].map(|()| random.list());
        Self {
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
}

/// Measures every function of a robot.
macro_rules! robot {
    ($name:literal, $file:literal, $tip:literal, $joints:literal, [$($key:ident)?];
        $(
            $(#[doc = $about:literal])+
            $kind:ident $trait:ident $method:ident($($argument:ident),*) -> $result:ty;
        )*
    ) => {{
        #[derive(homogen::Robot)]
        #[robot(urdf = $file, tip = $tip, quiet, generate(all) $(, $key)?)]
        struct Subject;

        let states = States::<$joints>::random();
        $(measure($name, stringify!($method), &|i| Subject.$method($(&states.$argument[i]),*));)*
    }};
}

/// Measures every robot.
macro_rules! robots {
    ($($rows:tt)*) => {
        fn main() {
            robot!("two_link", "../../robots/two_link.urdf", "fore", 2, []; $($rows)*);
            robot!("scara", "../../robots/scara.urdf", "tool", 4, []; $($rows)*);
            robot!("stanford", "../../robots/stanford.urdf", "tool", 6, []; $($rows)*);
            robot!("puma560", "../../robots/puma560.urdf", "tool", 6, []; $($rows)*);
            robot!("ur5_class", "../../robots/ur5_class.urdf", "tool0", 6, []; $($rows)*);
            robot!("panda_class", "../../robots/panda_class.urdf", "link8", 7, []; $($rows)*);
            robot!("quadruped", "../../robots/quadruped.urdf", "fl_foot", 12, []; $($rows)*);
            robot!("two_link_reproducible", "../../robots/two_link.urdf", "fore", 2, [reproducible]; $($rows)*);
            robot!("panda_class_reproducible", "../../robots/panda_class.urdf", "link8", 7, [reproducible]; $($rows)*);
            robot!("quadruped_reproducible", "../../robots/quadruped.urdf", "fl_foot", 12, [reproducible]; $($rows)*);
        }
    };
}
homogen::every_function!(robots);

//! Text of a package for Python: the class in Rust and the stub of a small robot.
//!
//! Text is pinned so that changes are reviewed. `python/run.sh` tests the results of packages; here their integration
//! of quaternions is compared with the runtime's, bit for bit.

#[path = "../../../codegen/src/print/python/package/number.rs"]
#[allow(dead_code, clippy::pedantic, reason = "a file of packages")]
mod number;
#[path = "../../../codegen/src/print/python/package/pack.rs"]
#[allow(dead_code, clippy::pedantic, reason = "a file of packages")]
mod pack;
#[path = "../../../codegen/src/print/python/package/processor.rs"]
#[allow(clippy::pedantic, reason = "a file of packages")]
mod processor;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[path = "../../../codegen/src/print/python/package/turned_f64.rs"]
#[allow(clippy::pedantic, reason = "a file of packages")]
mod turned;

use std::array::from_fn;

use homogen_codegen::Function::{ForwardKinematics, InverseDynamics, InverseDynamicsDerivatives};
use homogen_codegen::{Builder, Function};
use homogen_tests::states::Random;
use number::Lanes;
use pack::Pack;
use processor::Vectors;

/// A file of the package of the two-link arm.
fn file(functions: &[Function], path: &str) -> String {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/two_link.urdf");
    let builder = Builder::from_urdf(robot).generate(functions.iter().copied());
    let package = builder.to_python("two_link");
    let package = package.unwrap_or_else(|errors| panic!("{errors}"));
    let mut files = package.files.into_iter();
    let found = files.find(|(other, _)| other == path);
    found.unwrap_or_else(|| panic!("{path} is written")).1
}

#[test]
fn the_class_of_two_links() {
    let functions = [InverseDynamics, InverseDynamicsDerivatives];
    insta::assert_snapshot!(file(&functions, "src/lib.rs"));
}

#[test]
fn the_stub_of_two_links() {
    let functions = [
        ForwardKinematics,
        InverseDynamics,
        InverseDynamicsDerivatives,
    ];
    insta::assert_snapshot!(file(&functions, "python/two_link/__init__.pyi"));
}

#[test]
fn the_functions_of_two_links() {
    insta::assert_snapshot!(file(&[InverseDynamics], "src/robot.rs"));
}

/// The constants of a package for its type of number.
#[allow(dead_code, reason = "not every processor has registers of two lengths")]
mod real {
    mod sines {
        include!("../../../codegen/src/print/rust/sines/double.rs");

        pub fn of(angle: f64) -> (f64, f64) {
            sin_cos(angle)
        }
    }

    pub use sines::of as sin_cos;

    pub type Real = f64;
    pub const LIMIT: Real = 2e5;
    pub const NARROW: usize = 4;
    pub const WIDE: usize = 8;
}

/// The functions of a robot with every type of joint.
#[allow(
    dead_code,
    clippy::all,
    clippy::pedantic,
    reason = "a file of packages"
)]
mod robot {
    include!(concat!(env!("OUT_DIR"), "/joints_lanes.rs"));
}

/// The same robot, by the runtime.
#[derive(homogen::Robot)]
#[robot(urdf = "../robots/every_joint.urdf", generate(gravity))]
struct OfRuntime;

/// Results of `integrate`, with one state in each lane.
fn in_lanes<P: Vectors<L>, const L: usize>(
    processor: P,
    from: &[[f64; 25]],
    v: &[[f64; 23]],
) -> Vec<[f64; 25]> {
    let mut ahead = vec![[0.0; 25]; from.len()];
    let states = from.chunks(L).zip(v.chunks(L));
    for ((from, v), ahead) in states.zip(ahead.chunks_mut(L)) {
        let mut q = [Pack::filled(processor, 0.0); 25];
        let mut qd = [Pack::filled(processor, 0.0); 23];
        Pack::load(from, &mut q);
        Pack::load(v, &mut qd);
        let (stepped,) = robot::Joints.integrate(&q, &qd);
        Pack::store(&stepped, ahead.as_flattened_mut());
    }
    ahead
}

/// The same in each length of registers that this processor has.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn in_registers(from: &[[f64; 25]], v: &[[f64; 23]]) -> Vec<Vec<[f64; 25]>> {
    use pulp::x86::{V3, V4};
    let narrow = V3::try_new().map(|processor| in_lanes::<_, { real::NARROW }>(processor, from, v));
    let wide = V4::try_new().map(|processor| in_lanes::<_, { real::WIDE }>(processor, from, v));
    narrow.into_iter().chain(wide).collect()
}

/// The same as arrays, without registers.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn in_registers(from: &[[f64; 25]], v: &[[f64; 23]]) -> Vec<Vec<[f64; 25]>> {
    vec![in_lanes::<_, 4>((), from, v), in_lanes::<_, 8>((), from, v)]
}

#[test]
fn integration_in_packages_has_the_bits_of_the_runtime() {
    let mut random = Random::new(20);
    for size in [1e300, 1e200, 1e20, 1e-20, 1e-200, 1e-310, 5e-324, 0.0] {
        let q = from_fn(|k| size * [0.3, -1.0, 0.0, 0.7][k % 4]);
        let (found,) = robot::Joints.normalize(&q);
        let expected = OfRuntime.normalize(&q);
        assert_eq!(
            found.map(f64::to_bits),
            expected.map(f64::to_bits),
            "{size:e}"
        );
    }
    let (mut starts, mut motions, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    // A number of states that does not fill the last register.
    for state in 0..4003 {
        // From no motion to several full turns, and near half turns.
        let size = 10.0_f64.powi(state % 12 - 10);
        let mut number = || random.unit();
        let (from, to): ([f64; 25], [f64; 25]) = (from_fn(|_| number()), from_fn(|_| number()));
        let v: [f64; 23] = from_fn(|_| size * number());
        let [from, to] = [from, to].map(|q| {
            let normalized = OfRuntime.normalize(&q);
            assert_eq!(robot::Joints.normalize(&q), (normalized,));
            normalized
        });
        let ahead = OfRuntime.integrate(&from, &v);
        assert_eq!(robot::Joints.integrate(&from, &v), (ahead,));
        starts.push(from);
        motions.push(v);
        ends.push(ahead);
        for to in [ahead, to] {
            let apart = OfRuntime.difference(&from, &to);
            assert_eq!(robot::Joints.difference(&from, &to), (apart,));
        }
    }
    for found in in_registers(&starts, &motions) {
        assert_eq!(found, ends);
    }
}

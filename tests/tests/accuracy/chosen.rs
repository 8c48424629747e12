//! Accelerations by the algorithm that the engine chooses, in many random states.
//!
//! In: the robots that ship, and humanoids, with fixed and floating bases. Out: a failed test if a result is off by more
//! than the guide states: 100 u of the largest acceleration. The truth is the mass matrix of the description in 106
//! bits. States have any angles: a waist of three joints is singular where two of its axes are in line, beyond the
//! limits of real ones.

use std::path::Path;

use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Description, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::Double;
use homogen_codegen::request::Request;
use homogen_codegen::space::{FrameId, Space, Variable};
use homogen_codegen::{Function, list::Id};
use homogen_tests::arguments::{Arguments, at, of_lists};
use homogen_tests::climb::exactly;
use homogen_tests::effort::effort;
use homogen_tests::metrics;
use homogen_tests::programs::program;
use homogen_tests::states::Random;
use homogen_tests::subjects::subject;
use homogen_tests::tested::{F32, F64, Tested};

/// The largest error relative to the largest acceleration [u].
const LIMIT: f64 = 100.0;

/// The robots of the files that ship.
const SHIPPED: [&str; 9] = [
    "two_link",
    "scara",
    "stanford",
    "stanford_general",
    "puma560",
    "puma560_general",
    "ur5_class",
    "panda_class",
    "quadruped",
];

fn read(file: &str) -> Description {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let description = read_file(&folder.join(file), None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

fn chain(description: &Description, floating: bool) -> Chain {
    let request = Request {
        floating,
        ..Request::default()
    };
    chain::build(description, &request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Random arguments; quaternions have length 1.
fn state(chain: &Chain, random: &mut Random) -> Arguments {
    let spaces = chain.spaces();
    let [coordinates, velocities] =
        [Space::Coordinates, Space::Velocities].map(|space| spaces.len(space));
    let mut arguments = of_lists(coordinates, velocities, random);
    for first in spaces.quaternions() {
        let quaternion = &mut arguments[Variable::Q][first.index()..][..4];
        let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        for entry in quaternion {
            *entry /= length;
        }
    }
    arguments
}

/// The largest error of a chain's accelerations in a type, relative to the largest one [u].
fn worst<T: Tested>(chain: &Chain, states: usize) -> f64 {
    let function = Function::ForwardDynamics;
    let program = program(chain, &[function], FrameId::FIRST, T::REAL);
    let program = program.unwrap_or_else(|errors| panic!("{errors}"));
    let exact = exactly(chain, function);
    let mut random = Random::new(1);
    let errors = (0..states).map(|_| {
        let mut state = state(chain, &mut random);
        // The arguments of a type are exact.
        for variable in Variable::ALL {
            for entry in &mut state[variable] {
                *entry = T::literal(*entry).to_f64();
            }
        }
        let exact = exact.at(|input| Double::from(at(&state, input)));
        let found = metrics::results::<T>(&program, &state);
        let size = metrics::largest(exact.iter().map(|exact| exact.to_f64().abs()));
        let pairs = found.iter().zip(&exact);
        let errors = pairs.map(|(&found, exact)| (Double::from(found) - *exact).to_f64().abs());
        metrics::largest(errors) / size / T::ROUNDOFF
    });
    metrics::largest(errors)
}

/// Fails if an error exceeds the limit.
fn judge(name: &str, chain: &Chain) {
    let states = effort(1_024, 8_192);
    for (of, worst) in [
        (F64::NAME, worst::<F64>(chain, states)),
        (F32::NAME, worst::<F32>(chain, states)),
    ] {
        println!("{name} in {of}: {worst:.1} u");
        assert!(worst <= LIMIT, "{name} in {of}: {worst} u");
    }
}

#[test]
fn accelerations_of_the_robots_that_ship() {
    for robot in SHIPPED {
        let description = read(&format!("../robots/{robot}.urdf"));
        judge(robot, &chain(&description, false));
    }
}

/// The bases of the others have no inertia.
#[test]
fn accelerations_of_a_quadruped_on_a_floating_base() {
    let description = read("../robots/quadruped.urdf");
    judge("floating quadruped", &chain(&description, true));
}

#[test]
fn accelerations_of_humanoids() {
    let mut waist = subject("waist_with_arm/0").description;
    // A pelvis with the inertia of the torso, on the third joint.
    waist.links[0].inertial = waist.links[3].inertial.clone();
    for (name, description) in [
        ("humanoid", read("robots/humanoid.urdf")),
        ("waist with arm", waist),
    ] {
        for floating in [false, true] {
            let base = if floating { "floating " } else { "" };
            judge(&format!("{base}{name}"), &chain(&description, floating));
        }
    }
}

//! Struct fields in place of numbers of the description.
//!
//! With the file's numbers they give the results of constants; with others, those of the generic recursions on
//! `chain(&self)`. Fields may be of any type that converts to `f64`.

use homogen::{Chain, Payload, Robot};
use homogen_codegen::description::{Description, Step, read_file};
use homogen_codegen::error::Errors;
use homogen_robots::shipped::PandaClass;
use homogen_robots::with_every_function;
use homogen_tests::effort::effort;
use homogen_tests::functions::{EveryFunction, evaluate};
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot.
fn count() -> usize {
    effort(25, 100)
}

/// The worst is 27 u.
const LIMIT: f64 = 64.0;

/// Derives the Panda-class arm with the functions that are compared.
macro_rules! panda {
    ([$($function:ident),*] $($struct:tt)*) => {
        #[derive(Robot)]
        #[robot(urdf = "../../robots/panda_class.urdf", tip = "link8", generate($($function),*))]
        $($struct)*
    };
}

with_every_function! { panda!
    /// The Panda-class arm with one field of each kind, and two more.
    struct Panda {
        #[robot(mass_of = "link5")]
        mass: f64,
        #[robot(com_of = "link5")]
        center: [f64; 3],
        #[robot(inertia_of = "link6")]
        inertia: [f64; 6],
        #[robot(origin_of = "joint4")]
        origin: [f64; 3],
        #[robot(base_position)]
        base: [f64; 3],
        #[robot(gravity)]
        gravity: [f64; 3],
        /// The mass of a link without mass in the file.
        #[robot(mass_of = "link8")]
        payload: f64,
        #[robot(payload_on = "link7")]
        tool: Payload,
        /// A field of the user's own.
        calls: u32,
    }
}

fn described() -> Description {
    let mut errors = Errors::new();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/panda_class.urdf");
    let description = read_file(path.as_ref(), None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("it is a robot")
}

fn translation(steps: &[Step]) -> [f64; 3] {
    let Some(Step::Translate(offset)) = steps.first() else {
        panic!("a translation comes first: {steps:?}");
    };
    offset.map(|entry| entry.value)
}

/// The arm with the numbers of the file.
fn as_described() -> Panda {
    let description = described();
    let inertial = |name: &str| {
        let mut links = description.links.iter();
        let link = links.find(|link| link.name.text == name);
        let inertial = link.and_then(|link| link.inertial.as_ref());
        inertial.expect("it is in the file and has a mass")
    };
    let joint = description
        .joints
        .iter()
        .find(|joint| joint.name.text == "joint4");
    let joint = joint.expect("it is in the file");
    Panda {
        mass: inertial("link5").mass.value,
        center: translation(&inertial("link5").origin),
        inertia: inertial("link6").inertia.map(|entry| entry.value),
        origin: translation(&joint.origin),
        base: [0.0; 3],
        gravity: [0.0, 0.0, -9.81],
        payload: 0.0,
        tool: Payload::default(),
        calls: 0,
    }
}

fn agree<A, B, const N: usize>(one: &A, other: &B, seed: u64)
where
    A: EveryFunction<N, f64>,
    B: EveryFunction<N, f64>,
{
    let mut random = Random::new(seed);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let state = State::random(&mut random);
        worst.note(&evaluate(one, &state), &evaluate(other, &state));
    }
    println!("{worst}");
    worst.assert_within(LIMIT);
}

#[test]
fn the_numbers_of_the_file_give_the_constant_model() {
    let panda = as_described();
    agree(&panda, &PandaClass, 1);
    assert_eq!(panda.calls, 0);
}

#[test]
fn other_numbers_give_the_results_of_their_chain() {
    let panda = Panda {
        mass: 2.75,
        center: [0.03, -0.07, 0.11],
        inertia: [0.021, 0.003, -0.002, 0.018, 0.001, 0.015],
        origin: [0.09, 0.01, -0.02],
        base: [0.4, -1.1, 0.7],
        gravity: [1.0, -2.0, 3.0],
        payload: 1.25,
        tool: Payload {
            mass: 0.75,
            center: [0.02, -0.05, 0.08],
            inertia: [0.004, 0.0002, -0.0003, 0.005, 0.0001, 0.003],
        },
        calls: 0,
    };
    let chain: Chain<7, 1> = panda.chain();
    assert_eq!(chain.gravity, [1.0, -2.0, 3.0]);
    agree(&panda, &chain, 2);
}

#[test]
fn gravity_is_linear_in_a_payload() {
    let empty = as_described();
    let full = |payload| Panda {
        payload,
        ..as_described()
    };
    let mut random = Random::new(3);
    let mut is_large = false;
    for _ in 0..count() {
        let State { q, .. } = State::<f64, 7>::random(&mut random);
        let none: [f64; 7] = empty.gravity(&q);
        let (one, three): ([f64; 7], [f64; 7]) = (full(1.0).gravity(&q), full(3.0).gravity(&q));
        for k in 0..7 {
            let (once, thrice) = (one[k] - none[k], three[k] - none[k]);
            assert!((3.0 * once - thrice).abs() < 1e-13, "{once} {thrice}");
            is_large |= once.abs() > 1.0;
        }
    }
    assert!(
        is_large,
        "a kilogram at the flange changes torques by 1 N m"
    );
}

with_every_function! { panda!
    /// The arm with fields for the placements of its base and of two joints.
    struct Placed {
        #[robot(base_placement)]
        base: [f64; 6],
        #[robot(placement_of = "joint4")]
        elbow: [f64; 6],
        #[robot(placement_of = "joint7")]
        wrist: [f64; 6],
    }
}

#[test]
fn placements_of_the_file_give_the_constant_model_and_others_their_chain() {
    let description = described();
    let placement = |name: &str| {
        let mut joints = description.joints.iter();
        let joint = joints.find(|joint| joint.name.text == name);
        let steps = &joint.expect("it is in the file").origin;
        let mut place = [0.0; 6];
        for step in steps {
            match step {
                Step::Translate(offset) => {
                    place[..3].copy_from_slice(&offset.map(|entry| entry.value));
                }
                Step::Rotate(axis, angle) => place[3 + *axis as usize] = angle.value,
                Step::Quaternion(_) => unreachable!("the file has no quaternions"),
            }
        }
        place
    };
    let placed = Placed {
        base: [0.0; 6],
        elbow: placement("joint4"),
        wrist: placement("joint7"),
    };
    assert!(placed.elbow[3] > 1.5, "{:?}", placed.elbow);
    agree(&placed, &PandaClass, 4);

    let placed = Placed {
        base: [0.3, -0.2, 0.5, 0.4, -0.3, 2.0],
        elbow: [0.08, 0.01, -0.02, 1.5, 0.1, -0.2],
        wrist: [0.09, 0.02, 0.01, 1.6, -0.1, 0.3],
    };
    let chain: Chain<7, 1> = placed.chain();
    agree(&placed, &chain, 5);
    let upright = Placed {
        base: [0.3, -0.2, 0.5, 0.0, 0.0, 2.0],
        ..placed
    };
    let flat = Placed {
        base: [0.0; 6],
        ..placed
    };
    // Gravity torques depend on the tilt of the base, but not on its yaw or its position.
    let q = [0.4; 7];
    let [tilted, upright, flat] = [placed, upright, flat].map(|robot| robot.gravity(&q));
    for k in 0..7 {
        let (upright, flat): (f64, f64) = (upright[k], flat[k]);
        assert!((upright - flat).abs() < 1e-13, "{upright} {flat}");
    }
    assert!((tilted[1] - flat[1]).abs() > 1.0, "{tilted:?} {flat:?}");
}

/// A field of a generic struct, in several types.
#[derive(Robot)]
#[robot(urdf = "../../robots/two_link.urdf", generate(gravity))]
struct Loaded<T: Copy>
where
    f64: From<T>,
{
    #[robot(mass_of = "fore")]
    mass: T,
}

#[test]
fn a_field_may_have_any_type_that_converts_to_f64() {
    let q = [0.25_f32, -0.5];
    let single: [f32; 2] = Loaded { mass: 2.0_f32 }.gravity(&q);
    let whole: [f32; 2] = Loaded { mass: 2_i32 }.gravity(&q);
    assert_eq!(single, whole);
    let double: [f64; 2] = Loaded { mass: 2.0 }.gravity(&q.map(f64::from));
    for (x, y) in single.into_iter().zip(double) {
        assert!((f64::from(x) - y).abs() < 4e-6, "{x} {y}");
    }
}

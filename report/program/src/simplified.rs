//! Simpler models of a robot.
//!
//! In: a description. Out: the same with some data left out or changed. The report shows the errors of this.

use homogen_codegen::Function;
use homogen_codegen::description::{Description, Number, Step};

use crate::scene::{Scalar, Variant};

/// The joints of the arm that move it within a vertical plane, when the others rest at zero.
pub const PLANE: [usize; 3] = [1, 3, 5];

const F64: &[Scalar] = &[Scalar::F64];

/// Models for an arm in any motion.
pub fn anywhere() -> Vec<Variant> {
    let model = |name, title, change| Variant {
        name,
        title,
        change,
        scalars: F64,
        ..Variant::DEFAULT
    };
    vec![
        Variant {
            title: "full model",
            ..Variant::DEFAULT
        },
        model("f32_parameters", "parameters in f32", |robot, _| {
            each_number(robot, |number| f64::from(single(number)));
        }),
        model("four_digits", "1.5708 taken literally", |robot, request| {
            four_digits(robot);
            request.exact = true;
        }),
        model("without_1_percent", "terms < 1 % dropped", |robot, _| {
            drop_small(robot, 0.01);
        }),
        model("without_3_percent", "terms < 3 % dropped", |robot, _| {
            drop_small(robot, 0.03);
        }),
        model("without_10_percent", "terms < 10 % dropped", |robot, _| {
            drop_small(robot, 0.1);
        }),
        model("symmetric", "symmetric links", |robot, _| symmetric(robot)),
        model("points", "point masses", |robot, _| points(robot)),
        gravity(),
    ]
}

/// Models for an arm in slow motion.
pub fn slow() -> Vec<Variant> {
    vec![full(), gravity()]
}

/// Models for an arm with three moving joints.
pub fn in_a_plane() -> Vec<Variant> {
    let locked = Variant {
        name: "locked",
        title: "four joints locked",
        change: |robot, request| {
            let joints: Vec<_> = robot.joints.iter().take(7).collect();
            let others = joints
                .iter()
                .enumerate()
                .filter(|(k, _)| !PLANE.contains(k));
            request
                .lock
                .extend(others.map(|(_, joint)| (joint.name.clone(), None)));
        },
        joints: &PLANE,
        ..full()
    };
    vec![full(), locked]
}

fn full() -> Variant {
    Variant {
        title: "full model",
        scalars: F64,
        ..Variant::DEFAULT
    }
}

fn gravity() -> Variant {
    Variant {
        name: "gravity",
        title: "gravity only",
        scalars: F64,
        instead: Some(Function::Gravity),
        ..Variant::DEFAULT
    }
}

#[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn single(number: f64) -> f32 {
    number as f32
}

/// Changes every length, mass and inertia, but not angles.
fn each_number(robot: &mut Description, change: impl Fn(f64) -> f64) {
    let apply = |number: &mut Number| number.value = change(number.value);
    let place = |steps: &mut Vec<Step>| {
        for step in steps {
            if let Step::Translate(numbers) = step {
                numbers.iter_mut().for_each(apply);
            }
        }
    };
    for joint in &mut robot.joints {
        place(&mut joint.origin);
    }
    for inertial in robot
        .links
        .iter_mut()
        .filter_map(|link| link.inertial.as_mut())
    {
        place(&mut inertial.origin);
        apply(&mut inertial.mass);
        inertial.inertia.iter_mut().for_each(apply);
    }
}

/// Rounds angles to four decimals, as in some files.
fn four_digits(robot: &mut Description) {
    let origins = robot.joints.iter_mut().map(|joint| &mut joint.origin);
    for step in origins.flatten() {
        if let Step::Rotate(_, angle) = step {
            angle.value = (angle.value * 1e4).round() / 1e4;
        }
    }
}

/// Drops centres of mass and products of inertia that are small relative to the largest in the same link.
fn drop_small(robot: &mut Description, fraction: f64) {
    let largest = |numbers: &[Number]| numbers.iter().map(|x| x.value.abs()).fold(0.0, f64::max);
    let small = |numbers: &mut [Number], largest: f64| {
        for number in numbers {
            if number.value.abs() < fraction * largest {
                number.value = 0.0;
            }
        }
    };
    for inertial in robot
        .links
        .iter_mut()
        .filter_map(|link| link.inertial.as_mut())
    {
        for step in &mut inertial.origin {
            if let Step::Translate(numbers) = step {
                let most = largest(numbers);
                small(numbers, most);
            }
        }
        let most = largest(&inertial.inertia);
        small(&mut inertial.inertia, most);
    }
}

/// Makes each link symmetric about the axis of its frame with the largest coordinate of the centre of mass.
fn symmetric(robot: &mut Description) {
    for inertial in robot
        .links
        .iter_mut()
        .filter_map(|link| link.inertial.as_mut())
    {
        let mut axis = 2;
        for step in &mut inertial.origin {
            if let Step::Translate(numbers) = step {
                let size = |k: &usize| numbers[*k].value.abs();
                axis = (0..3)
                    .max_by(|a, b| size(a).total_cmp(&size(b)))
                    .unwrap_or(2);
                for k in (0..3).filter(|k| *k != axis) {
                    numbers[k].value = 0.0;
                }
            }
        }
        // xx, xy, xz, yy, yz, zz
        let diagonal = [0, 3, 5];
        for product in [1, 2, 4] {
            inertial.inertia[product].value = 0.0;
        }
        let [a, b] = [(axis + 1) % 3, (axis + 2) % 3].map(|k| diagonal[k]);
        let mean = 0.5 * (inertial.inertia[a].value + inertial.inertia[b].value);
        inertial.inertia[a].value = mean;
        inertial.inertia[b].value = mean;
    }
}

/// Replaces links by point masses.
fn points(robot: &mut Description) {
    for inertial in robot
        .links
        .iter_mut()
        .filter_map(|link| link.inertial.as_mut())
    {
        for number in &mut inertial.inertia {
            number.value = 0.0;
        }
    }
}

//! A robot with closed loops, mounted in frame 0 and written as text.
//!
//! In: a [`Mechanism`], a [`Mounting`]. Out: the text for `chain!` with the given number of digits, and the
//! description that the reader makes of it. Every link has its own frame, rotated against the others.

use std::fmt::Write;
use std::path::Path;

use homogen_codegen::description::{Description, inline};
use homogen_codegen::error::Errors;
use homogen_codegen::request::Request;

use super::draw::{Closure, Mechanism, Motion};
use super::space::{
    IDENTITY, Rotation, Vector, any_rotation, back, length, minus, plus, product, roll_pitch_yaw,
    turned,
};
use crate::states::Random;

/// The pose of a robot in frame 0, and the form of its text.
#[derive(Clone, Debug)]
pub struct Mounting {
    /// The robot's rotation.
    pub rotation: Rotation,
    /// The robot's position \[m\].
    pub place: Vector,
    /// The rotation of each link's frame relative to the robot.
    pub frames: Vec<Rotation>,
    /// Decimal digits of numbers.
    pub digits: usize,
}

impl Mounting {
    /// As drawn, with all digits.
    #[must_use]
    pub fn straight(mechanism: &Mechanism) -> Self {
        Self {
            rotation: IDENTITY,
            place: [0.0; 3],
            frames: vec![IDENTITY; mechanism.joints.len()],
            digits: 17,
        }
    }

    /// A random pose and random frames.
    pub fn any(mechanism: &Mechanism, digits: usize, random: &mut Random) -> Self {
        // A rotation that a few decimals write exactly.
        const SHORT: Rotation = [[0.48, -0.8, 0.36], [0.64, 0.6, 0.48], [-0.6, 0.0, 0.8]];
        let rotation = match random.below(4) {
            0 => SHORT,
            _ => any_rotation(random),
        };
        let are_turned = !random.chance(3);
        let frames = mechanism.joints.iter().map(|joint| match joint.motion {
            // Coordinates of these joints refer to the link's frame.
            Motion::Translation | Motion::Spherical => IDENTITY,
            _ if are_turned => any_rotation(random),
            _ => IDENTITY,
        });
        Self {
            rotation,
            frames: frames.collect(),
            place: std::array::from_fn(|_| random.unit()),
            digits,
        }
    }

    /// Numbers with the given digits, separated by commas.
    fn numbers(&self, numbers: &[f64]) -> String {
        let words = numbers.iter().map(|&number| {
            let number = if number.abs() < 1e-15 { 0.0 } else { number };
            let number: f64 = match self.digits {
                17.. => number,
                digits => format!("{number:.*e}", digits - 1)
                    .parse()
                    .expect("a number"),
            };
            format!("{number:?}")
        });
        words.collect::<Vec<_>>().join(", ")
    }
}

/// The text for `chain!`.
#[must_use]
pub fn text(mechanism: &Mechanism, mounting: &Mounting) -> String {
    let list = |numbers: &[f64]| mounting.numbers(numbers);
    let Mounting {
        rotation,
        place,
        frames,
        ..
    } = mounting;
    // A point in frame 0, and the rotation of a link's frame there.
    let mounted = |point: Vector| plus(turned(rotation, point), *place);
    let axes = |link: Option<usize>| link.map_or(IDENTITY, |link| product(rotation, &frames[link]));
    let origin =
        |link: Option<usize>| link.map_or([0.0; 3], |link| mounted(mechanism.joints[link].point));
    let within = |link: Option<usize>, direction: Vector| {
        turned(&back(&axes(link)), turned(rotation, direction))
    };
    let at = |link: Option<usize>, point: Vector| {
        turned(&back(&axes(link)), minus(mounted(point), origin(link)))
    };
    let mut text = format!(
        "struct Mechanism {{ gravity: [{}]",
        list(&turned(rotation, mechanism.gravity))
    );
    let actuated = mechanism.joints.iter().filter(|joint| joint.is_actuated);
    let actuated: Vec<String> = actuated
        .map(|joint| format!("{}_joint", joint.name))
        .collect();
    let _ = write!(
        text,
        ", actuated({}) }}\nlink ground;\n",
        actuated.join(", ")
    );
    for (k, joint) in mechanism.joints.iter().enumerate() {
        let along = |axis: Vector| format!("[{}]", list(&within(Some(k), axis)));
        let motion = match &joint.motion {
            Motion::Revolute(axis) => format!("continuous({})", along(*axis)),
            Motion::Prismatic(axis) => format!("prismatic({})", along(*axis)),
            Motion::Universal(first, second) => {
                format!("universal({}, {})", along(*first), along(*second))
            }
            Motion::Translation => "translation".to_owned(),
            Motion::Spherical => "spherical".to_owned(),
        };
        let parent = joint
            .parent
            .map_or("ground", |parent| &mechanism.joints[parent].name);
        let relative = product(&back(&axes(joint.parent)), &axes(Some(k)));
        let inertia = Mechanism::inertia(joint);
        // R I Rᵗ.
        let frame = back(&frames[k]);
        let tensor = product(&product(&frame, &inertia), &back(&frame));
        let six = [
            tensor[0][0],
            tensor[0][1],
            tensor[0][2],
            tensor[1][1],
            tensor[1][2],
            tensor[2][2],
        ];
        let _ = writeln!(
            text,
            "joint {0}_joint: {motion} {{ from: {parent}, at: xyz({1}) rpy({2}) }}\n\
             link {0} {{ mass: {3}, com: [{4}], inertia: [{5}] }}",
            joint.name,
            list(&at(joint.parent, joint.point)),
            list(&roll_pitch_yaw(&relative)),
            list(&[joint.mass]),
            list(&at(Some(k), joint.center)),
            list(&six),
        );
    }
    for (k, closed) in mechanism.loops.iter().enumerate() {
        let [from, to] = closed.links.map(Some);
        let [one, other] = Mechanism::ends(closed);
        let closure = match closed.closure {
            Closure::Revolute(axis) => format!("revolute([{}])", list(&within(from, axis))),
            Closure::Spherical => "spherical".to_owned(),
            Closure::Rod(_) => format!("rod({})", list(&[length(minus(other, one))])),
        };
        let relative = product(&back(&axes(to)), &axes(from));
        let [from_name, to_name] = closed.links.map(|link| &mechanism.joints[link].name);
        let _ = writeln!(
            text,
            "loop loop{k}: {closure} {{ from: {from_name}, to: {to_name}, at: xyz({}), to_at: xyz({}) rpy({}) }}",
            list(&at(from, one)),
            list(&at(to, other)),
            list(&roll_pitch_yaw(&relative)),
        );
    }
    text
}

/// Reads a text of `chain!`.
///
/// # Errors
/// Errors of the reader.
///
/// # Panics
/// If the text cannot be split into tokens.
pub fn read(text: &str) -> Result<(Description, Request), Errors> {
    let mut errors = Errors::new();
    let tokens = text.parse().expect("the text is tokens");
    let item = inline::read(tokens, Path::new("nowhere"), &mut errors);
    let found = item.and_then(|item| {
        item.description
            .map(|description| (description, item.request))
    });
    match found {
        Some(found) => errors.into_result(found),
        None => Err(errors),
    }
}

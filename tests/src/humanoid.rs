//! Humanoids with many joints, for tests of what is hard about them.
//!
//! In: the number of joints. Out: a description: a fixed pelvis, a waist of three joints, two legs of six, two arms of
//! seven, a head of two, and fingers of two joints each on both hands for the rest. Sizes, inertias and speeds are
//! typical of real robots; no number is round, and three quarters of the axes are at right angles to the one before.

use homogen_codegen::description::{
    Axis, Description, Inertial, Joint, Limits, Link, Name, Number, Source, Step, Unmodelled,
};
use homogen_codegen::error::Place;
use homogen_codegen::joint::JointKind;
use homogen_codegen::joint::actuator::Actuator;

use crate::states::Random;

/// A limb: the joint that carries it, its number of joints, and length, mass and speed of each of them.
struct Limb {
    on: Option<usize>,
    joints: usize,
    length: f64,
    mass: f64,
    speed: f64,
}

/// A humanoid with so many joints, at least 29.
#[must_use]
pub fn humanoid(joints: usize) -> Description {
    let mut random = Random::new(29);
    let limb = |on, joints, length, mass, speed| Limb {
        on,
        joints,
        length,
        mass,
        speed,
    };
    let waist = Some(2);
    let mut limbs = vec![
        limb(None, 3, 0.11, 3.0, 5.0),
        limb(None, 6, 0.21, 2.1, 12.0),
        limb(None, 6, 0.21, 2.1, 12.0),
        limb(waist, 7, 0.14, 0.9, 15.0),
        limb(waist, 7, 0.14, 0.9, 15.0),
    ];
    let hands = [21, 28];
    let mut left = joints - 29;
    if left >= 2 {
        limbs.push(limb(waist, 2, 0.07, 0.6, 8.0));
        left -= 2;
    }
    while left > 0 {
        let joints = left.min(2);
        let hand = hands[(left / 2) % 2];
        limbs.push(limb(Some(hand), joints, 0.035, 0.03, 6.0));
        left -= joints;
    }

    let mut description = Description {
        name: "humanoid".into(),
        source: Source::default(),
        links: vec![Link {
            name: "pelvis".into(),
            inertial: None,
        }],
        joints: Vec::new(),
        loops: Vec::new(),
        configurations: Vec::new(),
        collisions: Vec::new(),
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    };
    for limb in limbs {
        let mut on = limb.on;
        for _ in 0..limb.joints {
            let k = description.joints.len();
            let parent = on.map_or("pelvis".into(), |on| name("link", on));
            description
                .joints
                .push(joint(k, parent, &limb, &mut random));
            description.links.push(link(k, &limb, &mut random));
            on = Some(k);
        }
    }
    description
}

fn joint(k: usize, parent: Name, limb: &Limb, random: &mut Random) -> Joint {
    let along = [0.2, 0.3, 1.0].map(|share| number(limb.length * share * random.unit()));
    let quarter = *random.choose(&[-1.0, 1.0]) * std::f64::consts::FRAC_PI_2;
    let angle = if random.chance(4) {
        1.5 * random.unit()
    } else {
        quarter
    };
    let about = *random.choose(&[Axis::X, Axis::Y]);
    Joint {
        name: name("joint", k),
        kind: JointKind::Revolute,
        parent,
        child: name("link", k),
        origin: vec![Step::Translate(along), Step::Rotate(about, number(angle))],
        axis: [0.0, 0.0, 1.0].map(number),
        second_axis: [Number::default(); 3],
        mimic: None,
        limits: Some(Limits {
            lower: -1.0 + 0.5 * random.unit(),
            upper: 1.5 + 0.5 * random.unit(),
            velocity: limb.speed,
            effort: f64::INFINITY,
        }),
        actuator: Actuator::default(),
        place: Place::Unknown,
    }
}

fn link(k: usize, limb: &Limb, random: &mut Random) -> Link {
    let mass = limb.mass * (1.0 + 0.3 * random.unit());
    let size = limb.length * limb.length * mass / 8.0;
    let [xx, yy, zz] = [0; 3].map(|_| size * (1.0 + 0.3 * random.unit()));
    let [xy, xz, yz] = [0; 3].map(|_| 0.1 * size * random.unit());
    let center = [0; 3].map(|_| number(0.4 * limb.length * random.unit()));
    Link {
        name: name("link", k),
        inertial: Some(Inertial {
            origin: vec![Step::Translate(center)],
            mass: number(mass),
            inertia: [xx, xy, xz, yy, yz, zz].map(number),
            place: Place::Unknown,
        }),
    }
}

fn name(what: &str, k: usize) -> Name {
    format!("{what}{k}").as_str().into()
}

fn number(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}

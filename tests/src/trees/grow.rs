//! Random robots with the defects of those that vendors ship.
//!
//! In: a source of random numbers. Out: a [`Robot`]. [`features`](super::features) counts what follows, and a test
//! requires some of each:
//!
//! - residues of 1e-18 to 1e-6 in place of zeros: in offsets, roll, pitch and yaw, axes, centres of mass, the axes and
//!   the products of inertias;
//! - offsets and rotations that a fixed joint inverts but for rounding;
//! - in inline descriptions, lengths and angles that are products and quotients, by `pi` or not;
//! - right angles written with 2 to 17 digits, with `pi`, as sums of two or three parts, and with so many full turns
//!   that the angle is huge; angles near right ones;
//! - axes of length 1 but for their digits, and of other lengths;
//! - axes that are coaxial, parallel, antiparallel, intersecting or skew;
//! - links without inertial, massless ones in the middle, point masses, thin rods;
//! - every type of joint, and fixed ones everywhere; up to 20 joints; floating bases;
//! - mimic joints of joints inboard, outboard and in other branches, of mimic joints, of locked and of dropped joints;
//!   with factors of either sign, and 0;
//! - units in which numbers are a thousand times as large or as small;
//! - all combinations of a request: another base, end effectors, further frames, joints locked at zero and elsewhere,
//!   dropped links, the path alone, `exact`, any gravity and none, struct fields with values other than those
//!   described;
//! - armature, damping and friction at joints, mimic joints among them; external wrenches, in frames of links and in
//!   frame 0;
//! - numbers read as URDF, read as tokens, and given without text.
//!
//! One robot in three has no residues.

mod bodies;
mod numbers;

use crate::states::Random;

use self::numbers::Numbers;
use super::robot::{Body, Field, FrontEnd, Kind, NUMBERS, Options, Robot};
use super::written::Written;

/// The most joints of a robot, moving or not.
pub const MOST: usize = 20;

/// A random robot with at least one degree of freedom.
pub fn grow(random: &mut Random) -> Robot {
    loop {
        let robot = attempt(random);
        if robot.options.floating || robot.moving().next().is_some() {
            return robot;
        }
    }
}

fn attempt(random: &mut Random) -> Robot {
    let count = match random.below(16) {
        0..=10 => 1 + random.below(6),
        11..=14 => 7 + random.below(4),
        _ => 11 + random.below(MOST - 10),
    };
    let unit = |random: &mut Random| match random.below(8) {
        0 => 1e3,
        1 => 1e-3,
        _ => 1.0,
    };
    let mut numbers = Numbers {
        residues: !random.chance(3),
        front_end: *random.choose(&[
            FrontEnd::Urdf,
            FrontEnd::Urdf,
            FrontEnd::Inline,
            FrontEnd::Computed,
        ]),
        length: unit(random),
        mass: unit(random),
        random,
    };
    let mut bodies: Vec<Body> = Vec::new();
    for id in 1..=count {
        // Mostly a chain, sometimes a branch from anywhere.
        let parent = match numbers.random.below(4) {
            0 => numbers.random.below(id),
            _ => id - 1,
        };
        let body = bodies::body(id, parent, &bodies, &mut numbers);
        bodies.push(body);
    }
    if numbers.random.chance(6) {
        let row = row(&bodies, 1 + numbers.random.below(count));
        bodies::share_a_right_angle(&mut bodies, &row, &mut numbers);
    }
    add_mimics(&mut bodies, &mut numbers);
    let root = bodies::inertial(&mut numbers);
    let mut robot = Robot {
        root,
        bodies,
        options: Options::default(),
        front_end: numbers.front_end,
    };
    add_request(&mut robot, &mut numbers);
    shuffle(&mut robot.bodies, numbers.random);
    if robot.options.floating || robot.moving().next().is_some() {
        add_loads(&mut robot, &mut numbers);
    }
    robot
}

/// A robot without residues, of up to `most` joints, with 1 to 54 velocities besides those of a floating base, in a
/// unit of length of 1e-6 to 1e3 m, which is returned with it. Some joints have actuators, some are mimic joints.
pub fn grow_long(random: &mut Random, most: usize) -> (Robot, f64) {
    loop {
        let (robot, length) = attempt_long(random, most);
        let joints = robot.moving().filter_map(|id| robot.body(id));
        let velocities: usize = joints.map(|body| body.kind.entries()[1].len()).sum();
        if (1..=54).contains(&velocities) {
            return (robot, length);
        }
    }
}

/// The most joints of a robot with mimic joints.
const MIMICKED: usize = 16;

fn attempt_long(random: &mut Random, most: usize) -> (Robot, f64) {
    let mimics = random.chance(3);
    let most = if mimics { most.min(MIMICKED) } else { most };
    let count = (1 + random.below(most)).min(1 + random.below(most));
    let scales = [
        1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 1.0, 10.0, 100.0, 1e3,
    ];
    let length = *random.choose(&scales);
    let straight = random.chance(3);
    let mut numbers = Numbers {
        residues: false,
        front_end: *random.choose(&[FrontEnd::Urdf, FrontEnd::Inline]),
        length,
        mass: length * length * length * 1e3,
        random,
    };
    let mut bodies: Vec<Body> = Vec::new();
    for id in 1..=count {
        let parent = match numbers.random.below(6) {
            0 if !straight => numbers.random.below(id),
            _ => id - 1,
        };
        let body = bodies::body(id, parent, &bodies, &mut numbers);
        bodies.push(body);
    }
    if mimics {
        mimic_one(&mut bodies, &mut numbers);
    }
    let root = bodies::inertial(&mut numbers);
    let options = Options {
        floating: numbers.random.chance(5),
        exact: numbers.random.chance(4),
        gravity: match numbers.random.below(6) {
            0 => Some([(); 3].map(|()| Written::zero())),
            1 => Some(numbers.vector(10.0)),
            _ => None,
        },
        ..Options::default()
    };
    let mut robot = Robot {
        root,
        bodies,
        options,
        front_end: numbers.front_end,
    };
    if robot.options.floating || robot.moving().next().is_some() {
        add_loads(&mut robot, &mut numbers);
        robot.options.external = (Vec::new(), false);
    }
    (robot, length)
}

/// Makes up to three joints mimic one.
fn mimic_one(bodies: &mut [Body], numbers: &mut Numbers) {
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order.retain(|&at| bodies[at].kind.has_one_coordinate());
    shuffle(&mut order, numbers.random);
    let count = 1 + numbers.random.below(3);
    if let [mimicked, mimics @ ..] = &*order {
        let mimicked = bodies[*mimicked].id;
        for &mimic in mimics.iter().take(count) {
            bodies[mimic].mimic = Some(bodies::mimic(mimicked, numbers));
        }
    }
}

/// Makes some joints mimic others, without circles.
fn add_mimics(bodies: &mut [Body], numbers: &mut Numbers) {
    if numbers.random.chance(2) {
        return;
    }
    let one = |body: &Body| body.kind.has_one_coordinate();
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    shuffle(&mut order, numbers.random);
    for mimic in 1..order.len() {
        if !one(&bodies[order[mimic]]) || numbers.random.chance(3) {
            continue;
        }
        // Rarely a fixed one.
        let may_be_fixed = numbers.random.chance(8);
        let may_be_mimicked = |body: &&Body| one(body) || may_be_fixed && body.kind == Kind::Fixed;
        let before = order[..mimic].iter().map(|&at| &bodies[at]);
        let mimicked: Vec<usize> = before.filter(may_be_mimicked).map(|body| body.id).collect();
        if !mimicked.is_empty() {
            let mimicked = *numbers.random.choose(&mimicked);
            bodies[order[mimic]].mimic = Some(bodies::mimic(mimicked, numbers));
        }
    }
}

/// A body, its parent and its grandparent.
fn row(bodies: &[Body], last: usize) -> Vec<usize> {
    let before = |id: &usize| {
        let body = bodies.iter().find(|body| body.id == *id);
        body.map(|body| body.parent)
    };
    std::iter::successors(Some(last), before).take(3).collect()
}

/// Adds a random request that the robot can fulfil.
fn add_request(robot: &mut Robot, numbers: &mut Numbers) {
    let count = robot.bodies.len();
    let random = &mut *numbers.random;
    if random.chance(4) {
        robot.options.base = random.below(count.min(3));
    }
    robot.options.floating = random.chance(6);
    if random.chance(4) {
        let link = 1 + random.below(count);
        if link != robot.options.base {
            robot.options.drop.push(link);
        }
    }
    let modelled: Vec<usize> = (robot.bodies.iter().map(|body| body.id))
        .filter(|&id| robot.models(id))
        .collect();
    let link = |random: &mut Random| match modelled[..] {
        [] => robot.options.base,
        _ => *random.choose(&modelled),
    };
    if !random.chance(4) {
        robot.options.tip = Some(link(random));
        robot.options.path_only = random.chance(4);
    }
    if random.chance(3) {
        robot.options.frames.push(link(random));
    }
    robot.options.exact = random.chance(4);
    match random.below(6) {
        0 => robot.options.gravity = Some([(); 3].map(|()| Written::zero())),
        1 | 2 => robot.options.gravity = Some(numbers.vector(10.0)),
        _ => {}
    }
    for body in robot.bodies.iter().filter(|body| body.kind != Kind::Fixed) {
        if !numbers.random.chance(8) {
            continue;
        }
        let at = match numbers.random.below(4) {
            0 => None,
            1 => Some(numbers.right_angle()),
            _ => {
                let value = 4.0 * numbers.random.unit();
                Some(numbers.number(value))
            }
        };
        // The position of a locked joint is one plain number; joints with several coordinates are locked at zero.
        let is_one = |at: &Written| at.to_string().parse::<f64>().is_ok();
        let at = at.filter(|at| is_one(at) && body.kind.has_one_coordinate());
        robot.options.lock.push((body.id, at));
    }
    add_fields(robot, &modelled, numbers);
}

/// Adds random struct fields.
fn add_fields(robot: &mut Robot, modelled: &[usize], numbers: &mut Numbers) {
    let (length, mass) = (numbers.length, numbers.mass);
    let anywhere = |random: &mut Random| [(); 3].map(|()| length * random.unit());
    let padded = |numbers: &[f64]| -> [f64; NUMBERS] {
        std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
    };
    // Physical: no moment is larger than the sum of the other two, and products are small.
    let tensor = |random: &mut Random, size: f64| -> [f64; 6] {
        std::array::from_fn(|k| match k {
            0 | 3 | 5 => size * (1.0 + 0.25 * random.unit()),
            _ => 0.1 * size * random.unit(),
        })
    };
    for &id in modelled {
        let random = &mut *numbers.random;
        let weighs = |body: &Body| {
            let inertial = body.inertial.as_ref();
            inertial.is_some_and(|inertial| !inertial.mass.is_zero())
        };
        match random.below(16) {
            0 if robot.moves(id) => {
                let value = mass * (1.0 + random.unit());
                robot
                    .options
                    .fields
                    .push((Field::Mass(id), padded(&[value])));
            }
            1 if robot.moves(id) && robot.body(id).is_some_and(weighs) => {
                let value = anywhere(random);
                robot
                    .options
                    .fields
                    .push((Field::Center(id), padded(&value)));
            }
            2 => {
                let value = anywhere(random);
                robot
                    .options
                    .fields
                    .push((Field::Origin(id), padded(&value)));
            }
            3 if robot.moves(id) => {
                let value = mass * (1.0 + random.unit());
                let center = anywhere(random);
                let about = tensor(random, 0.1 * value * length * length);
                let load = [&[value][..], &center, &about].concat();
                robot
                    .options
                    .fields
                    .push((Field::Payload(id), padded(&load)));
            }
            4 if robot.moves(id) && robot.body(id).is_some_and(weighs) => {
                let value = tensor(random, 0.1 * mass * length * length);
                robot
                    .options
                    .fields
                    .push((Field::Inertia(id), padded(&value)));
            }
            5 => {
                let angles = [(); 3].map(|()| 3.0 * random.unit());
                let value = [anywhere(random), angles].concat();
                robot
                    .options
                    .fields
                    .push((Field::Placement(id), padded(&value)));
            }
            _ => {}
        }
    }
    if robot.options.gravity.is_none() && numbers.random.chance(4) {
        let value = [(); 3].map(|()| 9.0 * numbers.random.unit());
        robot.options.fields.push((Field::Gravity, padded(&value)));
    }
}

/// Adds random armature, damping and friction, and links with external wrenches.
fn add_loads(robot: &mut Robot, numbers: &mut Numbers) {
    let inertia = 0.1 * numbers.mass * numbers.length * numbers.length;
    let random = &mut *numbers.random;
    if random.chance(3) {
        for body in robot.bodies.iter().filter(|body| body.kind != Kind::Fixed) {
            if random.chance(2) {
                let actuator = [0.5, 2.0, 1.0].map(|size| size * inertia * (1.5 + random.unit()));
                robot.options.actuators.push((body.id, actuator));
            }
        }
    }
    if random.chance(4) {
        let mut moving: Vec<usize> = robot.bodies.iter().map(|body| body.id).collect();
        moving.retain(|&id| id == robot.options.base || robot.models(id));
        // The root has no joint.
        moving.extend((robot.options.base == 0).then_some(0));
        moving.retain(|&id| robot.moves(id));
        shuffle(&mut moving, random);
        moving.truncate(2);
        robot.options.external = (moving, random.chance(2));
    }
}

fn shuffle<X>(items: &mut [X], random: &mut Random) {
    for k in (1..items.len()).rev() {
        items.swap(k, random.below(k + 1));
    }
}

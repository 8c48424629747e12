//! Robots at random, as nasty as those that vendors ship.
//!
//! In: a source of random numbers. Out: a [`Robot`]. Whoever changes this keeps what follows in it;
//! [`features`](super::features) counts each, and a test wants some of all of them:
//! * residues of 1e-18 to 1e-6 where a zero was meant: in offsets, in roll, pitch and yaw, in axes,
//!   in centres of mass, in the axes of inertias and in their products;
//! * offsets and rotations that a fixed joint takes back but for rounding;
//! * in tokens, lengths and angles that are products and quotients, by `pi` or not;
//! * right angles written with 2 to 17 digits, with `pi`, as sums of two or three parts, and so many
//!   turns of them that the angle is huge; angles beside right ones;
//! * axes of length 1 but for their digits, and of any other length;
//! * axes that are coaxial, parallel, antiparallel, intersecting or nothing of all that;
//! * links without inertial, massless ones in the middle, points, thin rods;
//! * every kind of joint, and fixed ones everywhere; up to 20 joints; bases that are free;
//! * joints that follow others, in front of them, behind them and in other branches, through others that
//!   follow, held and left out ones; by factors of every sign, and by none;
//! * units in which numbers are a thousand times as large or as small;
//! * whatever a request can combine: another base, tips, further frames, joints held at zero and
//!   elsewhere, links dropped, the path alone, `exact`, any gravity and none, struct fields whose
//!   values are not those described;
//! * drives at joints, followers among them, and actions on links, in their frames and in frame 0;
//! * numbers read as URDF, as tokens, and numbers that were never written, with no digits to read.
//!
//! One robot in three is plain: the same without residues.

mod bodies;
mod numbers;

use crate::states::Random;

use self::numbers::Numbers;
use super::robot::{Asked, Body, Door, Field, Kind, NUMBERS, Robot};
use super::written::Written;

/// The most joints of a robot, moving or not.
pub const MOST: usize = 20;

/// A robot in which something moves.
pub fn grow(random: &mut Random) -> Robot {
    loop {
        let robot = attempt(random);
        if robot.asked.floating || robot.moving().next().is_some() {
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
        door: *random.choose(&[Door::Urdf, Door::Urdf, Door::Inline, Door::Computed]),
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
    lead(&mut bodies, &mut numbers);
    let root = bodies::inertial(&mut numbers);
    let mut robot = Robot {
        root,
        bodies,
        asked: Asked::default(),
        door: numbers.door,
    };
    ask(&mut robot, &mut numbers);
    shuffle(&mut robot.bodies, numbers.random);
    if robot.asked.floating || robot.moving().next().is_some() {
        load(&mut robot, &mut numbers);
    }
    robot
}

/// A plain robot of up to so many joints and of up to 54 velocities beside those of a floating base, in a unit of length of 1e-6 to 1e3 m, which is returned with it: whatever its joints
/// are, some with actuators, some of them mimic joints, on a fixed or a floating base.
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

/// The most joints of a robot in which some mimic others.
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
        door: *random.choose(&[Door::Urdf, Door::Inline]),
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
        follow(&mut bodies, &mut numbers);
    }
    let root = bodies::inertial(&mut numbers);
    let asked = Asked {
        floating: numbers.random.chance(5),
        exact: numbers.random.chance(4),
        gravity: match numbers.random.below(6) {
            0 => Some([(); 3].map(|()| Written::zero())),
            1 => Some(numbers.vector(10.0)),
            _ => None,
        },
        ..Asked::default()
    };
    let mut robot = Robot {
        root,
        bodies,
        asked,
        door: numbers.door,
    };
    if robot.asked.floating || robot.moving().next().is_some() {
        load(&mut robot, &mut numbers);
        robot.asked.external = (Vec::new(), false);
    }
    (robot, length)
}

/// Makes up to three joints mimic one.
fn follow(bodies: &mut [Body], numbers: &mut Numbers) {
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order.retain(|&at| bodies[at].kind.has_one_coordinate());
    shuffle(&mut order, numbers.random);
    let count = 1 + numbers.random.below(3);
    if let [leader, followers @ ..] = &*order {
        let leader = bodies[*leader].id;
        for &follower in followers.iter().take(count) {
            bodies[follower].mimic = Some(bodies::mimic(leader, numbers));
        }
    }
}

/// Makes some joints follow others, in no circle.
fn lead(bodies: &mut [Body], numbers: &mut Numbers) {
    if numbers.random.chance(2) {
        return;
    }
    let one = |body: &Body| body.kind.has_one_coordinate();
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    shuffle(&mut order, numbers.random);
    for follower in 1..order.len() {
        if !one(&bodies[order[follower]]) || numbers.random.chance(3) {
            continue;
        }
        // Rarely one that is fixed.
        let may_be_fixed = numbers.random.chance(8);
        let leads = |body: &&Body| one(body) || may_be_fixed && body.kind == Kind::Fixed;
        let before = order[..follower].iter().map(|&at| &bodies[at]);
        let leaders: Vec<usize> = before.filter(leads).map(|body| body.id).collect();
        if !leaders.is_empty() {
            let leader = *numbers.random.choose(&leaders);
            bodies[order[follower]].mimic = Some(bodies::mimic(leader, numbers));
        }
    }
}

/// A body and the two before it.
fn row(bodies: &[Body], last: usize) -> Vec<usize> {
    let before = |id: &usize| {
        let body = bodies.iter().find(|body| body.id == *id);
        body.map(|body| body.parent)
    };
    std::iter::successors(Some(last), before).take(3).collect()
}

/// A request that the robot can fulfil.
fn ask(robot: &mut Robot, numbers: &mut Numbers) {
    let count = robot.bodies.len();
    let random = &mut *numbers.random;
    if random.chance(4) {
        robot.asked.base = random.below(count.min(3));
    }
    robot.asked.floating = random.chance(6);
    if random.chance(4) {
        let link = 1 + random.below(count);
        if link != robot.asked.base {
            robot.asked.drop.push(link);
        }
    }
    let modelled: Vec<usize> = (robot.bodies.iter().map(|body| body.id))
        .filter(|&id| robot.models(id))
        .collect();
    let link = |random: &mut Random| match modelled[..] {
        [] => robot.asked.base,
        _ => *random.choose(&modelled),
    };
    if !random.chance(4) {
        robot.asked.tip = Some(link(random));
        robot.asked.path_only = random.chance(4);
    }
    if random.chance(3) {
        robot.asked.frames.push(link(random));
    }
    robot.asked.exact = random.chance(4);
    match random.below(6) {
        0 => robot.asked.gravity = Some([(); 3].map(|()| Written::zero())),
        1 | 2 => robot.asked.gravity = Some(numbers.vector(10.0)),
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
        // A coordinate of a request is a number, be it near a right angle or not, and several are zero.
        let is_one = |at: &Written| at.to_string().parse::<f64>().is_ok();
        let at = at.filter(|at| is_one(at) && body.kind.has_one_coordinate());
        robot.asked.lock.push((body.id, at));
    }
    give_fields(robot, &modelled, numbers);
}

/// Struct fields for what a joint feels.
fn give_fields(robot: &mut Robot, modelled: &[usize], numbers: &mut Numbers) {
    let (length, mass) = (numbers.length, numbers.mass);
    let anywhere = |random: &mut Random| [(); 3].map(|()| length * random.unit());
    let padded = |numbers: &[f64]| -> [f64; NUMBERS] {
        std::array::from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
    };
    // Such as a body has: of two moments none is less than half of the third, and products are small.
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
                robot.asked.fields.push((Field::Mass(id), padded(&[value])));
            }
            1 if robot.moves(id) && robot.body(id).is_some_and(weighs) => {
                let value = anywhere(random);
                robot.asked.fields.push((Field::Center(id), padded(&value)));
            }
            2 => {
                let value = anywhere(random);
                robot.asked.fields.push((Field::Origin(id), padded(&value)));
            }
            3 if robot.moves(id) => {
                let value = mass * (1.0 + random.unit());
                let center = anywhere(random);
                let about = tensor(random, 0.1 * value * length * length);
                let load = [&[value][..], &center, &about].concat();
                robot.asked.fields.push((Field::Payload(id), padded(&load)));
            }
            4 if robot.moves(id) && robot.body(id).is_some_and(weighs) => {
                let value = tensor(random, 0.1 * mass * length * length);
                robot
                    .asked
                    .fields
                    .push((Field::Inertia(id), padded(&value)));
            }
            5 => {
                let angles = [(); 3].map(|()| 3.0 * random.unit());
                let value = [anywhere(random), angles].concat();
                robot
                    .asked
                    .fields
                    .push((Field::Placement(id), padded(&value)));
            }
            _ => {}
        }
    }
    if robot.asked.gravity.is_none() && numbers.random.chance(4) {
        let value = [(); 3].map(|()| 9.0 * numbers.random.unit());
        robot.asked.fields.push((Field::Gravity, padded(&value)));
    }
}

/// Drives at joints, and links on which the surroundings act.
fn load(robot: &mut Robot, numbers: &mut Numbers) {
    let inertia = 0.1 * numbers.mass * numbers.length * numbers.length;
    let random = &mut *numbers.random;
    if random.chance(3) {
        for body in robot.bodies.iter().filter(|body| body.kind != Kind::Fixed) {
            if random.chance(2) {
                let drive = [0.5, 2.0, 1.0].map(|size| size * inertia * (1.5 + random.unit()));
                robot.asked.drives.push((body.id, drive));
            }
        }
    }
    if random.chance(4) {
        let mut moving: Vec<usize> = robot.bodies.iter().map(|body| body.id).collect();
        moving.retain(|&id| id == robot.asked.base || robot.models(id));
        // The root is no joint's.
        moving.extend((robot.asked.base == 0).then_some(0));
        moving.retain(|&id| robot.moves(id));
        shuffle(&mut moving, random);
        moving.truncate(2);
        robot.asked.external = (moving, random.chance(2));
    }
}

fn shuffle<X>(items: &mut [X], random: &mut Random) {
    for k in (1..items.len()).rev() {
        items.swap(k, random.below(k + 1));
    }
}

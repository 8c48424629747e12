//! Reduction of a failing robot to the smallest one that still fails.
//!
//! In: a robot, and a test for the same failure. Out: a robot of which nothing more can be removed: no joint, no field,
//! no word of the request, no number that could be zero or shorter.

use super::robot::{Body, Inertial, Kind, Robot, zeros};
use super::written::Written;

/// Removes all that the failure does not need.
pub fn shrink(robot: &Robot, fails: impl Fn(&Robot) -> bool) -> Robot {
    let mut least = robot.clone();
    let mut go_on = true;
    while go_on {
        go_on = false;
        let mut at = 0;
        // Candidates are made from the smallest robot so far; after a success the index points to the next one.
        while let Some(smaller) = smaller(&least).into_iter().nth(at) {
            if fails(&smaller) {
                least = smaller;
                go_on = true;
            } else {
                at += 1;
            }
        }
    }
    least
}

/// Robots with one thing removed, the largest steps first.
fn smaller(robot: &Robot) -> Vec<Robot> {
    let mut smaller = Vec::new();
    let mut with = |change: &dyn Fn(&mut Robot)| {
        let mut changed = robot.clone();
        change(&mut changed);
        smaller.push(changed);
    };
    for body in &robot.bodies {
        let carries = robot.bodies.iter().any(|other| other.parent == body.id);
        if !carries {
            with(&|robot| remove(robot, body.id));
        }
    }
    for body in robot.bodies.iter().filter(|body| body.parent == 0) {
        with(&|robot| become_root(robot, body.id));
    }
    shrink_request(robot, &mut with);
    for (index, body) in robot.bodies.iter().enumerate() {
        let mut on_body = |change: &dyn Fn(&mut Body)| {
            with(&|robot| change(&mut robot.bodies[index]));
        };
        if body.kind != Kind::Fixed {
            on_body(&|body| body.kind = Kind::Fixed);
        }
        if !matches!(body.kind, Kind::Fixed | Kind::Continuous) {
            on_body(&|body| body.kind = Kind::Continuous);
        }
        if body.mimic.is_some() {
            on_body(&|body| body.mimic = None);
        }
        if let Kind::Universal(axis) = &body.kind {
            let one =
                |k: usize| std::array::from_fn(|i| Written::new(if i == k { "1" } else { "0" }));
            if axis.iter().filter(|entry| !entry.is_zero()).count() > 1 {
                for k in 0..3 {
                    on_body(&|body| body.kind = Kind::Universal(one(k)));
                }
            }
        }
        if body.inertial.is_some() {
            on_body(&|body| body.inertial = None);
        }
        if !body.at.turns.is_empty() {
            on_body(&|body| body.at.turns.clear());
        }
        for k in 0..numbers(body.clone()).len() {
            on_body(&|body| zero(body, k));
            on_body(&|body| shorten(body, k));
        }
        if body.axis.iter().filter(|entry| !entry.is_zero()).count() > 1 {
            for k in 0..3 {
                on_body(&|body| {
                    body.axis = zeros();
                    body.axis[k] = Written::new("1");
                });
            }
        }
    }
    smaller.retain(|smaller| smaller != robot);
    smaller
}

/// Removes a link without children.
fn remove(robot: &mut Robot, id: usize) {
    robot.bodies.retain(|body| body.id != id);
    for body in &mut robot.bodies {
        body.mimic.take_if(|mimic| mimic.mimicked == id);
    }
    let options = &mut robot.options;
    if options.base == id {
        options.base = 0;
    }
    options.tip = options.tip.filter(|&tip| tip != id);
    options.lock.retain(|(joint, _)| *joint != id);
    options.drop.retain(|&link| link != id);
    options.frames.retain(|&link| link != id);
    options.fields.retain(|(field, _)| field.of() != Some(id));
    options.actuators.retain(|(joint, _)| *joint != id);
    options.external.0.retain(|&link| link != id);
}

/// Makes a link the root, and removes all but its descendants.
fn become_root(robot: &mut Robot, id: usize) {
    let inboard: Vec<usize> = (robot.bodies.iter().map(|body| body.id))
        .filter(|&other| other == id || !robot.upwards(other).any(|link| link == id))
        .collect();
    for other in inboard {
        remove(robot, other);
    }
    for body in robot.bodies.iter_mut().filter(|body| body.parent == id) {
        body.parent = 0;
    }
}

fn shrink_request(robot: &Robot, with: &mut impl FnMut(&dyn Fn(&mut Robot))) {
    if robot.root.is_some() {
        with(&|robot| robot.root = None);
    }
    with(&|robot| robot.options.floating = false);
    with(&|robot| robot.options.base = 0);
    with(&|robot| robot.options.tip = None);
    with(&|robot| robot.options.path_only = false);
    with(&|robot| robot.options.exact = false);
    with(&|robot| robot.options.gravity = None);
    for k in 0..robot.options.lock.len() {
        with(&|robot| {
            robot.options.lock.remove(k);
        });
        with(&|robot| robot.options.lock[k].1 = None);
    }
    for k in 0..robot.options.drop.len() {
        with(&|robot| {
            robot.options.drop.remove(k);
        });
    }
    for k in 0..robot.options.frames.len() {
        with(&|robot| {
            robot.options.frames.remove(k);
        });
    }
    with(&|robot| robot.options.external.1 = false);
    for k in 0..robot.options.external.0.len() {
        with(&|robot| {
            robot.options.external.0.remove(k);
        });
    }
    for k in 0..robot.options.actuators.len() {
        with(&|robot| {
            robot.options.actuators.remove(k);
        });
        for part in 0..3 {
            with(&|robot| robot.options.actuators[k].1[part] = 0.0);
        }
    }
    for k in 0..robot.options.fields.len() {
        with(&|robot| {
            robot.options.fields.remove(k);
        });
    }
}

/// All numbers of a body except those of its axis.
fn numbers(mut body: Body) -> Vec<Written> {
    let mut words = Vec::new();
    each(&mut body, |word| words.push(word.clone()));
    words
}

fn each(body: &mut Body, mut change: impl FnMut(&mut Written)) {
    body.at.numbers().for_each(&mut change);
    if let Kind::Screw(pitch) = &mut body.kind {
        change(pitch);
    }
    if let Some(mimic) = &mut body.mimic {
        change(&mut mimic.multiplier);
        change(&mut mimic.offset);
    }
    if let Some(Inertial { at, mass, tensor }) = &mut body.inertial {
        at.numbers().for_each(&mut change);
        change(mass);
        tensor.iter_mut().for_each(change);
    }
}

fn zero(body: &mut Body, k: usize) {
    let mut at = 0;
    each(body, |word| {
        if at == k && !word.is_zero() {
            *word = Written::zero();
        }
        at += 1;
    });
}

/// Shortens a number to one digit; a right angle is then an ordinary angle.
fn shorten(body: &mut Body, k: usize) {
    let mut at = 0;
    each(body, |word| {
        if at == k {
            let shorter = Written::digits(word.value(), 1);
            if shorter.to_string().len() < word.to_string().len() {
                *word = shorter;
            }
        }
        at += 1;
    });
}

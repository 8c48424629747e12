//! Random placements, axes and inertias of bodies.
//!
//! In: the bodies drawn before. Out: the next one. Its axis is often coaxial, parallel or antiparallel to that of the
//! joint before it, or intersects it, exactly or but for rounding.

use std::array::from_fn;

use crate::big::Big;

use super::super::robot::{Body, FrontEnd, Inertial, Kind, Mimic, Placement, zeros};
use super::super::written::Written;
use super::numbers::Numbers;

/// A rotation matrix.
type Rows = [[f64; 3]; 3];

/// A body on a link; its axis may be related to that of the joint that carries the link.
pub(super) fn body(id: usize, parent: usize, before: &[Body], numbers: &mut Numbers) -> Body {
    let mut body = Body {
        id,
        parent,
        kind: kind(numbers),
        at: placement(numbers),
        axis: numbers.axis(),
        mimic: None,
        inertial: inertial(numbers),
    };
    let carrier = before.iter().find(|body| body.id == parent);
    let Some(carrier) = carrier else { return body };
    match numbers.random.below(10) {
        // Coaxial: with a translation along the axis and a rotation about it, if it is a coordinate axis.
        0 => {
            body.axis.clone_from(&carrier.axis);
            body.at = Placement::none();
            if let Some(k) = coordinate(&body.axis) {
                body.at.xyz = numbers.nothing();
                body.at.xyz[k] = numbers.along(numbers.length)[k].clone();
                body.at.rpy = numbers.nothing();
                body.at.rpy[k] = numbers.angle();
            }
        }
        // Parallel.
        1 => {
            body.axis.clone_from(&carrier.axis);
            body.at.rpy = numbers.nothing();
            body.at.turns.clear();
        }
        // Antiparallel.
        2 => {
            body.axis = carrier.axis.each_ref().map(Written::negated);
            body.at.rpy = numbers.nothing();
            body.at.turns.clear();
        }
        // Intersecting.
        3 => body.at.xyz = numbers.nothing(),
        // The inverse of a fixed joint's placement: between this joint and the one before that, only rounding remains.
        4 | 5 if carrier.kind == Kind::Fixed => {
            body.at = inverse(&carrier.at);
            let last = before.iter().find(|body| body.id == carrier.parent);
            if let Some(last) = last {
                body.axis.clone_from(&last.axis);
            }
        }
        _ => {}
    }
    body
}

/// The coordinate axis along which an axis is, but for residues.
fn coordinate(axis: &[Written; 3]) -> Option<usize> {
    let square = |entry: &Written| entry.value() * entry.value();
    let whole: f64 = axis.iter().map(square).sum();
    axis.iter().position(|entry| square(entry) > 0.998 * whole)
}

fn kind(numbers: &mut Numbers) -> Kind {
    if numbers.random.chance(6) {
        return match numbers.random.below(6) {
            0 => Kind::Cylindrical,
            1 => Kind::Universal(numbers.axis()),
            2 => Kind::Translation,
            3 => Kind::Planar,
            4 => Kind::Spherical,
            _ => Kind::Floating,
        };
    }
    match numbers.random.below(8) {
        2 | 3 => Kind::Continuous,
        4 => Kind::Prismatic,
        5 if numbers.random.chance(2) => {
            let pitch = 0.1 * numbers.length * numbers.random.unit();
            Kind::Screw(numbers.number(pitch))
        }
        0 | 1 | 5 => Kind::Revolute,
        _ => Kind::Fixed,
    }
}

/// A mimic joint's relation: multiplier 1 or −1 as of gears and fingers, any, or 0.
pub(super) fn mimic(mimicked: usize, numbers: &mut Numbers) -> Mimic {
    let multiplier = match numbers.random.below(12) {
        0..=2 => Written::new("1"),
        3..=5 => Written::new("-1"),
        6 => numbers.zero(),
        _ => {
            let value = 2.0 * numbers.random.unit();
            numbers.number(value)
        }
    };
    let offset = match numbers.random.below(4) {
        0 => {
            let value = numbers.random.unit();
            numbers.number(value)
        }
        1 => {
            let decimals = 2 + numbers.random.below(16);
            Written::decimals(numbers.sign() * std::f64::consts::FRAC_PI_2, decimals)
        }
        _ => numbers.zero(),
    };
    Mimic {
        mimicked,
        multiplier,
        offset,
    }
}

fn placement(numbers: &mut Numbers) -> Placement {
    let length = numbers.length;
    let xyz = match numbers.random.below(6) {
        0 => numbers.nothing(),
        1 | 2 => numbers.along(length),
        _ => numbers.vector(length),
    };
    let rpy = match numbers.random.below(4) {
        0 => numbers.nothing(),
        1 => {
            let mut rpy = numbers.nothing();
            let k = numbers.random.below(3);
            rpy[k] = numbers.right_angle();
            rpy
        }
        _ => zeros().map(|_: Written| numbers.angle()),
    };
    let turns = match numbers.random.below(6) {
        0 if numbers.front_end == FrontEnd::Inline => sum_of_rotations(numbers),
        1 if numbers.front_end == FrontEnd::Inline => {
            vec![(numbers.random.below(3), numbers.angle())]
        }
        _ => Vec::new(),
    };
    Placement { xyz, rpy, turns }
}

/// A right angle as two or three rotations about one axis.
fn sum_of_rotations(numbers: &mut Numbers) -> Vec<(usize, Written)> {
    let axis = numbers.random.below(3);
    let part = part(numbers);
    vec![(axis, part.1); part.0]
}

/// Half or a third of a right angle, and the number of them in one.
fn part(numbers: &mut Numbers) -> (usize, Written) {
    let parts = 2 + numbers.random.below(2);
    let angle = if parts == 2 {
        std::f64::consts::FRAC_PI_4
    } else {
        std::f64::consts::FRAC_PI_6
    };
    let decimals = *numbers.random.choose(&[4, 6, 9, 12, 16]);
    (parts, Written::decimals(numbers.sign() * angle, decimals))
}

/// Two or three fixed joints in a row, each with a part of a right angle about the same axis.
pub(super) fn share_a_right_angle(bodies: &mut [Body], row: &[usize], numbers: &mut Numbers) {
    let axis = numbers.random.below(3);
    let (parts, angle) = part(numbers);
    for body in bodies
        .iter_mut()
        .filter(|body| row.contains(&body.id))
        .take(parts)
    {
        body.kind = Kind::Fixed;
        body.at.rpy = numbers.nothing();
        body.at.rpy[axis] = angle.clone();
        body.at.turns.clear();
    }
}

/// M⁻¹ of a placement, to 17 digits.
fn inverse(at: &Placement) -> Placement {
    let [roll, pitch, yaw] = at.rpy.each_ref().map(Written::value);
    let fixed = [(2, yaw), (1, pitch), (0, roll)].into_iter();
    let turns = at.turns.iter().map(|(axis, angle)| (*axis, angle.value()));
    let identity: Rows = from_fn(|i| from_fn(|j| f64::from(u8::from(i == j))));
    let rows = fixed.chain(turns).fold(identity, |rows, (axis, angle)| {
        product(&rows, &about(axis, angle))
    });
    let t = at.xyz.each_ref().map(Written::value);
    let xyz = from_fn(|j| -(0..3).map(|i| rows[i][j] * t[i]).sum::<f64>());
    // Angles of Rᵗ = Rz(yaw) Ry(pitch) Rx(roll), whose entry i, j is entry j, i of R.
    let level = (rows[0][0] * rows[0][0] + rows[0][1] * rows[0][1]).sqrt();
    let rpy = [
        angle_of(rows[1][2], rows[2][2]),
        angle_of(-rows[0][2], level),
        angle_of(rows[0][1], rows[0][0]),
    ];
    Placement {
        xyz: xyz.map(|entry| Written::digits(entry, 17)),
        rpy: rpy.map(|entry| Written::digits(entry, 17)),
        turns: Vec::new(),
    }
}

/// The angle, the same on every machine.
fn angle_of(sine: f64, cosine: f64) -> f64 {
    Big::new(sine).atan2(&Big::new(cosine)).to_f64()
}

fn about(axis: usize, angle: f64) -> Rows {
    let (sine, cosine) = Big::new(angle).sin_cos();
    let (sine, cosine) = (sine.to_f64(), cosine.to_f64());
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut rows = [[0.0; 3]; 3];
    rows[axis][axis] = 1.0;
    (rows[j][j], rows[j][k]) = (cosine, -sine);
    (rows[k][j], rows[k][k]) = (sine, cosine);
    rows
}

fn product(a: &Rows, b: &Rows) -> Rows {
    from_fn(|i| from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// No inertial, a massless one, a point mass, a rod, or a general body, with centre and axes along the frame but for
/// residues, or anywhere.
pub(super) fn inertial(numbers: &mut Numbers) -> Option<Inertial> {
    let (length, mass) = (numbers.length, numbers.mass);
    let described = |mass, tensor, at| Some(Inertial { at, mass, tensor });
    let word = |numbers: &mut Numbers| {
        let value = mass * (1.5 + numbers.random.unit());
        numbers.number(value)
    };
    let xyz = match numbers.random.below(4) {
        0 => numbers.nothing(),
        1 | 2 => numbers.along(0.3 * length),
        _ => numbers.vector(0.3 * length),
    };
    let rpy = match numbers.random.below(4) {
        0 | 1 => numbers.nothing(),
        2 => zeros(),
        _ => zeros().map(|_: Written| numbers.angle()),
    };
    let turns = Vec::new();
    let at = Placement { xyz, rpy, turns };
    let unit = mass * length * length;
    match numbers.random.below(12) {
        0 | 1 => None,
        2 => described(Written::zero(), zeros(), Placement::none()),
        3 => described(word(numbers), zeros(), at),
        4 => {
            let moment = 0.03 * unit * (1.5 + numbers.random.unit());
            let moment = numbers.number(moment);
            let mut tensor = zeros();
            for k in [0, 3, 5] {
                tensor[k] = moment.clone();
            }
            let along = *numbers.random.choose(&[0, 3, 5]);
            tensor[along] = Written::zero();
            described(word(numbers), tensor, at)
        }
        5..=8 => {
            // Principal moments that are nearly equal.
            let mut tensor = from_fn(|_| numbers.zero());
            for k in [0, 3, 5] {
                let moment = 0.03 * unit * (3.0 + numbers.random.unit());
                tensor[k] = numbers.number(moment);
            }
            for k in [1, 2, 4] {
                if numbers.residues && numbers.random.chance(4) {
                    tensor[k] = Written::digits(1e-9 * unit * numbers.sign(), 1);
                }
            }
            described(word(numbers), tensor, at)
        }
        _ => {
            let tensor = general(numbers).map(|entry| {
                let digits = *numbers.random.choose(&[6, 9, 17]);
                Written::digits(unit * entry, digits)
            });
            described(word(numbers), tensor, at)
        }
    }
}

/// A physical inertia tensor: tr(E) 1 − E with second moments E = A Aᵗ.
fn general(numbers: &mut Numbers) -> [f64; 6] {
    let a: Rows = from_fn(|_| from_fn(|_| 0.3 * numbers.random.unit()));
    let e = |i: usize, j: usize| -> f64 { (0..3).map(|k| a[i][k] * a[j][k]).sum() };
    let trace = e(0, 0) + e(1, 1) + e(2, 2);
    [
        trace - e(0, 0),
        -e(0, 1),
        -e(0, 2),
        trace - e(1, 1),
        -e(1, 2),
        trace - e(2, 2),
    ]
}

//! Descriptions and requests at random.
//!
//! In: a source of random numbers. Out: a tree whose joint k carries link k + 1, told in any order,
//! and a request that it can fulfil. Right angles, axes along coordinates and zeros are frequent,
//! since they are what simplification looks for.

use std::array::from_fn;
use std::f64::consts::FRAC_PI_2;

use homogen_codegen::description::{
    Axis, Description, Inertial, Joint, JointKind, Link, Name, Number, Source, Step,
};
use homogen_codegen::error::Place;
use homogen_codegen::request::{Parameter, Request, Target};
use quote::format_ident;

use super::JOINTS;
use crate::states::Random;

pub(super) struct Grown {
    pub(super) description: Description,
    pub(super) request: Request,
    pub(super) fields: Vec<[f64; 3]>,
}

pub(super) fn grow(random: &mut Random) -> Grown {
    // Mostly a chain, sometimes a branch from anywhere.
    let parents = from_fn(|k| match random.below(3) {
        0 => random.below(k + 1),
        _ => k,
    });
    let mut joints: Vec<Joint> = (0..JOINTS).map(|k| joint(k, parents[k], random)).collect();
    let mut links: Vec<Link> = (0..=JOINTS).map(|k| link(k, random)).collect();
    let modelled = Modelled::random(parents, random);
    let request = request(&modelled, &joints, random);
    let fields = request.parameters.iter();
    let fields = fields
        .map(|_| vector(random).map(|entry| 1.5 + entry))
        .collect();
    shuffle(&mut joints, random);
    shuffle(&mut links, random);
    Grown {
        description: Description {
            name: name("tree", 0),
            source: Source::default(),
            links,
            joints,
            warnings: Vec::new(),
        },
        request,
        fields,
    }
}

/// What is left of a tree when it is cut at a base and below a dropped link.
struct Modelled {
    base: usize,
    dropped: Option<usize>,
    /// The base first.
    links: Vec<usize>,
}

impl Modelled {
    fn random(parents: [usize; JOINTS], random: &mut Random) -> Self {
        let base = if random.chance(4) { random.below(3) } else { 0 };
        let dropped = random.chance(4).then(|| 1 + random.below(JOINTS));
        let dropped = dropped.filter(|&link| link != base);
        let mut links = vec![base];
        // Parents have smaller numbers than their children.
        for (k, parent) in parents.into_iter().enumerate() {
            let link = k + 1;
            if links.contains(&parent) && Some(link) != dropped && link != base {
                links.push(link);
            }
        }
        Self {
            base,
            dropped,
            links,
        }
    }
}

fn request(modelled: &Modelled, joints: &[Joint], random: &mut Random) -> Request {
    let tip = (!random.chance(4)).then(|| name("link", *random.choose(&modelled.links)));
    let mut request = Request {
        base: (modelled.base > 0).then(|| name("link", modelled.base)),
        path_only: tip.is_some() && random.chance(4),
        tip,
        drop: modelled.dropped.iter().map(|&k| name("link", k)).collect(),
        gravity: match random.below(4) {
            0 => Some([number(0.0); 3]),
            1 => Some(vector(random).map(number)),
            _ => None,
        },
        ..Request::default()
    };
    for joint in joints {
        if !matches!(joint.kind, JointKind::Fixed) && random.chance(8) {
            let at = (!random.chance(2)).then(|| number(random.unit()));
            request.lock.push((joint.name.clone(), at));
        }
    }
    if random.chance(3) {
        let link = *random.choose(&modelled.links);
        request.frames.push(name("link", link));
    }
    // The base is fixed: what it weighs is felt nowhere, and nothing carries it.
    for &link in modelled.links.iter().filter(|&&link| link != modelled.base) {
        let target = match random.below(16) {
            0 => Target::MassOf(name("link", link)),
            1 => Target::CenterOfMassOf(name("link", link)),
            2 => Target::OriginOf(name("joint", link - 1)),
            _ => continue,
        };
        add(&mut request, target);
    }
    if request.gravity.is_none() && random.chance(4) {
        add(&mut request, Target::Gravity);
    }
    request
}

fn add(request: &mut Request, target: Target) {
    let field = format_ident!("field_{}", request.parameters.len());
    request.parameters.push(Parameter {
        field,
        target,
        range: None,
    });
}

fn joint(k: usize, parent: usize, random: &mut Random) -> Joint {
    let kind = match random.below(6) {
        0 | 1 => JointKind::Revolute,
        2 => JointKind::Continuous,
        3 => JointKind::Prismatic,
        4 => JointKind::Screw {
            pitch: number(0.1 * random.unit()),
        },
        _ => JointKind::Fixed,
    };
    Joint {
        name: name("joint", k),
        kind,
        parent: name("link", parent),
        child: name("link", k + 1),
        origin: steps(random),
        axis: direction(random).map(number),
        limits: None,
        place: Place::Unknown,
    }
}

fn link(k: usize, random: &mut Random) -> Link {
    let inertial = (!random.chance(5)).then(|| Inertial {
        origin: steps(random),
        mass: number(1.5 + random.unit()),
        inertia: tensor(random).map(number),
        place: Place::Unknown,
    });
    Link {
        name: name("link", k),
        inertial,
    }
}

/// A tensor that a body can have: tr(E) 1 − E of second moments E = A Aᵗ.
fn tensor(random: &mut Random) -> [f64; 6] {
    if random.chance(4) {
        return [0.0; 6];
    }
    let a: [[f64; 3]; 3] = from_fn(|_| vector(random).map(|entry| 0.3 * entry));
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

/// A translation and up to two rotations, each of which may be missing.
fn steps(random: &mut Random) -> Vec<Step> {
    let mut steps = Vec::new();
    if !random.chance(4) {
        steps.push(Step::Translate(vector(random).map(number)));
    }
    for _ in 0..random.below(3) {
        let axis = *random.choose(&[Axis::X, Axis::Y, Axis::Z]);
        let quarters = *random.choose(&[-2.0, -1.0, 1.0, 2.0]);
        let angle = if random.chance(3) {
            3.0 * random.unit()
        } else {
            quarters * FRAC_PI_2
        };
        steps.push(Step::Rotate(axis, number(angle)));
    }
    if random.chance(4) {
        steps.push(Step::Translate(vector(random).map(number)));
    }
    steps
}

/// A vector, some of whose entries are zero.
fn vector(random: &mut Random) -> [f64; 3] {
    from_fn(|_| if random.chance(3) { 0.0 } else { random.unit() })
}

/// A vector of length 1, mostly along a coordinate axis.
fn direction(random: &mut Random) -> [f64; 3] {
    let mut direction = [0.0; 3];
    if random.chance(3) {
        direction = vector(random);
    }
    let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length < 0.1 {
        direction = [0.0; 3];
        direction[random.below(3)] = if random.chance(4) { -1.0 } else { 1.0 };
        return direction;
    }
    direction.map(|x| x / length)
}

fn shuffle<X>(items: &mut [X], random: &mut Random) {
    for k in (1..items.len()).rev() {
        items.swap(k, random.below(k + 1));
    }
}

fn name(kind: &str, k: usize) -> Name {
    Name {
        text: format!("{kind}{k}"),
        place: Place::Unknown,
    }
}

fn number(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}

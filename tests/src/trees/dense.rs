//! A random robot in the dense matrices of the oracle, joint by joint.
//!
//! In: a [`Robot`], number by number as written. Out: a placement, a screw and an inertia of 256 bits for every joint
//! below the base, fixed and locked ones included. Nothing is merged. Nothing is shared with the generator, not even
//! the reading of numbers; [`oracle::robot`](crate::oracle::robot) takes numbers that the generator has read.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::big::Big;
use crate::oracle::actuator::Actuator;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::{Manifold, Motion, across, translation_screw};
use crate::oracle::robot as oracle;

use super::movement::Movement;
use super::robot::{Body, Field, Inertial, Kind, NUMBERS, Placement, Robot};
use super::written::{Reading, Written};

/// A robot in matrices, and the meaning of its coordinates and velocities.
#[derive(Clone, Debug)]
pub struct Dense {
    /// The robot for the oracle.
    pub robot: oracle::Robot,
    /// Its coordinates.
    pub coordinates: Vec<Entry>,
    /// Its velocities.
    pub velocities: Vec<Entry>,
    /// The link of each of its bodies; `None` for intermediate bodies of joints with several velocities.
    pub links: Vec<Option<usize>>,
    /// An upper bound of the distance of centres of mass from the base \[m\]: the sum of all offsets.
    pub reach: f64,
    /// The largest translation of a joint for a unit of its coordinate.
    pub translation: f64,
    /// The largest sum of the displacements of all joints of a coordinate, for a unit of it.
    pub gain: f64,
    /// The mass of all bodies \[kg\].
    pub mass: f64,
    /// The sum of their second moments about the origins of their own frames [kg m²].
    pub second: f64,
}

/// A coordinate or a velocity of a joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its name.
    pub name: String,
    /// The number of the joint; 0 for a floating base.
    pub joint: usize,
    /// Its index among those of the joint.
    pub part: usize,
}

/// Bound of the coordinates of random states.
const FARTHEST: f64 = 4.0;

impl Dense {
    /// The part of a robot that its request selects.
    ///
    /// # Panics
    /// If the robot is not a tree.
    #[must_use]
    pub fn of(robot: &Robot) -> Self {
        let gravity = robot.options.gravity.as_ref();
        let gravity = gravity.map_or_else(|| big([0.0, 0.0, -9.81]), exact);
        let field = robot.field(Field::Gravity);
        let gravity = field.map_or(gravity, |field| big(first(field)));
        let mut dense = Self {
            robot: oracle::Robot {
                bodies: Vec::new(),
                frames: Vec::new(),
                gravity: Matrix::screw(&big([0.0; 3]), &gravity),
                loops: Vec::new(),
                actuators: Vec::new(),
                identifies_actuators: false,
                external: (Vec::new(), false),
            },
            coordinates: Vec::new(),
            velocities: Vec::new(),
            links: Vec::new(),
            reach: 0.0,
            translation: 0.0,
            gain: 1.0,
            mass: 0.0,
            second: 0.0,
        };
        if robot.options.floating {
            dense.add_floating_base(robot);
        }
        for joint in robot.moving().filter_map(|id| robot.body(id)) {
            let name = format!("joint{}", joint.id);
            dense.add_entries(joint.id, &name, &joint.kind);
        }
        let mut waiting: Vec<&Body> = robot.bodies.iter().collect();
        waiting.retain(|body| robot.models(body.id));
        // Parents before children, in any order of the text.
        while !waiting.is_empty() {
            let before = waiting.len();
            waiting.retain(|body| !dense.add_body(robot, body));
            assert!(waiting.len() < before, "the robot is a tree");
        }
        dense.gain = dense.gains();
        dense.add_actuators_and_wrenches(robot);
        dense
    }

    /// The links, each with the bodies that its joint moves, the last of which is the link.
    fn moved(&self) -> Vec<(usize, Range<usize>)> {
        let mut first = 0;
        let links = self.links.iter().enumerate();
        let links = links.filter_map(|(body, link)| Some((body, (*link)?)));
        links
            .map(|(body, link)| (link, std::mem::replace(&mut first, body + 1)..body + 1))
            .collect()
    }

    /// The link of each velocity of its joint, in the order of the actuators.
    #[must_use]
    pub fn actuated_links(&self) -> Vec<usize> {
        let links = self.moved().into_iter().flat_map(|(link, bodies)| {
            let screws = bodies.map(|body| self.robot.bodies[body].motion.screws().len());
            std::iter::repeat_n(link, screws.sum())
        });
        links.collect()
    }

    /// Adds armature, damping and friction, and links with external wrenches.
    fn add_actuators_and_wrenches(&mut self, robot: &Robot) {
        let actuators: BTreeMap<usize, [f64; 3]> = robot.actuators().collect();
        for (id, bodies) in self.moved() {
            let numbers = actuators
                .get(&id)
                .copied()
                .unwrap_or_default()
                .map(Big::new);
            for motion in bodies.map(|body| &self.robot.bodies[body].motion) {
                let factor = match motion {
                    Motion::Along { factor, .. } => factor.clone(),
                    Motion::Manifold { .. } | Motion::Held { .. } => Big::one(),
                };
                for (velocity, _) in motion.screws() {
                    let actuator = Actuator::new(velocity, factor.clone(), numbers.clone());
                    self.robot.actuators.push(actuator);
                }
            }
        }
        let bodies = robot.acted_on().filter_map(|link| self.body(link));
        let bodies = bodies.collect();
        self.robot.external = (bodies, robot.options.external.1);
    }

    /// Adds the coordinates and the velocities of a joint.
    fn add_entries(&mut self, joint: usize, called: &str, kind: &Kind) {
        let entry = |(part, name): (usize, &&str)| Entry {
            name: format!("{called}{name}"),
            joint,
            part,
        };
        let [coordinates, velocities] = kind.entries();
        let coordinates = coordinates.iter().enumerate().map(entry);
        self.coordinates.extend(coordinates);
        self.velocities
            .extend(velocities.iter().enumerate().map(entry));
    }

    /// Adds the floating base.
    fn add_floating_base(&mut self, robot: &Robot) {
        self.add_entries(0, "root", &Kind::Floating);
        let base = robot.body(robot.options.base);
        let inertial = base.map_or(&robot.root, |body| &body.inertial);
        let inertia = inertia(robot, robot.options.base, inertial.as_ref());
        self.add_inertia(&inertia);
        self.reach += FARTHEST;
        self.translation = 1.0;
        self.links.push(Some(robot.options.base));
        self.robot.bodies.push(oracle::Body {
            parent: None,
            placement: Matrix::identity(),
            motion: Motion::Manifold {
                manifold: Manifold::Floating,
                coordinate: 0,
                velocity: 0,
            },
            inertia,
            link: true,
        });
    }

    fn add_inertia(&mut self, inertia: &Matrix) {
        let mass = inertia.0[3][3].to_f64();
        if mass > 0.0 {
            self.reach += length(&inertia.column()) / mass;
        }
        self.mass += mass;
        self.second += (0..3).map(|k| inertia.0[k][k].to_f64().abs()).sum::<f64>();
    }

    /// The largest sum of factors of one velocity.
    fn gains(&self) -> f64 {
        let mut gains = vec![0.0; self.velocities.len()];
        for body in &self.robot.bodies {
            match &body.motion {
                Motion::Along {
                    velocity, factor, ..
                } => gains[*velocity] += factor.abs().to_f64(),
                Motion::Manifold { .. } | Motion::Held { .. } => {}
            }
        }
        gains.into_iter().fold(1.0, f64::max)
    }

    /// The body of a link; `None` for the base.
    #[must_use]
    pub fn body(&self, link: usize) -> Option<usize> {
        self.links.iter().position(|&known| known == Some(link))
    }

    /// Adds a body if its parent is there. Returns true if it was added.
    fn add_body(&mut self, robot: &Robot, body: &Body) -> bool {
        let parent = self.body(body.parent);
        if parent.is_none() && body.parent != robot.options.base {
            return false;
        }
        let offset = robot.field(Field::Origin(body.id)).map(first);
        let placement = match robot.field(Field::Placement(body.id)) {
            Some(field) => placed(field),
            None => placement(&body.at, offset, robot.reading()),
        };
        let inertia = inertia(robot, body.id, body.inertial.as_ref());
        let movement = Movement::of(robot, body);
        let translation = match &body.kind {
            Kind::Prismatic
            | Kind::Cylindrical
            | Kind::Translation
            | Kind::Planar
            | Kind::Floating => 1.0,
            Kind::Screw(pitch) => pitch.value().abs(),
            Kind::Revolute
            | Kind::Continuous
            | Kind::Universal(_)
            | Kind::Spherical
            | Kind::Fixed => 0.0,
        };
        let (times, at) = match &movement {
            Movement::Own => (1.0, FARTHEST),
            Movement::As { factor, offset, .. } => {
                let factor = factor.abs().to_f64();
                (factor, factor * FARTHEST + offset.abs().to_f64())
            }
            Movement::Held(at) => (0.0, at.abs().to_f64()),
        };
        self.reach += length(&placement.column()) + translation * at;
        self.add_inertia(&inertia);
        self.translation = self.translation.max(translation * times);
        let parts = self.parts(body, &movement, robot.reading());
        let moved = parts.iter().any(|(_, motion)| motion.moves());
        let (last, mut parent, mut placement) = (parts.len() - 1, parent, placement);
        for (k, (rotation, motion)) in parts.into_iter().enumerate() {
            // Intermediate bodies are no links.
            self.links.push((k == last).then_some(body.id));
            self.robot.bodies.push(oracle::Body {
                parent,
                placement: &placement * &rotation,
                motion,
                inertia: if k == last {
                    inertia.clone()
                } else {
                    Matrix::zero()
                },
                link: moved && k == last,
            });
            (parent, placement) = (Some(self.links.len() - 1), Matrix::identity());
        }
        true
    }

    /// The bodies of a joint, one after the other: a rotation in front of each, and its motion.
    fn parts(&self, body: &Body, movement: &Movement, reading: Reading) -> Vec<(Matrix, Motion)> {
        let first = |entries: &[Entry], joint: usize| {
            let first = entries.iter().position(|entry| entry.joint == joint);
            first.expect("moving joints have entries")
        };
        let places = |joint| {
            (
                first(&self.coordinates, joint),
                first(&self.velocities, joint),
            )
        };
        if let (Some(manifold), Movement::Own) = (manifold(&body.kind), movement) {
            let (coordinate, velocity) = places(body.id);
            let motion = Motion::Manifold {
                manifold,
                coordinate,
                velocity,
            };
            if manifold != Manifold::Planar {
                return vec![(Matrix::identity(), motion)];
            }
            let rotation = across(&unit(&body.axis, reading));
            let back = rotation.inverse();
            return vec![(rotation, motion), (back, Motion::none())];
        }
        let screws = screws(body, reading).into_iter().enumerate();
        let motions = screws.map(|(part, screw)| match movement {
            Movement::Own => {
                let (coordinate, velocity) = places(body.id);
                Motion::Along {
                    screw,
                    coordinate: coordinate + part,
                    velocity: velocity + part,
                    factor: Big::one(),
                    offset: Big::zero(),
                }
            }
            Movement::As {
                mimicked,
                factor,
                offset,
            } => {
                let (coordinate, velocity) = places(*mimicked);
                Motion::Along {
                    screw,
                    coordinate,
                    velocity,
                    factor: factor.clone(),
                    offset: offset.clone(),
                }
            }
            Movement::Held(at) => Motion::Held {
                screw,
                at: at.clone(),
            },
        });
        motions.map(|motion| (Matrix::identity(), motion)).collect()
    }
}

/// The configuration space of a joint whose velocities are in the axes of the moved body.
fn manifold(kind: &Kind) -> Option<Manifold> {
    Some(match kind {
        Kind::Planar => Manifold::Planar,
        Kind::Spherical => Manifold::Spherical,
        Kind::Floating => Manifold::Floating,
        _ => return None,
    })
}

fn length(vector: &[Big; 3]) -> f64 {
    let square = vector.iter().fold(Big::zero(), |sum, x| sum + x * x);
    square.sqrt().to_f64()
}

fn big<const N: usize>(values: [f64; N]) -> [Big; N] {
    values.map(Big::new)
}

fn exact<const N: usize>(numbers: &[Written; N]) -> [Big; N] {
    numbers.each_ref().map(Written::number)
}

fn placement(at: &Placement, offset: Option<[f64; 3]>, reading: Reading) -> Matrix {
    let meant = || at.xyz.each_ref().map(|entry| entry.meant(reading, 1.0));
    let xyz = offset.map_or_else(meant, big);
    let [roll, pitch, yaw] = &at.rpy;
    let fixed = [(2, yaw), (1, pitch), (0, roll)];
    let turns = at.turns.iter().map(|(axis, angle)| (*axis, angle));
    fixed
        .into_iter()
        .chain(turns)
        .fold(Matrix::translation(&xyz), |placement, (axis, angle)| {
            &placement * &rotation(axis, &angle.sin_cos(reading))
        })
}

/// R, 0; 0, 1 of a rotation about a coordinate axis.
fn rotation(axis: usize, (sine, cosine): &(Big, Big)) -> Matrix {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = Matrix::identity();
    matrix.0[j][j] = cosine.clone();
    matrix.0[j][k] = -sine;
    matrix.0[k][j] = sine.clone();
    matrix.0[k][k] = cosine.clone();
    matrix
}

/// The unit vector of a direction.
fn unit(axis: &[Written; 3], reading: Reading) -> [Big; 3] {
    let times = towards_1(axis);
    let axis = axis.each_ref().map(|entry| entry.meant(reading, times));
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    axis.map(|entry| entry / square.sqrt())
}

/// The power of two that scales the length of an axis to [1, 2), or 1 if it is in [0.98, 2); entries of the scaled axis
/// are compared with the size of residues.
fn towards_1(axis: &[Written; 3]) -> f64 {
    let length = length(&exact(axis));
    let mut times = 1.0;
    if (0.98..2.0).contains(&length) {
        return times;
    }
    while length * times >= 2.0 {
        times *= 0.5;
    }
    while length * times < 1.0 {
        times *= 2.0;
    }
    times
}

/// L of each motion of a joint that is a sequence of motions along screws through the origin; zero for other joints.
fn screws(body: &Body, reading: Reading) -> Vec<Matrix> {
    let nothing = big([0.0; 3]);
    let rotation = |axis| Matrix::screw(&unit(axis, reading), &nothing);
    let translation = |axis| Matrix::screw(&nothing, &unit(axis, reading));
    match &body.kind {
        Kind::Revolute | Kind::Continuous => vec![rotation(&body.axis)],
        Kind::Prismatic => vec![translation(&body.axis)],
        Kind::Screw(pitch) => {
            let along = translation(&body.axis).times(&pitch.number());
            vec![&rotation(&body.axis) + &along]
        }
        Kind::Cylindrical => vec![rotation(&body.axis), translation(&body.axis)],
        Kind::Universal(second) => vec![rotation(&body.axis), rotation(second)],
        Kind::Translation => (0..3).map(translation_screw).collect(),
        Kind::Planar | Kind::Spherical | Kind::Floating | Kind::Fixed => vec![Matrix::zero()],
    }
}

/// M J Mᵗ, where J = ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
fn inertia(robot: &Robot, link: usize, inertial: Option<&Inertial>) -> Matrix {
    let nothing = Inertial {
        at: Placement::none(),
        mass: Written::zero(),
        tensor: super::robot::zeros(),
    };
    let inertial = inertial.unwrap_or(&nothing);
    let mass = robot.field(Field::Mass(link));
    let mass = mass.map_or_else(|| inertial.mass.number(), |[mass, ..]| Big::new(mass));
    let tensor = robot.field(Field::Inertia(link));
    let tensor = tensor.map_or_else(|| exact(&inertial.tensor), |field| big(first(field)));
    let center = robot.field(Field::Center(link)).map(first);
    let at = placement(&inertial.at, center, robot.reading());
    let own = &(&at * &central(mass, tensor)) * &at.transposed();
    let Some([mass, x, y, z, tensor @ ..]) = robot.field(Field::Payload(link)) else {
        return own;
    };
    let at = Matrix::translation(&big([x, y, z]));
    let central = central(Big::new(mass), big(tensor));
    &own + &(&(&at * &central) * &at.transposed())
}

/// J about the centre of mass.
fn central(mass: Big, [xx, xy, xz, yy, yz, zz]: [Big; 6]) -> Matrix {
    let half = (&xx + &yy + &zz) / Big::new(2.0);
    let zero = Big::zero;
    Matrix([
        [&half - &xx, -&xy, -&xz, zero()],
        [-&xy, &half - &yy, -&yz, zero()],
        [-&xz, -&yz, &half - &zz, zero()],
        [zero(), zero(), zero(), mass],
    ])
}

/// The first numbers of a field.
fn first<const N: usize>(field: [f64; NUMBERS]) -> [f64; N] {
    std::array::from_fn(|k| field[k])
}

/// M of an origin and of roll, pitch and yaw.
fn placed([x, y, z, roll, pitch, yaw, ..]: [f64; NUMBERS]) -> Matrix {
    let turns = [(2, yaw), (1, pitch), (0, roll)].into_iter();
    turns.fold(
        Matrix::translation(&big([x, y, z])),
        |placement, (axis, angle)| &placement * &rotation(axis, &Big::new(angle).sin_cos()),
    )
}

//! A robot in the dense matrices of the oracle, joint by joint.
//!
//! In: a [`Robot`], number by number as written. Out: a placement, a screw and an inertia of 256
//! bits for every joint that hangs on the base, fixed and held ones too. It merges nothing, and
//! shares nothing with the generator: not even the reading of a number. That is why it stands beside
//! [`oracle::robot`](crate::oracle::robot), which reads what the generator read: one reader for both
//! would be wrong together with the generator's.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::big::Big;
use crate::oracle::drive::Drive;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::{self, Motion, Posture, across};
use crate::oracle::robot as oracle;

use super::movement::Movement;
use super::robot::{Body, Field, Inertial, Kind, NUMBERS, Placement, Robot};
use super::written::{Reading, Written};

/// A robot in matrices, and what its coordinates and velocities are.
#[derive(Clone, Debug)]
pub struct Dense {
    /// What the oracle evaluates.
    pub robot: oracle::Robot,
    /// Its coordinates.
    pub coordinates: Vec<Entry>,
    /// Its velocities.
    pub velocities: Vec<Entry>,
    /// The link of each of its bodies; none of those that a joint puts between.
    pub links: Vec<Option<usize>>,
    /// About how far the robot reaches, with its centres of mass \[m\]: the sum of all offsets.
    pub reach: f64,
    /// The most that a joint slides for a unit of its coordinate.
    pub slide: f64,
    /// The most that all joints of a coordinate together move for a unit of it.
    pub gain: f64,
    /// What all bodies weigh together \[kg\].
    pub mass: f64,
    /// The sum of their second moments about their own frames' origins [kg m²].
    pub second: f64,
}

/// A coordinate or a velocity of a joint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// What it is called.
    pub name: String,
    /// The number of the joint; 0 of a free base.
    pub joint: usize,
    /// Its place among those of the joint.
    pub part: usize,
}

/// States are drawn up to there.
const FARTHEST: f64 = 4.0;

impl Dense {
    /// The part of a robot that is asked for.
    ///
    /// # Panics
    /// Where the robot is no tree.
    #[must_use]
    pub fn of(robot: &Robot) -> Self {
        let gravity = robot.asked.gravity.as_ref();
        let gravity = gravity.map_or_else(|| big([0.0, 0.0, -9.81]), exact);
        let field = robot.field(Field::Gravity);
        let gravity = field.map_or(gravity, |field| big(first(field)));
        let mut dense = Self {
            robot: oracle::Robot {
                bodies: Vec::new(),
                frames: Vec::new(),
                gravity: Matrix::screw(&big([0.0; 3]), &gravity),
                loops: Vec::new(),
                drives: Vec::new(),
                identifies_drives: false,
                external: (Vec::new(), false),
            },
            coordinates: Vec::new(),
            velocities: Vec::new(),
            links: Vec::new(),
            reach: 0.0,
            slide: 0.0,
            gain: 1.0,
            mass: 0.0,
            second: 0.0,
        };
        if robot.asked.floating {
            dense.free(robot);
        }
        for joint in robot.moving().filter_map(|id| robot.body(id)) {
            let name = format!("joint{}", joint.id);
            dense.list(joint.id, &name, &joint.kind);
        }
        let mut waiting: Vec<&Body> = robot.bodies.iter().collect();
        waiting.retain(|body| robot.models(body.id));
        // Parents before children, whatever the order of the text.
        while !waiting.is_empty() {
            let before = waiting.len();
            waiting.retain(|body| !dense.take(robot, body));
            assert!(waiting.len() < before, "the robot is a tree");
        }
        dense.gain = dense.gains();
        dense.load(robot);
        dense
    }

    /// The links with the bodies that each one's joint moves: they end with it, and go back to another's.
    fn moved(&self) -> Vec<(usize, Range<usize>)> {
        let mut first = 0;
        let links = self.links.iter().enumerate();
        let links = links.filter_map(|(body, link)| Some((body, (*link)?)));
        links
            .map(|(body, link)| (link, std::mem::replace(&mut first, body + 1)..body + 1))
            .collect()
    }

    /// The links that joints move, one for each velocity of its joint, in the order of the drives.
    #[must_use]
    pub fn driven(&self) -> Vec<usize> {
        let links = self.moved().into_iter().flat_map(|(link, bodies)| {
            let screws = bodies.map(|body| self.robot.bodies[body].motion.screws().len());
            std::iter::repeat_n(link, screws.sum())
        });
        links.collect()
    }

    /// Adds drives, and links on which the surroundings act.
    fn load(&mut self, robot: &Robot) {
        let said: BTreeMap<usize, [f64; 3]> = robot.drives().collect();
        for (id, bodies) in self.moved() {
            let drive = said.get(&id).copied().unwrap_or_default().map(Big::new);
            for motion in bodies.map(|body| &self.robot.bodies[body].motion) {
                let factor = match motion {
                    Motion::Along { factor, .. } => factor.clone(),
                    Motion::Posture { .. } | Motion::Held { .. } => Big::one(),
                };
                for (velocity, _) in motion.screws() {
                    let drive = Drive::new(velocity, factor.clone(), drive.clone());
                    self.robot.drives.push(drive);
                }
            }
        }
        let bodies = robot.acted_on().filter_map(|link| self.body(link));
        let bodies = bodies.collect();
        self.robot.external = (bodies, robot.asked.external.1);
    }

    /// Adds the coordinates and the velocities of a joint.
    fn list(&mut self, joint: usize, called: &str, kind: &Kind) {
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

    /// Lets the base go.
    fn free(&mut self, robot: &Robot) {
        self.list(0, "root", &Kind::Floating);
        let base = robot.body(robot.asked.base);
        let inertial = base.map_or(&robot.root, |body| &body.inertial);
        let inertia = inertia(robot, robot.asked.base, inertial.as_ref());
        self.weigh(&inertia);
        self.reach += FARTHEST;
        self.slide = 1.0;
        self.links.push(Some(robot.asked.base));
        self.robot.bodies.push(oracle::Body {
            parent: None,
            placement: Matrix::identity(),
            motion: Motion::Posture {
                posture: Posture::Floating,
                coordinate: 0,
                velocity: 0,
            },
            inertia,
            link: true,
        });
    }

    fn weigh(&mut self, inertia: &Matrix) {
        let mass = inertia.0[3][3].to_f64();
        if mass > 0.0 {
            self.reach += length(&inertia.column()) / mass;
        }
        self.mass += mass;
        self.second += (0..3).map(|k| inertia.0[k][k].to_f64().abs()).sum::<f64>();
    }

    /// The largest sum of what a unit of a coordinate moves joints by.
    fn gains(&self) -> f64 {
        let mut gains = vec![0.0; self.velocities.len()];
        for body in &self.robot.bodies {
            match &body.motion {
                Motion::Along {
                    velocity, factor, ..
                } => gains[*velocity] += factor.abs().to_f64(),
                Motion::Posture { .. } | Motion::Held { .. } => {}
            }
        }
        gains.into_iter().fold(1.0, f64::max)
    }

    /// The body that carries a link; none for the base.
    #[must_use]
    pub fn body(&self, link: usize) -> Option<usize> {
        self.links.iter().position(|&known| known == Some(link))
    }

    /// Adds a body, if the one it hangs on is there.
    fn take(&mut self, robot: &Robot, body: &Body) -> bool {
        let parent = self.body(body.parent);
        if parent.is_none() && body.parent != robot.asked.base {
            return false;
        }
        let offset = robot.field(Field::Origin(body.id)).map(first);
        let placement = match robot.field(Field::Placement(body.id)) {
            Some(field) => placed(field),
            None => placement(&body.at, offset, robot.reading()),
        };
        let inertia = inertia(robot, body.id, body.inertial.as_ref());
        let movement = Movement::of(robot, body);
        let slide = match &body.kind {
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
        self.reach += length(&placement.column()) + slide * at;
        self.weigh(&inertia);
        self.slide = self.slide.max(slide * times);
        let parts = self.parts(body, &movement, robot.reading());
        let moved = parts.iter().any(|(_, motion)| motion.moves());
        let (last, mut parent, mut placement) = (parts.len() - 1, parent, placement);
        for (k, (turn, motion)) in parts.into_iter().enumerate() {
            // What moves by a part of a joint's velocities is no link.
            self.links.push((k == last).then_some(body.id));
            self.robot.bodies.push(oracle::Body {
                parent,
                placement: &placement * &turn,
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

    /// The bodies that a joint moves, one on the other: a turn in front of each, and what moves it.
    fn parts(&self, body: &Body, movement: &Movement, reading: Reading) -> Vec<(Matrix, Motion)> {
        let first = |entries: &[Entry], joint: usize| {
            let first = entries.iter().position(|entry| entry.joint == joint);
            first.expect("what moves is listed")
        };
        let places = |joint| {
            (
                first(&self.coordinates, joint),
                first(&self.velocities, joint),
            )
        };
        if let (Some(posture), Movement::Own) = (posture(&body.kind), movement) {
            let (coordinate, velocity) = places(body.id);
            let motion = Motion::Posture {
                posture,
                coordinate,
                velocity,
            };
            if posture != Posture::Planar {
                return vec![(Matrix::identity(), motion)];
            }
            let turn = across(&unit(&body.axis, reading));
            let back = turn.inverse();
            return vec![(turn, motion), (back, Motion::none())];
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
                leader,
                factor,
                offset,
            } => {
                let (coordinate, velocity) = places(*leader);
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

/// What a joint is whose velocities are seen in the moved frame.
fn posture(kind: &Kind) -> Option<Posture> {
    Some(match kind {
        Kind::Planar => Posture::Planar,
        Kind::Spherical => Posture::Spherical,
        Kind::Floating => Posture::Floating,
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

/// R, 0; 0, 1 of a turn about a coordinate axis.
fn rotation(axis: usize, (sine, cosine): &(Big, Big)) -> Matrix {
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = Matrix::identity();
    matrix.0[j][j] = cosine.clone();
    matrix.0[j][k] = -sine;
    matrix.0[k][j] = sine.clone();
    matrix.0[k][k] = cosine.clone();
    matrix
}

/// A direction made of length 1.
fn unit(axis: &[Written; 3], reading: Reading) -> [Big; 3] {
    let times = towards_1(axis);
    let axis = axis.each_ref().map(|entry| entry.meant(reading, times));
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    axis.map(|entry| entry / square.sqrt())
}

/// The power of two that makes the length of an axis 1 to 2, where it is not 0.98 to 2 anyhow: beside that an entry
/// is zero or not.
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

/// L through the origin, of each motion of a joint whose motions come one after the other; null of what
/// does not move, or moves in another way.
fn screws(body: &Body, reading: Reading) -> Vec<Matrix> {
    let nothing = big([0.0; 3]);
    let turn = |axis| Matrix::screw(&unit(axis, reading), &nothing);
    let slide = |axis| Matrix::screw(&nothing, &unit(axis, reading));
    match &body.kind {
        Kind::Revolute | Kind::Continuous => vec![turn(&body.axis)],
        Kind::Prismatic => vec![slide(&body.axis)],
        Kind::Screw(pitch) => {
            let along = slide(&body.axis).times(&pitch.number());
            vec![&turn(&body.axis) + &along]
        }
        Kind::Cylindrical => vec![turn(&body.axis), slide(&body.axis)],
        Kind::Universal(second) => vec![turn(&body.axis), turn(second)],
        Kind::Translation => (0..3).map(motion::slide).collect(),
        Kind::Planar | Kind::Spherical | Kind::Floating | Kind::Fixed => vec![Matrix::zero()],
    }
}

/// M J Mᵗ of ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
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

/// M by an origin, and by roll, pitch and yaw.
fn placed([x, y, z, roll, pitch, yaw, ..]: [f64; NUMBERS]) -> Matrix {
    let turns = [(2, yaw), (1, pitch), (0, roll)].into_iter();
    turns.fold(
        Matrix::translation(&big([x, y, z])),
        |placement, (axis, angle)| &placement * &rotation(axis, &Big::new(angle).sin_cos()),
    )
}

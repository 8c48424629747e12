//! A robot in the dense matrices of the oracle, joint by joint.
//!
//! In: a [`Robot`], number by number as written. Out: a placement, a screw and an inertia of 256
//! bits for every joint that hangs on the base, fixed and held ones too. It merges nothing, and
//! shares nothing with the generator: not even the reading of a number. That is why it stands beside
//! [`oracle::robot`](crate::oracle::robot), which reads what the generator read: one reader for both
//! would be wrong together with the generator's.

use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::{self as oracle, Coordinate};

use super::robot::{Body, Field, Inertial, Kind, Placement, Robot};
use super::written::{Reading, Written};

/// A robot in matrices, and which joint each coordinate is of.
#[derive(Clone, Debug)]
pub struct Dense {
    /// What the oracle evaluates.
    pub robot: oracle::Robot,
    /// The number of the joint of each of its coordinates.
    pub moving: Vec<usize>,
    /// The link of each of its bodies.
    pub links: Vec<usize>,
    /// About how far the robot reaches, with its centres of mass \[m\]: the sum of all offsets.
    pub reach: f64,
    /// The most that a joint slides for a unit of its coordinate.
    pub slide: f64,
    /// What all bodies weigh together \[kg\].
    pub mass: f64,
    /// The sum of their second moments about their own frames' origins [kg m²].
    pub second: f64,
}

impl Dense {
    /// The part of a robot that is asked for.
    ///
    /// # Panics
    /// Where the robot is no tree.
    #[must_use]
    pub fn of(robot: &Robot) -> Self {
        let gravity = robot.asked.gravity.as_ref();
        let gravity = gravity.map_or([0.0, 0.0, -9.81], |entries| {
            entries.each_ref().map(Written::value)
        });
        let gravity = robot.field(Field::Gravity).unwrap_or(gravity);
        let mut dense = Self {
            robot: oracle::Robot {
                bodies: Vec::new(),
                frames: Vec::new(),
                gravity: Matrix::screw(&big([0.0; 3]), &big(gravity)),
            },
            moving: Vec::new(),
            links: Vec::new(),
            reach: 0.0,
            slide: 0.0,
            mass: 0.0,
            second: 0.0,
        };
        let mut waiting: Vec<&Body> = robot.bodies.iter().collect();
        waiting.retain(|body| robot.models(body.id));
        // Parents before children, whatever the order of the text.
        while !waiting.is_empty() {
            let before = waiting.len();
            waiting.retain(|body| !dense.take(robot, body));
            assert!(waiting.len() < before, "the robot is a tree");
        }
        dense
    }

    /// The body that carries a link; none for the base.
    #[must_use]
    pub fn body(&self, link: usize) -> Option<usize> {
        self.links.iter().position(|&known| known == link)
    }

    /// Adds a body, if the one it hangs on is there.
    fn take(&mut self, robot: &Robot, body: &Body) -> bool {
        let parent = self.body(body.parent);
        if parent.is_none() && body.parent != robot.asked.base {
            return false;
        }
        let offset = robot.field(Field::Origin(body.id));
        let placement = placement(&body.at, offset, robot.reading());
        let inertia = inertia(robot, body);
        let slide = match &body.kind {
            Kind::Prismatic => 1.0,
            Kind::Screw(pitch) => pitch.value().abs(),
            Kind::Revolute | Kind::Continuous | Kind::Fixed => 0.0,
        };
        let (coordinate, at) = if let Some(at) = robot.held(body) {
            (Coordinate::Held(Big::new(at)), at.abs())
        } else {
            self.moving.push(body.id);
            // States are drawn up to 4.
            (Coordinate::Free(self.moving.len() - 1), 4.0)
        };
        let mass = inertia.0[3][3].to_f64();
        self.reach += length(&placement.column()) + slide * at;
        if mass > 0.0 {
            self.reach += length(&inertia.column()) / mass;
        }
        self.slide = self.slide.max(slide);
        self.mass += mass;
        self.second += (0..3).map(|k| inertia.0[k][k].to_f64().abs()).sum::<f64>();
        self.links.push(body.id);
        self.robot.bodies.push(oracle::Body {
            parent,
            placement,
            screw: screw(body, robot.reading()),
            inertia,
            coordinate,
            link: true,
        });
        true
    }
}

fn length(vector: &[Big; 3]) -> f64 {
    let square = vector.iter().fold(Big::zero(), |sum, x| sum + x * x);
    square.sqrt().to_f64()
}

fn big<const N: usize>(values: [f64; N]) -> [Big; N] {
    values.map(Big::new)
}

fn placement(at: &Placement, offset: Option<[f64; 3]>, reading: Reading) -> Matrix {
    let xyz = offset.unwrap_or_else(|| at.xyz.each_ref().map(|entry| entry.meant(reading)));
    let [roll, pitch, yaw] = &at.rpy;
    let fixed = [(2, yaw), (1, pitch), (0, roll)];
    let turns = at.turns.iter().map(|(axis, angle)| (*axis, angle));
    fixed.into_iter().chain(turns).fold(
        Matrix::translation(&big(xyz)),
        |placement, (axis, angle)| &placement * &rotation(axis, &angle.sin_cos(reading)),
    )
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

/// L through the origin, about or along an axis made of length 1.
fn screw(body: &Body, reading: Reading) -> Matrix {
    let nothing = big([0.0; 3]);
    let axis = big(body.axis.each_ref().map(|entry| entry.meant(reading)));
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    let axis = axis.map(|entry| entry / square.sqrt());
    match &body.kind {
        Kind::Fixed => Matrix::zero(),
        Kind::Revolute | Kind::Continuous => Matrix::screw(&axis, &nothing),
        Kind::Prismatic => Matrix::screw(&nothing, &axis),
        Kind::Screw(pitch) => {
            let pitch = Big::new(pitch.value());
            let slide = axis.each_ref().map(|entry| entry * &pitch);
            Matrix::screw(&axis, &slide)
        }
    }
}

/// M J Mᵗ of ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
fn inertia(robot: &Robot, body: &Body) -> Matrix {
    let nothing = Inertial {
        at: Placement::none(),
        mass: Written::zero(),
        tensor: super::robot::zeros(),
    };
    let inertial = body.inertial.as_ref().unwrap_or(&nothing);
    let mass = robot.field(Field::Mass(body.id));
    let mass = mass.map_or(inertial.mass.value(), |[mass, ..]| mass);
    let [xx, xy, xz, yy, yz, zz] = big(inertial.tensor.each_ref().map(Written::value));
    let half = (&xx + &yy + &zz) / Big::new(2.0);
    let zero = Big::zero;
    let central = Matrix([
        [&half - &xx, -&xy, -&xz, zero()],
        [-&xy, &half - &yy, -&yz, zero()],
        [-&xz, -&yz, &half - &zz, zero()],
        [zero(), zero(), zero(), Big::new(mass)],
    ]);
    let center = robot.field(Field::Center(body.id));
    let at = placement(&inertial.at, center, robot.reading());
    &(&at * &central) * &at.transposed()
}

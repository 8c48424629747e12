//! The robot of the printed data.
//!
//! In: the numbers that are printed for the generic recursions of the runtime. Out: a [`Robot`] of the moving joints
//! alone, for comparison with the described one.

use crate::dense::{Approximate, BodyId, Closed, DegreeOfFreedom, DenseBody, Matrix, Moved, Robot};
use crate::expression::{Arithmetic, Double};
use crate::joint::Manifold;
use crate::list::{Id, List};
use crate::module::{ChainData, DataMotion, LoopsData};
use crate::space::{CoordinateId, FrameId, VelocityId};

/// Number of values of a joint, and of a frame.
const JOINT: usize = 28;
const PLACEMENT: usize = 12;

/// The robot of some data, whose values follow one another.
pub(super) fn robot(data: &ChainData, numbers: &[Approximate]) -> Robot {
    let (joints, rest) = numbers.split_at(JOINT * data.parents.len());
    let (frames, rest) = rest.split_at(PLACEMENT * data.frames.len());
    let (gravity, actuators) = rest.split_at(3);
    let (mut coordinate, mut velocity) = (CoordinateId::new(0), VelocityId::new(0));
    // For each joint, the first of its coordinates and velocities.
    let mut places = Vec::new();
    for motion in &data.motions {
        places.push((coordinate, velocity));
        let (coordinates, velocities) = motion.counts();
        coordinate = coordinate.plus(coordinates);
        velocity = velocity.plus(velocities);
    }
    let joints = joints.chunks(JOINT).zip(&data.parents).zip(&data.motions);
    let mut bodies: List<BodyId, DenseBody> = (joints.enumerate())
        .map(|(k, ((numbers, parent), motion))| {
            let screw = [three(&numbers[12..15]), three(&numbers[15..18])];
            let along = |(coordinate, velocity), factor| {
                let degree_of_freedom = DegreeOfFreedom {
                    screw,
                    velocity,
                    factor,
                    actuator: [Approximate::exact(0.0); 3],
                };
                let moved = Moved::By {
                    screw,
                    coordinate,
                    factor,
                    offset: Approximate::exact(0.0),
                };
                (moved, vec![degree_of_freedom])
            };
            let (moved, degrees_of_freedom) = match *motion {
                DataMotion::Along => along(places[k], Approximate::exact(1.0)),
                DataMotion::Mimic {
                    mimicked,
                    multiplier,
                } => along(
                    places[usize::from(mimicked)],
                    Approximate::literal(multiplier),
                ),
                DataMotion::Manifold(manifold) => {
                    let (coordinate, velocity) = places[k];
                    let moved = Moved::Manifold(manifold, coordinate);
                    (moved, degrees_of_freedom(manifold, velocity))
                }
            };
            DenseBody {
                parent: parent.map(BodyId::from),
                placement: placement(&numbers[..PLACEMENT]),
                moved,
                degrees_of_freedom,
                inertia: inertia(&numbers[18..]),
            }
        })
        .collect();
    for (actuator, &(joint, velocity)) in actuators.chunks(3).zip(&data.actuated) {
        bodies[joint.into()].degrees_of_freedom[usize::from(velocity)].actuator = three(actuator);
    }
    let mut frame =
        |(numbers, body): (&[Approximate], Option<u16>)| Some(bodies.push(fixed(body, numbers)));
    let frames = frames.chunks(PLACEMENT).zip(&data.frames);
    let frames: List<FrameId, Option<BodyId>> = frames
        .map(|(numbers, (_, body))| frame((numbers, *body)))
        .collect();
    // Links with an external wrench come last.
    let external = frames.iter().skip(frames.len() - data.external.0);
    let external = external.copied().flatten().collect();
    Robot {
        bodies,
        velocities: velocity.index(),
        gravity: three(gravity),
        requested: frames.len() - data.external.0,
        frames,
        // The data do not contain which bodies are links.
        links: Vec::new(),
        base_columns: Vec::new(),
        identified: Vec::new(),
        spheres: List::new(),
        pairs: Vec::new(),
        loops: Vec::new(),
        elimination: Vec::new(),
        actuated: Vec::new(),
        external: (external, data.external.1),
    }
}

/// Number of values of a loop.
const LOOP: usize = 2 * PLACEMENT + 1;

/// The same with its loops, whose values are also given.
pub(super) fn closed_loops(mut robot: Robot, data: &LoopsData, numbers: &[Approximate]) -> Robot {
    for (closed, numbers) in data.loops.iter().zip(numbers.chunks(LOOP)) {
        let (placements, size) = numbers.split_at(2 * PLACEMENT);
        let ends = [0, 1].map(|end| {
            let ((_, body), numbers) = (&closed.frames[end], &placements[end * PLACEMENT..]);
            let body = robot.bodies.push(fixed(*body, &numbers[..PLACEMENT]));
            robot.frames.push(Some(body))
        });
        robot.loops.push(Closed {
            frames: ends,
            rows: closed.rows.clone(),
            size: size[0],
        });
    }
    let actuated = data.actuated.iter().enumerate();
    robot.actuated = actuated
        .filter(|(_, actuated)| **actuated)
        .map(|(k, _)| VelocityId::new(k))
        .collect();
    robot
}

/// A body fixed to another, as a frame.
fn fixed(body: Option<u16>, numbers: &[Approximate]) -> DenseBody {
    let nothing = [Approximate::exact(0.0); 3];
    DenseBody {
        parent: body.map(BodyId::from),
        placement: placement(numbers),
        moved: Moved::Held([nothing; 2], Double::ZERO),
        degrees_of_freedom: Vec::new(),
        inertia: Matrix::zero(),
    }
}

/// The degrees of freedom of a joint without an axis of its own: along the axes of its moved frame.
fn degrees_of_freedom(manifold: Manifold, first: VelocityId) -> Vec<DegreeOfFreedom> {
    let screws: &[usize] = match manifold {
        Manifold::Planar => &[3, 4, 2],
        Manifold::Spherical => &[0, 1, 2],
        Manifold::Floating => &[3, 4, 5, 0, 1, 2],
    };
    let screws = screws.iter().enumerate();
    screws
        .map(|(k, &entry)| {
            let mut screw = [[Approximate::exact(0.0); 3]; 2];
            screw[entry / 3][entry % 3] = Approximate::exact(1.0);
            DegreeOfFreedom {
                screw,
                velocity: first.plus(k),
                factor: Approximate::exact(1.0),
                actuator: [Approximate::exact(0.0); 3],
            }
        })
        .collect()
}

fn three(numbers: &[Approximate]) -> [Approximate; 3] {
    [0, 1, 2].map(|k| numbers[k])
}

fn placement(numbers: &[Approximate]) -> Matrix<Approximate> {
    let mut placement = Matrix::identity();
    for (row, numbers) in placement.0.iter_mut().zip(numbers.chunks(4)) {
        row.copy_from_slice(numbers);
    }
    placement
}

/// J from xx, yy, zz, xy, xz, yz; the first moments; the mass.
fn inertia(numbers: &[Approximate]) -> Matrix<Approximate> {
    let place = |row: usize, column: usize| match (row.min(column), row.max(column)) {
        (0, 0) => 0,
        (1, 1) => 1,
        (2, 2) => 2,
        (0, 1) => 3,
        (0, 2) => 4,
        (1, 2) => 5,
        (3, 3) => 9,
        (k, _) => 6 + k,
    };
    Matrix([0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| numbers[place(row, column)])))
}

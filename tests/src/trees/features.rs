//! Features of robots that are difficult for the generator.
//!
//! In: a [`Robot`], number by number. Out: the names of its features, from the list in [`grow`](super::grow). They are
//! found from what is written, not from how it was drawn.

use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::motion::Motion;

use super::dense::Dense;
use super::movement::Movement;
use super::robot::{Body, Field, FrontEnd, Inertial, Kind, Placement, Robot};
use super::written::{Reading, Written};

/// A name, and a function that returns true if a robot has the feature.
type Feature = (&'static str, fn(&Robot) -> bool);

/// All features.
pub const FEATURES: [Feature; 79] = [
    ("a joint with an actuator", |robot| {
        robot.actuators().next().is_some()
    }),
    ("a mimic joint with an actuator", |robot| {
        let mut actuators = robot.actuators();
        actuators.any(|(id, _)| {
            robot
                .body(id)
                .is_some_and(|body| robot.mimicked(body).is_some())
        })
    }),
    ("an external wrench on a link, in its frame", |robot| {
        robot.acted_on().next().is_some() && !robot.options.external.1
    }),
    ("an external wrench on a link, in frame 0", |robot| {
        robot.acted_on().next().is_some() && robot.options.external.1
    }),
    ("a residue in an offset", |robot| {
        any(robot, |body| residue(&body.at.xyz))
    }),
    ("a residue in roll, pitch and yaw", |robot| {
        any(robot, |body| residue(&body.at.rpy))
    }),
    ("a residue in an axis", |robot| {
        any(robot, |body| residue(&body.axis))
    }),
    ("an axis of another length than 1", |robot| {
        any(robot, |body| !(0.98..1.02).contains(&size(&body.axis)))
    }),
    ("a residue in an axis of another length", |robot| {
        let residue = |body: &Body| {
            let length = size(&body.axis);
            let small = |entry: f64| entry != 0.0 && entry.abs() < 1e-5 * length;
            let other = !(0.98..1.02).contains(&length);
            other && body.axis.iter().any(|word| small(word.value()))
        };
        any(robot, residue)
    }),
    ("a number that is computed", |robot| {
        let computed = |word: &Written| word.to_string().contains('/') && !right(word);
        let mut offsets = robot.bodies.iter().flat_map(|body| &body.at.xyz);
        offsets.any(computed) || angle(robot, computed)
    }),
    ("a residue in a centre of mass", |robot| {
        weighs(robot, |inertial| residue(&inertial.at.xyz))
    }),
    ("a residue in the axes of an inertia", |robot| {
        weighs(robot, |inertial| residue(&inertial.at.rpy))
    }),
    ("a residue in a product of inertia", |robot| {
        weighs(robot, |inertial| residue(&inertial.tensor))
    }),
    (
        "a placement that a fixed joint inverts but for rounding",
        inverted,
    ),
    ("a right angle of 2 to 4 decimals", |robot| {
        angle(robot, |word| right(word) && decimals(word) <= 4)
    }),
    ("a right angle of 5 to 13 decimals", |robot| {
        angle(robot, |word| {
            right(word) && (5..14).contains(&decimals(word))
        })
    }),
    ("a right angle of 14 decimals and more", |robot| {
        angle(robot, |word| right(word) && decimals(word) >= 14)
    }),
    ("a right angle by pi", |robot| {
        angle(robot, |word| word.to_string().contains("pi"))
    }),
    ("a right angle in parts", parts),
    ("thousands of right angles", |robot| {
        angle(robot, |word| right(word) && word.value().abs() > 100.0)
    }),
    ("a huge angle", |robot| {
        angle(robot, |word| word.value().abs() > 1000.0)
    }),
    ("an angle near a right one", |robot| {
        angle(robot, near_right)
    }),
    ("coaxial joints", |robot| {
        pair(robot, |pair| pair.parallel && pair.meet)
    }),
    ("parallel joints", |robot| {
        pair(robot, |pair| {
            pair.parallel && !pair.meet && pair.cosine > 0.0
        })
    }),
    ("antiparallel joints", |robot| {
        pair(robot, |pair| pair.parallel && pair.cosine < 0.0)
    }),
    ("intersecting joints", |robot| {
        pair(robot, |pair| !pair.parallel && pair.meet)
    }),
    ("skew joints", |robot| {
        pair(robot, |pair| !pair.parallel && !pair.meet)
    }),
    ("nearly parallel joints", |robot| {
        pair(robot, |pair| pair.nearly && !pair.parallel)
    }),
    ("a link without inertial", |robot| {
        any(robot, |body| body.inertial.is_none())
    }),
    ("a massless link in the middle", |robot| {
        any(robot, |body| massless(body) && carries(robot, body))
    }),
    ("a point mass", |robot| {
        weighs(robot, |inertial| {
            !inertial.mass.is_zero() && inertial.tensor.iter().all(Written::is_zero)
        })
    }),
    ("a thin rod", |robot| weighs(robot, rod)),
    ("a revolute joint", |robot| {
        any(robot, |body| body.kind == Kind::Revolute)
    }),
    ("a continuous joint", |robot| {
        any(robot, |body| body.kind == Kind::Continuous)
    }),
    ("a prismatic joint", |robot| {
        any(robot, |body| body.kind == Kind::Prismatic)
    }),
    ("a screw", |robot| {
        any(robot, |body| matches!(body.kind, Kind::Screw(_)))
    }),
    ("a cylindrical joint", |robot| {
        any(robot, |body| body.kind == Kind::Cylindrical)
    }),
    ("a universal joint", |robot| {
        any(robot, |body| matches!(body.kind, Kind::Universal(_)))
    }),
    ("a translation", |robot| {
        any(robot, |body| body.kind == Kind::Translation)
    }),
    ("a planar joint", |robot| {
        any(robot, |body| body.kind == Kind::Planar)
    }),
    ("a spherical joint", |robot| {
        any(robot, |body| body.kind == Kind::Spherical)
    }),
    ("a floating joint", |robot| {
        any(robot, |body| body.kind == Kind::Floating)
    }),
    ("a floating base", |robot| robot.options.floating),
    (
        "a floating base, and a joint that has several velocities",
        |robot| robot.options.floating && any(robot, |body| body.kind.entries()[1].len() > 1),
    ),
    ("a mimic joint", |robot| {
        mimics(robot, |_, movement| matches!(movement, Movement::As { .. }))
    }),
    ("a mimic joint of a mimic joint", |robot| {
        mimics(robot, |body, movement| {
            let moves = matches!(movement, Movement::As { .. });
            moves && robot.mimic_chain(body).count() > 2
        })
    }),
    ("a mimic joint of one outboard of itself", |robot| {
        mimics(robot, |body, movement| match movement {
            Movement::As { mimicked, .. } => robot.upwards(*mimicked).any(|link| link == body.id),
            _ => false,
        })
    }),
    ("a mimic joint of one in another branch", |robot| {
        mimics(robot, |body, movement| match movement {
            Movement::As { mimicked, .. } => {
                let above = |one: usize, other: usize| robot.upwards(one).any(|id| id == other);
                !above(*mimicked, body.id) && !above(body.id, *mimicked)
            }
            _ => false,
        })
    }),
    ("two mimic joints of one", |robot| {
        let mimicked = |body: &Body| match Movement::of(robot, body) {
            Movement::As { mimicked, .. } => Some(mimicked),
            _ => None,
        };
        let mut mimicked: Vec<usize> = robot.bodies.iter().filter_map(mimicked).collect();
        let count = mimicked.len();
        mimicked.sort_unstable();
        mimicked.dedup();
        mimicked.len() < count
    }),
    ("a mimic joint of a locked one", |robot| {
        mimics(robot, |body, movement| {
            let mut mimicked = robot.mimic_chain(body);
            let locked = mimicked.any(|mimicked| robot.locked(mimicked).is_some());
            locked && !movement.is_motion()
        })
    }),
    ("a mimic joint of one that is not modelled", |robot| {
        mimics(robot, |body, _| {
            robot
                .mimic_chain(body)
                .any(|mimicked| !robot.models(mimicked.id))
        })
    }),
    ("a locked mimic joint", |robot| {
        any(robot, |body| {
            body.mimic.is_some() && robot.locked(body).is_some() && robot.models(body.id)
        })
    }),
    ("a path moved by a joint beside it", |robot| {
        let path = robot.options.tip.filter(|_| robot.options.path_only);
        path.is_some_and(|tip| {
            robot
                .moving()
                .any(|id| !robot.upwards(tip).any(|link| link == id))
        })
    }),
    ("two fixed joints in a row", |robot| {
        any(robot, |body| {
            fixed(body) && robot.body(body.parent).is_some_and(fixed)
        })
    }),
    ("15 joints or more", |robot| robot.bodies.len() >= 15),
    ("another base", |robot| robot.options.base > 0),
    ("an end effector", |robot| robot.options.tip.is_some()),
    ("a further frame", |robot| !robot.options.frames.is_empty()),
    ("the path alone", |robot| robot.options.path_only),
    ("a joint locked at zero", |robot| {
        robot.options.lock.iter().any(|(_, at)| at.is_none())
    }),
    ("a joint locked elsewhere", |robot| {
        robot.options.lock.iter().any(|(_, at)| at.is_some())
    }),
    ("a dropped link", |robot| !robot.options.drop.is_empty()),
    ("angles as written", |robot| robot.options.exact),
    ("no gravity", |robot| gravity(robot, true)),
    ("an odd gravity", |robot| gravity(robot, false)),
    ("a field for a mass", |robot| {
        field(robot, |field| matches!(field, Field::Mass(_)))
    }),
    ("a field for a centre of mass", |robot| {
        field(robot, |field| matches!(field, Field::Center(_)))
    }),
    ("a field for an inertia", |robot| {
        field(robot, |field| matches!(field, Field::Inertia(_)))
    }),
    ("a field for a payload", |robot| {
        field(robot, |field| matches!(field, Field::Payload(_)))
    }),
    ("a field for a placement", |robot| {
        field(robot, |field| matches!(field, Field::Placement(_)))
    }),
    ("a field for an origin", |robot| {
        field(robot, |field| matches!(field, Field::Origin(_)))
    }),
    ("a field for gravity", |robot| {
        field(robot, |field| field == Field::Gravity)
    }),
    ("read as URDF", |robot| robot.front_end == FrontEnd::Urdf),
    ("read as tokens", |robot| {
        robot.front_end == FrontEnd::Inline
    }),
    ("numbers without text", |robot| {
        robot.front_end == FrontEnd::Computed
    }),
    ("lengths of 1e3", |robot| {
        any(robot, |body| {
            body.at.xyz.iter().any(|word| word.value().abs() > 50.0)
        })
    }),
    ("lengths of 1e-3", |robot| Dense::of(robot).reach < 0.05),
    ("masses of 1e3", |robot| {
        weighs(robot, |inertial| inertial.mass.value() > 50.0)
    }),
    ("no residue at all", is_plain),
];

/// True if a robot has no residue.
#[must_use]
pub fn is_plain(robot: &Robot) -> bool {
    robot.bodies.iter().all(plain)
}

fn any(robot: &Robot, has: impl Fn(&Body) -> bool) -> bool {
    robot.bodies.iter().any(has)
}

/// True for a modelled mimic joint with this property.
fn mimics(robot: &Robot, has: impl Fn(&Body, &Movement) -> bool) -> bool {
    any(robot, |body| {
        let is = robot.models(body.id) && robot.mimicked(body).is_some();
        is && has(body, &Movement::of(robot, body))
    })
}

fn weighs(robot: &Robot, has: impl Fn(&Inertial) -> bool) -> bool {
    let mut inertials = robot
        .bodies
        .iter()
        .filter_map(|body| body.inertial.as_ref());
    inertials.any(has)
}

fn is_residue(word: &Written) -> bool {
    let size = word.value().abs();
    size > 0.0 && size < 1e-5
}

fn size(axis: &[Written; 3]) -> f64 {
    let squares = axis.iter().map(|entry| entry.value() * entry.value());
    squares.sum::<f64>().sqrt()
}

fn residue(words: &[Written]) -> bool {
    words.iter().any(is_residue)
}

fn plain(body: &Body) -> bool {
    let mut body = body.clone();
    let placed = |at: &mut Placement| at.numbers().any(|word| is_residue(word));
    let weighed = body
        .inertial
        .as_mut()
        .is_some_and(|inertial| placed(&mut inertial.at) || residue(&inertial.tensor));
    let length = size(&body.axis);
    let small = |word: &Written| !word.is_zero() && word.value().abs() < 1e-5 * length;
    !weighed && !placed(&mut body.at) && !body.axis.iter().any(small)
}

/// True for an angle of a joint or of an inertia with this property.
fn angle(robot: &Robot, has: impl Fn(&Written) -> bool) -> bool {
    let of = |at: &Placement| {
        let turns = at.turns.iter().map(|(_, angle)| angle);
        at.rpy.iter().chain(turns).any(&has)
    };
    any(robot, |body| of(&body.at)) || weighs(robot, |inertial| of(&inertial.at))
}

fn right(word: &Written) -> bool {
    word.quarters(Reading::Digits).is_some()
}

fn decimals(word: &Written) -> usize {
    let word = word.to_string();
    word.split_once('.').map_or(0, |(_, rest)| rest.len())
}

fn near_right(word: &Written) -> bool {
    let off = (word.value().abs() - std::f64::consts::FRAC_PI_2).abs();
    off < 1e-2 && !right(word)
}

/// True if a fixed joint and the one behind it together are the identity but for rounding.
fn inverted(robot: &Robot) -> bool {
    any(robot, |body| {
        let Some(carrier) = robot.body(body.parent).filter(|body| fixed(body)) else {
            return false;
        };
        let [first, second] = [carrier, body].map(|body| placement(robot, body.id));
        let (Some(first), Some(second)) = (first, second) else {
            return false;
        };
        let both = &(&first * &second) - &Matrix::identity();
        let most = |matrix: &Matrix| largest(matrix.0.iter().flatten());
        let scale = largest(&first.column());
        scale > 0.0 && most(&both) > 0.0 && most(&both) < 1e-14 * scale.max(1.0)
    })
}

fn placement(robot: &Robot, id: usize) -> Option<Matrix> {
    let dense = Dense::of(robot);
    let body = dense.body(id)?;
    Some(dense.robot.bodies[body].placement.clone())
}

fn largest<'b>(entries: impl IntoIterator<Item = &'b Big>) -> f64 {
    let sizes = entries.into_iter().map(|entry| entry.abs().to_f64());
    sizes.fold(0.0, f64::max)
}

/// True for half or a third of a right angle, twice about the same axis.
fn parts(robot: &Robot) -> bool {
    let part = |word: &Written| {
        let part = word.value().abs();
        let of = |whole: f64| (part - whole).abs() < 1e-4;
        of(std::f64::consts::FRAC_PI_4) || of(std::f64::consts::FRAC_PI_6)
    };
    any(robot, |body| {
        let turns = &body.at.turns;
        let in_turns = turns.len() > 1 && turns[0] == turns[1] && part(&turns[0].1);
        let carrier = robot.body(body.parent);
        let in_row = carrier.is_some_and(|carrier| {
            let pairs = carrier.at.rpy.iter().zip(&body.at.rpy);
            pairs
                .into_iter()
                .any(|(one, other)| one == other && part(one))
        });
        in_turns || in_row
    })
}

/// Relation of a joint's axis to that of the joint before it.
struct Pair {
    /// Parallel to 1e-12.
    parallel: bool,
    /// Parallel to 1e-4.
    nearly: bool,
    /// Intersecting to 1e-9 of the robot's size.
    meet: bool,
    cosine: f64,
}

fn pair(robot: &Robot, has: impl Fn(&Pair) -> bool) -> bool {
    let dense = Dense::of(robot);
    let bodies = &dense.robot.bodies;
    // For each body, its pose where all joints are at zero; its axis: direction and point.
    let mut poses: Vec<Matrix> = Vec::new();
    for body in bodies {
        let parent = body
            .parent
            .map_or_else(Matrix::identity, |at| poses[at].clone());
        poses.push(&parent * &body.placement);
    }
    let axis = |body: usize, screw: &Matrix| {
        let l = &(&poses[body] * screw) * &poses[body].inverse();
        let [rotation, translation] = [l.vector(), l.column()].map(|v| v.map(|x| x.to_f64()));
        let point = poses[body].column().map(|x| x.to_f64());
        (
            if rotation == [0.0; 3] {
                translation
            } else {
                rotation
            },
            point,
        )
    };
    let moved = |body: usize| match &bodies[body].motion {
        Motion::Along { screw, .. } => Some(axis(body, screw)),
        _ => None,
    };
    let pairs = (0..bodies.len()).filter_map(|body| {
        let mut before = dense.robot.upwards(Some(body)).skip(1);
        Some((before.find_map(moved)?, moved(body)?))
    });
    pairs.into_iter().any(|((u, from), (v, to))| {
        let normal = cross(u, v);
        let offset: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
        let near = 1e-9 * dense.reach.max(f64::MIN_POSITIVE);
        let parallel = length(normal) < 1e-12;
        has(&Pair {
            parallel,
            nearly: length(normal) < 1e-4,
            meet: if parallel {
                length(cross(offset, u)) <= near
            } else {
                dot(offset, normal).abs() <= near
            },
            cosine: dot(u, v),
        })
    })
}

fn cross([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> [f64; 3] {
    [y * c - z * b, z * a - x * c, x * b - y * a]
}

fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u.iter().zip(v).map(|(x, y)| x * y).sum()
}

fn length(u: [f64; 3]) -> f64 {
    dot(u, u).sqrt()
}

fn fixed(body: &Body) -> bool {
    body.kind == Kind::Fixed
}

fn massless(body: &Body) -> bool {
    let inertial = body.inertial.as_ref();
    inertial.is_none_or(|inertial| inertial.mass.is_zero())
}

fn carries(robot: &Robot, body: &Body) -> bool {
    any(robot, |other| other.parent == body.id)
}

/// True for an inertia with one zero moment.
fn rod(inertial: &Inertial) -> bool {
    let diagonal = [0, 3, 5].map(|k| inertial.tensor[k].is_zero());
    diagonal.into_iter().filter(|zero| *zero).count() == 1
}

fn gravity(robot: &Robot, none: bool) -> bool {
    let given = robot.options.gravity.as_ref();
    given.is_some_and(|gravity| gravity.iter().all(Written::is_zero) == none)
}

fn field(robot: &Robot, is: impl Fn(Field) -> bool) -> bool {
    robot.options.fields.iter().any(|(field, _)| is(*field))
}

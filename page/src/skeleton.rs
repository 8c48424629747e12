//! The skeleton of a robot as data of the page: bodies, frames of links, frames of functions.
//!
//! Bodies are those of the chain, in the frames of the description; every link that is not left out is fixed to one of
//! them. The page moves the joints.

use serde_json::{Value, json};

use homogen_codegen::chain::{self, BodyId, Chain, Joint, Position};
use homogen_codegen::closure::ResidualKind;
use homogen_codegen::description::{Axis, Inertial, Name, Step};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::{Double, Expr, Graph, Term};
use homogen_codegen::joint::Motion;
use homogen_codegen::layout::Layout;
use homogen_codegen::list::{Id, List};
use homogen_codegen::matrix::{Pose, Rotation};
use homogen_codegen::module::Module;
use homogen_codegen::plan::arranged;
use homogen_codegen::quaternion::normalize;
use homogen_codegen::request::Request;
use homogen_codegen::space::{CoordinateId, Entry, Kind, Variable};

/// The skeleton of a robot.
///
/// # Errors
/// If a link has no frame in the chain.
pub fn skeleton(chain: &Chain) -> Result<Value, Errors> {
    let description = &chain.description;
    let with_all_frames = with_all_frames(chain)?;
    let bodies = chain.joints.iter().map(|joint| body(chain, joint));
    let links = with_all_frames.frames.iter().map(|frame| {
        let carrier = (description.joints.iter()).find(|joint| joint.child.text == frame.name);
        let link = (description.links.iter()).find(|link| link.name.text == frame.name);
        let inertial = link.and_then(|link| link.inertial.as_ref());
        json!({
            "name": frame.name,
            "body": frame.body.map(Id::index),
            "place": place(&with_all_frames.graph, frame.placement),
            "parent": carrier.map(|joint| &joint.parent.text),
            "joint": carrier.map(|joint| &joint.name.text),
            "mass": inertial.map(|inertial| inertial.mass.value),
            "center": inertial.map(|inertial| placed(inertial).0),
            "inertia": inertial.map(inertia),
        })
    });
    let loops = chain.loops.iter().map(|closed| {
        let ends = closed.frames.iter();
        let ends = ends
            .map(|end| json!({ "body": end.body.map(Id::index), "place": place(&chain.graph, end.placement) }));
        let rows = closed.rows.iter().map(|row| match *row {
            ResidualKind::Along(k) => json!(["along", k]),
            ResidualKind::Product(i, j) => json!(["product", i, j]),
            ResidualKind::Inclined => json!(["inclined"]),
            ResidualKind::Distance => json!(["distance"]),
        });
        json!({
            "name": closed.name, "kind": closed.word, "ends": ends.collect::<Value>(),
            "rows": rows.collect::<Value>(), "size": number(&chain.graph, closed.size),
        })
    });
    let spaces = chain.spaces();
    Ok(json!({
        "base": chain.report.base,
        "bodies": bodies.collect::<Value>(),
        "links": links.collect::<Value>(),
        "loops": loops.collect::<Value>(),
        "coordinates": coordinates(chain),
        "velocities": entries(&spaces.velocities, Variable::Qd).collect::<Value>(),
    }))
}

/// The coordinates, each with its joint.
fn coordinates(chain: &Chain) -> Value {
    let coordinates = &chain.spaces().coordinates;
    let entries = coordinates.ids().zip(entries(coordinates, Variable::Q));
    let entries = entries.map(|(coordinate, mut entry)| {
        entry["joint"] = json!(joint_of(chain, coordinate));
        entry
    });
    entries.collect()
}

/// The name of the joint that has a coordinate.
fn joint_of(chain: &Chain, coordinate: CoordinateId) -> Option<&str> {
    let mimics = |joint: &Joint| {
        let mut mimicked = chain.report.mimicked.iter();
        mimicked.any(|mimic| mimic.joint == joint.of)
    };
    let moves = |joint: &&Joint| match joint.position {
        Position::Along {
            coordinate: own, ..
        } => own == coordinate && !mimics(joint),
        Position::Manifold(manifold, first) => {
            (first..first.plus(manifold.coordinates().len())).contains(&coordinate)
        }
        Position::Taken => false,
    };
    chain.joints.iter().find(moves).map(|joint| &*joint.of)
}

/// The chain with the frames of all links that are not left out.
fn with_all_frames(chain: &Chain) -> Result<Chain, Errors> {
    let frames = chain.report.links.iter().cloned().map(Name::from);
    let request = Request {
        frames: frames.collect(),
        ..(*chain.request).clone()
    };
    let mut with_all_frames = chain::build(&chain.description, &request)?;
    let tip = usize::from(with_all_frames.has_tip);
    with_all_frames.frames = with_all_frames.frames.into_iter().skip(tip).collect();
    Ok(with_all_frames)
}

/// A body that moves relative to another, by one velocity.
fn body(chain: &Chain, joint: &Joint) -> Value {
    let number = |expr: Expr| number(&chain.graph, expr);
    let by = match joint.position {
        Position::Along { coordinate, factor } => {
            json!({ "coordinate": coordinate.index(), "factor": number(factor) })
        }
        Position::Manifold(manifold, coordinate) => {
            json!({ "coordinate": coordinate.index(), "manifold": manifold.word() })
        }
        Position::Taken => Value::Null,
    };
    let (rotates, translates) = match joint.motion {
        Motion::Revolute => (1.0, 0.0),
        Motion::Prismatic => (0.0, 1.0),
        Motion::Screw(pitch) => (1.0, number(pitch)),
    };
    json!({
        "name": joint.name,
        "joint": joint.of,
        "link": joint.link.as_ref().map(|(link, _)| link),
        "parent": joint.parent.map(Id::index),
        "place": place(&chain.graph, joint.placement),
        "axis": joint.axis.0.map(number),
        "rotates": rotates,
        "translates": translates,
        "by": by,
        "velocity": joint.velocity.index(),
    })
}

/// The entries of a space, named as those of a variable.
fn entries(entries: &[Entry], variable: Variable) -> impl Iterator<Item = Value> {
    entries.iter().map(move |entry| {
        let kind = match entry.kind {
            Kind::Rotation => "rotation",
            Kind::Translation => "translation",
            Kind::Quaternion => "quaternion",
            _ => "parameter",
        };
        json!({
            "name": entry.name, "kind": kind, "unit": variable.unit(entry.kind),
            "range": entry.range,
        })
    })
}

/// Frames of functions.
pub struct Layouts {
    /// For each function, the index of its layout.
    pub of: Vec<usize>,
    /// For each layout, the frame of each body relative to that of the description.
    pub places: Vec<Value>,
}

/// The frames of the functions of a module; layouts with the same frames are merged.
#[must_use]
pub fn layouts(chain: &Chain, module: &Module) -> Layouts {
    let mut known: Vec<(Layout, usize)> = Vec::new();
    let mut places: Vec<Value> = Vec::new();
    let of = module.functions.iter().map(|generated| {
        if let Some((_, index)) = known.iter().find(|(layout, _)| *layout == generated.layout) {
            return *index;
        }
        let chosen = chosen(chain, generated.layout);
        let same = places.iter().position(|other| *other == chosen);
        let index = same.unwrap_or_else(|| {
            places.push(chosen);
            places.len() - 1
        });
        known.push((generated.layout, index));
        index
    });
    let of = of.collect();
    Layouts { of, places }
}

/// The frame of each body in a layout, relative to the body's own frame. Both are fixed to the body, so their poses at
/// rest suffice.
fn chosen(chain: &Chain, layout: Layout) -> Value {
    let graph = chain.graph.clone();
    let bodies = arranged(&graph, chain, layout);
    let mut own: List<BodyId, Pose<Term<'_>>> = List::new();
    let mut laid: List<BodyId, Pose<Term<'_>>> = List::new();
    for (joint, body) in chain.joints.iter().zip(&bodies.bodies) {
        let rotation = match body.offset {
            Some(offset) => Pose::rotation(Rotation::about_z(offset)),
            None => Pose::identity(&graph),
        };
        let [mut here, mut there] = [
            joint.placement.map(|entry| graph.term(entry)),
            body.placement * rotation,
        ];
        if let Some(parent) = joint.parent {
            (here, there) = (own[parent] * here, laid[parent] * there);
        }
        own.push(here);
        laid.push(there);
    }
    let places = own.into_iter().zip(laid);
    let places = places.map(|(own, laid)| place(&graph, (own.inverse() * laid).map(Term::expr)));
    places.collect()
}

/// Rows 1 to 3 of a constant matrix.
fn place(graph: &Graph, pose: Pose<Expr>) -> Value {
    let entries = pose.entries().into_iter();
    entries.map(|entry| number(graph, entry)).collect()
}

/// A constant number: the command line has no fields here.
fn number(graph: &Graph, expr: Expr) -> f64 {
    graph.value(expr).map_or(0.0, Double::to_f64)
}

/// The inertia tensor about the centre of mass in the axes of the link [kg m²], xx, xy, xz, yy, yz, zz, in the precision
/// of a drawing.
fn inertia(inertial: &Inertial) -> [f64; 6] {
    let (_, axes) = placed(inertial);
    let [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(|entry| entry.value);
    let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let turned = |i: usize, j: usize| {
        let terms = (0..3).flat_map(|k| (0..3).map(move |l| (k, l)));
        terms
            .map(|(k, l)| axes[k][i] * tensor[k][l] * axes[l][j])
            .sum()
    };
    [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(i, j)| turned(i, j))
}

/// The centre of mass of a link in its frame \[m\], and the axes of the inertia tensor, in the precision of a drawing.
fn placed(inertial: &Inertial) -> ([f64; 3], [[f64; 3]; 3]) {
    let (zero, one) = (Double::from(0.0), Double::from(1.0));
    let center = moved(inertial, [zero; 3]);
    let axis = |k: usize| {
        let mut end = [zero; 3];
        end[k] = one;
        let end = moved(inertial, end);
        std::array::from_fn(|row| (end[row] - center[row]).to_f64())
    };
    (center.map(Double::to_f64), [0, 1, 2].map(axis))
}

/// A point of the frame of the inertia tensor in the frame of the link.
fn moved(inertial: &Inertial, mut point: [Double; 3]) -> [Double; 3] {
    for step in inertial.origin.iter().rev() {
        match step {
            Step::Translate(offset) => {
                for (entry, offset) in point.iter_mut().zip(offset) {
                    *entry = *entry + Double::from(offset.value);
                }
            }
            Step::Rotate(axis, angle) => {
                let (sine, cosine) = Double::from(angle.value).sin_cos();
                let [a, b] = match axis {
                    Axis::X => [1, 2],
                    Axis::Y => [2, 0],
                    Axis::Z => [0, 1],
                };
                (point[a], point[b]) = (
                    point[a] * cosine - point[b] * sine,
                    point[a] * sine + point[b] * cosine,
                );
            }
            Step::Quaternion(entries) => {
                let mut entries = entries.map(|entry| Double::from(entry.value));
                normalize(&mut entries);
                let [x, y, z, w] = entries;
                let cross = |[a, b, c]: [Double; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
                let once = cross(point);
                let twice = cross(once);
                let two = Double::from(2.0);
                point = std::array::from_fn(|k| point[k] + two * (w * once[k] + twice[k]));
            }
        }
    }
    point
}

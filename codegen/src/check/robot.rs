//! The robot as described: every link a body, every joint at its placement, nothing merged.
//!
//! In: the description and the request of a chain, and the chain's report: the order of q and the numbers that were
//! taken for right angles or zero. Out: a [`Robot`] whose placements are products of the described elementary motions.
//! It shares no step with [`crate::chain`], whose merging, locking and cutting are checked here; a correction in the
//! report is checked against the digits of its number.

mod closure;
mod collision;
mod inertia;
mod joint;
mod matrices;
mod motion;
mod written;

use std::collections::HashMap;

use crate::chain::Chain;
use crate::chain::base_parameters::BaseParameters;
use crate::dense::{Approximate, BodyId, DegreeOfFreedom, DenseBody, Matrix, Moved, Robot};
use crate::description::{Description, Joint, LinkId, Name};
use crate::expression::{Arithmetic, Double};
use crate::list::{Id, List};
use crate::request::Request;
use crate::space::{CoordinateId, FieldId, FrameId, Kind, Space, VelocityId};

/// A disagreement of description and chain.
#[derive(Debug)]
pub(super) struct Contradiction(pub(super) String);

/// The robot with some values of its fields.
pub(super) fn robot(
    chain: &Chain,
    fields: &List<FieldId, Vec<f64>>,
) -> Result<Robot, Contradiction> {
    let (description, request) = (&*chain.description, &*chain.request);
    let reader = RobotReader::of(chain, fields);
    let links: HashMap<&str, LinkId> =
        places(description.links.iter().map(|link| link.name.text.as_str()));
    let spaces = chain.spaces();
    let coordinates = places(spaces.names(Space::Coordinates));
    let velocities = places(spaces.names(Space::Velocities));
    let base = match &request.base {
        Some(base) => base.text.as_str(),
        None => &chain.report.base,
    };
    let kept = reader.kept(base, &links);
    let tip = chain.frames.first().filter(|_| chain.has_tip);
    let path = reader.path(tip.map(|tip| tip.name.as_str()));

    let mut bodies: List<BodyId, DenseBody> = List::new();
    let mut attached: HashMap<&str, BodyId> = HashMap::new();
    if let Some(placement) = reader.base() {
        attached.insert(base, bodies.push(fixed(None, placement)));
    }
    let mut moving = 0;
    let places = Places {
        coordinates: &coordinates,
        velocities: &velocities,
    };
    // The bodies that a joint moves, by its child link.
    let mut moved: HashMap<&str, Vec<BodyId>> = HashMap::new();
    for &joint in &kept {
        let before = bodies.len();
        let place = (
            attached.get(joint.parent.text.as_str()).copied(),
            reader.origin(joint)?,
        );
        let motion = reader.motion(joint, &kept, &path);
        let own = matches!(motion, JointCoordinate::Own);
        let of_joint = joint.kind.coordinates(&joint.name.text);
        let is_listed = |(name, _): &(String, Kind)| coordinates.contains_key(name.as_str());
        if joint.kind.moves() && of_joint.iter().all(is_listed) != own {
            let name = &joint.name.text;
            return Err(Contradiction(format!("whether joint {name} moves")));
        }
        moving += if own {
            joint.kind.degrees_of_freedom().len()
        } else {
            0
        };
        // The last body of a joint is the link; the others have no mass.
        let link = match joint.kind.manifold() {
            Some(manifold) if own => reader.placed(joint, manifold, place, &places, &mut bodies)?,
            _ => reader.in_series(joint, motion, place, &places, &mut bodies)?,
        };
        let child = joint.child.text.as_str();
        bodies[link].inertia = reader.inertia(&description[links[child]])?;
        attached.insert(child, link);
        moved.insert(child, bodies.ids().skip(before).collect());
    }
    if moving != spaces.velocities.len() {
        return Err(Contradiction("how many joints move".to_owned()));
    }
    let frames = chain.frames.iter().chain(&chain.external);
    let mut frames: List<FrameId, Option<BodyId>> = frames
        .map(|frame| attached.get(frame.name.as_str()).copied())
        .collect();
    let actuated = actuated(request, &kept, &velocities)?;
    let loops = reader.loops(chain, &attached, &mut bodies, &mut frames)?;
    let spheres = reader.spheres(chain, &attached, &mut bodies, &mut frames)?;
    let on = |name: &Name| attached.get(name.text.as_str()).copied();
    let external: Option<Vec<BodyId>> = request.external.iter().map(on).collect();
    let external = external.ok_or_else(|| Contradiction("what is acted on".to_owned()))?;
    Ok(Robot {
        bodies,
        velocities: moving,
        gravity: reader.gravity(),
        frames,
        requested: chain.frames.len(),
        spheres,
        pairs: chain.pairs.clone(),
        loops,
        elimination: chain.elimination.clone(),
        actuated,
        base_columns: (chain.base_parameters.iter())
            .flat_map(BaseParameters::columns)
            .collect(),
        identified: (chain.joints.iter())
            .filter(|_| chain.identifies_actuators)
            .filter_map(|joint| moved.get(joint.link.as_ref()?.0.as_str()).cloned())
            .collect(),
        links: (chain.joints.iter())
            .filter_map(|joint| attached.get(joint.link.as_ref()?.0.as_str()).copied())
            .collect(),
        external: (external, request.external_in_frame_0),
    })
}

/// The velocities of the actuated joints.
fn actuated(
    request: &Request,
    kept: &[&Joint],
    velocities: &HashMap<&str, VelocityId>,
) -> Result<Vec<VelocityId>, Contradiction> {
    let mut actuated = Vec::new();
    for joint in kept {
        let mut named = request.actuated.iter();
        if named.any(|name| name.text == joint.name.text) {
            for (name, _) in joint.kind.velocities(&joint.name.text) {
                actuated.push(place(velocities, &name)?);
            }
        }
    }
    Ok(actuated)
}

fn places<'n, I: Id>(names: impl Iterator<Item = &'n str>) -> HashMap<&'n str, I> {
    names.zip((0..).map(I::new)).collect()
}

/// The numbers of coordinates and velocities, by name.
struct Places<'p> {
    coordinates: &'p HashMap<&'p str, CoordinateId>,
    velocities: &'p HashMap<&'p str, VelocityId>,
}

impl Places<'_> {
    /// A body that the coordinate with a name moves along a screw, times a factor and from an offset on.
    fn along(
        &self,
        name: &str,
        screw: [[Approximate; 3]; 2],
        (factor, offset): (Approximate, Approximate),
    ) -> Result<DenseBody, Contradiction> {
        Ok(DenseBody {
            parent: None,
            placement: Matrix::identity(),
            moved: Moved::By {
                screw,
                coordinate: place(self.coordinates, name)?,
                factor,
                offset,
            },
            degrees_of_freedom: vec![DegreeOfFreedom {
                screw,
                velocity: place(self.velocities, name)?,
                factor,
                actuator: [Approximate::literal(0.0); 3],
            }],
            inertia: Matrix::zero(),
        })
    }
}

fn place<I: Id>(places: &HashMap<&str, I>, name: &str) -> Result<I, Contradiction> {
    let place = places.get(name).copied();
    place.ok_or_else(|| Contradiction(format!("what is called {name}")))
}

/// A body that is fixed to another one, or to frame 0.
fn fixed(parent: Option<BodyId>, placement: Matrix<Approximate>) -> DenseBody {
    let nothing = [[Approximate::literal(0.0); 3]; 2];
    held(parent, placement, nothing, Double::ZERO)
}

/// A body that is held at a coordinate along a screw.
fn held(
    parent: Option<BodyId>,
    placement: Matrix<Approximate>,
    screw: [[Approximate; 3]; 2],
    at: Double,
) -> DenseBody {
    DenseBody {
        parent,
        placement,
        moved: Moved::Held(screw, at),
        degrees_of_freedom: Vec::new(),
        inertia: Matrix::zero(),
    }
}

/// The motion of a joint.
#[derive(Clone, Copy)]
enum JointCoordinate<'d> {
    /// Its own coordinates.
    Own,
    /// The coordinate of a joint with this name, times a factor, plus an offset.
    Mimic(&'d str, Approximate, Approximate),
    /// None: it is held at a coordinate.
    Held(Double),
}

struct RobotReader<'d> {
    description: &'d Description,
    request: &'d Request,
    /// The values of the struct's fields.
    fields: &'d List<FieldId, Vec<f64>>,
    /// Quarter turns that numbers were taken for, by item and bits.
    snapped: HashMap<(&'d str, u64), i64>,
    /// Rotations that quaternions were taken for, by item and bits.
    turned: HashMap<(&'d str, [u64; 4]), [i64; 4]>,
}

impl<'d> RobotReader<'d> {
    /// A reader with the corrections of a chain's report.
    fn of(chain: &'d Chain, fields: &'d List<FieldId, Vec<f64>>) -> Self {
        Self {
            description: &chain.description,
            request: &chain.request,
            fields,
            snapped: (chain.report.snapped.iter())
                .map(|number| {
                    let key = (number.item.as_str(), number.written.to_bits());
                    (key, number.quarters)
                })
                .collect(),
            turned: (chain.report.turned.iter())
                .map(|turned| {
                    let key = (turned.item.as_str(), turned.written.map(f64::to_bits));
                    (key, turned.squares)
                })
                .collect(),
        }
    }
}

//! A description as dense matrices of 256 bits, joint by joint.
//!
//! In: a description and a request. Out: a placement, a motion and an inertia J for every joint below the base, fixed
//! and locked ones included, without merging, rotated frames or regrouping. Only the reading of the text is shared with
//! the generator; [`trees::dense`](crate::trees::dense) makes the same matrices of numbers as they were drawn, without
//! the reading.

mod joint;
mod kept;
mod written;

use homogen_codegen::closure::Closure;
use homogen_codegen::description::Description;
use homogen_codegen::request::Request;

use super::actuator::Actuator;
use super::matrix::Matrix;
use super::motion::Motion;
use crate::big::Big;

/// A robot in the matrices of the paper.
#[derive(Clone, Debug)]
pub struct Robot {
    /// The joints, parents before children.
    pub bodies: Vec<Body>,
    /// The body of the end effector's frame, then those of the further frames; `None` for the base.
    pub frames: Vec<Option<usize>>,
    /// H_g (§ 4.5).
    pub gravity: Matrix,
    /// The closed loops.
    pub loops: Vec<Loop>,
    /// Armature, damping and friction of each velocity of each joint.
    pub actuators: Vec<Actuator>,
    /// True if the regressor has columns of armature, damping and friction behind those of links.
    pub identifies_actuators: bool,
    /// The bodies on which external wrenches act, and whether the wrenches are in frame 0.
    pub external: (Vec<usize>, bool),
}

/// A closed loop between two frames.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its type.
    pub closure: Closure,
    /// The frames A and B: the body that each is fixed to, `None` for the base, and its pose there. z is the axis of
    /// the loop, if it has one.
    pub frames: [(Option<usize>, Matrix); 2],
    /// The cosine of the angle between two axes, as described.
    pub cosine: Big,
}

/// A joint and the link that it carries.
#[derive(Clone, Debug)]
pub struct Body {
    /// The parent; `None` for the base.
    pub parent: Option<usize>,
    /// M_parent,i at zero displacement.
    pub placement: Matrix,
    /// Its motion relative to the parent.
    pub motion: Motion,
    /// J in frame (i).
    pub inertia: Matrix,
    /// True for a link that a joint moves; false for intermediate bodies of joints with several velocities.
    pub link: bool,
}

impl Robot {
    /// The part of a description that a request selects.
    ///
    /// # Panics
    /// If the request names something that does not exist, or has struct fields.
    #[must_use]
    pub fn of(description: &Description, request: &Request) -> Self {
        assert!(request.parameters.is_empty(), "struct fields are not read");
        let reader = Reader {
            description,
            request,
        };
        let base = reader.base();
        let tip = reader.tip(base);
        let mut robot = Self {
            bodies: Vec::new(),
            frames: Vec::new(),
            gravity: reader.gravity(),
            loops: Vec::new(),
            actuators: Vec::new(),
            identifies_actuators: request.models_friction() || request.models_armature(),
            external: (Vec::new(), request.external_in_frame_0),
        };
        let links = reader.add_bodies(base, tip, &mut robot);
        let body_of = |link: &str| {
            let body = links.iter().position(|carried| *carried == link);
            assert!(body.is_some() || link == base, "{link} is not below {base}");
            body
        };
        let further = request.frames.iter().map(|frame| frame.text.as_str());
        robot.frames = tip.into_iter().chain(further).map(body_of).collect();
        let loops = description.loops.iter();
        robot.loops = loops
            .map(|described| reader.closed_loop(described, body_of))
            .collect();
        let external = request.external.iter();
        robot.external.0 = external.filter_map(|link| body_of(&link.text)).collect();
        robot
    }

    /// The number of velocities.
    #[must_use]
    pub fn velocities(&self) -> usize {
        let moving = self.bodies.iter().flat_map(|body| body.motion.screws());
        moving.map(|(velocity, _)| velocity + 1).max().unwrap_or(0)
    }

    /// The index of the first entry of each quaternion among the coordinates.
    pub fn quaternions(&self) -> impl Iterator<Item = usize> {
        self.bodies
            .iter()
            .filter_map(|body| body.motion.quaternion())
    }

    /// The bodies from one up to the base, itself first.
    pub fn upwards(&self, body: Option<usize>) -> impl Iterator<Item = usize> {
        std::iter::successors(body, |&body| self.bodies[body].parent)
    }
}

struct Reader<'d> {
    description: &'d Description,
    request: &'d Request,
}

//! A description as dense matrices of 256 bits, joint by joint.
//!
//! In: a description and a request. Out: a placement, a motion and an inertia J for every joint that
//! hangs on the base, fixed and locked ones too: nothing is merged, turned or regrouped. It shares with
//! the generator the reading of the text and nothing after it. Where that is to be contradicted too,
//! [`trees::dense`](crate::trees::dense) makes the same matrices of numbers as they were drawn.

mod joint;
mod kept;
mod written;

use homogen_codegen::closure::Closure;
use homogen_codegen::description::Description;
use homogen_codegen::request::Request;

use super::drive::Drive;
use super::matrix::Matrix;
use super::motion::Motion;
use crate::big::Big;

/// A robot in the matrices of the paper.
#[derive(Clone, Debug)]
pub struct Robot {
    /// The joints, parents before children.
    pub bodies: Vec<Body>,
    /// For the tip and every further frame asked for, the body whose frame it is; none for the base.
    pub frames: Vec<Option<usize>>,
    /// H_g (§ 4.5).
    pub gravity: Matrix,
    /// What holds bodies together that hang on the base anyhow.
    pub loops: Vec<Loop>,
    /// What drives joints beside bodies, of each of their velocities.
    pub drives: Vec<Drive>,
    /// Whether the regressor has columns of drives behind those of links.
    pub identifies_drives: bool,
    /// The bodies that the surroundings act on, and whether their actions are in frame 0.
    pub external: (Vec<usize>, bool),
}

/// Two frames that are held together.
#[derive(Clone, Debug)]
pub struct Loop {
    /// By what.
    pub closure: Closure,
    /// A and B, each with the body that it is fixed to, none for the base, and its place there; z is the
    /// axis of what holds them, where that has one.
    pub frames: [(Option<usize>, Matrix); 2],
    /// Of two axes the cosine of their angle as described.
    pub cosine: Big,
}

/// A joint and the link that it carries.
#[derive(Clone, Debug)]
pub struct Body {
    /// The body it hangs on; none for the base.
    pub parent: Option<usize>,
    /// M_parent,i where the joint is neutral.
    pub placement: Matrix,
    /// What moves it.
    pub motion: Motion,
    /// J in frame (i).
    pub inertia: Matrix,
    /// Whether it is a link that its joint moves, and not what moves by a part of a joint's freedoms.
    pub link: bool,
}

impl Robot {
    /// The part of a description that a request wants.
    ///
    /// # Panics
    /// Where the request names something that is not there, or has struct fields.
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
            drives: Vec::new(),
            identifies_drives: request.models_friction() || request.models_armature(),
            external: (Vec::new(), request.external_in_frame_0),
        };
        let links = reader.hang(base, tip, &mut robot);
        let seat = |link: &str| {
            let body = links.iter().position(|carried| *carried == link);
            assert!(
                body.is_some() || link == base,
                "{link} does not hang on {base}"
            );
            body
        };
        let further = request.frames.iter().map(|frame| frame.text.as_str());
        robot.frames = tip.into_iter().chain(further).map(seat).collect();
        let loops = description.loops.iter();
        robot.loops = loops
            .map(|described| reader.held(described, seat))
            .collect();
        let external = request.external.iter();
        robot.external.0 = external.filter_map(|link| seat(&link.text)).collect();
        robot
    }

    /// How many velocities there are.
    #[must_use]
    pub fn velocities(&self) -> usize {
        let moving = self.bodies.iter().flat_map(|body| body.motion.screws());
        moving.map(|(velocity, _)| velocity + 1).max().unwrap_or(0)
    }

    /// Where quaternions begin among the coordinates.
    pub fn quaternions(&self) -> impl Iterator<Item = usize> {
        self.bodies
            .iter()
            .filter_map(|body| body.motion.quaternion())
    }

    /// The bodies on the way from one up to the base, itself first.
    pub fn upwards(&self, body: Option<usize>) -> impl Iterator<Item = usize> {
        std::iter::successors(body, |&body| self.bodies[body].parent)
    }
}

struct Reader<'d> {
    description: &'d Description,
    request: &'d Request,
}

//! The signature as data: ordered lists of named entries, over which arguments and results are taken.
//!
//! A shared noun. A [`Space`] names one of a robot's lists, [`Spaces`] are the lists of one robot, a
//! [`Variable`] is what an argument holds of a list, a [`Quantity`] what a result holds of several,
//! an [`Outcome`] all that a function returns.
//! It knows no function and no joint.

mod quantity;
mod variable;

pub use quantity::{Entity, Outcome, Part, Quantity};
pub use variable::{Arguments, Variable};

use crate::list::{List, id};

/// One of the lists that every robot has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Space {
    /// What says where it is: q.
    Coordinates,
    /// What says how it moves: q̇, and with other units q̈ and τ.
    Velocities,
    /// What acts on links from outside: of each action its couple and its force.
    Actions,
    /// What it is made of: of each link that a joint moves, with all that is fixed to it, m, q_x, q_y, q_z, J_xx, J_xy,
    /// J_xz, J_yy, J_yz, J_zz in the link's own frame; then, where drives are modelled, armature, damping and friction of
    /// each velocity of a joint.
    Parameters,
    /// What torques can tell of them, each by the parameter that leads it.
    BaseParameters,
    /// What is zero where its loops are closed; empty where it has none.
    Constraints,
}

id! {
    /// The number of a struct field: in every list that has an entry for each of [`Request::parameters`](crate::request::Request).
    FieldId
}

id! {
    /// The number of an entry of [`Space::Coordinates`].
    CoordinateId
}

id! {
    /// The number of an entry of [`Space::Velocities`].
    VelocityId
}

id! {
    /// The number of an entry of [`Space::Parameters`], and of the column of the regressor that it has.
    ParameterId
}

id! {
    /// The number of a frame that is asked for, the tip's first where there is one: in every list that begins with
    /// such frames.
    FrameId
}

impl FrameId {
    /// That of the first; given where a function is of no frame.
    pub const FIRST: Self = Self(0);
}

/// The entries of an action, and what each does: a couple turns, a force slides.
pub const ACTION: [(&str, Kind); 6] = [
    ("cx", Kind::Turn),
    ("cy", Kind::Turn),
    ("cz", Kind::Turn),
    ("fx", Kind::Slide),
    ("fy", Kind::Slide),
    ("fz", Kind::Slide),
];

/// The action that an entry of all actions belongs to, counted from 0, and the name of the entry within it.
#[must_use]
pub const fn action_entry(entry: usize) -> (usize, &'static str) {
    (entry / ACTION.len(), ACTION[entry % ACTION.len()].0)
}

/// What an entry does to the body it is of, which decides its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// It turns.
    Turn,
    /// It slides.
    Slide,
    /// It is one of the four of a quaternion of unit length, which together turn.
    Quaternion,
    /// Nothing: it is a moment of its mass, of this order.
    Moment(u8),
    /// Nothing: it is what a joint that turns, or one that slides, feels for each second rate (2), for each rate (1), or
    /// for its sign alone (0).
    Drive {
        /// How many times the coordinate is differentiated.
        order: u8,
        /// Whether the joint slides.
        slides: bool,
    },
}

/// An entry of a space.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its name; that of the joint, where the joint has no other of its kind.
    pub name: String,
    /// What it does.
    pub kind: Kind,
    /// What it is described to stay in, in its unit; none where nothing is said.
    pub range: Option<[f64; 2]>,
}

/// The lists of a robot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spaces {
    /// Those of q.
    pub coordinates: List<CoordinateId, Entry>,
    /// Those of q̇, q̈ and τ.
    pub velocities: List<VelocityId, Entry>,
    /// Those of inertial parameters.
    pub parameters: List<ParameterId, Entry>,
    /// Those of base parameters.
    pub base_parameters: Vec<Entry>,
    /// Those of the residuals of its loops: lengths slide, products of axes turn.
    pub constraints: Vec<Entry>,
    /// Those of actions from outside: of each c_x, c_y, c_z, f_x, f_y, f_z.
    pub actions: Vec<Entry>,
}

impl Spaces {
    /// The entries of one of them.
    #[must_use]
    pub fn entries(&self, space: Space) -> &[Entry] {
        match space {
            Space::Coordinates => &self.coordinates,
            Space::Velocities => &self.velocities,
            Space::Parameters => &self.parameters,
            Space::BaseParameters => &self.base_parameters,
            Space::Constraints => &self.constraints,
            Space::Actions => &self.actions,
        }
    }

    /// How many actions from outside there are.
    #[must_use]
    pub fn actions(&self) -> usize {
        self.actions.len() / ACTION.len()
    }

    /// What the entries of one of them are called.
    pub fn names(&self, space: Space) -> impl Iterator<Item = &str> {
        self.entries(space).iter().map(|entry| entry.name.as_str())
    }

    /// Where the quaternions of q begin.
    pub fn quaternions(&self) -> impl Iterator<Item = CoordinateId> {
        let coordinates = self.coordinates.numbered();
        let places = coordinates.filter(|(_, entry)| entry.kind == Kind::Quaternion);
        places.map(|(k, _)| k).step_by(4)
    }

    /// How many entries one of them has.
    #[must_use]
    pub fn len(&self, space: Space) -> usize {
        self.entries(space).len()
    }
}

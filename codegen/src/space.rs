//! Spaces: named lists of coordinates, velocities and parameters, over which arguments and results range.
//!
//! A [`Space`] names one of a robot's lists and [`Spaces`] holds the lists of one robot. A [`Variable`] is an argument,
//! a [`Quantity`] a result over several spaces, and an [`Outcome`] the full result of a function.

mod quantity;
mod variable;

pub use quantity::{Entity, Order, Outcome, Part, Quantity};
pub use variable::{Arguments, Variable};

use crate::list::{Id, List, id};

/// One of the lists that every robot has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Space {
    /// Configuration q.
    Coordinates,
    /// Velocities q̇; accelerations q̈ and torques τ range over the same entries, in other units.
    Velocities,
    /// One wrench: couple and force.
    Wrench,
    /// External wrenches: couple and force of each.
    Actions,
    /// Inertial parameters of each link that a joint moves, with everything that is fixed to it, in the link's frame:
    /// m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz. After all links, if actuators are modelled: armature,
    /// damping and friction of each degree of freedom of a joint.
    Parameters,
    /// Base parameters: the linear combinations that torques determine, each named by its leading parameter.
    BaseParameters,
    /// Residuals of closed loops, zero if the loops are closed; empty without loops.
    Constraints,
    /// Requested frames, the end effector's first if there is one.
    Frames,
    /// Collision spheres.
    Spheres,
    /// Pairs of collision spheres that joints move relative to each other.
    Pairs,
}

id! {
    /// Index of a struct field, in lists with an entry for each of [`Request::parameters`](crate::request::Request).
    FieldId
}

id! {
    /// Index of an entry of [`Space::Coordinates`].
    CoordinateId
}

id! {
    /// Index of an entry of [`Space::Velocities`].
    VelocityId
}

id! {
    /// Index of an entry of [`Space::Parameters`] and of its column of the regressor.
    ParameterId
}

id! {
    /// Index of a requested frame, the end effector's first if there is one, in lists that begin with these frames.
    FrameId
}

id! {
    /// Index of an entry of [`Space::Spheres`].
    SphereId
}

impl FrameId {
    /// The first frame; also passed to functions without a frame.
    pub const FIRST: Self = Self(0);
}

/// Entries of a wrench with their kinds: a couple acts on rotations, a force on translations.
pub const ACTION: [(&str, Kind); 6] = [
    ("cx", Kind::Rotation),
    ("cy", Kind::Rotation),
    ("cz", Kind::Rotation),
    ("fx", Kind::Translation),
    ("fy", Kind::Translation),
    ("fz", Kind::Translation),
];

/// Index of the wrench that an entry of [`Space::Actions`] belongs to, and the name of the entry within it.
#[must_use]
pub const fn action_entry(entry: usize) -> (usize, &'static str) {
    (entry / ACTION.len(), ACTION[entry % ACTION.len()].0)
}

/// Kind of an entry, which decides its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Rotation.
    Rotation,
    /// Translation.
    Translation,
    /// One of the four components of a unit quaternion.
    Quaternion,
    /// Moment of mass of this order: 0 is a mass, 1 a first moment, 2 a second moment.
    Moment(u8),
    /// A frame, a sphere, or a pair of spheres; what belongs to it has a unit of its own.
    Frame,
    /// Parameter of an actuator: armature (order 2), damping (order 1) or friction (order 0).
    Actuator {
        /// Derivative of the coordinate that it is multiplied by; 0 means the sign of the velocity.
        order: u8,
        /// True for a prismatic joint.
        translates: bool,
    },
}

/// An entry of a space.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Name; that of the joint if the joint has no other entry of this kind.
    pub name: String,
    /// Kind.
    pub kind: Kind,
    /// Range in the description, in the unit of the entry; `None` if the description has none.
    pub range: Option<[f64; 2]>,
}

/// Spaces of a robot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spaces {
    /// Entries of q.
    pub coordinates: List<CoordinateId, Entry>,
    /// Entries of q̇, q̈ and τ.
    pub velocities: List<VelocityId, Entry>,
    /// Inertial parameters.
    pub parameters: List<ParameterId, Entry>,
    /// Base parameters.
    pub base_parameters: Vec<Entry>,
    /// Residuals of the loops: lengths (`Slide`) and products of axes (`Turn`).
    pub constraints: Vec<Entry>,
    /// Entries of one wrench: c_x, c_y, c_z, f_x, f_y, f_z.
    pub wrench: Vec<Entry>,
    /// Entries of the external wrenches: c_x, c_y, c_z, f_x, f_y, f_z of each.
    pub actions: Vec<Entry>,
    /// Requested frames.
    pub frames: List<FrameId, Entry>,
    /// Collision spheres.
    pub spheres: List<SphereId, Entry>,
    /// Pairs of collision spheres.
    pub pairs: Vec<Entry>,
    /// Sets of equal limbs.
    pub limbs: Vec<Limbs>,
}

/// Equal limbs: for each place in a limb the indices of its entries, one for each limb.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Limbs {
    /// Entries of [`Space::Coordinates`].
    pub coordinates: Vec<Vec<CoordinateId>>,
    /// Entries of [`Space::Velocities`].
    pub velocities: Vec<Vec<VelocityId>>,
    /// Entries of [`Space::Actions`].
    pub actions: Vec<Vec<usize>>,
}

impl Limbs {
    /// Minimum number of equal limbs: two fill the smallest vector register.
    pub const FEWEST: usize = 2;

    /// Number of limbs.
    #[must_use]
    pub fn count(&self) -> usize {
        self.velocities.first().map_or(0, Vec::len)
    }

    /// Indices of the entries of a space, by place and limb.
    #[must_use]
    pub fn entries(&self, space: Space) -> Vec<Vec<usize>> {
        match space {
            Space::Coordinates => indices(&self.coordinates),
            Space::Velocities => indices(&self.velocities),
            Space::Actions => self.actions.clone(),
            Space::Wrench
            | Space::Parameters
            | Space::BaseParameters
            | Space::Constraints
            | Space::Frames
            | Space::Spheres
            | Space::Pairs => Vec::new(),
        }
    }
}

fn indices<I: Id>(rows: &[Vec<I>]) -> Vec<Vec<usize>> {
    let row = |row: &Vec<I>| row.iter().map(|id| id.index()).collect();
    rows.iter().map(row).collect()
}

impl Spaces {
    /// Entries of a space.
    #[must_use]
    pub fn entries(&self, space: Space) -> &[Entry] {
        match space {
            Space::Coordinates => &self.coordinates,
            Space::Velocities => &self.velocities,
            Space::Parameters => &self.parameters,
            Space::BaseParameters => &self.base_parameters,
            Space::Constraints => &self.constraints,
            Space::Wrench => &self.wrench,
            Space::Actions => &self.actions,
            Space::Frames => &self.frames,
            Space::Spheres => &self.spheres,
            Space::Pairs => &self.pairs,
        }
    }

    /// Number of external wrenches.
    #[must_use]
    pub fn actions(&self) -> usize {
        self.actions.len() / ACTION.len()
    }

    /// Names of the entries of a space.
    pub fn names(&self, space: Space) -> impl Iterator<Item = &str> {
        self.entries(space).iter().map(|entry| entry.name.as_str())
    }

    /// Index of the first component of each quaternion in q.
    pub fn quaternions(&self) -> impl Iterator<Item = CoordinateId> {
        let coordinates = self.coordinates.numbered();
        let places = coordinates.filter(|(_, entry)| entry.kind == Kind::Quaternion);
        places.map(|(k, _)| k).step_by(4)
    }

    /// Number of entries of a space.
    #[must_use]
    pub fn len(&self, space: Space) -> usize {
        self.entries(space).len()
    }
}

//! Mechanics of MuJoCo that are not modelled, each with its warning.

use crate::description::xml::elements::NotModelled;

/// The body frame is moved to the inertial frame.
pub(in crate::description::mjcf) const ALIGNED: NotModelled = NotModelled {
    what: "MuJoCo moves the frame of this free body to its inertial frame",
    hint: "coordinates here are those of the frame as written; write align=\"false\" for the same in MuJoCo",
};

/// Armature and friction of a free joint.
pub(in crate::description::mjcf) const OF_WORLD: NotModelled = NotModelled {
    what: "armature or friction of a free joint",
    hint: "write <freejoint/>, which has no attributes of a class of defaults",
};

/// A spring.
pub(in crate::description::mjcf) const SPRING: NotModelled = NotModelled {
    what: "a spring",
    hint: "its force is missing from torques and accelerations: add it in your program",
};

/// Damping that is not linear in the velocity.
pub(in crate::description::mjcf) const CUBIC: NotModelled = NotModelled {
    what: "damping that is not linear in the velocity",
    hint: "only the linear part is modelled, with the key friction",
};

/// A mimic joint with a polynomial of higher order.
pub(in crate::description::mjcf) const POLYNOMIAL: NotModelled = NotModelled {
    what: "a joint that follows another by a polynomial of higher order",
    hint: "it moves freely here: lock it, or write a polynomial of first order",
};

/// A joint fixed by a constraint.
pub(in crate::description::mjcf) const HELD: NotModelled = NotModelled {
    what: "a joint that a constraint holds in place",
    hint: "it moves freely here: lock it",
};

/// A joint with two constraints, or a cycle of mimic joints.
pub(in crate::description::mjcf) const SECOND: NotModelled = NotModelled {
    what: "a second constraint of a mimic joint, or a cycle of mimic joints",
    hint: "only the first of its constraints is modelled",
};

/// Damping of an actuator.
pub(in crate::description::mjcf) const ACTUATOR_DAMPING: NotModelled = NotModelled {
    what: "damping of an actuator",
    hint: "set it with the key damping",
};

/// Armature of an actuator that does not act on a single hinge or slide.
pub(in crate::description::mjcf) const ELSEWHERE: NotModelled = NotModelled {
    what: "armature of an actuator that does not act on a single hinge or slide",
    hint: "set it with the key armature",
};

/// Forces of a plug-in.
pub(in crate::description::mjcf) const PLUGIN: NotModelled = NotModelled {
    what: "forces of a plug-in",
    hint: "they are missing from torques and accelerations",
};

/// A body whose pose is set by the program.
pub(in crate::description::mjcf) const MOCAP: NotModelled = NotModelled {
    what: "a body whose pose the program sets (mocap)",
    hint: "it is fixed in its described pose",
};

/// A body with gravity compensation.
pub(in crate::description::mjcf) const GRAVCOMP: NotModelled = NotModelled {
    what: "gravity compensation of a body",
    hint: "its whole weight acts here: subtract the force in your program",
};

/// Forces of a fluid.
pub(in crate::description::mjcf) const FLUID: NotModelled = NotModelled {
    what: "forces of a fluid",
    hint: "they are missing from torques and accelerations",
};

/// A constraint of a tendon or a flexible body.
pub(in crate::description::mjcf) const SOLVED: NotModelled = NotModelled {
    what: "a constraint of a tendon or a flexible body",
    hint: "it is not imposed here",
};

/// A muscle.
pub(in crate::description::mjcf) const MUSCLE: NotModelled = NotModelled {
    what: "a muscle",
    hint: "its force is missing from torques and accelerations",
};

/// Springs, friction or inertia of a tendon.
pub(in crate::description::mjcf) const TENDON_FORCE: NotModelled = NotModelled {
    what: "springs, friction or inertia of a tendon",
    hint: "they are missing from torques and accelerations",
};

/// A flexible body.
pub(in crate::description::mjcf) const FLEX: NotModelled = NotModelled {
    what: "a flexible body",
    hint: "it is left out, with its mass",
};

/// A constraint of an attached model.
pub(in crate::description::mjcf) const DETACHED: NotModelled = NotModelled {
    what: "a constraint on elements that are not attached",
    hint: "it is left out, as in MuJoCo",
};

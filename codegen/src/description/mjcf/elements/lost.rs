//! Mechanics of MuJoCo that are left out.

use crate::description::xml::elements::Lost;

/// The body moves with its inertial frame, and not with the one that is written.
pub(in crate::description::mjcf) const ALIGNED: Lost = Lost {
    what: "the body moves with its inertial frame, and not with the one that is written",
    hint: "coordinates here are those of the body's frame as written; write align=\"false\" for the same in MuJoCo",
};

/// Armature and friction of a free joint.
pub(in crate::description::mjcf) const OF_WORLD: Lost = Lost {
    what: "armature or friction of a free joint, which no motor has",
    hint: "write <freejoint/>, which takes none of a class of defaults",
};

/// A spring.
pub(in crate::description::mjcf) const SPRING: Lost = Lost {
    what: "a spring",
    hint: "its force is missing from torques and accelerations: add it outside",
};

/// Damping that is not linear in the velocity.
pub(in crate::description::mjcf) const CUBIC: Lost = Lost {
    what: "damping that is not linear in the velocity",
    hint: "the linear part is modelled where friction is asked for",
};

/// A joint follows another by a polynomial of higher order.
pub(in crate::description::mjcf) const POLYNOMIAL: Lost = Lost {
    what: "a joint follows another by a polynomial of higher order",
    hint: "it moves freely here: lock it, or let it follow linearly",
};

/// A joint is held where it is.
pub(in crate::description::mjcf) const HELD: Lost = Lost {
    what: "a joint is held where it is",
    hint: "it moves freely here: lock it",
};

/// A joint follows twice, or follows itself.
pub(in crate::description::mjcf) const SECOND: Lost = Lost {
    what: "a joint follows twice, or follows itself",
    hint: "the first of its constraints is modelled",
};

/// Damping by the motor.
pub(in crate::description::mjcf) const ACTUATOR_DAMPING: Lost = Lost {
    what: "damping by the motor",
    hint: "say it with damping beside the file",
};

/// An armature that is of no hinge or slide alone.
pub(in crate::description::mjcf) const ELSEWHERE: Lost = Lost {
    what: "an armature that is of no hinge or slide alone",
    hint: "say it with armature beside the file",
};

/// Forces of a plug-in.
pub(in crate::description::mjcf) const PLUGIN: Lost = Lost {
    what: "forces of a plug-in",
    hint: "they are missing from torques and accelerations",
};

/// A body whose place is set from outside.
pub(in crate::description::mjcf) const MOCAP: Lost = Lost {
    what: "a body whose place is set from outside",
    hint: "it is fixed where it is described",
};

/// A body that gravity does not pull by its whole weight.
pub(in crate::description::mjcf) const GRAVCOMP: Lost = Lost {
    what: "a body that gravity does not pull by its whole weight",
    hint: "gravity pulls it here: subtract the force outside",
};

/// Forces of a fluid.
pub(in crate::description::mjcf) const FLUID: Lost = Lost {
    what: "forces of a fluid",
    hint: "they are missing from torques and accelerations",
};

/// A constraint of a tendon or a flexible body.
pub(in crate::description::mjcf) const SOLVED: Lost = Lost {
    what: "a constraint of a tendon or a flexible body",
    hint: "it is missing here",
};

/// A muscle, which pulls by itself.
pub(in crate::description::mjcf) const MUSCLE: Lost = Lost {
    what: "a muscle, which pulls by itself",
    hint: "its force is missing from torques and accelerations",
};

/// Springs, friction or inertia of a tendon.
pub(in crate::description::mjcf) const TENDON_FORCE: Lost = Lost {
    what: "springs, friction or inertia of a tendon",
    hint: "they are missing from torques and accelerations",
};

/// A flexible body.
pub(in crate::description::mjcf) const FLEX: Lost = Lost {
    what: "a flexible body",
    hint: "it is left out, with its mass",
};

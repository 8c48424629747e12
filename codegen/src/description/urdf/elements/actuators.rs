//! Elements and attributes of transmissions: those of ROS, PR2, `ros2_control` and Drake.

use super::simulators::FORCE;
use super::{Content, Entry, NotModelled, Others, VALUE};

/// `<transmission>`.
pub(super) const TRANSMISSION: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::ignored("type", "a setting of controllers"),
    ],
    elements: &[
        Entry::read("joint", "the joint that it moves").with(&END),
        Entry::read("actuator", "a motor; the inertias of several add up").with(&END),
        Entry::read("mechanicalReduction", REDUCTION),
        Entry::read("mechanical_reduction", REDUCTION),
        Entry::read("drake:gear_ratio", RATIO).with(&VALUE),
        Entry::read("drake:rotor_inertia", ROTOR).with(&VALUE),
        Entry::read("leftActuator", OF_TWO).with(&END),
        Entry::read("rightActuator", OF_TWO).with(&END),
        Entry::read("flexJoint", OF_TWO).with(&END),
        Entry::read("rollJoint", OF_TWO).with(&END),
        Entry::read("gap_joint", OF_TWO).with(&GAP_JOINT),
        Entry::ignored("type", "a setting of controllers"),
        Entry::ignored("plugin", "a setting of controllers"),
        Entry::ignored("param", "settings of controllers"),
        Entry::ignored("hardwareInterface", "a setting of controllers"),
        Entry::ignored("motorTorqueConstant", "torque per current"),
        Entry::ignored("pulsesPerRevolution", "pulses of a sensor"),
        Entry::ignored("passive_joint", "joints that a motor moves through others"),
        Entry::ignored(
            "simulated_actuated_joint",
            "a setting of the PR2's simulation",
        ),
        Entry::ignored(
            "use_simulated_gripper_joint",
            "a setting of the PR2's simulation",
        ),
        Entry::not_modelled("compensator", &FORCE),
        Entry::not_modelled("motorInertia", &MOTOR_INERTIA),
        Entry::not_modelled("motor_inertia", &MOTOR_INERTIA),
        Entry::not_modelled("rotorInertia", &MOTOR_INERTIA),
    ],
    others: Others::Warned,
};

/// A joint or an actuator of a transmission.
pub(super) const END: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("mechanicalReduction", REDUCTION),
        Entry::read("mechanical_reduction", REDUCTION),
        Entry::ignored("role", "its role among several"),
        Entry::ignored("type", "a setting of controllers"),
    ],
    elements: &[
        Entry::read("mechanicalReduction", REDUCTION),
        Entry::read("mechanical_reduction", REDUCTION),
        Entry::read("drake:gear_ratio", RATIO).with(&VALUE),
        Entry::read("drake:rotor_inertia", ROTOR).with(&VALUE),
        Entry::ignored("hardwareInterface", "a setting of controllers"),
        Entry::ignored("role", "its role among several"),
        Entry::ignored("type", "a setting of controllers"),
        Entry::ignored("offset", "offset of an encoder"),
        Entry::ignored("motorTorqueConstant", "torque per current"),
        Entry::ignored("pulsesPerRevolution", "pulses of a sensor"),
        Entry::ignored("deadBandUpper", "settings of controllers"),
        Entry::ignored("deadBandLower", "settings of controllers"),
        Entry::ignored("saturationUpper", "settings of controllers"),
        Entry::ignored("saturationLower", "settings of controllers"),
        Entry::ignored(
            "ignoreTransmissionAbsoluteEncoder",
            "settings of controllers",
        ),
        Entry::ignored("param", "settings of controllers"),
        Entry::ignored("drake:controller_gains", "gains"),
        Entry::not_modelled("motorInertia", &MOTOR_INERTIA),
        Entry::not_modelled("motor_inertia", &MOTOR_INERTIA),
        Entry::not_modelled("rotorInertia", &MOTOR_INERTIA),
    ],
    others: Others::Warned,
};

/// The gripper of the PR2; its numbers belong to its linkage.
const GAP_JOINT: Content = Content {
    attributes: END.attributes,
    elements: &[],
    others: Others::Ignored,
};

/// Interfaces of controllers, and transmissions among them.
pub(super) const ROS2_CONTROL: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("transmission", "its reductions").with(&TRANSMISSION),
        Entry::ignored("hardware", "settings of controllers"),
        Entry::ignored("joint", "interfaces of a joint"),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("gpio", "interfaces"),
    ],
    others: Others::Ignored,
};

const REDUCTION: &str =
    "the ratio of a rotor; a warning if no rotor is modelled and the ratio is not 1";
const RATIO: &str = "`value`, the ratio of a rotor [1, for a prismatic joint rad/m]";
const ROTOR: &str =
    "`value`, the inertia of a rotor about its own axis [kg m²], modelled with the key `rotors`";
const OF_TWO: &str = "a warning if its reduction is not 1: joints that several motors move together are not modelled";

const MOTOR_INERTIA: NotModelled = NotModelled {
    what: "the inertia of a rotor",
    hint: "write it as <drake:rotor_inertia value=\"…\"/> in the <actuator>, with the key `rotors`",
};

//! Elements and attributes of transmissions: those of ROS, PR2, `ros2_control` and Drake.

use super::simulators::FORCE;
use super::{Content, Entry, Lost, Others, VALUE};

/// `<transmission>`.
pub(super) const TRANSMISSION: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::nothing("type", "a setting of controllers"),
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
        Entry::nothing("type", "a setting of controllers"),
        Entry::nothing("plugin", "a setting of controllers"),
        Entry::nothing("param", "settings of controllers"),
        Entry::nothing("hardwareInterface", "a setting of controllers"),
        Entry::nothing("motorTorqueConstant", "torque per current"),
        Entry::nothing("pulsesPerRevolution", "pulses of a sensor"),
        Entry::nothing("passive_joint", "joints that a motor moves through others"),
        Entry::nothing(
            "simulated_actuated_joint",
            "a setting of the PR2's simulation",
        ),
        Entry::nothing(
            "use_simulated_gripper_joint",
            "a setting of the PR2's simulation",
        ),
        Entry::lost("compensator", &FORCE),
        Entry::lost("motorInertia", &MOTOR_INERTIA),
        Entry::lost("motor_inertia", &MOTOR_INERTIA),
        Entry::lost("rotorInertia", &MOTOR_INERTIA),
    ],
    others: Others::Warned,
};

/// What stands at either end of a transmission.
pub(super) const END: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("mechanicalReduction", REDUCTION),
        Entry::read("mechanical_reduction", REDUCTION),
        Entry::nothing("role", "its role among several"),
        Entry::nothing("type", "a setting of controllers"),
    ],
    elements: &[
        Entry::read("mechanicalReduction", REDUCTION),
        Entry::read("mechanical_reduction", REDUCTION),
        Entry::read("drake:gear_ratio", RATIO).with(&VALUE),
        Entry::read("drake:rotor_inertia", ROTOR).with(&VALUE),
        Entry::nothing("hardwareInterface", "a setting of controllers"),
        Entry::nothing("role", "its role among several"),
        Entry::nothing("type", "a setting of controllers"),
        Entry::nothing("offset", "offset of an encoder"),
        Entry::nothing("motorTorqueConstant", "torque per current"),
        Entry::nothing("pulsesPerRevolution", "pulses of a sensor"),
        Entry::nothing("deadBandUpper", "settings of controllers"),
        Entry::nothing("deadBandLower", "settings of controllers"),
        Entry::nothing("saturationUpper", "settings of controllers"),
        Entry::nothing("saturationLower", "settings of controllers"),
        Entry::nothing(
            "ignoreTransmissionAbsoluteEncoder",
            "settings of controllers",
        ),
        Entry::nothing("param", "settings of controllers"),
        Entry::nothing("drake:controller_gains", "gains"),
        Entry::lost("motorInertia", &MOTOR_INERTIA),
        Entry::lost("motor_inertia", &MOTOR_INERTIA),
        Entry::lost("rotorInertia", &MOTOR_INERTIA),
    ],
    others: Others::Warned,
};

/// The gripper of the PR2, whose numbers are of its linkage.
const GAP_JOINT: Content = Content {
    attributes: END.attributes,
    elements: &[],
    others: Others::PassedOver,
};

/// Interfaces of controllers, and transmissions among them.
pub(super) const ROS2_CONTROL: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("transmission", "its reductions").with(&TRANSMISSION),
        Entry::nothing("hardware", "settings of controllers"),
        Entry::nothing("joint", "interfaces of a joint"),
        Entry::nothing("sensor", "sensors"),
        Entry::nothing("gpio", "interfaces"),
    ],
    others: Others::PassedOver,
};

const REDUCTION: &str =
    "the ratio of a rotor; a warning if no rotor is modelled and the ratio is not 1";
const RATIO: &str = "`value`, the ratio of a rotor [1, for a prismatic joint rad/m]";
const ROTOR: &str =
    "`value`, the inertia of a rotor about its own axis [kg m²], modelled with the key `rotors`";
const OF_TWO: &str = "a warning if its reduction is not 1: joints that several motors move together are not modelled";

const MOTOR_INERTIA: Lost = Lost {
    what: "the inertia of a rotor",
    hint: "write it as <drake:rotor_inertia value=\"…\"/> in the <actuator>, and ask for it with `rotors`",
};

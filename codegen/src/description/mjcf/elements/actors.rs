//! Elements and attributes of constraints, actuators, tendons and flexible bodies.

use super::lost::{FLEX, MUSCLE, PLUGIN, SOLVED, TENDON_FORCE};
use crate::description::xml::elements::{Content, Entry, Others, When};

pub(in crate::description::mjcf) static EQUALITY: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read(
            "joint",
            "a mimic joint, of a polynomial of first order, and a warning of others",
        )
        .with(&CONSTRAINT),
        Entry::read("connect", "a loop closed by a ball joint").with(&CONSTRAINT),
        Entry::read("weld", "a loop closed rigidly").with(&CONSTRAINT),
        Entry::lost("tendon", &SOLVED),
        Entry::lost("flex", &SOLVED),
        Entry::lost("flexvert", &SOLVED),
        Entry::lost("flexstrain", &SOLVED),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static CONSTRAINT: Content = Content {
    attributes: &[
        Entry::read("name", "that of a loop"),
        Entry::read("class", "its class of defaults"),
        Entry::read("active", "whether it is there"),
        Entry::read("joint1", "the joint that follows"),
        Entry::read("joint2", "the joint that leads"),
        Entry::read("polycoef", "offset and factor"),
        Entry::read("body1", "a body"),
        Entry::read("body2", "a body, or the world"),
        Entry::read(
            "anchor",
            "a point: of `connect` in `body1`, of `weld` in `body2`",
        ),
        Entry::read(
            "relpose",
            "the pose of `body2` in `body1`; as described where it is not written",
        ),
        Entry::read("site1", "a site"),
        Entry::read("site2", "a site"),
        Entry::nothing("torquescale", "a setting of the solver"),
        Entry::nothing("solref", "a setting of the solver"),
        Entry::nothing("solimp", "a setting of the solver"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ACTUATORS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("general", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("motor", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("position", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("velocity", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("intvelocity", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("orientation", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("pid", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("damper", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("cylinder", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("adhesion", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("dcmotor", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::lost("muscle", &MUSCLE),
        Entry::lost("plugin", &PLUGIN),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ACTUATOR: Content = Content {
    attributes: &[
        Entry::read("name", "messages name it"),
        Entry::read("class", "its class of defaults"),
        Entry::read("joint", "the joint that it drives"),
        Entry::read("jointinparent", "the joint that it drives"),
        Entry::read(
            "gear",
            "turns of the rotor for each of the joint, beside `armature`",
        ),
        Entry::read(
            "armature",
            "the inertia of its rotor, where `rotors` asks for it, and a warning where not",
        ),
        Entry::read("damping", "a warning where it is not 0"),
        Entry::nothing("tendon", "of control: torques are those of joints"),
        Entry::nothing("slidersite", "of control: torques are those of joints"),
        Entry::nothing("cranksite", "of control: torques are those of joints"),
        Entry::nothing("site", "of control: torques are those of joints"),
        Entry::nothing("refsite", "of control: torques are those of joints"),
        Entry::nothing("body", "of control: torques are those of joints"),
        Entry::nothing("group", "of control: torques are those of joints"),
        Entry::nothing("nsample", "of control: torques are those of joints"),
        Entry::nothing("interp", "of control: torques are those of joints"),
        Entry::nothing("delay", "of control: torques are those of joints"),
        Entry::nothing("ctrlrange", "of control: torques are those of joints"),
        Entry::nothing("user", "of control: torques are those of joints"),
        Entry::nothing("lengthrange", "of control: torques are those of joints"),
        Entry::nothing("cranklength", "of control: torques are those of joints"),
        Entry::nothing("ctrllimited", "of control: torques are those of joints"),
        Entry::nothing("forcelimited", "of control: torques are those of joints"),
        Entry::nothing("actlimited", "of control: torques are those of joints"),
        Entry::nothing("forcerange", "of control: torques are those of joints"),
        Entry::nothing("actrange", "of control: torques are those of joints"),
        Entry::nothing("actdim", "of control: torques are those of joints"),
        Entry::nothing("velrange", "of control: torques are those of joints"),
        Entry::nothing("ffrange", "of control: torques are those of joints"),
        Entry::nothing("dyntype", "of control: torques are those of joints"),
        Entry::nothing("gaintype", "of control: torques are those of joints"),
        Entry::nothing("biastype", "of control: torques are those of joints"),
        Entry::nothing("dynprm", "of control: torques are those of joints"),
        Entry::nothing("gainprm", "of control: torques are those of joints"),
        Entry::nothing("biasprm", "of control: torques are those of joints"),
        Entry::nothing("actearly", "of control: torques are those of joints"),
        Entry::nothing("kp", "of control: torques are those of joints"),
        Entry::nothing("kv", "of control: torques are those of joints"),
        Entry::nothing("dampratio", "of control: torques are those of joints"),
        Entry::nothing("timeconst", "of control: torques are those of joints"),
        Entry::nothing("inheritrange", "of control: torques are those of joints"),
        Entry::nothing("area", "of control: torques are those of joints"),
        Entry::nothing("diameter", "of control: torques are those of joints"),
        Entry::nothing("bias", "of control: torques are those of joints"),
        Entry::nothing("gain", "of control: torques are those of joints"),
        Entry::nothing("input", "of control: torques are those of joints"),
        Entry::nothing("inputchart", "of control: torques are those of joints"),
        Entry::nothing("kd", "of control: torques are those of joints"),
        Entry::nothing("ki", "of control: torques are those of joints"),
        Entry::nothing("imax", "of control: torques are those of joints"),
        Entry::nothing("motorconst", "of control: torques are those of joints"),
        Entry::nothing("resistance", "of control: torques are those of joints"),
        Entry::nothing("nominal", "of control: torques are those of joints"),
        Entry::nothing("saturation", "of control: torques are those of joints"),
        Entry::nothing("inductance", "of control: torques are those of joints"),
        Entry::nothing("cogging", "of control: torques are those of joints"),
        Entry::nothing("controller", "of control: torques are those of joints"),
        Entry::nothing("thermal", "of control: torques are those of joints"),
        Entry::nothing("lugre", "of control: torques are those of joints"),
        Entry::nothing("damping0", "of control: torques are those of joints"),
        Entry::nothing("voltage", "of control: torques are those of joints"),
    ],
    elements: &[],
    others: Others::PassedOver,
};

pub(in crate::description::mjcf) static TENDONS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::nothing(
            "spatial",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&TENDON),
        Entry::nothing(
            "fixed",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&TENDON),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static TENDON: Content = Content {
    attributes: &[
        Entry::lost("stiffness", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("damping", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("frictionloss", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("armature", &TENDON_FORCE).when(When::NotZero),
    ],
    elements: &[],
    others: Others::PassedOver,
};

pub(in crate::description::mjcf) static DEFORMABLE: Content = Content {
    attributes: &[],
    elements: &[
        Entry::lost("flex", &FLEX),
        Entry::nothing("skin", "what is seen"),
    ],
    others: Others::Warned,
};

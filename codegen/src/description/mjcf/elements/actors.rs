//! Elements and attributes of constraints, actuators, tendons and flexible bodies.

use super::unmodelled::{FLEX, MUSCLE, PLUGIN, SOLVED, TENDON_FORCE};
use crate::description::xml::elements::{Content, Entry, Others, When};

pub(in crate::description::mjcf) static EQUALITY: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read(
            "joint",
            "a mimic joint, if the polynomial has first order; otherwise a warning",
        )
        .with(&CONSTRAINT),
        Entry::read("connect", "a loop closed by a ball joint").with(&CONSTRAINT),
        Entry::read("weld", "a loop closed rigidly").with(&CONSTRAINT),
        Entry::not_modelled("tendon", &SOLVED),
        Entry::not_modelled("flex", &SOLVED),
        Entry::not_modelled("flexvert", &SOLVED),
        Entry::not_modelled("flexstrain", &SOLVED),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static CONSTRAINT: Content = Content {
    attributes: &[
        Entry::read("name", "the name of the loop"),
        Entry::read("class", "its class of defaults"),
        Entry::read("active", "if `false`, the constraint is ignored"),
        Entry::read("joint1", "the mimic joint"),
        Entry::read("joint2", "the mimicked joint"),
        Entry::read("polycoef", "offset and multiplier"),
        Entry::read("body1", "a body"),
        Entry::read("body2", "a body; the world if it is not written"),
        Entry::read(
            "anchor",
            "a point: of `connect` in `body1`, of `weld` in `body2`",
        ),
        Entry::read(
            "relpose",
            "the pose of `body2` in `body1`; that of the described configuration if it is not written",
        ),
        Entry::read("site1", "a site"),
        Entry::read("site2", "a site"),
        Entry::ignored("torquescale", "a setting of the solver"),
        Entry::ignored("solref", "a setting of the solver"),
        Entry::ignored("solimp", "a setting of the solver"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ACTUATORS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("general", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("motor", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("position", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("velocity", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read(
            "intvelocity",
            "its armature; torques here are those of joints",
        )
        .with(&ACTUATOR),
        Entry::read(
            "orientation",
            "its armature; torques here are those of joints",
        )
        .with(&ACTUATOR),
        Entry::read("pid", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("damper", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("cylinder", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("adhesion", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::read("dcmotor", "its armature; torques here are those of joints").with(&ACTUATOR),
        Entry::not_modelled("muscle", &MUSCLE),
        Entry::not_modelled("plugin", &PLUGIN),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ACTUATOR: Content = Content {
    attributes: &[
        Entry::read("name", "its name, used in messages"),
        Entry::read("class", "its class of defaults"),
        Entry::read("joint", "the joint of the actuator"),
        Entry::read("jointinparent", "the joint of the actuator"),
        Entry::read("gear", "the gear ratio of the rotor, for `armature`"),
        Entry::read(
            "armature",
            "the inertia of its rotor, with the key `rotors`; otherwise a warning",
        ),
        Entry::read("damping", "a warning if it is not 0"),
        Entry::ignored("tendon", "control; torques here are those of joints"),
        Entry::ignored("slidersite", "control; torques here are those of joints"),
        Entry::ignored("cranksite", "control; torques here are those of joints"),
        Entry::ignored("site", "control; torques here are those of joints"),
        Entry::ignored("refsite", "control; torques here are those of joints"),
        Entry::ignored("body", "control; torques here are those of joints"),
        Entry::ignored("group", "control; torques here are those of joints"),
        Entry::ignored("nsample", "control; torques here are those of joints"),
        Entry::ignored("interp", "control; torques here are those of joints"),
        Entry::ignored("delay", "control; torques here are those of joints"),
        Entry::ignored("ctrlrange", "control; torques here are those of joints"),
        Entry::ignored("user", "control; torques here are those of joints"),
        Entry::ignored("lengthrange", "control; torques here are those of joints"),
        Entry::ignored("cranklength", "control; torques here are those of joints"),
        Entry::ignored("ctrllimited", "control; torques here are those of joints"),
        Entry::ignored("forcelimited", "control; torques here are those of joints"),
        Entry::ignored("actlimited", "control; torques here are those of joints"),
        Entry::ignored("forcerange", "control; torques here are those of joints"),
        Entry::ignored("actrange", "control; torques here are those of joints"),
        Entry::ignored("actdim", "control; torques here are those of joints"),
        Entry::ignored("velrange", "control; torques here are those of joints"),
        Entry::ignored("ffrange", "control; torques here are those of joints"),
        Entry::ignored("dyntype", "control; torques here are those of joints"),
        Entry::ignored("gaintype", "control; torques here are those of joints"),
        Entry::ignored("biastype", "control; torques here are those of joints"),
        Entry::ignored("dynprm", "control; torques here are those of joints"),
        Entry::ignored("gainprm", "control; torques here are those of joints"),
        Entry::ignored("biasprm", "control; torques here are those of joints"),
        Entry::ignored("actearly", "control; torques here are those of joints"),
        Entry::ignored("kp", "control; torques here are those of joints"),
        Entry::ignored("kv", "control; torques here are those of joints"),
        Entry::ignored("dampratio", "control; torques here are those of joints"),
        Entry::ignored("timeconst", "control; torques here are those of joints"),
        Entry::ignored("inheritrange", "control; torques here are those of joints"),
        Entry::ignored("area", "control; torques here are those of joints"),
        Entry::ignored("diameter", "control; torques here are those of joints"),
        Entry::ignored("bias", "control; torques here are those of joints"),
        Entry::ignored("gain", "control; torques here are those of joints"),
        Entry::ignored("input", "control; torques here are those of joints"),
        Entry::ignored("inputchart", "control; torques here are those of joints"),
        Entry::ignored("kd", "control; torques here are those of joints"),
        Entry::ignored("ki", "control; torques here are those of joints"),
        Entry::ignored("imax", "control; torques here are those of joints"),
        Entry::ignored("motorconst", "control; torques here are those of joints"),
        Entry::ignored("resistance", "control; torques here are those of joints"),
        Entry::ignored("nominal", "control; torques here are those of joints"),
        Entry::ignored("saturation", "control; torques here are those of joints"),
        Entry::ignored("inductance", "control; torques here are those of joints"),
        Entry::ignored("cogging", "control; torques here are those of joints"),
        Entry::ignored("controller", "control; torques here are those of joints"),
        Entry::ignored("thermal", "control; torques here are those of joints"),
        Entry::ignored("lugre", "control; torques here are those of joints"),
        Entry::ignored("damping0", "control; torques here are those of joints"),
        Entry::ignored("voltage", "control; torques here are those of joints"),
    ],
    elements: &[],
    others: Others::Ignored,
};

pub(in crate::description::mjcf) static TENDONS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::ignored(
            "spatial",
            "a transmission; a warning of springs, friction and inertia",
        )
        .with(&TENDON),
        Entry::ignored(
            "fixed",
            "a transmission; a warning of springs, friction and inertia",
        )
        .with(&TENDON),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static TENDON: Content = Content {
    attributes: &[
        Entry::not_modelled("stiffness", &TENDON_FORCE).when(When::NotZero),
        Entry::not_modelled("damping", &TENDON_FORCE).when(When::NotZero),
        Entry::not_modelled("frictionloss", &TENDON_FORCE).when(When::NotZero),
        Entry::not_modelled("armature", &TENDON_FORCE).when(When::NotZero),
    ],
    elements: &[],
    others: Others::Ignored,
};

pub(in crate::description::mjcf) static DEFORMABLE: Content = Content {
    attributes: &[],
    elements: &[
        Entry::not_modelled("flex", &FLEX),
        Entry::ignored("skin", "visual"),
    ],
    others: Others::Warned,
};

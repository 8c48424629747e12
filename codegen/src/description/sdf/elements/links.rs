//! Elements of links and joints.

use super::pose::POSE;
use super::{ADDED_MASS, GRAVITY, KINEMATIC, SPRING, VELOCITY_DECAY};
use crate::description::xml::elements::{Content, Entry, Others, When};

pub(super) static LINK: Content = Content {
    attributes: &[Entry::read("name", "its name")],
    elements: &[
        Entry::read("pose", "its placement").with(&POSE),
        Entry::read("inertial", "mass, centre of mass, inertia; without one 1 kg and 1 kg m² about each axis, with a warning").with(&INERTIAL),
        Entry::not_modelled("gravity", &GRAVITY).when(When::False),
        Entry::not_modelled("kinematic", &KINEMATIC).when(When::True),
        Entry::not_modelled("velocity_decay", &VELOCITY_DECAY),
        Entry::ignored("audio_sink", "sound"),
        Entry::ignored("audio_source", "sound"),
        Entry::ignored("battery", "a setting of simulators"),
        Entry::ignored("collision", "collision geometry"),
        Entry::ignored("enable_wind", "a setting of simulators"),
        Entry::ignored("light", "appearance"),
        Entry::ignored("must_be_base_link", "a setting of simulators"),
        Entry::ignored("particle_emitter", "appearance"),
        Entry::ignored("projector", "appearance"),
        Entry::ignored("self_collide", "collision checks"),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("visual", "appearance"),
    ],
    others: Others::Warned,
};

pub(super) static INERTIAL: Content = Content {
    attributes: &[Entry::read(
        "auto",
        "`true` is an error: inertias of collisions are not computed",
    )],
    elements: &[
        Entry::read("mass", "the mass \\[kg\\]; 1 if it is not written"),
        Entry::read("pose", "the centre of mass, and the axes of the inertia").with(&POSE),
        Entry::read("inertia", "about the centre of mass [kg m²]").with(&INERTIA),
        Entry::not_modelled("fluid_added_mass", &ADDED_MASS),
        Entry::ignored("auto_inertia_params", "for `auto`"),
        Entry::ignored("density", "for `auto`"),
    ],
    others: Others::Warned,
};

pub(super) static INERTIA: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("ixx", "a moment; 1 if it is not written"),
        Entry::read("ixy", "a product; 0 if it is not written"),
        Entry::read("ixz", "a product; 0 if it is not written"),
        Entry::read("iyy", "a moment; 1 if it is not written"),
        Entry::read("iyz", "a product; 0 if it is not written"),
        Entry::read("izz", "a moment; 1 if it is not written"),
    ],
    others: Others::Warned,
};

pub(super) static JOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name, and that of its coordinate"),
        Entry::read(
            "type",
            "`revolute` is `continuous` without limits; `ball` is `spherical`, `revolute2` is `universal`; `gearbox` makes the hinge of its child a mimic joint",
        ),
    ],
    elements: &[
        Entry::read("parent", "the parent link, a frame on it, or `world`"),
        Entry::read("child", "the link that it moves, or a frame on it"),
        Entry::read("pose", "the frame of the joint").with(&POSE),
        Entry::read(
            "axis",
            "the axis; for `revolute2` and `universal` the first",
        )
        .with(&AXIS),
        Entry::read("axis2", "the second axis").with(&AXIS),
        Entry::read("screw_thread_pitch", "of a screw, metres per revolution"),
        Entry::read(
            "thread_pitch",
            "of a screw, radians per metre of a left-handed thread",
        ),
        Entry::read("gearbox_ratio", "of a gearbox; 1 if it is not written"),
        Entry::read(
            "gearbox_reference_body",
            "of a gearbox: the link of both hinges",
        ),
        Entry::read(
            "drake:rotor_inertia",
            "the inertia of a rotor [kg m²], modelled with the key `rotors`",
        ),
        Entry::read("drake:gear_ratio", "the ratio of a rotor"),
        Entry::ignored("drake:controller_gains", "gains"),
        Entry::ignored("physics", "settings of the solver"),
        Entry::ignored("sensor", "sensors"),
    ],
    others: Others::Warned,
};

pub(super) static AXIS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("xyz", "the direction; z if it is not written").with(&XYZ),
        Entry::read(
            "use_parent_model_frame",
            "`true`: in the axes of the model, as in version 1.4",
        ),
        Entry::read("limit", "limits").with(&LIMIT),
        Entry::read("dynamics", "damping and friction").with(&DYNAMICS),
        Entry::read("mimic", "a mimic joint").with(&MIMIC),
        Entry::ignored("initial_position", "a configuration"),
    ],
    others: Others::Warned,
};

pub(super) static XYZ: Content = Content {
    attributes: &[Entry::read(
        "expressed_in",
        "the frame whose axes the direction has; that of the joint by default",
    )],
    elements: &[],
    others: Others::Warned,
};

pub(super) static LIMIT: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("lower", "lower limit [rad or m]; infinite from −1e16 on"),
        Entry::read("upper", "upper limit [rad or m]; infinite from 1e16 on"),
        Entry::read(
            "effort",
            "maximum torque or force [N m or N]; infinite if it is negative",
        ),
        Entry::read(
            "velocity",
            "maximum velocity [rad/s or m/s]; infinite if it is negative",
        ),
        Entry::ignored("stiffness", "a setting of the solver"),
        Entry::ignored("dissipation", "a setting of the solver"),
        Entry::ignored("drake:acceleration", "unused"),
    ],
    others: Others::Warned,
};

pub(super) static DYNAMICS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read(
            "damping",
            "viscous friction, modelled with the key `friction`; otherwise a warning",
        ),
        Entry::read(
            "friction",
            "Coulomb friction, modelled with the key `friction`; otherwise a warning",
        ),
        Entry::not_modelled("spring_stiffness", &SPRING).when(When::NotZero),
        Entry::ignored("spring_reference", "part of a spring"),
    ],
    others: Others::Warned,
};

pub(super) static MIMIC: Content = Content {
    attributes: &[
        Entry::read("joint", "the mimicked joint"),
        Entry::ignored(
            "axis",
            "joints with two coordinates cannot be mimicked, which is an error",
        ),
    ],
    elements: &[
        Entry::read(
            "multiplier",
            "factor of the mimicked joint's coordinate; 1 by default",
        ),
        Entry::read("offset", "added to the product; 0 by default"),
        Entry::read(
            "reference",
            "subtracted from the mimicked joint's coordinate; 0 by default",
        ),
    ],
    others: Others::Warned,
};

//! Elements and attributes of simulators: Gazebo, MuJoCo, Bullet, Drake. Most are settings without mechanics.

use super::{Content, Entry, NotModelled, Others, When};

/// `<gazebo>`, with elements at any depth.
pub(super) const GAZEBO: Content = Content {
    attributes: &[],
    elements: &[
        Entry::not_modelled("joint", &LOOP),
        Entry::not_modelled("joint:hinge", &LOOP),
        Entry::not_modelled("joint:slider", &LOOP),
        Entry::not_modelled("joint_hinge", &LOOP),
        Entry::not_modelled("joint_slider", &LOOP),
        Entry::not_modelled("link", &GAZEBO_BODY),
        Entry::not_modelled("model", &GAZEBO_BODY),
        Entry::not_modelled("inertial", &GAZEBO_BODY),
        Entry::not_modelled("springStiffness", &FORCE).when(When::NotZero),
        Entry::not_modelled("springReference", &FORCE).when(When::NotZero),
        Entry::not_modelled("spring_stiffness", &FORCE).when(When::NotZero),
        Entry::not_modelled("spring_reference", &FORCE).when(When::NotZero),
        Entry::not_modelled("dynamics", &GAZEBO_DYNAMICS),
        Entry::not_modelled("dampingFactor", &VELOCITY_DECAY).when(When::NotZero),
        Entry::not_modelled("velocity_decay", &VELOCITY_DECAY),
        Entry::not_modelled("turnGravityOff", &GRAVITY).when(When::True),
        Entry::not_modelled("gravity", &GRAVITY).when(When::False),
        Entry::not_modelled("kinematic", &KINEMATIC).when(When::True),
        Entry::ignored("plugin", "plug-ins and their settings"),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("visual", "appearance"),
        Entry::ignored("collision", "collision geometry"),
        Entry::ignored("surface", "contact parameters"),
        Entry::ignored("material", "colours"),
    ],
    others: Others::Ignored,
};

/// `<mujoco>`: elements that MuJoCo reads in a URDF, and others that it ignores.
pub(super) const MUJOCO: Content = Content {
    attributes: &[],
    elements: &[
        Entry::ignored("compiler", "paths of files, treatment of meshes").with(&COMPILER),
        Entry::ignored("option", "settings of the simulation").with(&OPTION),
        Entry::ignored("size", "memory"),
        Entry::ignored("visual", "appearance"),
        Entry::ignored("statistic", "appearance"),
        Entry::ignored("asset", "meshes and colours"),
        Entry::ignored("contact", "pairs for collision checks"),
        Entry::ignored("keyframe", "configurations by name"),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("custom", "user data"),
        Entry::ignored("extension", "plug-ins"),
        Entry::not_modelled("equality", &CONSTRAINT),
        Entry::not_modelled("tendon", &FORCE),
        Entry::not_modelled("actuator", &MUJOCO_ACTUATOR),
        Entry::not_modelled("default", &MUJOCO_BODY),
        Entry::not_modelled("worldbody", &MUJOCO_BODY),
        Entry::not_modelled("deformable", &DEFORMABLE),
    ],
    others: Others::Warned,
};

pub(super) const COMPILER: Content = Content {
    attributes: &[
        Entry::not_modelled("boundmass", &CHANGED_MASSES).when(When::NotZero),
        Entry::not_modelled("boundinertia", &CHANGED_MASSES).when(When::NotZero),
        Entry::not_modelled("settotalmass", &CHANGED_MASSES).when(When::NotZero),
        Entry::not_modelled("inertiafromgeom", &CHANGED_MASSES).when(When::True),
    ],
    elements: &[],
    others: Others::Ignored,
};

pub(super) const OPTION: Content = Content {
    attributes: &[
        Entry::not_modelled("gravity", &MUJOCO_GRAVITY).when(When::NotStandardGravity),
        Entry::not_modelled("viscosity", &FORCE).when(When::NotZero),
        Entry::not_modelled("density", &FORCE).when(When::NotZero),
        Entry::not_modelled("wind", &FORCE).when(When::NotZero),
    ],
    elements: &[],
    others: Others::Ignored,
};

/// Bullet's `<contact>` in a link.
pub(super) const BULLET_CONTACT: Content = Content {
    attributes: &[],
    elements: &[Entry::not_modelled("inertia_scaling", &SCALED_INERTIA).when(When::NotOne)],
    others: Others::Ignored,
};

/// Springs, dampers and other forces between links.
pub(super) const FORCE: NotModelled = NotModelled {
    what: "a spring, a damper or another force",
    hint: "add its torque to tau, or its wrench with `external`",
};

pub(super) const CONSTRAINT: NotModelled = NotModelled {
    what: "a constraint between links or joints",
    hint: "the loop is left open: close it with <loop_joint>, or with `loop` beside the file; a joint that follows \
           another has <mimic>",
};

const LOOP: NotModelled = NotModelled {
    what: "a joint beside those of the tree, which closes a loop",
    hint: "the loop is left open: close it with <loop_joint>, or with `loop` beside the file",
};

pub(super) const FRAME: NotModelled = NotModelled {
    what: "a frame",
    hint: "write a link without inertia, on a fixed joint",
};

pub(super) const GRAVITY: NotModelled = NotModelled {
    what: "a link without gravity",
    hint: "gravity acts on all links here",
};

pub(super) const KINEMATIC: NotModelled = NotModelled {
    what: "a kinematic link, which forces do not move",
    hint: "lock its joint if it stands still",
};

pub(super) const DEFORMABLE: NotModelled = NotModelled {
    what: "a deformable body",
    hint: "links are rigid here",
};

pub(super) const IGNORED_BY_DRAKE: NotModelled = NotModelled {
    what: "an element that Drake ignores",
    hint: "it is read here: remove the element, or the attribute",
};

const GAZEBO_BODY: NotModelled = NotModelled {
    what: "a body or an inertia of Gazebo's own",
    hint: "describe it by <link> and <joint> of the robot",
};

const GAZEBO_DYNAMICS: NotModelled = NotModelled {
    what: "damping, friction or a spring of Gazebo's own",
    hint: "write damping and friction as <dynamics> of the joint",
};

const VELOCITY_DECAY: NotModelled = NotModelled {
    what: "air drag of a link",
    hint: "add its wrench with `external`, or leave it out",
};

const CHANGED_MASSES: NotModelled = NotModelled {
    what: "a mass or an inertia that MuJoCo changes",
    hint: "masses and inertias are those of <inertial> here",
};

const MUJOCO_GRAVITY: NotModelled = NotModelled {
    what: "another gravity",
    hint: "gravity is 9.81 m/s² along −z here: set another with the key `gravity`",
};

const MUJOCO_ACTUATOR: NotModelled = NotModelled {
    what: "gears of actuators",
    hint: "torques are those of joints here",
};

const MUJOCO_BODY: NotModelled = NotModelled {
    what: "bodies or joints of MuJoCo's own",
    hint: "MuJoCo reads none there either: describe them by <link> and <joint>",
};

const SCALED_INERTIA: NotModelled = NotModelled {
    what: "an inertia that Bullet scales",
    hint: "inertias are those of <inertial> here",
};

//! Elements and attributes of simulators: Gazebo, MuJoCo, Bullet, Drake. Most are settings without mechanics.

use super::{Content, Entry, Lost, Others, When};

/// `<gazebo>`, with what stands in it at any depth.
pub(super) const GAZEBO: Content = Content {
    attributes: &[],
    elements: &[
        Entry::lost("joint", &LOOP),
        Entry::lost("joint:hinge", &LOOP),
        Entry::lost("joint:slider", &LOOP),
        Entry::lost("joint_hinge", &LOOP),
        Entry::lost("joint_slider", &LOOP),
        Entry::lost("link", &GAZEBO_BODY),
        Entry::lost("model", &GAZEBO_BODY),
        Entry::lost("inertial", &GAZEBO_BODY),
        Entry::lost("springStiffness", &FORCE).when(When::NotZero),
        Entry::lost("springReference", &FORCE).when(When::NotZero),
        Entry::lost("spring_stiffness", &FORCE).when(When::NotZero),
        Entry::lost("spring_reference", &FORCE).when(When::NotZero),
        Entry::lost("dynamics", &GAZEBO_DYNAMICS),
        Entry::lost("dampingFactor", &VELOCITY_DECAY).when(When::NotZero),
        Entry::lost("velocity_decay", &VELOCITY_DECAY),
        Entry::lost("turnGravityOff", &GRAVITY).when(When::True),
        Entry::lost("gravity", &GRAVITY).when(When::False),
        Entry::lost("kinematic", &KINEMATIC).when(When::True),
        Entry::nothing("plugin", "plug-ins and their settings"),
        Entry::nothing("sensor", "sensors"),
        Entry::nothing("visual", "appearance"),
        Entry::nothing("collision", "collision geometry"),
        Entry::nothing("surface", "contact parameters"),
        Entry::nothing("material", "colours"),
    ],
    others: Others::PassedOver,
};

/// `<mujoco>`: what MuJoCo reads in a URDF, and what people hope that it does.
pub(super) const MUJOCO: Content = Content {
    attributes: &[],
    elements: &[
        Entry::nothing("compiler", "paths of files, treatment of meshes").with(&COMPILER),
        Entry::nothing("option", "settings of the simulation").with(&OPTION),
        Entry::nothing("size", "memory"),
        Entry::nothing("visual", "appearance"),
        Entry::nothing("statistic", "appearance"),
        Entry::nothing("asset", "meshes and colours"),
        Entry::nothing("contact", "pairs for collision checks"),
        Entry::nothing("keyframe", "configurations by name"),
        Entry::nothing("sensor", "sensors"),
        Entry::nothing("custom", "user data"),
        Entry::nothing("extension", "plug-ins"),
        Entry::lost("equality", &CONSTRAINT),
        Entry::lost("tendon", &FORCE),
        Entry::lost("actuator", &MUJOCO_ACTUATOR),
        Entry::lost("default", &MUJOCO_BODY),
        Entry::lost("worldbody", &MUJOCO_BODY),
        Entry::lost("deformable", &DEFORMABLE),
    ],
    others: Others::Warned,
};

pub(super) const COMPILER: Content = Content {
    attributes: &[
        Entry::lost("boundmass", &CHANGED_MASSES).when(When::NotZero),
        Entry::lost("boundinertia", &CHANGED_MASSES).when(When::NotZero),
        Entry::lost("settotalmass", &CHANGED_MASSES).when(When::NotZero),
        Entry::lost("inertiafromgeom", &CHANGED_MASSES).when(When::True),
    ],
    elements: &[],
    others: Others::PassedOver,
};

pub(super) const OPTION: Content = Content {
    attributes: &[
        Entry::lost("gravity", &MUJOCO_GRAVITY).when(When::NotStandardGravity),
        Entry::lost("viscosity", &FORCE).when(When::NotZero),
        Entry::lost("density", &FORCE).when(When::NotZero),
        Entry::lost("wind", &FORCE).when(When::NotZero),
    ],
    elements: &[],
    others: Others::PassedOver,
};

/// Bullet's `<contact>` in a link.
pub(super) const BULLET_CONTACT: Content = Content {
    attributes: &[],
    elements: &[Entry::lost("inertia_scaling", &SCALED_INERTIA).when(When::NotOne)],
    others: Others::PassedOver,
};

/// Springs, dampers and other forces between links.
pub(super) const FORCE: Lost = Lost {
    what: "a spring, a damper or another force",
    hint: "add its torque to tau, or its wrench with `external`",
};

pub(super) const CONSTRAINT: Lost = Lost {
    what: "a constraint between links or joints",
    hint: "the loop is left open: close it with <loop_joint>, or with `loop` beside the file; a joint that follows \
           another has <mimic>",
};

const LOOP: Lost = Lost {
    what: "a joint beside those of the tree, which closes a loop",
    hint: "the loop is left open: close it with <loop_joint>, or with `loop` beside the file",
};

pub(super) const FRAME: Lost = Lost {
    what: "a frame",
    hint: "write a link without inertia, on a fixed joint",
};

pub(super) const GRAVITY: Lost = Lost {
    what: "a link without gravity",
    hint: "gravity acts on all links here, as it does on the robot",
};

pub(super) const KINEMATIC: Lost = Lost {
    what: "a link that no force moves",
    hint: "lock its joint, if it does not move",
};

pub(super) const DEFORMABLE: Lost = Lost {
    what: "a deformable body",
    hint: "links are rigid here",
};

pub(super) const IGNORED_BY_DRAKE: Lost = Lost {
    what: "what Drake is told to ignore",
    hint: "it is read here as if it were not: remove the element, or the attribute",
};

const GAZEBO_BODY: Lost = Lost {
    what: "a body or an inertia of Gazebo's own",
    hint: "describe it by <link> and <joint> of the robot",
};

const GAZEBO_DYNAMICS: Lost = Lost {
    what: "damping, friction or a spring of Gazebo's own",
    hint: "write damping and friction as <dynamics> of the joint",
};

const VELOCITY_DECAY: Lost = Lost {
    what: "damping of a link by the air",
    hint: "add its wrench with `external`, or leave it to the simulation",
};

const CHANGED_MASSES: Lost = Lost {
    what: "a mass or an inertia that MuJoCo changes",
    hint: "masses and inertias are those of <inertial> here",
};

const MUJOCO_GRAVITY: Lost = Lost {
    what: "another gravity",
    hint: "gravity is 9.81 m/s² along −z here: say another with `gravity`",
};

const MUJOCO_ACTUATOR: Lost = Lost {
    what: "gears of actuators",
    hint: "torques are those of joints here",
};

const MUJOCO_BODY: Lost = Lost {
    what: "bodies or joints of MuJoCo's own",
    hint: "MuJoCo reads none there either: describe them by <link> and <joint>",
};

const SCALED_INERTIA: Lost = Lost {
    what: "an inertia that Bullet scales",
    hint: "inertias are those of <inertial> here",
};

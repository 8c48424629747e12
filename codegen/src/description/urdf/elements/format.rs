//! Elements and attributes of URDF itself, and of extensions that belong to links and joints.

use super::actuators::{ROS2_CONTROL, TRANSMISSION};
use super::simulators::{
    BULLET_CONTACT, CONSTRAINT, DEFORMABLE, FORCE, FRAME, GAZEBO, GRAVITY, IGNORED_BY_DRAKE,
    KINEMATIC, MUJOCO,
};
use super::{Content, Entry, NotModelled, Others, VALUE, When};

/// The root element.
pub(super) const ROBOT: Content = Content {
    attributes: &[
        Entry::read("name", "the robot's name"),
        Entry::read("version", "`1.0` or `1.1`; a warning if it is another"),
    ],
    elements: &[
        Entry::read("link", "a body and its frame").with(&LINK),
        Entry::read("joint", "a joint").with(&JOINT),
        Entry::read(
            "drake:joint",
            "a joint of Drake: `ball` is read as `spherical`, with a quaternion as its coordinates; \
             `planar` moves across z, `universal` rotates about x and then y; other types are those of `<joint>`",
        )
        .with(&JOINT),
        Entry::read("loop_joint", "a closed loop").with(&LOOP_JOINT),
        Entry::read(
            "transmission",
            "rotor inertia and ratio, modelled with the key `rotors`; a warning without it",
        )
        .with(&TRANSMISSION),
        Entry::read("ros2_control", "the reductions of its `<transmission>`s, as in those").with(&ROS2_CONTROL),
        Entry::ignored("gazebo", "settings of Gazebo, with warnings of the mechanics among them").with(&GAZEBO),
        Entry::ignored("mujoco", "settings of MuJoCo, with warnings of the mechanics among them").with(&MUJOCO),
        Entry::ignored("material", "colours"),
        Entry::ignored("sensor", "sensors"),
        Entry::not_modelled("robot", &SECOND_ROBOT),
        Entry::not_modelled("frame", &FRAME),
        Entry::not_modelled("fixed_frame", &FRAME),
        Entry::not_modelled("force_element", &FORCE),
        Entry::not_modelled("drake:linear_bushing_rpy", &FORCE),
        Entry::not_modelled("drake:linear_spring_damper", &FORCE),
        Entry::not_modelled("drake:ball_constraint", &CONSTRAINT),
        Entry::not_modelled("drake:coupler_constraint", &CONSTRAINT),
        Entry::not_modelled("drake:distance_constraint", &CONSTRAINT),
        Entry::not_modelled("drake:tendon_constraint", &CONSTRAINT),
        Entry::not_modelled("drake:weld_constraint", &CONSTRAINT),
        Entry::not_modelled("deformable", &DEFORMABLE),
        Entry::not_modelled("drake:deformable", &DEFORMABLE),
        Entry::ignored("drake:collision_filter_group", "pairs of links whose collisions are ignored"),
        Entry::not_modelled("virtual_joint", &VIRTUAL_JOINT),
        Entry::ignored("group", "SRDF: names of joints that are planned together"),
        Entry::ignored("group_state", "SRDF: configurations by name"),
        Entry::ignored("end_effector", "SRDF: names of groups"),
        Entry::ignored("passive_joint", "SRDF: joints that a planner leaves alone"),
        Entry::ignored("disable_collisions", "SRDF: pairs of links for collision checks"),
        Entry::ignored("enable_collisions", "SRDF: pairs of links for collision checks"),
        Entry::ignored("disable_default_collisions", "SRDF: links whose collisions are ignored"),
        Entry::ignored("link_sphere_approximation", "SRDF: collision geometry"),
        Entry::ignored("joint_property", "SRDF: settings of planners"),
        Entry::ignored("webots", "settings of Webots"),
    ],
    others: Others::Warned,
};

pub(super) const LINK: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::ignored("type", "unused by every reader"),
        Entry::ignored("concave", "Bullet: collision geometry"),
        Entry::not_modelled("drake_ignore", &IGNORED_BY_DRAKE).when(When::True),
    ],
    elements: &[
        Entry::read(
            "inertial",
            "mass, centre of mass, inertia; without one the link has no mass",
        )
        .with(&INERTIAL),
        Entry::ignored("visual", "appearance"),
        Entry::read(
            "collision",
            "its sphere, on [request](collisions.md); without one, ignored",
        ),
        Entry::ignored(
            "gazebo",
            "settings of Gazebo, with warnings of the mechanics among them",
        )
        .with(&GAZEBO),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("contact", "contact parameters").with(&BULLET_CONTACT),
        Entry::ignored("surface", "contact parameters"),
        Entry::ignored("material", "colours"),
        Entry::ignored("self_collide", "collision checks"),
        Entry::ignored("collision_checking", "collision checks"),
        Entry::ignored("self_collision_checking", "collision checks"),
        Entry::ignored("self_filter", "parts that a sensor ignores"),
        Entry::ignored("map", "settings of former versions of Gazebo"),
        Entry::not_modelled("gravity", &GRAVITY).when(When::False),
        Entry::not_modelled("kinematic", &KINEMATIC).when(When::True),
    ],
    others: Others::Warned,
};

pub(super) const INERTIAL: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("origin", "the centre of mass, and the axes of the inertia").with(&ORIGIN),
        Entry::read("mass", "`value` \\[kg\\]").with(&VALUE),
        Entry::read(
            "inertia",
            "`ixx`, `ixy`, `ixz`, `iyy`, `iyz`, `izz` about the centre of mass [kg m²]",
        )
        .with(&INERTIA),
    ],
    others: Others::WarnedLikeText,
};

const INERTIA: Content = Content {
    attributes: &[
        Entry::read("ixx", "an entry"),
        Entry::read("ixy", "an entry"),
        Entry::read("ixz", "an entry"),
        Entry::read("iyy", "an entry"),
        Entry::read("iyz", "an entry"),
        Entry::read("izz", "an entry"),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const ORIGIN: Content = Content {
    attributes: &[
        Entry::read("xyz", "the translation \\[m\\]"),
        Entry::read(
            "rpy",
            "roll, pitch and yaw \\[rad\\]; digits of a right angle are read as one; a warning if an angle exceeds a revolution",
        ),
        Entry::read(
            "quat_xyzw",
            "URDF 1.1: the rotation as a quaternion, normalised; digits of right angles are read as such; \
             an error together with `rpy`",
        ),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const JOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name, and that of its coordinate"),
        Entry::read("type", "[the type](joints.md)"),
        Entry::ignored("dont_collapse", "Isaac: merging of fixed links"),
        Entry::not_modelled("drake_ignore", &IGNORED_BY_DRAKE).when(When::True),
    ],
    elements: &[
        Entry::read("origin", "the child's frame in the parent's at coordinate 0").with(&ORIGIN),
        Entry::read("parent", "`link`, the parent link").with(&END),
        Entry::read("child", "`link`, the link that it moves").with(&END),
        Entry::read(
            "axis",
            "`xyz`, a direction in the child's frame, normalised; x, with a warning, if it is missing",
        )
        .with(&AXIS),
        Entry::read("axis2", "the second axis of type `universal`; a warning for other types").with(&AXIS),
        Entry::read("thread", "`pitch` of type `screw` [m/rad]; a warning for other types").with(&THREAD),
        Entry::read("limit", "limits of coordinate, velocity and effort").with(&LIMIT),
        Entry::read("mimic", "a mimic joint").with(&MIMIC),
        Entry::read(
            "dynamics",
            "damping and friction, modelled with the key `friction`; a warning without it",
        )
        .with(&DYNAMICS),
        Entry::read(
            "safety_controller",
            "only a warning if its limits are narrower than those of `<limit>`, which are the range",
        )
        .with(&SAFETY_CONTROLLER),
        Entry::ignored("calibration", "positions of switches"),
        Entry::ignored("hardwareInterface", "a setting of controllers"),
        Entry::ignored("gazebo", "settings of Gazebo, with warnings of the mechanics among them").with(&GAZEBO),
        Entry::ignored("sensor", "sensors"),
        Entry::ignored("map", "settings of former versions of Gazebo"),
        Entry::not_modelled("joint_properties", &JOINT_PROPERTIES),
    ],
    others: Others::Warned,
};

const END: Content = Content {
    attributes: &[Entry::read("link", "its name")],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const AXIS: Content = Content {
    attributes: &[
        Entry::read("xyz", "the direction"),
        Entry::not_modelled("rpy", &AXIS_RPY).when(When::NotZero),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

const THREAD: Content = Content {
    attributes: &[Entry::read("pitch", "the pitch")],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const LIMIT: Content = Content {
    attributes: &[
        Entry::read(
            "lower",
            "lower limit [rad or m]; 0 if only `upper` is written",
        ),
        Entry::read(
            "upper",
            "upper limit [rad or m]; 0 if only `lower` is written",
        ),
        Entry::read("velocity", "maximum velocity [rad/s or m/s]"),
        Entry::read(
            "effort",
            "maximum torque or force [N m or N]: the constant `MAX_EFFORT`",
        ),
        Entry::ignored("acceleration", "unused"),
        Entry::ignored("deceleration", "unused"),
        Entry::ignored("jerk", "unused"),
        Entry::ignored("drake:acceleration", "unused"),
        Entry::ignored("drake:jerk", "unused"),
        Entry::ignored("command_effort", "a limit of a motor"),
        Entry::ignored("current", "a limit of a motor"),
        Entry::ignored("gear_velocity", "a limit of a motor"),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const DYNAMICS: Content = Content {
    attributes: &[
        Entry::read(
            "damping",
            "viscous friction, modelled with the key `friction`",
        ),
        Entry::read(
            "friction",
            "Coulomb friction, modelled with the key `friction`",
        ),
        Entry::ignored("coulomb_window", "a setting of former versions of Drake"),
        Entry::not_modelled("armature", &ARMATURE).when(When::NotZero),
        Entry::not_modelled("rotor_inertia", &ARMATURE).when(When::NotZero),
        Entry::not_modelled("spring_stiffness", &FORCE).when(When::NotZero),
        Entry::not_modelled("spring_reference", &FORCE).when(When::NotZero),
        Entry::not_modelled("stiffness", &FORCE).when(When::NotZero),
        Entry::not_modelled("K", &OTHER_DYNAMICS).when(When::NotZero),
        Entry::not_modelled("D", &OTHER_DYNAMICS).when(When::NotZero),
        Entry::not_modelled("mu_coulomb", &OTHER_DYNAMICS).when(When::NotZero),
        Entry::not_modelled("mu_viscous", &OTHER_DYNAMICS).when(When::NotZero),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const MIMIC: Content = Content {
    attributes: &[
        Entry::read("joint", "the mimicked joint"),
        Entry::read(
            "multiplier",
            "factor of the mimicked joint's coordinate; 1 by default",
        ),
        Entry::read("offset", "added to the product; 0 by default"),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const SAFETY_CONTROLLER: Content = Content {
    attributes: &[
        Entry::read("soft_lower_limit", "a warning if it is above `lower`"),
        Entry::read("soft_upper_limit", "a warning if it is below `upper`"),
        Entry::ignored("k_position", "a gain"),
        Entry::ignored("k_velocity", "a gain"),
        Entry::ignored("k_effort", "a gain"),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

pub(super) const LOOP_JOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("type", "[the type](loops.md)"),
    ],
    elements: &[
        Entry::read("link1", "a link, and the frame of the joint on it").with(&LOOP_END),
        Entry::read("link2", "a link, and the frame of the joint on it").with(&LOOP_END),
        Entry::read("axis", "the axis, in the frames of both").with(&AXIS),
        Entry::read("axis2", "the second axis, if the type has one").with(&AXIS),
        Entry::read("rod", "`length` of type `rod` \\[m\\]").with(&ROD),
    ],
    others: Others::Warned,
};

const LOOP_END: Content = Content {
    attributes: &[
        Entry::read("link", "the link"),
        Entry::read("xyz", "the translation"),
        Entry::read("rpy", "roll, pitch and yaw"),
        Entry::read("quat_xyzw", "the rotation"),
    ],
    elements: &[],
    others: Others::WarnedLikeText,
};

const ROD: Content = Content {
    attributes: &[Entry::read("length", "the length")],
    elements: &[],
    others: Others::WarnedLikeText,
};

const SECOND_ROBOT: NotModelled = NotModelled {
    what: "a second robot",
    hint: "a file describes one robot: move its links and joints into the first",
};

const VIRTUAL_JOINT: NotModelled = NotModelled {
    what: "a joint between the world and the robot",
    hint: "the base is fixed; free it with `floating`, or write a joint and a link for the world",
};

const JOINT_PROPERTIES: NotModelled = NotModelled {
    what: "damping and friction",
    hint: "write them as <dynamics damping=\"…\" friction=\"…\"/>, the syntax of URDF since 2010",
};

const AXIS_RPY: NotModelled = NotModelled {
    what: "a rotation of the axis",
    hint: "URDF has no such attribute: rotate the axis itself",
};

const ARMATURE: NotModelled = NotModelled {
    what: "the inertia of a rotor",
    hint: "set it with the key `armature` or `rotor`, or as <drake:rotor_inertia value=\"…\"/> in the \
           <actuator> of a <transmission>",
};

const OTHER_DYNAMICS: NotModelled = NotModelled {
    what: "other dynamics",
    hint: "<dynamics> has damping and friction",
};

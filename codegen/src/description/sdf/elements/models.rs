//! Elements of files, worlds, models and frames.

use super::pose::POSE;
use super::{OF_DRAKE, links};
use crate::description::xml::elements::{Content, Entry, Others};

/// The root element.
pub(super) static SDF: Content = Content {
    attributes: &[Entry::read(
        "version",
        "1.4 to 1.12; a warning if it is another",
    )],
    elements: &[
        Entry::read("model", "the robot").with(&MODEL),
        Entry::read("world", "its only movable model is the robot").with(&WORLD),
        Entry::ignored("actor", "animation"),
        Entry::ignored("light", "appearance"),
    ],
    others: Others::Warned,
};

pub(super) static WORLD: Content = Content {
    attributes: &[Entry::ignored("name", "unused")],
    elements: &[
        Entry::read("model", "the robot; static models are a warning").with(&MODEL),
        Entry::read("include", "a model of another file").with(&INCLUDE),
        Entry::read(
            "gravity",
            "the acceleration of gravity [m/s²], unless the key `gravity` sets another",
        ),
        Entry::ignored("actor", "animation"),
        Entry::ignored("atmosphere", "a setting of simulators"),
        Entry::ignored("audio", "sound"),
        Entry::ignored("frame", "frames of the world"),
        Entry::ignored("gui", "appearance"),
        Entry::ignored("joint", "joints of the world: write them in the model"),
        Entry::ignored("light", "appearance"),
        Entry::ignored("magnetic_field", "for sensors"),
        Entry::ignored("physics", "settings of the solver"),
        Entry::ignored("plugin", "plug-ins and their settings"),
        Entry::ignored("population", "copies of models"),
        Entry::ignored("road", "appearance"),
        Entry::ignored("scene", "appearance"),
        Entry::ignored("spherical_coordinates", "for sensors"),
        Entry::ignored("state", "a state of the simulation"),
        Entry::ignored("wind", "a setting of simulators"),
    ],
    others: Others::Warned,
};

pub(super) static MODEL: Content = Content {
    attributes: &[
        Entry::read(
            "name",
            "the robot's name; of a model in a model, the beginning of the names in it: `arm::link`",
        ),
        Entry::read(
            "canonical_link",
            "the link that the model's frame is attached to; the first by default",
        ),
        Entry::read(
            "placement_frame",
            "the frame that the pose places; the model's own by default",
        ),
    ],
    elements: &[
        Entry::read("link", "a body and its frame").with(&links::LINK),
        Entry::read("joint", "a joint").with(&links::JOINT),
        Entry::read("frame", "a link without mass").with(&FRAME),
        Entry::read("model", "a model in it").with(&MODEL),
        Entry::read("include", "a model of another file").with(&INCLUDE),
        Entry::read(
            "pose",
            "its placement in the model around it, or in the world",
        )
        .with(&POSE),
        Entry::read(
            "static",
            "`true`: a model that does not move; a warning in a world",
        ),
        Entry::ignored("allow_auto_disable", "a setting of simulators"),
        Entry::ignored("enable_wind", "a setting of simulators"),
        Entry::ignored("self_collide", "collision checks"),
        Entry::ignored("gripper", "a setting of simulators"),
        Entry::ignored("plugin", "plug-ins and their settings"),
        Entry::not_modelled("drake:joint", &OF_DRAKE),
        Entry::not_modelled("drake:linear_bushing_rpy", &OF_DRAKE),
        Entry::not_modelled("drake:linear_spring_damper", &OF_DRAKE),
        Entry::not_modelled("drake:ball_constraint", &OF_DRAKE),
        Entry::not_modelled("drake:distance_constraint", &OF_DRAKE),
        Entry::not_modelled("drake:weld_constraint", &OF_DRAKE),
        Entry::not_modelled("drake:tendon_constraint", &OF_DRAKE),
        Entry::ignored(
            "drake:collision_filter_group",
            "pairs of links whose collisions are ignored",
        ),
    ],
    others: Others::Warned,
};

pub(super) static INCLUDE: Content = Content {
    attributes: &[Entry::read(
        "merge",
        "`true`: its links, joints and frames become those of this model",
    )],
    elements: &[
        Entry::read(
            "uri",
            "`model://name`, the folder of a model beside the file or in `packages`, or a path beside the file",
        ),
        Entry::read("name", "the name of the model here"),
        Entry::read("pose", "its placement, instead of its own").with(&POSE),
        Entry::read("placement_frame", "the frame that the pose places"),
        Entry::read("static", "`true`: a model that does not move"),
        Entry::ignored("plugin", "plug-ins and their settings"),
        Entry::ignored("experimental:params", "changes of the included model"),
    ],
    others: Others::Warned,
};

pub(super) static FRAME: Content = Content {
    attributes: &[
        Entry::read("name", "the name of the link"),
        Entry::read(
            "attached_to",
            "the frame that it moves with; the model's by default",
        ),
    ],
    elements: &[Entry::read("pose", "its placement").with(&POSE)],
    others: Others::Warned,
};

//! `<pose>`.

use crate::description::xml::elements::{Content, Entry, Others};

pub(super) static POSE: Content = Content {
    attributes: &[
        Entry::read(
            "relative_to",
            "the frame that it is placed in: of links and models the model around them, of joints their child, of frames the frame that they are attached to by default",
        ),
        Entry::read("degrees", "`true`: angles in degrees"),
        Entry::read("rotation_format", "`euler_rpy`, or `quat_xyzw`"),
        Entry::ignored("frame", "unused by every reader"),
    ],
    elements: &[],
    others: Others::Warned,
};

//! Elements and attributes of the tree of bodies.

use super::lost::{GRAVCOMP, MOCAP, PLUGIN};
use crate::description::xml::elements::{Content, Entry, Others, When};

/// A body, and the world.
pub(super) static BODY: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("childclass", "the class of defaults of what stands in it"),
        Entry::read("pos", "where it is in the body that it stands in \\[m\\]"),
        Entry::read("quat", "the rotation; one of these alone"),
        Entry::read("axisangle", "the rotation; one of these alone"),
        Entry::read("xyaxes", "the rotation; one of these alone"),
        Entry::read("zaxis", "the rotation; one of these alone"),
        Entry::read("euler", "the rotation; one of these alone"),
        Entry::lost("mocap", &MOCAP).when(When::True),
        Entry::lost("gravcomp", &GRAVCOMP).when(When::NotZero),
        Entry::nothing("sleep", "a setting of the solver"),
        Entry::nothing("simple", "a setting of the solver"),
        Entry::nothing("user", "numbers of one's own"),
    ],
    elements: &[
        Entry::read("body", "a link, that moves by the joints in it").with(&BODY),
        Entry::read("frame", "a placement of what stands in it").with(&FRAME),
        Entry::read(
            "replicate",
            "as many copies, each placed by one more `offset` and `euler`",
        )
        .with(&REPLICATE),
        Entry::read("inertial", "mass, centre of mass and inertia").with(&INERTIAL),
        Entry::read("joint", "a joint; several of one body one after the other").with(&JOINT),
        Entry::read("freejoint", "a joint that leaves everything free").with(&FREEJOINT),
        Entry::read(
            "geom",
            "mass, where the body has no `<inertial>` or `inertiafromgeom` is true",
        )
        .with(&GEOM),
        Entry::read("site", "a link without mass, by its name").with(&SITE),
        Entry::nothing("camera", "what is seen"),
        Entry::nothing("light", "what is seen"),
        Entry::lost("plugin", &PLUGIN),
        Entry::read("attach", "a mistake: an attached model is not read"),
        Entry::read("composite", "a mistake: its bodies are not read"),
        Entry::read("flexcomp", "a mistake: its bodies are not read"),
    ],
    others: Others::Warned,
};

pub(super) static FRAME: Content = Content {
    attributes: &[
        Entry::read("name", "nothing refers to it"),
        Entry::read("childclass", "the class of defaults of what stands in it"),
        Entry::read("pos", "the translation"),
        Entry::read("quat", "the rotation; one of these alone"),
        Entry::read("axisangle", "the rotation; one of these alone"),
        Entry::read("xyaxes", "the rotation; one of these alone"),
        Entry::read("zaxis", "the rotation; one of these alone"),
        Entry::read("euler", "the rotation; one of these alone"),
    ],
    elements: &[
        Entry::read("body", "a link, that moves by the joints in it").with(&BODY),
        Entry::read("frame", "a placement of what stands in it").with(&FRAME),
        Entry::read(
            "replicate",
            "as many copies, each placed by one more `offset` and `euler`",
        )
        .with(&REPLICATE),
        Entry::read("inertial", "mass, centre of mass and inertia").with(&INERTIAL),
        Entry::read("joint", "a joint; several of one body one after the other").with(&JOINT),
        Entry::read("freejoint", "a joint that leaves everything free").with(&FREEJOINT),
        Entry::read(
            "geom",
            "mass, where the body has no `<inertial>` or `inertiafromgeom` is true",
        )
        .with(&GEOM),
        Entry::read("site", "a link without mass, by its name").with(&SITE),
        Entry::nothing("camera", "what is seen"),
        Entry::nothing("light", "what is seen"),
        Entry::lost("plugin", &PLUGIN),
        Entry::read("attach", "a mistake: an attached model is not read"),
        Entry::read("composite", "a mistake: its bodies are not read"),
        Entry::read("flexcomp", "a mistake: its bodies are not read"),
    ],
    others: Others::Warned,
};

pub(super) static REPLICATE: Content = Content {
    attributes: &[
        Entry::read("count", "how many"),
        Entry::read("offset", "the translation from one to the next"),
        Entry::read("euler", "the rotation from one to the next"),
        Entry::read(
            "sep",
            "what stands between a name and the number of the copy",
        ),
        Entry::read("childclass", "the class of defaults of what stands in it"),
    ],
    elements: &[
        Entry::read("body", "a link, that moves by the joints in it").with(&BODY),
        Entry::read("frame", "a placement of what stands in it").with(&FRAME),
        Entry::read(
            "replicate",
            "as many copies, each placed by one more `offset` and `euler`",
        )
        .with(&REPLICATE),
        Entry::read("inertial", "mass, centre of mass and inertia").with(&INERTIAL),
        Entry::read("joint", "a joint; several of one body one after the other").with(&JOINT),
        Entry::read("freejoint", "a joint that leaves everything free").with(&FREEJOINT),
        Entry::read(
            "geom",
            "mass, where the body has no `<inertial>` or `inertiafromgeom` is true",
        )
        .with(&GEOM),
        Entry::read("site", "a link without mass, by its name").with(&SITE),
        Entry::nothing("camera", "what is seen"),
        Entry::nothing("light", "what is seen"),
        Entry::lost("plugin", &PLUGIN),
        Entry::read("attach", "a mistake: an attached model is not read"),
        Entry::read("composite", "a mistake: its bodies are not read"),
        Entry::read("flexcomp", "a mistake: its bodies are not read"),
    ],
    others: Others::Warned,
};

pub(super) static INERTIAL: Content = Content {
    attributes: &[
        Entry::read("pos", "the centre of mass"),
        Entry::read("mass", "the mass \\[kg\\]"),
        Entry::read("diaginertia", "the principal moments [kg m²]"),
        Entry::read(
            "fullinertia",
            "xx, yy, zz, xy, xz, yz in the axes of the body",
        ),
        Entry::read(
            "quat",
            "the principal axes; one of these alone, and none beside `fullinertia`",
        ),
        Entry::read(
            "axisangle",
            "the principal axes; one of these alone, and none beside `fullinertia`",
        ),
        Entry::read(
            "xyaxes",
            "the principal axes; one of these alone, and none beside `fullinertia`",
        ),
        Entry::read(
            "zaxis",
            "the principal axes; one of these alone, and none beside `fullinertia`",
        ),
        Entry::read(
            "euler",
            "the principal axes; one of these alone, and none beside `fullinertia`",
        ),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(super) static JOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name, and that of its coordinate"),
        Entry::read("class", "its class of defaults"),
        Entry::read(
            "type",
            "`hinge` is `revolute`, or `continuous` without limits; `slide` is `prismatic`, `ball` `spherical`, `free` `floating`",
        ),
        Entry::read("pos", "where its axis goes through"),
        Entry::read("axis", "the direction"),
        Entry::read("range", "the range of the coordinate; of a ball, a warning"),
        Entry::read("limited", "whether there is a range"),
        Entry::read("ref", "the coordinate as described"),
        Entry::read(
            "armature",
            "reflected inertia, where `rotors` asks for it, and a warning where not",
        ),
        Entry::read(
            "damping",
            "viscous friction, where `friction` asks for it, and a warning where not; a warning of its quadratic and cubic parts",
        ),
        Entry::read(
            "frictionloss",
            "Coulomb friction, where `friction` asks for it, and a warning where not",
        ),
        Entry::read("stiffness", "a warning where it is not 0"),
        Entry::read("springdamper", "a warning where it is not 0"),
        Entry::read(
            "actuatorfrcrange",
            "the largest torque or force, of which nothing is computed",
        ),
        Entry::read("actuatorfrclimited", "whether there is such a range"),
        Entry::nothing("springref", "it belongs to a spring"),
        Entry::nothing("group", "what is seen"),
        Entry::nothing("margin", "a setting of the solver"),
        Entry::nothing("solreflimit", "a setting of the solver"),
        Entry::nothing("solimplimit", "a setting of the solver"),
        Entry::nothing("solreffriction", "a setting of the solver"),
        Entry::nothing("solimpfriction", "a setting of the solver"),
        Entry::nothing("actuatorgravcomp", "it belongs to `gravcomp`"),
        Entry::nothing("user", "numbers of one's own"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(super) static FREEJOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read(
            "align",
            "a warning where MuJoCo moves the body's frame to its inertial frame",
        ),
        Entry::nothing("group", "what is seen"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(super) static GEOM: Content = Content {
    attributes: &[
        Entry::read("name", "messages name it"),
        Entry::read("class", "its class of defaults"),
        Entry::read("type", "the shape"),
        Entry::read("size", "radii and half lengths \\[m\\]"),
        Entry::read("fromto", "the ends of its axis"),
        Entry::read("pos", "where it is"),
        Entry::read("quat", "the rotation; one of these alone"),
        Entry::read("axisangle", "the rotation; one of these alone"),
        Entry::read("xyaxes", "the rotation; one of these alone"),
        Entry::read("zaxis", "the rotation; one of these alone"),
        Entry::read("euler", "the rotation; one of these alone"),
        Entry::read("mass", "the mass"),
        Entry::read(
            "density",
            "the mass of a volume; 1000 kg/m³ where neither is written",
        ),
        Entry::read("shellinertia", "whether it is hollow"),
        Entry::read("group", "whether it has mass, by `inertiagrouprange`"),
        Entry::read("mesh", "the mesh that it is"),
        Entry::nothing("contype", "how it touches"),
        Entry::nothing("conaffinity", "how it touches"),
        Entry::nothing("condim", "how it touches"),
        Entry::nothing("priority", "how it touches"),
        Entry::nothing("friction", "how it touches"),
        Entry::nothing("solmix", "how it touches"),
        Entry::nothing("solref", "how it touches"),
        Entry::nothing("solimp", "how it touches"),
        Entry::nothing("margin", "how it touches"),
        Entry::nothing("gap", "how it touches"),
        Entry::nothing("surfacevel", "how it touches"),
        Entry::nothing("adhesion", "how it touches"),
        Entry::nothing("hfield", "how it touches"),
        Entry::nothing("material", "what is seen"),
        Entry::nothing("rgba", "what is seen"),
        Entry::read(
            "fitscale",
            "a mistake where it is needed: a mass of a shape that is fitted to a mesh is not read",
        ),
        Entry::nothing("fluidshape", "`density` of `<option>` is warned of"),
        Entry::nothing("fluidcoef", "`density` of `<option>` is warned of"),
        Entry::nothing("user", "numbers of one's own"),
    ],
    elements: &[Entry::nothing("plugin", "a shape for contacts")],
    others: Others::Warned,
};

pub(super) static SITE: Content = Content {
    attributes: &[
        Entry::read("name", "that of the link; without one it is passed over"),
        Entry::read("class", "its class of defaults"),
        Entry::read("pos", "where it is"),
        Entry::read("fromto", "the ends of its axis"),
        Entry::read("quat", "the rotation; one of these alone"),
        Entry::read("axisangle", "the rotation; one of these alone"),
        Entry::read("xyaxes", "the rotation; one of these alone"),
        Entry::read("zaxis", "the rotation; one of these alone"),
        Entry::read("euler", "the rotation; one of these alone"),
        Entry::nothing("type", "what is seen"),
        Entry::nothing("group", "what is seen"),
        Entry::nothing("material", "what is seen"),
        Entry::nothing("size", "what is seen"),
        Entry::nothing("rgba", "what is seen"),
        Entry::nothing("user", "numbers of one's own"),
    ],
    elements: &[],
    others: Others::Warned,
};

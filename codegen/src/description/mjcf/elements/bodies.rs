//! Elements and attributes of the tree of bodies.

use super::unmodelled::{GRAVCOMP, MOCAP, PLUGIN};
use crate::description::xml::elements::{Content, Entry, Others, When};

/// Elements in a body, whether directly or in a frame or a replicate there.
static IN_BODIES: [Entry; 14] = [
    Entry::read("body", "a link that moves by its joints").with(&BODY),
    Entry::read("frame", "a placement of the elements inside").with(&FRAME),
    Entry::read(
        "replicate",
        "copies of the elements inside, each placed by one more `offset` and `euler`",
    )
    .with(&REPLICATE),
    Entry::read("inertial", "mass, centre of mass and inertia").with(&INERTIAL),
    Entry::read("joint", "a joint; several of one body are in series").with(&JOINT),
    Entry::read("freejoint", "a floating joint").with(&FREEJOINT),
    Entry::read(
        "geom",
        "mass, if the body has no `<inertial>` or `inertiafromgeom` is true",
    )
    .with(&GEOM),
    Entry::read("site", "a massless link with its name").with(&SITE),
    Entry::ignored("camera", "visual"),
    Entry::ignored("light", "visual"),
    Entry::not_modelled("plugin", &PLUGIN),
    Entry::read(
        "attach",
        "a copy of a body, a frame or the world of another model, or of a body or a frame of this one",
    )
    .with(&ATTACH),
    Entry::read("composite", "an error: its bodies are not read"),
    Entry::read(
        "flexcomp",
        "an error: its bodies are not read; ignored if `rigid` is true, because then it has none",
    ),
];

/// A body, and the world.
pub(super) static BODY: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("childclass", "the class of defaults of the elements inside"),
        Entry::read("pos", "the position in the parent's frame \\[m\\]"),
        Entry::read("quat", "the rotation; only one of these five"),
        Entry::read("axisangle", "the rotation; only one of these five"),
        Entry::read("xyaxes", "the rotation; only one of these five"),
        Entry::read("zaxis", "the rotation; only one of these five"),
        Entry::read("euler", "the rotation; only one of these five"),
        Entry::not_modelled("mocap", &MOCAP).when(When::True),
        Entry::not_modelled("gravcomp", &GRAVCOMP).when(When::NotZero),
        Entry::ignored("sleep", "a setting of the solver"),
        Entry::ignored("simple", "a setting of the solver"),
        Entry::ignored("user", "user data"),
    ],
    elements: &IN_BODIES,
    others: Others::Warned,
};

pub(super) static FRAME: Content = Content {
    attributes: &[
        Entry::read("name", "its name, for `<attach>`"),
        Entry::read("childclass", "the class of defaults of the elements inside"),
        Entry::read("pos", "the translation"),
        Entry::read("quat", "the rotation; only one of these five"),
        Entry::read("axisangle", "the rotation; only one of these five"),
        Entry::read("xyaxes", "the rotation; only one of these five"),
        Entry::read("zaxis", "the rotation; only one of these five"),
        Entry::read("euler", "the rotation; only one of these five"),
    ],
    elements: &IN_BODIES,
    others: Others::Warned,
};

pub(super) static REPLICATE: Content = Content {
    attributes: &[
        Entry::read("count", "the number of copies"),
        Entry::read("offset", "the translation from one to the next"),
        Entry::read("euler", "the rotation from one to the next"),
        Entry::read("sep", "text between a name and the number of the copy"),
        Entry::read("childclass", "the class of defaults of the elements inside"),
    ],
    elements: &IN_BODIES,
    others: Others::Warned,
};

pub(super) static ATTACH: Content = Content {
    attributes: &[
        Entry::read(
            "model",
            "the name of another model; this one if it is not written",
        ),
        Entry::read("body", "the body that is attached, with its subtree"),
        Entry::read(
            "frame",
            "the frame that is attached, with the elements inside",
        ),
        Entry::read("prefix", "text before all names"),
    ],
    elements: &[],
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
            "the principal axes; only one of these, and none beside `fullinertia`",
        ),
        Entry::read(
            "axisangle",
            "the principal axes; only one of these, and none beside `fullinertia`",
        ),
        Entry::read(
            "xyaxes",
            "the principal axes; only one of these, and none beside `fullinertia`",
        ),
        Entry::read(
            "zaxis",
            "the principal axes; only one of these, and none beside `fullinertia`",
        ),
        Entry::read(
            "euler",
            "the principal axes; only one of these, and none beside `fullinertia`",
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
        Entry::read(
            "pos",
            "a point of the axis, in the frame of the body \\[m\\]",
        ),
        Entry::read("axis", "the direction of the axis"),
        Entry::read("range", "the range of the coordinate; of a ball, a warning"),
        Entry::read("limited", "`true` or `false`: if the range is a limit"),
        Entry::read("ref", "the coordinate of the described configuration"),
        Entry::read(
            "armature",
            "reflected inertia, with the key `rotors`; otherwise a warning",
        ),
        Entry::read(
            "damping",
            "viscous friction, with the key `friction`; otherwise a warning; always a warning of quadratic and cubic parts",
        ),
        Entry::read(
            "frictionloss",
            "Coulomb friction, with the key `friction`; otherwise a warning",
        ),
        Entry::read("stiffness", "a warning if it is not 0"),
        Entry::read("springdamper", "a warning if it is not 0"),
        Entry::read("actuatorfrcrange", "the effort limit"),
        Entry::read(
            "actuatorfrclimited",
            "`true` or `false`: if that range is a limit",
        ),
        Entry::ignored("springref", "part of a spring"),
        Entry::ignored("group", "visual"),
        Entry::ignored("margin", "a setting of the solver"),
        Entry::ignored("solreflimit", "a setting of the solver"),
        Entry::ignored("solimplimit", "a setting of the solver"),
        Entry::ignored("solreffriction", "a setting of the solver"),
        Entry::ignored("solimpfriction", "a setting of the solver"),
        Entry::ignored("actuatorgravcomp", "part of `gravcomp`"),
        Entry::ignored("user", "user data"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(super) static FREEJOINT: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read(
            "align",
            "a warning if MuJoCo moves the body's frame to its inertial frame",
        ),
        Entry::ignored("group", "visual"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(super) static GEOM: Content = Content {
    attributes: &[
        Entry::read("name", "its name, used in messages"),
        Entry::read("class", "its class of defaults"),
        Entry::read("type", "the shape"),
        Entry::read("size", "radii and half lengths \\[m\\]"),
        Entry::read("fromto", "the ends of its axis"),
        Entry::read("pos", "the position of its centre"),
        Entry::read("quat", "the rotation; only one of these five"),
        Entry::read("axisangle", "the rotation; only one of these five"),
        Entry::read("xyaxes", "the rotation; only one of these five"),
        Entry::read("zaxis", "the rotation; only one of these five"),
        Entry::read("euler", "the rotation; only one of these five"),
        Entry::read("mass", "the mass"),
        Entry::read("density", "the density; 1000 kg/m³ if neither is written"),
        Entry::read("shellinertia", "`true`: the shape is hollow"),
        Entry::read(
            "group",
            "the geom has mass if this is in `inertiagrouprange`",
        ),
        Entry::read("mesh", "its mesh; that to which another shape is fitted"),
        Entry::ignored("contype", "contacts"),
        Entry::ignored("conaffinity", "contacts"),
        Entry::ignored("condim", "contacts"),
        Entry::ignored("priority", "contacts"),
        Entry::ignored("friction", "contacts"),
        Entry::ignored("solmix", "contacts"),
        Entry::ignored("solref", "contacts"),
        Entry::ignored("solimp", "contacts"),
        Entry::ignored("margin", "contacts"),
        Entry::ignored("gap", "contacts"),
        Entry::ignored("surfacevel", "contacts"),
        Entry::ignored("adhesion", "contacts"),
        Entry::read(
            "hfield",
            "its height field: a box of its extents, as in MuJoCo",
        ),
        Entry::ignored("material", "visual"),
        Entry::ignored("rgba", "visual"),
        Entry::read(
            "fitscale",
            "a factor for the size of a shape fitted to a mesh",
        ),
        Entry::ignored(
            "fluidshape",
            "part of fluid forces, see `density` of `<option>`",
        ),
        Entry::ignored(
            "fluidcoef",
            "part of fluid forces, see `density` of `<option>`",
        ),
        Entry::ignored("user", "user data"),
    ],
    elements: &[Entry::ignored("plugin", "a shape for contacts")],
    others: Others::Warned,
};

pub(super) static SITE: Content = Content {
    attributes: &[
        Entry::read(
            "name",
            "the name of the link; a site without a name is ignored",
        ),
        Entry::read("class", "its class of defaults"),
        Entry::read("pos", "the position"),
        Entry::read("fromto", "the ends of its axis"),
        Entry::read("quat", "the rotation; only one of these five"),
        Entry::read("axisangle", "the rotation; only one of these five"),
        Entry::read("xyaxes", "the rotation; only one of these five"),
        Entry::read("zaxis", "the rotation; only one of these five"),
        Entry::read("euler", "the rotation; only one of these five"),
        Entry::ignored("type", "visual"),
        Entry::ignored("group", "visual"),
        Entry::ignored("material", "visual"),
        Entry::ignored("size", "visual"),
        Entry::ignored("rgba", "visual"),
        Entry::ignored("user", "user data"),
    ],
    elements: &[],
    others: Others::Warned,
};

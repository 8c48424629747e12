//! Elements and attributes of settings, defaults and assets.

use super::unmodelled::{FLUID, MUSCLE};
use super::{actors, bodies};
use crate::description::xml::elements::{Content, Entry, Others, When};

pub(in crate::description::mjcf) static COMPILER: Content = Content {
    attributes: &[
        Entry::read("angle", "`degree`, unless `radian` is written"),
        Entry::read(
            "eulerseq",
            "the axes of `euler`; capital letters are fixed axes",
        ),
        Entry::read("autolimits", "`true`: a range is a limit without `limited`"),
        Entry::read(
            "inertiafromgeom",
            "inertias from geoms: `false`, `true`, or `auto` (bodies without `<inertial>`)",
        ),
        Entry::read("inertiagrouprange", "the groups of geoms that have mass"),
        Entry::read("boundmass", "the minimum mass of a body \\[kg\\]"),
        Entry::read(
            "boundinertia",
            "the minimum principal moment of a body [kg m²]",
        ),
        Entry::read(
            "balanceinertia",
            "non-physical principal moments are replaced by their mean",
        ),
        Entry::read(
            "settotalmass",
            "all masses and inertias are scaled to this mass",
        ),
        Entry::read("coordinate", "`global` is an error"),
        Entry::read("assetdir", "the folder of meshes"),
        Entry::read("meshdir", "the folder of meshes"),
        Entry::read("strippath", "`true` drops folders in the names of meshes"),
        Entry::read(
            "alignfree",
            "a warning if MuJoCo moves frames of free bodies",
        ),
        Entry::ignored("fusestatic", "bodies without joints stay links, at no cost"),
        Entry::read(
            "fitaabb",
            "`true`: a shape is fitted to the extents of its mesh along the principal axes, instead of its moments",
        ),
        Entry::ignored("texturedir", "visual"),
        Entry::ignored("discardvisual", "visual"),
        Entry::ignored("usethread", "a setting of the solver"),
        Entry::ignored("saveinertial", "for saving"),
        Entry::read(
            "conflict",
            "`merge` uses the gravity of an attached model if this one has none, `error` rejects another one",
        ),
    ],
    elements: &[Entry::ignored("lengthrange", "control of actuators")],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static OPTION: Content = Content {
    attributes: &[
        Entry::read(
            "gravity",
            "the acceleration of gravity, unless the key `gravity` sets another",
        ),
        Entry::not_modelled("density", &FLUID).when(When::NotZero),
        Entry::not_modelled("viscosity", &FLUID).when(When::NotZero),
        Entry::ignored("wind", "part of fluid forces, see `density`"),
        Entry::ignored("magnetic", "for sensors"),
        Entry::ignored("timestep", "a setting of the solver"),
        Entry::ignored("impratio", "a setting of the solver"),
        Entry::ignored("tolerance", "a setting of the solver"),
        Entry::ignored("ls_tolerance", "a setting of the solver"),
        Entry::ignored("noslip_tolerance", "a setting of the solver"),
        Entry::ignored("ccd_tolerance", "a setting of the solver"),
        Entry::ignored("sleep_tolerance", "a setting of the solver"),
        Entry::ignored("o_margin", "a setting of the solver"),
        Entry::ignored("o_solref", "a setting of the solver"),
        Entry::ignored("o_solimp", "a setting of the solver"),
        Entry::ignored("o_friction", "a setting of the solver"),
        Entry::ignored("integrator", "a setting of the solver"),
        Entry::ignored("cone", "a setting of the solver"),
        Entry::ignored("jacobian", "a setting of the solver"),
        Entry::ignored("solver", "a setting of the solver"),
        Entry::ignored("iterations", "a setting of the solver"),
        Entry::ignored("ls_iterations", "a setting of the solver"),
        Entry::ignored("noslip_iterations", "a setting of the solver"),
        Entry::ignored("ccd_iterations", "a setting of the solver"),
        Entry::ignored("sdf_iterations", "a setting of the solver"),
        Entry::ignored("sdf_initpoints", "a setting of the solver"),
        Entry::ignored("actuatorgroupdisable", "a setting of the solver"),
    ],
    elements: &[Entry::read("flag", "gravity").with(&FLAG)],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static FLAG: Content = Content {
    attributes: &[
        Entry::read("gravity", "`disable` sets gravity to 0"),
        Entry::ignored("constraint", "a setting of the solver"),
        Entry::ignored("equality", "a setting of the solver"),
        Entry::ignored("frictionloss", "a setting of the solver"),
        Entry::ignored("limit", "a setting of the solver"),
        Entry::ignored("contact", "a setting of the solver"),
        Entry::ignored("spring", "a setting of the solver"),
        Entry::ignored("damper", "a setting of the solver"),
        Entry::ignored("clampctrl", "a setting of the solver"),
        Entry::ignored("warmstart", "a setting of the solver"),
        Entry::ignored("filterparent", "a setting of the solver"),
        Entry::ignored("actuation", "a setting of the solver"),
        Entry::ignored("refsafe", "a setting of the solver"),
        Entry::ignored("sensor", "a setting of the solver"),
        Entry::ignored("midphase", "a setting of the solver"),
        Entry::ignored("eulerdamp", "a setting of the solver"),
        Entry::ignored("autoreset", "a setting of the solver"),
        Entry::ignored("nativeccd", "a setting of the solver"),
        Entry::ignored("island", "a setting of the solver"),
        Entry::ignored("multiccd", "a setting of the solver"),
        Entry::ignored("override", "a setting of the solver"),
        Entry::ignored("energy", "a setting of the solver"),
        Entry::ignored("fwdinv", "a setting of the solver"),
        Entry::ignored("invdiscrete", "a setting of the solver"),
        Entry::ignored("sleep", "a setting of the solver"),
        Entry::ignored("diagexact", "a setting of the solver"),
        Entry::ignored("passive", "a setting of the solver"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static DEFAULT: Content = Content {
    attributes: &[Entry::read("class", "its name")],
    elements: &[
        Entry::read(
            "default",
            "a class that inherits the attributes of this one",
        )
        .with(&DEFAULT),
        Entry::read("joint", "attributes of joints").with(&bodies::JOINT),
        Entry::read("geom", "attributes of geoms").with(&bodies::GEOM),
        Entry::read("site", "attributes of sites").with(&bodies::SITE),
        Entry::read("mesh", "attributes of meshes").with(&MESH),
        Entry::read("equality", "`active` of constraints").with(&actors::CONSTRAINT),
        Entry::ignored("tendon", "a warning of springs, friction and inertia")
            .with(&actors::TENDON),
        Entry::ignored("material", "visual"),
        Entry::ignored("camera", "visual"),
        Entry::ignored("light", "visual"),
        Entry::ignored("pair", "contacts"),
        Entry::read("general", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("motor", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("position", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("velocity", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("intvelocity", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("orientation", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("pid", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("damper", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("cylinder", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("adhesion", "gears and armatures").with(&actors::ACTUATOR),
        Entry::read("dcmotor", "gears and armatures").with(&actors::ACTUATOR),
        Entry::not_modelled("muscle", &MUSCLE),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ASSET: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("mesh", "a mesh").with(&MESH),
        Entry::read("model", "a model in another file, for `<attach>`").with(&MODEL),
        Entry::read("hfield", "a height field").with(&HEIGHT_FIELD),
        Entry::ignored("texture", "visual"),
        Entry::ignored("material", "visual"),
        Entry::ignored("skin", "visual"),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static MODEL: Content = Content {
    attributes: &[
        Entry::read(
            "name",
            "its name; that in its own file if it is not written",
        ),
        Entry::read(
            "file",
            "an MJCF file, in the folder of the first file or below it",
        ),
        Entry::ignored("content_type", "the file is MJCF"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static HEIGHT_FIELD: Content = Content {
    attributes: &[
        Entry::read(
            "name",
            "its name; the name of the file without its ending if it is not written",
        ),
        Entry::read("size", "its extents, height and depth \\[m\\]"),
        Entry::ignored("file", "contacts"),
        Entry::ignored("content_type", "contacts"),
        Entry::ignored("nrow", "contacts"),
        Entry::ignored("ncol", "contacts"),
        Entry::ignored("elevation", "contacts"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static MESH: Content = Content {
    attributes: &[
        Entry::read(
            "name",
            "its name; the name of the file without its ending if it is not written",
        ),
        Entry::read("class", "its class of defaults"),
        Entry::read(
            "file",
            "an STL, OBJ or MSH file, opened only where its volume is needed",
        ),
        Entry::read("vertex", "its vertices"),
        Entry::read(
            "face",
            "its triangles; a mesh without faces is its convex hull",
        ),
        Entry::read("scale", "a factor for each axis"),
        Entry::read("refpos", "the origin in the file"),
        Entry::read("refquat", "the axes in the file"),
        Entry::read(
            "inertia",
            "`legacy`, unless `exact`, `shell` or `convex` is written",
        ),
        Entry::read("builtin", "an error where its volume is needed"),
        Entry::read("params", "an error where its volume is needed"),
        Entry::ignored("content_type", "the format follows from the file's ending"),
        Entry::ignored("normal", "visual"),
        Entry::ignored("texcoord", "visual"),
        Entry::ignored("smoothnormal", "visual"),
        Entry::read("maxhullvert", "an error where the convex hull has the mass"),
        Entry::ignored("material", "visual"),
    ],
    elements: &[Entry::read("plugin", "an error where its volume is needed")],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static KEYFRAME: Content = Content {
    attributes: &[],
    elements: &[Entry::read("key", "a configuration, if it has a name and `qpos`").with(&KEY)],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static KEY: Content = Content {
    attributes: &[
        Entry::read("name", "its name"),
        Entry::read("qpos", "its coordinates, listed by `homogen check`"),
        Entry::ignored("time", "a state of the simulation"),
        Entry::ignored("qvel", "a state of the simulation"),
        Entry::ignored("act", "a state of the simulation"),
        Entry::ignored("ctrl", "a state of the simulation"),
        Entry::ignored("mpos", "a state of the simulation"),
        Entry::ignored("mquat", "a state of the simulation"),
    ],
    elements: &[],
    others: Others::Warned,
};

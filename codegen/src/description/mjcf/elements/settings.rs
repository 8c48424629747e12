//! Elements and attributes of settings, defaults and assets.

use super::lost::{FLUID, MUSCLE};
use super::{actors, bodies};
use crate::description::xml::elements::{Content, Entry, Others, When};

pub(in crate::description::mjcf) static COMPILER: Content = Content {
    attributes: &[
        Entry::read("angle", "`degree`, unless `radian` is written"),
        Entry::read(
            "eulerseq",
            "the axes of `euler`; capital letters are fixed axes",
        ),
        Entry::read("autolimits", "whether a range is a limit"),
        Entry::read("inertiafromgeom", "whether inertias are those of geoms"),
        Entry::read("inertiagrouprange", "the groups of geoms that have mass"),
        Entry::read("boundmass", "the least mass of a body"),
        Entry::read("boundinertia", "the least principal moment of a body"),
        Entry::read(
            "balanceinertia",
            "moments that no body has are replaced by their mean",
        ),
        Entry::read(
            "settotalmass",
            "all masses and inertias are scaled to this mass",
        ),
        Entry::read("coordinate", "`global` is a mistake"),
        Entry::read("assetdir", "the folder of meshes"),
        Entry::read("meshdir", "the folder of meshes"),
        Entry::read(
            "strippath",
            "whether folders in the names of meshes are left out",
        ),
        Entry::read(
            "alignfree",
            "a warning where MuJoCo moves frames of free bodies",
        ),
        Entry::nothing(
            "fusestatic",
            "bodies without joints stay links, and cost nothing",
        ),
        Entry::nothing(
            "fitaabb",
            "shapes that are fitted to meshes have no mass here",
        ),
        Entry::nothing("texturedir", "what is seen"),
        Entry::nothing("discardvisual", "what is seen"),
        Entry::nothing("usethread", "a setting of the solver"),
        Entry::nothing("saveinertial", "how MuJoCo saves"),
        Entry::nothing("conflict", "how models are attached"),
    ],
    elements: &[Entry::nothing("lengthrange", "of actuators")],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static OPTION: Content = Content {
    attributes: &[
        Entry::read(
            "gravity",
            "the acceleration of gravity, unless `gravity` asks for another",
        ),
        Entry::lost("density", &FLUID).when(When::NotZero),
        Entry::lost("viscosity", &FLUID).when(When::NotZero),
        Entry::nothing("wind", "it belongs to `density`"),
        Entry::nothing("magnetic", "of sensors"),
        Entry::nothing("timestep", "a setting of the solver"),
        Entry::nothing("impratio", "a setting of the solver"),
        Entry::nothing("tolerance", "a setting of the solver"),
        Entry::nothing("ls_tolerance", "a setting of the solver"),
        Entry::nothing("noslip_tolerance", "a setting of the solver"),
        Entry::nothing("ccd_tolerance", "a setting of the solver"),
        Entry::nothing("sleep_tolerance", "a setting of the solver"),
        Entry::nothing("o_margin", "a setting of the solver"),
        Entry::nothing("o_solref", "a setting of the solver"),
        Entry::nothing("o_solimp", "a setting of the solver"),
        Entry::nothing("o_friction", "a setting of the solver"),
        Entry::nothing("integrator", "a setting of the solver"),
        Entry::nothing("cone", "a setting of the solver"),
        Entry::nothing("jacobian", "a setting of the solver"),
        Entry::nothing("solver", "a setting of the solver"),
        Entry::nothing("iterations", "a setting of the solver"),
        Entry::nothing("ls_iterations", "a setting of the solver"),
        Entry::nothing("noslip_iterations", "a setting of the solver"),
        Entry::nothing("ccd_iterations", "a setting of the solver"),
        Entry::nothing("sdf_iterations", "a setting of the solver"),
        Entry::nothing("sdf_initpoints", "a setting of the solver"),
        Entry::nothing("actuatorgroupdisable", "a setting of the solver"),
    ],
    elements: &[Entry::read("flag", "gravity").with(&FLAG)],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static FLAG: Content = Content {
    attributes: &[
        Entry::read("gravity", "whether there is gravity"),
        Entry::nothing("constraint", "a setting of the solver"),
        Entry::nothing("equality", "a setting of the solver"),
        Entry::nothing("frictionloss", "a setting of the solver"),
        Entry::nothing("limit", "a setting of the solver"),
        Entry::nothing("contact", "a setting of the solver"),
        Entry::nothing("spring", "a setting of the solver"),
        Entry::nothing("damper", "a setting of the solver"),
        Entry::nothing("clampctrl", "a setting of the solver"),
        Entry::nothing("warmstart", "a setting of the solver"),
        Entry::nothing("filterparent", "a setting of the solver"),
        Entry::nothing("actuation", "a setting of the solver"),
        Entry::nothing("refsafe", "a setting of the solver"),
        Entry::nothing("sensor", "a setting of the solver"),
        Entry::nothing("midphase", "a setting of the solver"),
        Entry::nothing("eulerdamp", "a setting of the solver"),
        Entry::nothing("autoreset", "a setting of the solver"),
        Entry::nothing("nativeccd", "a setting of the solver"),
        Entry::nothing("island", "a setting of the solver"),
        Entry::nothing("multiccd", "a setting of the solver"),
        Entry::nothing("override", "a setting of the solver"),
        Entry::nothing("energy", "a setting of the solver"),
        Entry::nothing("fwdinv", "a setting of the solver"),
        Entry::nothing("invdiscrete", "a setting of the solver"),
        Entry::nothing("sleep", "a setting of the solver"),
        Entry::nothing("diagexact", "a setting of the solver"),
        Entry::nothing("passive", "a setting of the solver"),
    ],
    elements: &[],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static DEFAULT: Content = Content {
    attributes: &[Entry::read("class", "its name")],
    elements: &[
        Entry::read("default", "a class, which begins with what this one has").with(&DEFAULT),
        Entry::read("joint", "attributes of joints").with(&bodies::JOINT),
        Entry::read("geom", "attributes of geoms").with(&bodies::GEOM),
        Entry::read("site", "attributes of sites").with(&bodies::SITE),
        Entry::read("mesh", "attributes of meshes").with(&MESH),
        Entry::read("equality", "whether constraints are active").with(&actors::CONSTRAINT),
        Entry::nothing("tendon", "its springs, friction and inertia are warned of")
            .with(&actors::TENDON),
        Entry::nothing("material", "what is seen"),
        Entry::nothing("camera", "what is seen"),
        Entry::nothing("light", "what is seen"),
        Entry::nothing("pair", "how it touches"),
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
        Entry::lost("muscle", &MUSCLE),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static ASSET: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("mesh", "a mesh").with(&MESH),
        Entry::read("model", "a mistake where it is attached"),
        Entry::nothing("hfield", "how it touches"),
        Entry::nothing("texture", "what is seen"),
        Entry::nothing("material", "what is seen"),
        Entry::nothing("skin", "what is seen"),
    ],
    others: Others::Warned,
};

pub(in crate::description::mjcf) static MESH: Content = Content {
    attributes: &[
        Entry::read("name", "its name; that of its file where it has none"),
        Entry::read("class", "its class of defaults"),
        Entry::read(
            "file",
            "an STL, OBJ or MSH file, read where its volume is needed",
        ),
        Entry::read("vertex", "its vertices"),
        Entry::read("face", "its triangles"),
        Entry::read("scale", "a factor for each axis"),
        Entry::read("refpos", "the origin in the file"),
        Entry::read("refquat", "the axes in the file"),
        Entry::read(
            "inertia",
            "`legacy`, unless `exact` or `shell` is written; `convex` is a mistake where it is needed",
        ),
        Entry::read("builtin", "a mistake where its volume is needed"),
        Entry::read("params", "a mistake where its volume is needed"),
        Entry::nothing("content_type", "the file's ending tells"),
        Entry::nothing("normal", "what is seen"),
        Entry::nothing("texcoord", "what is seen"),
        Entry::nothing("smoothnormal", "what is seen"),
        Entry::nothing("maxhullvert", "how it touches"),
        Entry::nothing("material", "what is seen"),
    ],
    elements: &[Entry::read(
        "plugin",
        "a mistake where its volume is needed",
    )],
    others: Others::Warned,
};

//! Everything that may stand in an MJCF file, and what becomes of it.
//!
//! In: nothing. Out: the table of MuJoCo 4, and what of its mechanics is lost. It never reads a number.

mod bodies;

use super::element::Element;
use crate::description::xml::elements::{Content, Entry, Format, Lost, Others, When};

/// The format.
pub(super) static MJCF: Format = Format {
    root: &MUJOCO,
    places: &PLACES,
    called: &[
        ("mujoco", "model"),
        ("body", "body"),
        ("joint", "joint"),
        ("geom", "geom"),
        ("site", "site"),
        ("mesh", "mesh"),
    ],
    counted: &["body", "joint", "inertial", "geom"],
    elsewhere: &["include"],
};

/// What is refused of coordinates that older versions had.
pub(super) const GLOBAL: &str = "coordinates are global, which MuJoCo itself no longer reads";

/// The root element.
static MUJOCO: Content = Content {
    attributes: &[Entry::read("model", "the robot's name")],
    elements: &[
        Entry::read(
            "compiler",
            "settings; a later one replaces an earlier one, attribute by attribute",
        )
        .with(&COMPILER),
        Entry::read("option", "gravity").with(&OPTION),
        Entry::read("default", "classes of attributes").with(&DEFAULT),
        Entry::read("worldbody", "the fixed base, and what stands in it").with(&bodies::BODY),
        Entry::read("asset", "meshes, whose volume is needed").with(&ASSET),
        Entry::read("equality", "mimic joints and closed loops").with(&EQUALITY),
        Entry::read(
            "actuator",
            "armatures of actuators, where `rotors` asks for them",
        )
        .with(&ACTUATORS),
        Entry::nothing(
            "tendon",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&TENDONS),
        Entry::nothing("deformable", "the mechanics in it are warned of").with(&DEFORMABLE),
        Entry::nothing("size", "memory"),
        Entry::nothing("statistic", "what is seen"),
        Entry::nothing("visual", "what is seen"),
        Entry::nothing("contact", "how it touches"),
        Entry::nothing("sensor", "sensors"),
        Entry::nothing("keyframe", "configurations by name"),
        Entry::nothing("custom", "numbers of one's own"),
        Entry::nothing("extension", "programs; where they act is warned of"),
    ],
    others: Others::Warned,
};

static COMPILER: Content = Content {
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

static OPTION: Content = Content {
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

static FLAG: Content = Content {
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

static DEFAULT: Content = Content {
    attributes: &[Entry::read("class", "its name")],
    elements: &[
        Entry::read("default", "a class, which begins with what this one has").with(&DEFAULT),
        Entry::read("joint", "attributes of joints").with(&bodies::JOINT),
        Entry::read("geom", "attributes of geoms").with(&bodies::GEOM),
        Entry::read("site", "attributes of sites").with(&bodies::SITE),
        Entry::read("mesh", "attributes of meshes").with(&MESH),
        Entry::read("equality", "whether constraints are active").with(&CONSTRAINT),
        Entry::nothing("tendon", "its springs, friction and inertia are warned of").with(&TENDON),
        Entry::nothing("material", "what is seen"),
        Entry::nothing("camera", "what is seen"),
        Entry::nothing("light", "what is seen"),
        Entry::nothing("pair", "how it touches"),
        Entry::read("general", "gears and armatures").with(&ACTUATOR),
        Entry::read("motor", "gears and armatures").with(&ACTUATOR),
        Entry::read("position", "gears and armatures").with(&ACTUATOR),
        Entry::read("velocity", "gears and armatures").with(&ACTUATOR),
        Entry::read("intvelocity", "gears and armatures").with(&ACTUATOR),
        Entry::read("orientation", "gears and armatures").with(&ACTUATOR),
        Entry::read("pid", "gears and armatures").with(&ACTUATOR),
        Entry::read("damper", "gears and armatures").with(&ACTUATOR),
        Entry::read("cylinder", "gears and armatures").with(&ACTUATOR),
        Entry::read("adhesion", "gears and armatures").with(&ACTUATOR),
        Entry::read("dcmotor", "gears and armatures").with(&ACTUATOR),
        Entry::lost("muscle", &MUSCLE),
    ],
    others: Others::Warned,
};

static ASSET: Content = Content {
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

static MESH: Content = Content {
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

static EQUALITY: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read(
            "joint",
            "a mimic joint, of a polynomial of first order, and a warning of others",
        )
        .with(&CONSTRAINT),
        Entry::read("connect", "a loop closed by a ball joint").with(&CONSTRAINT),
        Entry::read("weld", "a loop closed rigidly").with(&CONSTRAINT),
        Entry::lost("tendon", &SOLVED),
        Entry::lost("flex", &SOLVED),
        Entry::lost("flexvert", &SOLVED),
        Entry::lost("flexstrain", &SOLVED),
    ],
    others: Others::Warned,
};

static CONSTRAINT: Content = Content {
    attributes: &[
        Entry::read("name", "that of a loop"),
        Entry::read("class", "its class of defaults"),
        Entry::read("active", "whether it is there"),
        Entry::read("joint1", "the joint that follows"),
        Entry::read("joint2", "the joint that leads"),
        Entry::read("polycoef", "offset and factor"),
        Entry::read("body1", "a body"),
        Entry::read("body2", "a body, or the world"),
        Entry::read(
            "anchor",
            "a point: of `connect` in `body1`, of `weld` in `body2`",
        ),
        Entry::read(
            "relpose",
            "the pose of `body2` in `body1`; as described where it is not written",
        ),
        Entry::read("site1", "a site"),
        Entry::read("site2", "a site"),
        Entry::nothing("torquescale", "a setting of the solver"),
        Entry::nothing("solref", "a setting of the solver"),
        Entry::nothing("solimp", "a setting of the solver"),
    ],
    elements: &[],
    others: Others::Warned,
};

static ACTUATORS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::read("general", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("motor", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("position", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("velocity", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("intvelocity", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("orientation", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("pid", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("damper", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("cylinder", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("adhesion", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::read("dcmotor", "its armature; torques are those of joints").with(&ACTUATOR),
        Entry::lost("muscle", &MUSCLE),
        Entry::lost("plugin", &PLUGIN),
    ],
    others: Others::Warned,
};

static ACTUATOR: Content = Content {
    attributes: &[
        Entry::read("name", "messages name it"),
        Entry::read("class", "its class of defaults"),
        Entry::read("joint", "the joint that it drives"),
        Entry::read("jointinparent", "the joint that it drives"),
        Entry::read(
            "gear",
            "turns of the rotor for each of the joint, beside `armature`",
        ),
        Entry::read(
            "armature",
            "the inertia of its rotor, where `rotors` asks for it, and a warning where not",
        ),
        Entry::read("damping", "a warning where it is not 0"),
        Entry::nothing("tendon", "of control: torques are those of joints"),
        Entry::nothing("slidersite", "of control: torques are those of joints"),
        Entry::nothing("cranksite", "of control: torques are those of joints"),
        Entry::nothing("site", "of control: torques are those of joints"),
        Entry::nothing("refsite", "of control: torques are those of joints"),
        Entry::nothing("body", "of control: torques are those of joints"),
        Entry::nothing("group", "of control: torques are those of joints"),
        Entry::nothing("nsample", "of control: torques are those of joints"),
        Entry::nothing("interp", "of control: torques are those of joints"),
        Entry::nothing("delay", "of control: torques are those of joints"),
        Entry::nothing("ctrlrange", "of control: torques are those of joints"),
        Entry::nothing("user", "of control: torques are those of joints"),
        Entry::nothing("lengthrange", "of control: torques are those of joints"),
        Entry::nothing("cranklength", "of control: torques are those of joints"),
        Entry::nothing("ctrllimited", "of control: torques are those of joints"),
        Entry::nothing("forcelimited", "of control: torques are those of joints"),
        Entry::nothing("actlimited", "of control: torques are those of joints"),
        Entry::nothing("forcerange", "of control: torques are those of joints"),
        Entry::nothing("actrange", "of control: torques are those of joints"),
        Entry::nothing("actdim", "of control: torques are those of joints"),
        Entry::nothing("velrange", "of control: torques are those of joints"),
        Entry::nothing("ffrange", "of control: torques are those of joints"),
        Entry::nothing("dyntype", "of control: torques are those of joints"),
        Entry::nothing("gaintype", "of control: torques are those of joints"),
        Entry::nothing("biastype", "of control: torques are those of joints"),
        Entry::nothing("dynprm", "of control: torques are those of joints"),
        Entry::nothing("gainprm", "of control: torques are those of joints"),
        Entry::nothing("biasprm", "of control: torques are those of joints"),
        Entry::nothing("actearly", "of control: torques are those of joints"),
        Entry::nothing("kp", "of control: torques are those of joints"),
        Entry::nothing("kv", "of control: torques are those of joints"),
        Entry::nothing("dampratio", "of control: torques are those of joints"),
        Entry::nothing("timeconst", "of control: torques are those of joints"),
        Entry::nothing("inheritrange", "of control: torques are those of joints"),
        Entry::nothing("area", "of control: torques are those of joints"),
        Entry::nothing("diameter", "of control: torques are those of joints"),
        Entry::nothing("bias", "of control: torques are those of joints"),
        Entry::nothing("gain", "of control: torques are those of joints"),
        Entry::nothing("input", "of control: torques are those of joints"),
        Entry::nothing("inputchart", "of control: torques are those of joints"),
        Entry::nothing("kd", "of control: torques are those of joints"),
        Entry::nothing("ki", "of control: torques are those of joints"),
        Entry::nothing("imax", "of control: torques are those of joints"),
        Entry::nothing("motorconst", "of control: torques are those of joints"),
        Entry::nothing("resistance", "of control: torques are those of joints"),
        Entry::nothing("nominal", "of control: torques are those of joints"),
        Entry::nothing("saturation", "of control: torques are those of joints"),
        Entry::nothing("inductance", "of control: torques are those of joints"),
        Entry::nothing("cogging", "of control: torques are those of joints"),
        Entry::nothing("controller", "of control: torques are those of joints"),
        Entry::nothing("thermal", "of control: torques are those of joints"),
        Entry::nothing("lugre", "of control: torques are those of joints"),
        Entry::nothing("damping0", "of control: torques are those of joints"),
        Entry::nothing("voltage", "of control: torques are those of joints"),
    ],
    elements: &[],
    others: Others::PassedOver,
};

static TENDONS: Content = Content {
    attributes: &[],
    elements: &[
        Entry::nothing(
            "spatial",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&TENDON),
        Entry::nothing(
            "fixed",
            "a transmission; its springs, friction and inertia are warned of",
        )
        .with(&TENDON),
    ],
    others: Others::Warned,
};

static TENDON: Content = Content {
    attributes: &[
        Entry::lost("stiffness", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("damping", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("frictionloss", &TENDON_FORCE).when(When::NotZero),
        Entry::lost("armature", &TENDON_FORCE).when(When::NotZero),
    ],
    elements: &[],
    others: Others::PassedOver,
};

static DEFORMABLE: Content = Content {
    attributes: &[],
    elements: &[
        Entry::lost("flex", &FLEX),
        Entry::nothing("skin", "what is seen"),
    ],
    others: Others::Warned,
};

/// The body moves with its inertial frame, and not with the one that is written.
pub(super) const ALIGNED: Lost = Lost {
    what: "the body moves with its inertial frame, and not with the one that is written",
    hint: "coordinates here are those of the body's frame as written; write align=\"false\" for the same in MuJoCo",
};

/// Armature and friction of a free joint.
pub(super) const OF_WORLD: Lost = Lost {
    what: "armature or friction of a free joint, which no motor has",
    hint: "write <freejoint/>, which takes none of a class of defaults",
};

/// A spring.
pub(super) const SPRING: Lost = Lost {
    what: "a spring",
    hint: "its force is missing from torques and accelerations: add it outside",
};

/// Damping that is not linear in the velocity.
pub(super) const CUBIC: Lost = Lost {
    what: "damping that is not linear in the velocity",
    hint: "the linear part is modelled where friction is asked for",
};

/// A joint follows another by a polynomial of higher order.
pub(super) const POLYNOMIAL: Lost = Lost {
    what: "a joint follows another by a polynomial of higher order",
    hint: "it moves freely here: lock it, or let it follow linearly",
};

/// A joint is held where it is.
pub(super) const HELD: Lost = Lost {
    what: "a joint is held where it is",
    hint: "it moves freely here: lock it",
};

/// A joint follows twice, or follows itself.
pub(super) const SECOND: Lost = Lost {
    what: "a joint follows twice, or follows itself",
    hint: "the first of its constraints is modelled",
};

/// Damping by the motor.
pub(super) const ACTUATOR_DAMPING: Lost = Lost {
    what: "damping by the motor",
    hint: "say it with damping beside the file",
};

/// An armature that is of no hinge or slide alone.
pub(super) const ELSEWHERE: Lost = Lost {
    what: "an armature that is of no hinge or slide alone",
    hint: "say it with armature beside the file",
};

/// Forces of a plug-in.
const PLUGIN: Lost = Lost {
    what: "forces of a plug-in",
    hint: "they are missing from torques and accelerations",
};

/// A body whose place is set from outside.
const MOCAP: Lost = Lost {
    what: "a body whose place is set from outside",
    hint: "it is fixed where it is described",
};

/// A body that gravity does not pull by its whole weight.
const GRAVCOMP: Lost = Lost {
    what: "a body that gravity does not pull by its whole weight",
    hint: "gravity pulls it here: subtract the force outside",
};

/// Forces of a fluid.
const FLUID: Lost = Lost {
    what: "forces of a fluid",
    hint: "they are missing from torques and accelerations",
};

/// A constraint of a tendon or a flexible body.
const SOLVED: Lost = Lost {
    what: "a constraint of a tendon or a flexible body",
    hint: "it is missing here",
};

/// A muscle, which pulls by itself.
const MUSCLE: Lost = Lost {
    what: "a muscle, which pulls by itself",
    hint: "its force is missing from torques and accelerations",
};

/// Springs, friction or inertia of a tendon.
const TENDON_FORCE: Lost = Lost {
    what: "springs, friction or inertia of a tendon",
    hint: "they are missing from torques and accelerations",
};

/// A flexible body.
const FLEX: Lost = Lost {
    what: "a flexible body",
    hint: "it is left out, with its mass",
};

/// Each element that has content, as the guide calls it.
static PLACES: [(&str, &Content); 22] = [
    ("`<mujoco>`", &MUJOCO),
    ("`<compiler>`", &COMPILER),
    ("`<option>`", &OPTION),
    ("`<flag>`", &FLAG),
    ("`<default>`", &DEFAULT),
    ("`<worldbody>` and `<body>`", &bodies::BODY),
    ("`<frame>`", &bodies::FRAME),
    ("`<replicate>`", &bodies::REPLICATE),
    ("`<inertial>`", &bodies::INERTIAL),
    ("`<joint>`", &bodies::JOINT),
    ("`<freejoint>`", &bodies::FREEJOINT),
    ("`<geom>`", &bodies::GEOM),
    ("`<site>`", &bodies::SITE),
    ("`<asset>`", &ASSET),
    ("`<mesh>`", &MESH),
    ("`<equality>`", &EQUALITY),
    (
        "`<joint>`, `<connect>` and `<weld>` of `<equality>`",
        &CONSTRAINT,
    ),
    ("`<actuator>`", &ACTUATORS),
    ("an actuator", &ACTUATOR),
    ("`<tendon>`", &TENDONS),
    ("a tendon", &TENDON),
    ("`<deformable>`", &DEFORMABLE),
];

/// The root element of each file that is included, with what may stand in the place of it.
pub(super) fn included(root: Element<'_>) -> Vec<(Element<'_>, &'static Content)> {
    let mut found = Vec::new();
    let mut waiting: Vec<(Element<'_>, &'static Content)> = vec![(root, &MUJOCO)];
    while let Some((element, content)) = waiting.pop() {
        for child in element.own_children() {
            if let Some(included) = child.included() {
                found.push((included, content));
                waiting.push((included, content));
            } else if let Some(inner) = content.element(child.tag()).and_then(|entry| entry.content)
            {
                waiting.push((child, inner));
            }
        }
    }
    found
}

/// The table as the guide shows it, in Markdown: of each element what may stand in it, attributes first.
#[must_use]
pub fn page() -> String {
    MJCF.page()
}

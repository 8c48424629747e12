//! Writes URDF.
//!
//! Joints that URDF 1.0 does not have are written by the extensions that this project reads, each with a warning;
//! rotors and armatures are transmissions with the elements of Drake.

use super::elementary::{Elementary, ElementaryMotion, elementary};
use super::markup::{Attribute, Markup};
use super::numbers::{plain, text, texts};
use super::placement::placed;
use super::{Converted, actuators};
use crate::chain::shape;
use crate::closure::Closure;
use crate::description::fresh::FreshNames;
use crate::description::{Description, Inertial, Joint, Loop, Sphere, Step};
use crate::error::{Diagnostic, Errors, Place};
use crate::joint::Manifold;
use crate::joint::actuator::ActuatorQuantity;
use crate::list::Id;
use crate::wording::{list, quoted};

/// State of the writer.
struct Urdf<'d> {
    markup: Markup,
    links: FreshNames,
    joints: FreshNames,
    errors: Errors,
    warnings: Vec<Diagnostic>,
    /// Joints of types that few readers know.
    spherical: Vec<&'d Joint>,
}

/// Writes a description.
///
/// # Errors
/// A description that is no tree, and rotors that transmissions cannot say.
pub(super) fn write(description: &Description) -> Result<Converted, Errors> {
    shape::whole(description)?;
    let links = description.links.iter().map(|link| link.name.text.as_str());
    let joints = description
        .joints
        .iter()
        .map(|joint| joint.name.text.as_str());
    let mut urdf = Urdf {
        markup: Markup::default(),
        links: FreshNames::of(links),
        joints: FreshNames::of(joints),
        errors: description.source.errors(),
        warnings: Vec::new(),
        spherical: Vec::new(),
    };
    let has_motors = |joint: &Joint| {
        let quantities = [
            ActuatorQuantity::Armature,
            ActuatorQuantity::Rotor,
            ActuatorQuantity::Ratio,
        ];
        let mut quantities = quantities.into_iter();
        quantities.any(|quantity| !joint.actuator.of(quantity).is_empty())
    };
    let mut root: Vec<Attribute> = vec![("name", description.name.text.clone())];
    if description.joints.iter().any(has_motors) {
        root.push(("xmlns:drake", "https://drake.mit.edu".to_owned()));
    }
    urdf.markup.text.push_str("<?xml version=\"1.0\"?>\n");
    urdf.markup.begin("robot", &root);
    // They stand in the order of their links.
    let mut collisions = description.collisions.iter().peekable();
    for (k, link) in description.links.iter().enumerate() {
        let own = std::iter::from_fn(|| collisions.next_if(|other| other.link.index() == k));
        let spheres = own.filter_map(|collision| collision.sphere.as_ref());
        urdf.link(
            &link.name.text,
            link.inertial.as_ref(),
            &spheres.collect::<Vec<_>>(),
        );
    }
    for joint in &description.joints {
        urdf.joint(joint);
    }
    for closed in &description.loops {
        urdf.closed(closed);
    }
    urdf.markup.end();
    urdf.warn_of(description);
    urdf.errors.into_result(Converted {
        text: urdf.markup.text,
        warnings: urdf.warnings,
    })
}

impl<'d> Urdf<'d> {
    fn link(&mut self, name: &str, inertial: Option<&Inertial>, spheres: &[&Sphere]) {
        let name = vec![("name", name.to_owned())];
        if inertial.is_none() && spheres.is_empty() {
            self.markup.empty("link", &name);
            return;
        }
        self.markup.begin("link", &name);
        if let Some(inertial) = inertial {
            self.inertial(inertial);
        }
        for sphere in spheres {
            self.sphere(sphere);
        }
        self.markup.end();
    }

    fn sphere(&mut self, sphere: &Sphere) {
        self.markup.begin("collision", &[]);
        self.origin(&sphere.origin);
        self.markup.begin("geometry", &[]);
        self.markup
            .empty("sphere", &[("radius", text(&sphere.radius))]);
        self.markup.end();
        self.markup.end();
    }

    fn inertial(&mut self, inertial: &Inertial) {
        self.markup.begin("inertial", &[]);
        self.origin(&inertial.origin);
        self.markup
            .empty("mass", &[("value", text(&inertial.mass))]);
        let entries = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
        let entries = entries.into_iter().zip(inertial.inertia.iter().map(text));
        self.markup.empty("inertia", &entries.collect::<Vec<_>>());
        self.markup.end();
    }

    /// The placement, unless it is the identity.
    fn origin(&mut self, steps: &[Step]) {
        let attributes = origin(steps);
        if !attributes.is_empty() {
            self.markup.empty("origin", &attributes);
        }
    }

    /// A joint, as joints in series with auxiliary links between them if it has several parts.
    fn joint(&mut self, joint: &'d Joint) {
        if joint.kind.has_several() && joint.limits.is_some() {
            self.warn(
                joint.place,
                format!(
                    "the limits of joint {}, which has several coordinates, are left out",
                    quoted(&joint.name.text)
                ),
                None,
            );
        }
        let parts = elementary(joint);
        let count = parts.len();
        let mut parent = joint.parent.text.clone();
        for (k, mut part) in parts.into_iter().enumerate() {
            if part.name != joint.name.text {
                part.name = self.joints.fresh(&part.name);
            }
            let child = if k + 1 == count {
                joint.child.text.clone()
            } else {
                let link = self.links.fresh(&format!("{}.link", part.name));
                self.link(&link, None, &[]);
                link
            };
            let origin: &[Step] = if k == 0 { &joint.origin } else { &[] };
            self.part(&part, origin, &parent, &child);
            self.motors(&part);
            parent = child;
        }
        if joint.kind.manifold() == Some(Manifold::Spherical) {
            self.spherical.push(joint);
        }
    }

    fn part(&mut self, part: &Elementary<'_>, origin: &[Step], parent: &str, child: &str) {
        let is_limited = part.is_limited();
        let kind = match part.motion {
            ElementaryMotion::Fixed => "fixed",
            ElementaryMotion::Rotation if is_limited => "revolute",
            ElementaryMotion::Rotation => "continuous",
            ElementaryMotion::Translation => "prismatic",
            ElementaryMotion::Manifold(manifold) => manifold.word(),
        };
        let attributes = [("name", part.name.clone()), ("type", kind.to_owned())];
        self.markup.begin("joint", &attributes);
        self.origin(origin);
        self.markup.empty("parent", &[("link", parent.to_owned())]);
        self.markup.empty("child", &[("link", child.to_owned())]);
        if matches!(
            part.motion,
            ElementaryMotion::Rotation
                | ElementaryMotion::Translation
                | ElementaryMotion::Manifold(Manifold::Planar)
        ) {
            self.markup.empty("axis", &[("xyz", texts(&part.axis))]);
        }
        self.limit(part);
        let resisting = [ActuatorQuantity::Damping, ActuatorQuantity::Friction];
        let resisting = resisting.map(|quantity| (quantity, actuators::numbers(part, quantity)));
        let resisting = resisting
            .into_iter()
            .filter(|(_, numbers)| !numbers.is_empty());
        let resisting: Vec<Attribute> = resisting
            .map(|(quantity, numbers)| (quantity.word(), texts(numbers)))
            .collect();
        if !resisting.is_empty() {
            self.markup.empty("dynamics", &resisting);
        }
        if let Some(mimic) = &part.mimic {
            let attributes = [
                ("joint", mimic.mimicked.text.clone()),
                ("multiplier", text(&mimic.multiplier)),
                ("offset", text(&mimic.offset)),
            ];
            self.markup.empty("mimic", &attributes);
        }
        self.markup.end();
    }

    /// The limits. Readers require velocity and effort of them, and take 0 for an unknown one.
    fn limit(&mut self, part: &Elementary<'_>) {
        let is_required = part.motion == ElementaryMotion::Translation
            || part.motion == ElementaryMotion::Rotation && part.is_limited();
        let Some(limits) = part.limits else {
            if is_required {
                let unknown = ["effort", "velocity"].map(|name| (name, "0".to_owned()));
                self.markup.empty("limit", &unknown);
            }
            return;
        };
        if part.motion == ElementaryMotion::Fixed {
            return;
        }
        let is_known = |limit: f64| limit.is_finite() && limit > 0.0;
        let mut attributes = Vec::new();
        if part.is_limited() {
            attributes.push(("lower", plain(limits.lower)));
            attributes.push(("upper", plain(limits.upper)));
        }
        if attributes.is_empty()
            && !is_required
            && !is_known(limits.effort)
            && !is_known(limits.velocity)
        {
            return;
        }
        for (name, limit) in [("effort", limits.effort), ("velocity", limits.velocity)] {
            let limit = if is_known(limit) { limit } else { 0.0 };
            attributes.push((name, plain(limit)));
        }
        self.markup.empty("limit", &attributes);
    }

    /// A transmission for each motor.
    fn motors(&mut self, part: &Elementary<'_>) {
        let motors = match actuators::motors(part) {
            Ok(motors) => motors,
            Err(quantity) => {
                let message = actuators::differ(part, quantity);
                self.errors.push(part.of.place, message);
                return;
            }
        };
        for (k, motor) in motors.iter().enumerate() {
            let number = if k == 0 {
                String::new()
            } else {
                format!("_{}", k + 1)
            };
            let name = |what: &str| vec![("name", format!("{}_{what}{number}", part.name))];
            self.markup.begin("transmission", &name("transmission"));
            self.markup
                .with_text("type", "transmission_interface/SimpleTransmission");
            self.markup.empty("joint", &[("name", part.name.clone())]);
            self.markup.begin("actuator", &name("motor"));
            if let Some(ratio) = &motor.ratio {
                self.markup.with_text("mechanicalReduction", &text(ratio));
                self.markup
                    .empty("drake:gear_ratio", &[("value", text(ratio))]);
            }
            if let Some(rotor) = &motor.rotor {
                self.markup
                    .empty("drake:rotor_inertia", &[("value", text(rotor))]);
            }
            self.markup.end();
            self.markup.end();
        }
    }

    fn closed(&mut self, closed: &Loop) {
        let definition = closed.closure.definition();
        let attributes = [
            ("name", closed.name.text.clone()),
            ("type", definition.word.to_owned()),
        ];
        self.markup.begin("loop_joint", &attributes);
        let ends = [
            ("link1", &closed.from, &closed.at),
            ("link2", &closed.to, &closed.to_at),
        ];
        for (tag, link, at) in ends {
            let mut attributes: Vec<Attribute> = vec![("link", link.text.clone())];
            attributes.extend(origin(at));
            self.markup.empty(tag, &attributes);
        }
        let axes = ["axis", "axis2"].into_iter().zip(&closed.axes);
        for (tag, axis) in axes.take(definition.axes) {
            self.markup.empty(tag, &[("xyz", texts(axis))]);
        }
        if let Closure::Rod { length } = closed.closure {
            self.markup.empty("rod", &[("length", text(&length))]);
        }
        self.markup.end();
    }

    fn warn(&mut self, place: Place, message: String, hint: Option<&str>) {
        self.warnings.push(Diagnostic {
            place,
            message,
            hint: hint.map(str::to_owned),
        });
    }

    /// Warnings of what URDF cannot say, and of what few programs read.
    fn warn_of(&mut self, description: &Description) {
        if let Some(gravity) = &description.gravity {
            let gravity = texts(gravity);
            self.warn(
                gravity_place(description),
                format!("URDF has no gravity: that of the model, {gravity} m/s², is left out"),
                Some("give it to the program that reads the file"),
            );
        }
        if let [first, ..] = self.spherical[..] {
            let names: Vec<String> = self
                .spherical
                .iter()
                .map(|joint| quoted(&joint.name.text))
                .collect();
            let names = list(names.iter().map(String::as_str));
            self.warn(
                first.place,
                format!("URDF has no ball joints: {names} of type spherical"),
                Some("PyBullet reads the type; Drake has <drake:joint type=\"ball\"> with other coordinates"),
            );
        }
        if let [first, ..] = &description.loops[..] {
            let names: Vec<String> = description
                .loops
                .iter()
                .map(|closed| quoted(&closed.name.text))
                .collect();
            let names = list(names.iter().map(String::as_str));
            self.warn(
                first.name.place,
                format!("URDF has no loops: {names} written as <loop_joint>"),
                Some("other programs leave them open"),
            );
        }
    }
}

fn gravity_place(description: &Description) -> Place {
    let first = description
        .gravity
        .and_then(|gravity| gravity.first().copied());
    first.map_or(Place::Unknown, |number| number.place)
}

/// The attributes of a placement.
fn origin(steps: &[Step]) -> Vec<Attribute> {
    let placed = placed(steps);
    let xyz = placed.xyz.map(|xyz| ("xyz", xyz));
    let rpy = placed.rpy.map(|rpy| ("rpy", rpy));
    xyz.into_iter().chain(rpy).collect()
}

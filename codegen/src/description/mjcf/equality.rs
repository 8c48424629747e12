//! `<equality>`: constraints that MuJoCo's solver enforces approximately and that hold exactly here.
//!
//! A `joint` with a polynomial of first order becomes a mimic joint; `connect` and `weld` become closed loops. Other
//! constraints are reported as warnings.

use super::element::Element;
use super::elements::unmodelled::{HELD, POLYNOMIAL, SECOND};
use super::orientation::of_mujoco;
use super::parts::{Affix, Scope, WORLD};
use super::reading::Mjcf;
use super::values::Attributes;
use crate::closure::Closure;
use crate::description::spatial::{inverse, to_number};
use crate::description::{JointId, Loop, Mimic, Name, Number, Step, number};
use crate::error::Place;
use crate::expression::Double;
use crate::wording::quoted;

/// One side of a loop: the link, and the placement of the joined frame on it.
type End = (Name, Vec<Step>);

/// A constraint, with the prefix and suffix of the names in it.
struct Constraint<'c, 'a> {
    element: Element<'a>,
    affix: &'c Affix,
    name: Option<String>,
    /// The constraint in messages.
    subject: String,
}

impl<'a> Mjcf<'a> {
    /// Reads all constraints.
    pub(super) fn read_equalities(&mut self, scopes: &[Scope]) -> Vec<Loop> {
        let mut loops = Vec::new();
        let names = ["joint1", "joint2", "body1", "body2", "site1", "site2"];
        self.referring(scopes, "equality", &names, true, |mjcf, element, affix| {
            let tag = element.tag();
            if !matches!(tag, "joint" | "connect" | "weld") {
                return;
            }
            let class = mjcf.class(element.attribute("class"));
            let attributes = Attributes {
                own: element,
                kind: "equality",
                class: class.unwrap_or_else(|| mjcf.model().defaults.main()),
            };
            let name = element.attribute("name");
            let name = name.map(|name| affix.name(&mjcf.word(name).text));
            let constraint = Constraint {
                element,
                affix,
                subject: match &name {
                    Some(name) => format!("<{tag}> {}", quoted(name)),
                    None => format!("a <{tag}>"),
                },
                name,
            };
            if !mjcf.flag(attributes.get("active"), true, &constraint.subject) {
                return;
            }
            if tag == "joint" {
                mjcf.mimic(&constraint);
            } else {
                loops.extend(mjcf.closed(&constraint));
            }
        });
        loops
    }

    /// Makes a joint a mimic joint.
    fn mimic(&mut self, constraint: &Constraint<'_, 'a>) {
        let (element, subject) = (constraint.element, &*constraint.subject);
        let place = self.place(element);
        let Some(mimic_joint) = self.joint_named(constraint, "joint1") else {
            if element.attribute("joint1").is_none() {
                self.refuse(
                    element,
                    format!("{subject} has no joint1"),
                    "write joint1=\"…\"",
                );
            }
            return;
        };
        let polynomial = element.attribute("polycoef");
        let polynomial = polynomial.and_then(|written| self.list(written, 0..=5, subject));
        let polynomial = polynomial.unwrap_or_default();
        let coefficient = |k: usize| match (polynomial.get(k), k) {
            (Some(number), _) => number.exact(),
            (None, 1) => Double::from(1.0),
            (None, _) => Double::ZERO,
        };
        if (2..5).any(|k| !coefficient(k).is_zero()) {
            self.noted.note(&POLYNOMIAL, place, subject.to_owned());
            return;
        }
        if element.attribute("joint2").is_none() {
            self.noted.note(&HELD, place, subject.to_owned());
            return;
        }
        let Some(mimicked) = self.joint_named(constraint, "joint2") else {
            return;
        };
        if self.tree.joints[mimic_joint].mimic.is_some() || self.mimics(mimicked, mimic_joint) {
            self.noted.note(&SECOND, place, subject.to_owned());
            return;
        }
        let reference = |mjcf: &Self, joint: JointId| {
            let name = &mjcf.tree.joints[joint].name.text;
            let reference = mjcf.tree.references.get(name);
            reference.map_or(Double::ZERO, Number::exact)
        };
        // y − y₀ = a₀ + a₁ (x − x₀), with the references x₀ and y₀ of both joints.
        let offset = reference(self, mimic_joint) + coefficient(0)
            - coefficient(1) * reference(self, mimicked);
        let mimic = Mimic {
            mimicked: self.tree.joints[mimicked].name.clone(),
            multiplier: to_number(coefficient(1), place),
            offset: to_number(offset, place),
            place,
        };
        self.tree.joints[mimic_joint].mimic = Some(mimic);
    }

    /// True if `joint` is `other`, or mimics it directly or through other joints.
    fn mimics(&self, joint: JointId, other: JointId) -> bool {
        let mut at = Some(joint);
        for _ in 0..=self.tree.joints.len() {
            match at {
                Some(found) if found == other => return true,
                Some(found) => {
                    let mimic = self.tree.joints[found].mimic.as_ref();
                    at = mimic.and_then(|mimic| self.tree.joint(&mimic.mimicked.text));
                }
                None => return false,
            }
        }
        false
    }

    /// The name that an attribute writes, as a name of the robot.
    fn name_in(&mut self, constraint: &Constraint<'_, 'a>, attribute: &str) -> Option<Name> {
        let mut name = self.word(constraint.element.attribute(attribute)?);
        name.text = constraint.affix.name(&name.text);
        Some(name)
    }

    /// The joint that an attribute names; it must have one coordinate.
    fn joint_named(&mut self, constraint: &Constraint<'_, 'a>, attribute: &str) -> Option<JointId> {
        let name = self.name_in(constraint, attribute)?;
        let found = self.tree.joint(&name.text);
        let is_scalar = |joint: &JointId| {
            let kind = self.tree.joints[*joint].kind;
            kind.moves() && !kind.has_several()
        };
        let found = found.filter(is_scalar);
        if found.is_none() {
            let subject = &constraint.subject;
            let message = format!(
                "{attribute} of {subject} must be a hinge or a slide: {}",
                quoted(&name.text)
            );
            self.reader.errors.push(name.place, message);
        }
        found
    }

    /// A loop that constrains a point (`connect`) or a pose (`weld`).
    fn closed(&mut self, constraint: &Constraint<'_, 'a>) -> Option<Loop> {
        let (element, subject) = (constraint.element, &constraint.subject);
        let place = self.place(element);
        let has = |name: &str| element.attribute(name).is_some();
        let is_weld = element.tag() == "weld";
        let ends = if has("body1") {
            self.on_bodies(constraint, is_weld)
        } else if has("site1") && has("site2") {
            let ends = ["site1", "site2"].map(|name| self.site_named(constraint, name));
            let [from, to] = ends;
            from.zip(to)
        } else {
            let hint = "write body1, or site1 and site2";
            self.refuse(
                element,
                format!("{subject} has no body1 and no sites"),
                hint,
            );
            None
        };
        let ((from, at), (to, to_at)) = ends?;
        let name = constraint.name.clone().unwrap_or_else(|| {
            let word = if is_weld { "weld" } else { "connect" };
            format!("{word}_{}_{}", from.text, to.text)
        });
        let zero = number::computed(Double::ZERO, place);
        Some(Loop {
            name: Name {
                text: self.loop_names.fresh(&name),
                place,
            },
            closure: if is_weld {
                Closure::Fixed
            } else {
                Closure::Spherical
            },
            from,
            to,
            at,
            to_at,
            axes: [[zero; 3]; 2],
        })
    }

    fn on_bodies(&mut self, constraint: &Constraint<'_, 'a>, is_weld: bool) -> Option<(End, End)> {
        let (element, subject) = (constraint.element, &*constraint.subject);
        let place = self.place(element);
        let first = self.body_named(constraint, "body1")?;
        let second = if element.attribute("body2").is_some() {
            self.body_named(constraint, "body2")?
        } else {
            Name {
                text: WORLD.to_owned(),
                place,
            }
        };
        let anchor = self.numbers::<3>(element.attribute("anchor"), subject);
        if anchor.is_none() && !is_weld {
            let hint = "write anchor=\"…\", in the frame of body1";
            self.refuse(element, format!("{subject} has no anchor"), hint);
            return None;
        }
        let anchor: Vec<Step> = anchor.map(Step::Translate).into_iter().collect();
        // The pose of the second body in the first, in the described configuration.
        let mut between = self.tree.between(&first.text, &second.text);
        if is_weld {
            let pose = self.numbers::<7>(element.attribute("relpose"), subject);
            if let Some([x, y, z, quaternion @ ..]) = pose
                && quaternion.iter().any(|entry: &Number| entry.value != 0.0)
            {
                between = vec![Step::Translate([x, y, z]), of_mujoco(quaternion)];
            }
            between.extend(&anchor);
            return Some(((first, between), (second, anchor)));
        }
        let mut there = inverse(&between);
        there.extend(&anchor);
        Some(((first, anchor), (second, there)))
    }

    fn body_named(&mut self, constraint: &Constraint<'_, 'a>, attribute: &str) -> Option<Name> {
        let name = self.name_in(constraint, attribute)?;
        if self.tree.is_body(&name.text) {
            return Some(name);
        }
        let subject = &constraint.subject;
        let message = format!(
            "{attribute} of {subject} must be a body, but there is no body {}",
            quoted(&name.text)
        );
        self.reader.errors.push(name.place, message);
        None
    }

    fn site_named(&mut self, constraint: &Constraint<'_, 'a>, attribute: &str) -> Option<End> {
        let name = self.name_in(constraint, attribute)?;
        let Some(link) = self.tree.sites.get(&name.text) else {
            let subject = &constraint.subject;
            let message = format!(
                "{attribute} of {subject} must be a site, but there is no site {}",
                quoted(&name.text)
            );
            self.reader.errors.push(name.place, message);
            return None;
        };
        let place: Place = name.place;
        let link = Name {
            text: link.clone(),
            place,
        };
        Some((link, Vec::new()))
    }
}

//! Writes MJCF.
//!
//! The root link becomes a body of the world, or the world itself if that is its name. Links without mass between
//! moving joints are merged into the body that they carry, because MuJoCo needs a mass on each moving body: their joints
//! become several joints of that body. Motors are reflected as armatures.

mod body;
mod equality;
mod joint;
mod keyframe;

use std::collections::HashMap;

use super::Converted;
use super::elementary::ElementaryMotion;
use super::markup::Markup;
use super::numbers::texts;
use crate::chain::shape;
use crate::chain::tree::Branch;
use crate::description::fresh::FreshNames;
use crate::description::{Description, JointId, LinkId, Step};
use crate::error::{Diagnostic, Errors, Place};
use crate::list::Id;
use crate::wording::{list, quoted};

/// The name of the fixed link.
const WORLD: &str = "world";

/// Maximum number of names in a warning.
const LISTED: usize = 6;

/// State of the writer.
struct Mjcf<'d> {
    description: &'d Description,
    markup: Markup,
    errors: Errors,
    warnings: Vec<Diagnostic>,
    root: LinkId,
    /// The joints below each link, in the order of the description.
    below: HashMap<LinkId, Vec<Branch>>,
    bodies: FreshNames,
    joints: FreshNames,
    /// The frames of loops on each link, by link name.
    sites: HashMap<&'d str, Vec<Site<'d>>>,
    /// The constraints, each with its attributes.
    equalities: Vec<(&'static str, Vec<(&'static str, String)>)>,
    /// The joints as written, a composite one several times, with their motions.
    order: Vec<(JointId, ElementaryMotion)>,
    /// Links that were merged into the bodies that they carry.
    merged: Vec<LinkId>,
    /// Links that move without mass.
    massless: Vec<LinkId>,
    /// Joints whose limits of velocity are left out.
    fast: Vec<JointId>,
}

/// A frame of a loop.
struct Site<'d> {
    name: String,
    at: &'d [Step],
}

/// Writes a description.
///
/// # Errors
/// A description that is no tree, and motions and loops that MJCF does not have.
pub(super) fn write(description: &Description) -> Result<Converted, Errors> {
    let (root, branches) = shape::whole(description)?;
    let mut below: HashMap<LinkId, Vec<Branch>> = HashMap::new();
    for branch in branches {
        below.entry(branch.parent).or_default().push(branch);
    }
    let links = description.links.iter().map(|link| link.name.text.as_str());
    let joints = description
        .joints
        .iter()
        .map(|joint| joint.name.text.as_str());
    let mut mjcf = Mjcf {
        description,
        markup: Markup::default(),
        errors: description.source.errors(),
        warnings: Vec::new(),
        root,
        below,
        bodies: FreshNames::of(links.chain([WORLD])),
        joints: FreshNames::of(joints),
        sites: HashMap::new(),
        equalities: Vec::new(),
        order: Vec::new(),
        merged: Vec::new(),
        massless: Vec::new(),
        fast: Vec::new(),
    };
    for closed in &description.loops {
        mjcf.closed(closed);
    }
    let name = [("model", description.name.text.clone())];
    mjcf.markup.begin("mujoco", &name);
    // Roll, pitch and yaw, as in URDF.
    let compiler = [("angle", "radian"), ("eulerseq", "XYZ")];
    let compiler = compiler.map(|(name, value)| (name, value.to_owned()));
    mjcf.markup.empty("compiler", &compiler);
    if let Some(gravity) = &description.gravity {
        mjcf.markup.empty("option", &[("gravity", texts(gravity))]);
    }
    mjcf.world();
    if !mjcf.equalities.is_empty() {
        mjcf.markup.begin("equality", &[]);
        for (tag, attributes) in std::mem::take(&mut mjcf.equalities) {
            mjcf.markup.empty(tag, &attributes);
        }
        mjcf.markup.end();
    }
    mjcf.keyframes();
    mjcf.markup.end();
    mjcf.warn_of_links();
    mjcf.errors.into_result(Converted {
        text: mjcf.markup.text,
        warnings: mjcf.warnings,
    })
}

impl Mjcf<'_> {
    fn warn(&mut self, place: Place, message: String, hint: Option<&str>) {
        self.warnings.push(Diagnostic {
            place,
            message,
            hint: hint.map(str::to_owned),
        });
    }

    /// Warns once of each kind of what MJCF does not have.
    fn warn_of_links(&mut self) {
        let merged = std::mem::take(&mut self.merged);
        if let Some(first) = merged.first() {
            let place = self.description[*first].name.place;
            let names = self.names(&merged, |description, link| &description[link].name.text);
            let message =
                format!("no mass and no frame: {names}, merged into the bodies that they carry");
            self.warn(place, message, None);
        }
        let massless = std::mem::take(&mut self.massless);
        if let Some(first) = massless.first() {
            let place = self.description[*first].name.place;
            let names = self.names(&massless, |description, link| &description[link].name.text);
            let message = format!("no mass: {names}, whose motion MuJoCo refuses");
            let hint = "give them inertias, or write boundmass and boundinertia into <compiler>";
            self.warn(place, message, Some(hint));
        }
        let fast = std::mem::take(&mut self.fast);
        if let Some(first) = fast.first() {
            let place = self.description[*first].name.place;
            let names = self.names(&fast, |description, joint| &description[joint].name.text);
            let message =
                format!("MJCF has no limits of velocities: those of {names} are left out");
            self.warn(place, message, None);
        }
    }

    /// The names of some items.
    fn names<I: Id>(&self, items: &[I], name: impl Fn(&Description, I) -> &String) -> String {
        let shown = items.iter().take(LISTED);
        let shown = shown.map(|item| quoted(name(self.description, *item)));
        let more = items.len().saturating_sub(LISTED);
        let more = (more > 0).then(|| format!("{more} more"));
        let shown: Vec<String> = shown.chain(more).collect();
        list(shown.iter().map(String::as_str))
    }
}

//! Bodies, from the world outwards.

use super::{Mjcf, WORLD};
use crate::chain::tree::Branch;
use crate::convert::elementary::elementary;
use crate::convert::markup::Attribute;
use crate::convert::numbers::{text, texts};
use crate::convert::placement::{placed, pose};
use crate::description::spatial::{entries, inverse};
use crate::description::{Inertial, Joint, JointId, LinkId, Number, Step};
use crate::joint::{JointKind, Manifold};
use crate::wording::quoted;

/// A body to write: the link, and the joints between it and the body around it.
struct MjcfBody {
    link: LinkId,
    joints: Vec<JointId>,
}

/// An item that remains to be written.
enum Pending {
    Begin(MjcfBody),
    End,
}

impl Mjcf<'_> {
    /// All bodies.
    pub(super) fn world(&mut self) {
        self.markup.begin("worldbody", &[]);
        let root = self.root;
        let link = &self.description[root];
        let is_world = link.name.text == WORLD;
        if is_world && has_mass(link.inertial.as_ref()) {
            let message = "the world has no inertia in MJCF: that of the fixed link is left out";
            self.warn(link.name.place, message.to_owned(), None);
        }
        let children = self.below.remove(&root).unwrap_or_default();
        // A free joint belongs to a body of the world, whose frame is that of the root.
        let (free, others): (Vec<_>, Vec<_>) = children
            .into_iter()
            .partition(|branch| self.is_free(branch.joint));
        let mut waiting: Vec<Pending> = Vec::new();
        if is_world {
            self.sites_on(root);
            waiting.extend(self.begun(others));
        } else {
            self.below.insert(root, others);
            let joints = Vec::new();
            waiting.push(Pending::Begin(MjcfBody { link: root, joints }));
        }
        waiting.extend(self.begun(free));
        waiting.reverse();
        while let Some(next) = waiting.pop() {
            match next {
                Pending::End => self.markup.end(),
                Pending::Begin(body) => {
                    self.body(&body);
                    let children = self.below.remove(&body.link).unwrap_or_default();
                    waiting.push(Pending::End);
                    waiting.extend(self.begun(children).into_iter().rev());
                }
            }
        }
        self.markup.end();
    }

    fn is_free(&self, joint: JointId) -> bool {
        self.description[joint].kind.manifold() == Some(Manifold::Floating)
    }

    /// The bodies below some joints.
    fn begun(&mut self, branches: Vec<Branch>) -> Vec<Pending> {
        let bodies = branches.into_iter().map(|branch| self.merged(&branch));
        bodies.map(Pending::Begin).collect()
    }

    /// The body that a joint carries, beyond links without mass that only carry a moving joint.
    fn merged(&mut self, first: &Branch) -> MjcfBody {
        let mut joints = vec![first.joint];
        let mut link = first.child;
        let mut kind = self.description[first.joint].kind;
        while is_mergeable(kind) {
            let described = &self.description[link];
            let is_looped = self.sites.contains_key(described.name.text.as_str());
            let Some([only]) = self.below.get(&link).map(Vec::as_slice) else {
                break;
            };
            let (joint, child) = (only.joint, only.child);
            kind = self.description[joint].kind;
            if is_looped || has_mass(described.inertial.as_ref()) || !is_mergeable(kind) {
                break;
            }
            self.below.remove(&link);
            self.merged.push(link);
            joints.push(joint);
            link = child;
        }
        MjcfBody { link, joints }
    }

    /// Begins a body.
    fn body(&mut self, body: &MjcfBody) {
        let description = self.description;
        let link = &description[body.link];
        let mut name = link.name.text.clone();
        if name == WORLD {
            name = self.bodies.fresh(WORLD);
            let message = format!("link \"{WORLD}\" is written as body {}", quoted(&name));
            self.warn(link.name.place, message, None);
        }
        let joints = body.joints.iter().map(|joint| &description[*joint]);
        let joints: Vec<&Joint> = joints.collect();
        let mut attributes = vec![("name", name)];
        attributes.extend(at(&origins(&joints)));
        self.markup.begin("body", &attributes);
        self.inertial(link.inertial.as_ref());
        for (k, joint) in body.joints.iter().enumerate() {
            let beyond = origins(&joints[k + 1..]);
            let frame = (!at(&beyond).is_empty()).then(|| pose(&inverse(&beyond)));
            self.check_free(*joint);
            for mut part in elementary(joints[k]) {
                if part.name != joints[k].name.text {
                    part.name = self.joints.fresh(&part.name);
                }
                self.joint(&part, *joint, frame.as_ref());
                self.mimic(&part);
            }
        }
        let moves = joints.iter().any(|joint| joint.kind.moves());
        if moves && !self.carries_mass(body.link) {
            self.massless.push(body.link);
        }
        self.sites_on(body.link);
    }

    /// Rejects a free joint that is not one of the world, or that has an origin.
    fn check_free(&mut self, joint: JointId) {
        if !self.is_free(joint) {
            return;
        }
        let joint = &self.description[joint];
        let is_of_root = joint.parent.text == self.description[self.root].name.text;
        if !is_of_root || !at(&joint.origin).is_empty() {
            let message = format!(
                "joint {} is floating, and MJCF has such joints only from the world, without an origin",
                quoted(&joint.name.text)
            );
            let hint = "use three prismatic joints and a spherical one";
            self.errors.push_with_hint(joint.place, message, hint);
        }
    }

    /// True if a link, or a link that is fixed to it, has mass.
    fn carries_mass(&self, link: LinkId) -> bool {
        let mut waiting = vec![link];
        while let Some(link) = waiting.pop() {
            if has_mass(self.description[link].inertial.as_ref()) {
                return true;
            }
            let below = self.below.get(&link).into_iter().flatten();
            let fixed = below.filter(|branch| !self.description[branch.joint].kind.moves());
            waiting.extend(fixed.map(|branch| branch.child));
        }
        false
    }

    fn inertial(&mut self, inertial: Option<&Inertial>) {
        let Some(inertial) = inertial.filter(|inertial| has_mass(Some(inertial))) else {
            return;
        };
        let [xx, xy, xz, yy, yz, zz] = inertial.inertia;
        let is_diagonal = [xy, xz, yz].iter().all(|entry| entry.value == 0.0);
        let place = placed(&inertial.origin);
        let position = place.xyz.unwrap_or_else(|| "0 0 0".to_owned());
        let mut attributes: Vec<Attribute> =
            vec![("pos", position), ("mass", text(&inertial.mass))];
        match place.rpy {
            Some(rpy) if is_diagonal => {
                attributes.push(("euler", rpy));
                attributes.push(("diaginertia", texts(&[xx, yy, zz])));
            }
            None if is_diagonal => attributes.push(("diaginertia", texts(&[xx, yy, zz]))),
            rpy => {
                // A full tensor is in the axes of the body.
                let tensor = match rpy {
                    Some(_) => rotated(inertial),
                    None => inertial.inertia,
                };
                let [xx, xy, xz, yy, yz, zz] = tensor;
                attributes.push(("fullinertia", texts(&[xx, yy, zz, xy, xz, yz])));
            }
        }
        self.markup.empty("inertial", &attributes);
    }

    /// The sites of a link.
    fn sites_on(&mut self, link: LinkId) {
        let name = self.description[link].name.text.as_str();
        for site in self.sites.remove(name).unwrap_or_default() {
            let mut attributes = vec![("name", site.name)];
            attributes.extend(at(site.at));
            self.markup.empty("site", &attributes);
        }
    }
}

/// True for joints that can be one of several joints of a body.
fn is_mergeable(kind: JointKind) -> bool {
    let is_free = matches!(kind.manifold(), Some(Manifold::Floating | Manifold::Planar));
    kind.moves() && !is_free
}

/// True if a link has mass or moments of inertia.
fn has_mass(inertial: Option<&Inertial>) -> bool {
    inertial.is_some_and(|inertial| {
        let mut numbers = inertial.inertia.iter().chain([&inertial.mass]);
        numbers.any(|number| number.value != 0.0)
    })
}

/// The placement across some joints at coordinate 0.
fn origins(joints: &[&Joint]) -> Vec<Step> {
    let steps = joints.iter().flat_map(|joint| &joint.origin);
    steps.copied().collect()
}

/// The inertia tensor in the axes of the link.
fn rotated(inertial: &Inertial) -> [Number; 6] {
    let [xx, xy, xz, yy, yz, zz] = inertial.inertia.map(|entry| entry.exact());
    let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let tensor = pose(&inertial.origin).tensor(&tensor);
    entries(&tensor, inertial.place)
}

/// The attributes of a placement.
fn at(steps: &[Step]) -> Vec<Attribute> {
    let placed = placed(steps);
    let position = placed.xyz.map(|xyz| ("pos", xyz));
    let angles = placed.rpy.map(|rpy| ("euler", rpy));
    position.into_iter().chain(angles).collect()
}

//! The tree of links.
//!
//! In: joints and the names of links. Out: a tree below one link; or errors about the joints that prevent one.

use super::names::Names;
use super::tree::Branch;
use crate::description::{Description, JointId, LinkId, Name};
use crate::error::Errors;
use crate::list::List;
use crate::request::Request;
use crate::wording::quoted;

/// The joints with the links that they connect.
pub struct Joints {
    /// Parent and child of each joint.
    ends: List<JointId, (LinkId, LinkId)>,
    /// The joint that carries each link.
    carrier: List<LinkId, Option<JointId>>,
}

impl Joints {
    /// Finds the links of every joint; `None` if a name is wrong, a link has two parents, or a cycle exists.
    pub fn connect(
        description: &Description,
        links: &Names<'_, LinkId>,
        errors: &mut Errors,
    ) -> Option<Self> {
        let mut ends: List<JointId, (LinkId, LinkId)> = List::new();
        for joint in &description.joints {
            let parent = links.find(&joint.parent, errors);
            let child = links.find(&joint.child, errors);
            ends.extend(parent.zip(child));
        }
        if ends.len() < description.joints.len() {
            return None;
        }
        let mut carrier = List::filled(None, description.links.len());
        for (joint, &(_, child)) in ends.numbered() {
            if let Some(first) = carrier[child].replace(joint) {
                let [first, second]: [&Name; 2] =
                    [first, joint].map(|joint| &description[joint].name);
                let [link, one, other] =
                    [&description[child].name, first, second].map(|name| quoted(&name.text));
                errors.push_with_hint(
                    second.place,
                    format!("link {link} has two parent joints, {one} and {other}"),
                    "leave one of the joints out, and describe it as a loop",
                );
            }
        }
        let joints = Self { ends, carrier };
        joints.check_cycles(description, errors);
        Some(joints)
    }

    fn check_cycles(&self, description: &Description, errors: &mut Errors) {
        // The pass in which a link was seen; each link is visited once.
        let mut seen = self.carrier.map(|_| None);
        for start in self.carrier.ids() {
            let mut link = start;
            while seen[link].is_none() {
                seen[link] = Some(start);
                let Some(joint) = self.carrier[link] else {
                    break;
                };
                link = self.ends[joint].0;
                if seen[link] == Some(start) {
                    let name = &description[joint].name;
                    let [joint, link] =
                        [name, &description[link].name].map(|name| quoted(&name.text));
                    errors.push(
                        name.place,
                        format!("joint {joint} closes a cycle: link {link} is its own ancestor"),
                    );
                    break;
                }
            }
        }
    }
}

/// The base: the link that is named, or the only one without a parent.
pub fn find_base(
    description: &Description,
    request: &Request,
    joints: &Joints,
    links: &Names<'_, LinkId>,
    errors: &mut Errors,
) -> Option<LinkId> {
    if let Some(name) = &request.base {
        return links.find(name, errors);
    }
    let mut roots = joints
        .carrier
        .ids()
        .filter(|&link| joints.carrier[link].is_none());
    let robot = &description.name;
    match (roots.next(), roots.next()) {
        (Some(root), None) => Some(root),
        (Some(first), Some(second)) => {
            let more = match roots.count() {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let second = &description[second].name;
            let [first, other] = [&description[first].name, second].map(|name| quoted(&name.text));
            errors.push_with_hint(
                second.place,
                format!("links {first}, {other}{more} have no parent: a robot has one root"),
                "connect them by joints, or name the base to model one part alone",
            );
            None
        }
        (None, _) if description.links.is_empty() => {
            errors.push(
                robot.place,
                format!("robot {} has no links", quoted(&robot.text)),
            );
            None
        }
        // Every link has a parent: the cycle has been reported.
        (None, _) => None,
    }
}

/// The root link and all joints, parents before children, siblings in the order of the description.
///
/// # Errors
/// Names that occur twice or do not exist, several roots, and cycles.
#[cfg(feature = "files")]
pub(crate) fn whole(description: &Description) -> Result<(LinkId, Vec<Branch>), Errors> {
    let mut errors = description.source.errors();
    let names = description.links.iter().map(|link| &link.name);
    let links = Names::of(names, "link", &mut errors);
    let connected = Joints::connect(description, &links, &mut errors);
    let request = Request::default();
    let root = connected.and_then(|connected| {
        let root = find_base(description, &request, &connected, &links, &mut errors)?;
        let branches = downstream(&connected, root, &[]);
        Some((root, branches))
    });
    match root {
        Some(found) if errors.is_empty() => Ok(found),
        _ => Err(errors),
    }
}

/// The joints downstream of the base, branch by branch, siblings in the order of the description.
pub fn downstream(joints: &Joints, base: LinkId, dropped: &[LinkId]) -> Vec<Branch> {
    let mut children: List<LinkId, Vec<Branch>> = joints.carrier.map(|_| Vec::new());
    for (joint, &(parent, child)) in joints.ends.numbered() {
        if !dropped.contains(&child) {
            children[parent].push(Branch {
                joint,
                parent,
                child,
                held: None,
                mimics: None,
            });
        }
    }
    let mut branches = Vec::new();
    let mut waiting = std::mem::take(&mut children[base]);
    waiting.reverse();
    while let Some(branch) = waiting.pop() {
        waiting.extend(
            std::mem::take(&mut children[branch.child])
                .into_iter()
                .rev(),
        );
        branches.push(branch);
    }
    branches
}

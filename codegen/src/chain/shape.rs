//! Which link hangs on which.
//!
//! In: joints and the names of links. Out: a tree below one link; or the joints that make it
//! something else. It never looks at what the joints allow.

use super::names::Names;
use super::tree::Branch;
use crate::description::{Description, Name};
use crate::error::Errors;
use crate::request::Request;
use crate::wording::quoted;

/// How the joints connect the links.
pub struct Joints {
    /// Parent and child of each joint.
    ends: Vec<(usize, usize)>,
    /// The joint that carries each link.
    carrier: Vec<Option<usize>>,
}

impl Joints {
    /// Finds the links of every joint; none where a name is wrong, a link has two carriers or hangs
    /// on itself.
    pub fn connect(
        description: &Description,
        links: &Names<'_>,
        errors: &mut Errors,
    ) -> Option<Self> {
        let mut ends = Vec::with_capacity(description.joints.len());
        for joint in &description.joints {
            let parent = links.find(&joint.parent, errors);
            let child = links.find(&joint.child, errors);
            ends.extend(parent.zip(child));
        }
        if ends.len() < description.joints.len() {
            return None;
        }
        let mut carrier = vec![None; description.links.len()];
        for (joint, &(_, child)) in ends.iter().enumerate() {
            if let Some(first) = carrier[child].replace(joint) {
                let [first, second]: [&Name; 2] =
                    [first, joint].map(|k| &description.joints[k].name);
                let [link, one, other] =
                    [&description.links[child].name, first, second].map(|name| quoted(&name.text));
                errors.push_with_hint(
                    second.place,
                    format!("link {link} hangs on two joints, {one} and {other}"),
                    "closed loops are not modelled by a tree: leave one of the joints out",
                );
            }
        }
        let joints = Self { ends, carrier };
        joints.check_cycles(description, errors);
        Some(joints)
    }

    fn check_cycles(&self, description: &Description, errors: &mut Errors) {
        // 0: not seen, otherwise the walk that saw it; each link is walked over once.
        let mut seen = vec![0; self.carrier.len()];
        for start in 0..self.carrier.len() {
            let mut link = start;
            while seen[link] == 0 {
                seen[link] = start + 1;
                let Some(joint) = self.carrier[link] else {
                    break;
                };
                link = self.ends[joint].0;
                if seen[link] == start + 1 {
                    let name = &description.joints[joint].name;
                    let [joint, link] =
                        [name, &description.links[link].name].map(|name| quoted(&name.text));
                    errors.push(
                        name.place,
                        format!("joint {joint} closes a cycle: link {link} hangs on itself"),
                    );
                    break;
                }
            }
        }
    }
}

/// The link taken as fixed: the one that is named, or the only one that hangs on nothing.
pub fn find_base(
    description: &Description,
    request: &Request,
    joints: &Joints,
    links: &Names<'_>,
    errors: &mut Errors,
) -> Option<usize> {
    if let Some(name) = &request.base {
        return links.find(name, errors);
    }
    let mut roots = (0..joints.carrier.len()).filter(|&link| joints.carrier[link].is_none());
    let robot = &description.name;
    match (roots.next(), roots.next()) {
        (Some(root), None) => Some(root),
        (Some(first), Some(second)) => {
            let more = match roots.count() {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let second = &description.links[second].name;
            let [first, other] =
                [&description.links[first].name, second].map(|name| quoted(&name.text));
            errors.push_with_hint(
                second.place,
                format!("links {first}, {other}{more} hang on nothing"),
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
        // Every link hangs on another: the cycle has been complained about.
        (None, _) => None,
    }
}

/// The joints that hang on the base, branch by branch, siblings in the order of the description.
pub fn downstream(joints: &Joints, base: usize, dropped: &[usize]) -> Vec<Branch> {
    let mut children: Vec<Vec<Branch>> = joints.carrier.iter().map(|_| Vec::new()).collect();
    for (joint, &(parent, child)) in joints.ends.iter().enumerate() {
        if !dropped.contains(&child) {
            children[parent].push(Branch {
                joint,
                parent,
                child,
                held: None,
                follows: None,
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

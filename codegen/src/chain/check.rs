//! What takes two items to see: names that refer to each other, and the shape of the whole.
//!
//! In: the description and the request. Out: a [`Tree`] that says for each link how it hangs on
//! the base; or all the mistakes. It never looks at a number.

use std::collections::HashMap;

use crate::description::{Description, JointKind, Name, Number};
use crate::error::Errors;
use crate::request::{Request, Target};

/// The part of a description that is modelled.
#[derive(Debug)]
pub struct Tree {
    /// Index of the link taken as fixed.
    pub base: usize,
    /// Joints downstream of the base, parents before children and siblings as described, each with
    /// the links it connects.
    pub branches: Vec<Branch>,
    /// The link that poses and Jacobians are of.
    pub tip: Option<usize>,
    /// Further links whose frames are asked for.
    pub frames: Vec<usize>,
    /// Links that are not modelled.
    pub dropped: Vec<usize>,
}

/// A joint of the tree.
#[derive(Debug)]
pub struct Branch {
    /// Index of the joint.
    pub joint: usize,
    /// Index of the link it hangs on.
    pub parent: usize,
    /// Index of the link it carries.
    pub child: usize,
    /// Where it is held still [rad or m]; none where it moves.
    pub held: Option<Number>,
}

/// Checks all that connects items, and puts the joints in order.
///
/// # Errors
/// All the mistakes that are found.
pub fn check(description: &Description, request: &Request) -> Result<Tree, Errors> {
    let mut errors = Errors::new();
    if let Some(file) = &description.source.file {
        errors.set_file(file.clone(), description.source.anchor);
    }
    let links = index(
        description.links.iter().map(|link| &link.name),
        "link",
        &mut errors,
    );
    let joints = index(
        description.joints.iter().map(|joint| &joint.name),
        "joint",
        &mut errors,
    );
    let connections = connect(description, &links, &mut errors);
    if !errors.is_empty() {
        return Err(errors);
    }

    let mut carrier = vec![None; description.links.len()];
    for (joint, &(_, child)) in connections.iter().enumerate() {
        if let Some(first) = carrier[child].replace(joint) {
            let [first, second]: [&Name; 2] = [first, joint].map(|k| &description.joints[k].name);
            errors.push_with_hint(
                second.place,
                format!(
                    "link \"{}\" hangs on two joints, \"{}\" and \"{}\"",
                    description.links[child].name.text, first.text, second.text
                ),
                "closed loops are not modelled by a tree: leave one of the joints out",
            );
        }
    }
    check_cycles(description, &connections, &carrier, &mut errors);
    let base = find_base(description, request, &links, &carrier, &mut errors);
    let (Some(base), true) = (base, errors.is_empty()) else {
        return Err(errors);
    };

    let find = |name: &Name, errors: &mut Errors| find(name, &links, "link", errors);
    let dropped: Vec<usize> = request
        .drop
        .iter()
        .filter_map(|name| find(name, &mut errors))
        .collect();
    if let Some(name) = request
        .drop
        .iter()
        .find(|name| links.get(name.text.as_str()) == Some(&base))
    {
        errors.push(
            name.place,
            format!("the base \"{}\" cannot be dropped", name.text),
        );
    }
    let tip = request
        .tip
        .as_ref()
        .and_then(|name| find(name, &mut errors));
    let frames: Vec<usize> = request
        .frames
        .iter()
        .filter_map(|name| find(name, &mut errors))
        .collect();
    let locks = locks(description, request, &joints, &mut errors);

    let mut branches = downstream(&connections, base, &dropped);
    for branch in &mut branches {
        branch.held = locks.get(&branch.joint).copied().or_else(|| {
            let fixed = matches!(description.joints[branch.joint].kind, JointKind::Fixed);
            fixed.then(Number::default)
        });
    }
    let mut kept = vec![false; description.links.len()];
    kept[base] = true;
    for branch in &branches {
        kept[branch.child] = true;
    }
    for (name, what) in request
        .tip
        .iter()
        .map(|name| (name, "tip"))
        .chain(request.frames.iter().map(|name| (name, "frame")))
    {
        if links
            .get(name.text.as_str())
            .is_some_and(|&link| !kept[link])
        {
            errors.push_with_hint(
                name.place,
                format!(
                    "the {what} \"{}\" does not hang on the base \"{}\"",
                    name.text, description.links[base].name.text
                ),
                "choose a base upstream of it, and do not drop it",
            );
        }
    }
    check_targets(request, &links, &joints, &kept, &branches, &mut errors);

    let mut ends: Vec<usize> = vec![base];
    ends.extend(branches.iter().map(|branch| branch.child));
    ends.retain(|&link| branches.iter().all(|branch| branch.parent != link));
    let tip = tip.or(match ends[..] {
        [only] => Some(only),
        _ => None,
    });
    if request.path_only {
        match tip {
            Some(tip) => hold_off_path(&mut branches, base, tip),
            None => errors.push_with_hint(
                request
                    .tip
                    .as_ref()
                    .map_or(description.name.place, |name| name.place),
                "path_only needs a tip, and the robot has more than one end",
                format!("name one of: {}", list(description, &ends)),
            ),
        }
    }
    let asks_for_frame = request
        .functions
        .iter()
        .flatten()
        .any(|function| function.of_a_frame());
    if asks_for_frame && tip.is_none() && frames.is_empty() && request.tip.is_none() {
        errors.push_with_hint(
            description.name.place,
            "which frame are poses and Jacobians of? The robot has more than one end",
            format!("name one as the tip: {}", list(description, &ends)),
        );
    }
    if branches.iter().all(|branch| branch.held.is_some()) && errors.is_empty() {
        errors.push(
            description.name.place,
            format!("no joint of \"{}\" moves", description.name.text),
        );
    }
    let dropped = (0..description.links.len())
        .filter(|&link| !kept[link])
        .collect();
    errors.into_result(Tree {
        base,
        branches,
        tip,
        frames,
        dropped,
    })
}

type Index<'a> = HashMap<&'a str, usize>;

fn index<'a>(names: impl Iterator<Item = &'a Name>, what: &str, errors: &mut Errors) -> Index<'a> {
    let mut index = Index::new();
    for (k, name) in names.enumerate() {
        if index.contains_key(name.text.as_str()) {
            errors.push(
                name.place,
                format!("two {what}s are called \"{}\"", name.text),
            );
        } else {
            index.insert(&name.text, k);
        }
    }
    index
}

fn find(name: &Name, index: &Index<'_>, what: &str, errors: &mut Errors) -> Option<usize> {
    let found = index.get(name.text.as_str()).copied();
    if found.is_none() {
        let message = format!("there is no {what} \"{}\"", name.text);
        match nearest(&name.text, index) {
            Some(near) => {
                errors.push_with_hint(name.place, message, format!("did you mean \"{near}\"?"))
            }
            None => errors.push(name.place, message),
        }
    }
    found
}

/// The known name that differs in the fewest letters, if it differs in few.
fn nearest<'a>(name: &str, index: &Index<'a>) -> Option<&'a str> {
    if index.len() > 1000 {
        return None;
    }
    let mut names: Vec<&str> = index.keys().copied().collect();
    names.sort_unstable();
    let (distance, near) = names
        .into_iter()
        .map(|known| (distance(name, known), known))
        .min()?;
    (distance <= 1 + name.chars().count() / 4).then_some(near)
}

/// Letters to insert, delete or exchange (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, other) in b.iter().enumerate() {
            let exchanged = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = exchanged.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

/// Parent and child of each joint.
fn connect(
    description: &Description,
    links: &Index<'_>,
    errors: &mut Errors,
) -> Vec<(usize, usize)> {
    let mut connections = Vec::new();
    for joint in &description.joints {
        let parent = find(&joint.parent, links, "link", errors);
        let child = find(&joint.child, links, "link", errors);
        if let (Some(parent), Some(child)) = (parent, child) {
            connections.push((parent, child));
        }
    }
    connections
}

fn check_cycles(
    description: &Description,
    connections: &[(usize, usize)],
    carrier: &[Option<usize>],
    errors: &mut Errors,
) {
    // 0: not seen, otherwise the walk that saw it; each link is walked over once.
    let mut seen = vec![0; carrier.len()];
    for start in 0..carrier.len() {
        let mut link = start;
        while seen[link] == 0 {
            seen[link] = start + 1;
            let Some(joint) = carrier[link] else { break };
            link = connections[joint].0;
            if seen[link] == start + 1 {
                let name = &description.joints[joint].name;
                errors.push(
                    name.place,
                    format!(
                        "joint \"{}\" closes a cycle: link \"{}\" hangs on itself",
                        name.text, description.links[link].name.text
                    ),
                );
                break;
            }
        }
    }
}

fn find_base(
    description: &Description,
    request: &Request,
    links: &Index<'_>,
    carrier: &[Option<usize>],
    errors: &mut Errors,
) -> Option<usize> {
    if let Some(name) = &request.base {
        return find(name, links, "link", errors);
    }
    let roots: Vec<usize> = (0..carrier.len())
        .filter(|&link| carrier[link].is_none())
        .collect();
    match roots[..] {
        [root] => Some(root),
        [] => {
            if description.links.is_empty() {
                errors.push(
                    description.name.place,
                    format!("robot \"{}\" has no links", description.name.text),
                );
            }
            None
        }
        _ => {
            errors.push_with_hint(
                description.links[roots[1]].name.place,
                format!("links {} all hang on nothing", list(description, &roots)),
                "connect them by joints, or name the base to model one part alone",
            );
            None
        }
    }
}

fn list(description: &Description, links: &[usize]) -> String {
    const SHOWN: usize = 8;
    let mut names: Vec<String> = links
        .iter()
        .take(SHOWN)
        .map(|&link| format!("\"{}\"", description.links[link].name.text))
        .collect();
    if links.len() > SHOWN {
        names.push(format!("and {} more", links.len() - SHOWN));
    }
    names.join(", ")
}

fn locks(
    description: &Description,
    request: &Request,
    joints: &Index<'_>,
    errors: &mut Errors,
) -> HashMap<usize, Number> {
    let mut locks = HashMap::new();
    for (name, value) in &request.lock {
        let Some(joint) = find(name, joints, "joint", errors) else {
            continue;
        };
        if matches!(description.joints[joint].kind, JointKind::Fixed) {
            errors.push(
                name.place,
                format!("joint \"{}\" is fixed and cannot be locked", name.text),
            );
        } else if locks.insert(joint, value.unwrap_or_default()).is_some() {
            errors.push(
                name.place,
                format!("joint \"{}\" is locked twice", name.text),
            );
        }
    }
    locks
}

/// The joints that hang on the base, branch by branch.
fn downstream(connections: &[(usize, usize)], base: usize, dropped: &[usize]) -> Vec<Branch> {
    let links = connections
        .iter()
        .flat_map(|&(parent, child)| [parent, child])
        .max()
        .unwrap_or(0);
    let mut children = vec![Vec::new(); links.max(base) + 1];
    for (joint, &(parent, child)) in connections.iter().enumerate() {
        if !dropped.contains(&child) {
            children[parent].push((joint, child));
        }
    }
    let mut branches = Vec::new();
    let mut waiting: Vec<(usize, usize, usize)> = Vec::new();
    let push = |parent: usize, waiting: &mut Vec<(usize, usize, usize)>| {
        waiting.extend(
            children[parent]
                .iter()
                .rev()
                .map(|&(joint, child)| (joint, parent, child)),
        );
    };
    push(base, &mut waiting);
    while let Some((joint, parent, child)) = waiting.pop() {
        branches.push(Branch {
            joint,
            parent,
            child,
            held: None,
        });
        push(child, &mut waiting);
    }
    branches
}

fn hold_off_path(branches: &mut [Branch], base: usize, tip: usize) {
    let mut link = tip;
    // Children come after parents, so one walk backwards meets the path in order.
    for branch in branches.iter_mut().rev() {
        if branch.child == link && link != base {
            link = branch.parent;
        } else if branch.held.is_none() {
            branch.held = Some(Number::default());
        }
    }
}

fn check_targets(
    request: &Request,
    links: &Index<'_>,
    joints: &Index<'_>,
    kept: &[bool],
    branches: &[Branch],
    errors: &mut Errors,
) {
    for parameter in &request.parameters {
        match &parameter.target {
            Target::Gravity => {}
            Target::MassOf(name) | Target::CenterOfMassOf(name) => {
                if let Some(link) = find(name, links, "link", errors)
                    && !kept[link]
                {
                    errors.push(
                        name.place,
                        format!("link \"{}\" is not modelled", name.text),
                    );
                }
            }
            Target::OriginOf(name) => {
                if let Some(joint) = find(name, joints, "joint", errors)
                    && branches.iter().all(|branch| branch.joint != joint)
                {
                    errors.push(
                        name.place,
                        format!("joint \"{}\" is not modelled", name.text),
                    );
                }
            }
        }
    }
}

//! Checks that take two items to see: names that refer to each other, and the shape of the tree.
//!
//! In: the description and the request. Out: a [`Tree`] with the path of each link to the base; or all errors. Numbers
//! are checked in [`numbers`].

use std::collections::{BTreeSet, HashMap};

use super::closure;
use super::collision;
use super::mimic;
use super::names::Names;
use super::shape::{Joints, downstream, find_base};
use super::tree::{Branch, MimicLaw, Tree};
use super::{actuator, external, numbers};
use crate::description::{Description, JointId, LinkId, Name, Number};
use crate::error::Errors;
use crate::list::List;
use crate::request::{Request, Target};
use crate::wording::quoted;

/// The largest number of joints. Every number of a chain keeps its expression, so a file of megabytes would fill the
/// memory.
const MOST: usize = 5000;

/// Checks all that connects items, and puts the joints in order.
///
/// # Errors
/// All errors that are found.
pub fn check(description: &Description, request: &Request) -> Result<Tree, Errors> {
    let mut errors = description.source.errors();
    let links = Names::of(
        description.links.iter().map(|link| &link.name),
        "link",
        &mut errors,
    );
    let joints = Names::of(
        description.joints.iter().map(|joint| &joint.name),
        "joint",
        &mut errors,
    );
    let connected = Joints::connect(description, &links, &mut errors);
    let base = match connected {
        Some(ref connected) => find_base(description, request, connected, &links, &mut errors),
        None => None,
    };
    let (Some(connected), Some(base), true) = (connected, base, errors.is_empty()) else {
        return Err(errors);
    };

    let mut find = |name: &Name| links.find(name, &mut errors);
    let dropped: Vec<LinkId> = request.drop.iter().filter_map(&mut find).collect();
    let tip = request.tip.as_ref().and_then(&mut find);
    let frames: Vec<LinkId> = request.frames.iter().filter_map(&mut find).collect();
    let locks = locks(description, request, &joints, &mut errors);
    let branches: Vec<Branch> = downstream(&connected, base, &dropped)
        .into_iter()
        .map(|branch| {
            let fixed = !description[branch.joint].kind.moves();
            let held = locks
                .get(&branch.joint)
                .copied()
                .or(fixed.then(Number::default));
            Branch { held, ..branch }
        })
        .collect();
    let dropped = modelled(description, base, &branches, false);
    let mut tree = Tree {
        base,
        branches,
        tip,
        frames,
        external: Vec::new(),
        collision_pairs: Vec::new(),
        dropped,
        locks,
    };
    check_kept(description, request, &tree, &links, &mut errors);
    for clash in request.clashes() {
        errors.record(clash);
    }
    check_targets(request, &tree, &links, &joints, &mut errors);
    check_coordinates(description, &joints, &mut errors);
    closure::check(description, &links, &mut errors);
    for name in &request.actuated {
        joints.find(name, &mut errors);
    }
    let mimics = mimic::mimics(description, &tree, &joints, &mut errors);
    choose_tip(description, request, &mimics, &mut tree, &mut errors);
    mimic::hold(&mut tree, &mimics);
    check_moving(description, request, &tree, &links, &mut errors);
    check_size(description, &tree, &mut errors);
    numbers::check(description, request, &tree, &mut errors);
    actuator::check(description, request, &tree, &joints, &mut errors);
    tree.external = external::check(description, request, &tree, &links, &mut errors);
    tree.collision_pairs = collision::check(description, request, &tree, &links, &mut errors);
    if tree.branches.iter().all(|branch| branch.held.is_some()) && errors.is_empty() {
        let robot = &description.name;
        let message = format!("no joint of {} moves", quoted(&robot.text));
        match mimic::stuck(description, &tree).first() {
            Some(stuck) => {
                let message = format!("{message}: {}", stuck.why);
                errors.push_with_hint(stuck.place, message, stuck.hint.as_str());
            }
            None => errors.push(robot.place, message),
        }
    }
    errors.into_result(tree)
}

/// The links that are part of the tree, or the others.
fn modelled(
    description: &Description,
    base: LinkId,
    branches: &[Branch],
    are: bool,
) -> Vec<LinkId> {
    let mut kept = List::filled(false, description.links.len());
    kept[base] = true;
    for branch in branches {
        kept[branch.child] = true;
    }
    kept.ids().filter(|&link| kept[link] == are).collect()
}

fn locks(
    description: &Description,
    request: &Request,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) -> HashMap<JointId, Number> {
    let mut locks = HashMap::new();
    for (name, value) in &request.lock {
        let Some(joint) = joints.find(name, errors) else {
            continue;
        };
        let called = quoted(&name.text);
        if !description[joint].kind.moves() {
            errors.push(
                name.place,
                format!("joint {called} is fixed and cannot be locked"),
            );
        } else if value.is_some() && description[joint].kind.has_several() {
            errors.push_with_hint(
                name.place,
                format!("joint {called} has several coordinates and is locked at one value"),
                "lock it without a value, which sets all of them to 0",
            );
        } else if locks.insert(joint, value.unwrap_or_default()).is_some() {
            errors.push(name.place, format!("joint {called} is locked twice"));
        }
    }
    locks
}

/// Checks that no coordinate of a joint with several has the name of another joint.
fn check_coordinates(description: &Description, joints: &Names<'_, JointId>, errors: &mut Errors) {
    let several = description.joints.iter();
    let several = several.filter(|joint| joint.kind.has_several());
    for joint in several {
        let own = &joint.name.text;
        let velocities = joint.kind.velocities(own).map(|(name, _)| name);
        let coordinates = joint
            .kind
            .coordinates(own)
            .into_iter()
            .map(|(name, _)| name);
        for text in coordinates.chain(velocities).collect::<BTreeSet<_>>() {
            let place = joint.name.place;
            let coordinate = Name { text, place };
            if joints.get(&coordinate).is_some() {
                let [name, own] = [&coordinate.text, &joint.name.text].map(|name| quoted(name));
                let message = format!("joint {name} has the name of a coordinate of joint {own}");
                errors.push_with_hint(place, message, "rename one of them");
            }
        }
    }
}

/// Checks that requested links are modelled.
fn check_kept(
    description: &Description,
    request: &Request,
    tree: &Tree,
    links: &Names<'_, LinkId>,
    errors: &mut Errors,
) {
    let base = quoted(&description[tree.base].name.text);
    for name in &request.drop {
        if links.get(name) == Some(tree.base) {
            errors.push(name.place, format!("the base {base} cannot be dropped"));
        }
    }
    let tips = request.tip.iter().map(|name| ("tip", name));
    let frames = request.frames.iter().map(|name| ("frame", name));
    for (what, name) in tips.chain(frames) {
        if links
            .get(name)
            .is_some_and(|link| tree.dropped.contains(&link))
        {
            errors.push_with_hint(
                name.place,
                format!(
                    "the {what} {} is not a descendant of the base {base}",
                    quoted(&name.text)
                ),
                "choose a base above it in the tree, and do not drop it",
            );
        }
    }
}

/// Checks that targets of struct fields are modelled.
fn check_targets(
    request: &Request,
    tree: &Tree,
    links: &Names<'_, LinkId>,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) {
    for parameter in &request.parameters {
        let missing = match &parameter.target {
            // Targets of actuators are checked with the other actuator data.
            Target::Gravity
            | Target::BasePosition
            | Target::BasePlacement
            | Target::ArmatureOf(_)
            | Target::DampingOf(_)
            | Target::FrictionOf(_) => None,
            Target::MassOf(name)
            | Target::CenterOfMassOf(name)
            | Target::InertiaOf(name)
            | Target::PayloadOn(name) => links
                .find(name, errors)
                .is_some_and(|link| tree.dropped.contains(&link))
                .then_some(("link", name)),
            Target::OriginOf(name) | Target::PlacementOf(name) => joints
                .find(name, errors)
                .is_some_and(|joint| tree.branches.iter().all(|branch| branch.joint != joint))
                .then_some(("joint", name)),
        };
        if let Some((what, name)) = missing {
            errors.push(
                name.place,
                format!("{what} {} is not modelled", quoted(&name.text)),
            );
        }
    }
}

/// Checks that a field for a mass or payload belongs to a link that moves; on others it would change nothing.
fn check_moving(
    description: &Description,
    request: &Request,
    tree: &Tree,
    links: &Names<'_, LinkId>,
    errors: &mut Errors,
) {
    let mut moves = List::filled(false, description.links.len());
    for branch in &tree.branches {
        moves[branch.child] = moves[branch.parent] || branch.held.is_none();
    }
    for parameter in &request.parameters {
        if let Some((name, what)) = parameter.target.weighs()
            && let Some(link) = links.get(name)
            && !moves[link]
            && !tree.dropped.contains(&link)
        {
            errors.push_with_hint(
                name.place,
                format!(
                    "link {} does not move: {what} changes nothing",
                    quoted(&name.text)
                ),
                "leave the field out, or choose a base above the link in the tree",
            );
        }
    }
}

/// Checks the number of joints.
fn check_size(description: &Description, tree: &Tree, errors: &mut Errors) {
    let count = tree.branches.len();
    if count > MOST {
        errors.push_with_hint(
            description.name.place,
            format!("the robot has {count} joints, and at most {MOST} can be modelled"),
            "choose a base further out, or drop links that are not needed",
        );
    }
}

/// Takes the only end of the tree as the tip if none is named. Several ends are an error if a function or `path_only`
/// needs the tip.
fn choose_tip(
    description: &Description,
    request: &Request,
    mimics: &List<JointId, Option<MimicLaw>>,
    tree: &mut Tree,
    errors: &mut Errors,
) {
    let mut ends = modelled(description, tree.base, &tree.branches, true);
    let mut carries = List::filled(false, description.links.len());
    for branch in &tree.branches {
        carries[branch.parent] = true;
    }
    ends.retain(|&link| !carries[link]);
    if let ([only], None) = (&ends[..], tree.tip) {
        tree.tip = Some(*only);
    }
    let names = || {
        const SHOWN: usize = 8;
        let shown = ends
            .iter()
            .take(SHOWN)
            .map(|&end| quoted(&description[end].name.text));
        let more = ends.len().saturating_sub(SHOWN);
        let more = (more > 0).then(|| format!("and {more} more"));
        shown.chain(more).collect::<Vec<_>>().join(", ")
    };
    // A tip that was named and not found has been reported.
    let unknown = tree.tip.is_none() && request.tip.is_none();
    match tree.tip {
        Some(tip) if request.path_only => hold_off_path(tree, mimics, tip),
        None if request.path_only && unknown => errors.push_with_hint(
            description.name.place,
            "path_only needs a tip, and the robot has more than one end",
            format!("name one of: {}", names()),
        ),
        _ => {}
    }
    let mut functions = request.functions.iter().flatten();
    if functions.any(|function| function.needs_a_frame()) && unknown && request.frames.is_empty() {
        errors.push_with_hint(
            description.name.place,
            "poses and Jacobians need a tip, and the robot has more than one end",
            format!("name one as the tip: {}", names()),
        );
    }
}

/// Holds every joint that does not move the tip, neither itself nor through a mimic joint.
fn hold_off_path(tree: &mut Tree, mimics: &List<JointId, Option<MimicLaw>>, tip: LinkId) {
    let mut moves = mimics.map(|_| false);
    let mut link = tip;
    // Children come after parents, so one pass backwards meets the path in order.
    for branch in tree.branches.iter().rev() {
        if branch.child == link && link != tree.base {
            link = branch.parent;
            moves[branch.joint] = true;
            if let Some(law) = mimics[branch.joint] {
                moves[law.mimicked] = true;
            }
        }
    }
    for branch in &mut tree.branches {
        // A mimic joint is held by its mimicked joint.
        let own = mimics[branch.joint].is_none();
        if own && !moves[branch.joint] && branch.held.is_none() {
            branch.held = Some(Number::default());
        }
    }
}

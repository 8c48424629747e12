//! Mimic joints.
//!
//! In: the description and its tree. Out: for each mimic joint the joint whose coordinate moves it, through other mimic
//! joints if need be, with multiplier and offset; an error if that is no joint with one coordinate; and which mimic
//! joints are locked with the joint that they mimic.

use super::names::Names;
use super::tree::{Branch, MimicLaw, Tree};
use crate::description::{Description, JointId, Number};
use crate::error::{Diagnostic, Errors, Place};
use crate::expression::Double;
use crate::list::List;
use crate::number::computed;
use crate::wording::quoted;

/// Rejects joints that cannot mimic or be mimicked; returns for each mimic joint what moves it. Locked joints mimic
/// nothing; joints that are left out pass on what they mimic.
pub fn mimics(
    description: &Description,
    tree: &Tree,
    joints: &Names<'_, JointId>,
    errors: &mut Errors,
) -> List<JointId, Option<MimicLaw>> {
    let mut mimicked_joints: List<JointId, Option<JointId>> =
        List::filled(None, description.joints.len());
    let there = tree.branches.iter().filter(|branch| branch.held.is_none());
    let mut waiting: Vec<JointId> = there.map(|branch| branch.joint).collect();
    while let Some(own) = waiting.pop() {
        let joint = &description[own];
        let Some(mimic) = joint.mimic.as_ref().filter(|_| joint.kind.moves()) else {
            continue;
        };
        if tree.locks.contains_key(&own) || mimicked_joints[own].is_some() {
            continue;
        }
        let Some(mimicked) = joints.get(&mimic.mimicked) else {
            // An unknown name is a slip in a vendor's file, which other readers ignore, and an error in an inline
            // description.
            if mimic.place.order().is_none() {
                joints.find(&mimic.mimicked, errors);
            }
            continue;
        };
        mimicked_joints[own] = Some(mimicked);
        waiting.push(mimicked);
        let mut both = [joint, &description[mimicked]].into_iter();
        if let Some(several) = both.find(|joint| joint.kind.has_several()) {
            errors.push_with_hint(
                mimic.place,
                format!(
                    "joint {} mimics joint {}, and {} has several coordinates",
                    quoted(&joint.name.text),
                    quoted(&mimic.mimicked.text),
                    quoted(&several.name.text)
                ),
                "mimic joints and mimicked joints must have one coordinate",
            );
        }
    }
    let refused = refuse_cycles(description, &mimicked_joints, errors);
    let law = |joint: JointId| {
        mimicked_joints[joint].filter(|_| !refused)?;
        let mut law = MimicLaw {
            mimicked: joint,
            multiplier: Double::from(1.0),
            offset: Double::from(0.0),
        };
        while let (Some(next), Some(mimic)) = (
            mimicked_joints[law.mimicked],
            &description[law.mimicked].mimic,
        ) {
            // In extended precision: a rounded product would be a different offset.
            let offset = law.multiplier * mimic.offset.exact();
            law.offset = law.offset + offset;
            law.multiplier = law.multiplier * mimic.multiplier.exact();
            law.mimicked = next;
        }
        Some(law)
    };
    mimicked_joints.ids().map(law).collect()
}

/// Rejects joints that mimic themselves, directly or through others. Returns true if there are any.
fn refuse_cycles(
    description: &Description,
    mimicked_joints: &List<JointId, Option<JointId>>,
    errors: &mut Errors,
) -> bool {
    let mut refused = false;
    // The pass in which a joint was seen; each joint is visited once.
    let mut seen = mimicked_joints.map(|_| None);
    for start in mimicked_joints.ids() {
        let mut at = start;
        while seen[at].is_none() {
            seen[at] = Some(start);
            let Some(next) = mimicked_joints[at] else {
                break;
            };
            if seen[next] == Some(start) {
                let joint = &description[next];
                let name = quoted(&joint.name.text);
                let message = if next == at {
                    format!("joint {name} mimics itself")
                } else {
                    format!("joint {name} mimics itself through others")
                };
                let place = joint
                    .mimic
                    .as_ref()
                    .map_or(joint.place, |mimic| mimic.place);
                errors.push_with_hint(place, message, "one of them must have its own coordinate");
                refused = true;
            }
            at = next;
        }
    }
    refused
}

/// Records what each joint mimics, and holds mimic joints whose mimicked joint is locked or left out, or whose
/// multiplier is zero. A joint that is left out has its locked coordinate, or zero.
pub fn hold(tree: &mut Tree, mimics: &List<JointId, Option<MimicLaw>>) {
    let stands = |joint: JointId| {
        let lock = tree.locks.get(&joint);
        lock.map_or(Double::ZERO, Number::exact)
    };
    let mut held: List<JointId, Option<Double>> =
        mimics.ids().map(|joint| Some(stands(joint))).collect();
    for branch in &tree.branches {
        held[branch.joint] = branch.held.as_ref().map(Number::exact);
    }
    let branches = tree.branches.iter_mut();
    for branch in branches.filter(|branch| branch.held.is_none()) {
        branch.mimics = mimics[branch.joint];
        let Some(law) = branch.mimics else {
            continue;
        };
        let still = law.multiplier.is_zero().then_some(Double::ZERO);
        if let Some(at) = held[law.mimicked].or(still) {
            let at = law.multiplier * at + law.offset;
            branch.held = Some(computed(at, Place::Unknown));
        }
    }
}

/// A joint that is held because the joint that it mimics has no coordinate.
pub struct Stuck {
    pub place: Place,
    /// The two joints, and the reason.
    pub why: String,
    pub hint: String,
}

/// The mimic joints whose mimicked joint was left out, or is fixed.
pub fn stuck(description: &Description, tree: &Tree) -> Vec<Stuck> {
    let moves = |joint: JointId| {
        let mut there = tree.branches.iter();
        there.any(|branch| branch.joint == joint) && description[joint].kind.moves()
    };
    let law = |branch: &Branch| Some((branch.joint, branch.mimics?));
    let mimics = tree.branches.iter().filter_map(law);
    let stuck =
        mimics.filter(|(_, law)| !(moves(law.mimicked) || tree.locks.contains_key(&law.mimicked)));
    let stuck = stuck.map(|(joint, law)| {
        let name = |joint: JointId| quoted(&description[joint].name.text);
        let (own, mimicked) = (name(joint), name(law.mimicked));
        let (why, hint) = if description[law.mimicked].kind.moves() {
            let hint = format!("lock {own} where it should be, or keep {mimicked}");
            ("which has no coordinate here", hint)
        } else {
            let hint = format!("let {own} mimic a moving joint, or leave <mimic> out");
            ("which is fixed", hint)
        };
        Stuck {
            place: description[joint].place,
            why: format!("joint {own} mimics joint {mimicked}, {why}"),
            hint,
        }
    });
    stuck.collect()
}

/// Warnings about mimic joints that are held because their mimicked joint was left out or is fixed, and about those
/// with their own coordinate because their mimicked joint does not exist.
pub fn warnings(description: &Description, tree: &Tree) -> Vec<Diagnostic> {
    let orphans = tree.branches.iter().filter(|branch| branch.held.is_none());
    let orphans = orphans.filter_map(|branch| {
        let joint = &description[branch.joint];
        let mimic = joint.mimic.as_ref().filter(|_| branch.mimics.is_none())?;
        let [own, mimicked] = [&joint.name.text, &mimic.mimicked.text].map(|name| quoted(name));
        Some(Diagnostic {
            place: mimic.place,
            message: format!(
                "joint {own} mimics joint {mimicked}, which does not exist: it gets a coordinate of its own"
            ),
            hint: Some("correct the name of the mimicked joint, or leave <mimic> out".to_owned()),
        })
    });
    let stuck = stuck(description, tree)
        .into_iter()
        .map(|stuck| Diagnostic {
            place: stuck.place,
            message: format!("{}: held at its position for coordinate 0", stuck.why),
            hint: Some(stuck.hint),
        });
    orphans.chain(stuck).collect()
}

//! `<key>` of `<keyframe>`: configurations with names.
//!
//! Runs once the tree is read. The numbers of `qpos` are those of all joints of the model, in the order of the bodies.
//! They are in radians, whatever the compiler says, and quaternions are w, x, y, z.

use std::collections::{HashMap, HashSet};

use super::element::Element;
use super::parts::{Affix, ModelId, PartId, Scope};
use super::reading::Mjcf;
use super::values::Attributes;
use crate::description::spatial::{Pose, exactly, quaternion, to_number};
use crate::description::{Configuration, JointId, JointKind, Number};
use crate::error::{Diagnostic, Place};
use crate::expression::Double;
use crate::list::Id;
use crate::wording::quoted;

/// Maximum number of coordinates of a configuration.
const MOST_COORDINATES: usize = 1_000_000;

impl<'a> Mjcf<'a> {
    /// Reads all keys that have a name and a `qpos`. Those of an attached model count once for each prefix.
    pub(super) fn read_keys(&mut self, scopes: &[Scope]) -> Vec<Configuration> {
        let mut found: Vec<Configuration> = Vec::new();
        let mut known = HashSet::new();
        let mut names = HashSet::new();
        for scope in scopes {
            let Some((from, at)) = &scope.attached else {
                continue;
            };
            let sections = self.models[scope.model].root.named("keyframe");
            if sections.is_empty() || !known.insert((scope.model, &scope.affix.prefix)) {
                continue;
            }
            let prefix = Affix {
                prefix: scope.affix.prefix.clone(),
                suffix: String::new(),
            };
            let joints = self.joints_of(scope.model);
            let joints: Vec<_> = joints
                .into_iter()
                .map(|(part, count)| {
                    let part = part.index();
                    let here = from.contains(&part).then(|| part - from.start + at);
                    let joint = here.and_then(|here| {
                        let joints = &self.tree.joints_of_parts;
                        joints.get(&PartId::new(here)).copied()
                    });
                    (joint, count)
                })
                .collect();
            for key in sections
                .into_iter()
                .flat_map(|section| section.named("key"))
            {
                let Some(key) = self.within(scope.model, |mjcf| mjcf.key(key, &prefix, &joints))
                else {
                    continue;
                };
                if !names.insert(key.name.text.clone()) {
                    let message = format!("there are two keys {}", quoted(&key.name.text));
                    self.reader.errors.push(key.name.place, message);
                }
                found.push(key);
            }
        }
        found
    }

    /// The joints of a model, in the order of its bodies, each with its number of coordinates.
    fn joints_of(&self, model: ModelId) -> Vec<(PartId, usize)> {
        let parts = self.models[model].parts.list.numbered();
        let joints = parts.filter(|(_, part)| {
            let tag = part.item.element.tag();
            matches!(tag, "joint" | "freejoint")
        });
        let mut joints: Vec<_> = joints
            .map(|(number, part)| (part.within, number, part.item.clone()))
            .collect();
        joints.sort_by_key(|(within, ..)| *within);
        let counted = joints.into_iter().map(|(_, number, item)| {
            let written = item.element.attribute("class");
            let named = written.and_then(|name| {
                let classes = &self.models[item.model].defaults.classes;
                classes.get(name.attribute.value().trim()).cloned()
            });
            // A class or a type that does not exist is an error of the joint.
            let attributes = Attributes {
                own: item.element,
                kind: "joint",
                class: named.unwrap_or(item.class),
            };
            let is_free = item.element.tag() == "freejoint";
            let kind = attributes.get("type").filter(|_| !is_free);
            let kind = kind.map(|kind| kind.attribute.value().trim());
            let count = match kind.unwrap_or_default() {
                "free" => 7,
                _ if is_free => 7,
                "ball" => 4,
                _ => 1,
            };
            (number, count)
        });
        counted.collect()
    }

    /// `joints` are those of the model, as far as they are attached, with their numbers of coordinates. `None` without
    /// a name or coordinates, or if their number is not that of the joints, which is a warning.
    fn key(
        &mut self,
        key: Element<'a>,
        affix: &Affix,
        joints: &[(Option<JointId>, usize)],
    ) -> Option<Configuration> {
        let written = key.attribute("qpos")?;
        let mut name = self.word(key.attribute("name")?);
        if name.text.is_empty() {
            return None;
        }
        name.text = affix.name(&name.text);
        let subject = format!("key {}", quoted(&name.text));
        let all = self.list(written, 0..=MOST_COORDINATES, &subject)?;
        let needed: usize = joints.iter().map(|(_, count)| count).sum();
        let place = self.place(key);
        // MuJoCo completes a key of a file that attaches models, by numbers that depend on the order of attachments.
        if all.len() != needed {
            self.reader.warnings.push(Diagnostic {
                place,
                message: format!(
                    "{subject} has {} coordinates, and the joints {needed}",
                    all.len()
                ),
                hint: Some("it is left out".to_owned()),
            });
            return None;
        }
        let mut rest = &all[..];
        let mut values = HashMap::new();
        for (joint, count) in joints {
            let (own, others) = rest.split_at(*count);
            rest = others;
            values.extend(joint.map(|joint| (joint, own)));
        }
        let moving = self.tree.joints.numbered();
        let moving = moving.filter(|(_, joint)| joint.kind.moves());
        let joints = moving.map(|(id, joint)| {
            let own = values.get(&id).map(|own| own.to_vec());
            let own = own.unwrap_or_else(|| self.described(id, place));
            (joint.name.clone(), coordinates(&own))
        });
        Some(Configuration {
            name,
            joints: joints.collect(),
        })
    }

    /// The numbers of a joint in the described configuration.
    fn described(&self, joint: JointId, place: Place) -> Vec<Number> {
        let joint = &self.tree.joints[joint];
        let [zero, one] = [0.0, 1.0].map(exactly);
        let exact = match joint.kind {
            JointKind::Spherical => vec![one, zero, zero, zero],
            JointKind::Floating => {
                let placement = self.tree.placements.get(&joint.child.text);
                let pose = placement.map_or_else(Pose::identity, |(_, steps)| Pose::of(steps));
                let mut quaternion = quaternion(&pose.rotation);
                quaternion.rotate_right(1);
                [&pose.position[..], &quaternion].concat()
            }
            _ => {
                let reference = self.tree.references.get(&joint.name.text);
                vec![reference.map_or(zero, Number::exact)]
            }
        };
        let exact = exact.into_iter();
        exact.map(|entry| to_number(entry, place)).collect()
    }
}

/// Coordinates in the order of this project, with a quaternion of length 1.
fn coordinates(written: &[Number]) -> Vec<Number> {
    let Some(at) = written.len().checked_sub(4) else {
        return written.to_vec();
    };
    let (position, quaternion) = written.split_at(at);
    let squares = quaternion.iter().map(|entry| entry.exact() * entry.exact());
    let length = squares
        .fold(Double::ZERO, |sum, square| sum + square)
        .sqrt();
    let of_length_1 = quaternion.iter().map(|entry| {
        if length.is_zero() {
            *entry
        } else {
            to_number(entry.exact() / length, entry.place)
        }
    });
    let mut quaternion: Vec<Number> = of_length_1.collect();
    quaternion.rotate_left(1);
    [position, &quaternion].concat()
}

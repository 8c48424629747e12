//! `<key>` of `<keyframe>`: configurations with names.
//!
//! Runs once the tree is read. The numbers of `qpos` are those of all joints, in the order of the bodies. They are in
//! radians, whatever the compiler says, and quaternions are w, x, y, z.

use super::element::Element;
use super::reading::Mjcf;
use crate::description::spatial::to_number;
use crate::description::{Configuration, JointKind, Number};
use crate::error::Diagnostic;
use crate::expression::Double;
use crate::wording::quoted;

/// Maximum number of coordinates of a configuration.
const MOST_COORDINATES: usize = 1_000_000;

impl<'a> Mjcf<'a> {
    /// Reads all keys that have a name and a `qpos`.
    pub(super) fn read_keys(&mut self, root: Element<'a>) -> Vec<Configuration> {
        let sections = root.named("keyframe").into_iter();
        let keys = sections.flat_map(|section| section.named("key"));
        keys.filter_map(|key| self.key(key)).collect()
    }

    /// `None` without a name or coordinates, or if there are too few or too many of them, which is a warning.
    fn key(&mut self, key: Element<'a>) -> Option<Configuration> {
        let written = key.attribute("qpos")?;
        let name = self.word(key.attribute("name")?);
        let subject = format!("key {}", quoted(&name.text));
        let all = self.list(written, 0..=MOST_COORDINATES, &subject)?;
        let mut rest = &all[..];
        let mut joints = Vec::new();
        let mut needed = 0;
        for joint in &self.tree.joints {
            let count = match joint.kind {
                JointKind::Fixed => continue,
                JointKind::Spherical => 4,
                JointKind::Floating => 7,
                _ => 1,
            };
            needed += count;
            let Some((own, others)) = rest.split_at_checked(count) else {
                continue;
            };
            rest = others;
            joints.push((joint.name.clone(), coordinates(own)));
        }
        if all.len() != needed {
            let place = self.place(key);
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
        Some(Configuration { name, joints })
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

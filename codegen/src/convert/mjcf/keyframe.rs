//! Keyframes: the configurations with names, in the order of the joints of the file.

use super::Mjcf;
use crate::convert::elementary::ElementaryMotion;
use crate::convert::numbers::text;
use crate::description::{Configuration, JointId, Number};
use crate::joint::Manifold;

impl Mjcf<'_> {
    /// Writes all configurations that have a value for each joint.
    pub(super) fn keyframes(&mut self) {
        let description = self.description;
        let keys = description.configurations.iter();
        let keys = keys.filter_map(|configuration| {
            let q = self.qpos(configuration)?;
            Some([("name", configuration.name.text.clone()), ("qpos", q)])
        });
        let keys: Vec<_> = keys.collect();
        if keys.is_empty() {
            return;
        }
        self.markup.begin("keyframe", &[]);
        for key in keys {
            self.markup.empty("key", &key);
        }
        self.markup.end();
    }

    /// The coordinates of a configuration.
    fn qpos(&self, configuration: &Configuration) -> Option<String> {
        let mut numbers = Vec::new();
        let mut before: Option<(JointId, usize)> = None;
        for (joint, motion) in &self.order {
            let first = match before {
                Some((same, count)) if same == *joint => count,
                _ => 0,
            };
            let name = &self.description[*joint].name.text;
            let mut joints = configuration.joints.iter();
            let (_, own) = joints.find(|(other, _)| other.text == *name)?;
            let count = match motion {
                ElementaryMotion::Fixed | ElementaryMotion::Manifold(Manifold::Planar) => 0,
                ElementaryMotion::Rotation | ElementaryMotion::Translation => 1,
                ElementaryMotion::Manifold(manifold) => manifold.coordinates().len(),
            };
            let own: &[Number] = own.get(first..first + count)?;
            // Quaternions are w, x, y, z there.
            let (position, quaternion) = own.split_at(count.saturating_sub(4));
            match quaternion {
                [x, y, z, w] => numbers.extend(position.iter().chain([w, x, y, z])),
                others => numbers.extend(position.iter().chain(others)),
            }
            before = Some((*joint, first + count));
        }
        let numbers = numbers.into_iter().map(text);
        Some(numbers.collect::<Vec<_>>().join(" "))
    }
}

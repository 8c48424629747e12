//! Placements of URDF: `xyz` and `rpy`, or the quaternion of URDF 1.1.

use roxmltree::{Attribute, Node};

use crate::description::xml::element::Reader;
use crate::description::{Axis, Number, Step, axis};

/// 2π, with room for rounded values of it.
const MORE_THAN_A_REVOLUTION: f64 = 6.3;

impl<'t> Reader<'_, 't> {
    /// The placement in `<origin xyz="…" rpy="…"/>`; without the element, the frames coincide.
    pub(in crate::description::urdf) fn origin(
        &mut self,
        origin: Option<Node<'_, 't>>,
        subject: &str,
    ) -> Vec<Step> {
        origin.map_or_else(Vec::new, |node| self.placement(node, subject))
    }

    /// The placement in an element's own `xyz`, and `rpy` or `quat_xyzw`.
    pub(in crate::description::urdf) fn placement(
        &mut self,
        node: Node<'_, 't>,
        subject: &str,
    ) -> Vec<Step> {
        let mut steps = Vec::new();
        if let Some(xyz) = node.attribute_node("xyz") {
            let subject = format!("xyz of the origin of {subject}");
            steps.extend(self.numbers(&xyz, &subject).map(Step::Translate));
        }
        let [rpy, quaternion] = ["rpy", "quat_xyzw"].map(|name| node.attribute_node(name));
        match (rpy, quaternion) {
            (Some(rpy), None) => {
                let subject = format!("rpy of the origin of {subject}");
                steps.extend(self.angles(&rpy, &subject).into_iter().flatten());
            }
            (None, Some(quaternion)) => {
                let subject = format!("quat_xyzw of the origin of {subject}");
                steps.extend(self.quaternion(&quaternion, &subject).map(Step::Quaternion));
            }
            (Some(_), Some(quaternion)) => self.errors.push_with_hint(
                self.positions.place(quaternion.range().start),
                format!("the origin of {subject} has both rpy and quat_xyzw"),
                "leave one of them out",
            ),
            (None, None) => {}
        }
        steps
    }

    /// Roll, pitch and yaw are rotations about fixed axes, which equal rotations about moving axes in reverse order.
    fn angles(&mut self, rpy: &Attribute<'_, 't>, subject: &str) -> Option<[Step; 3]> {
        let [roll, pitch, yaw]: [Number; 3] = self.numbers(rpy, subject)?;
        let mut angles = [roll, pitch, yaw].into_iter();
        if let Some(angle) = angles.find(|angle| angle.value.abs() > MORE_THAN_A_REVOLUTION) {
            let degrees = angle.value;
            self.warn(
                angle.place,
                format!("{subject} has an angle of {degrees} rad, more than one revolution"),
                Some(format!(
                    "angles are in radians: {degrees} degrees are {}",
                    degrees.to_radians()
                )),
            );
        }
        Some([
            Step::Rotate(Axis::Z, yaw),
            Step::Rotate(Axis::Y, pitch),
            Step::Rotate(Axis::X, roll),
        ])
    }

    fn quaternion(&mut self, written: &Attribute<'_, 't>, subject: &str) -> Option<[Number; 4]> {
        let entries = self.numbers(written, subject)?;
        let place = self.value_place(written);
        match axis::quaternion(&entries) {
            Ok(warning) => {
                if let Some(warning) = warning {
                    self.warn(
                        place,
                        format!("{subject} {}", warning.what),
                        Some(warning.hint),
                    );
                }
            }
            Err(refusal) => {
                let message = format!("{subject} {}", refusal.what);
                self.errors.push_with_hint(place, message, refusal.hint);
                return None;
            }
        }
        if std::mem::take(&mut self.is_of_version_1_0) {
            self.warn(
                self.positions.place(written.range().start),
                format!("{subject} needs URDF 1.1, but the robot has no such version"),
                Some("write <robot version=\"1.1\">: other readers may ignore it".to_owned()),
            );
        }
        Some(entries)
    }
}

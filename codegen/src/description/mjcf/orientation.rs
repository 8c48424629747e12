//! Placements: `pos`, and one of `quat`, `axisangle`, `euler`, `xyaxes` and `zaxis`.
//!
//! Quaternions and axes need not be normalised. If an element and its class of defaults write different forms of
//! orientation, the element's own counts, as in MuJoCo 4; in former versions another form overrode a quaternion.

use super::element::Written;
use super::reading::Mjcf;
use super::values::Attributes;
use crate::description::spatial::{self, DoubleMatrix, DoubleVector, exactly, to_number};
use crate::description::{Axis, Number, Step};
use crate::error::Place;
use crate::expression::Double;

/// The attributes of orientation.
const FORMS: [&str; 5] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

impl<'a> Mjcf<'a> {
    /// The placement of an element's frame.
    pub(super) fn placement(&mut self, attributes: &Attributes<'a>, subject: &str) -> Vec<Step> {
        let mut steps = Vec::new();
        let position = self.numbers::<3>(attributes.get("pos"), subject);
        steps.extend(position.filter(is_not_zero).map(Step::Translate));
        steps.extend(self.orientation(attributes, subject));
        steps
    }

    /// The rotation of an element's frame.
    pub(super) fn orientation(&mut self, attributes: &Attributes<'a>, subject: &str) -> Vec<Step> {
        let own = attributes.own;
        let own_forms = FORMS.into_iter().filter_map(|form| own.attribute(form));
        let own_forms: Vec<Written<'a>> = own_forms.collect();
        if own_forms.len() > 1 {
            let message = format!("{subject} has more than one orientation");
            self.refuse(
                own,
                message,
                "write only one of quat, axisangle, xyaxes, zaxis and euler",
            );
            return Vec::new();
        }
        // The element's own attribute, or else the last one of its classes.
        let of_class = || attributes.class.last_of(attributes.kind, &FORMS);
        let Some(form) = own_forms.first().copied().or_else(of_class) else {
            return Vec::new();
        };
        match form.attribute.name() {
            "quat" => self.quaternion(form, subject).into_iter().collect(),
            "axisangle" => self.axis_angle(form, subject),
            "xyaxes" => self.axes(form, subject),
            "zaxis" => {
                let axis = self.numbers::<3>(Some(form), subject);
                let place = self.place_of(form);
                let rotation =
                    axis.and_then(|axis| z_along(axis.map(|entry| entry.exact()), place));
                if rotation.is_none() && axis.is_some() {
                    self.refuse_length(form, subject);
                }
                rotation.into_iter().collect()
            }
            _ => {
                let angles = self.numbers::<3>(Some(form), subject);
                angles.map_or_else(Vec::new, |angles| self.euler(angles))
            }
        }
    }

    fn refuse_length(&mut self, written: Written<'a>, subject: &str) {
        let name = written.attribute.name();
        let place = self.place_of(written);
        self.reader.errors.push_with_hint(
            place,
            format!("{name} of {subject} has length 0"),
            "give a direction or a quaternion that is not 0",
        );
    }

    fn quaternion(&mut self, quat: Written<'a>, subject: &str) -> Option<Step> {
        let entries = self.numbers::<4>(Some(quat), subject)?;
        if entries.iter().all(|entry| entry.value == 0.0) {
            self.refuse_length(quat, subject);
            return None;
        }
        let is_turned = entries[1..].iter().any(|entry| entry.value != 0.0);
        is_turned.then(|| of_mujoco(entries))
    }

    /// An angle of the file in radians.
    pub(super) fn angle(&self, angle: Number) -> Number {
        if self.model().compiler.degrees {
            let exact = angle.exact() * Double::PI / exactly(180.0);
            to_number(exact, angle.place)
        } else {
            angle
        }
    }

    /// Rotations by Euler angles about the axes of `eulerseq`.
    pub(super) fn euler(&self, angles: [Number; 3]) -> Vec<Step> {
        let mut steps = Vec::new();
        for (letter, angle) in self.model().compiler.euler.into_iter().zip(angles) {
            let axis = match letter.to_ascii_lowercase() {
                'x' => Axis::X,
                'y' => Axis::Y,
                _ => Axis::Z,
            };
            let step = Step::Rotate(axis, self.angle(angle));
            if angle.value == 0.0 {
                continue;
            }
            if letter.is_ascii_lowercase() {
                steps.push(step);
            } else {
                steps.insert(0, step);
            }
        }
        steps
    }

    fn axis_angle(&mut self, form: Written<'a>, subject: &str) -> Vec<Step> {
        let Some([x, y, z, angle]) = self.numbers::<4>(Some(form), subject) else {
            return Vec::new();
        };
        let rotation = rotation_about(&[x, y, z], self.angle(angle));
        if rotation.is_none() {
            self.refuse_length(form, subject);
        }
        rotation.into_iter().collect()
    }

    fn axes(&mut self, form: Written<'a>, subject: &str) -> Vec<Step> {
        let Some(entries) = self.numbers::<6>(Some(form), subject) else {
            return Vec::new();
        };
        let place = self.place_of(form);
        let [a, b, c, d, e, f] = entries.map(|entry| entry.exact());
        let step = of_axes([a, b, c], [d, e, f], place);
        if step.is_none() {
            self.refuse_length(form, subject);
        }
        step.into_iter().collect()
    }
}

fn is_not_zero(offset: &[Number; 3]) -> bool {
    offset.iter().any(|entry| entry.value != 0.0)
}

/// A rotation by a quaternion in MuJoCo's order w, x, y, z.
pub(super) fn of_mujoco([w, x, y, z]: [Number; 4]) -> Step {
    Step::Quaternion([x, y, z, w])
}

/// A rotation about an axis of any length; `None` if the length is 0.
pub(super) fn rotation_about(axis: &[Number; 3], angle: Number) -> Option<Step> {
    let along = |k: usize| {
        let others = [axis[(k + 1) % 3], axis[(k + 2) % 3]];
        others.iter().all(|entry| entry.value == 0.0)
    };
    let axes = [Axis::X, Axis::Y, Axis::Z].into_iter().enumerate();
    for (k, name) in axes {
        if along(k) {
            let backwards = Number {
                value: -angle.value,
                rest: -angle.rest,
                ..angle
            };
            return match axis[k].value {
                0.0 => None,
                value if value < 0.0 => Some(Step::Rotate(name, backwards)),
                _ => Some(Step::Rotate(name, angle)),
            };
        }
    }
    let axis = axis.map(|entry| entry.exact());
    let length = spatial::dot(axis, axis).sqrt();
    let (sine, cosine) = (angle.exact() / exactly(2.0)).sin_cos();
    let [x, y, z] = spatial::times(axis, sine);
    let entries = [x, y, z, cosine * length];
    Some(Step::Quaternion(
        entries.map(|entry| to_number(entry, angle.place)),
    ))
}

/// The shortest rotation of the z axis to a direction; about x if the direction is −z. `None` if its length is 0.
pub(super) fn z_along([x, y, z]: DoubleVector, place: Place) -> Option<Step> {
    let across = x * x + y * y;
    let length = (across + z * z).sqrt();
    if length.is_zero() {
        return None;
    }
    let entries = if !across.is_zero() {
        let is_up = z.sign().to_f64() >= 0.0;
        let w = if is_up {
            length + z
        } else {
            across / (length - z)
        };
        [-y, x, Double::ZERO, w]
    } else if z.sign().to_f64() > 0.0 {
        return Some(Step::Quaternion(
            [0.0, 0.0, 0.0, 1.0].map(|entry| to_number(exactly(entry), place)),
        ));
    } else {
        [exactly(1.0), Double::ZERO, Double::ZERO, Double::ZERO]
    };
    Some(Step::Quaternion(
        entries.map(|entry| to_number(entry, place)),
    ))
}

/// The rotation to the frame with this x axis and with y in the plane of both vectors. `None` if they are parallel or
/// 0.
fn of_axes(x: DoubleVector, y: DoubleVector, place: Place) -> Option<Step> {
    let normal = spatial::cross(x, y);
    let y = spatial::cross(normal, x);
    let mut columns = [x, y, normal];
    for column in &mut columns {
        let square = spatial::dot(*column, *column);
        if square.is_zero() {
            return None;
        }
        let length = square.sqrt();
        *column = column.map(|entry| entry / length);
    }
    let rotation: DoubleMatrix = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    let entries = spatial::quaternion(&rotation);
    Some(Step::Quaternion(
        entries.map(|entry| to_number(entry, place)),
    ))
}

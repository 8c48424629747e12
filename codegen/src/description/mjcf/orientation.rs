//! Placements: `pos`, and one of `quat`, `axisangle`, `euler`, `xyaxes` and `zaxis`.
//!
//! In: the attributes of an element. Out: the steps of its placement, and complaints. What MuJoCo makes of length 1 may
//! have any. A class of defaults may have one form of orientation and the element another: the element's own counts, as
//! in MuJoCo 4; in former versions a quaternion gave way.

use super::element::Written;
use super::reading::Mjcf;
use super::spatial::{self, Matrix, Vector, exactly, written};
use super::values::Attributes;
use crate::description::{Axis, Number, Step};
use crate::error::Place;
use crate::expression::Double;

/// The forms.
const FORMS: [&str; 5] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

impl<'a> Mjcf<'a> {
    /// Where an element's frame is.
    pub(super) fn placement(&mut self, attributes: &Attributes<'a>, subject: &str) -> Vec<Step> {
        let mut steps = Vec::new();
        let position = self.numbers::<3>(attributes.get("pos"), subject);
        steps.extend(position.filter(is_not_zero).map(Step::Translate));
        steps.extend(self.orientation(attributes, subject));
        steps
    }

    /// How it is turned.
    pub(super) fn orientation(&mut self, attributes: &Attributes<'a>, subject: &str) -> Vec<Step> {
        let own = attributes.own;
        let said = FORMS.into_iter().filter_map(|form| own.attribute(form));
        let said: Vec<Written<'a>> = said.collect();
        if said.len() > 1 {
            let message = format!("{subject} is oriented in more than one way");
            self.refuse(own, message, "leave all but one of them out");
            return Vec::new();
        }
        // The last that is said, from the outermost class to the element.
        let of_class = || attributes.class.last_of(attributes.kind, &FORMS);
        let Some(form) = said.first().copied().or_else(of_class) else {
            return Vec::new();
        };
        match form.attribute.name() {
            "quat" => self.quaternion(form, subject).into_iter().collect(),
            "axisangle" => self.axis_angle(form, subject),
            "xyaxes" => self.axes(form, subject),
            "zaxis" => {
                let axis = self.numbers::<3>(Some(form), subject);
                let place = self.place_of(form);
                let turn = axis.and_then(|axis| z_along(axis.map(|entry| entry.exact()), place));
                if turn.is_none() && axis.is_some() {
                    self.refuse_length(form, subject);
                }
                turn.into_iter().collect()
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
            format!("{name} of {subject} has no direction"),
            "give it a length that is not zero",
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

    /// An angle in radians.
    pub(super) fn angle(&self, angle: Number) -> Number {
        if self.compiler.degrees {
            let exact = angle.exact() * Double::PI / exactly(180.0);
            written(exact, angle.place)
        } else {
            angle
        }
    }

    /// Angles about the axes that the compiler names.
    pub(super) fn euler(&self, angles: [Number; 3]) -> Vec<Step> {
        let mut steps = Vec::new();
        for (letter, angle) in self.compiler.euler.into_iter().zip(angles) {
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
        let turn = turn(&[x, y, z], self.angle(angle));
        if turn.is_none() {
            self.refuse_length(form, subject);
        }
        turn.into_iter().collect()
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

/// A quaternion that begins with w.
pub(super) fn of_mujoco([w, x, y, z]: [Number; 4]) -> Step {
    Step::Turn([x, y, z, w])
}

/// A rotation about an axis of any length; none about one without a direction.
pub(super) fn turn(axis: &[Number; 3], angle: Number) -> Option<Step> {
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
    Some(Step::Turn(entries.map(|entry| written(entry, angle.place))))
}

/// The shortest rotation that takes z along a direction; about x where that is −z. None of no direction.
pub(super) fn z_along([x, y, z]: Vector, place: Place) -> Option<Step> {
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
        return Some(Step::Turn(
            [0.0, 0.0, 0.0, 1.0].map(|entry| written(exactly(entry), place)),
        ));
    } else {
        [exactly(1.0), Double::ZERO, Double::ZERO, Double::ZERO]
    };
    Some(Step::Turn(entries.map(|entry| written(entry, place))))
}

/// The rotation whose x is along the first, and whose y is along the second as far as that is across it.
fn of_axes(x: Vector, y: Vector, place: Place) -> Option<Step> {
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
    let rotation: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    let entries = spatial::quaternion(&rotation);
    Some(Step::Turn(entries.map(|entry| written(entry, place))))
}

//! `<pose>`: reads placements, and places each frame in the one that its pose names.

use super::element::Element;
use super::frames::{Role, SdfFrame, WORLD_FRAME};
use super::index::{FrameIndex, ScopeIndex};
use super::reading::Sdf;
use crate::description::spatial::{inverse, to_number};
use crate::description::{Axis, Number, Step};
use crate::expression::Double;
use crate::wording::quoted;

/// Maximum number of steps of all poses of frames in each other, which bounds time and memory.
const MOST_STEPS: usize = 1_000_000;

impl<'a> Sdf<'a> {
    /// Places each frame in the one that its pose names.
    pub(super) fn resolve(&mut self) {
        let count = self.frames.all.len();
        for frame in (1..count).map(FrameIndex) {
            if self.frames.get(frame).role != Role::Model {
                self.attach(frame);
                self.place_frame(frame);
            }
        }
        for frame in (1..count).map(FrameIndex) {
            if self.frames.get(frame).role == Role::Model {
                self.place_frame(frame);
            }
        }
        self.frames.hold();
        self.measure_depths();
        for frame in (1..count).map(FrameIndex) {
            if self.frames.get(frame).role == Role::Model {
                self.shift_model(frame);
            }
        }
    }

    /// Finds the frame that a named frame is attached to.
    fn attach(&mut self, frame: FrameIndex) {
        let SdfFrame {
            role,
            scope,
            element,
            ..
        } = *self.frames.get(frame);
        let Some(element) = element.filter(|_| role == Role::Named) else {
            return;
        };
        let model = self.scopes[scope.0].model;
        let written = self.word(element, "attached_to");
        let to = written.and_then(|name| self.lookup(scope, &name));
        let to = to.unwrap_or(model);
        let own = self.frames.get_mut(frame);
        own.attached = to;
        own.parent = to;
    }

    /// The pose of one frame in another, within a bound on the length of all of them.
    pub(super) fn between(&mut self, from: FrameIndex, to: FrameIndex) -> Vec<Step> {
        if self.frames.steps > MOST_STEPS {
            return Vec::new();
        }
        let steps = self.frames.between(from, to);
        self.frames.steps += steps.len();
        if self.frames.steps > MOST_STEPS {
            let name = self.frames.get(to).name.clone();
            let message = "frames are placed in each other too often".to_owned();
            let hint = "place links in their parents, or in the model";
            self.reader.errors.push_with_hint(name.place, message, hint);
        }
        steps
    }

    /// Reads the pose of a frame.
    fn place_frame(&mut self, frame: FrameIndex) {
        let SdfFrame { scope, element, .. } = *self.frames.get(frame);
        let Some(pose) = element.and_then(|element| element.first("pose")) else {
            return;
        };
        let subject = quoted(&self.frames.get(frame).name.text);
        let steps = self.pose(pose, &subject);
        let name = self.word(pose, "relative_to");
        // A model cannot be placed in itself: names of its pose are those around it.
        let to = name.and_then(|name| self.lookup(scope, &name));
        let own = self.frames.get_mut(frame);
        own.steps = steps;
        own.parent = to.unwrap_or(own.parent);
    }

    /// Counts the frames between each one and the world; a circle is an error and opened.
    fn measure_depths(&mut self) {
        let world = WORLD_FRAME;
        let mut is_known = vec![false; self.frames.all.len()];
        is_known[world.0] = true;
        for start in 0..self.frames.all.len() {
            let mut path = Vec::new();
            let mut at = FrameIndex(start);
            while !is_known[at.0] {
                is_known[at.0] = true;
                path.push(at);
                at = self.frames.get(at).parent;
            }
            // A frame of this path has no depth yet.
            if path.contains(&at) {
                let name = self.frames.get(at).name.clone();
                let message = format!("the pose of {} is relative to itself", quoted(&name.text));
                let hint = "place one of the frames in this circle relative to __model__";
                self.reader.errors.push_with_hint(name.place, message, hint);
                self.frames.get_mut(at).parent = world;
            }
            let mut depth = self.frames.get(at).depth;
            if let Some(first) = path.iter().position(|frame| *frame == at) {
                // Frames beyond the opened one are placed in it.
                path.rotate_left(first + 1);
                depth = 0;
            }
            for frame in path.into_iter().rev() {
                depth += 1;
                self.frames.get_mut(frame).depth = depth;
            }
        }
    }

    /// Moves a model so that its placement frame, not its own, has the written pose.
    fn shift_model(&mut self, frame: FrameIndex) {
        let Some(placement) = self.scopes.iter().position(|scope| scope.model == frame) else {
            return;
        };
        let Some(name) = self.frames.placements.remove(&frame) else {
            return;
        };
        let Some(inner) = self.lookup(ScopeIndex(placement), &name) else {
            return;
        };
        let steps = inverse(&self.between(frame, inner));
        self.frames.get_mut(frame).steps.extend(steps);
    }

    /// The placement in a `<pose>`.
    pub(super) fn pose(&mut self, pose: Element<'a>, subject: &str) -> Vec<Step> {
        let subject = format!("the pose of {subject}");
        let format = self.word(pose, "rotation_format");
        let is_quaternion = match format.as_ref().map(|word| word.text.as_str()) {
            None | Some("euler_rpy") => false,
            Some("quat_xyzw") => true,
            Some(other) => {
                let message = format!("{subject} has the rotation_format {}", quoted(other));
                self.refuse(pose, message, "write euler_rpy or quat_xyzw");
                return Vec::new();
            }
        };
        if self.at(pose).text_of(pose.node).text.is_empty() {
            return Vec::new();
        }
        let count = if is_quaternion { 7 } else { 6 };
        let numbers = self
            .at(pose)
            .numbers_in_text(pose.node, count..=count, &subject);
        let degrees = self.word(pose, "degrees");
        let is_in_degrees = degrees.is_some_and(|word| word.text == "true" || word.text == "1");
        let angle = |angle: Number| {
            if is_in_degrees {
                let radians = angle.exact() * Double::PI / Double::from(180.0);
                to_number(radians, angle.place)
            } else {
                angle
            }
        };
        let mut steps = Vec::new();
        let Some((position, rotation)) = numbers.as_deref().and_then(<[Number]>::split_first_chunk)
        else {
            return steps;
        };
        let is_zero = |number: &Number| number.value == 0.0;
        if !position.iter().all(is_zero) {
            steps.push(Step::Translate(*position));
        }
        match *rotation {
            [roll, pitch, yaw] => {
                let turns = [(Axis::Z, yaw), (Axis::Y, pitch), (Axis::X, roll)];
                let turns = turns.into_iter().filter(|(_, turn)| !is_zero(turn));
                steps.extend(turns.map(|(axis, turn)| Step::Rotate(axis, angle(turn))));
            }
            [x, y, z, w] if ![x, y, z, w].iter().all(is_zero) => {
                if ![x, y, z].iter().all(is_zero) {
                    steps.push(Step::Quaternion([x, y, z, w]));
                }
            }
            _ => self.refuse(
                pose,
                format!("{subject} has a quaternion of zeros"),
                "write 0 0 0 1 for no rotation",
            ),
        }
        steps
    }
}

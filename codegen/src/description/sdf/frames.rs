//! Frames of links, joints, models and named frames, and their poses in each other.
//!
//! Each frame is placed in another one; the world is the outermost. The pose of one frame in another is the product of
//! the written placements between them, without those that both share, so that digits are kept.

use std::collections::HashMap;

use super::element::Element;
use super::index::{FrameIndex, ScopeIndex};
use super::scope::{BETWEEN, MODEL};
use crate::description::spatial::inverse;
use crate::description::{LinkId, Name, Number, Step};

/// Kind of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    World,
    Model,
    /// The frame of the link with this number.
    Link(LinkId),
    Joint,
    Named,
}

/// A frame.
pub(super) struct SdfFrame<'a> {
    pub(super) role: Role,
    /// The name with those of the models around it.
    pub(super) name: Name,
    /// The scope in which the names of its pose are looked up.
    pub(super) scope: ScopeIndex,
    /// The element with its pose, and the element that overrides it.
    pub(super) element: Option<Element<'a>>,
    /// The frame that it is placed in.
    pub(super) parent: FrameIndex,
    /// From the parent frame to this one.
    pub(super) steps: Vec<Step>,
    /// The frame that it is attached to; itself for a link and the world.
    pub(super) attached: FrameIndex,
    /// The number of frames between it and the world.
    pub(super) depth: usize,
}

/// The frame of the world.
pub(super) const WORLD_FRAME: FrameIndex = FrameIndex(0);

/// All frames; the first is the world.
#[derive(Default)]
pub(super) struct Frames<'a> {
    pub(super) all: Vec<SdfFrame<'a>>,
    /// The names of the frames that the poses of models place, by the models' own frames.
    pub(super) placements: HashMap<FrameIndex, Name>,
    /// The number of the link that each frame is attached to.
    holders: Vec<Option<LinkId>>,
    /// The number of steps of all poses that were asked for.
    pub(super) steps: usize,
}

impl<'a> Frames<'a> {
    pub(super) fn push(&mut self, frame: SdfFrame<'a>) -> FrameIndex {
        self.all.push(frame);
        FrameIndex(self.all.len() - 1)
    }

    pub(super) fn get(&self, frame: FrameIndex) -> &SdfFrame<'a> {
        &self.all[frame.0]
    }

    pub(super) fn get_mut(&mut self, frame: FrameIndex) -> &mut SdfFrame<'a> {
        &mut self.all[frame.0]
    }

    /// The pose of one frame in another.
    pub(super) fn between(&self, from: FrameIndex, to: FrameIndex) -> Vec<Step> {
        let (mut a, mut b) = (from, to);
        let (mut up, mut down) = (Vec::new(), Vec::new());
        while a != b {
            let (first, second) = (self.get(a), self.get(b));
            if first.depth >= second.depth {
                up.push(first);
                a = first.parent;
            }
            if second.depth >= first.depth && second.depth > 0 && a != b {
                down.push(second);
                b = second.parent;
            }
        }
        let above = up
            .iter()
            .rev()
            .flat_map(|frame| frame.steps.iter().copied());
        let mut steps = inverse(&above.collect::<Vec<_>>());
        let below = down.iter().rev();
        steps.extend(below.flat_map(|frame| frame.steps.iter().copied()));
        steps
    }

    /// The number of the link that a frame is attached to; `None` for the world, and for a circle.
    pub(super) fn link_of(&self, frame: FrameIndex) -> Option<LinkId> {
        self.holders.get(frame.0).copied().flatten()
    }

    /// Finds the links that all frames are attached to.
    pub(super) fn hold(&mut self) {
        let mut holders = vec![None; self.all.len()];
        let mut is_known = vec![false; self.all.len()];
        for start in 0..self.all.len() {
            let mut path = Vec::new();
            let mut at = start;
            let mut link = None;
            while !is_known[at] {
                is_known[at] = true;
                path.push(at);
                let frame = &self.all[at];
                match frame.role {
                    Role::Link(own) => link = Some(own),
                    Role::World => {}
                    Role::Model | Role::Joint | Role::Named => {
                        at = frame.attached.0;
                        link = holders[at];
                    }
                }
            }
            for frame in path {
                holders[frame] = link;
            }
        }
        self.holders = holders;
    }
}

/// True if some steps are no motion.
pub(super) fn is_nothing(steps: &[Step]) -> bool {
    let is_zero = |number: &Number| number.value == 0.0;
    steps.iter().all(|step| match step {
        Step::Translate(offset) => offset.iter().all(is_zero),
        Step::Rotate(_, angle) => is_zero(angle),
        Step::Quaternion([x, y, z, _]) => [x, y, z].into_iter().all(is_zero),
    })
}

/// The name of the frame of a model.
pub(super) fn name_of_model(name: &Name) -> Name {
    Name {
        text: format!("{}{}{MODEL}", name.text, BETWEEN),
        place: name.place,
    }
}

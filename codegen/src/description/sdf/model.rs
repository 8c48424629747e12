//! `<model>`, `<include>` and `<world>`: declares links, joints, frames and nested models.

use std::collections::HashMap;

use super::element::Element;
use super::frames::{Role, SdfFrame, name_of_model};
use super::index::{FrameIndex, ScopeIndex};
use super::reading::{PendingJoint, Sdf};
use super::scope::{BETWEEN, Scope, WORLD};
use crate::description::{Name, Number};
use crate::wording::{list, quoted};

/// Maximum nesting depth of models.
const DEEPEST: usize = 100;

/// Maximum number of frames, because a few characters can include without bound.
const MOST_FRAMES: usize = 100_000;

/// The robot of a file.
pub(super) struct Top {
    pub(super) name: Name,
    pub(super) gravity: Option<[Number; 3]>,
}

/// A model to declare, with what an `<include>` overrides.
#[derive(Clone, Copy)]
struct Declared<'a> {
    model: Element<'a>,
    /// The element that includes it.
    include: Option<Element<'a>>,
}

impl<'a> Declared<'a> {
    /// The elements that may have a setting, the one that overrides the other first.
    fn elements(self) -> impl Iterator<Item = Element<'a>> {
        self.include.into_iter().chain([self.model])
    }
}

impl<'a> Sdf<'a> {
    /// Declares the robot of a file: its only model, or the only movable one of its world.
    pub(super) fn top(&mut self, root: Element<'a>) -> Option<Top> {
        self.check_version(root);
        let world = root.first(WORLD);
        let gravity = world.and_then(|world| self.gravity(world));
        let places = [Some(root), world].into_iter().flatten();
        let mut models = Vec::new();
        for place in places {
            for child in place.children() {
                models.extend(self.declared(child));
            }
        }
        let (still, mut movable): (Vec<_>, Vec<_>) = models
            .into_iter()
            .partition(|declared| self.is_static(*declared));
        if movable.is_empty() && still.len() == 1 {
            movable.clone_from(&still);
        } else if let Some(first) = still.first() {
            let count = still.len();
            let models = if count == 1 { "model" } else { "models" };
            let message = format!("{count} static {models} of the world ignored");
            self.warn(first.model, message, "only the movable model is read");
        }
        let [declared] = movable[..] else {
            let names: Vec<String> = movable
                .iter()
                .filter_map(|declared| {
                    declared
                        .elements()
                        .find_map(|one| one.node.attribute("name"))
                })
                .map(quoted)
                .collect();
            let message = match movable.len() {
                0 => "the file has no <model>".to_owned(),
                count => format!(
                    "the file has {count} movable models, {}, and a robot is one",
                    list(names.iter().map(String::as_str))
                ),
            };
            let hint =
                "write one <model>; several parts are models in a model, with joints between them";
            self.refuse(root, message, hint);
            return None;
        };
        let name = self.model_name(declared)?;
        let world = SdfFrame {
            role: Role::World,
            name: Name::from(WORLD),
            scope: ScopeIndex(0),
            element: None,
            parent: FrameIndex(0),
            steps: Vec::new(),
            attached: FrameIndex(0),
            depth: 0,
        };
        let world = self.frames.push(world);
        self.scopes.push(Scope {
            model: world,
            prefix: String::new(),
            names: HashMap::new(),
            models: HashMap::new(),
            merged: None,
        });
        self.model(declared, &name, ScopeIndex(0), true, 0);
        Some(Top { name, gravity })
    }

    fn check_version(&mut self, root: Element<'a>) {
        let version = self.word(root, "version");
        let Some(version) = version else {
            self.warn(
                root,
                "the file has no version, and is read as 1.12".to_owned(),
                "write <sdf version=\"…\">",
            );
            return;
        };
        let is_known = minor(&version.text).is_some_and(|minor| (4..=12).contains(&minor));
        if !is_known {
            let message = format!(
                "the file has the version {}, and is read as one of 1.4 to 1.12",
                quoted(&version.text)
            );
            self.reader.warn(version.place, message, None);
        }
    }

    /// True if axes of a file are in the frame of the model, as in version 1.4.
    pub(super) fn has_axes_of_model(element: Element<'a>) -> bool {
        let root = Element::root(element.files(), element.file);
        let version = root
            .node
            .attribute("version")
            .and_then(|version| minor(version.trim()));
        version.is_some_and(|minor| minor <= 4)
    }

    /// The gravity of a world.
    fn gravity(&mut self, world: Element<'a>) -> Option<[Number; 3]> {
        let gravity = world.first("gravity")?;
        let subject = "the gravity of the world";
        let numbers = self
            .at(gravity)
            .numbers_in_text(gravity.node, 3..=3, subject)?;
        numbers.try_into().ok()
    }

    /// The model that an element is or includes.
    fn declared(&mut self, element: Element<'a>) -> Option<Declared<'a>> {
        match element.tag() {
            "model" => Some(Declared {
                model: element,
                include: None,
            }),
            "include" => {
                let root = element.included()?;
                let Some(model) = root.first("model") else {
                    let message = "the included file has no <model>".to_owned();
                    self.refuse(element, message, "include the file of a model");
                    return None;
                };
                Some(Declared {
                    model,
                    include: Some(element),
                })
            }
            _ => None,
        }
    }

    fn is_static(&mut self, declared: Declared<'a>) -> bool {
        let written = declared
            .elements()
            .find(|one| one.first("static").is_some());
        written.is_some_and(|one| self.flag(one, "static", "the model"))
    }

    /// The name of a model: that of its include, or its own.
    fn model_name(&mut self, declared: Declared<'a>) -> Option<Name> {
        let by_include = declared
            .include
            .and_then(|include| self.text(include, "name"));
        by_include.or_else(|| self.name(declared.model, "a model"))
    }

    /// Declares a model with everything in it.
    fn model(
        &mut self,
        declared: Declared<'a>,
        name: &Name,
        outer: ScopeIndex,
        is_top: bool,
        depth: usize,
    ) {
        let Declared { model, include } = declared;
        let is_merged = include.is_some_and(|include| {
            include
                .node
                .attribute("merge")
                .is_some_and(|merge| merge == "true" || merge == "1")
        });
        if depth == DEEPEST || self.frames.all.len() > MOST_FRAMES {
            let message = format!(
                "there are more than {DEEPEST} models in each other, or {MOST_FRAMES} frames"
            );
            self.refuse(include.unwrap_or(model), message, "nest or include less");
            return;
        }
        if self.open.contains(&model.file) && include.is_some() {
            let message = format!("the model {} includes itself", quoted(&name.text));
            self.refuse(include.unwrap_or(model), message, "leave the <include> out");
            return;
        }
        let around = self.scopes[outer.0].model;
        let frame = self.frames.push(SdfFrame {
            role: Role::Model,
            name: name_of_model(name),
            scope: outer,
            element: declared.elements().find(|one| one.first("pose").is_some()),
            parent: around,
            steps: Vec::new(),
            attached: around,
            depth: 0,
        });
        let outer_prefix = self.scopes[self.owner(outer).0].prefix.clone();
        let scope = ScopeIndex(self.scopes.len());
        self.scopes.push(Scope {
            model: frame,
            prefix: if is_top {
                String::new()
            } else {
                format!("{outer_prefix}{}{BETWEEN}", name.text)
            },
            names: HashMap::new(),
            models: HashMap::new(),
            merged: is_merged.then_some(outer),
        });
        if !is_top && !is_merged {
            self.declare(outer, name, frame);
            let owner = self.owner(outer);
            self.scopes[owner.0].models.insert(name.text.clone(), scope);
        }
        self.placement(declared, frame);
        self.open.push(model.file);
        for child in model.children() {
            match child.tag() {
                "link" => self.link(child, scope, frame),
                "joint" => self.declare_joint(child, scope, frame),
                "frame" => self.declare_frame(child, scope, frame),
                "model" | "include" => {
                    let Some(inner) = self.declared(child) else {
                        continue;
                    };
                    if let Some(name) = self.model_name(inner) {
                        self.model(inner, &name, scope, false, depth + 1);
                    }
                }
                _ => {}
            }
        }
        self.open.pop();
        self.canonical(model, scope, frame);
    }

    /// Notes the frame of a model that its pose places.
    fn placement(&mut self, declared: Declared<'a>, frame: FrameIndex) {
        let by_include = declared
            .include
            .and_then(|include| self.text(include, "placement_frame"));
        let own = self.word(declared.model, "placement_frame");
        let name = by_include.or(own);
        if let Some(name) = name {
            self.frames.placements.insert(frame, name);
        }
    }

    /// Attaches a model's frame to its canonical link: the named one, or the first.
    fn canonical(&mut self, model: Element<'a>, scope: ScopeIndex, frame: FrameIndex) {
        let named = self.word(model, "canonical_link");
        let named = named.and_then(|name| self.lookup(scope, &name));
        let owner = self.owner(scope);
        let inner = (frame.0 + 1..self.frames.all.len()).map(FrameIndex);
        let mut links = inner.filter(|inner| matches!(self.frames.get(*inner).role, Role::Link(_)));
        let first = links.clone().next();
        let own = links.find(|link| self.owner(self.frames.get(*link).scope) == owner);
        let canonical = named.or(own).or(first);
        let own = self.frames.get_mut(frame);
        own.attached = canonical.unwrap_or(own.attached);
    }

    fn declare_joint(&mut self, element: Element<'a>, scope: ScopeIndex, model: FrameIndex) {
        let Some(name) = self.name(element, "a joint") else {
            return;
        };
        let frame = self.named_frame(element, &name, scope, model, Role::Joint);
        self.pending.push(PendingJoint {
            element,
            scope,
            frame,
        });
    }

    fn declare_frame(&mut self, element: Element<'a>, scope: ScopeIndex, model: FrameIndex) {
        if let Some(name) = self.name(element, "a frame") {
            self.named_frame(element, &name, scope, model, Role::Named);
        }
    }

    /// Declares a frame with a name.
    pub(super) fn named_frame(
        &mut self,
        element: Element<'a>,
        name: &Name,
        scope: ScopeIndex,
        model: FrameIndex,
        role: Role,
    ) -> FrameIndex {
        let owner = self.owner(scope);
        let full = format!("{}{}", self.scopes[owner.0].prefix, name.text);
        match role {
            Role::Joint => self.joint_names.take(&full),
            Role::Link(_) | Role::Named => self.link_names.take(&full),
            Role::World | Role::Model => {}
        }
        let frame = self.frames.push(SdfFrame {
            role,
            name: Name {
                text: full,
                place: name.place,
            },
            scope,
            element: Some(element),
            parent: model,
            steps: Vec::new(),
            attached: model,
            depth: 0,
        });
        self.declare(scope, name, frame);
        frame
    }
}

/// The second number of a version 1.x.
fn minor(version: &str) -> Option<u32> {
    let minor = version.strip_prefix("1.")?;
    minor.split('.').next()?.parse().ok()
}

//! Expands the tree of bodies of a model to a list of elements.
//!
//! A `<frame>` becomes part of the placements of the elements inside. The elements inside a `<replicate>` are listed
//! once for each copy.

use super::element::Element;
use super::parts::{Affix, Item, ModelId, PartId, Parts, Scope, Span, SpanKind};
use super::reading::Mjcf;
use crate::description::Step;
use crate::description::spatial::{Pose, exactly, plus, to_number};
use crate::expression::Double;
use crate::list::Id;

/// Maximum nesting depth of frames.
const DEEPEST: usize = 100;

/// Maximum number of copies and attachments, because a few characters can replicate without bound.
const MOST_COPIES: usize = 100_000;

/// [`MOST_COPIES`] for one element.
const MOST_COPIES_OF_ONE: u32 = 100_000;

/// Maximum number of elements in all trees of bodies.
const MOST_PARTS: usize = 1_000_000;

/// The elements that are listed.
const LISTED: [&str; 6] = ["body", "joint", "freejoint", "inertial", "geom", "site"];

/// An element whose children are being listed.
struct Open<'a> {
    /// The children that are left, the next one last.
    children: Vec<Element<'a>>,
    /// Their surroundings.
    inside: Item<'a>,
    within: PartId,
    /// The number of frames and copies since the body.
    depth: usize,
    span: Option<usize>,
}

impl<'a> Mjcf<'a> {
    /// Lists the tree of bodies of a model. The models that it attaches are listed already.
    pub(super) fn expand(&mut self, model: ModelId) -> Parts<'a> {
        let root = self.model().root;
        let world = Item {
            element: root,
            model,
            frame: Vec::new(),
            class: self.model().defaults.main(),
            affix: Affix::default(),
        };
        let mut parts = Parts::default();
        parts.scopes.push(Scope {
            model,
            affix: Affix::default(),
            attached: Some((0..usize::MAX, 0)),
        });
        let within = parts.push(world.clone(), PartId::new(0));
        let mut waiting = Vec::new();
        for section in root.named("worldbody").into_iter().rev() {
            waiting.push(self.open(section, world.clone(), within, 0, None));
        }
        while let Some(open) = waiting.last_mut() {
            let Some(element) = open.children.pop() else {
                if let Some(span) = open.span {
                    parts.close(span);
                }
                waiting.pop();
                continue;
            };
            let item = Item {
                element,
                ..open.inside.clone()
            };
            let (within, depth) = (open.within, open.depth);
            if self.parts + parts.list.len() > MOST_PARTS || self.copies > MOST_COPIES {
                let message = format!(
                    "there are more than {MOST_COPIES} copies and attachments, or {MOST_PARTS} elements in bodies"
                );
                self.refuse(element, message, "attach or replicate less");
                break;
            }
            match element.tag() {
                "frame" | "replicate" if depth == DEEPEST => {
                    let message = format!("frames are nested more than {DEEPEST} deep");
                    self.refuse(element, message, "combine them into one");
                }
                "frame" => {
                    let span = self.span(SpanKind::Frame, &item, &parts, within);
                    let span = parts.open(span);
                    let attributes = self.attributes(&item, "");
                    let steps = self.placement(&attributes, "a <frame>");
                    let mut inside = item;
                    inside.frame.extend(steps);
                    waiting.push(self.open(element, inside, within, depth + 1, Some(span)));
                }
                "replicate" => {
                    let mut copies = self.copies(&item);
                    for copy in &copies {
                        parts.scopes.push(Scope {
                            model,
                            affix: copy.affix.clone(),
                            attached: None,
                        });
                    }
                    copies.reverse();
                    for inside in copies {
                        waiting.push(self.open(element, inside, within, depth + 1, None));
                    }
                }
                "attach" => self.attach(&item, within, &mut parts),
                "body" => {
                    let span = self.span(SpanKind::Body, &item, &parts, within);
                    let span = parts.open(span);
                    let body = parts.push(item.clone(), within);
                    let inside = Item {
                        frame: Vec::new(),
                        ..item
                    };
                    waiting.push(self.open(element, inside, body, 0, Some(span)));
                }
                // Without bodies of its own, it is a shape for contacts.
                "flexcomp" if self.flag(element.attribute("rigid"), false, "a <flexcomp>") => {}
                tag @ ("composite" | "flexcomp") => {
                    let message = format!("the bodies of a <{tag}> are not read");
                    let hint =
                        "save the model by MuJoCo, which writes its bodies, and read that file";
                    self.refuse(element, message, hint);
                }
                tag if LISTED.contains(&tag) => {
                    parts.push(item, within);
                }
                _ => {}
            }
        }
        self.parts += parts.list.len();
        parts
    }

    /// An element whose children come next.
    fn open(
        &mut self,
        element: Element<'a>,
        mut inside: Item<'a>,
        within: PartId,
        depth: usize,
        span: Option<usize>,
    ) -> Open<'a> {
        if let Some(class) = self.class(element.attribute("childclass")) {
            inside.class = class;
        }
        let mut children = element.children();
        children.reverse();
        Open {
            children,
            inside,
            within,
            depth,
            span,
        }
    }

    /// The range of a body or a frame that begins here.
    fn span(&mut self, kind: SpanKind, item: &Item<'a>, parts: &Parts<'a>, within: PartId) -> Span {
        let name = item.element.attribute("name");
        let name = name.map_or_else(String::new, |name| self.word(name).text);
        Span {
            kind,
            name: item.affix.name(&name),
            parts: parts.list.len()..usize::MAX,
            within,
            steps: item.frame.len(),
        }
    }

    /// The surroundings of each copy that a `<replicate>` makes.
    fn copies(&mut self, item: &Item<'a>) -> Vec<Item<'a>> {
        const SUBJECT: &str = "a <replicate>";
        let element = item.element;
        let Some(count) = self.number(element.attribute("count"), SUBJECT) else {
            self.refuse(
                element,
                format!("{SUBJECT} has no count"),
                "write count=\"…\"",
            );
            return Vec::new();
        };
        let count = count.value;
        let is_whole = |copies: &u32| f64::from(*copies).to_bits() == count.to_bits();
        let Some(copies) = (0..=MOST_COPIES_OF_ONE).find(is_whole) else {
            let message = format!("count of {SUBJECT} is {count}");
            let hint = format!("write a whole number up to {MOST_COPIES_OF_ONE}");
            self.refuse(element, message, &hint);
            return Vec::new();
        };
        let offset = self.numbers::<3>(element.attribute("offset"), SUBJECT);
        let offset = offset.map(|offset| offset.map(|entry| entry.exact()));
        let euler = self.numbers::<3>(element.attribute("euler"), SUBJECT);
        let separator = element
            .attribute("sep")
            .map(|written| self.word(written).text);
        let separator = separator.as_deref().unwrap_or_default();
        let place = self.place(element);
        let digits = copies.to_string().len();
        let mut position = [Double::ZERO; 3];
        let mut found = Vec::new();
        for copy in 0..copies {
            self.copies += 1;
            if self.copies > MOST_COPIES {
                break;
            }
            let rotations = euler.map_or_else(Vec::new, |euler| {
                let many = exactly(f64::from(copy));
                self.euler(euler.map(|angle| to_number(angle.exact() * many, angle.place)))
            });
            let mut inside = item.clone();
            let offset_of_copy = position.map(|entry| to_number(entry, place));
            inside.frame.push(Step::Translate(offset_of_copy));
            inside.frame.extend(&rotations);
            if let Some(offset) = offset {
                position = plus(position, Pose::of(&rotations).direction(offset));
            }
            let suffix = format!("{separator}{copy:0digits$}{}", item.affix.suffix);
            inside.affix.suffix = suffix;
            found.push(inside);
        }
        found
    }
}

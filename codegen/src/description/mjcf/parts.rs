//! The tree of bodies of a model as a list: frames, copies and attached models are resolved to elements with
//! placements and names.
//!
//! A body comes before the elements inside it, and they come before whatever follows the body. So a body with its
//! subtree, and a frame with its elements, is a range of the list, which can be attached elsewhere.

use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

use super::class::Class;
use super::element::Element;
use crate::description::Step;
use crate::list::{Id, List, id};

id! {
    /// The number of a model. A model comes before the models that it attaches.
    ModelId
}

id! {
    /// The number of an element in the tree of bodies.
    PartId
}

/// The name of the fixed link.
pub(super) const WORLD: &str = "world";

/// Prefix and suffix that attachments and copies add to the names of elements.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Affix {
    pub(super) prefix: String,
    pub(super) suffix: String,
}

impl Affix {
    /// A name of the file as a name of the robot.
    pub(super) fn name(&self, written: &str) -> String {
        match written {
            "" | WORLD => written.to_owned(),
            _ => [&self.prefix, written, &self.suffix].concat(),
        }
    }

    /// The same within another one.
    pub(super) fn within(&self, outer: &Self) -> Self {
        Self {
            prefix: [&*outer.prefix, &self.prefix].concat(),
            suffix: [&*self.suffix, &outer.suffix].concat(),
        }
    }
}

/// An element of the tree of bodies, with its surroundings.
#[derive(Clone)]
pub(super) struct Item<'a> {
    pub(super) element: Element<'a>,
    /// The model whose settings, defaults and assets count for the element.
    pub(super) model: ModelId,
    /// The placement of the frames between the body and the element.
    pub(super) frame: Vec<Step>,
    pub(super) class: Rc<Class<'a>>,
    pub(super) affix: Affix,
}

/// An element in the list.
#[derive(Clone)]
pub(super) struct Part<'a> {
    pub(super) item: Item<'a>,
    /// The body that contains it.
    pub(super) within: PartId,
}

/// The type of elements that can be attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum SpanKind {
    Body,
    Frame,
}

/// A body with its subtree, a frame with its elements, or the contents of the world.
#[derive(Clone)]
pub(super) struct Span {
    pub(super) kind: SpanKind,
    /// Its name; empty if it has none.
    pub(super) name: String,
    pub(super) parts: Range<usize>,
    /// The body that contains it.
    pub(super) within: PartId,
    /// The number of steps of the placement around it.
    pub(super) steps: usize,
}

/// The elements outside the tree of bodies that refer to names in it, once more for each attachment and copy.
#[derive(Clone)]
pub(super) struct Scope {
    /// The model of these elements.
    pub(super) model: ModelId,
    pub(super) affix: Affix,
    /// The attached elements, by their numbers in the list of their own model, and the number of the first one here;
    /// `None` for a copy within the model.
    pub(super) attached: Option<(Range<usize>, usize)>,
}

/// The list.
#[derive(Clone, Default)]
pub(super) struct Parts<'a> {
    pub(super) list: List<PartId, Part<'a>>,
    /// In the order of their beginnings; outer ones come before inner ones.
    pub(super) spans: Vec<Span>,
    named: HashMap<(SpanKind, String), usize>,
    pub(super) scopes: Vec<Scope>,
}

/// Elements that are to be attached.
pub(super) struct Taken<'a> {
    span: Span,
    parts: Vec<Part<'a>>,
    spans: Vec<Span>,
    scopes: Vec<Scope>,
}

impl<'a> Parts<'a> {
    /// Adds an element; returns its number.
    pub(super) fn push(&mut self, item: Item<'a>, within: PartId) -> PartId {
        self.list.push(Part { item, within })
    }

    /// Opens a body or a frame that begins here; returns its number for [`close`](Self::close).
    pub(super) fn open(&mut self, span: Span) -> usize {
        if !span.name.is_empty() {
            let key = (span.kind, span.name.clone());
            self.named.entry(key).or_insert(self.spans.len());
        }
        self.spans.push(span);
        self.spans.len() - 1
    }

    /// Ends a body or a frame here.
    pub(super) fn close(&mut self, span: usize) {
        self.spans[span].parts.end = self.list.len();
    }

    /// The body or frame with a name, with its elements so far.
    pub(super) fn take(&self, kind: SpanKind, name: &str) -> Option<Taken<'a>> {
        let number = *self.named.get(&(kind, name.to_owned()))?;
        let mut span = self.spans[number].clone();
        span.parts.end = span.parts.end.min(self.list.len());
        Some(self.taken(span, number))
    }

    /// The contents of the world.
    pub(super) fn take_all(&self) -> Taken<'a> {
        let span = Span {
            kind: SpanKind::Frame,
            name: String::new(),
            parts: 1..self.list.len(),
            within: PartId::new(0),
            steps: 0,
        };
        self.taken(span, 0)
    }

    fn taken(&self, span: Span, first: usize) -> Taken<'a> {
        let Range { start, end } = span.parts;
        let inner = self.spans[first..].iter();
        let inner = inner.take_while(|inner| inner.parts.start < end);
        let scopes = self.scopes.iter().filter_map(|scope| {
            let (from, at) = scope.attached.clone()?;
            let (low, high) = (start.max(at), end.min(at + from.len()));
            let from = from.start + low.checked_sub(at)?..from.start + high.checked_sub(at)?;
            (!from.is_empty()).then(|| Scope {
                attached: Some((from, low - start)),
                ..scope.clone()
            })
        });
        let copies = self.scopes.iter().filter(|scope| scope.attached.is_none());
        let list: &[Part<'a>] = &self.list;
        Taken {
            parts: list[start..end].to_vec(),
            spans: inner
                .filter(|inner| inner.parts.end <= end)
                .cloned()
                .collect(),
            scopes: scopes.chain(copies.cloned()).collect(),
            span,
        }
    }

    /// The names of all bodies or frames, in alphabetical order.
    pub(super) fn names(&self, kind: SpanKind) -> Vec<String> {
        let names = self.named.keys().filter(|(other, _)| *other == kind);
        let mut names: Vec<String> = names.map(|(_, name)| name.clone()).collect();
        names.sort_unstable();
        names
    }

    /// Adds elements at a place: with `around.frame` as the placement, and `around.affix` for names. Returns the number
    /// of scopes among them.
    pub(super) fn put(&mut self, taken: Taken<'a>, around: &Item<'a>, within: PartId) -> usize {
        let Taken {
            span,
            parts,
            spans,
            scopes,
        } = taken;
        let base = self.list.len();
        let moved = |part: PartId| {
            if part == span.within {
                within
            } else {
                PartId::new(part.index() - span.parts.start + base)
            }
        };
        for part in parts {
            let mut item = part.item;
            if part.within == span.within {
                let own = item.frame.split_off(span.steps);
                item.frame = [&*around.frame, &own].concat();
            }
            item.affix = item.affix.within(&around.affix);
            self.push(item, moved(part.within));
        }
        for inner in spans {
            let steps = if inner.within == span.within {
                around.frame.len() + inner.steps - span.steps
            } else {
                inner.steps
            };
            let Range { start, end } = inner.parts;
            self.open(Span {
                name: around.affix.name(&inner.name),
                parts: start - span.parts.start + base..end - span.parts.start + base,
                within: moved(inner.within),
                steps,
                kind: inner.kind,
            });
        }
        let count = scopes.len();
        self.scopes.extend(scopes.into_iter().map(|scope| Scope {
            affix: scope.affix.within(&around.affix),
            attached: scope.attached.map(|(from, at)| (from, at + base)),
            ..scope
        }));
        count
    }
}

impl Taken<'_> {
    /// Leaves the keyframes out: those of a copy within a model have no values of their own.
    pub(super) fn forget_keyframes(&mut self) {
        for scope in &mut self.scopes {
            scope.attached = None;
        }
    }
}

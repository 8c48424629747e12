//! `<body>`: reads the tree of bodies.
//!
//! Yields links, the joints between them, and a massless link for each site. A `<frame>` is merged into the placements
//! of the elements inside; the elements inside a `<replicate>` are read once for each copy.

use std::rc::Rc;

use super::element::Element;
use super::geom::Piece;
use super::joint::Moving;
use super::names::Names;
use super::reading::Mjcf;
use super::tree::{Item, WORLD};
use super::values::Attributes;
use crate::description::spatial::{Pose, exactly, plus, to_number};
use crate::description::{Joint, Link, Name, Step};
use crate::error::Place;
use crate::expression::Double;
use crate::wording::quoted;

/// Maximum nesting depth of frames.
const DEEPEST: usize = 100;

/// Maximum number of links, because a few characters can replicate without bound.
const MOST_LINKS: usize = 100_000;

/// Maximum number of copies of one element.
const MOST_COPIES: u32 = 100_000;

/// A body that is not read yet.
struct PendingBody<'a> {
    item: Item<'a>,
    parent: Name,
}

impl<'a> Mjcf<'a> {
    /// Reads all bodies.
    pub(super) fn read_tree(&mut self, root: Element<'a>) {
        self.tree.link_names = Names::of_elements(root, &["body"]);
        self.tree.joint_names = Names::of_elements(root, &["joint", "freejoint"]);
        self.tree.link_names.take(WORLD);
        let place = self.place(root);
        let world = Name {
            text: WORLD.to_owned(),
            place,
        };
        self.tree.links.push(Link {
            name: world.clone(),
            inertial: None,
        });
        let mut waiting = Vec::new();
        for section in root.named("worldbody") {
            let whole = Item {
                element: section,
                frame: Vec::new(),
                class: self.defaults.main(),
                suffix: String::new(),
            };
            let mut items = Vec::new();
            self.contents(&whole, 0, &mut items);
            for item in items {
                match item.element.tag() {
                    "body" => waiting.push(PendingBody {
                        item,
                        parent: world.clone(),
                    }),
                    "site" => self.site(&item, &world),
                    tag @ ("joint" | "freejoint" | "inertial") => {
                        let message = format!("the world has a <{tag}>");
                        self.refuse(item.element, message, "move it into a <body>");
                    }
                    _ => {}
                }
            }
        }
        waiting.reverse();
        while let Some(body) = waiting.pop() {
            if self.tree.links.len() > MOST_LINKS {
                break;
            }
            let mut children = self.body(body);
            children.reverse();
            waiting.append(&mut children);
        }
        if self.tree.links.len().max(self.tree.copies) > MOST_LINKS {
            let message = format!("there are more than {MOST_LINKS} bodies, sites or copies");
            self.refuse(root, message, "replicate less");
        }
    }

    /// The attributes of an item, with those of its class as defaults.
    pub(super) fn attributes(&mut self, item: &Item<'a>, kind: &'static str) -> Attributes<'a> {
        let class = self.class(item.element.attribute("class"));
        Attributes {
            own: item.element,
            kind,
            class: class.unwrap_or_else(|| Rc::clone(&item.class)),
        }
    }

    /// The name of an item, with the suffix of its copy; `None` if it has no name.
    pub(super) fn name_of(&mut self, item: &Item<'a>) -> Option<Name> {
        let mut name = self.word(item.element.attribute("name")?);
        if name.text.is_empty() {
            return None;
        }
        name.text.push_str(&item.suffix);
        Some(name)
    }

    /// Lists the elements of a body, a frame or the world in the order of the text, with frames and copies expanded.
    fn contents(&mut self, whole: &Item<'a>, depth: usize, items: &mut Vec<Item<'a>>) {
        let class = self.class(whole.element.attribute("childclass"));
        let class = class.unwrap_or_else(|| Rc::clone(&whole.class));
        for element in whole.element.children() {
            let item = Item {
                element,
                class: Rc::clone(&class),
                ..whole.clone()
            };
            let tag = element.tag();
            if !matches!(tag, "frame" | "replicate") {
                items.push(item);
                continue;
            }
            if depth == DEEPEST {
                let message = format!("frames are nested more than {DEEPEST} deep");
                self.refuse(element, message, "combine them into one");
                return;
            }
            if tag == "frame" {
                let attributes = self.attributes(&item, "");
                let steps = self.placement(&attributes, "a <frame>");
                let mut inner = item;
                inner.frame.extend(steps);
                self.contents(&inner, depth + 1, items);
            } else {
                self.copies(&item, depth, items);
            }
        }
    }

    /// Lists the copies that a `<replicate>` makes of the elements inside.
    fn copies(&mut self, item: &Item<'a>, depth: usize, items: &mut Vec<Item<'a>>) {
        const SUBJECT: &str = "a <replicate>";
        let element = item.element;
        let Some(count) = self.number(element.attribute("count"), SUBJECT) else {
            self.refuse(
                element,
                format!("{SUBJECT} has no count"),
                "write count=\"…\"",
            );
            return;
        };
        let count = count.value;
        let is_whole = |copies: &u32| f64::from(*copies).to_bits() == count.to_bits();
        let Some(copies) = (0..=MOST_COPIES).find(is_whole) else {
            let message = format!("count of {SUBJECT} is {count}");
            let hint = format!("write a whole number up to {MOST_COPIES}");
            self.refuse(element, message, &hint);
            return;
        };
        let offset = self.numbers::<3>(element.attribute("offset"), SUBJECT);
        let offset = offset.map(|offset| offset.map(|entry| entry.exact()));
        let euler = self.numbers::<3>(element.attribute("euler"), SUBJECT);
        let separator = element
            .attribute("sep")
            .map(|written| self.word(written).text);
        let place = self.place(element);
        let digits = copies.to_string().len();
        let mut position = [Double::ZERO; 3];
        for copy in 0..copies {
            self.tree.copies += 1;
            if self.tree.copies > MOST_LINKS {
                return;
            }
            let rotations = euler.map_or_else(Vec::new, |euler| {
                let many = exactly(f64::from(copy));
                self.euler(euler.map(|angle| to_number(angle.exact() * many, angle.place)))
            });
            let mut inner = item.clone();
            let offset_of_copy = position.map(|entry| to_number(entry, place));
            inner.frame.push(Step::Translate(offset_of_copy));
            inner.frame.extend(&rotations);
            if let Some(offset) = offset {
                position = plus(position, Pose::of(&rotations).direction(offset));
            }
            let separator = separator.as_deref().unwrap_or_default();
            inner.suffix = format!("{separator}{copy:0digits$}{}", item.suffix);
            self.contents(&inner, depth + 1, items);
        }
    }

    /// Reads a body, and returns its child bodies.
    fn body(&mut self, body: PendingBody<'a>) -> Vec<PendingBody<'a>> {
        let PendingBody { item, parent } = body;
        let place = self.place(item.element);
        let name = self.name_of(&item).unwrap_or_else(|| {
            let number = self.tree.links.len();
            Name {
                text: self.tree.link_names.fresh(&format!("body_{number}")),
                place,
            }
        });
        self.tree.link_names.take(&name.text);
        let subject = format!("body {}", quoted(&name.text));
        let attributes = self.attributes(&item, "");
        let mut steps = item.frame.clone();
        steps.extend(self.placement(&attributes, &subject));
        let inside = Item {
            frame: Vec::new(),
            ..item.clone()
        };
        let mut items = Vec::new();
        self.contents(&inside, 0, &mut items);
        let of_tag = |tags: &[&str]| {
            let found = items
                .iter()
                .filter(|item| tags.contains(&item.element.tag()));
            found.cloned().collect::<Vec<_>>()
        };
        let mut inertials = of_tag(&["inertial"]).into_iter().map(|item| item.element);
        let inertial = inertials.next();
        if let Some(second) = inertials.next() {
            self.refuse(
                second,
                format!("{subject} has more than one <inertial>"),
                "leave one of them out",
            );
        }
        let geoms = of_tag(&["geom"]);
        let pieces = |mjcf: &mut Self| mjcf.pieces(&geoms, &subject);
        let inertial = self.inertia(inertial, pieces, place, &subject);
        let joints = of_tag(&["joint", "freejoint"]);
        self.tree
            .placements
            .insert(name.text.clone(), (parent.text.clone(), steps.clone()));
        let has_bodies = items.iter().any(|item| item.element.tag() == "body");
        self.connect(&Moving {
            link: &name,
            parent: &parent,
            steps,
            subject: &subject,
            has_bodies,
            joints: &joints,
            place,
        });
        self.tree.links.push(Link {
            name: name.clone(),
            inertial,
        });
        for site in of_tag(&["site"]) {
            self.site(&site, &name);
        }
        let bodies = of_tag(&["body"]).into_iter();
        bodies
            .map(|item| PendingBody {
                item,
                parent: name.clone(),
            })
            .collect()
    }

    fn pieces(&mut self, geoms: &[Item<'a>], body: &str) -> Vec<Piece> {
        let geoms = geoms.iter();
        geoms
            .filter_map(|item| {
                let geom = self.attributes(item, "geom");
                self.piece(&geom, &item.frame, body)
            })
            .collect()
    }

    /// Adds a massless link for a site.
    fn site(&mut self, item: &Item<'a>, on: &Name) {
        let Some(name) = self.name_of(item) else {
            return;
        };
        let site = self.attributes(item, "site");
        let subject = format!("site {}", quoted(&name.text));
        let mut steps = item.frame.clone();
        steps.extend(match site.get("fromto") {
            None => self.placement(&site, &subject),
            Some(ends) => {
                let ends = self.numbers::<6>(Some(ends), &subject);
                let shape = ends.and_then(|ends| self.between(&site, ends, &subject));
                shape.map_or_else(Vec::new, |(steps, _)| steps)
            }
        });
        let link = self.tree.link_names.of_site(&name.text);
        self.tree.sites.insert(name.text.clone(), link.clone());
        self.tree
            .placements
            .insert(link.clone(), (on.text.clone(), steps.clone()));
        let link = Name {
            text: link,
            place: name.place,
        };
        self.weld(&link, on, steps, name.place);
        self.tree.links.push(Link {
            name: link,
            inertial: None,
        });
    }

    /// Adds a fixed joint that places a link on another.
    pub(super) fn weld(&mut self, link: &Name, to: &Name, origin: Vec<Step>, place: Place) {
        let name = Name {
            text: self.tree.joint_names.fresh(&link.text),
            place,
        };
        let joint = Joint::fixed(name, to, link, origin);
        self.tree.joints.push(joint);
    }
}

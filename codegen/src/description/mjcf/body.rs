//! `<body>`: reads the listed tree of bodies.
//!
//! Yields links, the joints between them, and a massless link for each site.

use super::geom::Piece;
use super::joint::ConnectedBody;
use super::names::Names;
use super::parts::{Item, Part, PartId, WORLD};
use super::reading::Mjcf;
use super::values::Attributes;
use crate::description::{Joint, Link, Name, Step};
use crate::error::Place;
use crate::list::{Id, List};
use crate::wording::quoted;

/// Maximum number of links.
const MOST_LINKS: usize = 100_000;

/// A body, and the elements directly in it.
struct BodyElement<'p, 'a> {
    item: &'p Item<'a>,
    parent: Name,
    inside: Vec<(PartId, &'p Item<'a>)>,
}

impl<'a> Mjcf<'a> {
    /// Reads all bodies of the first model.
    pub(super) fn read_tree(&mut self, list: &List<PartId, Part<'a>>) {
        let named = |tags: &[&str]| {
            let named = list
                .iter()
                .filter(|part| tags.contains(&part.item.element.tag()));
            named
                .filter_map(|part| written_name(&part.item))
                .collect::<Vec<String>>()
        };
        let (links, joints) = (named(&["body"]), named(&["joint", "freejoint"]));
        let links = links.iter().map(String::as_str).chain([WORLD]);
        self.tree.link_names = Names::of(links);
        self.tree.joint_names = Names::of(joints.iter().map(String::as_str));
        let mut inside: List<PartId, Vec<PartId>> = List::filled(Vec::new(), list.len());
        for (number, part) in list.numbered().skip(1) {
            inside[part.within].push(number);
        }
        let mut inside = inside.map(|parts| {
            let parts = parts.iter().map(|part| (*part, &list[*part].item));
            parts.collect::<Vec<_>>()
        });
        let world = PartId::new(0);
        let mut names: List<PartId, Option<Name>> = List::filled(None, list.len());
        names[world] = Some(self.world(&list[world].item, &inside[world]));
        for (number, Part { item, within }) in list.numbered().skip(1) {
            if self.tree.links.len() > MOST_LINKS {
                break;
            }
            if item.element.tag() != "body" {
                continue;
            }
            let Some(parent) = names[*within].clone() else {
                continue;
            };
            let body = BodyElement {
                item,
                parent,
                inside: std::mem::take(&mut inside[number]),
            };
            names[number] = Some(self.within(item.model, |mjcf| mjcf.body(&body)));
        }
        if self.tree.links.len() > MOST_LINKS {
            let message = format!("there are more than {MOST_LINKS} bodies and sites");
            self.refuse(self.model().root, message, "replicate less");
        }
    }

    /// The fixed link with its sites; returns its name.
    fn world(&mut self, item: &Item<'a>, inside: &[(PartId, &Item<'a>)]) -> Name {
        let world = Name {
            text: WORLD.to_owned(),
            place: self.place(item.element),
        };
        self.tree.links.push(Link {
            name: world.clone(),
            inertial: None,
        });
        for (_, item) in inside {
            match item.element.tag() {
                "site" => self.site(item, &world),
                tag @ ("joint" | "freejoint" | "inertial") => {
                    let message = format!("the world has a <{tag}>");
                    self.refuse(item.element, message, "move it into a <body>");
                }
                _ => {}
            }
        }
        world
    }

    /// The attributes of an item, with those of its class as defaults.
    pub(super) fn attributes(&mut self, item: &Item<'a>, kind: &'static str) -> Attributes<'a> {
        let class = self.class(item.element.attribute("class"));
        Attributes {
            own: item.element,
            kind,
            class: class.unwrap_or_else(|| item.class.clone()),
        }
    }

    /// The name of an item; `None` if it has no name.
    pub(super) fn name_of(&mut self, item: &Item<'a>) -> Option<Name> {
        let mut name = self.word(item.element.attribute("name")?);
        if name.text.is_empty() {
            return None;
        }
        name.text = item.affix.name(&name.text);
        let affixes = &mut self.tree.affixes;
        affixes.insert(name.text.clone(), item.affix.clone());
        Some(name)
    }

    /// Reads a body; returns its name.
    fn body(&mut self, body: &BodyElement<'_, 'a>) -> Name {
        let BodyElement {
            item,
            parent,
            inside,
        } = body;
        let place = self.place(item.element);
        let name = self.name_of(item).unwrap_or_else(|| {
            let number = self.tree.links.len();
            Name {
                text: self.tree.link_names.fresh(&format!("body_{number}")),
                place,
            }
        });
        let subject = format!("body {}", quoted(&name.text));
        let attributes = self.attributes(item, "");
        let mut steps = item.frame.clone();
        steps.extend(self.placement(&attributes, &subject));
        let of_tag = |tags: &[&str]| {
            let found = inside
                .iter()
                .filter(|(_, item)| tags.contains(&item.element.tag()));
            found.copied().collect::<Vec<_>>()
        };
        let mut inertials = of_tag(&["inertial"])
            .into_iter()
            .map(|(_, item)| item.element);
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
        let has_bodies = !of_tag(&["body"]).is_empty();
        self.connect(&ConnectedBody {
            link: &name,
            parent,
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
        for (_, site) in of_tag(&["site"]) {
            self.site(site, &name);
        }
        name
    }

    /// The masses of geoms. As in MuJoCo, the groups that have mass are those of the body's model.
    fn pieces(&mut self, geoms: &[(PartId, &Item<'a>)], body: &str) -> Vec<Piece> {
        let groups = self.model().compiler.groups;
        let geoms = geoms.iter();
        geoms
            .filter_map(|(_, item)| {
                self.within(item.model, |mjcf| {
                    let geom = mjcf.attributes(item, "geom");
                    mjcf.piece(&geom, &item.frame, groups, body)
                })
            })
            .collect()
    }

    /// Adds a massless link for a site.
    fn site(&mut self, item: &Item<'a>, on: &Name) {
        self.within(item.model, |mjcf| mjcf.site_of_model(item, on));
    }

    fn site_of_model(&mut self, item: &Item<'a>, on: &Name) {
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
        self.tree.add(Joint::fixed(name, to, link, origin));
    }
}

/// The name of an item as a name of the robot; `None` if it has no name.
fn written_name(item: &Item<'_>) -> Option<String> {
    let name = item.element.node.attribute("name")?.trim();
    (!name.is_empty()).then(|| item.affix.name(name))
}

//! Everything that may stand in a URDF file, and what becomes of it.
//!
//! In: nothing. Out: one table, the only list of elements and attributes that the reader knows: of URDF 1.0
//! and 1.1, and of the extensions of ROS, Gazebo, Drake, MuJoCo, Bullet and Isaac. [`survey`](super::survey)
//! warns by it of what is left out, and the guide's page "What is read and what is not" is printed from it.
//! It never reads a number.

mod actuators;
mod format;
mod simulators;

use std::fmt::Write;

pub(super) use self::format::ROBOT;

/// What may stand in an element.
pub(super) struct Content {
    pub(super) attributes: &'static [Entry],
    pub(super) elements: &'static [Entry],
    pub(super) others: Others,
}

/// What becomes of elements and attributes that have no row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Others {
    /// They are ignored, with a warning.
    Warned,
    /// The same; and the element's values are attributes, so that text in it is one of them gone astray.
    WarnedLikeText,
    /// They are settings without mechanics, but what stands in them is looked at by the same rows.
    PassedOver,
}

/// An element or an attribute.
pub(super) struct Entry {
    /// As it is written; a name with Drake's prefix is known without it as well.
    pub(super) name: &'static str,
    pub(super) when: When,
    pub(super) becomes: Becomes,
    /// What may stand in it; none where nobody looks.
    pub(super) content: Option<&'static Content>,
}

/// Values for which a warning is due: of an attribute, or of an element's attribute `value` or text.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum When {
    Always,
    /// Anything but the number 0.
    NotZero,
    /// Anything but the number 1.
    NotOne,
    /// `true` or `1`.
    True,
    /// `false` or `0`.
    False,
    /// Three numbers that are not 0 0 -9.81.
    NotStandardGravity,
}

/// What the reader makes of it.
#[derive(Clone, Copy)]
pub(super) enum Becomes {
    /// This, in the words of the guide.
    Read(&'static str),
    /// Nothing: it has no mechanics.
    Nothing(&'static str),
    /// Nothing, though it is mechanics: a warning.
    Lost(&'static Lost),
}

/// Mechanics that are left out.
pub(super) struct Lost {
    /// What it is, with its article.
    pub(super) what: &'static str,
    /// What the user can do about it.
    pub(super) hint: &'static str,
}

impl Entry {
    const fn new(name: &'static str, becomes: Becomes) -> Self {
        Self {
            name,
            when: When::Always,
            becomes,
            content: None,
        }
    }

    /// What is read.
    const fn read(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Read(what))
    }

    /// What has no mechanics.
    const fn nothing(name: &'static str, what: &'static str) -> Self {
        Self::new(name, Becomes::Nothing(what))
    }

    /// Mechanics that are left out.
    const fn lost(name: &'static str, what: &'static Lost) -> Self {
        Self::new(name, Becomes::Lost(what))
    }

    const fn when(self, when: When) -> Self {
        Self { when, ..self }
    }

    const fn with(self, content: &'static Content) -> Self {
        Self {
            content: Some(content),
            ..self
        }
    }

    /// As the guide writes it, with the values that are warned of.
    fn shown(&self, is_attribute: bool) -> String {
        let name = self.name;
        let when = match self.when {
            When::Always => "",
            When::NotZero => " that is not 0",
            When::NotOne => " that is not 1",
            When::True => " that is true",
            When::False => " that is false",
            When::NotStandardGravity => " that is not 0 0 -9.81",
        };
        if is_attribute {
            format!("`{name}`{when}")
        } else {
            format!("`<{name}>`{when}")
        }
    }

    /// Whether an element or attribute of this name is meant.
    pub(super) fn is(&self, written: &str) -> bool {
        self.name == written || self.name.strip_prefix("drake:") == Some(written)
    }
}

impl Becomes {
    pub(super) const fn is_read(self) -> bool {
        matches!(self, Self::Read(_))
    }

    /// In the words of the guide, in which only what is code begins with `<`.
    fn text(self) -> String {
        match self {
            Self::Read(what) => what.to_owned(),
            Self::Nothing(what) => format!("nothing: {what}"),
            Self::Lost(Lost { what, hint }) => {
                let text = format!("**a warning**: {what}; {hint}");
                text.replace('<', "&lt;")
            }
        }
    }
}

impl Content {
    pub(super) fn element(&self, written: &str) -> Option<&'static Entry> {
        self.elements.iter().find(|entry| entry.is(written))
    }

    pub(super) fn attribute(&self, written: &str) -> Option<&'static Entry> {
        self.attributes.iter().find(|entry| entry.is(written))
    }
}

/// An element with one value.
const VALUE: Content = Content {
    attributes: &[Entry::read("value", "the value")],
    elements: &[],
    others: Others::WarnedLikeText,
};

/// Each element that has content, as the guide calls it.
const PLACES: [(&str, &Content); 18] = [
    ("`<robot>`", &ROBOT),
    ("`<link>`", &format::LINK),
    ("`<inertial>`", &format::INERTIAL),
    ("`<origin>`", &format::ORIGIN),
    ("`<joint>` and `<drake:joint>`", &format::JOINT),
    ("`<axis>` and `<axis2>`", &format::AXIS),
    ("`<limit>`", &format::LIMIT),
    ("`<dynamics>`", &format::DYNAMICS),
    ("`<mimic>`", &format::MIMIC),
    ("`<safety_controller>`", &format::SAFETY_CONTROLLER),
    ("`<loop_joint>`", &format::LOOP_JOINT),
    ("`<transmission>`", &actuators::TRANSMISSION),
    (
        "`<actuator>` and `<joint>` of a transmission",
        &actuators::END,
    ),
    ("`<gazebo>`, at any depth", &simulators::GAZEBO),
    ("`<mujoco>`", &simulators::MUJOCO),
    ("`<compiler>` of MuJoCo", &simulators::COMPILER),
    ("`<option>` of MuJoCo", &simulators::OPTION),
    (
        "`<contact>` of Bullet, in a link",
        &simulators::BULLET_CONTACT,
    ),
];

/// Where an element that stands elsewhere would be read: as an element, or as an attribute.
pub(super) fn home(written: &str) -> Option<String> {
    let place = |reads: &dyn Fn(&Content) -> bool| {
        let place = PLACES.iter().find(|(_, content)| reads(content));
        place.map(|(name, _)| name.replace('`', ""))
    };
    let read = |entry: Option<&Entry>| entry.is_some_and(|entry| entry.becomes.is_read());
    let element = place(&|content| read(content.element(written)));
    let element = element.map(|place| format!("it stands in {place}: move it there"));
    let attribute = place(&|content| !NAMES.contains(&written) && read(content.attribute(written)));
    element.or_else(|| attribute.map(|place| format!("write it as an attribute of {place}")))
}

/// Attributes that many elements have.
const NAMES: [&str; 3] = ["name", "type", "version"];

/// The table as the guide shows it, in Markdown: of each element what may stand in it, attributes first.
#[must_use]
pub fn page() -> String {
    let mut page = String::new();
    for (place, content) in PLACES {
        // Writing to a string cannot fail.
        let _ = write!(page, "## In {place}\n\n| | becomes |\n|---|---|\n");
        let rows = content.attributes.iter().map(|entry| (entry, true));
        let rows = rows.chain(content.elements.iter().map(|entry| (entry, false)));
        // Rows of one fate are one.
        let mut written: Vec<(String, String)> = Vec::new();
        for (entry, is_attribute) in rows {
            let name = entry.shown(is_attribute);
            let becomes = entry.becomes.text();
            match written.last_mut().filter(|(_, last)| *last == becomes) {
                Some((names, _)) => names.extend([", ", &name]),
                None => written.push((name, becomes)),
            }
        }
        for (names, becomes) in written {
            let _ = writeln!(page, "| {names} | {becomes} |");
        }
        let others = match content.others {
            Others::Warned => "Anything else is ignored, with a warning.",
            Others::WarnedLikeText => {
                "Anything else is ignored, with a warning; so are values that stand in it as elements or text."
            }
            Others::PassedOver => "Anything else is a setting, and passed over.",
        };
        let _ = writeln!(page, "\n{others}\n");
    }
    page
}

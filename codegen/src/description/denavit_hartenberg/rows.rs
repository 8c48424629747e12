//! Converts rows of a table to links and joints, by either convention.

use crate::description::{Axis, Inertial, Joint, Limits, Link, Name, Number, Step, number};
use crate::error::Place;
use crate::joint::JointKind;
use crate::joint::actuator::Actuator;
use crate::wording::{known, quoted};

/// Convention of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description) enum Convention {
    /// Denavit and Hartenberg 1955, Paul 1981: frame i at the far end of link i.
    Standard,
    /// Craig 1986, Khalil and Kleinfinger: frame i on the axis of joint i.
    Modified,
}

/// A row: a joint and the link that it moves.
pub(in crate::description) struct Row {
    pub(in crate::description) joint: Name,
    /// The link's name, if the row has one.
    pub(in crate::description) link: Option<Name>,
    pub(in crate::description) kind: JointKind,
    pub(in crate::description) a: Number,
    pub(in crate::description) alpha: Number,
    pub(in crate::description) d: Number,
    pub(in crate::description) theta: Number,
    /// Mass and inertia in the frame of the row.
    pub(in crate::description) inertial: Option<Inertial>,
    pub(in crate::description) limits: Option<Limits>,
}

impl Convention {
    /// The convention with a name, or a message and a hint.
    pub(in crate::description) fn from_name(name: &str) -> Result<Self, (String, String)> {
        match name {
            "standard" => Ok(Self::Standard),
            "modified" => Ok(Self::Modified),
            other => Err((
                format!("unknown convention {}", quoted(other)),
                known(other, "conventions", &["standard", "modified"]),
            )),
        }
    }
}

/// The chain of the rows; `place` is that of the table.
pub(in crate::description) fn assemble(
    convention: Convention,
    rows: Vec<Row>,
    place: Place,
) -> (Vec<Link>, Vec<Joint>) {
    let mut parent = Name {
        text: "base".to_owned(),
        place,
    };
    let mut links = vec![Link {
        name: parent.clone(),
        inertial: None,
    }];
    let mut joints = Vec::new();
    for row in rows {
        let link = row
            .link
            .clone()
            .unwrap_or_else(|| suffixed(&row.joint, "_link"));
        let before = [Step::Rotate(Axis::Z, row.theta), along(Axis::Z, row.d)];
        let behind = [along(Axis::X, row.a), Step::Rotate(Axis::X, row.alpha)];
        let moves = row.kind.moves();
        let offset = row.a.value != 0.0 || row.alpha.value != 0.0;
        let axis = [0.0, 0.0, 1.0].map(|value| number::computed(value, row.joint.place));
        let mut joint = Joint {
            name: row.joint.clone(),
            kind: row.kind,
            parent,
            child: link.clone(),
            origin: before.to_vec(),
            axis,
            second_axis: axis,
            limits: row.limits,
            mimic: None,
            actuator: Actuator::default(),
            place: row.joint.place,
        };
        match convention {
            Convention::Modified => {
                let [shift, twist] = behind;
                joint.origin = [twist, shift].into_iter().chain(before).collect();
                joints.push(joint);
            }
            Convention::Standard if moves && offset => {
                let on_axis = suffixed(&row.joint, "_axis");
                joint.child = on_axis.clone();
                let carried = Joint {
                    name: suffixed(&row.joint, "_offset"),
                    kind: JointKind::Fixed,
                    parent: on_axis.clone(),
                    child: link.clone(),
                    origin: behind.to_vec(),
                    limits: None,
                    actuator: Actuator::default(),
                    ..joint.clone()
                };
                links.push(Link {
                    name: on_axis,
                    inertial: Some(massless(row.joint.place)),
                });
                joints.push(joint);
                joints.push(carried);
            }
            Convention::Standard => {
                joint.origin.extend(behind);
                joints.push(joint);
            }
        }
        links.push(Link {
            name: link.clone(),
            inertial: row.inertial,
        });
        parent = link;
    }
    (links, joints)
}

fn suffixed(name: &Name, suffix: &str) -> Name {
    Name {
        text: format!("{}{suffix}", name.text),
        place: name.place,
    }
}

fn along(axis: Axis, length: Number) -> Step {
    let mut step = [0.0; 3].map(|zero| number::computed(zero, length.place));
    step[axis as usize] = length;
    Step::Translate(step)
}

/// The frame on a joint's axis has no body, so its mass is not missing.
fn massless(place: Place) -> Inertial {
    let zero = number::computed(0.0, place);
    Inertial {
        origin: Vec::new(),
        mass: zero,
        inertia: [zero; 6],
        place,
    }
}

//! The interpretation of a description: joints in the order of q, links, and what was merged, locked, left out or read
//! as a right angle.

use serde_json::{Value, json};

use crate::diagnostics::{line_and_column, warnings};
use homogen_codegen::chain::{BodyId, Chain};
use homogen_codegen::description::{FileFormat, Joint};
use homogen_codegen::expand::configurations;
use homogen_codegen::list::Id;
use homogen_codegen::space::Space;

/// The moving joints, including mimic joints, each with the mass of its body.
pub fn described(chain: &Chain) -> impl Iterator<Item = (&Joint, f64)> {
    // The last velocity of a joint moves the body.
    let last = |k: BodyId| chain.joints.get(k.plus(1)).map(|next| next.of.as_str());
    let bodies = chain.joints.numbered();
    let bodies = bodies.filter(move |(k, body)| last(*k) != Some(&body.of));
    bodies.filter_map(|(_, body)| {
        let mass = chain.graph.value(body.inertia.mass)?.to_f64();
        let mut joints = chain.description.joints.iter();
        let joint = joints.find(|joint| joint.name.text == body.of)?;
        Some((joint, mass))
    })
}

/// The link of the end effector, if there is one.
#[must_use]
pub fn tip(chain: &Chain) -> Option<&str> {
    let tip = chain.frames.first().filter(|_| chain.has_tip);
    tip.map(|tip| tip.name.as_str())
}

/// The report of a chain, with each warning at its place.
#[must_use]
pub fn report(chain: &Chain) -> Value {
    let description = &chain.description;
    let report = &chain.report;
    let spaces = chain.spaces();
    let names = |space| spaces.names(space).collect::<Value>();
    let merged = report.merged.iter();
    let merged: Value = merged
        .map(|(link, into)| json!({ "link": link, "into": into }))
        .collect();
    let locked = report.locked.iter();
    let locked: Value = locked
        .map(|(joint, at)| json!({ "joint": joint, "q": at }))
        .collect();
    let mimicked = report.mimicked.iter();
    let mimicked: Value = mimicked
        .map(|mimic| {
            json!({
                "joint": mimic.joint, "of": mimic.mimicked,
                "multiplier": mimic.multiplier, "offset": mimic.offset,
            })
        })
        .collect();
    let snapped = report.snapped.iter().map(|angle| {
        let (line, column) = line_and_column(angle.place);
        json!({
            "line": line, "column": column, "item": angle.item,
            "written": angle.written, "quarter_turns": angle.quarters,
        })
    });
    let details = described(chain).map(|(joint, mass)| {
        let limits = joint.limits.as_ref();
        // JSON has no infinity: a missing limit is null.
        let limits = limits.map(|limits| {
            json!({ "lower": limits.lower, "upper": limits.upper, "velocity": limits.velocity })
        });
        let mut planes = report.planes.iter();
        let plane = planes.find(|plane| plane.joint == joint.name.text);
        let plane = plane.map(|plane| json!({ "x": plane.x, "y": plane.y }));
        let mut details = json!({
            "name": joint.name.text, "kind": joint.kind.word(), "parent": joint.parent.text,
            "child": joint.child.text, "mass": mass, "limits": limits,
        });
        if let Some(plane) = plane {
            details["plane"] = plane;
        }
        details
    });
    let frames: Value = chain
        .frames
        .iter()
        .map(|frame| frame.name.as_str())
        .collect();
    let mut answer = json!({
        "robot": description.name.text,
        "file": description.source.file,
        "format": description.source.format.map(FileFormat::name),
        "base": report.base,
        "tip": tip(chain),
        "joints": report.joints,
        "coordinates": names(Space::Coordinates),
        "velocities": names(Space::Velocities),
        "links": report.links,
        "merged": merged,
        "locked": locked,
        "dropped": report.dropped,
        "mimicked": mimicked,
        "snapped": snapped.collect::<Value>(),
        "turned": turned(chain),
        "warnings": warnings(&report.warnings),
        "details": {
            "hash": format!("{:016x}", description.source.hash),
            "frames": frames,
            "joints": details.collect::<Value>(),
        },
    });
    let configurations = configurations(chain);
    let configurations =
        configurations.map(|configuration| (configuration.name, json!(configuration.q)));
    let configurations: serde_json::Map<String, Value> = configurations.collect();
    if !configurations.is_empty() {
        answer["configurations"] = Value::Object(configurations);
    }
    if !chain.loops.is_empty() {
        let loops = chain.loops.iter().map(|closed| {
            let [from, to] = closed.frames.each_ref().map(|frame| &frame.name);
            json!({ "name": closed.name, "kind": closed.word, "from": from, "to": to })
        });
        answer["loops"] = loops.collect();
        answer["constraints"] = names(Space::Constraints);
        answer["closed"] = json!(report.closed);
        answer["dependent"] = json!(report.dependent);
    }
    answer
}

/// Quaternions that were read as rotations by right angles.
fn turned(chain: &Chain) -> Value {
    let turned = chain.report.turned.iter().map(|turned| {
        let (line, column) = line_and_column(turned.place);
        json!({
            "line": line, "column": column, "item": turned.item,
            "written": turned.written, "meant": turned.squares.map(root),
        })
    });
    turned.collect()
}

/// An entry of a quaternion of right angles; `square` is four times its square, with its sign.
#[must_use]
pub fn root(square: i64) -> String {
    let sign = if square < 0 { "−" } else { "" };
    let size = match square.abs() {
        0 => "0",
        1 => "½",
        2 => "√½",
        _ => "1",
    };
    format!("{sign}{size}")
}

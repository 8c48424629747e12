//! Facts about a robot for its doc comments.
//!
//! In: a chain. Out: an [`About`]: names, what is modelled and what is not, and every warning with its place.
//! Operation counts and accuracy belong to each function.

use std::collections::BTreeSet;

use crate::chain::Chain;
use crate::expression::{Double, Expr};
use crate::formulation::Parameters;
use crate::joint::ActuatorTerms;
use crate::module::About;
use crate::plan::inertial_parameters;
use crate::wording::{code, list};

/// Collects the facts about a robot.
pub(super) fn about(chain: &Chain) -> About {
    let (description, formulation) = (&chain.description, chain.request.formulation);
    let report = &chain.report;
    About {
        robot: description.name.text.clone(),
        source: description.source.clone(),
        base: report.base.clone(),
        tip: match chain.frames.first() {
            Some(tip) if chain.has_tip => tip.name.clone(),
            _ => String::new(),
        },
        facts: facts(chain, formulation.parameters),
        actuated: chain.has_actuator_terms(),
        formulation: formulation.words(),
        warnings: report.warnings.clone(),
        left_out: Vec::new(),
    }
}

fn facts(chain: &Chain, parameters: Parameters) -> Vec<String> {
    let report = &chain.report;
    let mut facts = Vec::new();
    let mut count = |number: usize, one: &str, many: &str| match number {
        0 => {}
        1 => facts.push(format!("1 {one}")),
        _ => facts.push(format!("{number} {many}")),
    };
    count(report.merged.len(), "link merged", "links merged");
    count(report.locked.len(), "joint locked", "joints locked");
    count(report.dropped.len(), "link left out", "links left out");
    let (right_angles, residues) = report.right_angles_and_residues();
    count(
        right_angles,
        "angle taken for a right angle",
        "angles taken for right angles",
    );
    count(
        residues,
        "residue taken for zero",
        "residues taken for zero",
    );
    if !report.closed.is_empty() {
        let names = list(report.closed.iter().map(String::as_str));
        facts.push(format!("closed whatever the joints do: {names}"));
    }
    if !report.dependent.is_empty() {
        let names = list(report.dependent.iter().map(String::as_str));
        facts.push(format!(
            "implied by the others where loops are closed: {names}"
        ));
    }
    let having = |is: fn(&ActuatorTerms<Expr>) -> Expr| {
        let joints = chain.joints.iter();
        let joints = joints.filter(|joint| !chain.graph.term(is(&joint.actuator)).is_zero());
        // A joint with several velocities counts once.
        let joints: BTreeSet<&str> = joints.map(|joint| joint.of.as_str()).collect();
        joints.len()
    };
    let what = [
        (having(|actuator| actuator.armature), "armature of"),
        (having(|actuator| actuator.damping), "viscous friction of"),
        (
            having(|actuator| actuator.friction),
            "Coulomb friction (its sign that of q̇, 0 at rest: a step) of",
        ),
    ];
    for (number, what) in what.into_iter().filter(|(number, _)| *number > 0) {
        let joints = if number == 1 { "joint" } else { "joints" };
        facts.push(format!("{what} {number} {joints}"));
    }
    if !chain.external.is_empty() {
        let links = chain.external.iter().map(|link| code(&link.name));
        let links: Vec<String> = links.collect();
        let frame = if chain.request.external_in_frame_0 {
            "in frame 0"
        } else {
            "in the link's frame"
        };
        let links = list(links.iter().map(String::as_str));
        facts.push(format!("external wrenches on {links}, {frame}"));
    }
    facts.push(gravity(chain));
    let used = inertial_parameters(chain, parameters);
    let links = chain.joints.iter().filter(|joint| joint.link.is_some());
    facts.push(format!(
        "{used} of {} inertial parameters used",
        10 * links.count()
    ));
    for plane in &report.planes {
        facts.push(format!("{} has {}", code(&plane.joint), plane.text()));
    }
    facts
}

fn gravity(chain: &Chain) -> String {
    let entries = chain
        .gravity
        .map(|entry| chain.graph.value(entry).map(Double::to_f64));
    match entries.0 {
        [Some(x), Some(y), Some(z)] => {
            let names = ["x", "y", "z"];
            let along: Vec<(usize, f64)> = [x, y, z]
                .into_iter()
                .enumerate()
                .filter(|(_, entry)| *entry != 0.0)
                .collect();
            match along[..] {
                [] => "no gravity".into(),
                [(k, entry)] => {
                    let sign = if entry < 0.0 { "−" } else { "" };
                    format!(
                        "gravity only along {sign}{} ({} m/s²)",
                        names[k],
                        entry.abs()
                    )
                }
                _ => format!("gravity ({x}, {y}, {z}) m/s²"),
            }
        }
        _ => "gravity given at run time".into(),
    }
}

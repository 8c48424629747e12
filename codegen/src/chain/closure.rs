//! Checks of loops: they must join two bodies that move relative to each other.
//!
//! In: the loops of a description and its links, or the merged chain. Out: an error for each loop with an unknown link,
//! with one link, or with two links of one body; warnings about loops and actuators that no function reads. Whether a
//! loop can close is checked by its equations.

use super::names::Names;
use super::{Chain, Loop};
use crate::description::{Description, LinkId};
use crate::error::{Diagnostic, Errors};
use crate::function::Function;
use crate::request::Request;
use crate::space::{Entry, VelocityId};
use crate::wording::quoted;

/// Rejects loops with unknown links, or with one link.
pub fn check(description: &Description, links: &Names<'_, LinkId>, errors: &mut Errors) {
    for described in &description.loops {
        let found = [&described.from, &described.to].map(|link| links.find(link, errors));
        if let [Some(from), Some(to)] = found
            && from == to
        {
            let [name, link] = [&described.name, &described.to].map(|name| quoted(&name.text));
            let message = format!("loop {name} joins link {link} to itself");
            let hint = "name two links that move relative to each other";
            errors.push_with_hint(described.to.place, message, hint);
        }
    }
}

/// Rejects loops between two links of one body, and actuators of joints without a velocity; lists the residuals and the
/// velocities with an actuator.
///
/// # Errors
/// One error for each of them.
pub fn check_merged(mut chain: Chain, request: &Request) -> Result<Chain, Errors> {
    let mut errors = chain.description.source.errors();
    for closed in &chain.loops {
        let [from, to] = &closed.frames;
        if from.body == to.body {
            let [name, from, to] = [&closed.name, &from.name, &to.name].map(|name| quoted(name));
            errors.push_with_hint(
                closed.place,
                format!(
                    "loop {name} joins links {from} and {to}, which do not move relative to each other"
                ),
                "leave the loop out, or unlock a joint between them",
            );
        }
    }
    let joint = |velocity: VelocityId| &chain.joints[chain.mover(velocity)].of;
    let velocities = chain.spaces.velocities.ids();
    for name in &request.actuated {
        if velocities
            .clone()
            .all(|velocity| *joint(velocity) != name.text)
        {
            let message = format!("joint {} has no velocity of its own", quoted(&name.text));
            errors.push_with_hint(
                name.place,
                message,
                "an actuated joint must move, and must not be locked or a mimic joint",
            );
        }
    }
    let is_actuated = |velocity: VelocityId| {
        let mut actuated = request.actuated.iter();
        actuated.any(|name| name.text == *joint(velocity))
    };
    chain.actuated = velocities.clone().map(is_actuated).collect();
    chain.close(|_| {});
    let warnings = unasked(&chain, request);
    chain.report.warnings.extend(warnings);
    errors.into_result(chain)
}

/// Warnings about loops and actuators that no requested function reads.
fn unasked(chain: &Chain, request: &Request) -> Vec<Diagnostic> {
    let asked = |is: fn(Function) -> bool| {
        let mut functions = request.functions.iter().flatten();
        request.functions.is_empty() || functions.any(|&function| is(function))
    };
    let mut warnings = Vec::new();
    if !asked(Function::is_of_loops) {
        warnings.extend(chain.loops.iter().map(|closed| Diagnostic {
            place: closed.place,
            message: format!(
                "loop {} is left open: no function of loops is generated",
                quoted(&closed.name)
            ),
            hint: Some("generate constrained_forward_dynamics, or leave the loop out".into()),
        }));
    }
    if let Some(first) = request.actuated.first()
        && !asked(Function::wants_actuators)
    {
        warnings.push(Diagnostic {
            place: first.place,
            message: "actuated joints are named, but no function uses them".into(),
            hint: Some("generate actuated_inverse_dynamics".into()),
        });
    }
    warnings
}

/// The residuals of loops.
#[must_use]
pub fn entries(loops: &[Loop]) -> Vec<Entry> {
    let rows = loops.iter().flat_map(|closed| {
        let rows = closed.rows.iter();
        rows.map(|row| Entry {
            name: row.name(&closed.name),
            kind: row.kind(),
            range: None,
        })
    });
    rows.collect()
}

//! The implicit midpoint rule in C, as an equation for the velocities after a step, for a solver.
//!
//! In: what all steps need. Out: heads and definitions of `midpoint_residual`, of `midpoint_configuration` and, with
//! derivatives of inverse dynamics and the mass matrix, of `midpoint_derivatives`. With w = (q̇ + q̇⁺)/2 the rule is
//! q⁺ = q + Δt w, and inverse dynamics at q + Δt w/2, w and (q̇⁺ − q̇)/Δt needs τ.

use super::texts::{Head, INVERSE, INVERSE_DERIVATIVES, MASS, Texts, definition};
use crate::print::c::literals::literal;

/// The functions that there are.
pub(super) fn heads(texts: &Texts<'_>) -> Vec<Head> {
    let Texts { t, n, .. } = texts;
    let lines = |lines: &[&str]| lines.iter().map(|&line| line.to_owned()).collect();
    let head = |name: &str, parameters: String| format!("{}({parameters})", texts.own(name));
    let vectors = ["q", "qd", "next_qd"].map(|name| format!("const {t} {name}[{n}]"));
    let vectors = vectors.join(", ");
    let mut heads = vec![
        (
            lines(&[
                "What velocities next_qd after dt [s] need by the implicit midpoint rule, less tau: zero for those of the rule,",
                "q+ = q + dt w with w = (qd + qd+) / 2, where inverse dynamics at q + dt w / 2, w and (qd+ - qd) / dt needs tau.",
            ]),
            head(
                "midpoint_residual",
                texts.parameters(
                    &["q", "qd", "next_qd", "tau"],
                    &[format!("{t} residual[{n}]")],
                ),
            ),
        ),
        (
            lines(&["Coordinates after a step by this rule."]),
            head(
                "midpoint_configuration",
                format!("{vectors}, {t} dt, {t} next_q[{n}]"),
            ),
        ),
    ];
    if has_derivatives(texts) {
        let further = ["d_q", "d_qd", "d_next_qd"].map(|name| format!("{t} {name}[{n}][{n}]"));
        heads.push((
            lines(&[
                "Derivatives of this residual by q, qd and next_qd, a row for each of its entries.",
            ]),
            head(
                "midpoint_derivatives",
                texts.parameters(&["q", "qd", "next_qd"], &further),
            ),
        ));
    }
    heads
}

/// Definitions.
pub(super) fn definitions(texts: &Texts<'_>) -> String {
    let mut text = middle(texts);
    let bodies = [residual(texts), configuration(texts), derivatives(texts)];
    for ((_, head), body) in heads(texts).into_iter().zip(bodies) {
        text.push_str(&definition(&head, &body));
    }
    text
}

/// True if the residual has derivatives.
fn has_derivatives(texts: &Texts<'_>) -> bool {
    texts.has(INVERSE_DERIVATIVES) && texts.has(MASS)
}

/// Locals of the middle of a step, and the call that fills them.
fn at_the_middle(texts: &Texts<'_>) -> String {
    let Texts { t, n, .. } = texts;
    let name = texts.own("midpoint");
    format!(
        "    {t} at_q[{n}], at_qd[{n}], at_qdd[{n}];
    {name}(q, qd, next_qd, dt, at_q, at_qd, at_qdd);
"
    )
}

const MIDDLE: [&str; 3] = ["at_q", "at_qd", "at_qdd"];

/// The state at the middle of a step.
fn middle(texts: &Texts<'_>) -> String {
    let Texts { t, n, .. } = texts;
    let (name, half) = (texts.own("midpoint"), half(texts));
    format!(
        "
/* The middle of a step, with the accelerations that lead from the velocities before it to those after it. */
HOMOGEN_FN static void {name}(const {t} q[{n}], const {t} qd[{n}], const {t} next_qd[{n}], {t} dt, {t} at_q[{n}], {t} at_qd[{n}], {t} at_qdd[{n}])
{{
    int k;
    for (k = 0; k < {n}; ++k) {{
        at_qd[k] = {half} * (qd[k] + next_qd[k]);
        at_qdd[k] = (next_qd[k] - qd[k]) / dt;
        at_q[k] = q[k] + {half} * dt * at_qd[k];
    }}
}}
"
    )
}

fn half(texts: &Texts<'_>) -> String {
    literal(0.5, texts.module.scalar)
}

fn residual(texts: &Texts<'_>) -> String {
    let (n, middle) = (texts.n, at_the_middle(texts));
    let call = texts.call(INVERSE, MIDDLE, &["residual"]);
    format!(
        "    int k;
{middle}    {call}
    for (k = 0; k < {n}; ++k) {{
        residual[k] -= tau[k];
    }}
"
    )
}

fn configuration(texts: &Texts<'_>) -> String {
    let (n, half) = (texts.n, half(texts));
    format!(
        "    int k;
    for (k = 0; k < {n}; ++k) {{
        next_q[k] = q[k] + dt * ({half} * (qd[k] + next_qd[k]));
    }}
"
    )
}

fn derivatives(texts: &Texts<'_>) -> String {
    let Texts { t, n, .. } = texts;
    let (middle, half) = (at_the_middle(texts), half(texts));
    let by_state = texts.call(INVERSE_DERIVATIVES, MIDDLE, &["d_q", "by_qd"]);
    let mass = texts.call(MASS, MIDDLE, &["inertia"]);
    format!(
        "    {t} by_qd[{n}][{n}], inertia[{n}][{n}];
    int r, c;
{middle}    {by_state}
    {mass}
    for (r = 0; r < {n}; ++r) {{
        for (c = 0; c < {n}; ++c) {{
            const {t} of_mean = {half} * ({half} * dt * d_q[r][c] + by_qd[r][c]);
            const {t} of_rate = inertia[r][c] / dt;
            d_qd[r][c] = of_mean - of_rate;
            d_next_qd[r][c] = of_mean + of_rate;
        }}
    }}
"
    )
}

//! Time steps by explicit stages in C, and their first and second derivatives.
//!
//! In: a rule's [`Table`], and what all steps need. Out: heads and definitions of `step`; with derivatives of forward
//! dynamics `step_derivatives`, with its Hessian `step_hessian`.

use super::rule::Table;
use super::texts::{Head, Texts, definition, has_derivatives, has_hessian};

/// A rule with what its texts need.
pub(super) struct Explicit<'m> {
    pub texts: Texts<'m>,
    pub table: Table,
    /// The scalar type.
    pub t: &'static str,
    /// Number of velocities.
    pub n: usize,
    /// Number of stages.
    pub s: usize,
}

impl<'m> Explicit<'m> {
    pub fn of(texts: Texts<'m>, table: Table) -> Self {
        Self {
            t: texts.t,
            n: texts.n,
            s: table.stages(),
            texts,
            table,
        }
    }
}

/// State and forces at the start.
pub(super) const START: [&str; 3] = ["q", "qd", "tau"];

/// The functions that there are.
pub(super) fn heads(explicit: &Explicit<'_>) -> Vec<Head> {
    let Explicit { texts, t, n, .. } = explicit;
    let lines = |lines: &[&str]| lines.iter().map(|&line| line.to_owned()).collect();
    let about = format!(
        "State after dt [s] under constant tau: {}.",
        explicit.table.about
    );
    let (double, triple) = (2 * n, 3 * n);
    let mut heads = vec![(
        vec![about],
        format!(
            "{}({})",
            texts.own("step"),
            texts.parameters(
                &START,
                &[format!("{t} next_q[{n}]"), format!("{t} next_qd[{n}]")]
            )
        ),
    )];
    if has_derivatives(texts.module) {
        heads.push((
            lines(&[
                "State after dt [s] as above, with its derivatives: a = d(q+, qd+)/d(q, qd) and b = d(q+, qd+)/d tau, a row for",
                "each entry of that state.",
            ]),
            format!(
                "{}({})",
                texts.own("step_derivatives"),
                texts.parameters(&START, &[
                    format!("{t} next_q[{n}]"),
                    format!("{t} next_qd[{n}]"),
                    format!("{t} a[{double}][{double}]"),
                    format!("{t} b[{double}][{n}]")
                ])
            ),
        ));
    }
    if has_hessian(texts.module) {
        heads.push((
            lines(&[
                "Second derivatives of the sum of the state after this step, (q+, qd+), times weights: a row and a column for",
                "each entry of q, qd and tau.",
            ]),
            format!(
                "{}({})",
                texts.own("step_hessian"),
                texts.parameters(&START, &[
                    format!("const {t} weights[{double}]"),
                    format!("{t} hessian[{triple}][{triple}]")
                ])
            ),
        ));
    }
    heads
}

/// Definitions.
pub(super) fn definitions(explicit: &Explicit<'_>) -> String {
    let mut text = explicit.stage();
    let bodies = [
        explicit.step(),
        explicit.step_derivatives(),
        explicit.step_hessian(),
    ];
    for (k, ((_, head), body)) in heads(explicit).into_iter().zip(bodies).enumerate() {
        // Derivatives of one stage alone are at the start.
        if k == 1 && (explicit.s > 1 || has_hessian(explicit.texts.module)) {
            text.push_str(&explicit.stage_derivatives());
            text.push_str(&explicit.step_along());
        }
        text.push_str(&definition(&head, &body));
    }
    text
}

//! Statements of time steps in C.
//!
//! In: [`Texts`]. Out: bodies of the functions, and the functions of a stage that they share. Derivatives follow the
//! stages. The Hessian of a contraction with weights goes back through them: each q̈ᵢ gets the weights of what depends on
//! it, and adds its own Hessian between the derivatives of its stage.

use super::rule::Table;
use super::{BOTH, DERIVATIVES, SECOND, Texts, VALUE};
use crate::print::c::literals::literal;

impl Texts<'_> {
    /// The coefficients aᵢⱼ and bᵢⱼ of the rule, as constants.
    fn of_rates(&self) -> String {
        let Table { of_q, of_qd, .. } = Table::of(self.rule);
        let rows = |rows: &[&[f64]]| {
            let rows = rows.iter().map(|row| self.row(row));
            format!("{{{}}}", rows.collect::<Vec<_>>().join(", "))
        };
        let Self { t, s, .. } = self;
        let all = s + 1;
        format!(
            "    const {t} of_q[{all}][{s}] = {};
    const {t} of_qd[{all}][{s}] = {};
",
            rows(of_q),
            rows(of_qd)
        )
    }

    /// All coefficients of the rule.
    fn table(&self) -> String {
        let time = self.row(Table::of(self.rule).time);
        let Self { t, s, .. } = self;
        format!(
            "    const {t} time[{}] = {time};\n{}",
            s + 1,
            self.of_rates()
        )
    }

    /// Numbers in braces.
    fn row(&self, row: &[f64]) -> String {
        let entries = row.iter().map(|&entry| literal(entry, self.module.scalar));
        format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
    }

    /// State of a stage.
    pub(super) fn stage(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (name, table) = (self.own("stage"), self.table());
        format!(
            "
/* State of a stage of a step, or of its end, from the accelerations of the stages before. */
HOMOGEN_FN static void {name}(int i, const {t} q[{n}], const {t} qd[{n}], {t} dt, {t} qdd[{s}][{n}], {t} at_q[{n}], {t} at_qd[{n}])
{{
{table}    int j, k;
    for (k = 0; k < {n}; ++k) {{
        at_q[k] = q[k] + time[i] * dt * qd[k];
        at_qd[k] = qd[k];
        for (j = 0; j < i; ++j) {{
            at_q[k] += dt * dt * of_q[i][j] * qdd[j][k];
            at_qd[k] += dt * of_qd[i][j] * qdd[j][k];
        }}
    }}
}}
"
        )
    }

    pub(super) fn step(&self) -> String {
        let Self { t, n, s, .. } = self;
        let stage = self.own("stage");
        let call = self.call(VALUE, ["next_q", "next_qd", ""], &["qdd[i]"]);
        format!(
            "    {t} qdd[{s}][{n}];
    int i;
    for (i = 0; i < {s}; ++i) {{
        {stage}(i, q, qd, dt, qdd, next_q, next_qd);
        {call}
    }}
    {stage}({s}, q, qd, dt, qdd, next_q, next_qd);
"
        )
    }

    /// Derivatives of the state of a stage.
    pub(super) fn stage_derivatives(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (name, table) = (self.own("stage_derivatives"), self.table());
        let (double, triple) = (2 * n, 3 * n);
        format!(
            "
/* Derivatives of that state by q, qd and tau of the start. */
HOMOGEN_FN static void {name}(int i, {t} dt, {t} qdd[{s}][{n}][{triple}], {t} at[{double}][{triple}])
{{
{table}    int j, k, c;
    for (k = 0; k < {n}; ++k) {{
        for (c = 0; c < {triple}; ++c) {{
            at[k][c] = 0;
            at[{n} + k][c] = 0;
        }}
        at[k][k] = 1;
        at[k][{n} + k] = time[i] * dt;
        at[{n} + k][{n} + k] = 1;
        for (j = 0; j < i; ++j) {{
            const {t} x = dt * dt * of_q[i][j];
            const {t} v = dt * of_qd[i][j];
            for (c = 0; c < {triple}; ++c) {{
                at[k][c] += x * qdd[j][k][c];
                at[{n} + k][c] += v * qdd[j][k][c];
            }}
        }}
    }}
}}
"
        )
    }

    /// All stages with their derivatives.
    pub(super) fn step_along(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (double, triple) = (2 * n, 3 * n);
        let further = [
            format!("{t} at_q[{}][{n}]", s + 1),
            format!("{t} at_qd[{}][{n}]", s + 1),
            format!("{t} by[{s}][3][{n}][{n}]"),
            format!("{t} at[{}][{double}][{triple}]", s + 1),
        ];
        let (name, parameters) = (self.own("step_along"), self.parameters(&further));
        let [stage, derivatives] = ["stage", "stage_derivatives"].map(|name| self.own(name));
        let state = ["at_q[i]", "at_qd[i]", ""];
        let by = ["by[i][0]", "by[i][1]", "by[i][2]"];
        let calls = if self.has(BOTH) {
            self.call(BOTH, state, &["qdd[i]", by[0], by[1], by[2]])
        } else {
            let [value, derivatives] = [
                self.call(VALUE, state, &["qdd[i]"]),
                self.call(DERIVATIVES, state, &by),
            ];
            format!("{value}\n        {derivatives}")
        };
        format!(
            "
/* The stages and the end with their derivatives, and those of forward dynamics at the stages by q, qd and tau. */
HOMOGEN_FN static void {name}({parameters})
{{
    {t} qdd[{s}][{n}];
    {t} along[{s}][{n}][{triple}];
    int i, k, r, c;
    for (i = 0; i < {s}; ++i) {{
        {stage}(i, q, qd, dt, qdd, at_q[i], at_qd[i]);
        {derivatives}(i, dt, along, at[i]);
        {calls}
        for (r = 0; r < {n}; ++r) {{
            for (c = 0; c < {n}; ++c) {{
                along[i][r][c] = 0;
                along[i][r][{n} + c] = 0;
                along[i][r][{double} + c] = by[i][2][r][c];
            }}
            for (k = 0; k < {n}; ++k) {{
                for (c = 0; c < {triple}; ++c) {{
                    along[i][r][c] += by[i][0][r][k] * at[i][k][c] + by[i][1][r][k] * at[i][{n} + k][c];
                }}
            }}
        }}
    }}
    {stage}({s}, q, qd, dt, qdd, at_q[{s}], at_qd[{s}]);
    {derivatives}({s}, dt, along, at[{s}]);
}}
"
        )
    }

    /// Locals of the stages beside others, and the call that fills them.
    fn along_with(&self, locals: &str) -> String {
        let Self { t, n, s, .. } = self;
        let (double, triple, all) = (2 * n, 3 * n, s + 1);
        let robot = (!self.module.parameters.is_empty()).then_some("robot");
        let actions = (self.module.spaces.actions() > 0).then_some("actions");
        let passed = robot.into_iter().chain(["q", "qd", "tau"]).chain(actions);
        let passed = passed.chain(["dt", "at_q", "at_qd", "by", "at"]);
        let passed = passed.collect::<Vec<_>>().join(", ");
        let name = self.own("step_along");
        format!(
            "    {t} at_q[{all}][{n}], at_qd[{all}][{n}];
    {t} by[{s}][3][{n}][{n}];
    {t} at[{all}][{double}][{triple}];
    {locals}
    {name}({passed});
"
        )
    }

    pub(super) fn step_derivatives(&self) -> String {
        let Self { n, s, .. } = self;
        let double = 2 * n;
        let along = self.along_with("int k, r, c;");
        format!(
            "{along}    for (k = 0; k < {n}; ++k) {{
        next_q[k] = at_q[{s}][k];
        next_qd[k] = at_qd[{s}][k];
    }}
    for (r = 0; r < {double}; ++r) {{
        for (c = 0; c < {double}; ++c) {{
            a[r][c] = at[{s}][r][c];
        }}
        for (c = 0; c < {n}; ++c) {{
            b[r][c] = at[{s}][r][{double} + c];
        }}
    }}
"
        )
    }

    pub(super) fn step_hessian(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (double, triple) = (2 * n, 3 * n);
        let table = self.of_rates();
        let along = self.along_with(&format!(
            "{t} w[{s}][{n}];
    {t} q_q[{n}][{n}], q_qd[{n}][{n}], qd_qd[{n}][{n}], q_tau[{n}][{n}];
    {t} half[{triple}][{triple}];
    int i, j, k, r, c;"
        ));
        let call = self.call(
            SECOND,
            ["at_q[i]", "at_qd[i]", "w[i]"],
            &["q_q", "q_qd", "qd_qd", "q_tau"],
        );
        format!(
            "{table}{along}    for (r = 0; r < {triple}; ++r) {{
        for (c = 0; c < {triple}; ++c) {{
            hessian[r][c] = 0;
        }}
    }}
    for (i = 0; i < {s}; ++i) {{
        for (k = 0; k < {n}; ++k) {{
            w[i][k] = dt * dt * of_q[{s}][i] * weights[k] + dt * of_qd[{s}][i] * weights[{n} + k];
        }}
    }}
    for (i = {s} - 1; i >= 0; --i) {{
        for (j = 0; j < i; ++j) {{
            const {t} x = dt * dt * of_q[i][j];
            const {t} v = dt * of_qd[i][j];
            for (r = 0; r < {n}; ++r) {{
                for (k = 0; k < {n}; ++k) {{
                    w[j][k] += w[i][r] * (x * by[i][0][r][k] + v * by[i][1][r][k]);
                }}
            }}
        }}
        {call}
        /* The Hessian of the stage times its derivatives. */
        for (r = 0; r < {n}; ++r) {{
            for (c = 0; c < {triple}; ++c) {{
                half[r][c] = c < {double} ? 0 : q_tau[r][c - {double}];
                half[{n} + r][c] = 0;
                half[{double} + r][c] = 0;
            }}
            for (k = 0; k < {n}; ++k) {{
                for (c = 0; c < {triple}; ++c) {{
                    half[r][c] += q_q[r][k] * at[i][k][c] + q_qd[r][k] * at[i][{n} + k][c];
                    half[{n} + r][c] += q_qd[k][r] * at[i][k][c] + qd_qd[r][k] * at[i][{n} + k][c];
                    half[{double} + r][c] += q_tau[k][r] * at[i][k][c];
                }}
            }}
        }}
        for (r = 0; r < {triple}; ++r) {{
            for (k = 0; k < {double}; ++k) {{
                for (c = 0; c < {triple}; ++c) {{
                    hessian[r][c] += at[i][k][r] * half[k][c];
                }}
            }}
        }}
        for (r = 0; r < {n}; ++r) {{
            for (c = 0; c < {triple}; ++c) {{
                hessian[{double} + r][c] += half[{double} + r][c];
            }}
        }}
    }}
"
        )
    }
}

//! Statements of explicit time steps in C.
//!
//! In: [`Explicit`]. Out: bodies of the functions, and the functions of a stage that they share. Derivatives follow the
//! stages. The Hessian of a contraction with weights goes back through them: each q̈ᵢ gets the weights of what depends on
//! it, and adds its own Hessian between the derivatives of its stage.

use super::explicit::{Explicit, START};
use super::rule::Table;
use super::texts::{BOTH, DERIVATIVES, SECOND, VALUE};
use crate::print::c::literals::literal;

impl Explicit<'_> {
    /// The coefficients aᵢⱼ and bᵢⱼ of the rule, as constants.
    fn of_rates(&self) -> String {
        let Table { of_q, of_qd, .. } = self.table;
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
    fn coefficients(&self) -> String {
        let time = self.row(self.table.time);
        let Self { t, s, .. } = self;
        format!(
            "    const {t} time[{}] = {time};\n{}",
            s + 1,
            self.of_rates()
        )
    }

    /// Numbers in braces.
    fn row(&self, row: &[f64]) -> String {
        let entries = row
            .iter()
            .map(|&entry| literal(entry, self.texts.module.scalar));
        format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
    }

    /// State of a stage.
    pub(super) fn stage(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (name, table) = (self.texts.own("stage"), self.coefficients());
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
        let stage = self.texts.own("stage");
        let call = self
            .texts
            .call(VALUE, ["next_q", "next_qd", ""], &["qdd[i]"]);
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

    /// Length of rows that compilers divide into vectors without a rest.
    const fn row_length(&self) -> usize {
        (3 * self.n).next_multiple_of(4)
    }

    /// Derivatives of the state of a stage.
    pub(super) fn stage_derivatives(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (name, table) = (self.texts.own("stage_derivatives"), self.coefficients());
        let (double, row) = (2 * n, self.row_length());
        format!(
            "
/* Derivatives of that state by q, qd and tau of the start. */
HOMOGEN_FN static void {name}(int i, {t} dt, {t} along[{s}][{n}][{row}], {t} at[{double}][{row}])
{{
{table}    int j, k, c;
    for (k = 0; k < {n}; ++k) {{
        {t} position[{row}] = {{0}}, velocity[{row}] = {{0}};
        position[k] = 1;
        position[{n} + k] = time[i] * dt;
        velocity[{n} + k] = 1;
        for (j = 0; j < i; ++j) {{
            const {t} x = dt * dt * of_q[i][j];
            const {t} v = dt * of_qd[i][j];
            for (c = 0; c < {row}; ++c) {{
                position[c] += x * along[j][k][c];
                velocity[c] += v * along[j][k][c];
            }}
        }}
        for (c = 0; c < {row}; ++c) {{
            at[k][c] = position[c];
            at[{n} + k][c] = velocity[c];
        }}
    }}
}}
"
        )
    }

    /// Calls for accelerations and their derivatives by q, qd and tau.
    fn derivatives(&self, state: [&str; 3], results: [&str; 4], indent: &str) -> String {
        if self.texts.has(BOTH) {
            return self.texts.call(BOTH, state, &results);
        }
        let (value, derivatives) = results.split_at(1);
        let value = self.texts.call(VALUE, state, value);
        let derivatives = self.texts.call(DERIVATIVES, state, derivatives);
        format!("{value}\n{indent}{derivatives}")
    }

    /// All stages with their derivatives.
    pub(super) fn step_along(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (double, row, table) = (2 * n, self.row_length(), self.coefficients());
        let further = [
            format!("{t} at_q[{}][{n}]", s + 1),
            format!("{t} at_qd[{}][{n}]", s + 1),
            format!("{t} by[{s}][3][{n}][{n}]"),
            format!("{t} along[{s}][{n}][{row}]"),
        ];
        let (name, parameters) = (
            self.texts.own("step_along"),
            self.texts.parameters(&START, &further),
        );
        let stage = self.texts.own("stage");
        let by = ["qdd[i]", "by[i][0]", "by[i][1]", "by[i][2]"];
        let calls = self.derivatives(["at_q[i]", "at_qd[i]", ""], by, "        ");
        format!(
            "
/* The stages and the end. Derivatives of the accelerations of each stage: `by` by its own q, qd and tau, `along` by those
 * of the start, in the same rows. */
HOMOGEN_FN static void {name}({parameters})
{{
{table}    {t} qdd[{s}][{n}];
    int i, j, k, r, c;
    for (i = 0; i < {s}; ++i) {{
        {stage}(i, q, qd, dt, qdd, at_q[i], at_qd[i]);
        {calls}
        for (r = 0; r < {n}; ++r) {{
            {t} sum[{row}] = {{0}};
            for (c = 0; c < {n}; ++c) {{
                sum[c] = by[i][0][r][c];
                sum[{n} + c] = by[i][1][r][c] + time[i] * dt * by[i][0][r][c];
                sum[{double} + c] = by[i][2][r][c];
            }}
            for (j = 0; j < i; ++j) {{
                const {t} x = dt * dt * of_q[i][j];
                const {t} v = dt * of_qd[i][j];
                if (x == 0 && v == 0) {{
                    continue;
                }}
                for (k = 0; k < {n}; ++k) {{
                    const {t} by_stage = x * by[i][0][r][k] + v * by[i][1][r][k];
                    for (c = 0; c < {row}; ++c) {{
                        sum[c] += by_stage * along[j][k][c];
                    }}
                }}
            }}
            for (c = 0; c < {row}; ++c) {{
                along[i][r][c] = sum[c];
            }}
        }}
    }}
    {stage}({s}, q, qd, dt, qdd, at_q[{s}], at_qd[{s}]);
}}
"
        )
    }

    /// Locals of the stages beside others, and the call that fills them.
    fn along_with(&self, locals: &str) -> String {
        let Self { t, n, s, .. } = self;
        let (row, all) = (self.row_length(), s + 1);
        let robot = (!self.texts.module.parameters.is_empty()).then_some("robot");
        let actions = (self.texts.module.spaces.actions() > 0).then_some("actions");
        let passed = robot.into_iter().chain(["q", "qd", "tau"]).chain(actions);
        let passed = passed.chain(["dt", "at_q", "at_qd", "by", "along"]);
        let passed = passed.collect::<Vec<_>>().join(", ");
        let name = self.texts.own("step_along");
        format!(
            "    {t} at_q[{all}][{n}], at_qd[{all}][{n}];
    {t} by[{s}][3][{n}][{n}];
    {t} along[{s}][{n}][{row}];
    {locals}
    {name}({passed});
"
        )
    }

    /// The derivatives of a rule of one stage, at the start of the step.
    fn derivatives_of_one_stage(&self) -> String {
        let Self { t, n, .. } = self;
        let Table { of_q, of_qd, .. } = self.table;
        let coefficient = |row: &[f64]| literal(row[0], self.texts.module.scalar);
        let (x, v) = (coefficient(of_q[1]), coefficient(of_qd[1]));
        let stage = self.texts.own("stage");
        let results = ["qdd[0]", "dq", "dqd", "dtau"];
        let calls = self.derivatives(["q", "qd", ""], results, "    ");
        format!(
            "    const {t} x = dt * dt * {x};
    const {t} v = dt * {v};
    {t} qdd[1][{n}];
    {t} dq[{n}][{n}], dqd[{n}][{n}], dtau[{n}][{n}];
    int k, c;
    {calls}
    {stage}(1, q, qd, dt, qdd, next_q, next_qd);
    for (k = 0; k < {n}; ++k) {{
        for (c = 0; c < {n}; ++c) {{
            a[k][c] = x * dq[k][c];
            a[k][{n} + c] = x * dqd[k][c];
            a[{n} + k][c] = v * dq[k][c];
            a[{n} + k][{n} + c] = v * dqd[k][c];
            b[k][c] = x * dtau[k][c];
            b[{n} + k][c] = v * dtau[k][c];
        }}
        a[k][k] += 1;
        a[k][{n} + k] += dt;
        a[{n} + k][{n} + k] += 1;
    }}
"
        )
    }

    pub(super) fn step_derivatives(&self) -> String {
        if self.s == 1 {
            return self.derivatives_of_one_stage();
        }
        let Self { t, n, s, .. } = self;
        let (double, row) = (2 * n, self.row_length());
        let derivatives = self.texts.own("stage_derivatives");
        let along = self.along_with(&format!("{t} at[{double}][{row}];\n    int k, r, c;"));
        format!(
            "{along}    {derivatives}({s}, dt, along, at);
    for (k = 0; k < {n}; ++k) {{
        next_q[k] = at_q[{s}][k];
        next_qd[k] = at_qd[{s}][k];
    }}
    for (r = 0; r < {double}; ++r) {{
        for (c = 0; c < {double}; ++c) {{
            a[r][c] = at[r][c];
        }}
        for (c = 0; c < {n}; ++c) {{
            b[r][c] = at[r][{double} + c];
        }}
    }}
"
        )
    }

    pub(super) fn step_hessian(&self) -> String {
        let Self { t, n, s, .. } = self;
        let (double, triple, row) = (2 * n, 3 * n, self.row_length());
        let (table, derivatives) = (self.of_rates(), self.texts.own("stage_derivatives"));
        let along = self.along_with(&format!(
            "{t} w[{s}][{n}];
    {t} q_q[{n}][{n}], q_qd[{n}][{n}], qd_qd[{n}][{n}], q_tau[{n}][{n}];
    {t} half[{double}][{row}];
    {t} all[{triple}][{row}] = {{{{0}}}};
    {t} at[{double}][{row}];
    int i, j, k, r, c;"
        ));
        let call = self.texts.call(
            SECOND,
            ["at_q[i]", "at_qd[i]", "w[i]"],
            &["q_q", "q_qd", "qd_qd", "q_tau"],
        );
        format!(
            "{table}{along}    for (i = 0; i < {s}; ++i) {{
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
        {derivatives}(i, dt, along, at);
        {call}
        /* The Hessian of the stage times its derivatives, and these on the other side. */
        for (r = 0; r < {n}; ++r) {{
            {t} of_q_r[{row}] = {{0}}, of_qd_r[{row}] = {{0}}, of_tau_r[{row}] = {{0}};
            for (c = 0; c < {n}; ++c) {{
                of_q_r[{double} + c] = q_tau[r][c];
            }}
            for (k = 0; k < {n}; ++k) {{
                for (c = 0; c < {row}; ++c) {{
                    of_q_r[c] += q_q[r][k] * at[k][c] + q_qd[r][k] * at[{n} + k][c];
                    of_qd_r[c] += q_qd[k][r] * at[k][c] + qd_qd[r][k] * at[{n} + k][c];
                    of_tau_r[c] += q_tau[k][r] * at[k][c];
                }}
            }}
            for (c = 0; c < {row}; ++c) {{
                half[r][c] = of_q_r[c];
                half[{n} + r][c] = of_qd_r[c];
                all[{double} + r][c] += of_tau_r[c];
            }}
        }}
        for (r = 0; r < {triple}; ++r) {{
            {t} sum[{row}] = {{0}};
            for (k = 0; k < {double}; ++k) {{
                for (c = 0; c < {row}; ++c) {{
                    sum[c] += at[k][r] * half[k][c];
                }}
            }}
            for (c = 0; c < {row}; ++c) {{
                all[r][c] += sum[c];
            }}
        }}
    }}
    for (r = 0; r < {triple}; ++r) {{
        for (c = 0; c < {triple}; ++c) {{
            hessian[r][c] = all[r][c];
        }}
    }}
"
        )
    }
}

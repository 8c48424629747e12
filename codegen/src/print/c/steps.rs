//! Time steps of a robot in C, and their first and second derivatives.
//!
//! In: a [`Module`] with forward dynamics, and a rule. Out: `step`; with derivatives of forward dynamics
//! `step_derivatives`, with its Hessian `step_hessian`.
//!
//! Rules are tables: stage i is at q + cᵢ Δt q̇ + Δt² Σⱼ aᵢⱼ q̈ⱼ with the velocities q̇ + Δt Σⱼ bᵢⱼ q̈ⱼ of the stages j
//! before it, and the row after the last stage is the end of the step. Derivatives follow the stages. The Hessian of a
//! contraction with weights goes back through them: each q̈ᵢ gets the weights of what depends on it, and adds its own
//! Hessian between the derivatives of its stage.

use std::fmt::Write;

use super::comments::comment;
use super::declarations::{argument_lengths, declarator, number};
use super::literals::literal;
use super::names::{own, symbols};
use crate::function::Function;
use crate::module::{DataMotion, Module};
use crate::request::Integrator;
use crate::space::{Space, Variable};

/// Message and hint if a module cannot have steps, or not those that acados needs.
///
/// # Errors
/// If coordinates are not added, loops are closed, functions are missing, or acados cannot pass what they take.
pub fn check(module: &Module, acados: bool) -> Result<(), [String; 2]> {
    let mut motions = module.data.motions.iter().zip(&module.data.names);
    let manifold = motions.find(|(motion, _)| matches!(motion, DataMotion::Manifold(_)));
    if let Some((_, name)) = manifold {
        return Err([
            format!("`steps` needs coordinates that are added, and joint `{name}` has others"),
            "leave it out; `homogen::step` in Rust and `step` in Python have such steps".to_owned(),
        ]);
    }
    if module.spaces.len(Space::Constraints) > 0 {
        return Err([
            "`steps` is not for robots with loops, which a step would open".to_owned(),
            "leave it out, or leave out the loops".to_owned(),
        ]);
    }
    let needed = [
        (index(module, VALUE).is_some(), Function::ForwardDynamics),
        (
            !acados || has_derivatives(module),
            Function::ForwardDynamicsDerivatives,
        ),
    ];
    if let Some((_, function)) = needed.into_iter().find(|(has, _)| !has) {
        let name = function.name();
        let option = if acados { "acados" } else { "steps" };
        return Err([
            format!("`{option}` needs the function {name}"),
            format!("add {name} to the functions, by itself"),
        ]);
    }
    let passed = [
        (!module.parameters.is_empty(), "fields"),
        (module.spaces.actions() > 0, "external wrenches"),
    ];
    match passed.into_iter().find(|(has, _)| acados && *has) {
        None => Ok(()),
        Some((_, what)) => Err([
            format!("`acados` has no place for {what}"),
            format!("leave out the {what}, or call the steps from functions of your own"),
        ]),
    }
}

/// Items that steps call.
const VALUE: &[Function] = &[Function::ForwardDynamics];
const DERIVATIVES: &[Function] = &[Function::ForwardDynamicsDerivatives];
const SECOND: &[Function] = &[Function::ForwardDynamicsHessian];
/// Both at once, in place of the first two where derivatives are computed.
const BOTH: &[Function] = &[
    Function::ForwardDynamics,
    Function::ForwardDynamicsDerivatives,
];

/// Index of an item.
fn index(module: &Module, item: &[Function]) -> Option<usize> {
    let mut functions = module.functions.iter();
    functions.position(|generated| generated.functions == item)
}

/// True if steps have derivatives.
pub(super) fn has_derivatives(module: &Module) -> bool {
    [DERIVATIVES, BOTH]
        .into_iter()
        .any(|item| index(module, item).is_some())
}

/// True if steps have a Hessian.
pub(super) fn has_hessian(module: &Module) -> bool {
    has_derivatives(module) && index(module, SECOND).is_some()
}

/// Coefficients of a rule.
struct Table {
    /// cᵢ.
    time: Vec<f64>,
    /// aᵢⱼ.
    of_q: Vec<Vec<f64>>,
    /// bᵢⱼ.
    of_qd: Vec<Vec<f64>>,
}

impl Table {
    fn of(rule: Integrator) -> Self {
        let (time, of_q, of_qd): (&[f64], &[&[f64]], &[&[f64]]) = match rule {
            Integrator::SemiImplicit => (&[0.0, 1.0], &[&[0.0], &[1.0]], &[&[0.0], &[1.0]]),
            Integrator::Euler => (&[0.0, 1.0], &[&[0.0], &[0.0]], &[&[0.0], &[1.0]]),
            Integrator::Rk4 => {
                const SIXTH: f64 = 1.0 / 6.0;
                const THIRD: f64 = 1.0 / 3.0;
                (
                    &[0.0, 0.5, 0.5, 1.0, 1.0],
                    &[
                        &[0.0, 0.0, 0.0, 0.0],
                        &[0.0, 0.0, 0.0, 0.0],
                        &[0.25, 0.0, 0.0, 0.0],
                        &[0.0, 0.5, 0.0, 0.0],
                        &[SIXTH, SIXTH, SIXTH, 0.0],
                    ],
                    &[
                        &[0.0, 0.0, 0.0, 0.0],
                        &[0.5, 0.0, 0.0, 0.0],
                        &[0.0, 0.5, 0.0, 0.0],
                        &[0.0, 0.0, 1.0, 0.0],
                        &[SIXTH, THIRD, THIRD, SIXTH],
                    ],
                )
            }
        };
        let rows = |rows: &[&[f64]]| rows.iter().map(|row| row.to_vec()).collect();
        Self {
            time: time.to_vec(),
            of_q: rows(of_q),
            of_qd: rows(of_qd),
        }
    }
}

/// Facts that all texts need.
struct Texts<'m> {
    module: &'m Module,
    prefix: &'m str,
    rule: Integrator,
    /// The scalar type.
    t: &'static str,
    /// Number of velocities.
    n: usize,
    /// Number of stages.
    s: usize,
}

impl<'m> Texts<'m> {
    fn of(module: &'m Module, prefix: &'m str, rule: Integrator) -> Self {
        Self {
            module,
            prefix,
            rule,
            t: number(module.scalar),
            n: module.spaces.len(Space::Velocities),
            s: Table::of(rule).time.len() - 1,
        }
    }

    fn own(&self, name: &str) -> String {
        own(self.prefix, name)
    }

    fn has(&self, item: &[Function]) -> bool {
        index(self.module, item).is_some()
    }

    /// `const arm_robot *robot, const double q[2], … , double dt`, and further parameters.
    fn parameters(&self, further: &[String]) -> String {
        let Self { t, n, .. } = self;
        let robot = (!self.module.parameters.is_empty())
            .then(|| format!("const {} *robot", self.own("robot")));
        let state = ["q", "qd", "tau"].map(|name| format!("const {t} {name}[{n}]"));
        let actions = (self.module.spaces.actions() > 0).then(|| {
            let lengths = argument_lengths(Variable::Actions, &self.module.spaces);
            format!("const {t} {}", declarator("actions", &lengths))
        });
        let all = robot.into_iter().chain(state).chain(actions);
        let all = all.chain([format!("{t} dt")]).chain(further.to_vec());
        all.collect::<Vec<_>>().join(", ")
    }

    /// A call of an item at a stage, with its results.
    fn call(&self, item: &[Function], names: [&str; 3], results: &[&str]) -> String {
        let Some(index) = index(self.module, item) else {
            return String::new();
        };
        let [q, qd, weights] = names;
        let robot = (!self.module.parameters.is_empty()).then_some("robot");
        let arguments = self.module.functions[index].arguments(&self.module.spaces);
        let arguments = arguments.into_iter().map(|argument| match argument {
            Variable::Q => q,
            Variable::Qd => qd,
            Variable::Weights => weights,
            other => other.name(),
        });
        let all = robot
            .into_iter()
            .chain(arguments)
            .chain(results.iter().copied());
        let symbol = &symbols(self.module, self.prefix)[index];
        format!("{symbol}({});", all.collect::<Vec<_>>().join(", "))
    }
}

/// Declarations with their comments.
pub(super) fn declarations(module: &Module, prefix: &str, rule: Integrator) -> String {
    let texts = Texts::of(module, prefix, rule);
    let mut text = String::new();
    for (about, head) in heads(&texts) {
        text.push_str(&comment(&about));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "HOMOGEN_FN void {head};\n");
    }
    text
}

/// Comments and heads of the functions that there are.
fn heads(texts: &Texts<'_>) -> Vec<(Vec<String>, String)> {
    let Texts { t, n, .. } = texts;
    let rule = match texts.rule {
        Integrator::SemiImplicit => "qd+ = qd + dt qdd, q+ = q + dt qd+",
        Integrator::Euler => "qd+ = qd + dt qdd, q+ = q + dt qd",
        Integrator::Rk4 => "the classical rule of Runge and Kutta, of order 4",
    };
    let lines = |lines: &[&str]| lines.iter().map(|&line| line.to_owned()).collect();
    let about = format!("State after dt [s] under constant tau: {rule}.");
    let (double, triple) = (2 * n, 3 * n);
    let mut heads = vec![(
        vec![about],
        format!(
            "{}({})",
            texts.own("step"),
            texts.parameters(&[format!("{t} next_q[{n}]"), format!("{t} next_qd[{n}]")])
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
                texts.parameters(&[
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
                texts.parameters(&[
                    format!("const {t} weights[{double}]"),
                    format!("{t} hessian[{triple}][{triple}]")
                ])
            ),
        ));
    }
    heads
}

/// Definitions.
pub(super) fn definitions(module: &Module, prefix: &str, rule: Integrator) -> String {
    let texts = Texts::of(module, prefix, rule);
    let mut text = texts.stage();
    let bodies = [texts.step(), texts.step_derivatives(), texts.step_hessian()];
    for (k, ((_, head), body)) in heads(&texts).into_iter().zip(bodies).enumerate() {
        if k == 1 {
            text.push_str(&texts.stage_derivatives());
            text.push_str(&texts.step_along());
        }
        // Writing to a string cannot fail.
        let _ = write!(text, "\nHOMOGEN_FN void {head}\n{{\n{body}}}\n");
    }
    text
}

impl Texts<'_> {
    /// The coefficients aᵢⱼ and bᵢⱼ of the rule, as constants.
    fn of_rates(&self) -> String {
        let Table { of_q, of_qd, .. } = Table::of(self.rule);
        let rows = |rows: &[Vec<f64>]| {
            let rows = rows.iter().map(|row| self.row(row));
            format!("{{{}}}", rows.collect::<Vec<_>>().join(", "))
        };
        let Self { t, s, .. } = self;
        let all = s + 1;
        format!(
            "    const {t} of_q[{all}][{s}] = {};
    const {t} of_qd[{all}][{s}] = {};
",
            rows(&of_q),
            rows(&of_qd)
        )
    }

    /// All coefficients of the rule.
    fn table(&self) -> String {
        let time = self.row(&Table::of(self.rule).time);
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
    fn stage(&self) -> String {
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

    fn step(&self) -> String {
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
    fn stage_derivatives(&self) -> String {
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
    fn step_along(&self) -> String {
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

    fn step_derivatives(&self) -> String {
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

    fn step_hessian(&self) -> String {
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

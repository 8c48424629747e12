//! Time steps of a robot in C, and their first and second derivatives.
//!
//! In: a [`Module`] with forward dynamics, and a rule. Out: `step`; with derivatives of forward dynamics
//! `step_derivatives`, with its Hessian `step_hessian`.

mod bodies;
mod rule;

use std::fmt::Write;

use self::rule::Table;
use super::comments::comment;
use super::declarations::{argument_lengths, declarator, number};
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
            s: Table::of(rule).stages(),
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
        // Derivatives of one stage alone are at the start.
        if k == 1 && (texts.s > 1 || has_hessian(module)) {
            text.push_str(&texts.stage_derivatives());
            text.push_str(&texts.step_along());
        }
        // Writing to a string cannot fail.
        let _ = write!(text, "\nHOMOGEN_FN void {head}\n{{\n{body}}}\n");
    }
    text
}

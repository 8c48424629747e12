//! Facts that the texts of all time steps need.
//!
//! In: a [`Module`] and a prefix. Out: names, parameters, and calls of the functions of a module that steps are made of.

use crate::function::Function;
use crate::module::Module;
use crate::print::c::declarations::{argument_lengths, declarator, number};
use crate::print::c::names::{own, symbols};
use crate::space::{Space, Variable};

/// Comment of a function, and what stands between its `void` and its body.
pub(super) type Head = (Vec<String>, String);

/// Definition of a function.
pub(super) fn definition(head: &str, body: &str) -> String {
    format!("\nHOMOGEN_FN void {head}\n{{\n{body}}}\n")
}

/// Items that steps call.
pub(super) const INVERSE: &[Function] = &[Function::InverseDynamics];
pub(super) const INVERSE_DERIVATIVES: &[Function] = &[Function::InverseDynamicsDerivatives];
pub(super) const MASS: &[Function] = &[Function::MassMatrix];
pub(super) const VALUE: &[Function] = &[Function::ForwardDynamics];
pub(super) const DERIVATIVES: &[Function] = &[Function::ForwardDynamicsDerivatives];
pub(super) const SECOND: &[Function] = &[Function::ForwardDynamicsHessian];
/// Both at once, in place of the first two where derivatives are computed.
pub(super) const BOTH: &[Function] = &[
    Function::ForwardDynamics,
    Function::ForwardDynamicsDerivatives,
];

/// Index of an item.
pub(super) fn index(module: &Module, item: &[Function]) -> Option<usize> {
    let mut functions = module.functions.iter();
    functions.position(|generated| generated.functions == item)
}

/// True if steps have derivatives.
pub(in crate::print::c) fn has_derivatives(module: &Module) -> bool {
    [DERIVATIVES, BOTH]
        .into_iter()
        .any(|item| index(module, item).is_some())
}

/// True if steps have a Hessian.
pub(in crate::print::c) fn has_hessian(module: &Module) -> bool {
    has_derivatives(module) && index(module, SECOND).is_some()
}

/// Facts that all texts need.
pub(super) struct Texts<'m> {
    pub module: &'m Module,
    prefix: &'m str,
    /// The scalar type.
    pub t: &'static str,
    /// Number of velocities.
    pub n: usize,
}

impl<'m> Texts<'m> {
    pub fn of(module: &'m Module, prefix: &'m str) -> Self {
        Self {
            module,
            prefix,
            t: number(module.scalar),
            n: module.spaces.len(Space::Velocities),
        }
    }

    pub fn own(&self, name: &str) -> String {
        own(self.prefix, name)
    }

    pub fn has(&self, item: &[Function]) -> bool {
        index(self.module, item).is_some()
    }

    /// `const arm_robot *robot, const double q[2], … , double dt` of vectors with these names, and further parameters.
    pub fn parameters(&self, vectors: &[&str], further: &[String]) -> String {
        let Self { t, n, .. } = self;
        let robot = (!self.module.parameters.is_empty())
            .then(|| format!("const {} *robot", self.own("robot")));
        let state = vectors.iter().map(|name| format!("const {t} {name}[{n}]"));
        let actions = (self.module.spaces.actions() > 0).then(|| {
            let lengths = argument_lengths(Variable::Actions, &self.module.spaces);
            format!("const {t} {}", declarator("actions", &lengths))
        });
        let all = robot.into_iter().chain(state).chain(actions);
        let all = all.chain([format!("{t} dt")]).chain(further.to_vec());
        all.collect::<Vec<_>>().join(", ")
    }

    /// A call of an item, with its results. Names are those of q, of q̇, and of q̈ or weights.
    pub fn call(&self, item: &[Function], names: [&str; 3], results: &[&str]) -> String {
        let Some(index) = index(self.module, item) else {
            return String::new();
        };
        let [q, qd, third] = names;
        let robot = (!self.module.parameters.is_empty()).then_some("robot");
        let arguments = self.module.functions[index].arguments(&self.module.spaces);
        let arguments = arguments.into_iter().map(|argument| match argument {
            Variable::Q => q,
            Variable::Qd => qd,
            Variable::Qdd | Variable::Weights => third,
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

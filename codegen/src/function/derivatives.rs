//! Generated derivatives: which results of other functions are the derivatives of a function.
//!
//! In: a [`Function`]. Out: its [`Derivatives`], for interfaces that hand functions to solvers with their derivatives.
//! An argument of the other function that the function does not have is zero: gravity is inverse dynamics at rest.

use super::Function;
use crate::space::Variable;

/// Results that are the derivatives of a function.
#[derive(Clone, Copy, Debug)]
pub struct Derivatives {
    /// The function.
    pub of: Function,
    /// Derivatives by its arguments: a row for each entry of its result; a gradient where the result is a number.
    pub first: &'static [First],
    /// The transposed matrices of these times [`Variable::Weights`], of a function that builds no matrix; empty if there
    /// is none, or if it costs more.
    pub products: &'static [First],
    /// Blocks of the second derivatives of its result, contracted with weights; those that are not here are zero, or
    /// the transpose of one that is here. Empty if there is no such function.
    pub second: &'static [Second],
}

/// Derivative by an argument.
#[derive(Clone, Copy, Debug)]
pub struct First {
    /// The argument.
    pub by: Variable,
    /// The function that has it among its results.
    pub function: Function,
    /// Index of the result.
    pub part: usize,
}

/// Second derivative of the result multiplied by [`Variable::Weights`].
#[derive(Clone, Copy, Debug)]
pub struct Second {
    /// The arguments, of rows and of columns.
    pub by: [Variable; 2],
    /// The function that has it among its results.
    pub function: Function,
    /// Index of the result.
    pub part: usize,
}

const fn first(by: Variable, function: Function, part: usize) -> First {
    First { by, function, part }
}

const fn second(rows: Variable, columns: Variable, function: Function, part: usize) -> Second {
    Second {
        by: [rows, columns],
        function,
        part,
    }
}

use Function::{
    CenterOfMassJacobian, ConstraintJacobian, DistanceJacobian, ForwardDynamicsDerivatives,
    ForwardDynamicsHessian, ForwardDynamicsVjp, GravityDerivative, InverseDynamicsDerivatives,
    InverseDynamicsHessian, InverseDynamicsVjp, MassMatrix,
};
use Variable::{Q, Qd, Qdd, Tau};

const ALL: [Derivatives; 8] = [
    Derivatives {
        of: Function::InverseDynamics,
        first: &[
            first(Q, InverseDynamicsDerivatives, 0),
            first(Qd, InverseDynamicsDerivatives, 1),
            first(Qdd, MassMatrix, 0),
        ],
        products: &[
            first(Q, InverseDynamicsVjp, 0),
            first(Qd, InverseDynamicsVjp, 1),
            first(Qdd, InverseDynamicsVjp, 2),
        ],
        second: &[
            second(Q, Q, InverseDynamicsHessian, 0),
            second(Q, Qd, InverseDynamicsHessian, 1),
            second(Qd, Qd, InverseDynamicsHessian, 2),
            second(Q, Qdd, InverseDynamicsHessian, 3),
        ],
    },
    Derivatives {
        of: Function::Bias,
        first: &[
            first(Q, InverseDynamicsDerivatives, 0),
            first(Qd, InverseDynamicsDerivatives, 1),
        ],
        products: &[
            first(Q, InverseDynamicsVjp, 0),
            first(Qd, InverseDynamicsVjp, 1),
        ],
        second: &[
            second(Q, Q, InverseDynamicsHessian, 0),
            second(Q, Qd, InverseDynamicsHessian, 1),
            second(Qd, Qd, InverseDynamicsHessian, 2),
        ],
    },
    Derivatives {
        of: Function::Gravity,
        first: &[first(Q, GravityDerivative, 0)],
        products: &[],
        second: &[second(Q, Q, InverseDynamicsHessian, 0)],
    },
    Derivatives {
        of: Function::ForwardDynamics,
        first: &[
            first(Q, ForwardDynamicsDerivatives, 0),
            first(Qd, ForwardDynamicsDerivatives, 1),
            first(Tau, ForwardDynamicsDerivatives, 2),
        ],
        products: &[
            first(Q, ForwardDynamicsVjp, 0),
            first(Qd, ForwardDynamicsVjp, 1),
            first(Tau, ForwardDynamicsVjp, 2),
        ],
        second: &[
            second(Q, Q, ForwardDynamicsHessian, 0),
            second(Q, Qd, ForwardDynamicsHessian, 1),
            second(Qd, Qd, ForwardDynamicsHessian, 2),
            second(Q, Tau, ForwardDynamicsHessian, 3),
        ],
    },
    Derivatives {
        of: Function::PotentialEnergy,
        first: &[first(Q, Function::Gravity, 0)],
        products: &[],
        second: &[],
    },
    Derivatives {
        of: Function::CenterOfMass,
        first: &[first(Q, CenterOfMassJacobian, 0)],
        products: &[],
        second: &[],
    },
    Derivatives {
        of: Function::Constraint,
        first: &[first(Q, ConstraintJacobian, 0)],
        products: &[],
        second: &[],
    },
    Derivatives {
        of: Function::Distances,
        first: &[first(Q, DistanceJacobian, 0)],
        products: &[],
        second: &[],
    },
];

impl Function {
    /// Its generated derivatives; `None` if there are none.
    #[must_use]
    pub fn derivatives(self) -> Option<&'static Derivatives> {
        ALL.iter().find(|derivatives| derivatives.of == self)
    }
}

#[cfg(test)]
mod tests {
    use super::ALL;
    use crate::space::{Space, Variable};

    /// Every argument has a derivative, and every block the sizes of its arguments.
    #[test]
    fn blocks_range_over_the_result_and_the_arguments() {
        for derivatives in &ALL {
            let of = derivatives.of;
            let by: Vec<Variable> = derivatives.first.iter().map(|first| first.by).collect();
            assert_eq!(by, of.arguments(), "{}", of.name());
            let products = derivatives.products.iter().map(|product| product.by);
            let products: Vec<Variable> = products.collect();
            assert!(products.is_empty() || products == by, "{}", of.name());
            for second in derivatives.second {
                let (_, quantity) = second.function.result().parts().nth(second.part).unwrap();
                assert_eq!(quantity.over, [Space::Velocities; 2], "{}", of.name());
                assert!(second.by.iter().all(|by| of.arguments().contains(by)));
                assert!(second.function.arguments().contains(&Variable::Weights));
            }
        }
    }
}

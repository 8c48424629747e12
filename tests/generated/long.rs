//! Functions whose code is as long as that of all others together: second derivatives, gradients and changes.

use homogen_codegen::Function;

/// The functions, which some tests leave out.
pub const LONG: [Function; 7] = [
    Function::InverseDynamicsVjp,
    Function::InverseDynamicsJvp,
    Function::InverseDynamicsHessian,
    Function::ForwardDynamicsParameterDerivatives,
    Function::ForwardDynamicsVjp,
    Function::ForwardDynamicsJvp,
    Function::ForwardDynamicsHessian,
];

//! Test vectors and origins of inertial numbers, for the reviewer of a generated file.

use crate::space::Variable;

/// Material for the reviewer of a generated file.
#[derive(Clone, Debug, Default)]
pub struct Review {
    /// Test vectors.
    pub vectors: Vec<TestVector>,
    /// Origins of inertial numbers, for each layout of the frames.
    pub origins: Vec<Origins>,
    /// Merged links, and the link whose body each became part of.
    pub merged: Vec<(String, String)>,
}

/// Test vector: expected results of a function at a state, computed without its program.
#[derive(Clone, Debug)]
pub struct TestVector {
    /// Index of the function in the module.
    pub function: usize,
    /// Arguments, rounded to the scalar type.
    pub arguments: Vec<(Variable, Vec<f64>)>,
    /// Fields, in the order of the module.
    pub fields: Vec<Vec<f64>>,
    /// Expected results.
    pub expected: Vec<f64>,
    /// Allowed error of each result.
    pub tolerances: Vec<f64>,
}

/// Origins of the inertial numbers in one layout of the frames.
#[derive(Clone, Debug)]
pub struct Origins {
    /// Names of the functions with this layout.
    pub functions: Vec<String>,
    /// Bodies with inertial numbers: name of the link, and numbers.
    pub bodies: Vec<(String, Vec<Sum>)>,
}

/// Entry of a pseudo-inertia as a sum of parameters of links.
#[derive(Clone, Debug)]
pub struct Sum {
    /// Entry: `J_xx`, `q_x`, `m`.
    pub entry: &'static str,
    /// Value by the description [kg, kg m, kg m²].
    pub value: f64,
    /// Parameters with their factors; empty if the sum is not resolved.
    pub terms: Vec<(f64, String)>,
}

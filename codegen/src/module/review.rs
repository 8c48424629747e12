//! What the reviewer of a file reads beside its code.

use crate::space::Variable;

/// What the reviewer of a file wants to see beside its code.
#[derive(Clone, Debug, Default)]
pub struct Review {
    /// What functions should return.
    pub vectors: Vec<Vector>,
    /// Where inertial numbers come from, for each layout of the frames.
    pub origins: Vec<Origins>,
    /// The links that became part of the body of another, and that other.
    pub merged: Vec<(String, String)>,
}

/// What a function should return at a state, found without its program.
#[derive(Clone, Debug)]
pub struct Vector {
    /// Its place in the module.
    pub function: usize,
    /// Its arguments, in the type of number.
    pub arguments: Vec<(Variable, Vec<f64>)>,
    /// The fields, in the order of the module.
    pub fields: Vec<Vec<f64>>,
    /// The numbers of its results.
    pub expected: Vec<f64>,
    /// How far each may be off.
    pub tolerances: Vec<f64>,
}

/// Where the inertial numbers of bodies come from whose frames stand in one way.
#[derive(Clone, Debug)]
pub struct Origins {
    /// The functions that have them, by name.
    pub functions: Vec<String>,
    /// The bodies that have any: the link that each is, and its numbers.
    pub bodies: Vec<(String, Vec<Sum>)>,
}

/// An entry of a J as a sum of parameters of links.
#[derive(Clone, Debug)]
pub struct Sum {
    /// The entry: `J_xx`, `q_x`, `m`.
    pub entry: &'static str,
    /// What it is described as [kg, kg m, kg m²].
    pub value: f64,
    /// The parameters, each with its factor; none where they are not told apart.
    pub terms: Vec<(f64, String)>,
}

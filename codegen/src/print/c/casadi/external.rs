//! A function of `CasADi`: inputs, outputs, and calls of generated functions.

use super::matrix::SparseMatrix;
use crate::module::Module;
use crate::print::c::declarations::argument_lengths;
use crate::space::Variable;

/// An input or an output.
#[derive(Clone, Debug)]
pub(super) struct Port {
    pub name: String,
    pub matrix: SparseMatrix,
}

/// A function of `CasADi`.
#[derive(Clone, Debug)]
pub(super) struct External {
    pub name: String,
    /// Arguments of the robot's function, which are the first inputs.
    pub arguments: Vec<Variable>,
    /// Their names and shapes.
    pub inputs: Vec<Port>,
    /// The fields, which follow them.
    pub fields: Option<Port>,
    /// Inputs of derivatives: results of the function, and weights.
    pub further: Vec<Port>,
    /// Index of the input with the weights of the result, and their matrix.
    pub seeds: Option<(usize, SparseMatrix)>,
    pub outputs: Vec<Port>,
    /// Calls of generated functions, and what is stored of their results.
    pub calls: Vec<FunctionCall>,
}

/// Call of a generated function.
#[derive(Clone, Debug)]
pub(super) struct FunctionCall {
    /// Index of the generated function.
    pub function: usize,
    /// Index of an output, index of the result that it needs, and what is stored.
    pub stores: Vec<(usize, usize, Store)>,
}

/// The part of a result that is stored.
#[derive(Clone, Debug)]
pub(super) enum Store {
    /// Its entries.
    Entries(SparseMatrix),
    /// The transposed matrix times the weights.
    Adjoint(SparseMatrix),
}

/// Input for an argument: a column, or a row for each wrench.
pub(super) fn input(variable: Variable, module: &Module) -> Port {
    let matrix = match *argument_lengths(variable, &module.spaces) {
        [rows, columns] => SparseMatrix::full(rows, columns),
        _ => SparseMatrix::full(module.spaces.len(variable.space()), 1),
    };
    Port {
        name: variable.name().to_owned(),
        matrix,
    }
}

impl External {
    /// Input for the fields: a column of their numbers.
    pub fn fields(module: &Module) -> Option<Port> {
        let fields = module.parameters.iter();
        let count = fields.map(|field| field.target.entries()).sum::<usize>();
        (count > 0).then(|| Port {
            name: "p".to_owned(),
            matrix: SparseMatrix::full(count, 1),
        })
    }

    /// All inputs, in order.
    pub fn all_inputs(&self) -> impl Iterator<Item = &Port> {
        let inputs = self.inputs.iter().chain(&self.fields);
        inputs.chain(&self.further)
    }

    /// Number of inputs.
    pub fn count_inputs(&self) -> usize {
        self.all_inputs().count()
    }

    /// Stores an output from a result of a generated function: its index, that of the result, and what is stored. An
    /// output without entries is not stored.
    pub fn store(&mut self, function: usize, stored: (usize, usize, Store)) {
        if matches!(&stored.2, Store::Entries(matrix) if matrix.entries.is_empty()) {
            return;
        }
        match self.calls.iter_mut().find(|call| call.function == function) {
            Some(call) => call.stores.push(stored),
            None => self.calls.push(FunctionCall {
                function,
                stores: vec![stored],
            }),
        }
    }
}

//! Functions of `CasADi` that are derivatives of another.
//!
//! In: a function, and the generated functions that have its derivatives among their results. Out: its Jacobian, the
//! product of the transposed Jacobian with weights, and the Jacobian of that product; or the reason why there are none.

use super::external::{External, Port, Store};
use super::matrix::SparseMatrix;
use crate::function::{Derivatives, Function};
use crate::module::{GeneratedFunction, Module};
use crate::print::steps::ConfigurationFunction;
use crate::space::{Quantity, Variable};
use crate::wording::{code, list};

/// Block of derivatives.
struct DerivativeBlock {
    /// Index of the generated function, and of its result.
    place: (usize, usize),
    matrix: SparseMatrix,
}

/// The Jacobian, by arguments and fields.
pub(super) fn jacobian(module: &Module, of: usize, function: &External) -> Option<External> {
    let (blocks, out) = (first(module, of).ok()?, &function.outputs[0]);
    let mut derived = Derived::of("jac", function);
    for (by, block) in function.inputs.iter().zip(blocks) {
        let name = format!("jac_{}_{}", out.name, by.name);
        derived.entries(name, block.place, in_rows_of(&out.matrix, block.matrix));
    }
    if let Some(fields) = &function.fields {
        let name = format!("jac_{}_{}", out.name, fields.name);
        derived.zero(name, out, fields);
    }
    Some(derived.external)
}

/// The transposed Jacobian times weights.
pub(super) fn adjoint(module: &Module, of: usize, function: &External) -> Option<External> {
    let mut derived = Derived::of("adj1", function);
    derived.weigh(function);
    let stores: Vec<((usize, usize), Store)> = if let Some(places) = products(module, of) {
        let sizes = function.inputs.iter().map(|by| by.matrix.size());
        let vectors = sizes.map(|size| Store::Entries(SparseMatrix::full(size, 1)));
        places.into_iter().zip(vectors).collect()
    } else {
        let out = &function.outputs[0].matrix;
        let blocks = first(module, of).ok()?.into_iter();
        let matrices =
            blocks.map(|block| (block.place, Store::Adjoint(in_rows_of(out, block.matrix))));
        matrices.collect()
    };
    for (by, store) in function.inputs.iter().zip(stores) {
        let matrix = SparseMatrix::full(by.matrix.size(), 1);
        derived.push(format!("adj_{}", by.name), matrix, store);
    }
    if let Some(Port { name, matrix }) = &function.fields {
        let matrix = SparseMatrix::zero(matrix.rows, matrix.columns);
        derived.external.outputs.push(Port {
            name: format!("adj_{name}"),
            matrix,
        });
    }
    Some(derived.external)
}

/// The Jacobian of the transposed Jacobian times weights: by arguments the second derivatives, by weights the transposed
/// Jacobian.
pub(super) fn adjoint_jacobian(
    module: &Module,
    of: usize,
    function: &External,
) -> Option<External> {
    let (blocks, adjoint) = (first(module, of).ok()?, adjoint(module, of, function)?);
    let [function_alone] = *module.functions[of].functions else {
        return None;
    };
    let derivatives = function_alone.derivatives()?;
    let mut derived = Derived::of("jac", &adjoint);
    let second = |rows: Variable, columns: Variable| {
        let mut all = derivatives.second.iter();
        let found = all.find(|block| block.by == [rows, columns] || block.by == [columns, rows])?;
        let (place, quantity) = place(module, derivatives, (found.function, found.part))?;
        let matrix = of_result(module, place, &quantity);
        let is_given = found.by == [rows, columns];
        let matrix = if is_given {
            matrix
        } else {
            matrix.transposed()
        };
        Some(DerivativeBlock { place, matrix })
    };
    let needed = derivatives.second.iter().map(|block| block.function);
    let mut has = needed.map(|function| provider(module, derivatives, function).is_some());
    if derivatives.second.is_empty() || !has.all(|has| has) {
        return None;
    }
    let all = function.inputs.iter().zip(&function.arguments).zip(blocks);
    for ((rows, variable), block) in all {
        let name = |by: &Port| format!("jac_adj_{}_{}", rows.name, by.name);
        for (columns, by) in function.inputs.iter().zip(&function.arguments) {
            match second(*variable, *by) {
                Some(block) => derived.entries(name(columns), block.place, block.matrix),
                None => derived.zero(name(columns), rows, columns),
            }
        }
        if let Some(fields) = &function.fields {
            derived.zero(name(fields), rows, fields);
        }
        let [out, weights] = &*adjoint.further else {
            return None;
        };
        derived.zero(name(out), rows, out);
        let jacobian = in_rows_of(&function.outputs[0].matrix, block.matrix);
        derived.entries(name(weights), block.place, jacobian.transposed());
    }
    if let Some(fields) = &function.fields {
        let inputs = function.inputs.iter().chain(&function.fields);
        for by in inputs.chain(&adjoint.further) {
            let name = format!("jac_adj_{}_{}", fields.name, by.name);
            derived.zero(name, fields, by);
        }
    }
    Some(derived.external)
}

/// The reason why a function has no derivatives, of one whose derivatives can be generated.
pub(super) fn without_derivatives(module: &Module, of: usize) -> Option<String> {
    first(module, of).err().flatten()
}

/// A function in the making.
struct Derived {
    external: External,
}

impl Derived {
    /// Function with the inputs of another and its outputs.
    fn of(kind: &str, function: &External) -> Self {
        let out = |port: &Port| Port {
            name: format!("out_{}", port.name),
            matrix: SparseMatrix::zero(port.matrix.rows, port.matrix.columns),
        };
        let mut external = External {
            name: format!("{kind}_{}", function.name),
            outputs: Vec::new(),
            calls: Vec::new(),
            ..function.clone()
        };
        external.further.extend(function.outputs.iter().map(out));
        Self { external }
    }

    /// Adds the weights of the outputs as an input.
    fn weigh(&mut self, function: &External) {
        let [Port { name, matrix }] = &*function.outputs else {
            return;
        };
        self.external.seeds = Some((self.external.count_inputs(), matrix.clone()));
        self.external.further.push(Port {
            name: format!("adj_{name}"),
            matrix: matrix.clone(),
        });
    }

    /// Adds an output with the entries of a result.
    fn entries(&mut self, name: String, place: (usize, usize), matrix: SparseMatrix) {
        let store = Store::Entries(matrix.clone());
        self.push(name, matrix, (place, store));
    }

    /// Adds an output without entries.
    fn zero(&mut self, name: String, rows: &Port, columns: &Port) {
        let matrix = SparseMatrix::zero(rows.matrix.size(), columns.matrix.size());
        self.external.outputs.push(Port { name, matrix });
    }

    fn push(
        &mut self,
        name: String,
        matrix: SparseMatrix,
        ((function, result), store): ((usize, usize), Store),
    ) {
        let output = self.external.outputs.len();
        self.external.outputs.push(Port { name, matrix });
        self.external.store(function, (output, result, store));
    }
}

/// The row of derivatives of a function. The error is the reason why they are not its derivatives by coordinates, if there
/// is a row.
fn row(module: &Module, of: usize) -> Result<&'static Derivatives, Option<String>> {
    let generated = &module.functions[of];
    let [function] = *generated.functions else {
        return Err(None);
    };
    let derivatives = function.derivatives().ok_or(None)?;
    if !ConfigurationFunction::of(module).is_empty() {
        let why =
            "q has coordinates that are not added, and generated derivatives are along velocities";
        return Err(Some(why.to_owned()));
    }
    let arguments = generated.arguments(&module.spaces);
    if arguments.contains(&Variable::Actions) {
        return Err(Some("none is generated by external wrenches".to_owned()));
    }
    Ok(derivatives)
}

/// The results that are the transposed derivatives by each argument times weights; `None` if they are not generated.
fn products(module: &Module, of: usize) -> Option<Vec<(usize, usize)>> {
    let derivatives = row(module, of).ok()?;
    let places = (derivatives.products.iter()).map(|product| {
        let (place, _) = place(module, derivatives, (product.function, product.part))?;
        Some(place)
    });
    let places = places.collect::<Option<Vec<_>>>()?;
    (!places.is_empty()).then_some(places)
}

/// The derivatives by each argument. The error is the reason why there are none, if the function has a row of
/// derivatives.
fn first(module: &Module, of: usize) -> Result<Vec<DerivativeBlock>, Option<String>> {
    let derivatives = row(module, of)?;
    let mut missing = Vec::new();
    let mut blocks = Vec::new();
    for block in derivatives.first {
        let Some((place, quantity)) = place(module, derivatives, (block.function, block.part))
        else {
            missing.push(code(block.function.name()));
            continue;
        };
        let matrix = of_result(module, place, &quantity);
        // The gradient of a number is a row.
        let is_gradient =
            quantity.lengths(&module.spaces).len() + quantity.entity.dimensions().len() == 1;
        let matrix = if is_gradient {
            matrix.transposed()
        } else {
            matrix
        };
        blocks.push(DerivativeBlock { place, matrix });
    }
    if missing.is_empty() {
        return Ok(blocks);
    }
    missing.dedup();
    let missing = list(missing.iter().map(String::as_str));
    Err(Some(format!("they need {missing}")))
}

/// Index of the generated function that computes a function of a table, and that of the result with the quantity; one
/// with more functions of the table is preferred, because they share their work.
fn place(
    module: &Module,
    derivatives: &Derivatives,
    (function, part): (Function, usize),
) -> Option<((usize, usize), Quantity)> {
    let index = provider(module, derivatives, function)?;
    let functions = &module.functions[index].functions;
    let before = functions.iter().take_while(|other| **other != function);
    let before: usize = before.map(|other| other.result().parts().count()).sum();
    let (_, quantity) = function.result().parts().nth(part)?;
    Some(((index, before + part), quantity))
}

fn provider(module: &Module, derivatives: &Derivatives, function: Function) -> Option<usize> {
    let is_needed = |other: &&Function| {
        let first = derivatives.first.iter().map(|block| block.function);
        let second = derivatives.second.iter().map(|block| block.function);
        first.chain(second).any(|needed| needed == **other)
    };
    let has = |generated: &GeneratedFunction| {
        generated.frame.is_none() && generated.functions.contains(&function)
    };
    let all = module.functions.iter().enumerate().rev();
    let all = all.filter(|(_, generated)| has(generated));
    let (index, _) =
        all.max_by_key(|(_, generated)| generated.functions.iter().filter(is_needed).count())?;
    Some(index)
}

/// Matrix of a result.
fn of_result(
    module: &Module,
    (function, result): (usize, usize),
    quantity: &Quantity,
) -> SparseMatrix {
    let generated = &module.functions[function];
    let quantities = generated
        .functions
        .iter()
        .flat_map(|function| function.result().parts());
    let sizes = quantities.map(|(_, quantity)| quantity.size(&module.spaces));
    let before: usize = sizes.take(result).sum();
    let operands = &generated.program.results;
    let end = before + quantity.size(&module.spaces);
    let operands = operands.get(before..end).unwrap_or_default();
    SparseMatrix::of(quantity, &module.spaces, operands)
}

/// The matrix without the rows of structural zeros of a result.
fn in_rows_of(out: &SparseMatrix, matrix: SparseMatrix) -> SparseMatrix {
    matrix.rows_where(|row| out.entries.iter().any(|entry| entry.0 == row))
}

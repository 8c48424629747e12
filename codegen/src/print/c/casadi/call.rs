//! Body of a function of `CasADi`: reads inputs, calls generated functions, and stores their results.
//!
//! In: an [`External`] and the names of the C functions. Out: statements of C. A function whose results nobody wants is
//! not called.

use std::fmt::Write;

use super::external::{External, FunctionCall, Store};
use super::matrix::SparseMatrix;
use super::tables::Tables;
use crate::module::Module;
use crate::print::c::COptions;
use crate::print::c::declarations::{argument_lengths, lengths, results};
use crate::print::c::names::{own, unscoped};
use crate::request::Parameter;
use crate::schedule::Names;
use crate::space::Variable;

/// Statements of a function.
pub(super) fn body(
    external: &External,
    module: &Module,
    options: &COptions<'_>,
    symbols: &[String],
    tables: &mut Tables,
) -> String {
    let mut names = unscoped();
    let own_names = ["robot", "prepared"].map(|name| own(options.prefix, name));
    let reserved = symbols
        .iter()
        .map(String::as_str)
        .chain(["arg", "res", "iw", "w", "mem"]);
    for name in reserved.chain(own_names.iter().map(String::as_str)) {
        names.take(name);
    }
    if external.calls.is_empty() {
        return "    (void)arg;\n    (void)res;\n".to_owned();
    }
    let mut body = CallWriter {
        external,
        module,
        symbols,
        tables,
        names,
        text: String::new(),
        local: Vec::new(),
        robot: String::new(),
    };
    body.inputs(&own_names[0]);
    body.seeds();
    for call in &external.calls {
        body.call(call);
    }
    body.text
}

/// Printer of a body.
struct CallWriter<'b> {
    external: &'b External,
    module: &'b Module,
    symbols: &'b [String],
    tables: &'b mut Tables,
    names: Names,
    text: String,
    /// Name of each argument.
    local: Vec<(Variable, String)>,
    /// Name of the struct of fields.
    robot: String,
}

impl CallWriter<'_> {
    fn line(&mut self, depth: usize, line: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "{}{line}", "    ".repeat(depth));
    }

    /// Reads the arguments that are passed on, and the fields.
    fn inputs(&mut self, structure: &str) {
        let External {
            arguments, calls, ..
        } = self.external;
        let called = calls.iter().flat_map(|call| {
            let generated = &self.module.functions[call.function];
            generated.arguments(&self.module.spaces)
        });
        let called: Vec<Variable> = called.collect();
        for (k, &variable) in arguments.iter().enumerate() {
            if !called.contains(&variable) {
                continue;
            }
            let name = self.names.alone(variable.name());
            if let [rows, columns] = *argument_lengths(variable, &self.module.spaces) {
                self.line(1, &format!("double {name}[{rows}][{columns}];"));
                self.line(1, &format!("for (int i = 0; i < {rows}; i++) {{"));
                self.line(2, &format!("for (int j = 0; j < {columns}; j++) {{"));
                let value = format!("arg[{k}] ? arg[{k}][i + {rows} * j] : 0.0");
                self.line(3, &format!("{name}[i][j] = {value};"));
                self.line(2, "}");
                self.line(1, "}");
            } else {
                let zeros = self.zeros(variable);
                let value = format!("arg[{k}] ? arg[{k}] : {zeros}");
                self.line(1, &format!("const double *const {name} = {value};"));
            }
            self.local.push((variable, name));
        }
        let Some(fields) = &self.external.fields else {
            return;
        };
        let (p, robot) = (self.names.alone("p"), self.names.alone("robot"));
        let zeros = self.tables.zeros(fields.matrix.rows);
        let k = arguments.len();
        self.line(
            1,
            &format!("const double *const {p} = arg[{k}] ? arg[{k}] : {zeros};"),
        );
        let mut place = 0;
        let members = self.module.parameters.iter().map(Parameter::entries);
        let members = members.map(|entries| {
            let numbers = entries.iter().map(|_| {
                place += 1;
                format!("{p}[{}]", place - 1)
            });
            match &*numbers.collect::<Vec<_>>() {
                [number] => number.clone(),
                numbers => format!("{{{}}}", numbers.join(", ")),
            }
        });
        let members: Vec<String> = members.collect();
        self.line(
            1,
            &format!("const {structure} {robot} = {{{}}};", members.join(", ")),
        );
        self.robot = robot;
    }

    /// Name of an array of zeros for an argument.
    fn zeros(&mut self, variable: Variable) -> String {
        let lengths = argument_lengths(variable, &self.module.spaces);
        self.tables.zeros(lengths.iter().product())
    }

    /// Reads the weights.
    fn seeds(&mut self) {
        let Some((input, matrix)) = &self.external.seeds else {
            return;
        };
        let name = self.names.alone("weights");
        let (places, count) = (self.tables.places(in_place(matrix)), matrix.entries.len());
        let spread = self.tables.spread();
        self.line(1, &format!("double {name}[{}] = {{0.0}};", matrix.size()));
        self.line(
            1,
            &format!("{spread}({name}, arg[{input}], {places}, {count});"),
        );
        self.local.push((Variable::Weights, name));
    }

    /// Calls a function if one of its results is wanted.
    fn call(&mut self, call: &FunctionCall) {
        let stores = &call.stores;
        let wanted = stores.iter().map(|(output, ..)| format!("res[{output}]"));
        let wanted: Vec<String> = wanted.collect();
        self.line(1, &format!("if ({}) {{", wanted.join(" || ")));
        let generated = &self.module.functions[call.function];
        let mut scope = self.names.clone();
        let mut passed = Vec::new();
        if !self.robot.is_empty() {
            passed.push(format!("&{}", self.robot));
        }
        for variable in generated.arguments(&self.module.spaces) {
            let local = self.local.iter().find(|(of, _)| *of == variable);
            let local = local.map(|(_, name)| name.clone());
            let value = local.unwrap_or_else(|| self.zeros(variable));
            passed.push(match *argument_lengths(variable, &self.module.spaces) {
                // Before C23 an array of arrays is not taken for one of constants.
                [_, columns] => format!("(const double(*)[{columns}]){value}"),
                _ => value,
            });
        }
        let mut first = Vec::new();
        for (name, quantity) in results(&generated.functions) {
            let name = scope.alone(&name);
            let lengths = lengths(&quantity, &self.module.spaces);
            let sizes: Vec<String> = lengths.iter().map(|length| format!("[{length}]")).collect();
            self.line(2, &format!("double {name}{};", sizes.concat()));
            first.push(match lengths.len() {
                0 => format!("&{name}"),
                depth => format!("&{name}{}", "[0]".repeat(depth)),
            });
            passed.push(if lengths.is_empty() {
                format!("&{name}")
            } else {
                name
            });
        }
        self.line(
            2,
            &format!("{}({});", self.symbols[call.function], passed.join(", ")),
        );
        for (output, result, store) in stores {
            let statement = self.store(*output, &first[*result], store);
            if wanted.len() == 1 {
                self.line(2, &statement);
            } else {
                self.line(2, &format!("if (res[{output}]) {{"));
                self.line(3, &statement);
                self.line(2, "}");
            }
        }
        self.line(1, "}");
    }

    /// Statement that stores an output.
    fn store(&mut self, output: usize, first: &str, store: &Store) -> String {
        match store {
            Store::Entries(matrix) => {
                let (put, places) = (self.tables.put(), self.tables.places(matrix.places()));
                format!(
                    "{put}(res[{output}], {first}, {places}, {});",
                    matrix.entries.len()
                )
            }
            Store::Adjoint(matrix) => {
                let [row, column] = matrix.strides;
                let shape = [matrix.rows, matrix.columns, row, column];
                let shape = self
                    .tables
                    .places(shape.map(|size| size.to_string()).to_vec());
                let weights = self.local.iter().find(|(of, _)| *of == Variable::Weights);
                let weights = weights.map_or("", |(_, name)| name);
                let adjoint = self.tables.adjoint();
                format!("{adjoint}(res[{output}], {weights}, {first}, {shape});")
            }
        }
    }
}

/// Place of each entry of a vector.
fn in_place(matrix: &SparseMatrix) -> Vec<String> {
    let entries = matrix.entries.iter();
    let places = entries.map(|(row, column, _)| row + matrix.rows * column);
    places.map(|place| place.to_string()).collect()
}

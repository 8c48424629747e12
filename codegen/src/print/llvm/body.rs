//! Instructions of LLVM for the statements of a routine.
//!
//! In: statements. Out: one or two instructions for each, on values with the names of the routine. Names of
//! intermediate values contain a dot, which names of a routine do not.

use std::fmt::Write;

use super::lanes::Lanes;
use crate::formulation::Sines;
use crate::print::walk::Language;
use crate::schedule::{Angle, Cells, LoopTable, Operation, RoutineLoop, StorePlace, Value};

/// Name within a function, in quotes if LLVM needs them.
pub(super) fn local(name: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "_.".contains(letter);
    if name.chars().all(is_plain) {
        format!("%{name}")
    } else {
        format!("%\"{name}\"")
    }
}

/// Instructions under construction.
pub(super) struct LlvmWriter {
    pub(super) lanes: Lanes,
    fused: bool,
    sines: Sines,
    /// Stack allocations; LLVM promotes them to registers if they precede everything else.
    stack: String,
    text: String,
    /// Number of intermediate values.
    unnamed: usize,
    /// Number of loops.
    loops: usize,
    /// Name of the index of the current loop; names are unique in a function.
    index: String,
    /// Name of the work array, if there is one.
    pub(super) work: Option<String>,
    /// Name of the matrix in which results are stored as soon as they are computed.
    pub(super) filled: Option<String>,
}

impl LlvmWriter {
    pub(super) fn new(lanes: Lanes, fused: bool, sines: Sines) -> Self {
        Self {
            lanes,
            fused,
            sines,
            stack: String::new(),
            text: String::new(),
            unnamed: 0,
            loops: 0,
            index: String::new(),
            work: None,
            filled: None,
        }
    }

    /// Full text.
    pub(super) fn finish(self) -> String {
        self.stack + &self.text
    }

    pub(super) fn line(&mut self, instruction: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {instruction}");
    }

    pub(super) fn bind(&mut self, name: &str, instruction: &str) {
        self.line(&format!("{} = {instruction}", local(name)));
    }

    /// Binds an intermediate value and returns its name.
    pub(super) fn between(&mut self, instruction: &str) -> String {
        self.unnamed += 1;
        let name = format!("v.{}", self.unnamed);
        self.bind(&name, instruction);
        local(&name)
    }

    /// Stack allocation of an array of values.
    pub(super) fn array(&mut self, name: &str, kind: &str) {
        let (name, size) = (local(name), self.lanes.size());
        let _ = writeln!(self.stack, "  {name} = alloca {kind}, align {size}");
    }

    /// Address of an entry of an array of values.
    pub(super) fn entry(&mut self, array: &str, index: &str) -> String {
        let value = self.lanes.value();
        self.between(&format!("getelementptr {value}, ptr {array}, i64 {index}"))
    }

    pub(super) fn load(&mut self, address: &str) -> String {
        let (value, size) = (self.lanes.value(), self.lanes.size());
        self.between(&format!("load {value}, ptr {address}, align {size}"))
    }

    /// Binds a name to the value at an address.
    pub(super) fn load_as(&mut self, name: &str, address: &str) {
        let (value, size) = (self.lanes.value(), self.lanes.size());
        self.bind(name, &format!("load {value}, ptr {address}, align {size}"));
    }

    pub(super) fn store_at(&mut self, address: &str, value: &str) {
        let (kind, size) = (self.lanes.value(), self.lanes.size());
        self.line(&format!(
            "store {kind} {value}, ptr {address}, align {size}"
        ));
    }

    /// Value as an operand.
    pub(super) fn read(&mut self, value: &Value) -> String {
        match value {
            Value::Literal(value) => self.lanes.literal(*value),
            Value::Name(name) => local(name),
            Value::Work(place) => {
                let address = self.work_entry(*place);
                self.load(&address)
            }
            Value::Entry(table, row, column) => {
                let address = self.cell(table, *row, &column.to_string());
                self.load(&address)
            }
            Value::Cell(row, _) => {
                let address = self.row(row);
                self.load(&address)
            }
            Value::Operation(operation) => {
                let instruction = self.instruction(operation);
                self.between(&instruction)
            }
        }
    }

    /// Address of an entry of the work array.
    pub(super) fn work_entry(&mut self, place: usize) -> String {
        let work = self.work.clone();
        let work = work.expect("what waits has an array to wait in");
        self.entry(&local(&work), &place.to_string())
    }

    /// Address of the entry of a row for the current iteration.
    fn row(&mut self, row: &Cells) -> String {
        let index = local(&self.index);
        match row {
            Cells::Table(table, row) => self.cell(table, *row, &index),
            Cells::Work(first) => {
                let first = self.work_entry(*first);
                self.entry(&first, &index)
            }
        }
    }

    /// Address of an entry of a table, which is stored by rows with an entry for each iteration.
    fn cell(&mut self, table: &str, row: usize, column: &str) -> String {
        let value = self.lanes.value();
        let table = local(&format!("{table}.{row}"));
        self.between(&format!("getelementptr {value}, ptr {table}, i64 {column}"))
    }

    /// Instruction with the result of an operation, after those for its parts.
    fn instruction(&mut self, operation: &Operation<Value>) -> String {
        let value = self.lanes.value();
        match operation.clone().map(|of| self.read(&of)) {
            Operation::Add(a, b) => format!("fadd {value} {a}, {b}"),
            Operation::Sub(a, b) => format!("fsub {value} {a}, {b}"),
            Operation::Mul(a, b) => format!("fmul {value} {a}, {b}"),
            Operation::Div(a, b) => format!("fdiv {value} {a}, {b}"),
            Operation::Neg(a) => format!("fneg {value} {a}"),
            Operation::Sqrt(a) => {
                let sqrt = self.lanes.intrinsic("sqrt");
                format!("call {value} {sqrt}({value} {a})")
            }
            Operation::Sign(a) => self.sign(&a),
            Operation::MulAdd(a, b, c) => self.product_and_sum([&a, &b, &c], Signs::Plus),
            Operation::MulSub(a, b, c) => self.product_and_sum([&a, &b, &c], Signs::MinusTerm),
            Operation::NegMulAdd(a, b, c) => {
                self.product_and_sum([&a, &b, &c], Signs::MinusProduct)
            }
        }
    }

    /// Product and sum, fused or not.
    fn product_and_sum(&mut self, [a, b, c]: [&str; 3], signs: Signs) -> String {
        let value = self.lanes.value();
        if self.fused {
            let negative =
                |writer: &mut Self, of: &str| writer.between(&format!("fneg {value} {of}"));
            let (a, c) = match signs {
                Signs::Plus => (a.to_owned(), c.to_owned()),
                Signs::MinusTerm => (a.to_owned(), negative(self, c)),
                Signs::MinusProduct => (negative(self, a), c.to_owned()),
            };
            let fma = self.lanes.intrinsic("fma");
            return format!("call {value} {fma}({value} {a}, {value} {b}, {value} {c})");
        }
        let product = self.between(&format!("fmul {value} {a}, {b}"));
        match signs {
            Signs::Plus => format!("fadd {value} {product}, {c}"),
            Signs::MinusTerm => format!("fsub {value} {product}, {c}"),
            Signs::MinusProduct => format!("fsub {value} {c}, {product}"),
        }
    }

    /// −1, 0 or 1: (a > 0) − (a < 0).
    fn sign(&mut self, a: &str) -> String {
        let (value, truth) = (self.lanes.value(), self.lanes.truth());
        let [zero, one] = [0.0, 1.0].map(|number| self.lanes.literal(number));
        let [above, below] = ["ogt", "olt"].map(|order| {
            let holds = self.between(&format!("fcmp {order} {value} {a}, {zero}"));
            self.between(&format!(
                "select {truth} {holds}, {value} {one}, {value} {zero}"
            ))
        });
        format!("fsub {value} {above}, {below}")
    }
}

/// Term of a product and sum that is subtracted.
#[derive(Clone, Copy)]
enum Signs {
    Plus,
    MinusTerm,
    MinusProduct,
}

impl Language for LlvmWriter {
    fn operation(&mut self, name: &str, operation: &Operation<Value>) {
        let instruction = self.instruction(operation);
        self.bind(name, &instruction);
    }

    fn sines_and_cosines(&mut self, angles: &[Angle]) {
        let value = self.lanes.value();
        for angle in angles {
            let of = self.read(&angle.value);
            let parts = [(&angle.sine, "sin"), (&angle.cosine, "cos")];
            if self.sines == Sines::Platform {
                for (name, function) in parts {
                    let Some(name) = name else { continue };
                    let function = self.lanes.intrinsic(function);
                    self.bind(name, &format!("call {value} {function}({value} {of})"));
                }
                continue;
            }
            let function = self.lanes.sin_cos();
            let pair = format!("{{ {value}, {value} }}");
            let turn = self.between(&format!("call {pair} {function}({value} {of})"));
            for (place, (name, _)) in parts.into_iter().enumerate() {
                let Some(name) = name else { continue };
                self.bind(name, &format!("extractvalue {pair} {turn}, {place}"));
            }
        }
    }

    fn put(&mut self, place: &StorePlace, value: &Value) {
        let value = self.read(value);
        let address = match place {
            StorePlace::Work(place) => self.work_entry(*place),
            StorePlace::Cell(row, _) => self.row(row),
        };
        self.store_at(&address, &value);
    }

    fn store(&mut self, result: usize, value: &Value) {
        let value = self.read(value);
        let filled = self.filled.clone();
        let filled = filled.expect("early results have a matrix");
        let address = self.entry(&local(&filled), &result.to_string());
        self.store_at(&address, &value);
    }

    /// Rows are separate arrays. The loop index is on the stack, where LLVM promotes it to a register.
    fn begin_loop(&mut self, each: &RoutineLoop) {
        let RoutineLoop {
            table,
            rows,
            index,
            loads,
            ..
        } = each;
        let kind = format!("[{} x {}]", each.count, self.lanes.value());
        for row in 0..rows.len() {
            self.array(&format!("{table}.{row}"), &kind);
        }
        if let Some(LoopTable { table, height, .. }) = &each.found {
            for row in 0..*height {
                self.array(&format!("{table}.{row}"), &kind);
            }
        }
        for (row, values) in rows.iter().enumerate() {
            for (column, value) in values.iter().enumerate() {
                let value = self.read(value);
                let address = self.cell(table, row, &column.to_string());
                self.store_at(&address, &value);
            }
        }
        self.loops += 1;
        self.index = format!("{index}.{}", self.loops);
        let index = self.index.clone();
        let counter = format!("{index}.at");
        let _ = writeln!(self.stack, "  {} = alloca i64, align 8", local(&counter));
        let (counter, label) = (local(&counter), label(&index));
        self.line(&format!("store i64 0, ptr {counter}, align 8"));
        self.line(&format!("br label %{label}"));
        let _ = writeln!(self.text, "{label}:");
        self.bind(&index, &format!("load i64, ptr {counter}, align 8"));
        for (name, row) in loads {
            let address = self.row(row);
            self.load_as(name, &address);
        }
    }

    fn end_loop(&mut self, each: &RoutineLoop) {
        let index = self.index.clone();
        let counter = local(&format!("{index}.at"));
        let next = self.between(&format!("add i64 {}, 1", local(&index)));
        self.line(&format!("store i64 {next}, ptr {counter}, align 8"));
        let more = self.between(&format!("icmp ult i64 {next}, {}", each.count));
        let label = label(&index);
        self.line(&format!("br i1 {more}, label %{label}, label %{label}.end"));
        let _ = writeln!(self.text, "{label}.end:");
    }
}

/// Label of a loop.
fn label(index: &str) -> String {
    format!("{index}.loop")
}

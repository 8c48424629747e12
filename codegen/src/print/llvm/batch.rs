//! Functions of many states: a loop over vectors of states, and one over the remaining states.
//!
//! In: a function, and the vector types that it is printed for, scalars first. Out: its `NAME_batch`. Its parameters
//! are the number of states, the fields, and for each argument and result a pointer, the stride between states and the
//! stride between entries of a state, both in numbers, so that arrays by rows and by columns can be read in place. All
//! states of a vector are read before any of their results is stored. `NAME_arrays` has one signature for all functions:
//! the number of states, the fields, and a pointer to these triples.

use std::fmt::Write;

use super::body::local;
use super::function::{LlvmFunction, Pointer, ROBOT};
use super::lanes::Lanes;

/// Definition.
pub(super) fn batch(function: &LlvmFunction<'_>, widths: &[Lanes]) -> String {
    let mut lines = Lines::default();
    for lanes in widths {
        lines.blocks(function, *lanes);
    }
    lines.push("%state.at = alloca i64, align 8");
    lines.push("store i64 0, ptr %state.at, align 8");
    // The widest first; scalars take the rest.
    for lanes in widths.iter().rev() {
        one_loop(&mut lines, function, *lanes);
    }
    lines.push("ret void");
    format!(
        "define void @{}_batch({}) nounwind {{\n{}}}\n\n",
        function.symbol,
        parameters(function, &format!("ptr {}", local(ROBOT))),
        lines.0
    )
}

/// Parameters of a function of many states, with those fields if there are any.
pub(super) fn parameters(function: &LlvmFunction<'_>, fields: &str) -> String {
    let fields = function.has_fields().then(|| fields.to_owned());
    let pointers = function.arguments().into_iter().chain(function.results());
    let strided = pointers.map(|pointer| {
        let [state, entry] = ["state", "entry"].map(|of| pointer.part(of));
        format!("ptr {}, i64 {state}, i64 {entry}", local(&pointer.name))
    });
    let count = "i64 %count.of".to_owned();
    let parameters = [count].into_iter().chain(fields).chain(strided);
    parameters.collect::<Vec<_>>().join(", ")
}

/// Function with the same parameters behind a pointer.
pub(super) fn arrays(function: &LlvmFunction<'_>) -> String {
    let mut lines = Lines::default();
    let fields = function
        .has_fields()
        .then(|| format!("ptr {}", local(ROBOT)));
    let mut given: Vec<String> = ["i64 %count.of".to_owned()]
        .into_iter()
        .chain(fields)
        .collect();
    let pointers = function.arguments().into_iter().chain(function.results());
    for (k, pointer) in pointers.enumerate() {
        let parts = [("start", "ptr"), ("state", "i64"), ("entry", "i64")];
        for (part, (of, kind)) in parts.into_iter().enumerate() {
            let value = pointer.part(of);
            let place = pointer.part(&format!("{of}.place"));
            lines.push(&format!(
                "{place} = getelementptr {{ ptr, i64, i64 }}, ptr %arrays.of, i64 {k}, i32 {part}"
            ));
            lines.push(&format!("{value} = load {kind}, ptr {place}, align 8"));
            given.push(format!("{kind} {value}"));
        }
    }
    let (symbol, given) = (function.symbol, given.join(", "));
    lines.push(&format!("call void @{symbol}_batch({given})"));
    lines.push("ret void");
    format!(
        "define void @{symbol}_arrays(i64 %count.of, ptr {}, ptr %arrays.of) nounwind {{\n{}}}\n\n",
        local(ROBOT),
        lines.0
    )
}

/// Loop over states, as many at a time as there are lanes.
fn one_loop(lines: &mut Lines, function: &LlvmFunction<'_>, lanes: Lanes) {
    let count = lanes.count;
    let own = |name: &str| format!("{name}.{count}");
    let [more, some, none] = ["more", "some", "none"].map(own);
    lines.push(&format!("br label %{more}"));
    lines.label(&more);
    let [first, end, holds] = ["first", "end", "holds"].map(own);
    lines.push(&format!("%{first} = load i64, ptr %state.at, align 8"));
    lines.push(&format!("%{end} = add i64 %{first}, {count}"));
    lines.push(&format!("%{holds} = icmp ule i64 %{end}, %count.of"));
    lines.push(&format!("br i1 %{holds}, label %{some}, label %{none}"));
    lines.label(&some);
    lines.compute(function, lanes, &first);
    lines.push(&format!("store i64 %{end}, ptr %state.at, align 8"));
    lines.push(&format!("br label %{more}"));
    lines.label(&none);
}

impl Pointer {
    /// Name of a value that belongs to the parameter.
    pub(super) fn part(&self, of: &str) -> String {
        local(&format!("{}.{of}", self.name))
    }

    /// Block of the values of the current states.
    fn block(&self, lanes: Lanes) -> String {
        self.part(&format!("block.{}", lanes.count))
    }
}

/// Functions that move the entries of a vector of states between an array and a block of values.
///
/// If `unrolled`, LLVM repeats the instructions of their loops whatever their length: registers of a GPU have no addresses.
pub(super) fn moves(lanes: Lanes, unrolled: bool) -> String {
    let (remark, how) = if unrolled {
        (
            ", !llvm.loop !0",
            "!0 = distinct !{!0, !1}\n!1 = !{!\"llvm.loop.unroll.full\"}\n\n",
        )
    } else {
        ("", "")
    };
    mover("read", lanes, remark) + &mover("write", lanes, remark) + how
}

/// Such a function: a loop over entries, with a remark on the loop.
fn mover(name: &str, lanes: Lanes, remark: &str) -> String {
    let (value, number, size, count) = (lanes.value(), lanes.number(), lanes.size(), lanes.count);
    let reads = name == "read";
    let mut lines = Lines::default();
    lines.label("start");
    for lane in 1..count {
        lines.push(&format!("%lane.{lane} = mul i64 %state, {lane}"));
    }
    lines.push("br label %entries");
    lines.label("entries");
    lines.push("%k = phi i64 [ 0, %start ], [ %k.next, %entries ]");
    lines.push("%within = mul i64 %k, %entry");
    lines.push(&format!(
        "%at = getelementptr {number}, ptr %array, i64 %within"
    ));
    lines.push(&format!(
        "%place = getelementptr {value}, ptr %block, i64 %k"
    ));
    let mut whole = "poison".to_owned();
    if !reads {
        lines.push(&format!("%all = load {value}, ptr %place, align {size}"));
    }
    for lane in 0..count {
        let address = if lane == 0 {
            "%at".to_owned()
        } else {
            let address = format!("%at.{lane}");
            lines.push(&format!(
                "{address} = getelementptr {number}, ptr %at, i64 %lane.{lane}"
            ));
            address
        };
        match (reads, count) {
            (true, 1) => {
                lines.push(&format!(
                    "%one = load {number}, ptr {address}, align {size}"
                ));
                "%one".clone_into(&mut whole);
            }
            (true, _) => {
                lines.push(&format!(
                    "%one.{lane} = load {number}, ptr {address}, align {size}"
                ));
                lines.push(&format!(
                    "%all.{lane} = insertelement {value} {whole}, {number} %one.{lane}, i64 {lane}"
                ));
                whole = format!("%all.{lane}");
            }
            (false, 1) => lines.push(&format!("store {number} %all, ptr {address}, align {size}")),
            (false, _) => {
                lines.push(&format!(
                    "%one.{lane} = extractelement {value} %all, i64 {lane}"
                ));
                lines.push(&format!(
                    "store {number} %one.{lane}, ptr {address}, align {size}"
                ));
            }
        }
    }
    if reads {
        lines.push(&format!("store {value} {whole}, ptr %place, align {size}"));
    }
    lines.push("%k.next = add i64 %k, 1");
    lines.push("%more = icmp ult i64 %k.next, %len");
    lines.push(&format!("br i1 %more, label %entries, label %done{remark}"));
    lines.label("done");
    lines.push("ret void");
    format!(
        "define internal void @{name}{}(ptr %array, i64 %state, i64 %entry, ptr %block, i64 %len) alwaysinline nounwind {{\n{}}}\n\n",
        lanes.suffix(),
        lines.0
    )
}

/// Instructions and labels.
#[derive(Default)]
pub(super) struct Lines(pub(super) String);

impl Lines {
    pub(super) fn push(&mut self, instruction: &str) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "  {instruction}");
    }

    pub(super) fn label(&mut self, name: &str) {
        let _ = writeln!(self.0, "{name}:");
    }

    /// Room for the entries of as many states as there are lanes.
    pub(super) fn blocks(&mut self, function: &LlvmFunction<'_>, lanes: Lanes) {
        for pointer in function.arguments().into_iter().chain(function.results()) {
            let (block, len) = (pointer.block(lanes), pointer.len);
            let (kind, size) = (lanes.value(), lanes.size());
            self.push(&format!("{block} = alloca [{len} x {kind}], align {size}"));
        }
    }

    /// Reads the states from `first` on, computes and writes their results.
    pub(super) fn compute(&mut self, function: &LlvmFunction<'_>, lanes: Lanes, first: &str) {
        let (arguments, results) = (function.arguments(), function.results());
        for pointer in &arguments {
            self.move_states("read", pointer, lanes, first);
        }
        let fields = function
            .has_fields()
            .then(|| format!("ptr {}", local(ROBOT)));
        let blocks = arguments.iter().chain(&results);
        let blocks = blocks.map(|pointer| format!("ptr {}", pointer.block(lanes)));
        let all: Vec<String> = fields.into_iter().chain(blocks).collect();
        let name = function.name(lanes);
        self.push(&format!("call void {name}({})", all.join(", ")));
        for pointer in &results {
            self.move_states("write", pointer, lanes, first);
        }
    }

    /// Moves the states from `first` on between an array and its block.
    fn move_states(&mut self, by: &str, pointer: &Pointer, lanes: Lanes, first: &str) {
        if pointer.len == 0 {
            return;
        }
        let own = |of: &str| pointer.part(&format!("{of}.{}.{by}", lanes.count));
        let [offset, from] = ["offset", "from"].map(own);
        let [state, entry] = ["state", "entry"].map(|of| pointer.part(of));
        let (number, base) = (lanes.number(), local(&pointer.name));
        self.push(&format!("{offset} = mul i64 %{first}, {state}"));
        self.push(&format!(
            "{from} = getelementptr {number}, ptr {base}, i64 {offset}"
        ));
        self.push(&format!(
            "call void @{by}{}(ptr {from}, i64 {state}, i64 {entry}, ptr {}, i64 {})",
            lanes.suffix(),
            pointer.block(lanes),
            pointer.len
        ));
    }
}

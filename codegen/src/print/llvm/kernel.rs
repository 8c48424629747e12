//! Functions of many states on GPUs of NVIDIA: kernels, with a thread for each state.
//!
//! In: a function. Out: its `NAME_kernel`, which is launched over a line of blocks of a line of threads. Its parameters are
//! those of `NAME_batch`, with the fields as an array by value. It stores the constant last rows of matrices, too, so that
//! nothing else has to write to the GPU's memory.

use super::batch::{Lines, parameters};
use super::body::local;
use super::function::{LlvmFunction, ROBOT};
use super::lanes::Lanes;

/// Indices of threads within a block, of blocks, and the number of threads of a block.
const REGISTERS: [&str; 3] = ["tid.x", "ctaid.x", "ntid.x"];

/// Definition.
pub(super) fn kernel(function: &LlvmFunction<'_>, lanes: Lanes) -> String {
    let (number, size) = (lanes.number(), lanes.size());
    let mut lines = Lines::default();
    lines.blocks(function, lanes);
    for register in REGISTERS {
        lines.push(&format!("%{register} = call i32 {}()", intrinsic(register)));
        lines.push(&format!("%{register}.of = zext i32 %{register} to i64"));
    }
    lines.push("%before.of = mul i64 %ctaid.x.of, %ntid.x.of");
    lines.push("%state.of = add i64 %before.of, %tid.x.of");
    lines.push("%is.state = icmp ult i64 %state.of, %count.of");
    lines.push("br i1 %is.state, label %some.of, label %none.of");
    lines.label("some.of");
    lines.compute(function, lanes, "state.of");
    for pointer in function.results() {
        let [state, entry] = ["state", "entry"].map(|of| pointer.part(of));
        let [before, matrix] = ["before", "matrix"].map(|of| pointer.part(of));
        if pointer.below.is_some() {
            lines.push(&format!("{before} = mul i64 %state.of, {state}"));
            let array = local(&pointer.name);
            lines.push(&format!(
                "{matrix} = getelementptr {number}, ptr {array}, i64 {before}"
            ));
        }
        for (k, value) in pointer.below.iter().flatten().enumerate() {
            let own = |of: &str| pointer.part(&format!("{of}.below.{k}"));
            let [offset, place] = ["offset", "place"].map(own);
            lines.push(&format!("{offset} = mul i64 {entry}, {}", pointer.len + k));
            lines.push(&format!(
                "{place} = getelementptr {number}, ptr {matrix}, i64 {offset}"
            ));
            lines.push(&format!(
                "store {number} {}, ptr {place}, align {size}",
                lanes.literal(*value)
            ));
        }
    }
    lines.push("br label %none.of");
    lines.label("none.of");
    lines.push("ret void");
    let fields = format!(
        "ptr byval([{} x {number}]) align {size} {}",
        function.fields(),
        local(ROBOT)
    );
    format!(
        "define ptx_kernel void @{}_kernel({}) nounwind {{\n{}}}\n\n",
        function.symbol,
        parameters(function, &fields),
        lines.0
    )
}

/// Declarations of the registers that kernels read.
pub(super) fn declarations() -> String {
    let lines = REGISTERS.map(|register| format!("declare i32 {}()\n", intrinsic(register)));
    lines.concat()
}

fn intrinsic(register: &str) -> String {
    format!("@llvm.nvvm.read.ptx.sreg.{register}")
}

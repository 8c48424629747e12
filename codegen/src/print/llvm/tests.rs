//! Text of hand-made modules, as users of the command see it.

use std::collections::BTreeMap;

use super::{LlvmOptions, States, Steps, print};
use crate::function::Function;
use crate::module::Module;
use crate::print::rust::tests::{generated, literal, module, step, with_payload};
use crate::real::Real;
use crate::schedule::{Operand, Operation, Program};

fn written(module: &Module, lanes: usize, fused: bool) -> String {
    of_states(module, States::InLanes(lanes), fused)
}

fn of_states(module: &Module, states: States, fused: bool) -> String {
    let options = LlvmOptions {
        prefix: "pendulum_",
        asked: Some("Made by hand."),
        steps: Steps::OfQuaternions,
        states,
        fused,
    };
    print(module, &options)
}

/// Lines of a function.
fn function<'t>(text: &'t str, name: &str) -> &'t str {
    let head = format!(" {name}(");
    let at = text.find(&head).expect("the function");
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let end = text[at..].find("\n}\n").expect("an end");
    &text[start..at + end + 2]
}

/// A gravity function with these steps, whose result is the last.
fn steps(real: Real, operations: &[Operation]) -> Module {
    let last = u32::try_from(operations.len() - 1).expect("few steps");
    let program = Program {
        angles: Vec::new(),
        before_angles: 0,
        steps: operations.iter().map(|&of| step(None, of)).collect(),
        results: vec![Operand::Step(last), literal(-0.5)],
        open: BTreeMap::new(),
    };
    Module {
        functions: vec![generated(&[Function::Gravity], program)],
        ..module(real)
    }
}

#[test]
fn products_and_sums_are_fused_or_not() {
    let operation = Operation::NegMulAdd(literal(2.0), literal(3.0), literal(4.0));
    let module = steps(Real::F32, &[operation]);
    let plain = written(&module, 4, false);
    let expected = "define internal void @pendulum_gravity.4(ptr %q, ptr %gravity) nounwind {
  %v.1 = fmul <4 x float> splat (float 0x4000000000000000), splat (float 0x4008000000000000)
  %t_1 = fsub <4 x float> splat (float 0x4010000000000000), %v.1
  %v.2 = getelementptr <4 x float>, ptr %gravity, i64 0
  store <4 x float> %t_1, ptr %v.2, align 4
  %v.3 = getelementptr <4 x float>, ptr %gravity, i64 1
  store <4 x float> splat (float 0xBFE0000000000000), ptr %v.3, align 4
  ret void
}";
    assert_eq!(function(&plain, "@pendulum_gravity.4"), expected);
    let fused = written(&module, 1, true);
    let expected = "define void @pendulum_gravity(ptr %q, ptr %gravity) nounwind {
  %v.1 = fneg float 0x4000000000000000
  %t_1 = call float @llvm.fma.f32(float %v.1, float 0x4008000000000000, float 0x4010000000000000)
  %v.2 = getelementptr float, ptr %gravity, i64 0
  store float %t_1, ptr %v.2, align 4
  %v.3 = getelementptr float, ptr %gravity, i64 1
  store float 0xBFE0000000000000, ptr %v.3, align 4
  ret void
}";
    assert_eq!(function(&fused, "@pendulum_gravity"), expected);
}

#[test]
fn fields_are_the_same_in_all_lanes() {
    let text = written(&with_payload(module(Real::F64)), 2, false);
    let expected = "  %v.3 = getelementptr double, ptr %robot, i64 0
  %v.4 = load double, ptr %v.3, align 8
  %v.5 = insertelement <2 x double> poison, double %v.4, i64 0
  %payload = shufflevector <2 x double> %v.5, <2 x double> poison, <2 x i32> zeroinitializer
";
    let found = function(&text, "@pendulum_gravity.2");
    assert!(found.contains(expected), "{found}");
}

#[test]
fn a_batch_takes_each_array_with_its_strides() {
    let text = written(&steps(Real::F64, &[Operation::Neg(literal(1.0))]), 2, false);
    let batch = function(&text, "@pendulum_gravity_batch");
    let expected = "define void @pendulum_gravity_batch(i64 %count.of, ptr %q, i64 %q.state, i64 %q.entry, \
                    ptr %gravity, i64 %gravity.state, i64 %gravity.entry) nounwind {";
    assert_eq!(batch.lines().next(), Some(expected));
    let calls = ["@pendulum_gravity.2(", "@pendulum_gravity("].map(|call| batch.find(call));
    assert!(
        calls[0] < calls[1] && calls[0].is_some(),
        "vectors come first: {batch}"
    );
}

#[test]
fn all_functions_have_one_signature_behind_a_pointer() {
    let module = steps(Real::F64, &[Operation::Neg(literal(1.0))]);
    let text = written(&module, 2, false);
    let expected = "define void @pendulum_gravity_arrays(i64 %count.of, ptr %robot, ptr %arrays.of) nounwind {
  %q.start.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 0, i32 0
  %q.start = load ptr, ptr %q.start.place, align 8
  %q.state.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 0, i32 1
  %q.state = load i64, ptr %q.state.place, align 8
  %q.entry.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 0, i32 2
  %q.entry = load i64, ptr %q.entry.place, align 8
  %gravity.start.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 1, i32 0
  %gravity.start = load ptr, ptr %gravity.start.place, align 8
  %gravity.state.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 1, i32 1
  %gravity.state = load i64, ptr %gravity.state.place, align 8
  %gravity.entry.place = getelementptr { ptr, i64, i64 }, ptr %arrays.of, i64 1, i32 2
  %gravity.entry = load i64, ptr %gravity.entry.place, align 8
  call void @pendulum_gravity_batch(i64 %count.of, ptr %q.start, i64 %q.state, i64 %q.entry, ptr %gravity.start, i64 %gravity.state, i64 %gravity.entry)
  ret void
}";
    let found = function(&text, "@pendulum_gravity_arrays");
    assert_eq!(found, expected);
    let with_fields = written(&with_payload(module), 1, false);
    let call = "  call void @pendulum_gravity_batch(i64 %count.of, ptr %robot, ptr %q.start,";
    let found = function(&with_fields, "@pendulum_gravity_arrays");
    assert!(found.contains(call), "{found}");
}

#[test]
fn without_a_head_nothing_is_said_and_configurations_are_by_choice() {
    let module = steps(Real::F64, &[Operation::Neg(literal(1.0))]);
    let options = |steps| LlvmOptions {
        prefix: "pendulum_",
        asked: None,
        steps,
        states: States::InLanes(1),
        fused: false,
    };
    let [all, none] = [Steps::All, Steps::None].map(|steps| print(&module, &options(steps)));
    assert!(!all.contains(';') && !none.contains(';'), "{all}");
    assert!(all.contains("@pendulum_integrate_arrays("));
    assert!(!none.contains("@pendulum_integrate"));
}

#[test]
fn a_kernel_computes_the_state_of_its_thread() {
    let text = of_states(&with_payload(module(Real::F32)), States::InThreads, true);
    let kernel = function(&text, "@pendulum_gravity_kernel");
    let head = "define ptx_kernel void @pendulum_gravity_kernel(i64 %count.of, ptr byval([1 x float]) align 4 %robot, \
                ptr %q, i64 %q.state, i64 %q.entry, ptr %gravity, i64 %gravity.state, i64 %gravity.entry) nounwind {";
    assert_eq!(kernel.lines().next(), Some(head));
    for line in [
        "  %is.state = icmp ult i64 %state.of, %count.of",
        "  %q.offset.1.read = mul i64 %state.of, %q.state",
        "  call void @pendulum_gravity(ptr %robot, ptr %q.block.1, ptr %gravity.block.1)",
    ] {
        assert!(kernel.contains(line), "{line} in {kernel}");
    }
    assert!(
        !text.contains("_batch") && !text.contains("_arrays"),
        "{text}"
    );
    // Loops that are not unrolled would keep entries in memory.
    assert_eq!(text.matches("!llvm.loop !0").count(), 2);
}

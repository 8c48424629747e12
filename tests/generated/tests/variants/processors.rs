//! One robot for different processors: the choice of operations, and the stated cost.

use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::module::Module;
use homogen_codegen::request::Request;
use homogen_codegen::{Builder, Function, Processor, Real, description, front_end};
use quote::quote;

const PANDA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/panda_class.urdf");

/// Inverse and forward dynamics of seven joints, as in a derive.
fn module(processor: Processor, scalar: Real) -> Result<Module, Errors> {
    let mut errors = Errors::new();
    let robot = description::read_file(PANDA.as_ref(), None, &mut errors).expect("it is a robot");
    let request = Request {
        functions: vec![
            vec![Function::InverseDynamics],
            vec![Function::ForwardDynamics],
        ],
        processor,
        scalar,
        ..Request::default()
    };
    expand(&robot, &request)
}

fn file(processor: Processor) -> String {
    let builder = Builder::from_urdf(PANDA).generate([Function::InverseDynamics]);
    let source = builder.processor(processor).scalar(Real::F32).to_source();
    source
        .unwrap_or_else(|errors| panic!("{errors}"))
        .to_string()
}

/// Cycles of inverse and of forward dynamics, and the number of fused sums.
#[test]
fn costs_depend_on_the_processor() {
    let found = [
        (Processor::CortexM4, Real::F32),
        (Processor::CortexM7, Real::F32),
        (Processor::CortexM7, Real::F64),
        (Processor::X86_64, Real::F64),
        (Processor::X86_64V3, Real::F64),
        (Processor::AArch64, Real::F64),
    ]
    .map(|(processor, scalar)| {
        let module = module(processor, scalar).unwrap_or_else(|errors| panic!("{errors}"));
        let counts = module.functions.iter().map(|generated| {
            let (of, cycles) = generated
                .operation_count
                .cycles
                .expect("a processor was chosen");
            assert_eq!(of, processor);
            (cycles, generated.operation_count.fused)
        });
        counts.collect::<Vec<_>>()
    });
    let expected = [
        [(583, 0), (1222, 0)],
        [(583, 0), (1234, 0)],
        [(1193, 0), (2530, 0)],
        [(292, 0), (581, 0)],
        [(209, 165), (406, 350)],
        [(209, 165), (415, 350)],
    ];
    assert_eq!(found, expected);
}

#[test]
fn without_a_processor_no_cycles_are_stated() {
    let portable = module(Processor::Portable, Real::Generic).expect("it has no mistakes");
    assert!(
        portable
            .functions
            .iter()
            .all(|generated| generated.operation_count.cycles.is_none())
    );
    assert!(!file(Processor::Portable).contains("cycles"));
}

#[test]
fn products_are_fused_if_the_processor_can() {
    let fuses = |processor: &str| {
        let tokens = quote! {
            #[robot(urdf = #PANDA, tip = "link8", processor = #processor, generate(gravity))]
            struct Panda;
        };
        front_end::derive(tokens, None)
            .to_string()
            .contains("mul_add (")
    };
    assert!(fuses("portable") && fuses("x86-64-v3") && fuses("aarch64"));
    assert!(!fuses("x86-64") && !fuses("cortex-m4") && !fuses("cortex-m7"));
}

#[test]
fn a_file_for_core_assumes_no_fused_product() {
    let text = file(Processor::AArch64);
    assert!(
        text.contains(" --processor aarch64 ") && text.contains(" --scalar f32"),
        "{text}"
    );
    // 305 products and 278 sums, unfused, on two units.
    assert!(
        text.contains("on aarch64 292 cycles of arithmetic"),
        "{text}"
    );
    assert!(!text.contains("mul_add"), "{text}");
}

#[test]
fn f64_on_a_processor_without_it_is_refused() {
    let refusal = module(Processor::CortexM4, Real::F64).expect_err("refused");
    assert_eq!(
        refusal.to_string(),
        "error: cortex-m4 computes f64 in software, operation by operation\n  \
         hint: choose f32 as the scalar, or another processor\n"
    );
}

#[test]
fn an_unknown_processor_is_reported_with_a_suggestion() {
    let refusal = front_end::derive(
        quote! {
            #[robot(urdf = #PANDA, processor = "cortexm4")]
            struct Panda;
        },
        None,
    );
    let text = refusal.to_string();
    assert!(text.contains("unknown processor"), "{text}");
    assert!(text.contains("did you mean"), "{text}");
    let no_name = front_end::derive(
        quote! {
            #[robot(urdf = #PANDA, processor = 4)]
            struct Panda;
        },
        None,
    );
    assert!(
        no_name
            .to_string()
            .contains("needs the name of a processor")
    );
}

//! Base parameters compared with the parameters of the description.

use homogen_codegen::Function::{self, InverseDynamics};
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::space::FrameId;
use homogen_tests::metrics;
use homogen_tests::tested::{F32, F64, Tested};

use crate::hard_cases::case::{Bench, Case, Variant, judge};
use crate::hard_cases::states::states;

pub const CASES: &[Case] = &[RAW, REGROUPED];

const BASE: Layout = Layout {
    regroup: true,
    ..Layout::DESCRIBED
};

const fn by(name: &'static str, layout: Layout) -> Case {
    Case {
        variant: Variant::WithLayout(layout),
        ..Case::scaled(name, InverseDynamics, 10.0)
    }
}

/// The worst are 3.5 u of base parameters and 3.1 u of the description's.
const RAW: Case = by("regrouped_par/raw", Layout::DESCRIBED);
const REGROUPED: Case = by("regrouped_par", BASE);

/// A payload of 1 kg, 1 t and 10⁶ kg at 10 m, which dominates the base parameters.
#[test]
fn regrouped_par() {
    for mass in ["1", "1e3", "1e6"] {
        judge(&[&RAW, &REGROUPED], &format!("payload/{mass}"), |_| {
            states(336, 7, |_, _| ())
        });
    }
    assert_no_worse::<F64>("payload/1e3");
    assert_no_worse::<F32>("payload/1e3");
}

/// Errors relative to S of the description's parameters: regrouping does not make sums larger.
fn assert_no_worse<T: Tested>(label: &str) {
    const FUNCTIONS: [Function; 1] = [InverseDynamics];
    let bench = Bench::new(label, InverseDynamics);
    let [raw, base] = [Layout::DESCRIBED, BASE].map(|layout| {
        program_by(
            &bench.chain,
            &FUNCTIONS,
            FrameId::FIRST,
            layout,
            Algorithm::PLAIN,
        )
    });
    let mut worst: f64 = 0.0;
    for arguments in states(120, 7, |_, _| ()) {
        let found = metrics::results::<T>(&base, &arguments);
        let sizes = metrics::sizes::<T>(&raw, &arguments);
        let errors = metrics::scaled::<T>(&found, &bench.truth(&arguments), &sizes);
        worst = worst.max(metrics::largest(errors));
    }
    println!(
        "regrouped, by S of the raw parameters, {}: {worst:.2} u",
        T::NAME
    );
    assert!(worst <= 10.0, "{worst} u");
}

//! The worst known inputs, measured again.
//!
//! In: `worst_inputs.txt`; each line has a case, a robot, a scalar type, and the arguments in hexadecimal. Out: a
//! failed test if an error exceeds its limit, or if a case has no line.

use std::collections::BTreeSet;

use homogen_tests::arguments::{self, Arguments};
use homogen_tests::metrics;
use homogen_tests::tested::{F32, F64, Flushed, Fused32, Fused64, Tested};

use super::{angles, cancelling, forward_dynamics, large, regrouped};
use crate::hard_cases::case::{Bench, Case};

const TABLE: &str = include_str!("worst_inputs.txt");

fn cases() -> impl Iterator<Item = &'static Case> {
    let all = [
        angles::CASES,
        cancelling::CASES,
        forward_dynamics::CASES,
        large::CASES,
        regrouped::CASES,
    ];
    all.into_iter().flatten()
}

#[test]
fn the_worst_known_inputs_stay_within_their_limits() {
    let mut without: BTreeSet<&str> = cases().map(|case| case.name).collect();
    for line in TABLE.lines().filter(|line| !line.starts_with('#')) {
        let mut words = line.splitn(4, ' ');
        let mut word = || words.next().expect("case, robot, type, arguments");
        let (name, label, of, arguments) = (word(), word(), word(), word());
        let case = cases().find(|case| case.name == name);
        let case = case.unwrap_or_else(|| panic!("there is no case {name}"));
        let arguments = arguments::parse(arguments).unwrap_or_else(|refusal| panic!("{refusal}"));
        let bench = Bench::new(label, case.function);
        match of {
            "f64" => again::<F64>(case, &bench, arguments),
            "f32" => again::<F32>(case, &bench, arguments),
            "flushed" => again::<Flushed>(case, &bench, arguments),
            "f32_fused" => again::<Fused32>(case, &bench, arguments),
            "f64_fused" => again::<Fused64>(case, &bench, arguments),
            _ => panic!("{of} is not a type"),
        }
        without.remove(name);
    }
    assert!(without.is_empty(), "no line of {without:?}");
}

fn again<T: Tested>(case: &Case, bench: &Bench, arguments: Arguments) {
    let errors = bench.measure::<T>(
        case,
        &bench.program::<T>(case),
        &[bench.prepare(case, arguments)],
    );
    let (error, arguments) = errors.worst();
    let line = arguments::line(arguments);
    let limit = case
        .limit::<T>(bench.joints())
        .expect("the case has this type");
    let name = case.name;
    assert!(error <= limit, "{name}, {}: {error} u at {line}", T::NAME);
    // An input without an error tests nothing.
    assert!(
        metrics::largest([error]) > 0.0,
        "{name}, {}: {line}",
        T::NAME
    );
}

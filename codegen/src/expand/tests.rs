//! Operation counts of functions together, and the share of error bounds in the time of an expansion.
//!
//! In: an arm, and for times a humanoid. Out: operation counts, which are pinned; times of the expansion and of its
//! bounds, which are printed only.

use std::fs;
use std::time::{Duration, Instant};

use super::{expand, understand};
use crate::accuracy::{RoundingModel, of_plan};
use crate::description::{Description, read_text};
use crate::error::Errors;
use crate::function::Function;
use crate::plan::{Planned, Programs, plan, plans};
use crate::request::{Parameter, Request, Target};
use crate::schedule::OperationCount;
use crate::space::FrameId;

fn described(robot: &str) -> Description {
    let path = format!("{}/../{robot}", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(path).expect("it is in the repository");
    let mut errors = Errors::new();
    read_text(&text, robot, None, &mut errors).expect("a robot")
}

/// The functions of a controller in operational space, with a minimal and a careless request.
#[test]
fn functions_requested_together_share_their_work() {
    use Function::{
        AccelerationBias, Bias, BodyJacobian, BodyJacobianRate, GeometricJacobian,
        GeometricJacobianRate, MassMatrix, SpatialJacobian, SpatialJacobianRate,
    };
    let chain = understand(&described("robots/panda_class.urdf"), &Request::default());
    let chain = chain.expect("an arm");
    let programs = Programs::of(&chain);
    let operation_count = |functions: &[Function]| {
        let plan = plan(&programs, functions.to_vec(), FrameId::FIRST).expect("it moves");
        let OperationCount { mul, add, .. } = plan.operation_count;
        (mul, add)
    };
    let operational = [MassMatrix, Bias, GeometricJacobian, GeometricJacobianRate];
    let with_bias = [&operational[..], &[AccelerationBias]].concat();
    let all = [
        &operational[..],
        &[
            SpatialJacobian,
            SpatialJacobianRate,
            BodyJacobian,
            BodyJacobianRate,
        ],
    ]
    .concat();
    for (functions, pinned, at_most) in [
        (&operational[..], (711, 574), 0.91),
        (&with_bias, (776, 636), 0.85),
        (&all, (1048, 785), 0.78),
    ] {
        let together = operation_count(functions);
        assert_eq!(together, pinned, "{functions:?}");
        let alone = functions
            .iter()
            .map(|&function| operation_count(&[function]));
        let (mul, add) = alone.fold((0, 0), |sum, (mul, add)| (sum.0 + mul, sum.1 + add));
        let share = f64::from(u32::try_from(together.0 + together.1).expect("few"))
            / f64::from(u32::try_from(mul + add).expect("few"));
        assert!(share <= at_most, "{functions:?}: {share:.3}");
    }
}

/// The time from the description to the module; the chosen plans are bounded again to time the bounds alone.
#[test]
#[ignore = "measures: run it by itself"]
fn share_of_the_bounds_in_the_time_of_an_expansion() {
    for robot in ["robots/panda_class.urdf", "tests/robots/humanoid.urdf"] {
        let description = described(robot);
        let request = Request::default();
        let start = Instant::now();
        let module = expand(&description, &request).expect("all functions");
        let whole = start.elapsed();
        let chain = understand(&description, &request).expect("a tree");
        let mut bounds = Duration::ZERO;
        for Planned { plan, .. } in plans(&chain).expect("few joints") {
            let Ok(plan) = plan else {
                continue;
            };
            let start = Instant::now();
            let _ = of_plan(&plan, RoundingModel::of(&request));
            bounds += start.elapsed();
        }
        println!(
            "{robot}: {} joints, {} functions in {whole:.2?}, of which bounds {bounds:.2?}: {:.0} %",
            chain.joints.len(),
            module.functions.len(),
            100.0 * bounds.as_secs_f64() / whole.as_secs_f64()
        );
    }
}

/// (mul, add) of a function with all numbers folded, with a payload in a field, of the part left after `prepare`, and
/// of the prepared part.
#[test]
fn a_payload_that_is_prepared_costs_little_more_than_none() {
    let description = described("robots/panda_class.urdf");
    let request = |parameters: Vec<Parameter>, prepare| Request {
        parameters,
        prepare,
        functions: [
            Function::InverseDynamics,
            Function::Gravity,
            Function::MassMatrix,
            Function::ForwardDynamics,
        ]
        .map(|function| vec![function])
        .to_vec(),
        tip: Some("link8".into()),
        ..Request::default()
    };
    let load = Parameter {
        field: quote::format_ident!("load"),
        target: Target::PayloadOn("link8".into()),
        range: None,
    };
    let folded = expand(&description, &request(Vec::new(), false)).expect("an arm");
    let free = expand(&description, &request(vec![load], true)).expect("an arm");
    let prepared = free.prepared.as_ref().expect("it is asked for");
    let pair = |operation_count: OperationCount| (operation_count.mul, operation_count.add);
    let functions = folded.functions.iter().zip(&free.functions);
    let functions = functions.zip(&prepared.functions);
    let operation_counts: Vec<_> = functions
        .map(|((folded, free), left)| {
            [folded, free, left].map(|generated| pair(generated.operation_count))
        })
        .collect();
    let inverse_dynamics = [(305, 278), (344, 334), (308, 283)];
    let gravity = [(49, 30), (58, 45), (50, 32)];
    let mass_matrix = [(182, 168), (217, 222), (182, 169)];
    // With its largest payload only a more expensive formulation is accurate enough.
    let forward_dynamics = [(603, 534), (854, 780), (819, 733)];
    assert_eq!(
        operation_counts,
        [inverse_dynamics, gravity, mass_matrix, forward_dynamics]
    );
    assert_eq!(
        (pair(prepared.operation_count), prepared.names.len()),
        ((62, 89), 56)
    );
}

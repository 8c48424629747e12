//! The functions of robots with loops and of others; loops and actuators that are refused.

use super::{FOUR_BAR, PIN, chain, described};
use crate::expand::{expand, understand};
use crate::function::Function;
use crate::module::Module;
use crate::print::rust::{FormattedSource, Item, Library, methods};
use crate::request::Request;

#[test]
fn every_function_of_a_robot_with_loops_is_listed() {
    let text = FOUR_BAR.to_owned() + PIN;
    let (description, request) = described(&text);
    let request = Request {
        actuated: vec!["a".into()],
        ..request
    };
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let generated: Vec<Function> = (module.functions.iter())
        .flat_map(|generated| generated.functions.clone())
        .collect();
    for function in Function::OF_LOOPS {
        assert!(generated.contains(&function), "{function:?}");
    }
    let facts = &module.about.facts;
    let reported = "closed whatever the joints do: pin.z, pin.xz and pin.yz";
    assert!(facts.iter().any(|fact| fact == reported), "{facts:?}");
}

#[test]
fn functions_that_ignore_loops_document_it() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let (item, library) = (Item::named_after("four bar"), Library::default());
    let open = "/// Loops are ignored: the robot is computed as the tree of its joints";
    for generated in &module.functions {
        let alone = Module {
            functions: vec![generated.clone()],
            ..module.clone()
        };
        let text = FormattedSource::new("", &methods(&alone, &item, &library)).to_string();
        let [function] = &*generated.functions else {
            panic!("one at a time");
        };
        assert_eq!(text.contains(open), !function.is_of_loops(), "{function:?}");
        let instead = format!("{open}; `constrained_forward_dynamics` keeps them closed.");
        assert_eq!(text.contains(&instead), function.solves(), "{function:?}");
    }
}

#[test]
fn impossible_loops_are_refused() {
    let refused = |text: &str| chain(&(FOUR_BAR.to_owned() + text)).expect_err("a mistake");
    let reported =
        refused("loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0.01) }");
    assert!(
        reported.contains("loop \"pin\" cannot close: \"pin.z\" is -0.01 m in every configuration"),
        "{reported}"
    );
    let reported = refused("loop pin: revolute(z) { from: rocker, to: rocker }");
    assert!(
        reported.contains("loop \"pin\" joins link \"rocker\" to itself"),
        "{reported}"
    );
    let reported = refused("loop pin: revolute(z) { from: coupler, to: roker }");
    assert!(
        reported.contains("there is no link \"roker\""),
        "{reported}"
    );
    let reported = refused("loop pin: planar(z) { from: coupler, to: rocker }");
    assert!(
        reported.contains("loop \"pin\" constrains nothing"),
        "{reported}"
    );
    let reported = refused(
        "link tool; joint held: fixed { from: rocker, to: tool } loop pin: spherical { from: tool, to: rocker }",
    );
    assert!(
        reported.contains(
            "loop \"pin\" joins links \"tool\" and \"rocker\", which do not move relative to each other"
        ),
        "{reported}"
    );
    let reported = refused("loop pin: spherical { from: tool, to: tool }");
    assert!(reported.contains("there is no link \"tool\""), "{reported}");
}

#[test]
fn functions_of_loops_are_refused_without_loops() {
    let (description, request) = described(FOUR_BAR);
    for function in Function::OF_LOOPS {
        let request = Request {
            functions: vec![vec![function]],
            ..request.clone()
        };
        let reported = expand(&description, &request)
            .expect_err("no loop")
            .to_string();
        assert!(
            reported.contains("is of robots with loops, and this one has none"),
            "{reported}"
        );
    }
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let generated = module
        .functions
        .iter()
        .flat_map(|generated| &generated.functions);
    assert!(
        generated
            .into_iter()
            .all(|function| !function.is_of_loops())
    );
}

#[test]
fn a_loop_of_a_link_that_is_not_modelled_is_left_open_with_a_warning() {
    let text = FOUR_BAR.to_owned() + "loop pin: spherical { from: coupler, to: rocker }";
    let (description, request) = described(&text);
    let request = Request {
        drop: vec!["rocker".into()],
        ..request
    };
    let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(chain.loops.is_empty());
    let reported: Vec<&str> = chain
        .report
        .warnings
        .iter()
        .map(|warning| &*warning.message)
        .collect();
    assert!(
        reported.contains(&"loop \"pin\" is left open: link \"rocker\" is not modelled"),
        "{reported:?}"
    );
}

#[test]
fn loops_and_actuators_that_no_function_reads_give_a_warning() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let reported = |functions: &[Function]| -> Vec<String> {
        let request = Request {
            functions: functions.iter().map(|&function| vec![function]).collect(),
            actuated: vec!["a".into()],
            ..request.clone()
        };
        let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
        let warnings = chain.report.warnings.into_iter();
        warnings.map(|warning| warning.message).collect()
    };
    let open = "loop \"pin\" is left open: no function of loops is generated";
    let actuated = "actuated joints are named, but no function uses them";
    assert_eq!(reported(&[Function::ForwardDynamics]), [open, actuated]);
    assert_eq!(
        reported(&[Function::Constraint, Function::Gravity]),
        [actuated]
    );
    assert!(reported(&[Function::ActuatedInverseDynamics]).is_empty());
    assert!(reported(&[]).is_empty());
}

#[test]
fn actuators_must_be_joints_that_move_independently() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let with = |names: &[&str]| Request {
        actuated: names.iter().map(|&name| name.into()).collect(),
        functions: vec![vec![Function::ActuatedInverseDynamics]],
        ..request.clone()
    };
    let reported = |request: &Request| {
        let refused = expand(&description, request).map(|_| ());
        refused.expect_err("a mistake").to_string()
    };
    let found = reported(&with(&[]));
    assert!(
        found.contains("\"actuated_inverse_dynamics\" needs the actuated joints"),
        "{found}"
    );
    let found = reported(&with(&["d"]));
    assert!(found.contains("there is no joint \"d\""), "{found}");
    let locked = Request {
        lock: vec![("b".into(), None)],
        ..with(&["b"])
    };
    let found = reported(&locked);
    assert!(
        found.contains("joint \"b\" has no velocity of its own"),
        "{found}"
    );
    expand(&description, &with(&["a"])).unwrap_or_else(|errors| panic!("{errors}"));
}

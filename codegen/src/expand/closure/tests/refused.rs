//! What is generated of robots with loops and of others; loops and drives that cannot be.

use super::{FOUR_BAR, PIN, chain, described};
use crate::expand::{expand, understand};
use crate::function::Function;
use crate::module::Module;
use crate::print::rust::{Item, Source, World, methods};
use crate::request::Request;

#[test]
fn all_that_a_robot_with_loops_can_have_is_listed() {
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
    let told = "closed whatever the joints do: pin.z, pin.xz and pin.yz";
    assert!(facts.iter().any(|fact| fact == told), "{facts:?}");
}

#[test]
fn what_leaves_loops_open_says_so() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let (item, world) = (Item::named_after("four bar"), World::default());
    let open = "/// Loops are left open: what counts is the tree of joints that hangs on the base";
    for generated in &module.functions {
        let alone = Module {
            functions: vec![generated.clone()],
            ..module.clone()
        };
        let text = Source::new("", &methods(&alone, &item, &world)).to_string();
        let [function] = &*generated.functions else {
            panic!("one at a time");
        };
        assert_eq!(text.contains(open), !function.is_of_loops(), "{function:?}");
        let instead = format!("{open}; `constrained_forward_dynamics` holds them together.");
        assert_eq!(text.contains(&instead), function.solves(), "{function:?}");
    }
}

#[test]
fn loops_that_cannot_be_are_refused() {
    let refused = |text: &str| chain(&(FOUR_BAR.to_owned() + text)).expect_err("a mistake");
    let told =
        refused("loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0.01) }");
    assert!(
        told.contains("loop \"pin\" cannot close: \"pin.z\" is -0.01 m whatever the joints do"),
        "{told}"
    );
    let told = refused("loop pin: revolute(z) { from: rocker, to: rocker }");
    assert!(
        told.contains("loop \"pin\" joins link \"rocker\" to itself"),
        "{told}"
    );
    let told = refused("loop pin: revolute(z) { from: coupler, to: roker }");
    assert!(told.contains("there is no link \"roker\""), "{told}");
    let told = refused("loop pin: planar(z) { from: coupler, to: rocker }");
    assert!(told.contains("loop \"pin\" holds nothing"), "{told}");
    let told = refused(
        "link tool; joint held: fixed { from: rocker, to: tool } loop pin: spherical { from: tool, to: rocker }",
    );
    assert!(
        told.contains(
            "loop \"pin\" joins links \"tool\" and \"rocker\", which do not move relative to each other"
        ),
        "{told}"
    );
    let told = refused("loop pin: spherical { from: tool, to: tool }");
    assert!(told.contains("there is no link \"tool\""), "{told}");
}

#[test]
fn functions_of_loops_are_refused_where_there_is_none() {
    let (description, request) = described(FOUR_BAR);
    for function in Function::OF_LOOPS {
        let request = Request {
            functions: vec![vec![function]],
            ..request.clone()
        };
        let told = expand(&description, &request)
            .expect_err("no loop")
            .to_string();
        assert!(
            told.contains("is of robots with loops, and this one has none"),
            "{told}"
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
fn a_loop_of_a_link_that_is_not_modelled_is_left_open_with_a_doubt() {
    let text = FOUR_BAR.to_owned() + "loop pin: spherical { from: coupler, to: rocker }";
    let (description, request) = described(&text);
    let request = Request {
        drop: vec!["rocker".into()],
        ..request
    };
    let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(chain.loops.is_empty());
    let told: Vec<&str> = chain
        .report
        .warnings
        .iter()
        .map(|doubt| &*doubt.message)
        .collect();
    assert!(
        told.contains(&"loop \"pin\" is left open: link \"rocker\" is not modelled"),
        "{told:?}"
    );
}

#[test]
fn loops_and_drives_that_nothing_asks_for_are_doubted() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let told = |functions: &[Function]| -> Vec<String> {
        let request = Request {
            functions: functions.iter().map(|&function| vec![function]).collect(),
            actuated: vec!["a".into()],
            ..request.clone()
        };
        let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
        let doubts = chain.report.warnings.into_iter();
        doubts.map(|doubt| doubt.message).collect()
    };
    let open = "loop \"pin\" is left open: no function of loops is generated";
    let driven = "actuated joints are named, but no function uses them";
    assert_eq!(told(&[Function::ForwardDynamics]), [open, driven]);
    assert_eq!(told(&[Function::Constraint, Function::Gravity]), [driven]);
    assert!(told(&[Function::ActuatedInverseDynamics]).is_empty());
    assert!(told(&[]).is_empty());
}

#[test]
fn drives_are_joints_that_move_by_themselves() {
    let (description, request) = described(&(FOUR_BAR.to_owned() + PIN));
    let with = |names: &[&str]| Request {
        actuated: names.iter().map(|&name| name.into()).collect(),
        functions: vec![vec![Function::ActuatedInverseDynamics]],
        ..request.clone()
    };
    let told = |request: &Request| {
        let refused = expand(&description, request).map(|_| ());
        refused.expect_err("a mistake").to_string()
    };
    let said = told(&with(&[]));
    assert!(
        said.contains("\"actuated_inverse_dynamics\" asks which joints are driven"),
        "{said}"
    );
    let said = told(&with(&["d"]));
    assert!(said.contains("there is no joint \"d\""), "{said}");
    let locked = Request {
        lock: vec![("b".into(), None)],
        ..with(&["b"])
    };
    let said = told(&locked);
    assert!(
        said.contains("joint \"b\" has no velocity of its own"),
        "{said}"
    );
    expand(&description, &with(&["a"])).unwrap_or_else(|errors| panic!("{errors}"));
}

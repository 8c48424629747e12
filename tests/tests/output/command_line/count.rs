//! `homogen count`: what functions cost, as JSON and as a table.

use homogen_codegen::Function;
use serde_json::Value;

use super::{ARM, homogen, json, keys, refused};

#[test]
fn gives_every_price_by_name() {
    let counted = json("count - --format json", ARM);
    let functions = counted["functions"].as_object().unwrap();
    // Two ends and no tip: functions of a frame are absent.
    let whole = Function::ALL
        .into_iter()
        .filter(|function| !function.needs_a_frame());
    let whole: Vec<&str> = whole.map(Function::name).collect();
    assert_eq!(keys(&counted["functions"]), whole);
    for (name, operation_count) in functions {
        let mut wanted = vec![
            "mul", "add", "div", "sqrt", "sin", "cos", "neg", "fused", "depth", "literals",
            "naive", "errors",
        ];
        // The largest error found, by which the algorithm was chosen.
        let solves = Function::ALL
            .into_iter()
            .any(|function| function.solves() && function.name() == name);
        wanted.extend(solves.then_some("found"));
        assert_eq!(keys(operation_count), wanted);
        let found = operation_count["found"]["f64"].as_f64();
        assert!(found.is_none_or(|found| (0.0..1e-12).contains(&found)));
    }
    let errors = |name: &str| &functions[name]["errors"][0];
    let error = errors("gravity")["f64"]["N m"].as_f64();
    assert!(error.is_some_and(|error| (1e-17..1e-13).contains(&error)));
    let joints = errors("gravity")["joints"].as_array().unwrap();
    let worst = joints.iter().filter_map(|bound| bound["f64"].as_f64());
    assert_eq!(worst.reduce(f64::max), error);
    assert!(joints.iter().all(|bound| bound["joint"].is_string()));
    let of = |name: &str| errors(name)["of"].as_str();
    assert_eq!(of("gravity"), Some("results"));
    assert_eq!(of("forward_dynamics"), Some("tau"));
    assert_eq!(of("mass_matrix_inverse"), Some("M"));
    let dynamics = &functions["inverse_dynamics"];
    let number = |value: &Value| value.as_u64().expect("a number");
    assert!(number(&dynamics["mul"]) * 10 < number(&dynamics["naive"]["mul"]));
    assert!(number(&dynamics["add"]) * 10 < number(&dynamics["naive"]["add"]));
    assert_eq!((number(&dynamics["sin"]), number(&dynamics["cos"])), (2, 2));

    assert_eq!(counted["left_out"][0]["functions"][0], "forward_kinematics");
    assert_eq!(
        counted["left_out"][0]["reason"],
        "the robot has more than one end, and none is named as the tip"
    );

    let with_tip = json("count - --tip hand --frames camera --format json", ARM);
    let names = keys(&with_tip["functions"]);
    assert!(names.contains(&"forward_kinematics"));
    assert!(names.contains(&"forward_kinematics_of_camera"));
    assert_eq!(with_tip["left_out"].as_array().map(Vec::len), Some(0));
}

#[test]
fn in_words_it_is_a_table() {
    let answer = homogen("count - --functions gravity,mass_matrix+bias", ARM);
    let lines: Vec<&str> = answer.output.lines().collect();
    assert_eq!(lines.len(), 3, "{}", answer.output);
    assert!(
        lines[0].trim_start().starts_with("mul  add  div"),
        "{}",
        lines[0]
    );
    assert!(lines[1].starts_with("gravity "), "{}", lines[1]);
    assert!(
        lines[2].starts_with("mass_matrix_and_bias "),
        "{}",
        lines[2]
    );
    assert!(
        lines.iter().all(|line| line.len() == lines[0].len()),
        "{}",
        answer.output
    );
    assert!(
        answer.remarks.starts_with("warning: <stdin>:4:5: "),
        "{}",
        answer.remarks
    );

    let all = homogen("count -", ARM);
    let head = all.output.lines().next().expect("a head");
    assert!(head.ends_with("naive add  error found"), "{head}");
    assert!(
        all.remarks
            .contains("note: left out: forward_kinematics, frame_poses, spatial_jacobian"),
        "{}",
        all.remarks
    );
    assert!(
        all.remarks
            .contains(" and acceleration_bias: the robot has more than one end,"),
        "{}",
        all.remarks
    );
    let why = refused("count - --functions forward_kinematics", ARM);
    assert!(why.contains("the robot has more than one end"), "{why}");
}

#[test]
fn functions_that_share_their_work_cost_less() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/ur5_class.urdf");
    let (pose, jacobian) = ("forward_kinematics", "geometric_jacobian");
    let functions = format!("{pose},{jacobian},{pose}+{jacobian}");
    let counted = json(
        &format!("count {robot} --functions {functions} --format json"),
        "",
    );
    let mul = |name: &str| {
        counted["functions"][name]["mul"]
            .as_u64()
            .expect("a number")
    };
    assert!(mul(&format!("{pose}_and_{jacobian}")) < mul(pose) + mul(jacobian));
}

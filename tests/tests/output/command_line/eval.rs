//! `homogen eval`: results in given states, with their shape, and what is wrong with states.

use homogen_cli::Answer;
use serde_json::{Value, json};

use super::{ARM, homogen, keys};

#[test]
fn says_the_shape_and_the_rows() {
    let states = r#"{"states":[{"q":[0.5,1,0.25]}]}"#;
    let jacobian = in_json("--function geometric_jacobian --frame camera", states);
    assert_eq!(jacobian["function"], "geometric_jacobian");
    let wanted = [
        "version",
        "function",
        "coordinates",
        "velocities",
        "joints",
        "base",
        "frame",
        "shape",
        "rows",
        "warnings",
        "results",
    ];
    assert_eq!(keys(&jacobian), wanted);
    for names in ["joints", "coordinates", "velocities"] {
        assert_eq!(jacobian[names], json!(["shoulder", "elbow", "slide"]));
    }
    assert_eq!(jacobian["frame"], "camera");
    assert_eq!(jacobian["shape"], json!([6, 3]));
    assert_eq!(jacobian["rows"][0], "angular_x");
    assert_eq!(jacobian["rows"][5], "linear_z");
    // The camera hangs on the shoulder, whose axis is −y of the base; its arm is (−sin, cos)/10.
    let rows = jacobian["results"][0].as_array().unwrap();
    assert_eq!(rows[1], json!([-1.0, 0.0, 0.0]));
    assert_eq!(rows[3][0], json!(-0.1 * 0.5_f64.cos()));
    assert_eq!(rows[5][0], json!(-0.1 * 0.5_f64.sin()));

    let pose = in_json("--function forward_kinematics --tip camera", states);
    assert_eq!(pose["shape"], json!([4, 4]));
    assert_eq!(pose["results"][0][3], json!([0.0, 0.0, 0.0, 1.0]));
    assert_eq!(pose["results"][0][2][3], json!(0.1 * 0.5_f64.cos()));
}

#[test]
fn poses_of_several_frames_are_a_list_with_their_names() {
    let states = r#"{"states":[{"q":[0.5,1,0.25]}]}"#;
    let all = in_json("--function frame_poses --tip hand --frame camera", states);
    assert_eq!(all["frames"], json!(["hand", "camera"]));
    assert_eq!(all["shape"], json!([2, 4, 4]));
    for (place, frame) in ["hand", "camera"].iter().enumerate() {
        let one = in_json(
            &format!("--function forward_kinematics --tip {frame}"),
            states,
        );
        assert_eq!(all["results"][0][place], one["results"][0]);
    }
}

#[test]
fn several_quantities_are_an_object() {
    let states = r#"{"states":[{"q":[0.5,1,0.25],"qd":[0,0,0],"qdd":[0,0,0]}]}"#;
    let of = |function: &str| in_json(&format!("--function {function}"), states);
    let derivatives = of("inverse_dynamics_derivatives");
    assert_eq!(derivatives["shape"], json!({ "dq": [3, 3], "dqd": [3, 3] }));
    let result = &derivatives["results"][0];
    assert_eq!(keys(result), ["dq", "dqd"]);
    // At rest only gravity answers, and no rate does.
    assert_eq!(result["dqd"], json!(vec![vec![0.0; 3]; 3]));
    let [answered, gravity] =
        [&result["dq"], &of("gravity_derivative")["results"][0]].map(|rows| {
            let rows = rows.as_array().expect("rows").iter();
            let entries = rows.flat_map(|row| row.as_array().expect("entries").clone());
            entries
                .map(|entry| entry.as_f64().expect("a number"))
                .collect::<Vec<_>>()
        });
    assert_eq!((answered.len(), gravity.len()), (9, 9));
    let mut pairs = answered.iter().zip(&gravity);
    assert!(pairs.all(|(x, y)| (x - y).abs() < 1e-12), "{answered:?}");
    let text = eval("--function inverse_dynamics_derivatives", states).output;
    assert!(text.starts_with("dq of inverse_dynamics_derivatives of state 0\n"));
    assert!(text.contains("\ndqd of inverse_dynamics_derivatives of state 0\n"));
}

#[test]
fn prints_the_shortest_digits_of_the_arithmetic() {
    let states = r#"{"states":[{"q":[0.5,1,0.25]}]}"#;
    let results = |scalar: &str| {
        let answer = in_json(&format!("--function gravity --scalar {scalar}"), states);
        let results: Vec<String> = answer["results"][0]
            .as_array()
            .unwrap()
            .iter()
            .map(Value::to_string)
            .collect();
        results
    };
    for (single, double) in results("f32").iter().zip(results("f64")) {
        let number: f32 = single.parse().expect("a number");
        assert_eq!(format!("{number:?}"), *single);
        let double: f64 = double.parse().expect("a number");
        assert!((double - f64::from(number)).abs() <= 1e-5 * double.abs());
    }
}

#[test]
fn in_words_it_names_the_joints() {
    let answer = eval("--function gravity", r#"{"states":[{"q":[0,0,0]}]}"#);
    let lines: Vec<&str> = answer.output.lines().collect();
    assert_eq!(lines[0], "gravity of state 0");
    assert!(
        lines[1].ends_with("  shoulder") && lines[3].ends_with("  slide"),
        "{lines:?}"
    );
    assert!(
        answer.remarks.starts_with("warning: <stdin>:4:5: "),
        "{}",
        answer.remarks
    );
}

#[test]
fn gravity_may_be_anything() {
    let states = r#"{"states":[{"q":[0,0,0]}]}"#;
    let at = |gravity: &str| {
        let answer = in_json(&format!("--function gravity --gravity {gravity}"), states);
        answer["results"][0][2].as_f64().expect("a number")
    };
    // The hand slides along x.
    assert_eq!(at("none"), 0.0);
    assert_eq!(at("-2,0,0"), 1.0);
    assert_eq!(at("0,0,-9.81"), 0.0);
}

#[test]
fn names_the_state_and_the_key_of_each_mistake() {
    let states = r#"{"states":[
        {"q":[0,0,0],"qd":[0,0,0]},
        {"q":[0,0],"qd":[0,NaN,0]},
        {"qd":[0,0,null],"q":[0,0,0],"tau":"unneeded"},
        {"q":{},"qd":[0,0,"one"]},
        7
    ]}"#;
    let answer = eval("--function bias --format json", states);
    let expected = "\
error: states.json: state 1 has 2 numbers in \"q\" for 3 joints
error: states.json: state 1 has a \"qd\" whose entry 1 is not a finite number
error: states.json: state 2 has a \"qd\" whose entry 2 is not a finite number
error: states.json: state 3 has a \"q\" that is not a list
error: states.json: state 3 has a \"qd\" whose entry 2 is not a finite number
error: states.json: state 4 is not an object
";
    assert_eq!(answer.remarks, expected);
    assert_eq!((&*answer.output, answer.code), ("", 1));
}

#[test]
fn wants_json() {
    let answer = eval("--function bias", "{\"states\":[{\"q\":[0,0,}]}");
    assert_eq!(
        answer.remarks,
        "error: states.json:1:22: not JSON: expected value\n"
    );
    let answer = eval("--function bias", "{\"state\":[]}");
    assert!(
        answer
            .remarks
            .starts_with("error: states.json: the list \"states\" is missing\n")
    );
    assert!(answer.remarks.contains("  hint: write {\"states\":"));
    let answer = eval("--function bias", r#"{"states":[{"q":[0,0,0]}]}"#);
    assert_eq!(
        answer.remarks,
        "error: states.json: state 0 has no \"qd\"\n"
    );
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_states() {
    let states = r#"{"states":[{"q":[0.1,0.2,0.3],"qd":[0,0,0]}]}"#;
    let plain = eval("--function bias", states);
    let marked = eval("--function bias", &format!("\u{feff}{states}"));
    assert_eq!(marked.remarks, plain.remarks);
    assert_eq!((marked.output, marked.code), (plain.output, 0));
    let mistaken = eval("--function bias", "\u{feff}{\"states\":[{\"q\":[0,0,}]}");
    assert_eq!(
        mistaken.remarks,
        "error: states.json:1:22: not JSON: expected value\n"
    );
}

#[test]
fn states_in_utf_16_are_told_by_name() {
    let states: String = "{\"states\":[]}".chars().flat_map(|c| [c, '\0']).collect();
    let answer = eval("--function bias", &states);
    let expected = "error: states.json is UTF-16\n  hint: save it as UTF-8\n";
    assert_eq!(answer.remarks, expected);
}

#[test]
fn a_result_that_no_number_can_hold_is_a_mistake() {
    let states = r#"{"states":[{"q":[0,0,0],"qd":[1e30,0,0]}]}"#;
    let answer = eval("--function bias --scalar f32 --format json", states);
    let expected = "error: state 0: a result is too large for f32\n";
    assert_eq!((&*answer.remarks, answer.code), (expected, 1));
    let answer = eval("--function bias --scalar f64 --format json", states);
    assert_eq!(answer.code, 0);
}

/// The answer of [`eval`] in JSON.
fn in_json(arguments: &str, states: &str) -> Value {
    let answer = eval(&format!("{arguments} --format json"), states);
    serde_json::from_str(&answer.output).expect("JSON")
}

/// The answer of `eval` for states that come from a file, and a robot from standard input.
pub(super) fn eval(arguments: &str, states: &str) -> Answer {
    // A name of its own for each call: tests run at the same time.
    let name = format!(
        "homogen-states-{:016x}.json",
        fingerprint(arguments, states)
    );
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, states).expect("a temporary file");
    let arguments = format!("eval - {arguments} --states {}", path.display());
    let answer = homogen(&arguments, ARM);
    std::fs::remove_file(&path).expect("it is still there");
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    Answer {
        remarks: answer.remarks.replace(&name, "states.json"),
        ..answer
    }
}

fn fingerprint(arguments: &str, states: &str) -> u64 {
    use std::hash::{DefaultHasher, Hash, Hasher};
    let mut hasher = DefaultHasher::new();
    (arguments, states, std::process::id()).hash(&mut hasher);
    hasher.finish()
}

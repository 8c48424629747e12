//! `--friction`, `--damping`, `--rotors`, `--armature`, `--rotor`, `--ratio`: what joints feel beside bodies.

use serde_json::{Value, json};

use super::eval::eval;
use super::{ARM, homogen, refused};

const STATES: &str =
    r#"{"states":[{"q":[0.5,1,0.25],"qd":[0.5,-2,0],"qdd":[1,2,-4]},{"q":[0.5,1,0.25]}]}"#;

/// τ of the first state with some options less that without.
fn taken(options: &str) -> Value {
    let torques = |options: &str| -> Vec<f64> {
        let states = STATES.replace(",{\"q\":[0.5,1,0.25]}", "");
        let answer = eval(
            &format!("--function inverse_dynamics --format json {options}"),
            &states,
        );
        assert_eq!(answer.code, 0, "{}", answer.remarks);
        let answer: Value = serde_json::from_str(&answer.output).expect("JSON");
        serde_json::from_value(answer["results"][0].clone()).expect("numbers")
    };
    let with = torques(options).into_iter().zip(torques(""));
    // To a millionth: what is printed has the digits of sums.
    let taken = with.map(|(with, without)| ((with - without) * 1e6).round() / 1e6);
    taken.collect()
}

#[test]
fn are_added_to_the_torques() {
    let friction = "--friction=elbow=0.25 --friction=slide=3";
    assert_eq!(taken(friction), json!([0.0, -0.25, 0.0]));
    assert_eq!(taken("--damping shoulder=0.5"), json!([0.25, 0.0, 0.0]));
    assert_eq!(taken("--armature slide=0.5"), json!([0.0, 0.0, -2.0]));
    let rotor = "--rotor elbow=0.01 --ratio elbow=-5";
    assert_eq!(taken(rotor), json!([0.0, 0.5, 0.0]));
}

/// Beside multiplications and additions, where there are any.
#[test]
fn signs_are_counted() {
    let signs = |options: &str| {
        let answer = homogen(
            &format!("count - --functions bias --format json {options}"),
            ARM,
        );
        let answer: Value = serde_json::from_str(&answer.output).expect("JSON");
        answer["functions"]["bias"]["sign"].clone()
    };
    assert_eq!(signs("--friction=elbow=0.25 --friction=slide=3"), json!(2));
    assert_eq!(signs("--damping shoulder=0.5"), Value::Null);
}

#[test]
fn mistakes_and_warnings_are_reported() {
    let usage = homogen("check - --damping shoulder", ARM);
    assert_eq!(usage.code, 2);
    let message = "write JOINT=NUMBER";
    assert!(usage.remarks.contains(message), "{}", usage.remarks);
    assert_eq!(
        refused("check - --friction=mount=1 --armature nobody=1", ARM),
        "error: joint \"mount\" is fixed and has no friction\n\
         error: there is no joint \"nobody\"\n  \
         hint: joints: \"shoulder\", \"elbow\", \"slide\" and \"mount\"\n"
    );
    let doubtful = homogen("check - --friction --rotors", ARM);
    assert_eq!(doubtful.code, 0);
    let any = "is requested, but no moving joint has it in the description";
    for what in ["friction", "armature"] {
        let warning = format!("{what} {any}");
        assert!(doubtful.output.contains(&warning), "{}", doubtful.output);
    }
}

/// About the first axis an armature and the moment of its link are felt alike.
#[test]
fn are_identified_beside_links() {
    let answer = homogen("base-parameters - --friction", ARM);
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    for sum in [
        "0 N m s = shoulder.damping",
        "0 N = slide.friction",
        " + shoulder.armature",
    ] {
        assert!(answer.output.contains(sum), "{}", answer.output);
    }
}

//! `--external`: links on which the surroundings act.

use serde_json::{Value, json};

use super::eval::eval;
use super::{ARM, homogen, refused};

/// At q = 0 the arm lies along x of the base, whose shoulder turns about −y and whose slide goes along x.
fn taken(options: &str, action: &str) -> Value {
    let states = |actions: &str| {
        format!("{{\"states\":[{{\"q\":[0,0,0],\"qd\":[0,0,0],\"qdd\":[0,0,0]{actions}}}]}}")
    };
    let torques = |options: &str, actions: &str| -> Vec<f64> {
        let options = format!("--function inverse_dynamics --format json {options}");
        let answer = eval(&options, &states(actions));
        assert_eq!(answer.code, 0, "{}", answer.remarks);
        let answer: Value = serde_json::from_str(&answer.output).expect("JSON");
        serde_json::from_value(answer["results"][0].clone()).expect("numbers")
    };
    let with = torques(options, &format!(",\"actions\":[{action}]"));
    let with = with.into_iter().zip(torques("", ""));
    let taken = with.map(|(with, without)| ((with - without) * 1e6).round() / 1e6);
    taken.collect()
}

#[test]
fn take_from_the_torques_what_they_do() {
    // A pull of 10 N along x of the hand, and a couple about the axes.
    assert_eq!(
        taken("--external hand", "[0,0,0,10,0,0]"),
        json!([0.0, 0.0, -10.0])
    );
    assert_eq!(
        taken("--external hand", "[0,0,2,0,0,0]"),
        json!([-2.0, -2.0, 0.0])
    );
    // A push of 10 N along y of the camera, 0.1 m above the shoulder, and along x, which turns it.
    assert_eq!(
        taken("--external camera", "[0,0,0,0,10,0]"),
        json!([0.0, 0.0, 0.0])
    );
    assert_eq!(
        taken("--external camera", "[0,0,0,10,0,0]"),
        json!([1.0, 0.0, 0.0])
    );
    // The same along z of the base, through its origin, on the hand.
    let base = "--external hand --external-in-frame-0";
    assert_eq!(taken(base, "[0,0,0,0,0,10]"), json!([0.0, 5.0, 0.0]));
}

#[test]
fn mistakes_are_told() {
    let states = |actions: &str| {
        format!("{{\"states\":[{{\"q\":[0,0,0],\"qd\":[0,0,0],\"qdd\":[0,0,0]{actions}}}]}}")
    };
    for (actions, reported) in [
        ("", "state 0 has no \"actions\""),
        (",\"actions\":[]", "state 0 has 0 actions for 1 links"),
        (
            ",\"actions\":[[1,2,3]]",
            "state 0 has an action 0 that is not a list of 6 numbers",
        ),
        (
            ",\"actions\":[[1,2,3,4,5,\"6\"]]",
            "state 0 has a \"actions\" whose entry 5 is not a finite number",
        ),
    ] {
        let answer = eval(
            "--function inverse_dynamics --external hand",
            &states(actions),
        );
        assert_eq!(answer.code, 1, "{actions}");
        assert!(answer.remarks.contains(reported), "{}", answer.remarks);
    }
    assert_eq!(
        refused("count - --functions gravity --external hand", ARM),
        "error: external wrenches enter inverse and forward dynamics and their derivatives, but none of these is generated\n  \
         hint: leave them out, or generate inverse_dynamics or forward_dynamics\n"
    );
    assert_eq!(homogen("count - --external-in-frame-0", ARM).code, 2);
}

#[test]
fn a_header_for_c_has_arrays_of_six() {
    let header = std::env::temp_dir().join("homogen_external.h");
    let options = format!(
        "generate - --functions forward_dynamics --external hand,fore --extern-c arm_ --c-header {}",
        header.display()
    );
    let answer = homogen(&options, ARM);
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    let text = std::fs::read_to_string(&header).expect("a header");
    std::fs::remove_file(&header).expect("it was there");
    let parameters =
        "const double q[3], const double qd[3], const double tau[3], const double actions[2][6]";
    assert!(text.contains(parameters), "{text}");
}

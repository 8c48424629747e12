//! Configurations with names.

use std::ffi::OsString;

use serde_json::{Value, json};

use crate::answer;

/// A mimic joint, a joint that may be locked, and a body without joints.
const ARM: &str = r#"<mujoco><worldbody><body name="a"><joint name="j" axis="0 1 0"/><geom size="0.1"/>
  <body name="b" pos="1 0 0"><joint name="k" type="ball"/><geom size="0.1" pos="0.1 0 0"/>
    <body name="c" pos="1 0 0"><joint name="l" axis="0 1 0"/><geom size="0.1" pos="0.2 0 0"/></body></body></body></worldbody>
  <equality><joint joint1="l" joint2="j"/></equality>
  <keyframe><key name="home" qpos="0.5 1 0 0 0 0.5"/></keyframe></mujoco>"#;

fn output(words: &[&str]) -> String {
    let words = ["homogen", "check", "-"].iter().chain(words);
    let answer = answer(words.map(OsString::from), &mut ARM.as_bytes());
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    answer.output
}

#[test]
fn configurations_are_listed_in_the_order_of_q() {
    let answer: Value = serde_json::from_str(&output(&["--format", "json"])).expect("JSON");
    assert_eq!(answer["coordinates"].as_array().map(Vec::len), Some(5));
    let home = json!({ "home": [0.5, 0.0, 0.0, 0.0, 1.0] });
    assert_eq!(answer["configurations"], home);
    let text = output(&[]);
    assert!(
        text.contains("\nconfiguration home: 0.5 0 0 0 1\n"),
        "{text}"
    );
    let locked = output(&["--lock", "j"]);
    assert!(
        locked.contains("\nconfiguration home: 0 0 0 1\n"),
        "{locked}"
    );
}

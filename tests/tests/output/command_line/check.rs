//! `homogen check`: what became of a description, as JSON and in words.

use serde_json::{Value, json};

use super::{ARM, homogen, json, keys, refused};

#[test]
fn tells_what_became_of_the_description() {
    let arm = json("check - --tip hand --lock elbow=0.3 --format json", ARM);
    let wanted = [
        "version",
        "robot",
        "file",
        "format",
        "base",
        "tip",
        "joints",
        "coordinates",
        "velocities",
        "links",
        "merged",
        "locked",
        "dropped",
        "mimicked",
        "snapped",
        "turned",
        "warnings",
        "details",
    ];
    assert_eq!(keys(&arm), wanted);
    assert_eq!(arm["robot"], "arm");
    assert_eq!(arm["file"], "<stdin>");
    assert_eq!(arm["format"], "URDF");
    assert_eq!(arm["base"], "base");
    assert_eq!(arm["tip"], "hand");
    for names in ["joints", "coordinates", "velocities"] {
        assert_eq!(arm[names], json!(["shoulder", "slide"]));
    }
    assert_eq!(arm["mimicked"], json!([]));
    assert_eq!(
        arm["links"],
        json!(["base", "upper", "fore", "hand", "camera"])
    );
    assert_eq!(
        arm["merged"],
        json!([{ "link": "fore", "into": "upper" }, { "link": "camera", "into": "upper" }])
    );
    assert_eq!(arm["locked"], json!([{ "joint": "elbow", "q": 0.3 }]));
    assert_eq!(arm["dropped"], json!([]));
    let written: f64 = "1.5708".parse().expect("a number");
    let snapped = json!({
        "line": 15, "column": 18, "item": "shoulder", "written": written, "quarter_turns": 1,
    });
    assert_eq!(arm["snapped"], json!([snapped]));
    assert_eq!(arm["warnings"][0]["line"], 4);
    assert_eq!(arm["warnings"][0]["column"], 5);
    let message = arm["warnings"][0]["message"].as_str().unwrap();
    assert!(
        message.starts_with("the inertia of link \"upper\""),
        "{message}"
    );
    let shoulder = &arm["details"]["joints"][0];
    assert_eq!(shoulder["kind"], "revolute");
    assert_eq!(shoulder["mass"], 3.0);
    assert_eq!(
        shoulder["limits"],
        json!({ "lower": -1.0, "upper": 2.0, "velocity": 3.0 })
    );
}

#[test]
fn several_ends_have_no_tip() {
    let arm = json("check - --exact --format json", ARM);
    assert_eq!(arm["tip"], Value::Null);
    assert_eq!(arm["snapped"], json!([]));
    let rest = json("check - --drop fore --base base --format json", ARM);
    assert_eq!(rest["dropped"], json!(["fore", "hand"]));
    assert_eq!(rest["joints"], json!(["shoulder"]));
    assert_eq!(rest["tip"], "camera");
}

#[test]
fn in_words() {
    let answer = homogen("check - --tip hand --lock elbow --drop camera", ARM);
    let expected = "\
robot arm from <stdin>
format URDF
base base
tip hand
2 joints, in the order of q:
    0  shoulder: revolute, from base to upper, carries 3 kg
    1  slide: prismatic, from fore to hand, carries 0.5 kg
4 links modelled
1 link merged
  fore into upper
1 joint locked
  elbow at 0
1 link left out
  camera
1 angle read as a right angle
  15:18: 1.5708 of shoulder is π/2
1 warning
warning: <stdin>:4:5: the inertia of link \"upper\" is not physical: a second moment about its centre \
of mass is -5.000e-2 kg m² (-33.3 % of the largest)
  hint: used as given: correct the file, or make this an error with strict
";
    assert_eq!(answer.output, expected);
    assert_eq!((&*answer.remarks, answer.code), ("", 0));
}

#[test]
fn strict_refuses_what_is_doubtful() {
    let remarks = refused("check - --strict", ARM);
    assert!(
        remarks.starts_with("error: <stdin>:4:5: the inertia of link"),
        "{remarks}"
    );
    assert!(remarks.contains("(refused: strict)"), "{remarks}");
}

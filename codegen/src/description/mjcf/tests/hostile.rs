//! Hostile texts: too large, nested too deep, truncated, changed at random.

use super::{ARM, errors, in_world};
use crate::description::changed::changed;

#[test]
fn copies_of_copies_are_bounded() {
    let mut bodies = "<body name=\"a\"/>".to_owned();
    for _ in 0..12 {
        bodies = format!("<replicate count=\"1000\">{bodies}</replicate>");
    }
    assert!(errors(&in_world(&bodies)).contains("replicate less"));
    let empty = format!(
        "{}{}",
        "<replicate count=\"1000\">".repeat(12),
        "</replicate>".repeat(12)
    );
    assert!(errors(&in_world(&empty)).contains("replicate less"));
    for count in ["-1", "0.5", "1e9", "nan"] {
        let text = in_world(&format!("<replicate count=\"{count}\"><body/></replicate>"));
        assert_ne!(errors(&text), "", "{count}");
    }
}

#[test]
fn nesting_is_bounded() {
    let nested = |tag: &str, depth: usize| {
        in_world(&format!(
            "{}{}",
            format!("<{tag}>").repeat(depth),
            format!("</{tag}>").repeat(depth)
        ))
    };
    assert!(errors(&nested("frame", 5000)).contains("frames are nested more than 100 deep"));
    assert_eq!(errors(&nested("body", 5000)), "");
    let defaults = format!(
        "<mujoco>{}{}</mujoco>",
        "<default>".repeat(5000),
        "</default>".repeat(5000)
    );
    assert!(errors(&defaults).contains("classes of defaults are nested more than 100 deep"));
}

#[test]
fn damaged_files_never_panic() {
    let letters = b"<>/=\"' -.0123456789eyxz";
    for text in changed(ARM, letters, 7).take(3000) {
        let _ = errors(&text);
    }
    for end in 0..ARM.len() {
        if ARM.is_char_boundary(end) {
            let _ = errors(&ARM[..end]);
        }
    }
}

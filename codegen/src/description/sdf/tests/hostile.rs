//! Damaged and adverse texts.

use super::super::read;
use super::{errors, link, with};
use crate::description::Given;
use crate::description::changed::changed;
use crate::error::Errors;

const ARM: &str = r#"<?xml version="1.0"?>
<sdf version="1.11">
  <world name="w">
    <gravity>0 0 -9.8</gravity>
    <model name="arm" canonical_link="a" placement_frame="f">
      <pose relative_to="__model__">0 0 0 0 0 0.1</pose>
      <link name="a"><inertial><pose>0 0 0.1 0 0 0</pose><mass>1.5</mass><inertia><ixx>0.1</ixx></inertia></inertial></link>
      <link name="b"><pose relative_to="a" degrees="true">0 0 1 90 0 0</pose></link>
      <frame name="f" attached_to="b"><pose>0 0 1 0 0 0</pose></frame>
      <model name="hand"><link name="palm"/><joint name="k" type="ball"><parent>palm</parent><child>palm</child></joint></model>
      <joint name="j" type="revolute"><pose relative_to="f"/><parent>a</parent><child>b</child>
        <axis><xyz expressed_in="a">0 1 0</xyz><limit><lower>-1</lower><upper>inf</upper></limit>
        <dynamics><damping>0.1</damping></dynamics><mimic joint="j"><multiplier>2</multiplier></mimic></axis></joint>
      <joint name="g" type="gearbox"><parent>a</parent><child>b</child><gearbox_reference_body>world</gearbox_reference_body>
        <axis><xyz>0 0 1</xyz></axis></joint>
    </model>
  </world>
</sdf>
"#;

#[test]
fn damaged_texts_give_a_description_or_errors() {
    let mut read_well = 0;
    for text in changed(ARM, b"<>/\"=0159-.xg: \n&", 5).take(2000) {
        let mut errors = Errors::new();
        let robot = read(&text, "arm.sdf", None, &Given::default(), None, &mut errors);
        assert!(robot.is_some() || !errors.is_empty(), "{text}");
        read_well += usize::from(errors.is_empty());
    }
    assert!(read_well < 2000);
}

#[test]
fn adverse_texts_are_errors() {
    for (text, message) in [
        ("", "the file is empty"),
        (
            "<sdf version='1.9'>",
            "the file ends in the middle of an element",
        ),
        ("<sdf version='1.9'/>", "the file has no <model>"),
        (
            "<!DOCTYPE a [<!ENTITY b 'c'>]><sdf version='1.9'><model name='&b;'/></sdf>",
            "error",
        ),
    ] {
        assert!(errors(text).contains(message), "{}", errors(text));
    }
    let deep = "<model name=\"m\">".repeat(150) + &link("a", "") + &"</model>".repeat(150);
    let message = errors(&format!("<sdf version=\"1.9\">{deep}</sdf>"));
    assert!(
        message.contains("more than 100 models in each other"),
        "{message}"
    );
    let included = with("<include><uri>model://x</uri></include>");
    assert!(errors(&included).contains("a text without a file has no folder"));
}

/// Ten thousand frames, each placed in the one before.
#[test]
fn long_chains_of_frames_are_read_in_time() {
    let frame = |k: usize| {
        let before = k - 1;
        format!("<frame name=\"f{k}\" attached_to=\"f{before}\"><pose>0 0 1 0 0 0</pose></frame>")
    };
    let frames: Vec<String> = (1..10_000).map(frame).collect();
    let frames = frames.concat();
    let text = with(&format!("{}<frame name=\"f0\"/>{frames}", link("a", "")));
    let start = std::time::Instant::now();
    assert_eq!(errors(&text), "");
    assert!(start.elapsed().as_secs() < 20);
}

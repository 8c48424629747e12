//! Poses of links, frames and models.

use super::{errors, is_at, joint, link, model, with};

const FIXED: &str = "<joint name=\"j\" type=\"fixed\"><parent>a</parent><child>b</child></joint>";

#[test]
fn a_pose_is_relative_to_the_model_or_to_a_frame() {
    let a = link("a", "");
    let b = link("b", "<pose>1 2 0  0 0 1.5707963267948966</pose>");
    let robot = model(&with(&format!("{a}{b}{FIXED}")));
    is_at(&joint(&robot, "j").origin, [1.0, 2.0, 0.0], [0.0, 1.0, 0.0]);

    let frame = "<frame name=\"f\" attached_to=\"a\"><pose>0 0 1 0 0 0</pose></frame>";
    let b = link(
        "b",
        "<pose relative_to=\"f\" degrees=\"true\">1 0 0 0 0 90</pose>",
    );
    let robot = model(&with(&format!("{a}{frame}{b}{FIXED}")));
    is_at(&joint(&robot, "j").origin, [1.0, 0.0, 1.0], [0.0, 1.0, 0.0]);
    is_at(&joint(&robot, "f").origin, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    assert_eq!(joint(&robot, "f").parent.text, "a");

    let b = link(
        "b",
        "<pose relative_to='a' rotation_format='quat_xyzw'>0 0 0 0 0 1 1</pose>",
    );
    let robot = model(&with(&format!("{a}{b}{FIXED}")));
    is_at(&joint(&robot, "j").origin, [0.0; 3], [0.0, 1.0, 0.0]);
}

/// Digits are kept: a link relative to its parent has the numbers of the file.
#[test]
fn placements_that_both_share_are_left_out() {
    let a = link("a", "<pose>0.1 0 0 0.2 0.3 0.4</pose>");
    let b = link("b", "<pose relative_to=\"a\">0.7 0 0 0 0 0</pose>");
    let robot = model(&with(&format!("{a}{b}{FIXED}")));
    assert_eq!(joint(&robot, "j").origin.len(), 1);
}

#[test]
fn the_world_is_the_root_if_the_base_is_away_from_it() {
    let away = model(&with(&link("a", "<pose>0 0 1 0 0 0</pose>")));
    assert_eq!(away.links[0].name.text, "world");
    is_at(&joint(&away, "a").origin, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    let there = model(&with(&link("a", "<pose>0 0 0 0 0 0</pose>")));
    assert_eq!(there.links.len(), 1);
    let placed = with(&format!("<pose>0 1 0 0 0 0</pose>{}", link("a", "")));
    is_at(
        &joint(&model(&placed), "a").origin,
        [0.0, 1.0, 0.0],
        [1.0, 0.0, 0.0],
    );
}

#[test]
fn nested_models_have_names_and_poses_of_their_own() {
    let inner = format!(
        "<model name=\"hand\" placement_frame=\"palm\"><pose relative_to=\"a\">0 0 1 0 0 0</pose>{}{}\
         <joint name=\"grip\" type=\"fixed\"><parent>wrist</parent><child>palm</child></joint></model>",
        link("wrist", ""),
        link("palm", "<pose>0 0.5 0 0 0 0</pose>")
    );
    let mount =
        "<joint name=\"mount\" type=\"fixed\"><parent>a</parent><child>hand::palm</child></joint>";
    let robot = model(&with(&format!("{}{inner}{mount}", link("a", ""))));
    let names: Vec<&str> = robot.links.iter().map(|link| &*link.name.text).collect();
    assert_eq!(names, ["a", "hand::wrist", "hand::palm"]);
    is_at(
        &joint(&robot, "mount").origin,
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
    );
    is_at(
        &joint(&robot, "hand::grip").origin,
        [0.0, 0.5, 0.0],
        [1.0, 0.0, 0.0],
    );
    // A model stands for its first link.
    let mount = mount.replace("hand::palm", "hand");
    let robot = model(&with(&format!("{}{inner}{mount}", link("a", ""))));
    assert_eq!(joint(&robot, "mount").child.text, "hand::wrist");
    is_at(
        &joint(&robot, "mount").origin,
        [0.0, -0.5, 1.0],
        [1.0, 0.0, 0.0],
    );
}

#[test]
fn mistakes_of_placements_have_their_places() {
    let text = with(&format!(
        "{}\n<frame name=\"f\"><pose relative_to=\"g\"/></frame>",
        link("a", "")
    ));
    assert_eq!(
        errors(&text),
        "error: arm.sdf:2:36: there is no link, joint or frame \"g\"\n  hint: names: \"a\" and \"f\"\n"
    );
    let text = with(&format!(
        "{}\n<frame name=\"f\"><pose relative_to=\"g\"/></frame><frame name=\"g\"><pose relative_to=\"f\"/></frame>",
        link("a", "")
    ));
    assert!(
        errors(&text).contains("is relative to itself"),
        "{}",
        errors(&text)
    );
    let text = with(&link("a", "\n<pose>1 2 3</pose>"));
    assert_eq!(
        errors(&text),
        "error: arm.sdf:2:7: the pose of \"a\" has 3 numbers instead of 6\n"
    );
    let text = with(&link("a", "\n<pose>1 2 x 0 0 0</pose>"));
    assert_eq!(
        errors(&text),
        "error: arm.sdf:2:11: the pose of \"a\" is not a number: \"x\"\n"
    );
    let text = with(&format!("{}{}", link("a", ""), link("a", "")));
    assert!(errors(&text).contains("there is another element \"a\" in the model"));
    let text = with(&link("__a__", ""));
    assert!(errors(&text).contains("the name \"__a__\" is reserved"));
}

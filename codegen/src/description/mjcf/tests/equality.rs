//! Constraints that become mimic joints and loops.

use super::{all_near, errors, fine, joint, pose, warnings};
use crate::description::Description;

/// Two arms in the world, with joints `x` and `y` and sites `s` and `t`, and a constraint in line 2.
fn arms(constraint: &str) -> String {
    format!(
        "<mujoco><compiler angle=\"radian\"/><worldbody><body name=\"a\" pos=\"1 0 0\" euler=\"0 0 1.5707963267948966\"><joint name=\"x\" ref=\"0.25\"/>\
         <site name=\"s\" pos=\"0 1 0\"/></body>\
         <body name=\"b\" pos=\"0 2 0\"><joint name=\"y\" type=\"slide\" ref=\"0.5\"/><site name=\"t\"/></body>\
         </worldbody><equality>\n{constraint}</equality></mujoco>"
    )
}

fn mimic(robot: &Description, name: &str) -> Option<(String, f64, f64)> {
    let mimic = joint(robot, name).mimic.as_ref()?;
    Some((
        mimic.mimicked.text.clone(),
        mimic.multiplier.value,
        mimic.offset.value,
    ))
}

#[test]
fn a_polynomial_of_first_order_is_a_mimic_joint() {
    // y − 0.5 = 1 + 2 (x − 0.25)
    let robot = fine(&arms(
        "<joint joint1=\"y\" joint2=\"x\" polycoef=\"1 2 0 0 0\"/>",
    ));
    assert_eq!(mimic(&robot, "y"), Some(("x".to_owned(), 2.0, 1.0)));
    let robot = fine(&arms("<joint joint1=\"y\" joint2=\"x\"/>"));
    assert_eq!(mimic(&robot, "y"), Some(("x".to_owned(), 1.0, 0.25)));
    let robot = fine(&arms("<joint joint1=\"y\" joint2=\"x\" active=\"false\"/>"));
    assert_eq!(mimic(&robot, "y"), None);
}

#[test]
fn other_constraints_of_joints_are_warnings() {
    let found = |constraint: &str| warnings(&arms(constraint));
    assert_eq!(
        found("<joint name=\"e\" joint1=\"y\" joint2=\"x\" polycoef=\"0 1 2 0 0\"/>"),
        [
            "arm.xml:2:1: not modelled: <joint> \"e\": a joint that follows another by a polynomial of higher order"
        ]
    );
    assert_eq!(
        found("<joint joint1=\"y\"/>"),
        ["arm.xml:2:1: not modelled: a <joint>: a joint that a constraint holds in place"]
    );
    let both = "<joint joint1=\"y\" joint2=\"x\"/>\n<joint joint1=\"x\" joint2=\"y\"/>";
    assert_eq!(
        found(both),
        [
            "arm.xml:3:1: not modelled: a <joint>: a second constraint of a mimic joint, or a cycle of mimic joints"
        ]
    );
    assert!(
        errors(&arms("<joint joint1=\"z\" joint2=\"x\"/>"))
            .contains("joint1 of a <joint> must be a hinge or a slide: \"z\"")
    );
    assert!(errors(&arms("<joint/>")).contains("a <joint> has no joint1"));
}

#[test]
fn a_connection_is_a_loop_with_its_place_on_both_bodies() {
    let robot = fine(&arms(
        "<connect name=\"c\" body1=\"a\" body2=\"b\" anchor=\"0 1 0\"/>",
    ));
    let [closed] = &robot.loops[..] else {
        panic!("one loop");
    };
    assert_eq!(
        [&*closed.name.text, &*closed.from.text, &*closed.to.text],
        ["c", "a", "b"]
    );
    assert_eq!(closed.closure.definition().word, "spherical");
    all_near(pose(&closed.at).1, [0.0, 1.0, 0.0]);
    // In the world's frame the anchor is the origin.
    all_near(pose(&closed.to_at).1, [0.0, -2.0, 0.0]);
    let robot = fine(&arms("<connect body1=\"a\" anchor=\"0 1 0\"/>"));
    assert_eq!(robot.loops[0].to.text, "world");
    all_near(pose(&robot.loops[0].to_at).1, [0.0; 3]);
}

#[test]
fn a_weld_fixes_the_described_or_the_written_pose() {
    let robot = fine(&arms("<weld body1=\"a\" body2=\"b\"/>"));
    let closed = &robot.loops[0];
    assert_eq!(closed.closure.definition().word, "fixed");
    assert!(closed.to_at.is_empty());
    // The pose of b in a.
    let (rotation, position) = pose(&closed.at);
    all_near(position, [2.0, 1.0, 0.0]);
    all_near(rotation[0], [0.0, 1.0, 0.0]);
    let written = "<weld body1=\"a\" body2=\"b\" relpose=\"1 2 3 1 0 0 0\" anchor=\"0 0 1\"/>";
    let robot = fine(&arms(written));
    all_near(pose(&robot.loops[0].at).1, [1.0, 2.0, 4.0]);
    all_near(pose(&robot.loops[0].to_at).1, [0.0, 0.0, 1.0]);
}

#[test]
fn sites_close_loops() {
    let robot = fine(&arms("<connect site1=\"s\" site2=\"t\"/>"));
    let closed = &robot.loops[0];
    assert_eq!([&*closed.from.text, &*closed.to.text], ["s", "t"]);
    assert_eq!(closed.name.text, "connect_s_t");
    assert!(
        errors(&arms("<connect site1=\"s\" site2=\"u\"/>"))
            .contains("site2 of a <connect> must be a site, but there is no site \"u\"")
    );
    assert!(
        errors(&arms("<connect body1=\"c\" anchor=\"0 0 0\"/>"))
            .contains("body1 of a <connect> must be a body, but there is no body \"c\"")
    );
    assert!(errors(&arms("<connect body1=\"a\"/>")).contains("a <connect> has no anchor"));
    assert!(errors(&arms("<weld/>")).contains("a <weld> has no body1 and no sites"));
}

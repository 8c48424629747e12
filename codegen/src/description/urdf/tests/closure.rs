//! Errors of loop joints.

use super::{errors_in, fine};
use crate::closure::Closure;
use crate::description::Step;

const LINKS: &str = r#"<link name="a"/><link name="b"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"#;

fn with(text: &str) -> String {
    format!("<robot name=\"arm\">{LINKS}\n{text}</robot>")
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn loop_joints_join_two_links() {
    let robot = fine(&with(
        r#"<loop_joint name="ball" type="spherical">
             <link1 link="a" xyz="0.1 0 0" rpy="0 0 0.5"/><link2 link="b"/></loop_joint>
           <loop_joint name="pin" type="continuous"><axis xyz="0 0 1"/>
             <link1 link="a"/><link2 link="b" xyz="1 2 3"/></loop_joint>
           <loop_joint name="bar" type="rod"><rod length="0.3"/>
             <link1 link="a"/><link2 link="b" xyz="1 2 3"/></loop_joint>"#,
    ));
    assert!(robot.warnings.is_empty(), "{:?}", robot.warnings);
    let [ball, pin, bar] = &robot.loops[..] else {
        panic!("{:?}", robot.loops);
    };
    assert!(matches!(ball.closure, Closure::Spherical));
    assert_eq!([&ball.from.text, &ball.to.text], ["a", "b"]);
    let shifted = |step: &Step| matches!(step, Step::Translate([x, ..]) if x.value == 0.1);
    assert!(ball.at.iter().any(shifted), "{:?}", ball.at);
    assert!(matches!(pin.closure, Closure::Revolute));
    assert_eq!(pin.axes.map(|axis| axis[2].value), [1.0; 2]);
    assert_eq!(bar.closure.length().map(|length| length.value), Some(0.3));
}

#[test]
fn errors_of_loop_joints_show_the_syntax() {
    assert_eq!(
        errors_in(
            r#"<loop_joint name="p" type="ball"><link1 link="a"/><link2 link="b"/></loop_joint>"#
        ),
        "error: arm.urdf:2:28: loop joint \"p\" has the unknown type \"ball\"\n  hint: known types: fixed, \
         revolute, prismatic, cylindrical, universal, planar, translation, spherical and rod\n"
    );
    assert_eq!(
        errors_in(r#"<loop_joint name="p" type="spherical"><link1 link="a"/></loop_joint>"#),
        "error: arm.urdf:2:1: loop joint \"p\" has no <link2>\n  \
         hint: add <link2 link=\"…\" xyz=\"0 0 0\" rpy=\"0 0 0\"/>\n"
    );
    assert_eq!(
        errors_in(
            r#"<loop_joint name="p" type="rod"><link1 link="a"/><link2 link="b"/></loop_joint>"#
        ),
        "error: arm.urdf:2:1: loop joint \"p\" has no <rod>\n  \
         hint: add <rod length=\"…\"/>, in metres\n"
    );
}

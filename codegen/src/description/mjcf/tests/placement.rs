//! Placements in each form.

use std::f64::consts::FRAC_PI_2;

use super::{all_near, errors, fine, in_world, joint, pose};

/// The rotation of a body with these attributes, under this compiler.
fn rotation(compiler: &str, attributes: &str) -> [[f64; 3]; 3] {
    let text = format!(
        "<mujoco><compiler {compiler}/><worldbody><body name=\"a\" {attributes}/></worldbody></mujoco>"
    );
    pose(&joint(&fine(&text), "a").origin).0
}

fn same(found: [[f64; 3]; 3], wanted: [[f64; 3]; 3]) {
    for (found, wanted) in found.into_iter().zip(wanted) {
        all_near(found, wanted);
    }
}

const ABOUT_Z: [[f64; 3]; 3] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

#[test]
fn all_forms_of_a_rotation_by_90_degrees_agree() {
    for attributes in [
        "quat=\"3 0 0 3\"",
        "axisangle=\"0 0 2 90\"",
        "axisangle=\"0 0 -1 -90\"",
        "euler=\"0 0 90\"",
        "xyaxes=\"0 2 0 -3 1 0\"",
    ] {
        same(rotation("", attributes), ABOUT_Z);
    }
    let radians = format!("euler=\"0 0 {FRAC_PI_2}\"");
    same(rotation("angle=\"radian\"", &radians), ABOUT_Z);
}

/// Small letters are axes that rotate with the frame, capital ones are fixed.
#[test]
fn euler_angles_follow_their_letters() {
    let angles = "euler=\"30 40 50\"";
    let [x, y, z] = [30.0, 40.0, 50.0].map(|angle: f64| {
        let (sine, cosine) = angle.to_radians().sin_cos();
        (sine, cosine)
    });
    let about_x = [[1.0, 0.0, 0.0], [0.0, x.1, -x.0], [0.0, x.0, x.1]];
    let about_y = [[y.1, 0.0, y.0], [0.0, 1.0, 0.0], [-y.0, 0.0, y.1]];
    let about_z = [[z.1, -z.0, 0.0], [z.0, z.1, 0.0], [0.0, 0.0, 1.0]];
    let times = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| {
        a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
    };
    same(
        rotation("", angles),
        times(times(about_x, about_y), about_z),
    );
    same(
        rotation("eulerseq=\"XYZ\"", angles),
        times(about_z, times(about_y, about_x)),
    );
    same(
        rotation("eulerseq=\"xYz\"", angles),
        times(about_y, times(about_x, about_z)),
    );
    assert!(
        errors("<mujoco><compiler\neulerseq=\"xya\"/></mujoco>")
            .starts_with("error: arm.xml:2:11: eulerseq of the compiler is not three letters: xya")
    );
}

#[test]
fn zaxis_is_the_shortest_rotation() {
    same(
        rotation("", "zaxis=\"0 0 5\""),
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    );
    same(
        rotation("", "zaxis=\"0 0 -1\""),
        [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]],
    );
    same(
        rotation("", "zaxis=\"2 0 0\""),
        [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]],
    );
    let half = std::f64::consts::FRAC_1_SQRT_2;
    same(
        rotation("", "zaxis=\"0 1 -1\""),
        [[1.0, 0.0, 0.0], [0.0, -half, half], [0.0, -half, -half]],
    );
}

#[test]
fn frames_place_the_elements_inside() {
    let text = in_world(
        "<frame pos=\"1 0 0\" euler=\"0 0 1.5707963267948966\"><frame pos=\"2 0 0\"><body name=\"a\" pos=\"0 0 3\"/></frame></frame>",
    );
    let (rotation, position) = pose(&joint(&fine(&text), "a").origin);
    all_near(position, [1.0, 2.0, 3.0]);
    same(rotation, ABOUT_Z);
}

#[test]
fn copies_are_placed_one_after_the_other() {
    let text = "<mujoco><worldbody><replicate count=\"3\" offset=\"1 0 0\" euler=\"0 0 90\" sep=\"-\">\
                <body name=\"a\" pos=\"0 0 1\"><body name=\"b\"/></body></replicate></worldbody></mujoco>";
    let robot = fine(text);
    let places = ["a-0", "a-1", "a-2"].map(|name| pose(&joint(&robot, name).origin));
    all_near(places[0].1, [0.0, 0.0, 1.0]);
    all_near(places[1].1, [1.0, 0.0, 1.0]);
    all_near(places[2].1, [1.0, 1.0, 1.0]);
    same(places[1].0, ABOUT_Z);
    assert_eq!(joint(&robot, "b-2").parent.text, "a-2");
    let many = text.replace("count=\"3\"", "count=\"11\"");
    assert_eq!(joint(&fine(&many), "b-07").parent.text, "a-07");
}

#[test]
fn wrong_placements_are_errors() {
    let refusal =
        |attributes: &str| errors(&in_world(&format!("<body name=\"a\"\n{attributes}/>")));
    assert_eq!(
        refusal("quat=\"1 0 0 0\" euler=\"0 0 0\""),
        "error: arm.xml:2:1: body \"a\" has more than one orientation\n  hint: write only one of quat, axisangle, xyaxes, zaxis and euler\n"
    );
    for (attributes, name) in [
        ("quat=\"0 0 0 0\"", "quat"),
        ("axisangle=\"0 0 0 1\"", "axisangle"),
        ("zaxis=\"0 0 0\"", "zaxis"),
        ("xyaxes=\"1 0 0 2 0 0\"", "xyaxes"),
    ] {
        let start = format!(
            "error: arm.xml:3:{}: {name} of body \"a\" has length 0",
            name.len() + 3
        );
        assert!(
            refusal(attributes).starts_with(&start),
            "{}",
            refusal(attributes)
        );
    }
    assert_eq!(
        refusal("pos=\"1 0\""),
        "error: arm.xml:3:6: pos of body \"a\" has 2 numbers instead of 3\n"
    );
}

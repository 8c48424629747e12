//! Collision geometry: spheres are read, and mistakes in it are no errors of the file.

use super::fine;
use crate::description::{Collision, Step};

/// The collision geometry of a link, with its inner text in line 2 from column 1.
fn of_link(inner: &str) -> Vec<Collision> {
    let text = format!("<robot name=\"r\"><link name=\"a\">\n{inner}</link></robot>");
    fine(&text).collisions
}

/// A shape with this geometry.
fn shape(geometry: &str) -> String {
    format!("<collision><geometry>{geometry}</geometry></collision>")
}

#[test]
fn spheres_have_a_place_and_a_radius() {
    let inner = "<collision name=\"c\"><origin xyz=\"0.1 0 -2\" rpy=\"0 0 1\"/>\
                 <geometry><sphere radius=\"0.25\"/></geometry></collision>";
    let second = shape("<sphere radius=\"1e-3\"/>");
    let robot = fine(&format!(
        "<robot name=\"r\"><link name=\"base\"/><link name=\"a\">{inner}{second}</link></robot>"
    ));
    let [first, second] = &robot.collisions[..] else {
        panic!("{:?}", robot.collisions)
    };
    assert_eq!(robot[first.link].name.text, "a");
    let sphere = first.sphere.as_ref().expect("a sphere");
    assert_eq!(sphere.radius.value, 0.25);
    let Step::Translate(offset) = sphere.origin[0] else {
        panic!("{:?}", sphere.origin)
    };
    assert_eq!(offset.map(|entry| entry.value), [0.1, 0.0, -2.0]);
    assert_eq!(sphere.origin.len(), 4);
    let sphere = second.sphere.as_ref().expect("a sphere");
    assert!(sphere.origin.is_empty());
}

#[test]
fn other_shapes_are_no_spheres() {
    for geometry in ["<box size=\"1 1 1\"/>", "<mesh filename=\"a.stl\"/>", ""] {
        let [collision] = &of_link(&shape(geometry))[..] else {
            panic!("one shape")
        };
        assert!(collision.sphere.is_none() && collision.errors.is_empty());
    }
    assert!(of_link("<collision/>")[0].sphere.is_none());
}

#[test]
fn mistakes_wait_for_a_request() {
    let said = |inner: &str| of_link(inner)[0].errors.to_string();
    assert_eq!(
        said(&shape("<sphere/>")),
        "error: 2:22: the radius of a collision of link \"a\" is missing\n"
    );
    assert_eq!(
        said(&shape("<sphere radius=\"0\"/>")),
        "error: 2:38: the radius of a collision of link \"a\" is not positive: 0\n"
    );
    assert_eq!(
        said("<collision><origin xyz=\"1 2\"/><geometry><sphere radius=\"1\"/></geometry></collision>")
            .lines()
            .count(),
        1
    );
}

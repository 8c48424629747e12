//! Rotations by quaternions, and the frames of planar joints.

use super::*;
use crate::description::read_text;
use crate::expand::expand;
use crate::expression::Double;

const INERTIAL: &str = "<inertial><origin xyz=\"0.1 0.02 -0.03\"/><mass value=\"2\"/><inertia ixx=\"0.02\" ixy=\"0.001\" \
    ixz=\"-0.002\" iyy=\"0.03\" iyz=\"0.0005\" izz=\"0.025\"/></inertial>";

/// An arm whose joint has this origin and this axis.
fn file(origin: &str, kind: &str, axis: &str) -> Description {
    let text = format!(
        "<robot name=\"r\" version=\"1.1\"><link name=\"a\"/><link name=\"b\">{INERTIAL}</link><link name=\"c\">{INERTIAL}</link>\
         <joint name=\"j\" type=\"{kind}\"><parent link=\"a\"/><child link=\"b\"/><axis xyz=\"{axis}\"/>\
         <origin xyz=\"0.1 0.2 0.3\" {origin}/></joint>\
         <joint name=\"k\" type=\"revolute\"><parent link=\"b\"/><child link=\"c\"/><axis xyz=\"0 1 0\"/>\
         <origin xyz=\"0.3 0 0.1\"/></joint></robot>"
    );
    let mut errors = Errors::new();
    let description = read_text(&text, "r.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

/// Rotation of the first joint's placement, by rows.
fn rotation(chain: &Chain) -> [[f64; 3]; 3] {
    let rotation = chain.joints[BodyId(0)].placement.rotation;
    let value = |entry| chain.graph.value(entry).map_or(f64::NAN, Double::to_f64);
    rotation.map(value).0
}

fn distance(one: [[f64; 3]; 3], other: [[f64; 3]; 3]) -> f64 {
    let pairs = one.as_flattened().iter().zip(other.as_flattened());
    pairs.fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()))
}

fn exact() -> Request {
    Request {
        exact: true,
        ..Request::default()
    }
}

#[test]
fn a_quaternion_is_the_rotation_of_its_angles() {
    for (rpy, quaternion) in [
        ("0.4 0 0", "0.198669330795061 0 0 0.980066577841242"),
        ("0 0 -1.2", "0 0 -0.564642473395035 0.825335614909678"),
        // Any length, and either sign.
        ("0 0.6 0", "0 -2.95520206661340 0 -9.55336489125606"),
        (
            "0.3 -0.5 0.7",
            "0.219895766329105 -0.180145857996886 0.363237369728236 0.887272187679753",
        ),
    ] {
        let [angles, turned] = [
            format!("rpy=\"{rpy}\""),
            format!("quat_xyzw=\"{quaternion}\""),
        ]
        .map(|origin| {
            build(&file(&origin, "revolute", "0 0 1"), &Request::default()).expect("a chain")
        });
        let away = distance(rotation(&angles), rotation(&turned));
        assert!(away < 1e-14, "{rpy}: {away}");
        assert!(turned.report.turned.is_empty());
    }
}

#[test]
fn a_quaternion_of_right_angles_is_exact_and_reported_unless_exact_is_set() {
    for (quaternion, entries, reported) in [
        (
            "0.7071068 0 0 0.7071068",
            [[1., 0., 0.], [0., 0., -1.], [0., 1., 0.]],
            true,
        ),
        (
            "0.707 0 0 0.7071",
            [[1., 0., 0.], [0., 0., -1.], [0., 1., 0.]],
            true,
        ),
        (
            "0.5 0.5 0.5 0.5",
            [[0., 0., 1.], [1., 0., 0.], [0., 1., 0.]],
            false,
        ),
        (
            "0 0 3 0",
            [[-1., 0., 0.], [0., -1., 0.], [0., 0., 1.]],
            false,
        ),
    ] {
        let description = file(&format!("quat_xyzw=\"{quaternion}\""), "revolute", "0 0 1");
        let chain = build(&description, &Request::default()).expect("a chain");
        assert_eq!(rotation(&chain), entries, "{quaternion}");
        assert_eq!(!chain.report.turned.is_empty(), reported, "{quaternion}");
        assert_eq!(
            chain.report.right_angles_and_residues().0,
            usize::from(reported)
        );
        let written = build(&description, &exact()).expect("a chain");
        assert!(written.report.turned.is_empty());
    }
    // Its entries differ, and `exact` keeps the difference.
    let description = file("quat_xyzw=\"0.707 0 0 0.7071\"", "revolute", "0 0 1");
    let written = rotation(&build(&description, &exact()).expect("a chain"));
    assert!((written[1][1] - 1e-4 / 0.70705).abs() < 1e-8, "{written:?}");
}

/// The check of every expansion computes quaternions independently.
#[test]
fn the_check_agrees_on_quaternions() {
    for quaternion in [
        "0.1 -0.2 0.3 0.9",
        "0.7071068 0 0 0.7071068",
        "0.707 0 0 0.7071",
        "1e-17 0 0.6 0.8",
        "1e-200 2e-200 0 3e-200",
        "1e-17 0 0 2e-17",
        "1e-17 0 3e15 4e15",
    ] {
        let description = file(
            &format!("quat_xyzw=\"{quaternion}\""),
            "revolute",
            "0 0.6 0.8",
        );
        for request in [Request::default(), exact()] {
            let module = expand(&description, &request);
            assert!(module.is_ok(), "{quaternion}: {:?}", module.err());
        }
    }
}

/// x and y of the plane of a joint about an axis.
fn plane(axis: [f64; 3]) -> [[f64; 3]; 2] {
    let [x, y, z] = axis.map(|entry| format!("{entry:?}"));
    let chain = build(&file("", "planar", &format!("{x} {y} {z}")), &exact()).expect("a chain");
    let rotation = rotation(&chain);
    [0, 1].map(|k| rotation.map(|row| row[k]))
}

#[test]
fn a_plane_across_a_coordinate_axis_has_the_next_two_axes() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let opposite = |axis: [f64; 3]| axis.map(|entry| 0.0 - entry);
    for (axis, along) in [
        (z, [x, y]),
        (x, [y, z]),
        (y, [z, x]),
        (opposite(z), [x, opposite(y)]),
        (opposite(x), [y, opposite(z)]),
        (opposite(y), [z, opposite(x)]),
    ] {
        assert_eq!(plane(axis), along, "{axis:?}");
    }
}

#[test]
fn a_plane_rotates_no_further_than_its_axis() {
    // In steps of a degree along great circles, through all axes and their opposites, and past (1, 1, 1).
    let circles: [fn(f64, f64) -> [f64; 3]; 4] = [
        |c, s| [c, s, 0.0],
        |c, s| [0.0, c, s],
        |c, s| [s, 0.0, c],
        |c, s| [0.6 * c, 0.8 * c, s],
    ];
    for circle in circles {
        let at = |step: i32| {
            let angle = f64::from(step) * 2.0 * std::f64::consts::PI / 360.0;
            plane(circle(angle.cos(), angle.sin()))
        };
        let mut before = at(0);
        for step in 1..=360 {
            let now = at(step);
            let turned = before.as_flattened().iter().zip(now.as_flattened());
            let turned = turned.fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
            // One degree is 0.0175, and a few times as much where the circle is near (1, 1, 1).
            assert!(turned < 0.15, "step {step}: {turned}");
            before = now;
        }
    }
}

#[test]
fn residues_of_an_axis_rotate_no_plane() {
    for (axis, along) in [
        ([1e-17, 0.0, 1.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        ([0.0, -6e-17, -1.0], [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]),
        ([6e-17, 1.0, 1e-16], [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    ] {
        let found = plane(axis);
        let away = found.as_flattened().iter().zip(along.as_flattened());
        let away = away.fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
        assert!(away < 1e-15, "{axis:?}: {found:?}");
    }
}

#[test]
fn a_plane_across_the_diagonal_is_continuous() {
    for axis in [
        "1 1 1",
        "-1 -1 -1",
        "0.57735027 0.57735027 0.57735027",
        "0.57735027 0.57735027 0.57735026",
        "0.577351 0.577350 0.577350",
        "0.57736 0.57735 0.57734",
        "1 1 -1",
    ] {
        let description = file("rpy=\"0.1 0.2 0.3\"", "planar", axis);
        let module = expand(&description, &Request::default());
        assert!(module.is_ok(), "{axis}: {:?}", module.err());
        let reported = module.expect("a module").about.facts.join("; ");
        assert!(reported.contains("`j` has x along ["), "{reported}");
    }
}

//! Inertias of geoms, and the compiler's bounds and balance.

use std::f64::consts::PI;

use super::{all_near, errors, fine, in_world, inertial, link, near, pose, values};

/// Mass, centre of mass, and tensor about it, of body `a` in its own axes.
fn found(compiler: &str, body: &str) -> (f64, [f64; 3], [f64; 6]) {
    let text = format!(
        "<mujoco><compiler {compiler}/><worldbody><body name=\"a\">{body}</body></worldbody></mujoco>"
    );
    let robot = fine(&text);
    let found = inertial(&robot, "a");
    let (r, center) = pose(&found.origin);
    let [xx, xy, xz, yy, yz, zz] = values(found.inertia);
    let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let entry = |i: usize, j: usize| {
        let mut sum = 0.0;
        for k in 0..3 {
            for l in 0..3 {
                sum += r[i][k] * tensor[k][l] * r[j][l];
            }
        }
        sum
    };
    let tensor = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(i, j)| entry(i, j));
    (found.mass.value, center, tensor)
}

const EXPLICIT: &str = "<inertial pos=\"1 2 3\" mass=\"4\" diaginertia=\"0.1 0.2 0.25\"/>";
const BALL: &str = "<geom size=\"0.1\" pos=\"0 0 1\"/>";

#[test]
fn an_inertial_counts_unless_inertiafromgeom_is_true() {
    let both = format!("{EXPLICIT}{BALL}");
    let ball = 4.0 / 3.0 * PI;
    near(found("", &both).0, 4.0);
    near(found("", BALL).0, ball);
    near(found("inertiafromgeom=\"true\"", &both).0, ball);
    near(found("inertiafromgeom=\"true\"", EXPLICIT).0, 4.0);
    let text = format!(
        "<mujoco><compiler inertiafromgeom=\"false\"/><worldbody><body name=\"a\">{BALL}</body></worldbody></mujoco>"
    );
    assert!(link(&fine(&text), "a").inertial.is_none());
}

#[test]
fn full_tensors_are_in_the_order_of_mujoco() {
    let (_, center, tensor) = found(
        "",
        "<inertial pos=\"0 0 1\" mass=\"1\" fullinertia=\"1 2 2.5 0.1 0.2 0.3\"/>",
    );
    all_near(center, [0.0, 0.0, 1.0]);
    all_near(tensor, [1.0, 0.1, 0.2, 2.0, 0.3, 2.5]);
}

#[test]
fn geoms_add_up() {
    // Two points at ±1 along x, and the half sides of boxes.
    let (mass, center, tensor) = found(
        "",
        "<geom type=\"box\" size=\"1 2 3\" pos=\"1 0 0\" mass=\"3\"/><geom type=\"box\" size=\"1 2 3\" pos=\"-1 0 0\" mass=\"3\"/>",
    );
    near(mass, 6.0);
    all_near(center, [0.0; 3]);
    all_near(
        tensor,
        [
            6.0 * 13.0 / 3.0,
            0.0,
            0.0,
            6.0 * 10.0 / 3.0 + 6.0,
            0.0,
            6.0 * 5.0 / 3.0 + 6.0,
        ],
    );
}

#[test]
fn geoms_between_two_points_lie_along_them() {
    let (mass, center, tensor) = found(
        "",
        "<geom type=\"cylinder\" fromto=\"1 0 0 3 0 0\" size=\"0.5\" mass=\"12\"/>",
    );
    near(mass, 12.0);
    all_near(center, [2.0, 0.0, 0.0]);
    let (along, across) = (12.0 * 0.125, 0.75 + 4.0);
    all_near(tensor, [along, 0.0, 0.0, across, 0.0, across]);
}

#[test]
fn frames_move_geoms() {
    let (_, center, _) = found(
        "",
        "<frame pos=\"1 0 0\"><frame pos=\"0 2 0\"><geom size=\"0.1\" pos=\"0 0 3\"/></frame></frame>",
    );
    all_near(center, [1.0, 2.0, 3.0]);
}

#[test]
fn groups_choose_geoms() {
    let two =
        "<geom size=\"0.1\" mass=\"1\" group=\"2\"/><geom size=\"0.1\" mass=\"5\" group=\"3\"/>";
    near(found("", two).0, 6.0);
    near(found("inertiagrouprange=\"3 5\"", two).0, 5.0);
}

#[test]
fn bounds_apply_to_principal_moments() {
    near(found("boundmass=\"7\"", EXPLICIT).0, 7.0);
    near(found("boundmass=\"0.5\"", EXPLICIT).0, 4.0);
    let turned = "<inertial pos=\"0 0 0\" mass=\"1\" fullinertia=\"2 2 1 1 0 0\"/>";
    // Principal moments 1, 3 and 1, the first two along the diagonals.
    let (_, _, tensor) = found("boundinertia=\"1.5\"", turned);
    all_near(tensor, [2.25, 0.75, 0.0, 2.25, 0.0, 1.5]);
    let (_, _, tensor) = found("boundinertia=\"0.15\"", EXPLICIT);
    all_near(tensor, [0.15, 0.0, 0.0, 0.2, 0.0, 0.25]);
    let robot = fine(
        "<mujoco><compiler boundmass=\"1\" boundinertia=\"2\"/><worldbody><body name=\"a\"/></worldbody></mujoco>",
    );
    let bare = inertial(&robot, "a");
    near(bare.mass.value, 1.0);
    all_near(values(bare.inertia), [2.0, 0.0, 0.0, 2.0, 0.0, 2.0]);
}

#[test]
fn balanceinertia_replaces_non_physical_moments() {
    let impossible = "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 4\"/>";
    all_near(found("", impossible).2, [1.0, 0.0, 0.0, 1.0, 0.0, 4.0]);
    all_near(
        found("balanceinertia=\"true\"", impossible).2,
        [2.0, 0.0, 0.0, 2.0, 0.0, 2.0],
    );
    all_near(
        found("balanceinertia=\"true\"", EXPLICIT).2,
        [0.1, 0.0, 0.0, 0.2, 0.0, 0.25],
    );
}

#[test]
fn all_bodies_are_scaled_together() {
    let text = "<mujoco><compiler settotalmass=\"10\"/><worldbody><body name=\"a\">\
                <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/><body name=\"b\">\
                <inertial pos=\"0 0 0\" mass=\"3\" diaginertia=\"3 3 3\"/></body></body></worldbody></mujoco>";
    let robot = fine(text);
    near(inertial(&robot, "a").mass.value, 2.5);
    near(inertial(&robot, "b").mass.value, 7.5);
    near(inertial(&robot, "b").inertia[3].value, 7.5);
}

#[test]
fn wrong_inertias_are_errors() {
    let refusal = |body: &str| errors(&in_world(&format!("<body name=\"a\">\n{body}</body>")));
    for (body, message) in [
        (
            "<inertial mass=\"1\"/>",
            "the <inertial> of body \"a\" has no pos",
        ),
        (
            "<inertial pos=\"0 0 0\"/>",
            "the <inertial> of body \"a\" has no mass",
        ),
        (
            "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\" fullinertia=\"1 1 1 0 0 0\"/>",
            "has both fullinertia and diaginertia",
        ),
        (
            "<inertial pos=\"0 0 0\" mass=\"1\" euler=\"1 0 0\" fullinertia=\"1 1 1 0 0 0\"/>",
            "has both fullinertia and an orientation",
        ),
        (
            "<inertial pos=\"0 0 0\" mass=\"-1\"/>",
            "the mass of body \"a\" is negative: -1",
        ),
        ("<geom/>", "a geom of body \"a\" needs a positive size"),
        (
            "<geom name=\"g\" type=\"box\" size=\"1 2\"/>",
            "geom \"g\" of body \"a\" needs a positive size",
        ),
        (
            "<geom size=\"1\" fromto=\"0 0 0 1 0 0\"/>",
            "is a sphere and has fromto",
        ),
        (
            "<geom type=\"capsule\" size=\"1\" fromto=\"0 0 0 1 0 0\" pos=\"1 0 0\"/>",
            "has both pos and fromto",
        ),
        (
            "<geom type=\"capsule\" size=\"1\" fromto=\"1 0 0 1 0 0\"/>",
            "has no length",
        ),
        (
            "<geom type=\"mesh\" mesh=\"m\"/>",
            "names a mesh that does not exist: \"m\"",
        ),
        ("<geom type=\"mesh\"/>", "has no mesh"),
        (
            "<geom type=\"ball\"/>",
            "type of a geom of body \"a\" is \"ball\"",
        ),
        ("<geom size=\"1\" mass=\"-1\"/>", "has a negative mass"),
    ] {
        assert!(
            refusal(body).contains("arm.xml:3:"),
            "{body}: {}",
            refusal(body)
        );
        assert!(refusal(body).contains(message), "{body}: {}", refusal(body));
    }
    // A geom without mass is not read further.
    assert_eq!(refusal("<geom type=\"mesh\" mesh=\"m\" mass=\"0\"/>"), "");
    assert_eq!(
        refusal("<geom type=\"mesh\" mesh=\"m\"/><inertial pos=\"0 0 0\" mass=\"1\"/>"),
        ""
    );
}

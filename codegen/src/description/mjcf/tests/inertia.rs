//! Inertias of geoms, and the compiler's bounds and balance.

use std::f64::consts::PI;

use super::{all_near, errors, fine, in_world, inertial, link, near, pose, values};

/// Mass, centre of mass, and tensor about it, of body `a` in its own axes.
fn found(compiler: &str, body: &str) -> (f64, [f64; 3], [f64; 6]) {
    let text = format!(
        "<mujoco><compiler {compiler}/><worldbody><body name=\"a\">{body}</body></worldbody></mujoco>"
    );
    of_body(&text)
}

/// The same for the body `a` of a whole file.
fn of_body(text: &str) -> (f64, [f64; 3], [f64; 6]) {
    let robot = fine(text);
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

/// Relative deviation from MuJoCo, which stores the orientation of a mesh in single precision.
const SINGLE: f64 = 2e-6;

/// Asserts that a geom that uses an irregular mesh without faces has the inertia that MuJoCo 4.0.0 computes.
fn like_mujoco(inertia: &str, geom: &str, mass: f64, center: [f64; 3], tensor: [f64; 6]) {
    with_compiler("", inertia, geom, mass, center, tensor);
}

/// The same with attributes of the compiler.
fn with_compiler(
    compiler: &str,
    inertia: &str,
    geom: &str,
    mass: f64,
    center: [f64; 3],
    tensor: [f64; 6],
) {
    let text = format!(
        "<mujoco><compiler {compiler}/><asset><mesh name=\"m\" inertia=\"{inertia}\" vertex=\"0 0 0 0.1 0 0 0 0.3 0 0 0 0.1 0.12 0.1 0.15 0.05 0.1 0.05\"/>\
         </asset><worldbody><body name=\"a\"><geom mesh=\"m\" {geom}/></body></worldbody></mujoco>"
    );
    let found = of_body(&text);
    let largest = tensor.into_iter().fold(0.0, f64::max);
    let pairs = (found.1.into_iter().zip(center)).map(|pair| (pair, 1.0));
    let entries = (found.2.into_iter().zip(tensor)).map(|pair| (pair, largest));
    for ((found, wanted), scale) in pairs.chain(entries).chain([((found.0, mass), mass)]) {
        assert!(
            (found - wanted).abs() < SINGLE * scale,
            "{geom}: {found} and {wanted}"
        );
    }
}

#[test]
fn a_mesh_without_faces_is_its_convex_hull() {
    let center = [0.045_109_89, 0.091_758_245, 0.050_137_364];
    let tensor = [
        0.006_463_617,
        0.000_444_46,
        -0.000_530_602,
        0.002_631_037,
        0.000_381_616,
        0.006_061_377,
    ];
    for inertia in ["legacy", "exact", "convex"] {
        let geom = "type=\"mesh\"";
        like_mujoco(inertia, geom, 1.516_666_764, center, tensor);
    }
}

#[test]
fn shapes_are_fitted_to_the_inertia_of_a_mesh() {
    let center = [0.045_109_89, 0.091_758_245, 0.050_137_364];
    like_mujoco(
        "convex",
        "type=\"box\" fitscale=\"1.5\"",
        6.141_961_876,
        center,
        [
            0.058_894_546,
            0.004_049_785,
            -0.004_834_688,
            0.023_973_22,
            0.003_477_174,
            0.055_229_457,
        ],
    );
    let ball = 0.002_081_073_083;
    like_mujoco(
        "legacy",
        "type=\"sphere\"",
        1.198_317_352,
        center,
        [ball, 0.0, 0.0, ball, 0.0, ball],
    );
    like_mujoco(
        "legacy",
        "type=\"cylinder\" shellinertia=\"true\"",
        76.362_803_260,
        center,
        [
            0.432_047_302,
            0.034_247_892,
            -0.004_363_309,
            0.173_050_67,
            0.033_564_36,
            0.432_223_244,
        ],
    );
    like_mujoco(
        "legacy",
        "type=\"ellipsoid\"",
        0.952_866_287,
        center,
        [
            0.002_436_513,
            0.000_167_543,
            -0.000_200_015,
            0.000_991_79,
            0.000_143_853,
            0.002_284_885,
        ],
    );
    like_mujoco(
        "shell",
        "type=\"capsule\" pos=\"1 0 0\"",
        3.435_370_859,
        [1.045_005_502, 0.103_779_993, 0.050_454_053],
        [
            0.025_272_569,
            0.002_622_896,
            -0.000_379_127,
            0.007_164_381,
            0.002_671_259,
            0.025_258_715,
        ],
    );
}

#[test]
fn shapes_are_fitted_to_the_extents_of_a_mesh_with_fitaabb() {
    let center = [0.049_030_809, 0.157_435_978, 0.059_354_348];
    for (geom, mass, tensor) in [
        (
            "type=\"box\"",
            8.775_647_683,
            [
                0.094_494_237,
                0.005_365_15,
                -0.008_401_845,
                0.046_244_532,
                0.004_379_17,
                0.087_934_482,
            ],
        ),
        (
            "type=\"cylinder\" fitscale=\"1.2\"",
            17.693_426_213,
            [
                0.266_563_971,
                0.016_851_267,
                -0.002_146_914,
                0.139_127_764,
                0.016_514_944,
                0.266_650_542,
            ],
        ),
        (
            "type=\"capsule\"",
            7.958_717_236,
            [
                0.060_752_489,
                0.003_001_33,
                -0.000_382_381,
                0.038_055_197,
                0.002_941_428,
                0.060_767_907,
            ],
        ),
        (
            "type=\"sphere\"",
            15.289_656_02,
            [0.144_987_461, 0.0, 0.0, 0.144_987_461, 0.0, 0.144_987_461],
        ),
    ] {
        with_compiler("fitaabb=\"true\"", "convex", geom, mass, center, tensor);
    }
}

#[test]
fn a_flat_mesh_has_no_hull_and_no_fitted_box() {
    let refusal = |mesh: &str, geom: &str| {
        errors(&format!(
            "<mujoco><asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 1 1 0 0 1 0\" {mesh}/></asset><worldbody><body name=\"a\">\
             <geom mesh=\"m\" {geom}/></body></worldbody></mujoco>"
        ))
    };
    let found = refusal("", "type=\"mesh\"");
    assert!(found.contains("its vertices are in a plane"), "{found}");
    let plate = "inertia=\"shell\" face=\"0 1 2 0 2 3\"";
    let found = refusal(plate, "type=\"box\"");
    assert!(found.contains("fitted to a mesh without extent"), "{found}");
    assert_eq!(refusal(plate, "type=\"mesh\""), "");
}

#[test]
fn a_height_field_is_a_box_of_its_extents() {
    let (mass, center, tensor) = of_body(
        "<mujoco><asset><hfield name=\"h\" size=\"1 2 0.5 0.1\" nrow=\"2\" ncol=\"2\"/></asset><worldbody><body name=\"a\">\
         <geom type=\"hfield\" hfield=\"h\" density=\"1\" pos=\"0 0 1\"/></body></worldbody></mujoco>",
    );
    near(mass, 2.8);
    all_near(center, [0.0, 0.0, 1.0]);
    let third = 2.8 / 3.0;
    let height = 0.175_f64 * 0.175;
    all_near(
        tensor,
        [
            third * (4.0 + height),
            0.0,
            0.0,
            third * (1.0 + height),
            0.0,
            third * 5.0,
        ],
    );
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
        ("<geom type=\"hfield\"/>", "has no hfield"),
        (
            "<geom type=\"hfield\" hfield=\"h\"/>",
            "names a height field that does not exist: \"h\"",
        ),
        (
            "<geom type=\"box\" mesh=\"m\" fromto=\"0 0 0 1 0 0\"/>",
            "has both mesh and fromto",
        ),
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

//! Errors of links: their inertials.

use super::{MASS, TENSOR, errors_in_inertial};

#[test]
fn an_inertial_has_mass_and_inertia() {
    assert_eq!(
        errors_in_inertial(""),
        "error: arm.urdf:1:32: the inertial of link \"a\" has no <mass>\n  \
         hint: add <mass value=\"…\"/>\n\
         error: arm.urdf:1:32: the inertial of link \"a\" has no <inertia>\n  \
         hint: add <inertia ixx=\"…\" ixy=\"…\" ixz=\"…\" iyy=\"…\" iyz=\"…\" izz=\"…\"/>\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass/>{TENSOR}")),
        "error: arm.urdf:2:1: the mass of link \"a\" is missing\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"-0.5\"/>{TENSOR}")),
        "error: arm.urdf:2:14: the mass of link \"a\" is negative: -0.5\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("{MASS}<mass value=\"2\"/>{TENSOR}")),
        "error: arm.urdf:2:18: the inertial of link \"a\" has more than one <mass>\n"
    );
    assert_eq!(
        errors_in_inertial(&format!("<mass value=\"0\"/>{TENSOR}")),
        ""
    );
}

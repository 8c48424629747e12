//! Chains of any number of joints.
//!
//! In: a number. Out: a description with equal links.

use std::fmt::Write;

use homogen_codegen::description::{Description, read_text};
use homogen_codegen::error::Errors;

/// A chain of equal links with full inertia tensors. Successive axes are perpendicular and skew.
///
/// # Errors
/// None: the description is valid.
pub fn chain(joints: usize) -> Result<Description, Errors> {
    let mut text = String::from("<robot name=\"chain\"><link name=\"l0\"/>");
    for joint in 1..=joints {
        let (parent, turned) = (joint - 1, if joint % 2 == 0 { "-" } else { "" });
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "<joint name=\"j{joint}\" type=\"continuous\"><parent link=\"l{parent}\"/>\
             <child link=\"l{joint}\"/><origin xyz=\"0.1 0.02 0.2\" \
             rpy=\"{turned}1.5707963267948966 0 0\"/><axis xyz=\"0 0 1\"/></joint>\
             <link name=\"l{joint}\"><inertial><origin xyz=\"0.05 0.02 0.1\"/><mass value=\"1\"/>\
             <inertia ixx=\"0.01\" ixy=\"0.001\" ixz=\"-0.002\" iyy=\"0.012\" iyz=\"0.0015\" \
             izz=\"0.008\"/></inertial></link>"
        );
    }
    text.push_str("</robot>");
    let mut errors = Errors::new();
    match read_text(&text, "chain.urdf", None, &mut errors) {
        Some(description) => errors.into_result(description),
        None => Err(errors),
    }
}

//! The arms of the example; add yours.
//!
//! In: the environment variable `ARM`. Out: the arm's description, tip and number of joints, for build scripts.

use std::env;

/// An arm.
pub struct Arm {
    /// Its name.
    pub name: &'static str,
    /// The path of its description, relative to this folder.
    pub urdf: &'static str,
    /// The link of the end effector.
    pub tip: &'static str,
    /// Number of joints.
    #[allow(dead_code, reason = "of the two build scripts one needs it")]
    pub joints: usize,
}

const ARMS: [Arm; 2] = [
    Arm {
        name: "panda_class",
        urdf: "../../robots/panda_class.urdf",
        tip: "link8",
        joints: 7,
    },
    Arm {
        name: "puma560",
        urdf: "../../robots/puma560.urdf",
        tip: "tool",
        joints: 6,
    },
];

/// The arm with the name in `ARM`; the first one if it is not set.
///
/// # Errors
/// A name that is not in the table.
pub fn chosen() -> Result<&'static Arm, String> {
    let Ok(name) = env::var("ARM") else {
        return Ok(&ARMS[0]);
    };
    let found = ARMS.iter().find(|arm| arm.name == name);
    found.ok_or_else(|| format!("ARM={name} is not in arms.rs"))
}

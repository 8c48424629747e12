//! The arms that the example knows; yours is one more.
//!
//! In: the variable `ARM`. Out: where its description lies and what a build script must know of it.

use std::env;

/// An arm.
pub struct Arm {
    /// What it is called.
    pub name: &'static str,
    /// Its description, seen from this folder.
    pub urdf: &'static str,
    /// The link whose pose matters.
    pub tip: &'static str,
    /// How many joints it has.
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

/// The arm that `ARM` names; the first where it names none.
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

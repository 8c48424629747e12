//! What `<compiler>` says of everything else.
//!
//! A shared noun, which begins as MuJoCo has it where a file says nothing.

use crate::description::Number;
use crate::expression::Double;

/// Whether inertias are those of geoms.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum FromGeoms {
    Never,
    Always,
    /// Where a body has no `<inertial>`.
    Otherwise,
}

/// The settings.
#[expect(clippy::struct_excessive_bools, reason = "each is a word of its own")]
pub(super) struct Compiler {
    /// Angles are in degrees.
    pub(super) degrees: bool,
    /// The axes of Euler angles; capital letters are fixed axes.
    pub(super) euler: [char; 3],
    /// A range is a limit where nothing else is said.
    pub(super) autolimits: bool,
    pub(super) from_geoms: FromGeoms,
    /// The groups of geoms that have mass.
    pub(super) groups: [f64; 2],
    /// The least mass of a body \[kg\].
    pub(super) bound_mass: Double,
    /// The least principal inertia of a body \[kg m²\].
    pub(super) bound_inertia: Double,
    /// Inertias that no body has are replaced by their mean.
    pub(super) balance: bool,
    /// The mass of all bodies together \[kg\].
    pub(super) total_mass: Option<Number>,
    /// The folder of meshes.
    pub(super) meshes: String,
    /// Folders in names of meshes are left out.
    pub(super) strip: bool,
    /// Shapes are fitted to meshes by their extents.
    pub(super) fit_extents: bool,
    /// Free bodies without children move with their inertial frame.
    pub(super) align_free: bool,
}

impl Default for Compiler {
    fn default() -> Self {
        Self {
            degrees: true,
            euler: ['x', 'y', 'z'],
            autolimits: true,
            from_geoms: FromGeoms::Otherwise,
            groups: [0.0, 5.0],
            bound_mass: Double::ZERO,
            bound_inertia: Double::ZERO,
            balance: false,
            total_mass: None,
            meshes: String::new(),
            strip: false,
            fit_extents: false,
            align_free: false,
        }
    }
}

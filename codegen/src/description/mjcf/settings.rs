//! Settings of `<compiler>`, with MuJoCo's defaults, and gravity.

use crate::description::Number;
use crate::description::number::computed;
use crate::error::Place;
use crate::expression::Double;

/// Source of inertias: `inertiafromgeom`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum FromGeoms {
    Never,
    Always,
    /// Only for bodies without `<inertial>`.
    Otherwise,
}

/// The settings.
#[derive(Clone)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is an attribute of its own"
)]
pub(super) struct Compiler {
    /// True if angles are in degrees.
    pub(super) degrees: bool,
    /// The axes of Euler angles; capital letters are fixed axes.
    pub(super) euler: [char; 3],
    /// True if a range makes a limit, unless `limited` is `false`.
    pub(super) autolimits: bool,
    pub(super) from_geoms: FromGeoms,
    /// Minimum and maximum group of the geoms that have mass.
    pub(super) groups: [f64; 2],
    /// Minimum mass of a body \[kg\].
    pub(super) bound_mass: Double,
    /// Minimum principal moment of inertia of a body \[kg m²\].
    pub(super) bound_inertia: Double,
    /// True if non-physical principal moments are replaced by their mean.
    pub(super) balance: bool,
    /// Mass that all bodies together are scaled to \[kg\].
    pub(super) total_mass: Option<Number>,
    /// The folder of meshes.
    pub(super) meshes: String,
    /// True if folders in the names of meshes are dropped.
    pub(super) strip: bool,
    /// True if shapes are fitted to meshes by their bounding boxes.
    pub(super) fit_extents: bool,
    /// True if frames of free bodies without children are moved to their inertial frames.
    pub(super) align_free: bool,
    pub(super) conflict: Conflict,
}

/// Treatment of settings of attached models.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Conflict {
    /// The settings of the model around them count.
    Warning,
    /// So does a setting that only the attached model writes.
    Merge,
    /// Different settings are an error.
    Error,
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
            conflict: Conflict::Warning,
        }
    }
}

/// Gravity as a model writes it.
#[derive(Clone, Copy, Default)]
pub(super) struct Gravity {
    /// The acceleration.
    pub(super) written: Option<[Number; 3]>,
    /// True if a flag switches it off, false if a flag leaves it on.
    pub(super) is_off: Option<(bool, Place)>,
}

impl Gravity {
    /// The acceleration that counts; `None` if the model does not write one.
    pub(super) fn acceleration(&self) -> Option<[Number; 3]> {
        match self.is_off {
            Some((true, place)) => Some([0.0; 3].map(|zero| computed(zero, place))),
            _ => self.written,
        }
    }
}

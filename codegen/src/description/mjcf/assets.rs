//! Meshes by name, and the inertias computed from them.

use std::collections::HashMap;
use std::rc::Rc;

use super::element::Element;
use crate::description::spatial::{Matrix, Vector};
use crate::expression::Double;

/// Inertia of a mesh at density 1.
pub(super) struct Measured {
    /// The volume \[m³\], or the area of a shell \[m²\].
    pub(super) measure: Double,
    /// The centre of mass in the frame of the geom \[m\].
    pub(super) center: Vector,
    /// Inertia tensor about the centre of mass, in the axes of the geom.
    pub(super) tensor: Matrix,
}

/// The meshes of a file by name, and the inertias computed so far; `None` for a mesh with an error.
#[derive(Default)]
pub(super) struct Meshes<'a> {
    pub(super) assets: HashMap<String, Element<'a>>,
    pub(super) measured: HashMap<String, Option<Rc<Measured>>>,
}

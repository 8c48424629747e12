//! Meshes by name, and what those are that were measured.
//!
//! A shared noun.

use std::collections::HashMap;
use std::rc::Rc;

use super::element::Element;
use super::spatial::{Matrix, Vector};
use crate::expression::Double;

/// What a mesh is as a body of density 1.
pub(super) struct Measured {
    /// The volume \[m³\], or the area of a shell \[m²\].
    pub(super) measure: Double,
    /// The centre of mass in the frame of the geom \[m\].
    pub(super) center: Vector,
    /// About that, in the axes of the geom.
    pub(super) tensor: Matrix,
}

/// The meshes of a file, by name; those that were measured, or refused.
#[derive(Default)]
pub(super) struct Meshes<'a> {
    pub(super) assets: HashMap<String, Element<'a>>,
    pub(super) measured: HashMap<String, Option<Rc<Measured>>>,
}

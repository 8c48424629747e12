//! `<mesh>` of the assets: the volume of a mesh, its centre and its moments.

use std::rc::Rc;

use super::Mjcf;
use super::spatial::{Matrix, Vector};
use crate::description::Name;
use crate::expression::Double;
use crate::wording::quoted;

/// What a mesh is as a body of density 1.
pub(super) struct Measured {
    /// The volume \[m³\], or the area of a shell \[m²\].
    pub(super) measure: Double,
    /// The centre of mass in the frame of the mesh \[m\].
    pub(super) center: Vector,
    /// About that, in the axes of the mesh.
    pub(super) tensor: Matrix,
}

impl Mjcf<'_> {
    /// The mesh of a name.
    pub(super) fn measured(&mut self, name: &Name, subject: &str) -> Option<Rc<Measured>> {
        let message = format!("mesh {} of {subject} is not read", quoted(&name.text));
        let hint = "give its body an <inertial>";
        self.reader.errors.push_with_hint(name.place, message, hint);
        None
    }
}

//! Meshes and height fields by name, and the inertias of meshes.

use std::collections::HashMap;
use std::rc::Rc;

use super::element::Element;
use crate::description::spatial::{Matrix, Vector, cross, exactly, principal};
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

/// Rounding errors of moments, relative to the largest: a mesh below this has no thickness.
const FLAT: f64 = 1e-14;

impl Measured {
    /// Half the side lengths of the box with the principal moments of the mesh, in ascending order, and its axes as
    /// columns.
    pub(super) fn inertia_box(&self) -> (Vector, Matrix) {
        let (moments, axes) = principal(&self.tensor);
        let mut order = [0, 1, 2];
        // The longest side has the smallest moment.
        order.sort_by(|&a, &b| moments[b].to_f64().total_cmp(&moments[a].to_f64()));
        let [a, b, c] = order.map(|k| moments[k]);
        // A box with half sides x, y, z and volume 1 has Iyy + Izz − Ixx = 2 x² / 3.
        let factor = exactly(1.5) / self.measure;
        let halves = [b + c - a, a + c - b, a + b - c].map(|sum| {
            if sum.to_f64() > FLAT * a.to_f64() {
                (factor * sum).sqrt()
            } else {
                Double::ZERO
            }
        });
        let [x, y, _] = order.map(|k| axes.map(|row| row[k]));
        // Right-handed, whatever the order.
        let columns = [x, y, cross(x, y)];
        (halves, [0, 1, 2].map(|i| columns.map(|column| column[i])))
    }
}

/// The assets of a file by name, and the inertias of meshes computed so far; `None` for a mesh with an error.
#[derive(Default)]
pub(super) struct Assets<'a> {
    pub(super) meshes: HashMap<String, Element<'a>>,
    pub(super) height_fields: HashMap<String, Element<'a>>,
    pub(super) measured: HashMap<String, Option<Rc<Measured>>>,
}

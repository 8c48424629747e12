//! Meshes and height fields of a model by name, and the inertias of meshes.

use std::collections::HashMap;
use std::rc::Rc;

use super::element::Element;
use super::parts::ModelId;
use crate::description::spatial::{
    DoubleMatrix, DoubleVector, cross, dot, exactly, minus, principal,
};
use crate::expression::Double;

/// Inertia of a mesh at density 1.
pub(super) struct MeshInertia {
    /// The volume \[m³\], or the area of a shell \[m²\].
    pub(super) measure: Double,
    /// The centre of mass in the frame of the geom \[m\].
    pub(super) center: DoubleVector,
    /// Inertia tensor about the centre of mass, in the axes of the geom.
    pub(super) tensor: DoubleMatrix,
    /// The vertices in the frame of the geom, if shapes are fitted to their extents.
    pub(super) corners: Vec<[f64; 3]>,
}

/// Rounding errors of moments, relative to the largest: a mesh below this has no thickness.
const FLAT: f64 = 1e-14;

impl MeshInertia {
    /// The centre and half the side lengths of the box around the vertices along the given axes (columns), in these axes
    /// and relative to the centre of mass.
    pub(super) fn extents(&self, axes: &DoubleMatrix) -> [DoubleVector; 2] {
        let along = [0, 1, 2].map(|k| {
            let axis = axes.map(|row| row[k]);
            let places = self.corners.iter().map(|corner| {
                let from_center = minus(corner.map(exactly), self.center);
                dot(axis, from_center).to_f64()
            });
            places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], place| {
                [low.min(place), high.max(place)]
            })
        });
        let two = exactly(2.0);
        [
            along.map(|[low, high]| (exactly(high) + exactly(low)) / two),
            along.map(|[low, high]| (exactly(high) - exactly(low)) / two),
        ]
    }

    /// Half the side lengths of the box with the principal moments of the mesh, in ascending order, and its axes as
    /// columns.
    pub(super) fn inertia_box(&self) -> (DoubleVector, DoubleMatrix) {
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

/// An asset.
#[derive(Clone, Copy)]
pub(super) struct Asset<'a> {
    /// The model whose settings and defaults count for it.
    pub(super) model: ModelId,
    pub(super) element: Element<'a>,
}

/// The assets of a model by name, and the inertias of meshes computed so far; `None` for a mesh with an error.
#[derive(Default)]
pub(super) struct Assets<'a> {
    pub(super) meshes: HashMap<String, Asset<'a>>,
    pub(super) height_fields: HashMap<String, Asset<'a>>,
    pub(super) measured: HashMap<String, Option<Rc<MeshInertia>>>,
}

impl<'a> Assets<'a> {
    /// The meshes and height fields under names with a prefix.
    pub(super) fn with_prefix(&self, prefix: &str) -> Self {
        let named = |assets: &HashMap<String, Asset<'a>>| {
            let assets = assets.iter();
            assets
                .map(|(name, asset)| (format!("{prefix}{name}"), *asset))
                .collect()
        };
        Self {
            meshes: named(&self.meshes),
            height_fields: named(&self.height_fields),
            measured: HashMap::new(),
        }
    }

    /// Adds the meshes and height fields of other names.
    pub(super) fn import(&mut self, others: Self) {
        for (name, mesh) in others.meshes {
            self.meshes.entry(name).or_insert(mesh);
        }
        for (name, field) in others.height_fields {
            self.height_fields.entry(name).or_insert(field);
        }
    }
}

//! `<geom>`: the mass of a shape as a part of its body.
//!
//! Visual and contact attributes are ignored.

use std::rc::Rc;

use super::assets::{Asset, MeshInertia};
use super::mesh::unknown;
use super::orientation::z_along;
use super::parts::ModelId;
use super::reading::Mjcf;
use super::shape::Shape;
use super::values::Attributes;
use crate::description::spatial::{
    self, DoubleMatrix, DoubleVector, Pose, Solid, diagonal, exactly, to_number,
};
use crate::description::{Number, Step};
use crate::error::Place;
use crate::expression::Double;
use crate::list::Id;

/// Masses \[kg\] and volumes \[m³\] up to this are zero, as in MuJoCo.
const NOTHING: f64 = 1e-14;

/// Default density of a geom \[kg/m³\].
const WATER: f64 = 1000.0;

/// Type of a geom.
#[derive(Clone, Copy, PartialEq, Eq)]
enum GeomType {
    Shape(Shape),
    Mesh,
    /// A signed distance field, which a plug-in makes.
    Field,
    /// A terrain.
    Heights,
    Plane,
}

const GEOM_TYPES: [(&str, GeomType); 9] = [
    ("sphere", GeomType::Shape(Shape::Sphere)),
    ("capsule", GeomType::Shape(Shape::Capsule)),
    ("cylinder", GeomType::Shape(Shape::Cylinder)),
    ("ellipsoid", GeomType::Shape(Shape::Ellipsoid)),
    ("box", GeomType::Shape(Shape::Box)),
    ("mesh", GeomType::Mesh),
    ("sdf", GeomType::Field),
    ("hfield", GeomType::Heights),
    ("plane", GeomType::Plane),
];

/// A part of a body: the mass of one geom.
pub(super) struct Piece {
    pub(super) mass: Double,
    /// From the body's frame to the principal or mesh frame at the part's centre of mass.
    pub(super) origin: Vec<Step>,
    /// Inertia tensor about the centre of mass, in the axes of that frame \[kg m²\].
    pub(super) tensor: DoubleMatrix,
    pub(super) place: Place,
}

impl Piece {
    /// The part in the axes of the body's frame.
    pub(super) fn solid(&self) -> Solid {
        let pose = Pose::of(&self.origin);
        Solid {
            mass: self.mass,
            center: pose.position,
            tensor: pose.tensor(&self.tensor),
        }
    }
}

impl<'a> Mjcf<'a> {
    /// The part of the body that a geom contributes; `frame` is its placement in the body, `groups` are the first and
    /// the last group that have mass. `None` if it has no mass.
    pub(super) fn piece(
        &mut self,
        geom: &Attributes<'a>,
        frame: &[Step],
        groups: [f64; 2],
        body: &str,
    ) -> Option<Piece> {
        let subject = match geom.own.attribute("name") {
            Some(name) => {
                let name = self.word(name);
                format!("geom {} of {body}", crate::wording::quoted(&name.text))
            }
            None => format!("a geom of {body}"),
        };
        let group = self.number(geom.get("group"), &subject);
        let group = group.map_or(0.0, |group| group.value);
        let [least, most] = groups;
        if group < least || group > most {
            return None;
        }
        let sphere = GeomType::Shape(Shape::Sphere);
        let form = self.choice(geom.get("type"), &GEOM_TYPES, sphere, &subject);
        let mass = self.number(geom.get("mass"), &subject);
        let density = self.number(geom.get("density"), &subject);
        // Nothing else of a massless geom is read, not even its mesh.
        let is_nothing = match (mass, density) {
            (Some(mass), _) => mass.value == 0.0,
            (None, Some(density)) => density.value == 0.0,
            (None, None) => false,
        };
        if is_nothing {
            return None;
        }
        let place = self.place(geom.own);
        let mut origin = frame.to_vec();
        let (measure, moments): (Double, Box<dyn Fn(Double) -> DoubleMatrix>) = match form {
            GeomType::Plane => return None,
            GeomType::Field => {
                let hint = "give its body an <inertial>";
                self.refuse(
                    geom.own,
                    format!("{subject} is a signed distance field of a plug-in, whose mass is not computed"),
                    hint,
                );
                return None;
            }
            GeomType::Heights => {
                let sizes = self.extents_of_heights(geom, &subject)?;
                origin.extend(self.placement(geom, &subject));
                let is_hollow = self.flag(geom.get("shellinertia"), false, &subject);
                let of = move |mass: Double| diagonal(Shape::Box.moments(mass, sizes, is_hollow));
                (Shape::Box.measure(sizes, is_hollow), Box::new(of))
            }
            GeomType::Mesh => {
                let mesh = self.mesh_of(geom, &subject)?;
                origin.extend(self.placement(geom, &subject));
                origin.push(Step::Translate(
                    mesh.center.map(|entry| to_number(entry, place)),
                ));
                let MeshInertia {
                    measure, tensor, ..
                } = *mesh;
                let of = move |mass: Double| tensor.map(|row| spatial::times(row, mass / measure));
                (measure, Box::new(of))
            }
            GeomType::Shape(shape) => {
                let (steps, sizes) = self.placement_of_shape(geom, shape, &subject)?;
                origin.extend(steps);
                let is_hollow = self.flag(geom.get("shellinertia"), false, &subject);
                let of = move |mass: Double| diagonal(shape.moments(mass, sizes, is_hollow));
                (shape.measure(sizes, is_hollow), Box::new(of))
            }
        };
        let is_tiny = measure.to_f64() <= NOTHING;
        let mass = match mass {
            Some(_) if is_tiny => return None,
            Some(mass) => mass.exact(),
            None => density.map_or(exactly(WATER), |density| density.exact()) * measure,
        };
        if mass.to_f64() < 0.0 {
            self.refuse(
                geom.own,
                format!("{subject} has a negative mass"),
                "write a mass or density of 0 or more",
            );
            return None;
        }
        (mass.to_f64() > NOTHING).then(|| Piece {
            mass,
            origin,
            tensor: moments(mass),
            place,
        })
    }

    /// The placement and the sizes of a shape.
    fn placement_of_shape(
        &mut self,
        geom: &Attributes<'a>,
        shape: Shape,
        subject: &str,
    ) -> Option<(Vec<Step>, DoubleVector)> {
        if geom.get("mesh").is_some() {
            return self.fitted(geom, shape, subject);
        }
        let entries = self.entries::<3>(geom, "size", subject);
        let mut sizes = entries.map(|entry| entry.map(|entry| entry.exact()));
        let steps = match geom.get("fromto") {
            None => self.placement(geom, subject),
            Some(ends) => {
                let ends = self.numbers::<6>(Some(ends), subject)?;
                if shape == Shape::Sphere {
                    let hint = "fromto is for capsules, cylinders, ellipsoids and boxes";
                    self.refuse(
                        geom.own,
                        format!("{subject} is a sphere and has fromto"),
                        hint,
                    );
                    return None;
                }
                let (steps, half) = self.between(geom, ends, subject)?;
                if matches!(shape, Shape::Ellipsoid | Shape::Box) {
                    sizes = [sizes[0], sizes[0], Some(half)];
                } else {
                    sizes[1] = Some(half);
                }
                steps
            }
        };
        let needed = &sizes[..shape.sizes()];
        let is_positive = |size: &Option<Double>| size.is_some_and(|size| size.to_f64() > 0.0);
        if !needed.iter().all(is_positive) {
            let message = format!("{subject} needs a positive size");
            let count = shape.sizes();
            let hint = format!("write {count} positive sizes, or give its body an <inertial>");
            self.refuse(geom.own, message, &hint);
            return None;
        }
        Some((steps, sizes.map(|size| size.unwrap_or(Double::ZERO))))
    }

    /// The placement and the sizes of a shape fitted to a mesh: to the box with its principal moments, or to its extents
    /// along its principal axes.
    fn fitted(
        &mut self,
        geom: &Attributes<'a>,
        shape: Shape,
        subject: &str,
    ) -> Option<(Vec<Step>, DoubleVector)> {
        if geom.get("fromto").is_some() {
            let message = format!("{subject} has both mesh and fromto");
            self.refuse(geom.own, message, "leave one of them out");
            return None;
        }
        let mesh = self.mesh_of(geom, subject)?;
        let place = self.place(geom.own);
        let scale = self.number(geom.get("fitscale"), subject);
        let scale = scale.map_or(exactly(1.0), |scale| scale.exact());
        let (halves, axes) = mesh.inertia_box();
        let is_around = self.fits_extents();
        let (center, sizes) = if is_around {
            let [center, halves] = mesh.extents(&axes);
            (Some(center), shape.around(halves))
        } else {
            (None, shape.fitted(halves))
        };
        let sizes = spatial::times(sizes, scale);
        // Only the tube of a capsule with the moments of the mesh may have no length.
        let needed = if shape == Shape::Capsule && !is_around {
            1
        } else {
            shape.sizes()
        };
        if sizes[..needed].iter().any(|size| size.to_f64() <= 0.0) {
            let message = format!("{subject} is fitted to a mesh without extent");
            self.refuse(geom.own, message, "give its body an <inertial>");
            return None;
        }
        let mut steps = self.placement(geom, subject);
        steps.push(Step::Translate(
            mesh.center.map(|entry| to_number(entry, place)),
        ));
        let axes = spatial::quaternion(&axes);
        steps.push(Step::Quaternion(axes.map(|entry| to_number(entry, place))));
        let center = center.map(|center| center.map(|entry| to_number(entry, place)));
        steps.extend(center.map(Step::Translate));
        Some((steps, sizes))
    }

    /// True if shapes are fitted to the extents of meshes. As in MuJoCo, the first file says so for all models.
    pub(super) fn fits_extents(&self) -> bool {
        self.models[ModelId::new(0)].compiler.fit_extents
    }

    /// Half the side lengths of the box that a height field counts as.
    fn extents_of_heights(&mut self, geom: &Attributes<'a>, subject: &str) -> Option<DoubleVector> {
        let Some(written) = geom.get("hfield") else {
            let message = format!("{subject} has no hfield");
            self.refuse(geom.own, message, "write hfield=\"…\"");
            return None;
        };
        let name = self.word(written);
        let height_fields = &self.model().assets.height_fields;
        let Some(&Asset { element, .. }) = height_fields.get(&name.text) else {
            let names = height_fields.keys().map(String::as_str);
            let refusal = unknown(
                "height field",
                "height fields",
                &name,
                names.collect(),
                subject,
            );
            self.reader.errors.record(refusal);
            return None;
        };
        let what = format!("height field {}", crate::wording::quoted(&name.text));
        let size = self.numbers::<4>(element.attribute("size"), &what);
        let Some([x, y, above, below]) = size.map(|size| size.map(|entry| entry.exact())) else {
            let hint = "write size=\"…\" with its extents, its height and its depth";
            self.refuse(element, format!("{what} has no size"), hint);
            return None;
        };
        // As in MuJoCo: a quarter of the height, and half of the depth.
        let half = above / exactly(4.0) + below / exactly(2.0);
        Some([x, y, half])
    }

    /// The placement of a shape between two points, and half of its length.
    pub(super) fn between(
        &mut self,
        geom: &Attributes<'a>,
        ends: [Number; 6],
        subject: &str,
    ) -> Option<(Vec<Step>, Double)> {
        let position = self.numbers::<3>(geom.get("pos"), subject);
        if position.is_some_and(|position| position.iter().any(|entry| entry.value != 0.0)) {
            let hint = "leave one of them out; a class of defaults may have it";
            self.refuse(geom.own, format!("{subject} has both pos and fromto"), hint);
            return None;
        }
        let place = ends[0].place;
        let [a, b, c, d, e, f] = ends.map(|entry| entry.exact());
        let (from, to) = ([a, b, c], [d, e, f]);
        let half = exactly(1.0) / exactly(2.0);
        let along = spatial::minus(from, to);
        let Some(rotation) = z_along(along, place) else {
            let hint = "the two points of fromto must differ";
            self.refuse(geom.own, format!("{subject} has no length"), hint);
            return None;
        };
        let center = spatial::times(spatial::plus(from, to), half);
        let steps = vec![
            Step::Translate(center.map(|entry| to_number(entry, place))),
            rotation,
        ];
        let length = spatial::dot(along, along).sqrt();
        Some((steps, length * half))
    }

    /// The mesh that a geom names.
    fn mesh_of(&mut self, geom: &Attributes<'a>, subject: &str) -> Option<Rc<MeshInertia>> {
        let Some(written) = geom.get("mesh") else {
            self.refuse(
                geom.own,
                format!("{subject} has no mesh"),
                "write mesh=\"…\"",
            );
            return None;
        };
        let name = self.word(written);
        self.measured(&name, subject)
    }
}

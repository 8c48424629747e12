//! `<geom>`: the mass that a shape gives to its body.
//!
//! In: a geom, with the class behind it and where it stands. Out: a [`Piece`], where it has mass; and complaints. It never
//! looks at what is seen or touched.

use std::rc::Rc;

use super::assets::Measured;
use super::orientation::z_along;
use super::reading::Mjcf;
use super::shape::Shape;
use super::spatial::{self, Matrix, Pose, Solid, Vector, diagonal, exactly, written};
use super::values::Attributes;
use crate::description::{Number, Step};
use crate::error::Place;
use crate::expression::Double;

/// Below this, in kg and m³, MuJoCo takes a geom for none.
const NOTHING: f64 = 1e-14;

/// The density of a geom of which none is said \[kg/m³\].
const WATER: f64 = 1000.0;

/// What a geom is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Shape(Shape),
    Mesh,
    /// A signed distance field, which a plug-in makes.
    Field,
    /// A terrain.
    Heights,
    Plane,
}

const FORMS: [(&str, Form); 9] = [
    ("sphere", Form::Shape(Shape::Sphere)),
    ("capsule", Form::Shape(Shape::Capsule)),
    ("cylinder", Form::Shape(Shape::Cylinder)),
    ("ellipsoid", Form::Shape(Shape::Ellipsoid)),
    ("box", Form::Shape(Shape::Box)),
    ("mesh", Form::Mesh),
    ("sdf", Form::Field),
    ("hfield", Form::Heights),
    ("plane", Form::Plane),
];

/// A part of a body.
pub(super) struct Piece {
    pub(super) mass: Double,
    /// From the body's frame to one at the part's centre.
    pub(super) origin: Vec<Step>,
    /// About that centre, in the axes of that frame.
    pub(super) tensor: Matrix,
    pub(super) place: Place,
}

impl Piece {
    /// The same in the axes of the body's frame.
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
    /// The part of a body that a geom is, in frames from the body's outwards; none where it has no mass.
    pub(super) fn piece(
        &mut self,
        geom: &Attributes<'a>,
        frame: &[Step],
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
        let [least, most] = self.compiler.groups;
        if group < least || group > most {
            return None;
        }
        let sphere = Form::Shape(Shape::Sphere);
        let form = self.choice(geom.get("type"), &FORMS, sphere, &subject);
        let mass = self.number(geom.get("mass"), &subject);
        let density = self.number(geom.get("density"), &subject);
        // Nothing is looked for that has no mass anyhow.
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
        let (measure, moments): (Double, Box<dyn Fn(Double) -> Matrix>) = match form {
            Form::Plane => return None,
            Form::Field => {
                let hint = "give its body an <inertial>";
                self.refuse(
                    geom.own,
                    format!("{subject} is made by a plug-in, and its mass is not read"),
                    hint,
                );
                return None;
            }
            Form::Heights => {
                let hint = "give its body an <inertial>, or the geom mass=\"0\"";
                self.refuse(
                    geom.own,
                    format!("{subject} is a terrain, and its mass is not read"),
                    hint,
                );
                return None;
            }
            Form::Mesh => {
                let mesh = self.mesh_of(geom, &subject)?;
                origin.extend(self.placement(geom, &subject));
                origin.push(Step::Translate(
                    mesh.center.map(|entry| written(entry, place)),
                ));
                let Measured {
                    measure, tensor, ..
                } = *mesh;
                let of = move |mass: Double| tensor.map(|row| spatial::times(row, mass / measure));
                (measure, Box::new(of))
            }
            Form::Shape(shape) => {
                let (steps, sizes) = self.stand(geom, shape, &subject)?;
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
            self.refuse(geom.own, format!("{subject} has a negative mass"), "");
            return None;
        }
        (mass.to_f64() > NOTHING).then(|| Piece {
            mass,
            origin,
            tensor: moments(mass),
            place,
        })
    }

    /// Where a shape stands, and its sizes.
    fn stand(
        &mut self,
        geom: &Attributes<'a>,
        shape: Shape,
        subject: &str,
    ) -> Option<(Vec<Step>, Vector)> {
        if geom.get("mesh").is_some() {
            let hint = "give its body an <inertial>, or the geom its own size";
            self.refuse(
                geom.own,
                format!("{subject} is fitted to a mesh, and its mass is not read"),
                hint,
            );
            return None;
        }
        let entries = self.entries::<3>(geom, "size", subject);
        let mut sizes = entries.map(|entry| entry.map(|entry| entry.exact()));
        let steps = match geom.get("fromto") {
            None => self.placement(geom, subject),
            Some(ends) => {
                let ends = self.numbers::<6>(Some(ends), subject)?;
                if shape == Shape::Sphere {
                    let hint = "only capsules, cylinders, ellipsoids and boxes have ends";
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
            let message = format!("{subject} has no positive size");
            let count = shape.sizes();
            let hint = format!("its type has {count}; or give its body an <inertial>");
            self.refuse(geom.own, message, &hint);
            return None;
        }
        Some((steps, sizes.map(|size| size.unwrap_or(Double::ZERO))))
    }

    /// Where something stands that lies between two points, and half of its length.
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
        let Some(turn) = z_along(along, place) else {
            let hint = "its ends are one point";
            self.refuse(geom.own, format!("{subject} has no length"), hint);
            return None;
        };
        let center = spatial::times(spatial::plus(from, to), half);
        let steps = vec![
            Step::Translate(center.map(|entry| written(entry, place))),
            turn,
        ];
        let length = spatial::dot(along, along).sqrt();
        Some((steps, length * half))
    }

    /// The mesh that a geom names.
    fn mesh_of(&mut self, geom: &Attributes<'a>, subject: &str) -> Option<Rc<Measured>> {
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

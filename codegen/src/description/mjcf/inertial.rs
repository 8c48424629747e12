//! The inertia of a body: that of its `<inertial>`, or of its geoms.
//!
//! In: what stands in a body. Out: an [`Inertial`], with what the compiler is told to mend; and complaints. It never
//! looks at joints.

use super::element::Element;
use super::geom::Piece;
use super::reading::Mjcf;
use super::settings::FromGeoms;
use super::spatial::{self, Matrix, Pose, diagonal, exactly, written};
use super::values::Attributes;
use crate::description::{Inertial, Number, Step, number};
use crate::error::Place;
use crate::expression::Double;

/// An inertia before it is mended.
struct Found {
    mass: Number,
    origin: Vec<Step>,
    /// xx, xy, xz, yy, yz, zz.
    tensor: [Number; 6],
    place: Place,
}

impl<'a> Mjcf<'a> {
    /// The inertia of a body; none where it has no mass.
    pub(super) fn inertia(
        &mut self,
        inertial: Option<Element<'a>>,
        pieces: impl FnOnce(&mut Self) -> Vec<Piece>,
        place: Place,
        subject: &str,
    ) -> Option<Inertial> {
        let explicit = inertial.and_then(|element| self.explicit(element, subject));
        let from_geoms = match self.compiler.from_geoms {
            FromGeoms::Never => false,
            FromGeoms::Always => true,
            FromGeoms::Otherwise => inertial.is_none(),
        };
        let of_geoms = if from_geoms {
            of_pieces(&pieces(self))
        } else {
            None
        };
        let found = of_geoms.or(explicit).or_else(|| {
            // Bodies without anything have the least mass.
            let bounds = [self.compiler.bound_mass, self.compiler.bound_inertia];
            let is_bounded = bounds.iter().any(|bound| bound.to_f64() > 0.0);
            let nothing = number::computed(Double::ZERO, place);
            is_bounded.then(|| Found {
                mass: nothing,
                origin: Vec::new(),
                tensor: [nothing; 6],
                place,
            })
        })?;
        if found.mass.value < 0.0 {
            let message = format!("the mass of {subject} is negative: {}", found.mass.value);
            self.reader.errors.push(found.mass.place, message);
        }
        Some(self.mended(found))
    }

    /// What an `<inertial>` says.
    fn explicit(&mut self, element: Element<'a>, body: &str) -> Option<Found> {
        let subject = format!("the <inertial> of {body}");
        let place = self.place(element);
        for name in ["pos", "mass"] {
            if element.attribute(name).is_none() {
                self.refuse(
                    element,
                    format!("{subject} has no {name}"),
                    "MuJoCo needs both pos and mass",
                );
                return None;
            }
        }
        let attributes = Attributes {
            own: element,
            kind: "",
            class: self.defaults.main(),
        };
        let origin = self.placement(&attributes, &subject);
        let mass = self.number(element.attribute("mass"), &subject)?;
        let zero = number::computed(Double::ZERO, place);
        let (full, diagonal) = (
            element.attribute("fullinertia"),
            element.attribute("diaginertia"),
        );
        let tensor = match (full, diagonal) {
            (Some(_), Some(_)) => {
                let hint = "leave one of them out";
                self.refuse(
                    element,
                    format!("{subject} has both fullinertia and diaginertia"),
                    hint,
                );
                return None;
            }
            (Some(full), None) => {
                let turned = ["axisangle", "euler", "xyaxes", "zaxis"];
                if turned.iter().any(|name| element.attribute(name).is_some()) {
                    let hint = "its axes are those of the body's frame";
                    self.refuse(
                        element,
                        format!("{subject} has fullinertia and is turned"),
                        hint,
                    );
                    return None;
                }
                let [xx, yy, zz, xy, xz, yz] = self.numbers::<6>(Some(full), &subject)?;
                [xx, xy, xz, yy, yz, zz]
            }
            (None, Some(diagonal)) => {
                let [xx, yy, zz] = self.numbers::<3>(Some(diagonal), &subject)?;
                [xx, zero, zero, yy, zero, zz]
            }
            (None, None) => [zero; 6],
        };
        // A quaternion beside a full tensor means nothing.
        let origin = match full {
            Some(_) => origin
                .into_iter()
                .filter(|step| matches!(step, Step::Translate(_)))
                .collect(),
            None => origin,
        };
        Some(Found {
            mass,
            origin,
            tensor,
            place,
        })
    }

    /// With the least mass and the least moments, and balanced, where the compiler is told so.
    fn mended(&self, found: Found) -> Inertial {
        let Found {
            mut mass,
            origin,
            tensor,
            place,
        } = found;
        let compiler = &self.compiler;
        if (compiler.bound_mass - mass.exact()).sign().to_f64() > 0.0 {
            mass = written(compiler.bound_mass, place);
        }
        let bound = compiler.bound_inertia;
        let inertia = if bound.to_f64() > 0.0 || compiler.balance {
            let [xx, xy, xz, yy, yz, zz] = tensor.map(|entry| entry.exact());
            let matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            match mended(&matrix, bound, compiler.balance) {
                Some(matrix) => spatial::entries(&matrix, place),
                None => tensor,
            }
        } else {
            tensor
        };
        Inertial {
            origin,
            mass,
            inertia,
            place,
        }
    }
}

/// A tensor whose principal moments are no less than a bound, and balanced where no body has them; none where it stays.
fn mended(tensor: &Matrix, bound: Double, balance: bool) -> Option<Matrix> {
    let (moments, axes) = spatial::principal(tensor);
    let is_below = |moment: &Double| (bound - *moment).sign().to_f64() > 0.0;
    let is_changed = moments.iter().any(is_below);
    let moments = moments.map(|moment| if is_below(&moment) { bound } else { moment });
    // As MuJoCo decides it: thin bodies lie on the edge.
    let [a, b, c] = moments.map(Double::to_f64);
    let is_of_no_body = a + b < c || a + c < b || b + c < a;
    if balance && is_of_no_body {
        let mean = (moments[0] + moments[1] + moments[2]) / exactly(3.0);
        return Some(diagonal([mean; 3]));
    }
    let frame = Pose {
        rotation: axes,
        position: [Double::ZERO; 3],
    };
    is_changed.then(|| frame.tensor(&diagonal(moments)))
}

/// The inertia of parts together: of one as it stands, of several in the axes of the body.
fn of_pieces(pieces: &[Piece]) -> Option<Found> {
    let first = pieces.first()?;
    let place = first.place;
    if pieces.len() == 1 {
        return Some(Found {
            mass: written(first.mass, place),
            origin: first.origin.clone(),
            tensor: spatial::entries(&first.tensor, place),
            place,
        });
    }
    let solids: Vec<_> = pieces.iter().map(Piece::solid).collect();
    let whole = spatial::together(&solids);
    let center = whole.center.map(|entry| written(entry, place));
    Some(Found {
        mass: written(whole.mass, place),
        origin: vec![Step::Translate(center)],
        tensor: spatial::entries(&whole.tensor, place),
        place,
    })
}

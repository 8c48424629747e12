//! Inertia of a body: from its `<inertial>`, or from its geoms.
//!
//! Applies `boundmass`, `boundinertia` and `balanceinertia` of the compiler.

use super::element::Element;
use super::geom::Piece;
use super::reading::Mjcf;
use super::settings::FromGeoms;
use super::values::Attributes;
use crate::description::spatial::{self, DoubleMatrix, Pose, diagonal, exactly, to_number};
use crate::description::{Inertial, Number, Step, number};
use crate::error::Place;
use crate::expression::Double;

/// An inertia before bounds and balance are applied.
struct RawInertia {
    mass: Number,
    origin: Vec<Step>,
    /// xx, xy, xz, yy, yz, zz.
    tensor: [Number; 6],
    place: Place,
}

impl<'a> Mjcf<'a> {
    /// The inertia of a body; `None` if it has none.
    pub(super) fn inertia(
        &mut self,
        inertial: Option<Element<'a>>,
        pieces: impl FnOnce(&mut Self) -> Vec<Piece>,
        place: Place,
        subject: &str,
    ) -> Option<Inertial> {
        let explicit = inertial.and_then(|element| self.explicit(element, subject));
        let from_geoms = match self.model().compiler.from_geoms {
            FromGeoms::Never => false,
            FromGeoms::Always => true,
            FromGeoms::Otherwise => inertial.is_none(),
        };
        let of_geoms = if from_geoms {
            of_pieces(&pieces(self))
        } else {
            None
        };
        let inertia = of_geoms.or(explicit).or_else(|| {
            // A body without inertia gets the minimum mass and moments.
            let bounds = [
                self.model().compiler.bound_mass,
                self.model().compiler.bound_inertia,
            ];
            let is_bounded = bounds.iter().any(|bound| bound.to_f64() > 0.0);
            let nothing = number::computed(Double::ZERO, place);
            is_bounded.then(|| RawInertia {
                mass: nothing,
                origin: Vec::new(),
                tensor: [nothing; 6],
                place,
            })
        })?;
        if inertia.mass.value < 0.0 {
            let message = format!("the mass of {subject} is negative: {}", inertia.mass.value);
            self.reader.errors.push(inertia.mass.place, message);
        }
        Some(self.bounded(inertia))
    }

    /// The inertia in an `<inertial>`.
    fn explicit(&mut self, element: Element<'a>, body: &str) -> Option<RawInertia> {
        let subject = format!("the <inertial> of {body}");
        let place = self.place(element);
        for name in ["pos", "mass"] {
            if element.attribute(name).is_none() {
                self.refuse(
                    element,
                    format!("{subject} has no {name}"),
                    "write both pos and mass, as MuJoCo requires",
                );
                return None;
            }
        }
        let attributes = Attributes {
            own: element,
            kind: "",
            class: self.model().defaults.main(),
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
                let orientations = ["axisangle", "euler", "xyaxes", "zaxis"];
                if orientations
                    .iter()
                    .any(|name| element.attribute(name).is_some())
                {
                    let hint =
                        "fullinertia is in the axes of the body's frame: remove the orientation";
                    self.refuse(
                        element,
                        format!("{subject} has both fullinertia and an orientation"),
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
        // As in MuJoCo, a quaternion beside a full tensor is ignored.
        let origin = match full {
            Some(_) => origin
                .into_iter()
                .filter(|step| matches!(step, Step::Translate(_)))
                .collect(),
            None => origin,
        };
        Some(RawInertia {
            mass,
            origin,
            tensor,
            place,
        })
    }

    /// Applies the minimum mass and moments, and balances the moments, as the compiler's settings say.
    fn bounded(&self, inertia: RawInertia) -> Inertial {
        let RawInertia {
            mut mass,
            origin,
            tensor,
            place,
        } = inertia;
        let compiler = &self.model().compiler;
        if (compiler.bound_mass - mass.exact()).sign().to_f64() > 0.0 {
            mass = to_number(compiler.bound_mass, place);
        }
        let bound = compiler.bound_inertia;
        let inertia = if bound.to_f64() > 0.0 || compiler.balance {
            let [xx, xy, xz, yy, yz, zz] = tensor.map(|entry| entry.exact());
            let matrix = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            match bounded(&matrix, bound, compiler.balance) {
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

/// A tensor with principal moments of at least `bound`, and balanced if they are non-physical; `None` if it stays the
/// same.
fn bounded(tensor: &DoubleMatrix, bound: Double, balance: bool) -> Option<DoubleMatrix> {
    let (moments, axes) = spatial::principal(tensor);
    let is_below = |moment: &Double| (bound - *moment).sign().to_f64() > 0.0;
    let is_changed = moments.iter().any(is_below);
    let moments = moments.map(|moment| if is_below(&moment) { bound } else { moment });
    // In `f64`, as MuJoCo decides it: thin bodies fulfil the triangle inequality with equality.
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

/// The inertia of all parts: of a single part in its own frame, of several in the axes of the body.
fn of_pieces(pieces: &[Piece]) -> Option<RawInertia> {
    let first = pieces.first()?;
    let place = first.place;
    if pieces.len() == 1 {
        return Some(RawInertia {
            mass: to_number(first.mass, place),
            origin: first.origin.clone(),
            tensor: spatial::entries(&first.tensor, place),
            place,
        });
    }
    let solids: Vec<_> = pieces.iter().map(Piece::solid).collect();
    let whole = spatial::together(&solids);
    let center = whole.center.map(|entry| to_number(entry, place));
    Some(RawInertia {
        mass: to_number(whole.mass, place),
        origin: vec![Step::Translate(center)],
        tensor: spatial::entries(&whole.tensor, place),
        place,
    })
}

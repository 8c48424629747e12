//! Numbers as written, with the corrections of the report.
//!
//! In: offsets, angles and axes, and the struct fields that replace some. Out: dense matrices and directions. That a
//! number is a right angle or zero, as a report claims, is checked against its digits.

use std::f64::consts::FRAC_PI_2;

use super::matrices::{by_products, by_quaternion, of_length_1, placed};
use super::{Approximate, Contradiction, RobotReader};
use crate::dense::Matrix;
use crate::description::{Axis, Joint, Number, Step};
use crate::expression::Arithmetic;
use crate::list::Id;
use crate::request::Target;
use crate::space::FieldId;

impl RobotReader<'_> {
    /// The value of the field with a target.
    pub(super) fn field<const N: usize>(
        &self,
        is: impl Fn(&Target) -> bool,
    ) -> Option<[Approximate; N]> {
        let mut parameters = self.request.parameters.iter();
        let field = parameters.position(|parameter| is(&parameter.target))?;
        Some(std::array::from_fn(|k| {
            Approximate::exact(self.fields[FieldId::new(field)][k])
        }))
    }

    /// The pose of the base, if a field sets it.
    pub(super) fn base(&self) -> Option<Matrix<Approximate>> {
        let position = self.field(|target| matches!(target, Target::BasePosition));
        let placement = self.field(|target| matches!(target, Target::BasePlacement));
        position.map(Matrix::translation).or(placement.map(placed))
    }

    pub(super) fn gravity(&self) -> [Approximate; 3] {
        let field = self.field(|target| matches!(target, Target::Gravity));
        let described = self
            .request
            .gravity
            .map(|gravity| gravity.map(|entry| Approximate::written(entry.exact())));
        let described = described.unwrap_or([0.0, 0.0, -9.81].map(Approximate::literal));
        field.unwrap_or(described)
    }

    pub(super) fn origin(&self, joint: &Joint) -> Result<Matrix<Approximate>, Contradiction> {
        let name = &joint.name.text;
        let mut placement = self.placement(name, &joint.origin)?;
        let field = self.field(|target| matches!(target, Target::OriginOf(of) if of.text == *name));
        if let Some(offset) = field {
            placement.set_column(offset);
        }
        let field =
            self.field(|target| matches!(target, Target::PlacementOf(of) if of.text == *name));
        Ok(field.map_or(placement, placed))
    }

    /// A direction, of length 1.
    pub(super) fn direction(
        &self,
        joint: &Joint,
        axis: &[Number; 3],
    ) -> Result<[Approximate; 3], Contradiction> {
        let axis = self.components(&joint.name.text, axis)?;
        Ok(of_length_1(axis))
    }

    pub(super) fn placement(
        &self,
        item: &str,
        steps: &[Step],
    ) -> Result<Matrix<Approximate>, Contradiction> {
        let mut placement = Matrix::identity();
        for step in steps {
            let step = match step {
                Step::Translate(offset) => Matrix::translation(self.components(item, offset)?),
                Step::Rotate(axis, angle) => {
                    let axis = match axis {
                        Axis::X => 0,
                        Axis::Y => 1,
                        Axis::Z => 2,
                    };
                    let sine_and_cosine = match self.quarters(item, angle)? {
                        Some(quarters) => {
                            let [sine, cosine] = [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [-1.0, 0.0]]
                                [usize::try_from(quarters.rem_euclid(4)).unwrap_or(0)];
                            (Approximate::literal(sine), Approximate::literal(cosine))
                        }
                        None => Approximate::written(angle.exact()).sin_cos(),
                    };
                    Matrix::rotation(axis, sine_and_cosine)
                }
                Step::Quaternion(entries) => self.turned(item, entries)?,
            };
            placement = placement.times(&step);
        }
        Ok(placement)
    }

    /// The rotation by a quaternion. That it is one by right angles, as a report claims, is checked against its digits.
    fn turned(
        &self,
        item: &str,
        entries: &[Number; 4],
    ) -> Result<Matrix<Approximate>, Contradiction> {
        let written = entries.map(|entry| entry.value);
        let bits = written.map(f64::to_bits);
        let Some(&squares) = self.turned.get(&(item, bits)) else {
            let is_large = written.iter().any(|entry| entry.abs() >= 0.5);
            let mut meant = entries.map(|entry| Approximate::written(entry.exact()));
            if is_large {
                for (meant, entry) in meant.iter_mut().zip(entries) {
                    *meant = self.component(item, entry)?;
                }
            }
            return Ok(by_quaternion(meant));
        };
        let excused = entries.iter().zip(squares).all(|(entry, square)| {
            #[expect(clippy::cast_precision_loss, reason = "at most 4")]
            let meant = (square.abs() as f64 / 4.0).sqrt() * square.signum() as f64;
            let digits = 0.5 * entry.resolution + entry.value.abs() * f64::EPSILON;
            (entry.value - meant).abs() <= (1.0 + 1e-6) * digits.max(4.0 * f64::EPSILON)
        });
        let is_of_length_1 = squares.iter().map(|square| square.abs()).sum::<i64>() == 4;
        if !excused || !is_of_length_1 || self.request.exact {
            return Err(Contradiction(format!(
                "that {written:?} of {item} is rounded"
            )));
        }
        // 4 a b of two entries is an integer, since both squares are the same; the matrix has entries 0 and ±1.
        let product = |a: i64, b: i64| {
            #[expect(clippy::cast_precision_loss, reason = "at most 4")]
            let product = (a.signum() * b) as f64;
            Approximate::exact(product)
        };
        Ok(by_products(squares, product, Approximate::exact(0.5)))
    }

    pub(super) fn components(
        &self,
        item: &str,
        numbers: &[Number; 3],
    ) -> Result<[Approximate; 3], Contradiction> {
        let [x, y, z] = numbers;
        let component = |number| self.component(item, number);
        Ok([component(x)?, component(y)?, component(z)?])
    }

    /// An entry of an offset or an axis.
    fn component(&self, item: &str, number: &Number) -> Result<Approximate, Contradiction> {
        let zero =
            number.value != 0.0 && self.snapped.contains_key(&(item, number.value.to_bits()));
        if zero && self.quarters(item, number)? == Some(0) {
            return Ok(Approximate::literal(0.0));
        }
        Ok(Approximate::written(number.exact()))
    }

    /// The quarter turns that a number was taken for, if they are within its digits or its last bits.
    fn quarters(&self, item: &str, number: &Number) -> Result<Option<i64>, Contradiction> {
        let Some(&quarters) = self.snapped.get(&(item, number.value.to_bits())) else {
            // `pi/2` is exact, and so is 0.
            let quarters = (number.value / FRAC_PI_2).round();
            let distance = (number.value - quarters * FRAC_PI_2).abs();
            let is_exact = number.resolution == 0.0
                && quarters.abs() <= 1e6
                && distance <= number.value.abs() * f64::EPSILON;
            #[expect(clippy::cast_possible_truncation, reason = "a whole number of turns")]
            return Ok(is_exact.then_some(quarters as i64));
        };
        #[expect(clippy::cast_precision_loss, reason = "few turns are many")]
        let distance = (number.value - quarters as f64 * FRAC_PI_2).abs();
        let digits = 0.5 * number.resolution + number.value.abs() * f64::EPSILON;
        let excused = distance <= (1.0 + 1e-6) * digits.max(4.0 * f64::EPSILON);
        if excused && !self.request.exact {
            Ok(Some(quarters))
        } else {
            let written = number.value;
            Err(Contradiction(format!(
                "that {written} of {item} is rounded"
            )))
        }
    }
}

//! Rotation matrices of quaternions, recognized by how their entries are computed.
//!
//! In: steps, and the inputs that are entries x, y, z, w of quaternions of length 1. Out: the steps that are polynomials
//! of second degree in these, their ranges, and those that are entries of R = 1 + 2 w v̲ + 2 v̲² with v = (x, y, z). It
//! never looks at a label.
//!
//! With n = x² + y² + z² + w² and the rotation R̂ of the quaternion over its length, R = n R̂ + (1 − n) 1, so that R
//! lengthens no vector where n ≤ 1, and by 1 + 2 (n − 1) at most elsewhere.

use std::collections::HashMap;

use crate::expression::Input;
use crate::list::Id;
use crate::real::Real;
use crate::schedule::{Operand, Operation};
use crate::space::{CoordinateId, Variable};

/// Σ aᵢⱼ qᵢ qⱼ over i ≤ j, with q₄ = 1.
type Terms = [[f64; 5]; 5];

/// A polynomial in the entries of one quaternion, given by its first coordinate; none where it is a number.
#[derive(Clone, Copy)]
struct Polynomial {
    quaternion: Option<CoordinateId>,
    terms: Terms,
}

/// An entry of the rotation matrix of a quaternion, or the opposite of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// The first coordinate of the quaternion.
    pub quaternion: CoordinateId,
    /// Row and column.
    pub place: [usize; 2],
    /// 1, or −1 where it is the opposite.
    pub sign: f64,
}

/// The polynomials among the steps of a program so far.
#[derive(Default)]
pub struct Rotations(HashMap<u32, (Polynomial, Option<Entry>)>);

/// How much n is above 1 at most, in units of roundoff: entries are rounded, after a division by a computed length.
const ROUNDED: f64 = 16.0;

/// Far more than numbers differ from what they stand for, whose polynomials are ranges' here.
const MARGIN: f64 = 1e-9;

/// The greatest n.
fn longest(scalar: Real) -> f64 {
    1.0 + ROUNDED * scalar.roundoff() + MARGIN
}

/// The greatest factor by which a rotation matrix of a quaternion lengthens a vector.
pub fn stretch(scalar: Real) -> f64 {
    2.0 * longest(scalar) - 1.0
}

impl Rotations {
    /// Takes in a step; the range of its exact value, where it is a polynomial.
    pub fn take(
        &mut self,
        step: u32,
        operation: Operation,
        quaternions: &[CoordinateId],
        scalar: Real,
    ) -> Option<[f64; 2]> {
        let of = |operand| self.of(operand, quaternions);
        let polynomial = match operation {
            Operation::Add(a, b) => of(a)?.plus(1.0, of(b)?),
            Operation::Sub(a, b) => of(a)?.plus(-1.0, of(b)?),
            Operation::Mul(a, b) => of(a)?.times(of(b)?),
            Operation::MulAdd(a, b, c) => of(a)?.times(of(b)?)?.plus(1.0, of(c)?),
            Operation::MulSub(a, b, c) => of(a)?.times(of(b)?)?.plus(-1.0, of(c)?),
            Operation::NegMulAdd(a, b, c) => of(c)?.plus(-1.0, of(a)?.times(of(b)?)?),
            Operation::Div(..) | Operation::Sqrt(_) | Operation::Sign(_) | Operation::Neg(_) => {
                None
            }
        }?;
        self.0.insert(step, (polynomial, polynomial.entry()));
        Some(polynomial.range(longest(scalar)))
    }

    /// The polynomial that an operand is.
    fn of(&self, operand: Operand, quaternions: &[CoordinateId]) -> Option<Polynomial> {
        let mut terms = Terms::default();
        match operand {
            Operand::Step(step) => Some(self.0.get(&step)?.0),
            Operand::Literal(number) => {
                terms[4][4] = number;
                Polynomial::exact(None, terms)
            }
            Operand::Input(Input::Variable(Variable::Q, k)) => {
                let entry = |first: &CoordinateId| usize::from(k).checked_sub(first.index());
                let mut places = quaternions.iter().map(|first| (first, entry(first)));
                let (first, entry) = places.find(|(_, entry)| matches!(entry, Some(0..4)))?;
                terms[entry?][4] = 1.0;
                Polynomial::exact(Some(*first), terms)
            }
            _ => None,
        }
    }

    /// The entry of a rotation matrix that an operand is.
    pub fn entry(&self, operand: Operand) -> Option<Entry> {
        match operand {
            Operand::Step(step) => self.0.get(&step)?.1,
            _ => None,
        }
    }

    /// Whether some steps are entries in one row, or one column, of a rotation matrix.
    pub fn are_in_line(&self, steps: &[u32]) -> bool {
        let entries: Option<Vec<Entry>> = (steps.iter())
            .map(|&step| self.entry(Operand::Step(step)))
            .collect();
        let Some(entries) = entries else {
            return false;
        };
        (0..2).any(|axis| {
            entries.windows(2).all(|pair| {
                let [a, b] = [pair[0], pair[1]];
                a.quaternion == b.quaternion
                    && a.place[axis] == b.place[axis]
                    && a.place[1 - axis] != b.place[1 - axis]
            })
        })
    }
}

impl Polynomial {
    /// Of terms in whose sums and products no digit is lost.
    fn exact(quaternion: Option<CoordinateId>, terms: Terms) -> Option<Self> {
        const PARTS: f64 = 64.0;
        let few = |term: &f64| term.abs() <= PARTS && (PARTS * term).fract() == 0.0;
        let exact = terms.iter().flatten().all(few);
        exact.then_some(Self { quaternion, terms })
    }

    /// The quaternion of two polynomials, where there are not two.
    fn beside(self, other: Self) -> Option<Option<CoordinateId>> {
        match (self.quaternion, other.quaternion) {
            (Some(a), Some(b)) if a != b => None,
            (a, b) => Some(a.or(b)),
        }
    }

    fn plus(self, sign: f64, other: Self) -> Option<Self> {
        let mut terms = self.terms;
        for (sum, term) in terms.iter_mut().flatten().zip(other.terms.iter().flatten()) {
            *sum += sign * term;
        }
        Self::exact(self.beside(other)?, terms)
    }

    fn times(self, other: Self) -> Option<Self> {
        let [a, b] = [self.linear()?, other.linear()?];
        let mut terms = Terms::default();
        for (i, x) in a.into_iter().enumerate() {
            for (j, y) in b.into_iter().enumerate() {
                terms[i.min(j)][i.max(j)] += x * y;
            }
        }
        Self::exact(self.beside(other)?, terms)
    }

    /// Its factors of x, y, z, w and 1, where it is of first degree.
    fn linear(self) -> Option<[f64; 5]> {
        let quadratic = self.terms.iter().flat_map(|row| &row[..4]);
        let is_linear = quadratic.into_iter().all(|term| *term == 0.0);
        is_linear.then(|| self.terms.map(|row| row[4]))
    }

    /// Its range: eigenvalues of a symmetric matrix are in the discs of Gershgorin.
    fn range(self, longest: f64) -> [f64; 2] {
        let Self { terms, .. } = self;
        let linear = (0..4).map(|i| terms[i][4] * terms[i][4]).sum::<f64>();
        let linear = (linear * longest).sqrt() + MARGIN;
        let discs = (0..4).map(|i| {
            let beside = (0..4).filter(|&j| j != i);
            let radius = beside.map(|j| terms[i.min(j)][i.max(j)].abs() / 2.0);
            (terms[i][i], radius.sum::<f64>())
        });
        let [least, most] = discs.fold([0.0_f64; 2], |[least, most], (center, radius)| {
            [least.min(center - radius), most.max(center + radius)]
        });
        let constant = terms[4][4];
        [
            constant + least * longest - linear,
            constant + most * longest + linear,
        ]
    }

    /// The entry of the rotation matrix that it is.
    fn entry(self) -> Option<Entry> {
        let places = (0..3).flat_map(|row| (0..3).map(move |column| [row, column]));
        let mut signed = places.flat_map(|place| [(place, 1.0), (place, -1.0)]);
        let quaternion = self.quaternion?;
        let (place, sign) = signed.find(|&(place, sign)| {
            rotation(place).map(|row| row.map(|term| sign * term)) == self.terms
        })?;
        Some(Entry {
            quaternion,
            place,
            sign,
        })
    }
}

/// An entry of R = 1 + 2 w v̲ + 2 v̲².
fn rotation([row, column]: [usize; 2]) -> Terms {
    let mut terms = Terms::default();
    if row == column {
        terms[4][4] = 1.0;
        for other in (0..3).filter(|&other| other != row) {
            terms[other][other] = -2.0;
        }
    } else {
        let third = 3 - row - column;
        terms[row.min(column)][row.max(column)] = 2.0;
        // v̲ has −vₖ in the rows and columns (0, 1), (1, 2), (2, 0).
        terms[third][3] = if (row + 1) % 3 == column { -2.0 } else { 2.0 };
    }
    terms
}

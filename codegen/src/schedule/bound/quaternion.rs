//! Rotation matrices of quaternions, recognised by the computation of their entries.
//!
//! In: steps, and the inputs that are entries x, y, z, w of unit quaternions. Out: the ranges of steps that are
//! polynomials of second degree in these, and the steps that are entries of R = 1 + 2 w v̲ + 2 v̲² with v = (x, y, z).
//!
//! With n = x² + y² + z² + w² and the rotation R̂ of the normalised quaternion, R = n R̂ + (1 − n) 1. R lengthens no
//! vector if n ≤ 1, and by a factor of at most 2n − 1 otherwise.

use std::collections::HashMap;
use std::mem::replace;

use crate::expression::Input;
use crate::real::Real;
use crate::schedule::{Operand, Operation};

/// Σ aᵢⱼ qᵢ qⱼ over i ≤ j, with q₄ = 1.
type Polynomial = [[f64; 5]; 5];

/// An entry of the rotation matrix of a quaternion, or its negative.
#[derive(Clone, Copy)]
pub struct RotationEntry {
    /// The first entry of the quaternion.
    pub quaternion: Input,
    /// Row and column.
    pub place: [usize; 2],
    /// 1, or −1 for the negative.
    pub sign: f64,
}

/// Steps that are polynomials in a quaternion, by its first entry.
#[derive(Default)]
pub struct Polynomials(HashMap<u32, (Input, Polynomial)>);

/// Margin of the ranges of polynomials, for literals that are taken as printed and are rounded.
const MARGIN: f64 = 1e-9;

/// Index of an input among the entries of a quaternion.
fn place(input: Input, first: Input) -> Option<usize> {
    match (input, first) {
        (Input::Variable(of, k), Input::Variable(same, first)) if of == same => k
            .checked_sub(first)
            .map(usize::from)
            .filter(|place| *place < 4),
        _ => None,
    }
}

/// Factor on the range of an input: above 1 for an entry of a quaternion, which rounding may make longer than 1.
pub fn beyond(input: Input, quaternions: &[Input], scalar: Real) -> f64 {
    let is_entry = |&first: &Input| place(input, first).is_some();
    if quaternions.iter().any(is_entry) {
        longest(scalar).sqrt()
    } else {
        1.0
    }
}

/// Largest n. Entries that were divided by a computed length leave n within 10 unit roundoffs of 1.
fn longest(scalar: Real) -> f64 {
    1.0 + 16.0 * scalar.roundoff() + MARGIN
}

/// Largest factor by which R lengthens a vector.
pub fn stretch(scalar: Real) -> f64 {
    2.0 * longest(scalar) - 1.0
}

impl Polynomials {
    /// Adds a step. For a polynomial: the range of its exact value, and the entry of R that it is.
    pub fn take(
        &mut self,
        step: u32,
        operation: Operation,
        quaternions: &[Input],
        scalar: Real,
    ) -> Option<([f64; 2], Option<RotationEntry>)> {
        let (first, polynomial) = quaternions.iter().find_map(|&first| {
            let of = |operand| self.polynomial(operand, first);
            let polynomial = match operation {
                Operation::Add(a, b) => sum(&of(a)?, 1.0, &of(b)?),
                Operation::Sub(a, b) => sum(&of(a)?, -1.0, &of(b)?),
                Operation::Mul(a, b) => product(&of(a)?, &of(b)?),
                Operation::MulAdd(a, b, c) => sum(&product(&of(a)?, &of(b)?)?, 1.0, &of(c)?),
                Operation::MulSub(a, b, c) => sum(&product(&of(a)?, &of(b)?)?, -1.0, &of(c)?),
                Operation::NegMulAdd(a, b, c) => sum(&of(c)?, -1.0, &product(&of(a)?, &of(b)?)?),
                _ => None,
            };
            Some((first, polynomial?))
        })?;
        self.0.insert(step, (first, polynomial));
        let entry = RotationEntry::of(first, &polynomial);
        Some((range(&polynomial, longest(scalar)), entry))
    }

    /// An operand as a polynomial in the entries of a quaternion.
    fn polynomial(&self, operand: Operand, first: Input) -> Option<Polynomial> {
        let mut polynomial = Polynomial::default();
        match operand {
            Operand::Step(step) => {
                let found = self.0.get(&step).filter(|found| found.0 == first);
                return found.map(|found| found.1);
            }
            Operand::Literal(number) => polynomial[4][4] = number,
            Operand::Input(input) => polynomial[place(input, first)?][4] = 1.0,
            Operand::Sin(_) | Operand::Cos(_) => return None,
        }
        exact(polynomial)
    }
}

impl RotationEntry {
    /// The entry of R that a polynomial equals, up to its sign.
    fn of(quaternion: Input, polynomial: &Polynomial) -> Option<Self> {
        (0..18).find_map(|k| {
            let (place, sign) = ([k / 3 % 3, k % 3], if k < 9 { 1.0 } else { -1.0 });
            let entry = rotation(place).map(|row| row.map(|term| sign * term));
            (entry == *polynomial).then_some(Self {
                quaternion,
                place,
                sign,
            })
        })
    }

    /// True for different entries in one row or one column of the same R: together they are no longer than a unit
    /// vector multiplied by R.
    pub fn are_in_line(entries: &[Self]) -> bool {
        (0..2).any(|axis| {
            let mut others = [false; 3];
            entries.iter().all(|entry| {
                let is_same = entry.quaternion == entries[0].quaternion;
                let is_new = !replace(&mut others[entry.place[1 - axis]], true);
                is_same && is_new && entry.place[axis] == entries[0].place[axis]
            })
        })
    }
}

/// The polynomial if its coefficients have few enough digits for exact sums and products.
fn exact(polynomial: Polynomial) -> Option<Polynomial> {
    const PARTS: f64 = 64.0;
    let few = |term: &f64| term.abs() <= PARTS && (PARTS * term).fract() == 0.0;
    polynomial.iter().flatten().all(few).then_some(polynomial)
}

fn sum(a: &Polynomial, sign: f64, b: &Polynomial) -> Option<Polynomial> {
    let mut sum = *a;
    for (sum, term) in sum.iter_mut().flatten().zip(b.iter().flatten()) {
        *sum += sign * term;
    }
    exact(sum)
}

/// The product of two polynomials of first degree.
fn product(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    let is_linear = |of: &Polynomial| of.iter().flat_map(|row| &row[..4]).all(|term| *term == 0.0);
    let mut product = Polynomial::default();
    for (i, row) in a.iter().enumerate() {
        for (j, other) in b.iter().enumerate() {
            product[i.min(j)][i.max(j)] += row[4] * other[4];
        }
    }
    exact(product).filter(|_| is_linear(a) && is_linear(b))
}

/// Range of a polynomial by Gershgorin discs, which contain the eigenvalues of a symmetric matrix.
fn range(of: &Polynomial, longest: f64) -> [f64; 2] {
    let linear = (0..4).map(|i| of[i][4] * of[i][4]).sum::<f64>();
    let linear = (linear * longest).sqrt() + MARGIN;
    let (mut least, mut most) = (0.0_f64, 0.0_f64);
    for i in 0..4 {
        let beside = (0..4).filter(|&j| j != i);
        let radius = beside.map(|j| of[i.min(j)][i.max(j)].abs() / 2.0);
        let radius = radius.sum::<f64>();
        least = least.min(of[i][i] - radius);
        most = most.max(of[i][i] + radius);
    }
    let constant = of[4][4];
    [
        constant + least * longest - linear,
        constant + most * longest + linear,
    ]
}

/// An entry of R = 1 + 2 w v̲ + 2 v̲².
fn rotation([row, column]: [usize; 2]) -> Polynomial {
    let mut entry = Polynomial::default();
    if row == column {
        entry[4][4] = 1.0;
        for other in (0..3).filter(|&other| other != row) {
            entry[other][other] = -2.0;
        }
    } else {
        entry[row.min(column)][row.max(column)] = 2.0;
        // v̲ has −z in row 0, column 1, and so on cyclically.
        let sign = if (row + 1) % 3 == column { -1.0 } else { 1.0 };
        entry[3 - row - column][3] = 2.0 * sign;
    }
    entry
}

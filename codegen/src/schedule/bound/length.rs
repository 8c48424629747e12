//! Bounds of vectors: length of a few values together.
//!
//! In: the values of a program up to a step, and the forms of its sums. Out: bounds of √(a² + b² + …) of values and of
//! their errors that rotations do not increase. Ranges of single entries would grow by √2 with each rotation, and by
//! 128 for seven joints there and back.

use std::f64::consts::SQRT_2;

use super::combination::{Column, Combination, ROWS};
use super::group::{self, ColumnGroup};
use super::kind::{ColumnKind, Monomial, StepForm};
use super::known::Known;
use super::norm::{both, norm, root};
use super::quaternion::{RotationEntry, stretch};
use super::value::Value;
use crate::index::{Index, spread};
use crate::real::Real;
use crate::schedule::{Operand, number};

/// √(a² + b² + …) of exact values, and of their errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Length {
    /// Length of the values.
    pub size: f64,
    /// Length of the errors.
    pub error: f64,
}

impl Length {
    /// Rounding error of two products and their sum, for a vector of this length and another.
    pub fn roundings(self, other: Self, scalar: Real) -> f64 {
        let size = (self.size + self.error) * (other.size + other.error);
        let roundoff = scalar.roundoff();
        (2.0 + roundoff) * roundoff * size + 3.0 * scalar.smallest()
    }

    const UNKNOWN: Self = Self {
        size: f64::INFINITY,
        error: f64::INFINITY,
    };

    /// Length of the entries of both vectors together.
    fn beside(self, other: Self) -> Self {
        Self {
            size: both(self.size, other.size),
            error: both(self.error, other.error),
        }
    }

    /// Smaller of two bounds.
    const fn least(self, other: Self) -> Self {
        Self {
            size: self.size.min(other.size),
            error: self.error.min(other.error),
        }
    }

    /// Length of the sum with another vector.
    fn plus(self, other: Self) -> Self {
        Self {
            size: self.size + other.size,
            error: self.error + other.error,
        }
    }

    /// Length of the product with a matrix of this norm.
    fn times(self, norm: f64) -> Self {
        Self {
            size: self.size * norm,
            error: self.error * norm,
        }
    }

    /// The root of the vector's square, before rounding: it changes by no more than the vector, also near zero. Of the
    /// sum of squares, at most three products and two sums are rounded.
    pub fn root_of(self, square: Value, scalar: Real) -> Value {
        let roundoff = scalar.roundoff();
        // √(1 ± δ) is within δ/2 + δ²/2 of 1, and δ is at most (1 + u)³ − 1.
        let rounded = (self.size + self.error) * 1.5 * (1.0 + 5.0 * roundoff) * roundoff;
        Value {
            lo: square.lo.max(0.0).sqrt(),
            hi: square.hi.sqrt().min(self.size),
            error: self.error + rounded + (3.0 * scalar.smallest()).sqrt(),
        }
        .or_unknown()
    }

    /// Error of the scalar product with another vector, before rounding.
    pub fn across(self, other: Self) -> f64 {
        self.size * other.error + self.error * (other.size + other.error)
    }
}

impl From<Value> for Length {
    fn from(value: Value) -> Self {
        Self {
            size: value.size(),
            error: value.error,
        }
    }
}

/// Maximum number of entries of a vector.
const ENTRIES: usize = ROWS;

/// Maximum depth of the recursion; lengths further back are known already.
const DEPTH: usize = 64;

/// Maximum average number of lengths stored for each step.
const MOST: usize = 8;

/// Known lengths, by the steps of the entries.
#[derive(Default)]
pub struct Lengths {
    all: Vec<([u32; ENTRIES], Length)>,
    index: Index,
}

/// A hash of the steps of some entries.
fn spread_of([a, b, c]: [u32; ENTRIES]) -> u32 {
    spread((u64::from(a) << 32) | u64::from(b), c.into())
}

/// Placeholder for an absent entry.
const NOTHING: u32 = u32::MAX;

impl Lengths {
    /// Length of some operands.
    pub fn of(&mut self, known: &Known<'_>, entries: &[Operand]) -> Length {
        self.follow(known, entries, true, DEPTH)
    }

    /// Length of some operands. `first` is false while single entries are replaced one by one; then only whole rotated
    /// vectors are combined.
    fn follow(
        &mut self,
        known: &Known<'_>,
        entries: &[Operand],
        first: bool,
        depth: usize,
    ) -> Length {
        let (mut set, mut count, mut leaves) = ([NOTHING; ENTRIES], 0, Vec::new());
        let mut length = Length::default();
        for &entry in entries {
            if let Operand::Step(step) = entry {
                length = length.beside(known.value(entry).into());
                if let Some(place) = set.get_mut(count) {
                    *place = step;
                }
                count += 1;
            } else {
                leaves.push(entry);
            }
        }
        let leaves = of_leaves(known, leaves);
        if !(1..=ENTRIES).contains(&count) || depth == 0 {
            return length.beside(leaves);
        }
        // The latest first.
        let steps = &mut set[..count];
        steps.sort_unstable_by(|a, b| b.cmp(a));
        let hash = spread_of(set);
        let is = |at: u32| self.all[at as usize].0 == set;
        if let Some(at) = self.index.find(hash, is) {
            return self.all[at as usize].1.beside(leaves);
        }
        let steps = &set[..count];
        let entries = steps.iter().map(|&k| known.steps[k as usize].entry);
        if let Some(entries) = entries.collect::<Option<Vec<RotationEntry>>>()
            && RotationEntry::are_in_line(&entries)
        {
            length.size = length.size.min(stretch(known.scalar()));
        }
        let twice = steps.windows(2).any(|pair| pair[0] == pair[1]);
        if !twice && self.all.len() < MOST * known.steps.len() {
            let turned =
                |step: &u32| matches!(known.steps[*step as usize].form, StepForm::ByRotation(_));
            let turned = steps.iter().any(turned);
            if count > 1 && (turned || first) {
                length = length.least(self.unfolded(known, steps, depth - 1));
            }
            if first || !turned {
                length = length.least(self.combined(known, steps, depth - 1));
            }
            // The recursion has replaced an entry by earlier ones, and so has not found this set.
            self.index.insert(number(self.all.len()), hash);
            self.all.push((set, length));
        }
        length.beside(leaves)
    }

    /// Length by the linear combination that the entries are.
    fn combined(&mut self, known: &Known<'_>, steps: &[u32], depth: usize) -> Length {
        let Some(combination) = Combination::of(known, steps) else {
            return Length::UNKNOWN;
        };
        let mut length = self.of_columns(known, Vec::new(), &combination.columns, depth);
        let mut others = combination.columns;
        let rotated = group::rotated(known, &mut others);
        if !rotated.is_empty() {
            length = length.least(self.of_columns(known, rotated, &others, depth));
        }
        Length {
            size: length.size,
            error: length.error + root(combination.lost),
        }
    }

    /// Length of the sum of some groups and other columns.
    fn of_columns(
        &mut self,
        known: &Known<'_>,
        mut groups: Vec<ColumnGroup>,
        columns: &[Column],
        depth: usize,
    ) -> Length {
        group::by_kind(known, columns, &mut groups);
        let mut length = self.of_groups(known, &groups, depth);
        // The third entry of a vector that is rotated about an axis has a label of its own.
        let rotated = |group: &ColumnGroup| matches!(group.kind, ColumnKind::Rotated(_));
        let whole = |group: &ColumnGroup| {
            matches!(group.members[..], [Monomial::Whole(_)]) && !rotated(group)
        };
        let turned = |group: &ColumnGroup| {
            matches!(
                (group.kind, &group.members[..]),
                (ColumnKind::ByRotation(_), [_, _])
            )
        };
        if let Some(at) = groups.iter().position(turned) {
            for third in 0..groups.len() {
                if whole(&groups[third]) {
                    let mut others = groups.clone();
                    let ColumnGroup {
                        members, matrix, ..
                    } = groups[third].clone();
                    others[at].take(members[0], matrix[0]);
                    others.remove(third);
                    length = length.least(self.of_groups(known, &others, depth));
                }
            }
        }
        length
    }

    /// Length of the sum of groups, bounded as a whole or row by row.
    fn of_groups(&mut self, known: &Known<'_>, groups: &[ColumnGroup], depth: usize) -> Length {
        let mut whole = Length::default();
        let mut rows = [Length::default(); ROWS];
        for ColumnGroup {
            kind,
            members,
            matrix,
        } in groups
        {
            let mut length = self.of_group(known, members, depth);
            if let &ColumnKind::Rotated(error) = kind {
                let by = Length {
                    size: stretch(known.scalar()),
                    error,
                };
                length = Length {
                    size: by.size * length.size,
                    error: by.across(length),
                };
            }
            whole = whole.plus(length.times(norm(matrix)));
            for (row, sum) in rows.iter_mut().enumerate() {
                let entries = matrix.iter().map(|column| column[row]);
                *sum = sum.plus(length.times(root(entries)));
            }
        }
        whole.least(rows.into_iter().fold(Length::default(), Length::beside))
    }

    /// Length of some values; products are bounded by their common factor.
    fn of_group(&mut self, known: &Known<'_>, members: &[Monomial], depth: usize) -> Length {
        let [Monomial::Product(a, b), ..] = *members else {
            let operands: Vec<Operand> = (members.iter())
                .filter_map(|of| match *of {
                    Monomial::Whole(operand) => Some(operand),
                    Monomial::Product(..) => None,
                })
                .collect();
            return self.follow(known, &operands, true, depth);
        };
        let shared = if matches!(b, Operand::Input(_)) { b } else { a };
        let others: Vec<Operand> = (members.iter())
            .filter_map(|of| match *of {
                Monomial::Product(a, b) => Some(if b == shared { a } else { b }),
                Monomial::Whole(_) => None,
            })
            .collect();
        let factor = Length::from(known.value(shared));
        let others = self.follow(known, &others, true, depth);
        let together = Length {
            size: factor.size * others.size,
            error: factor.across(others),
        };
        match *members {
            [Monomial::Product(a, b)] => together.least(known.product([a, b]).into()),
            _ => together,
        }
    }

    /// Length by the operands of the latest entry.
    fn unfolded(&mut self, known: &Known<'_>, steps: &[u32], depth: usize) -> Length {
        let youngest = &known.steps[steps[0] as usize];
        let mut rest: Vec<Operand> = steps[1..].iter().map(|&k| Operand::Step(k)).collect();
        let mut without = |gone: Operand, added: Length| {
            // An entry that is in the set already would count once instead of twice.
            if rest.contains(&gone) {
                return Length::UNKNOWN;
            }
            let length = self.follow(known, &[&rest[..], &[gone]].concat(), false, depth);
            let rounding =
                known.scalar().roundoff() * youngest.value.reach() + known.scalar().smallest();
            Length {
                size: length.size + added.size,
                error: length.error + added.error + rounding,
            }
        };
        match youngest.form {
            StepForm::Plain => Length::UNKNOWN,
            StepForm::More(a, added) => without(a, added.into()),
            StepForm::Sum(a, b) => {
                let [of_a, of_b] = [a, b].map(|operand| known.value(operand).into());
                without(a, of_b).least(without(b, of_a))
            }
            StepForm::ByRotation(rotation) => {
                let second = rest.iter().position(|entry| match entry {
                    Operand::Step(k) => matches!(
                        known.steps[*k as usize].form,
                        StepForm::ByRotation(other) if rotation.completes(&other)
                    ),
                    _ => false,
                });
                let both = second.map(|second| rest.remove(second)).is_some();
                let before = [rotation.by_cosine.0, rotation.by_sine.0];
                if before.iter().any(|entry| rest.contains(entry)) {
                    return Length::UNKNOWN;
                }
                let length = self.follow(known, &[&rest[..], &before].concat(), true, depth);
                let turned = self.follow(known, &before, true, depth);
                let by = of_turn(known, rotation.angle);
                let roundings =
                    by.roundings(turned, known.scalar()) * if both { SQRT_2 } else { 1.0 };
                Length {
                    size: length.size * by.size.max(1.0),
                    error: length.error * by.size.max(1.0)
                        + by.error * (turned.size + turned.error)
                        + roundings,
                }
            }
        }
    }
}

/// Length of literals, inputs, sines and cosines; (s, c) of one angle has length 1.
fn of_leaves(known: &Known<'_>, mut leaves: Vec<Operand>) -> Length {
    let mut length = Length::default();
    while let Some(leaf) = leaves.pop() {
        let other = match leaf {
            Operand::Sin(angle) => Some((angle, Operand::Cos(angle))),
            Operand::Cos(angle) => Some((angle, Operand::Sin(angle))),
            _ => None,
        };
        let found = other.and_then(|(angle, other)| {
            let at = leaves.iter().position(|leaf| *leaf == other)?;
            leaves.remove(at);
            Some(of_turn(known, angle))
        });
        length = length.beside(found.unwrap_or_else(|| known.value(leaf).into()));
    }
    length
}

/// Length of sine and cosine of a rotation.
fn of_turn(known: &Known<'_>, angle: u32) -> Length {
    let (pair, size) = known.turns.pair(angle);
    let [sine, cosine] = pair.map(|operand| Length::from(known.value(operand)));
    Length {
        size,
        ..sine.beside(cosine)
    }
}

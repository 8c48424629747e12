//! How long a few values are together, as the entries of a vector.
//!
//! In: the values of a program so far, and how sums came about. Out: a bound of √(a² + b² + …), and
//! of the same of their errors, that turning a vector does not let grow. Ranges of single entries
//! cannot tell this: each turn would lengthen them by √2, and seven joints there and back by 128.

use std::collections::HashMap;
use std::f64::consts::SQRT_2;

use super::{Known, Value};
use crate::schedule::Operand;

/// √(a² + b² + …) of exact values, and of their errors.
#[derive(Clone, Copy, Debug, Default)]
pub struct Length {
    /// Of the values.
    pub size: f64,
    /// Of the errors.
    pub error: f64,
}

/// How a value came about, as far as lengths are concerned.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// An entry of a turned vector.
    Turned(Turn),
    /// a ± b.
    Sum(Operand, Operand),
    /// The first, plus or minus something of that value that has no place of its own.
    More(Operand, Value),
    /// Nothing that helps.
    Plain,
}

/// c x + s y, or c y − s x, of a vector (x, y) and an angle.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    angle: u32,
    /// What the cosine multiplies, and whether a minus stands before it.
    by_cosine: (Operand, bool),
    /// What the sine multiplies, and whether a minus stands before it.
    by_sine: (Operand, bool),
}

impl Turn {
    /// The sum of two products, where their factors are those of a turn.
    pub fn of(
        first: [Operand; 2],
        first_minus: bool,
        second: [Operand; 2],
        second_minus: bool,
    ) -> Option<Self> {
        let ways = |pair: [Operand; 2]| [(pair[0], pair[1]), (pair[1], pair[0])];
        ways(first).into_iter().find_map(|(of_first, x)| {
            ways(second).into_iter().find_map(|(of_second, y)| {
                let (x, y) = ((x, first_minus), (y, second_minus));
                match (of_first, of_second) {
                    (Operand::Cos(angle), Operand::Sin(other)) if angle == other => Some(Self {
                        angle,
                        by_cosine: x,
                        by_sine: y,
                    }),
                    (Operand::Sin(angle), Operand::Cos(other)) if angle == other => Some(Self {
                        angle,
                        by_cosine: y,
                        by_sine: x,
                    }),
                    _ => None,
                }
            })
        })
    }

    /// Whether the other is the second entry of the same turned vector.
    fn completes(&self, other: &Self) -> bool {
        let ((x, x_minus), (y, y_minus)) = (self.by_cosine, self.by_sine);
        let ((z, z_minus), (w, w_minus)) = (other.by_cosine, other.by_sine);
        let opposed = (x_minus == z_minus) != (y_minus == w_minus);
        self.angle == other.angle && (x, y) == (w, z) && opposed
    }
}

impl Length {
    const UNKNOWN: Self = Self {
        size: f64::INFINITY,
        error: f64::INFINITY,
    };

    /// Of these entries and others.
    fn beside(self, other: Self) -> Self {
        let both = |a: f64, b: f64| (a * a + b * b).sqrt();
        Self {
            size: both(self.size, other.size),
            error: both(self.error, other.error),
        }
    }

    /// The better of two bounds.
    const fn least(self, other: Self) -> Self {
        Self {
            size: self.size.min(other.size),
            error: self.error.min(other.error),
        }
    }

    /// The error of a product with another vector, before it is rounded.
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

/// The most entries of a vector.
const ENTRIES: usize = 3;

/// How far back a length is followed at once; what lies further back has been asked for before.
const DEPTH: usize = 64;

/// How many lengths are remembered for each step; beyond, none is followed any further.
const MOST: usize = 64;

/// The lengths that were asked for, by the steps that are the entries.
#[derive(Default)]
pub struct Lengths(HashMap<Vec<u32>, Length>);

impl Lengths {
    /// How long the values of some operands are together.
    pub fn of(&mut self, known: &Known<'_>, entries: &[Operand]) -> Length {
        self.follow(known, entries, DEPTH)
    }

    fn follow(&mut self, known: &Known<'_>, entries: &[Operand], depth: usize) -> Length {
        let (mut steps, mut leaves) = (Vec::new(), Vec::new());
        for &entry in entries {
            match entry {
                Operand::Step(step) => steps.push(step),
                leaf => leaves.push(leaf),
            }
        }
        // The youngest first.
        steps.sort_unstable_by(|a, b| b.cmp(a));
        let leaves = of_leaves(known, leaves);
        if let Some(&length) = self.0.get(&steps) {
            return length.beside(leaves);
        }
        let mut length = Length::default();
        for &step in &steps {
            length = length.beside(known.steps[step as usize].0.into());
        }
        let twice = steps.windows(2).any(|pair| pair[0] == pair[1]);
        let few = (2..=ENTRIES).contains(&steps.len()) && self.0.len() < MOST * known.steps.len();
        if few && !twice && depth > 0 {
            length = length.least(self.unfolded(known, &steps, depth - 1));
            self.0.insert(steps, length);
        }
        length.beside(leaves)
    }

    /// The length by what the youngest entry came from.
    fn unfolded(&mut self, known: &Known<'_>, steps: &[u32], depth: usize) -> Length {
        let (value, form) = known.steps[steps[0] as usize];
        let mut rest: Vec<Operand> = steps[1..].iter().map(|&k| Operand::Step(k)).collect();
        let mut without = |gone: Operand, added: Length| {
            // An entry that is there already would be counted once instead of twice.
            if rest.contains(&gone) {
                return Length::UNKNOWN;
            }
            let length = self.follow(known, &[&rest[..], &[gone]].concat(), depth);
            let rounding = known.roundoff * value.reach();
            Length {
                size: length.size + added.size,
                error: length.error + added.error + rounding,
            }
        };
        match form {
            Form::Plain => Length::UNKNOWN,
            Form::More(a, added) => without(a, added.into()),
            Form::Sum(a, b) => {
                let [of_a, of_b] = [a, b].map(|operand| known.value(operand).into());
                without(a, of_b).least(without(b, of_a))
            }
            Form::Turned(turn) => {
                let second = rest.iter().position(|entry| match entry {
                    Operand::Step(k) => matches!(
                        known.steps[*k as usize].1,
                        Form::Turned(other) if turn.completes(&other)
                    ),
                    _ => false,
                });
                let both = second.map(|second| rest.remove(second)).is_some();
                let before = [turn.by_cosine.0, turn.by_sine.0];
                if before.iter().any(|entry| rest.contains(entry)) {
                    return Length::UNKNOWN;
                }
                let length = self.follow(known, &[&rest[..], &before].concat(), depth);
                let turned = self.follow(known, &before, depth);
                let by = of_turn(known, turn.angle);
                let roundings = known.roundings(by, turned) * if both { SQRT_2 } else { 1.0 };
                Length {
                    size: length.size,
                    error: length.error + by.error * (turned.size + turned.error) + roundings,
                }
            }
        }
    }
}

/// Of numbers, inputs, sines and cosines; (s, c) of one angle is of length 1.
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

fn of_turn(known: &Known<'_>, angle: u32) -> Length {
    let [sine, cosine] = known.turns[angle as usize].map(Length::from);
    Length {
        size: 1.0,
        ..sine.beside(cosine)
    }
}

//! Linear dependence of columns, by elimination in 106 bits.
//!
//! In: columns of parameters, one after the other, each entry with the size of what it is a sum of. Out: of each column
//! that adds nothing, the combination of earlier ones that it is. With each entry the variance of its rounding error is
//! carried, as if errors were independent of each other: a column adds nothing where no entry is left of it that is more
//! than that. So no row is compared with another one, and no column, whatever their units. It never knows what is in them.

#[cfg(test)]
mod tests;

use super::energies::Entry;
use crate::expression::Double;
use crate::space::ParameterId;

/// How much of a parameter is in a combination.
pub(super) type Combination = Vec<(ParameterId, Double)>;

/// 2⁻¹⁰⁰: the rounding error of an entry, beside what it is a sum of.
const ROUNDOFF: f64 = f64::from_bits((1023 - 100) << 52);

/// So many times its rounding error is more than rounding.
const SIGNIFICANT: f64 = 1e4;

/// A factor that is no more than so many times its rounding error is nothing: the error that is carried is more than any that
/// was seen.
const ROUNDED: f64 = 10.0;

/// Beside a part so small of what an entry is a sum of, its square would not be told from rounding: of axes that are parallel
/// but for so small an angle, some columns see the angle and others its square.
const ASKEW: f64 = 1e-13;

/// Columns that do not depend on each other.
#[derive(Default)]
pub(super) struct Span {
    kept: Vec<Kept>,
    pub(super) left: Left,
}

/// What was left of columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Left {
    /// The most of those that were taken for combinations of others, beside its rounding error.
    most: f64,
    /// The least of those that were not, beside its rounding error.
    least: f64,
    /// The least of those, beside what it is a sum of.
    smallest: f64,
}

impl Default for Left {
    fn default() -> Self {
        Self {
            most: 0.0,
            least: f64::INFINITY,
            smallest: 1.0,
        }
    }
}

impl Left {
    /// Those of both.
    pub(super) const fn and(self, other: Self) -> Self {
        Self {
            most: self.most.max(other.most),
            least: self.least.min(other.least),
            smallest: self.smallest.min(other.smallest),
        }
    }

    /// Whether rounding may have decided.
    pub(super) const fn is_uncertain(self) -> bool {
        self.most > SIGNIFICANT / 100.0 || self.least < SIGNIFICANT * 100.0 || self.smallest < ASKEW
    }
}

/// An entry of a column that is being reduced.
#[derive(Clone, Copy)]
struct Rest {
    value: Double,
    /// The variance of its rounding error.
    variance: f64,
    /// The magnitudes of what it is a sum of.
    whole: f64,
}

impl Rest {
    fn of((value, size): Entry) -> Self {
        let roundoff = ROUNDOFF * size;
        Self {
            value,
            variance: roundoff * roundoff,
            whole: size,
        }
    }

    fn is_zero(self) -> bool {
        self.value.to_f64() == 0.0 && self.variance == 0.0
    }

    /// Less a product.
    fn less(self, part: Self, entry: Self) -> Self {
        let term = part.value * entry.value;
        let of_whole = part.value.to_f64() * entry.whole;
        let [of_part, of_entry, of_term] = [part.value, entry.value, term].map(|x| {
            let size = x.to_f64();
            size * size
        });
        Self {
            value: self.value - term,
            whole: (self.whole * self.whole + of_whole * of_whole).sqrt(),
            variance: self.variance
                + part.variance * of_entry
                + entry.variance * of_part
                + ROUNDOFF * ROUNDOFF * of_term,
        }
    }

    /// A quotient.
    fn over(self, of: Self) -> Self {
        let value = self.value / of.value;
        let scale = 1.0 / of.value.to_f64();
        let size = value.to_f64();
        Self {
            value,
            whole: self.whole * scale.abs(),
            variance: (self.variance + size * size * of.variance) * scale * scale,
        }
    }

    /// How many times its rounding error it is.
    fn significance(self) -> f64 {
        if self.value.to_f64() == 0.0 {
            return 0.0;
        }
        self.value.to_f64().abs() / self.variance.sqrt()
    }
}

/// A column that does not depend on those before.
struct Kept {
    /// None of one that is of no parameter.
    name: Option<ParameterId>,
    /// The row in which it has 1 once what depends on others is taken off, and later columns have 0.
    pivot: usize,
    reduced: Vec<Rest>,
    /// How much of the reduced columns it is, its own last.
    parts: Vec<Rest>,
}

/// A column that is being reduced.
struct Column {
    name: Option<ParameterId>,
    rest: Vec<Rest>,
    /// How much of the reduced columns has been taken off.
    parts: Vec<Rest>,
}

impl Column {
    /// Takes off what it has of a reduced column.
    fn reduce(&mut self, kept: &Kept) {
        let part = self.rest[kept.pivot];
        self.parts.push(part);
        if part.is_zero() {
            return;
        }
        for (rest, entry) in self.rest.iter_mut().zip(&kept.reduced) {
            if !entry.is_zero() {
                *rest = rest.less(part, *entry);
            }
        }
        self.rest[kept.pivot] = Rest::of((Double::ZERO, 0.0));
    }

    /// The most of an entry that is left, beside its rounding error.
    fn significance(&self) -> f64 {
        let left = self.rest.iter().map(|rest| rest.significance());
        left.fold(0.0, f64::max)
    }
}

impl Span {
    /// Adds a column; or, where it depends on those that are there, returns how much of each it is.
    pub(super) fn take(
        &mut self,
        name: Option<ParameterId>,
        column: impl Iterator<Item = Entry>,
    ) -> Option<Combination> {
        let column = self.reduced(name, column);
        let left = column.significance();
        if left <= SIGNIFICANT {
            self.left.most = self.left.most.max(left);
            return Some(self.combination(column.parts));
        }
        self.keep(column, left);
        None
    }

    /// Adds those of some columns that do not depend on each other, whichever they are: by those of which most is left,
    /// the others are combinations with small factors.
    pub(super) fn take_some<C: Iterator<Item = Entry>>(
        &mut self,
        columns: impl Iterator<Item = (ParameterId, C)>,
    ) {
        let columns = columns.map(|(name, column)| self.reduced(Some(name), column));
        let mut columns: Vec<Column> = columns.collect();
        loop {
            let left = columns.iter().map(Column::significance).enumerate();
            let Some((most, left)) = left.max_by(|(_, a), (_, b)| a.total_cmp(b)) else {
                return;
            };
            if left <= SIGNIFICANT {
                self.left.most = self.left.most.max(left);
                return;
            }
            let kept = self.keep(columns.swap_remove(most), left);
            for column in &mut columns {
                column.reduce(kept);
            }
        }
    }

    /// A column, less all that it has of those that are there.
    fn reduced(&self, name: Option<ParameterId>, entries: impl Iterator<Item = Entry>) -> Column {
        let mut column = Column {
            name,
            rest: entries.map(Rest::of).collect(),
            parts: Vec::new(),
        };
        for kept in &self.kept {
            column.reduce(kept);
        }
        column
    }

    /// Adds a reduced column that has some significance.
    fn keep(&mut self, column: Column, left: f64) -> &Kept {
        let Column {
            name,
            rest,
            mut parts,
        } = column;
        self.left.least = self.left.least.min(left);
        let known = rest.iter().filter(|rest| rest.significance() > SIGNIFICANT);
        let parts_left = known.map(|rest| rest.value.to_f64().abs() / rest.whole);
        self.left.smallest = self.left.smallest.min(parts_left.fold(0.0, f64::max));
        let significant = |row: &usize| {
            if rest[*row].significance() > SIGNIFICANT {
                rest[*row].value.to_f64().abs()
            } else {
                0.0
            }
        };
        let largest = (0..rest.len()).max_by(|a, b| significant(a).total_cmp(&significant(b)));
        let pivot = largest.unwrap_or(0);
        parts.push(rest[pivot]);
        let reduced = rest.iter().map(|entry| entry.over(rest[pivot]));
        self.kept.push(Kept {
            name,
            pivot,
            reduced: reduced.collect(),
            parts,
        });
        &self.kept[self.kept.len() - 1]
    }

    /// The columns that another one is made of, by its parts of the reduced ones; without those of which there is no more
    /// than rounding.
    fn combination(&self, mut parts: Vec<Rest>) -> Combination {
        let mut combination = Vec::new();
        for (place, kept) in self.kept.iter().enumerate().rev() {
            let factor = parts[place].over(kept.parts[place]);
            if factor.significance() <= ROUNDED {
                continue;
            }
            for (part, of_kept) in parts.iter_mut().zip(&kept.parts[..place]) {
                *part = part.less(factor, *of_kept);
            }
            combination.extend(kept.name.map(|name| (name, factor.value)));
        }
        combination.reverse();
        combination
    }
}

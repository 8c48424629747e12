//! Linear dependence of columns, by elimination in 106 bits.
//!
//! In: columns of parameters, one after the other, each entry with the size of its terms. Out: for each column that
//! depends on earlier ones, the combination of them that it is. Each entry carries the variance of its rounding error,
//! as if errors were independent: a column is dependent if all entries that are left of it are within their rounding
//! error. So units of rows and columns do not matter.

#[cfg(test)]
mod tests;

use super::energies::SizedEntry;
use crate::expression::Double;
use crate::space::ParameterId;

/// Factors of parameters in a combination.
pub(super) type Combination = Vec<(ParameterId, Double)>;

/// 2⁻¹⁰⁰: the rounding error of an entry, relative to the size of its terms.
const ROUNDOFF: f64 = f64::from_bits((1023 - 100) << 52);

/// Ratio of an entry to its rounding error above which the entry is significant.
const SIGNIFICANT: f64 = 1e4;

/// Ratio of a factor to its rounding error below which the factor counts as zero: the estimated error is larger than
/// any that was observed.
const ROUNDED: f64 = 10.0;

/// Ratio of an entry to the size of its terms below which its square is within rounding: for axes that are parallel but
/// for such a small angle, some columns depend on the angle and others on its square.
const ASKEW: f64 = 1e-13;

/// Linearly independent columns.
#[derive(Default)]
pub(super) struct Span {
    kept: Vec<Kept>,
    pub(super) left: Residuals,
}

/// Residuals of columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Residuals {
    /// The largest of those that were taken for combinations of others, relative to its rounding error.
    most: f64,
    /// The smallest of those that were not, relative to its rounding error.
    least: f64,
    /// The smallest of those that were not, relative to the size of its terms.
    smallest: f64,
}

impl Default for Residuals {
    fn default() -> Self {
        Self {
            most: 0.0,
            least: f64::INFINITY,
            smallest: 1.0,
        }
    }
}

impl Residuals {
    /// The residuals of both.
    pub(super) const fn and(self, other: Self) -> Self {
        Self {
            most: self.most.max(other.most),
            least: self.least.min(other.least),
            smallest: self.smallest.min(other.smallest),
        }
    }

    /// True if rounding may have decided.
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
    /// The size of its terms, and of those of the numbers that it was computed from.
    whole: f64,
}

impl Rest {
    fn of((value, size): SizedEntry) -> Self {
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

    /// Minus a product.
    fn less(self, part: Self, entry: Self) -> Self {
        let term = part.value * entry.value;
        let square = |x: f64| x * x;
        let [of_part, of_entry, of_term] =
            [part.value, entry.value, term].map(|x| square(x.to_f64()));
        Self {
            value: self.value - term,
            whole: (square(self.whole)
                + of_part * square(entry.whole)
                + square(part.whole) * of_entry)
                .sqrt(),
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

    /// Ratio to its rounding error.
    fn significance(self) -> f64 {
        if self.value.to_f64() == 0.0 {
            return 0.0;
        }
        self.value.to_f64().abs() / self.variance.sqrt()
    }
}

/// A column that does not depend on those before.
struct Kept {
    /// `None` for a column that belongs to no parameter.
    name: Option<ParameterId>,
    /// The row of its pivot: 1 in this column after elimination, 0 in later columns.
    pivot: usize,
    reduced: Vec<Rest>,
    /// Its factors in the reduced columns, its own last.
    parts: Vec<Rest>,
}

/// A column that is being reduced.
struct Column {
    name: Option<ParameterId>,
    rest: Vec<Rest>,
    /// The factors of the reduced columns that have been subtracted.
    parts: Vec<Rest>,
}

impl Column {
    /// Eliminates a reduced column.
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

    /// The largest ratio of an entry that is left to its rounding error.
    fn significance(&self) -> f64 {
        let left = self.rest.iter().map(|rest| rest.significance());
        left.fold(0.0, f64::max)
    }
}

impl Span {
    /// Adds a column; if it depends on earlier columns, returns its factors in them.
    pub(super) fn take(
        &mut self,
        name: Option<ParameterId>,
        column: impl Iterator<Item = SizedEntry>,
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

    /// Adds the independent ones among some columns, in the order of their largest residuals: the others are
    /// combinations of those with small factors.
    pub(super) fn take_some<C: Iterator<Item = SizedEntry>>(
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

    /// A column after elimination of all columns that have been added.
    fn reduced(
        &self,
        name: Option<ParameterId>,
        entries: impl Iterator<Item = SizedEntry>,
    ) -> Column {
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

    /// Adds a reduced column that is significant.
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

    /// The combination of columns that another one is, from its factors in the reduced ones; factors within rounding
    /// are left out.
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

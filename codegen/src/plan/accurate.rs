//! The cheapest accurate program of functions that solve an equation.
//!
//! In: a [`Search`]; the worst loss of the mass matrix. Out: of the groups of forms that [`forward`] names, the
//! cheapest program that is accurate enough by its [`Measure`]; if there is none, the cheapest of those that lose
//! little more than the best; or an error if none leaves half of the digits.

use super::forward::{self, ForwardForm};
use super::measured::{ENOUGH, Measure, MeasuredError};
use super::search::{ChosenProgram, Search};
use super::solvable::Worst;
use crate::error::Errors;

/// Ratio to the sufficient error beyond which a form is given up after one layout.
const FAR: f64 = 16.0;

/// An error that is barely enough \[u\]: an estimate from a few states may miss one of twice as much.
const BARELY: f64 = 0.75 * ENOUGH;

/// Share of the cost that may be added where another is [barely](BARELY) accurate, one in so many.
const LITTLE: usize = 16;

/// True if a form is not worth trying in other layouts than one: they save less than a fifth of its cost.
const fn is_dear(cost: usize, least: usize) -> bool {
    cost > least + least / 4
}

/// The cheapest program that is accurate enough, or nearly as accurate as the best.
///
/// # Errors
/// If no form leaves half of the digits.
pub(super) fn accurate(search: &Search<'_>, worst: Worst) -> Result<ChosenProgram, Errors> {
    let mut trial = Trial::of(search, worst);
    for forms in forward::groups(search.chain, search.functions, search.formulation) {
        for form in forms {
            trial.measure(form);
        }
        if trial.best.is_some() {
            break;
        }
    }
    if let Some((cost, found)) = trial.accurate() {
        return Ok(trial.safer(cost, found));
    }
    let least = (trial.tried.iter()).fold(MeasuredError::INFINITE, |least, tried| {
        least.least(tried.found.error)
    });
    if forward::keeps_half(least.eighth, search.scalar) {
        Ok(trial.nearly_as_good(least.worst))
    } else {
        let of = (search.scalar, search.formulation.frame);
        let (chain, functions) = (search.chain, search.functions);
        Err(forward::hopeless(chain, worst, least.worst, functions, of))
    }
}

/// State of the search.
struct Trial<'s> {
    search: &'s Search<'s>,
    measure: Measure<'s>,
    /// The cheapest program that is accurate enough, with its cost.
    best: Option<(usize, ChosenProgram)>,
    /// Programs that are not, in the order in which they were measured.
    tried: Vec<Tried>,
    /// The same forms in more expensive layouts, with their costs; not measured yet.
    costlier: Vec<(usize, ChosenProgram)>,
}

/// A program that is not accurate enough.
struct Tried {
    /// Its cost.
    cost: usize,
    found: ChosenProgram,
    /// True if it is the cheapest of all layouts; false if the form was tried in one.
    is_cheapest: bool,
}

impl Tried {
    /// True if its error is beyond what another layout could mend.
    fn is_far(&self) -> bool {
        self.found.error.worst > FAR * ENOUGH
    }
}

impl<'s> Trial<'s> {
    fn of(search: &'s Search<'s>, worst: Worst) -> Self {
        Self {
            search,
            measure: Measure::of(search.chain, search.functions, worst.loss, search.scalar),
            best: None,
            tried: Vec::new(),
            costlier: Vec::new(),
        }
    }

    fn measured(&mut self, mut found: ChosenProgram) -> ChosenProgram {
        if !found.error.is_measured() {
            found.error = self.measure.error(&found.program);
        }
        found
    }

    /// Measures a form in its cheapest layout, if it can still be the cheapest.
    fn measure(&mut self, form: ForwardForm) {
        let mut made = Vec::new();
        // A form that costs far more in the layout of the best one is not tried in others.
        if let Some((least, before)) = &self.best {
            let found = self.search.like(before, form, &mut made);
            if is_dear(found.0, *least) {
                return;
            }
            made.push(found);
        }
        // Nor is one that is far from accurate in one layout; one that costs far more than another waits.
        if let Some(before) = self.tried.first() {
            let (cost, first) = self.search.like(&before.found, form, &mut made);
            let waits = is_dear(cost, before.cost);
            let tried = Tried {
                cost,
                found: self.measured(first),
                is_cheapest: false,
            };
            if tried.is_far() || (waits && tried.found.error.worst > ENOUGH) {
                return self.tried.push(tried);
            }
            made.push((cost, tried.found));
        }
        let mut layouts = self.search.by_cost(form, made).into_iter();
        let (cost, found) = layouts.next().expect("there is at least one layout");
        if (self.best.as_ref()).is_some_and(|(least, _)| *least <= cost) {
            return;
        }
        let found = self.measured(found);
        if found.error.worst <= ENOUGH {
            self.best = Some((cost, found));
        } else {
            self.tried.push(Tried {
                cost,
                found,
                is_cheapest: true,
            });
            self.costlier.extend(layouts);
        }
    }

    /// The cheapest that is accurate enough. Frames far from their bodies may cause the loss of a form, so other
    /// layouts are tried before a more expensive form is taken.
    fn accurate(&mut self) -> Option<(usize, ChosenProgram)> {
        let costlier = std::mem::take(&mut self.costlier);
        self.take_cheapest(costlier);
        let waiting = self
            .tried
            .iter()
            .filter(|tried| !tried.is_cheapest && !tried.is_far());
        let waiting: Vec<(usize, ForwardForm)> = waiting
            .map(|tried| (tried.cost, ForwardForm::of(tried.found.algorithm)))
            .collect();
        for (cost, form) in waiting {
            if (self.best.as_ref()).is_none_or(|(least, _)| !is_dear(cost, *least)) {
                let layouts = self.search.by_cost(form, Vec::new());
                self.take_cheapest(layouts);
            }
        }
        self.best.take()
    }

    /// Replaces the best program by the cheapest of some that is accurate enough, if there is a cheaper one.
    fn take_cheapest(&mut self, mut programs: Vec<(usize, ChosenProgram)>) {
        if let Some((least, _)) = &self.best {
            programs.retain(|(cost, _)| cost < least);
        }
        programs.sort_by_key(|(cost, _)| *cost);
        let mut measured = programs
            .into_iter()
            .map(|(cost, found)| (cost, self.measured(found)));
        if let Some(cheaper) = measured.find(|(_, found)| found.error.worst <= ENOUGH) {
            self.best = Some(cheaper);
        }
    }

    /// The same with inertias that are rotated in full, if that halves the loss for little.
    fn safer(&mut self, cost: usize, found: ChosenProgram) -> ChosenProgram {
        let full = ForwardForm::full(found.algorithm.forward);
        if found.error.worst <= BARELY || full == ForwardForm::of(found.algorithm) {
            return found;
        }
        let (more, full) = self.search.like(&found, full, &mut Vec::new());
        if more > cost + cost / LITTLE {
            return found;
        }
        let full = self.measured(full);
        if full.error.found <= found.error.found / 2.0 {
            full
        } else {
            found
        }
    }

    /// The cheapest of those that lose little more than the best, if none is accurate enough. All forms lose digits
    /// near singular configurations. A loss a few times larger matters less than an inverse that does not invert.
    fn nearly_as_good(mut self, least: f64) -> ChosenProgram {
        let mut good = std::mem::take(&mut self.tried);
        let solves = |Tried { found, .. }: &Tried| {
            found.error.worst <= FAR * least && self.measure.unsolved(&found.program) <= ENOUGH
        };
        let solving: Vec<bool> = good.iter().map(solves).collect();
        if solving.contains(&true) {
            let mut solving = solving.into_iter();
            good.retain(|_| solving.next() == Some(true));
        }
        let worst = good.iter().map(|tried| tried.found.error.worst);
        let least = worst.fold(f64::INFINITY, f64::min);
        good.retain(|tried| tried.found.error.worst <= 2.0 * least);
        let weighed = good.into_iter().map(|tried| {
            if tried.is_cheapest {
                return (tried.cost, tried.found);
            }
            let (cost, found) = self.search.best(ForwardForm::of(tried.found.algorithm));
            (cost, self.measured(found))
        });
        let best = weighed.min_by_key(|(cost, _)| *cost);
        best.expect("the least is among them").1
    }
}

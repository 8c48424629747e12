//! Residuals that depend on others in closed configurations.
//!
//! In: a description and its chain. Out: the order in which residuals are eliminated; those that the others imply in
//! closed configurations, as in every over-constrained linkage that moves; and warnings if rounding of the description
//! decides it, or if the loops leave no motion or do not close.

mod order;

use super::{robot, states};
use crate::chain::Chain;
use crate::dense::{Dense, State};
use crate::error::Diagnostic;
use crate::real::Real;
use crate::space::{Kind, Space};
use crate::wording::{list, quoted};

/// Least number of closed configurations with motion in which residuals are compared.
const STATES: usize = 2;

/// Largest number of configurations that are tried: a linkage may also close where nothing can move, or near a singular
/// configuration.
const ATTEMPTS: usize = 5;

/// Ratio of a pivot to ε, the threshold of zero pivots, above which it is clearly not zero: its reciprocal is then right
/// to 2e-10.
const CLEAR: f64 = 16.0;

/// Ratio to ε of a residual that depends on others to all digits of `f64`.
const EXACT: f64 = 1e-12;

/// Share of the largest acceleration by which accelerations may vary with ε.
const CERTAIN: f64 = 1e-3;

/// The residuals that depend on others.
pub struct Redundancy {
    /// All residuals in the order in which they are eliminated.
    pub elimination: Vec<usize>,
    /// The names of those that depend on others.
    pub dependent: Vec<String>,
    /// Warnings about loops that do not close or do not move, and about uncertain dependences.
    pub warnings: Vec<Diagnostic>,
}

/// Compares the residuals of all loops in closed configurations.
#[must_use]
pub fn redundancy(chain: &Chain) -> Redundancy {
    let mut found = Redundancy {
        elimination: chain.elimination.clone(),
        dependent: Vec::new(),
        warnings: Vec::new(),
    };
    let at = |state: &State| {
        let robot = robot::robot(chain, &state.fields)?;
        Ok(Dense::of(robot, state.clone()))
    };
    let mut configurations: Vec<Dense> = Vec::new();
    let mut samples: Vec<Sample> = Vec::new();
    for number in 0..ATTEMPTS {
        // A robot that contradicts its chain is refused by the check.
        let Ok(Some(state)) = states::closed(chain, number, at) else {
            return found;
        };
        let Ok(dense) = at(&state) else {
            return found;
        };
        configurations.push(dense);
        let elimination = elimination(&configurations, chain);
        if elimination != found.elimination {
            found.elimination = elimination;
            samples.clear();
        }
        for dense in &mut configurations[samples.len()..] {
            dense.eliminate_in(found.elimination.clone());
            samples.push(Sample::of(dense, chain.request.scalar));
        }
        let useful: Vec<&Sample> = samples.iter().filter(|sample| sample.is_useful()).collect();
        // Near a singular configuration residuals nearly depend that are independent elsewhere.
        let is_settled = useful.iter().any(|sample| sample.is_certain)
            && !largest(&useful).iter().any(|pivot| is_borderline(*pivot));
        if useful.len() >= STATES && is_settled {
            break;
        }
    }
    if samples.iter().any(Sample::is_useful) {
        samples.retain(Sample::is_useful);
    } else if samples.iter().any(|sample| sample.is_closed) {
        samples.retain(|sample| sample.is_closed);
    }
    let most = largest(&samples.iter().collect::<Vec<_>>());
    found.dependent = named(chain, &most, |pivot| pivot < 1.0);
    found.warnings.extend(warning(chain, &samples, &most));
    found
}

/// The order of elimination, by the configurations that are closed, or by all if none is.
fn elimination(configurations: &[Dense], chain: &Chain) -> Vec<usize> {
    let zero_pivot = chain.request.scalar.zero_pivot();
    let is_closed = |dense: &&Dense| is_closed(&dense.relative_residuals(), zero_pivot);
    let mut of: Vec<&Dense> = configurations.iter().filter(is_closed).collect();
    if of.is_empty() {
        of = configurations.iter().collect();
    }
    let scaled = of.iter().map(|dense| dense.scaled_schur_complement());
    let loops = chain.loops.iter().map(|closed| closed.rows.len());
    order::order(scaled.collect(), loops, CLEAR * zero_pivot)
}

/// The warning about loops that do not close, do not move, or whose dependences are uncertain.
fn warning(chain: &Chain, samples: &[Sample], most: &[f64]) -> Option<Diagnostic> {
    if !samples.iter().any(|sample| sample.is_closed) {
        let nearest = samples
            .iter()
            .min_by(|a, b| a.opening().total_cmp(&b.opening()));
        return nearest.map(|nearest| open(chain, nearest));
    }
    if !samples.iter().any(|sample| sample.moves) {
        let held = samples.iter().map(|sample| sample.held).max().unwrap_or(0);
        return Some(no_motion(chain, held));
    }
    let is_certain = samples.iter().any(|sample| sample.is_certain);
    let uncertain = named(chain, most, |pivot| (EXACT..CLEAR).contains(&pivot));
    let has_borderline = most.iter().any(|pivot| is_borderline(*pivot));
    (!uncertain.is_empty() && (!is_certain || has_borderline))
        .then(|| nearly_dependent(chain, &uncertain))
}

/// The names of the residuals with such pivots.
fn named(chain: &Chain, pivots: &[f64], is_such: impl Fn(f64) -> bool) -> Vec<String> {
    let names = chain.spaces().names(Space::Constraints).zip(pivots);
    let names = names.filter(|(_, pivot)| is_such(**pivot));
    names.map(|(name, _)| name.to_owned()).collect()
}

/// The largest pivot of each residual.
fn largest(samples: &[&Sample]) -> Vec<f64> {
    let count = samples.first().map_or(0, |sample| sample.pivots.len());
    let largest = |k: usize| {
        let pivots = samples.iter().map(|sample| sample.pivots[k]);
        pivots.fold(0.0, f64::max)
    };
    (0..count).map(largest).collect()
}

/// True if rounding may decide whether a residual with this pivot depends on others.
fn is_borderline(pivot: f64) -> bool {
    (CLEAR.recip()..CLEAR).contains(&pivot)
}

/// The residuals in one configuration.
struct Sample {
    /// Each, and as a share of what joints change it by.
    residuals: Vec<(f64, f64)>,
    is_closed: bool,
    /// For each residual its independent part, after those before it, divided by ε.
    pivots: Vec<f64>,
    /// Number of velocities that change a residual.
    held: usize,
    /// True if those are more than the independent residuals.
    moves: bool,
    /// True if accelerations are the same for another ε.
    is_certain: bool,
}

impl Sample {
    fn of(dense: &mut Dense, scalar: Real) -> Self {
        let zero_pivot = scalar.zero_pivot();
        let pivots = dense.independence(zero_pivot).into_iter();
        let pivots: Vec<f64> = pivots.map(|pivot| pivot / zero_pivot).collect();
        let shares = dense.relative_residuals();
        let held = dense.held();
        let accelerations = |dense: &Dense, zero_pivot| {
            let mut solution = dense.constrained(zero_pivot);
            solution.truncate(dense.state.velocities());
            solution
        };
        Self {
            is_closed: is_closed(&shares, zero_pivot),
            residuals: (dense.residuals().iter().map(|residual| residual.to_f64()))
                .zip(shares)
                .collect(),
            held,
            moves: pivots.iter().filter(|pivot| **pivot >= CLEAR).count() < held,
            pivots,
            is_certain: dense.sensitivity(accelerations, (zero_pivot, scalar.roundoff()))
                <= CERTAIN,
        }
    }

    const fn is_useful(&self) -> bool {
        self.is_closed && self.moves
    }

    /// The largest share by which it is open.
    fn opening(&self) -> f64 {
        self.residuals
            .iter()
            .fold(0.0, |most, (_, share)| most.max(*share))
    }
}

/// True if loops are closed as far as a pivot of ε can tell: pivots are squares of shares. Where a search ends with
/// loops more open than that, the residual that is left depends on the others there, and not where it closes.
fn is_closed(shares: &[f64], zero_pivot: f64) -> bool {
    shares.iter().all(|share| share * share <= zero_pivot)
}

/// The warning that loops do not close.
fn open(chain: &Chain, nearest: &Sample) -> Diagnostic {
    let entries = chain.spaces().constraints.iter();
    let pairs = entries.zip(&nearest.residuals);
    let (entry, (residual, _)) = pairs
        .max_by(|(_, (_, a)), (_, (_, b))| a.total_cmp(b))
        .expect("a loop has residuals");
    let unit = if entry.kind == Kind::Translation {
        " m"
    } else {
        ""
    };
    let (loops, close) = if let [_] = &*chain.loops {
        ("loop", "closes")
    } else {
        ("loops", "close")
    };
    Diagnostic {
        place: chain.loops[0].place,
        message: format!(
            "no configuration was found in which {loops} {} {close}: in the nearest, {} is {residual:.1e}{unit}",
            loop_names(chain),
            quoted(&entry.name)
        ),
        hint: Some(DIGITS.to_owned()),
    }
}

fn nearly_dependent(chain: &Chain, residuals: &[String]) -> Diagnostic {
    let names: Vec<String> = residuals.iter().map(|name| quoted(name)).collect();
    let (is, depend) = if let [_] = residuals {
        ("it does", "depends")
    } else {
        ("they do", "depend")
    };
    Diagnostic {
        place: chain.loops[0].place,
        message: format!(
            "{} nearly {depend} on the other residuals where the loops are closed: accelerations differ by whether \
             {is}, and rounding decides",
            list(names.iter().map(String::as_str))
        ),
        hint: Some(DIGITS.to_owned()),
    }
}

/// The warning that loops hold every joint that changes their residuals.
fn no_motion(chain: &Chain, held: usize) -> Diagnostic {
    let names = loop_names(chain);
    let (message, its) = if let [_] = &*chain.loops {
        (format!("loop {names} allows no motion"), "its")
    } else {
        (format!("loops {names} allow no motion"), "their")
    };
    let which = if held == chain.spaces().velocities.len() {
        String::new()
    } else {
        format!(" of the joints that move {its} ends against each other")
    };
    Diagnostic {
        place: chain.loops[0].place,
        message: message + &which,
        hint: Some(DIGITS.to_owned()),
    }
}

/// The names of all loops, quoted.
fn loop_names(chain: &Chain) -> String {
    let names = chain.loops.iter().map(|closed| quoted(&closed.name));
    let names: Vec<String> = names.collect();
    list(names.iter().map(String::as_str))
}

const DIGITS: &str = "if the loops should move, write axes, angles and offsets with more digits, or give a loop a type \
                      that leaves free what others constrain";

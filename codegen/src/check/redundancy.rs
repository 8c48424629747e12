//! Residuals that depend on others in closed configurations.
//!
//! In: a description and its chain. Out: the residuals that the others imply in closed configurations, as in every
//! over-constrained linkage that moves; and warnings if rounding of the description decides it, or if the loops leave
//! no motion.

use super::{robot, states};
use crate::chain::Chain;
use crate::dense::{Dense, State};
use crate::error::Diagnostic;
use crate::space::Space;
use crate::wording::{list, quoted};

/// Least number of closed configurations with motion in which residuals are compared.
const STATES: usize = 2;

/// Largest number of configurations that are tried: a linkage may also close where nothing can move, or near a singular
/// configuration.
const ATTEMPTS: usize = 5;

/// The residual [m, 1] of a configuration that did not close.
const OPEN: f64 = 1e-2;

/// Ratio of a pivot to ε, the threshold of zero pivots, above which it is clearly not zero.
const CLEAR: f64 = 100.0;

/// Ratio to ε of a residual that depends on others to all digits of `f64`.
const EXACT: f64 = 1e-12;

/// Share of the largest acceleration by which accelerations may vary with ε.
const CERTAIN: f64 = 1e-3;

/// The residuals that depend on others.
#[derive(Default)]
pub struct Redundancy {
    /// Their names.
    pub dependent: Vec<String>,
    /// Warnings about uncertain dependences.
    pub warnings: Vec<Diagnostic>,
}

/// Compares the residuals of all loops in closed configurations.
#[must_use]
pub fn redundancy(chain: &Chain) -> Redundancy {
    let at = |state: &State| {
        let robot = robot::robot(chain, &state.fields)?;
        Ok(Dense::of(robot, state.clone()))
    };
    let scalar = chain.request.scalar;
    let (zero_pivot, roundoff) = (scalar.zero_pivot(), scalar.roundoff());
    let mut samples: Vec<Sample> = Vec::new();
    for number in 0..ATTEMPTS {
        // A robot that contradicts its chain is refused by the check.
        let Ok(Some(state)) = states::closed(chain, number, at) else {
            return Redundancy::default();
        };
        let Ok(dense) = at(&state) else {
            return Redundancy::default();
        };
        samples.push(Sample::of(dense, zero_pivot, roundoff));
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
    }
    let moves = samples.iter().any(|sample| sample.moves);
    let is_certain = samples.iter().any(|sample| sample.is_certain);
    let most = largest(&samples.iter().collect::<Vec<_>>());
    let named = |is: &dyn Fn(f64) -> bool| -> Vec<String> {
        let names = chain.spaces().names(Space::Constraints).zip(&most);
        let names = names.filter(|(_, pivot)| is(**pivot));
        names.map(|(name, _)| name.to_owned()).collect()
    };
    let dependent = named(&|pivot| pivot < 1.0);
    let uncertain = named(&|pivot| (EXACT..CLEAR).contains(&pivot));
    let borderline = named(&is_borderline);
    let mut warnings = Vec::new();
    if !moves {
        let held = samples.iter().map(|sample| sample.held).max().unwrap_or(0);
        warnings.push(no_motion(chain, held));
    } else if !(uncertain.is_empty() || is_certain && borderline.is_empty()) {
        warnings.push(nearly_dependent(chain, &uncertain));
    }
    Redundancy {
        dependent,
        warnings,
    }
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
    fn of(mut dense: Dense, zero_pivot: f64, roundoff: f64) -> Self {
        let pivots = dense.independence(zero_pivot).into_iter();
        let pivots: Vec<f64> = pivots.map(|pivot| pivot / zero_pivot).collect();
        let residuals = dense.residuals();
        let open = residuals.iter().map(|residual| residual.size());
        let held = dense.held();
        let accelerations = |dense: &Dense, zero_pivot| {
            let mut solution = dense.constrained(zero_pivot);
            solution.truncate(dense.state.velocities());
            solution
        };
        Self {
            is_closed: open.fold(0.0, f64::max) < OPEN,
            held,
            moves: pivots.iter().filter(|pivot| **pivot >= CLEAR).count() < held,
            pivots,
            is_certain: dense.sensitivity(accelerations, (zero_pivot, roundoff)) <= CERTAIN,
        }
    }

    const fn is_useful(&self) -> bool {
        self.is_closed && self.moves
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

/// The warning that loops hold every joint among those that change their residuals.
fn no_motion(chain: &Chain, held: usize) -> Diagnostic {
    let names: Vec<String> = chain
        .loops
        .iter()
        .map(|closed| quoted(&closed.name))
        .collect();
    let (loops, hold, its) = if let [_] = &*names {
        ("loop", "holds", "its")
    } else {
        ("loops", "hold", "their")
    };
    let which = if held == chain.spaces().velocities.len() {
        ": nothing can move".to_owned()
    } else {
        format!(" that moves {its} ends against each other")
    };
    Diagnostic {
        place: chain.loops[0].place,
        message: format!(
            "{loops} {} {hold} where closed every joint{which}",
            list(names.iter().map(String::as_str))
        ),
        hint: Some(DIGITS.to_owned()),
    }
}

const DIGITS: &str = "if the loops should move, write axes, angles and offsets with more digits, or give a loop a type \
                      that leaves free what others constrain";

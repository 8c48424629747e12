//! Residuals that depend on others where the loops are closed.
//!
//! In: a description and its chain. Out: the residuals that the others imply in closed configurations, as in every
//! over-constrained mechanism that moves; and warnings where rounding of the description decides it, or where the
//! loops leave no motion.

use super::{robot, states};
use crate::chain::Chain;
use crate::dense::{Dense, State};
use crate::description::{Description, freed};
use crate::error::Complaint;
use crate::request::Request;
use crate::space::Space;
use crate::wording::{list, quoted};

/// In how many closed configurations residuals are compared.
const STATES: usize = 2;

/// How many times ε, the part of the whole below which a pivot counts as nothing, is clear of it.
const CLEAR: f64 = 100.0;

/// How many times ε is left of a residual that depends on others to all digits of `f64`.
const EXACT: f64 = 1e-12;

/// By which part of the largest acceleration others may differ with ε.
const CERTAIN: f64 = 1e-3;

/// Which residuals depend on others.
#[derive(Default)]
pub struct Redundancy {
    /// Their names.
    pub dependent: Vec<String>,
    /// What is uncertain about them.
    pub warnings: Vec<Complaint>,
}

/// Compares the residuals of all loops in closed configurations.
#[must_use]
pub fn redundancy(description: &Description, request: &Request, chain: &Chain) -> Redundancy {
    let (description, request) = &freed(description, request);
    let at = |state: &State| {
        let robot = robot::robot(description, request, chain, &state.fields)?;
        Ok(Dense::of(robot, state.clone()))
    };
    let vanishing = request.scalar.vanishing();
    let mut pivots: Vec<Vec<f64>> = Vec::new();
    let mut involved = 0;
    let mut is_certain = false;
    for number in 0..STATES {
        // A robot that contradicts its chain is refused by the check.
        let Ok(Some(state)) = states::closed(chain, request, number, at) else {
            return Redundancy::default();
        };
        let Ok(mut dense) = at(&state) else {
            return Redundancy::default();
        };
        pivots.push(dense.independence(vanishing, false));
        involved = involved.max(dense.held());
        let accelerations = |dense: &Dense, vanishing| {
            let mut solution = dense.constrained(vanishing);
            solution.truncate(dense.state.qd.len());
            solution
        };
        let limits = (vanishing, request.scalar.roundoff());
        is_certain |= dense.sensitivity(accelerations, limits) <= CERTAIN;
    }
    let count = pivots.first().map_or(0, Vec::len);
    let most = |k: usize| pivots.iter().map(|pivots| pivots[k]).fold(0.0, f64::max) / vanishing;
    let most: Vec<f64> = (0..count).map(most).collect();
    let named = |is: &dyn Fn(f64) -> bool| -> Vec<String> {
        let names = chain.spaces().names(Space::Constraints).zip(&most);
        let names = names.filter(|(_, pivot)| is(**pivot));
        names.map(|(name, _)| name.to_owned()).collect()
    };
    let dependent = named(&|pivot| pivot < 1.0);
    let uncertain = named(&|pivot| (EXACT..CLEAR).contains(&pivot));
    let in_doubt = named(&|pivot| (CLEAR.recip()..CLEAR).contains(&pivot));
    let mut warnings = Vec::new();
    if most.iter().filter(|pivot| **pivot >= CLEAR).count() == involved {
        warnings.push(no_motion(chain, involved));
    } else if !(uncertain.is_empty() || is_certain && in_doubt.is_empty()) {
        warnings.push(nearly_dependent(chain, &uncertain));
    }
    Redundancy {
        dependent,
        warnings,
    }
}

fn nearly_dependent(chain: &Chain, residuals: &[String]) -> Complaint {
    let names: Vec<String> = residuals.iter().map(|name| quoted(name)).collect();
    let (is, depend) = if let [_] = residuals {
        ("it does", "depends")
    } else {
        ("they do", "depend")
    };
    Complaint {
        place: chain.loops[0].place,
        message: format!(
            "{} nearly {depend} on the other residuals where the loops are closed: accelerations differ by whether \
             {is}, and rounding decides",
            list(names.iter().map(String::as_str))
        ),
        hint: Some(DIGITS.to_owned()),
    }
}

/// A warning that loops hold every joint of so many that change their residuals.
fn no_motion(chain: &Chain, involved: usize) -> Complaint {
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
    let which = if involved == chain.spaces().velocities.len() {
        ": nothing can move".to_owned()
    } else {
        format!(" that moves {its} ends against each other")
    };
    Complaint {
        place: chain.loops[0].place,
        message: format!(
            "{loops} {} {hold} where closed every joint{which}",
            list(names.iter().map(String::as_str))
        ),
        hint: Some(DIGITS.to_owned()),
    }
}

const DIGITS: &str = "where the mechanism should move, write axes, angles and offsets with more digits, or give a loop \
                      a type that leaves free what others hold";

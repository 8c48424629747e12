//! Comparison of base parameters with torques of the description.
//!
//! In: a description, the request, and a chain whose base parameters have been found. Out: an error if they are wrong.
//! With Y_b, the columns of the regressor that lead a group, and K, the factors of all parameters in the groups, each
//! column of Y has to equal that of Y_b K, and the columns of Y_b must be independent. Both are checked with torques at
//! independent states, by products of dense matrices; base parameters are found by energies in link frames.

mod balance;
mod independent;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;

use super::robot::{Contradiction, robot};
use super::states::wide;
use super::{FAULT, printable};
use crate::chain::Chain;
use crate::chain::base_parameters::BaseParameters;
use crate::dense::{Dense, MotionOrder};
use crate::error::Errors;
use crate::expression::Double;
use crate::list::List;
use crate::space::{ParameterId, VelocityId};
use crate::wording::quoted;
use balance::units;
use independent::{Dependent, ROUNDED, Rows, Seen, first_dependent, own_rows};

/// Relative error of a column, with rows in units of their own.
const OFF: f64 = 1e-10;

/// Number of states for a block of columns beyond the number that could determine it.
const MORE: usize = 2;

/// Number of states at which all columns are compared.
const CHECKED: usize = 2;

/// Compares the base parameters of a chain with its description, with fields at their described values.
///
/// # Errors
/// If one is not finite in the type that it is printed for; if 106 bits do not decide which columns depend on each
/// other; if torques by base parameters are wrong, or base parameters depend on each other.
pub fn judge_base_parameters(chain: &Chain) -> Result<(), Errors> {
    let Some(base) = &chain.base_parameters else {
        return Ok(());
    };
    let place = chain.description.name.place;
    let values = base.groups.iter().map(|group| group.value);
    printable(
        (&chain.description.source, place),
        values,
        chain.request.scalar,
    )?;
    let mut errors = chain.description.source.errors();
    if base.is_uncertain() {
        let message = "base parameters cannot be told apart: torques of one inertial parameter are so nearly those of \
                       others together that 106 bits do not decide";
        errors.push_with_hint(place, message, UNCERTAIN);
        return Err(errors);
    }
    let counts = base.blocks.iter().map(|block| block.leading.len() + MORE);
    let counts: Vec<usize> = counts.collect();
    let most = counts.iter().copied().max().unwrap_or(0).max(CHECKED);
    let mut seen = Vec::new();
    let mut rows: Vec<Rows> = base.blocks.iter().map(|_| Vec::new()).collect();
    for (k, state) in wide(chain, most).into_iter().enumerate() {
        let robot = match robot(chain, &state.fields) {
            Ok(robot) => robot,
            Err(Contradiction(what)) => {
                let message = format!("chain and description disagree: {what}");
                errors.push_with_hint(place, message, FAULT);
                return Err(errors);
            }
        };
        let wanted = base.blocks.iter().zip(&counts);
        let wanted = wanted.filter(|(_, count)| **count > k);
        let wanted: BTreeSet<ParameterId> = wanted
            .flat_map(|(block, _)| block.leading.clone())
            .collect();
        let is_wanted = |parameter: ParameterId| k < CHECKED || wanted.contains(&parameter);
        let dense = Dense::of(robot, state);
        let (regressor, sizes) = dense.regressor_and_sizes(is_wanted);
        let at = Seen {
            torques: dense.torques(MotionOrder::Accelerated),
            regressor,
            sizes,
        };
        for ((block, rows), count) in base.blocks.iter().zip(&mut rows).zip(&counts) {
            if *count > k {
                rows.extend(own_rows(block, &at));
            }
        }
        if k < CHECKED {
            seen.push(at);
        }
    }
    let name = |parameter: ParameterId| quoted(&chain.spaces().parameters[parameter].name);
    if let Some(wrong) = first_wrong(base, &seen) {
        let name = name(wrong.parameter);
        if wrong.is_rounding {
            let message = format!(
                "base parameters cannot be told apart: torques of {name} by others would be off by what the rounding of \
                 numbers to 64 bits makes of them"
            );
            errors.push_with_hint(place, message, UNCERTAIN);
        } else {
            let message = format!(
                "torques of {name} by base parameters would be off by {:.0e} of themselves",
                wrong.off
            );
            errors.push_with_hint(place, message, FAULT);
        }
    } else if let Some((row, [found, expected])) = first_wrong_torque(base, &seen) {
        let joint = quoted(&chain.spaces().velocities[row].name);
        let message = format!(
            "the torque of joint {joint} by base parameters would be {found:e}, and is {expected:e} by the description"
        );
        errors.push_with_hint(place, message, FAULT);
    } else if let Some(Dependent(parameter)) = first_dependent(base, &seen[0], rows) {
        let name = name(parameter);
        let message = format!("base parameters would depend on each other: {name} on others");
        errors.push_with_hint(place, message, FAULT);
    }
    errors.into_result(())
}

/// Hint about base parameters that cannot be determined.
const UNCERTAIN: &str = "ask for `regressor`, whose columns are of all parameters; or write angles, axes and lengths \
                         that are meant to be the same with the same digits, or model a robot whose masses and lengths \
                         differ less";

/// Error of torques by values of base parameters, relative to the size of their terms.
const VALUED: f64 = 1e-12;

/// The first torque that values of base parameters make wrong, with both values.
fn first_wrong_torque(base: &BaseParameters, seen: &[Seen]) -> Option<(VelocityId, [f64; 2])> {
    seen.iter().find_map(|at| {
        at.torques.numbered().find_map(|(row, torque)| {
            let terms = base.groups.iter().map(|group| {
                let entry = at.regressor[group.leading()][row].to_f64();
                (entry * group.value, entry.abs() * group.size)
            });
            let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), (term, of_term)| {
                (sum + term, size + of_term)
            });
            let torque_size = torque.noise();
            let expected = torque.to_f64();
            // NaN is wrong as well.
            let right = (sum - expected).abs() <= VALUED * size + torque_size;
            (!right).then_some((row, [sum, expected]))
        })
    })
}

/// A parameter whose column differs from the combination of base columns.
struct Wrong {
    parameter: ParameterId,
    /// Its relative error.
    off: f64,
    /// True if the rounding of factors, or of the numbers of the description, to `f64` explains it.
    is_rounding: bool,
}

/// The first column of Y that differs in Y_b K.
fn first_wrong(base: &BaseParameters, seen: &[Seen]) -> Option<Wrong> {
    let first = &seen.first()?.regressor;
    let mut factors: List<ParameterId, Vec<(ParameterId, f64)>> = first.map(|_| Vec::new());
    for group in &base.groups {
        for &(member, factor) in &group.members {
            factors[member].push((group.leading(), factor));
        }
    }
    let units = units_of_rows(seen);
    factors.numbered().find_map(|(parameter, terms)| {
        let rows = units.ids();
        let rows = rows.map(|row| Compared::of(parameter, terms, row, seen));
        let rows: List<VelocityId, Compared> = rows.collect();
        let most = |of: fn(&Compared) -> f64| {
            let shares = rows.iter().zip(&units);
            shares.map(|(row, unit)| of(row) / unit).fold(0.0, f64::max)
        };
        let (whole, size) = (most(|row| row.whole), most(|row| row.size));
        let mut rows = rows.iter().zip(&units);
        rows.find_map(|(row, unit)| {
            // NaN is wrong as well.
            let right = row.off <= (OFF * whole + ROUNDED * size) * unit;
            (!right).then(|| Wrong {
                parameter,
                off: row.off / (whole * unit),
                is_rounding: row.off <= row.explained + ROUNDED * row.size,
            })
        })
    })
}

/// Units in which rows of the regressor can be compared.
fn units_of_rows(seen: &[Seen]) -> List<VelocityId, f64> {
    let at = seen.iter().flat_map(|at| {
        let rows = at.torques.ids();
        rows.map(|row| at.sizes.iter().map(|column| column[row]).collect())
    });
    let [of_all, _] = units(at.collect());
    let rows = seen.iter().flat_map(|at| at.torques.ids());
    let mut largest = seen[0].torques.map(|_| 0.0_f64);
    for (row, unit) in rows.zip(of_all) {
        largest[row] = largest[row].max(unit);
    }
    largest
}

/// A column of Y compared with that of Y_b K, in a row at all states.
struct Compared {
    off: f64,
    whole: f64,
    /// Size of an entry's terms.
    size: f64,
    /// The error that the rounding of factors, and of the numbers of the description, to `f64` explains.
    explained: f64,
}

impl Compared {
    fn of(
        parameter: ParameterId,
        terms: &[(ParameterId, f64)],
        row: VelocityId,
        seen: &[Seen],
    ) -> Self {
        let [mut off, mut whole, mut size, mut explained] = [0.0_f64; 4];
        for Seen {
            regressor, sizes, ..
        } in seen
        {
            let expected = regressor[parameter][row];
            let (mut rest, mut rounding) = (expected.value, expected.error);
            for &(leading, factor) in terms {
                let entry = regressor[leading][row];
                let term = Double::from(factor) * entry.value;
                rest = rest - term;
                rounding += 4.0 * f64::EPSILON * term.to_f64().abs() + factor.abs() * entry.error;
                size = size.max(factor.abs() * sizes[leading][row]);
            }
            off = off.max(rest.to_f64().abs());
            whole = whole.max(expected.size());
            explained = explained.max(rounding);
            size = size.max(sizes[parameter][row]);
        }
        Self {
            off,
            whole,
            size,
            explained,
        }
    }
}

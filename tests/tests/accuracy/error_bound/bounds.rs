//! Comparison of bounds with the worst measured errors.
//!
//! In: the bounds of a function, the errors of its results. Out: true if all errors are within their bounds and no
//! bound is far above them; a table of both.

use std::fmt::Write;

use homogen_codegen::Function;
use homogen_codegen::accuracy::Bound;
use homogen_codegen::chain::Chain;

/// The worst error of the results to which a bound applies.
fn worst_of(chain: &Chain, function: Function, bound: &Bound, errors: &[f64]) -> f64 {
    let (result, spaces) = (function.result(), chain.spaces());
    let name = |k: usize| {
        let (space, entry) = result.owner(spaces, k)?;
        Some(&spaces.entries(space)[entry].name)
    };
    let units = result.units(spaces).into_iter();
    let own = units.zip(errors).enumerate();
    let own = own.filter(|(k, (unit, _))| *unit == bound.unit && name(*k) == bound.joint.as_ref());
    own.fold(0.0, |most, (_, (_, &error))| most.max(error))
}

/// The value of a bound in one type.
pub fn number(bound: &Bound) -> f64 {
    let number = bound.double.or(bound.single);
    number.expect("a bound in one type")
}

/// True if the errors of all joints are within their bounds, and the largest bound of each unit is at most `farthest`
/// times the worst error. Appends both to a table.
pub fn holds(
    chain: &Chain,
    function: Function,
    bounds: &[Bound],
    errors: &[f64],
    farthest: f64,
    table: &mut String,
) -> bool {
    let mut units: Vec<&str> = bounds.iter().map(|bound| bound.unit).collect();
    units.sort_unstable();
    units.dedup();
    let mut holds = true;
    for unit in units {
        let (mut most, mut worst) = (0.0_f64, 0.0_f64);
        for bound in bounds.iter().filter(|bound| bound.unit == unit) {
            let (bounded, found) = (number(bound), worst_of(chain, function, bound, errors));
            holds &= found <= bounded;
            if found > bounded {
                writeln!(table, "{bound:?}: {found:.1e}").expect("a string takes everything");
            }
            (most, worst) = (most.max(bounded), worst.max(found));
        }
        // Exact results may have a bound for rounded numbers.
        holds &= most <= farthest * worst || worst == 0.0;
        let name = function.name();
        writeln!(table, "{name:20} {unit:6} {worst:9.1e} of {most:9.1e}")
            .expect("a string takes everything");
    }
    holds
}

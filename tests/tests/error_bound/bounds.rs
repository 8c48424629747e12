//! Bounds beside the worst errors that were measured.
//!
//! In: the bounds of a function, the errors of its results. Out: whether none is beyond its bound and
//! none of the bounds far beyond, and a table of both.

use std::fmt::Write;

use homogen_codegen::Function;
use homogen_codegen::accuracy::Bound;
use homogen_codegen::chain::Chain;

/// The worst of the errors of a function's results that a bound is of.
fn worst_of(chain: &Chain, function: Function, bound: &Bound, errors: &[f64]) -> f64 {
    let (result, spaces) = (function.result(), chain.spaces());
    let name = |k: usize| {
        let owner = result.owner(spaces, k)?;
        Some(&spaces.velocities[owner].name)
    };
    let units = result.units(spaces).into_iter();
    let own = units.zip(errors).enumerate();
    let own = own.filter(|(k, (unit, _))| *unit == bound.unit && name(*k) == bound.joint.as_ref());
    own.fold(0.0, |most, (_, (_, &error))| most.max(error))
}

/// The number of a bound that is of one type.
pub fn number(bound: &Bound) -> f64 {
    let number = bound.double.or(bound.single);
    number.expect("it is of one type")
}

/// Whether no joint's error is beyond its bound, and the worst bound of each unit no farther from the
/// worst error than that; in a table.
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
            let (promised, found) = (number(bound), worst_of(chain, function, bound, errors));
            holds &= found <= promised;
            if found > promised {
                writeln!(table, "{bound:?}: {found:.1e}").expect("a string takes everything");
            }
            (most, worst) = (most.max(promised), worst.max(found));
        }
        // What is exact may have been bounded as if its numbers were not.
        holds &= most <= farthest * worst || worst == 0.0;
        let name = function.name();
        writeln!(table, "{name:20} {unit:6} {worst:9.1e} of {most:9.1e}")
            .expect("a string takes everything");
    }
    holds
}

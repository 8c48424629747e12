//! Runs every program of one function in turns, and prints the time and the errors of each.
//!
//! In: `SCENE FUNCTION TRUTH BATCHES`, with TRUTH the folder of the scene's states and exact results; then, for each
//! other program, `MAKER TYPE SYMBOL LIBRARY`. Out: a line a program: name, type, quartiles of the time per call in ns,
//! median, 99th percentile and maximum of the error. The source of the programs is generated.

mod case;
#[path = "../../../../examples/src/entries.rs"]
mod entries;
mod library;
mod peer;
#[path = "../../../../examples/src/timing.rs"]
mod timing;
mod truth;
mod with_libm;

use std::error::Error;
use std::time::Duration;

use case::Case;
#[allow(
    unused_imports,
    reason = "the generated robots need it, where there are any"
)]
use case::State;
use truth::Truths;
#[allow(
    unused_imports,
    reason = "the generated robots need it, where there are any"
)]
use with_libm::Libm;

include!(concat!(env!("OUT_DIR"), "/cases.rs"));

/// The shortest batch: long relative to the clock's resolution, short relative to other events on a machine.
const SHORTEST: Duration = Duration::from_micros(200);

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, function, folder, batches, peers @ ..] = &arguments[..] else {
        return Err("measured SCENE FUNCTION TRUTH BATCHES [MAKER TYPE SYMBOL LIBRARY]…".into());
    };
    let truths = Truths::read(folder.as_ref(), function)?;
    let mut cases = cases(scene, function, &truths);
    for peer in peers.as_chunks().0 {
        cases.push(peer::load(peer, function, &truths)?);
    }
    let batches_of_cases: Vec<&dyn Fn()> = cases.iter().map(|case| &*case.batch).collect();
    let calls = u32::try_from(truths.of("f64").states)?;
    let times = timing::alternate(batches.parse()?, calls, SHORTEST, &batches_of_cases);
    for (case, time) in cases.iter().zip(times) {
        let truth = truths.of(case.scalar);
        let errors = truth.errors(&*case.results, &case.entries);
        println!(
            "{} {} {:.3} {:.3} {:.3} {:e} {:e} {:e}",
            case.name,
            case.scalar,
            time.lower,
            time.median,
            time.upper,
            errors.median,
            errors.rare,
            errors.worst
        );
    }
    Ok(())
}

//! Runs every program of one function on many states in turns, and prints the time and the errors of each.
//!
//! In: `SCENE FUNCTION TRUTH BATCHES STATES`, with TRUTH the folder of the scene's states and exact results, which are
//! repeated until each thread has STATES of them; then, for each other program, `MAKER TYPE SYMBOL LIBRARY`. Out: a line
//! a program as from `measured`, with times per state; first on one thread, then on all, with `:all` behind the name.
//! The source of the programs is generated.

#[path = "../../../../examples/src/entries.rs"]
mod entries;
mod library;
mod limit;
mod program;
#[path = "../../../../examples/src/timing.rs"]
mod timing;
mod truth;

use std::cell::RefCell;
use std::error::Error;
use std::fmt::Write;
use std::time::Duration;

#[allow(
    unused_imports,
    reason = "the generated robots need it, where there are any"
)]
use homogen::batch::Batch;
use homogen::batch::Number;
use rayon::ThreadPoolBuilder;

use entries::Entries;
use program::{Foreigners, Program};
use truth::Truths;

/// Our programs of a function: one state at a time, and in registers of each length that this processor has.
#[allow(
    unused_macros,
    reason = "the generated robots need it, where there are any"
)]
macro_rules! programs {
    ($robot:expr, $function:ident, $coordinates:literal, $velocities:literal) => {{
        let mut programs = vec![Program::alone("alone", |q, qd, x| {
            $robot.$function(q, qd, x)
        })];
        for (name, vectors) in program::kinds() {
            programs.push(Program::batch(name.to_owned(), move |q, qd, x, results| {
                let batch = Batch::of(&$robot).at_most(vectors);
                batch.$function(q, qd, x, results).expect("as long");
            }));
        }
        programs
    }};
}

include!(concat!(env!("OUT_DIR"), "/many.rs"));

/// The shortest batch: long relative to the clock's resolution, short relative to other events on a machine.
const SHORTEST: Duration = Duration::from_micros(200);

/// A type of number, with the programs that are measured in it.
trait Measured: Number + Entries + 'static {
    const NAME: &str;

    /// Our programs of a function of a scene.
    fn ours(scene: &str, function: &str) -> Vec<Program<Self>>;

    /// The limit of the processor: about a thousand independent fused operations for each state.
    fn limit(states: usize) -> Option<Program<Self>>;
}

impl Measured for f64 {
    const NAME: &str = "f64";

    fn ours(scene: &str, function: &str) -> Vec<Program<Self>> {
        in_f64(scene, function)
    }

    fn limit(states: usize) -> Option<Program<Self>> {
        limit::in_f64(states)
    }
}

impl Measured for f32 {
    const NAME: &str = "f32";

    fn ours(scene: &str, function: &str) -> Vec<Program<Self>> {
        in_f32(scene, function)
    }

    fn limit(states: usize) -> Option<Program<Self>> {
        limit::in_f32(states)
    }
}

/// The arguments of the command line.
struct Request<'a> {
    scene: &'a str,
    function: &'a str,
    truths: Truths,
    batches: usize,
    /// Number of states of each thread.
    states: usize,
    peers: &'a [[String; 4]],
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, function, folder, batches, states, peers @ ..] = &arguments[..] else {
        let usage = "many SCENE FUNCTION TRUTH BATCHES STATES [MAKER TYPE SYMBOL LIBRARY]…";
        return Err(usage.into());
    };
    let request = Request {
        scene,
        function,
        truths: Truths::read(folder.as_ref(), function)?,
        batches: batches.parse()?,
        states: states.parse()?,
        peers: peers.as_chunks().0,
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    for (suffix, threads) in [("", 1), (":all", threads)] {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build()?;
        // Inside the pool, so that a batch on one thread need not wake another.
        let text = pool.install(|| {
            let double = measure::<f64>(&request, suffix)?;
            Ok::<_, String>(double + &measure::<f32>(&request, suffix)?)
        });
        print!("{}", text?);
    }
    Ok(())
}

/// A line for each program in one type of number, on the threads of the pool that this runs in.
fn measure<T: Measured>(request: &Request<'_>, suffix: &str) -> Result<String, String> {
    let truth = request.truths.of(T::NAME);
    let mut programs = T::ours(request.scene, request.function);
    for [maker, scalar, symbol, library] in request.peers {
        if scalar == T::NAME {
            let foreigners = Foreigners::load(library.as_ref(), symbol);
            let foreigners = foreigners.map_err(|reason| format!("{library}: {reason}"))?;
            let places = truth.places(request.function);
            programs.push(foreigners.program(format!("{maker}/{symbol}"), places, truth.entries()));
        }
    }
    programs.extend(T::limit(request.states));
    let states = request.states * rayon::current_num_threads();
    let lists = truth.places(request.function).map(|place| {
        let of_state = |state: &[f64]| state[place.clone()].to_vec();
        let list = truth.arguments().chunks_exact(truth.length()).cycle();
        let list = list.take(states).flat_map(of_state);
        list.map(T::constant).collect::<Vec<T>>()
    });
    let results = RefCell::new(vec![T::constant(0.0); states * truth.entries()]);
    let batches: Vec<_> = (programs.iter())
        .map(|program| {
            || {
                (program.run)(
                    lists.each_ref().map(Vec::as_slice),
                    &mut results.borrow_mut(),
                );
            }
        })
        .collect();
    let batches: Vec<&dyn Fn()> = batches.iter().map(|batch| batch as &dyn Fn()).collect();
    let calls = u32::try_from(states).map_err(|reason| reason.to_string())?;
    let times = timing::alternate(request.batches, calls, SHORTEST, &batches);
    let mut text = String::new();
    for ((program, batch), time) in programs.iter().zip(batches).zip(times) {
        // The results of one program must not be taken for another's.
        results.borrow_mut().fill(T::constant(f64::NAN));
        batch();
        let found = |state: usize| {
            let (results, mut numbers) = (results.borrow(), Vec::new());
            for entry in &results[state * truth.entries()..][..truth.entries()] {
                entry.push(&mut numbers);
            }
            numbers
        };
        let errors = truth.errors(&found, &[]);
        writeln!(
            text,
            "{}{suffix} {} {:.3} {:.3} {:.3} {:e} {:e} {:e}",
            program.name,
            T::NAME,
            time.lower,
            time.median,
            time.upper,
            errors.median,
            errors.rare,
            errors.worst
        )
        .map_err(|reason| reason.to_string())?;
    }
    Ok(text)
}

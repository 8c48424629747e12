//! A seven-joint arm from its description to checked straight-line code, on one screen.
//!
//! In: the Panda-class arm of `robots/`. Out: facts of the model, the operation count of each function, torques at a
//! state, and each function against the generic recursions of the runtime: largest difference and time per call,
//! in one run.

use std::error::Error;
use std::time::Duration;

use homogen::{Chain, Robot};
use homogen_codegen::Function;
use homogen_examples::bound::{self, Bound, Complete, Number};
use homogen_examples::states::{State, random};
use homogen_examples::timing::{Spread, alternate};
use homogen_examples::{machine, operation_count};

const URDF: &str = include_str!("../../../robots/panda_class.urdf");

/// The arm, with every number folded into the code.
#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8", generate(all))]
struct Panda;

/// A function of an arm whose seven links have ten parameters each.
fn bind<T: Number>(arm: &impl Complete<7, 70, T>, function: Function) -> Bound<'_, T, 7> {
    bound::bind(arm, function)
}

/// The same arm as data, for the generic recursions.
const GENERIC: Chain<7, 1> = Panda::chain();

const NOTES: &str = "  \
  trig: sines and cosines; dense: products and sums if every 4×4 matrix were multiplied out.
  Errors: against the generic recursions in f64, over 1,000 random states, each entry in relation
  to the largest magnitude that it takes in them.
  Times: medians of 25 batches of both in turn, independent states; carry over the ratio only.";

fn main() -> Result<(), Box<dyn Error>> {
    let operation_counts =
        operation_count::count("panda_class.urdf", URDF, "link8").map_err(|e| e.to_string())?;
    let about = &operation_counts.about;
    println!(
        "{}: {} joints, frame 0 is {}, the tip {}\n  {}\n",
        about.robot,
        operation_counts.spaces.coordinates.len(),
        about.base,
        about.tip,
        about.facts.join(" · ")
    );
    show_torques();

    let states = random::<7>(1000, 1);
    println!();
    println!(
        "                                          operations             worst error        ns per call in f64"
    );
    println!(
        "                                          mul  add trig dense      f64     f32  generated generic ratio"
    );
    for function in bound::functions() {
        let operation_count = operation_counts.of(function);
        let [wide, single] = errors(function, &states);
        let (generated, generic) = times(function, &states[..64]);
        println!(
            "  {:<38} {:>4} {:>4} {:>4} {:>5} {wide:>8.0e} {single:>7.0e} {:>10.0} {:>7.0} {:>5.0}",
            function.name(),
            operation_count.mul,
            operation_count.add,
            operation_count.sin + operation_count.cos,
            operation_count.naive_mul + operation_count.naive_add,
            generated.median,
            generic.median,
            generic.median / generated.median,
        );
    }
    println!("\n{NOTES}");
    println!("  {}", machine::describe());
    Ok(())
}

/// Joint torques at one state, generated and generic.
fn show_torques() {
    let state = State {
        q: [0.3, -0.6, 0.2, -2.2, 0.1, 1.6, 0.8],
        qd: [0.5, -0.4, 0.3, 0.6, -0.7, 0.2, 0.9],
        qdd: [1.0, 0.5, -0.5, 2.0, 1.5, -1.0, 3.0],
        tau: [0.0; 7],
        weights: [0.0; 7],
        q_change: [0.0; 7],
        qd_change: [0.0; 7],
        qdd_change: [0.0; 7],
        tau_change: [0.0; 7],
        wrench: [0.0; 6],
    };
    let row = |name: &str, unit: &str, numbers: &[f64], digits: usize| {
        print!("  {name:<11}");
        for number in numbers {
            print!(" {number:>11.digits$}");
        }
        println!("  {unit}");
    };
    row("q", "rad", &state.q, 1);
    row("qd", "rad/s", &state.qd, 1);
    row("qdd", "rad/s²", &state.qdd, 1);
    let function = Function::InverseDynamics;
    row(
        "τ generated",
        "N m",
        &bind(&Panda, function).entries(&state),
        7,
    );
    row(
        "τ generic",
        "N m",
        &bind(&GENERIC, function).entries(&state),
        7,
    );
}

/// The worst differences from the generic recursions in f64: of generated f64, of generated f32.
fn errors(function: Function, states: &[State<f32, 7>]) -> [f64; 2] {
    let reference = bind(&GENERIC, function);
    let reference: Vec<_> = states
        .iter()
        .map(|s| reference.entries(&s.widen()))
        .collect();
    let (wide, single) = (bind(&Panda, function), bind(&Panda, function));
    let wide: Vec<_> = states.iter().map(|s| wide.entries(&s.widen())).collect();
    let single: Vec<_> = states.iter().map(|s| single.entries(s)).collect();
    [worst(&wide, &reference), worst(&single, &reference)]
}

/// The largest difference, each entry relative to its largest magnitude in all states.
fn worst(results: &[Vec<f64>], reference: &[Vec<f64>]) -> f64 {
    let size = |k: usize| {
        reference
            .iter()
            .map(|entries| entries[k].abs())
            .fold(0.0, f64::max)
    };
    let sizes: Vec<f64> = (0..reference[0].len()).map(size).collect();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    let mut worst = 0.0_f64;
    for (result, reference) in results.iter().zip(reference) {
        for ((x, y), size) in result.iter().zip(reference).zip(&sizes) {
            // An entry that is zero in every state is relative to the other entries.
            let size = if *size < 1e-9 * largest {
                largest
            } else {
                *size
            };
            worst = worst.max((x - y).abs() / size);
        }
    }
    worst
}

fn times(function: Function, states: &[State<f32, 7>]) -> (Spread, Spread) {
    let states: Vec<_> = states.iter().map(State::widen).collect();
    let generated: Bound<'_, f64, 7> = bind(&Panda, function);
    let generic = bind(&GENERIC, function);
    let batches: [&dyn Fn(); 2] = [&|| generated.batch(&states), &|| generic.batch(&states)];
    let times = alternate(25, 64, Duration::from_micros(500), &batches);
    (times[0], times[1])
}

//! The inverse dynamics of an arm in batches: nanoseconds a state, in registers of every length, on one core and
//! on all.
//!
//! In: the Panda-class arm of `robots/`, and the number of states on all cores, 32768 where none is named. Out: a table of
//! times and of their ratios to one state at a time, from one run in which the programs take turns. With
//! `RAYON_NUM_THREADS=1` the rows of all cores are those of one thread.

use std::cell::RefCell;
use std::time::Duration;

use homogen::Robot;
use homogen::batch::{Batch, Number, Vectors};
use homogen_examples::machine;
use homogen_examples::states::{State, random};
use homogen_examples::timing::alternate;

/// The arm, with a method for slices of states.
#[derive(Robot)]
#[robot(
    urdf = "../robots/panda_class.urdf",
    tip = "link8",
    generate(inverse_dynamics),
    batch
)]
struct Panda;

/// The largest number of states that a batch does not split between cores.
const FEW: usize = 512;

/// States for all cores, where no number is named.
const MANY: usize = 1 << 15;

fn main() {
    let named = std::env::args().nth(1);
    let many = named.map_or(MANY, |number| number.parse().expect("a number of states"));
    assert!(many >= FEW, "at least {FEW} states");
    let single = random::<7>(many, 1);
    let double: Vec<_> = single.iter().map(State::widen).collect();
    println!("inverse dynamics, Panda class       ns a state  ratio  10⁶ states/s\n");
    table("f64", &double);
    table("f32", &single);
    println!("  Lower quartiles of 301 batches in turn; ratios are to one state at a time.");
    println!("  {}", machine::describe());
}

/// Every program in one type of number.
fn table<T: Number>(number: &str, states: &[State<T, 7>]) {
    let list = |part: fn(&State<T, 7>) -> [T; 7]| states.iter().map(part).collect::<Vec<_>>();
    let (q, qd, qdd) = (
        list(|state| state.q),
        list(|state| state.qd),
        list(|state| state.qdd),
    );
    let tau = RefCell::new(q.clone());
    let one_by_one = || {
        let mut tau = tau.borrow_mut();
        for (i, tau) in tau.iter_mut().take(FEW).enumerate() {
            *tau = Panda.inverse_dynamics(&q[i], &qd[i], &qdd[i]);
        }
    };
    let batch = |most: Vectors, states: usize| {
        let tau = &mut tau.borrow_mut()[..states];
        let done = Batch::of(&Panda).at_most(most).inverse_dynamics(
            &q[..states],
            &qd[..states],
            &qdd[..states],
            tau,
        );
        done.expect("as long");
    };
    let columns = [&q, &qd, &qdd].map(|states| columns(states));
    let tau_columns = RefCell::new(columns[0].clone());
    let by_columns = |most: Vectors, states: usize| {
        let [q, qd, qdd] =
            (columns.each_ref()).map(|of| of.each_ref().map(|column| &column[..states]));
        let mut tau = tau_columns.borrow_mut();
        let mut tau = tau.each_mut().map(|column| &mut column[..states]);
        let batch = Batch::of(&Panda).at_most(most).columns();
        let done = batch.inverse_dynamics(q, qd, qdd, &mut tau);
        done.expect("as long");
    };
    let many = states.len();
    let programs: [(&str, usize, &dyn Fn()); 7] = [
        ("one state at a time", FEW, &one_by_one),
        ("batch, up to 256 bits", FEW, &|| {
            batch(Vectors::Bits256, FEW);
        }),
        ("batch, up to 512 bits", FEW, &|| {
            batch(Vectors::Bits512, FEW);
        }),
        ("columns, up to 256 bits", FEW, &|| {
            by_columns(Vectors::Bits256, FEW);
        }),
        ("columns, up to 512 bits", FEW, &|| {
            by_columns(Vectors::Bits512, FEW);
        }),
        ("batch on all cores", many, &|| {
            batch(Vectors::Bits512, many);
        }),
        ("columns on all cores", many, &|| {
            by_columns(Vectors::Bits512, many);
        }),
    ];
    let batches = programs.map(|(_, _, program)| program);
    let times = alternate(301, 1, Duration::from_micros(50), &batches);
    let per_state = |index: usize| times[index].lower / f64_of(programs[index].1);
    for (index, (name, ..)) in programs.iter().enumerate() {
        let time = per_state(index);
        println!(
            "  {number} {name:<30} {time:>8.1} {:>6.2} {:>13.1}",
            time / per_state(0),
            1e3 / time
        );
    }
    println!();
}

/// A column for each entry of some states.
fn columns<T: Copy>(states: &[[T; 7]]) -> [Vec<T>; 7] {
    std::array::from_fn(|k| states.iter().map(|state| state[k]).collect())
}

fn f64_of(count: usize) -> f64 {
    f64::from(u32::try_from(count).expect("few"))
}

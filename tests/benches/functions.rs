//! Time per call of every generated function, beside the generic recursions of the runtime.
//!
//! Method: plain `std`, one thread. Generated and generic code take turns in one run, batch by
//! batch; a batch goes through 64 random states, which are independent, so that calls may overlap as
//! they would in a loop over samples. The table shows median and quartiles over the batches. Only
//! the ratio carries over to another machine, and differences under 10 % are noise: for less, pin
//! the program to one core and fix its clock (`taskset -c 2 cargo bench -p homogen-tests`).

use std::time::Duration;

use homogen::{Chain, Robot};
use homogen_examples::bound::{self, Complete, Number, bind};
use homogen_examples::machine;
use homogen_examples::states::{State, random};
use homogen_examples::timing::{Spread, alternate};

const BATCHES: usize = 101;
const SHORTEST: Duration = Duration::from_micros(200);

/// Declares a robot with all functions.
macro_rules! robot {
    ($robot:ident, $urdf:literal, $tip:literal) => {
        #[derive(Robot)]
        #[robot(urdf = $urdf, tip = $tip, generate(all))]
        struct $robot;
    };
}

robot!(Ur5, "../robots/ur5_class.urdf", "tool0");
robot!(Panda, "../robots/panda_class.urdf", "link8");
robot!(Quadruped, "../robots/quadruped.urdf", "fl_foot");

fn main() {
    println!("{}", machine::describe());
    println!("median over {BATCHES} batches in ns per call, quartiles in brackets\n");
    compare::<_, 6, 60, _>("ur5_class", &Ur5, &Ur5::chain());
    compare::<_, 7, 70, _>("panda_class", &Panda, &Panda::chain());
    compare::<_, 12, 120, _>("quadruped", &Quadruped, &Quadruped::chain());
}

/// Both precisions of one robot, whose links have P parameters.
fn compare<R, const N: usize, const P: usize, const F: usize>(
    name: &str,
    robot: &R,
    chain: &Chain<N, F>,
) where
    R: Complete<N, P, f64> + Complete<N, P, f32>,
{
    let single = random::<N>(64, 1);
    let double: Vec<_> = single.iter().map(State::widen).collect();
    table::<_, _, _, N, P>(&format!("{name}, f64"), robot, chain, &double);
    table::<_, _, _, N, P>(&format!("{name}, f32"), robot, chain, &single);
}

fn table<R, C, T: Number, const N: usize, const P: usize>(
    name: &str,
    robot: &R,
    chain: &C,
    states: &[State<T, N>],
) where
    R: Complete<N, P, T>,
    C: Complete<N, P, T>,
{
    println!(
        "{name:<28} {:>20} {:>22} {:>6}",
        "generated", "generic", "ratio"
    );
    for function in bound::functions() {
        let generated = bind(robot, function);
        let generic = bind(chain, function);
        let calls = u32::try_from(states.len()).expect("64 states");
        let batches: [&dyn Fn(); 2] = [&|| generated.batch(states), &|| generic.batch(states)];
        let times = alternate(BATCHES, calls, SHORTEST, &batches);
        let (generated, generic) = (times[0], times[1]);
        println!(
            "{:<28} {:>20} {:>22} {:>6.1}",
            function.name(),
            cell(generated),
            cell(generic),
            generic.median / generated.median
        );
    }
    println!();
}

fn cell(time: Spread) -> String {
    format!("{:.0} ({:.0}–{:.0})", time.median, time.lower, time.upper)
}

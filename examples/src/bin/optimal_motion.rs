//! The optimal motion of an arm: an iterative linear-quadratic regulator on generated derivatives.
//!
//! The arm moves to another configuration within a second, from rest to rest. The cost has torques beyond the holding
//! ones, rates, and the errors at the end. The solver is that of `homogen_examples::optimal`, written for any robot. Draws
//! the cost of each iteration, joints and torques to `target/optimal_motion.svg` or to the path given.

use std::io;
use std::time::Instant;

use homogen::Robot;
use homogen_examples::drawing::joints;
use homogen_examples::machine;
use homogen_examples::motion::largest;
use homogen_examples::optimal::{Plan, Problem};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};

#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(gravity, forward_dynamics, forward_dynamics_derivatives))]
struct Panda;

const PROBLEM: Problem<7> = Problem {
    from: [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8],
    to: [1.2, 0.2, -0.5, -1.3, 0.6, 1.2, 0.0],
    steps: 100,
    period: 0.01,
    effort: 1e-3,
    haste: 0.05,
    miss: [100.0, 10.0],
};
const ITERATIONS: usize = 40;

fn main() -> io::Result<()> {
    let begin = Instant::now();
    let plan = solve();
    let time = begin.elapsed();
    let [missed, rest] = missed(&plan);
    println!(
        "Panda-class arm, from rest to rest in a second, {} steps",
        PROBLEM.steps
    );
    println!(
        "  cost {:.4} after {} iterations, {:.4} at the beginning",
        last(&plan.costs),
        plan.costs.len() - 1,
        plan.costs[0]
    );
    println!("  misses its end by {missed:.1e} rad, and rest by {rest:.1e} rad/s");
    println!(
        "  {:.1} ms an iteration, of which most is linear algebra",
        1e3 * time.as_secs_f64() / count(&plan)
    );
    println!("  {}", machine::describe());
    let path = plot::path_from_arguments("optimal_motion");
    plot::write(&path, &page(&plan))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

fn solve() -> Plan<7> {
    PROBLEM.solve(&Panda, &Panda.gravity(&PROBLEM.from), ITERATIONS)
}

fn last(costs: &[f64]) -> f64 {
    costs[costs.len() - 1]
}

/// Number of iterations.
fn count(plan: &Plan<7>) -> f64 {
    f64::from(u32::try_from(plan.costs.len() - 1).expect("a few"))
}

/// The largest errors at the end: of coordinates \[rad\] and of rates \[rad/s\].
fn missed(plan: &Plan<7>) -> [f64; 2] {
    let [q, qd] = plan.states[PROBLEM.steps];
    let off = q.iter().zip(&PROBLEM.to).map(|(q, to)| q - to);
    [largest(off), largest(qd)]
}

fn page(plan: &Plan<7>) -> Page {
    let time = |k: usize| f64::from(u32::try_from(k).expect("a few hundred")) * PROBLEM.period;
    let costs = plan.costs.iter().zip(0_u32..);
    let costs = costs.map(|(cost, iteration)| [f64::from(iteration), *cost]);
    let costs = Panel {
        x: Axis {
            label: "iteration",
            scale: Scale::Linear,
        },
        y: Axis {
            label: "cost",
            scale: Scale::Log,
        },
        curves: vec![Curve {
            label: String::new(),
            points: costs.collect(),
            color: Color::Blue,
            style: Style::Dots,
        }],
        marks: Vec::new(),
        height: 220.0,
        to_scale: false,
    };
    let states = plan.states.iter().enumerate();
    let torques = plan.torques.iter().enumerate();
    Page {
        title: "From rest to rest in a second, for the least effort".to_owned(),
        panels: vec![
            costs,
            joints("joints [rad]", states.map(|(k, [q, _])| (time(k), *q))),
            joints("torques [N m]", torques.map(|(k, tau)| (time(k), *tau))),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{last, missed, solve};

    #[test]
    fn every_iteration_decreases_the_cost_and_the_goal_is_reached() {
        let plan = solve();
        assert!(plan.costs.windows(2).all(|pair| pair[1] < pair[0]));
        assert!(last(&plan.costs) < 0.1 * plan.costs[0], "{:?}", plan.costs);
        let [place, rest] = missed(&plan);
        assert!(place < 0.02 && rest < 0.1, "{place} {rest}");
    }
}

//! The optimal motion of an arm that reaches a point: second derivatives beside Gauss and Newton's approximation.
//!
//! The flange moves to a point within a second, from rest to rest. The cost has torques beyond the holding ones, rates, and
//! the errors at the end. Differential dynamic programming takes all second derivatives from generated code; the iterative
//! linear-quadratic regulator leaves out those of the dynamics and of the position. The solver is that of
//! `homogen_examples::optimal`, written for any robot. Draws the cost of each iteration, joints and torques to
//! `target/optimal_motion.svg` or to the path given.

use std::io;
use std::time::Instant;

use homogen::Robot;
use homogen_examples::drawing::joints;
use homogen_examples::machine;
use homogen_examples::motion::largest;
use homogen_examples::optimal::{Method, Plan, Problem};
use homogen_plot::{self as plot, Axis, Color, Curve, Page, Panel, Scale, Style};

#[derive(Robot)]
#[robot(urdf = "../robots/panda_class.urdf", tip = "link8")]
#[robot(generate(
    gravity,
    forward_kinematics,
    geometric_jacobian,
    forward_kinematics_hessian,
    forward_dynamics,
    forward_dynamics_derivatives,
    forward_dynamics_hessian
))]
struct Panda;

/// `tests/crocoddyl/reach.py` solves the same problem.
const PROBLEM: Problem<7> = Problem {
    from: [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8],
    goal: [0.36, 0.45, 0.64],
    steps: 100,
    period: 0.01,
    effort: 1e-3,
    haste: 0.05,
    miss: [1000.0, 10.0],
};
const ITERATIONS: usize = 200;
/// Solutions of which the shortest is timed.
const REPEATS: usize = 20;
/// Relative excess of the cost at which an iteration counts as the last one.
const NEAR: f64 = 1e-9;

fn main() -> io::Result<()> {
    println!(
        "Panda-class arm, from rest to rest in a second, {} steps",
        PROBLEM.steps
    );
    let [(regulator, regulator_time), (exact, exact_time)] = [Method::GaussNewton, Method::Exact]
        .map(|method| {
            let runs = (0..REPEATS).map(|_| {
                let begin = Instant::now();
                let plan = solve(method);
                (plan, begin.elapsed().as_secs_f64())
            });
            let shortest = runs.min_by(|(_, a), (_, b)| a.total_cmp(b));
            shortest.expect("at least one run")
        });
    println!("  cost {:.9} at the beginning", exact.costs[0]);
    for (name, plan, time) in [
        (
            "iterative linear-quadratic regulator",
            &regulator,
            regulator_time,
        ),
        ("differential dynamic programming", &exact, exact_time),
    ] {
        let iterations = plan.costs.len() - 1;
        let each = 1e3 * time / f64::from(u32::try_from(iterations).expect("a few"));
        println!(
            "  {name}: cost {:.9}; {} iterations to within {NEAR:.0e} of it, {each:.2} ms each",
            last(&plan.costs),
            needed(&plan.costs),
        );
    }
    let [missed, rest] = missed(&exact);
    println!("  misses its end by {missed:.1e} m, and rest by {rest:.1e} rad/s");
    println!("  {}", machine::describe());
    let path = plot::path_from_arguments("optimal_motion");
    plot::write(&path, &page(&regulator, &exact))?;
    println!("  drawn in {}", path.display());
    Ok(())
}

fn solve(method: Method) -> Plan<7> {
    PROBLEM.solve(&Panda, method, &Panda.gravity(&PROBLEM.from), ITERATIONS)
}

fn last(costs: &[f64]) -> f64 {
    costs[costs.len() - 1]
}

/// Iterations until the cost is as good as the last one.
fn needed(costs: &[f64]) -> usize {
    let enough = (1.0 + NEAR) * last(costs);
    costs.iter().take_while(|cost| **cost > enough).count()
}

/// The largest errors at the end: of the position \[m\] and of rates \[rad/s\].
fn missed(plan: &Plan<7>) -> [f64; 2] {
    let [q, qd] = plan.states[PROBLEM.steps];
    [largest(PROBLEM.error(&Panda, &q)), largest(qd)]
}

fn page(regulator: &Plan<7>, exact: &Plan<7>) -> Page {
    let time = |k: usize| f64::from(u32::try_from(k).expect("a few hundred")) * PROBLEM.period;
    let best = last(&exact.costs);
    let excess = |label: &str, plan: &Plan<7>, color| {
        let costs = plan.costs.iter().zip(0_u32..);
        let excess = costs.map(|(cost, iteration)| [f64::from(iteration), cost / best - 1.0]);
        Curve {
            label: label.to_owned(),
            // Beyond it is rounding.
            points: excess.filter(|[_, excess]| *excess > 1e-13).collect(),
            color,
            style: Style::Dots,
        }
    };
    let costs = Panel {
        x: Axis {
            label: "iteration",
            scale: Scale::Linear,
        },
        y: Axis {
            label: "cost over the least, minus 1",
            scale: Scale::Log,
        },
        curves: vec![
            excess(
                "iterative linear-quadratic regulator",
                regulator,
                Color::Vermilion,
            ),
            excess("differential dynamic programming", exact, Color::Blue),
        ],
        marks: Vec::new(),
        height: 260.0,
        to_scale: false,
    };
    let states = exact.states.iter().enumerate();
    let torques = exact.torques.iter().enumerate();
    Page {
        title: "To a point in a second, for the least effort".to_owned(),
        panels: vec![
            costs,
            joints("joints [rad]", states.map(|(k, [q, _])| (time(k), *q))),
            joints("torques [N m]", torques.map(|(k, tau)| (time(k), *tau))),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{last, missed, needed, solve};
    use homogen_examples::optimal::Method;

    #[test]
    fn both_methods_reach_the_same_optimum_and_second_derivatives_need_fewer_iterations() {
        let [regulator, exact] = [Method::GaussNewton, Method::Exact].map(solve);
        for plan in [&regulator, &exact] {
            assert!(plan.costs.windows(2).all(|pair| pair[1] < pair[0]));
            assert!(last(&plan.costs) < 0.1 * plan.costs[0], "{:?}", plan.costs);
            let [place, rest] = missed(plan);
            assert!(place < 0.02 && rest < 0.1, "{place} {rest}");
        }
        assert!((last(&regulator.costs) / last(&exact.costs) - 1.0).abs() < 1e-8);
        let iterations = [regulator, exact].map(|plan| needed(&plan.costs));
        // Observed: 18 and 11.
        assert!(iterations[1] + 5 < iterations[0], "{iterations:?}");
    }
}

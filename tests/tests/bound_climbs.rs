//! Climbs of the worst error on arms and trees, and what the bounds of solutions rest on.
//!
//! In: robots. Out: that no error is beyond its bound and no bound far from the worst error, that
//! accelerations under a bound are numbers, and that nothing moves more than its energy allows.

use homogen_codegen::Function;
use homogen_codegen::accuracy::Accuracy;
use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::chain;
use homogen_codegen::description::Description;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::{Formulation, Forward};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::Variable;
use homogen_tests::climb::{Climb, any, exactly, listed};
use homogen_tests::humanoid::humanoid;
use homogen_tests::states::Random;
use homogen_tests::subjects::{Subject, subject};
use homogen_tests::tested::{F32, F64, Fused64, Tested};

/// What shows that a mass matrix stays positive definite: no joint and no body is faster than its bound
/// for the energy that it has.
#[test]
fn nothing_moves_more_than_its_energy_allows() {
    for label in [
        "panda_class/0",
        "quadruped/0",
        "spatial/6",
        "planar/5",
        "thin_rod/0",
    ] {
        let Subject {
            description,
            mut request,
        } = subject(label);
        let joints = chain::build(&description, &request).expect("a tree").joints;
        let carried = joints.iter().map(|joint| {
            let mut all = description.joints.iter();
            let found = all.find(|other| other.name.text == joint.name);
            found.expect("it is of the description").child.clone()
        });
        request.frames = carried.collect();
        request.tip = None;
        request.path_only = false;
        let chain = chain::build(&description, &request)
            .unwrap_or_else(|errors| panic!("{errors}"))
            .identified();
        let range = Range::of(&chain);
        let most = mobility(&chain, Layout::DESCRIBED, &range).expect("bodies have inertias");
        let energy = exactly(&chain, Function::MassMatrix);
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
        let moving: Vec<Expr> = (chain.frames.ids())
            .flat_map(|frame| {
                let of = |function: Function| function.build(&graph, &bodies, frame, Way::PLAIN);
                [of(Function::Velocity), of(Function::ForwardKinematics)].concat()
            })
            .map(Term::expr)
            .collect();
        let moving = Evaluation::of(&graph, &moving);
        let mut random = Random::new(3);
        let count = chain.joints.len();
        for _ in 0..100 {
            let q: Vec<f64> = range.arguments[Variable::Q]
                .iter()
                .map(|&range| any::<F64>(range, &mut random))
                .collect();
            let qd: Vec<f64> = (0..count).map(|_| random.unit()).collect();
            let at = |input: Input| {
                Double::from(match input {
                    Input::Variable(Variable::Q, k) => q[usize::from(k)],
                    Input::Variable(Variable::Qd, k) => qd[usize::from(k)],
                    _ => unreachable!("nothing else is read"),
                })
            };
            let m: Vec<f64> = energy.at(at).into_iter().map(Double::to_f64).collect();
            let twice: f64 = (0..count * count)
                .map(|k| m[k] * qd[k / count] * qd[k % count])
                .sum();
            // What stands on an axis is at rest, but for the last digits here.
            let allowed =
                |square: f64, most: f64| square <= most * twice * (1.0 + 1e-9) + 1e-30 * twice;
            for (k, &most) in most.joints.iter().enumerate() {
                assert!(allowed(qd[k] * qd[k], most), "{label} {k}");
            }
            let moving: Vec<f64> = moving.at(at).into_iter().map(Double::to_f64).collect();
            for (frame, found) in chain.frames.iter().zip(moving.chunks(6 + 12)) {
                let [omega, v] = [0, 3].map(|first| [0, 1, 2].map(|k| found[first + k]));
                let origin = [0, 1, 2].map(|row| found[6 + 4 * row + 3]);
                let cross = |k: usize| {
                    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                    omega[i] * origin[j] - omega[j] * origin[i]
                };
                let speed = [0, 1, 2].map(|k| v[k] + cross(k));
                let square = |vector: [f64; 3]| vector.iter().map(|x| x * x).sum::<f64>();
                let [turns, slides] = most.bodies[frame.body.expect("it moves")];
                assert!(allowed(square(omega), turns), "{label} {}", frame.name);
                assert!(allowed(square(speed), slides), "{label} {}", frame.name);
            }
        }
    }
}

/// Torques of the exact accelerations that the range has never lead to what is no number, where a bound
/// is printed.
fn accelerations<T: Tested>(description: &Description, form: Option<Forward>) {
    let request = Request {
        formulation: Formulation {
            forward: form,
            ..Formulation::default()
        },
        ..Request::default()
    };
    let function = Function::ForwardDynamics;
    let listed = listed(description, request.clone(), function, T::REAL);
    let promise = match &listed.accuracy[0] {
        Accuracy::Backward(_, promise) => promise,
        other => {
            println!("{} in {}: {other:?}", description.name.text, T::NAME);
            return;
        }
    };
    let chain = chain::build(description, &request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified();
    let needed = exactly(&chain, Function::InverseDynamics);
    let range = Range::of(&chain);
    let mut random = Random::new(11);
    let mut worst = 0.0_f64;
    for _ in 0..40 {
        let mut draw = |ranges: &[[f64; 2]]| -> Vec<f64> {
            ranges
                .iter()
                .map(|&range| any::<T>(range, &mut random))
                .collect()
        };
        let [q, qd, qdd] =
            [Variable::Q, Variable::Qd, Variable::Qdd].map(|of| draw(&range.arguments[of]));
        let torques = |qdd: &[f64]| {
            needed.at(|input| {
                Double::from(match input {
                    Input::Variable(Variable::Q, k) => q[usize::from(k)],
                    Input::Variable(Variable::Qd, k) => qd[usize::from(k)],
                    Input::Variable(Variable::Qdd, k) => qdd[usize::from(k)],
                    _ => unreachable!("nothing else is read"),
                })
            })
        };
        let qdd: Vec<f64> = qdd.iter().map(|qdd| 0.999 * qdd).collect();
        let tau: Vec<T> = (torques(&qdd).into_iter())
            .map(|tau| T::literal(tau.to_f64()))
            .collect();
        let found = run(&listed.program, |input| match input {
            Input::Variable(Variable::Q, k) => T::literal(q[usize::from(k)]),
            Input::Variable(Variable::Qd, k) => T::literal(qd[usize::from(k)]),
            Input::Variable(Variable::Tau, k) => tau[usize::from(k)],
            _ => unreachable!("nothing else is read"),
        });
        let found: Vec<f64> = found.into_iter().map(T::to_f64).collect();
        for ((needed, tau), bound) in torques(&found).iter().zip(&tau).zip(&promise.bounds) {
            let most = bound.double.or(bound.single).expect("it is of one type");
            let error = (*needed - Double::from(tau.to_f64())).to_f64().abs();
            assert!(error <= most, "{}: {error:e} of {most:e}", T::NAME);
            worst = worst.max(error / most);
        }
    }
    println!("{} in {}: {worst:.1e}", description.name.text, T::NAME);
}

/// Infinite in single precision under a bound, once.
#[test]
fn articulated_bodies_on_trees_in_single_precision() {
    for joints in [29, 36] {
        let description = humanoid(joints);
        accelerations::<F32>(&description, Some(Forward::Articulated));
        accelerations::<F64>(&description, Some(Forward::Articulated));
    }
}

#[test]
fn accelerations_of_trees_by_default() {
    let description = humanoid(31);
    accelerations::<F64>(&description, None);
    accelerations::<F64>(&description, Some(Forward::MassMatrix { refinements: 1 }));
}

/// No error beyond its bound, and no bound farther than 1,000 times the worst that is found.
#[test]
fn climbs_on_trees_of_29_to_48_joints() {
    for joints in [29, 36, 48] {
        let description = humanoid(joints);
        for function in [Function::InverseDynamics, Function::Bias] {
            let subject = Climb::<Fused64>::new(&description, &Request::default(), function);
            let worst = subject.holds(&format!("{joints} joints {function:?}"), 60, 120);
            assert!(
                worst >= 1e-3,
                "{joints} joints: {worst:e} of the bound of {function:?}"
            );
        }
        let subject = Climb::<F32>::new(&description, &Request::default(), Function::Gravity);
        let worst = subject.holds(&format!("{joints} joints gravity"), 60, 60);
        assert!(
            worst >= 1e-2,
            "{joints} joints: {worst:e} of the bound of gravity"
        );
    }
}

/// The same within 100 on arms, of every function that is evaluated and every unit of its results.
#[test]
fn climbs_on_arms() {
    for label in [
        "panda_class/0",
        "ur5_class/0",
        "puma560_general/0",
        "stanford_general/0",
    ] {
        let Subject {
            description,
            request,
        } = subject(label);
        let evaluated = |function: &Function| !(function.solves() || function.is_constrained());
        for function in Function::ALL.into_iter().filter(evaluated) {
            let subject = Climb::<F64>::new(&description, &request, function);
            let name = format!("{label} {function:?}");
            for (unit, worst) in subject.by_unit(&name, 300, 3_600) {
                // What is exact may have been bounded as if its numbers were not.
                let is_near = worst >= 1e-2 || worst == 0.0;
                assert!(is_near, "{worst:e} of the bound of {name} in {unit}");
            }
        }
    }
}

/// The same within 500 with a floating base, of each function whose results its quaternion turns; of the rate of a
/// tree's momentum, where inertias cancel that grow with all that it carries, within 10,000.
#[test]
fn climbs_with_a_floating_base() {
    for (name, description, tip, far) in [
        (
            "panda_class",
            subject("panda_class/0").description,
            "link8",
            500.0,
        ),
        ("humanoid", humanoid(29), "link21", 1e4),
    ] {
        let floating = Request {
            floating: true,
            tip: Some(tip.into()),
            ..Request::default()
        };
        for (function, farthest) in [
            (Function::SpatialJacobianRate, 500.0),
            (Function::Acceleration, 500.0),
            (Function::Gravity, 500.0),
            (Function::CentroidalMomentumMatrix, 500.0),
            (Function::CentroidalMomentumBias, far),
        ] {
            let name = format!("floating {name} {function:?}");
            climb_within::<F64>(&description, &floating, function, farthest, &name);
            climb_within::<F32>(&description, &floating, function, farthest, &name);
        }
    }
}

fn climb_within<T: Tested>(
    description: &Description,
    request: &Request,
    function: Function,
    farthest: f64,
    name: &str,
) {
    let subject = Climb::<T>::new(description, request, function);
    for (unit, worst) in subject.by_unit(name, 300, 3_600) {
        let is_near = farthest * worst >= 1.0 || worst == 0.0;
        assert!(is_near, "{worst:e} of the bound of {name} in {unit}");
    }
}

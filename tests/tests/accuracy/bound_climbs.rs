//! Searches for the worst errors on arms and trees, and the assumptions of the bounds of solutions.
//!
//! In: robots. Out: errors are within their bounds, and bounds are not far above the worst error; accelerations with a
//! bound are finite; velocities are within the bounds by the kinetic energy.

use homogen_codegen::Function;
use homogen_codegen::accuracy::Accuracy;
use homogen_codegen::accuracy::mobility::mobility;
use homogen_codegen::chain;
use homogen_codegen::description::Description;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::{Formulation, Forward};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Algorithm;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::Variable;
use homogen_tests::climb::{Climb, any, exactly, generated};
use homogen_tests::effort::effort;
use homogen_tests::humanoid::humanoid;
use homogen_tests::states::Random;
use homogen_tests::subjects::{Subject, subject};
use homogen_tests::tested::{F32, F64, Fused64, Tested};

/// The bounds of velocities by the kinetic energy, which show that a mass matrix stays positive definite, hold for
/// joints and bodies.
#[test]
fn velocities_are_within_their_bounds_by_the_kinetic_energy() {
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
                let of =
                    |function: Function| function.build(&graph, &bodies, frame, Algorithm::PLAIN);
                [of(Function::TipVelocity), of(Function::ForwardKinematics)].concat()
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
            // A point on an axis is at rest, but for rounding here.
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
                let [angular, linear] = most.bodies[frame.body.expect("it moves")];
                assert!(allowed(square(omega), angular), "{label} {}", frame.name);
                assert!(allowed(square(speed), linear), "{label} {}", frame.name);
            }
        }
    }
}

/// Accelerations with a printed bound are finite and within it, at torques of accelerations in the range.
fn accelerations<T: Tested>(description: &Description, form: Option<Forward>) {
    let request = Request {
        formulation: Formulation::default().with_forward(form),
        ..Request::default()
    };
    let function = Function::ForwardDynamics;
    let generated = generated(description, request.clone(), function, T::REAL);
    let bound = match &generated.accuracy[0] {
        Accuracy::Backward(_, bound) => bound,
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
        let found = run(&generated.program, |input| match input {
            Input::Variable(Variable::Q, k) => T::literal(q[usize::from(k)]),
            Input::Variable(Variable::Qd, k) => T::literal(qd[usize::from(k)]),
            Input::Variable(Variable::Tau, k) => tau[usize::from(k)],
            _ => unreachable!("nothing else is read"),
        });
        let found: Vec<f64> = found.into_iter().map(T::to_f64).collect();
        for ((needed, tau), bound) in torques(&found).iter().zip(&tau).zip(&bound.bounds) {
            let most = bound.double.or(bound.single).expect("a bound in one type");
            let error = (*needed - Double::from(tau.to_f64())).to_f64().abs();
            assert!(error <= most, "{}: {error:e} of {most:e}", T::NAME);
            worst = worst.max(error / most);
        }
    }
    println!("{} in {}: {worst:.1e}", description.name.text, T::NAME);
}

/// Accelerations were once infinite in single precision though a bound was printed.
#[test]
fn articulated_bodies_of_trees_stay_within_their_bounds() {
    for joints in [29, 36] {
        let description = humanoid(joints);
        accelerations::<F32>(&description, Some(Forward::Articulated));
        accelerations::<F64>(&description, Some(Forward::Articulated));
    }
}

#[test]
fn accelerations_of_trees_stay_within_their_bounds() {
    let description = humanoid(31);
    accelerations::<F64>(&description, None);
    accelerations::<F64>(&description, Some(Forward::MassMatrix { refinements: 1 }));
}

/// Errors stay within their bounds, and bounds are at most 1,000 times the worst error that is found.
#[test]
fn bounds_on_trees_of_29_to_48_joints_hold_and_are_tight_within_1000() {
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

/// All functions except solutions, in every unit of their results.
#[test]
fn bounds_on_arms_hold_and_are_tight_within_100() {
    let labels = [
        "panda_class/0",
        "stanford_general/0",
        "ur5_class/0",
        "puma560_general/0",
    ];
    for label in labels.into_iter().take(effort(2, 4)) {
        let Subject {
            description,
            request,
        } = subject(label);
        let evaluated = |function: &Function| !(function.solves() || function.is_constrained());
        for function in Function::ALL.into_iter().filter(evaluated) {
            let subject = Climb::<F64>::new(&description, &request, function);
            let name = format!("{label} {function:?}");
            for (unit, worst) in subject.by_unit(&name, 300, 3_600) {
                // Second derivatives are sums of products of three motions, which are never all at their worst.
                let least = match function {
                    Function::InverseDynamicsHessian => 2e-3,
                    _ => 1e-2,
                };
                // Exact results may have a bound for rounded numbers.
                let is_near = worst >= least || worst == 0.0;
                assert!(is_near, "{worst:e} of the bound of {name} in {unit}");
            }
        }
    }
}

/// Functions whose results depend on the base's orientation. The bound of a tree's momentum bias may be 10,000 times
/// the worst error, since inertias cancel that grow with all that they carry.
#[test]
fn bounds_with_a_floating_base_hold_and_are_tight_within_500() {
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
            (Function::TipAcceleration, 500.0),
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
    for (unit, worst) in subject.by_unit(name, 300, effort(1_200, 3_600)) {
        let is_near = farthest * worst >= 1.0 || worst == 0.0;
        assert!(is_near, "{worst:e} of the bound of {name} in {unit}");
    }
}

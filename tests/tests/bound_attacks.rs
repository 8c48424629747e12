//! Attacks on the errors that are printed: what has once been found to break a bound, by the name of
//! what it is, and climbs of the worst error on arms and trees.
//!
//! In: descriptions, and what is printed of them. Out: that what is printed is true, or that it says
//! why nothing is promised. Programs run as the generated code does; the reference is the same
//! function in the frames of the description, with 106 bits.

use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::frames::{Layout, arrange};
use homogen_codegen::chain::mobility::mobility;
use homogen_codegen::chain::range::Range;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Description, read_text};
use homogen_codegen::emit::{Item, Listed};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::{Formulation, Forward};
use homogen_codegen::model::{self, Way};
use homogen_codegen::request::{Parameter, Request, Target};
use homogen_codegen::schedule::run;
use homogen_codegen::{Builder, Function, Real};
use homogen_tests::humanoid::humanoid;
use homogen_tests::states::Random;
use homogen_tests::subjects::subject;
use homogen_tests::tested::{F32, F64, Flushed, Fused32, Fused64, Tested};
use quote::format_ident;

/// A link of a serial arm: its joint as URDF has it, its mass, and ixx = iyy = izz.
struct Segment<'s> {
    joint: &'s str,
    mass: f64,
    inertia: f64,
}

/// Links in a row, 0.4 m apart.
fn row(segments: &[Segment<'_>]) -> Description {
    let mut text = r#"<robot name="row"><link name="l0"/>"#.to_owned();
    for (k, segment) in segments.iter().enumerate() {
        let Segment {
            joint,
            mass,
            inertia,
        } = segment;
        let next = k + 1;
        text.push_str(&format!(
            r#"<joint name="j{next}" {joint}<parent link="l{k}"/><child link="l{next}"/></joint>
            <link name="l{next}"><inertial><origin xyz="0.2 0.03 -0.02"/><mass value="{mass}"/>
            <inertia ixx="{inertia}" iyy="{inertia}" izz="{inertia}" ixy="0" ixz="0" iyz="0"/>
            </inertial></link>"#
        ));
    }
    text.push_str("</robot>");
    let mut errors = Errors::new();
    let description = read_text(&text, "row.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

/// A joint about or along an axis, with these limits.
fn joint(kind: &str, axis: &str, limit: &str) -> String {
    format!(r#"type="{kind}"><origin xyz="0.4 0 0.1"/><axis xyz="{axis}"/><limit {limit}/>"#)
}

/// One function of a robot, by itself.
fn listed(description: &Description, request: Request, function: Function, scalar: Real) -> Listed {
    let request = Request {
        functions: vec![vec![function]],
        scalar,
        ..request
    };
    let listing = expand(description, &request, Item::made(format_ident!("Arm")));
    let listing = listing.unwrap_or_else(|errors| panic!("{errors}"));
    let listed = listing.functions.into_iter().next();
    listed.expect("one function was asked for")
}

/// The bounds of a function, of results or of what they are exact for.
fn bounds(listed: &Listed) -> &[Bound] {
    match &*listed.accuracy {
        [Accuracy::Within(promise) | Accuracy::Backward(_, promise)] => &promise.bounds,
        other => panic!("{other:?}"),
    }
}

/// Why a function has no bound.
fn refusal(listed: &Listed) -> &'static str {
    match *listed.accuracy {
        [Accuracy::Unknown(reason)] => reason,
        ref other => panic!("{other:?}"),
    }
}

/// What a climb looks at: one function in one type, its bounds and its truth.
struct Subject<T> {
    listed: Listed,
    /// Of each result.
    bounds: Vec<f64>,
    exact: Evaluation<Double>,
    range: Range,
    as_type: std::marker::PhantomData<T>,
}

/// A state: every number that the range has.
type State = Vec<f64>;

impl<T: Tested> Subject<T> {
    /// Of a function that has a bound for each joint.
    fn new(description: &Description, request: &Request, function: Function) -> Self {
        let listed = listed(description, request.clone(), function, T::REAL);
        let chain = chain::build(description, request).unwrap_or_else(|errors| panic!("{errors}"));
        let bounds = bounds(&listed).iter();
        let bounds = bounds.map(|bound| bound.double.or(bound.single).expect("it is of one type"));
        Self {
            bounds: bounds.collect(),
            listed,
            exact: exactly(&chain, function),
            range: Range::of(&chain),
            as_type: std::marker::PhantomData,
        }
    }

    /// The ranges of all inputs.
    fn ends(&self) -> Vec<(Input, [f64; 2])> {
        let index = |k: usize| u16::try_from(k).expect("few");
        let all = |ranges: &[[f64; 2]], of: fn(u16) -> Input| -> Vec<(Input, [f64; 2])> {
            let ranges = ranges.iter().enumerate();
            ranges.map(|(k, &range)| (of(index(k)), range)).collect()
        };
        let mut ends = all(&self.range.q, Input::Q);
        ends.extend(all(&self.range.qd, Input::Qd));
        ends.extend(all(&self.range.qdd, Input::Qdd));
        for (field, ranges) in self.range.fields.iter().enumerate() {
            for (k, &range) in ranges.iter().enumerate() {
                ends.push((Input::Parameter(index(field), index(k)), range));
            }
        }
        ends
    }

    /// The errors of all results in a state.
    fn errors(&self, ends: &[(Input, [f64; 2])], state: &State) -> Vec<f64> {
        let at = |input: Input| {
            let place = ends.iter().position(|(of, _)| *of == input);
            state[place.expect("every input has a range")]
        };
        let exact = self.exact.at(|input| Double::from(at(input)));
        let found = run(&self.listed.program, |input| T::literal(at(input)));
        let pairs = found.into_iter().zip(exact);
        pairs
            .map(|(found, exact)| (Double::from(found.to_f64()) - exact).to_f64().abs())
            .collect()
    }

    /// The share of its bound that the worst error takes, of each result: in corners of the range and
    /// anywhere in it, and then uphill from the worst of them.
    fn attack(&self, seed: u64, states: usize, steps: usize) -> Vec<f64> {
        let ends = self.ends();
        let mut random = Random::new(seed);
        let mut worst = vec![0.0_f64; self.bounds.len()];
        let mut best = (0.0, State::new());
        let share = |errors: &[f64]| -> Vec<f64> {
            let pairs = errors.iter().zip(&self.bounds);
            pairs
                .map(|(error, bound)| if *error == 0.0 { 0.0 } else { error / bound })
                .collect()
        };
        for turn in 0..states + steps {
            let mut state = best.1.clone();
            if turn < states {
                state = ends
                    .iter()
                    .map(|(_, range)| any::<T>(*range, &mut random))
                    .collect();
            } else {
                for _ in 0..=random.below(3) {
                    let at = random.below(ends.len());
                    state[at] = any::<T>(ends[at].1, &mut random);
                }
            }
            let shares = share(&self.errors(&ends, &state));
            for (worst, share) in worst.iter_mut().zip(&shares) {
                assert!(share.is_finite(), "an error that is no number");
                *worst = worst.max(*share);
            }
            let most = shares.into_iter().fold(0.0, f64::max);
            if most >= best.0 {
                best = (most, state);
            }
        }
        worst
    }

    /// Holds every result against its bound; the worst share of all.
    fn holds(&self, name: &str, states: usize, steps: usize) -> f64 {
        let worst = self
            .attack(7, states, steps)
            .into_iter()
            .fold(0.0, f64::max);
        println!("{name} in {}: {worst:.1e} of the bound", T::NAME);
        assert!(worst <= 1.0, "{name} in {}: {worst}", T::NAME);
        worst
    }
}

/// A number of the type within a range, often at its ends and sometimes small.
fn any<T: Tested>([lo, hi]: [f64; 2], random: &mut Random) -> f64 {
    let x = match random.below(8) {
        0..3 => lo,
        3..6 => hi,
        6 => 0.5 * (lo + hi) + 0.5 * (hi - lo) * random.unit() * 2.0_f64.powi(-20),
        _ => 0.5 * (lo + hi) + 0.5 * (hi - lo) * random.unit(),
    };
    let near = T::literal(x).to_f64();
    let step = 2.0 * T::ROUNDOFF * near.abs();
    let back = if near > hi {
        T::literal(near - step).to_f64()
    } else {
        near
    };
    if back < lo {
        T::literal(back + step).to_f64()
    } else {
        back
    }
}

/// What a function computes, with 106 bits.
fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = model::build(&graph, &bodies, function, 0, Way::PLAIN).into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}

const TORQUES: [Function; 3] = [Function::InverseDynamics, Function::Bias, Function::Gravity];

/// Two links whose joints have these limits.
fn two(limit: &str) -> Description {
    let (first, second) = (
        joint("revolute", "0 1 0", limit),
        joint("revolute", "0 0 1", limit),
    );
    row(&[
        Segment {
            joint: &first,
            mass: 2.0,
            inertia: 0.03,
        },
        Segment {
            joint: &second,
            mass: 1.0,
            inertia: 0.01,
        },
    ])
}

#[test]
fn angles_that_leave_the_sines_of_a_file_for_core_alone() {
    let text = |most: f64, scalar: Real| {
        let limits = format!(r#"lower="-{most}" upper="{most}" velocity="2""#);
        let builder = Builder::from_description(two(&limits));
        let builder = builder.scalar(scalar).generate([Function::InverseDynamics]);
        builder
            .to_source()
            .unwrap_or_else(|errors| panic!("{errors}"))
            .to_string()
    };
    let refused = "Error: no bound: angles leave the range of its sines.";
    assert!(text(1e5, Real::F32).contains(refused));
    assert!(text(3300.0, Real::F32).contains(refused));
    assert!(!text(3200.0, Real::F32).contains(refused));
    assert!(text(2.1e5, Real::F64).contains(refused));
    assert!(!text(2e5, Real::F64).contains(refused));
}

/// At the edge of the range of those sines the bound holds.
#[test]
fn angles_at_the_edge_of_the_range_of_sines() {
    let description = two(r#"lower="-3200" upper="3200" velocity="2""#);
    let request = Request::default();
    for function in TORQUES {
        Subject::<F32>::new(&description, &request, function).holds("edge", 300, 100);
        Subject::<Fused32>::new(&description, &request, function).holds("edge", 300, 100);
    }
    let description = two(r#"lower="-2e5" upper="2e5" velocity="2""#);
    Subject::<F64>::new(&description, &request, Function::Gravity).holds("edge", 300, 100);
}

#[test]
fn sines_that_a_user_names_are_said_to_be_assumed() {
    let builder = Builder::from_description(two(r#"lower="-1" upper="1" velocity="2""#));
    let builder = builder.sin_cos("crate::sines::table");
    let source = builder.generate([Function::Gravity]).to_source();
    let source = source
        .unwrap_or_else(|errors| panic!("{errors}"))
        .to_string();
    assert!(
        source.contains("q within its limits, sines within 1 unit in the last place"),
        "{source}"
    );
}

/// A field for the acceleration of gravity.
fn gravity(range: Option<[f64; 2]>) -> Request {
    Request {
        parameters: vec![Parameter {
            field: format_ident!("gravity"),
            target: Target::Gravity,
            range,
        }],
        ..Request::default()
    }
}

/// On vertical axes, where the described gravity is felt by no joint.
#[test]
fn gravity_that_a_field_turns_to_where_it_is_felt() {
    let vertical = joint("continuous", "0 0 1", "effort=\"1\" velocity=\"2\"");
    let segment = || Segment {
        joint: &vertical,
        mass: 2.0,
        inertia: 0.03,
    };
    let description = row(&[segment(), segment()]);
    for range in [None, Some([-100.0, 100.0])] {
        let request = gravity(range);
        let worst = Subject::<F32>::new(&description, &request, Function::Gravity)
            .holds("gravity", 300, 100);
        assert!(worst > 1e-2, "{worst}");
        let listed = listed(&description, request, Function::Gravity, Real::F32);
        let Accuracy::Within(promise) = &listed.accuracy[0] else {
            panic!("{:?}", listed.accuracy);
        };
        let most = range.map_or(2.0 * 9.81, |[_, most]| most);
        let said = format!("entries of `gravity` ≤ {most} m/s²");
        assert!(promise.range.contains(&said), "{}", promise.range);
    }
}

#[test]
fn a_mass_in_a_field_from_zero_to_twice_what_is_described() {
    let description = two(r#"lower="-1" upper="1" velocity="2""#);
    for range in [None, Some([0.5, 40.0])] {
        let request = Request {
            parameters: vec![Parameter {
                field: format_ident!("load"),
                target: Target::MassOf("l2".into()),
                range,
            }],
            ..Request::default()
        };
        for function in TORQUES {
            Subject::<F32>::new(&description, &request, function).holds("load", 200, 50);
            Subject::<F64>::new(&description, &request, function).holds("load", 200, 50);
        }
        // Without the load its inertia is left, and M regular.
        let listed = listed(&description, request, Function::ForwardDynamics, Real::F64);
        assert!(
            bounds(&listed)
                .iter()
                .all(|bound| bound.double < Some(1e-11))
        );
    }
}

/// Limits that are one point: a slide that is held at 50 m.
#[test]
fn a_slide_held_at_50_m() {
    let turn = joint("revolute", "0 1 0", r#"lower="-1" upper="1" velocity="2""#);
    let slide = joint(
        "prismatic",
        "1 0 0",
        r#"lower="50" upper="50" velocity="1""#,
    );
    let segments = [&turn, &slide].map(|joint| Segment {
        joint,
        mass: 1.0,
        inertia: 0.01,
    });
    let (description, request) = (row(&segments), Request::default());
    for function in TORQUES {
        Subject::<F32>::new(&description, &request, function).holds("slide", 200, 100);
        Subject::<F64>::new(&description, &request, function).holds("slide", 200, 100);
    }
}

#[test]
fn a_velocity_limit_of_1e20_overflows_in_single_precision() {
    let (description, request) = (
        two(r#"lower="-1" upper="1" velocity="1e20""#),
        Request::default(),
    );
    let of = |scalar| listed(&description, request.clone(), Function::Bias, scalar);
    assert_eq!(refusal(&of(Real::F32)), "it overflows within its range");
    Subject::<F64>::new(&description, &request, Function::Bias).holds("fast", 200, 50);
    // Where any type is meant, one line tells both.
    let Accuracy::Within(promise) = &of(Real::Generic).accuracy[0] else {
        panic!("f64 has a bound");
    };
    assert_eq!(promise.lacks, Some("it overflows within its range"));
    assert!(
        promise
            .bounds
            .iter()
            .all(|bound| bound.single == Some(f64::INFINITY))
    );
    let huge = two(r#"lower="-1" upper="1" velocity="1e200""#);
    let listed = listed(&huge, request, Function::Bias, Real::F64);
    assert_eq!(refusal(&listed), "it overflows within its range");
}

/// Infinite limits are as good as none, which the range says.
#[test]
fn limits_without_end() {
    let description = two(r#"lower="-inf" upper="inf" velocity="inf""#);
    let listed = listed(&description, Request::default(), Function::Bias, Real::F32);
    let Accuracy::Within(promise) = &listed.accuracy[0] else {
        panic!("{:?}", listed.accuracy);
    };
    assert_eq!(promise.range, "|q| ≤ π rad, |q̇| ≤ 10 rad/s");
}

/// Results, arguments and all between are subnormal, and may be taken for zero.
#[test]
fn arguments_that_are_subnormal() {
    let light = joint(
        "revolute",
        "0 1 0",
        r#"lower="-1e-40" upper="1e-39" velocity="1e-39""#,
    );
    let segments = [&light, &light].map(|joint| Segment {
        joint,
        mass: 1e-20,
        inertia: 1e-22,
    });
    let (description, request) = (row(&segments), Request::default());
    for function in [
        Function::InverseDynamics,
        Function::Bias,
        Function::MassMatrix,
    ] {
        Subject::<F32>::new(&description, &request, Function::Bias).holds("tiny", 200, 50);
        let flushed = Flushing::new(&description, &request, function);
        flushed.holds("tiny", 200, 50);
    }
}

/// Where matrices have one bound for a row and unit, results share it.
struct Flushing;

impl Flushing {
    fn new(description: &Description, request: &Request, function: Function) -> Subject<Flushed> {
        let listed = listed(description, request.clone(), function, Real::F32);
        let chain = chain::build(description, request).unwrap_or_else(|errors| panic!("{errors}"));
        let rows: Vec<f64> = (bounds(&listed).iter())
            .map(|bound| bound.single.expect("it is in f32"))
            .collect();
        let each = listed.program.results.len() / rows.len();
        Subject {
            bounds: rows.iter().flat_map(|&bound| vec![bound; each]).collect(),
            listed,
            exact: exactly(&chain, function),
            range: Range::of(&chain),
            as_type: std::marker::PhantomData,
        }
    }
}

#[test]
fn an_inertia_that_no_body_has() {
    let turn = joint("revolute", "0 1 0", r#"lower="-1" upper="1" velocity="2""#);
    let segments = [0.03, -0.01].map(|inertia| Segment {
        joint: &turn,
        mass: 1.0,
        inertia,
    });
    let description = row(&segments);
    for function in [Function::ForwardDynamics, Function::MassMatrixInverse] {
        let listed = listed(&description, Request::default(), function, Real::F64);
        let reason = refusal(&listed);
        assert_eq!(
            reason,
            "an inertia is none that a body has, as far as its digits tell"
        );
    }
}

/// Two joints about one line, with nothing but rounding between them and a singular mass matrix.
#[test]
fn a_coaxial_pair_whose_first_body_weighs_next_to_nothing() {
    let first = joint("continuous", "0 0 1", "effort=\"1\" velocity=\"2\"");
    let second = first.replace("0.4 0 0.1", "0 0 0.1");
    let description = row(&[
        Segment {
            joint: &first,
            mass: 1e-12,
            inertia: 1e-14,
        },
        Segment {
            joint: &second,
            mass: 1.0,
            inertia: 0.01,
        },
    ]);
    let request = Request {
        formulation: Formulation {
            forward: Some(Forward::UNREFINED),
            ..Formulation::default()
        },
        ..Request::default()
    };
    let listed = listed(
        &description,
        request,
        Function::ForwardDynamics,
        Real::Generic,
    );
    match &listed.accuracy[0] {
        Accuracy::Unknown(_) => {}
        Accuracy::Backward(_, promise) => {
            let single = promise.bounds.iter().map(|bound| bound.single);
            assert!(single.into_iter().all(|bound| bound == Some(f64::INFINITY)));
            assert!(promise.lacks.is_some());
        }
        Accuracy::Within(_) => panic!("accelerations are not bounded themselves"),
    }
}

#[test]
fn the_sentence_of_the_inverse_says_that_each_column_is_exact() {
    let builder = Builder::from_description(two(r#"lower="-1" upper="1" velocity="2""#));
    let source = builder.generate([Function::MassMatrixInverse]).to_source();
    let source = source
        .unwrap_or_else(|errors| panic!("{errors}"))
        .to_string();
    assert!(
        source.contains("each column is exact for an M of its own, off by at most"),
        "{source}"
    );
}

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
        let homogen_tests::subjects::Subject {
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
        let chain =
            chain::build(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
        let range = Range::of(&chain);
        let most = mobility(&chain, Layout::DESCRIBED, &range).expect("bodies have inertias");
        let energy = exactly(&chain, Function::MassMatrix);
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
        let moving: Vec<Expr> = (0..chain.frames.len())
            .flat_map(|frame| {
                let of = |function| model::build(&graph, &bodies, function, frame, Way::PLAIN);
                [of(Function::Velocity), of(Function::ForwardKinematics)].concat()
            })
            .map(Term::expr)
            .collect();
        let moving = Evaluation::of(&graph, &moving);
        let mut random = Random::new(3);
        let count = chain.joints.len();
        for _ in 0..100 {
            let q: Vec<f64> = range
                .q
                .iter()
                .map(|&range| any::<F64>(range, &mut random))
                .collect();
            let qd: Vec<f64> = (0..count).map(|_| random.unit()).collect();
            let at = |input: Input| {
                Double::from(match input {
                    Input::Q(k) => q[usize::from(k)],
                    Input::Qd(k) => qd[usize::from(k)],
                    _ => unreachable!("nothing else is read"),
                })
            };
            let m: Vec<f64> = energy.at(at).into_iter().map(Double::to_f64).collect();
            let twice: f64 = (0..count * count)
                .map(|k| m[k] * qd[k / count] * qd[k % count])
                .sum();
            let allowed = |square: f64, most: f64| square <= most * twice * (1.0 + 1e-9);
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
    let chain = chain::build(description, &request).unwrap_or_else(|errors| panic!("{errors}"));
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
        let [q, qd, qdd] = [&range.q, &range.qd, &range.qdd].map(|ranges| draw(ranges));
        let torques = |qdd: &[f64]| {
            needed.at(|input| {
                Double::from(match input {
                    Input::Q(k) => q[usize::from(k)],
                    Input::Qd(k) => qd[usize::from(k)],
                    Input::Qdd(k) => qdd[usize::from(k)],
                    _ => unreachable!("nothing else is read"),
                })
            })
        };
        let qdd: Vec<f64> = qdd.iter().map(|qdd| 0.999 * qdd).collect();
        let tau: Vec<T> = (torques(&qdd).into_iter())
            .map(|tau| T::literal(tau.to_f64()))
            .collect();
        let found = run(&listed.program, |input| match input {
            Input::Q(k) => T::literal(q[usize::from(k)]),
            Input::Qd(k) => T::literal(qd[usize::from(k)]),
            Input::Tau(k) => tau[usize::from(k)],
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
            let subject = Subject::<Fused64>::new(&description, &Request::default(), function);
            let worst = subject.holds(&format!("{joints} joints {function:?}"), 60, 120);
            assert!(
                worst >= 1e-3,
                "{joints} joints: {worst:e} of the bound of {function:?}"
            );
        }
        let subject = Subject::<F32>::new(&description, &Request::default(), Function::Gravity);
        subject.holds(&format!("{joints} joints gravity"), 60, 60);
    }
}

/// The same within 100 on an arm.
#[test]
fn climbs_on_an_arm_of_seven_joints() {
    let homogen_tests::subjects::Subject {
        description,
        request,
    } = subject("panda_class/0");
    for function in TORQUES {
        let subject = Subject::<F64>::new(&description, &request, function);
        let worst = subject.holds(&format!("{function:?}"), 500, 1500);
        assert!(worst >= 1e-2, "{worst:e} of the bound of {function:?}");
    }
}

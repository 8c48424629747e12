//! Attacks on printed error bounds: descriptions that once broke a bound.
//!
//! In: descriptions. Out: the printed bound holds, or the reason for its absence is printed.

use homogen_codegen::accuracy::Accuracy;
use homogen_codegen::description::{Description, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::formulation::{Formulation, Forward};
use homogen_codegen::module::GeneratedFunction;
use homogen_codegen::request::{Parameter, Request, Target};
use homogen_codegen::{Builder, Function, Real};
use homogen_tests::climb::{Climb, bounds, generated};
use homogen_tests::tested::{F32, F64, Flushed, Fused32, Tested};
use quote::format_ident;

/// A link of a serial arm: its joint in URDF, its mass, and ixx = iyy = izz.
struct Segment<'s> {
    joint: &'s str,
    mass: f64,
    inertia: f64,
}

/// A serial arm of links 0.4 m apart.
fn row(segments: &[Segment<'_>]) -> Description {
    let mut text = r#"<robot name="row"><link name="l0"/>"#.to_owned();
    for (k, segment) in segments.iter().enumerate() {
        let Segment {
            joint,
            mass,
            inertia,
        } = segment;
        let next = k + 1;
        let piece = format!(
            r#"<joint name="j{next}" {joint}<parent link="l{k}"/><child link="l{next}"/></joint>
            <link name="l{next}"><inertial><origin xyz="0.2 0.03 -0.02"/><mass value="{mass}"/>
            <inertia ixx="{inertia}" iyy="{inertia}" izz="{inertia}" ixy="0" ixz="0" iyz="0"/>
            </inertial></link>"#
        );
        text.push_str(&piece);
    }
    text.push_str("</robot>");
    let mut errors = Errors::new();
    let description = read_text(&text, "row.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

/// A joint about or along an axis, with limits.
fn joint(kind: &str, axis: &str, limit: &str) -> String {
    format!(r#"type="{kind}"><origin xyz="0.4 0 0.1"/><axis xyz="{axis}"/><limit {limit}/>"#)
}

/// The reason why a function has no bound.
fn refusal(generated: &GeneratedFunction) -> &'static str {
    match *generated.accuracy {
        [Accuracy::Unknown(reason)] => reason,
        ref other => panic!("{other:?}"),
    }
}

/// Compares all results of a function with their bounds. Returns the largest ratio of error to bound.
fn holds<T: Tested>(description: &Description, request: &Request, function: Function) -> f64 {
    let climb = Climb::<T>::new(description, request, function);
    climb.holds(&format!("{function:?}"), 200, 100)
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
fn angles_beyond_the_range_of_a_files_sines_have_no_bound() {
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

/// The range is that of the sines in a file.
#[test]
fn bounds_hold_at_the_edge_of_the_range_of_sines() {
    let description = two(r#"lower="-3200" upper="3200" velocity="2""#);
    let request = Request::default();
    for function in TORQUES {
        holds::<F32>(&description, &request, function);
        holds::<Fused32>(&description, &request, function);
    }
    let description = two(r#"lower="-2e5" upper="2e5" velocity="2""#);
    holds::<F64>(&description, &request, Function::Gravity);
}

#[test]
fn the_bound_states_its_assumption_of_a_users_sines() {
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

/// With vertical axes, the described gravity causes no torque.
#[test]
fn bounds_hold_for_every_direction_of_gravity_in_a_field() {
    let vertical = joint("continuous", "0 0 1", "effort=\"1\" velocity=\"2\"");
    let segment = || Segment {
        joint: &vertical,
        mass: 2.0,
        inertia: 0.03,
    };
    let description = row(&[segment(), segment()]);
    for range in [None, Some([-100.0, 100.0])] {
        let request = gravity(range);
        let worst = holds::<F32>(&description, &request, Function::Gravity);
        assert!(worst > 1e-2, "{worst}");
        let generated = generated(&description, request, Function::Gravity, Real::F32);
        let Accuracy::Within(bound) = &generated.accuracy[0] else {
            panic!("{:?}", generated.accuracy);
        };
        let most = range.map_or(2.0 * 9.81, |[_, most]| most);
        let expected = format!("entries of `gravity` ≤ {most} m/s²");
        assert!(bound.range.contains(&expected), "{}", bound.range);
    }
}

#[test]
fn bounds_hold_for_a_mass_in_a_field_within_its_range() {
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
            holds::<F32>(&description, &request, function);
            holds::<F64>(&description, &request, function);
        }
        // The inertia of link 2 remains at mass 0, so M is regular.
        let generated = generated(&description, request, Function::ForwardDynamics, Real::F64);
        assert!(
            bounds(&generated)
                .iter()
                .all(|bound| bound.double < Some(1e-11))
        );
    }
}

/// Equal limits: a prismatic joint that stays at 50 m.
#[test]
fn bounds_hold_for_a_prismatic_joint_with_equal_limits() {
    let revolute = joint("revolute", "0 1 0", r#"lower="-1" upper="1" velocity="2""#);
    let prismatic = joint(
        "prismatic",
        "1 0 0",
        r#"lower="50" upper="50" velocity="1""#,
    );
    let segments = [&revolute, &prismatic].map(|joint| Segment {
        joint,
        mass: 1.0,
        inertia: 0.01,
    });
    let (description, request) = (row(&segments), Request::default());
    for function in TORQUES {
        holds::<F32>(&description, &request, function);
        holds::<F64>(&description, &request, function);
    }
}

#[test]
fn a_velocity_limit_of_1e20_overflows_in_single_precision() {
    let (description, request) = (
        two(r#"lower="-1" upper="1" velocity="1e20""#),
        Request::default(),
    );
    let of = |scalar| generated(&description, request.clone(), Function::Bias, scalar);
    assert_eq!(
        refusal(&of(Real::F32)),
        "a number may overflow within the range"
    );
    holds::<F64>(&description, &request, Function::Bias);
    // A module for any type states both bounds in one line.
    let Accuracy::Within(bound) = &of(Real::Generic).accuracy[0] else {
        panic!("f64 has a bound");
    };
    assert_eq!(bound.lacks, Some("a number may overflow within the range"));
    assert!(
        bound
            .bounds
            .iter()
            .all(|bound| bound.single == Some(f64::INFINITY))
    );
    let huge = two(r#"lower="-1" upper="1" velocity="1e200""#);
    let generated = generated(&huge, request, Function::Bias, Real::F64);
    assert_eq!(
        refusal(&generated),
        "a number may overflow within the range"
    );
}

/// Infinite limits are like no limits, and the range states the default.
#[test]
fn infinite_limits_give_the_default_range() {
    let description = two(r#"lower="-inf" upper="inf" velocity="inf""#);
    let generated = generated(&description, Request::default(), Function::Bias, Real::F32);
    let Accuracy::Within(bound) = &generated.accuracy[0] else {
        panic!("{:?}", generated.accuracy);
    };
    assert_eq!(bound.range, "|q| ≤ π rad, |q̇| ≤ 10 rad/s");
}

/// Results, arguments and intermediate values are subnormal, and may be flushed to zero.
#[test]
fn bounds_hold_for_subnormal_arguments() {
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
        holds::<F32>(&description, &request, function);
        holds::<Flushed>(&description, &request, function);
    }
}

#[test]
fn a_non_physical_inertia_has_no_bound() {
    let revolute = joint("revolute", "0 1 0", r#"lower="-1" upper="1" velocity="2""#);
    let segments = [0.03, -0.01].map(|inertia| Segment {
        joint: &revolute,
        mass: 1.0,
        inertia,
    });
    let description = row(&segments);
    for function in [Function::ForwardDynamics, Function::MassMatrixInverse] {
        let request = Request {
            formulation: Formulation::default().with_forward(Forward::UNREFINED),
            ..Request::default()
        };
        let generated = generated(&description, request, function, Real::F64);
        let reason = refusal(&generated);
        assert_eq!(
            reason,
            "an inertia is none that a body has, as far as its digits tell"
        );
    }
}

/// Two joints about one line, with a mass matrix that is singular but for rounding.
#[test]
fn a_coaxial_pair_with_a_nearly_massless_first_body_has_no_bound() {
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
        formulation: Formulation::default().with_forward(Forward::UNREFINED),
        ..Request::default()
    };
    let generated = generated(
        &description,
        request,
        Function::ForwardDynamics,
        Real::Generic,
    );
    match &generated.accuracy[0] {
        Accuracy::Unknown(_) => {}
        Accuracy::Backward(_, bound) => {
            let single = bound.bounds.iter().map(|bound| bound.single);
            assert!(single.into_iter().all(|bound| bound == Some(f64::INFINITY)));
            assert!(bound.lacks.is_some());
        }
        other => panic!("accelerations are not bounded themselves: {other:?}"),
    }
}

#[test]
fn the_bound_of_the_inverse_says_that_each_column_is_exact_for_a_nearby_matrix() {
    let builder = Builder::from_description(two(r#"lower="-1" upper="1" velocity="2""#));
    let source = builder.generate([Function::MassMatrixInverse]).to_source();
    let source = source
        .unwrap_or_else(|errors| panic!("{errors}"))
        .to_string();
    assert!(
        source.contains("each column is exact for a mass matrix that differs from M by at most"),
        "{source}"
    );
}

/// Twelve joints in a row with a light link at the end: the reason is the rounding of the mass matrix, not overflow.
/// With three joints it is overflow.
#[test]
fn the_reason_for_no_bound_is_rounding_before_overflow() {
    let limit = r#"lower="-2" upper="2" velocity="2""#;
    let joints = ["0 0 1", "0 1 0"].map(|axis| joint("revolute", axis, limit));
    for (count, expected) in [
        (
            12,
            "rounding may outweigh the least inertia, as far as ranges tell",
        ),
        (3, "a number may overflow within the range"),
    ] {
        let segment = |k: usize| Segment {
            joint: &joints[k % 2],
            mass: if k + 1 < count { 2.0 } else { 1e-16 },
            inertia: if k + 1 < count { 0.03 } else { 1e-18 },
        };
        let arm = row(&(0..count).map(segment).collect::<Vec<_>>());
        let generated = generated(
            &arm,
            Request::default(),
            Function::MassMatrixInverse,
            Real::F32,
        );
        assert_eq!(refusal(&generated), expected, "{count} joints");
    }
}

//! Generated code among adverse names, scopes and lints.
#![deny(warnings, clippy::pedantic, missing_docs, unused_qualifications)]
#![deny(unreachable_pub)]

/// The same robot in an ordinary scope.
mod friendly {
    #[derive(homogen::Robot)]
    #[robot(
        urdf = "../robots/hostile.urdf",
        tip = "hand-auge 2",
        frames("hand_auge-2")
    )]
    #[robot(generate(
        forward_kinematics,
        spatial_jacobian,
        body_jacobian,
        geometric_jacobian,
        velocity,
        acceleration,
        inverse_dynamics,
        gravity,
        bias,
        mass_matrix,
        all_of(mass_matrix, bias)
    ))]
    pub(crate) struct Arm;
}

/// A scope without the prelude, in which common names mean something else.
#[no_implicit_prelude]
#[allow(
    dead_code,
    non_camel_case_types,
    non_upper_case_globals,
    unused_macros,
    reason = "they are here only to shadow"
)]
mod shadowed {
    use ::homogen::Robot as Macro;

    mod core {}
    mod std {}
    mod homogen {}
    struct f32;
    struct f64;
    struct u8;
    struct usize;
    struct Option;
    struct Into;
    struct Pose;
    trait Scalar {}
    trait Gravity {}
    fn sin() {}
    fn sin_cos() {}
    fn sqrt() {}
    fn k() {}
    fn mul_add() {}
    fn t_1() {}
    macro_rules! include_bytes {
        () => {};
    }
    macro_rules! unreachable {
        () => {};
    }

    macro_rules! arm {
        ($name:ident, $scalar:ident) => {
            #[::core::prelude::v1::derive(Macro)]
            #[robot(
                urdf = "../robots/hostile.urdf",
                tip = "hand-auge 2",
                frames("hand_auge-2")
            )]
            #[robot(scalar = $scalar)]
            #[robot(generate(
                forward_kinematics,
                spatial_jacobian,
                body_jacobian,
                geometric_jacobian,
                velocity,
                acceleration,
                inverse_dynamics,
                gravity,
                bias,
                mass_matrix,
                all_of(mass_matrix, bias)
            ))]
            pub(crate) struct $name<'q, T, const q_1: ::core::primitive::usize>
            where
                T: ::core::marker::Copy,
            {
                /// The mass of the last link.
                #[robot(mass_of = "hand-auge 2")]
                pub(crate) q_2: ::core::primitive::f32,
                /// Gravity.
                #[robot(gravity)]
                pub(crate) r#fn: [::core::primitive::f64; 3],
                /// A field that the robot does not use.
                pub(crate) t_1: &'q [T; q_1],
            }
        };
    }
    arm!(Generic, generic);
    arm!(Single, f32);
    arm!(Double, f64);
}

/// Structs with names of generated code: of its type parameter or of its values.
mod namesakes {
    macro_rules! arm {
        ($name:ident) => {
            #[derive(homogen::Robot)]
            #[robot(urdf = "../robots/hostile.urdf", generate(gravity))]
            pub(crate) struct $name;
        };
    }
    arm!(T);
    #[allow(non_camel_case_types, reason = "the name is under test")]
    pub(crate) mod k {
        arm!(k);
    }
    #[allow(non_camel_case_types, reason = "the name is under test")]
    pub(crate) mod t_1 {
        arm!(t_1);
    }
    #[allow(non_camel_case_types, reason = "the name is under test")]
    pub(crate) mod q {
        arm!(q);
    }
}

const Q: [f64; 3] = [0.4, -0.2, 1.1];
const QD: [f64; 3] = [-0.3, 0.5, 0.7];
const QDD: [f64; 3] = [1.3, -0.8, 0.2];

fn close(a: f64, b: f64, tolerance: f64) {
    assert!(
        (a - b).abs() <= tolerance * (1.0 + b.abs()),
        "{a} is not {b}"
    );
}

#[test]
fn names_and_scopes_change_no_result() {
    let expected = friendly::Arm.inverse_dynamics(&Q, &QD, &QDD);
    let fields = [0_u8; 2];
    let generic = shadowed::Generic {
        q_2: 0.7,
        r#fn: [0.0, 0.0, -9.81],
        t_1: &fields,
    };
    let double = shadowed::Double {
        q_2: 0.7,
        r#fn: [0.0, 0.0, -9.81],
        t_1: &fields,
    };
    let single = shadowed::Single {
        q_2: 0.7,
        r#fn: [0.0, 0.0, -9.81],
        t_1: &fields,
    };
    let narrow = |values: [f64; 3]| values.map(<f32 as homogen::Scalar>::constant);
    let generic = generic.inverse_dynamics(&Q, &QD, &QDD);
    let double = double.inverse_dynamics(&Q, &QD, &QDD);
    let single = single.inverse_dynamics(&narrow(Q), &narrow(QD), &narrow(QDD));
    for i in 0..3 {
        // The field of the mass is an f32.
        close(generic[i], expected[i], 1e-6);
        close(double[i], generic[i], 1e-14);
        close(single[i].into(), expected[i], 1e-5);
    }
}

#[test]
fn a_struct_may_have_any_name() {
    let expected = friendly::Arm.gravity(&Q);
    let found = [
        namesakes::T.gravity(&Q),
        namesakes::k::k.gravity(&Q),
        namesakes::t_1::t_1.gravity(&Q),
        namesakes::q::q.gravity(&Q),
    ];
    for torques in found {
        for i in 0..3 {
            close(torques[i], expected[i], 0.0);
        }
    }
    let joints = friendly::Arm::chain().joints;
    assert_eq!(namesakes::T::chain().joints, joints);
    assert_eq!(namesakes::k::k::chain().joints, joints);
    assert_eq!(namesakes::t_1::t_1::chain().joints, joints);
    assert_eq!(namesakes::q::q::chain().joints, joints);
}

#[test]
fn frames_of_similar_names_are_two_functions() {
    let near = friendly::Arm.forward_kinematics(&Q).translation();
    let far = friendly::Arm
        .forward_kinematics_of_hand_auge_2(&Q)
        .translation();
    let squares = (0..3).map(|i| (near[i] - far[i]) * (near[i] - far[i]));
    close(squares.sum::<f64>().sqrt(), 0.1, 1e-14);
}

#[test]
fn functions_generated_together_agree_with_those_generated_alone() {
    let (mass, bias) = friendly::Arm.mass_matrix_and_bias(&Q, &QD);
    let (alone, at_rest) = (friendly::Arm.mass_matrix(&Q), friendly::Arm.bias(&Q, &QD));
    for i in 0..3 {
        close(bias[i], at_rest[i], 1e-14);
        for j in 0..3 {
            close(mass[i][j], alone[i][j], 1e-14);
        }
    }
}

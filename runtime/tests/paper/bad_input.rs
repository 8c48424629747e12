//! Errors of bad input, with the quantity and its value; finite numbers never panic.

use crate::sample::Random;
use homogen::frames::{Axis, pose_from_points};
use homogen::geometry::{Line, Plane, angle};
use homogen::{
    Acceleration, Chain, Displacement, Error, Frame, Inertia, Joint, Pose, Real, Screw, Velocity,
    angles, newton_euler, normalize, rotation, vector,
};

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

#[test]
fn matrices_that_are_not_rotations() {
    let mut sheared = IDENTITY;
    sheared[0][1] = 0.25;
    let refused = Pose::checked(sheared, [0.0; 3], 1e-9);
    assert_eq!(refused, Err(Error::NotRotation { value: 0.25 }));
    assert!((rotation::defect(&sheared) - 0.25).abs() < 1e-16);
    assert_eq!(
        rotation::check(&sheared, 1e-9),
        Err(Error::NotRotation { value: 0.25 })
    );
    assert_eq!(
        refused.unwrap_err().to_string(),
        "not a rotation: an entry of RᵗR differs from I by 2.5e-1; `normalize::nearest_rotation` gives the nearest one"
    );
    let mut mirror = IDENTITY;
    mirror[2][2] = -1.0;
    let refused = Pose::checked(mirror, [0.0; 3], 1e-9).unwrap_err();
    assert_eq!(refused, Error::NotRotation { value: -1.0 });
    assert_eq!(refused.to_string(), "not a rotation: its determinant is -1");
    // Just inside and just outside the tolerance.
    let scaled = |s: f64| IDENTITY.map(|row| row.map(|x| x * s));
    assert!(Pose::checked(scaled(1.0 + 4e-10), [0.0; 3], 1e-9).is_ok());
    assert!(Pose::checked(scaled(1.0 + 6e-10), [0.0; 3], 1e-9).is_err());
}

#[test]
fn axes_that_are_not_of_unit_length() {
    let refused = Screw::checked([0.0, 3.0, 4.0], [0.0; 3], 1e-9).unwrap_err();
    assert_eq!(
        refused,
        Error::NotUnit {
            quantity: "the axis u",
            value: 5.0
        }
    );
    assert_eq!(
        refused.to_string(),
        "the axis u must be of unit length, but has length 5"
    );
    let refused = Screw::checked([0.0; 3], [0.0, 0.0, 0.5], 1e-9);
    assert!(matches!(refused, Err(Error::NotUnit { value: 0.5, .. })));
    let refused = Screw::checked([0.0; 3], [0.0; 3], 1e-9);
    assert!(matches!(refused, Err(Error::NotUnit { value: 0.0, .. })));
    assert!(Screw::checked([0.0, 0.6, 0.8], [7.0, 0.0, 0.0], 1e-9).is_ok());
    assert!(Screw::checked([0.0; 3], [0.0, 0.6, 0.8], 1e-9).is_ok());
}

#[test]
fn negative_masses_and_non_physical_inertias() {
    let refused = Inertia::new([1.0, 1.0, 1.0, 0.0, 0.0, 0.0], [0.0; 3], -2.5).check(1e-9);
    assert_eq!(refused, Err(Error::NegativeMass { value: -2.5 }));
    assert_eq!(
        refused.unwrap_err().to_string(),
        "the mass is -2.5 kg, and must not be negative"
    );
    // A moment of inertia that is larger than the sum of the two others.
    let tensor = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.5]];
    let refused = Inertia::from_tensor_at_center_of_mass(1.0, [0.0; 3], &tensor).check(1e-9);
    assert!(matches!(
        refused,
        Err(Error::NotPhysical { value: -0.25, .. })
    ));
    let message = refused.unwrap_err().to_string();
    assert_eq!(
        message,
        "non-physical inertia: a principal second moment about the centre of mass is -2.5e-1"
    );
    let refused = Inertia::new([0.0; 6], [0.0, 0.5, 0.0], 0.0).check(1e-9);
    assert!(matches!(
        refused,
        Err(Error::NotPhysical { value: 0.5, .. })
    ));
    assert_eq!(Inertia::<f64>::zero().check(0.0), Ok(()));
}

#[test]
fn numbers_that_are_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = [
            Pose::checked(IDENTITY, [0.0, bad, 0.0], 1e-9).err(),
            Pose::checked([[bad; 3]; 3], [0.0; 3], 1e-9).err(),
            Screw::checked([bad, 0.0, 1.0], [0.0; 3], 1e-9).err(),
            Screw::checked([0.0, 0.0, 1.0], [0.0, bad, 0.0], 1e-9).err(),
            Inertia::new([0.0; 6], [0.0; 3], bad).check(1e-9).err(),
            Inertia::new([0.0; 6], [0.0, 0.0, bad], 1.0)
                .check(1e-9)
                .err(),
            Inertia::new([1.0, 1.0, 1.0, bad, 0.0, 0.0], [0.0; 3], 1.0)
                .check(1e-9)
                .err(),
            rotation::check(&[[0.0, bad, 0.0]; 3], 1e-9).err(),
        ];
        for error in refused {
            let Some(Error::NotFinite { value, .. }) = error else {
                panic!("{bad} gave {error:?}");
            };
            assert_eq!(value.to_bits(), bad.to_bits());
            assert!(error.is_some_and(|e| e.to_string().contains(&format!(" is {bad}, and"))));
        }
    }
}

#[test]
fn the_other_messages_name_quantity_and_value() {
    let refused = Line::through([1.0; 3], [1.0; 3]).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the data do not determine the result: the direction of the line is 0e0"
    );
    let form = Error::NotOfForm {
        quantity: "(G, a; 0, 0)",
        value: 0.5,
    };
    assert_eq!(
        form.to_string(),
        "not of the form (G, a; 0, 0): an entry differs by 5e-1"
    );
}

#[test]
fn parents_behind_their_children() {
    let z = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]);
    let place = Pose::from_translation([0.5, 0.0, 0.0]);
    let joint = |name, parent, screw, mass| {
        Joint::new(
            name,
            parent,
            place,
            screw,
            Inertia::of_particle(mass, [1.0, 0.0, 0.0]),
        )
    };
    let frame = |body| Frame::new("tip", body, place);
    let chain = |parent, screw, mass, body| {
        let joints = [joint("a", None, z, 1.0), joint("b", parent, screw, mass)];
        Chain::<2, 1>::new(joints, [frame(body)], [0.0, 0.0, -9.81])
    };
    assert_eq!(chain(Some(0), z, 1.0, Some(1)).check(1e-9), Ok(()));
    let refused = chain(Some(1), z, 1.0, None).check(1e-9).unwrap_err();
    assert_eq!(
        refused,
        Error::ParentAfterChild {
            joint: "b",
            parent: 1
        }
    );
    assert_eq!(
        refused.to_string(),
        "\"b\": there is no joint 1 before it; list parents first"
    );
    let refused = chain(Some(0), z, 1.0, Some(2)).check(1e-9);
    assert_eq!(
        refused,
        Err(Error::ParentAfterChild {
            joint: "tip",
            parent: 2
        })
    );
    let long = Screw::revolute([0.0, 0.0, 2.0], [0.0; 3]);
    assert!(matches!(
        chain(Some(0), long, 1.0, None).check(1e-9),
        Err(Error::NotUnit { value: 2.0, .. })
    ));
    let refused = chain(Some(0), z, -1.0, None).check(1e-9);
    assert_eq!(refused, Err(Error::NegativeMass { value: -1.0 }));
}

/// Numbers of every size, subnormal ones and the largest among them.
fn wild<T: Real>(random: &mut Random) -> T {
    let largest = T::constant(0.25) / T::MIN_POSITIVE;
    let sizes = [
        T::constant(0.0),
        T::MIN_POSITIVE * T::EPSILON,
        T::MIN_POSITIVE,
        T::MIN_POSITIVE.sqrt(),
        T::EPSILON,
        T::constant(1.0),
        T::constant(1e6),
        largest.sqrt(),
        largest,
    ];
    sizes[random.index(sizes.len())] * random.number()
}

/// Results may be meaningless here, but functions must return.
fn finite_numbers_never_panic<T: Real>() {
    let mut random = Random::new(170);
    for _ in 0..2000 {
        let mut v = || -> [T; 3] { std::array::from_fn(|_| wild(&mut random)) };
        let (a, b, c) = (v(), v(), v());
        let rows = [v(), v(), v()];
        let (pose, w) = (Pose::new(rows, a), Velocity::new(b, c));
        let j = Inertia::new([a[0], a[1], a[2], b[0], b[1], b[2]], c, rows[0][0]);
        let h = Acceleration::from_parts(a, b, c);
        let _ = std::hint::black_box((
            (
                pose.inverse(),
                pose.change_frame(&j),
                pose.change_frame(&h),
                pose.change_frame(&w),
            ),
            (
                Displacement::from_relative_pose(pose).log(),
                w.instantaneous_screw_axis(),
            ),
            (Screw::new(a, b).exp(c[0]), w.displacement(c[1])),
            (
                j.check(a[0]),
                j.principal_frame(),
                j.action(&h),
                j.momentum(&w),
            ),
            (rotation::axis_angle(&rows), rotation::check(&rows, a[0])),
            (
                normalize::nearest_rotation(&rows),
                vector::unit(a),
                vector::norm(b),
            ),
            (pose_from_points(a, b, c, Axis::X, Axis::Z), angle(a, b)),
        ));
        std::hint::black_box((
            Pose::checked(rows, a, b[0]).is_ok(),
            Screw::checked(a, b, c[0]).is_ok(),
            newton_euler::action(
                &j,
                [None; 6],
                [a[0], a[1], a[2], b[0], b[1], b[2]].map(Some),
            )
            .is_ok(),
            Line::through(a, b)
                .and_then(|l| l.approach(&Line::through(b, c)?))
                .is_ok(),
            Plane::through(a, b, c)
                .and_then(|p| p.intersection(&Plane::from_point_and_normal(a, b)?))
                .is_ok(),
        ));
        for sequence in angles::Sequence::ALL {
            std::hint::black_box((
                angles::from_rotation(sequence, &rows),
                angles::rates(sequence, a, b).is_ok(),
                angles::second_rates(sequence, a, b, c).is_ok(),
            ));
        }
    }
}

in_both_precisions! {
    finite_numbers_never_panic
}

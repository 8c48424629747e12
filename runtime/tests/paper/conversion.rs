//! Conversions to and from nalgebra.

use crate::dense::{assert_same, assert_within};
use crate::sample::{Random, inertias, poses};
use homogen::{
    Acceleration, Action, Direction, Displacement, Error, Inertia, Momentum, Point, Pose, Real,
    Screw, Velocity,
};
use nalgebra::{Isometry3, Matrix4, Point3, RealField, Vector3, Vector4, Vector6};

fn matrices_there_and_back<T: Real + RealField + Copy>() {
    let mut random = Random::new(180);
    for (m, j) in poses::<T>(180)
        .into_iter()
        .zip(inertias::<T>(180).into_iter().cycle())
    {
        let w = random.velocity::<T>();
        let h = Acceleration::new(
            [random.vector::<T>(), random.vector(), random.vector()],
            random.vector(),
        );
        let (gamma, phi) = (j.momentum(&w), j.action(&h));
        let l = random.screw::<T>();
        assert_eq!(Pose::try_from(Matrix4::from(m)), Ok(m));
        let q = Displacement::from_relative_pose(m);
        assert_eq!(Displacement::try_from(Matrix4::from(q)), Ok(q));
        assert_eq!(Screw::try_from(Matrix4::from(l)), Ok(l));
        assert_eq!(Velocity::try_from(Matrix4::from(w)), Ok(w));
        assert_eq!(Acceleration::try_from(Matrix4::from(h)), Ok(h));
        assert_eq!(Inertia::try_from(Matrix4::from(j)), Ok(j));
        assert_eq!(Momentum::try_from(Matrix4::from(gamma)), Ok(gamma));
        assert_eq!(Action::try_from(Matrix4::from(phi)), Ok(phi));
        let rows = j.to_matrix();
        let dense = Matrix4::from(j);
        for i in 0..4 {
            for k in 0..4 {
                assert_eq!(dense[(i, k)], rows[i][k]);
            }
        }
    }
}

fn vectors_in_either_row_order<T: Real + RealField + Copy>() {
    let mut random = Random::new(181);
    for _ in 0..20 {
        let (a, b) = (random.vector::<T>(), random.vector());
        let angular = Vector6::new(a[0], a[1], a[2], b[0], b[1], b[2]);
        let linear = Vector6::new(b[0], b[1], b[2], a[0], a[1], a[2]);
        assert_eq!(Screw::new(a, b).to_vector_angular_first(), angular);
        assert_eq!(Screw::new(a, b).to_vector_linear_first(), linear);
        assert_eq!(Velocity::new(a, b).to_vector_angular_first(), angular);
        assert_eq!(
            Velocity::from_vector_linear_first(&linear),
            Velocity::new(a, b)
        );
        assert_eq!(Momentum::new(a, b).to_vector_linear_first(), linear);
        assert_eq!(
            Momentum::from_vector_angular_first(&angular),
            Momentum::new(a, b)
        );
        assert_eq!(Action::new(a, b).to_vector_angular_first(), angular);
        assert_eq!(Action::from_vector_linear_first(&linear), Action::new(a, b));
    }
}

fn isometries_there_and_back<T: Real + RealField + Copy>() {
    for m in poses::<T>(182) {
        let isometry = Isometry3::from(m);
        let one = T::constant(1.0);
        assert_same(&Pose::from(isometry).to_matrix(), &m.to_matrix(), one, 16.0);
        let p = [0.3, -0.4, 0.5].map(T::constant);
        let moved = isometry * Point3::from(Point(p));
        let scale = crate::dense::size_of(&m.to_matrix());
        assert_within(Point::from(moved).0, (m * Point(p)).0, scale, 32.0);
    }
}

fn points_and_directions<T: Real + RealField + Copy>() {
    let p = [0.3, -0.4, 0.5].map(T::constant);
    assert_eq!(Point::from(Point3::from(Point(p))), Point(p));
    assert_eq!(Direction::from(Vector3::from(Direction(p))), Direction(p));
    assert_eq!(Vector4::from(Point(p))[3], T::constant(1.0));
    assert_eq!(Vector4::from(Direction(p))[3], T::constant(0.0));
}

fn other_forms_are_refused<T: Real + RealField + Copy>() {
    let mut random = Random::new(183);
    let ones = Matrix4::repeat(T::constant(1.0));
    let wrong = |error: Option<Error>| {
        matches!(
            error,
            Some(Error::NotOfForm { .. } | Error::NotRotation { .. })
        )
    };
    assert!(wrong(Pose::try_from(ones).err()));
    assert!(wrong(Displacement::try_from(ones).err()));
    assert!(wrong(Screw::try_from(ones).err()));
    assert!(wrong(Velocity::try_from(ones).err()));
    assert!(wrong(Acceleration::try_from(ones).err()));
    assert!(wrong(Momentum::try_from(ones).err()));
    assert!(wrong(Action::try_from(ones).err()));
    let mut lopsided = Matrix4::from(random.inertia::<T>());
    lopsided[(1, 0)] += T::constant(0.5);
    let refused = Inertia::try_from(lopsided);
    assert!(matches!(refused, Err(Error::NotOfForm { value, .. }) if (value - 0.5).abs() < 1e-6));
    let nan = Matrix4::repeat(T::constant(f64::NAN));
    assert!(matches!(
        Inertia::try_from(nan),
        Err(Error::NotFinite { .. })
    ));
    assert!(matches!(
        Velocity::try_from(nan),
        Err(Error::NotFinite { .. })
    ));
}

in_both_precisions! {
    matrices_there_and_back
    vectors_in_either_row_order
    isometries_there_and_back
    points_and_directions
    other_forms_are_refused
}

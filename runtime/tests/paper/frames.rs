//! SPACELIB's frames from points and vectors.

use crate::dense::{assert_within, unit_roundoff};
use crate::sample::Random;
use homogen::frames::{
    Axis, pose_from_points, pose_from_vectors, rotation_from_points, rotation_from_vectors,
};
use homogen::vector::{add, cross, dot, scale, transpose, unit};
use homogen::{Error, Real, rotation};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

fn frames_from_vectors<T: Real>() {
    let mut random = Random::new(130);
    for first in AXES {
        for second in AXES {
            for _ in 0..50 {
                let (v, w, p) = (random.vector::<T>(), random.vector(), random.vector());
                if first == second {
                    let refused = rotation_from_vectors(v, w, first, second);
                    assert!(matches!(refused, Err(Error::Degenerate { .. })));
                    continue;
                }
                let r = rotation_from_vectors(v, w, first, second).expect("not parallel");
                let m = pose_from_vectors(p, v, w, first, second).expect("not parallel");
                assert_eq!((*m.rotation(), m.translation()), (r, p));
                assert_eq!(rotation::check(&r, T::constant(8.0) * T::EPSILON), Ok(()));
                let axes = transpose(&r);
                let (a, b) = (axes[first.index()], axes[second.index()]);
                assert_eq!(Some(a), unit(v));
                // The second axis is in the half-plane of w, the third one perpendicular to both vectors.
                assert!(dot(b, w) > T::constant(0.0));
                let third = axes[3 - first.index() - second.index()];
                assert_within(
                    [dot(third, v), dot(third, w)],
                    [T::constant(0.0); 2],
                    T::constant(2.0),
                    16.0,
                );
            }
        }
    }
}

fn frames_from_points<T: Real>() {
    let mut random = Random::new(131);
    for _ in 0..50 {
        let (o, a, b) = (random.vector::<T>(), random.vector(), random.vector());
        let m = pose_from_points(o, a, b, Axis::X, Axis::Y).expect("not on a line");
        let r = rotation_from_points(o, a, b, Axis::X, Axis::Y).expect("not on a line");
        assert_eq!((*m.rotation(), m.translation()), (r, o));
        // In the new frame the points are (x, 0, 0) and (·, y, 0), x and y positive.
        let back = m.inverse();
        let (a, b) = ((back * homogen::Point(a)).0, (back * homogen::Point(b)).0);
        assert!(a[0] > T::constant(0.0) && b[1] > T::constant(0.0));
        assert_within(
            [a[1], a[2], b[2]],
            [T::constant(0.0); 3],
            T::constant(4.0),
            16.0,
        );
    }
}

fn nearly_parallel_vectors_still_make_a_rotation<T: Real>() {
    let mut random = Random::new(132);
    for exponent in [2, 4, 6, 8, 12, 14] {
        let small = T::constant(10.0_f64.powi(-exponent));
        if small < T::constant(64.0) * unit_roundoff::<T>() {
            continue;
        }
        for _ in 0..50 {
            let v = random.unit::<T>();
            let aside = unit(cross(v, random.unit())).expect("not parallel");
            let w = add(v, scale(small, aside));
            let r = rotation_from_vectors(v, w, Axis::Z, Axis::X).expect("not parallel");
            assert_eq!(rotation::check(&r, T::constant(8.0) * T::EPSILON), Ok(()));
        }
    }
}

fn data_that_determine_no_frame_are_refused<T: Real>() {
    let zero = [T::constant(0.0); 3];
    let v = [1.0, 2.0, 3.0].map(T::constant);
    for (a, b) in [
        (zero, v),
        (v, zero),
        (v, v),
        (v, scale(T::constant(-2.0), v)),
    ] {
        let refused = rotation_from_vectors(a, b, Axis::X, Axis::Z);
        assert!(
            matches!(refused, Err(Error::Degenerate { .. })),
            "{refused:?}"
        );
    }
    let nan = [T::constant(f64::NAN); 3];
    let refused = pose_from_points(zero, nan, v, Axis::X, Axis::Y);
    assert!(matches!(refused, Err(Error::NotFinite { .. })));
}

fn axes_have_their_unit_vectors<T: Real>() {
    for axis in AXES {
        let v = axis.unit_vector::<T>();
        for (i, x) in v.into_iter().enumerate() {
            assert_eq!(x, T::constant(if i == axis.index() { 1.0 } else { 0.0 }));
        }
    }
}

in_both_precisions! {
    frames_from_vectors
    frames_from_points
    nearly_parallel_vectors_still_make_a_rotation
    data_that_determine_no_frame_are_refused
    axes_have_their_unit_vectors
}

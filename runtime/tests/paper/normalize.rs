//! SPACELIB's normalisation: the nearest rotation, symmetric and skew matrix.

use crate::dense::{assert_within, size};
use crate::sample::{Random, poses};
use homogen::normalize::{nearest_pose, nearest_rotation, nearest_skew, nearest_symmetric, skew};
use homogen::vector::{dot, matrix_product, matrix_scale, matrix_sum, transpose};
use homogen::{Error, Pose, Real, rotation};

fn flat<T: Real>(x: &[[T; 3]; 3]) -> Vec<T> {
    x.as_flattened().to_vec()
}

fn rotations_are_their_own_nearest<T: Real>() {
    for m in poses::<T>(150) {
        let near = nearest_pose(&m).expect("a rotation");
        assert_within(
            flat(near.rotation()),
            flat(m.rotation()),
            T::constant(1.0),
            16.0,
        );
        assert_eq!(near.translation(), m.translation());
    }
}

/// tr(RᵗX) is largest for the nearest rotation, for which RᵗX is symmetric; no other rotation has a larger
/// one.
fn no_rotation_is_nearer<T: Real>() {
    let mut random = Random::new(151);
    for drift in [1e-6, 1e-3, 0.1, 1.0, 3.0] {
        for _ in 0..20 {
            let r = random.rotation::<T>();
            let x = r.map(|row| row.map(|e| e + T::constant(drift) * random.number()));
            let near = nearest_rotation(&x).expect("one is nearest");
            assert_eq!(
                rotation::check(&near, T::constant(16.0) * T::EPSILON),
                Ok(())
            );
            let scale = T::constant(4.0) * size(flat(&x));
            let polar = matrix_product(&transpose(&near), &x);
            assert_within(flat(&polar), flat(&transpose(&polar)), scale, 256.0);
            let merit = |r: &[[T; 3]; 3]| {
                r.iter()
                    .zip(&x)
                    .fold(T::constant(0.0), |sum, (a, b)| sum + dot(*a, *b))
            };
            let slack = T::constant(32.0) * T::EPSILON * scale;
            for _ in 0..20 {
                let step = rotation::from_axis_angle(random.unit(), random.number::<T>());
                assert!(merit(&matrix_product(&near, &step)) <= merit(&near) + slack);
                assert!(merit(&random.rotation()) <= merit(&near) + slack);
            }
        }
    }
}

fn reflections_become_rotations<T: Real>() {
    let mirror =
        [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, -0.5]].map(|row| row.map(T::constant));
    let near = nearest_rotation(&mirror).expect("one is nearest");
    assert_within(
        flat(&near),
        flat(&homogen::vector::identity()),
        T::constant(1.0),
        8.0,
    );
    assert_eq!(
        rotation::check(&near, T::constant(8.0) * T::EPSILON),
        Ok(())
    );
}

fn matrices_without_a_nearest_rotation_are_refused<T: Real>() {
    let zero = [[T::constant(0.0); 3]; 3];
    assert!(matches!(
        nearest_rotation(&zero),
        Err(Error::Degenerate { .. })
    ));
    let inversion = matrix_scale(T::constant(-1.0), &homogen::vector::identity());
    assert!(matches!(
        nearest_rotation(&inversion),
        Err(Error::Degenerate { .. })
    ));
    let mut broken = *Pose::<T>::identity().rotation();
    broken[1][2] = T::constant(f64::NAN);
    assert!(matches!(
        nearest_rotation(&broken),
        Err(Error::NotFinite { .. })
    ));
}

fn symmetric_and_skew_parts<T: Real>() {
    let mut random = Random::new(152);
    for _ in 0..50 {
        let x: [[T; 3]; 3] = std::array::from_fn(|_| random.vector());
        let (symmetric, antisymmetric) = (nearest_symmetric(&x), nearest_skew(&x));
        assert_eq!(transpose(&symmetric), symmetric);
        assert_eq!(
            transpose(&antisymmetric),
            matrix_scale(T::constant(-1.0), &antisymmetric)
        );
        let sum = matrix_sum(&symmetric, &antisymmetric);
        assert_within(flat(&sum), flat(&x), T::constant(1.0), 2.0);
        let twice = matrix_scale(T::constant(2.0), &antisymmetric);
        assert_eq!(skew(&x), twice);
    }
}

in_both_precisions! {
    rotations_are_their_own_nearest
    no_rotation_is_nearer
    reflections_become_rotations
    matrices_without_a_nearest_rotation_are_refused
    symmetric_and_skew_parts
}

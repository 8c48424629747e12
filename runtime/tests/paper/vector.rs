//! § 2.1: the underscore operator and the change of frame of a vector.

use crate::dense::assert_within;
use crate::sample::{Random, units};
use homogen::vector::{
    add, axial, cross, dot, matrix_product, matrix_scale, matrix_sum, negate, norm, outer, product,
    scale, sub, transpose, underscore, unit,
};
use homogen::{Direction, Pose, Real};

fn underscore_is_cross_product<T: Real>() {
    let mut random = Random::new(1);
    for _ in 0..100 {
        let (b, c) = (random.vector::<T>(), random.vector());
        let a = cross(b, c);
        let one = T::constant(1.0);
        assert_within(product(&underscore(b), c), a, one, 2.0);
        // a̲ = b̲ c̲ − c̲ b̲ = −b cᵗ + c bᵗ.
        let minus = |x: &[[T; 3]; 3]| matrix_scale(-one, x);
        let commutator = matrix_sum(
            &matrix_product(&underscore(b), &underscore(c)),
            &minus(&matrix_product(&underscore(c), &underscore(b))),
        );
        let dyads = matrix_sum(&minus(&outer(b, c)), &outer(c, b));
        let expected = underscore(a);
        assert_within(
            commutator.as_flattened().to_vec(),
            expected.as_flattened().to_vec(),
            one,
            6.0,
        );
        assert_within(
            dyads.as_flattened().to_vec(),
            expected.as_flattened().to_vec(),
            one,
            4.0,
        );
        assert_eq!(axial(&expected), a);
    }
}

fn underscore_annihilates_its_vector<T: Real>() {
    let mut random = Random::new(2);
    for _ in 0..100 {
        let v = random.vector::<T>();
        assert_within(
            product(&underscore(v), v),
            [T::constant(0.0); 3],
            T::constant(1.0),
            0.0,
        );
    }
}

fn powers_of_unit_underscore_alternate<T: Real>() {
    for u in units::<T>(3) {
        let first = underscore(u);
        let mut power = first;
        for _ in 1..5 {
            let next = matrix_product(&matrix_product(&power, &first), &first);
            let expected = matrix_scale(T::constant(-1.0), &power);
            assert_within(
                next.as_flattened().to_vec(),
                expected.as_flattened().to_vec(),
                T::constant(1.0),
                16.0,
            );
            power = matrix_product(&power, &first);
        }
    }
}

fn vectors_change_frame_by_rotation<T: Real>() {
    let mut random = Random::new(4);
    for _ in 0..100 {
        let (r, v, t) = (random.rotation::<T>(), random.vector(), random.vector());
        let literal = matrix_product(&matrix_product(&r, &underscore(v)), &transpose(&r));
        let expected = underscore(product(&r, v));
        assert_within(
            literal.as_flattened().to_vec(),
            expected.as_flattened().to_vec(),
            T::constant(2.0),
            16.0,
        );
        // The same for `Direction`, which a translation does not change.
        let seen = Pose::new(r, t) * Direction(v);
        assert_within(seen.0, axial(&literal), T::constant(2.0), 16.0);
    }
}

fn sums_and_products_are_those_of_vectors<T: Real>() {
    let mut random = Random::new(5);
    for _ in 0..100 {
        let (a, b) = (random.vector::<T>(), random.vector());
        assert_within(sub(add(a, b), b), a, T::constant(2.0), 2.0);
        assert_eq!(negate(a), scale(T::constant(-1.0), a));
        assert_within(
            [dot(cross(a, b), a)],
            [T::constant(0.0)],
            T::constant(4.0),
            4.0,
        );
    }
}

fn norm_neither_overflows_nor_underflows<T: Real>() {
    let mut random = Random::new(6);
    let tiny = T::MIN_POSITIVE;
    for size in [
        tiny,
        tiny.sqrt(),
        T::constant(1.0),
        T::constant(1.0) / tiny.sqrt(),
        T::constant(0.1) / tiny,
    ] {
        for u in units::<T>(7) {
            let v = scale(size, u);
            let length = norm(v);
            assert!(
                (length / size - T::constant(1.0)).abs() <= T::constant(8.0) * T::EPSILON,
                "{length} of {size}"
            );
            assert_within(unit(v).expect("not zero"), u, T::constant(1.0), 8.0);
        }
        let v = scale(size, random.unit::<T>());
        assert!(norm(v).is_finite());
    }
    assert!(
        norm([T::constant(0.0), T::constant(f64::NAN)])
            .to_f64()
            .is_nan()
    );
    assert!(norm([T::constant(f64::NEG_INFINITY); 2]) > T::constant(1e30));
    assert_eq!(unit([T::constant(0.0); 3]), None);
    assert_eq!(unit([T::constant(f64::NAN); 3]), None);
    assert_eq!(unit([T::constant(f64::INFINITY); 3]), None);
}

fn subnormal_vectors_have_a_direction<T: Real>() {
    let least = T::MIN_POSITIVE * T::EPSILON;
    let u = unit([least, T::constant(0.0), -least]).expect("not zero");
    let root = T::constant(0.5).sqrt();
    assert_within(u, [root, T::constant(0.0), -root], T::constant(1.0), 4.0);
}

in_both_precisions! {
    underscore_is_cross_product
    underscore_annihilates_its_vector
    powers_of_unit_underscore_alternate
    vectors_change_frame_by_rotation
    sums_and_products_are_those_of_vectors
    norm_neither_overflows_nor_underflows
    subnormal_vectors_have_a_direction
}

//! SPACELIB's points, lines and planes.

use crate::dense::assert_within;
use crate::sample::Random;
use homogen::geometry::{Line, Plane, angle, distance, intermediate, middle};
use homogen::vector::{add, cross, dot, norm, scale, sub, unit};
use homogen::{Error, Real};

fn lines_through_points<T: Real>() {
    let mut random = Random::new(140);
    for _ in 0..100 {
        let (a, b) = (random.vector::<T>(), random.vector());
        let line = Line::through(a, b).expect("two points");
        assert_eq!(line.point(), a);
        assert_within(
            [line.distance(b)],
            [T::constant(0.0)],
            T::constant(4.0),
            4.0,
        );
        assert_within(line.project(b), b, T::constant(4.0), 8.0);
        // The projection is the foot of the perpendicular.
        let p = random.vector();
        let foot = line.project(p);
        assert_within(
            [dot(sub(p, foot), line.direction())],
            [T::constant(0.0)],
            T::constant(4.0),
            8.0,
        );
        assert_within(
            [distance(p, foot)],
            [line.distance(p)],
            T::constant(4.0),
            8.0,
        );
    }
}

fn lines_approach_each_other<T: Real>() {
    let mut random = Random::new(141);
    for _ in 0..100 {
        let (u, v) = (random.unit::<T>(), random.unit());
        let sine = norm(cross(u, v));
        if sine < T::constant(0.1) {
            continue;
        }
        // Two lines with a given common perpendicular.
        let normal = unit(cross(u, v)).expect("not parallel");
        let (foot, gap) = (random.vector(), random.positive::<T>());
        let other = add(foot, scale(gap, normal));
        let first =
            Line::from_point_and_direction(add(foot, scale(random.number(), u)), u).expect("unit");
        let second =
            Line::from_point_and_direction(add(other, scale(random.number(), v)), v).expect("unit");
        let found = first.approach(&second).expect("not parallel");
        let scale = T::constant(8.0) / (sine * sine);
        assert_within(found.first, foot, scale, 16.0);
        assert_within(found.second, other, scale, 16.0);
        assert_within([found.distance], [gap], scale, 16.0);
    }
}

fn planes_through_points<T: Real>() {
    let mut random = Random::new(142);
    for _ in 0..100 {
        let (a, b, c) = (random.vector::<T>(), random.vector(), random.vector());
        let sine = norm(cross(
            unit(sub(b, a)).expect("two"),
            unit(sub(c, a)).expect("two"),
        ));
        if sine < T::constant(0.05) {
            continue;
        }
        let plane = Plane::through(a, b, c).expect("three points");
        let scale = T::constant(4.0) / sine;
        let zero = T::constant(0.0);
        assert_within([a, b, c].map(|p| plane.distance(p)), [zero; 3], scale, 16.0);
        assert_eq!(plane.offset() - dot(plane.normal(), a), zero);
        let p = random.vector();
        let foot = plane.project(p);
        assert_within([plane.distance(foot)], [zero], T::constant(4.0), 16.0);
        assert_within(
            [distance(p, foot)],
            [plane.distance(p).abs()],
            T::constant(4.0),
            16.0,
        );
    }
}

fn planes_meet_planes_and_lines<T: Real>() {
    let mut random = Random::new(143);
    for _ in 0..100 {
        let (m, n) = (random.unit::<T>(), random.unit());
        let sine = norm(cross(m, n));
        if sine < T::constant(0.1) {
            continue;
        }
        let first = Plane::from_point_and_normal(random.vector(), m).expect("unit");
        let second = Plane::from_point_and_normal(random.vector(), n).expect("unit");
        let line = first.intersection(&second).expect("not parallel");
        let zero = T::constant(0.0);
        for t in [-1.0, 0.0, 2.0].map(T::constant) {
            let p = add(line.point(), scale(t, line.direction()));
            let size = T::constant(8.0) / (sine * sine);
            assert_within(
                [first.distance(p), second.distance(p)],
                [zero; 2],
                size,
                16.0,
            );
        }
        // Its point is the one nearest to the origin.
        assert_within(
            [dot(line.point(), line.direction())],
            [zero],
            T::constant(8.0) / sine,
            16.0,
        );
        let other = Line::from_point_and_direction(random.vector(), random.unit()).expect("unit");
        let steep = dot(other.direction(), m).abs();
        if steep > T::constant(0.1) {
            let p = first.intersection_with_line(&other).expect("not parallel");
            let size = T::constant(8.0) / steep;
            assert_within(
                [first.distance(p), other.distance(p)],
                [zero; 2],
                size,
                16.0,
            );
        }
    }
}

fn angles_keep_their_digits<T: Real>() {
    let z = [0.0, 0.0, 3.0].map(T::constant);
    for x in [1e-30, 1e-12, 1e-4, 0.5, 1.5] {
        let (s, c) = T::constant(x).sin_cos();
        let v = [s, T::constant(0.0), c];
        let x = T::constant(x);
        assert_within([angle(z, v)], [x], x, 4.0);
        let pi = T::constant(std::f64::consts::PI);
        assert_within([angle(scale(T::constant(-1.0), z), v)], [pi - x], pi, 4.0);
    }
    assert_eq!(angle(z, [T::constant(0.0); 3]), T::constant(0.0));
}

fn points_between<T: Real>() {
    let mut random = Random::new(144);
    for _ in 0..50 {
        let (a, b) = (random.vector::<T>(), random.vector());
        assert_eq!(intermediate(a, b, T::constant(0.0)), a);
        assert_eq!(intermediate(a, b, T::constant(1.0)), b);
        let half = middle(a, b);
        assert_within(
            [distance(a, half)],
            [distance(half, b)],
            T::constant(2.0),
            4.0,
        );
        assert_within([distance(a, b)], [norm(sub(a, b))], T::constant(2.0), 0.0);
    }
}

fn parallel_things_are_refused<T: Real>() {
    let (p, u) = (
        [0.5, 0.25, -1.0].map(T::constant),
        [1.0, 2.0, 2.0].map(T::constant),
    );
    let zero = [T::constant(0.0); 3];
    let line = Line::from_point_and_direction(p, u).expect("a direction");
    let other = Line::from_point_and_direction(zero, u).expect("a direction");
    let plane = Plane::from_point_and_normal(p, u).expect("a normal");
    let across = unit(cross(u, p)).expect("not parallel");
    let flat = Line::from_point_and_direction(p, across).expect("a direction");
    let degenerate = |error: Option<Error>| matches!(error, Some(Error::Degenerate { .. }));
    assert!(degenerate(line.approach(&other).err()));
    assert!(degenerate(line.approach(&line).err()));
    assert!(degenerate(plane.intersection(&plane).err()));
    assert!(degenerate(plane.intersection_with_line(&flat).err()));
    assert!(degenerate(Line::through(p, p).err()));
    assert!(degenerate(Plane::through(p, p, u).err()));
    assert!(degenerate(
        Plane::through(zero, u, scale(T::constant(2.0), u)).err()
    ));
    assert!(degenerate(Plane::from_point_and_normal(p, zero).err()));
    let nan = [T::constant(f64::NAN); 3];
    assert!(matches!(
        Line::through(p, nan),
        Err(Error::NotFinite { .. })
    ));
    assert!(matches!(
        Plane::through(nan, p, u),
        Err(Error::NotFinite { .. })
    ));
}

in_both_precisions! {
    lines_through_points
    lines_approach_each_other
    planes_through_points
    planes_meet_planes_and_lines
    angles_keep_their_digits
    points_between
    parallel_things_are_refused
}

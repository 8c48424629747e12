//! Distances by independent means: exact cases, and minima over parameters.

use crate::dense::{assert_within, size};
use crate::sample::Random;
use homogen::Real;
use homogen::geometry::{Line, Plane, distance, intermediate, middle};
use homogen::vector::{add, cross, norm, scale, sub};

/// Integers x, y, z, r with x² + y² + z² = r².
const QUADRUPLES: [[f64; 4]; 8] = [
    [0.0, 3.0, 4.0, 5.0],
    [0.0, 0.0, 7.0, 7.0],
    [1.0, 2.0, 2.0, 3.0],
    [2.0, 3.0, 6.0, 7.0],
    [1.0, 4.0, 8.0, 9.0],
    [4.0, 4.0, 7.0, 9.0],
    [2.0, 6.0, 9.0, 11.0],
    [3.0, 4.0, 12.0, 13.0],
];

/// Three perpendicular axes of integers with the same length, which is the last number.
const FRAMES: [([[f64; 3]; 3], f64); 3] = [
    ([[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [2.0, -2.0, 1.0]], 3.0),
    ([[2.0, 3.0, 6.0], [3.0, -6.0, 2.0], [6.0, 2.0, -3.0]], 7.0),
    ([[1.0, 4.0, 8.0], [4.0, 7.0, -4.0], [8.0, -4.0, 1.0]], 9.0),
];

/// Multiples of 1/8, which are exact.
fn eighths<T: Real>(random: &mut Random) -> [T; 3] {
    std::array::from_fn(|_| {
        let eighth = u32::try_from(random.index(129)).expect("small");
        T::constant(f64::from(eighth) / 8.0 - 8.0)
    })
}

fn distances_of_points_in_whole_numbers<T: Real>() {
    let mut random = Random::new(230);
    for [x, y, z, length] in QUADRUPLES {
        for step in [[x, y, z], [-y, z, x], [z, -x, -y]] {
            for power in [-20, -3, 0, 5] {
                let grown = T::constant(2.0_f64.powi(power));
                let a = scale(grown, eighths(&mut random));
                let b = add(a, scale(grown, step.map(T::constant)));
                let exact = grown * T::constant(length);
                assert_within([distance(a, b), distance(b, a)], [exact; 2], exact, 2.0);
                assert_eq!(sub(b, a), scale(grown, step.map(T::constant)));
                // The points at a quarter and at half of the distance are exact.
                let part = |k: f64| add(a, scale(grown, step.map(|x| T::constant(k * x))));
                assert_eq!(intermediate(a, b, T::constant(0.25)), part(0.25));
                assert_eq!(middle(a, b), part(0.5));
            }
        }
    }
}

fn distances_from_lines_and_planes_in_whole_numbers<T: Real>() {
    let mut random = Random::new(231);
    for ([u, v, n], length) in FRAMES {
        let [u, v, n] = [u, v, n].map(|axis| axis.map(T::constant));
        for _ in 0..20 {
            let [along, aside, up] = eighths::<T>(&mut random);
            let start = eighths(&mut random);
            let on_line = add(start, scale(along, u));
            let on_plane = add(on_line, scale(aside, v));
            let p = add(on_plane, scale(up, n));
            let size = size(p).max(size(start)).max(T::constant(1.0));
            let length = T::constant(length);
            let line = Line::from_point_and_direction(start, u).expect("a direction");
            assert_within(
                [line.distance(on_plane)],
                [length * aside.abs()],
                size,
                16.0,
            );
            assert_within(line.project(on_plane), on_line, size, 16.0);
            let plane = Plane::from_point_and_normal(start, n).expect("a normal");
            assert_within([plane.distance(p)], [length * up], size, 16.0);
            assert_within(plane.project(p), on_plane, size, 16.0);
            // Two lines at right angles, `up` lengths apart.
            let other = Line::from_point_and_direction(p, v).expect("a direction");
            let approach = line.approach(&other).expect("not parallel");
            assert_within([approach.distance], [length * up.abs()], size, 32.0);
            assert_within(approach.first, on_line, size, 32.0);
            assert_within(approach.second, sub(p, scale(aside, v)), size, 32.0);
            let met = plane.intersection_with_line(
                &Line::from_point_and_direction(p, add(n, u)).expect("a direction"),
            );
            let expected = sub(on_plane, scale(up, u));
            assert_within(met.expect("not parallel"), expected, size, 32.0);
        }
    }
}

/// The minimum of the squared distance over two parameters, by coordinate descent: each step goes to the
/// minimum of the parabola through three values.
fn least<T: Real>(square: impl Fn([T; 2]) -> T) -> T {
    let mut at = [T::constant(0.0); 2];
    let (one, two) = (T::constant(1.0), T::constant(2.0));
    for sweep in 0..200 {
        let k = sweep % 2;
        let beside = |step: T| {
            let mut beside = at;
            beside[k] = beside[k] + step;
            square(beside)
        };
        let (before, here, after) = (beside(-one), square(at), beside(one));
        let curvature = before - two * here + after;
        at[k] = at[k] - (after - before) / (two * curvature);
    }
    square(at)
}

/// The sum of the squares of the coordinates of a − b.
fn square<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    let [x, y, z] = sub(a, b);
    x * x + y * y + z * z
}

fn distances_are_the_least_over_parameters<T: Real>() {
    let mut random = Random::new(232);
    let mut judged = 0;
    for _ in 0..100 {
        let (p, start, other) = (random.vector::<T>(), random.vector(), random.vector());
        let (u, v) = (random.unit(), random.unit());
        // Coordinate descent is slow for nearly parallel lines.
        if norm(cross(u, v)) < T::constant(0.5) {
            continue;
        }
        judged += 1;
        let at = |start: [T; 3], s: T, u: [T; 3]| add(start, scale(s, u));
        let size = T::constant(64.0);
        let line = Line::from_point_and_direction(start, u).expect("a direction");
        // Over one parameter: the other adds an independent parabola.
        let of_line = least(|[s, t]| square(at(start, s, u), p) + t * t);
        let found = line.distance(p);
        assert_within([found * found], [of_line], size, 4.0);
        let plane = Plane::from_point_and_normal(start, cross(u, v)).expect("a normal");
        let of_plane = least(|[s, t]| square(at(at(start, s, u), t, v), p));
        let found = plane.distance(p);
        assert_within([found * found], [of_plane], size, 4.0);
        let second = Line::from_point_and_direction(other, v).expect("a direction");
        let of_lines = least(|[s, t]| square(at(start, s, u), at(other, t, v)));
        let found = line.approach(&second).expect("not parallel");
        assert_within([found.distance * found.distance], [of_lines], size, 8.0);
        let apart = distance(found.first, found.second);
        assert_within([apart], [found.distance], size, 4.0);
    }
    assert!(judged > 50, "only {judged}");
}

in_both_precisions! {
    distances_of_points_in_whole_numbers
    distances_from_lines_and_planes_in_whole_numbers
    distances_are_the_least_over_parameters
}

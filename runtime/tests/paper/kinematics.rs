//! § 3.1 and § 3.2: W, H, and their changes of frame.

use crate::dense::{apply, assert_same, assert_within, combine, product, size_of};
use crate::sample::{Random, poses, velocities};
use homogen::vector::{add, cross, matrix_product, matrix_sum, product as turn, sub, underscore};
use homogen::{Acceleration, Direction, Point, Real, Velocity};

fn velocity_of_points<T: Real>() {
    let mut random = Random::new(30);
    for w in velocities::<T>(30) {
        let p = Point(random.vector());
        let literal = apply(&w.to_matrix(), p.to_homogeneous());
        assert_within((w * p).to_homogeneous(), literal, T::constant(2.0), 8.0);
        let vectors = add(w.v(), cross(w.omega(), p.0));
        assert_within((w * p).0, vectors, T::constant(2.0), 8.0);
        let direction = Direction(p.0);
        assert_within(
            (w * direction).0,
            cross(w.omega(), p.0),
            T::constant(2.0),
            8.0,
        );
    }
}

fn velocity_from_a_point<T: Real>() {
    let mut random = Random::new(31);
    for w in velocities::<T>(31) {
        let p = random.vector();
        let found = Velocity::at_point(w.omega(), (w * Point(p)).0, p);
        assert_same(&found.to_matrix(), &w.to_matrix(), T::constant(2.0), 8.0);
    }
}

fn acceleration_of_points<T: Real>() {
    let mut random = Random::new(32);
    for w in velocities::<T>(32) {
        let (omega_dot, a, p) = (random.vector(), random.vector(), random.vector());
        let omega = w.omega();
        let h = Acceleration::from_parts(omega_dot, omega, a);
        let literal = apply(&h.to_matrix(), Point(p).to_homogeneous());
        assert_within(
            (h * Point(p)).to_homogeneous(),
            literal,
            T::constant(4.0),
            8.0,
        );
        // (7), as vectors.
        let turning = add(cross(omega_dot, p), cross(omega, cross(omega, p)));
        assert_within((h * Point(p)).0, add(a, turning), T::constant(4.0), 16.0);
        assert_within((h * Direction(p)).0, turning, T::constant(4.0), 16.0);
        let found = Acceleration::at_point(omega_dot, omega, (h * Point(p)).0, p);
        assert_same(&found.to_matrix(), &h.to_matrix(), T::constant(8.0), 8.0);
    }
}

fn acceleration_is_derivative_plus_square<T: Real>() {
    let mut random = Random::new(33);
    for w in velocities::<T>(33) {
        // H = Ẇ + W².
        let w_dot = random.velocity();
        let h = Acceleration::from_velocity_derivative(&w, &w_dot);
        let square = product(&w.to_matrix(), &w.to_matrix());
        let literal = combine(1.0, &w_dot.to_matrix(), 1.0, &square);
        assert_same(&h.to_matrix(), &literal, T::constant(2.0), 8.0);
        let found = h.velocity_derivative(&w);
        assert_same(
            &found.to_matrix(),
            &w_dot.to_matrix(),
            T::constant(4.0),
            8.0,
        );
    }
}

fn parts_of_the_acceleration_block<T: Real>() {
    let mut random = Random::new(34);
    for w in velocities::<T>(34) {
        let (omega_dot, omega) = (random.vector::<T>(), w.omega());
        let h = Acceleration::from_parts(omega_dot, omega, random.vector());
        let square = matrix_product(&underscore(omega), &underscore(omega));
        let literal = matrix_sum(&underscore(omega_dot), &square);
        let flat = |x: &[[T; 3]; 3]| x.as_flattened().to_vec();
        assert_within(flat(h.g()), flat(&literal), T::constant(2.0), 4.0);
        assert_within(h.omega_dot(), omega_dot, T::constant(3.0), 4.0);
        assert_within(
            flat(&h.omega_squared()),
            flat(&square),
            T::constant(3.0),
            4.0,
        );
    }
}

fn kinematic_matrices_change_frame<T: Real>() {
    let mut random = Random::new(35);
    for m in poses::<T>(35) {
        let (w, l) = (random.velocity(), random.screw());
        let h = Acceleration::from_parts(random.vector(), w.omega(), random.vector());
        let similar = |x| product(&product(&m.to_matrix(), &x), &m.inverse().to_matrix());
        let scale = T::constant(4.0) * size_of(&m.to_matrix());
        assert_same(
            &m.change_frame(&w).to_matrix(),
            &similar(w.to_matrix()),
            scale,
            16.0,
        );
        assert_same(
            &m.change_frame(&l).to_matrix(),
            &similar(l.to_matrix()),
            scale,
            16.0,
        );
        assert_same(
            &m.change_frame(&h).to_matrix(),
            &similar(h.to_matrix()),
            scale,
            16.0,
        );
    }
}

fn pole_moves_to_the_new_origin<T: Real>() {
    let mut random = Random::new(36);
    for m_r_s in poses::<T>(36) {
        // After (9): v of the new pole = R v₀ₛ − ω̲₍ᵣ₎ tᵣₛ.
        let w_in_s = random.velocity();
        let w_in_r = m_r_s.change_frame(&w_in_s);
        let carried = cross(w_in_r.omega(), m_r_s.translation());
        let expected = sub(turn(m_r_s.rotation(), w_in_s.v()), carried);
        assert_within(w_in_r.v(), expected, size_of(&m_r_s.to_matrix()), 16.0);
        assert_eq!(w_in_r.omega(), turn(m_r_s.rotation(), w_in_s.omega()));
    }
}

in_both_precisions! {
    velocity_of_points
    velocity_from_a_point
    acceleration_of_points
    acceleration_is_derivative_plus_square
    parts_of_the_acceleration_block
    kinematic_matrices_change_frame
    pole_moves_to_the_new_origin
}

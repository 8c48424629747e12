//! Pure translations, against the motion of every point of the body.
//!
//! § 2.2 to § 3.2 without rotation, and the pole of rotations: the smallest cases of every matrix, which
//! show wrong signs.

use crate::dense::{assert_same, assert_within};
use crate::jet::Jet;
use crate::sample::{Random, units};
use homogen::vector::{add, cross, identity, negate, product, scale, sub};
use homogen::{
    Acceleration, Action, Direction, Displacement, Momentum, Point, Pose, Real, Screw, Velocity,
};

/// Vectors, the zero vector and those along the axes among them.
fn shifts<T: Real>(seed: u64) -> Vec<[T; 3]> {
    let mut random = Random::new(seed);
    let mut list = vec![[T::constant(0.0); 3]];
    list.extend(units::<T>(seed));
    list.extend((0..50).map(|_| random.vector()));
    list
}

/// M of a translation adds t to every point, and nothing to directions.
fn points_move_by_the_vector<T: Real>() {
    let mut random = Random::new(220);
    for (t, other) in shifts::<T>(220).into_iter().zip(shifts(221)) {
        let m = Pose::from_translation(t);
        let p = random.vector();
        let one = T::constant(2.0);
        assert_within((m * Point(p)).0, add(p, t), one, 2.0);
        assert_eq!((m * Direction(p)).0, p);
        assert_eq!(m.inverse(), Pose::from_translation(negate(t)));
        assert_within((m.inverse() * Point(add(p, t))).0, p, one, 4.0);
        let both = Pose::from_translation(other) * m;
        assert_within((both * Point(p)).0, add(p, add(t, other)), one, 6.0);
        assert_eq!(*both.rotation(), identity());
    }
}

/// Q = exp(L s) of a prismatic pair: every point moves by s u in any frame; the logarithm gives L and s.
fn displacements_shift_every_point<T: Real>() {
    let mut random = Random::new(222);
    for u in units::<T>(222) {
        for s in [-1.5, 0.25, 1.0].map(T::constant) {
            let q = Screw::prismatic(u).exp(s);
            let p = random.vector();
            let shift = scale(s, u);
            let size = T::constant(4.0);
            assert_eq!(*q.rotation(), identity());
            assert_within((q * Point(p)).0, add(p, shift), size, 4.0);
            assert_eq!((q * Direction(p)).0, p);
            // Q₍ₖ₎ translates by the same vector in frame (k).
            let m_k_0 = random.pose::<T>();
            let seen = m_k_0.change_frame(&q);
            let expected = add(p, product(m_k_0.rotation(), shift));
            assert_within((seen * Point(p)).0, expected, size, 16.0);
            // Between two translated frames, Q maps the points of one to those of the other.
            let (a, b) = (random.vector(), random.vector());
            let [m_0_1, m_0_2] = [a, b].map(Pose::from_translation);
            let between = Displacement::between(&m_0_1, &m_0_2);
            assert_within((between * Point(p)).0, add(p, sub(b, a)), size, 8.0);
            let (l, length) = q.log();
            assert_eq!(l.u(), [T::constant(0.0); 3]);
            assert_within(scale(length, l.b()), shift, size, 4.0);
        }
    }
}

/// W = (0, v; 0, 0) and H = (0, a; 0, 0): all points have the same motion, by automatic derivatives of a point.
fn all_points_of_a_translating_body_have_the_same_motion<T: Real>() {
    let mut random = Random::new(223);
    for u in units::<T>(223) {
        let [s, rate, second]: [T; 3] = random.vector();
        let l = Screw::prismatic(u);
        let still = Screw::prismatic(u.map(Jet::still));
        let (w, h) = (l.velocity(rate), l.acceleration(rate, second));
        assert_eq!(w.omega(), [T::constant(0.0); 3]);
        assert_eq!(*h.g(), [[T::constant(0.0); 3]; 3]);
        for _ in 0..5 {
            let p = random.vector();
            let path = (still.exp(Jet(s, rate, second)) * Point(p.map(Jet::still))).0;
            let now = Point(path.map(|x| x.0));
            let one = T::constant(1.0);
            assert_within((w * now).0, path.map(|x| x.1), one, 4.0);
            assert_within((h * now).0, path.map(|x| x.2), one, 4.0);
            assert_within((w * now).0, scale(rate, u), one, 4.0);
            assert_within((h * now).0, scale(second, u), one, 4.0);
        }
    }
}

/// In a frame translated by t: the same directions, and another pole.
fn shifted_frames_move_the_pole_alone<T: Real>() {
    let mut random = Random::new(224);
    for t in shifts::<T>(224) {
        let m = Pose::from_translation(t);
        let (omega, v, p) = (random.vector(), random.vector(), random.vector::<T>());
        let size = T::constant(8.0);
        // A translating body has the same W and H at every pole.
        let zero = [T::constant(0.0); 3];
        let sliding = Velocity::new(zero, v);
        assert_eq!(m.change_frame(&sliding), sliding);
        let sliding = Acceleration::from_parts(zero, zero, v);
        assert_eq!(m.change_frame(&sliding), sliding);
        // For a rotating body, v₀ and a₀ are those of another point.
        let w = Velocity::new(omega, v);
        let seen = m.change_frame(&w);
        assert_eq!(seen.omega(), omega);
        assert_within(seen.v(), add(v, cross(omega, negate(t))), size, 4.0);
        let h = Acceleration::from_parts(p, omega, v);
        let pole = add(cross(p, negate(t)), cross(omega, cross(omega, negate(t))));
        let seen = m.change_frame(&h);
        assert_within(seen.a(), add(v, pole), size, 8.0);
        // The same force at the translated point, and the same for a particle.
        let moved = m.change_frame(&Action::of_force(v, p));
        let expected = Action::of_force(v, add(p, t));
        assert_same(&moved.to_matrix(), &expected.to_matrix(), size, 8.0);
        let moved = m.change_frame(&Momentum::of_particle(T::constant(2.0), p, v));
        let expected = Momentum::of_particle(T::constant(2.0), add(p, t), v);
        assert_same(&moved.to_matrix(), &expected.to_matrix(), size, 8.0);
    }
}

in_both_precisions! {
    points_move_by_the_vector
    displacements_shift_every_point
    all_points_of_a_translating_body_have_the_same_motion
    shifted_frames_move_the_pole_alone
}

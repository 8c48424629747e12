//! § 3.1 and § 3.3: W and H as derivatives of M(t), and the composition of relative motions.
//!
//! M₀₂(t) = exp(L₁ φ(t)) A exp(L₂ ψ(t)) B, with derivatives by a stencil of seven points: its
//! truncation and its rounding set the tolerances, which are therefore not in units.

use crate::dense::{Dense, assert_same, assert_within, combine, product, size_of};
use crate::sample::{Random, poses};
use homogen::{Acceleration, Pose, Real, Screw, Velocity};
use std::array::from_fn;

/// A motion of two joints: φ = a₀ + a₁ t + a₂ t² and ψ likewise.
struct Motion<T> {
    screws: [Screw<T>; 2],
    places: [Pose<T>; 2],
    coefficients: [[T; 3]; 2],
}

impl<T: Real> Motion<T> {
    fn random(random: &mut Random) -> Self {
        Self {
            screws: [random.screw(), random.screw()],
            places: [random.pose(), random.pose()],
            coefficients: [random.vector(), random.vector()],
        }
    }

    fn coordinate(&self, joint: usize, t: T) -> T {
        let [a, b, c] = self.coefficients[joint];
        a + b * t + c * t * t
    }

    /// M₀₁ and M₁₂ at t.
    fn poses(&self, t: T) -> [Pose<T>; 2] {
        from_fn(|i| self.screws[i].exp(self.coordinate(i, t)) * self.places[i])
    }

    /// W₀₁₍₀₎, H₀₁₍₀₎ and W₁₂₍₁₎, H₁₂₍₁₎ at t = 0.
    fn rates(&self) -> [(Velocity<T>, Acceleration<T>); 2] {
        from_fn(|i| {
            let [_, rate, half] = self.coefficients[i];
            let second = T::constant(2.0) * half;
            (
                self.screws[i].velocity(rate),
                self.screws[i].acceleration(rate, second),
            )
        })
    }
}

/// Ṁ and M̈ at t = 0, by central differences of sixth order.
fn derivatives<T: Real>(m: impl Fn(T) -> Pose<T>, step: T) -> (Dense<T>, Dense<T>) {
    let at = |k: f64| m(T::constant(k) * step).to_matrix();
    let pairs = [1.0, 2.0, 3.0].map(|k| (at(k), at(-k)));
    let mut first = [[T::constant(0.0); 4]; 4];
    let mut second = first;
    for ((plus, minus), (a, b)) in
        pairs
            .iter()
            .zip([(0.75, 1.5), (-0.15, -0.15), (1.0 / 60.0, 1.0 / 90.0)])
    {
        first = combine(1.0, &first, a, &combine(1.0, plus, -1.0, minus));
        let center = combine(1.0, plus, -1.0, &at(0.0));
        second = combine(
            1.0,
            &second,
            b,
            &combine(1.0, &center, 1.0, &combine(1.0, minus, -1.0, &at(0.0))),
        );
    }
    let inverse = T::constant(1.0) / step;
    (
        first.map(|r| r.map(|x| x * inverse)),
        second.map(|r| r.map(|x| x * inverse * inverse)),
    )
}

fn derivatives_of_the_pose<T: Real>(step: f64, tolerance: f64) {
    let mut random = Random::new(40);
    let units = tolerance / (T::EPSILON.to_f64() / 2.0);
    for _ in 0..50 {
        let motion = Motion::<T>::random(&mut random);
        let (m_dot, m_ddot) = derivatives(|t| motion.poses(t)[0], T::constant(step));
        let m = motion.poses(T::constant(0.0))[0];
        let [(w, h), _] = motion.rates();
        // Ṁ = W M and M̈ = H M; W = Ṁ M⁻¹ and H = M̈ M⁻¹.
        let scale = T::constant(8.0);
        assert_same(
            &m_dot,
            &product(&w.to_matrix(), &m.to_matrix()),
            scale,
            units,
        );
        assert_same(
            &m_ddot,
            &product(&h.to_matrix(), &m.to_matrix()),
            scale,
            units,
        );
        let inverse = m.inverse().to_matrix();
        assert_same(&product(&m_dot, &inverse), &w.to_matrix(), scale, units);
        assert_same(&product(&m_ddot, &inverse), &h.to_matrix(), scale, units);
    }
}

#[test]
fn derivatives_of_the_pose_f32() {
    derivatives_of_the_pose::<f32>(0.125, 3e-5);
}

#[test]
fn derivatives_of_the_pose_f64() {
    derivatives_of_the_pose::<f64>(0.01, 5e-12);
}

fn composed_motion<T: Real>(step: f64, tolerance: f64) {
    let mut random = Random::new(41);
    let units = tolerance / (T::EPSILON.to_f64() / 2.0);
    for _ in 0..50 {
        let motion = Motion::<T>::random(&mut random);
        let whole = |t: T| {
            let [m_0_1, m_1_2] = motion.poses(t);
            m_0_1 * m_1_2
        };
        let (m_dot, m_ddot) = derivatives(whole, T::constant(step));
        let zero = T::constant(0.0);
        let inverse = whole(zero).inverse().to_matrix();
        let [(w_0_1, h_0_1), (w_1_2, h_1_2)] = motion.rates();
        // Appendix A1: both in frame (0), then (10) and (11).
        let m_0_1 = motion.poses(zero)[0];
        let (w_1_2, h_1_2) = (m_0_1.change_frame(&w_1_2), m_0_1.change_frame(&h_1_2));
        let w_0_2 = w_0_1 + w_1_2;
        let h_0_2 = h_0_1.compose(&h_1_2, &w_0_1, &w_1_2);
        let scale = T::constant(32.0);
        assert_same(&product(&m_dot, &inverse), &w_0_2.to_matrix(), scale, units);
        assert_same(
            &product(&m_ddot, &inverse),
            &h_0_2.to_matrix(),
            scale,
            units,
        );
    }
}

#[test]
fn composed_motion_f32() {
    composed_motion::<f32>(0.125, 3e-5);
}

#[test]
fn composed_motion_f64() {
    composed_motion::<f64>(0.01, 5e-12);
}

fn composition_holds_in_any_frame<T: Real>() {
    let mut random = Random::new(42);
    for m in poses::<T>(42) {
        // (12), (13): composed and then seen from elsewhere, or the other way round.
        let (w_a, w_b) = (random.velocity(), random.velocity());
        let (h_a, h_b) = (
            Acceleration::from_parts(random.vector(), w_a.omega(), random.vector()),
            Acceleration::from_parts(random.vector(), w_b.omega(), random.vector()),
        );
        let scale = T::constant(16.0) * size_of(&m.to_matrix());
        let seen = m.change_frame(&w_a) + m.change_frame(&w_b);
        assert_same(
            &m.change_frame(&(w_a + w_b)).to_matrix(),
            &seen.to_matrix(),
            scale,
            16.0,
        );
        let seen = m.change_frame(&h_a).compose(
            &m.change_frame(&h_b),
            &m.change_frame(&w_a),
            &m.change_frame(&w_b),
        );
        let composed = h_a.compose(&h_b, &w_a, &w_b);
        assert_same(
            &m.change_frame(&composed).to_matrix(),
            &seen.to_matrix(),
            scale,
            16.0,
        );
    }
}

fn coriolis_term_is_twice_the_product<T: Real>() {
    let mut random = Random::new(43);
    for _ in 0..50 {
        let (w_a, w_b) = (random.velocity::<T>(), random.velocity());
        let literal = product(&w_a.to_matrix(), &w_b.to_matrix());
        let twice = combine(2.0, &literal, 0.0, &literal);
        let found = Acceleration::coriolis(&w_a, &w_b);
        assert_same(&found.to_matrix(), &twice, T::constant(1.0), 8.0);
        let composed = Acceleration::zero().compose(&Acceleration::zero(), &w_a, &w_b);
        assert_same(&composed.to_matrix(), &twice, T::constant(1.0), 8.0);
    }
}

fn relative_velocities_invert<T: Real>() {
    let mut random = Random::new(44);
    for _ in 0..50 {
        let (a, b) = (random.velocity::<T>(), random.velocity());
        let back = (a + b) - b;
        assert_within(back.omega(), a.omega(), T::constant(2.0), 2.0);
        assert_within(back.v(), a.v(), T::constant(2.0), 2.0);
        assert_eq!(-a + a, Velocity::zero());
    }
}

in_both_precisions! {
    composition_holds_in_any_frame
    coriolis_term_is_twice_the_product
    relative_velocities_invert
}

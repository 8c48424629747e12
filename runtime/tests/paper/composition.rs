//! § 3.1 and § 3.3: W and H as derivatives of M(t), and the composition of relative motions.
//!
//! M₀₂(t) = exp(L₁ φ(t)) A exp(L₂ ψ(t)) B, with automatic derivatives with respect to t.

use crate::dense::{Dense, assert_same, assert_within, combine, product, size_of};
use crate::jet::Jet;
use crate::sample::{Random, poses};
use homogen::{Acceleration, Pose, Real, Screw, Velocity};
use std::array::from_fn;

/// A motion of two joints: φ, φ̇ and φ̈ at an instant, and the same for ψ.
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

    /// M₀₁ and M₁₂ with their derivatives.
    fn poses(&self) -> [Pose<Jet<T>>; 2] {
        from_fn(|i| {
            let [at, rate, second] = self.coefficients[i];
            let (l, m) = (&self.screws[i], &self.places[i]);
            let still = Screw::new(l.u().map(Jet::still), l.b().map(Jet::still));
            let place = Pose::new(
                m.rotation().map(|row| row.map(Jet::still)),
                m.translation().map(Jet::still),
            );
            still.exp(Jet(at, rate, second)) * place
        })
    }

    /// W₀₁₍₀₎, H₀₁₍₀₎ and W₁₂₍₁₎, H₁₂₍₁₎.
    fn rates(&self) -> [(Velocity<T>, Acceleration<T>); 2] {
        from_fn(|i| {
            let [_, rate, second] = self.coefficients[i];
            (
                self.screws[i].velocity(rate),
                self.screws[i].acceleration(rate, second),
            )
        })
    }
}

/// M, Ṁ and M̈ of a pose of jets.
fn derivatives<T: Real>(m: &Pose<Jet<T>>) -> [Dense<T>; 3] {
    let part = |part: fn(Jet<T>) -> T| m.to_matrix().map(|row| row.map(part));
    [part(|x| x.0), part(|x| x.1), part(|x| x.2)]
}

fn derivatives_of_the_pose<T: Real>() {
    let mut random = Random::new(40);
    for _ in 0..50 {
        let motion = Motion::<T>::random(&mut random);
        let [m_0_1, _] = motion.poses();
        let [m, m_dot, m_ddot] = derivatives(&m_0_1);
        let [(w, h), _] = motion.rates();
        // Ṁ = W M and M̈ = H M; W = Ṁ M⁻¹ and H = M̈ M⁻¹.
        let scale = T::constant(8.0);
        let (w, h) = (w.to_matrix(), h.to_matrix());
        assert_same(&m_dot, &product(&w, &m), scale, 8.0);
        assert_same(&m_ddot, &product(&h, &m), scale, 8.0);
        let [inverse, ..] = derivatives(&m_0_1.inverse());
        assert_same(&product(&m_dot, &inverse), &w, scale, 8.0);
        assert_same(&product(&m_ddot, &inverse), &h, scale, 8.0);
    }
}

fn composed_motion<T: Real>() {
    let mut random = Random::new(41);
    for _ in 0..50 {
        let motion = Motion::<T>::random(&mut random);
        let [m_0_1, m_1_2] = motion.poses();
        let m_0_2 = m_0_1 * m_1_2;
        let ([_, m_dot, m_ddot], [inverse, ..]) =
            (derivatives(&m_0_2), derivatives(&m_0_2.inverse()));
        let [(w_0_1, h_0_1), (w_1_2, h_1_2)] = motion.rates();
        // Appendix A1: both in frame (0), then (10) and (11).
        let now = Pose::new(
            m_0_1.rotation().map(|row| row.map(|x| x.0)),
            m_0_1.translation().map(|x| x.0),
        );
        let (w_1_2, h_1_2) = (now.change_frame(&w_1_2), now.change_frame(&h_1_2));
        let w_0_2 = w_0_1 + w_1_2;
        let h_0_2 = h_0_1.compose(&h_1_2, &w_0_1, &w_1_2);
        let scale = T::constant(32.0);
        assert_same(&product(&m_dot, &inverse), &w_0_2.to_matrix(), scale, 8.0);
        assert_same(&product(&m_ddot, &inverse), &h_0_2.to_matrix(), scale, 8.0);
    }
}

fn composition_holds_in_any_frame<T: Real>() {
    let mut random = Random::new(42);
    for m in poses::<T>(42) {
        // (12), (13): composition and change of frame commute.
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
    derivatives_of_the_pose
    composed_motion
    composition_holds_in_any_frame
    coriolis_term_is_twice_the_product
    relative_velocities_invert
}

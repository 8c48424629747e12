//! § 4.1 to § 4.3 and appendix A2, A3: the integrals that define Φ, Γ and J, as sums over particles.

use crate::dense::{Dense, assert_same, combine, product, size_of, transpose};
use crate::sample::Random;
use homogen::{Acceleration, Action, Inertia, Momentum, Point, Pose, Real, Velocity};

const PARTICLES: usize = 2000;

/// A moving body of many particles.
struct Cloud<T> {
    particles: Vec<(T, [T; 3])>,
    w: Velocity<T>,
    h: Acceleration<T>,
}

impl<T: Real> Cloud<T> {
    fn random(random: &mut Random) -> Self {
        let w = random.velocity();
        Self {
            particles: (0..PARTICLES)
                .map(|_| (random.positive(), random.vector()))
                .collect(),
            w,
            h: Acceleration::from_parts(random.vector(), w.omega(), random.vector()),
        }
    }

    fn inertia(&self) -> Inertia<T> {
        self.particles.iter().fold(Inertia::zero(), |j, (m, p)| {
            j + Inertia::of_particle(*m, *p)
        })
    }

    /// Σ (X Pᵗ − P Xᵗ) dm, or Σ P Pᵗ dm without X.
    fn integral(&self, x: impl Fn([T; 3]) -> Option<[T; 4]>) -> Dense<T> {
        let mut sum = [[T::constant(0.0); 4]; 4];
        for (m, p) in &self.particles {
            let p4 = Point(*p).to_homogeneous();
            let left = x(*p).unwrap_or(p4);
            let dyad: Dense<T> =
                std::array::from_fn(|i| std::array::from_fn(|j| left[i] * p4[j] * *m));
            let term = match x(*p) {
                Some(_) => combine(1.0, &dyad, -1.0, &transpose(&dyad)),
                None => dyad,
            };
            sum = combine(1.0, &sum, 1.0, &term);
        }
        sum
    }
}

/// Tolerance of a sum in units of rounding: its bound is the number of terms, its usual error the root of that.
const UNITS: f64 = 200.0;

fn inertia_is_the_sum_over_particles<T: Real>() {
    let mut random = Random::new(60);
    for _ in 0..4 {
        let cloud = Cloud::<T>::random(&mut random);
        let literal = cloud.integral(|_| None);
        assert_same(
            &cloud.inertia().to_matrix(),
            &literal,
            T::constant(1.0),
            UNITS,
        );
    }
}

fn momentum_is_the_sum_over_particles<T: Real>() {
    let mut random = Random::new(61);
    for _ in 0..4 {
        let cloud = Cloud::<T>::random(&mut random);
        let j = cloud.inertia();
        let literal = cloud.integral(|p| Some((cloud.w * Point(p)).to_homogeneous()));
        let scale = size_of(&j.to_matrix());
        assert_same(&j.momentum(&cloud.w).to_matrix(), &literal, scale, UNITS);
        let sum = cloud
            .particles
            .iter()
            .fold(Momentum::zero(), |sum, (m, p)| {
                sum + Momentum::of_particle(*m, *p, (cloud.w * Point(*p)).0)
            });
        assert_same(&sum.to_matrix(), &literal, scale, UNITS);
    }
}

fn action_is_the_sum_over_particles<T: Real>() {
    let mut random = Random::new(62);
    for _ in 0..4 {
        let cloud = Cloud::<T>::random(&mut random);
        let j = cloud.inertia();
        // dF = P̈ dm.
        let literal = cloud.integral(|p| Some((cloud.h * Point(p)).to_homogeneous()));
        let scale = T::constant(2.0) * size_of(&j.to_matrix());
        assert_same(&j.action(&cloud.h).to_matrix(), &literal, scale, UNITS);
        let sum = cloud.particles.iter().fold(Action::zero(), |sum, (m, p)| {
            let force = (cloud.h * Point(*p)).scaled(*m).0;
            sum + Action::of_force(force, *p)
        });
        assert_same(&sum.to_matrix(), &literal, scale, UNITS);
    }
}

fn kinetic_energy_is_the_sum_over_particles<T: Real>() {
    let mut random = Random::new(63);
    for _ in 0..4 {
        let cloud = Cloud::<T>::random(&mut random);
        // (23)
        let sum = cloud
            .particles
            .iter()
            .fold(T::constant(0.0), |sum, (m, p)| {
                let v = (cloud.w * Point(*p)).0;
                sum + T::constant(0.5) * *m * homogen::vector::dot(v, v)
            });
        let found = cloud.inertia().kinetic_energy(&cloud.w);
        crate::dense::assert_within([found], [sum], sum, UNITS);
    }
}

fn inertia_of_moved_particles<T: Real>() {
    let mut random = Random::new(64);
    for _ in 0..4 {
        // Appendix A3.
        let cloud = Cloud::<T>::random(&mut random);
        let m_r_s: Pose<T> = random.pose();
        let moved = cloud.particles.iter().fold(Inertia::zero(), |j, (m, p)| {
            j + Inertia::of_particle(*m, (m_r_s * Point(*p)).0)
        });
        let j = m_r_s.change_frame(&cloud.inertia()).to_matrix();
        assert_same(
            &j,
            &moved.to_matrix(),
            T::constant(2.0) * size_of(&moved.to_matrix()),
            UNITS,
        );
        let dense = m_r_s.to_matrix();
        let literal = product(
            &product(&dense, &cloud.inertia().to_matrix()),
            &transpose(&dense),
        );
        assert_same(&j, &literal, T::constant(2.0) * size_of(&literal), 16.0);
    }
}

in_both_precisions! {
    inertia_is_the_sum_over_particles
    momentum_is_the_sum_over_particles
    action_is_the_sum_over_particles
    kinetic_energy_is_the_sum_over_particles
    inertia_of_moved_particles
}

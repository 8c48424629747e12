//! Inputs: random ones from a fixed seed, and degenerate ones.
//!
//! Random numbers have 24 bits, so that they are the same number in f32 and in f64.

use homogen::{Displacement, Inertia, Pose, Real, Screw, Velocity, rotation, vector};
use std::array::from_fn;
use std::vec::Vec;

/// Random numbers, vectors and matrices.
pub struct Random(homogen_random::Random);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(homogen_random::Random::new(seed))
    }

    /// In (−1, 1), and never zero.
    pub fn number<T: Real>(&mut self) -> T {
        T::constant(self.0.odd())
    }

    /// In (0, 1).
    pub fn positive<T: Real>(&mut self) -> T {
        self.number::<T>().abs()
    }

    pub fn index(&mut self, below: usize) -> usize {
        self.0.below(below)
    }

    pub fn vector<T: Real>(&mut self) -> [T; 3] {
        from_fn(|_| self.number())
    }

    pub fn unit<T: Real>(&mut self) -> [T; 3] {
        loop {
            let v = self.vector();
            if vector::dot(v, v) > T::constant(0.01) {
                return vector::unit(v).expect("not zero");
            }
        }
    }

    pub fn rotation<T: Real>(&mut self) -> [[T; 3]; 3] {
        let angle = self.number::<T>() * T::constant(3.2);
        rotation::from_axis_angle(self.unit(), angle)
    }

    pub fn pose<T: Real>(&mut self) -> Pose<T> {
        Pose::new(self.rotation(), self.vector())
    }

    pub fn screw<T: Real>(&mut self) -> Screw<T> {
        Screw::helical(self.unit(), self.vector(), self.number())
    }

    pub fn velocity<T: Real>(&mut self) -> Velocity<T> {
        Velocity::new(self.vector(), self.vector())
    }

    /// A body of several particles.
    pub fn inertia<T: Real>(&mut self) -> Inertia<T> {
        (0..6).fold(Inertia::zero(), |j, _| {
            j + Inertia::of_particle(self.positive(), self.vector())
        })
    }
}

/// Unit vectors: the axes, in planes, in all octants, close to an axis, and random.
pub fn units<T: Real>(seed: u64) -> Vec<[T; 3]> {
    let mut random = Random::new(seed);
    let mut list = Vec::new();
    let levels = [-1.0, 0.0, 1.0];
    for x in levels {
        for y in levels {
            for z in levels {
                if let Some(u) = vector::unit([x, y, z].map(T::constant)) {
                    list.push(u);
                }
            }
        }
    }
    list.push([1e-9, 1.0, -1e-9].map(T::constant));
    list.push([-1.0, 1e-30, 0.0].map(T::constant));
    list.extend((0..20).map(|_| random.unit()));
    list
}

/// Angles: zero, tiny, small, right, near and at π and 2π, beyond, of both signs.
pub fn angles<T: Real>() -> Vec<T> {
    let pi = std::f64::consts::PI;
    let list = [
        0.0,
        1e-300,
        1e-30,
        1e-12,
        1e-8,
        1e-5,
        1e-3,
        0.1,
        0.7,
        1.5,
        pi / 2.0,
        2.0,
        3.0,
        pi - 1e-3,
        pi - 1e-6,
        pi - 1e-12,
        pi,
        4.0,
        2.0 * pi,
        7.0,
    ];
    list.iter()
        .flat_map(|x| [T::constant(*x), T::constant(-*x)])
        .collect()
}

/// Poses: the identity, pure translations, rotations by 90° and 180°, far and near, and random.
pub fn poses<T: Real>(seed: u64) -> Vec<Pose<T>> {
    let mut random = Random::new(seed);
    let mut list = vec![Pose::identity(), Pose::from_translation(random.vector())];
    for u in units(seed).into_iter().step_by(5) {
        for angle in [
            0.0,
            1e-9,
            1.0,
            std::f64::consts::FRAC_PI_2,
            std::f64::consts::PI,
        ] {
            for reach in [0.0, 1.0, 100.0] {
                list.push(Pose::new(
                    rotation::from_axis_angle(u, T::constant(angle)),
                    vector::scale(T::constant(reach), random.vector()),
                ));
            }
        }
    }
    list.extend((0..50).map(|_| random.pose()));
    list
}

/// Displacements along all screws by all angles.
pub fn displacements<T: Real>(seed: u64) -> Vec<Displacement<T>> {
    poses(seed)
        .into_iter()
        .map(Displacement::from_relative_pose)
        .collect()
}

/// Velocities: rest, pure translation, pure rotation, slow, and random.
pub fn velocities<T: Real>(seed: u64) -> Vec<Velocity<T>> {
    let mut random = Random::new(seed);
    let zero = [T::constant(0.0); 3];
    let tiny = |v: [T; 3]| vector::scale(T::constant(1e-12), v);
    let mut list = vec![
        Velocity::zero(),
        Velocity::new(zero, random.vector()),
        Velocity::new(random.vector(), zero),
        Velocity::new(tiny(random.vector()), random.vector()),
        Velocity::new(random.vector(), tiny(random.vector())),
    ];
    list.extend((0..50).map(|_| random.velocity()));
    list
}

/// Inertias: no mass, a particle, a rod, a plate, a long thin body, far away, and random.
pub fn inertias<T: Real>(seed: u64) -> Vec<Inertia<T>> {
    let mut random = Random::new(seed);
    let particle = |m: f64, p: [f64; 3]| Inertia::of_particle(T::constant(m), p.map(T::constant));
    let rod = particle(1.0, [1.0, 0.0, 0.0]) + particle(1.0, [-1.0, 0.0, 0.0]);
    let plate = rod + particle(2.0, [0.0, 0.5, 0.0]) + particle(2.0, [0.0, -0.5, 0.0]);
    let mut list = vec![
        Inertia::zero(),
        particle(2.0, [0.0; 3]),
        particle(2.0, [0.3, -0.2, 0.9]),
        rod,
        plate,
        rod + particle(1e-6, [0.0, 0.0, 1.0]),
        Pose::from_translation([100.0, 0.0, -50.0].map(T::constant)).change_frame(&plate),
        random.pose().change_frame(&rod),
        random.pose().change_frame(&plate),
    ];
    list.extend((0..30).map(|_| random.inertia()));
    list
}

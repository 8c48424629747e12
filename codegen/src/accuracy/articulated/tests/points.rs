//! Chains of random points of mass, as twists and inertias of six numbers about one origin.
//!
//! In: seeds. Out: their articulated inertias, by Schur complements, their sizes γ and s, and bounds of their
//! motion. It shares nothing with the engine.

pub(super) type Twist = [f64; 6];
pub(super) type Inertia = [Twist; 6];

/// Random numbers, and vectors of them.
pub(super) struct Random(homogen_random::Random);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(homogen_random::Random::new(seed))
    }

    /// In [−1, 1).
    pub(super) fn unit(&mut self) -> f64 {
        self.0.unit()
    }

    pub(super) fn vector(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.unit())
    }

    pub(super) fn direction(&mut self) -> [f64; 3] {
        let vector = self.vector();
        let length = norm(&vector);
        vector.map(|entry| entry / length)
    }
}

pub(super) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub(super) fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

pub(super) fn twist([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> Twist {
    [x, y, z, u, v, w]
}

/// ω, and the velocity of a point.
pub(super) fn at([x, y, z, u, v, w]: Twist, point: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let omega = [x, y, z];
    let [a, b, c] = cross(omega, point);
    (omega, [u + a, v + b, w + c])
}

pub(super) fn times(inertia: &Inertia, x: &Twist) -> Twist {
    inertia.map(|row| dot(&row, x))
}

/// The inertia with something added to each entry.
pub(super) fn plus(inertia: &Inertia, entry: impl Fn(usize, usize) -> f64) -> Inertia {
    std::array::from_fn(|i| std::array::from_fn(|j| inertia[i][j] + entry(i, j)))
}

/// The articulated inertia that is passed on inwards: I − I S Sᵀ I / D.
pub(super) fn left(inertia: &Inertia, screw: &Twist) -> Inertia {
    let u = times(inertia, screw);
    let d = dot(&u, screw);
    plus(inertia, |i, j| -u[i] * u[j] / d)
}

/// Some points of mass, in a chain of bodies, body 0 first.
pub(super) struct Chain {
    pub(super) bodies: Vec<Body>,
}

pub(super) struct Body {
    pub(super) screw: Twist,
    /// A point on its axis.
    pub(super) origin: [f64; 3],
    /// γ and s of it with all bodies outboard of it.
    pub(super) sizes: [f64; 2],
    pub(super) inertia: Inertia,
}

impl Chain {
    pub(super) fn new(random: &mut Random, count: usize) -> Self {
        let mut outboard: Vec<([f64; 3], f64)> = Vec::new();
        let mut bodies: Vec<Body> = Vec::new();
        for _ in 0..count {
            let axis = random.direction();
            let origin = random.vector();
            let translates = random.unit() > 0.5;
            // Some are thin, and some much heavier than others.
            let (along, thin) = (random.direction(), random.unit().abs().powi(4));
            let heavy = 10.0_f64.powf(2.0 * random.unit());
            let points = 2 + usize::from(random.unit() > 0.0);
            let own: Vec<([f64; 3], f64)> = (0..points)
                .map(|_| {
                    let (off, far) = (random.vector(), random.unit());
                    let point = std::array::from_fn(|k| origin[k] + far * along[k] + thin * off[k]);
                    (point, heavy * (0.1 + random.unit().abs()))
                })
                .collect();
            let inertia = own.iter().fold([[0.0; 6]; 6], |sum, (point, mass)| {
                let speeds: [[f64; 3]; 6] = std::array::from_fn(|k| {
                    let mut x = [0.0; 6];
                    x[k] = 1.0;
                    at(x, *point).1
                });
                plus(&sum, |i, j| mass * dot(&speeds[i], &speeds[j]))
            });
            outboard.extend(own);
            let (mut angular, mut linear) = (0.0, 0.0);
            for (point, mass) in &outboard {
                let arm: [f64; 3] = std::array::from_fn(|k| point[k] - origin[k]);
                angular += mass * dot(&arm, &arm);
                linear += mass;
            }
            let screw = if translates {
                twist([0.0; 3], axis)
            } else {
                twist(axis, cross(origin, axis))
            };
            bodies.push(Body {
                screw,
                origin,
                sizes: [angular.sqrt(), linear.sqrt()],
                inertia,
            });
        }
        bodies.reverse();
        Self { bodies }
    }

    /// The articulated inertia of each body, with an error added to its own inertia.
    pub(super) fn articulated(&self, off: impl Fn(usize) -> Inertia) -> Vec<Inertia> {
        let mut all = vec![[[0.0; 6]; 6]; self.bodies.len()];
        let mut passed = [[0.0; 6]; 6];
        for (k, body) in self.bodies.iter().enumerate().rev() {
            let off = off(k);
            all[k] = plus(&body.inertia, |i, j| passed[i][j] + off[i][j]);
            passed = left(&all[k], &body.screw);
        }
        all
    }

    /// The inverse of the mass matrix, by elimination.
    pub(super) fn inverse(&self) -> Vec<Vec<f64>> {
        let count = self.bodies.len();
        let mut inverse: Vec<Vec<f64>> = (0..count)
            .map(|i| {
                let entries = (0..count).map(|j| {
                    let outboard = self.bodies[i.max(j)..].iter();
                    let of = outboard.map(|body| {
                        let action = times(&body.inertia, &self.bodies[j].screw);
                        dot(&self.bodies[i].screw, &action)
                    });
                    of.sum()
                });
                let unit = (0..count).map(|j| f64::from(u8::from(i == j)));
                entries.chain(unit).collect()
            })
            .collect();
        for k in 0..count {
            let pivot = inverse[k][k];
            let row: Vec<f64> = inverse[k].iter().map(|entry| entry / pivot).collect();
            for (i, other) in inverse.iter_mut().enumerate() {
                let factor = if i == k { 0.0 } else { other[k] };
                for (entry, of_row) in other.iter_mut().zip(&row) {
                    *entry -= factor * of_row;
                }
            }
            inverse[k] = row;
        }
        for row in &mut inverse {
            row.drain(..count);
        }
        inverse
    }

    /// For each body a bound of ω² and of the velocity² of its origin at the kinetic energy ½: the traces
    /// of J M⁻¹ Jᵗ, where joints share rotation and translation in proportion to M⁻¹.
    pub(super) fn mobility(&self) -> Vec<[f64; 2]> {
        let inverse = self.inverse();
        let bodies = self.bodies.iter().enumerate();
        bodies
            .map(|(k, body)| {
                let moved: Vec<_> = (0..=k)
                    .map(|i| at(self.bodies[i].screw, body.origin))
                    .collect();
                let mut sums = [0.0; 2];
                for (i, (rotation, translation)) in moved.iter().enumerate() {
                    for (j, (other_rotation, other_translation)) in moved.iter().enumerate() {
                        let share = inverse[i][j];
                        sums[0] += share * dot(rotation, other_rotation);
                        sums[1] += share * dot(translation, other_translation);
                    }
                }
                sums
            })
            .collect()
    }
}

impl Body {
    /// γ|ω| + s|v|.
    pub(super) fn g(&self, x: Twist) -> f64 {
        let (omega, v) = at(x, self.origin);
        self.sizes[0] * norm(&omega) + self.sizes[1] * norm(&v)
    }

    /// An inertia, moved to the body's origin.
    pub(super) fn about(&self, inertia: &Inertia) -> Inertia {
        let unit: [Twist; 6] = std::array::from_fn(|k| {
            let mut axis = [0.0; 3];
            axis[k % 3] = 1.0;
            if k < 3 {
                twist(axis, cross(self.origin, axis))
            } else {
                twist([0.0; 3], axis)
            }
        });
        std::array::from_fn(|i| std::array::from_fn(|j| dot(&unit[i], &times(inertia, &unit[j]))))
    }

    /// Its blocks A, B, M, as Frobenius norms.
    pub(super) fn blocks(&self, inertia: &Inertia) -> [f64; 3] {
        let about = self.about(inertia);
        [(0, 0), (0, 3), (3, 3)].map(|(row, column)| {
            let rows = about[row..row + 3].iter();
            norm(
                &rows
                    .flat_map(|row| row[column..column + 3].to_vec())
                    .collect::<Vec<f64>>(),
            )
        })
    }
}

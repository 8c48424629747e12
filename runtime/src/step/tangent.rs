//! Derivatives of configurations that are moved by a step of velocities.
//!
//! In: the step x = q̇ Δt of each joint, and changes of the configuration before it and of x. Out: the change after it,
//! along velocities. A joint along a screw adds both. For a planar, spherical or floating joint with the displacement
//! exp x̲ = (R, t; 0, 1), x = (v, ω) in the axes of the body, with s = Rᵗ t:
//!
//! * ω: Rᵗ δω + E δx_ω,
//! * v: Rᵗ δv − s × Rᵗ δω + E δx_v + F δx_ω,
//!
//! where E(ω) = 1 − a ω̲ + c ω̲² is the right Jacobian of the rotation, a = (1 − cos φ)/φ², c = (φ − sin φ)/φ³, and
//! F = −a v̲ + c (ω̲ v̲ + v̲ ω̲) + (ω·v) (e ω̲² − d ω̲) its derivative along v, with d = (sin φ/φ − 2 a)/φ² and
//! e = (a − 3 c)/φ². Near φ = 0, d and e lose digits, but are multiplied by powers of ω that vanish faster.

use crate::matrix::vector::{
    add, cross, dot, identity, matrix_product, matrix_scale, matrix_sum, product, sub, transpose,
    underscore,
};
use crate::robot::joint::Motion;
use crate::robot::manifold::angle;
use crate::robot::step::ranges;
use crate::scalar::Scalar;
use crate::scalar::rounding::{Rounding, Unfused};

/// Replaces changes of a configuration, a row for each velocity, by those after a step with changes of its own.
pub(super) fn moved<const N: usize, T: Scalar>(
    motions: &[Motion],
    step: &[T; N],
    mut of_q: [&mut [[T; N]; N]; 3],
    of_step: [&[[T; N]; N]; 3],
) {
    for (motion, _, own) in ranges(motions.iter().copied()) {
        let Some(x) = step.get(own.clone()) else {
            continue;
        };
        let rows = of_q.iter_mut().zip(of_step);
        let rows = rows.filter_map(|(q, x)| Some((q.get_mut(own.clone())?, x.get(own.clone())?)));
        match (motion, x) {
            (Motion::Planar, &[vx, vy, wz]) => {
                let zero = T::constant(0.0);
                let change = Change::of([zero, zero, wz], [vx, vy, zero]);
                rows.for_each(|(q, x)| {
                    each_column(q, x, |[vx, vy, wz]: [T; 3], [sx, sy, sw]| {
                        let q = ([zero, zero, wz], [vx, vy, zero]);
                        let ([.., wz], [vx, vy, _]) =
                            change.after(q, ([zero, zero, sw], [sx, sy, zero]));
                        [vx, vy, wz]
                    });
                });
            }
            (Motion::Spherical, &[x, y, z]) => {
                let none = [T::constant(0.0); 3];
                let change = Change::of([x, y, z], none);
                rows.for_each(|(q, x)| {
                    each_column(q, x, |q: [T; 3], x| change.after((q, none), (x, none)).0);
                });
            }
            (Motion::Floating, &[vx, vy, vz, wx, wy, wz]) => {
                let change = Change::of([wx, wy, wz], [vx, vy, vz]);
                rows.for_each(|(q, x)| {
                    let halves = |[vx, vy, vz, wx, wy, wz]: [T; 6]| ([wx, wy, wz], [vx, vy, vz]);
                    each_column(q, x, |q, x| {
                        let ([wx, wy, wz], [vx, vy, vz]) = change.after(halves(q), halves(x));
                        [vx, vy, vz, wx, wy, wz]
                    });
                });
            }
            _ => rows.for_each(|(q, x)| {
                each_column(q, x, |[q]: [T; 1], [x]| [q + x]);
            }),
        }
    }
}

/// Replaces each column of some rows.
fn each_column<const M: usize, const N: usize, T: Scalar>(
    rows: &mut [[T; N]],
    of_step: &[[T; N]],
    after: impl Fn([T; M], [T; M]) -> [T; M],
) {
    let (Ok(rows), Ok(of_step)) = (
        <&mut [[T; N]; M]>::try_from(rows),
        <&[[T; N]; M]>::try_from(of_step),
    ) else {
        return;
    };
    for column in 0..N {
        let found = after(rows.map(|row| row[column]), of_step.map(|row| row[column]));
        for (row, entry) in rows.iter_mut().zip(found) {
            row[column] = entry;
        }
    }
}

/// The change of a body's displacement, from those of the displacement before a step and of the step.
struct Change<T> {
    /// Rᵗ.
    back: [[T; 3]; 3],
    /// s.
    shift: [T; 3],
    /// E.
    e: [[T; 3]; 3],
    /// F.
    f: [[T; 3]; 3],
}

/// Angular before linear.
type Pair<T> = ([T; 3], [T; 3]);

impl<T: Scalar> Change<T> {
    fn of(omega: [T; 3], v: [T; 3]) -> Self {
        let number = T::constant;
        let angle = angle(omega);
        let square = angle * angle;
        let ([sine, half_sine], [_, half_cosine]) =
            Unfused::sin_cos_all([angle, number(0.5) * angle]);
        let ratio = half_sine / angle;
        // a, c, and sin φ/φ.
        let bend = number(2.0) * ratio * ratio;
        let bulge = angle.minus_sine(sine) / (square * angle);
        let turn = number(2.0) * ratio * half_cosine;
        let of_turn = (turn - number(2.0) * bend) / square;
        let of_bulge = (bend - number(3.0) * bulge) / square;
        let [w, along] = [omega, v].map(underscore);
        let twice = matrix_product(&w, &w);
        let both = matrix_product(&w, &along);
        // v̲ ω̲ is the transpose of ω̲ v̲.
        let both = matrix_sum(&both, &transpose(&both));
        let sum =
            |a: &[[T; 3]; 3], factor: T, b: &[[T; 3]; 3]| matrix_sum(a, &matrix_scale(factor, b));
        let share = dot(omega, v);
        let f = matrix_sum(&matrix_scale(-bend, &along), &matrix_scale(bulge, &both));
        let e = sum(&sum(&identity(), -bend, &w), bulge, &twice);
        Self {
            back: sum(&sum(&identity(), -turn, &w), bend, &twice),
            shift: product(&e, v),
            e,
            f: sum(&sum(&f, share * of_bulge, &twice), -(share * of_turn), &w),
        }
    }

    fn after(&self, (omega, v): Pair<T>, (x_omega, x_v): Pair<T>) -> Pair<T> {
        let turned = product(&self.back, omega);
        let own = sub(product(&self.back, v), cross(self.shift, turned));
        let of_step = add(product(&self.e, x_v), product(&self.f, x_omega));
        (add(turned, product(&self.e, x_omega)), add(own, of_step))
    }
}

//! Arms at and near singular configurations: two wrist axes in one line, a straight elbow.
//!
//! In: configurations. Out: errors of the generated Jacobians, and residuals of solutions of A q̇ = W with the exact
//! matrix, plain and damped.

use std::array::from_fn;
use std::iter::once;

use homogen::loop_closure::{ClosedChain, velocity};
use homogen::robot::{BodyJacobian, GeometricJacobian, SpatialJacobian};
use homogen::{Chain, Inertia, Jacobian, Joint, Pose, Screw};
use homogen_robots::shipped::{PandaClass, Puma560};
use homogen_tests::big::Big;
use homogen_tests::states::Random;
use homogen_tests::tested::{Fused32, Fused64};
use nalgebra::{RealField, SMatrix, SVector};

use crate::hard_cases_geometry::exact::{add, cross, exact, nearest_matrix, norm};
use crate::hard_cases_geometry::exact_arm::{Column, ExactArm, at, reach};
use crate::hard_cases_geometry::measure::{Number, direction, hold, size, units, vector};
use crate::hard_cases_geometry::worst::{DAMPED, PANDA, PUMA};

/// A singularity of an arm: joint `bent` at the angle `singular`.
struct Bent {
    bent: usize,
    singular: f64,
}

impl Bent {
    fn configurations<T: Number, const N: usize>(&self, seed: u64, count: u32) -> Vec<[T; N]> {
        let mut random = Random::new(seed);
        let configuration = |k| {
            let mut q = from_fn(|_| T::constant(3.0 * random.unit()));
            let away = match k % 5 {
                0 => T::constant(0.0),
                1 => T::MIN_POSITIVE * T::constant(random.unit()),
                _ => size(&mut random, -15.0, -2.0),
            };
            q[self.bent] = T::constant(self.singular) + away;
            q
        };
        (0..count).map(configuration).collect()
    }
}

/// The worst entry of the three Jacobians, in u, relative to 1 for axes and to the arm's size for lengths.
fn entries<R, T: Number, const N: usize>(robot: &R, q: &[T; N], exact: &ExactArm, reach: f64) -> f64
where
    R: SpatialJacobian<N, T> + GeometricJacobian<N, T> + BodyJacobian<N, T>,
{
    let pairs = [
        (robot.spatial_jacobian(q), &exact.spatial),
        (robot.geometric_jacobian(q), &exact.geometric),
        (robot.body_jacobian(q), &exact.body),
    ];
    let reach = Big::new(reach);
    let mut worst = 0.0_f64;
    for (found, exact) in pairs {
        for (screw, [u, b]) in found.iter().zip(exact) {
            for i in 0..3 {
                worst = worst.max(units(screw.u()[i], &u[i], &Big::one()));
                worst = worst.max(units(screw.b()[i], &b[i], &reach));
            }
        }
    }
    worst
}

/// The arm on a base that moves along a screw.
fn on_a_moving_base<const N: usize, const M: usize, const F: usize>(
    chain: &Chain<N, F>,
    screw: Screw<f64>,
) -> Chain<M, 1> {
    let base = Joint::new("base", None, Pose::identity(), screw, Inertia::zero());
    let joints = from_fn(|k| {
        let Some(k) = k.checked_sub(1) else {
            return base;
        };
        let joint = chain.joints[k];
        let parent = Some(joint.parent.map_or(0, |parent| parent + 1));
        Joint { parent, ..joint }
    });
    let mut tip = chain.tip();
    tip.body = tip.body.map(|body| body + 1);
    Chain::new(joints, [tip], chain.gravity)
}

/// The rates that keep the end effector at rest while the base moves. With full rank: its remaining velocity, in u of
/// the velocities that should add up to zero. With a rank lost to rounding: the part of the remaining velocity that the
/// joints could still remove.
fn still_tip<T: Number, const N: usize, const M: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    arm: &ExactArm,
) -> [f64; 2] {
    let mut random = Random::new(q[0].to_f64().to_bits());
    let base = Screw::new(
        direction::<f32>(&mut random).map(f64::from),
        vector(&mut random),
    );
    let target = Pose::new(
        nearest_matrix(&arm.tip.r),
        arm.tip.t.each_ref().map(Big::to_f64),
    );
    let closed = ClosedChain::tip_at(on_a_moving_base::<N, M, F>(chain, base), target);
    let moved = from_fn(|k| if k == 0 { T::constant(0.0) } else { q[k - 1] });
    let rate = rate(&mut random);
    let driving = from_fn(|k| (k == 0).then_some(rate));
    let found = velocity(&closed, &moved, &driving);
    if !found.values.iter().all(|x| x.is_finite()) {
        return [f64::NAN; 2];
    }
    // The length by which the runtime scales metres against radians.
    let length = Big::new(reach(chain)) + norm(&arm.tip.t);
    let (u, b) = (exact(base.u()), exact(base.b()));
    let first: Column = [u.clone(), add(&b, &cross(&u, &arm.tip.t))];
    let columns: Vec<[Big; 6]> = (once(&first).chain(&arm.geometric))
        .map(|[u, b]| {
            from_fn(|i| {
                if i < 3 {
                    u[i].clone()
                } else {
                    &b[i - 3] / &length
                }
            })
        })
        .collect();
    let rates = exact(found.values);
    let mut gap: [Big; 6] = from_fn(|_| Big::zero());
    let mut speeds = Big::zero();
    for (column, rate) in columns.iter().zip(&rates) {
        gap = from_fn(|i| &gap[i] + &column[i] * rate);
        speeds = speeds + product(column, column).sqrt() * rate.abs();
    }
    let unit = speeds * Big::new(T::UNIT) + Big::new(T::UNDERFLOW);
    if found.is_singular() {
        let seen = columns[1..]
            .iter()
            .map(|column| product(column, &gap).abs());
        [0.0, (seen.fold(Big::zero(), Big::max) / unit).to_f64()]
    } else {
        [(product(&gap, &gap).sqrt() / unit).to_f64(), 0.0]
    }
}

/// The sum of products.
fn product(x: &[Big; 6], y: &[Big; 6]) -> Big {
    let products = x.iter().zip(y).map(|(x, y)| x * y);
    products.fold(Big::zero(), |sum, product| sum + product)
}

/// Configuration, wanted velocity, λ.
type Damped<T> = [T; 13];

/// The residual of the normal equations, in u, for damped rates q̇ = (AᵗA + λ²)⁻¹ Aᵗ W by nalgebra's QR of the stacked
/// matrix (A; λ) of the generated Jacobian.
fn damped_error<T: Number + RealField>(state: &Damped<T>) -> f64 {
    let [q, speed]: [[T; 6]; 2] = from_fn(|i| from_fn(|k| state[6 * i + k]));
    let lambda = state[12];
    let chain = Puma560::chain();
    let length = T::constant(reach(&chain));
    let [ux, uy, uz, bx, by, bz] = Puma560.geometric_jacobian(&q).to_matrix_angular_first();
    let [bx, by, bz] = [bx, by, bz].map(|row| row.map(|x| x / length));
    let a = [ux, uy, uz, bx, by, bz];
    let zero = T::constant(0.0);
    let stacked = SMatrix::<T, 12, 6>::from_fn(|i, j| match i.checked_sub(6) {
        None => a[i][j],
        Some(row) if row == j => lambda,
        Some(_) => zero,
    });
    let right = SVector::<T, 12>::from_fn(|i, _| speed.get(i).copied().unwrap_or(zero));
    let factors = stacked.qr();
    let rotated = factors.q().transpose() * right;
    let Some(rates) = factors.r().solve_upper_triangular(&rotated) else {
        return f64::NAN;
    };
    let rates: [Big; 6] = from_fn(|k| rates[k].big());
    let (speed, lambda, length) = (exact(speed), lambda.big(), length.big());
    let columns: Vec<[Big; 6]> = (at(&chain, &q).geometric.iter())
        .map(|[u, b]| {
            from_fn(|i| {
                if i < 3 {
                    u[i].clone()
                } else {
                    &b[i - 3] / &length
                }
            })
        })
        .collect();
    let mut gap = speed.each_ref().map(|x| -x);
    for (column, rate) in columns.iter().zip(&rates) {
        gap = from_fn(|i| &gap[i] + &column[i] * rate);
    }
    let seen = (columns.iter().zip(&rates))
        .map(|(column, rate)| (product(column, &gap) + &lambda * &lambda * rate).abs());
    let size = (rates.iter().chain(&speed)).fold(Big::zero(), |sum, x| sum + x.abs());
    let unit = size * Big::new(T::UNIT) + Big::new(T::UNDERFLOW);
    (seen.fold(Big::zero(), Big::max) / unit).to_f64()
}

/// A rate: zero, subnormal, or ordinary.
fn rate<T: Number>(random: &mut Random) -> T {
    let subnormal = T::MIN_POSITIVE * T::constant(random.unit());
    *random.choose(&[
        T::constant(0.0),
        subnormal,
        T::constant(1.0),
        T::constant(0.3),
    ])
}

/// Both arms near their singularities. The worst are 4.3 u for J and 4.7 u for rates; the limits are twice as large.
/// With a rank lost to rounding, rates are exact for a matrix that differs by the threshold of the rank, 64 ε = 128 u:
/// the worst is 25, the limit 64.
fn near_singular<T: Number>(puma: &Bent, panda: &Bent) {
    let limits = [("J", 8.0), ("rates", 10.0), ("rates, rank lost", 64.0)];
    let chain = Puma560::chain();
    hold(limits, &PUMA, &puma.configurations::<T, 6>(10, 500), |q| {
        let arm = at(&chain, q);
        let [full, lost] = still_tip::<T, 6, 7, _>(&chain, q, &arm);
        [entries(&Puma560, q, &arm, reach(&chain)), full, lost]
    });
    let chain = PandaClass::chain();
    hold(
        limits,
        &PANDA,
        &panda.configurations::<T, 7>(11, 500),
        |q| {
            let arm = at(&chain, q);
            let [full, lost] = still_tip::<T, 7, 8, _>(&chain, q, &arm);
            [entries(&PandaClass, q, &arm, reach(&chain)), full, lost]
        },
    );
}

/// Damped solutions for the arm of six joints, in the types that nalgebra supports.
fn damped<T: Number + RealField>(bent: &Bent) {
    let mut random = Random::new(12);
    let configurations = bent.configurations::<T, 6>(13, 500);
    let states: Vec<Damped<T>> = (configurations.iter())
        .map(|q| {
            let speed: T = rate(&mut random);
            let lambda = size::<T>(&mut random, -6.0, -1.0);
            from_fn(|k| match k {
                0..6 => q[k],
                6..12 => speed * T::constant(random.unit()),
                _ => lambda,
            })
        })
        .collect();
    // The worst is 5.2 u; the limit is twice as large.
    hold([("damped rates", 10.0)], &DAMPED, &states, |state| {
        [damped_error(state)]
    });
}

/// The angle of the elbow at which the next joint is farthest from the shoulder. `inner` is the pose of the elbow in
/// the shoulder's frame, `outer` that of the next joint in the elbow's.
fn straight(inner: &Pose<f64>, outer: &Pose<f64>) -> f64 {
    let from_shoulder = homogen::vector::transposed_product(inner.rotation(), inner.translation());
    let angle = |[x, y, _]: [f64; 3]| y.atan2(x);
    angle(from_shoulder) - angle(outer.translation())
}

const PUMA_WRIST: Bent = Bent {
    bent: 4,
    singular: 0.0,
};
const PANDA_WRIST: Bent = Bent {
    bent: 5,
    singular: 0.0,
};

fn puma_elbow() -> Bent {
    let joints = Puma560::chain().joints;
    let singular = straight(&joints[2].placement, &joints[3].placement);
    Bent { bent: 2, singular }
}

fn panda_elbow() -> Bent {
    let joints = PandaClass::chain().joints;
    // The axis of the third joint is the line from the shoulder.
    let inner = joints[2].placement * joints[3].placement;
    let singular = straight(&inner, &joints[4].placement);
    Bent { bent: 3, singular }
}

/// Asserts that the rank is lost at the singular angle and full 0.01 rad away from it; the other joints are far from
/// singularities.
fn flagged<T: Number>(puma: &Bent) {
    let closed = ClosedChain::tip_at(Puma560::chain(), Pose::identity());
    for (away, is_singular) in [
        (0.0, true),
        (T::UNIT, true),
        (-T::UNIT, true),
        (0.01, false),
    ] {
        let mut q = [0.3, -0.8, 0.9, 0.5, 0.8, -0.4].map(T::constant);
        q[puma.bent] = T::constant(puma.singular + away);
        let found = velocity(&closed, &q, &[None; 6]);
        assert_eq!(found.is_singular(), is_singular, "{away:e} away");
    }
}

fn wrist<T: Number>() {
    flagged::<T>(&PUMA_WRIST);
    near_singular::<T>(&PUMA_WRIST, &PANDA_WRIST);
}

fn elbow<T: Number>() {
    flagged::<T>(&puma_elbow());
    near_singular::<T>(&puma_elbow(), &panda_elbow());
}

crate::in_every_type! {
    /// Hard case 21.
    wrist_singular => wrist;
    /// Hard case 22.
    elbow_singular => elbow;
}

#[test]
fn wrist_singular_fused() {
    wrist::<Fused64>();
    wrist::<Fused32>();
}

#[test]
fn elbow_singular_fused() {
    elbow::<Fused64>();
    elbow::<Fused32>();
}

#[test]
fn wrist_singular_damped() {
    damped::<f64>(&PUMA_WRIST);
    damped::<f32>(&PUMA_WRIST);
}

#[test]
fn elbow_singular_damped() {
    damped::<f64>(&puma_elbow());
    damped::<f32>(&puma_elbow());
}

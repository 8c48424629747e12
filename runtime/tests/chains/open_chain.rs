//! Composition in any frame, H̃ by recursion and by the closed sum, and derivatives of positions.

use crate::jet::Jet;
use crate::sample::{Random, agree, largest};
use homogen::open_chain::{
    BodyMotion, bias_acceleration_as_sum, bias_accelerations, commutator, joint_actions, motions,
    poses, screws,
};
use homogen::{Jacobian, Point, Pose, Real, Velocity, open_chain};
use std::array::from_fn;

fn entries<T: Real>(matrix: &[[T; 4]; 4]) -> Vec<T> {
    matrix.as_flattened().to_vec()
}

/// Velocity and acceleration of points, by automatic derivatives of positions.
#[test]
fn motions_are_the_derivatives_of_positions() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd, qdd]: [[f64; 7]; 3] = from_fn(|_| random.numbers());
        let jets = poses(&chain, &from_fn(|i| Jet(q[i], qd[i], qdd[i])));
        let motions = motions(&chain, &q, &qd, &qdd);
        let point: [f64; 3] = random.numbers();
        for (jet, motion) in jets.iter().zip(&motions) {
            let moving = *jet * Point(point.map(Jet::still));
            let still = motion.pose * Point(point);
            agree(&still.0, &moving.0.map(|x| x.0), 64.0, 10.0);
            let rate = motion.velocity * still;
            agree(&rate.0, &moving.0.map(|x| x.1), 256.0, 20.0);
            let second_rate = motion.acceleration * still;
            agree(&second_rate.0, &moving.0.map(|x| x.2), 256.0, 80.0);
        }
    }
}

fn composition_in_any_frame<T: Real>() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd, qdd]: [[T; 7]; 3] = from_fn(|_| random.numbers());
        let relative: [BodyMotion<T>; 7] =
            from_fn(|i| BodyMotion::of_joint(&chain.joints[i], q[i], qd[i], qdd[i]));
        let in_base = motions(&chain, &q, &qd, &qdd);
        let k: Pose<f64> = random.pose();
        let m_k_0 = Pose::new(
            k.rotation().map(|row| row.map(T::constant)),
            k.translation().map(T::constant),
        );
        for i in 1..7 {
            let Some(parent) = chain.joints[i].parent else {
                continue;
            };
            let size = largest(&entries(&in_base[i].acceleration.to_matrix())).max(1.0);
            // (12) and (13) with every term in frame (k).
            let (w_0_p, h_0_p) = in_base[parent].in_frame(&m_k_0);
            let m_k_p = m_k_0 * in_base[parent].pose;
            let (w_p_i, h_p_i) = relative[i].in_frame(&m_k_p);
            let (w_0_i, h_0_i) = in_base[i].in_frame(&m_k_0);
            agree(
                &entries(&(w_0_p + w_p_i).to_matrix()),
                &entries(&w_0_i.to_matrix()),
                32.0,
                size,
            );
            let composed = h_0_p.compose(&h_p_i, &w_0_p, &w_p_i);
            agree(
                &entries(&composed.to_matrix()),
                &entries(&h_0_i.to_matrix()),
                64.0,
                size,
            );
            // A motion and its inverse are the identity.
            let none = in_base[i].then(&in_base[i].inverse());
            agree(
                &entries(&none.velocity.to_matrix()),
                &[T::constant(0.0); 16],
                64.0,
                size,
            );
            agree(
                &entries(&none.acceleration.to_matrix()),
                &[T::constant(0.0); 16],
                128.0,
                4.0 * size,
            );
        }
    }
}

#[test]
fn composition_holds_in_any_frame() {
    composition_in_any_frame::<f64>();
    composition_in_any_frame::<f32>();
}

/// (W, W') = W W' − W' W, by dense products.
#[test]
fn commutators_are_differences_of_products() {
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let [a, b] = [0; 2].map(|_| Velocity::new(random.numbers::<f64, 3>(), random.numbers()));
        let product = |x: [[f64; 4]; 4], y: [[f64; 4]; 4]| -> [[f64; 4]; 4] {
            from_fn(|i| from_fn(|j| (0..4).map(|k| x[i][k] * y[k][j]).sum()))
        };
        let [ab, ba] = [(a, b), (b, a)].map(|(x, y)| product(x.to_matrix(), y.to_matrix()));
        let literal: [[f64; 4]; 4] = from_fn(|i| from_fn(|j| ab[i][j] - ba[i][j]));
        let ours = commutator(&a, &b).to_matrix();
        agree(&entries(&ours), &entries(&literal), 8.0, 2.0);
    }
}

fn bias_acceleration<T: Real>() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd]: [[T; 7]; 2] = from_fn(|_| random.numbers());
        let velocities =
            motions(&chain, &q, &qd, &[T::constant(0.0); 7]).map(|motion| motion.velocity);
        for (body, recursion) in bias_accelerations(&chain, &q, &qd).iter().enumerate() {
            let sum = bias_acceleration_as_sum(&chain, &velocities, body);
            let (sum, recursion) = (entries(&sum.to_matrix()), entries(&recursion.to_matrix()));
            agree(&sum, &recursion, 64.0, largest(&recursion).max(4.0));
        }
    }
}

#[test]
fn bias_acceleration_by_recursion_is_the_closed_sum() {
    bias_acceleration::<f64>();
    bias_acceleration::<f32>();
}

#[test]
fn velocities_are_sums_of_screws() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd]: [[f64; 7]; 2] = from_fn(|_| random.numbers());
        let motions = motions(&chain, &q, &qd, &[0.0; 7]);
        let screws = screws(&chain, &poses(&chain, &q));
        for (body, motion) in motions.iter().enumerate() {
            let rates = from_fn(|i| {
                if chain.carries(i, Some(body)) {
                    qd[i]
                } else {
                    0.0
                }
            });
            agree(
                &entries(&screws.velocity(&rates).to_matrix()),
                &entries(&motion.velocity.to_matrix()),
                64.0,
                8.0,
            );
        }
    }
}

/// An external wrench reduces the torque of a joint by its power at a unit rate of the joint.
#[test]
fn external_actions_work_on_the_joints_that_carry_them() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let [q, qd, qdd]: [[f64; 7]; 3] = from_fn(|_| random.numbers());
        let external = random.actions();
        let none = [homogen::Action::zero(); 7];
        let free = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &none);
        let loaded = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &external);
        let motions = motions(&chain, &q, &qd, &qdd);
        let joints = loaded.iter().zip(&free).zip(&qd);
        let lost: f64 = joints
            .map(|((with, without), qd)| (without - with) * qd)
            .sum();
        let work: f64 = (0..7)
            .map(|i| motions[i].velocity.power(&external[i]))
            .sum();
        agree(&[lost], &[work], 256.0, largest(&free) + 20.0);
    }
}

/// At rest, the wrench on the base is the weight of the robot.
#[test]
fn the_first_joint_bears_all_weight() {
    for seed in 0..100 {
        let mut random = Random::new(seed);
        let chain = random.chain();
        let q: [f64; 7] = random.numbers();
        let rest = [0.0; 7];
        let none = [homogen::Action::zero(); 7];
        let [first, ..] = joint_actions(&chain, &q, &rest, &rest, &none);
        let mass: f64 = chain.joints.iter().map(|joint| joint.inertia.mass()).sum();
        agree(
            &first.f(),
            &chain.gravity.map(|g| -mass * g),
            64.0,
            9.81 * mass,
        );
    }
}

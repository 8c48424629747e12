//! The closed forms of the Stanford arm against the recursions.

use crate::sample::{Random, agree};
use homogen::open_chain::{self, bias_accelerations, motions, poses};
use homogen::worked_examples::stanford_arm;
use homogen::{Action, Real};
use std::array::from_fn;

/// Random states, and all angles at multiples of 90°.
fn states<T: Real>() -> impl Iterator<Item = ([T; 6], [T; 6])> {
    let right = std::f64::consts::FRAC_PI_2;
    let special = (0..256_u32).map(move |k| {
        let at = |digit: u32| T::constant(right * f64::from((k >> (2 * digit)) % 4));
        let q = [at(0), at(1), T::constant(0.5), at(2), at(3), at(1)];
        (q, [T::constant(1.0); 6])
    });
    let random = (0..1000).map(|seed| {
        let mut random = Random::new(seed);
        (
            random.numbers().map(|x: T| T::constant(3.0) * x),
            random.numbers(),
        )
    });
    special.chain(random)
}

fn closed_forms<T: Real>() {
    let chain = stanford_arm::chain();
    let tool = chain.frames[0].placement;
    for (q, qd) in states::<T>() {
        let motions = motions(&chain, &q, &qd, &[T::constant(0.0); 6]);
        let boom = stanford_arm::boom_pose(&q).to_matrix();
        agree(
            boom.as_flattened(),
            motions[2].pose.to_matrix().as_flattened(),
            8.0,
            4.0,
        );
        let m_6_tool = homogen::Pose::from_translation(tool.translation().map(T::constant));
        agree(
            stanford_arm::tool_pose(&q).to_matrix().as_flattened(),
            (motions[5].pose * m_6_tool).to_matrix().as_flattened(),
            16.0,
            4.0,
        );
        let velocity = stanford_arm::boom_velocity(&q, &qd).to_matrix();
        agree(
            velocity.as_flattened(),
            motions[2].velocity.to_matrix().as_flattened(),
            16.0,
            4.0,
        );
        let closed = stanford_arm::boom_bias_acceleration(&q, &qd).to_matrix();
        let recursion = bias_accelerations(&chain, &q, &qd)[2].to_matrix();
        agree(closed.as_flattened(), recursion.as_flattened(), 32.0, 4.0);
        let recursion = open_chain::screws(&chain, &poses(&chain, &q));
        for (ours, theirs) in stanford_arm::screws(&q).iter().zip(&recursion) {
            agree(&ours.u(), &theirs.u(), 16.0, 1.0);
            agree(&ours.b(), &theirs.b(), 16.0, 4.0);
        }
    }
}

#[test]
fn stanford_arm_in_closed_form() {
    closed_forms::<f64>();
    closed_forms::<f32>();
}

/// With the printed C₁S₁ the third screw is not even a unit vector; with C₁S₂ it is.
#[test]
fn the_boom_slides_along_c1_s2() {
    let q = [0.7_f64, 0.4, 0.5, 0.0, 0.0, 0.0];
    let [x, y, z] = stanford_arm::screws(&q)[2].b();
    let length = |x: f64| (x * x + y * y + z * z).sqrt();
    assert!((x - q[0].cos() * q[1].sin()).abs() < 1e-16);
    assert!((length(x) - 1.0).abs() < 1e-15);
    assert!((length(q[0].cos() * q[0].sin()) - 1.0).abs() > 0.01);
}

/// At rest, the force of the boom is the component of the weight that it carries along its direction.
#[test]
fn the_force_of_the_boom_at_rest() {
    let chain = stanford_arm::chain();
    let carried: f64 = chain.joints[2..].iter().map(|j| j.inertia.mass()).sum();
    for (q, _) in states::<f64>() {
        let rest = [0.0; 6];
        let torques = open_chain::inverse_dynamics(&chain, &q, &rest, &rest, &[Action::zero(); 6]);
        let expected = [0.0, carried * 9.81 * q[1].cos()];
        agree(&[torques[0], torques[2]], &expected, 32.0, carried * 9.81);
    }
}

/// The inertia is transformed to frame 0 by M₀,ᵢ: only then is the rate of the kinetic energy the power of the
/// joints.
#[test]
fn the_power_of_the_joints_is_the_rate_of_the_energy() {
    let chain = stanford_arm::chain();
    let mut random = Random::new(7);
    for _ in 0..100 {
        let [q, qd, qdd]: [[f64; 6]; 3] = from_fn(|_| random.numbers());
        let energy = |t: f64| {
            let q = from_fn(|i| q[i] + t * (qd[i] + 0.5 * t * qdd[i]));
            let qd = from_fn(|i| qd[i] + t * qdd[i]);
            let motions = motions(&chain, &q, &qd, &[0.0; 6]);
            let inertias = open_chain::inertias(&chain, &motions.map(|motion| motion.pose));
            let bodies = inertias.iter().zip(&motions);
            bodies
                .map(|(j, motion)| {
                    j.kinetic_energy(&motion.velocity) + j.potential_energy(chain.gravity)
                })
                .sum::<f64>()
        };
        // A central difference of fourth order: 1e-3⁴ of truncation, 1e-13 of rounding.
        let h = 1e-3;
        let slope =
            (8.0 * (energy(h) - energy(-h)) - energy(2.0 * h) + energy(-2.0 * h)) / (12.0 * h);
        let torques = open_chain::inverse_dynamics(&chain, &q, &qd, &qdd, &[Action::zero(); 6]);
        let power: f64 = torques
            .iter()
            .zip(&qd)
            .map(|(torque, qd)| torque * qd)
            .sum();
        assert!(
            (slope - power).abs() < 1e-8 * (1.0 + power.abs()),
            "{slope} but {power}"
        );
    }
}

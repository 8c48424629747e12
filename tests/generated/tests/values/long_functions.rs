//! Functions that are long enough to be printed in blocks: they compile, and agree with the generic recursions.
#![deny(warnings, clippy::pedantic)]

use homogen::{Robot, generic};
use homogen_tests::effort::effort;
use homogen_tests::functions::evaluate;
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// 39 joints; the longest function has some 100,000 operations. All functions but the Hessian of forward dynamics, which
/// takes as long to compile as all others.
#[derive(Robot)]
#[robot(
    urdf = "../robots/humanoid.urdf",
    tip = "left_arm_9",
    generate(
        forward_kinematics,
        spatial_jacobian,
        body_jacobian,
        geometric_jacobian,
        spatial_jacobian_rate,
        body_jacobian_rate,
        geometric_jacobian_rate,
        jacobian_derivative,
        velocity,
        acceleration,
        acceleration_bias,
        inverse_dynamics,
        gravity,
        bias,
        mass_matrix,
        forward_dynamics,
        mass_matrix_inverse,
        kinetic_energy,
        potential_energy,
        regressor,
        base_regressor,
        kinetic_energy_regressor,
        potential_energy_regressor,
        center_of_mass,
        center_of_mass_velocity,
        center_of_mass_jacobian,
        momentum,
        centroidal_momentum,
        centroidal_momentum_matrix,
        centroidal_momentum_bias,
        inverse_dynamics_derivatives,
        inverse_dynamics_vjp,
        inverse_dynamics_jvp,
        inverse_dynamics_hessian,
        forward_dynamics_derivatives,
        forward_dynamics_vjp,
        forward_dynamics_jvp,
        gravity_derivative,
        coriolis_matrix
    )
)]
struct Humanoid;

/// States of each robot.
fn count() -> usize {
    effort(4, 20)
}

#[test]
fn long_functions_agree_with_the_recursions() {
    let chain = Humanoid::chain();
    let mut random = Random::new(21);
    let mut worst = Worst::in_units_of(DOUBLE);
    for _ in 0..count() {
        let state = State::<f64, 39>::random(&mut random);
        worst.note(&evaluate(&Humanoid, &state), &evaluate(&chain, &state));
    }
    println!("{worst}");
    worst.assert_within(64.0);
}

/// Backward: torques of the accelerations, and M M⁻¹.
#[test]
fn long_solutions_agree_with_the_recursions() {
    let chain = Humanoid::chain();
    let mut random = Random::new(22);
    let [mut torques, mut unit] = [0.0_f64; 2];
    for _ in 0..count() {
        let State { q, qd, qdd } = State::<f64, 39>::random(&mut random);
        let tau = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        let found = Humanoid.forward_dynamics(&q, &qd, &tau);
        for (needed, tau) in generic::inverse_dynamics(&chain, &q, &qd, &found)
            .iter()
            .zip(&tau)
        {
            torques = torques.max((needed - tau).abs());
        }
        let mass = generic::mass_matrix(&chain, &q);
        let inverse = Humanoid.mass_matrix_inverse(&q);
        for (i, row) in mass.iter().enumerate() {
            for (k, column) in inverse.iter().enumerate() {
                let entry: f64 = row.iter().zip(column).map(|(m, n)| m * n).sum();
                unit = unit.max((entry - f64::from(u8::from(i == k))).abs());
            }
        }
    }
    println!("{torques:.1e} N m, {unit:.1e}");
    assert!(torques < 1e-9, "{torques:e} N m");
    assert!(unit < 1e-9, "{unit:e}");
}

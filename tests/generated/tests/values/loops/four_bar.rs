//! A four-bar linkage, compared with its triangles, and its energy over time.

use homogen::loop_closure::{ClosureOutcome, project, project_rates};

use super::{difference, largest, step};

homogen::chain! {
    /// Bars of 0.1, 0.3 and 0.2 m on a ground of 0.35 m; the crank cannot make a full turn.
    pub struct FourBar {
        gravity: [0.0, -9.81, 0.0],
        generate(
            constraint, constraint_jacobian, constrained_forward_dynamics, kinetic_energy,
            potential_energy,
        )
    }
    link ground;
    joint a: revolute(z);
    link crank { mass: 0.5, com: [0.05, 0.01, 0.0], inertia: [1e-4, 4e-4, 5e-4] }
    joint b: revolute(z) { at: xyz(0.1, 0.0, 0.0) }
    link coupler { mass: 0.8, com: [0.15, 0.0, 0.02], inertia: [1e-4, 6e-3, 6e-3] }
    joint c: revolute(z) { from: ground, at: xyz(0.35, 0.0, 0.0) }
    link rocker { mass: 0.6, com: [0.1, 0.0, 0.0], inertia: [1e-4, 2e-3, 2e-3] }
    loop pin: revolute(z) {
        from: coupler, to: rocker, at: xyz(0.3, 0.0, 0.0), to_at: xyz(0.2, 0.0, 0.0) }
}

/// The coordinates at an angle of the crank, with the coupler above, by the law of cosines.
fn closed(crank: f64) -> [f64; 3] {
    let (sine, cosine) = crank.sin_cos();
    let [x, y] = [0.35 - 0.1 * cosine, -0.1 * sine];
    let distance = x.hypot(y);
    let inner = ((0.09 + distance * distance - 0.04) / (0.6 * distance)).acos();
    let coupler = y.atan2(x) + inner;
    let [dx, dy] = [0.3 * coupler.cos() - x, 0.3 * coupler.sin() - y];
    [crank, coupler - crank, dy.atan2(dx)]
}

#[test]
fn triangles_close_the_loop() {
    for k in 0..60 {
        let crank = 0.1 * f64::from(k) - 3.0;
        let q = closed(crank);
        assert!(largest(&FourBar.constraint(&q)) < 3e-16, "{crank}");
        let found = project(&FourBar, &[q[0] + 0.05, q[1] - 0.1, q[2] + 0.1], 1e-15);
        assert_eq!(found.outcome, ClosureOutcome::Closed, "{found:?}");
        assert!(
            difference(&found.q, &closed(found.q[0])) < 1e-13,
            "{found:?}"
        );
    }
}

#[test]
fn energy_is_kept_and_the_loop_stays_closed() {
    let mut q = closed(1.0);
    let mut qd = project_rates(&FourBar.constraint_jacobian(&q), &[3.0, 0.0, 0.0]);
    let energy = |q: &[f64; 3], qd: &[f64; 3]| -> f64 {
        FourBar.kinetic_energy(q, qd) + FourBar.potential_energy(q)
    };
    let (start, mut most) = (energy(&q, &qd), 0.0_f64);
    let mut travelled = 0.0;
    for _ in 0..4000 {
        step(&mut q, &mut qd, 2.5e-4, |q, qd| {
            FourBar.constrained_forward_dynamics(q, qd, &[0.0; 3]).qdd
        });
        travelled += qd[0].abs() * 2.5e-4;
        most = most.max((energy(&q, &qd) - start).abs());
    }
    let kinetic: f64 = FourBar.kinetic_energy(&q, &qd);
    println!(
        "energy {most:.1e} J of {start:.3} J, loop {:.1e} m, travelled {travelled:.2} rad, kinetic {kinetic:.2} J",
        largest(&FourBar.constraint(&q))
    );
    assert!(travelled > 2.0, "{travelled}");
    // The energy is not corrected, so its drift is the error of the steps.
    assert!(most < 1e-9, "{most}");
    assert!(largest(&FourBar.constraint(&q)) < 1e-9);
}

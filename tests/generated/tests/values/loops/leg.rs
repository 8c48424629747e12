//! A leg with a rod across the knee's two joints and a foot moved by a crank, like Cassie's: compared with formulas by
//! hand, and on a floating base.

use homogen::loop_closure::{ClosureOutcome, project, project_by, project_rates};

use super::{largest, step};

/// Passes the leg, behind the given head, to a macro: to the compiler, or as text.
macro_rules! leg {
    ($($then:ident)::+! $($head:tt)*) => {
        $($then)::+! {
            $($head)*
            joint roll: revolute(x) { from: pelvis, at: xyz(0.02, 0.13, 0.0) }
            link hip_roll { mass: 1.8, com: [0.0, 0.01, -0.02], inertia: [3e-3, 5e-3, 4e-3] }
            joint yaw: revolute(z) { at: xyz(0.0, 0.0, -0.09) }
            link hip_yaw { mass: 1.2, com: [0.0, 0.0, -0.03], inertia: [2e-3, 3e-3, 2e-3] }
            joint pitch: revolute(y) { at: xyz(0.0, 0.05, -0.05) }
            link thigh { mass: 5.5, com: [0.06, 0.0, -0.03], inertia: [1e-2, 5e-2, 5e-2] }
            joint knee: revolute(y) { at: xyz(0.12, 0.0, -0.02) }
            link shin { mass: 0.8, com: [0.18, 0.01, 0.01], inertia: [1e-3, 8e-3, 8e-3] }
            joint tarsus: revolute(y) { at: xyz(0.43, 0.0, 0.02) rpy(0.0, -1.2, 0.0) }
            link tarsus { mass: 0.9, com: [-0.1, 0.0, -0.01], inertia: [1e-3, 9e-3, 9e-3] }
            joint crank: revolute(y) { at: xyz(0.06, 0.01, -0.03) }
            link crank { mass: 0.15, com: [0.02, 0.0, 0.0], inertia: [4e-5, 1e-4, 1e-4] }
            joint toe: revolute(y) { from: tarsus, at: xyz(0.41, 0.0, 0.0) rpy(0.0, 0.6, 0.0) }
            link foot { mass: 0.2, com: [0.01, 0.0, -0.02], inertia: [1e-4, 3e-4, 3e-4] }
            loop achilles: rod(0.5012) {
                from: thigh, to: tarsus, at: xyz(0.0, 0.03, 0.045), to_at: xyz(-0.11, 0.0, -0.03) }
            loop plantar: rod(0.35) {
                from: crank, to: foot, at: xyz(0.055, 0.0, 0.0), to_at: xyz(-0.05, 0.0, 0.02) }
        }
    };
}

leg! {
    homogen::chain!
    /// The leg on a fixed pelvis.
    pub struct Leg {
        generate(
            constraint, constraint_jacobian, constrained_forward_dynamics, kinetic_energy,
            potential_energy,
        )
    }
    link pelvis;
}

leg! {
    homogen::chain!
    /// The leg on a floating pelvis.
    pub struct FreeLeg {
        floating,
        generate(constraint, constraint_jacobian, constrained_forward_dynamics)
    }
    link pelvis { mass: 10.0, com: [0.05, 0.0, 0.02], inertia: [0.08, 0.05, 0.08] }
}

/// The leg on a fixed pelvis, as text.
pub(super) const STANDING: &str = leg!(stringify! struct Leg; link pelvis;);

/// The leg on a floating pelvis, as text.
pub(super) const FREE: &str = leg! {
    stringify!
    struct Leg { floating }
    link pelvis { mass: 10.0, com: [0.05, 0.0, 0.02], inertia: [0.08, 0.05, 0.08] }
};

/// A point after a rotation about y and a translation.
fn moved([x, y, z]: [f64; 3], angle: f64, [dx, dy, dz]: [f64; 3]) -> [f64; 3] {
    let (sine, cosine) = angle.sin_cos();
    [
        cosine * x + sine * z + dx,
        y + dy,
        cosine * z - sine * x + dz,
    ]
}

/// The lengths of both rods, by rotations about y from link to link.
fn lengths(q: &[f64; 7]) -> [f64; 2] {
    let [_, _, _, knee, tarsus, crank, toe] = *q;
    let heel = moved([-0.11, 0.0, -0.03], tarsus - 1.2, [0.43, 0.0, 0.02]);
    let heel = moved(heel, knee, [0.12, 0.0, -0.02]);
    let pin = moved([0.055, 0.0, 0.0], crank, [0.06, 0.01, -0.03]);
    let foot = moved([-0.05, 0.0, 0.02], toe + 0.6, [0.41, 0.0, 0.0]);
    let distance = |a: [f64; 3], b: [f64; 3]| {
        let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
        squares.sum::<f64>().sqrt()
    };
    [distance(heel, [0.0, 0.03, 0.045]), distance(pin, foot)]
}

/// A configuration in which both rods have their length.
fn closed() -> [f64; 7] {
    let found = project(&Leg, &[0.1, -0.2, 0.3, 0.4, 0.2, 0.3, -0.2], 1e-15);
    assert_eq!(found.outcome, ClosureOutcome::Closed, "{found:?}");
    found.q
}

#[test]
fn residuals_are_those_of_the_rods_lengths() {
    for k in 0..20 {
        let places = [0.0, 0.7, 1.4, 2.1, 2.8, 3.5, 4.2];
        let q: [f64; 7] = places.map(|place| (f64::from(k) * 1.3 + place).sin());
        let found = Leg.constraint(&q);
        for ((found, distance), length) in found.iter().zip(lengths(&q)).zip([0.5012, 0.35]) {
            let expected = (distance * distance - length * length) / (2.0 * length);
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }
}

#[test]
fn rods_keep_their_length_and_the_leg_its_energy() {
    let mut q = closed();
    let wanted = [0.5, 0.4, -1.0, 2.0, 0.0, 1.0, 0.0];
    let mut qd = project_rates(&Leg.constraint_jacobian(&q), &wanted);
    let energy = |q: &[f64; 7], qd: &[f64; 7]| -> f64 {
        Leg.kinetic_energy(q, qd) + Leg.potential_energy(q)
    };
    let (start, mut most) = (energy(&q, &qd), 0.0_f64);
    for _ in 0..2000 {
        step(&mut q, &mut qd, 2.5e-4, |q, qd| {
            Leg.constrained_forward_dynamics(q, qd, &[0.0; 7]).qdd
        });
        most = most.max((energy(&q, &qd) - start).abs());
    }
    println!("energy {most:.1e} J, rods {:?}, {q:?}", Leg.constraint(&q));
    assert!(most < 1e-7, "{most}");
    assert!(
        largest(&Leg.constraint(&q)) < 1e-9,
        "{:?}",
        Leg.constraint(&q)
    );
    // A rod exerts a force along itself only: its torques are this force times its Jacobian.
    let force = Leg
        .constrained_forward_dynamics(&q, &qd, &[0.0; 7])
        .multipliers;
    assert!(
        force.iter().all(|x| x.is_finite() && x.abs() > 1e-3),
        "{force:?}"
    );
}

#[test]
fn the_position_of_a_floating_base_does_not_matter_to_rods() {
    let standing = closed();
    let start = std::array::from_fn(|k| match k {
        0..3 => 1e6,
        3..7 => 0.5,
        _ => standing[k - 7] + 0.02,
    });
    let found = project_by(&FreeLeg, &start, 1e-15, |q, v| FreeLeg.integrate(q, v));
    assert_eq!(found.outcome, ClosureOutcome::Closed, "{found:?}");
    // No step moved the base, and its distance costs the rods no accuracy.
    assert_eq!(found.q[..7], start[..7]);
    let jacobian = FreeLeg.constraint_jacobian(&found.q);
    for row in jacobian {
        assert_eq!(row[..9], [0.0; 9], "body, roll, yaw and pitch");
    }
    // In free fall no joint accelerates.
    let found = FreeLeg
        .constrained_forward_dynamics(&found.q, &[0.0; 13], &[0.0; 13])
        .qdd;
    assert!(largest(&found[3..]) < 1e-11, "{found:?}");
    let fall = found[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((fall - 9.81).abs() < 1e-11, "{fall}");
}

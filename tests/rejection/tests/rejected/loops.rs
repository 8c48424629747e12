//! Loops that cannot be, each stage by itself: words, links, bodies, equations, and what is asked for.

use homogen::chain;

chain! {
    struct Words { generate(constraint) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    loop pin: revolut(z) { from: arm, to: ground }
    loop stay: rod(-0.1) { from: arm, to: ground }
    loop ball: spherical { from: arm, twist: 0.1 }
    loop slot: prismatic { from: arm, to: ground }
    loop cross: universal(x) { from: arm, to: ground }
}

chain! {
    struct Links { generate(constraint), actuated(crnk) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    loop pin: spherical { from: arm, to: arm }
    loop stay: rod(0.1) { from: ground, to: amr }
}

chain! {
    struct Bodies { generate(constraint, actuated_inverse_dynamics), actuated(held) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    joint held: fixed { at: xyz(0.2, 0.0, 0.0) }
    link tool;
    loop pin: spherical { from: arm, to: tool }
}

chain! {
    struct Equations { generate(constraint_jacobian) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    loop slot: planar(z) { from: arm, to: ground, at: xyz(0.1, 0.0, 0.02) }
    loop face: planar(z) { from: ground, to: arm }
}

chain! {
    struct Asked { generate(constrained_forward_dynamics) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
}

chain! {
    struct Unasked { strict, generate(gravity), actuated(crank) }
    link ground;
    joint crank: revolute(z);
    link arm { mass: 1.0, com: [0.1, 0.0, 0.0], inertia: [0.01, 0.01, 0.01] }
    loop slot: spherical { from: arm, to: ground }
}

fn main() {
    let _: [f64; 2] = Words.constraint(&[0.0]);
    let _: [f64; 2] = Links.constraint(&[0.0]);
    let _: [f64; 3] = Bodies.constraint(&[0.0]);
    let _: [f64; 1] = Bodies.actuated_inverse_dynamics(&[0.0], &[0.0], &[0.0]);
    let _: [[f64; 1]; 3] = Equations.constraint_jacobian(&[0.0]);
    let _: homogen::ConstrainedAccelerations<1, 3> =
        Asked.constrained_forward_dynamics(&[0.0], &[0.0], &[0.0]);
    let _ = Unasked.gravity(&[0.0]);
}

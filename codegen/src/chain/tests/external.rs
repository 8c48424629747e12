//! External wrenches: on which links, in which frame, and which are refused.
//!
//! Every expansion is compared with dense matrices, which take each wrench to frame 0 as M Φ Mᵗ.

use super::*;
use crate::builder::Builder;
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters};
use crate::function::Function;
use crate::module::Module;
use crate::space::Variable;

/// A robot with a joint with several velocities, parallel axes, and a merged link.
fn tree(settings: &str) -> (Description, Request) {
    read(&format!(
        "struct Tree {{ {settings} }}
        link base; link shoulder;
        joint ball: spherical {{ from: base, to: g, at: xyz(0.1, 0, 0.2) rz(0.3) }}
        joint first: revolute(z) {{ from: g, to: h, at: xyz(0.1, 0.1, 0) rx(0.4) }}
        joint second: revolute(z) {{ from: h, to: i, at: xyz(0.3, 0, 0.1) }}
        joint weld: fixed {{ from: i, to: finger, at: xyz(0.1, 0.2, 0) rpy(0.3, 0.4, 0.5) }}
        joint slide: prismatic(y) {{ from: g, to: tool, at: xyz(0.1, 0.2, 0) rpy(0.3, 0.4, 0.5) }}
        joint stand: fixed {{ from: base, to: shoulder }}
        link g {{ mass: 0.5, com: [0.02, 0.01, 0.01], inertia: [0.003, 0, 0, 0.004, 0, 0.005] }}
        link h {{ mass: 0.3, com: [0.01, -0.02, 0.01], inertia: [0.002, 0, 0, 0.003, 0, 0.004] }}
        link i {{ mass: 0.6, com: [0.03, 0.02, -0.04], inertia: [0.004, 0.001, 0, 0.006, 0.001, 0.005] }}
        link tool {{ mass: 0.6, com: [0.03, 0.02, -0.04], inertia: [0.004, 0.001, 0, 0.006, 0.001, 0.005] }}
        link finger;"
    ))
}

const ALL: [Function; 5] = [
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::InverseDynamicsDerivatives,
    Function::InverseDynamicsHessian,
    Function::ForwardDynamicsDerivatives,
];

fn listed(settings: &str, formulation: Formulation) -> Module {
    // Derivatives are expensive, and do not depend on the form of the requested accelerations.
    let functions = if formulation.forward.is_some() {
        &ALL[..2]
    } else {
        &ALL[..]
    };
    let (description, request) = tree(settings);
    let builder = Builder::from_description(description).request(Request {
        formulation,
        ..request
    });
    let module = builder.generate(functions.iter().copied()).module();
    module.unwrap_or_else(|errors| panic!("{formulation:?}: {errors}"))
}

#[test]
fn every_formulation_agrees_with_dense_matrices() {
    let forms = [
        Formulation::default(),
        Formulation::default().with_angles(Angles::Merged),
        Formulation::default()
            .with_frame(Frame::Base)
            .with_parameters(Parameters::Raw),
        Formulation::default().with_forward(Forward::Articulated),
        Formulation::default().with_forward(Forward::MassMatrix { refinements: 1 }),
    ];
    for frame in ["", ", frame = 0"] {
        for formulation in forms {
            let settings = format!("tip: tool, external(finger, h, tool{frame})");
            let module = listed(&settings, formulation);
            assert_eq!(module.spaces.actions(), 3);
            assert_eq!(module.spaces.actions[0].name, "finger.cx");
            assert!((module.functions.iter()).all(|generated| {
                generated
                    .arguments(&module.spaces)
                    .contains(&Variable::Actions)
            }));
        }
    }
}

#[test]
fn generated_code_documents_links_and_frame() {
    let facts = |settings: &str| {
        listed(settings, Formulation::default())
            .about
            .facts
            .join("; ")
    };
    let own = facts("tip: tool, external(finger, h)");
    let reported = "; external wrenches on `finger` and `h`, in the link's frame; ";
    assert!(own.contains(reported), "{own}");
    let base = facts("tip: tool, external(finger, frame = 0)");
    assert!(
        base.contains("; external wrenches on `finger`, in frame 0; "),
        "{base}"
    );
}

#[test]
fn inverse_and_forward_dynamics_and_their_derivatives_take_wrenches() {
    let (description, request) = tree("tip: tool, external(finger, h)");
    let builder = Builder::from_description(description)
        .request(request)
        .name("Robot");
    let source = builder
        .clone()
        .runtime("::homogen")
        .generate([
            Function::InverseDynamics,
            Function::ForwardDynamicsDerivatives,
            Function::Bias,
        ])
        .to_source()
        .expect("no mistakes")
        .to_string();
    let count = |text: &str| source.matches(text).count();
    assert_eq!(count("actions: &[::homogen::Action<T>; 2],"), 2, "{source}");
    assert_eq!(count("actions.map(|action| (action.c(), action.f()))"), 2);
    // The methods of the traits have no wrenches.
    assert_eq!(count("&[::homogen::Action::zero(); 2]"), 2, "{source}");
    let core = builder
        .extern_c("arm_")
        .generate([Function::ForwardDynamics])
        .to_source()
        .expect("no mistakes")
        .to_string();
    assert!(core.contains("actions: &[[f64; 6]; 2],"), "{core}");
}

#[test]
fn wrenches_without_effect_are_refused() {
    assert_eq!(
        said(&arm(
            "drop(tool), external(tool, base, fore, fore, gripper)"
        )),
        lines(&[
            r#"error: link "tool" is not modelled"#,
            r#"error: link "base" does not move: a wrench on it changes nothing"#,
            "  hint: leave it out, or choose a base above the link in the tree",
            r#"error: the external wrench on link "fore" is requested twice"#,
            r#"error: there is no link "gripper""#,
            r#"  hint: did you mean "upper"? links: "base", "upper", "fore" and "tool""#,
        ])
    );
    assert_eq!(
        said(&arm("external(tool), generate(gravity, bias)")),
        lines(&[
            "error: external wrenches enter inverse and forward dynamics and their derivatives, but none of these is generated",
            "  hint: leave them out, or generate inverse_dynamics or forward_dynamics",
        ])
    );
    assert_eq!(
        said(&arm("external(frame = 0)")),
        lines(&[
            "error: external_in_frame_0 is set, but there are no external wrenches",
            "  hint: name the links on which they act with external",
        ])
    );
}

//! Fields of the struct: conflicts, errors, and `prepare`.

use super::{arm, as_asked, text};
use crate::builder::Builder;
use crate::function::Function;
use crate::request::Target;

/// The errors of a two-link arm with these fields.
fn refusal(fields: &[(&str, Target)]) -> String {
    let builder = Builder::from_urdf("../robots/two_link.urdf").generate([Function::Gravity]);
    let with_fields = fields.iter().fold(builder, |builder, (field, target)| {
        builder.parameter(field, target.clone())
    });
    with_fields
        .to_tokens()
        .map_or_else(|errors| errors.to_string(), |_| String::new())
}

#[test]
fn all_conflicts_of_fields_are_reported_at_once() {
    let mass = || Target::MassOf("fore".into());
    assert_eq!(
        refusal(&[
            ("a", mass()),
            ("b", mass()),
            ("a", Target::Gravity),
            ("c", Target::Gravity)
        ]),
        "error: field `b` stands for the mass of link \"fore\", as `a` does\n  \
         hint: leave out one of them\n\
         error: two fields have the name `a`\n  hint: rename one of them\n\
         error: field `c` stands for gravity, as `a` does\n  hint: leave out one of them\n"
    );
    assert_eq!(refusal(&[("a", mass()), ("b", Target::Gravity)]), "");
    let twice = arm(as_asked)
        .gravity([0.0; 3])
        .parameter("g", Target::Gravity);
    let twice = Builder {
        expand: crate::expand::expand,
        ..twice
    };
    let message = twice.to_tokens().expect_err("a mistake").to_string();
    assert!(
        message.contains("gravity is both a vector and the field `g`"),
        "{message}"
    );
}

#[test]
fn a_centre_of_mass_without_mass_is_a_warning() {
    let module = |builder: Builder| builder.module().expect("no mistakes");
    let warnings = |builder| module(builder).about.located_warnings();
    let arm = Builder::from_urdf("../robots/two_link.urdf")
        .generate([Function::Gravity])
        .parameter("center", Target::CenterOfMassOf("tip".into()));
    let message = "link \"tip\" has no mass: field `center` for its centre of mass changes nothing";
    assert_eq!(warnings(arm.clone()), [message]);
    let refused = arm.clone().strict().to_tokens().expect_err("strict");
    assert_eq!(
        refused.to_string(),
        format!("error: {message} (refused: strict)\n")
    );
    let with_mass = arm.parameter("mass", Target::MassOf("tip".into()));
    assert_eq!(warnings(with_mass), [""; 0]);
}

#[test]
fn a_payload_has_a_type_of_its_own_beside_the_runtime_and_is_an_array_without_it() {
    let builder = Builder::from_urdf("../robots/two_link.urdf")
        .generate([Function::Gravity])
        .parameter_within("load", Target::PayloadOn("tip".into()), 0.0..=4.0);
    let alone = text(&builder);
    for part in [
        "pub load: [f64; 10],\n",
        "let [load_m, load_x, load_y, _, _, _, _, _, _, _] = self.load;\n",
        "/// Payload on `tip`: its mass in kg",
        "`load` from 0 to 4 kg, its centre of mass up to 0.25 m along each axis",
    ] {
        assert!(alone.contains(part), "{alone}");
    }
    let beside = text(&builder.runtime("::homogen"));
    for part in [
        "pub load: ::homogen::Payload<::core::primitive::f64>,\n",
        "= ::homogen::Payload::numbers(",
    ] {
        assert!(beside.contains(part), "{beside}");
    }
}

#[test]
fn prepare_computes_once_what_depends_on_fields() {
    let plain = Builder::from_urdf("../robots/two_link.urdf")
        .generate([
            Function::InverseDynamics,
            Function::InverseDynamicsDerivatives,
        ])
        .parameter("load", Target::PayloadOn("tip".into()));
    let parted = text(&plain.clone().prepare());
    let mut parts = parted.split("pub fn prepare(&self) -> TwoLinkPrepared {\n");
    let [head, rest] = [(); 2].map(|()| parts.next().expect("both parts"));
    // The functions of the robot itself stay the same.
    let before = text(&plain);
    let start = before.find("/// Joint torques").expect("a function");
    let end = before.rfind("\n    }\n").expect("its end");
    assert!(
        head.contains(
            before[start..end]
                .split("\n    }\n")
                .next()
                .expect("a body")
        )
    );
    for part in [
        " --field load=payload_on:tip --prepare` (FNV-1a ",
        "    /// Results are the same, bit for bit.",
    ] {
        assert!(head.contains(part), "{head}");
    }
    for part in [
        "pub struct TwoLinkPrepared {\n    values: [f64; ",
        "impl TwoLinkPrepared {\n",
        "    /// Computed once by `prepare`, for all functions: ",
        ".values;\n",
        "= TwoLink::sin_cos(",
        ") -> TwoLinkTorqueDerivatives {",
    ] {
        assert!(rest.contains(part), "{rest}");
    }
    // Neither fields nor structures of results are duplicated.
    assert!(!rest.contains("self.load"), "{rest}");
    assert_eq!(parted.matches("pub struct ").count(), 3, "{parted}");
}

#[test]
fn prepare_without_fields_is_an_error() {
    let arm = || Builder::from_urdf("../robots/two_link.urdf").prepare();
    let message = |builder: Builder| {
        builder
            .to_tokens()
            .map(|_| ())
            .expect_err("a mistake")
            .to_string()
    };
    assert_eq!(
        message(arm().generate([Function::Gravity])),
        "error: `prepare` computes once what depends on fields alone, and the robot has none\n  \
         hint: leave it out: all other numbers are folded into the code\n"
    );
    let unread = arm().generate([Function::ForwardKinematics]);
    assert_eq!(
        message(unread.parameter("load", Target::PayloadOn("tip".into()))),
        "error: `prepare` computes once what depends on fields alone, and no function reads one\n  \
         hint: leave it out, or ask for functions that read the fields\n"
    );
}

#[test]
fn impossible_ranges_are_errors() {
    let mass = || Target::MassOf("rod-2".into());
    let builder = arm(as_asked)
        .parameter_within("light", mass(), -1.0..=1.0)
        .parameter_within("none", mass(), 2.0..=1.0)
        .parameter_within("endless", Target::Gravity, 0.0..=f64::INFINITY)
        .parameter_within("fine", Target::Gravity, -12.0..=12.0);
    let errors = builder.to_source().map(|_| ()).expect_err("three mistakes");
    let text = errors.to_string();
    for part in [
        "the range of field `light` has negative masses",
        "the range of field `none` is empty",
        "the range of field `endless` is not finite",
        "hint: write range = 0.0..=3.0",
    ] {
        assert!(text.contains(part), "{text}");
    }
    assert!(!text.contains("fine"), "{text}");
}

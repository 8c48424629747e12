//! Fields of the struct: which go together, what is told of those that do not, and what is prepared of them.

use super::{arm, as_asked, text};
use crate::builder::Builder;
use crate::function::Function;
use crate::request::Target;

/// What is said of a two-link arm with these fields.
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
fn two_fields_for_one_number_and_two_of_one_name_are_told_at_once() {
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
         error: two fields are called `a`\n  hint: give one of them another name\n\
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
    let said = twice.to_tokens().expect_err("a mistake").to_string();
    assert!(
        said.contains("gravity is given as a vector and in field `g`"),
        "{said}"
    );
}

#[test]
fn the_centre_of_a_mass_that_is_not_there_is_doubted_unless_a_field_gives_the_mass() {
    let module = |builder: Builder| builder.module().expect("no mistakes");
    let doubts = |builder| module(builder).about.located_warnings();
    let arm = Builder::from_urdf("../robots/two_link.urdf")
        .generate([Function::Gravity])
        .parameter("center", Target::CenterOfMassOf("tip".into()));
    let message = "link \"tip\" has no mass: field `center`, where its centre is, changes nothing";
    assert_eq!(doubts(arm.clone()), [message]);
    let refused = arm.clone().strict().to_tokens().expect_err("strict");
    assert_eq!(
        refused.to_string(),
        format!("error: {message} (refused: strict)\n")
    );
    let with_mass = arm.parameter("mass", Target::MassOf("tip".into()));
    assert_eq!(doubts(with_mass), [""; 0]);
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
fn what_fields_decide_is_computed_once_where_that_is_asked_for() {
    let plain = Builder::from_urdf("../robots/two_link.urdf")
        .generate([
            Function::InverseDynamics,
            Function::InverseDynamicsDerivatives,
        ])
        .parameter("load", Target::PayloadOn("tip".into()));
    let parted = text(&plain.clone().prepare());
    let mut parts = parted.split("pub fn prepare(&self) -> TwoLinkPrepared {\n");
    let [head, rest] = [(); 2].map(|()| parts.next().expect("both parts"));
    // What the robot itself has is what it was.
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
    // Neither fields nor structures of results are there twice.
    assert!(!rest.contains("self.load"), "{rest}");
    assert_eq!(parted.matches("pub struct ").count(), 3, "{parted}");
}

#[test]
fn nothing_is_prepared_where_there_is_nothing_to_prepare() {
    let arm = || Builder::from_urdf("../robots/two_link.urdf").prepare();
    let said = |builder: Builder| {
        builder
            .to_tokens()
            .map(|_| ())
            .expect_err("a mistake")
            .to_string()
    };
    assert_eq!(
        said(arm().generate([Function::Gravity])),
        "error: `prepare` computes once what depends on fields alone, and the robot has none\n  \
         hint: leave it out: all other numbers are folded into the code\n"
    );
    let unread = arm().generate([Function::ForwardKinematics]);
    assert_eq!(
        said(unread.parameter("load", Target::PayloadOn("tip".into()))),
        "error: `prepare` computes once what depends on fields alone, and no function reads one\n  \
         hint: leave it out, or ask for functions that read the fields\n"
    );
}

#[test]
fn a_range_that_a_field_cannot_have_is_told() {
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

//! Options of a build script and their effects; the stages are replaced by a simple one.

mod configurations;
mod fields;
mod languages;
mod reviewed;

use super::Builder;
use crate::description::Description;
use crate::error::{Errors, Place};
use crate::formulation::{Formulation, Products, Sines};
use crate::function::Function;
use crate::module::Module;
use crate::print::rust::tests::module;
use crate::real::Real;
use crate::request::{Request, Target};

const URDF: &str = r#"<robot name="double pendulum"><link name="world"/></robot>"#;

fn arm(expand: fn(&Description, &Request) -> Result<Module, Errors>) -> Builder {
    let mut errors = Errors::new();
    let description = crate::description::read_text(URDF, "pendulum.urdf", None, &mut errors);
    let builder = Builder::from_description(description.expect("it is a robot"));
    Builder { expand, ..builder }
}

#[expect(
    clippy::unnecessary_wraps,
    reason = "the stages it stands for can fail"
)]
fn as_asked(_: &Description, request: &Request) -> Result<Module, Errors> {
    Ok(Module {
        parameters: request.parameters.clone(),
        ..module(request.scalar)
    })
}

fn text(builder: &Builder) -> String {
    builder.to_source().expect("no mistakes").to_string()
}

#[test]
fn a_file_needs_nothing_but_core_and_sines() {
    let builder = arm(as_asked).generate([Function::Gravity]);
    let text = text(&builder.sin_cos("crate::fast::sin_cos").tip("rod-2"));
    for part in [
        "// Made by `homogen generate pendulum.urdf --tip rod-2 --functions gravity --sin-cos crate::fast::sin_cos` (FNV-1a ",
        "pub struct DoublePendulum;\n",
        "pub fn gravity(&self, q: &[f64; 2]) -> [f64; 2] {\n",
        "let (_, c_1) = crate::fast::sin_cos(q_1);\n",
    ] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn the_sines_of_the_platform_are_those_of_libm_unless_others_are_named() {
    let formulation = Formulation::default().with_sines(Sines::Platform);
    let builder = arm(as_asked).formulation(formulation);
    for (scalar, call) in [
        (Real::F32, "= ::libm::sincosf(q_1);\n"),
        (Real::F64, "= ::libm::sincos(q_1);\n"),
    ] {
        let text = text(&builder.clone().scalar(scalar));
        assert!(
            text.contains(call) && !text.contains("fn sin_cos"),
            "{text}"
        );
    }
    let text = text(&builder.sin_cos("crate::fast::sin_cos"));
    assert!(text.contains("= crate::fast::sin_cos(q_1);\n"), "{text}");
}

#[test]
fn with_the_runtime_it_is_what_a_derive_expands_to() {
    let builder = arm(as_asked).name("Arm").runtime("::homogen");
    let text = text(&builder);
    assert!(text.contains("pub struct Arm;\n"), "{text}");
    assert!(
        text.contains("::homogen::robot::Gravity<2, T> for Arm {"),
        "{text}"
    );
}

#[test]
fn batches_are_of_the_runtime() {
    let builder = arm(|description, request| {
        assert!(request.batch);
        as_asked(description, request)
    });
    let builder = builder.name("Arm").batch();
    let refused = builder.to_source().expect_err("no runtime").to_string();
    assert!(refused.contains("needs the runtime"), "{refused}");
    assert!(builder.runtime("::homogen").to_source().is_ok());
}

#[test]
fn every_option_reaches_the_stages() {
    let builder = arm(|_, request| {
        assert_eq!(request.scalar, Real::F32);
        assert_eq!(
            request.functions,
            [vec![Function::MassMatrix, Function::Bias]]
        );
        assert_eq!(request.base.as_ref().map(|base| &*base.text), Some("world"));
        assert!(request.exact && request.strict && request.path_only);
        assert_eq!(request.lock.len(), 2);
        assert_eq!(request.parameters.len(), 1);
        assert_eq!(request.formulation.words(), ["unfused"]);
        let mut errors = Errors::new();
        errors.push(Place::Unknown, "as asked");
        Err(errors)
    });
    let builder = builder
        .scalar(Real::F32)
        .base("world")
        .all_of([Function::MassMatrix, Function::Bias])
        .path_only()
        .exact()
        .strict()
        .lock("shoulder")
        .lock_at("elbow", 0.5)
        .formulation(Formulation::default().with_products(Products::Unfused))
        .parameter("field", Target::Gravity);
    let errors = builder.to_tokens().expect_err("as asked");
    assert_eq!(errors.to_string(), "error: as asked\n");
}

#[test]
fn all_options_that_are_not_rust_are_errors() {
    let builder = arm(as_asked)
        .name("fn")
        .sin_cos("1 + 1")
        .parameter("a b", Target::Gravity);
    let errors = builder.to_tokens().expect_err("three mistakes");
    assert_eq!(errors.diagnostics().len(), 3, "{errors}");
}

#[test]
fn a_missing_file_is_an_error() {
    let errors = Builder::from_urdf("no/such.urdf")
        .to_tokens()
        .expect_err("no file");
    assert!(errors.to_string().contains("such.urdf"), "{errors}");
}

#[test]
fn the_derive_writes_the_same() {
    let derived = crate::front_end::derive(
        quote::quote! {
            #[robot(urdf = "../robots/two_link.urdf", tip = "tip")]
            #[robot(generate(forward_kinematics, inverse_dynamics, all_of(mass_matrix, bias)))]
            pub struct TwoLink;
        },
        None,
    );
    let built = Builder::from_urdf("../robots/two_link.urdf")
        .tip("tip")
        .generate([Function::ForwardKinematics, Function::InverseDynamics])
        .all_of([Function::MassMatrix, Function::Bias])
        .runtime("::homogen")
        .to_tokens()
        .expect("a robot that ships");
    let (derived, built) = (derived.to_string(), built.to_string());
    // The derive has the struct already, and makes cargo watch the file.
    let (methods, watch) = derived.split_once("const _ :").expect("a watched file");
    assert!(watch.contains(":: core :: include_bytes !"), "{watch}");
    assert!(watch.contains("two_link.urdf"), "{watch}");
    let (declaration, built) = built.split_once("# [allow").expect("a block of methods");
    assert!(
        declaration.ends_with("pub struct TwoLink ; "),
        "{declaration}"
    );
    assert_eq!(methods.trim_end(), format!("# [allow{built}").trim_end());
}

/// The format of the description does not change the cost.
#[test]
fn a_robot_costs_the_same_in_every_format() {
    let counts = |builder: Builder| {
        let source = text(&builder.tip("tip").generate(Function::ALL));
        let counts = source.lines().filter(|line| line.contains(" mul, "));
        let counts: Vec<String> = counts.map(str::to_owned).collect();
        assert!(counts.len() >= Function::ALL.len(), "{counts:?}");
        counts
    };
    let of_urdf = counts(Builder::from_urdf("../robots/two_link.urdf"));
    for other in [
        Builder::from_mjcf("../robots/two_link.xml"),
        Builder::from_sdf("../robots/two_link.sdf"),
    ] {
        assert_eq!(counts(other), of_urdf);
    }
}

#[test]
fn a_real_arm_needs_nothing_but_core_and_sines() {
    let source = Builder::from_urdf("../robots/panda_class.urdf")
        .tip("link8")
        .scalar(Real::F32)
        .generate(Function::ALL);
    let text = text(&source);
    for function in Function::ALL {
        let signature = format!("pub fn {}(", function.name());
        assert!(text.contains(&signature), "{}", function.name());
    }
    assert!(!text.contains("homogen::") && !text.contains("_f64"));
}

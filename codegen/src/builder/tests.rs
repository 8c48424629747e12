//! The options of a build script, and what they lead to; the stages between are made by hand.

use super::Builder;
use crate::description::Description;
use crate::error::{Errors, Place};
use crate::formulation::{Formulation, Products, Sines};
use crate::function::Function;
use crate::print::Listing;
use crate::print::rust::tests::listing;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Request, Target};

const URDF: &str = r#"<robot name="double pendulum"><link name="world"/></robot>"#;

fn arm(expand: fn(&Description, &Request) -> Result<Listing, Errors>) -> Builder {
    let mut errors = Errors::new();
    let description = crate::description::read_text(URDF, "pendulum.urdf", None, &mut errors);
    let builder = Builder::from_description(description.expect("it is a robot"));
    Builder { expand, ..builder }
}

#[expect(
    clippy::unnecessary_wraps,
    reason = "the stages it stands for can fail"
)]
fn as_asked(_: &Description, request: &Request) -> Result<Listing, Errors> {
    Ok(Listing {
        parameters: request.parameters.clone(),
        ..listing(request.scalar)
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
    let formulation = Formulation {
        sines: Sines::Platform,
        ..Formulation::default()
    };
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
    assert!(refused.contains("batches are of the runtime"), "{refused}");
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
        .formulation(Formulation {
            products: Products::Unfused,
            ..Formulation::default()
        })
        .parameter("field", Target::Gravity);
    let errors = builder.to_tokens().expect_err("as asked");
    assert_eq!(errors.to_string(), "error: as asked\n");
}

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
    let doubts = |builder: Builder| builder.listing().expect("no mistakes").about.warnings;
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
        "/// What `tip` carries: its mass in kg",
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
        "    /// Results are the same, bit for bit;",
    ] {
        assert!(head.contains(part), "{head}");
    }
    for part in [
        "pub struct TwoLinkPrepared {\n    values: [f64; ",
        "impl TwoLinkPrepared {\n",
        "    /// Done before, once for all functions: ",
        ".values;\n",
        "= TwoLink::sin_cos(",
        ") -> TwoLinkInverseDynamicsDerivatives {",
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

#[test]
fn options_that_are_no_rust_are_all_told() {
    let builder = arm(as_asked)
        .name("fn")
        .sin_cos("1 + 1")
        .parameter("a b", Target::Gravity);
    let errors = builder.to_tokens().expect_err("three mistakes");
    assert_eq!(errors.complaints().len(), 3, "{errors}");
}

#[test]
fn c_has_names_of_its_own_and_no_runtime() {
    let errors = |builder: Builder| builder.to_c_header().expect_err("a mistake").to_string();
    let one = errors(arm(as_asked).extern_c("arm-"));
    assert_eq!(one, "error: no name in C begins with `arm-`\n");
    let other = errors(arm(as_asked).extern_c("arm_").runtime("::homogen"));
    assert!(other.contains("without the runtime"), "{other}");
    let header = arm(as_asked)
        .extern_c("arm_")
        .frames(["eye"])
        .parameter("payload", Target::MassOf("rod-2".into()))
        .to_c_header()
        .expect("no mistakes");
    let asked = " * Made by `homogen generate pendulum.urdf --frames eye --field payload=mass_of:rod-2 --extern-c arm_` ";
    assert!(header.contains(asked), "{header}");
    let none = arm(as_asked).to_c_header().expect("no mistakes");
    assert_eq!(none, "");
}

#[test]
fn the_same_in_c() {
    let builder = arm(as_asked).generate([Function::Gravity]).tip("rod-2");
    let source = builder.to_c("arm.h").expect("no mistakes");
    let asked = "--tip rod-2 --functions gravity --language c --output arm.c` ";
    assert!(source.header.contains(asked), "{}", source.header);
    assert!(source.text.contains("#include \"arm.h\"\n"));
    let name = |builder: Builder| builder.to_c("arm.h").expect("no mistakes").header;
    for (builder, function) in [
        (
            builder.clone(),
            "void double_pendulum_gravity(const double q[2]",
        ),
        (
            builder.clone().name("Arm").scalar(Real::F32),
            "void arm_gravity(const float q[2]",
        ),
        (
            builder.clone().name("Arm").extern_c("left_"),
            "void left_gravity(",
        ),
    ] {
        let header = name(builder);
        assert!(header.contains(function), "{header}");
    }
    let errors = builder.runtime("::homogen").sin_cos("crate::sin_cos");
    let errors = errors.to_c("arm.h").expect_err("two mistakes").to_string();
    assert!(errors.contains("the runtime is Rust's"), "{errors}");
    assert!(errors.contains("can be named in Rust only"), "{errors}");
}

#[test]
fn products_fuse_in_c_where_the_processor_can_and_never_in_core() {
    let builder = Builder::from_urdf("../robots/two_link.urdf").generate([Function::Gravity]);
    for (processor, fuses) in [
        (Processor::Portable, false),
        (Processor::CortexM7, false),
        (Processor::AArch64, true),
    ] {
        let builder = builder.clone().processor(processor);
        let source = builder.to_c("arm.h").expect("no mistakes");
        assert_eq!(source.text.contains("HOMOGEN_FMA"), fuses, "{processor:?}");
        assert!(!text(&builder).contains("mul_add"));
    }
}

#[test]
fn a_header_stands_beside_its_source() {
    let beside = |file: &str| super::c::header_beside(file.as_ref());
    let found = beside("src/arm.cu").expect("a name");
    assert_eq!(found, ("src/arm.h".into(), "arm.h".to_owned()));
    for file in ["arm.h", "a\"b.c", "a\\.c", "a??.c", "a\nb.c", "/"] {
        assert!(beside(file).is_err(), "{file}");
    }
}

#[test]
fn a_file_that_is_not_there_is_told() {
    let errors = Builder::from_urdf("no/such.urdf")
        .to_tokens()
        .expect_err("no file");
    assert!(errors.to_string().contains("such.urdf"), "{errors}");
}

#[test]
fn the_derive_writes_the_same() {
    let derived = crate::door::derive(quote::quote! {
        #[robot(urdf = "../robots/two_link.urdf", tip = "tip")]
        #[robot(generate(forward_kinematics, inverse_dynamics, all_of(mass_matrix, bias)))]
        pub struct TwoLink;
    });
    let built = Builder::from_urdf("../robots/two_link.urdf")
        .tip("tip")
        .generate([Function::ForwardKinematics, Function::InverseDynamics])
        .all_of([Function::MassMatrix, Function::Bias])
        .runtime("::homogen")
        .to_tokens()
        .expect("a robot that ships");
    let (derived, built) = (derived.to_string(), built.to_string());
    // One has the struct already, the other has cargo watch the file.
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

#[test]
fn a_package_for_python_has_no_options_of_rust() {
    let builder = arm(as_asked)
        .runtime("::homogen")
        .sin_cos("::libm::sincos")
        .extern_c("arm_")
        .processor(Processor::CortexM7)
        .drop("nothing")
        .generate([Function::Gravity]);
    let errors = builder.to_python("arm_py").expect_err("four mistakes");
    let told = errors.to_string();
    for part in [
        "its own batches",
        "can be named in Rust only",
        "files that need `core` alone",
        "finds its processor when it runs",
    ] {
        assert!(told.contains(part), "{told}");
    }
    let package = arm(as_asked)
        .generate([Function::Gravity])
        .to_python("Arm Py");
    assert_eq!(package.expect("no mistakes").module, "arm_py");
    let errors = arm(as_asked).to_python("numpy").expect_err("a mistake");
    assert!(errors.to_string().contains("would hide NumPy"), "{errors}");
}

#[test]
fn the_reviewer_of_a_file_reads_what_no_derive_has() {
    let builder = Builder::from_urdf("../robots/two_link.urdf")
        .tip("tip")
        .generate([Function::InverseDynamics]);
    let file = text(&builder);
    for part in [
        "// Made by `homogen generate two_link.urdf --tip tip --functions inverse_dynamics` (FNV-1a ",
        "// Needs: Rust 1.63 or later, edition 2018 or later, `core`.\n",
        "pub const JOINTS: [&'static str; 2] = [\"shoulder\", \"elbow\"];\n",
        "pub const LOWER: [f64; 2] = [-",
        "#[cfg(test)]\n",
        "\n    #[test]\n    fn inverse_dynamics() {\n",
        "//   `fore`\n",
        "//     q_x = 0.8 = `upper.q_x` + 0.4 `fore.m`\n",
    ] {
        assert!(file.contains(part), "{part}\n{file}");
    }
    let tokens = builder.to_tokens().expect("a robot that ships").to_string();
    assert!(!tokens.contains("JOINTS") && !tokens.contains("# [cfg (test)]"));
    let source = builder.to_c("arm.h").expect("a robot that ships");
    for part in [
        "#define TWO_LINK_LOWER {-",
        "#ifdef HOMOGEN_SELF_TEST\n",
        "HOMOGEN_FN int two_link_self_test(void);\n",
    ] {
        assert!(source.header.contains(part), "{}", source.header);
    }
    assert!(
        source
            .text
            .contains(" *     q_x = 0.8 = `upper.q_x` + 0.4 `fore.m`\n")
    );
}

#[test]
fn a_file_in_ascii_is_ascii_and_names_that_are_not_are_told() {
    let builder = Builder::from_urdf("../robots/two_link.urdf").ascii();
    let source = builder.to_c("arm.h").expect("a robot that ships");
    for text in [text(&builder), source.header, source.text] {
        assert!(text.is_ascii() && text.contains("--ascii"), "{text}");
    }
    let named = builder.parameter("maß", Target::MassOf("fore".into()));
    let told = named.to_source().map(|_| ()).expect_err("no ASCII");
    assert!(
        told.to_string().contains("`maß` is a name in the file"),
        "{told}"
    );
}

#[test]
fn what_a_shell_would_read_otherwise_stands_in_quotes() {
    let builder = arm(as_asked)
        .tip("it's; $(rm)")
        .lock_at("-j", -0.25)
        .damping("a b", [0.5, 1e-7])
        .gravity([0.0, 0.0, -1.62])
        .generate([Function::Gravity]);
    let header = builder.to_source().expect("no mistakes").to_string();
    let command = "homogen generate pendulum.urdf --tip 'it'\\''s; $(rm)' --lock=-j=-0.25 \
                   --gravity 0,0,-1.62 '--damping=a b=0.5,0.0000001' --functions gravity";
    assert!(header.contains(command), "{header}");
}

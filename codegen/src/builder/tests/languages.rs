//! Files in C and packages for Python by the builder.

use std::collections::BTreeSet;
use std::num::NonZeroUsize;

use super::{arm, as_asked, text};
use crate::builder::{Builder, c};
use crate::function::Function;
use crate::print::arrays::Order;
use crate::print::c::CSource;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::{Integrator, Target};

#[test]
fn c_has_names_of_its_own_and_no_runtime() {
    let errors = |builder: Builder| builder.to_c_header().expect_err("a mistake").to_string();
    let one = errors(arm(as_asked).extern_c("arm-"));
    assert_eq!(one, "error: `arm-` cannot begin a name in C\n");
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
fn python_is_a_module_for_any_library() {
    let builder = arm(as_asked).generate([Function::Gravity]).tip("rod-2");
    let text = |order| builder.to_plain_python(order).expect("no mistakes");
    let [linear, angular] = [Order::LinearFirst, Order::AngularFirst].map(text);
    let asked = "--tip rod-2 --functions gravity --language python` ";
    assert!(linear.contains(asked), "{linear}");
    let asked = "--language python --order angular-first` ";
    assert!(angular.contains(asked), "{angular}");
    assert!(linear.contains("def gravity(q, library=math):"), "{linear}");
    let other = builder
        .clone()
        .name("Arm")
        .ascii()
        .prepare()
        .section(NonZeroUsize::MIN);
    let other = other
        .runtime("::homogen")
        .sin_cos("crate::sin_cos")
        .extern_c("arm_");
    let other = other.processor(Processor::CortexM4);
    let errors = other.to_plain_python(Order::LinearFirst);
    let errors = errors.expect_err("eight mistakes").to_string();
    for option in [
        "name",
        "ascii",
        "prepare",
        "section",
        "runtime",
        "sin_cos",
        "extern_c",
        "processor",
    ] {
        let message = format!("`{option}` is for compiled languages, and not for Python");
        assert!(errors.contains(&message), "{errors}");
    }
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
    assert!(errors.contains("`runtime` is for Rust"), "{errors}");
    assert!(errors.contains("`sin_cos` is for Rust only"), "{errors}");
}

/// A robot that ships.
fn two_link() -> Builder {
    let root = env!("CARGO_MANIFEST_DIR");
    Builder::from_urdf(format!("{root}/../robots/two_link.urdf"))
}

#[test]
fn a_header_of_cpp_has_templates_in_a_namespace() {
    let builder = two_link()
        .generate([Function::Gravity, Function::KineticEnergy])
        .parameter("payload", Target::MassOf("fore".into()));
    let text = builder
        .to_cpp("arm.hpp", Order::AngularFirst)
        .expect("no mistakes");
    for part in [
        " --functions gravity,kinetic_energy --field payload=mass_of:fore --language cpp --output arm.hpp`",
        "\nnamespace two_link {\n",
        "inline constexpr std::size_t NQ = 2;\n",
        "inline constexpr std::array<double, 2> NEUTRAL = {0.0, 0.0};\n",
        "template <class P = double>\nstruct Robot {\n    P payload; ",
        "template <class P, class Q>\nauto gravity(const Robot<P>& robot, const Q& q)\n{\n    using T = detail::scalar<P, \
         decltype(q[0])>;\n    detail::check<2, Q>();\n    std::array<T, 2> gravity;\n    const T q_1 = T(q[0]);\n",
        "    const T payload = T(robot.payload);\n",
        "    return gravity;\n}\n",
        "    T kinetic_energy;\n",
        "    kinetic_energy = ",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let jacobian = two_link().generate([Function::GeometricJacobian]);
    let text = jacobian.to_cpp("arm.hpp", Order::LinearFirst);
    let text = text.expect("no mistakes");
    for part in [
        " --language cpp --order linear-first --output arm.hpp`",
        "the linear three, then the angular three.",
        "order: b, u.",
        "geometric_jacobian[1][4] = T(-1.0);\n",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let other = builder.prepare().section(NonZeroUsize::MIN).casadi();
    let errors = other
        .to_cpp("arm.hpp", Order::AngularFirst)
        .expect_err("three mistakes")
        .to_string();
    for option in ["`prepare`", "`section`", "`casadi`"] {
        assert!(errors.contains(option), "{errors}");
    }
}

#[test]
fn the_interface_of_casadi_is_for_c_in_f64() {
    let functions = [
        Function::Gravity,
        Function::GravityDerivative,
        Function::Bias,
    ];
    let builder = two_link().generate(functions).casadi();
    let text = builder.to_c("arm.h").expect("no mistakes").text;
    for part in [
        " --functions gravity,gravity_derivative,bias --casadi --language c",
        "/* two_link_casadi_gravity: (q) -> (gravity)\n */\n",
        "/* jac_two_link_casadi_gravity: (q, out_gravity) -> (jac_gravity_q)\n */\n",
        "/* adj1_two_link_casadi_gravity: (q, out_gravity, adj_gravity) -> (adj_q)\n */\n",
        " * Without derivatives:\n * two_link_casadi_bias: they need `inverse_dynamics_derivatives`\n",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(!text.contains("jac_adj1_") && !text.contains("jac_two_link_casadi_bias"));
    // A gradient needs no matrix.
    let functions = [Function::Bias, Function::InverseDynamicsVjp];
    let gradient = two_link().generate(functions).casadi();
    let gradient = gradient.to_c("arm.h").expect("no mistakes").text;
    assert!(gradient.contains(
        "/* adj1_two_link_casadi_bias: (q, qd, out_bias, adj_bias) -> (adj_q, adj_qd)\n */\n"
    ));
    assert!(!gradient.contains("jac_two_link_casadi_bias"));
    let without = builder.clone().to_c("arm.h").expect("no mistakes");
    assert!(!without.header.contains("casadi_"), "{}", without.header);
    let errors = [
        builder.to_source().map(|_| ()),
        builder.to_llvm(NonZeroUsize::MIN).map(|_| ()),
        builder.to_plain_python(Order::LinearFirst).map(|_| ()),
        builder.clone().scalar(Real::F32).to_c("arm.h").map(|_| ()),
        builder.extern_c("jac_").to_c("arm.h").map(|_| ()),
    ];
    let errors = errors.map(|found| found.expect_err("a mistake").to_string());
    for (error, part) in errors.iter().zip([
        "`casadi` is for C only",
        "`casadi` is for C only",
        "`casadi` is for C only",
        "`casadi` is for numbers of f64",
        "the prefix `jac_` for those of derivatives",
    ]) {
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_folder_of_c_has_each_definition_once() {
    let functions = [Function::Gravity, Function::InverseDynamics];
    let builder = Builder::from_urdf("../robots/quadruped.urdf").floating();
    let builder = builder.generate(functions);
    let builder = builder.section(NonZeroUsize::new(300).expect("not zero"));
    let module = builder.c_module().expect("no mistakes");
    let one = builder.c(&module, "quadruped.h");
    let files = builder.c_files(&module, "quadruped.h");
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        [
            "quadruped.h",
            "quadruped.c",
            "quadruped_gravity.c",
            "quadruped_inverse_dynamics.c"
        ]
    );
    assert_eq!(files[0].1, one.header);
    let definitions = |text: &str| -> BTreeSet<String> {
        let parts = text.split("\nHOMOGEN_FN HOMOGEN_CLONES ").skip(1);
        let bodies = parts.map(|part| part.split("\n}\n").next().unwrap_or_default().to_owned());
        bodies.collect()
    };
    let mut apart = BTreeSet::new();
    for (name, text) in &files[1..] {
        let own = definitions(text);
        assert!(own.is_disjoint(&apart) && !own.is_empty(), "{name}");
        apart.extend(own);
    }
    assert_eq!(apart, definitions(&one.text));
    // Configurations move by functions of the first source, whose sines the others have if they need them.
    let has = |file: usize, part: &str| files[file].1.contains(part);
    assert!(has(1, "void quadruped_integrate(") && has(1, "self_test(void)"));
    assert!(has(3, "void quadruped_inverse_dynamics_section_") && has(3, "_sin_cos(double "));
}

#[test]
fn time_steps_and_acados_are_for_c_and_coordinates_that_are_added() {
    let dynamics = [
        Function::ForwardDynamics,
        Function::ForwardDynamicsDerivatives,
    ];
    let builder = two_link()
        .generate(dynamics)
        .steps(Integrator::Rk4)
        .acados();
    let CSource { header, text } = builder.to_c("arm.h").expect("no mistakes");
    assert!(
        text.contains(" --steps rk4 --acados --language c"),
        "{text}"
    );
    for name in ["two_link_step(", "two_link_step_derivatives("] {
        assert!(header.contains(name) && text.contains(name), "{header}");
    }
    assert!(!header.contains("step_hessian") && !text.contains("acados_fun_jac_hess(void"));
    let floating = Builder::from_urdf("../robots/quadruped.urdf").floating();
    let floating = floating.generate([Function::ForwardDynamics]);
    let rod = "pin: rod(0.5) { from: fore, to: base, at: xyz(0.3, 0, 0) }";
    let closed = two_link().generate(dynamics).closed(rod);
    let field = two_link()
        .generate(dynamics)
        .parameter("payload", Target::MassOf("fore".into()));
    let errors = [
        builder.to_source().map(|_| ()),
        builder.to_cpp("arm.hpp", Order::AngularFirst).map(|_| ()),
        builder.clone().scalar(Real::F32).to_c("arm.h").map(|_| ()),
        floating.steps(Integrator::Euler).to_c("arm.h").map(|_| ()),
        closed.steps(Integrator::Euler).to_c("arm.h").map(|_| ()),
        two_link()
            .generate([Function::Gravity])
            .steps(Integrator::Euler)
            .to_c("arm.h")
            .map(|_| ()),
        two_link()
            .generate(dynamics)
            .acados()
            .to_c("arm.h")
            .map(|_| ()),
        field
            .steps(Integrator::Euler)
            .acados()
            .to_c("arm.h")
            .map(|_| ()),
        two_link()
            .generate(dynamics)
            .steps(Integrator::ImplicitMidpoint)
            .to_c("arm.h")
            .map(|_| ()),
        two_link()
            .generate([Function::InverseDynamics])
            .steps(Integrator::ImplicitMidpoint)
            .acados()
            .to_c("arm.h")
            .map(|_| ()),
    ];
    let errors = errors.map(|found| found.expect_err("a mistake").to_string());
    for (error, part) in errors.iter().zip([
        "`steps` is for C only",
        "`steps` is for C only",
        "`acados` is for numbers of f64",
        "joint `root` has others",
        "`steps` is not for robots with loops",
        "`steps` needs the function forward_dynamics",
        "`acados` needs `steps`",
        "`acados` has no place for fields",
        "`steps` needs the function inverse_dynamics",
        "the midpoint rule is an equation for it",
    ]) {
        assert!(error.contains(part), "{error}");
    }
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
    let beside = |file: &str| c::header_beside(file.as_ref());
    let found = beside("src/arm.cu").expect("a name");
    assert_eq!(found, ("src/arm.h".into(), "arm.h".to_owned()));
    for file in ["arm.h", "a\"b.c", "a\\.c", "a??.c", "a\nb.c", "/"] {
        assert!(beside(file).is_err(), "{file}");
    }
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
    let errors = errors.to_string();
    for part in [
        "its own batches",
        "`sin_cos` is for Rust only",
        "files that need only `core`",
        "selects the processor at run time",
    ] {
        assert!(errors.contains(part), "{errors}");
    }
    let package = arm(as_asked)
        .generate([Function::Gravity])
        .to_python("Arm Py");
    assert_eq!(package.expect("no mistakes").module, "arm_py");
    let errors = arm(as_asked).to_python("numpy").expect_err("a mistake");
    assert!(errors.to_string().contains("would hide NumPy"), "{errors}");
}

/// The name of a struct without fields is a pattern, which would match instead of binding.
#[test]
fn a_struct_may_be_called_as_what_files_bind() {
    let builder = Builder::from_urdf("../robots/two_link.urdf").generate([Function::Gravity]);
    let file = |name: &str| text(&builder.clone().name(name));
    for (name, parts) in [
        (
            "q",
            [
                "pub fn gravity(&self, q_: &[f64; 2])",
                "let [q_1, q_2] = *q_;",
                "use super::q as Robot;",
            ],
        ),
        (
            "near",
            [
                "pub fn gravity(&self, q: &[f64; 2])",
                "let near_ = z * SINE[1] + SINE[0];",
                "use super::near as Robot;",
            ],
        ),
        (
            "gen",
            ["pub struct r#gen;", "mod gen_vectors", "use super::r#gen;"],
        ),
        (
            "f64",
            ["pub struct f64_;", "mod f64_vectors", "use super::f64_;"],
        ),
    ] {
        let file = file(name);
        for part in parts {
            assert!(file.contains(part), "{part}\n{file}");
        }
    }
}

/// Texts are assembled from parts, and never searched for words of a template.
#[test]
fn a_robot_may_be_called_as_a_word_of_a_template() {
    let builder = Builder::from_urdf("../robots/two_link.urdf").generate([Function::Gravity]);
    for (name, sines, test) in [
        (
            "robot",
            "robot_turn robot_sin_cos(double angle)",
            "int robot_self_test(void)",
        ),
        (
            "Robot_Mul_Add",
            "robot_mul_add_turn robot_mul_add_sin_cos(double angle)",
            "int robot_mul_add_self_test(void)",
        ),
    ] {
        let source = builder
            .clone()
            .name(name)
            .to_c("arm.h")
            .expect("no mistakes");
        for part in [sines, test] {
            assert!(source.text.contains(part), "{part}\n{}", source.text);
        }
        assert!(!source.text.contains("robot_MUL_ADD"), "{}", source.text);
    }
}

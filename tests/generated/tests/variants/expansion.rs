//! Generated code: the text for small robots, operation counts for all of them.
//!
//! Text is pinned so that changes are reviewed; counts so that none rises unnoticed. All front ends must give the same
//! code, and the same bytes each time.

use std::fmt::Write;

use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{Description, Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::formulation::{Formulation, Forward, Parameters, Products, Sines};
use homogen_codegen::print::rust::{self, FormattedSource, Item, Library};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::OperationCount;
use homogen_codegen::space::FrameId;
use homogen_codegen::{Builder, Function, Real, front_end};
use homogen_tests::programs::program;
use quote::{format_ident, quote};

/// Lines of a snapshot that can be read in a review.
const READABLE: usize = 240;

fn path(robot: &str) -> String {
    format!("{}/../../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"))
}

fn named(text: &str) -> Name {
    Name {
        text: text.to_owned(),
        ..Name::default()
    }
}

fn described(robot: &str) -> Description {
    let mut errors = Errors::new();
    let description = read_file(path(robot).as_ref(), None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("it is a robot")
}

fn chain_of(robot: &str, tip: &str) -> Chain {
    let request = Request {
        tip: Some(named(tip)),
        ..Request::default()
    };
    chain::build(&described(robot), &request)
        .unwrap_or_else(|errors| panic!("{errors}"))
        .identified()
}

/// The file of a builder, short enough for a review.
fn file(builder: &Builder) -> String {
    let source = builder
        .to_source()
        .unwrap_or_else(|errors| panic!("{errors}"));
    let text = source.to_string();
    assert!(text.lines().count() <= READABLE, "{text}");
    text
}

#[test]
fn inverse_dynamics_of_two_links() {
    let builder = Builder::from_urdf(path("two_link")).generate([Function::InverseDynamics]);
    insta::assert_snapshot!(file(&builder.runtime("::homogen")));
}

#[test]
fn pose_and_jacobian_of_two_links() {
    let builder = Builder::from_urdf(path("two_link"));
    let builder = builder.all_of([Function::ForwardKinematics, Function::GeometricJacobian]);
    insta::assert_snapshot!(file(&builder.runtime("::homogen")));
}

#[test]
fn mass_matrix_of_two_links_for_core_alone() {
    let builder = Builder::from_urdf(path("two_link")).generate([Function::MassMatrix]);
    insta::assert_snapshot!(file(&builder));
}

#[test]
fn inverse_dynamics_of_a_scara_in_single_precision_for_core_alone() {
    let builder = Builder::from_urdf(path("scara")).generate([Function::InverseDynamics]);
    insta::assert_snapshot!(file(&builder.scalar(Real::F32)));
}

#[test]
fn a_pendulum_with_a_field() {
    let tokens = quote! {
        #[robot(
            gravity = [0.0, -9.81, 0.0],
            generate(inverse_dynamics);
            link wall;
            joint hinge: revolute(z) { limits: [-3, 3] }
            link rod { mass: 0.5, com: [0.5, 0.0, 0.0], inertia: [0.0, 0.01, 0.01] }
            joint weld: fixed { at: xyz(1.0, 0.0, 0.0) }
            link bob
        )]
        struct Pendulum {
            #[robot(mass_of = bob)]
            bob: f64,
        }
    };
    let text = FormattedSource::new("", &front_end::derive(tokens, None)).to_string();
    assert!(text.lines().count() <= READABLE, "{text}");
    insta::assert_snapshot!(text);
}

/// The operation count of a function, for a row of the table.
fn operation_count(chain: &Chain, function: Function) -> OperationCount {
    let program = program(chain, &[function], FrameId::FIRST, Real::Generic);
    OperationCount::of(&program.unwrap_or_else(|errors| panic!("{errors}")))
}

#[test]
fn prices_of_every_robot() {
    let mut table = String::new();
    let robots = [
        ("two_link", "tip"),
        ("scara", "tool"),
        ("stanford", "tool"),
        ("stanford_general", "tool"),
        ("puma560", "tool"),
        ("puma560_general", "tool"),
        ("ur5_class", "tool0"),
        ("panda_class", "link8"),
        ("quadruped", "hr_foot"),
    ];
    for (robot, tip) in robots {
        let chain = chain_of(robot, tip);
        writeln!(
            table,
            "{robot:29} mul  add  div sqrt  sin  cos fused depth literals"
        )
        .expect("a string takes everything");
        for function in Function::ALL {
            let OperationCount {
                mul,
                add,
                div,
                sqrt,
                sin,
                cos,
                fused,
                depth,
                literals,
                ..
            } = operation_count(&chain, function);
            writeln!(
                table,
                "  {:28}{mul:4} {add:4} {div:4} {sqrt:4} {sin:4} {cos:4} {fused:5} {depth:5} {literals:8}",
                function.name()
            )
            .expect("a string takes everything");
        }
    }
    insta::assert_snapshot!(table);
}

/// The counts that the project has published.
#[test]
fn no_operation_count_rises_above_the_published_one() {
    let panda = chain_of("panda_class", "link8");
    let price_of = |function| operation_count(&panda, function);
    let inverse_dynamics = price_of(Function::InverseDynamics);
    assert!(
        inverse_dynamics.mul + inverse_dynamics.add <= 605,
        "{inverse_dynamics}"
    );
    assert!(inverse_dynamics.mul <= 320, "{inverse_dynamics}");
    assert!(
        inverse_dynamics.sin + inverse_dynamics.cos <= 12,
        "{inverse_dynamics}"
    );
    for (function, bar) in [(Function::MassMatrix, 420), (Function::Gravity, 102)] {
        let operation_count = price_of(function);
        assert!(
            operation_count.mul + operation_count.add <= bar,
            "{function:?}: {operation_count}"
        );
    }
    for (robot, bar) in [("stanford_general", 436), ("puma560_general", 499)] {
        let operation_count = operation_count(&chain_of(robot, "tool"), Function::InverseDynamics);
        assert!(
            operation_count.mul + operation_count.add <= bar,
            "{robot}: {operation_count}"
        );
    }
}

/// The two-link arm of robots/, in the grammar of `chain!`.
const INLINE: &str = "
    link base;
    joint shoulder: revolute(z) { at: rx(pi/2), limits: [-3, 3] }
    link upper { mass: 2.0, com: [0.2, 0, 0], inertia: [0.002, 0.03, 0.03] }
    joint elbow: revolute(z) { at: xyz(0.4, 0, 0) }
    link fore { mass: 1.0, com: [0.15, 0, 0], inertia: [0.001, 0.01, 0.01] }
    joint tip_fixed: fixed { at: xyz(0.3, 0, 0) }
    link tip";

/// The methods and traits of formatted code.
///
/// Left out: comments, which state the origin; attributes; the struct, which a derive does not write; the constants
/// before the first method, since limits differ; and the constant by which the compiler watches a file.
fn methods(text: &str) -> String {
    text.lines()
        .skip_while(|line| !line.contains(" fn "))
        .take_while(|line| !line.starts_with("const _"))
        .filter(|line| !line.trim().is_empty())
        .filter(|line| !line.trim().starts_with("//") && !line.trim().starts_with("#["))
        .flat_map(|line| [line, "\n"])
        .collect()
}

#[test]
fn every_front_end_gives_the_same_code() {
    front_ends("", Formulation::default());
}

#[test]
fn every_front_end_gives_the_same_formulation() {
    let formulation = Formulation::default()
        .with_parameters(Parameters::Raw)
        .with_forward(Forward::Articulated)
        .with_products(Products::Unfused)
        .with_sines(Sines::Platform);
    let formulated = front_ends("raw, articulated, unfused, platform_sines", formulation);
    assert!(!formulated.contains("mul_add") && !formulated.contains("sin_cos_all"));
    assert!(formulated != front_ends("", Formulation::default()));
}

/// The code of every front end except the command line; the formulation as words and as data.
fn front_ends(words: &str, formulation: Formulation) -> String {
    let functions = Function::ALL;
    let names = functions.map(|function| format_ident!("{}", function.name()));
    let inline: proc_macro2::TokenStream = INLINE.parse().expect("tokens");
    let words: proc_macro2::TokenStream = words.parse().expect("tokens");
    let source = |tokens| FormattedSource::new("", &tokens).to_string();

    let derived = source(front_end::derive(
        quote! {
            #[robot(urdf = "../../robots/two_link.urdf", generate(#(#names),*), formulation(#words))]
            pub struct TwoLink;
        },
        None,
    ));
    let by_chain = source(front_end::chain(
        quote! {
            pub struct TwoLink { generate(#(#names),*), formulation(#words) }
            #inline
        },
        None,
    ));
    let by_attribute = source(front_end::derive(
        quote! {
            #[robot(generate(#(#names),*), formulation(#words); #inline)]
            pub struct TwoLink;
        },
        None,
    ));
    let builder = Builder::from_urdf(path("two_link")).generate(functions);
    let builder = builder.formulation(formulation).runtime("::homogen");
    let built = source(builder.to_tokens().expect("no mistakes"));
    let request = Request {
        functions: functions.map(|function| vec![function]).to_vec(),
        formulation,
        ..Request::default()
    };
    let module = expand(&described("two_link"), &request).expect("no mistakes");
    let item = Item::named_after("two link");
    let by_library = source(rust::print(&module, &item, &Library::default()));

    let expected = methods(&derived);
    // Each function is a method, its equations and a trait method; `chain` is one more.
    assert_eq!(
        expected.matches(" fn ").count(),
        3 * functions.len() + 1,
        "{expected}"
    );
    for (front_end, text) in [
        ("chain!", by_chain),
        ("attribute", by_attribute),
        ("builder", built),
        ("library", by_library),
    ] {
        let methods = methods(&text);
        assert!(
            methods == expected,
            "{front_end}:\n{methods}\nderive:\n{expected}"
        );
    }
    expected
}

/// An arm, a tree, and a robot with a sliding joint. The hash maps of each run have another seed.
#[test]
fn the_same_bytes_each_time() {
    for (robot, tip) in [
        ("scara", "tool"),
        ("panda_class", "link8"),
        ("quadruped", "hr_foot"),
    ] {
        let expanded = || {
            let builder = Builder::from_urdf(path(robot)).tip(tip);
            let builder = builder.generate(Function::ALL).runtime("::homogen");
            builder.to_source().expect("no mistakes").to_string()
        };
        assert!(expanded() == expanded(), "{robot}");
    }
}

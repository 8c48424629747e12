//! Every number and every line of code of the README, computed anew.
//!
//! In: the README and the robots. Out: nothing where they agree; else the line that should stand
//! there. Its blocks of Rust are compiled as well, as tests of the documentation. It never looks at
//! times: they belong to the machine that is named beside them.

use std::fmt::Write;
use std::path::Path;

use homogen_codegen::description::{Name, read_file, read_text};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::{expand, program_as, understand};
use homogen_codegen::formulation::{Angles, Formulation, Frame, Parameters};
use homogen_codegen::print::rust::{Item, Source, World, methods};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::Price;
use homogen_codegen::{Function, Real};
use homogen_examples::price::{self, Prices};

const README: &str = include_str!("../../README.md");

macro_rules! prices {
    ($robot:literal, $tip:literal) => {{
        let file = concat!($robot, ".urdf");
        let text = include_str!(concat!("../../robots/", $robot, ".urdf"));
        price::count(file, text, $tip).expect("the robots that ship have no mistakes")
    }};
}

#[test]
fn the_example_is_the_program() {
    let program = include_str!("../src/bin/quick_start.rs");
    let code = program.lines().filter(|line| !line.starts_with("//!"));
    let code: Vec<_> = code.skip_while(|line| line.is_empty()).collect();
    assert_contains(&format!("```rust\n{}\n```\n", code.join("\n")));
}

#[test]
fn the_expansion_is_what_the_code_generator_prints() {
    let text = include_str!("../../robots/two_link.urdf");
    let mut errors = Errors::new();
    let robot = read_text(text, "two_link.urdf", None, &mut errors).expect("it is a robot");
    let request = Request {
        functions: vec![vec![Function::InverseDynamics]],
        ..Request::default()
    };
    let listing = expand(&robot, &request).expect("it has no mistakes");
    let methods = methods(&listing, &Item::named_after("two link"), &World::default());
    let source = Source::new("", &methods).to_string();
    assert_contains(&format!("```rust,ignore\n{source}```\n"));
}

#[test]
fn the_prices_of_the_functions_are_those_of_the_doc_comments() {
    let prices = prices!("panda_class", "link8");
    for function in Function::ALL {
        let name = function.name();
        let price = prices.of(function);
        let (mul, add) = (price.mul, price.add);
        // The table of joints, which comes later, has a row for each function as well.
        let (table, _) = README.split_once("<!-- joints -->").expect("it is there");
        let rows = (table.lines()).filter(|line| line.starts_with(&format!("| `{name}` |")));
        let rows: Vec<_> = rows.collect();
        let end = format!(" | {mul} | {add} |");
        assert!(
            rows.len() == 1 && rows[0].ends_with(&end),
            "`{name}` should have one row that ends with{end}: {rows:?}"
        );
    }
}

#[test]
fn the_output_shown_has_the_prices_of_today() {
    let prices = prices!("panda_class", "link8");
    let all = Function::ALL.into_iter();
    for function in all.filter(|&function| function != Function::BaseRegressor) {
        let price = prices.of(function);
        let start = format!(
            "  {:<28} {:>4} {:>4} {:>4} {:>5} ",
            function.name(),
            price.mul,
            price.add,
            price.sin + price.cos,
            price.naive_mul + price.naive_add
        );
        assert_contains(&start);
    }
}

#[test]
fn the_counts_beside_published_ones_are_those_of_today() {
    let robots = [
        (
            "[Stanford](robots/stanford_general.urdf)",
            prices!("stanford_general", "tool"),
        ),
        (
            "[PUMA 560](robots/puma560_general.urdf)",
            prices!("puma560_general", "tool"),
        ),
        (
            "[Panda class](robots/panda_class.urdf)",
            prices!("panda_class", "link8"),
        ),
    ];
    for (name, prices) in &robots {
        let cell = |function| count(prices, function);
        let start = format!("| {name} | {} | ", cell(Function::InverseDynamics));
        let rows = README.lines().filter(|line| line.starts_with(&start));
        let mass = format!(" | {} | ", cell(Function::MassMatrix));
        let found = rows.filter(|line| line.contains(&mass)).count();
        assert_eq!(found, 1, "{start}…{mass}");
    }
}

#[test]
fn the_prices_of_formulations_are_those_of_today() {
    let columns = {
        let (plain, frame) = (Formulation::default(), Frame::Base);
        let (angles, parameters) = (Angles::Merged, Parameters::Raw);
        [
            plain,
            Formulation { angles, ..plain },
            Formulation {
                parameters,
                ..plain
            },
            Formulation { frame, ..plain },
            Formulation {
                frame,
                parameters,
                ..plain
            },
        ]
    };
    for (name, robot, tip, function) in [
        (
            "Panda class",
            "panda_class",
            "link8",
            Function::InverseDynamics,
        ),
        (
            "PUMA 560",
            "puma560_general",
            "tool",
            Function::InverseDynamics,
        ),
        (
            "PUMA 560",
            "puma560_general",
            "tool",
            Function::ForwardKinematics,
        ),
        ("UR5 class", "ur5_class", "tool0", Function::MassMatrix),
        (
            "quadruped",
            "quadruped",
            "hr_foot",
            Function::ForwardDynamics,
        ),
    ] {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let file = root.join(format!("robots/{robot}.urdf"));
        let mut errors = Errors::new();
        let description = read_file(&file, None, &mut errors).expect("it is a robot");
        let request = Request {
            tip: Some(Name {
                text: tip.to_owned(),
                ..Name::default()
            }),
            ..Request::default()
        };
        let chain = understand(&description, &request).expect("it has no mistakes");
        let mut row = format!("| {name}, `{}` |", function.name());
        for formulation in columns {
            let program = program_as(formulation, &chain, &[function], 0, Real::Generic);
            let price = Price::of(&program.expect("it has forward dynamics"));
            // Writing to a string cannot fail.
            let _ = write!(row, " {}/{} |", price.mul, price.add);
        }
        assert_contains(&format!("{row}\n"));
    }
}

#[test]
fn files_that_are_named_are_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut missing = String::new();
    let links = README
        .split("](")
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    let links = links.filter(|link| !link.starts_with('#'));
    let programs = README
        .split("--bin ")
        .skip(1)
        .filter_map(|rest| rest.split_whitespace().next());
    // Examples are one file each; what tests at length is a file or a folder of the tests.
    let programs = programs.map(|name| match name.trim_matches('`') {
        name @ "mutations" => format!("tests/src/bin/{name}/main.rs"),
        name @ ("fire" | "trees") => format!("tests/src/bin/{name}.rs"),
        name => format!("examples/src/bin/{name}.rs"),
    });
    for path in links.map(str::to_owned).chain(programs) {
        let path = path.split('#').next().unwrap_or_default();
        if !root.join(path).exists() {
            // Writing to a string cannot fail.
            let _ = writeln!(missing, "{path}");
        }
    }
    assert_eq!(missing, "");
}

fn count(prices: &Prices, function: Function) -> String {
    let price = prices.of(function);
    format!("{}/{}", price.mul, price.add)
}

fn assert_contains(part: &str) {
    assert!(README.contains(part), "the README lacks\n{part}");
}

//! Every operation count and every generated line of code in the guide, computed again.
//!
//! In: its chapters and the robots. A failed test prints the expected line. Documentation tests compile the blocks of
//! Rust. Times are not checked; they belong to the machine that is named beside them.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::rc::Rc;

use homogen_codegen::Function;
use homogen_codegen::description::{Name, read_file};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::formulation::{Angles, Formulation, Frame, Parameters};
use homogen_codegen::plan::{Programs, plan};
use homogen_codegen::request::Request;
use homogen_codegen::space::FrameId;
use homogen_examples::operation_count::{self, OperationCounts};
use homogen_examples::{bound, listing};

const ACCURACY: &str = include_str!("../../guide/src/accuracy.md");
const FORMULATIONS: &str = include_str!("../../guide/src/formulations.md");
const FUNCTIONS: &str = include_str!("../../guide/src/functions.md");
const GENERATED_CODE: &str = include_str!("../../guide/src/generated-code.md");

macro_rules! operation_counts {
    ($robot:literal, $tip:literal) => {{
        let file = concat!($robot, ".urdf");
        let text = include_str!(concat!("../../robots/", $robot, ".urdf"));
        operation_count::count(file, text, $tip).expect("the robots of the repository are valid")
    }};
}

#[test]
fn the_expansion_is_what_the_code_generator_prints() {
    let source = listing::inverse_dynamics_of_two_links().expect("it is valid");
    let block = format!("```rust,ignore\n{source}```\n");
    assert_contains(GENERATED_CODE, &block);
}

#[test]
fn the_counts_of_the_functions_are_those_of_the_doc_comments() {
    let operation_counts = operation_counts!("panda_class", "link8");
    for function in Function::ALL {
        let name = function.name();
        let operation_count = operation_counts.of(function);
        let (mul, add) = (operation_count.mul, operation_count.add);
        let rows = (FUNCTIONS.lines()).filter(|line| line.starts_with(&format!("| `{name}` |")));
        let rows: Vec<_> = rows.collect();
        let end = format!(" | {mul} | {add} |");
        assert!(
            rows.len() == 1 && rows[0].ends_with(&end),
            "`{name}` should have one row that ends with{end}: {rows:?}"
        );
    }
}

#[test]
fn the_output_shown_has_the_current_counts() {
    let operation_counts = operation_counts!("panda_class", "link8");
    for function in bound::functions() {
        let operation_count = operation_counts.of(function);
        let start = format!(
            "  {:<38} {:>4} {:>4} {:>4} {:>5} ",
            function.name(),
            operation_count.mul,
            operation_count.add,
            operation_count.sin + operation_count.cos,
            operation_count.naive_mul + operation_count.naive_add
        );
        assert_contains(ACCURACY, &start);
    }
}

#[test]
fn the_counts_beside_published_ones_are_current() {
    let robots = [
        (
            "[Stanford](../../robots/stanford_general.urdf)",
            operation_counts!("stanford_general", "tool"),
        ),
        (
            "[PUMA 560](../../robots/puma560_general.urdf)",
            operation_counts!("puma560_general", "tool"),
        ),
        (
            "[Panda class](../../robots/panda_class.urdf)",
            operation_counts!("panda_class", "link8"),
        ),
    ];
    for (name, operation_counts) in &robots {
        let cell = |function| count(operation_counts, function);
        let start = format!("| {name} | {} | ", cell(Function::InverseDynamics));
        let rows = ACCURACY.lines().filter(|line| line.starts_with(&start));
        let mass = format!(" | {} | ", cell(Function::MassMatrix));
        let found = rows.filter(|line| line.contains(&mass)).count();
        assert_eq!(found, 1, "{start}…{mass}");
    }
}

#[test]
fn the_counts_of_formulations_are_current() {
    let columns = {
        let (plain, frame) = (Formulation::default(), Frame::Base);
        let (angles, parameters) = (Angles::Merged, Parameters::Raw);
        [
            plain,
            plain.with_angles(angles),
            plain.with_parameters(parameters),
            plain.with_frame(frame),
            plain.with_frame(frame).with_parameters(parameters),
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
        let mut chain = understand(&description, &request).expect("it is valid");
        let mut row = format!("| {name}, `{}` |", function.name());
        for formulation in columns {
            Rc::make_mut(&mut chain.request).formulation = formulation;
            let plan = plan(&Programs::of(&chain), vec![function], FrameId::FIRST);
            let operation_count = plan.expect("it has forward dynamics").operation_count;
            // Writing to a string cannot fail.
            let _ = write!(row, " {}/{} |", operation_count.mul, operation_count.add);
        }
        assert_contains(FORMULATIONS, &format!("{row}\n"));
    }
}

/// A chapter must be in the contents, and in the list of pages that are compiled.
#[test]
fn every_chapter_is_in_the_contents_and_is_compiled() {
    let contents = include_str!("../../guide/src/SUMMARY.md");
    let compiled = include_str!("../src/lib.rs");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../guide/src");
    let entries = fs::read_dir(root).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("readable").file_name());
    let names = names.map(|name| name.into_string().expect("a name"));
    let names: Vec<String> = names.filter(|name| name != "SUMMARY.md").collect();
    assert!(names.len() > 10);
    for name in names {
        assert!(
            contents.contains(&format!("]({name})")),
            "{name} is in no list"
        );
        assert!(
            compiled.contains(&format!("/{name}\"")),
            "{name} is not compiled"
        );
    }
}

fn count(operation_counts: &OperationCounts, function: Function) -> String {
    let operation_count = operation_counts.of(function);
    format!("{}/{}", operation_count.mul, operation_count.add)
}

fn assert_contains(chapter: &str, part: &str) {
    assert!(chapter.contains(part), "the chapter lacks\n{part}");
}

//! Every operation count of the committed report, computed again.
//!
//! In: `report/DETAILS.md`, and the tables of scenes of the report. A failed test prints the expected row. Times and
//! errors are not checked; they belong to the machine that the report names. `homogen report` writes a new report.

#[path = "../../report/program/src/chain.rs"]
mod chain;
#[expect(dead_code, reason = "much of a scene is for measuring")]
#[path = "../../report/program/src/scene.rs"]
mod scene;
#[path = "../../report/program/src/simplified.rs"]
mod simplified;
#[path = "../../report/program/src/states.rs"]
mod states;

use std::path::Path;

use homogen_codegen::Function;
use homogen_codegen::description::Description;
use homogen_codegen::expand::expand;
use homogen_codegen::formulation::Angles;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::OperationCount;
use scene::{Scene, Variant};

const REPORT: &str = include_str!("../../report/DETAILS.md");

#[test]
fn counts_of_the_robots_are_current() {
    for scene in robots() {
        let part = part(&format!("### {}", scene.title));
        for &function in &scene.functions {
            let OperationCount {
                mul,
                add,
                div,
                sin,
                cos,
                ..
            } = operation_count(&scene, &Variant::DEFAULT, function);
            let trig = sin + cos;
            assert_row(
                part,
                &format!("| `{}` | {mul} | {add} | {div} | {trig} |", function.name()),
            );
        }
    }
}

#[test]
fn counts_of_formulations_are_current() {
    let part = part("## Formulations");
    for scene in robots() {
        for &function in &scene.functions {
            for variant in scene
                .variants
                .iter()
                .filter(|variant| variant.serves(function))
            {
                let OperationCount { mul, add, div, .. } =
                    operation_count(&scene, variant, function);
                let (robot, name, way) = (&scene.title, function.name(), variant.title);
                assert_row(
                    part,
                    &format!("| {robot} | `{name}` | {way} | {mul} | {add} | {div} |"),
                );
            }
        }
    }
}

/// Cells of a table's row that starts with these.
fn cells<'a>(part: &'a str, start: &[&str]) -> Vec<&'a str> {
    let mut rows = part
        .lines()
        .map(|row| row.split('|').map(str::trim).skip(1).collect::<Vec<_>>());
    let found = rows.find(|row| row.starts_with(start));
    found.unwrap_or_else(|| panic!("no row {start:?}"))
}

/// Ratios in the README are those of the report, without flags and native.
#[test]
fn ratios_of_the_readme_are_those_of_the_report() {
    let part = part("## Without flags");
    let readme = include_str!("../../README.md");
    for (title, function) in [
        ("inverse dynamics", "`inverse_dynamics`"),
        (
            "derivatives of inverse dynamics",
            "`inverse_dynamics_derivatives`",
        ),
        ("forward dynamics", "`forward_dynamics`"),
        (
            "derivatives of forward dynamics",
            "`forward_dynamics_derivatives`",
        ),
    ] {
        let row = cells(part, &["Panda with hand", function]);
        assert_eq!(cells(readme, &[title])[1..3], row[6..8], "{title}");
    }
}

/// Ratios in the guide are those of the report.
#[test]
fn ratios_of_the_guide_are_those_of_the_report() {
    let part = part("### Panda with hand: other programs");
    let guide = include_str!("../../guide/src/accuracy.md");
    for (title, function) in [
        ("inverse dynamics", "`inverse_dynamics`"),
        ("forward dynamics", "`forward_dynamics`"),
        (
            "forward dynamics, refined once: less than half of their error",
            "`forward_dynamics`, refined once",
        ),
    ] {
        let row = cells(part, &[function, "f64"]);
        assert_eq!(cells(guide, &[title])[1], row[8], "{title}");
    }
}

/// `cargo run -p homogen-examples --bin bars` draws a new one.
#[test]
fn the_picture_of_the_readme_is_drawn_from_the_report() {
    let committed = include_str!("../../report/bars.svg");
    assert_eq!(
        homogen_examples::bars::draw(REPORT).as_deref(),
        Some(committed)
    );
}

/// Merged angles are shown for exactly those functions whose program they change.
#[test]
fn merged_angles_are_shown_where_they_change_a_program() {
    for scene in robots() {
        let merged = Variant {
            change: |_, request| request.formulation.angles = Angles::Merged,
            ..Variant::DEFAULT
        };
        for &function in &scene.functions {
            let is_shown = (scene.variants.iter())
                .any(|variant| variant.name == "merged" && variant.serves(function));
            let differs = operation_count(&scene, &merged, function)
                != operation_count(&scene, &Variant::DEFAULT, function);
            assert_eq!(is_shown, differs, "{}, {}", scene.title, function.name());
        }
    }
}

#[test]
fn counts_of_simpler_models_are_current() {
    let part = part("## Simpler models");
    let scenes = scene::models(root()).expect("the robots of the repository are valid");
    for scene in scenes {
        for variant in &scene.variants {
            let OperationCount { mul, add, .. } =
                operation_count(&scene, variant, Function::InverseDynamics);
            for scalar in variant.scalars {
                let (title, model, scalar) = (&scene.title, variant.title, scalar.name());
                assert_row(
                    part,
                    &format!("| {title} | {model} | {scalar} | {mul} | {add} |"),
                );
            }
        }
    }
}

/// Longer chains take too long without optimisation.
#[test]
fn counts_of_chains_are_current() {
    let part = part("## Long chains");
    for joints in [1, 2, 4, 8] {
        let chain = chain::chain(joints).expect("it is valid");
        for function in [
            Function::ForwardKinematics,
            Function::Gravity,
            Function::InverseDynamics,
            Function::MassMatrix,
            Function::ForwardDynamics,
        ] {
            let request = Request {
                scalar: Real::F64,
                ..Request::default()
            };
            let OperationCount { mul, add, div, .. } = count(&chain, request, function);
            let name = function.name();
            assert_row(
                part,
                &format!("| `{name}` | {joints} | {mul} | {add} | {div} |"),
            );
        }
    }
}

/// Both types have the same states, except for quaternions, which have unit length in each.
#[test]
fn states_are_those_of_both_types() {
    for scene in robots() {
        let whole = scene.states.len() == states::STATES * 4 * scene.joints.len();
        assert!(whole, "{} has states of other lengths", scene.title);
        assert_eq!(states::in_single_precision(&scene.states), None);
    }
    let free = scene::free(root()).expect("the robots of the repository are valid");
    assert_eq!(free.states.len(), states::STATES * (19 + 3 * 18));
    let single = states::in_single_precision(&free.states).expect("quaternions are rounded");
    for (states, epsilon) in [(&free.states, f64::EPSILON), (&single, f32::EPSILON.into())] {
        for state in states.chunks_exact(19 + 3 * 18) {
            let length: f64 = state[3..7].iter().map(|x| x * x).sum();
            // Four entries, each rounded once or twice.
            assert!((length - 1.0).abs() < 4.0 * epsilon, "{length}");
        }
    }
    for (seen, state) in single
        .chunks(19 + 3 * 18)
        .zip(free.states.chunks(19 + 3 * 18))
    {
        assert_eq!((&seen[..3], &seen[7..]), (&state[..3], &state[7..]));
    }
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

fn robots() -> Vec<Scene> {
    scene::robots(root()).expect("the robots of the repository are valid")
}

fn operation_count(scene: &Scene, variant: &Variant, function: Function) -> OperationCount {
    let (description, request) = scene.of(variant);
    count(&description, request, variant.instead.unwrap_or(function))
}

fn count(description: &Description, request: Request, function: Function) -> OperationCount {
    let request = Request {
        functions: vec![vec![function]],
        ..request
    };
    let module = expand(description, &request).expect("it is valid");
    module.functions[0].operation_count
}

/// The text between a heading and the next one of its level or above.
fn part(heading: &str) -> &'static str {
    let start = format!("{heading}\n");
    let start = REPORT
        .find(&start)
        .unwrap_or_else(|| panic!("no part {heading}"));
    let rest = &REPORT[start + heading.len()..];
    let rank = heading.split(' ').next().unwrap_or_default();
    let next = (1..=rank.len()).filter_map(|marks| rest.find(&format!("\n{} ", "#".repeat(marks))));
    &rest[..next.min().unwrap_or(rest.len())]
}

fn assert_row(part: &str, start: &str) {
    let rows = part.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(
        rows, 1,
        "the report should have one row that starts with\n{start}"
    );
}

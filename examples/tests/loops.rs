//! The tables of closed loops in the guide, computed again.
//!
//! In: the types of loops, the functions of loops, and the slider-crank of the chapter. A failed test prints the
//! expected row of residuals or operation counts.

use std::path::Path;

use homogen_codegen::Function;
use homogen_codegen::closure;
use homogen_codegen::description::inline;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::request::Request;

const LOOPS: &str = include_str!("../../guide/src/loops.md");

/// The text between the braces of the macro.
fn slider_crank() -> &'static str {
    let (_, inside) = LOOPS.split_once("homogen::chain! {").expect("a robot");
    let (inside, _) = inside.split_once("\n}\n").expect("its end");
    inside
}

#[test]
fn every_kind_has_a_row_with_its_residuals() {
    for kind in &closure::ALL {
        let start = format!("| `{}", kind.word);
        let row = LOOPS.lines().find(|line| {
            let rest = line.strip_prefix(&start);
            rest.is_some_and(|rest| rest.starts_with(['`', '(']))
        });
        let row = row.unwrap_or_else(|| panic!("{} has no row", kind.word));
        let (_, cell) = row[2..].split_once('|').expect("two columns");
        let names: Vec<String> = (kind.rows.iter())
            .map(|row| row.name("").trim_start_matches('.').to_owned())
            .filter(|name| !name.is_empty())
            .collect();
        let listed: Vec<&str> = cell.split('`').skip(1).step_by(2).collect();
        assert_eq!(listed, names, "{row}");
    }
}

#[test]
fn the_counts_of_the_slider_crank_are_current() {
    let mut errors = Errors::new();
    let tokens = slider_crank().parse().expect("tokens");
    let item = inline::read(tokens, Path::new(""), &mut errors).expect("a robot");
    assert!(errors.is_empty(), "{errors}");
    let request = Request {
        functions: Function::OF_LOOPS.map(|function| vec![function]).to_vec(),
        ..item.request
    };
    let description = item.description.expect("it is in place");
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let (_, table) = LOOPS.split_once("<!-- loops -->").expect("it is there");
    for (function, generated) in Function::OF_LOOPS.into_iter().zip(&module.functions) {
        let (name, operation_count) = (function.name(), &generated.operation_count);
        let end = format!(" | {} | {} |", operation_count.mul, operation_count.add);
        let row = table
            .lines()
            .find(|line| line.starts_with(&format!("| `{name}` |")));
        let row = row.unwrap_or_else(|| panic!("{name} has no row"));
        assert!(row.ends_with(&end), "`{name}` should end with{end}: {row}");
    }
}

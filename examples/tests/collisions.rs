//! The table of collision spheres in the guide, computed again.
//!
//! In: the robot of the chapter. A failed test prints the expected end of a row.

use std::path::Path;

use homogen_codegen::Function;
use homogen_codegen::description;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::request::Request;

const COLLISIONS: &str = include_str!("../../guide/src/collisions.md");

#[test]
fn the_counts_of_the_two_arms_are_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/robots/two_arms.urdf");
    let mut errors = Errors::new();
    let description = description::read_file(&path, None, &mut errors);
    let description = description.unwrap_or_else(|| panic!("{errors}"));
    let request = Request {
        functions: Function::OF_SPHERES.map(|function| vec![function]).to_vec(),
        collision: true,
        ..Request::default()
    };
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let (_, table) = (COLLISIONS.split_once("<!-- collisions -->")).expect("it is there");
    for (function, generated) in Function::OF_SPHERES.into_iter().zip(&module.functions) {
        let (name, operation_count) = (function.name(), &generated.operation_count);
        let end = format!(" | {} | {} |", operation_count.mul, operation_count.add);
        let start = format!("| `{name}` |");
        let row = table.lines().find(|line| line.starts_with(&start));
        let row = row.unwrap_or_else(|| panic!("{name} has no row"));
        assert!(row.ends_with(&end), "`{name}` should end with{end}: {row}");
    }
    let [spheres, pairs] = [module.spaces.spheres.len(), module.spaces.pairs.len()];
    assert_eq!([spheres, pairs], [9, 22], "the numbers below the table");
}

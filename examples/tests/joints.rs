//! The table of joints and functions in the guide, computed again.
//!
//! In: the tables of joints and of functions, and one body on a joint of each type. A failed test prints the expected
//! table of operation counts.

use std::fmt::Write;

use homogen_codegen::Function;
use homogen_codegen::description::read_text;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::joint;
use homogen_codegen::request::Request;

const JOINTS: &str = include_str!("../../guide/src/joints.md");

/// A body with a general inertia on a joint of a type.
fn robot(kind: &str) -> String {
    format!(
        r#"<robot name="body"><link name="base"/><link name="body"><inertial>
        <origin xyz="0.1 0.2 0.3"/><mass value="2"/>
        <inertia ixx="0.3" ixy="0.01" ixz="0.02" iyy="0.4" iyz="0.03" izz="0.5"/></inertial></link>
        <joint name="j" type="{kind}"><parent link="base"/><child link="body"/>
        <axis xyz="0 0 1"/><axis2 xyz="0 1 0"/><thread pitch="0.01"/></joint></robot>"#
    )
}

/// Multiplications and additions of every function, in the order of the table.
fn operations(kind: &str) -> Vec<usize> {
    let mut errors = Errors::new();
    let description = read_text(&robot(kind), "body.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    let request = Request {
        functions: Function::ALL.map(|function| vec![function]).to_vec(),
        ..Request::default()
    };
    let description = description.expect("it is valid");
    let module = expand(&description, &request).unwrap_or_else(|errors| panic!("{kind}: {errors}"));
    let operation_counts = module
        .functions
        .iter()
        .map(|generated| &generated.operation_count);
    operation_counts
        .map(|operation_count| operation_count.mul + operation_count.add)
        .collect()
}

#[test]
fn every_function_has_a_count_for_every_joint() {
    let kinds = joint::ALL.iter().filter(|kind| kind.moves());
    let kinds: Vec<&str> = kinds.map(|kind| kind.word).collect();
    let columns: Vec<Vec<usize>> = kinds.iter().map(|kind| operations(kind)).collect();
    let mut table = format!(
        "| | {} |\n|---|{}\n",
        kinds.join(" | "),
        "---:|".repeat(kinds.len())
    );
    for (row, function) in Function::ALL.into_iter().enumerate() {
        let operation_counts = columns.iter().map(|column| column[row].to_string());
        let operation_counts: Vec<String> = operation_counts.collect();
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "| `{}` | {} |",
            function.name(),
            operation_counts.join(" | ")
        );
    }
    let marked = format!("<!-- joints -->\n{table}");
    assert!(
        JOINTS.contains(&marked),
        "the chapter should have\n{marked}"
    );
}

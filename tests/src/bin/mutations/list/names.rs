//! Wrong edits of names, and of the tests that generated files contain.

use super::{Mutation, engine};

const ON_EITHER_BASE: &str = "check::vectors::tests::programs_of_every_joint_pass_on_either_base";

/// All mutations of this file.
pub(super) const NAMES: &[Mutation] = &[
    Mutation {
        name: "C: two robots with a function of the same name",
        file: "codegen/src/print/c/names.rs",
        from: r#"let between = if is_apart { "_" } else { "" };"#,
        to: r#"let between = if is_apart { "" } else { "" };"#,
        noticed_by: engine("print::c::names::tests::ambiguous_names_get_a_second_underscore"),
    },
    Mutation {
        name: "C: a member with the name of a macro",
        file: "codegen/src/print/c/names.rs",
        from: "in_capitals || reserved || MACROS.contains(&name)",
        to: "reserved || MACROS.contains(&name)",
        noticed_by: engine("print::c::names::tests::members_avoid_macros"),
    },
    Mutation {
        name: "Rust: an argument with the name of the struct",
        file: "codegen/src/print/rust/dialect.rs",
        from: "self.local(argument.name())",
        to: "ident(argument.name())",
        noticed_by: engine("builder::tests::languages::a_struct_may_be_called_as_what_files_bind"),
    },
    Mutation {
        name: "tests in files: quaternions that are not normalised",
        file: "codegen/src/check/vectors.rs",
        from: "normalize(&mut q[entries]);",
        to: "let _ = entries;",
        noticed_by: engine(ON_EITHER_BASE),
    },
    Mutation {
        name: "tests in files: angles whose sines have no bound",
        file: "codegen/src/check/vectors.rs",
        from: "found.reason == Some(Reason::Angle)",
        to: "found.reason == Some(Reason::Divisor)",
        noticed_by: engine(ON_EITHER_BASE),
    },
];

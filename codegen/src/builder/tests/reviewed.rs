//! Parts of a file for its reviewer: the command that writes it, limits, tests, provenance.

use super::{arm, as_asked, text};
use crate::builder::Builder;
use crate::function::Function;
use crate::request::Target;

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
        "pub const NV: usize = 2;\n",
        "#[cfg(test)]\n",
        "\n    #[test]\n    fn inverse_dynamics() {\n",
        "//   `fore`\n",
        "//     q_x = 0.8 = `upper.q_x` + 0.4 `fore.m`\n",
    ] {
        assert!(file.contains(part), "{part}\n{file}");
    }
    let tokens = builder.to_tokens().expect("a robot that ships").to_string();
    assert!(!tokens.contains("# [cfg (test)]"));
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
fn a_file_in_ascii_is_ascii_and_other_names_are_errors() {
    let builder = Builder::from_urdf("../robots/two_link.urdf").ascii();
    let source = builder.to_c("arm.h").expect("a robot that ships");
    for text in [text(&builder), source.header, source.text] {
        assert!(text.is_ascii() && text.contains("--ascii"), "{text}");
    }
    let named = builder.parameter("maß", Target::MassOf("fore".into()));
    let errors = named.to_source().map(|_| ()).expect_err("no ASCII");
    assert!(
        errors.to_string().contains("`maß` is a name in the file"),
        "{errors}"
    );
}

#[test]
fn words_that_a_shell_would_change_are_quoted() {
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

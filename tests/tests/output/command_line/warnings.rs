//! Warnings of `homogen check`, which every other command reports too, as text and as JSON; functions that a robot cannot
//! have, reported with the reason wherever they are left out.

use homogen_cli::Answer;
use homogen_codegen::{Builder, Function, Real};
use serde_json::Value;

use super::{ARM, eval::eval, homogen};

/// An arm whose last link weighs nothing.
fn massless() -> String {
    ARM.replace(
        "<inertial><mass value=\"0.5\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial>",
        "",
    )
}

fn parsed(answer: &Answer) -> Value {
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    serde_json::from_str(&answer.output).expect("JSON")
}

/// The lines of standard error with warnings and their hints.
fn warnings(text: &str) -> Vec<&str> {
    let mut lines = text
        .lines()
        .skip_while(|line| !line.starts_with("warning: "));
    let is_of_warnings =
        |line: &&str| line.starts_with("warning: ") || line.starts_with("  hint: ");
    lines.by_ref().take_while(is_of_warnings).collect()
}

const STATES: &str = r#"{"states":[{"q":[0.5,1,0.25],"qd":[0,0,0],"tau":[1,0,0]}]}"#;

#[test]
fn all_commands_report_them_in_the_same_words() {
    let checked = homogen("check -", ARM);
    let wanted = warnings(&checked.output);
    assert_eq!(wanted.len(), 2, "{}", checked.output);
    for arguments in [
        "count - --functions gravity",
        "inspect - --function gravity",
        "generate - --functions gravity",
        "generate -",
    ] {
        assert_eq!(
            warnings(&homogen(arguments, ARM).remarks),
            wanted,
            "{arguments}"
        );
    }
    let answer = eval("--function gravity", STATES);
    let remarks = answer.remarks.replace("states.json", "<stdin>");
    assert_eq!(warnings(&remarks), wanted);
}

#[test]
fn in_json_they_are_the_same_entries() {
    let checked = parsed(&homogen("check - --format json", ARM));
    let wanted = &checked["warnings"];
    assert_eq!(wanted.as_array().map(Vec::len), Some(1));
    assert_eq!(
        (&wanted[0]["line"], &wanted[0]["column"]),
        (&4.into(), &5.into())
    );
    assert!(wanted[0]["hint"].is_string());
    let counted = parsed(&homogen("count - --functions bias --format json", ARM));
    assert_eq!(&counted["warnings"], wanted);
    let evaluated = eval("--function bias --format json", STATES);
    assert_eq!(evaluated.remarks, "");
    assert_eq!(&parsed(&evaluated)["warnings"], wanted);
}

#[test]
fn a_warning_about_one_function_is_reported_where_that_function_is_requested() {
    // A hand of 10 t on links of 1 kg.
    let text = ARM.replace("mass value=\"0.5\"", "mass value=\"1e13\"");
    let unrefined = "--function forward_dynamics --formulation refined=0";
    let count = |format: &str| {
        homogen(
            &format!("count - --tip hand {unrefined} --format {format}"),
            &text,
        )
    };
    let said = count("text").remarks;
    let lost = "forward_dynamics with refined = 0 loses ";
    assert!(said.contains(lost), "{said}");
    let counted = parsed(&count("json"));
    let warnings = counted["warnings"].as_array().expect("a list");
    let last = warnings.last().expect("a warning");
    assert!(
        last["message"]
            .as_str()
            .is_some_and(|text| text.starts_with(lost))
    );
    let other = homogen("count - --function gravity --formulation refined=0", &text);
    assert!(!other.remarks.contains(lost), "{}", other.remarks);
}

#[test]
fn functions_left_out_are_reported_with_the_reason() {
    let text = massless();
    let reason = "<stdin>:21:16: joint \"slide\" can accelerate without any force: the mass matrix \
                  is singular";
    let note = format!(
        "note: left out: forward_dynamics, mass_matrix_inverse, forward_dynamics_derivatives, \
         forward_dynamics_vjp, forward_dynamics_jvp, forward_dynamics_hessian and forward_dynamics_parameter_derivatives: \
         {reason}\n  hint: give"
    );
    for command in ["count - --tip hand", "generate - --tip hand"] {
        let answer = homogen(command, &text);
        assert_eq!(answer.code, 0);
        assert!(answer.remarks.contains(&note), "{}", answer.remarks);
    }
    let counted = parsed(&homogen("count - --tip hand --format json", &text));
    let left_out = &counted["left_out"][0];
    assert_eq!(left_out["functions"][1], "mass_matrix_inverse");
    assert_eq!(left_out["reason"], reason);
    assert!(
        left_out["hint"]
            .as_str()
            .is_some_and(|hint| hint.starts_with("give"))
    );
    // A request without missing functions reports nothing.
    let asked = homogen("count - --tip hand --functions gravity", &text);
    assert!(!asked.remarks.contains("left out"), "{}", asked.remarks);
}

#[test]
fn a_file_lists_functions_left_out_at_its_head_and_above_the_struct() {
    let answer = homogen("generate - --tip hand", &massless());
    let line = "Left out: `forward_dynamics`, `mass_matrix_inverse`, \
                `forward_dynamics_derivatives`, `forward_dynamics_vjp`, `forward_dynamics_jvp`, `forward_dynamics_hessian` and \
                `forward_dynamics_parameter_derivatives` (<stdin>:21:16: joint \"slide\" can accelerate without any force: the mass matrix is singular).\n";
    for opening in ["// ", "/// "] {
        let count = answer.output.matches(&format!("\n{opening}{line}")).count();
        assert_eq!(count, 1, "{}", answer.output);
    }
    // With the runtime, `chain` lists them as well.
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/quadruped.urdf");
    let built = Builder::from_urdf(robot)
        .runtime("::homogen")
        .scalar(Real::F64);
    let text = built.to_source().expect("no mistakes").to_string();
    let line = "Left out: `forward_kinematics`, `frame_poses`, `spatial_jacobian`,";
    assert!(
        text.contains(&format!("    /// {line}")),
        "no line above `chain`"
    );
    let all = built
        .tip("hr_foot")
        .to_source()
        .expect("no mistakes")
        .to_string();
    assert!(!all.contains("Left out"));
    for function in Function::ALL {
        assert!(all.contains(&format!("pub fn {}(", function.name())));
    }
}

/// A robot whose joint between links a and b has this type and this text.
fn jointed(kind: &str, inner: &str) -> String {
    let inertial = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>";
    format!(
        "<robot name=\"r\" version=\"1.1\"><link name=\"a\"/><link name=\"b\">{inertial}</link>\n\
         <joint name=\"j\" type=\"{kind}\"><parent link=\"a\"/><child link=\"b\"/>{inner}</joint></robot>"
    )
}

#[test]
fn warnings_stand_beside_the_mistakes_that_they_explain() {
    let text = jointed("revolute", "<axis xyz=\"0 0 1\"/>")
        .replace("<link name=\"a\"/>", "<Link name=\"a\"/>");
    let refused = homogen("check -", &text);
    assert_eq!(refused.code, 1);
    assert!(
        refused
            .remarks
            .contains("error: <stdin>:2:47: there is no link \"a\""),
        "{}",
        refused.remarks
    );
    let warning =
        "warning: <stdin>:1:31: <Link> in robot \"r\" is ignored\n  hint: did you mean <link>?\n";
    assert!(refused.remarks.ends_with(warning), "{}", refused.remarks);
}

#[test]
fn mechanics_that_are_not_modelled_are_refused_where_that_is_strict() {
    let text = jointed("revolute", "<axis xyz=\"0 0 1\"/>")
        .replace("</robot>", "<force_element name=\"s\"/></robot>");
    assert_eq!(homogen("check -", &text).code, 0);
    let refused = homogen("check - --strict", &text);
    assert_eq!(refused.code, 1);
    let error = "not modelled: <force_element> in robot \"r\": a spring, a damper or another force (refused: strict)";
    assert!(refused.remarks.contains(error), "{}", refused.remarks);
    assert_eq!(
        refused.remarks.matches("force_element").count(),
        1,
        "{}",
        refused.remarks
    );
}

#[test]
fn a_joint_that_follows_a_fixed_one_is_named_where_nothing_moves() {
    let follower = "<joint name=\"k\" type=\"revolute\"><axis xyz=\"0 0 1\"/><parent link=\"b\"/><child link=\"c\"/><mimic joint=\"j\"/></joint><link name=\"c\"/></robot>";
    let text = jointed("fixed", "").replace("</robot>", follower);
    let refused = homogen("check -", &text);
    let error = "no joint of \"r\" moves: joint \"k\" mimics joint \"j\", which is fixed\n  \
                 hint: let \"k\" mimic a moving joint, or leave <mimic> out\n";
    assert!(refused.remarks.contains(error), "{}", refused.remarks);
}

#[test]
fn a_plane_and_a_quaternion_of_right_angles_are_told() {
    let text = jointed(
        "planar",
        "<axis xyz=\"0 1 0\"/>\n<origin quat_xyzw=\"0.7071068 0 0 0.7071068\"/>",
    );
    let checked = homogen("check -", &text).output;
    for line in [
        "    0  j: planar (j.x, j.y, j.angle), x along z, y along x, from a to b, carries 1 kg\n",
        "1 angle read as a right angle\n  3:20: 0.7071068 0 0 0.7071068 of j is √½ 0 0 √½\n",
    ] {
        assert!(checked.contains(line), "{checked}");
    }
    let checked = parsed(&homogen("check - --format json", &text));
    assert_eq!(checked["turned"][0]["meant"][3], "√½");
    assert_eq!(checked["details"]["joints"][0]["plane"]["x"][2], 1.0);
    let generated = homogen("generate - --functions gravity", &text).output;
    assert!(
        generated.contains("`j` has x along z, y along x"),
        "{generated}"
    );
}

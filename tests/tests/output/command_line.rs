//! Output of the program `homogen`, for people and for programs.
//!
//! In: arguments and standard input. Out: the answer, word for word where others rely on it. A file a
//! command, one for the formulation; here is what holds for all.

mod actuators;
mod check;
mod count;
mod eval;
mod external;
mod formulation;
mod generate;
mod hostile;
mod inspect;
mod warnings;

use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use homogen_cli::{Answer, answer, run};
use serde_json::Value;

/// Four links that move and one that does not, right angles in six digits, a doubtful inertia.
const ARM: &str = r#"<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.3"/></inertial>
  </link>
  <link name="fore">
    <inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="hand">
    <inertial><mass value="0.5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="camera"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <origin rpy="1.5708 0 0"/>
    <limit lower="-1" upper="2" velocity="3" effort="4"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/><child link="fore"/><axis xyz="0 0 1"/><origin xyz="0.5 0 0"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="fore"/><child link="hand"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="4" velocity="1"/>
  </joint>
  <joint name="mount" type="fixed">
    <parent link="upper"/><child link="camera"/><origin xyz="0 0.1 0"/>
  </joint>
</robot>
"#;

/// The program called with these words, on a standard input.
fn homogen(arguments: &str, input: &str) -> Answer {
    let words = std::iter::once("homogen").chain(arguments.split_whitespace());
    answer(words.map(OsString::from), &mut input.as_bytes())
}

/// The JSON of an answer without a mistake.
fn json(arguments: &str, input: &str) -> Value {
    let answer = homogen(arguments, input);
    assert_eq!((&*answer.remarks, answer.code), ("", 0), "{arguments}");
    serde_json::from_str(&answer.output).expect("JSON")
}

/// The names of what a JSON object has, in their order.
fn keys(object: &Value) -> Vec<&str> {
    let object = object.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

/// The standard error of an answer with mistakes.
fn refused(arguments: &str, input: &str) -> String {
    let answer = homogen(arguments, input);
    assert_eq!((&*answer.output, answer.code), ("", 1), "{arguments}");
    answer.remarks
}

#[test]
fn each_mistake_has_its_line() {
    let text = ARM
        .replace("prismatic", "prismatik")
        .replace("value=\"2\"", "value=\"heavy\"");
    let remarks = refused("count - --format json", &text);
    let mistakes: Vec<&str> = remarks
        .lines()
        .filter(|line| line.starts_with("error"))
        .collect();
    let [mass, kind] = mistakes[..] else {
        panic!("{remarks}");
    };
    assert!(
        mass.starts_with("error: <stdin>:4:28: the mass of link \"upper\""),
        "{mass}"
    );
    assert!(
        kind.starts_with("error: <stdin>:21:29: joint \"slide\" has the unknown type"),
        "{kind}"
    );
    assert!(
        remarks.contains("\n  hint: did you mean \"prismatic\"?"),
        "{remarks}"
    );
}

#[test]
fn a_file_that_is_not_there() {
    assert_eq!(
        refused("check no/such.urdf", ""),
        "error: cannot read no/such.urdf: there is no such file\n"
    );
    assert_eq!(
        refused("eval - --function gravity --states no/such.json", ARM),
        "error: cannot read no/such.json: there is no such file\n"
    );
    assert_eq!(
        refused("eval - --function gravity --states -", ARM),
        "error: the description and the states cannot both be standard input\n"
    );
}

#[test]
fn arguments_that_make_no_sense() {
    for (arguments, said) in [
        (
            "count - --functions mass_matix",
            "did you mean \"mass_matrix\"? known functions: forward",
        ),
        ("count - --functions bias+bias", "bias occurs twice"),
        (
            "check - --gravity 0,0",
            "write gravity as three numbers with commas, or none",
        ),
        ("check - --gravity 0,0,inf", "`inf` is not a finite number"),
        (
            "count - --processor cortex-m5",
            "unknown processor\n  hint: did you mean \"cortex-m4\"? known processors: portable,",
        ),
        ("check - --lock elbow=bent", "`bent` is not a number"),
        ("eval - --function gravity", "--states <FILE>"),
        ("fly", "unrecognized subcommand"),
    ] {
        let answer = homogen(arguments, ARM);
        assert_eq!((&*answer.output, answer.code), ("", 2), "{arguments}");
        assert!(
            answer.remarks.contains(said),
            "{arguments}: {}",
            answer.remarks
        );
    }
}

#[test]
fn help_has_an_example_for_every_command() {
    let answer = homogen("--help", "");
    assert_eq!((&*answer.remarks, answer.code), ("", 0));
    for command in ["check", "inspect", "count", "eval", "generate"] {
        assert!(answer.output.contains(command));
        let help = homogen(&format!("{command} --help"), "");
        let example = format!("\nExample:\n  homogen {command} arm.urdf");
        assert!(help.output.contains(&example), "{}", help.output);
    }
}

/// A robot of that many joints, one after the other.
fn snake(joints: usize) -> String {
    let links = (1..=joints).map(|k| {
        let parent = k - 1;
        format!(
            "<link name=\"l{k}\"/><joint name=\"j{k}\" type=\"continuous\">\
             <parent link=\"l{parent}\"/><child link=\"l{k}\"/></joint>"
        )
    });
    let links: String = links.collect();
    format!("<robot name=\"snake\"><link name=\"l0\"/>{links}</robot>")
}

#[test]
fn a_long_robot_is_checked_and_one_of_reasonable_size_generated() {
    let long = snake(1199);
    let checked = json("check - --format json", &long);
    assert_eq!(checked["joints"].as_array().map(Vec::len), Some(1199));
    let expected = "error: 1199 joints move, and functions are generated for at most 1000\n";
    assert!(refused("count -", &long).starts_with(expected));
    assert!(refused("generate -", &long).starts_with(expected));
}

#[test]
fn what_is_too_large_for_a_robot_is_refused() {
    let expected = "\
error: <stdin>:1:14: the robot has 5001 joints, and at most 5000 can be modelled
  hint: choose a base further out, or drop links that are not needed
";
    let longer = snake(5001);
    let reported = refused("check -", &longer);
    assert!(reported.starts_with(expected), "{reported}");
    // None of its joints has an axis: ten warnings of that are enough.
    assert!(reported.ends_with("and 990 more warnings\n"), "{reported}");
    let rest = json("check - --base l1 --drop l1000 --format json", &longer);
    assert_eq!(rest["joints"].as_array().map(Vec::len), Some(998));
}

/// A stream that nobody reads any more.
struct Closed(io::ErrorKind);

impl Write for Closed {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_reader_that_has_gone_is_no_mistake_and_a_full_disk_is_one() {
    let call = |kind| {
        let arguments = ["homogen", "check", "-"].map(OsString::from);
        let mut remarks = Vec::new();
        let code = run(
            arguments,
            &mut ARM.as_bytes(),
            &mut Closed(kind),
            &mut remarks,
        );
        (code, String::from_utf8(remarks).expect("text"))
    };
    assert_eq!(
        call(io::ErrorKind::BrokenPipe),
        (ExitCode::SUCCESS, String::new())
    );
    let (code, remarks) = call(io::ErrorKind::StorageFull);
    assert_eq!(code, ExitCode::FAILURE);
    assert!(remarks.starts_with("error: cannot write: "), "{remarks}");
}

/// That of `eval` stands among its keys, in its own file.
#[test]
fn every_answer_in_json_begins_with_its_version() {
    for command in ["check -", "count - --tip hand", "base-parameters -"] {
        let answer = homogen(&format!("{command} --format json"), ARM);
        let answer: Value = serde_json::from_str(&answer.output).expect("JSON");
        assert_eq!(
            (keys(&answer)[0], &answer["version"]),
            ("version", &1.into())
        );
    }
}

#[test]
fn versions_are_those_of_the_formats_and_shells_complete_every_command() {
    let versions = homogen("--version", "").output;
    assert_eq!(homogen("-V", "").output.lines().count(), 1);
    for line in ["generated files: format 1", "answers in JSON: version 1"] {
        assert!(versions.lines().any(|other| other == line), "{versions}");
    }
    for shell in ["bash", "zsh", "fish"] {
        let script = homogen(&format!("completions {shell}"), "").output;
        for word in ["base-parameters", "generate", "path-only", "completions"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}

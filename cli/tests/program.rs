//! The binary `homogen` as a shell runs it: exit status, standard output, standard error.
//!
//! Answers are tested beside the commands and in the tests of the workspace, by calls of the library.

use std::process::{Command, Output, Stdio};

const TWO_LINK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");

fn homogen(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homogen"));
    command.args(arguments).stdin(Stdio::null());
    command
}

/// Exit status, standard output and standard error.
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = homogen(arguments).output().expect("it starts");
    let [stdout, stderr] = [stdout, stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (status.code(), stdout, stderr)
}

#[test]
fn help_is_output_and_succeeds() {
    let (code, output, remarks) = run(&["--help"]);
    assert_eq!((code, &*remarks), (Some(0), ""));
    assert!(output.contains("Usage: homogen"), "{output}");
}

#[test]
fn a_generated_file_is_output_and_succeeds() {
    let (code, output, remarks) = run(&["generate", TWO_LINK, "--functions", "gravity"]);
    assert_eq!(code, Some(0), "{remarks}");
    assert!(output.contains("pub fn gravity"), "{output}");
}

#[test]
fn a_missing_file_fails_with_one_message_and_no_output() {
    let (code, output, remarks) = run(&["check", "no_such_arm.urdf"]);
    assert_eq!((code, &*output), (Some(1), ""));
    assert_eq!(remarks.matches("error").count(), 1, "{remarks}");
    assert!(remarks.contains("no_such_arm.urdf"), "{remarks}");
}

#[test]
fn a_wrong_option_fails_as_one_of_usage() {
    let (code, output, remarks) = run(&["generate", TWO_LINK, "--functoins", "gravity"]);
    assert_eq!((code, &*output), (Some(2), ""));
    assert!(remarks.contains("--functions"), "no suggestion: {remarks}");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = homogen(&["completions", "bash"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    drop(child.stdout.take());
    let Output { status, stderr, .. } = child.wait_with_output().expect("it ends");
    assert!(status.success() && stderr.is_empty(), "{status}");
}

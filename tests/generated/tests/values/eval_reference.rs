//! `homogen eval` compared with the numbers of Pinocchio, for every robot that ships.
//!
//! In: tests/reference/*.json. Out: agreement to a few roundings, with and without `--exact`, since these files have
//! angles with all digits.

use std::ffi::OsString;
use std::path::PathBuf;

use homogen_cli::answer;
use serde_json::{Value, json};

/// Largest difference, relative to the largest entry of a result.
const TOLERANCE: f64 = 1e-13;

#[test]
fn two_link() {
    check("two_link");
}

#[test]
fn scara() {
    check("scara");
}

#[test]
fn stanford() {
    check("stanford");
    check("stanford_general");
}

#[test]
fn puma560() {
    check("puma560");
    check("puma560_general");
}

#[test]
fn ur5_class() {
    check("ur5_class");
}

#[test]
fn panda_class() {
    check("panda_class");
}

#[test]
fn quadruped() {
    check("quadruped");
}

/// A function, the numbers of Pinocchio to compare with, and ours in the same order.
type Comparison = (&'static str, fn(&Value) -> Vec<f64>, fn(&Value) -> Vec<f64>);

const COMPARISONS: [Comparison; 11] = [
    ("inverse_dynamics", |state| numbers(&state["tau"]), numbers),
    (
        "gravity",
        |state| numbers(&state["gravity_torque"]),
        numbers,
    ),
    ("bias", |state| numbers(&state["bias"]), numbers),
    ("forward_dynamics", |state| numbers(&state["ddq"]), numbers),
    ("mass_matrix", |state| numbers(&state["M_upper"]), upper),
    (
        "forward_kinematics",
        |state| numbers(&state["frame_R"]),
        |pose| block(pose, 0..3),
    ),
    (
        "forward_kinematics",
        |state| numbers(&state["frame_p"]),
        |pose| block(pose, 3..4),
    ),
    (
        "geometric_jacobian",
        |state| numbers(&state["J_local_world_aligned"]),
        linear_first,
    ),
    (
        "spatial_jacobian",
        |state| numbers(&state["J_world"]),
        linear_first,
    ),
    ("velocity", velocity, |matrix| block(matrix, 0..4)),
    ("acceleration", acceleration, |matrix| block(matrix, 0..4)),
];

fn check(robot: &str) {
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let reference = root.join(format!("tests/reference/{robot}.json"));
    let reference = std::fs::read_to_string(reference).expect("the reference can be read");
    let reference: Value = serde_json::from_str(&reference).expect("the reference is JSON");
    let file = root.join(format!("robots/{robot}.urdf"));
    let expected = reference["states"].as_array().expect("a list of states");
    let states = expected.iter().map(|state| {
        json!({ "q": state["q"], "qd": state["v"], "qdd": state["a"], "tau": state["torque"] })
    });
    let states = json!({ "states": states.collect::<Vec<_>>() }).to_string();
    for (function, theirs, ours) in COMPARISONS {
        for exact in [false, true] {
            let mut arguments: Vec<OsString> = vec!["homogen".into(), "eval".into()];
            arguments.push(file.clone().into());
            let tip = reference["frame"].as_str().expect("the name of a frame");
            let options = ["--function", function, "--states", "-", "--format", "json"];
            arguments.extend(
                options
                    .into_iter()
                    .chain(["--tip", tip])
                    .map(OsString::from),
            );
            arguments.extend(exact.then(|| "--exact".into()));
            let answer = answer(arguments, &mut states.as_bytes());
            assert_eq!((answer.code, &*answer.remarks), (0, ""), "{robot}");
            let answer: Value = serde_json::from_str(&answer.output).expect("JSON");
            let results = answer["results"].as_array().expect("a list of results");
            assert_eq!(results.len(), expected.len());
            for (index, (result, state)) in results.iter().zip(expected).enumerate() {
                let error = difference(&ours(result), &theirs(state));
                assert!(
                    error < TOLERANCE,
                    "{function} of {robot}, state {index}, exact {exact}: {error:e}"
                );
            }
        }
    }
}

fn difference(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    let size = theirs
        .iter()
        .fold(0.0_f64, |size, entry| size.max(entry.abs()));
    let pairs = ours.iter().zip(theirs);
    let worst = pairs.fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
    // A SCARA's gravity torques are nearly zero for Pinocchio.
    worst / size.max(1e-3)
}

/// All numbers of a value, row by row.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        number => vec![number.as_f64().expect("a number")],
    }
}

fn rows(matrix: &Value) -> Vec<Vec<f64>> {
    let rows = matrix.as_array().expect("a list of rows");
    rows.iter().map(numbers).collect()
}

/// The given columns of the first three rows, row by row.
fn block(matrix: &Value, columns: std::ops::Range<usize>) -> Vec<f64> {
    let rows = rows(matrix);
    assert_eq!(rows.len(), 4);
    let rows = rows[..3].iter();
    rows.flat_map(|row| row[columns.clone()].to_vec()).collect()
}

fn upper(matrix: &Value) -> Vec<f64> {
    let rows = rows(matrix);
    let rows = rows.iter().enumerate();
    rows.flat_map(|(k, row)| row[k..].to_vec()).collect()
}

/// The rows of a Jacobian in the order of the reference, linear part first.
fn linear_first(jacobian: &Value) -> Vec<f64> {
    let mut rows = rows(jacobian);
    rows.rotate_left(3);
    rows.concat()
}

fn skew(vector: &[f64]) -> [[f64; 3]; 3] {
    let [x, y, z] = [vector[0], vector[1], vector[2]];
    [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]
}

/// ω̲, v₀ from the velocity of the frame's origin p: v₀ = v − ω × p.
fn velocity(state: &Value) -> Vec<f64> {
    let spin = skew(&numbers(&state["frame_angular_velocity"]));
    let linear = numbers(&state["frame_linear_velocity"]);
    with_offset(spin, &linear, &numbers(&state["frame_p"]))
}

/// G, a₀ from the acceleration of the frame's origin p: G = ω̲̇ + ω̲², a₀ = a − G p.
fn acceleration(state: &Value) -> Vec<f64> {
    let spin = skew(&numbers(&state["frame_angular_velocity"]));
    let rate = skew(&numbers(&state["frame_angular_acceleration"]));
    let square = |i: usize, j: usize| (0..3).map(|k| spin[i][k] * spin[k][j]).sum::<f64>();
    let g = std::array::from_fn(|i| std::array::from_fn(|j| rate[i][j] + square(i, j)));
    let linear = numbers(&state["frame_linear_acceleration"]);
    with_offset(g, &linear, &numbers(&state["frame_p"]))
}

/// The rows of a 3×3 block, each with its entry of u − block · p.
fn with_offset(block: [[f64; 3]; 3], u: &[f64], p: &[f64]) -> Vec<f64> {
    let rows = block.iter().zip(u);
    rows.flat_map(|(row, u)| {
        let moved: f64 = row.iter().zip(p).map(|(entry, p)| entry * p).sum();
        [row[0], row[1], row[2], u - moved]
    })
    .collect()
}

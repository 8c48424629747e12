//! Files of states and results, as users see them: results are compared with those of the same states in JSON, and
//! NumPy's format with bytes of `numpy.save`.

mod refused;

use std::ffi::OsString;
use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::{Answer, answer};

/// An arm with a rotation and a translation.
const ARM: &str = r#"<robot name="arm"><link name="base"/>
<link name="upper"><inertial><origin xyz="0.2 0.1 0"/><mass value="2"/>
<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.15"/></inertial></link>
<link name="hand"><inertial><mass value="0.5"/>
<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
<joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/></joint>
<joint name="slide" type="prismatic"><parent link="upper"/><child link="hand"/><axis xyz="1 0 0"/>
<origin xyz="0 0.3 0.1"/><limit lower="0" upper="1" effort="4" velocity="1"/></joint></robot>"#;

/// A folder of a test, which is removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("homogen-eval-{test}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder for temporary files");
        Self(path)
    }

    fn path(&self, name: &str) -> String {
        self.0
            .join(name)
            .to_str()
            .expect("a path in UTF-8")
            .to_owned()
    }

    fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        fs::write(self.0.join(name), bytes).expect("a temporary file");
        self.path(name)
    }

    /// Its entries, sorted by name.
    fn names(&self) -> Vec<String> {
        let names = fs::read_dir(&self.0).expect("it is there");
        let names = names.map(|entry| entry.expect("it is there").file_name());
        let mut names: Vec<String> = names
            .map(|name| name.to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Runs `homogen eval - …` for the arm.
fn eval(words: &[&str]) -> Answer {
    let words = ["homogen", "eval", "-"].iter().chain(words);
    answer(words.map(OsString::from), &mut ARM.as_bytes())
}

/// The single line of an error, and its hint if there is one, without the folder.
fn refused(folder: &Folder, words: &[&str]) -> String {
    let before = folder.names();
    let answer = eval(words);
    assert_eq!(
        (&*answer.output, answer.code),
        ("", 1),
        "{words:?}: {}",
        answer.remarks
    );
    assert_eq!(folder.names(), before, "nothing is left");
    answer
        .remarks
        .replace(&format!("{}/", folder.0.display()), "")
}

/// The error of the torques of gravity at the states of a file.
fn refused_states(folder: &Folder, path: &str) -> String {
    let words = ["--function", "gravity", "--states", path, "-o", "never.npy"];
    refused(folder, &words)
}

/// An array as `numpy.save` writes it.
fn npy(descr: &str, shape: &str, numbers: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}");
    let text = format!("{text:<117}\n");
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(text.as_bytes());
    bytes.extend(numbers);
    bytes
}

fn bytes(numbers: &[f64]) -> Vec<u8> {
    numbers
        .iter()
        .flat_map(|number| number.to_le_bytes())
        .collect()
}

/// The numbers of an array after a head of 128 bytes.
fn numbers(path: &str) -> Vec<f64> {
    let bytes = fs::read(path).expect("it was written");
    let (numbers, rest) = bytes[128..].as_chunks();
    assert_eq!(rest.len(), 0);
    numbers
        .iter()
        .map(|&number| f64::from_le_bytes(number))
        .collect()
}

/// The numbers within a value, in their order.
fn flat(value: &Value) -> Vec<f64> {
    match value.as_array() {
        Some(values) => values.iter().flat_map(flat).collect(),
        None => vec![value.as_f64().expect("a number")],
    }
}

/// True if all bits are equal, including the sign of 0.
fn same(found: &[f64], expected: &[f64]) -> bool {
    let bits = |numbers: &[f64]| {
        numbers
            .iter()
            .map(|number| number.to_bits())
            .collect::<Vec<_>>()
    };
    bits(found) == bits(expected)
}

/// States with 1300 rotations and translations for two arguments, more than one thread computes.
fn many() -> (Vec<f64>, Vec<f64>, String) {
    let q: Vec<f64> = (0..2600).map(|k| 0.37 * f64::from(k) - 400.0).collect();
    let qd: Vec<f64> = (0..2600).map(|k| 3.0 - 0.011 * f64::from(k)).collect();
    let states = q.chunks(2).zip(qd.chunks(2));
    let states: Vec<Value> = states.map(|(q, qd)| json!({ "q": q, "qd": qd })).collect();
    (q, qd, json!({ "states": states }).to_string())
}

#[test]
fn arrays_give_the_bits_of_json() {
    let folder = Folder::new("arrays");
    let (q, qd, states) = many();
    let states = folder.write("states.json", states);
    let q = format!(
        "q={}",
        folder.write("q.npy", npy("'<f8'", "(1300, 2)", &bytes(&q)))
    );
    let qd = format!(
        "qd={}",
        folder.write("qd.npy", npy("'<f8'", "(1300, 2)", &bytes(&qd)))
    );
    let out = folder.path("out.npy");
    for (function, shape) in [
        ("bias", "(1300, 2)"),
        ("velocity", "(1300, 4, 4)"),
        ("coriolis_matrix", "(1300, 2, 2)"),
        ("kinetic_energy", "(1300,)"),
    ] {
        let answer = eval(&[
            "--function",
            function,
            "--states",
            &states,
            "--format",
            "json",
        ]);
        let json: Value = serde_json::from_str(&answer.output).expect("JSON");
        let answer = eval(&[
            "--function",
            function,
            "--states",
            &qd,
            "--states",
            &q,
            "-o",
            &out,
        ]);
        assert_eq!(answer, Answer::default(), "{function}");
        let head = fs::read(&out).expect("it was written");
        let expected = npy("'<f8'", shape, &[]);
        assert_eq!(
            String::from_utf8_lossy(&head[..128]),
            String::from_utf8_lossy(&expected)
        );
        let found = numbers(&out);
        assert!(same(&found, &flat(&json["results"])), "{function}");
        // A state alone has the same result as among others.
        let all: Value =
            serde_json::from_str(&fs::read_to_string(&states).expect("it is there")).expect("JSON");
        for k in [0, 7, 650, 655, 1299] {
            let alone = json!({ "states": [all["states"][k]] }).to_string();
            let alone = folder.write("alone.json", alone);
            let answer = eval(&[
                "--function",
                function,
                "--states",
                &alone,
                "--format",
                "json",
            ]);
            let json: Value = serde_json::from_str(&answer.output).expect("JSON");
            let each = found.len() / 1300;
            assert!(
                same(&found[k * each..][..each], &flat(&json["results"])),
                "{function}, state {k}"
            );
        }
    }
    assert_eq!(
        folder.names(),
        ["alone.json", "out.npy", "q.npy", "qd.npy", "states.json"]
    );
}

#[test]
fn results_of_several_parts_are_files_by_name_and_states_of_any_kind() {
    let folder = Folder::new("parts");
    let states = r#"{"states":[{"q":[0.5,0.25],"qd":[1,2],"qdd":[0,3]},{"q":[0,0],"qd":[0,1],"qdd":[1,1]}]}"#;
    let states = folder.write("states.json", states);
    let words = [
        "--function",
        "inverse_dynamics_derivatives",
        "--states",
        &states,
    ];
    let shown = eval(&[&words[..], &["--format", "json"]].concat());
    let kept: Value = serde_json::from_str(&shown.output).expect("JSON");
    let [dq, dqd, all] = ["dq.npy", "dqd.npy", "all.json"].map(|name| folder.path(name));
    let files = [format!("dqd={dqd}"), format!("dq={dq}")];
    let answer = eval(&[&words[..], &["-o", &files[0], "--output", &files[1]]].concat());
    assert_eq!(answer, Answer::default());
    for (path, part) in [(&dq, "dq"), (&dqd, "dqd")] {
        let expected: Vec<f64> = (0..2)
            .flat_map(|k| flat(&kept["results"][k][part]))
            .collect();
        assert!(same(&numbers(path), &expected), "{part}");
    }
    let answer = eval(&[&words[..], &["-o", &all]].concat());
    assert_eq!(answer, Answer::default());
    assert_eq!(
        fs::read_to_string(&all).expect("it was written"),
        shown.output
    );

    let hint = "  hint: --output dq=FILE --output dqd=FILE\n";
    let expected = format!("error: write each result to an .npy file of its own\n{hint}");
    for files in [
        vec!["x.npy"],
        vec!["dq=x.npy"],
        vec!["dq=x.npy", "dq=y.npy"],
        vec!["x.npy", "dq=y.npy"],
    ] {
        let files = files.into_iter().flat_map(|file| ["-o", file]);
        let words: Vec<&str> = words.into_iter().chain(files).collect();
        assert_eq!(refused(&folder, &words), expected);
    }
    assert_eq!(
        refused(&folder, &[&words[..], &["-o", "tau.csv"]].concat()),
        "error: the format of tau.csv is unknown: name it .npy or .json\n"
    );
}

#[test]
fn single_precision_stays_single() {
    let folder = Folder::new("single");
    let singles: Vec<u8> = [0.1_f32, 0.2, -0.3, 0.4]
        .iter()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let q = folder.write("q.npy", npy("'<f4'", "(2, 2)", &singles));
    let doubles: Vec<f64> = [0.1_f32, 0.2, -0.3, 0.4].map(f64::from).to_vec();
    let wide = folder.write("wide.npy", npy("'<f8'", "(2, 2)", &bytes(&doubles)));
    let out = folder.path("out.npy");
    let gravity = ["--function", "gravity", "-o", &out];
    let of = |words: &[&str]| {
        assert_eq!(eval(&[&gravity[..], words].concat()), Answer::default());
        fs::read(&out).expect("it was written")
    };
    // Single precision numbers are exact doubles, and are computed in double precision by default.
    assert_eq!(of(&["--states", &q]), of(&["--states", &wide]));
    let found = of(&["--states", &wide, "--scalar", "f32"]);
    assert_eq!(found, of(&["--states", &q, "--scalar", "f32"]));
    assert!(
        found[10..].starts_with(b"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }")
    );
    let found = found[128..]
        .as_chunks()
        .0
        .iter()
        .map(|&number| f32::from_le_bytes(number));
    let answer = eval(&[
        "--function",
        "gravity",
        "--states",
        &q,
        "--scalar",
        "f32",
        "--format",
        "json",
    ]);
    let json: Value = serde_json::from_str(&answer.output).expect("JSON");
    let answer = flat(&json["results"])
        .into_iter()
        .map(|number| number.to_string());
    assert!(found.map(|number| number.to_string()).eq(answer));
}

#[test]
fn nan_is_computed_with_in_files_and_an_error_in_json() {
    let folder = Folder::new("nan");
    let states = [
        0.1,
        0.2,
        f64::NAN,
        0.2,
        f64::INFINITY,
        0.0,
        1e300,
        0.2,
        0.1,
        0.2,
    ];
    let q = folder.write("q.npy", npy("'<f8'", "(5, 2)", &bytes(&states)));
    let out = folder.path("out.npy");
    assert_eq!(
        eval(&["--function", "gravity", "--states", &q, "-o", &out]),
        Answer::default()
    );
    let found = numbers(&out);
    assert!(found[2].is_nan() && found[4].is_nan(), "{found:?}");
    assert!(found[6].is_finite());
    assert!(same(&found[..2], &found[8..]));
    let expected = "\
error: state 1: an argument is not a finite number
  hint: write to a file, which can have such results: --output FILE
error: state 2: an argument is not a finite number
  hint: write to a file, which can have such results: --output FILE
";
    assert_eq!(
        refused(&folder, &["--function", "gravity", "--states", &q]),
        expected
    );
}

//! Files of states and of results, as a user of the command has them: what comes out is held against what the
//! same states make of JSON, and NumPy's format against bytes that `numpy.save` wrote.

use std::ffi::OsString;
use std::fs;
use std::path::PathBuf;

use serde_json::{Value, json};

use crate::cli::{Answer, answer};

/// A turn and a shift.
const ARM: &str = r#"<robot name="arm"><link name="base"/>
<link name="upper"><inertial><origin xyz="0.2 0.1 0"/><mass value="2"/>
<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.15"/></inertial></link>
<link name="hand"><inertial><mass value="0.5"/>
<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
<joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/></joint>
<joint name="slide" type="prismatic"><parent link="upper"/><child link="hand"/><axis xyz="1 0 0"/>
<origin xyz="0 0.3 0.1"/><limit lower="0" upper="1" effort="4" velocity="1"/></joint></robot>"#;

/// A folder of a test's own, which is gone afterwards.
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

    /// What is in it, in the order of names.
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

/// `homogen eval - …` for the arm.
fn eval(words: &[&str]) -> Answer {
    let words = ["homogen", "eval", "-"].iter().chain(words);
    answer(words.map(OsString::from), &mut ARM.as_bytes())
}

/// The only line of a mistake, and its hint if there is one, without the folder.
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

/// The numbers of an array behind a head of 128 bytes.
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

/// All digits count, and the sign of a zero.
fn same(found: &[f64], expected: &[f64]) -> bool {
    let bits = |numbers: &[f64]| {
        numbers
            .iter()
            .map(|number| number.to_bits())
            .collect::<Vec<_>>()
    };
    bits(found) == bits(expected)
}

/// States with 1300 turns and shifts, more than one thread takes: for two arguments.
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
        let said = eval(&[
            "--function",
            function,
            "--states",
            &states,
            "--format",
            "json",
        ]);
        let said: Value = serde_json::from_str(&said.output).expect("JSON");
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
        assert!(same(&found, &flat(&said["results"])), "{function}");
        // Beside others a state is what it is alone.
        let all: Value =
            serde_json::from_str(&fs::read_to_string(&states).expect("it is there")).expect("JSON");
        for k in [0, 7, 650, 655, 1299] {
            let alone = json!({ "states": [all["states"][k]] }).to_string();
            let alone = folder.write("alone.json", alone);
            let said = eval(&[
                "--function",
                function,
                "--states",
                &alone,
                "--format",
                "json",
            ]);
            let said: Value = serde_json::from_str(&said.output).expect("JSON");
            let each = found.len() / 1300;
            assert!(
                same(&found[k * each..][..each], &flat(&said["results"])),
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
    let said = eval(&[&words[..], &["--format", "json"]].concat());
    let kept: Value = serde_json::from_str(&said.output).expect("JSON");
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
        said.output
    );

    let hint = "  hint: --output dq=FILE --output dqd=FILE\n";
    let expected =
        format!("error: an .npy file holds one result, and each result is in one file\n{hint}");
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
        "error: nothing says how tau.csv is to be written: results are .npy, .parquet or .json\n"
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
    // A single is a double as it stands, and computed with as such where nothing else is asked for.
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
    let said = eval(&[
        "--function",
        "gravity",
        "--states",
        &q,
        "--scalar",
        "f32",
        "--format",
        "json",
    ]);
    let said: Value = serde_json::from_str(&said.output).expect("JSON");
    let said = flat(&said["results"])
        .into_iter()
        .map(|number| number.to_string());
    assert!(found.map(|number| number.to_string()).eq(said));
}

#[test]
fn what_is_no_number_is_ieees_in_a_file_and_a_mistake_in_words() {
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
error: state 1: an argument is no finite number
  hint: a file holds what becomes of it: --output FILE
error: state 2: an argument is no finite number
  hint: a file holds what becomes of it: --output FILE
";
    assert_eq!(
        refused(&folder, &["--function", "gravity", "--states", &q]),
        expected
    );
}

#[test]
fn no_states_are_none() {
    let folder = Folder::new("none");
    let q = folder.write("q.npy", npy("'<f8'", "(0, 2)", &[]));
    let out = folder.path("out.npy");
    assert_eq!(
        eval(&["--function", "mass_matrix", "--states", &q, "-o", &out]),
        Answer::default()
    );
    assert_eq!(
        fs::read(&out).expect("it was written"),
        npy("'<f8'", "(0, 2, 2)", &[])
    );
}

#[test]
fn an_array_that_is_none_of_states_is_refused() {
    let folder = Folder::new("refused");
    let whole = npy("'<f8'", "(3, 2)", &bytes(&[0.5; 6]));
    let fortran = String::from_utf8_lossy(&whole[10..128]).replace("False", "True ");
    let fortran = [&whole[..10], fortran.as_bytes(), &whole[128..]].concat();
    let cases: [(&str, Vec<u8>, &str); 17] = [
        ("empty", vec![], "is no .npy file: it ends within its head"),
        (
            "text",
            b"{\"states\":[]}".to_vec(),
            "is no .npy file: it begins with something else",
        ),
        (
            "head",
            whole[..60].to_vec(),
            "is no .npy file: it ends within its head",
        ),
        (
            "cut",
            whole[..150].to_vec(),
            "is cut off: it has 150 of 176 bytes",
        ),
        (
            "more",
            [&whole[..], &[0]].concat(),
            "has 177 bytes, and 176 by its head",
        ),
        (
            "version",
            [b"\x93NUMPY\x09\x00", &whole[8..]].concat(),
            "is a .npy file of the unknown version 9",
        ),
        (
            "long",
            b"\x93NUMPY\x02\x00\xff\xff\xff\xff".to_vec(),
            "has a head of 4294967295 bytes, which no array of numbers needs",
        ),
        (
            "words",
            npy("open('x')", "(3, 2)", &[]),
            "has a head that NumPy does not write",
        ),
        (
            "negative",
            npy("'<f8'", "(-3, 2)", &[]),
            "has a head that NumPy does not write",
        ),
        (
            "huge",
            npy("'<f8'", "(99999999999999999999, 2)", &[]),
            "has a head that NumPy does not write",
        ),
        (
            "far",
            npy("'<f8'", "(18446744073709551615, 2)", &[]),
            "is cut off: it has 128 of 295147905179352825968 bytes",
        ),
        (
            "whole",
            npy("'<i8'", "(3, 2)", &bytes(&[0.0; 6])),
            "has numbers of the type <i8\n  hint: save little-endian float64 or float32: array.astype('<f8')",
        ),
        (
            "big",
            npy("'>f8'", "(3, 2)", &bytes(&[0.0; 6])),
            "has numbers of the type >f8\n  hint: save little-endian float64 or float32: array.astype('<f8')",
        ),
        (
            "struct",
            npy("[('a', '<f8'), ('b', '<f8')]", "(3,)", &bytes(&[0.0; 6])),
            "has numbers of the type [('a', '<f8'), ('b', '<f8')]\n  hint: save little-endian float64 or float32: array.astype('<f8')",
        ),
        (
            "turned",
            npy("'<f8'", "(2, 3)", &bytes(&[0.0; 6])),
            "has the shape (2, 3), and the argument (states, 2)\n  hint: one row a state, in the order of `homogen check`",
        ),
        (
            "one",
            npy("'<f8'", "(2,)", &bytes(&[0.0; 2])),
            "has the shape (2,), and the argument (states, 2)\n  hint: one state is a row: array[None]",
        ),
        (
            "fortran",
            fortran,
            "is in Fortran's order\n  hint: save it state by state: numpy.ascontiguousarray(array)",
        ),
    ];
    for (name, bytes, why) in cases {
        let name = format!("{name}.npy");
        let path = folder.write(&name, bytes);
        let found = refused(
            &folder,
            &[
                "--function",
                "gravity",
                "--states",
                &path,
                "-o",
                "never.npy",
            ],
        );
        assert_eq!(found, format!("error: {name}: {why}\n"));
    }
}

#[test]
fn arguments_and_files_belong_together() {
    let folder = Folder::new("together");
    let two = folder.write("two.npy", npy("'<f8'", "(2, 2)", &bytes(&[0.0; 4])));
    let three = folder.write("three.npy", npy("'<f8'", "(3, 2)", &bytes(&[0.0; 6])));
    let [q, qd, tau] = [
        format!("q={two}"),
        format!("qd={three}"),
        format!("tau={two}"),
    ];
    for (states, expected) in [
        (
            vec![&*q, &qd],
            "error: there are 3 states of qd, and 2 of q\n",
        ),
        (
            vec![&q],
            "error: there is no qd among the states\n  hint: --states qd=FILE\n",
        ),
        (
            vec![&two],
            "error: an .npy file holds one argument, and the function has q, qd\n  hint: --states q=FILE --states qd=FILE\n",
        ),
        (vec![&q, &q, &qd], "error: q is given twice\n"),
        (
            vec![&q, &qd, &tau],
            "error: the function is none of tau: two.npy is not needed\n",
        ),
        (
            vec![&two, &qd],
            "error: nothing says what two.npy holds\n  hint: beside others, each file is of an argument: --states q=q.npy\n\
             error: there is no q among the states\n  hint: --states q=FILE\n",
        ),
        (
            vec![&q, "qd=no.npy"],
            "error: cannot read no.npy: there is no such file\n",
        ),
    ] {
        let states = states.into_iter().flat_map(|file| ["--states", file]);
        let words: Vec<&str> = ["--function", "bias", "-o", "never.npy"]
            .into_iter()
            .chain(states)
            .collect();
        assert_eq!(refused(&folder, &words), expected);
    }
}

#[test]
fn a_file_that_cannot_be_written_leaves_what_was_there() {
    let folder = Folder::new("unwritten");
    let (q, ..) = many();
    let q = folder.write("q.npy", npy("'<f8'", "(1300, 2)", &bytes(&q)));
    let to = |out: &str| {
        refused(
            &folder,
            &["--function", "gravity", "--states", &q, "-o", out],
        )
    };
    let found = to(&folder.path("no/out.npy"));
    assert!(
        found.starts_with("error: cannot write no/out.npy: "),
        "{found}"
    );
    fs::create_dir(folder.0.join("folder.npy")).expect("a folder");
    assert_eq!(
        to(&folder.path("folder.npy")),
        "error: cannot write folder.npy: it is a folder\n"
    );
    let locked = folder.write("locked.npy", "mine");
    let mut rights = fs::metadata(&locked).expect("it is there").permissions();
    rights.set_readonly(true);
    fs::set_permissions(&locked, rights).expect("it is ours");
    assert!(to(&locked).starts_with("error: cannot write locked.npy: "));
    assert_eq!(fs::read(&locked).expect("it is there"), b"mine");

    // States that end in the middle: what was there stays as it is.
    let mine = folder.write("mine.npy", "mine");
    let json = folder.write("bad.json", r#"{"states":[{"q":[1,2]},{"q":[1]}]}"#);
    refused(
        &folder,
        &["--function", "gravity", "--states", &json, "-o", &mine],
    );
    assert_eq!(fs::read(&mine).expect("it is there"), b"mine");
    // The same file for states and results is read before it is replaced.
    assert_eq!(
        eval(&["--function", "gravity", "--states", &q, "-o", &q]),
        Answer::default()
    );
    assert_eq!(numbers(&q).len(), 2600);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = Folder::new("full");
    let (q, ..) = many();
    let q = folder.write("q.npy", npy("'<f8'", "(1300, 2)", &bytes(&q)));
    for name in ["full.npy", "full.json"] {
        let full = folder.path(name);
        std::os::unix::fs::symlink("/dev/full", &full).expect("a link");
        let found = refused(
            &folder,
            &["--function", "gravity", "--states", &q, "-o", &full],
        );
        assert!(
            found.starts_with(&format!(
                "error: cannot write {name}: No space left on device"
            )),
            "{found}"
        );
        assert!(
            fs::symlink_metadata(&full)
                .expect("it is there")
                .is_symlink()
        );
    }
    // A device that takes everything is written to, and stays one.
    let null = folder.path("null.npy");
    std::os::unix::fs::symlink("/dev/null", &null).expect("a link");
    assert_eq!(
        eval(&["--function", "gravity", "--states", &q, "-o", &null]),
        Answer::default()
    );
    assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
}

#[cfg(not(feature = "parquet"))]
#[test]
fn without_parquet_it_says_how_to_get_it() {
    let folder = Folder::new("without");
    let q = folder.write("q.npy", npy("'<f8'", "(1, 2)", &bytes(&[0.0; 2])));
    for words in [
        ["--states", "x.parquet", "-o", "x.npy"],
        ["--states", &q, "-o", "x.parquet"],
    ] {
        let expected = "error: this binary knows no Parquet, and so not x.parquet\n  hint: build it with --features parquet, or use .npy\n";
        assert_eq!(
            refused(&folder, &[&["--function", "gravity"], &words[..]].concat()),
            expected
        );
    }
}

#[cfg(feature = "parquet")]
mod parquet {
    use std::fs::File;

    use ::parquet::basic::Compression;
    use ::parquet::data_type::{ByteArrayType, DoubleType};
    use ::parquet::file::properties::WriterProperties;
    use ::parquet::file::reader::{FileReader, SerializedFileReader};
    use ::parquet::file::writer::SerializedFileWriter;
    use ::parquet::record::Field;
    use ::parquet::schema::parser::parse_message_type;

    use super::*;

    /// A list of a row, some of whose numbers may not be there.
    type Row<'a> = &'a [Option<f64>];

    /// A table as Arrow's writers make it, compressed, some rows to a group: lists of numbers that may be absent.
    fn table(path: &str, columns: &[(&str, Vec<Row<'_>>)], group: usize) {
        let schema = columns.iter().map(|(name, _)| {
            format!("optional group {name} (LIST) {{ repeated group list {{ optional double element; }} }}")
        });
        let schema = format!(
            "message schema {{ optional binary label; {} }}",
            schema.collect::<String>()
        );
        let schema = parse_message_type(&schema).expect("a schema");
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .build();
        let file = File::create(path).expect("a temporary file");
        let mut file =
            SerializedFileWriter::new(file, schema.into(), properties.into()).expect("a table");
        let rows = columns[0].1.len();
        for first in (0..rows).step_by(group) {
            let mut rows_of_group = file.next_row_group().expect("a group");
            let last = rows.min(first + group);
            let mut label = rows_of_group
                .next_column()
                .expect("a column")
                .expect("there is one");
            let levels = vec![0; last - first];
            label
                .typed::<ByteArrayType>()
                .write_batch(&[], Some(&levels), None)
                .expect("nothing");
            label.close().expect("a column");
            for (_, column) in columns {
                let rows = &column[first..last];
                let numbers: Vec<f64> = rows
                    .iter()
                    .flat_map(|row| row.iter().flatten())
                    .copied()
                    .collect();
                let defined = rows.iter().flat_map(|row| match row {
                    [] => vec![1],
                    row => row
                        .iter()
                        .map(|number| 2 + i16::from(number.is_some()))
                        .collect(),
                });
                let defined: Vec<i16> = defined.collect();
                let again = rows
                    .iter()
                    .flat_map(|row| (0..row.len().max(1)).map(|k| i16::from(k > 0)));
                let again: Vec<i16> = again.collect();
                let mut column = rows_of_group
                    .next_column()
                    .expect("a column")
                    .expect("there is one");
                let writer = column.typed::<DoubleType>();
                writer
                    .write_batch(&numbers, Some(&defined), Some(&again))
                    .expect("numbers");
                column.close().expect("a column");
            }
            rows_of_group.close().expect("a group");
        }
        file.close().expect("a table");
    }

    #[test]
    fn a_table_gives_the_bits_of_json() {
        let folder = Folder::new("table");
        let (q, qd, states) = many();
        let states = folder.write("states.json", states);
        let [given, kept, out] =
            ["given.parquet", "kept.parquet", "out.npy"].map(|name| folder.path(name));
        let [q, qd] = [q, qd].map(|numbers| numbers.into_iter().map(Some).collect::<Vec<_>>());
        table(
            &given,
            &[("qd", qd.chunks(2).collect()), ("q", q.chunks(2).collect())],
            500,
        );
        for function in ["bias", "kinetic_energy"] {
            let words = ["--function", function, "--states"];
            assert_eq!(
                eval(&[&words[..], &[&states, "-o", &out]].concat()),
                Answer::default()
            );
            let expected = numbers(&out);
            assert_eq!(
                eval(&[&words[..], &[&given, "-o", &out]].concat()),
                Answer::default()
            );
            assert!(same(&numbers(&out), &expected), "{function}");
            // Results in a table are read back by another reader.
            assert_eq!(
                eval(&[&words[..], &[&given, "-o", &kept]].concat()),
                Answer::default()
            );
            let file = SerializedFileReader::new(File::open(&kept).expect("it was written"))
                .expect("a table");
            let mut found = Vec::new();
            for row in file.get_row_iter(None).expect("rows") {
                let row = row.expect("a row");
                let [(name, field)] = row.get_column_iter().collect::<Vec<_>>()[..] else {
                    panic!("{row:?} has one column");
                };
                assert_eq!(name, function);
                match field {
                    Field::Double(number) => found.push(*number),
                    Field::ListInternal(list) => {
                        found.extend(list.elements().iter().map(|field| match field {
                            Field::Double(number) => *number,
                            other => panic!("{other:?} is no number"),
                        }))
                    }
                    other => panic!("{other:?} is no result"),
                }
            }
            assert!(same(&found, &expected), "{function}");
        }
        assert_eq!(
            folder.names(),
            ["given.parquet", "kept.parquet", "out.npy", "states.json"]
        );
    }

    #[test]
    fn rows_that_are_no_states_are_refused() {
        let folder = Folder::new("rows");
        let path = folder.path("rows.parquet");
        let good = [Some(0.5), Some(0.25)];
        let mut rows: Vec<Row<'_>> = vec![&good; 7];
        for (row, found) in [
            (&[Some(1.0)][..], "1 numbers for 2"),
            (&[], "0 numbers for 2"),
            (&[Some(1.0), None], "1 numbers for 2"),
            (&[Some(1.0), None, Some(2.0)], "a null"),
            (&[Some(1.0), Some(2.0), Some(3.0)], "3 numbers for 2"),
        ] {
            rows[5] = row;
            table(&path, &[("q", rows.clone())], 3);
            let words = [
                "--function",
                "gravity",
                "--states",
                &path,
                "-o",
                "never.npy",
            ];
            assert_eq!(
                refused(&folder, &words),
                format!("error: rows.parquet: state 5 has {found} in \"q\"\n")
            );
        }
        let words = ["--function", "bias", "--states", &path, "-o", "never.npy"];
        assert_eq!(
            refused(&folder, &words),
            "error: rows.parquet: has no column \"qd\"\n"
        );
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_of_a_table() {
        let folder = Folder::new("full-table");
        let (.., states) = many();
        let states = folder.write("states.json", states);
        let full = folder.path("full.parquet");
        std::os::unix::fs::symlink("/dev/full", &full).expect("a link");
        let found = refused(
            &folder,
            &["--function", "gravity", "--states", &states, "-o", &full],
        );
        assert!(
            found.starts_with("error: cannot write full.parquet: No space left on device"),
            "{found}"
        );
    }

    #[test]
    fn a_table_that_is_none_is_refused() {
        let folder = Folder::new("no-table");
        let (.., states) = many();
        let states = folder.write("states.json", states);
        let table = folder.path("table.parquet");
        let words = ["--function", "gravity", "--states", &states, "-o", &table];
        assert_eq!(eval(&words), Answer::default());
        let bytes = fs::read(&table).expect("it was written");
        for (name, bytes) in [
            ("empty", &[][..]),
            ("cut", &bytes[..bytes.len() / 2]),
            ("text", b"PAR1 and no more"),
        ] {
            let path = folder.write(&format!("{name}.parquet"), bytes);
            let found = refused(
                &folder,
                &[
                    "--function",
                    "gravity",
                    "--states",
                    &path,
                    "-o",
                    "never.npy",
                ],
            );
            assert!(
                found.starts_with(&format!(
                    "error: {name}.parquet: cannot be read as Parquet: "
                )),
                "{found}"
            );
        }
    }
}

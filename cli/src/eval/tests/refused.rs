//! Wrong files of states, states that do not fit together, and unwritable outputs: each is an error and leaves
//! everything unchanged.

use std::fs;

use super::{Folder, bytes, eval, many, npy, numbers, refused, refused_states};
use crate::Answer;

#[test]
fn no_states_are_no_results() {
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
fn wrong_arrays_are_errors() {
    let folder = Folder::new("refused");
    for (name, bytes, why) in strange() {
        let name = format!("{name}.npy");
        let path = folder.write(&name, bytes);
        assert_eq!(
            refused_states(&folder, &path),
            format!("error: {name}: {why}\n")
        );
    }
}

/// Files without states, with the reason.
fn strange() -> [(&'static str, Vec<u8>, &'static str); 17] {
    let whole = npy("'<f8'", "(3, 2)", &bytes(&[0.5; 6]));
    let fortran = String::from_utf8_lossy(&whole[10..128]).replace("False", "True ");
    let fortran = [&whole[..10], fortran.as_bytes(), &whole[128..]].concat();
    [
        (
            "empty",
            vec![],
            "is not an .npy file: it ends within its head",
        ),
        (
            "text",
            b"{\"states\":[]}".to_vec(),
            "is not an .npy file: its first bytes are wrong",
        ),
        (
            "head",
            whole[..60].to_vec(),
            "is not an .npy file: it ends within its head",
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
            "is an .npy file of the unknown version 9",
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
            "has the shape (2, 3) instead of (states, 2)\n  hint: write one row for each state, in the order of `homogen check`",
        ),
        (
            "one",
            npy("'<f8'", "(2,)", &bytes(&[0.0; 2])),
            "has the shape (2,) instead of (states, 2)\n  hint: write one state as a row: array[None]",
        ),
        (
            "fortran",
            fortran,
            "is in Fortran order\n  hint: save it in C order: numpy.ascontiguousarray(array)",
        ),
    ]
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
            "error: there are 3 states of qd, but 2 of q\n",
        ),
        (
            vec![&q],
            "error: the states of qd are missing\n  hint: --states qd=FILE\n",
        ),
        (
            vec![&two],
            "error: an .npy file has one argument, and the function has q, qd\n  hint: --states q=FILE --states qd=FILE\n",
        ),
        (vec![&q, &q, &qd], "error: q occurs twice\n"),
        (
            vec![&q, &qd, &tau],
            "error: the function has no argument tau: leave two.npy out\n",
        ),
        (
            vec![&two, &qd],
            "error: the argument in two.npy is unknown\n  hint: name the argument of each file: --states q=q.npy\n\
             error: the states of q are missing\n  hint: --states q=FILE\n",
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

    // States that end in the middle: the existing file stays unchanged.
    let mine = folder.write("mine.npy", "mine");
    let json = folder.write("bad.json", r#"{"states":[{"q":[1,2]},{"q":[1]}]}"#);
    refused(
        &folder,
        &["--function", "gravity", "--states", &json, "-o", &mine],
    );
    assert_eq!(fs::read(&mine).expect("it is there"), b"mine");
    // If states and results have the same file, it is read before it is replaced.
    assert_eq!(
        eval(&["--function", "gravity", "--states", &q, "-o", &q]),
        Answer::default()
    );
    assert_eq!(numbers(&q).len(), 2600);
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
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
    // A device is written to, and stays a device.
    let null = folder.path("null.npy");
    std::os::unix::fs::symlink("/dev/null", &null).expect("a link");
    assert_eq!(
        eval(&["--function", "gravity", "--states", &q, "-o", &null]),
        Answer::default()
    );
    assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
}

//! Names that deceive terminals, editors, compilers: each is shown, none is obeyed, whichever way it
//! leaves the program.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use homogen_cli::Answer;
use serde_json::Value;

use super::homogen;

/// Characters that no output may contain unescaped: controls, marks of direction, characters without width.
fn is_hidden(letter: char) -> bool {
    let alone = [
        '\u{7f}', '\u{ad}', '\u{61c}', '\u{200b}', '\u{200c}', '\u{200d}', '\u{200e}', '\u{200f}',
        '\u{2028}', '\u{2029}', '\u{2060}', '\u{feff}',
    ];
    let ranges = [
        '\0'..='\u{1f}',
        '\u{80}'..='\u{9f}',
        '\u{202a}'..='\u{202e}',
        '\u{2066}'..='\u{2069}',
    ];
    alone.contains(&letter) || ranges.iter().any(|range| range.contains(&letter))
}

/// As attributes of XML have it: no controls below U+0080 but tab and line ends.
const EVIL: &str = "&#x202e;a&#x2066;b*/ /* c&#x200b;&#10;&#9;&#13;`x` \\ ??/ &quot;&#x85;&#xfeff; // &#x9b;2J&#x61c;&#x7f;";

/// An arm all of whose names end so.
fn arm(evil: &str) -> String {
    let link = |name: &str, xx: f64| {
        format!(
            "<link name=\"{name} {evil}\"><inertial><origin xyz=\"0.1 0 0\"/><mass value=\"1\"/>\
             <inertia ixx=\"{xx}\" ixy=\"0\" ixz=\"0\" iyy=\"0.01\" iyz=\"0\" izz=\"0.01\"/></inertial></link>"
        )
    };
    let joint = |name: &str, kind: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name} {evil}\" type=\"{kind}\"><parent link=\"{parent} {evil}\"/>\
             <child link=\"{child} {evil}\"/><origin xyz=\"0.3 0 0\" rpy=\"1.5708 0 0\"/>\
             <axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" velocity=\"1\" effort=\"1\"/></joint>"
        )
    };
    [
        format!("<robot name=\"arm {evil}\"><link name=\"base {evil}\"/>"),
        // No body has the first one's inertia.
        link("upper", 0.05),
        link("fore", 0.01),
        format!("<link name=\"eye {evil}\"/>"),
        joint("shoulder", "revolute", "base", "upper"),
        joint("elbow", "revolute", "upper", "fore"),
        joint("mount", "fixed", "fore", "eye"),
        "</robot>".to_owned(),
    ]
    .concat()
}

fn path(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile");
    fs::create_dir_all(&folder).expect("a folder to write in");
    folder.join(name)
}

fn all_is_shown(answer: &Answer, what: &str) {
    for text in [&answer.output, &answer.remarks] {
        let hidden: Vec<char> = text
            .chars()
            .filter(|&c| c != '\n' && is_hidden(c))
            .collect();
        assert!(hidden.is_empty(), "{what}: {hidden:?}");
    }
}

#[test]
fn every_command_shows_them() {
    let states = path("states.json");
    fs::write(&states, r#"{"states":[{"q":[0,0]}]}"#).expect("a file");
    let eval = format!("eval - --function gravity --states {}", states.display());
    for command in [
        "check -",
        "check - --format json",
        "count -",
        "count - --format json",
        "inspect - --function gravity",
        "show - --functions gravity",
        "generate -",
        "generate - --language c",
        &eval,
        &format!("{eval} --format json"),
    ] {
        let answer = homogen(command, &arm(EVIL));
        assert_eq!(answer.code, 0, "{command}: {}", answer.remarks);
        all_is_shown(&answer, command);
        let whole = answer.output + &answer.remarks;
        let escape = if command.contains("format json") {
            "\\u202ea"
        } else {
            "\\u{202e}a"
        };
        assert!(whole.contains(escape), "{command}: {whole}");
    }
    let strict = homogen("check - --strict", &arm(EVIL));
    assert_eq!(strict.code, 1);
    all_is_shown(&strict, "mistakes");
    assert!(strict.remarks.contains("\\u{202e}a"), "{}", strict.remarks);
    // A name is what it was: JSON gives it back whole.
    let json: Value =
        serde_json::from_str(&homogen("check - --format json", &arm("\u{202e}")).output)
            .expect("JSON");
    assert_eq!(json["joints"][0], "shoulder \u{202e}");
}

#[test]
fn mistakes_show_them_and_begin_no_line() {
    let text = arm(EVIL).replace("type=\"fixed\"", "type=\"&#x202e;&#10;error: all is lost\"");
    let answer = homogen("check -", &text);
    assert_eq!(answer.code, 1);
    all_is_shown(&answer, "a type that is unknown");
    assert_eq!(
        answer.remarks.matches("\nerror:").count(),
        0,
        "{}",
        answer.remarks
    );
    // A table may hold controls of every kind.
    let table =
        "convention modified\njoint kind a alpha d theta\n\u{1b}[2J\u{7}j revolute 0 0 0 0\n";
    for command in ["check -", "count -", "generate -", "check - --format json"] {
        all_is_shown(&homogen(command, table), command);
    }
    let text = format!("{table}\u{1b}]0;k revolut\u{202e} 0 0 0 0\n");
    let answer = homogen("check -", &text);
    assert_eq!(answer.code, 1);
    all_is_shown(&answer, "a table");
    // So may the name of a file, and the words of an option.
    all_is_shown(&homogen("check no\u{202e}\u{1b}/such.urdf", ""), "a path");
    all_is_shown(&homogen("check - --tip \u{202e}\u{1b}", &arm("")), "a tip");
}

#[test]
fn files_with_them_compile_without_a_warning() {
    let (rust, header, source) = (path("evil.rs"), path("evil.h"), path("evil.c"));
    let command = format!(
        "generate - --extern-c evil_ --c-header {} -o {}",
        header.display(),
        rust.display()
    );
    let answer = homogen(&command, &arm(EVIL));
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    // The file in C has its header beside it, and is compiled by itself.
    let c99 = path("evil99.c");
    let command = format!("generate - --language c -o {}", c99.display());
    let answer = homogen(&command, &arm(EVIL));
    assert_eq!(answer.code, 0, "{}", answer.remarks);
    for file in [&rust, &header, &c99, &c99.with_extension("h")] {
        let text = fs::read_to_string(file).expect("it was written");
        assert!(
            text.chars().all(|c| c == '\n' || !is_hidden(c)),
            "{}",
            file.display()
        );
    }
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    compiles(
        Command::new(rustc)
            .args([
                "--edition",
                "2021",
                "--crate-type",
                "lib",
                "--emit",
                "metadata",
            ])
            .args(["-D", "warnings", "-o"])
            .arg(path("evil.rmeta"))
            .arg(&rust),
    );
    fs::write(&source, "#include \"evil.h\"\n").expect("a file");
    // Rust links with this compiler.
    for standard in ["-std=c99", "-std=gnu17"] {
        for source in [&source, &c99] {
            compiles(
                Command::new("cc")
                    .args([
                        standard,
                        "-Wall",
                        "-Wextra",
                        "-Werror",
                        "-pedantic",
                        "-fsyntax-only",
                    ])
                    .arg(source),
            );
        }
    }
}

fn compiles(compiler: &mut Command) {
    let output = compiler.output().expect("a compiler");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && said.is_empty(),
        "{compiler:?}\n{said}"
    );
}

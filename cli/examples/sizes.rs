//! Costs of robots with many joints: operations and text, and times to expand, compile and call.
//!
//! `cargo run -p homogen-cli --example sizes -- [--joints 16,29,256] [OPTION …]`, where options are
//! those of `homogen generate`, such as `--section 800`; `-- --robot chain 64` writes a robot's URDF instead.
//!
//! Takes the numbers of joints (16, 29, 32 and 64 by default) and options of functions, and prints a table in Markdown.
//! The robots are the same on every machine: revolute joints with oblique axes and offsets, and full inertias; a chain,
//! and a tree of limbs of eight joints; with 29 joints a humanoid, whose functions are all compiled together. Seconds
//! are processor time, because other programs may run at the same time; memory is the maximum. Built without
//! optimisation, as proc macros are, it measures the expansion time of a derive.
//!
//! GNU time measures, at `/usr/bin/time`; `rustc` is the one in the path.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Output};
use std::{env, fs};

use homogen_cli as cli;
use homogen_random::Random;

type Fallible<T> = Result<T, Box<dyn Error>>;

const JOINTS: &str = "16,29,32,64";

/// Number of joints of a humanoid.
const HUMANOID: usize = 29;

/// Functions with their arguments.
const FUNCTIONS: [(&str, &str); 3] = [
    ("inverse_dynamics", "q, qd, qdd"),
    ("forward_dynamics", "q, qd, tau"),
    ("mass_matrix", "q"),
];

/// Maximum number of joints for the mass matrix, which grows with their square.
const MOST_OF_MATRICES: usize = 64;

fn main() -> Fallible<()> {
    let words: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match &*words {
        ["--robot", kind, joints] => {
            print!("{}", robot(kind, joints.parse()?)?);
            Ok(())
        }
        ["--expand", from, to, options @ ..] => expand(from, to, options),
        ["--joints", joints, options @ ..] => measure(joints, options),
        options => measure(JOINTS, options),
    }
}

/// Runs the command line.
fn expand(from: &str, to: &str, options: &[&str]) -> Fallible<()> {
    let words = [
        "homogen", "generate", from, "--scalar", "f64", "--name", "Robot", "-o", to,
    ];
    let words = words.iter().chain(options).map(Into::into);
    let answer = cli::answer(words, &mut std::io::empty());
    if answer.code == 0 {
        Ok(())
    } else {
        Err(answer.remarks.into())
    }
}

fn measure(joints: &str, options: &[&str]) -> Fallible<()> {
    let folder = env::temp_dir().join("homogen_sizes");
    fs::create_dir_all(&folder)?;
    println!(
        "| robot | function | mul and add | kB of text | expanded s | MB | debug s | MB | release s | MB | ns a joint |"
    );
    println!("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    for joints in joints.split(',') {
        let joints = joints.parse()?;
        if joints == HUMANOID {
            row(&folder, ("humanoid", joints), None, options)?;
            continue;
        }
        for kind in ["chain", "tree"] {
            for of in FUNCTIONS {
                if of.0 != "mass_matrix" || joints <= MOST_OF_MATRICES {
                    row(&folder, (kind, joints), Some(of), options)?;
                }
            }
        }
    }
    Ok(())
}

/// One function, or all.
fn row(
    folder: &Path,
    (kind, joints): (&str, usize),
    function: Option<(&str, &str)>,
    options: &[&str],
) -> Fallible<()> {
    let name = function.map_or("all", |(name, _)| name);
    let file = |ending: &str| folder.join(format!("{kind}_{joints}_{name}.{ending}"));
    let (urdf, source) = (file("urdf"), file("rs"));
    fs::write(&urdf, robot(kind, joints)?)?;
    let mut expansion = vec![
        "--expand".into(),
        urdf.into_os_string(),
        source.clone().into(),
    ];
    expansion.extend(options.iter().map(Into::into));
    match function {
        Some((name, _)) => expansion.extend(["--functions".into(), name.into()]),
        None => expansion.extend(["--tip".into(), "l21".into()]),
    }
    let expanded = Cost::of(&env::current_exe()?, expansion)?;
    let text = fs::read_to_string(&source)?;
    let library = file("rlib");
    // Functions that are not called would not be compiled in a program.
    let compiled = |flags: &[&str]| {
        let flags = ["--edition=2021", "--crate-type=lib", "-Awarnings"]
            .iter()
            .chain(flags);
        let mut words: Vec<_> = flags.map(Into::into).collect();
        words.extend(["-o".into(), library.clone().into(), source.clone().into()]);
        Cost::of(Path::new("rustc"), words)
    };
    let debug = compiled(&["-Cdebuginfo=2"])?;
    let release = compiled(&["-Copt-level=3"])?;
    let called = function.map(|function| {
        let program = file("main.rs");
        fs::write(&program, timed(&text, joints, function))?;
        let executable = file(env::consts::EXE_EXTENSION);
        let mut rustc = Command::new("rustc");
        rustc.args([
            "--edition=2021",
            "--crate-name=timed",
            "-Awarnings",
            "-Copt-level=3",
            "-o",
        ]);
        checked(rustc.args([&executable, &program]).output()?)?;
        let output = checked(Command::new(&executable).output()?)?;
        Fallible::Ok(String::from_utf8(output.stdout)?)
    });
    let called = called.transpose()?.unwrap_or_default();
    println!(
        "| {kind} {joints} | `{name}` | {} | {} | {expanded} | {debug} | {release} | {} |",
        operations(&text),
        text.len().div_ceil(1000),
        called.trim()
    );
    Ok(())
}

/// Multiplications and additions, from the head of the file for each function.
fn operations(text: &str) -> usize {
    let heads = text
        .lines()
        .filter(|line| line.starts_with("// ") && line.contains(" mul, "));
    let numbers = heads.flat_map(|line| {
        let before = |word: &str| line.split(word).next()?.rsplit(' ').next()?.parse().ok();
        [before(" mul, "), before(" add, ")]
    });
    numbers
        .map(|number: Option<usize>| number.unwrap_or(0))
        .sum()
}

/// A program that prints the time per call and joint.
fn timed(text: &str, joints: usize, (name, arguments): (&str, &str)) -> String {
    format!(
        "{text}
fn main() {{
    let number = |k: usize| (k % 61) as f64 / 61.0 - 0.45;
    let states: Vec<[[f64; {joints}]; 4]> = (0..64)
        .map(|k| std::array::from_fn(|i| std::array::from_fn(|j| number(13 * k + 7 * i + 11 * j))))
        .collect();
    let mut least = f64::INFINITY;
    for _ in 0..50 {{
        let start = std::time::Instant::now();
        for [q, qd, qdd, tau] in &states {{
            let _ = (q, qd, qdd, tau);
            std::hint::black_box(&Robot.{name}({arguments}));
        }}
        least = least.min(start.elapsed().as_secs_f64());
    }}
    println!(\"{{:.1}}\", 1e9 * least / 64.0 / {joints}.0);
}}
"
    )
}

/// Cost of a program.
struct Cost {
    /// Processor time \[s\].
    seconds: f64,
    kilobytes: f64,
}

impl Cost {
    fn of(program: &Path, words: Vec<std::ffi::OsString>) -> Fallible<Self> {
        let mut command = Command::new("/usr/bin/time");
        let output = command.args(["-f", "%U %M"]).arg(program).args(words);
        let output = checked(output.output()?)?;
        let output = String::from_utf8(output.stderr)?;
        let last = output.lines().last().unwrap_or_default();
        let (seconds, kilobytes) = last.split_once(' ').ok_or("GNU time printed nothing")?;
        Ok(Self {
            seconds: seconds.parse()?,
            kilobytes: kilobytes.parse()?,
        })
    }
}

impl std::fmt::Display for Cost {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{:.2} | {:.0}", self.seconds, self.kilobytes / 1000.0)
    }
}

fn checked(output: Output) -> Fallible<Output> {
    if output.status.success() {
        return Ok(output);
    }
    Err(String::from_utf8_lossy(&output.stderr).into())
}

/// The URDF of a robot.
fn robot(kind: &str, joints: usize) -> Fallible<String> {
    const LIMB: usize = 8;
    let parents: Vec<Option<usize>> = match kind {
        "chain" => (0..joints).map(|k: usize| k.checked_sub(1)).collect(),
        // Each limb is attached to the end of another one, to which two are attached.
        "tree" => (0..joints)
            .map(|k| match (k / LIMB, k % LIMB) {
                (0, 0) => None,
                (limb, 0) => Some((limb - 1) / 2 * LIMB + LIMB - 1),
                _ => Some(k - 1),
            })
            .collect(),
        // A waist of three joints, legs of six on the base, arms of seven on the waist.
        "humanoid" => (0..joints)
            .map(|k| match k {
                0 | 3 | 9 => None,
                15 | 22 => Some(2),
                _ => Some(k - 1),
            })
            .collect(),
        other => return Err(format!("{other} must be chain, tree or humanoid").into()),
    };
    let mut text = format!("<robot name=\"{kind}\"><link name=\"base\"/>\n");
    let mut random = Random::new(29);
    for (k, parent) in parents.iter().enumerate() {
        let parent = parent.map_or_else(|| "base".to_owned(), |parent| format!("l{parent}"));
        let rotations = if kind == "humanoid" && !random.chance(4) {
            [FRAC_PI_2, 0.0, 0.0]
        } else {
            [(); 3].map(|()| 1.5 * random.unit())
        };
        let [x, y, z] = [(); 3].map(|()| 0.3 * random.unit());
        let [roll, pitch, yaw] = rotations;
        let mass = 1.0 + 0.5 * random.unit();
        let [cx, cy, cz] = [(); 3].map(|()| 0.1 * random.unit());
        let size = 0.01 * mass;
        let [xx, yy, zz] = [(); 3].map(|()| size * (1.0 + 0.3 * random.unit()));
        let [xy, xz, yz] = [(); 3].map(|()| 0.1 * size * random.unit());
        writeln!(
            text,
            "<joint name=\"j{k}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"l{k}\"/>\
             <origin xyz=\"{x} {y} {z}\" rpy=\"{roll} {pitch} {yaw}\"/><axis xyz=\"0 0 1\"/>\
             <limit lower=\"-1\" upper=\"1.5\" velocity=\"5\" effort=\"100\"/></joint>\n\
             <link name=\"l{k}\"><inertial><origin xyz=\"{cx} {cy} {cz}\"/><mass value=\"{mass}\"/>\
             <inertia ixx=\"{xx}\" ixy=\"{xy}\" ixz=\"{xz}\" iyy=\"{yy}\" iyz=\"{yz}\" izz=\"{zz}\"/></inertial></link>"
        )?;
    }
    text.push_str("</robot>\n");
    Ok(text)
}

//! The measured program, run function by function.
//!
//! In: executables and the folders with exact results. Out: a [`Point`] for every program in every scene: the median of
//! its rounds. The executables take turns, round by round, so that a drift of the clock affects all of them.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use homogen_codegen::Function;

use crate::peers::Peers;
use crate::program::{Executables, Flags};
use crate::progress::Progress;
use crate::scene::{Scalar, Scene};

/// Time and errors of one program.
#[derive(Clone, Debug)]
pub struct Point {
    /// The scene's name.
    pub scene: String,
    /// The function.
    pub function: Function,
    /// The program.
    pub key: Key,
    /// Time per call: lower quartile, median, upper quartile \[ns\].
    pub time: [f64; 3],
    /// Median over the states of the worst entry's error, relative to its magnitude.
    pub median: f64,
    /// 99th percentile of the same.
    pub rare: f64,
    /// The worst error of any entry at any state, relative to its magnitude.
    pub worst: f64,
}

/// The key of a program among those of a function.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// The name of the variant, or of another program.
    pub variant: String,
    /// The type of number.
    pub scalar: Scalar,
    /// The target of its compilation.
    pub flags: Flags,
}

impl Key {
    /// True for other programs.
    pub fn is_of_a_peer(&self) -> bool {
        self.variant.contains('/')
    }
}

/// The duration of the measurement.
#[derive(Clone, Copy)]
pub struct Effort {
    /// Number of turns of the executables.
    pub rounds: usize,
    /// Number of turns of the programs of one executable in each round.
    pub batches: usize,
}

impl Effort {
    /// Enough to check that everything runs.
    pub const SMOKE: Self = Self {
        rounds: 1,
        batches: 3,
    };
    /// Enough for medians that other load does not change.
    pub const USUAL: Self = Self {
        rounds: 3,
        batches: 21,
    };
    /// Six times as long.
    pub const LONG: Self = Self {
        rounds: 9,
        batches: 43,
    };
}

/// A scene with the folder of its exact results, and the other programs.
pub struct Run<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The folder of its exact results.
    pub truth: PathBuf,
    /// The other programs.
    pub peers: Option<&'a Peers>,
    /// The makers of the compared ones.
    pub makers: &'static [&'static str],
}

/// Runs every program with one state a call.
///
/// # Errors
/// A program that fails, or whose output cannot be read.
pub fn measure(
    executables: &[Executables],
    runs: &[Run<'_>],
    effort: Effort,
    progress: &mut Progress,
) -> Result<Vec<Point>, Box<dyn Error>> {
    let mut points = Vec::new();
    for run in runs {
        for &function in &run.scene.functions {
            let turn = || {
                let mut lines = Vec::new();
                for Executables {
                    flags, measured, ..
                } in executables
                {
                    lines.extend(once(measured, *flags, run, function, &[effort.batches])?);
                }
                Ok(lines)
            };
            points.extend(rounds(run.scene, function, effort, turn)?);
            progress.advance(&format!("{} {}", run.scene.name, function.name()));
        }
    }
    Ok(points)
}

/// Medians over the rounds.
///
/// # Errors
/// A turn that fails.
pub fn rounds(
    scene: &Scene,
    function: Function,
    effort: Effort,
    mut turn: impl FnMut() -> Result<Vec<Line>, Box<dyn Error>>,
) -> Result<Vec<Point>, Box<dyn Error>> {
    let mut lines: BTreeMap<Key, Vec<[f64; 6]>> = BTreeMap::new();
    for _ in 0..effort.rounds {
        for (key, numbers) in turn()? {
            lines.entry(key).or_default().push(numbers);
        }
    }
    let point = |(key, rounds): (Key, Vec<[f64; 6]>)| {
        let middle = |k: usize| median(rounds.iter().map(|numbers| numbers[k]).collect());
        Point {
            scene: scene.name.clone(),
            function,
            key,
            time: [middle(0), middle(1), middle(2)],
            median: middle(3),
            rare: middle(4),
            worst: middle(5),
        }
    };
    Ok(lines.into_iter().map(point).collect())
}

/// A program, and its line of numbers.
pub type Line = (Key, [f64; 6]);

/// The output of an executable for a function; `numbers` are its further arguments, the number of batches first.
///
/// # Errors
/// A failure, or an output that cannot be read.
pub fn once(
    executable: &Path,
    flags: Flags,
    run: &Run<'_>,
    function: Function,
    numbers: &[usize],
) -> Result<Vec<Line>, Box<dyn Error>> {
    let mut command = Command::new(executable);
    command
        .args([&run.scene.name, function.name()])
        .arg(&run.truth)
        .args(numbers.iter().map(usize::to_string));
    // Other programs are compiled for this processor: they are compared with ours for this processor.
    if let (Flags::Native, Some(peers)) = (flags, run.peers) {
        command.args(peers.libraries(run.scene, function, run.makers));
    }
    lines_of(&mut command, flags)
}

/// The output of a program.
///
/// # Errors
/// A failure, or an output that cannot be read.
pub fn lines_of(command: &mut Command, flags: Flags) -> Result<Vec<Line>, Box<dyn Error>> {
    let output = command.output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let text = String::from_utf8(output.stdout)?;
    text.lines().map(|line| read(line, flags)).collect()
}

/// `default f64 91.2 92.0 93.1 1e-17 1e-16 3e-16`
fn read(line: &str, flags: Flags) -> Result<Line, Box<dyn Error>> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [variant, scalar, numbers @ ..] = &words[..] else {
        return Err(format!("not understood: {line}").into());
    };
    let numbers = numbers.iter().map(|number| number.parse());
    let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
    let scalar = if *scalar == Scalar::F32.name() {
        Scalar::F32
    } else {
        Scalar::F64
    };
    let key = Key {
        variant: (*variant).to_owned(),
        scalar,
        flags,
    };
    let numbers = numbers
        .try_into()
        .map_err(|_| format!("not understood: {line}"))?;
    Ok((key, numbers))
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

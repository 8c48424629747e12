//! The measured program, run function by function.
//!
//! In: executables and the folders with the truth. Out: a [`Point`] for every program in every scene.
//! The executables take turns, round by round, so that a drift of the clock meets all alike; what
//! is kept of each program is the median of its rounds.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

use homogen_codegen::Function;

use crate::peers::Peers;
use crate::program::{Executables, Flags};
use crate::progress::Progress;
use crate::scene::{Scalar, Scene};

/// What one program took, and how far it was off.
#[derive(Clone, Debug)]
pub struct Point {
    /// The scene's name.
    pub scene: String,
    /// What was computed.
    pub function: Function,
    /// Which program.
    pub key: Key,
    /// Time per call: lower quartile, median, upper quartile \[ns\].
    pub time: [f64; 3],
    /// Median over the states of the worst entry's error, in relation to its magnitude.
    pub median: f64,
    /// Of 99 in 100 states the worst entry's error is no larger.
    pub rare: f64,
    /// The worst error of any entry at any state, in relation to its magnitude.
    pub worst: f64,
}

/// What tells the programs of a function apart.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Key {
    /// The variant's name, or a peer's.
    pub variant: String,
    /// The type of number.
    pub scalar: Scalar,
    /// What it was compiled for.
    pub flags: Flags,
}

impl Key {
    /// Whether it is not ours.
    pub fn is_of_a_peer(&self) -> bool {
        self.variant.contains('/')
    }
}

/// How long to measure.
#[derive(Clone, Copy)]
pub struct Effort {
    /// How often the executables take turns.
    pub rounds: usize,
    /// How often the programs of one executable do, in each round.
    pub batches: usize,
}

impl Effort {
    /// Enough to see that everything runs.
    pub const SMOKE: Self = Self {
        rounds: 1,
        batches: 3,
    };
    /// For medians that a neighbour does not move.
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

/// Where a scene's truth lies, and which peers stand beside ours.
pub struct Run<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The folder of its truth.
    pub truth: PathBuf,
    /// What stands beside ours.
    pub peers: Option<&'a Peers>,
    /// Those of its makers that do.
    pub makers: &'static [&'static str],
}

/// Runs everything that is called for one state.
///
/// # Errors
/// Where a program fails or says what cannot be understood.
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
                let mut said = Vec::new();
                for Executables {
                    flags, measured, ..
                } in executables
                {
                    said.extend(once(measured, *flags, run, function, &[effort.batches])?);
                }
                Ok(said)
            };
            points.extend(rounds(run.scene, function, effort, turn)?);
            progress.advance(&format!("{} {}", run.scene.name, function.name()));
        }
    }
    Ok(points)
}

/// Medians over the rounds of what is said in each turn.
///
/// # Errors
/// Where a turn fails.
pub fn rounds(
    scene: &Scene,
    function: Function,
    effort: Effort,
    mut turn: impl FnMut() -> Result<Vec<Said>, Box<dyn Error>>,
) -> Result<Vec<Point>, Box<dyn Error>> {
    let mut said: BTreeMap<Key, Vec<[f64; 6]>> = BTreeMap::new();
    for _ in 0..effort.rounds {
        for (key, numbers) in turn()? {
            said.entry(key).or_default().push(numbers);
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
    Ok(said.into_iter().map(point).collect())
}

/// A program, and its line of numbers.
pub type Said = (Key, [f64; 6]);

/// What an executable says of a function, for so many batches and whatever else it is to know.
///
/// # Errors
/// Where it fails or says what cannot be understood.
pub fn once(
    executable: &Path,
    flags: Flags,
    run: &Run<'_>,
    function: Function,
    numbers: &[usize],
) -> Result<Vec<Said>, Box<dyn Error>> {
    let mut command = Command::new(executable);
    command
        .args([&run.scene.name, function.name()])
        .arg(&run.truth)
        .args(numbers.iter().map(usize::to_string));
    // Others are compiled for one processor: they stand beside ours for this one.
    if let (Flags::Native, Some(peers)) = (flags, run.peers) {
        command.args(peers.libraries(run.scene, function, run.makers));
    }
    said(&mut command, flags)
}

/// What a program says.
///
/// # Errors
/// Where it fails or says what cannot be understood.
pub fn said(command: &mut Command, flags: Flags) -> Result<Vec<Said>, Box<dyn Error>> {
    let output = command.output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let text = String::from_utf8(output.stdout)?;
    text.lines().map(|line| read(line, flags)).collect()
}

/// `default f64 91.2 92.0 93.1 1e-17 1e-16 3e-16`
fn read(line: &str, flags: Flags) -> Result<Said, Box<dyn Error>> {
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

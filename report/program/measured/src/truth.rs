//! The states of a scene, and the exact results of a function.
//!
//! In: two files of `f64` in little-endian order. `states` has q, q̇, q̈ and τ of each state; their `lengths` are in a
//! file beside it. The file of a function has three numbers for each entry of each result: the exact value as a sum of
//! two, and the magnitude that errors are relative to. The folder `f32` has the same for single precision, if the states
//! differ there. Out: states, and the errors of results.

use std::ops::Range;
use std::path::Path;
use std::{fs, io};

/// States and exact results of one function, for each type of number.
pub struct Truths {
    double: Truth,
    single: Option<Truth>,
}

impl Truths {
    /// Reads the folder of a scene for a function.
    pub fn read(folder: &Path, function: &str) -> io::Result<Self> {
        let single = folder.join("f32");
        let single = single.exists().then(|| Truth::read(&single, function));
        Ok(Self {
            double: Truth::read(folder, function)?,
            single: single.transpose()?,
        })
    }

    /// States and exact results for a type of number.
    pub fn of(&self, scalar: &str) -> &Truth {
        let single = self.single.as_ref().filter(|_| scalar == "f32");
        single.unwrap_or(&self.double)
    }
}

/// States and exact results of one function.
pub struct Truth {
    /// Number of states.
    pub states: usize,
    /// Number of coordinates of the robot.
    pub coordinates: usize,
    /// Number of velocities, accelerations and torques.
    pub velocities: usize,
    arguments: Vec<f64>,
    exact: Vec<[f64; 3]>,
}

/// The errors of results over all states, relative to the magnitudes.
pub struct Errors {
    /// Median of the worst entry of a state.
    pub median: f64,
    /// 99th percentile of the worst entry of a state.
    pub rare: f64,
    /// The worst entry of all states.
    pub worst: f64,
}

impl Truth {
    /// Reads `lengths`, `states` and the file of a function.
    fn read(folder: &Path, function: &str) -> io::Result<Self> {
        let lengths = fs::read_to_string(folder.join("lengths"))?;
        let lengths = lengths.split_whitespace().map(str::parse);
        let lengths: Vec<usize> = lengths
            .collect::<Result<_, _>>()
            .map_err(io::Error::other)?;
        let [coordinates, velocities] = lengths[..] else {
            return Err(io::Error::other("two lengths were expected"));
        };
        let arguments = numbers(&folder.join("states"))?;
        let exact = numbers(&folder.join(function))?;
        Ok(Self {
            states: arguments.len() / (coordinates + 3 * velocities),
            coordinates,
            velocities,
            arguments,
            exact: exact.as_chunks().0.to_vec(),
        })
    }

    /// Number of numbers of a result.
    pub fn entries(&self) -> usize {
        self.exact.len() / self.states
    }

    /// q, q̇, q̈ and τ of each state.
    pub fn arguments(&self) -> &[f64] {
        &self.arguments
    }

    /// Number of numbers of a state.
    pub fn length(&self) -> usize {
        self.coordinates + 3 * self.velocities
    }

    /// The ranges of the arguments of a function in a state: q, q̇, and q̈ or τ.
    pub fn places(&self, function: &str) -> [Range<usize>; 3] {
        let list = |k: usize| {
            let start = self.coordinates + k * self.velocities;
            start..start + self.velocities
        };
        let last = usize::from(function.starts_with("forward_dynamics"));
        [0..self.coordinates, list(0), list(1 + last)]
    }

    /// The errors of results, state by state. Entry k of a result is entry `entries[k]` of the exact one, or entry k if
    /// the list is empty.
    pub fn errors(&self, results: &dyn Fn(usize) -> Vec<f64>, entries: &[usize]) -> Errors {
        let length = self.entries();
        let worst = |(state, exact): (usize, &[[f64; 3]])| {
            let results = results(state).into_iter().enumerate();
            let errors = results.filter_map(|(k, result)| {
                let k = if entries.is_empty() { k } else { entries[k] };
                exact.get(k).map(|exact| error(result, *exact))
            });
            errors.fold(0.0, worse)
        };
        let states = self.exact.chunks_exact(length).enumerate();
        let mut errors: Vec<f64> = states.map(worst).collect();
        errors.sort_by(f64::total_cmp);
        Errors {
            median: errors[errors.len() / 2],
            rare: errors[errors.len() * 99 / 100],
            worst: errors.last().copied().unwrap_or(f64::NAN),
        }
    }
}

fn error(result: f64, [high, low, magnitude]: [f64; 3]) -> f64 {
    let error = (result - high - low).abs();
    if error == 0.0 { 0.0 } else { error / magnitude }
}

/// The larger, and NaN if either is.
fn worse(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

fn numbers(path: &Path) -> io::Result<Vec<f64>> {
    let bytes = fs::read(path)?;
    let (numbers, _) = bytes.as_chunks();
    Ok(numbers
        .iter()
        .map(|number| f64::from_le_bytes(*number))
        .collect())
}

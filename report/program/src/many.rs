//! Many states at once: batches, one call a state, and other programs.
//!
//! In: scenes, and the executables of [`source`]. Out: a [`Point`] for every program, on one thread and on all.

use std::error::Error;
use std::fmt::{Display, Write};

use homogen_codegen::Function;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{self, Item, Library};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::OperationCount;
use homogen_codegen::space::Space;
use homogen_plot::Color;

use crate::measure::{Effort, Point, Run, lines_of, once, rounds};
use crate::program::{Executables, Flags};
use crate::progress::Progress;
use crate::scene::{Scalar, Scene};
use crate::truth::as_one;

/// The measured function.
pub const FUNCTION: Function = Function::InverseDynamics;

/// Number of states for each thread, and in a call of frax.
pub const STATES: usize = 16384;

/// Suffix of the name of a program on all threads.
pub const ALL: &str = ":all";

/// The program that measures the limit of the processor, and its number of operations a state.
pub const LIMIT: (&str, f64) = ("limit", 1024.0);

/// An implementation in the report.
pub struct Implementation {
    /// Its name in the measured program; of other programs the maker.
    pub name: &'static str,
    /// Its title in the report.
    pub title: &'static str,
    /// Its colour in the figures.
    pub color: Color,
}

/// One state a call, for comparison with batches.
pub const ALONE: &str = "alone";

/// Ours: one state a call, and batches in registers of each length.
pub const OURS: [Implementation; 4] = [
    implementation(ALONE, "one state at a time", Color::Black),
    implementation("target", "batch, vectors of the target", Color::Grey),
    implementation("avx2", "batch, AVX2", Color::Blue),
    implementation("avx512", "batch, AVX-512", Color::Purple),
];

/// Other programs.
pub const OTHERS: [Implementation; 6] = [
    implementation("pinocchio", "Pinocchio", Color::Vermilion),
    implementation("plain", "CasADi's C", Color::Black),
    implementation("snapped", "CasADi's C, snapped", Color::Black),
    implementation("restrict", "CasADi's C, with `restrict`", Color::Black),
    implementation("mujoco", "MuJoCo", Color::Orange),
    implementation("frax", "frax", Color::Wine),
];

const fn implementation(name: &'static str, title: &'static str, color: Color) -> Implementation {
    Implementation { name, title, color }
}

/// The measurements of many states.
pub struct Many<'a> {
    /// The robots.
    pub scenes: Vec<&'a Scene>,
    /// The operation count of each.
    pub operation_counts: Vec<OperationCount>,
    /// The versions of other programs, in addition to those for one state.
    pub versions: &'a str,
    /// One measurement for each program.
    pub points: Vec<Point>,
    /// The reasons why other programs are missing.
    pub missing: Vec<String>,
}

impl Many<'_> {
    /// The measurement of an implementation.
    pub fn find(
        &self,
        scene: &Scene,
        name: &str,
        all: bool,
        scalar: Scalar,
        flags: Flags,
    ) -> Option<&Point> {
        self.points.iter().find(|point| {
            point.scene == scene.name
                && name_of(point) == name
                && point.key.variant.ends_with(ALL) == all
                && point.key.scalar == scalar
                && point.key.flags == flags
        })
    }
}

/// The name of the implementation.
pub fn name_of(point: &Point) -> &str {
    let name = &point.key.variant;
    let name = name.strip_suffix(ALL).unwrap_or(name);
    name.split_once('/').map_or(name, |(maker, _)| maker)
}

/// The source of all scenes for `many`, and the operation count of each.
///
/// # Errors
/// Errors of a robot's description.
pub fn source(scenes: &[&Scene]) -> Result<(String, Vec<OperationCount>), Box<dyn Error>> {
    let (mut modules, mut arms, mut operation_counts) = (String::new(), String::new(), Vec::new());
    for (k, scene) in scenes.iter().enumerate() {
        let request = Request {
            functions: vec![vec![FUNCTION]],
            batch: true,
            ..scene.request.clone()
        };
        let module = expand(&scene.description, &request).map_err(as_one)?;
        let methods = rust::print(&module, &Item::named_after("robot"), &Library::default());
        writeln!(
            modules,
            "#[allow(dead_code, reason = \"batches are called as a builder has them\")] mod m_{k} {{ {methods} }}"
        )?;
        writeln!(
            arms,
            "(\"{}\", \"{name}\") => programs!(m_{k}::Robot, {name}, {}, {}),",
            scene.name,
            scene.length(Space::Coordinates),
            scene.length(Space::Velocities),
            name = FUNCTION.name(),
        )?;
        operation_counts.push(module.functions[0].operation_count);
    }
    let mut text = String::new();
    for scalar in [Scalar::F64, Scalar::F32].map(Scalar::name) {
        writeln!(
            text,
            "fn in_{scalar}(scene: &str, function: &str) -> Vec<Program<{scalar}>> {{\n\
             match (scene, function) {{ {arms} _ => Vec::new() }}\n}}"
        )?;
    }
    Ok((text + &modules, operation_counts))
}

/// Runs everything: in each round, each executable and then frax.
///
/// # Errors
/// A homogen program that fails, or whose output cannot be read.
pub fn measure<'a>(
    executables: &[Executables],
    runs: &[Run<'a>],
    effort: Effort,
    operation_counts: Vec<OperationCount>,
    progress: &mut Progress,
) -> Result<Many<'a>, Box<dyn Error>> {
    let mut points = Vec::new();
    let mut missing: Vec<String> = Vec::new();
    for run in runs {
        let turn = || {
            let numbers = [effort.batches, STATES];
            let mut all = Vec::new();
            for Executables { flags, many, .. } in executables {
                all.extend(once(many, *flags, run, FUNCTION, &numbers)?);
            }
            for scalar in [Scalar::F64, Scalar::F32] {
                let Some(peers) = run.peers else { continue };
                // frax takes a thousand times as long.
                let batches = effort.batches.div_ceil(7);
                let mut frax = peers.frax(run.scene, &run.truth, batches, STATES, scalar);
                match lines_of(&mut frax, Flags::Native) {
                    Ok(lines) => all.extend(lines),
                    Err(reason) => missing.push(reason_of("frax", run.scene, &*reason)),
                }
            }
            Ok(all)
        };
        let found = rounds(run.scene, FUNCTION, effort, turn)?;
        if run.peers.is_some() && !found.iter().any(|point| name_of(point) == "mujoco") {
            missing.push(reason_of("MuJoCo", run.scene, &"it has no library"));
        }
        points.extend(found);
        progress.advance(&format!("{}, many states", run.scene.name));
    }
    missing.dedup();
    Ok(Many {
        scenes: runs.iter().map(|run| run.scene).collect(),
        operation_counts,
        versions: runs
            .iter()
            .find_map(|run| run.peers)
            .map_or("", |peers| &peers.versions_of_many),
        points,
        missing,
    })
}

/// The reason why a program is missing for a scene: the last line of its output, which has the error.
fn reason_of(other: &str, scene: &Scene, reason: &dyn Display) -> String {
    let reason = reason.to_string();
    let last = reason.trim().lines().last().unwrap_or_default();
    format!("{other} for {}: {last}", scene.title)
}

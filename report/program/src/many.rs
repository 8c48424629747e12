//! Many states at once: our batches, one call a state, and others.
//!
//! In: scenes, and the executables that were compiled of [`source`]. Out: a [`Point`] for every program, on one
//! thread and on all. It never says what they mean.

use std::error::Error;
use std::fmt::{Display, Write};

use homogen_codegen::Function;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{self, Item, World};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::Price;
use homogen_codegen::space::Space;
use homogen_plot::Color;

use crate::measure::{Effort, Point, Run, once, rounds, said};
use crate::program::{Executables, Flags};
use crate::progress::Progress;
use crate::scene::{Scalar, Scene};
use crate::truth::told;

/// What is computed.
pub const FUNCTION: Function = Function::InverseDynamics;

/// Of how many states for each thread, and in a call of frax.
pub const STATES: usize = 16384;

/// What stands behind the name of a program that ran on all threads.
pub const ALL: &str = ":all";

/// The program that tells what the processor can compute, and how many operations it does in the place of a state.
pub const LIMIT: (&str, f64) = ("limit", 1024.0);

/// A program, as readers see it.
pub struct Way {
    /// What it is called there: ours by its own name, others by who made them.
    pub name: &'static str,
    /// What readers call it.
    pub title: &'static str,
    /// Its colour in the figures.
    pub color: Color,
}

/// One state a call, which batches stand beside.
pub const ALONE: &str = "alone";

/// Ours: one state a call, and batches on each kind of vectors.
pub const OURS: [Way; 6] = [
    way(ALONE, "one state at a time", Color::Black),
    way("target", "batch, vectors of the build", Color::Grey),
    way("avx2", "batch, AVX2", Color::Sky),
    way("avx2_fused", "batch, AVX2, fused", Color::Blue),
    way("avx512", "batch, AVX-512", Color::Green),
    way("avx512_fused", "batch, AVX-512, fused", Color::Purple),
];

/// Others.
pub const OTHERS: [Way; 6] = [
    way("pinocchio", "Pinocchio", Color::Vermilion),
    way("plain", "CasADi's C", Color::Black),
    way("snapped", "the same, snapped", Color::Black),
    way("restrict", "the same, with `restrict`", Color::Black),
    way("mujoco", "MuJoCo", Color::Orange),
    way("frax", "frax", Color::Wine),
];

const fn way(name: &'static str, title: &'static str, color: Color) -> Way {
    Way { name, title, color }
}

/// What was measured.
pub struct Many<'a> {
    /// The robots.
    pub scenes: Vec<&'a Scene>,
    /// What the function of each costs.
    pub prices: Vec<Price>,
    /// With what others were made, beside those that are called for one state.
    pub versions: &'a str,
    /// Every program.
    pub points: Vec<Point>,
    /// Why some of the others are missing.
    pub missing: Vec<String>,
}

impl Many<'_> {
    /// A program of ours, or the only one of another.
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

/// The name of a way.
pub fn name_of(point: &Point) -> &str {
    let name = &point.key.variant;
    let name = name.strip_suffix(ALL).unwrap_or(name);
    name.split_once('/').map_or(name, |(maker, _)| maker)
}

/// The source of all scenes, as `many` includes it, and what the function of each costs.
///
/// # Errors
/// Where a robot has mistakes.
pub fn source(scenes: &[&Scene]) -> Result<(String, Vec<Price>), Box<dyn Error>> {
    let (mut modules, mut arms, mut prices) = (String::new(), String::new(), Vec::new());
    for (k, scene) in scenes.iter().enumerate() {
        let request = Request {
            functions: vec![vec![FUNCTION]],
            batch: true,
            ..scene.request.clone()
        };
        let module = expand(&scene.description, &request).map_err(told)?;
        let methods = rust::print(&module, &Item::named_after("robot"), &World::default());
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
        prices.push(module.functions[0].price);
    }
    let mut text = String::new();
    for scalar in [Scalar::F64, Scalar::F32].map(Scalar::name) {
        writeln!(
            text,
            "fn in_{scalar}(scene: &str, function: &str) -> Vec<Program<{scalar}>> {{\n\
             match (scene, function) {{ {arms} _ => Vec::new() }}\n}}"
        )?;
    }
    Ok((text + &modules, prices))
}

/// Runs everything: in each round, each executable and then frax.
///
/// # Errors
/// Where a program of ours fails or says what cannot be understood.
pub fn measure<'a>(
    executables: &[Executables],
    runs: &[Run<'a>],
    effort: Effort,
    prices: Vec<Price>,
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
                // It takes a thousand times as long as ours.
                let batches = effort.batches.div_ceil(7);
                let mut frax = peers.frax(run.scene, &run.truth, batches, STATES, scalar);
                match said(&mut frax, Flags::Native) {
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
        prices,
        versions: runs
            .iter()
            .find_map(|run| run.peers)
            .map_or("", |peers| &peers.versions_of_many),
        points,
        missing,
    })
}

/// Why another is missing beside a scene: the last line of what was said, in which programs tell what failed.
fn reason_of(other: &str, scene: &Scene, reason: &dyn Display) -> String {
    let reason = reason.to_string();
    let last = reason.trim().lines().last().unwrap_or_default();
    format!("{other} beside {}: {last}", scene.title)
}

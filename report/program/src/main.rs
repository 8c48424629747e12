//! Measures speed against error on this machine, and writes tables and plots.
//!
//! In: the robots of this repository. Out: a page, `report/REPORT.md`, the details, `report/DETAILS.md`, and their
//! figures.
//!
//! 1. The scenes and their variants are expanded into one program, which is compiled without flags and for
//!    this processor.
//! 2. Exact results are computed.
//! 3. The programs run in turns.
//! 4. Tables and figures are written.

mod chain;
mod document;
mod figures;
mod growth;
mod hard;
mod many;
mod measure;
mod origin;
mod output;
mod peers;
mod program;
mod progress;
mod scene;
mod simplified;
mod source;
mod states;
mod truth;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use clap::Parser;
use document::Measured;
use measure::{Effort, Run};
use origin::Origin;
use peers::{MAKERS, MAKERS_OF_MANY, Peers};
use program::Flags;
use progress::Progress;
use scene::Scene;

/// Measure speed against error on this machine, and write tables and plots
#[derive(Parser)]
#[command(name = "homogen report")]
struct Options {
    /// Folder of the report [default: `report` in the repository]
    #[arg(long, short, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Measure six times as long
    #[arg(long, conflicts_with = "smoke")]
    long: bool,
    /// Only check that everything runs: two robots, a few batches, no change of the repository
    #[arg(long)]
    smoke: bool,
    /// Folder of other programs for comparison, by report/peer/setup.sh
    #[arg(long, value_name = "FOLDER")]
    peers: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(Options::parse()) {
        Ok(folder) => {
            eprintln!("written: {}", folder.join("REPORT.md").display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The numbers of joints of the chains, and the largest number of operations of a function that is compiled.
const GROWTH: (&[usize], usize) = (&growth::JOINTS, usize::MAX);
const GROWTH_IN_SMOKE: (&[usize], usize) = (&[1, 2, 4], 1000);

fn run(options: Options) -> Result<PathBuf, Box<dyn Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = here.join("../..");
    let origin = Origin::of(&root);
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| here.join("target"), PathBuf::from);
    let work = target.join("work");
    fs::create_dir_all(&work)?;
    let effort = match (options.smoke, options.long) {
        (true, _) => Effort::SMOKE,
        (_, false) => Effort::USUAL,
        (_, true) => Effort::LONG,
    };
    let peers = options.peers.map(Peers::find).transpose()?;
    let mut robots = scene::robots(&root).map_err(truth::as_one)?;
    if options.smoke {
        robots.truncate(1);
        robots.push(scene::free(&root).map_err(truth::as_one)?);
    }
    let models = scene::models(&root).map_err(truth::as_one)?;
    let beside = match &peers {
        Some(peers) => peers.scenes(&root)?,
        None => Vec::new(),
    };
    let scenes = || robots.iter().chain(&models).chain(&beside);
    let (joints, most) = if options.smoke {
        GROWTH_IN_SMOKE
    } else {
        GROWTH
    };
    let of_many = of_many(&robots, &beside, options.smoke);
    let functions: usize = scenes().map(|scene| scene.functions.len()).sum();
    let chains = joints.len() * growth::FUNCTIONS.len();
    let mut progress = Progress::new(functions + chains + of_many.len());

    progress.stage("expanding the robots");
    let source = source::source(scenes())?;
    fs::write(work.join("cases.rs"), &source.text)?;
    let (text, prices_of_many) = many::source(&of_many)?;
    fs::write(work.join("many.rs"), text)?;
    progress.stage("computing exact results");
    let truth = |scene: &Scene| work.join("truth").join(&scene.name);
    for scene in scenes() {
        truth::write(scene, &truth(scene))?;
    }
    progress.stage("computing hard cases");
    let hard = hard::formulations::map();
    let every = hard::functions::maps();
    let mut executables = Vec::new();
    for flags in Flags::ALL {
        progress.stage(&format!("compiling, {}", flags.name()));
        executables.push(program::compile(&work, &target.join("measured"), flags)?);
    }
    progress.stage("growing chains");
    let grown = growth::measure(joints, most, &work.join("growth"), &mut progress)?;
    progress.stage("measuring");
    let run = |scene, makers| Run {
        scene,
        truth: truth(scene),
        peers: peers.as_ref(),
        makers,
    };
    let runs: Vec<Run<'_>> = scenes().map(|scene| run(scene, &MAKERS)).collect();
    let points = measure::measure(&executables, &runs, effort, &mut progress)?;
    progress.stage("measuring many states");
    let runs: Vec<Run<'_>> = (of_many.into_iter())
        .map(|scene| run(scene, &MAKERS_OF_MANY))
        .collect();
    let many = many::measure(&executables, &runs, effort, prices_of_many, &mut progress)?;

    let folder = options.output.unwrap_or_else(|| {
        if options.smoke {
            work.join("smoke")
        } else {
            root.join("report")
        }
    });
    output::write(
        &folder,
        &Measured {
            effort,
            robots: &robots,
            models: &models,
            beside: &beside,
            versions: peers.as_ref().map_or("", |peers| &peers.versions),
            points: &points,
            operation_counts: &source.operation_counts,
            many: &many,
            grown: &grown,
            hard: &hard,
            every: &every,
        },
        &origin,
    )?;
    Ok(folder)
}

/// The robots for many states: those that are compared with other programs, or without these the robots of the
/// repository except the smallest.
fn of_many<'a>(robots: &'a [Scene], beside: &'a [Scene], smoke: bool) -> Vec<&'a Scene> {
    let scenes = match (beside, smoke) {
        ([], true) => &robots[..1],
        ([], false) => &robots[1..],
        (beside, _) => beside,
    };
    scenes.iter().collect()
}

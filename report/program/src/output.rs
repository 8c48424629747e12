//! The files of the report.
//!
//! In: all measurements. Out: a folder with a page, the details, and their figures.

use std::path::Path;
use std::{fs, io};

use homogen_codegen::Function::{ForwardDynamics, InverseDynamics};
use homogen_examples::bars;
use homogen_plot::grid::{self, Grid};
use homogen_plot::heat;

use crate::document::{self, Measured, page};
use crate::figures;
use crate::hard::functions::TYPES;
use crate::origin::Origin;
use crate::scene::Scene;

/// Writes all files.
///
/// # Errors
/// A file that cannot be written.
pub fn write(folder: &Path, measured: &Measured<'_>, origin: &Origin) -> io::Result<()> {
    let Measured {
        robots,
        models,
        beside,
        points,
        ..
    } = *measured;
    fs::create_dir_all(folder)?;
    let svg = |name: &str, figure: &Grid| {
        let path = folder.join(name).with_extension("svg");
        fs::write(path, grid::draw(figure))
    };
    let trade = |scene: &Scene, functions: &[_]| {
        let title = format!("{}: time per call against worst error", scene.title);
        figures::trade(&title, scene, functions, points)
    };
    for scene in robots.iter().chain(beside) {
        svg(&scene.name, &trade(scene, &scene.functions))?;
    }
    // An arm that is compared with other programs, if they are installed.
    let arms = beside.iter().chain(robots);
    if let Some(arm) = arms.into_iter().find(|scene| scene.joints.len() == 7) {
        svg("summary", &trade(arm, &[InverseDynamics, ForwardDynamics]))?;
    }
    // Functions with several formulations.
    let large = robots.iter().filter(|scene| scene.joints.len() >= 7);
    let shown = large.flat_map(|scene| [(scene, InverseDynamics), (scene, ForwardDynamics)]);
    let shown: Vec<_> = shown.collect();
    svg("formulations", &figures::formulations(&shown, points))?;
    svg("models", &figures::models(models, points))?;
    svg("many", &figures::many(measured.many))?;
    fs::write(folder.join("hard.svg"), heat::draw(measured.hard))?;
    for (scalar, map) in TYPES.iter().zip(measured.every) {
        let path = folder.join(format!("hard_{scalar}.svg"));
        fs::write(path, heat::draw(map))?;
    }
    svg("growth", &figures::growth(measured.grown))?;
    let details = document::details(measured, origin);
    fs::write(folder.join("DETAILS.md"), &details)?;
    let figure = match bars::draw(&details) {
        Some(picture) => {
            fs::write(folder.join("bars.svg"), picture)?;
            ["bars", bars::TITLE]
        }
        // Without other programs.
        None => [&*robots[0].name, &*robots[0].title],
    };
    let page = page::write(measured, origin, figure, folder);
    fs::write(folder.join("REPORT.md"), page)
}

//! The first page of the report.
//!
//! In: the measurements, their origin, the name of the figure. Out: Markdown: machine, builds, date and commit; one
//! figure; one table with the functions that most users call; links to everything else.

use std::fmt::Write;
use std::path::Path;

use homogen_codegen::Function::{
    self, ForwardDynamics, ForwardDynamicsDerivatives, ForwardKinematics, GeometricJacobian,
    InverseDynamics, InverseDynamicsDerivatives,
};
use homogen_examples::machine;

use super::comparison::{self, Comparison};
use super::{Measured, comparisons};
use crate::origin::Origin;
use crate::states::STATES;

/// The functions of the table.
const FUNCTIONS: [Function; 6] = [
    ForwardKinematics,
    GeometricJacobian,
    InverseDynamics,
    InverseDynamicsDerivatives,
    ForwardDynamics,
    ForwardDynamicsDerivatives,
];

/// Further files of the folder: file, title, the command that writes it.
const FILES: [(&str, &str, &str); 2] = [
    (
        "COMPILE.md",
        "Compile time",
        "report/compile.py > report/COMPILE.md",
    ),
    (
        "FLAGS.md",
        "Every function of every robot that ships, without flags and native",
        "report/flags.py > report/FLAGS.md",
    ),
];

/// The page. `figure` is the name and the caption of the figure, `folder` where the page is written.
pub fn write(
    measured: &Measured<'_>,
    origin: &Origin,
    [figure, caption]: [&str; 2],
    folder: &Path,
) -> String {
    let mut text = String::from("# Speed and error\n\n");
    text.push_str(&head(measured, origin));
    let _ = writeln!(text, "![{caption}]({figure}.svg)\n");
    text.push_str(&table(measured));
    text.push_str(&links(folder));
    text
}

fn head(measured: &Measured<'_>, origin: &Origin) -> String {
    let others = match measured.versions {
        "" => "none; `--peers` adds them",
        versions => versions,
    };
    format!(
        "| | |\n|---|---|\n\
         | measured | {} (UTC), commit {} |\n\
         | machine | {} |\n\
         | ours, without flags | `cargo build --release`, {}; instructions are chosen at run time |\n\
         | ours, native | the same with `-C target-cpu=native` |\n\
         | others | {others} |\n\n",
        origin.date,
        origin.commit,
        machine::processor(),
        machine::COMPILER,
    )
}

fn table(measured: &Measured<'_>) -> String {
    let mut text = format!(
        "Time of one call on one thread [ns], `f64`, median over {STATES} random states; of \
         `_batch` per state, many states a call. Error: worst entry at the worst state, relative \
         to the terms that it is summed from; u = 2⁻⁵³. The fastest other program is \
         Pinocchio, the C that CasADi generates from it, as generated or tuned, or for many \
         states also MuJoCo and frax.\n\n"
    );
    text.push_str(comparison::HEAD);
    let scenes = match measured.beside {
        [] => measured.robots,
        beside => beside,
    };
    for scene in scenes {
        let shown = FUNCTIONS.into_iter();
        for function in shown.filter(|function| scene.functions.contains(function)) {
            text.push_str(&Comparison::of(measured, scene, function).row());
        }
        if measured.many.scenes.iter().any(|of| of.name == scene.name) {
            text.push_str(&Comparison::of_many(measured.many, scene).row());
        }
    }
    let _ = writeln!(
        text,
        "\nAll functions of all robots of this report ([table](DETAILS.md#without-flags)):\n\n{}",
        comparison::in_short(&comparisons(measured))
    );
    text
}

fn links(folder: &Path) -> String {
    let mut text = String::from(
        "- [Details](DETAILS.md): method, every function, formulations, other programs, many \
         states, hard cases, simpler models, long chains.\n",
    );
    for (file, title, command) in FILES {
        let title = if folder.join(file).exists() {
            format!("[{title}]({file})")
        } else {
            title.to_owned()
        };
        let _ = writeln!(text, "- {title}: `{command}`.");
    }
    text
}

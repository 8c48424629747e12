//! The report as Markdown.
//!
//! In: the measurements. Out: a page, and the details: tables, with the figures between them. Operation counts are exact,
//! and a test compares the committed copy with them; times belong to the machine that the first lines name.

mod cells;
mod comparison;
pub mod many;
pub mod page;

use std::fmt::Write;

use homogen_codegen::Function;
use homogen_codegen::schedule::OperationCount;
use homogen_examples::{machine, timing};
use homogen_plot::heat::Map;

use cells::{fastest, find, in_units, operation_count, spread, time, units};
use comparison::Comparison;

use crate::growth::{self, Grown};
use crate::hard::functions::TYPES;
use crate::many::Many;
use crate::measure::{Effort, Point};
use crate::origin::Origin;
use crate::peers::MAKERS;
use crate::program::Flags;
use crate::scene::{Scalar, Scene, Variant};
use crate::source::GENERIC;
use crate::states::STATES;

/// All measurements.
pub struct Measured<'a> {
    /// The duration of the measurement.
    pub effort: Effort,
    /// The robots of the repository.
    pub robots: &'a [Scene],
    /// The scenes with simpler models.
    pub models: &'a [Scene],
    /// The robots that are compared with other programs.
    pub beside: &'a [Scene],
    /// The versions of the other programs; empty without any.
    pub versions: &'a str,
    /// Every program in every scene.
    pub points: &'a [Point],
    /// Scene, variant, function, operation count.
    pub operation_counts: &'a [(String, &'static str, Function, OperationCount)],
    /// Many states at once.
    pub many: &'a Many<'a>,
    /// Chains.
    pub grown: &'a [Grown],
    /// Hard cases by formulation.
    pub hard: &'a Map,
    /// Worst errors of every function of hard robots, one map a type of [`TYPES`].
    pub every: &'a [Map; 2],
}

/// The text of the details.
pub fn details(measured: &Measured<'_>, origin: &Origin) -> String {
    let mut text = String::from("# Speed and error: details\n\n");
    text.push_str(&method(measured, origin));
    text.push_str(&robots(measured));
    text.push_str(&without_flags(measured));
    text.push_str(&formulations(measured));
    if !measured.versions.is_empty() {
        text.push_str(&peers(measured));
    }
    text.push_str(&many::write(measured.many));
    text.push_str(&hard(measured));
    text.push_str(&models(measured));
    text.push_str(&grown(measured.grown));
    text
}

fn method(measured: &Measured<'_>, origin: &Origin) -> String {
    let Effort { rounds, batches } = measured.effort;
    format!(
        "The [first page](REPORT.md) has the results that most users need.\n\n\
         - Measured with `homogen report` on {processor}; {date} (UTC), commit {commit}.\n\
         - {rustc}, opt-level 3, built twice: without flags, where instructions are chosen at run \
         time, and native, with `-C target-cpu=native`.\n\
         - One thread. A time is the median of {rounds} rounds. In each round all programs of a \
         function take {batches} turns. A turn calls the function in {STATES} random states: once \
         before the clock starts if that takes less than {slow} ms, then with the clock. Only \
         ratios carry over to another machine.\n\
         - An error is the worst over all entries of a result and all states, against the same \
         function in 106 bits. It is relative to the sum of the magnitudes of the terms of the \
         entry; where a mass matrix is inverted, to the largest entry of the result. u is the \
         unit roundoff, 2⁻⁵³ for `f64` and 2⁻²⁴ for `f32`.\n\
         - The generic recursion is that of `homogen::generic` in the runtime crate. It reads the \
         robot when it runs; the derive writes straight-line code.\n\n",
        date = origin.date,
        commit = origin.commit,
        processor = machine::processor(),
        rustc = machine::COMPILER,
        slow = timing::SLOW.as_millis(),
    )
}

fn robots(measured: &Measured<'_>) -> String {
    let mut text = String::from(
        "## Robots that ship\n\n\
         Times in ns; counts are those of the doc comments. Errors of native programs: median over \
         the states, 99th percentile, worst.\n\n",
    );
    for scene in measured.robots {
        let _ = writeln!(
            text,
            "### {}\n\n![{0}: time per call against worst error]({}.svg)\n\n\
             | function | mul | add | div | sin, cos | f64, without flags | native | f32, without flags | native | generic recursion, native | error f64 | f32 | generic recursion |\n\
             |---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|",
            scene.title, scene.name
        );
        for &function in &scene.functions {
            let operation_count = operation_count(measured, scene, Variant::DEFAULT.name, function);
            let at =
                |variant, scalar, flags| find(measured, scene, function, variant, scalar, flags);
            let default = |scalar, flags| at(Variant::DEFAULT.name, scalar, flags);
            let generic = at(GENERIC, Scalar::F64, Flags::Native);
            let _ = writeln!(
                text,
                "| `{}` | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
                function.name(),
                operation_count.mul,
                operation_count.add,
                operation_count.div,
                operation_count.sin + operation_count.cos,
                time(default(Scalar::F64, Flags::Without)),
                time(default(Scalar::F64, Flags::Native)),
                time(default(Scalar::F32, Flags::Without)),
                time(default(Scalar::F32, Flags::Native)),
                time(generic),
                spread(default(Scalar::F64, Flags::Native)),
                spread(default(Scalar::F32, Flags::Native)),
                spread(generic),
            );
        }
        text.push('\n');
    }
    text
}

/// All functions of all robots, one state a call, and many states.
fn comparisons<'a>(measured: &Measured<'a>) -> Vec<Comparison<'a>> {
    let scenes = measured.robots.iter().chain(measured.beside);
    let one = scenes.flat_map(|scene| {
        let functions = scene.functions.iter();
        functions.map(|&function| Comparison::of(measured, scene, function))
    });
    let many = measured.many;
    let of_many = many
        .scenes
        .iter()
        .map(|scene| Comparison::of_many(many, scene));
    one.chain(of_many).collect()
}

fn without_flags(measured: &Measured<'_>) -> String {
    let comparisons = comparisons(measured);
    let mut text = format!(
        "## Without flags\n\n\
         Functions above {} ns, `f64`, one thread, times in ns; of `_batch` per state. Errors in u.\n\n{}\n",
        comparison::LONG,
        comparison::in_short(&comparisons)
    );
    text.push_str(comparison::HEAD);
    for comparison in comparisons.iter().filter(|one| one.is_long()) {
        text.push_str(&comparison.row());
    }
    text.push('\n');
    text
}

fn formulations(measured: &Measured<'_>) -> String {
    let mut text = String::from(
        "## Formulations\n\n\
         The same functions in other formulations, `f64`; times in ns. Merged angles lose digits \
         after many turns; these states have at most 4 rad.\n\n\
         ![Formulations: time per call against worst error](formulations.svg)\n\n\
         | robot | function | formulation | mul | add | div | without flags | native | error, without flags | native |\n\
         |---|---|---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for scene in measured.robots {
        for &function in &scene.functions {
            for variant in scene.variants.iter().filter(|v| v.serves(function)) {
                let operation_count = operation_count(measured, scene, variant.name, function);
                let at = |flags| find(measured, scene, function, variant.name, Scalar::F64, flags);
                let _ = writeln!(
                    text,
                    "| {} | `{}` | {} | {} | {} | {} | {} | {} | {} | {} |",
                    scene.title,
                    function.name(),
                    variant.title,
                    operation_count.mul,
                    operation_count.add,
                    operation_count.div,
                    time(at(Flags::Without)),
                    time(at(Flags::Native)),
                    units(at(Flags::Without)),
                    units(at(Flags::Native)),
                );
            }
        }
    }
    text.push('\n');
    text
}

fn peers(measured: &Measured<'_>) -> String {
    let mut text = format!(
        "## Other programs\n\n\
         {}, on the same description, states and thread, all compiled for this processor. \
         `report/peer` sets them up. Pinocchio's templates, and the C that CasADi generates from \
         Pinocchio's algorithms, are loaded into the program that runs ours and take turns with \
         it.\n\n\
         - CasADi's C: as generated; `snapped`, with exact right angles and merged common \
         subexpressions; `restrict`, the same with `restrict` pointers in place of null checks.\n\
         - Mass matrix and forward dynamics: the faster of Pinocchio's two conventions counts.\n\
         - Results: Pinocchio leaves them in its data, of symmetric matrices the upper triangle; \
         ours and CasADi's are returned whole.\n\
         - Sines: random states make the branches of the platform's sines unpredictable, for all \
         that call them; along a smooth motion most are predicted.\n\
         - Right angles: Pinocchio and CasADi's plain C take the digits of the file literally. \
         Where a file has few digits, that is most of their error.\n\n",
        measured.versions
    );
    let with_peers = |scene: &&Scene| {
        let mut points = measured.points.iter();
        points.any(|point| point.scene == scene.name && point.key.is_of_a_peer())
    };
    let scenes = measured.robots.iter().chain(measured.beside);
    for scene in scenes.filter(with_peers) {
        let _ = writeln!(text, "### {}: other programs\n", scene.title);
        // The figures of the robots of the repository are above.
        if !measured.robots.iter().any(|robot| robot.name == scene.name) {
            let _ = writeln!(
                text,
                "![{}: time per call against worst error]({}.svg)\n",
                scene.title, scene.name
            );
        }
        let _ = writeln!(
            text,
            "| function | type | ours | with platform sines | Pinocchio | CasADi | snapped | restrict | ours / fastest other | with platform sines | error of ours | Pinocchio | CasADi | restrict |\n\
             |---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|"
        );
        for scalar in [Scalar::F64, Scalar::F32] {
            for &function in &scene.functions {
                let counted =
                    |variant: &Variant| operation_count(measured, scene, variant.name, function);
                let default = counted(&Variant::DEFAULT);
                let row =
                    |variant: &Variant| row_of_peers(measured, scene, function, variant, scalar);
                text.push_str(&row(&Variant::DEFAULT));
                // Formulations that the engine did not choose.
                let forms = scene.variants.iter().filter(|variant| {
                    variant.functions.contains(&function)
                        && variant.functions.iter().all(|function| function.solves())
                        && variant.scalars.contains(&scalar)
                });
                for form in forms.filter(|form| counted(form) != default) {
                    text.push_str(&row(form));
                }
            }
        }
        text.push('\n');
    }
    text
}

fn row_of_peers(
    measured: &Measured<'_>,
    scene: &Scene,
    function: Function,
    variant: &Variant,
    scalar: Scalar,
) -> String {
    let ours = |variant| find(measured, scene, function, variant, scalar, Flags::Native);
    let (platform, label) = if variant.name == Variant::DEFAULT.name {
        (ours("platform_sines"), String::new())
    } else {
        (None, format!(", {}", variant.title))
    };
    let ours = ours(variant.name);
    let best = MAKERS.map(|maker| fastest(measured, scene, function, maker, scalar));
    let times = best.iter().flatten().map(|point| point.time[1]);
    let least = times.fold(f64::INFINITY, f64::min);
    let ratio = |ours: Option<&Point>| match ours {
        Some(ours) if least.is_finite() => format!("{:.2}", ours.time[1] / least),
        _ => "–".to_owned(),
    };
    let [pinocchio, plain, snapped, restrict] = best.map(time);
    format!(
        "| `{}`{label} | {} | {} | {} | {pinocchio} | {plain} | {snapped} | {restrict} | {} | {} | {} | {} | {} | {} |\n",
        function.name(),
        scalar.name(),
        time(ours),
        time(platform),
        ratio(ours),
        ratio(platform),
        units(ours),
        units(best[0]),
        units(best[1]),
        units(best[3]),
    )
}

fn hard(measured: &Measured<'_>) -> String {
    let mut text = String::from(
        "## Hard cases\n\n\
         Worst error over 200 states, in units of roundoff of the type, without fused operations; \
         a dash where a formulation makes no difference or is rejected. Errors of forward dynamics \
         are relative to the largest acceleration. The tests compare these robots, in more states, \
         with 256 bits.\n\n\
         ![Hard cases by formulation](hard.svg)\n\n",
    );
    table(&mut text, "case", measured.hard);
    text.push_str(
        "Every function in the engine's choice of formulation, over 40 states of each robot. \
         Errors of functions that solve with the mass matrix are relative to the largest entry, \
         others to the sum of the magnitudes of the terms; a dash where a function is rejected \
         because rounding would leave too few digits.\n\n",
    );
    for (scalar, map) in TYPES.iter().zip(measured.every) {
        let _ = writeln!(text, "![{}](hard_{scalar}.svg)\n", map.title);
        table(&mut text, &format!("function, {scalar}"), map);
    }
    text
}

/// A table of errors in units of rounding.
fn table(text: &mut String, corner: &str, map: &Map) {
    let _ = write!(text, "| {corner} |");
    for column in &map.columns {
        let _ = write!(text, " {column} |");
    }
    let _ = writeln!(text, "\n|---|{}", "---:|".repeat(map.columns.len()));
    for (title, numbers) in &map.rows {
        let _ = write!(text, "| {title} |");
        for number in numbers {
            let _ = match number {
                Some(number) => write!(text, " {} |", in_units(*number)),
                None => write!(text, " – |"),
            };
        }
        text.push('\n');
    }
    text.push('\n');
}

fn models(measured: &Measured<'_>) -> String {
    let mut text = String::from(
        "## Simpler models\n\n\
         Inverse dynamics of simpler models of the Panda-class arm, against the full model in 106 \
         bits; native, times in ns. Dropped terms are coordinates of a centre of mass and entries \
         of an inertia tensor that are small beside the largest of the same link. A symmetric link \
         has its centre of mass on an axis and equal moments about it. `1.5708 taken literally` is \
         a file with right angles of four decimals, read with `exact`; by default they are read \
         as right angles.\n\n\
         ![Simpler models: time per call against worst error](models.svg)\n\n\
         | scene | model | type | mul | add | time | median error | worst error |\n\
         |---|---|---|---:|---:|---:|---:|---:|\n",
    );
    for scene in measured.models {
        for variant in &scene.variants {
            for &scalar in variant.scalars {
                let function = Function::InverseDynamics;
                let operation_count = operation_count(measured, scene, variant.name, function);
                let point = find(
                    measured,
                    scene,
                    function,
                    variant.name,
                    scalar,
                    Flags::Native,
                );
                let (median, worst) = point.map_or((f64::NAN, f64::NAN), |p| (p.median, p.worst));
                let _ = writeln!(
                    text,
                    "| {} | {} | {} | {} | {} | {} | {median:.0e} | {worst:.0e} |",
                    scene.title,
                    variant.title,
                    scalar.name(),
                    operation_count.mul,
                    operation_count.add,
                    time(point),
                );
            }
        }
    }
    text.push('\n');
    text
}

fn grown(grown: &[Grown]) -> String {
    let mut text = String::from(
        "## Long chains\n\n\
         Chains of equal links with full inertia tensors and skew axes, `f64`. Each function is \
         alone in a file that needs `core` and has its own sines, compiled with `-C opt-level=3`. \
         Expansion is the time from the description to tokens, in a generator built with opt-level \
         1.\n\n\
         ![Counts and times of chains of 1 to 64 joints](growth.svg)\n\n\
         | function | joints | mul | add | div | expansion, ms | compilation, s | call, ns |\n\
         |---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for function in growth::FUNCTIONS {
        for grown in grown.iter().filter(|grown| grown.function == function) {
            let or_none = |number: Option<f64>, digits: usize| {
                number.map_or_else(|| "–".to_owned(), |number| format!("{number:.digits$}"))
            };
            let OperationCount { mul, add, div, .. } = grown.operation_count;
            let _ = writeln!(
                text,
                "| `{}` | {} | {mul} | {add} | {div} | {:.1} | {} | {} |",
                function.name(),
                grown.joints,
                1e3 * grown.expansion,
                or_none(grown.compilation, 2),
                or_none(grown.call, 0),
            );
        }
    }
    text
}

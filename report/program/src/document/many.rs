//! The part of the report about many states.
//!
//! In: the measurements. Out: a summary of ratios, and a table for each robot.

use std::fmt::Write;

use homogen_codegen::schedule::OperationCount;
use homogen_examples::machine;

use super::cells::units;
use crate::figures::count;
use crate::many::{
    ALL, ALONE, FUNCTION, Implementation, LIMIT, Many, OTHERS, OURS, STATES, name_of,
};
use crate::measure::Point;
use crate::program::Flags;
use crate::scene::{Scalar, Scene};
use crate::states;

const SCALARS: [Scalar; 2] = [Scalar::F64, Scalar::F32];

/// Number of evaluations a second on a GPU, from frax's README.
const OF_A_GPU: f64 = 1e8;

/// The text of the part.
pub fn write(many: &Many<'_>) -> String {
    let mut text = method(many);
    text.push_str(&in_short(many));
    for (scene, operation_count) in many.scenes.iter().zip(&many.operation_counts) {
        text.push_str(&robot(many, scene, operation_count));
    }
    text
}

fn method(many: &Many<'_>) -> String {
    let mut text = format!(
        "## Many states\n\n\
         Inverse dynamics of many states a call, on {processor}, in the same run: {STATES} states a \
         thread, {different} random ones repeated, from arrays into arrays. A time is the wall \
         time of all states, divided by their number, on one thread or on all. An error is the \
         worst of all entries.\n\
         A batch has the bits of one state at a time. Both choose their instructions at run \
         time.\n\n",
        processor = machine::processor(),
        different = states::STATES,
    );
    if !many.versions.is_empty() {
        let _ = writeln!(
            text,
            "Other programs: {}.\n\n\
             - Pinocchio and CasADi's C, compiled for this processor, and MuJoCo are called once a \
             state and write its results. On all threads each thread has a copy of the library, \
             and free threads take shares of 512 states, as in our batches. CasADi's own `map` \
             writes the same C: a loop over the function, on threads by OpenMP or by threads that \
             each call starts.\n\
             - MuJoCo has Pinocchio's masses. Constraints, contacts, passive forces, actuators and \
             sensors are switched off; the rest of `mj_inverse` is part of its time.\n\
             - frax's `rnea` is compiled by JAX for {STATES} states a call and chooses its threads.\n",
            many.versions.lines().collect::<Vec<_>>().join("; ")
        );
    }
    for missing in &many.missing {
        let _ = writeln!(text, "Left out: {missing}.\n");
    }
    text.push_str(
        "The limit is the time of independent fused multiply-adds on the widest vectors, measured \
         in turns with the rest, for the mul and add of a state; sines are not counted.\n\n",
    );
    let limit = |scalar, all| {
        // The same for all robots, apart from noise.
        let scene = many.scenes.first()?;
        let point = many.find(scene, LIMIT.0, all, scalar, Flags::Native)?;
        Some(LIMIT.1 / point.time[1])
    };
    let of = |scalar: Scalar| {
        let [one, all] = [false, true].map(|all| limit(scalar, all));
        Some(format!("{:.0} and {:.0} in {}", one?, all?, scalar.name()))
    };
    if let [Some(double), Some(single)] = SCALARS.map(of) {
        let _ = writeln!(
            text,
            "On this machine: {double}, {single} [10⁹ operations a second, one thread and all].\n"
        );
    }
    text.push_str("![Many states: time per state against worst error](many.svg)\n\n");
    text
}

/// Ratios between programs, and rates beside the limit.
fn in_short(many: &Many<'_>) -> String {
    let mut text = String::from("| in short |");
    for scene in &many.scenes {
        let _ = write!(text, " {} |", scene.title);
    }
    let _ = writeln!(text, "\n|---|{}", "---:|".repeat(many.scenes.len()));
    let mut row =
        |title: &str, cell: &dyn Fn(&Scene, &OperationCount) -> Option<f64>, digits: usize| {
            let _ = write!(text, "| {title} |");
            for (scene, operation_count) in many.scenes.iter().zip(&many.operation_counts) {
                let _ = match cell(scene, operation_count) {
                    Some(number) => write!(text, " {number:.digits$} |"),
                    None => write!(text, " – |"),
                };
            }
            text.push('\n');
        };
    for scalar in SCALARS {
        let name = scalar.name();
        let time = |scene: &Scene, implementation: &str, flags| {
            let point = many.find(scene, implementation, false, scalar, flags);
            point.map(|point| point.time[1])
        };
        let avx2 = |scene: &Scene| time(scene, "avx2", Flags::Native);
        row(
            &format!("{name}, batch on AVX2 / one state at a time"),
            &|scene, _| Some(avx2(scene)? / time(scene, ALONE, Flags::Native)?),
            2,
        );
        row(
            &format!("{name}, batch on AVX2 / fastest other program, one thread"),
            &|scene, _| {
                let others = OTHERS
                    .iter()
                    .filter_map(|implementation| time(scene, implementation.name, Flags::Native));
                Some(avx2(scene)? / least(others)?)
            },
            2,
        );
        let best = |scene: &Scene, all, flags| {
            let point = fastest(many, scene, all, scalar, flags);
            point.map(|point| point.time[1])
        };
        row(
            &format!("{name}, fastest batch, without flags / native"),
            &|scene, _| {
                Some(best(scene, false, Flags::Without)? / best(scene, false, Flags::Native)?)
            },
            2,
        );
        for (other, title) in [("pinocchio", "Pinocchio"), ("frax", "frax")] {
            row(
                &format!("{name}, {title} / fastest batch, all threads"),
                &|scene, _| {
                    let other = many.find(scene, other, true, scalar, Flags::Native)?;
                    Some(other.time[1] / best(scene, true, Flags::Native)?)
                },
                0,
            );
        }
        row(
            &format!("{name}, fastest batch, one thread, 10⁶ states a second"),
            &|scene, _| Some(1e3 / best(scene, false, Flags::Native)?),
            1,
        );
        row(
            &format!("{name}, fastest batch, all threads, 10⁶ states a second and thread"),
            &|scene, _| Some(1e3 / best(scene, true, Flags::Native)? / threads()),
            1,
        );
        row(
            &format!("{name}, limit, one thread, 10⁶ states a second"),
            &|scene, operation_count| {
                Some(1e3 / limit(many, scene, operation_count, false, scalar)?)
            },
            1,
        );
        row(
            &format!("{name}, threads of this machine for 10⁸ states a second"),
            &|scene, _| Some(OF_A_GPU * 1e-9 * best(scene, true, Flags::Native)? * threads()),
            1,
        );
    }
    text.push_str(
        "\nPublished figures of GPU libraries: frax \"upwards of 100 million computations per \
         second, depending on your batch size\" \
         ([README of 0.1.0](https://pypi.org/project/frax/0.1.0/)), the 10⁸ of the table; GRiD \"as much as a 7.2x speedup over a state-of-the-art, multi-threaded CPU \
         implementation\", 2.5 with transfers \
         ([Plancher et al.](https://a2r-lab.org/publication/grid/)).\n\n",
    );
    text
}

fn robot(many: &Many<'_>, scene: &Scene, operation_count: &OperationCount) -> String {
    let mut text = format!(
        "### Many states: {}\n\n\
         `{}`, {} mul, {} add, {} sin and cos; times in ns a state, rates in 10⁶ states a second.\n\n\
         | program | build | f64, one thread | of one at a time | rate | all threads | rate a thread | f32, one thread | of one at a time | rate | all threads | rate a thread | error f64 | f32 |\n\
         |---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
        scene.title,
        FUNCTION.name(),
        operation_count.mul,
        operation_count.add,
        operation_count.sin + operation_count.cos,
    );
    for flags in Flags::ALL {
        for implementation in &OURS {
            text.push_str(&row(many, scene, implementation, flags));
        }
    }
    for implementation in &OTHERS {
        text.push_str(&row(many, scene, implementation, Flags::Native));
    }
    let _ = write!(text, "| limit | native |");
    for scalar in SCALARS {
        let [one, all] = [false, true].map(|all| limit(many, scene, operation_count, all, scalar));
        text.push_str(&times(one, None, all));
    }
    text.push_str(" – | – |\n\n");
    text
}

/// The row of a program in both types; empty if it did not run.
fn row(many: &Many<'_>, scene: &Scene, implementation: &Implementation, flags: Flags) -> String {
    let find = |name, all, scalar| many.find(scene, name, all, scalar, flags);
    let ran = |scalar| {
        [false, true]
            .iter()
            .any(|all| find(implementation.name, *all, scalar).is_some())
    };
    if !SCALARS.into_iter().any(ran) {
        return String::new();
    }
    let mut text = format!("| {} | {} |", implementation.title, flags.name());
    for scalar in SCALARS {
        let time = |name, all| find(name, all, scalar).map(|point| point.time[1]);
        text.push_str(&times(
            time(implementation.name, false),
            time(ALONE, false),
            time(implementation.name, true),
        ));
    }
    for scalar in SCALARS {
        let point =
            find(implementation.name, true, scalar).or(find(implementation.name, false, scalar));
        let _ = write!(text, " {} |", units(point));
    }
    text.push('\n');
    text
}

/// Five cells: time, ratio and rate on one thread; time, and rate per thread, on all threads.
fn times(one: Option<f64>, alone: Option<f64>, all: Option<f64>) -> String {
    let digits = |time: f64| usize::from(time < 99.95);
    let time = |time: Option<f64>| time.map(|time| format!("{time:.0$}", digits(time)));
    let rate = |time: Option<f64>, threads| {
        let rate = time.map(|time| 1e3 / time / threads);
        rate.map(|rate| format!("{rate:.0$}", 1 + digits(10.0 * rate)))
    };
    let ratio = one
        .zip(alone)
        .map(|(one, alone)| format!("{:.2}", one / alone));
    let cells = [
        time(one),
        ratio,
        rate(one, 1.0),
        time(all),
        rate(all, threads()),
    ];
    let cells = cells.map(|cell| format!(" {} |", cell.unwrap_or_else(|| "–".to_owned())));
    cells.concat()
}

/// The fastest batch of homogen.
pub fn fastest<'a>(
    many: &'a Many<'_>,
    scene: &Scene,
    all: bool,
    scalar: Scalar,
    flags: Flags,
) -> Option<&'a Point> {
    let is_batch = |point: &&Point| {
        let ours = OURS
            .iter()
            .any(|implementation| implementation.name == name_of(point));
        ours && name_of(point) != ALONE
    };
    let batches = many.points.iter().filter(is_batch).filter(|point| {
        point.scene == scene.name
            && point.key.variant.ends_with(ALL) == all
            && point.key.scalar == scalar
            && point.key.flags == flags
    });
    batches.min_by(|a, b| a.time[1].total_cmp(&b.time[1]))
}

/// The lower bound of the time of a state by the limit of the processor \[ns\].
pub fn limit(
    many: &Many<'_>,
    scene: &Scene,
    operation_count: &OperationCount,
    all: bool,
    scalar: Scalar,
) -> Option<f64> {
    let point = many.find(scene, LIMIT.0, all, scalar, Flags::Native)?;
    Some(point.time[1] * count(operation_count.mul + operation_count.add) / LIMIT.1)
}

fn least(times: impl Iterator<Item = f64>) -> Option<f64> {
    times.min_by(f64::total_cmp)
}

fn threads() -> f64 {
    std::thread::available_parallelism().map_or(1.0, |threads| count(threads.get()))
}

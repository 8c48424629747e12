//! Any serial arm, from a Denavit–Hartenberg table: direct kinematics and inverse dynamics along a motion, without a
//! compiler.
//!
//! `cargo run --release -p homogen-examples --bin serial_arm [table.dh configurations.motion]`
//!
//! The generator reads the table, and its programs are interpreted instead of printed. A motion has one line a
//! configuration, the time \[s\] before the coordinates \[rad or m\], and is at rest in each of them. SPACELIB has such a
//! program for direct kinematics and inverse dynamics.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, error, fs};

use homogen_codegen::description::read_file;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::expression::Input;
use homogen_codegen::plan::{Programs, plan};
use homogen_codegen::request::Request;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};

/// Number of steps between two configurations.
const MOMENTS: u32 = 12;

/// An arm with the programs of its functions.
struct Arm {
    joints: Vec<String>,
    kinematics: Program,
    dynamics: Program,
}

/// A state of the motion.
#[derive(Clone, Debug)]
struct State {
    /// \[s\]
    time: f64,
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
}

/// A configuration and its time \[s\].
struct Waypoint {
    time: f64,
    q: Vec<f64>,
}

fn main() -> Result<(), Box<dyn error::Error>> {
    let shipped = |name: &str| {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../robots")
            .join(name)
    };
    let mut paths = env::args_os().skip(1).map(PathBuf::from);
    let table = paths.next().unwrap_or_else(|| shipped("rx90_class.dh"));
    let waypoints = paths
        .next()
        .unwrap_or_else(|| table.with_extension("motion"));
    let arm = Arm::read(&table)?;
    let text =
        fs::read_to_string(&waypoints).map_err(|e| format!("{}: {e}", waypoints.display()))?;
    let waypoints = read_waypoints(&text, arm.joints.len())?;
    print!("{}", arm.table(&along(&waypoints)));
    Ok(())
}

impl Arm {
    /// Reads a table.
    fn read(path: &Path) -> Result<Self, Errors> {
        let mut errors = Errors::new();
        let description = read_file(path, None, &mut errors);
        let (Some(description), true) = (description, errors.is_empty()) else {
            return Err(errors);
        };
        let request = Request {
            scalar: Real::F64,
            ..Request::default()
        };
        let chain = understand(&description, &request)?;
        let programs = Programs::of(&chain);
        let of = |function| plan(&programs, vec![function], FrameId::FIRST);
        Ok(Self {
            kinematics: of(Function::ForwardKinematics)?.program,
            dynamics: of(Function::InverseDynamics)?.program,
            joints: chain
                .joints
                .iter()
                .map(|joint| joint.name.clone())
                .collect(),
        })
    }

    /// M₀ of the last frame: the rows of (R, t) in sequence.
    fn pose(&self, state: &State) -> Vec<f64> {
        run(&self.kinematics, |input| state.input(input))
    }

    /// Torques \[N m\] and forces \[N\], from the base outwards.
    fn torques(&self, state: &State) -> Vec<f64> {
        run(&self.dynamics, |input| state.input(input))
    }

    /// One line a moment: time, position of the last frame, torques and forces of the joints.
    fn table(&self, states: &[State]) -> String {
        let mut text = format!(
            "{:>7} {:>8} {:>8} {:>8} ",
            "t [s]", "x [m]", "y [m]", "z [m]"
        );
        let heads = self.joints.iter().map(|name| format!(" {name:>9}"));
        text.extend(heads.chain(["  [N m or N]\n".to_owned()]));
        for state in states {
            let pose = self.pose(state);
            let numbers = [state.time, pose[3], pose[7], pose[11]];
            let place = numbers.map(|x| format!("{x:8.4}")).join(" ");
            // Writing to a string cannot fail.
            let _ = write!(text, "{place}  ");
            for torque in self.torques(state) {
                let _ = write!(text, " {torque:9.3}");
            }
            text.push('\n');
        }
        text
    }
}

impl State {
    fn input(&self, input: Input) -> f64 {
        match input {
            Input::Variable(Variable::Q, k) => self.q[usize::from(k)],
            Input::Variable(Variable::Qd, k) => self.qd[usize::from(k)],
            Input::Variable(Variable::Qdd, k) => self.qdd[usize::from(k)],
            Input::Variable(..) | Input::Parameter(..) => {
                unreachable!("neither function reads it")
            }
        }
    }
}

/// Reads one configuration a line; `#` begins a comment.
fn read_waypoints(text: &str, joints: usize) -> Result<Vec<Waypoint>, String> {
    let mut waypoints: Vec<Waypoint> = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        let line = line.split('#').next().unwrap_or_default();
        let words = line.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = words
            .collect::<Result<_, _>>()
            .map_err(|e| format!("line {number}: {e}"))?;
        match numbers.as_slice() {
            [] => {}
            [time, q @ ..] if q.len() == joints && numbers.iter().all(|x| x.is_finite()) => {
                if waypoints.last().is_some_and(|before| before.time >= *time) {
                    return Err(format!("line {number}: times must increase"));
                }
                let (time, q) = (*time, q.to_vec());
                waypoints.push(Waypoint { time, q });
            }
            _ => {
                return Err(format!(
                    "line {number}: expected the time and {joints} coordinates"
                ));
            }
        }
    }
    Ok(waypoints)
}

/// From rest to rest between configurations: s = 10 τ³ − 15 τ⁴ + 6 τ⁵.
fn along(waypoints: &[Waypoint]) -> Vec<State> {
    let mut states = Vec::new();
    for pair in waypoints.windows(2) {
        let span = pair[1].time - pair[0].time;
        for k in 0..=MOMENTS {
            let t = f64::from(k) / f64::from(MOMENTS);
            let way = t.powi(3) * (10.0 - 15.0 * t + 6.0 * t * t);
            let rate = 30.0 * (t * (1.0 - t)).powi(2) / span;
            let second = 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t) / span.powi(2);
            let joints = || pair[0].q.iter().zip(&pair[1].q);
            states.push(State {
                time: pair[0].time + t * span,
                q: joints()
                    .map(|(from, to)| from + way * (to - from))
                    .collect(),
                qd: joints().map(|(from, to)| rate * (to - from)).collect(),
                qdd: joints().map(|(from, to)| second * (to - from)).collect(),
            });
        }
    }
    states
}

#[cfg(test)]
mod tests {
    use super::{Arm, MOMENTS, State, along, read_waypoints};
    use std::path::Path;

    /// Compares with Pinocchio's results for the same two files (`tests/reference/serial_arm.py`).
    fn agrees(name: &str, reference: &str) {
        let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
        let table = robots.join(name).with_extension("dh");
        let arm = Arm::read(&table).expect("a table that ships");
        let text = std::fs::read_to_string(table.with_extension("motion")).expect("it ships");
        let n = arm.joints.len();
        let states = along(&read_waypoints(&text, n).expect("waypoints"));
        let lines = reference.lines().filter(|line| !line.starts_with('#'));
        let lines: Vec<Vec<f64>> = lines
            .map(|line| {
                line.split(' ')
                    .map(|x| x.parse().expect("a number"))
                    .collect()
            })
            .collect();
        assert_eq!(lines.len(), states.len());
        assert!(lines.len() > usize::try_from(MOMENTS).expect("small"));
        let mut largest: f64 = 0.0;
        for (state, line) in states.iter().zip(&lines) {
            let (given, found) = line.split_at(1 + 3 * n);
            let State { time, q, qd, qdd } = state;
            let moving = [&[*time], &q[..], &qd[..], &qdd[..]].concat();
            close(&moving, given, 1e-13, name);
            // Rotation and translation are separate there, and row by row together here.
            let pose = arm.pose(state);
            let (r, p) = (0..12).partition::<Vec<usize>, _>(|k| k % 4 < 3);
            let pose: Vec<f64> = r.into_iter().chain(p).map(|k| pose[k]).collect();
            close(&pose, &found[..12], 1e-14, name);
            close(&arm.torques(state), &found[12..], 2e-13, name);
            largest = found[12..]
                .iter()
                .fold(largest, |most, x| most.max(x.abs()));
        }
        assert!(largest > 10.0, "{name} hardly moves: {largest}");
    }

    fn close(found: &[f64], known: &[f64], tolerance: f64, name: &str) {
        assert_eq!(found.len(), known.len());
        for (a, b) in found.iter().zip(known) {
            let size = b.abs().max(1.0);
            assert!((a - b).abs() <= tolerance * size, "{name}: {a} is not {b}");
        }
    }

    #[test]
    fn arms_from_tables_agree_with_pinocchio() {
        agrees(
            "rx90_class",
            include_str!("../../../tests/reference/rx90_class.txt"),
        );
        agrees(
            "stanford_class",
            include_str!("../../../tests/reference/stanford_class.txt"),
        );
    }

    #[test]
    fn wrong_lines_of_a_motion_are_errors_with_their_number() {
        let refusal = |text| read_waypoints(text, 2).err().expect("none");
        assert_eq!(
            refusal("0 1 2\n1 2"),
            "line 2: expected the time and 2 coordinates"
        );
        assert_eq!(
            refusal("0 1 2\n# rest\n0 1 2"),
            "line 3: times must increase"
        );
        assert_eq!(refusal("0 1 x"), "line 1: invalid float literal");
        assert_eq!(
            refusal("0 inf 0"),
            "line 1: expected the time and 2 coordinates"
        );
    }

    #[test]
    fn a_line_is_printed_for_each_moment() {
        let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
        let arm = Arm::read(&robots.join("rx90_class.dh")).expect("a table that ships");
        let states = along(&read_waypoints("0 0 0 0 0 0 0\n1 0 1 0 0 0 0", 6).expect("waypoints"));
        let table = arm.table(&states);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), states.len() + 1);
        // The upper arm points forward, forearm and flange upwards.
        let start = "  0.0000   0.4500   0.0000   0.5350 ";
        assert!(lines[1].starts_with(start), "{}", lines[1]);
    }
}

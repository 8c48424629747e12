//! The written file is the same robot.
//!
//! In: the robots that ship, and texts with what few files have. Each is written as URDF and as MJCF, and read again.
//! Operation counts must be the same, and M, bias and inverse dynamics at random states to rounding errors.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use homogen_random::Random;
use serde_json::{Value, json};

use crate::{Answer, answer};

/// Largest relative error.
const LIMIT: f64 = 1e-13;

const STATES: usize = 4;

/// Angles in degrees, several joints of a body away from its origin, a ball, a free body, limits, sites, constraints.
const CREATURE: &str = r#"<mujoco model="creature">
  <compiler eulerseq="zyx"/>
  <option gravity="0 0.5 -9.7"/>
  <worldbody>
    <body name="trunk" pos="0 0 1">
      <freejoint name="root"/>
      <geom type="box" size="0.2 0.1 0.05" pos="0.01 0 0" euler="10 20 30"/>
      <body name="head" pos="0.25 0 0.1" quat="0.9 0.1 -0.2 0.3">
        <joint name="neck" type="ball" pos="-0.05 0 0.01" range="0 40"/>
        <inertial pos="0.01 0.02 0.03" mass="0.7" fullinertia="0.02 0.03 0.04 0.001 -0.002 0.003"/>
        <body name="jaw" pos="0 0 -0.1" euler="0 90 0">
          <joint name="jaw" axis="0 1 0" range="-10 30" armature="0.01" damping="0.2" frictionloss="0.1" ref="5"/>
          <geom type="capsule" fromto="0 0 0 0.1 0 0" size="0.02"/>
        </body>
      </body>
      <body name="leg" pos="0.1 0.1 -0.05">
        <joint name="abduction" axis="1 0 0" pos="0 0.01 0.02" range="-45 45" actuatorfrcrange="-30 30"/>
        <joint name="flexion" axis="0 1 0" pos="0.03 0 0"/>
        <joint name="stretch" type="slide" axis="0 0 -1" range="-0.1 0.1"/>
        <geom type="capsule" fromto="0 0 0 0 0 -0.3" size="0.03"/>
        <body name="foot" pos="0 0 -0.3">
          <inertial pos="0 0 -0.02" euler="0 0 20" mass="0.3" diaginertia="1e-3 2e-3 1.5e-3"/>
          <joint name="ankle" axis="0.1 1 0.3"/>
          <site name="sole" pos="0 0 -0.05" zaxis="0 1 1"/>
        </body>
      </body>
    </body>
  </worldbody>
  <equality>
    <joint joint1="ankle" joint2="flexion" polycoef="0.1 -0.5 0 0 0"/>
  </equality>
</mujoco>
"#;

/// Joints and placements that URDF 1.0 does not have, motors, friction for each velocity.
const EXTENSIONS: &str = r#"<robot name="extensions" version="1.1">
  <link name="world"/>
  <link name="a"><inertial><origin xyz="0.1 0 0.02" rpy="0.3 0.2 -0.1"/><mass value="1.5"/>
    <inertia ixx="0.02" ixy="0.001" ixz="-0.002" iyy="0.03" iyz="0.003" izz="0.04"/></inertial></link>
  <link name="b"><inertial><origin xyz="0 0.1 0"/><mass value="0.8"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.015"/></inertial></link>
  <link name="c"><inertial><mass value="0.5"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.015"/></inertial></link>
  <link name="d"><inertial><origin xyz="0 0 0.1"/><mass value="0.4"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.005"/></inertial></link>
  <link name="tool"/>
  <joint name="lift" type="cylindrical"><parent link="world"/><child link="a"/>
    <origin xyz="0 0 0.5" quat_xyzw="0.7071 0 0 0.7071"/><axis xyz="0 0.6 0.8"/><dynamics damping="0.1 0.2"/></joint>
  <joint name="cardan" type="universal"><parent link="a"/><child link="b"/>
    <origin xyz="0.2 0 0" rpy="0 1.5708 0.3"/><axis xyz="1 0 0"/><axis2 xyz="0 1 0"/></joint>
  <joint name="elbow" type="revolute"><parent link="b"/><child link="c"/>
    <origin xyz="0 0.3 0" rpy="1.57 0 0"/><axis xyz="0.577 0.577 0.577"/>
    <limit lower="-1" upper="1.5" velocity="2" effort="30"/><dynamics damping="0.5" friction="0.3"/></joint>
  <joint name="table" type="translation"><parent link="c"/><child link="d"/><origin rpy="0.1 0.2 0.3"/></joint>
  <joint name="flange" type="fixed"><parent link="d"/><child link="tool"/><origin xyz="0 0 0.1" rpy="0 0 3.14159"/></joint>
  <transmission name="t"><joint name="elbow"/><actuator name="m"><mechanicalReduction>50</mechanicalReduction></actuator>
    <drake:rotor_inertia value="2e-5"/></transmission>
</robot>
"#;

/// A screw, which other programs know as a rotation and a translation that mimics it.
const SCREW: &str = r#"<robot name="screw"><link name="base"/>
  <link name="nut"><inertial><origin xyz="0.1 0 0"/><mass value="1.5"/>
    <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.04"/></inertial></link>
  <joint name="spindle" type="screw"><parent link="base"/><child link="nut"/><origin rpy="0.2 0 0"/>
    <axis xyz="0 0 1"/><thread pitch="0.003"/><dynamics damping="0.1"/></joint></robot>
"#;

/// Two loops of types that both formats have.
const LOOPS: &str = r#"<mujoco model="loops"><worldbody>
  <body name="crank"><joint name="crank" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.1 0 0" size="0.01"/>
    <body name="rod" pos="0.1 0 0"><joint name="rod" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.01"/></body></body>
  <body name="slider" pos="0.4 0 0"><joint name="slider" type="slide" axis="1 0 0"/><geom size="0.02"/></body>
</worldbody><equality><connect name="pin" body1="rod" body2="slider" anchor="0.3 0 0"/></equality></mujoco>
"#;

fn homogen(words: &[&str]) -> Answer {
    let words = ["homogen"].iter().chain(words).map(OsString::from);
    answer(words, &mut std::io::empty())
}

fn output(words: &[&str]) -> String {
    let answer = homogen(words);
    assert_eq!(answer.code, 0, "{words:?}: {}", answer.remarks);
    answer.output
}

fn json_of(words: &[&str]) -> Value {
    let words: Vec<&str> = words.iter().copied().chain(["--format", "json"]).collect();
    serde_json::from_str(&output(&words)).expect("JSON")
}

/// A folder of its own for the files of a test.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("homogen-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// The number of coordinates of a type, of which the last four are a quaternion if there are more than three.
fn coordinates(kind: &str) -> usize {
    match kind {
        "cylindrical" | "universal" => 2,
        "planar" | "translation" => 3,
        "spherical" => 4,
        "floating" => 7,
        _ => 1,
    }
}

/// Random states of a file, as a file.
fn states(path: &str, into: &Path) -> String {
    let robot = json_of(&["check", path]);
    let mimicked = robot["mimicked"].as_array().expect("a list");
    let mimics = |name: &Value| mimicked.iter().any(|mimic| mimic["joint"] == *name);
    let joints = robot["details"]["joints"].as_array().expect("a list");
    let joints = joints.iter().filter(|joint| !mimics(&joint["name"]));
    let counts: Vec<usize> = joints
        .map(|joint| coordinates(joint["kind"].as_str().expect("a word")))
        .collect();
    let velocities = robot["velocities"].as_array().expect("a list").len();
    let mut random = Random::new(7);
    let mut state = || {
        let mut q = Vec::new();
        for count in &counts {
            let mut own: Vec<f64> = (0..*count).map(|_| 2.0 * random.unit()).collect();
            if let Some(quaternion) = own.len().checked_sub(4).map(|at| &mut own[at..]) {
                let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
                for x in quaternion {
                    *x /= length;
                }
            }
            q.append(&mut own);
        }
        let mut rates = || {
            (0..velocities)
                .map(|_| 2.0 * random.unit())
                .collect::<Vec<f64>>()
        };
        json!({ "q": q, "qd": rates(), "qdd": rates() })
    };
    let states: Vec<Value> = (0..STATES).map(|_| state()).collect();
    let path = into.join("states.json");
    fs::write(&path, json!({ "states": states }).to_string()).expect("written");
    path.display().to_string()
}

fn numbers(value: &Value, into: &mut Vec<f64>) {
    match value {
        Value::Array(entries) => {
            for entry in entries {
                numbers(entry, into);
            }
        }
        number => into.push(number.as_f64().expect("a number")),
    }
}

/// Compares a file with what is written for it in a format.
fn is_the_same(path: &str, format: &str, into: &Path, words: &[&str], counts: bool) {
    let written = into.join(format!("written.{format}"));
    let written = written.display().to_string();
    output(&["convert", path, "--to", format, "-o", &written]);
    let states = states(path, into);
    let both = |command: &[&str]| {
        [path, &written].map(|file| {
            let words: Vec<&str> = [command[0], file]
                .iter()
                .chain(&command[1..])
                .chain(words)
                .copied()
                .collect();
            json_of(&words)
        })
    };
    if counts {
        let functions = "mass_matrix,bias,inverse_dynamics,gravity";
        let [ours, theirs] = both(&["count", "--functions", functions]);
        for (function, count) in ours["functions"].as_object().expect("an object") {
            for operation in ["mul", "add", "sin", "cos", "div"] {
                let other = &theirs["functions"][function][operation];
                assert_eq!(
                    *other, count[operation],
                    "{operation} of {function} of {path} as {format}"
                );
            }
        }
    }
    for function in ["mass_matrix", "bias", "inverse_dynamics"] {
        let [ours, theirs] =
            both(&["eval", "--function", function, "--states", &states]).map(|answer| {
                let mut found = Vec::new();
                numbers(&answer["results"], &mut found);
                found
            });
        assert_eq!(ours.len(), theirs.len(), "{function} of {path} as {format}");
        let size = ours.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(size > 0.0);
        for (a, b) in ours.iter().zip(&theirs) {
            assert!(
                (a - b).abs() <= LIMIT * size,
                "{function} of {path} as {format}: {a}, {b}"
            );
        }
    }
}

/// A text as a file.
fn file(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).expect("written");
    path.display().to_string()
}

#[test]
fn robots_that_ship_are_the_same_in_both_formats() {
    let folder = folder("convert-shipped");
    let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots");
    let mut files: Vec<PathBuf> = fs::read_dir(robots)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| {
            let ending = path.extension().and_then(|ending| ending.to_str());
            ending.is_some_and(|ending| ["urdf", "xml", "sdf", "dh", "xacro"].contains(&ending))
        })
        .collect();
    files.sort();
    assert!(files.len() > 10, "{files:?}");
    for path in files {
        let path = path.display().to_string();
        for format in ["urdf", "mjcf"] {
            is_the_same(&path, format, &folder, &[], true);
        }
    }
}

/// Forward dynamics is chosen for the velocities within the limits, which MJCF does not have.
#[test]
fn forward_dynamics_is_the_same_without_limits_of_velocities() {
    let folder = folder("convert-limits");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots/panda_class.urdf");
    let text = fs::read_to_string(path).expect("a robot");
    let mut parts = text.split(" velocity=\"");
    let first = parts.next().unwrap_or_default();
    let others = parts.map(|part| part.split_once('"').expect("a quote").1);
    let unlimited: String = std::iter::once(first).chain(others).collect();
    assert_ne!(unlimited, text);
    let path = file(&folder, "unlimited.urdf", &unlimited);
    let written = folder.join("unlimited.xml").display().to_string();
    output(&["convert", &path, "-o", &written]);
    let [ours, theirs] = [&*path, &written].map(|file| {
        let counted = json_of(&["count", file, "--functions", "forward_dynamics"]);
        let count = &counted["functions"]["forward_dynamics"];
        ["mul", "add", "sin", "cos", "div"].map(|operation| count[operation].clone())
    });
    assert!(ours[0].is_u64(), "{ours:?}");
    assert_eq!(ours, theirs);
}

#[test]
fn several_joints_balls_and_free_bodies_of_mjcf_are_the_same() {
    let folder = folder("convert-creature");
    let path = file(&folder, "creature.xml", CREATURE);
    for format in ["urdf", "mjcf"] {
        is_the_same(&path, format, &folder, &["--gravity=0,0.5,-9.7"], true);
        let words = ["--gravity=0,0.5,-9.7", "--rotors", "--friction"];
        is_the_same(&path, format, &folder, &words, false);
    }
    let answer = homogen(&["convert", &path]);
    for what in ["URDF has no ball joints", "URDF has no gravity"] {
        assert!(answer.remarks.contains(what), "{}", answer.remarks);
    }
}

#[test]
fn joints_that_urdf_does_not_have_are_several_joints() {
    let folder = folder("convert-extensions");
    let path = file(&folder, "extensions.urdf", EXTENSIONS);
    for format in ["urdf", "mjcf"] {
        is_the_same(&path, format, &folder, &[], true);
        is_the_same(&path, format, &folder, &["--rotors", "--friction"], false);
    }
    let urdf = output(&["convert", &path]);
    for kind in ["cylindrical", "universal", "translation"] {
        assert!(!urdf.contains(kind), "{urdf}");
    }
    let path = file(&folder, "screw.urdf", SCREW);
    for format in ["urdf", "mjcf"] {
        is_the_same(&path, format, &folder, &["--friction"], false);
    }
}

#[test]
fn loops_are_written() {
    let folder = folder("convert-loops");
    let path = file(&folder, "loops.xml", LOOPS);
    for format in ["urdf", "mjcf"] {
        let written = folder.join(format!("loops.{format}"));
        let written = written.display().to_string();
        output(&["convert", &path, "--to", format, "-o", &written]);
        let [ours, theirs] = [&*path, &written].map(|file| json_of(&["check", file]));
        assert_eq!(ours["constraints"], theirs["constraints"]);
        let states = states(&path, &folder);
        let [ours, theirs] = [&*path, &written].map(|file| {
            let words = [
                "eval",
                file,
                "--function",
                "constraint",
                "--states",
                &states,
            ];
            json_of(&words)["results"].clone()
        });
        let [mut a, mut b] = [Vec::new(), Vec::new()];
        numbers(&ours, &mut a);
        numbers(&theirs, &mut b);
        assert!(a.len() == b.len() && !a.is_empty());
        for (a, b) in a.iter().zip(&b) {
            assert!((a - b).abs() < LIMIT, "{a}, {b}");
        }
    }
}

/// An error names the place of the joint.
#[test]
fn motions_that_mjcf_does_not_have_are_errors() {
    let folder = folder("convert-refused");
    let inertial = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>";
    for (kind, origin, message) in [
        ("planar", "", "robot.urdf:2:1: joint \"j\" is planar"),
        (
            "floating",
            "<origin xyz=\"1 0 0\"/>",
            "robot.urdf:2:1: joint \"j\" is floating",
        ),
    ] {
        let text = format!(
            "<robot name=\"r\"><link name=\"a\"/><link name=\"b\">{inertial}</link>\n<joint name=\"j\" type=\"{kind}\">\
             {origin}<parent link=\"a\"/><child link=\"b\"/><axis xyz=\"0 0 1\"/></joint></robot>"
        );
        let path = file(&folder, "robot.urdf", &text);
        let answer = homogen(&["convert", &path, "--to", "mjcf"]);
        assert_eq!((&*answer.output, answer.code), ("", 1));
        assert!(answer.remarks.contains(message), "{}", answer.remarks);
        output(&["convert", &path, "--to", "urdf"]);
    }
}

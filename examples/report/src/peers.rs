//! Other implementations, where they are installed.
//!
//! In: the folder that a set-up of peers left, and the folder of the URDF files it was made from. Out:
//! a scene for each robot that both have, in the peers' own states, and what stands beside ours
//! there: C functions that CasADi wrote (from Pinocchio's algorithms), and Pinocchio itself in C++.
//! It never builds them.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use homogen_codegen::Function;

use crate::scene::{FUNCTIONS, STATES, Scene, Variant};

/// What a set-up of peers left.
pub struct Peers {
    /// With `build` and `data`.
    pub folder: PathBuf,
    /// With `NAME.urdf`.
    pub robots: PathBuf,
}

/// Their robots and what readers call them.
const ROBOTS: [(&str, &str); 2] = [("ur5", "UR5"), ("panda", "Panda with hand")];

/// As CasADi writes them; with right angles made exact and common parts merged; and then with
/// pointers that do not alias in place of a check of each.
const GENERATED: [&str; 3] = ["casadi", "casadi-snap", "casadi-snap-ptr"];

impl Peers {
    /// The scenes of the robots that are there.
    ///
    /// # Errors
    /// Where a file cannot be read or has mistakes.
    pub fn scenes(&self, variants: &[Variant]) -> Result<Vec<Scene>, Box<dyn Error>> {
        let mut scenes = Vec::new();
        for (name, title) in ROBOTS {
            let data = self.folder.join("data").join(name);
            if !data.join("states.bin").exists() {
                continue;
            }
            let urdf = self.robots.join(name).with_extension("urdf");
            let model = fs::read_to_string(data.join("model.txt"))?;
            let frame = model.lines().last().and_then(|line| line.split(' ').next());
            let frame = frame.ok_or("the last line of model.txt names no frame")?;
            let mut scene = Scene::read(&format!("peer_{name}"), title, &urdf, frame)
                .map_err(crate::truth::told)?;
            let bytes = fs::read(data.join("states.bin"))?;
            let (numbers, _) = bytes.as_chunks();
            scene.states = numbers.iter().map(|x| f64::from_le_bytes(*x)).collect();
            if scene.states.len() != STATES * 4 * scene.joints {
                return Err(format!("{name}: states.bin is of another robot").into());
            }
            scene.functions = FUNCTIONS.to_vec();
            scene.variants = variants.to_vec();
            scene.generic = true;
            scenes.push(scene);
        }
        Ok(scenes)
    }

    /// The libraries that compute a function, as `measured` takes them.
    pub fn libraries(&self, scene: &Scene, function: Function) -> Vec<String> {
        let Some(robot) = scene.name.strip_prefix("peer_") else {
            return Vec::new();
        };
        let mut libraries = Vec::new();
        for maker in GENERATED {
            for symbol in symbols(function) {
                let folder = self.folder.join("build/cg").join(format!("{maker}_double"));
                let file = format!("{robot}_{symbol}.native.so");
                let path = folder.join(robot).join(file);
                if path.exists() {
                    libraries.push(format!("{maker}/{symbol}={symbol}@{}", path.display()));
                }
            }
        }
        libraries
    }

    /// The times per call that Pinocchio's own program tells \[ns\]: name and median.
    ///
    /// # Errors
    /// Where it does not run.
    pub fn pinocchio(
        &self,
        scene: &Scene,
        function: Function,
    ) -> Result<Vec<(String, f64)>, Box<dyn Error>> {
        let program = self.folder.join("build/bench_pin_native_double");
        let Some(robot) = scene.name.strip_prefix("peer_") else {
            return Ok(Vec::new());
        };
        let [first, ..] = symbols(function) else {
            return Ok(Vec::new());
        };
        if !program.exists() {
            return Ok(Vec::new());
        }
        let output = Command::new(program)
            .arg(self.folder.join("data").join(robot))
            .args([robot, "native", "0.02", first])
            .output()?;
        let text = String::from_utf8(output.stdout)?;
        let mut times = Vec::new();
        for line in text.lines() {
            let columns: Vec<&str> = line.split(',').collect();
            if let [_, name, _, _, _, median, ..] = columns[..]
                && symbols(function).contains(&name)
            {
                times.push((format!("pinocchio/{name}"), median.parse()?));
            }
        }
        Ok(times)
    }
}

/// What they call a function, each way they have.
const fn symbols(function: Function) -> &'static [&'static str] {
    match function {
        Function::ForwardKinematics => &["fk_frame"],
        Function::GeometricJacobian => &["jac_frame_lwa"],
        Function::Gravity => &["gravity"],
        Function::InverseDynamics => &["rnea"],
        Function::Bias => &["nle"],
        Function::MassMatrix => &["crba", "crba_local"],
        Function::ForwardDynamics => &["aba", "aba_local"],
        Function::MassMatrixInverse => &["minverse"],
        _ => &[],
    }
}

/// Where PEER_ENV and the options say they are.
///
/// # Errors
/// Where only one of the folders is known.
pub fn find(
    folder: Option<PathBuf>,
    robots: Option<PathBuf>,
) -> Result<Option<Peers>, Box<dyn Error>> {
    let folder = folder.or_else(|| std::env::var_os("PEER_ENV").map(PathBuf::from));
    match (folder, robots) {
        (None, None) => Ok(None),
        (Some(folder), Some(robots)) => {
            for path in [&folder.join("data"), &robots] {
                present(path)?;
            }
            Ok(Some(Peers { folder, robots }))
        }
        (Some(_), None) => Err("peers need --peer-robots: the folder of their URDF files".into()),
        (None, Some(_)) => {
            Err("peers need --peers, or PEER_ENV: the folder of their set-up".into())
        }
    }
}

fn present(path: &Path) -> Result<(), Box<dyn Error>> {
    if path.is_dir() {
        Ok(())
    } else {
        Err(format!("there is no folder {}", path.display()).into())
    }
}

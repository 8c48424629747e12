//! Other implementations, where they are installed.
//!
//! In: the folder that `report/peer/setup.sh` made. Out: a scene for each robot in it that does
//! not ship, and for any scene the libraries that stand beside ours: Pinocchio itself, and C that
//! CasADi wrote from its algorithms. It never builds them.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use homogen_codegen::Function;
use homogen_examples::machine;

use crate::scene::{self, Scalar, Scene};
use crate::truth::told;

/// Who makes libraries: Pinocchio, and CasADi as it writes them; with right angles made exact and
/// common parts merged; and then with pointers that do not alias in place of a check of each.
pub const MAKERS: [&str; 4] = ["pinocchio", "plain", "snapped", "restrict"];

/// The same and MuJoCo, whose inverse dynamics stands beside ours for many states.
pub const MAKERS_OF_MANY: [&str; 5] = ["pinocchio", "plain", "snapped", "restrict", "mujoco"];

/// What a set-up of peers left.
pub struct Peers {
    folder: PathBuf,
    /// With what it was made.
    pub versions: String,
    /// With what else for many states, a line each.
    pub versions_of_many: String,
}

impl Peers {
    /// What lies in a folder.
    ///
    /// # Errors
    /// Where it is no such folder, or was compiled for another processor.
    pub fn find(folder: PathBuf) -> Result<Self, Box<dyn Error>> {
        let read = |name: &str| {
            let path = folder.join(name);
            let text = fs::read_to_string(&path);
            text.map_err(|reason| {
                let path = path.display();
                format!("{path}: {reason}; report/peer/setup.sh makes a folder with it")
            })
        };
        let versions = read("versions.txt")?.trim().to_owned();
        let versions_of_many = read("versions.many.txt")?.trim().to_owned();
        let processor = read("processor")?;
        if machine::processor_name() != processor.trim() {
            return Err(format!(
                "{} was compiled for another processor, {}; run report/peer/setup.sh here",
                folder.display(),
                processor.trim()
            )
            .into());
        }
        Ok(Self {
            folder,
            versions,
            versions_of_many,
        })
    }

    /// The robots that do not ship, in the order of their names; `root` is the repository.
    ///
    /// # Errors
    /// Where a file cannot be read or has mistakes; where a robot that ships changed since its peers
    /// were made.
    pub fn scenes(&self, root: &Path) -> Result<Vec<Scene>, Box<dyn Error>> {
        let entries = fs::read_dir(&self.folder)?.collect::<io::Result<Vec<_>>>()?;
        let mut names: Vec<_> = entries.iter().map(fs::DirEntry::file_name).collect();
        names.sort();
        let mut scenes = Vec::new();
        for name in names.iter().filter_map(|name| name.to_str()) {
            let folder = self.folder.join(name);
            let description = folder.join("robot.urdf");
            if !description.exists() {
                continue;
            }
            let shipped = root.join("robots").join(name).with_extension("urdf");
            if !shipped.exists() {
                scenes.push(scene_of(name, &folder)?);
            } else if fs::read(shipped)? != fs::read(description)? {
                return Err(format!("{name}.urdf changed; run report/peer/setup.sh again").into());
            }
        }
        Ok(scenes)
    }

    /// What computes a function beside ours, as `measured` takes it: maker, type of number, symbol and
    /// library of each.
    pub fn libraries(&self, scene: &Scene, function: Function, makers: &[&str]) -> Vec<String> {
        let mut libraries = Vec::new();
        for &maker in makers {
            for scalar in [Scalar::F64, Scalar::F32] {
                let file = format!("{maker}.{}.so", scalar.name());
                let library = self.folder.join(&scene.name).join(file);
                if !library.exists() {
                    continue;
                }
                for symbol in symbols(function) {
                    let words = [maker, scalar.name(), &symbol].map(str::to_owned);
                    libraries.extend(words);
                    libraries.push(library.display().to_string());
                }
            }
        }
        libraries
    }

    /// frax on so many states of a robot at once, for so many batches: a program that says what `measured` does of
    /// the inverse dynamics. `truth` is the folder of the robot's.
    pub fn frax(
        &self,
        scene: &Scene,
        truth: &Path,
        batches: usize,
        states: usize,
        scalar: Scalar,
    ) -> Command {
        let mut command = Command::new(self.folder.join("tools/frax/bin/python"));
        command
            .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("../peer/in_jax.py"))
            .arg(self.folder.join(&scene.name))
            .arg(truth)
            .args([batches, states].map(|number| number.to_string()))
            .arg(scalar.name());
        command
    }
}

/// The robot in a folder, whose peers count its joints in the same order.
fn scene_of(name: &str, folder: &Path) -> Result<Scene, Box<dyn Error>> {
    let read = |file: &str| fs::read_to_string(folder.join(file));
    let (title, tip, base) = (read("title")?, read("frame")?, read("base")?);
    let scene = scene::beside_peers(
        [name, title.trim(), tip.trim()],
        &folder.join("robot.urdf"),
        base.trim() == "floating",
    );
    let mut scene = scene.map_err(told)?;
    if let Ok(functions) = read("functions") {
        let compared: Vec<&str> = functions.split_whitespace().collect();
        scene
            .functions
            .retain(|function| compared.contains(&function.name()));
    }
    let joints = read("model.joints")?;
    if !joints.lines().eq(&scene.joints) {
        let (theirs, ours) = (joints.replace('\n', " "), scene.joints.join(" "));
        return Err(format!("peers count the joints of {name} as {theirs}, not as {ours}").into());
    }
    Ok(scene)
}

/// What they call a function, each way they have: in link frames, and in the frame of the base.
fn symbols(function: Function) -> Vec<String> {
    let symbol = format!("peer_{}", function.name());
    match function {
        Function::MassMatrix | Function::ForwardDynamics => {
            vec![format!("{symbol}_world"), symbol]
        }
        _ => vec![symbol],
    }
}

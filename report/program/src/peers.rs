//! Other programs, if they are installed.
//!
//! In: the folder of `report/peer/setup.sh`. Out: a scene for each robot that is only there, and the libraries for any
//! scene: Pinocchio, and C that CasADi generates from its algorithms. Nothing is built here.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};

use homogen_codegen::Function;
use homogen_examples::machine;

use crate::scene::{self, Scalar, Scene};
use crate::truth::as_one;

/// The makers of libraries: Pinocchio; CasADi's original C; the same with exact right angles and merged common
/// subexpressions; and that with `restrict` in place of a check of each pointer.
pub const MAKERS: [&str; 4] = ["pinocchio", "plain", "snapped", "restrict"];

/// The same and MuJoCo, whose inverse dynamics is compared for many states.
pub const MAKERS_OF_MANY: [&str; 5] = ["pinocchio", "plain", "snapped", "restrict", "mujoco"];

/// The title of a maker on the first page.
pub fn title(maker: &str) -> &str {
    match maker {
        "pinocchio" => "Pinocchio",
        "plain" => "CasADi C",
        "snapped" | "restrict" => "CasADi C, tuned",
        "mujoco" => "MuJoCo",
        other => other,
    }
}

/// A folder with other programs.
pub struct Peers {
    folder: PathBuf,
    /// The versions of the programs.
    pub versions: String,
    /// The versions of those for many states, a line each.
    pub versions_of_many: String,
}

impl Peers {
    /// The contents of a folder.
    ///
    /// # Errors
    /// A folder that `setup.sh` did not make, or that was compiled for another processor.
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

    /// The robots that are not in the repository, in the order of their names; `root` is the repository.
    ///
    /// # Errors
    /// A file that cannot be read or has errors; a robot of the repository that changed since the folder was made.
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

    /// The other implementations of a function, as arguments of `measured`: maker, type of number, symbol and library
    /// of each.
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

    /// frax on many states of a robot at once: a program with the output of `measured` for the inverse dynamics.
    /// `truth` is the folder of the robot's exact results.
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

/// The robot in a folder; an error unless the other programs have its joints in the same order.
fn scene_of(name: &str, folder: &Path) -> Result<Scene, Box<dyn Error>> {
    let read = |file: &str| fs::read_to_string(folder.join(file));
    let (title, tip, base) = (read("title")?, read("frame")?, read("base")?);
    let scene = scene::beside_peers(
        [name, title.trim(), tip.trim()],
        &folder.join("robot.urdf"),
        base.trim() == "floating",
    );
    let mut scene = scene.map_err(as_one)?;
    if let Ok(functions) = read("functions") {
        let compared: Vec<&str> = functions.split_whitespace().collect();
        scene
            .functions
            .retain(|function| compared.contains(&function.name()));
    }
    let joints = read("model.joints")?;
    if !joints.lines().eq(&scene.joints) {
        let (theirs, ours) = (joints.replace('\n', " "), scene.joints.join(" "));
        return Err(
            format!("{name}: other programs have the joints {theirs}, homogen has {ours}").into(),
        );
    }
    Ok(scene)
}

/// The symbols of a function in their libraries: in link frames, and in the frame of the base.
fn symbols(function: Function) -> Vec<String> {
    let symbol = format!("peer_{}", function.name());
    match function {
        Function::MassMatrix | Function::ForwardDynamics => {
            vec![format!("{symbol}_world"), symbol]
        }
        _ => vec![symbol],
    }
}

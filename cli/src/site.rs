//! `homogen site`: the engine as a page of static files, for any server.
//!
//! A folder with the page, its script and style sheet, a worker, the engine as a WebAssembly module, and sample robots.
//! The view of a robot is that of `homogen show`. The page requests nothing but these files.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use clap::Args;

use super::options::mistake;
use super::show::{ROBOT, STYLE, view};
use super::{Answer, Outcome, clone};
use homogen_codegen::error::Errors;
use homogen_codegen::template::filled;

/// The page, with a mark for the view of a robot.
const PAGE: &str = include_str!("site/page.html");

/// The style sheet, after that of the view.
const OWN_STYLE: &str = include_str!("site/site.css");

/// The script: the view, then what takes descriptions and shows results.
const SCRIPT: &str = view!(
    include_str!("site/engine.js"),
    include_str!("site/messages.js"),
    include_str!("site/joined.js"),
    include_str!("site/options.js"),
    include_str!("site/values.js"),
    include_str!("site/jacobian.js"),
    include_str!("site/trajectory.js"),
    include_str!("site/plot.js"),
    include_str!("site/mesh.js"),
    include_str!("site/shapes.js"),
    include_str!("site/zip.js"),
    include_str!("site/measured.js"),
    include_str!("site/files.js"),
    include_str!("site/address.js"),
    include_str!("site/start.js")
);

/// The script of the worker.
const WORKER: &str = include_str!("site/worker.js");

/// Sample robots, by their paths in a clone.
const SAMPLES: [&str; 6] = [
    "robots/two_link.urdf",
    "robots/panda_class.urdf",
    "robots/ur5_class.urdf",
    "robots/quadruped.urdf",
    "tests/robots/humanoid.urdf",
    "robots/stanford_class.dh",
];

/// Write a page that reads descriptions in a browser and shows robots, values and code: a folder for any web server
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen site -o site-of-homogen && python3 -m http.server -d site-of-homogen

It compiles the engine to WebAssembly, in a clone of the repository. The page computes in the browser and sends nothing.")]
pub(super) struct Site {
    /// The folder to write; its files of the same names are replaced
    #[arg(long, short, value_name = "FOLDER")]
    output: PathBuf,
}

impl Site {
    pub(super) fn run(&self) -> Outcome {
        let here = env::current_dir().map_err(|reason| mistake(reason.to_string()))?;
        let clone = clone::find(&here, "the site compiles its module")?;
        let module = compiled(clone)?;
        self.write("index.html", filled(PAGE, &[("@ROBOT@", ROBOT)]))?;
        self.write("site.css", format!("{STYLE}{OWN_STYLE}"))?;
        self.write("site.js", SCRIPT)?;
        self.write("worker.js", WORKER)?;
        self.write("homogen.wasm", read(&module)?)?;
        for sample in SAMPLES {
            let path = clone.join(sample);
            let name = path.file_name().map_or(&*path, Path::new);
            self.write(Path::new("robots").join(name), read(&path)?)?;
        }
        Ok(Answer::default())
    }

    fn write(&self, name: impl AsRef<Path>, bytes: impl AsRef<[u8]>) -> Result<(), Errors> {
        let path = self.output.join(name);
        let written = || {
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(&path, bytes)
        };
        written().map_err(|reason| mistake(format!("cannot write {}: {reason}", path.display())))
    }
}

/// The path of the WebAssembly module, which the script of the crate `site` compiles.
fn compiled(clone: &Path) -> Result<PathBuf, Errors> {
    let script = clone.join("site/build.sh");
    let built = Command::new("bash")
        .arg(&script)
        .stderr(Stdio::inherit())
        .output();
    let built =
        built.map_err(|reason| mistake(format!("cannot run {}: {reason}", script.display())))?;
    let path = String::from_utf8_lossy(&built.stdout).trim().to_owned();
    if built.status.success() && !path.is_empty() {
        Ok(path.into())
    } else {
        Err(mistake("the WebAssembly module did not compile"))
    }
}

fn read(path: &Path) -> Result<Vec<u8>, Errors> {
    fs::read(path).map_err(|reason| mistake(format!("cannot read {}: {reason}", path.display())))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn samples_of_the_page_are_written() {
        let clone = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let start = SCRIPT.split("const SAMPLES = [").nth(1).expect("samples");
        let list = start.split("];").next().expect("an end");
        let named: Vec<&str> = list
            .lines()
            .filter_map(|line| line.split('"').nth(1))
            .collect();
        let written: Vec<&str> = SAMPLES
            .iter()
            .filter_map(|path| path.rsplit('/').next())
            .collect();
        assert_eq!(named, written);
        for sample in SAMPLES {
            assert!(clone.join(sample).is_file(), "{sample}");
        }
    }

    #[test]
    fn the_page_has_every_element_that_its_script_asks_for() {
        let page = filled(PAGE, &[("@ROBOT@", ROBOT)]);
        let made = format!("{page}{SCRIPT}");
        for part in SCRIPT.split("by(\"").skip(1) {
            let id = part.split('"').next().expect("an id");
            let is_there =
                made.contains(&format!("id=\"{id}\"")) || made.contains(&format!("id: \"{id}\""));
            assert!(is_there, "{id}");
        }
        // Everything comes from the folder itself; the name of SVG's namespace is no address.
        let made = made.replace("http://www.w3.org/2000/svg", "");
        for address in ["http://", "https://", "//cdn"] {
            assert!(!made.contains(address), "{address}");
        }
    }
}

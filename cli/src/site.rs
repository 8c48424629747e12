//! `homogen site`: the engine as a page of static files, for any server.
//!
//! A folder with the page, its script and style sheet, a worker, the engine as a WebAssembly module, and sample robots.
//! The view of a robot is that of `homogen show`. The page requests nothing but these files.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs, io};

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

/// The folder of robots in a clone.
const ROBOTS: &str = "robots";

/// A robot outside of it that has a button, too: large.
const HUMANOID: &str = "tests/robots/humanoid.urdf";

/// Endings of files that describe robots.
const DESCRIPTIONS: [&str; 5] = ["urdf", "xacro", "xml", "sdf", "dh"];

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
        for path in samples(clone)? {
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

/// Robots that the page opens by their names: those of a clone.
fn samples(clone: &Path) -> Result<Vec<PathBuf>, Errors> {
    let folder = clone.join(ROBOTS);
    let files = fs::read_dir(&folder).and_then(|files| {
        let paths = files.map(|file| Ok(file?.path()));
        paths.collect::<io::Result<Vec<_>>>()
    });
    let mut files =
        files.map_err(|reason| mistake(format!("cannot list {}: {reason}", folder.display())))?;
    files.retain(|path| {
        let ending = path.extension().and_then(|ending| ending.to_str());
        ending.is_some_and(|ending| DESCRIPTIONS.contains(&ending))
    });
    files.push(clone.join(HUMANOID));
    Ok(files)
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
    fn robots_with_a_button_are_written() {
        let clone = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let written = samples(&clone).expect("a folder of robots");
        let names = written.iter().filter_map(|path| path.file_name()?.to_str());
        let names: Vec<&str> = names.collect();
        let start = SCRIPT.split("const SAMPLES = [").nth(1).expect("samples");
        let list = start.split("];").next().expect("an end");
        let buttons: Vec<&str> = (list.lines())
            .filter_map(|line| line.split('"').nth(1))
            .collect();
        assert!(buttons.len() > 3);
        for button in buttons {
            assert!(names.contains(&button), "{button}");
        }
        for path in &written {
            assert!(path.is_file(), "{}", path.display());
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

//! The measured program: written, compiled for the baseline and for this processor, and run.
//!
//! In: scenes. Out: one executable for each set of flags, and what it says of a function. It never
//! looks at the numbers.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use homogen_codegen::Function;
use homogen_codegen::emit::{self, Item};
use homogen_codegen::expand::expand;
use homogen_codegen::function::Argument;
use homogen_codegen::schedule::Price;
use proc_macro2::{Ident, Span};

use crate::scene::{Scalar, Scene, Variant};
use crate::truth::told;

/// What a program is compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Flags {
    /// Every processor of the architecture.
    Baseline,
    /// This one.
    Native,
}

impl Flags {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Baseline, Self::Native];

    /// What readers call it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Native => "native",
        }
    }

    const fn rustflags(self) -> &'static str {
        match self {
            Self::Baseline => "",
            Self::Native => "-Ctarget-cpu=native",
        }
    }
}

/// What the recursions of the runtime are called among the variants.
pub const GENERIC: &str = "generic";

/// The source of all scenes, and the price of every program in it.
pub struct Source {
    /// What `measured` includes.
    pub text: String,
    /// Scene, variant, function, price.
    pub prices: Vec<(String, &'static str, Function, Price)>,
}

/// Expands every variant of every scene.
///
/// # Errors
/// Where a robot has mistakes.
pub fn source<'a>(scenes: impl Iterator<Item = &'a Scene>) -> Result<Source, Box<dyn Error>> {
    let mut modules = String::new();
    let mut arms = String::new();
    let mut prices = Vec::new();
    let mut count = 0;
    for scene in scenes {
        let mut cases = vec![String::new(); scene.functions.len()];
        for variant in &scene.variants {
            let (description, mut request) = scene.of(variant);
            let served: Vec<usize> = (0..scene.functions.len())
                .filter(|k| variant.serves(scene.functions[*k]))
                .collect();
            if served.is_empty() {
                continue;
            }
            let wanted = |function| variant.instead.unwrap_or(function);
            let functions = served.iter().map(|k| vec![wanted(scene.functions[*k])]);
            request.functions = functions.collect();
            let item = Item::made(Ident::new("Robot", Span::call_site()));
            let listing = expand(&description, &request, item).map_err(told)?;
            let module = format!("m_{count}");
            count += 1;
            writeln!(modules, "mod {module} {{ {} }}", emit::emit(&listing))?;
            for (listed, k) in listing.functions.iter().zip(served) {
                let (function, cases) = (scene.functions[k], &mut cases[k]);
                prices.push((scene.name.clone(), variant.name, function, listed.price));
                let robot = format!("{module}::Robot");
                for &scalar in variant.scalars {
                    cases.push_str(&case(
                        scene,
                        variant.name,
                        variant,
                        &robot,
                        wanted(function),
                        scalar,
                    ));
                }
                if scene.generic && variant.name == Variant::DEFAULT.name {
                    let chain = format!("const {{ {robot}::chain() }}");
                    for scalar in [Scalar::F64, Scalar::F32] {
                        cases.push_str(&case(scene, GENERIC, variant, &chain, function, scalar));
                    }
                }
            }
        }
        for (function, cases) in scene.functions.iter().zip(cases) {
            writeln!(
                arms,
                "(\"{}\", \"{}\") => vec![{cases}],",
                scene.name,
                function.name()
            )?;
        }
    }
    let text = format!(
        "#[allow(unused_imports, reason = \"for the functions of chains\")]\n\
         use homogen::robot::*;\n\
         fn cases(scene: &str, function: &str, truth: &Truth) -> Vec<Case> {{\n\
         match (scene, function) {{ {arms} _ => Vec::new() }}\n}}\n{modules}"
    );
    Ok(Source { text, prices })
}

/// A call of a function of a robot, as a program of `measured`.
fn case(
    scene: &Scene,
    name: &str,
    variant: &Variant,
    robot: &str,
    function: Function,
    scalar: Scalar,
) -> String {
    let argument = |argument: &Argument| {
        let name = argument.name();
        if variant.joints.is_empty() {
            return format!("&s.{name}");
        }
        let parts = variant.joints.iter().map(|k| format!("s.{name}[{k}]"));
        format!("&[{}]", parts.collect::<Vec<_>>().join(", "))
    };
    let arguments: Vec<String> = function.arguments().iter().map(argument).collect();
    let (arguments, function) = (arguments.join(", "), function.name());
    let (joints, entries, scalar) = (scene.joints, variant.joints, scalar.name());
    format!(
        "Case::of([\"{name}\", \"{scalar}\"], truth, &{entries:?}, \
         |s: &State<{scalar}, {joints}>| ({robot}).{function}({arguments})),\n"
    )
}

/// Compiles the measured program.
///
/// # Errors
/// Where cargo fails; what it says is shown.
pub fn compile(source: &Path, target: &Path, flags: Flags) -> Result<PathBuf, Box<dyn Error>> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("measured/Cargo.toml");
    let output = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "--release", "--quiet", "--manifest-path"])
        .arg(manifest)
        .arg("--target-dir")
        .arg(target)
        .env("GENERATED", source)
        .env("CARGO_ENCODED_RUSTFLAGS", flags.rustflags())
        .output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let built = target
        .join("release")
        .join(format!("measured{}", env::consts::EXE_SUFFIX));
    let kept = target.join(format!(
        "measured-{}{}",
        flags.name(),
        env::consts::EXE_SUFFIX
    ));
    // The other flags overwrite it.
    fs::copy(built, &kept)?;
    Ok(kept)
}

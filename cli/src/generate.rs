//! `homogen generate`: a file of Rust that needs `core` and nothing else, or one of C with its header.
//!
//! In: a description and names of functions. Out: what the builder of a build script writes, with
//! the same tokens. It never writes a file before everything is known to be right.

use std::io::Read;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::fields::Fields;
use super::functions::Functions;
use super::options::{Robot, Scalar, is_standard_input, mistake};
use super::{Answer, Said};
use homogen_codegen::builder::{Builder, header_beside};
use homogen_codegen::error::Errors;
use homogen_codegen::module::Module;
use homogen_codegen::real::Real;

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Language {
    Rust,
    C,
    Llvm,
}

/// Write the functions of a robot as a file of Rust that needs core and nothing else, or of C
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen generate arm.urdf --scalar f32 --functions inverse_dynamics,gravity -o arm.rs
  homogen generate arm.urdf --language c -o arm.c

Exit status: 0; 1 for a mistake in what was read; 2 for one in the arguments; 3 if everything was asked for and a
function was left out because of a fault of homogen, which standard error and the head of the file report: the others
are written.")]
pub(super) struct Generate {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    functions: Functions,
    #[command(flatten)]
    fields: Fields,
    /// What the file is written in; c is C99, with a header beside the file (arm.h beside arm.c); llvm is LLVM IR
    #[arg(long, value_enum, default_value = "rust")]
    language: Language,
    /// The states that a vector holds in LLVM IR
    #[arg(long, value_name = "COUNT", default_value = "8")]
    lanes: NonZeroUsize,
    /// The type of number [default: f64, or any with --runtime]
    #[arg(long, value_enum)]
    scalar: Option<Scalar>,
    /// Write what a derive expands to, for a crate that has the runtime at this path: ::homogen
    #[arg(long, value_name = "PATH")]
    runtime: Option<String>,
    /// Functions of slices of states besides
    #[arg(long, requires = "runtime")]
    batch: bool,
    /// The most statements of one compiled function: longer ones are cut into sections that are called one after the
    /// other [default: 2000, of functions with more than 8000]
    #[arg(long, value_name = "COUNT")]
    section: Option<NonZeroUsize>,
    /// Write no character beyond ASCII: θ is theta in comments
    #[arg(long)]
    ascii: bool,
    /// The path of a function from an angle to its sine and cosine, such as ::libm::sincosf
    /// [default: the file brings its own]
    #[arg(long, value_name = "PATH")]
    sin_cos: Option<String>,
    /// Functions for C as well, whose names begin with this; in C all names begin so
    /// [default there: the robot's name]
    #[arg(long, value_name = "PREFIX")]
    extern_c: Option<String>,
    /// The file to write the header of the functions for C to
    #[arg(long, value_name = "OUT", requires = "extern_c")]
    c_header: Option<PathBuf>,
    /// The name of the struct, or of the robot in C [default: the robot's]
    #[arg(long)]
    name: Option<String>,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "OUT", default_value = "-")]
    output: PathBuf,
}

impl Generate {
    pub(super) fn run(&self, input: &mut dyn Read) -> Said {
        let name = self.name.as_deref();
        let (mut builder, remarks) =
            self.functions
                .builder(&self.robot, &self.fields, (self.number(), name), input)?;
        if let Some(path) = &self.runtime {
            builder = builder.runtime(path);
        }
        if self.batch {
            builder = builder.batch();
        }
        if let Some(most) = self.section {
            builder = builder.section(most);
        }
        if self.ascii {
            builder = builder.ascii();
        }
        if let Some(path) = &self.sin_cos {
            builder = builder.sin_cos(path);
        }
        if let Some(prefix) = &self.extern_c {
            builder = builder.extern_c(prefix);
        }
        let (output, module) = match self.language {
            Language::Rust => self.rust(&builder)?,
            Language::C => self.c(&builder)?,
            Language::Llvm => self.llvm(&builder)?,
        };
        Ok(Answer {
            output,
            remarks: remarks + &Functions::remarks(&module),
            code: Functions::code(&module),
        })
    }

    /// The type of number: any where none is named and the runtime has them all.
    fn number(&self) -> Real {
        match (self.scalar, &self.runtime) {
            (Some(scalar), _) => scalar.into(),
            (None, Some(_)) => Real::Generic,
            (None, None) => Real::F64,
        }
    }

    /// Writes a file of Rust, or returns its text.
    fn rust(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.file_listing()?;
        let text = builder.source(&module).to_string();
        if let Some(path) = &self.c_header {
            write(path, &builder.c_header(&module))?;
        }
        if is_standard_input(&self.output) {
            return Ok((text, module));
        }
        write(&self.output, &text)?;
        Ok((String::new(), module))
    }

    /// Writes a module of LLVM IR, or returns its text.
    fn llvm(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.c_listing()?;
        let text = builder.llvm(&module, self.lanes);
        if is_standard_input(&self.output) {
            return Ok((text, module));
        }
        write(&self.output, &text)?;
        Ok((String::new(), module))
    }

    /// Writes a file of C and its header, or returns both as one text.
    fn c(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        if self.c_header.is_some() {
            let message = "--c-header is the header of functions that are written in Rust";
            let mut errors = mistake(message);
            errors.append(builder.c_listing().err().unwrap_or_default());
            return Err(errors);
        }
        let to_file = !is_standard_input(&self.output);
        let beside = to_file.then(|| header_beside(&self.output)).transpose()?;
        let module = builder.c_listing()?;
        let Some((path, name)) = beside else {
            let source = builder.c(&module, "robot.h");
            return Ok((format!("{}\n{}", source.header, source.text), module));
        };
        let source = builder.c(&module, &name);
        write(&path, &source.header)?;
        write(&self.output, &source.text)?;
        Ok((String::new(), module))
    }
}

pub(super) fn write(path: &Path, text: &str) -> Result<(), Errors> {
    let refuse = |reason| mistake(format!("cannot write {}: {reason}", path.display()));
    std::fs::write(path, text).map_err(refuse)
}

//! `homogen generate`: a file in Rust that needs only `core`, one in C with its header, a header in C++, LLVM IR, or plain
//! Python.
//!
//! The output is that of the builder of a build script. Nothing is written if there are errors.

use std::io::Read;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::functions::{self, Generated};
use super::options::{Asked, Scalar, is_standard_input, mistake};
use super::{Answer, Outcome};
use homogen_codegen::builder::{Builder, header_beside};
use homogen_codegen::error::Errors;
use homogen_codegen::module::Module;
use homogen_codegen::print::arrays::Order;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::FILE;

/// Language of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Language {
    Rust,
    C,
    Cpp,
    Llvm,
    Python,
}

/// Order of six numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Halves {
    LinearFirst,
    AngularFirst,
}

impl From<Halves> for Order {
    fn from(halves: Halves) -> Self {
        match halves {
            Halves::LinearFirst => Self::LinearFirst,
            Halves::AngularFirst => Self::AngularFirst,
        }
    }
}

/// Write the functions of a robot as a file of Rust that needs only core, or of C, C++, LLVM IR or Python
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen generate arm.urdf --scalar f32 --functions inverse_dynamics,gravity -o arm.rs
  homogen generate arm.urdf --language c -o arm.c
  homogen generate arm.urdf --language cpp --order linear-first -o arm.hpp
  homogen generate arm.urdf --language python -o arm.py

Exit status: 0; 1 for an error in the input; 2 for one in the arguments; 3 if all functions were requested and one was
left out because of a fault of homogen, which standard error and the head of the file report; the others are written.")]
pub(super) struct Generate {
    #[command(flatten)]
    generated: Generated,
    /// The language; c is C99, with a header beside the file (arm.h beside arm.c); cpp is a header of C++17 for numbers of
    /// any type; llvm is LLVM IR; python is a module for numbers of any library
    #[arg(long, value_enum, default_value = "rust")]
    language: Language,
    /// Number of states in a vector of LLVM IR
    #[arg(long, value_name = "COUNT", default_value = "8")]
    lanes: NonZeroUsize,
    /// In C++ and Python the first half of twists, wrenches and momenta
    /// [default: angular-first in C++, linear-first in Python]
    #[arg(long, value_enum)]
    order: Option<Halves>,
    /// The type of numbers [default: f64, or any with --runtime]
    #[arg(long, value_enum)]
    scalar: Option<Scalar>,
    /// Write the code of a derive, for a crate with the runtime at this path: ::homogen
    #[arg(long, value_name = "PATH")]
    runtime: Option<String>,
    #[command(flatten)]
    asked: Asked<FILE>,
    /// Restrict the file to ASCII: θ becomes theta in comments
    #[arg(long)]
    ascii: bool,
    /// The path of a function from an angle to its sine and cosine, such as ::libm::sincosf
    /// [default: the file has its own]
    #[arg(long, value_name = "PATH")]
    sin_cos: Option<String>,
    /// Add functions for C with this prefix; in C the prefix of all names
    /// [default in C: the robot's name]
    #[arg(long, value_name = "PREFIX")]
    extern_c: Option<String>,
    /// The file for the header of the C functions
    #[arg(long, value_name = "OUT", requires = "extern_c")]
    c_header: Option<PathBuf>,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "OUT", default_value = "-")]
    output: PathBuf,
}

impl Generate {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let request = self.asked.and(Request {
            scalar: self.number(),
            ..Request::default()
        });
        let mut builder = self.generated.builder(request, input)?;
        if let Some(path) = &self.runtime {
            builder = builder.runtime(path);
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
        if self.order.is_some() && !matches!(self.language, Language::Cpp | Language::Python) {
            return Err(mistake("--order is for C++ and Python"));
        }
        let (output, module) = match self.language {
            Language::Rust => self.rust(&builder)?,
            Language::C => self.c(&builder)?,
            Language::Cpp => self.cpp(&builder)?,
            Language::Llvm => self.llvm(&builder)?,
            Language::Python => self.python(&builder)?,
        };
        Ok(Answer {
            output,
            remarks: functions::remarks(&module),
            code: functions::status(&module),
        })
    }

    /// The type of numbers: any by default, if the runtime is used.
    fn number(&self) -> Real {
        match (self.scalar, &self.runtime) {
            (Some(scalar), _) => scalar.into(),
            (None, Some(_)) => Real::Generic,
            (None, None) => Real::F64,
        }
    }

    /// Writes a file of Rust, or returns its text.
    fn rust(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.file_module()?;
        let text = builder.source(&module).to_string();
        if let Some(path) = &self.c_header {
            write(path, &builder.c_header(&module))?;
        }
        Ok((self.put(text)?, module))
    }

    /// Writes a text, or returns it for standard output.
    fn put(&self, text: String) -> Result<String, Errors> {
        if is_standard_input(&self.output) {
            return Ok(text);
        }
        write(&self.output, &text).map(|()| String::new())
    }

    /// Writes a header in C++, or returns its text.
    fn cpp(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.cpp_module()?;
        let name = self.output.file_name().and_then(|name| name.to_str());
        let name = name.filter(|_| !is_standard_input(&self.output));
        let order = self.order.map_or(Order::AngularFirst, Order::from);
        let text = builder.cpp(&module, name.unwrap_or("robot.hpp"), order);
        Ok((self.put(text)?, module))
    }

    /// Writes a module of LLVM IR, or returns its text.
    fn llvm(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.compiled_module()?;
        let text = builder.llvm(&module, self.lanes);
        Ok((self.put(text)?, module))
    }

    /// Writes a module of Python, or returns its text.
    fn python(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        let module = builder.plain_python_module()?;
        let order = self.order.map_or(Order::LinearFirst, Order::from);
        Ok((self.put(builder.plain_python(&module, order))?, module))
    }

    /// Writes a file of C and its header, or returns both as one text.
    fn c(&self, builder: &Builder) -> Result<(String, Module), Errors> {
        if self.c_header.is_some() {
            let message = "--c-header is for functions written in Rust";
            let mut errors = mistake(message);
            errors.append(builder.c_module().err().unwrap_or_default());
            return Err(errors);
        }
        let to_file = !is_standard_input(&self.output);
        let beside = to_file.then(|| header_beside(&self.output)).transpose()?;
        let module = builder.c_module()?;
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

//! Generates straight-line code for the kinematics and dynamics of a robot from its description.
//!
//! ```
//! use homogen_codegen::{Builder, Function::Gravity, Real};
//!
//! // In a build script, where `.write("arm.rs")` writes the same to `OUT_DIR`.
//! let source = Builder::from_urdf("../robots/two_link.urdf")
//!     .name("Arm")
//!     .scalar(Real::F32)
//!     .generate([Gravity])
//!     .to_source()?
//!     .to_string();
//! assert!(source.contains("pub fn gravity(&self, q: &[f32; 2]) -> [f32; 2]"));
//! # Ok::<(), homogen_codegen::error::Errors>(())
//! ```
//!
//! [`Builder`] is the front end for build scripts and writes Rust for `core` alone, C99 ([`Builder::write_c`]), LLVM IR,
//! plain Python and Python packages. The command line `homogen` is in the crate `homogen-cli`, the derive and the macro in the crate
//! `homogen`. [`Function`] lists the functions, [`Formulation`] the algorithms and [`Processor`] the targets.
//!
//! The engine is a pipeline of stages; each uses the one before it, and [`expand`] connects them:
//!
//! ```text
//! description ──► chain ──► plan ──────────► module ──► print
//!  what the        what it   one a function:   what is    rust, c,
//!  user wrote      means     layout, model,    generated  llvm,
//!                            simplify,            ▲       python
//!                            schedule             ├── check
//!                                                 └── accuracy
//! ```
//!
//! # Features
//!
//! | feature | |
//! |---|---|
//! | `files` (default) | [`Builder`]: files in Rust, C and LLVM, packages for Python, and what reviewers read; with `formats` |
//! | `formats` | MJCF, SDF and xacro files; those of URDF and tables are read without it |

#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "files")]
pub mod builder;
pub mod description;
pub mod error;
pub mod formulation;
pub mod function;
mod index;
pub mod processor;
#[doc(hidden)]
pub mod quaternion;
mod random;
pub mod real;
pub mod request;

// Not for users: called by the macros, the tests and the reports of the project.
#[doc(hidden)]
pub mod accuracy;
#[cfg(feature = "files")]
#[doc(hidden)]
pub mod arithmetic;
#[doc(hidden)]
pub mod chain;
#[doc(hidden)]
pub mod check;
#[doc(hidden)]
pub mod closure;
#[cfg(feature = "files")]
#[doc(hidden)]
pub mod convert;
mod dense;
#[doc(hidden)]
pub mod expand;
#[doc(hidden)]
pub mod expression;
#[doc(hidden)]
pub mod front_end;
#[doc(hidden)]
pub mod joint;
#[doc(hidden)]
pub mod layout;
#[doc(hidden)]
pub mod list;
#[doc(hidden)]
pub mod matrix;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod module;
#[doc(hidden)]
pub mod name;
#[doc(hidden)]
pub mod number;
#[doc(hidden)]
pub mod plan;
#[doc(hidden)]
pub mod print;
#[doc(hidden)]
pub mod range;
#[doc(hidden)]
pub mod schedule;
#[doc(hidden)]
pub mod simplify;
#[doc(hidden)]
pub mod space;
#[cfg(feature = "files")]
#[doc(hidden)]
pub mod template;
#[doc(hidden)]
pub mod wording;

#[cfg(feature = "files")]
pub use builder::Builder;
pub use formulation::Formulation;
pub use function::Function;
pub use processor::Processor;
pub use real::Real;
pub use request::Target;

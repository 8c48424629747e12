//! The module of LLVM IR that a [`Builder`] writes.
//!
//! In: its options, and how many lanes a vector has. Out: text.

use std::num::NonZeroUsize;

use super::Builder;
use super::command::Language;
use crate::error::Errors;
use crate::module::Module;
use crate::print::llvm::{self, Steps, Writing};

impl Builder {
    /// The same functions as LLVM IR, for LLVM 19 or later: `NAME` of one state, with the parameters that it has in
    /// [`to_c`](Self::to_c), and `NAME_batch` of many states, in vectors of `lanes`.
    ///
    /// `NAME_batch` takes the count of states, the fields where the robot has any, and for each argument and each
    /// result a pointer, the distance between states and the distance between entries of one state, both in numbers.
    /// `NAME_arrays` takes the count, a pointer to the fields, which nothing reads where there are none, and a pointer to
    /// those triples (`ptr`, `i64`, `i64`), one after the other.
    /// The bits are those of the file in C. [`Real::Generic`](crate::Real::Generic) is taken for `double`.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request; options that only Rust has.
    pub fn to_llvm(&self, lanes: NonZeroUsize) -> Result<String, Errors> {
        let module = self.c_module()?;
        Ok(self.llvm(&module, lanes))
    }

    /// The module of LLVM.
    #[doc(hidden)]
    #[must_use]
    pub fn llvm(&self, module: &Module, lanes: NonZeroUsize) -> String {
        let writing = Writing {
            prefix: &self.prefix(module),
            asked: Some(&self.asked(module, Language::Llvm(lanes))),
            steps: Steps::OfQuaternions,
            lanes: lanes.get(),
            fused: self.fuses(module),
        };
        llvm::print(module, &writing)
    }
}

//! LLVM IR of a [`Builder`], as text.

use std::num::NonZeroUsize;

use super::Builder;
use super::command::Language;
use crate::error::Errors;
use crate::module::Module;
use crate::print::llvm::{self, LlvmOptions, States, Steps};

impl Builder {
    /// The functions as LLVM IR, for LLVM 19 or later: `NAME` for one state, with the parameters of
    /// [`to_c`](Self::to_c), and `NAME_batch` for many states, in vectors of `lanes`.
    ///
    /// `NAME_batch` takes the number of states and the fields, if there are some. For each argument and each result it
    /// takes a pointer, the distance between states, and the distance between entries of one state, both in numbers.
    /// `NAME_arrays` takes the number of states, a pointer to the fields, which is not read if there are none, and a pointer
    /// to these triples (`ptr`, `i64`, `i64`), one after the other.
    /// Results equal those of the C file bit for bit. [`Real::Generic`](crate::Real::Generic) becomes `double`.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that only Rust has.
    pub fn to_llvm(&self, lanes: NonZeroUsize) -> Result<String, Errors> {
        let module = self.compiled_module()?;
        Ok(self.llvm(&module, lanes))
    }

    /// The LLVM IR of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn llvm(&self, module: &Module, lanes: NonZeroUsize) -> String {
        let options = LlvmOptions {
            prefix: &self.prefix(module),
            asked: Some(&self.asked(module, Language::Llvm(lanes))),
            steps: Steps::OfQuaternions,
            states: States::InLanes(lanes.get()),
            fused: self.fuses(module),
        };
        llvm::print(module, &options)
    }
}

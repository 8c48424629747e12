//! Robots with arbitrary names: their files are generated, compiled and linked in every language.
//!
//! In: seeds. Out: messages of compilers and of the files' own tests. The names are keywords, macros and types of
//! headers, identifiers of generated files, words in other alphabets, and strings that are no identifiers.

pub mod compilers;
pub mod files;
pub mod pool;
pub mod robot;

//! Robots of any names, generated, compiled and linked in every language.
//!
//! In: seeds. Out: what the command line writes of robots whose names are words of languages, of headers and of our
//! own files, in other alphabets or no words at all; and what compilers and the tests in these files say to it.

pub mod compilers;
pub mod files;
pub mod pool;
pub mod robot;

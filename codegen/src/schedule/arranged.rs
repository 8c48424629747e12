//! Arrangement of a program for printing.
//!
//! In: a [`Program`], the equal limbs of its robot, and the length of functions. Out: its steps in the order of
//! execution, its loops, and its sections. Results are the same bits.

use std::borrow::Cow;

use super::Program;
use super::limbs::in_limbs;
use super::repeats::{Repeat, repeats};
use super::sections::{Length, Sections, sections};
use crate::space::Limbs;

/// A program with its loops and sections.
#[derive(Clone, Debug)]
pub struct Arranged<'p> {
    /// The program, with the same results.
    pub program: Cow<'p, Program>,
    /// Its loops, in order.
    pub repeats: Vec<Repeat>,
    /// Its sections, if it is too long for one function.
    pub sections: Option<Sections>,
}

impl<'p> Arranged<'p> {
    /// Arranges a program.
    #[must_use]
    pub fn of(program: &'p Program, limbs: &[Limbs], length: Length) -> Self {
        let columns = repeats(program);
        let (program, repeats) = match in_limbs(program, limbs, &columns, length) {
            Some((program, repeats)) => (Cow::Owned(program), repeats),
            None => (Cow::Borrowed(program), columns),
        };
        let sections = sections(&program, &repeats, length);
        Self {
            program,
            repeats,
            sections,
        }
    }
}

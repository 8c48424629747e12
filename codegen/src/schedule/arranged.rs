//! Arrangement of a program for printing.
//!
//! In: a [`Program`], the equal limbs of its robot, and the length of functions. Out: its steps in the order of
//! execution, its loops, and its sections. Results are the same bits.

use std::borrow::Cow;
use std::collections::HashMap;

use super::limbs::in_limbs;
use super::parts::in_parts;
use super::repeats::{Repeat, repeats};
use super::sections::{Length, Sections, are_needed, sections};
use super::{Operand, Program};
use crate::space::Limbs;

/// A program with its loops and sections.
#[derive(Clone, Debug)]
pub struct Arranged<'p> {
    /// The program, with the same results.
    pub program: Cow<'p, Program>,
    /// Its loops, in order, with their results in the order of those of the program.
    pub repeats: Vec<Repeat>,
    /// Its sections, if it is too long for one function.
    pub sections: Option<Sections>,
}

impl<'p> Arranged<'p> {
    /// Arranges a program.
    #[must_use]
    pub fn of(program: &'p Program, limbs: &[Limbs], length: Length) -> Self {
        let columns = repeats(program);
        let (mut program, mut repeats) = match in_limbs(program, limbs, &columns, length) {
            Some((program, repeats)) => (Cow::Owned(program), repeats),
            None => (Cow::Borrowed(program), columns),
        };
        if are_needed(&program, &repeats, length) {
            let parts = in_parts(&program, &repeats, length.of_section());
            (program, repeats) = (Cow::Owned(parts.0), parts.1);
        }
        let first_result = first_result(&program);
        for repeat in &mut repeats {
            let place = |step: &u32| first_result.get(step).copied().unwrap_or(usize::MAX);
            repeat.stores.sort_by_key(place);
        }
        let sections = sections(&program, &repeats, length);
        Self {
            program,
            repeats,
            sections,
        }
    }
}

/// For each step that is a result, the index of the first such result.
fn first_result(program: &Program) -> HashMap<u32, usize> {
    let results = program.results.iter().enumerate().rev();
    let results = results.filter_map(|(index, result)| match result {
        Operand::Step(step) => Some((*step, index)),
        _ => None,
    });
    results.collect()
}

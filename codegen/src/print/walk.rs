//! The walk over a routine that all languages share.
//!
//! In: the statements of a [`Routine`](crate::schedule::Routine). Out: a call for each of them on a [`Language`], in
//! their order. It writes nothing itself.

use crate::schedule::{Angle, Operation, Rounds, Statement, Value};

/// The spelling of what statements are made of. What is written gathers in the language itself.
pub(super) trait Language {
    /// Binds a name to the result of an operation.
    fn operation(&mut self, name: &str, operation: &Operation<Value>);

    /// Binds names to the sines and cosines of all angles.
    fn sines_and_cosines(&mut self, angles: &[Angle]);

    /// Puts a value into the work array.
    fn put(&mut self, place: usize, value: &Value);

    /// Stores the result of that index.
    fn store(&mut self, result: usize, value: &Value);

    /// Begins the loop over the columns of a table, which is filled first.
    fn begin_loop(&mut self, rounds: &Rounds);

    /// Ends that loop.
    fn end_loop(&mut self, rounds: &Rounds);

    /// Begins a scope; by default names are those of one scope.
    fn begin_scope(&mut self) {}

    /// Ends that scope, behind which some of its names are read.
    fn end_scope(&mut self, _handed_on: &[String]) {}
}

/// Writes statements one after the other.
pub(super) fn walk(language: &mut impl Language, statements: &[Statement]) {
    for statement in statements {
        match statement {
            Statement::Operation(name, operation) => language.operation(name, operation),
            Statement::SinesAndCosines(angles) => language.sines_and_cosines(angles),
            Statement::Block {
                statements,
                handed_on,
            } => {
                language.begin_scope();
                walk(language, statements);
                language.end_scope(handed_on);
            }
            Statement::Left(place, value) => language.put(*place, value),
            Statement::Found(result, value) => language.store(*result, value),
            Statement::Rounds(rounds) => {
                language.begin_loop(rounds);
                walk(language, &rounds.statements);
                language.end_loop(rounds);
            }
        }
    }
}

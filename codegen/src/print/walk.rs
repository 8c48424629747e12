//! Walk over the statements of a routine, shared by all languages.
//!
//! In: the statements of a [`Routine`](crate::schedule::Routine). Out: calls of a [`Language`], in their order.

use crate::schedule::{Angle, Operation, RoutineLoop, Statement, StorePlace, Value};

/// Printer of statements, which collects its text.
pub(super) trait Language {
    /// Binds a name to the result of an operation.
    fn operation(&mut self, name: &str, operation: &Operation<Value>);

    /// Binds names to the sines and cosines of all angles.
    fn sines_and_cosines(&mut self, angles: &[Angle]);

    /// Stores a value in the work array or in a table of a loop.
    fn put(&mut self, place: &StorePlace, value: &Value);

    /// Stores the result with an index.
    fn store(&mut self, result: usize, value: &Value);

    /// Initialises a table and begins the loop over its columns.
    fn begin_loop(&mut self, each: &RoutineLoop);

    /// Ends the loop.
    fn end_loop(&mut self, each: &RoutineLoop);

    /// Begins a scope. The default is for languages in which a function is one scope.
    fn begin_scope(&mut self) {}

    /// Ends a scope; some of its names are read after it.
    fn end_scope(&mut self, _handed_on: &[String]) {}
}

/// Prints statements in order.
pub(super) fn walk(language: &mut impl Language, statements: &[Statement]) {
    for statement in statements {
        match statement {
            Statement::Operation(name, operation) => language.operation(name, operation),
            Statement::SinesAndCosines(angles) => language.sines_and_cosines(angles),
            Statement::Block {
                statements,
                outputs,
            } => {
                language.begin_scope();
                walk(language, statements);
                language.end_scope(outputs);
            }
            Statement::Store(place, value) => language.put(place, value),
            Statement::StoreResult(result, value) => language.store(*result, value),
            Statement::Loop(each) => {
                language.begin_loop(each);
                walk(language, &each.statements);
                language.end_loop(each);
            }
        }
    }
}

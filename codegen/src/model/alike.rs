//! Equal computations for several columns.
//!
//! In: columns, and a function of each. Out: its results, with columns that have the same zeros one after the other and
//! computed by the same steps, so that the steps can be written once for all of them, whoever reads their results.

use crate::expression::Term;
use crate::list::List;
use crate::space::VelocityId;

/// Minimum operations saved for columns to share a loop: a column no longer shares operations with others that it is a
/// multiple of.
const WORTH: usize = 300;

type Column<'g> = List<VelocityId, Term<'g>>;

/// The results of `of` for each column, each of which takes at least some number of operations; columns whose zeros too
/// few others have are not marked.
pub fn alike<'g, R>(
    columns: &[Column<'g>],
    operations: usize,
    of: impl Fn(&Column<'g>) -> R,
) -> Vec<R>
where
    R: IntoIterator<Item = Term<'g>> + FromIterator<Term<'g>>,
{
    let zeros = |column: &Column<'g>| -> Vec<bool> {
        let zeros = column.iter().map(|entry| entry.is_zero());
        zeros.collect()
    };
    let zeros: Vec<Vec<bool>> = columns.iter().map(zeros).collect();
    let is_worth = |k: usize| {
        let others = zeros.iter().filter(|other| **other == zeros[k]).count() - 1;
        others * operations >= WORTH
    };
    // All are marked before the first result is computed, so that changes of signs precede all of them.
    let marked = columns.iter().zip(0_u16..).enumerate();
    let marked = marked.map(|(k, (column, number))| {
        is_worth(k).then(|| column.map(|entry| entry.taken_by(number)))
    });
    let marked: Vec<Option<Column<'g>>> = marked.collect();
    let mut made: Vec<Option<R>> = columns.iter().map(|_| None).collect();
    for first in 0..columns.len() {
        if marked[first].is_none() {
            made[first] = Some(of(&columns[first]));
        }
        for k in first..columns.len() {
            if let (Some(column), None, true) = (&marked[k], &made[k], zeros[k] == zeros[first]) {
                made[k] = Some(of(column).into_iter().map(Term::made).collect());
            }
        }
    }
    made.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use std::mem::{Discriminant, discriminant};

    use super::{WORTH, alike};
    use crate::expression::{Graph, Input, Term};
    use crate::list::List;
    use crate::schedule::{Operand, Operation, Program, run, schedule};
    use crate::simplify::simplify;
    use crate::space::{Variable, VelocityId};

    fn q(graph: &Graph, k: u16) -> Term<'_> {
        graph.input(Input::Variable(Variable::Q, k))
    }

    /// Length of the columns: the shortest that pays for two.
    const LENGTH: u16 = 18;

    /// Columns of which the second is the first up to signs, and the third has a zero.
    fn columns<'g>(graph: &'g Graph) -> Vec<List<VelocityId, Term<'g>>> {
        let [a, b, zero] = [q(graph, 1), q(graph, 2), graph.constant(0.0)];
        let of_each: [&dyn Fn(u16, Term<'g>) -> Term<'g>; 3] = [
            &|_, x| a * x,
            &|k, x| if k % 2 == 0 { -(b + x) } else { b * x },
            &|k, x| if k == 0 { zero } else { x },
        ];
        let column = |of: &dyn Fn(u16, Term<'g>) -> Term<'g>| {
            let entries = (0..LENGTH).map(|k| of(k, q(graph, 3 + k)));
            entries.collect()
        };
        of_each.map(column).into()
    }

    /// Each entry minus l times the last one.
    fn solved<'g>(graph: &'g Graph, x: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let last = x.iter().copied().last().expect("entries");
        x.map(|&entry| entry - q(graph, 0) * last)
    }

    fn program(of_each: bool) -> Program {
        let graph = Graph::new();
        let columns = columns(&graph);
        let found: Vec<_> = if of_each {
            columns
                .iter()
                .map(|column| solved(&graph, column))
                .collect()
        } else {
            alike(&columns, WORTH, |column| solved(&graph, column))
        };
        let results: Vec<_> = found.iter().flatten().map(|term| term.expr()).collect();
        let (graph, results) = simplify(&graph, &results);
        schedule(&graph, &results)
    }

    /// The kinds of operations whose results are the entries of two columns.
    fn kinds(program: &Program) -> [Vec<Discriminant<Operation>>; 2] {
        let kind = |result: &Operand| match *result {
            Operand::Step(step) => discriminant(&program.steps[step as usize].operation),
            _ => unreachable!("{result:?}"),
        };
        let mut columns = program.results.chunks(usize::from(LENGTH));
        [(); 2].map(|()| columns.next().expect("a column").iter().map(kind).collect())
    }

    #[test]
    fn columns_with_the_same_zeros_are_computed_by_the_same_steps() {
        let [first, second] = kinds(&program(false));
        assert_eq!(first, second);
        // Unmarked, signs move outwards.
        let [first, second] = kinds(&program(true));
        assert_ne!(first, second);
    }

    /// A reader with a sign of its own would otherwise have the entries computed with it.
    #[test]
    fn readers_do_not_change_the_steps() {
        let graph = Graph::new();
        let columns = columns(&graph);
        let found = alike(&columns, WORTH, |column| solved(&graph, column));
        let results = found[0].iter().map(|&entry| -entry);
        let results = results.chain(found[1].iter().copied());
        let results: Vec<_> = results.map(Term::expr).collect();
        let (graph, results) = simplify(&graph, &results);
        let program = schedule(&graph, &results);
        let at = |operand: Operand| match operand {
            Operand::Step(step) => program.steps[step as usize].operation,
            _ => unreachable!("{operand:?}"),
        };
        let entry = |&result: &Operand| match at(result) {
            Operation::Neg(entry) => discriminant(&at(entry)),
            entry => discriminant(&entry),
        };
        let (first, second) = program.results.split_at(usize::from(LENGTH));
        let [first, second] = [first, second].map(|of| of.iter().map(entry).collect::<Vec<_>>());
        assert_eq!(first, second);
    }

    #[test]
    fn other_columns_are_unchanged() {
        let [alike, each] = [program(false), program(true)].map(|program| {
            run::<f64>(&program, |input| match input {
                Input::Variable(Variable::Q, k) => f64::from(k).sin() + 0.3,
                _ => unreachable!("only q is used"),
            })
        });
        assert_eq!(alike, each);
        assert_eq!(alike.len(), 3 * usize::from(LENGTH));
    }
}

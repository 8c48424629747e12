//! Large matrices that a function fills as it goes.
//!
//! In: the results of a function, and which of them its statements store. Out: the matrix as it begins, and what
//! stores an entry. Hundreds of numbers that nothing reads any more would otherwise wait on the stack for the end, as
//! no compiler brings stores forward so far. It never says when an entry is found.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use crate::function::Function;
use crate::schedule::LONGEST_SCOPE;
use crate::space::{Outcome, Spaces};

/// A matrix that is filled.
pub(super) struct Filling {
    /// Its name.
    pub matrix: Ident,
    /// How long its rows are.
    pub columns: usize,
}

impl Filling {
    /// The matrix with all results that are known from the start, and a one for those that are stored later.
    ///
    /// Not a zero: what began as zeros alone would be cleared by a call for all of it, which takes longer
    /// than the stores that this saves.
    pub fn begin(
        &self,
        results: &[TokenStream],
        stored: &BTreeSet<usize>,
        one: &TokenStream,
    ) -> TokenStream {
        let at_first = results.iter().enumerate();
        let at_first = at_first.map(|(k, result)| if stored.contains(&k) { one } else { result });
        let at_first: Vec<_> = at_first.collect();
        let rows = at_first.chunks(self.columns);
        let rows = rows.map(|row| quote! { [#(#row),*] });
        let matrix = &self.matrix;
        quote! { let mut #matrix = [#(#rows),*]; }
    }

    /// `y[1][2] = a;`, of the result of that index.
    pub fn store(&self, result: usize, value: &TokenStream) -> TokenStream {
        let place = [result / self.columns, result % self.columns];
        let [row, column] = place.map(Literal::usize_unsuffixed);
        let matrix = &self.matrix;
        quote! { #matrix[#row][#column] = #value; }
    }
}

/// How long the rows are of what `functions` return, where they are those of a matrix with more numbers than a
/// scope has, none of which is read again: what is solved for is made of what was found before.
pub(super) fn columns(functions: &[Function], spaces: &Spaces) -> Option<usize> {
    let [function] = functions else {
        return None;
    };
    let Outcome::One(quantity) = function.result() else {
        return None;
    };
    if function.solves() || function.is_constrained() {
        return None;
    }
    let [rows, columns] = quantity.lengths(spaces)[..] else {
        return None;
    };
    (rows * columns > LONGEST_SCOPE).then_some(columns)
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::{format_ident, quote};

    use super::{Filling, columns};
    use crate::chain;
    use crate::description;
    use crate::error::Errors;
    use crate::function::Function;
    use crate::request::Request;
    use crate::space::Spaces;

    fn spaces(robot: &str, request: &Request) -> Spaces {
        let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
        let description = description::read_file(path.as_ref(), None, &mut Errors::new());
        let description = description.expect("a robot that ships");
        let chain = chain::build(&description, request).expect("no mistakes");
        chain.spaces().clone()
    }

    #[test]
    fn matrices_with_more_numbers_than_a_scope_has_are_filled_but_where_they_are_solved_for() {
        let fixed = Request::default();
        let [two_link, ur5, quadruped] =
            ["two_link", "ur5_class", "quadruped"].map(|robot| spaces(robot, &fixed));
        let floating = Request {
            floating: true,
            ..fixed
        };
        let free = spaces("quadruped", &floating);
        assert_eq!(columns(&[Function::Regressor], &ur5), Some(60));
        assert_eq!(columns(&[Function::BaseRegressor], &ur5), Some(36));
        assert_eq!(columns(&[Function::Regressor], &two_link), None);
        assert_eq!(
            columns(&[Function::Regressor, Function::Gravity], &ur5),
            None
        );
        assert_eq!(columns(&[Function::InverseDynamicsDerivatives], &ur5), None);
        for function in [Function::MassMatrix, Function::CoriolisMatrix] {
            assert_eq!(columns(&[function], &free), Some(18));
            assert_eq!(columns(&[function], &quadruped), None);
        }
        assert_eq!(columns(&[Function::MassMatrixInverse], &free), None);
    }

    #[test]
    fn what_is_found_is_stored_in_its_place_and_the_rest_is_there_from_the_start() {
        let filling = Filling {
            matrix: format_ident!("y_"),
            columns: 3,
        };
        let results: Vec<TokenStream> = ["k(0.0)", "a", "b", "q", "c", "a"]
            .map(|text| text.parse().expect("tokens"))
            .into();
        let begun = filling.begin(&results, &[1, 2, 4, 5].into(), &quote! { k(1.0) });
        let expected = quote! {
            let mut y_ = [[k(0.0), k(1.0), k(1.0)], [q, k(1.0), k(1.0)]];
        };
        assert_eq!(begun.to_string(), expected.to_string());
        let stored = filling.store(5, &results[5]);
        assert_eq!(stored.to_string(), quote! { y_[1][2] = a; }.to_string());
    }
}

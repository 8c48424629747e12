//! The statements of a function, and large matrices that they fill as they go.
//!
//! In: statements with the names that they bind, and results. Out: one after the other; or, of a large matrix,
//! with each result stored where it is returned as soon as it is found. Hundreds of numbers that nothing reads any
//! more would otherwise wait on the stack for the end, as no compiler brings stores forward so far. It never
//! changes a statement, only what stands between two.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::names::ident;
use crate::function::Function;
use crate::schedule::{LONGEST_SCOPE, Names};
use crate::space::{Outcome, Spaces};

/// What comes before the result of a function.
pub(super) struct Statements {
    /// What binds constants, arguments and fields.
    pub head: TokenStream,
    /// What computes, each with the names that it binds.
    pub steps: Vec<(TokenStream, Vec<String>)>,
    /// All names that are taken.
    pub names: Names,
    /// A one, where numbers can be written and no result waits in an array.
    pub one: Option<TokenStream>,
}

impl ToTokens for Statements {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let steps = self.steps.iter().map(|(step, _)| step);
        tokens.extend(std::iter::once(&self.head).chain(steps).cloned());
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

impl Statements {
    /// The statements, which store results as they find them, and the matrix of all results at the end; nothing
    /// where that is not possible.
    pub fn filling(&self, results: &[TokenStream], columns: usize) -> Option<TokenStream> {
        let one = self.one.as_ref()?;
        let bound = self.steps.iter().zip(0_usize..);
        let bound = bound.flat_map(|((_, names), step)| names.iter().map(move |name| (name, step)));
        let bound: BTreeMap<&String, usize> = bound.collect();
        let matrix = ident(&self.names.clone().fresh("y"));

        let mut stores = vec![TokenStream::new(); self.steps.len()];
        let at_first = results.iter().enumerate().map(|(k, result)| {
            let Some(&step) = bound.get(&result.to_string()) else {
                return result;
            };
            let [row, column] = [k / columns, k % columns].map(Literal::usize_unsuffixed);
            stores[step].extend(quote! { #matrix[#row][#column] = #result; });
            // Not zero: what began as zeros alone would be cleared by a call for all of it, which takes longer
            // than the stores that this saves.
            one
        });
        let at_first: Vec<_> = at_first.collect();
        let rows = at_first.chunks(columns).map(|row| quote! { [#(#row),*] });
        let begun = quote! { let mut #matrix = [#(#rows),*]; };

        let first = stores.iter().position(|stores| !stores.is_empty())?;
        let steps = self.steps.iter().map(|(step, _)| step);
        let mut written: Vec<_> = steps
            .zip(stores)
            .map(|(step, stores)| quote! { #step #stores })
            .collect();
        written.insert(first, begun);
        let head = &self.head;
        Some(quote! { #head #(#written)* #matrix })
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use super::{Statements, columns};
    use crate::chain;
    use crate::description;
    use crate::error::Errors;
    use crate::function::Function;
    use crate::request::Request;
    use crate::schedule::Names;
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

    fn statements(one: Option<TokenStream>) -> Statements {
        let steps = [
            (quote! { let s = sine(q); }, vec!["s"]),
            (quote! { let a = s * q; }, vec!["a"]),
            (
                quote! { let [b, c] = { let d = a * a; [a * d, d * d] }; },
                vec!["b", "c"],
            ),
        ];
        let own = |names: Vec<&str>| names.into_iter().map(str::to_owned).collect();
        Statements {
            head: quote! { let k = constant; let [q] = *q; },
            steps: steps.map(|(step, names)| (step, own(names))).into(),
            names: Names::beside(&["q", "y"]),
            one,
        }
    }

    fn results() -> Vec<TokenStream> {
        ["k(0.0)", "a", "b", "q", "c", "a"]
            .map(|text| text.parse().expect("tokens"))
            .into()
    }

    #[test]
    fn what_is_found_is_stored_behind_the_statement_that_binds_it() {
        let filling = statements(Some(quote! { k(1.0) })).filling(&results(), 3);
        let expected = quote! {
            let k = constant;
            let [q] = *q;
            let s = sine(q);
            let mut y_ = [[k(0.0), k(1.0), k(1.0)], [q, k(1.0), k(1.0)]];
            let a = s * q;
            y_[0][1] = a;
            y_[1][2] = a;
            let [b, c] = { let d = a * a; [a * d, d * d] };
            y_[0][2] = b;
            y_[1][1] = c;
            y_
        };
        let filling = filling.expect("there is something to store");
        assert_eq!(filling.to_string(), expected.to_string());
    }

    #[test]
    fn nothing_is_stored_early_where_nothing_is_found_or_no_number_can_be_written() {
        let known = vec![quote! { k(0.0) }, quote! { q }];
        assert!(
            statements(Some(quote! { k(1.0) }))
                .filling(&known, 2)
                .is_none()
        );
        assert!(statements(None).filling(&results(), 3).is_none());
    }
}

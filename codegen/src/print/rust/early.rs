//! Large matrices that a function fills early.
//!
//! In: the results of a function, and the indices of those that its statements store. Out: the initial matrix, and the
//! stores of its entries.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// Matrix that is filled early.
pub(super) struct Filling {
    /// Name.
    pub matrix: Ident,
    /// Length of its rows.
    pub columns: usize,
}

impl Filling {
    /// Initial matrix with all results that are known from the start, and 1 for those that are stored later.
    ///
    /// The placeholder is not 0: compilers clear an array of zeros by a call, which takes longer than the stores that
    /// early filling saves.
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

    /// `y[1][2] = a;` for the result with this index.
    pub fn store(&self, result: usize, value: &TokenStream) -> TokenStream {
        let place = [result / self.columns, result % self.columns];
        let [row, column] = place.map(Literal::usize_unsuffixed);
        let matrix = &self.matrix;
        quote! { #matrix[#row][#column] = #value; }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::{format_ident, quote};

    use super::Filling;

    #[test]
    fn early_results_are_stored_and_the_rest_is_initial() {
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

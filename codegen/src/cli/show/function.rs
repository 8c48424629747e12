//! Functions as a page tells them.
//!
//! In: a listing and the layouts that its functions have. Out: of each function its name, what it
//! costs, how exact it is, in which layout its frames stand, and its code as it is printed, packed. It
//! never prints an operation itself.

use serde_json::{Value, json};

use super::packed::packed;
use super::shown;
use super::skeleton::Layouts;
use crate::cli::count::{have_signs, price};
use crate::print::rust::{Item, Source, World, each_method};
use crate::print::{Listed, Listing};
use crate::space::Variable;
use crate::wording::visible;

/// The functions of a listing.
pub(super) fn functions(listing: &Listing, layouts: &Layouts) -> Value {
    let item = Item::named_after(&listing.about.robot);
    let methods = each_method(listing, &item, &World::default());
    let signs = have_signs(&listing.functions);
    let functions = listing.functions.iter().zip(methods).zip(&layouts.of);
    let functions = functions.map(|((listed, method), layout)| {
        let code = Source::new("", &method).to_string();
        let arguments = listed.arguments(&listing.spaces);
        json!({
            "name": visible(&listed.name()),
            "of": listed.frame.as_deref().map(visible),
            "sentence": sentence(listing, listed),
            "arguments": arguments.into_iter().map(Variable::name).collect::<Value>(),
            "price": shown(price(listed, signs)),
            "layout": layout,
            "lines": code.lines().count(),
            "code": packed(&code),
        })
    });
    functions.collect()
}

/// What a function computes; of several together, what each of them does.
fn sentence(listing: &Listing, listed: &Listed) -> String {
    let about = &listing.about;
    let frame = listed.frame.as_deref().unwrap_or(&about.tip);
    let [base, frame] = [&about.base, frame].map(visible);
    let functions = listed.functions.iter();
    let sentences: Vec<String> = functions
        .map(|function| function.sentence(&base, &frame))
        .collect();
    sentences.join(" ")
}

//! What C sees of a robot: functions with C's calling convention, and the header that declares them.
//!
//! In: a [`Listing`] and how the names of the functions begin. Out: Rust functions around the
//! methods, and the text of a header with the same comments. Pointers become references to arrays of
//! fixed size, results go to memory that need not hold anything yet: there is nothing unsafe but the
//! promise that no other function has these names.

use std::fmt::Write;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::dialect::Dialect;
use super::documentation::{self, plain};
use super::item::is_array;
use super::method::{arguments, count, names};
use super::results::type_of;
use super::{Library, Listed, Listing};
use crate::function::{Function, Shape};
use crate::request::Real;

/// The functions, one for each method.
pub(super) fn functions(listing: &Listing, prefix: &str, dialect: &Dialect) -> TokenStream {
    let methods = listing.functions.iter().zip(names(listing));
    methods
        .map(|(listed, method)| function(listing, listed, &method, prefix, dialect))
        .collect()
}

fn function(
    listing: &Listing,
    listed: &Listed,
    method: &Ident,
    prefix: &str,
    dialect: &Dialect,
) -> TokenStream {
    let robot = &listing.item.ident;
    let number = &dialect.number;
    let joints = count(listing.about.joints.len());
    let arguments = arguments(&listed.functions);
    let arguments = arguments
        .iter()
        .map(|argument| format_ident!("{}", argument.name()));
    let arguments: Vec<_> = arguments.collect();
    let results = listed.functions.iter();
    let results: Vec<_> = results
        .map(|function| format_ident!("{}", function.name()))
        .collect();
    let types = listed.functions.iter();
    let types = types.map(|function| type_of(function.shape(), &joints, dialect));

    let (receiver, value) = if listing.parameters.is_empty() {
        (TokenStream::new(), quote! { #robot })
    } else {
        (quote! { robot: &#robot, }, quote! { robot })
    };
    let call = quote! { #value.#method(#(#arguments),*) };
    let body = match &*results {
        [result] => quote! { #result.write(#call); },
        results => {
            let values = results.iter().map(|result| format_ident!("{result}_"));
            let values: Vec<_> = values.collect();
            quote! {
                let (#(#values),*) = #call;
                #(#results.write(#values);)*
            }
        }
    };
    let about =
        format!(" [`{robot}::{method}`] for C, whose header tells what the pointers are to be.");
    let name = format_ident!("{prefix}{method}");
    quote! {
        #[doc = #about]
        #[allow(unsafe_code, reason = "the name is promised to be the only one of its kind")]
        #[unsafe(no_mangle)]
        pub extern "C" fn #name(
            #receiver
            #(#arguments: &[#number; #joints],)*
            #(#results: &mut ::core::mem::MaybeUninit<#types>,)*
        ) {
            #body
        }
    }
}

/// The header, where the library says how names begin.
#[must_use]
pub fn c_header(listing: &Listing, options: &str, library: &Library) -> Option<String> {
    let prefix = library.c_prefix.as_deref()?;
    let dialect = Dialect::of_core(listing, library);
    let number = match dialect.real {
        Real::F32 => "float",
        Real::F64 | Real::Generic => "double",
    };
    let mut head = documentation::head(listing, options);
    head.push(
        "No pointer may be null, and no result may overlap an argument or another result."
            .to_owned(),
    );
    let mut text = comment(&head);
    let guard = format!("HOMOGEN_{}{}_H", prefix, listing.item.ident).to_uppercase();
    let _ = writeln!(text, "#ifndef {guard}\n#define {guard}\n");
    text.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    structure(&mut text, listing, prefix, number);
    for (listed, method) in listing.functions.iter().zip(names(listing)) {
        text.push_str(&comment(&documentation::lines(listing, listed, &dialect)));
        let name = format!("{prefix}{method}");
        let _ = writeln!(
            text,
            "void {name}({});\n",
            parameters(listing, listed, prefix, number)
        );
    }
    text.push_str("#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    Some(text)
}

/// The struct, where it has fields.
fn structure(text: &mut String, listing: &Listing, prefix: &str, number: &str) {
    if listing.parameters.is_empty() {
        return;
    }
    text.push_str("typedef struct {\n");
    for parameter in &listing.parameters {
        let about = documentation::field(&parameter.target);
        let size = if is_array(&parameter.target) {
            "[3]"
        } else {
            ""
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "    {number} {}{size}; /* {} */",
            parameter.field,
            harmless(&about)
        );
    }
    let _ = writeln!(text, "}} {prefix}robot;\n");
}

/// `const float q[6], float gravity[6]`.
fn parameters(listing: &Listing, listed: &Listed, prefix: &str, number: &str) -> String {
    let joints = listing.about.joints.len();
    let robot = (!listing.parameters.is_empty()).then(|| format!("const {prefix}robot *robot"));
    let arguments = arguments(&listed.functions);
    let arguments = arguments
        .iter()
        .map(|argument| format!("const {number} {}[{joints}]", argument.name()));
    let results = listed.functions.iter();
    let results = results.map(|function| format!("{number} {}", declarator(*function, joints)));
    let all: Vec<_> = robot.into_iter().chain(arguments).chain(results).collect();
    all.join(", ")
}

/// `forward_kinematics[3][4]`.
fn declarator(function: Function, joints: usize) -> String {
    let size = match function.shape() {
        Shape::Pose | Shape::Acceleration => "[3][4]".to_owned(),
        Shape::Velocity => "[6]".to_owned(),
        Shape::Screws => format!("[{joints}][6]"),
        Shape::Vector => format!("[{joints}]"),
        Shape::Matrix => format!("[{joints}][{joints}]"),
    };
    format!("{}{size}", function.name())
}

fn comment(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| harmless(line)).collect();
    format!("/* {}\n */\n", lines.join("\n * ").replace(" \n", "\n"))
}

/// A text that does not end the comment around it.
fn harmless(text: &str) -> String {
    plain(text).replace("*/", "* /")
}

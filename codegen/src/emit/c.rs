//! What C sees of a robot: functions with C's calling convention, and the header that declares them.
//!
//! In: a [`Listing`] and how the names of the functions begin. Out: Rust functions around the
//! methods, and the text of a header with the same comments. Pointers become references to arrays of
//! fixed size, results go to memory that need not hold anything yet: there is nothing unsafe but the
//! promise that no other function has these names.

use std::collections::BTreeSet;
use std::fmt::Write;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::dialect::Dialect;
use super::documentation;
use super::item::is_array;
use super::lengths::Lengths;
use super::method::{arguments, names};
use super::names::{KEYWORDS as OF_RUST, unscoped};
use super::results::type_of;
use super::{Library, Listed, Listing};
use crate::function::Function;
use crate::real::Real;
use crate::space::Spaces;
use crate::wording::visible;

/// The functions, one for each method.
pub(super) fn functions(listing: &Listing, prefix: &str, dialect: &Dialect) -> TokenStream {
    let methods = listing.functions.iter().zip(names(listing));
    methods
        .zip(symbols(listing, prefix))
        .map(|((listed, method), symbol)| function(listing, listed, &method, &symbol, dialect))
        .collect()
}

fn function(
    listing: &Listing,
    listed: &Listed,
    method: &Ident,
    symbol: &str,
    dialect: &Dialect,
) -> TokenStream {
    let robot = &listing.item.ident;
    let number = &dialect.number;
    let lengths = Lengths::of_spaces(&listing.spaces);
    let arguments = arguments(&listed.functions);
    let each = arguments
        .iter()
        .map(|argument| lengths.of(argument.space()));
    let each: Vec<_> = each.collect();
    let arguments = arguments
        .iter()
        .map(|argument| format_ident!("{}", argument.name()));
    let arguments: Vec<_> = arguments.collect();
    let results = listed.functions.iter();
    let results: Vec<_> = results
        .map(|function| format_ident!("{}", function.name()))
        .collect();
    let types = listed.functions.iter();
    let types = types.map(|function| type_of(&function.result(), &lengths, dialect));

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
    let name = format_ident!("{symbol}");
    quote! {
        #[doc = #about]
        #[allow(unsafe_code, reason = "the name is promised to be the only one of its kind")]
        #[unsafe(no_mangle)]
        pub extern "C" fn #name(
            #receiver
            #(#arguments: &[#number; #each],)*
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
    let robot = ascii(&listing.item.ident.unraw().to_string());
    let guard = format!("HOMOGEN_{prefix}{robot}_H").to_uppercase();
    let _ = writeln!(text, "#ifndef {guard}\n#define {guard}\n");
    text.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
    structure(&mut text, listing, prefix, number);
    for (listed, name) in listing.functions.iter().zip(symbols(listing, prefix)) {
        text.push_str(&comment(&documentation::lines(listing, listed, &dialect)));
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
    let mut taken = BTreeSet::new();
    for parameter in &listing.parameters {
        let field = member(&parameter.field, &mut taken);
        let about = documentation::field(&parameter.target);
        let size = if is_array(&parameter.target) {
            "[3]"
        } else {
            ""
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "    {number} {field}{size}; /* {} */",
            harmless(&about)
        );
    }
    let _ = writeln!(text, "}} {prefix}robot;\n");
}

/// The names of the functions: those of the methods behind the prefix, in ASCII, without which there
/// is no `no_mangle`.
fn symbols(listing: &Listing, prefix: &str) -> Vec<String> {
    let mut names = unscoped();
    let listed = listing.functions.iter();
    listed
        .map(|listed| format!("{prefix}{}", names.fresh(&ascii(&listed.name()))))
        .collect()
}

/// What a field is called in C; only its place in the struct has to be that of Rust.
fn member(field: &Ident, taken: &mut BTreeSet<String>) -> String {
    let mut name = ascii(&field.unraw().to_string());
    while OF_RUST.contains(&name.as_str())
        || KEYWORDS.contains(&name.as_str())
        || taken.contains(&name)
    {
        name.push('_');
    }
    taken.insert(name.clone());
    name
}

/// The text with an underscore for every character that not every compiler takes in a name.
fn ascii(text: &str) -> String {
    text.replace(|letter: char| !letter.is_ascii(), "_")
}

/// Words that C or C++ reserves and Rust does not, and two that common compilers define.
#[rustfmt::skip]
const KEYWORDS: [&str; 78] = [
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "case",
    "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return",
    "co_yield", "compl", "concept", "const_cast", "consteval", "constexpr", "constinit",
    "decltype", "default", "delete", "double", "dynamic_cast", "explicit", "export", "float",
    "friend", "goto", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not",
    "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public", "register",
    "reinterpret_cast", "requires", "restrict", "short", "signed", "sizeof", "static_assert",
    "static_cast", "switch", "template", "this", "thread_local", "throw", "typedef", "typeid",
    "typename", "typeof_unqual", "unsigned", "using", "void", "volatile", "wchar_t", "xor", "xor_eq",
    "linux", "unix",
];

/// `const float q[6], float gravity[6]`.
fn parameters(listing: &Listing, listed: &Listed, prefix: &str, number: &str) -> String {
    let spaces = &listing.spaces;
    let robot = (!listing.parameters.is_empty()).then(|| format!("const {prefix}robot *robot"));
    let arguments = arguments(&listed.functions);
    let arguments = arguments
        .iter()
        .map(|argument| (argument.name(), spaces.len(argument.space())))
        .map(|(name, length)| format!("const {number} {name}[{length}]"));
    let results = listed.functions.iter();
    let results = results.map(|function| format!("{number} {}", declarator(*function, spaces)));
    let all: Vec<_> = robot.into_iter().chain(arguments).chain(results).collect();
    all.join(", ")
}

/// `forward_kinematics[3][4]`.
fn declarator(function: Function, spaces: &Spaces) -> String {
    let quantity = function.result();
    let lengths = quantity.lengths(spaces).into_iter();
    let lengths = lengths.chain(quantity.entity.dimensions().iter().copied());
    let sizes: Vec<String> = lengths.map(|length| format!("[{length}]")).collect();
    if sizes.is_empty() {
        format!("*{}", function.name())
    } else {
        format!("{}{}", function.name(), sizes.concat())
    }
}

fn comment(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| harmless(line)).collect();
    format!("/* {}\n */\n", lines.join("\n * ").replace(" \n", "\n"))
}

/// A text that neither ends the comment around it nor seems to begin another.
fn harmless(text: &str) -> String {
    visible(text).replace("*/", "* /").replace("/*", "/ *")
}

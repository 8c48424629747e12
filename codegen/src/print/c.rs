//! C: the header of functions that are written in another language.
//!
//! In: a [`Listing`] and what is known of those functions. Out: their names, and declarations with the
//! same comments as theirs. It never knows that language.

use std::fmt::Write;

use super::documentation::{self, Angles};
use super::{Listed, Listing};
use crate::function::Function;
use crate::real::Real;
use crate::schedule::Names;
use crate::space::Spaces;
use crate::wording::visible;

/// What a header tells besides what the listing does.
pub(super) struct Header<'a> {
    /// How the names of the functions begin.
    pub prefix: &'a str,
    /// What the robot's type is called where they are written.
    pub robot: &'a str,
    /// What was asked for.
    pub options: &'a str,
    /// For which angles they are precise.
    pub angles: &'a Angles,
}

impl Header<'_> {
    /// The text of the file.
    pub fn text(&self, listing: &Listing) -> String {
        let prefix = self.prefix;
        let number = match listing.scalar {
            Real::F32 => "float",
            Real::F64 | Real::Generic => "double",
        };
        let mut head = documentation::head(listing, self.options);
        head.push(
            "No pointer may be null, and no result may overlap an argument or another result."
                .to_owned(),
        );
        let mut text = comment(&head);
        let guard = format!("HOMOGEN_{prefix}{}_H", ascii(self.robot)).to_uppercase();
        let _ = writeln!(text, "#ifndef {guard}\n#define {guard}\n");
        text.push_str("#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n");
        structure(&mut text, listing, prefix, number);
        for (listed, name) in listing.functions.iter().zip(symbols(listing, prefix)) {
            let about = documentation::of_function(listing, listed, Some(self.angles));
            text.push_str(&comment(&about));
            let parameters = parameters(listing, listed, prefix, number);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "void {name}({parameters});\n");
        }
        text.push_str("#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
        text
    }
}

/// The struct, where it has fields.
fn structure(text: &mut String, listing: &Listing, prefix: &str, number: &str) {
    if listing.parameters.is_empty() {
        return;
    }
    text.push_str("typedef struct {\n");
    // What a field is called does not matter: only its place in the struct is that of its definition.
    let mut names = Names::beside(&KEYWORDS);
    for parameter in &listing.parameters {
        let field = names.alone(&ascii(&parameter.name()));
        let about = documentation::of_field(&parameter.target);
        let size = match parameter.target.entries() {
            1 => String::new(),
            entries => format!("[{entries}]"),
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

/// The names of the functions behind a prefix, in ASCII, which linkers want.
pub(super) fn symbols(listing: &Listing, prefix: &str) -> Vec<String> {
    let mut names = Names::default();
    let listed = listing.functions.iter();
    listed
        .map(|listed| format!("{prefix}{}", names.fresh(&ascii(&listed.name()))))
        .collect()
}

/// The text with an underscore for every character that not every compiler takes in a name.
fn ascii(text: &str) -> String {
    text.replace(|letter: char| !letter.is_ascii(), "_")
}

/// Words that C or C++ reserves, or Rust, which calls the fields alike; and two that common compilers
/// define.
#[rustfmt::skip]
const KEYWORDS: [&str; 131] = [
    "abstract", "alignas", "alignof", "and", "and_eq", "as", "asm", "async", "auto", "await",
    "become", "bitand", "bitor", "bool", "box", "break", "case", "catch", "char", "char16_t",
    "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "crate", "decltype",
    "default", "delete", "do", "double", "dyn", "dynamic_cast", "else", "enum", "explicit",
    "export", "extern", "false", "final", "float", "fn", "for", "friend", "gen", "goto", "if",
    "impl", "in", "inline", "int", "let", "long", "loop", "macro", "match", "mod", "move", "mut",
    "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or",
    "or_eq", "override", "priv", "private", "protected", "pub", "public", "ref", "register",
    "reinterpret_cast", "requires", "restrict", "return", "Self", "self", "short", "signed",
    "sizeof", "static", "static_assert", "static_cast", "struct", "super", "switch", "template",
    "this", "thread_local", "throw", "trait", "true", "try", "type", "typedef", "typeid",
    "typename", "typeof", "typeof_unqual", "union", "unsafe", "unsigned", "unsized", "use", "using",
    "virtual", "void", "volatile", "wchar_t", "where", "while", "xor", "xor_eq", "yield", "linux",
    "unix",
];

/// `const float q[6], float gravity[6]`.
fn parameters(listing: &Listing, listed: &Listed, prefix: &str, number: &str) -> String {
    let spaces = &listing.spaces;
    let robot = (!listing.parameters.is_empty()).then(|| format!("const {prefix}robot *robot"));
    let arguments = listed.arguments().into_iter();
    let arguments = arguments
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
    let lengths = [&*quantity.lengths(spaces), quantity.entity.dimensions()].concat();
    if lengths.is_empty() {
        return format!("*{}", function.name());
    }
    lengths
        .iter()
        .fold(function.name().to_owned(), |name, length| {
            format!("{name}[{length}]")
        })
}

fn comment(lines: &[String]) -> String {
    let lines: Vec<_> = lines.iter().map(|line| harmless(line)).collect();
    format!("/* {}\n */\n", lines.join("\n * ").replace(" \n", "\n"))
}

/// A text that neither ends the comment around it nor seems to begin another.
fn harmless(text: &str) -> String {
    visible(text).replace("*/", "* /").replace("/*", "/ *")
}

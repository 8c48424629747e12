//! Names of Python.
//!
//! In: texts. Out: reserved words, names of modules.

use super::standard;
use crate::schedule::{Names, sanitize};

/// Names of a new scope.
pub(in crate::print) fn unscoped() -> Names {
    Names::beside(&KEYWORDS)
}

/// Names of classes in a module, distinct from other names in its files.
pub(super) fn in_module(module: &str) -> Names {
    let mut names = unscoped();
    for own in OWN {
        names.take(own);
    }
    names.take(&format!("_{module}"));
    names
}

/// Text as the name of a module, in ASCII: `arm_py` for `Arm-Py`. `None` if it would hide NumPy.
///
/// The name of a standard module gets an underscore, since Python would import its own.
#[must_use]
pub fn module(text: &str) -> Option<String> {
    let name = sanitize(text).replace(|letter: char| !letter.is_ascii(), "_");
    let mut names = unscoped();
    for own in standard::MODULES {
        names.take(own);
    }
    let name = names.alone(&name);
    // Links and libraries need a letter first.
    let letter = if name.starts_with('_') { "n" } else { "" };
    (name != "numpy").then(|| format!("{letter}{name}"))
}

/// Other names in the files of a module.
const OWN: [&str; 13] = [
    "__all__",
    "__doc__",
    "__file__",
    "__name__",
    "__path__",
    "_ArrayLike",
    "_Final",
    "_NDArray",
    "_NamedTuple",
    "_np",
    "float",
    "int",
    "list",
];

/// Words that Python reserves: always, in places, or by custom.
const KEYWORDS: [&str; 39] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "case", "class",
    "continue", "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if",
    "import", "in", "is", "lambda", "match", "nonlocal", "not", "or", "pass", "raise", "return",
    "try", "type", "while", "with", "yield", "self",
];

#[cfg(test)]
mod tests {
    use super::module;

    #[test]
    fn modules_are_words_of_ascii() {
        let folders = [
            "arm_py", "Arm-Py", "class", "None", "__init__", "2nd", "机器", "a.b", "", "typing",
            "Test",
        ];
        let modules = folders.map(|folder| module(folder).expect("a name"));
        let wanted = [
            "arm_py", "arm_py", "class_", "none", "init", "n2nd", "n__", "a_b", "unnamed",
            "typing_", "test_",
        ];
        assert_eq!(modules, wanted);
        assert_eq!(module("NumPy"), None);
    }
}

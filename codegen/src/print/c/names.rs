//! Names of C.
//!
//! In: texts. Out: reserved words, prefixes, and names of functions, other definitions, members and entries of spaces.
//!
//! A name in a file is a prefix and a name of the generator, which begins with a letter and has no two adjacent
//! underscores. If both together could be the prefix of another robot and a longer name, as `mobile_base_regressor` of
//! the robots `mobile` and `mobile_base`, they are separated by a second underscore.

use std::fmt::Write;

use crate::function::Function;
use crate::module::Module;
use crate::schedule::{Names, sanitize};
use crate::space::{Space, Spaces};

/// Names of a new scope.
pub(super) fn unscoped() -> Names {
    Names::beside(&KEYWORDS)
}

/// Prefix of a robot: `double_pendulum_` for `double pendulum`. Letters beyond ASCII are replaced by their numbers, so
/// that robots whose names differ only by these can be linked together.
pub(super) fn prefix(robot: &str) -> String {
    let mut name = String::new();
    let mut after_letter = false;
    for letter in sanitize(robot).chars() {
        let is_letter = !letter.is_ascii();
        let between = is_letter || after_letter;
        if between && !name.is_empty() && !name.ends_with('_') && letter != '_' {
            name.push('_');
        }
        if is_letter {
            // Writing to a string cannot fail.
            let _ = write!(name, "u{:x}", u32::from(letter));
        } else {
            name.push(letter);
        }
        after_letter = is_letter;
    }
    name.push('_');
    name
}

/// Name in a file.
#[must_use]
pub fn own(prefix: &str, name: &str) -> String {
    joined(prefix, name, is_another(prefix, name, is_own))
}

/// Constant or macro in a file, in capitals.
pub(super) fn constant(prefix: &str, name: &str) -> String {
    // Macros that all files share begin with this prefix.
    let is_shared = prefix.eq_ignore_ascii_case("homogen_");
    let is_apart = is_shared || is_another(prefix, name, is_own_constant);
    joined(prefix, name, is_apart).to_uppercase()
}

fn joined(prefix: &str, name: &str, is_apart: bool) -> String {
    let between = if is_apart { "_" } else { "" };
    format!("{prefix}{between}{name}")
}

/// True if a prefix and a name could be another prefix and another name.
fn is_another(prefix: &str, name: &str, is_name: impl Fn(&str) -> bool) -> bool {
    let whole = format!("{prefix}{name}");
    let ends = prefix.match_indices('_').map(|(end, _)| end + 1);
    let mut within = ends.filter(|end| *end < prefix.len());
    within.any(|end| is_name(&whole[end..]))
}

/// Names of definitions that are not functions of the robot.
const OWN: [&str; 24] = [
    "acados_fun",
    "acados_fun_jac",
    "acados_fun_jac_hess",
    "acados_read",
    "acados_store",
    "base_parameters",
    "difference",
    "failures",
    "integrate",
    "neutral",
    "normalize",
    "prepare",
    "prepared",
    "robot",
    "self_test",
    "sin_cos",
    "sqrt",
    "stage",
    "stage_derivatives",
    "step",
    "step_along",
    "step_derivatives",
    "step_hessian",
    "turn",
];

/// True if the file of some robot has this name after its prefix.
fn is_own(name: &str) -> bool {
    let mut within = ["prepared_", "casadi_"].into_iter();
    let of_state = within.find_map(|within| name.strip_prefix(within));
    let of_state = of_state.unwrap_or(name);
    let goes_on =
        |rest: &str| rest.is_empty() || rest.starts_with("_and_") || rest.starts_with("_of_");
    let mut functions = Function::every();
    OWN.contains(&name)
        || functions.any(|function| of_state.strip_prefix(function.name()).is_some_and(goes_on))
}

/// The same for constants; entries may have any name.
fn is_own_constant(name: &str) -> bool {
    let mut spaces = ["q_", "v_", "c_"].into_iter();
    spaces.any(|space| name.to_ascii_lowercase().starts_with(space))
}

/// Names of the functions with a prefix, in ASCII for linkers.
pub(in crate::print) fn symbols(module: &Module, prefix: &str) -> Vec<String> {
    functions(module, |name| own(prefix, name))
}

/// The same for the functions of a prepared robot.
pub(super) fn prepared_symbols(module: &Module, prefix: &str) -> Vec<String> {
    functions(module, |name| own(prefix, &format!("prepared_{name}")))
}

fn functions(module: &Module, symbol: impl Fn(&str) -> String) -> Vec<String> {
    let mut names = Names::default();
    let functions = module.functions.iter();
    functions
        .map(|generated| symbol(&names.fresh(&ascii(&generated.name()))))
        .collect()
}

/// The text with an underscore for every character that some compilers reject in names.
pub(super) fn ascii(text: &str) -> String {
    text.replace(|letter: char| !letter.is_ascii(), "_")
}

/// Names of members, close to the preferred ones.
///
/// They avoid names that other headers may define: capitals, a leading underscore before a capital or another
/// underscore, and some words in small letters that headers of common platforms define.
pub(super) fn members(wishes: impl Iterator<Item = String>) -> Vec<String> {
    let mut names = unscoped();
    let members = wishes.map(|wish| {
        let mut member = ascii(&wish);
        if may_be_macro(&member) {
            member.push('_');
        }
        names.alone(&member)
    });
    members.collect()
}

fn may_be_macro(name: &str) -> bool {
    let mut letters = name.chars().filter(char::is_ascii_alphabetic);
    let many = letters.clone().nth(1).is_some() || name == "I";
    let in_capitals = many && letters.all(|letter| letter.is_ascii_uppercase());
    let reserved = name.strip_prefix('_').is_some_and(|rest| {
        rest.starts_with(|first: char| first == '_' || first.is_ascii_uppercase())
    });
    in_capitals || reserved || MACROS.contains(&name)
}

/// Names of the entries of a space after its letter, in capitals.
pub(super) fn constants(
    spaces: &Spaces,
    space: Space,
    (prefix, letter): (&str, &str),
) -> Vec<String> {
    let mut names = Names::default();
    let entries = spaces.names(space);
    entries
        .map(|name| constant(prefix, &format!("{letter}_{}", names.fresh(&ascii(name)))))
        .collect()
}

/// Words in small letters that headers of C, POSIX, Windows, Qt and AltiVec define, and compilers of some systems.
#[rustfmt::skip]
const MACROS: [&str; 28] = [
    "cdecl", "complex", "emit", "environ", "errno", "far", "foreach", "forever", "huge", "i386", "imaginary",
    "interface", "linux", "mips", "near", "noreturn", "pascal", "pixel", "signals", "slots", "small", "sparc",
    "stderr", "stdin", "stdout", "sun", "unix", "vector",
];

/// Reserved words of C, C++ and Rust, which has the same names for fields; two that common compilers define; and the
/// macros of the files.
#[rustfmt::skip]
const KEYWORDS: [&str; 140] = [
    "abstract", "alignas", "alignof", "and", "and_eq", "as", "asm", "async", "auto", "await",
    "become", "bitand", "bitor", "bool", "box", "break", "case", "catch", "char", "char16_t",
    "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "contract_assert", "crate", "decltype",
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
    "unix", "HOMOGEN_CLONES", "HOMOGEN_DISPATCH", "HOMOGEN_FMA", "HOMOGEN_FMAF", "HOMOGEN_FN", "_Bool", "_Complex", "_Imaginary",
];

#[cfg(test)]
mod tests {
    use super::{constant, members, own, prefix};

    #[test]
    fn names_begin_with_a_letter_and_are_ascii() {
        let robots = [
            ("double pendulum", "double_pendulum_"),
            ("UR5e", "ur5e_"),
            ("2nd", "n2nd_"),
            ("\u{6a5f}\u{5668}", "u6a5f_u5668_"),
            ("\u{624b}\u{81c2} 2", "u624b_u81c2_2_"),
            ("Kamera-\u{f6}se", "kamera_uf6_se_"),
            ("", "unnamed_"),
            ("*/", "unnamed_"),
        ];
        for (robot, begins) in robots {
            assert_eq!(prefix(robot), begins);
        }
    }

    /// If two robots are linked together, neither has a name of the other.
    #[test]
    fn ambiguous_names_get_a_second_underscore() {
        assert_eq!(own("mobile_", "base_regressor"), "mobile_base_regressor");
        assert_eq!(own("mobile_base_", "regressor"), "mobile_base__regressor");
        assert_eq!(own("mobile_base_", "gravity"), "mobile_base_gravity");
        assert_eq!(own("arm_prepared_", "bias"), "arm_prepared__bias");
        assert_eq!(
            own("arm_constrained_", "forward_dynamics"),
            "arm_constrained__forward_dynamics"
        );
        assert_eq!(own("base_", "regressor"), "base_regressor");
        assert_eq!(constant("arm_", "q_nq"), "ARM_Q_NQ");
        assert_eq!(constant("arm_q_", "nq"), "ARM_Q__NQ");
        assert_eq!(constant("homogen_", "q_h"), "HOMOGEN__Q_H");
    }

    #[test]
    fn members_avoid_macros() {
        let wishes = [
            "payload", "G", "I", "EOF", "M_PI", "unix", "near", "_Payload", "__FILE__", "int",
            "int_",
        ];
        let found = members(wishes.map(str::to_owned).into_iter());
        let names = [
            "payload",
            "G",
            "I_",
            "EOF_",
            "M_PI_",
            "unix_",
            "near_",
            "_Payload_",
            "__FILE___",
            "int_",
            "int__",
        ];
        assert_eq!(found, names);
    }
}

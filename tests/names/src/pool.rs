//! Random names for robots, links, joints, frames, loops and fields.
//!
//! In: a random number. Out: words of the field, keywords of Rust, C, C++ and Python, macros of their headers,
//! identifiers of generated files, other alphabets, names that begin with digits or signs, and combinations of these.

use homogen_random::Random;

/// Common names, in the spellings that people use.
const PLAIN: [&str; 28] = [
    "robot",
    "Robot",
    "my_robot",
    "ur5_robot",
    "robot arm",
    "ROBOT",
    "ROBOT_",
    "robot_robot",
    "arm",
    "Arm",
    "left arm",
    "base",
    "base_link",
    "mobile",
    "mobile_base",
    "world",
    "root",
    "tool0",
    "ee_link",
    "panda_hand_tcp",
    "joint_1",
    "q1",
    "j1",
    "x",
    "Elbow-Flexion",
    "unnamed",
    "homogen",
    "hip.pitch",
];

/// Keywords of any edition or standard.
const KEYWORDS: [&str; 66] = [
    "fn",
    "gen",
    "try",
    "async",
    "await",
    "dyn",
    "union",
    "self",
    "Self",
    "super",
    "crate",
    "type",
    "match",
    "yield",
    "abstract",
    "macro",
    "typeof",
    "raw",
    "static",
    "loop",
    "where",
    "int",
    "double",
    "float",
    "register",
    "restrict",
    "_Bool",
    "_Complex",
    "inline",
    "typeof_unqual",
    "constexpr",
    "nullptr",
    "bool",
    "and",
    "or",
    "xor",
    "not_eq",
    "class",
    "template",
    "typename",
    "namespace",
    "requires",
    "concept",
    "co_await",
    "char8_t",
    "this",
    "operator",
    "contract_assert",
    "None",
    "True",
    "lambda",
    "def",
    "pass",
    "import",
    "global",
    "nonlocal",
    "case",
    "print",
    "list",
    "str",
    "object",
    "__init__",
    "__doc__",
    "__all__",
    "NamedTuple",
    "numpy",
];

/// Macros and types of headers and preludes.
const MACROS: [&str; 44] = [
    "I",
    "unix",
    "linux",
    "M_PI",
    "NULL",
    "EOF",
    "errno",
    "near",
    "far",
    "small",
    "interface",
    "complex",
    "signals",
    "stdin",
    "INFINITY",
    "NAN",
    "FLT_RADIX",
    "DBL_MAX",
    "INT_MAX",
    "UINT64_C",
    "HUGE_VAL",
    "SIGINT",
    "assert",
    "min",
    "f64",
    "f32",
    "usize",
    "u64",
    "Option",
    "Iterator",
    "Copy",
    "Clone",
    "Debug",
    "core",
    "std",
    "typing",
    "test",
    "math",
    "platform",
    "float64",
    "property",
    "__FILE__",
    "_Payload",
    "sqrt",
];

/// Names in generated files.
const OWN: [&str; 64] = [
    "q",
    "qd",
    "qdd",
    "tau",
    "k",
    "mul_add",
    "sines",
    "cosines",
    "angles",
    "turn",
    "turn_1",
    "sin_cos",
    "MUL_ADD",
    "ROBOT_MUL_ADD",
    "APART",
    "near",
    "found",
    "entry",
    "expected",
    "tolerances",
    "off",
    "failures",
    "self_test",
    "off_by",
    "count",
    "prepared",
    "prepare",
    "values",
    "T",
    "number",
    "action",
    "results",
    "angle",
    "quadrant",
    "r",
    "z",
    "half",
    "low",
    "sine",
    "cosine",
    "SINE",
    "ROUND",
    "shifted",
    "gravity",
    "bias",
    "mass_matrix",
    "regressor",
    "base_regressor",
    "constrained",
    "constrained_forward_dynamics",
    "centroidal",
    "actuated",
    "center_of_mass",
    "vectors",
    "Prepared",
    "work",
    "y",
    "t_1",
    "q_1",
    "w_0_1_in_1_z",
    "chain",
    "new",
    "py",
    "out",
];

/// Other alphabets, leading signs and digits, and names that differ only in letters that many identifiers cannot have.
const STRANGE: [&str; 34] = [
    "2nd",
    "6dof",
    "007",
    "_x",
    "__x",
    "x_",
    "_",
    "-",
    "*/",
    "/*",
    "//",
    "\"",
    "'",
    "\\",
    "a b",
    "a-b",
    "a.b",
    "a/b",
    "机器人",
    "手臂",
    "机器",
    "ロボット",
    "로봇",
    "Kamera-öse",
    "Kamera-ose",
    "ÄRM",
    "ärm",
    "çelik",
    "рука",
    "ﬁ",
    "é",
    "e\u{301}",
    "x²",
    "🤖",
];

/// A random name.
pub fn name(random: &mut Random) -> String {
    let of = |random: &mut Random| -> String {
        let list: &[&str] = match random.below(5) {
            0 => &PLAIN,
            1 => &KEYWORDS,
            2 => &MACROS,
            3 => &OWN,
            _ => &STRANGE,
        };
        (*random.choose(list)).to_owned()
    };
    let first = of(random);
    match random.below(8) {
        0 => format!(
            "{first}{}{}",
            random.choose(&["_", " ", "-", "."]),
            of(random)
        ),
        1 => format!(
            "{}{first}",
            random.choose(&["my_", "robot_", "_", "2", "new "])
        ),
        2 => format!(
            "{first}{}",
            random.choose(&["_robot", "_2", "2", "_", " base", "_q", "_v"])
        ),
        3 => first.to_uppercase(),
        4 if random.chance(8) => first.repeat(40),
        _ => first,
    }
}

/// A random name that the command line accepts for a field or a struct.
pub fn identifier(random: &mut Random) -> String {
    loop {
        let name = name(random);
        let is_word = |letter: char| letter == '_' || letter.is_alphanumeric();
        let begins = |first: char| first == '_' || first.is_alphabetic();
        let normal = name.is_ascii() || ["ärm", "機", "Öse"].contains(&&*name);
        if name == "_" || !normal || !name.chars().all(is_word) || !name.starts_with(begins) {
            continue;
        }
        // Words that any edition reserves are written raw; these four cannot be.
        if ["self", "Self", "super", "crate"].contains(&&*name) {
            continue;
        }
        return if is_reserved(&name) {
            format!("r#{name}")
        } else {
            name
        };
    }
}

/// True if an edition of Rust reserves the word.
fn is_reserved(name: &str) -> bool {
    const RESERVED: [&str; 21] = [
        "fn", "try", "async", "await", "dyn", "type", "match", "yield", "abstract", "macro",
        "typeof", "static", "loop", "where", "as", "do", "final", "move", "mut", "pub", "ref",
    ];
    RESERVED.contains(&name)
}

//! Symbols and instructions of the firmware's image.
//!
//! In: its symbols by `nm --demangle --print-size`, and its instructions by `objdump --disassemble --demangle`. Out: size
//! and number of instructions of each function of the controller, and an error for each forbidden symbol and
//! instruction.

use std::collections::BTreeMap;

/// Symbols of images that can panic, allocate, or call through a table.
const FORBIDDEN: [(&str, &str); 8] = [
    ("panicking", "a path that panics"),
    ("unwrap_failed", "a path that panics"),
    ("begin_unwind", "a path that panics"),
    ("__rust_alloc", "an allocator"),
    ("malloc", "an allocator"),
    ("vtable", "dynamic dispatch"),
    ("core::fmt", "dynamic dispatch"),
    ("__aeabi_d", "arithmetic in double precision"),
];

/// A function of the controller.
#[derive(Debug, Default)]
pub struct Function {
    /// Bytes of its instructions and constants.
    pub bytes: u32,
    /// Number of its instructions.
    pub instructions: u32,
    /// Functions of the controller that it calls, one for each call.
    pub calls: Vec<String>,
}

/// The functions of the controller, by name.
pub type Functions = BTreeMap<String, Function>;

/// Number of instructions of a call, with those of the functions that it calls.
pub fn instructions(functions: &Functions, name: &str) -> u32 {
    functions.get(name).map_or(0, |function| {
        let called = function
            .calls
            .iter()
            .map(|called| instructions(functions, called));
        function.instructions + called.sum::<u32>()
    })
}

/// Reads an image; its errors are appended to `wrong`.
pub fn read(symbols: &str, code: &str, wrong: &mut Vec<String>) -> Functions {
    let mut functions = Functions::new();
    for line in symbols.lines() {
        read_symbol(line, &mut functions, wrong);
    }
    let mut inside = "";
    for line in code.lines() {
        if let Some((_, name)) = line
            .strip_suffix(">:")
            .and_then(|line| line.split_once('<'))
        {
            inside = name;
        } else if let Some(instruction) = Instruction::read(line) {
            instruction.judge(inside, wrong);
            if let Some(function) = functions.get_mut(short(inside).unwrap_or_default()) {
                instruction.count(inside, function, wrong);
            }
        }
    }
    functions
}

/// `00000abc 00000123 T controller::control::gravity`.
fn read_symbol(line: &str, functions: &mut Functions, wrong: &mut Vec<String>) {
    for (part, meaning) in FORBIDDEN {
        if line.contains(part) {
            wrong.push(format!("{meaning}: symbol `{line}`"));
        }
    }
    let name = line.splitn(4, ' ').nth(3).unwrap_or_default();
    if is_double(name) {
        wrong.push(format!("arithmetic in double precision: symbol `{line}`"));
    }
    let bytes = line
        .split(' ')
        .nth(1)
        .and_then(|size| u32::from_str_radix(size, 16).ok());
    if let (Some(name), Some(bytes)) = (short(name), bytes) {
        let known = functions.entry(name.to_owned()).or_default();
        known.bytes = bytes;
    }
}

/// `__adddf3`, `__extendsfdf2` and the other routines that a compiler calls for f64.
fn is_double(name: &str) -> bool {
    name.starts_with("__")
        && (name.ends_with("df2") || name.ends_with("df3") || name.contains("2d"))
}

/// The short name of a function of the library: `gravity` for `controller::control::gravity` or `arm_gravity` in C, and
/// `sin_cos` of the generated file. `None` for functions of the measurement.
fn short(name: &str) -> Option<&str> {
    // Compilers write the last one in two ways.
    let prefixes = [
        "arm_",
        "controller::control::",
        "controller::arm::Arm::",
        "<controller::arm::Arm>::",
    ];
    let mut names = prefixes
        .iter()
        .filter_map(|prefix| name.strip_prefix(prefix));
    names.next().filter(|name| !name.contains(':'))
}

/// One line of a disassembly.
struct Instruction<'a> {
    line: &'a str,
    mnemonic: &'a str,
    operands: &'a str,
}

impl<'a> Instruction<'a> {
    /// ` 412:\tee30 0a20 \tvadd.f32\ts0, s0, s1`; not data, which begins with a point.
    fn read(line: &'a str) -> Option<Self> {
        let mut parts = line.trim().split('\t').skip(2);
        let mnemonic = parts.next()?.trim();
        let operands = parts.next().unwrap_or_default();
        let data = mnemonic.starts_with('.') || mnemonic.is_empty();
        (!data).then_some(Self {
            line,
            mnemonic,
            operands,
        })
    }

    /// Adds an error if the instruction is forbidden in every function of the image.
    fn judge(&self, inside: &str, wrong: &mut Vec<String>) {
        if self.mnemonic.contains(".f64") {
            let line = self.line.trim();
            wrong.push(format!(
                "arithmetic in double precision in `{inside}`: {line}"
            ));
        }
        if self.mnemonic.starts_with("blx") {
            let line = self.line.trim();
            wrong.push(format!(
                "a call of an unknown function in `{inside}`: {line}"
            ));
        }
    }

    /// The function of the controller in an operand such as `5d0 <controller::sines::sin_cos>`.
    fn called(&self) -> Option<&str> {
        let (_, name) = self.operands.split_once('<')?;
        short(name.strip_suffix('>')?)
    }

    /// True if the operand is a later address in the function.
    fn is_forward_in(&self, inside: &str) -> bool {
        let place = self.line.trim().split(':').next().unwrap_or_default();
        let (to, name) = self.operands.split_once(' ').unwrap_or_default();
        let [from, to] = [place, to].map(|text| u32::from_str_radix(text, 16));
        let inside = name.trim_start_matches('<').strip_prefix(inside);
        inside.is_some_and(|rest| rest.starts_with('+'))
            && matches!((from, to), (Ok(from), Ok(to)) if to > from)
    }

    /// Counts the instruction; a function of the controller may only compute and call others.
    fn count(&self, inside: &str, function: &mut Function, wrong: &mut Vec<String>) {
        if self.mnemonic == "nop" {
            return; // after the function's return, before its constants
        }
        function.instructions += 1;
        let branches = self.mnemonic.starts_with('b') || self.mnemonic.starts_with("cb");
        let bits = ["bfi", "bfc", "bic"]
            .iter()
            .any(|bits| self.mnemonic.starts_with(bits));
        let returns = self.mnemonic == "bx" && self.operands == "lr";
        // A forward jump over constants among the instructions.
        let skips = ["b.n", "b.w"].contains(&self.mnemonic) && self.is_forward_in(inside);
        if !branches || bits || returns || skips {
        } else if let ("bl", Some(called)) = (self.mnemonic, self.called()) {
            function.calls.push(called.to_owned());
        } else {
            wrong.push(format!("a branch in `{inside}`: {}", self.line.trim()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::read;

    fn wrong(symbols: &str, code: &str) -> Vec<String> {
        let mut wrong = Vec::new();
        read(symbols, code, &mut wrong);
        wrong
    }

    #[test]
    fn a_clean_function_is_counted() {
        let symbols = "00000400 00000010 T controller::control::gravity\n";
        let code = "00000400 <controller::control::gravity>:\n \
                    400:\tb510      \tpush\t{r4, lr}\n \
                    402:\tf000 f8e5 \tbl\t5d0 <<controller::arm::Arm>::sin_cos>\n \
                    406:\tee30 0a20 \tvadd.f32\ts0, s0, s1\n \
                    40a:\tbd10      \tpop\t{r4, pc}\n \
                    40c:\t3f800000 \t.word\t0x3f800000\n";
        let mut wrong = Vec::new();
        let functions = read(symbols, code, &mut wrong);
        let gravity = &functions["gravity"];
        assert_eq!((gravity.bytes, gravity.instructions), (16, 4));
        assert_eq!(gravity.calls, ["sin_cos"]);
        assert_eq!(wrong, Vec::<String>::new());
    }

    #[test]
    fn forbidden_symbols_and_instructions_are_errors() {
        for symbol in [
            "core::panicking::panic_fmt",
            "__aeabi_dmul",
            "__extendsfdf2",
            "__aeabi_f2d",
            "__rust_alloc",
        ] {
            let symbols = format!("00000400 00000010 T {symbol}\n");
            assert_eq!(wrong(&symbols, "").len(), 1, "{symbol}");
        }
        for instruction in [
            "vadd.f64\td0, d0, d1",
            "blx\tr3",
            "bne.n\t412 <x>",
            "cbz\tr0, 412 <x>",
        ] {
            let symbols = "00000400 00000010 T controller::control::gravity\n";
            let code =
                format!("00000400 <controller::control::gravity>:\n 400:\tb510 \t{instruction}\n");
            assert!(!wrong(symbols, &code).is_empty(), "{instruction}");
        }
    }
}

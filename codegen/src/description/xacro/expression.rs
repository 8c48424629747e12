//! Expressions of xacro: `${…}`.
//!
//! The language is the part of Python's expressions that descriptions of robots use. An expression is evaluated by
//! walking its tree: nothing is executed, and nothing outside the expansion is reachable.
//!
//! ```text
//! expression  = or ["if" or "else" expression]
//! or          = and {"or" and}
//! and         = not {"and" not}
//! not         = "not" not | comparison
//! comparison  = sum {("==" | "!=" | "<" | "<=" | ">" | ">=" | ["not"] "in" | "is" ["not"]) sum}
//! sum         = product {("+" | "-") product}
//! product     = sign {("*" | "/" | "//" | "%") sign}
//! sign        = ("+" | "-") sign | power
//! power       = operand ["**" sign]
//! operand     = atom {"." name | "[" index "]" | "(" [arguments] ")"}
//! index       = expression | [expression] ":" [expression] [":" [expression]]
//! arguments   = argument {"," argument}
//! argument    = [name "="] expression | comprehension
//! atom        = number | text {text} | name | "None" | "True" | "False"
//!             | "(" [expression {"," expression}] ")" | "[" [expression {"," expression}] "]" | "[" comprehension "]"
//! comprehension = expression {"for" name {"," name} "in" or {"if" or}}
//! ```

mod call;
mod elementary;
mod evaluate;
pub(super) mod function;
mod method;
mod operator;
pub(super) mod parse;
pub(super) mod surroundings;
mod token;
mod tree;
pub(super) mod value;

pub(super) use self::evaluate::evaluate;

#[cfg(test)]
mod tests;

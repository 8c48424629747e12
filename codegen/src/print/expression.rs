//! Expressions: operations in infix notation, with parentheses only where the order of operations needs them.
//!
//! In: an operation, whose operands may be operations again. Out: its text in a language with the usual precedence:
//! signs before products, products before sums, and otherwise from left to right.

use crate::schedule::{Operation, Value};

/// Text with infix notation.
pub(super) trait Text: Clone {
    /// A natural number.
    fn natural(number: usize) -> Self;

    /// a ∘ b.
    fn infix(&self, symbol: Infix, b: &Self) -> Self;

    /// −a.
    fn negative(&self) -> Self;

    /// (a).
    fn in_parentheses(&self) -> Self;
}

/// Spelling of operations in a language.
pub(super) trait Spelling {
    /// Text of an expression.
    type Text: Text;

    /// A value; an operation as a whole expression.
    fn read(&self, value: &Value) -> Self::Text;

    /// √a, of a whole expression.
    fn root(&self, a: &Self::Text) -> Self::Text;

    /// The sign of a, which the text may contain twice.
    fn sign(&self, a: &Self::Text) -> Self::Text;

    /// a b + c, rounded once, of these whole expressions; `None` in languages and files without it.
    fn fused(&self, _: impl FnOnce() -> [Self::Text; 3]) -> Option<Self::Text> {
        None
    }
}

/// Symbol between two operands.
#[derive(Clone, Copy)]
pub(super) enum Infix {
    Add,
    Sub,
    Mul,
    Div,
}

impl Infix {
    /// The symbol.
    pub fn letter(self) -> char {
        match self {
            Self::Add => '+',
            Self::Sub => '-',
            Self::Mul => '*',
            Self::Div => '/',
        }
    }
}

impl Text for String {
    fn natural(number: usize) -> Self {
        number.to_string()
    }

    fn infix(&self, symbol: Infix, b: &Self) -> Self {
        format!("{self} {} {b}", symbol.letter())
    }

    /// In parentheses where two signs would follow each other.
    fn negative(&self) -> Self {
        if self.starts_with('-') {
            format!("-({self})")
        } else {
            format!("-{self}")
        }
    }

    fn in_parentheses(&self) -> Self {
        format!("({self})")
    }
}

/// `3 + row + 6 * k`: a sum of a number and multiples of indices, at least one, without zeros and ones.
pub(super) fn subscript<T: Text>(first: usize, terms: &[(usize, &T)]) -> T {
    let multiples = terms.iter().map(|&(factor, index)| match factor {
        1 => index.clone(),
        _ => T::natural(factor).infix(Infix::Mul, index),
    });
    let first = (first > 0).then(|| T::natural(first));
    let sum = first.into_iter().chain(multiples);
    sum.reduce(|a, b| a.infix(Infix::Add, &b))
        .expect("at least one index")
}

/// Precedence of the symbols of an expression, from the loosest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// An operation as a whole expression.
pub(super) fn spelled<S: Spelling>(language: &S, operation: &Operation<Value>) -> S::Text {
    expression(language, operation).0
}

/// The same, and how tightly it binds.
fn expression<S: Spelling>(language: &S, operation: &Operation<Value>) -> (S::Text, Binding) {
    let whole = |value| language.read(value);
    let operand = |value, least| operand(language, value, least);
    let negative = |a| operand(a, Binding::Atom).negative();
    let sum = |a, symbol, b| {
        let [a, b] = [operand(a, Binding::Sum), operand(b, Binding::Product)];
        (a.infix(symbol, &b), Binding::Sum)
    };
    let product = |a, symbol, b| {
        let [a, b] = [operand(a, Binding::Product), operand(b, Binding::Sign)];
        (a.infix(symbol, &b), Binding::Product)
    };
    // a b ± c
    let product_and_sum = |a, b, symbol, c| {
        let (product, c) = (product(a, Infix::Mul, b).0, operand(c, Binding::Product));
        (product.infix(symbol, &c), Binding::Sum)
    };
    let atom = |text| (text, Binding::Atom);
    match operation {
        Operation::Add(a, b) => sum(a, Infix::Add, b),
        Operation::Sub(a, b) => sum(a, Infix::Sub, b),
        Operation::Mul(a, b) => product(a, Infix::Mul, b),
        Operation::Div(a, b) => product(a, Infix::Div, b),
        Operation::Neg(a) => (negative(a), Binding::Sign),
        Operation::Sqrt(a) => atom(language.root(&whole(a))),
        // It may begin with a conversion, which binds like a sign.
        Operation::Sign(a) => (language.sign(&operand(a, Binding::Atom)), Binding::Sign),
        Operation::MulAdd(a, b, c) => {
            let fused = language.fused(|| [whole(a), whole(b), whole(c)]);
            fused.map_or_else(|| product_and_sum(a, b, Infix::Add, c), atom)
        }
        Operation::MulSub(a, b, c) => {
            let fused = language.fused(|| [whole(a), whole(b), negative(c)]);
            fused.map_or_else(|| product_and_sum(a, b, Infix::Sub, c), atom)
        }
        Operation::NegMulAdd(a, b, c) => {
            let fused = language.fused(|| [negative(a), whole(b), whole(c)]);
            let unfused = || {
                let (product, c) = (product(a, Infix::Mul, b).0, operand(c, Binding::Sum));
                (c.infix(Infix::Sub, &product), Binding::Sum)
            };
            fused.map_or_else(unfused, atom)
        }
    }
}

/// A value as an operand of symbols that bind as tightly as `least`.
fn operand<S: Spelling>(language: &S, value: &Value, least: Binding) -> S::Text {
    let Value::Operation(operation) = value else {
        return language.read(value);
    };
    let (text, binding) = expression(language, operation);
    if binding < least {
        text.in_parentheses()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use homogen_random::Random;
    use syn::{BinOp, Expr, Lit, UnOp};

    use super::{Spelling, spelled, subscript};
    use crate::schedule::{Operation, Value};

    /// Spelling of Rust with names of numbers, and with a function for fused products or without.
    struct Plain {
        fuses: bool,
    }

    impl Spelling for Plain {
        type Text = String;

        fn read(&self, value: &Value) -> String {
            match value {
                Value::Literal(value) => format!("{value:?}"),
                Value::Operation(operation) => spelled(self, operation),
                _ => unreachable!("no other values"),
            }
        }

        fn root(&self, a: &String) -> String {
            format!("sqrt({a})")
        }

        fn sign(&self, a: &String) -> String {
            format!("-sign({a}, {a})")
        }

        fn fused(&self, operands: impl FnOnce() -> [String; 3]) -> Option<String> {
            self.fuses
                .then(|| format!("fused({})", operands().join(", ")))
        }
    }

    fn computed(operation: &Operation<Value>) -> f64 {
        let value = |value: Value| match value {
            Value::Literal(value) => value,
            Value::Operation(operation) => computed(&operation),
            _ => unreachable!("no other values"),
        };
        match operation.clone().map(value) {
            Operation::Add(a, b) => a + b,
            Operation::Sub(a, b) => a - b,
            Operation::Mul(a, b) => a * b,
            Operation::Div(a, b) => a / b,
            Operation::Sqrt(a) => a.abs().sqrt(),
            Operation::Sign(a) => -a.signum(),
            Operation::Neg(a) => -a,
            Operation::MulAdd(a, b, c) => a * b + c,
            Operation::MulSub(a, b, c) => a * b - c,
            Operation::NegMulAdd(a, b, c) => c - a * b,
        }
    }

    /// Value of a text of Rust.
    fn parsed(text: &Expr) -> f64 {
        match text {
            Expr::Lit(of) => match &of.lit {
                Lit::Float(value) => value.base10_parse().expect("a number"),
                _ => unreachable!("all literals have fractions"),
            },
            Expr::Paren(inside) => parsed(&inside.expr),
            Expr::Unary(of) => {
                assert!(matches!(of.op, UnOp::Neg(_)));
                -parsed(&of.expr)
            }
            Expr::Binary(of) => {
                let [a, b] = [&of.left, &of.right].map(|side| parsed(side));
                match of.op {
                    BinOp::Add(_) => a + b,
                    BinOp::Sub(_) => a - b,
                    BinOp::Mul(_) => a * b,
                    BinOp::Div(_) => a / b,
                    _ => unreachable!("no other symbols"),
                }
            }
            Expr::Call(of) => match &*of.args.iter().map(parsed).collect::<Vec<_>>() {
                [a] => a.abs().sqrt(),
                [a, _] => a.signum(),
                [a, b, c] => a * b + c,
                _ => unreachable!("no other functions"),
            },
            _ => unreachable!("no other expressions"),
        }
    }

    /// Random operation with others inside, up to a depth.
    fn operation(random: &mut Random, depth: u32) -> Operation<Value> {
        let kind = random.below(10);
        let mut value = || match depth {
            0 => Value::Literal(1.0 + random.unit()),
            _ if random.chance(3) => Value::Literal(1.5),
            _ => Value::Operation(Box::new(operation(random, depth - 1))),
        };
        match kind {
            0 => Operation::Add(value(), value()),
            1 => Operation::Sub(value(), value()),
            2 => Operation::Mul(value(), value()),
            3 => Operation::Div(value(), value()),
            4 => Operation::Sqrt(value()),
            5 => Operation::Sign(value()),
            6 => Operation::Neg(value()),
            7 => Operation::MulAdd(value(), value(), value()),
            8 => Operation::MulSub(value(), value(), value()),
            _ => Operation::NegMulAdd(value(), value(), value()),
        }
    }

    #[test]
    fn an_expression_is_read_as_it_was_written() {
        let mut random = Random::new(11);
        for _ in 0..2000 {
            let operation = operation(&mut random, 3);
            for fuses in [false, true] {
                let text = spelled(&Plain { fuses }, &operation);
                let read = syn::parse_str(&text).expect("an expression");
                let [found, expected] = [parsed(&read), computed(&operation)];
                let is_same = found.to_bits() == expected.to_bits();
                assert!(is_same || found.is_nan() && expected.is_nan(), "{text}");
            }
        }
    }

    #[test]
    fn subscripts_are_sums_without_zeros_and_ones() {
        let [row, k] = ["row", "k"].map(str::to_owned);
        assert_eq!(subscript(0, &[(1, &k)]), "k");
        assert_eq!(subscript(3, &[(1, &row), (6, &k)]), "3 + row + 6 * k");
    }

    #[test]
    fn parentheses_are_where_the_order_needs_them() {
        let number = Value::Literal;
        let inside = |operation| Value::Operation(Box::new(operation));
        let sum = || inside(Operation::Add(number(1.0), number(2.0)));
        let product = || inside(Operation::Mul(number(3.0), number(4.0)));
        let negative = || inside(Operation::Neg(number(5.0)));
        let cases = [
            (Operation::Add(sum(), product()), "1.0 + 2.0 + 3.0 * 4.0"),
            (Operation::Sub(product(), sum()), "3.0 * 4.0 - (1.0 + 2.0)"),
            (Operation::Mul(product(), sum()), "3.0 * 4.0 * (1.0 + 2.0)"),
            (
                Operation::Div(sum(), product()),
                "(1.0 + 2.0) / (3.0 * 4.0)",
            ),
            (Operation::Mul(negative(), negative()), "-5.0 * -5.0"),
            (Operation::Neg(product()), "-(3.0 * 4.0)"),
            (Operation::Sqrt(sum()), "sqrt(1.0 + 2.0)"),
            (
                Operation::MulSub(sum(), number(1.0), product()),
                "(1.0 + 2.0) * 1.0 - 3.0 * 4.0",
            ),
            (
                Operation::NegMulAdd(product(), number(1.0), sum()),
                "1.0 + 2.0 - 3.0 * 4.0 * 1.0",
            ),
        ];
        for (operation, text) in cases {
            assert_eq!(spelled(&Plain { fuses: false }, &operation), text);
        }
        let fused = Operation::NegMulAdd(sum(), product(), negative());
        let text = "fused(-(1.0 + 2.0), 3.0 * 4.0, -5.0)";
        assert_eq!(spelled(&Plain { fuses: true }, &fused), text);
    }
}

//! Parses an expression into a tree.

use std::rc::Rc;

use super::token::{Token, tokens};
use super::tree::{Binary, Comparison, Each, Expression, Unary};
use super::value::Value;
use crate::description::xacro::failure::{Failure, failure, failure_with_hint};
use crate::wording::quoted;

/// Maximum number of operations and values of an expression.
const MOST_PARTS: usize = 400;

/// Maximum depth of operations in operations.
const MOST_NESTED: usize = 40;

/// Words that are no names.
const KEYWORDS: [&str; 35] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue",
    "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import",
    "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while",
    "with", "yield",
];

/// Strength of operators: a stronger one binds first.
const OR: u8 = 1;
const AND: u8 = 2;
const NOT: u8 = 3;
const COMPARISON: u8 = 4;
const SUM: u8 = 5;
const PRODUCT: u8 = 6;
const SIGN: u8 = 7;
const POWER: u8 = 8;

/// Parses a whole text.
pub(in crate::description::xacro) fn parse(text: &str) -> Result<Expression, Failure> {
    let mut parser = Parser {
        tokens: tokens(text)?,
        at: 0,
        parts: 0,
        depth: 0,
    };
    if parser.tokens.is_empty() {
        return Err(failure("the expression is empty"));
    }
    let expression = parser.items_or_one(None)?;
    match parser.peek() {
        None => Ok(expression),
        Some(_) => Err(parser.unexpected()),
    }
}

/// True if a word can be the name of a property.
pub(in crate::description::xacro) fn is_name(word: &str) -> bool {
    let mut letters = word.chars();
    let starts = letters
        .next()
        .is_some_and(|letter| letter.is_alphabetic() || letter == '_');
    starts
        && letters.all(|letter| letter.is_alphanumeric() || letter == '_')
        && !KEYWORDS.contains(&word)
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
    parts: usize,
    depth: usize,
}

impl Parser {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at)
    }

    fn is_sign(&self, sign: &str) -> bool {
        matches!(self.peek(), Some(Token::Sign(found)) if *found == sign)
    }

    fn is_word(&self, word: &str) -> bool {
        matches!(self.peek(), Some(Token::Word(found)) if &**found == word)
    }

    /// Takes a sign if it comes next.
    fn take(&mut self, sign: &str) -> bool {
        let found = self.is_sign(sign);
        self.at += usize::from(found);
        found
    }

    /// Takes a keyword if it comes next.
    fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, sign: &str) -> Result<(), Failure> {
        if self.take(sign) {
            Ok(())
        } else {
            Err(match self.peek() {
                None => failure(format!("{} is missing at the end", quoted(sign))),
                Some(_) => self.unexpected(),
            })
        }
    }

    fn unexpected(&self) -> Failure {
        let found = match self.peek() {
            None => return failure("the expression ends too early"),
            Some(Token::Integer(value)) => value.to_string(),
            Some(Token::Float(value)) => value.to_string(),
            Some(Token::Text(text) | Token::Word(text)) => text.to_string(),
            Some(Token::Sign(sign)) => (*sign).to_owned(),
        };
        let what = format!("unexpected {}", quoted(&found));
        if found == "=" {
            return failure_with_hint(what, "write == to compare");
        }
        match &*found {
            "&" => failure_with_hint("the operator & is not supported", "write `and`"),
            "|" => failure_with_hint("the operator | is not supported", "write `or`"),
            "~" | "^" | "<<" | ">>" | "@" | ":=" => {
                failure(format!("the operator {found} is not supported"))
            }
            _ => failure(what),
        }
    }

    /// Counts a part, so that no tree is deeper than its number of parts.
    fn count(&mut self) -> Result<(), Failure> {
        self.parts += 1;
        if self.parts > MOST_PARTS {
            return Err(failure(format!(
                "an expression has more than {MOST_PARTS} operations and values"
            )));
        }
        Ok(())
    }

    /// An expression, a tuple without parentheses, or the items up to a closing bracket.
    fn items_or_one(&mut self, close: Option<&'static str>) -> Result<Expression, Failure> {
        let first = self.expression()?;
        if self.is_word("for") {
            return self.each(first);
        }
        if !self.is_sign(",") {
            return Ok(first);
        }
        let mut items = vec![first];
        while self.take(",") {
            if self.peek().is_none() || close.is_some_and(|close| self.is_sign(close)) {
                break;
            }
            items.push(self.expression()?);
        }
        Ok(Expression::List(items, true))
    }

    /// `a if test else b`, or an operation.
    fn expression(&mut self) -> Result<Expression, Failure> {
        self.count()?;
        let value = self.operation(0)?;
        if !self.take_word("if") {
            return Ok(value);
        }
        let test = self.operation(0)?;
        if !self.take_word("else") {
            return Err(match self.peek() {
                None => failure("`if` has no `else`"),
                Some(_) => self.unexpected(),
            });
        }
        let other = self.expression()?;
        Ok(Expression::If(Box::new([test, value, other])))
    }

    /// An operation whose operators are stronger than a strength.
    fn operation(&mut self, weakest: u8) -> Result<Expression, Failure> {
        self.count()?;
        self.depth += 1;
        if self.depth > MOST_NESTED {
            return Err(failure(format!(
                "an expression is nested more than {MOST_NESTED} deep"
            )));
        }
        let found = self.operators(weakest);
        self.depth -= 1;
        found
    }

    /// The operand at hand, and the operators behind it.
    fn operators(&mut self, weakest: u8) -> Result<Expression, Failure> {
        let mut left = if self.take_word("not") {
            if weakest > NOT {
                self.at -= 1;
                return Err(self.unexpected());
            }
            Expression::Unary(Unary::Not, Box::new(self.operation(NOT)?))
        } else if self.take("-") {
            Expression::Unary(Unary::Minus, Box::new(self.operation(SIGN)?))
        } else if self.take("+") {
            Expression::Unary(Unary::Plus, Box::new(self.operation(SIGN)?))
        } else {
            self.operand()?
        };
        loop {
            self.count()?;
            let Some((strength, operator)) = self.binary() else {
                if weakest >= COMPARISON {
                    return Ok(left);
                }
                let comparisons = self.comparisons()?;
                if !comparisons.is_empty() {
                    left = Expression::Compare(Box::new(left), comparisons);
                    continue;
                }
                if weakest < AND && self.take_word("and") {
                    left = Expression::And(Box::new([left, self.operation(AND)?]));
                } else if weakest < OR && self.take_word("or") {
                    left = Expression::Or(Box::new([left, self.operation(OR)?]));
                } else {
                    return Ok(left);
                }
                continue;
            };
            if strength <= weakest && strength != POWER {
                return Ok(left);
            }
            self.at += 1;
            // A power binds to the right, and weaker than a sign on its right.
            let right = if strength == POWER {
                self.exponent()?
            } else {
                self.operation(strength)?
            };
            left = Expression::Binary(operator, Box::new([left, right]));
        }
    }

    /// The right side of a power.
    fn exponent(&mut self) -> Result<Expression, Failure> {
        self.operation(POWER - 1)
    }

    /// The arithmetic operator that comes next, with its strength.
    fn binary(&self) -> Option<(u8, Binary)> {
        let Some(Token::Sign(sign)) = self.peek() else {
            return None;
        };
        Some(match *sign {
            "+" => (SUM, Binary::Add),
            "-" => (SUM, Binary::Subtract),
            "*" => (PRODUCT, Binary::Multiply),
            "/" => (PRODUCT, Binary::Divide),
            "//" => (PRODUCT, Binary::FloorDivide),
            "%" => (PRODUCT, Binary::Remainder),
            "**" => (POWER, Binary::Power),
            _ => return None,
        })
    }

    /// Comparisons in a row: `a < b <= c`.
    fn comparisons(&mut self) -> Result<Vec<(Comparison, Expression)>, Failure> {
        let mut found = Vec::new();
        loop {
            let comparison = match self.peek() {
                Some(Token::Sign("==")) => Comparison::Equal,
                Some(Token::Sign("!=")) => Comparison::Different,
                Some(Token::Sign("<")) => Comparison::Less,
                Some(Token::Sign("<=")) => Comparison::AtMost,
                Some(Token::Sign(">")) => Comparison::Greater,
                Some(Token::Sign(">=")) => Comparison::AtLeast,
                Some(Token::Word(word)) if &**word == "in" => Comparison::In,
                Some(Token::Word(word)) if &**word == "is" => Comparison::Is,
                Some(Token::Word(word)) if &**word == "not" => Comparison::NotIn,
                _ => return Ok(found),
            };
            self.at += 1;
            let comparison = match comparison {
                Comparison::Is if self.take_word("not") => Comparison::IsNot,
                Comparison::NotIn if !self.take_word("in") => return Err(self.unexpected()),
                other => other,
            };
            found.push((comparison, self.operation(COMPARISON)?));
        }
    }

    /// A value with its indices, members and calls.
    fn operand(&mut self) -> Result<Expression, Failure> {
        let mut value = self.atom()?;
        loop {
            self.count()?;
            if self.take(".") {
                let Some(Token::Word(name)) = self.peek().cloned() else {
                    return Err(self.unexpected());
                };
                self.at += 1;
                value = Expression::Member(Box::new(value), name);
            } else if self.take("[") {
                value = self.subscript(value)?;
            } else if self.take("(") {
                value = self.call(value)?;
            } else {
                return Ok(value);
            }
        }
    }

    /// The rest of `value[index]` or `value[from:to:step]`.
    fn subscript(&mut self, value: Expression) -> Result<Expression, Failure> {
        let mut ends: Vec<Option<Expression>> = vec![None];
        loop {
            if self.take("]") {
                break;
            }
            if self.take(":") {
                ends.push(None);
                continue;
            }
            match ends.last_mut() {
                Some(end @ None) => *end = Some(self.items_or_one(Some("]"))?),
                _ => return Err(self.unexpected()),
            }
        }
        let mut ends = ends.into_iter();
        match (ends.next().flatten(), ends.next(), ends.next(), ends.next()) {
            (Some(index), None, None, _) => Ok(Expression::Index(Box::new([value, index]))),
            (from, Some(to), step, None) => Ok(Expression::Slice(
                Box::new(value),
                Box::new([from, to, step.flatten()]),
            )),
            _ => Err(failure("an index is not complete")),
        }
    }

    /// The rest of `function(…)`.
    fn call(&mut self, function: Expression) -> Result<Expression, Failure> {
        let (mut values, mut named) = (Vec::new(), Vec::new());
        while !self.take(")") {
            let name = match (self.peek(), self.tokens.get(self.at + 1)) {
                (Some(Token::Word(name)), Some(Token::Sign("="))) => Some(Rc::clone(name)),
                _ => None,
            };
            if let Some(name) = name {
                self.at += 2;
                named.push((name, self.expression()?));
            } else {
                if !named.is_empty() {
                    return Err(failure(
                        "an argument without a name follows one with a name",
                    ));
                }
                let value = self.expression()?;
                let value = if self.is_word("for") {
                    self.each(value)?
                } else {
                    value
                };
                values.push(value);
            }
            if !self.take(",") {
                self.expect(")")?;
                break;
            }
        }
        Ok(Expression::Call(Box::new(function), values, named))
    }

    /// The rest of `value for names in values if test`.
    fn each(&mut self, value: Expression) -> Result<Expression, Failure> {
        let mut loops = Vec::new();
        while self.take_word("for") {
            self.count()?;
            let mut names = Vec::new();
            let in_parentheses = self.take("(");
            loop {
                match self.peek().cloned() {
                    Some(Token::Word(name)) if is_name(&name) => names.push(name),
                    _ => return Err(self.unexpected()),
                }
                self.at += 1;
                if !self.take(",") {
                    break;
                }
            }
            if in_parentheses {
                self.expect(")")?;
            }
            if !self.take_word("in") {
                return Err(self.unexpected());
            }
            let values = self.operation(0)?;
            let mut tests = Vec::new();
            while self.take_word("if") {
                tests.push(self.operation(0)?);
            }
            loops.push(Each {
                names,
                values,
                tests,
            });
        }
        Ok(Expression::Each(Box::new(value), loops))
    }

    fn atom(&mut self) -> Result<Expression, Failure> {
        let Some(token) = self.peek().cloned() else {
            return Err(self.unexpected());
        };
        self.at += 1;
        let constant = |value| Ok(Expression::Constant(value));
        match token {
            Token::Integer(value) => constant(Value::Integer(value)),
            Token::Float(value) => constant(Value::Float(value)),
            Token::Text(first) => {
                let mut text = first.to_string();
                while let Some(Token::Text(next)) = self.peek() {
                    text.push_str(next);
                    self.at += 1;
                }
                constant(text.into())
            }
            Token::Word(word) => match &*word {
                "None" => constant(Value::None),
                "True" => constant(Value::Bool(true)),
                "False" => constant(Value::Bool(false)),
                "lambda" => Err(failure("functions by `lambda` are not supported")),
                name if is_name(name) => Ok(Expression::Name(word)),
                _ => {
                    self.at -= 1;
                    Err(self.unexpected())
                }
            },
            Token::Sign("(") => {
                if self.take(")") {
                    return Ok(Expression::List(Vec::new(), true));
                }
                let inner = self.items_or_one(Some(")"))?;
                self.expect(")")?;
                Ok(inner)
            }
            Token::Sign("[") => {
                if self.take("]") {
                    return Ok(Expression::List(Vec::new(), false));
                }
                let first = self.expression()?;
                if self.is_word("for") {
                    let each = self.each(first)?;
                    self.expect("]")?;
                    return Ok(each);
                }
                let mut items = vec![first];
                while self.take(",") && !self.is_sign("]") {
                    items.push(self.expression()?);
                }
                self.expect("]")?;
                Ok(Expression::List(items, false))
            }
            Token::Sign(_) => {
                self.at -= 1;
                Err(self.unexpected())
            }
        }
    }
}

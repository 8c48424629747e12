//! Operators of expressions: Python's arithmetic and comparisons.

use std::cmp::Ordering;

use super::elementary;
use super::tree::{Binary, Comparison, Unary};
use super::value::{List, Value};
use crate::description::xacro::budget::Budget;
use crate::description::xacro::failure::{Failure, failure, failure_with_hint};

/// The value of an operator with one operand.
pub(super) fn unary(operator: Unary, value: &Value) -> Result<Value, Failure> {
    let sign = match operator {
        Unary::Not => return Ok(Value::Bool(!value.is_true())),
        Unary::Plus => 1,
        Unary::Minus => -1,
    };
    match value {
        Value::Float(number) if sign < 0 => Ok(Value::Float(-number)),
        Value::Float(number) => Ok(Value::Float(*number)),
        other => match other.as_integer() {
            Some(integer) => Ok(Value::Integer(sign * integer)),
            None => Err(failure(format!("{} has no sign", value.kind()))),
        },
    }
}

/// The value of an operator with two operands.
pub(super) fn binary(
    operator: Binary,
    [a, b]: [&Value; 2],
    budget: &mut Budget,
) -> Result<Value, Failure> {
    if let (Some(a), Some(b)) = (a.as_integer(), b.as_integer())
        && let Some(value) = of_integers(operator, a, b)?
    {
        return Value::integer(value);
    }
    if let (Some(a), Some(b)) = (a.as_number(), b.as_number()) {
        return of_numbers(operator, a, b).map(Value::Float);
    }
    match (operator, a, b) {
        (Binary::Add, Value::Text(a), Value::Text(b)) => {
            budget.spend_text(a.len() + b.len())?;
            Ok(format!("{a}{b}").into())
        }
        (Binary::Add, Value::List(a), Value::List(b)) if a.is_tuple == b.is_tuple => {
            let items = [&a.items()[..], &b.items()[..]].concat();
            budget.spend(items.len())?;
            List::new(items, a.is_tuple).map(Value::List)
        }
        (Binary::Multiply, a, b) => {
            let (repeated, times) = match (a.as_integer(), b.as_integer()) {
                (Some(times), None) => (b, times),
                (None, Some(times)) => (a, times),
                _ => return Err(no_operator("*", a, b)),
            };
            let times = usize::try_from(times).unwrap_or(0);
            match repeated {
                Value::Text(text) => {
                    budget.spend_text(text.len().saturating_mul(times))?;
                    Ok(text.repeat(times).into())
                }
                Value::List(list) => {
                    let items = list.items();
                    let count = items.len().saturating_mul(times);
                    budget.spend(count)?;
                    let repeated = items.iter().cycle().take(count).cloned();
                    List::new(repeated.collect(), list.is_tuple).map(Value::List)
                }
                _ => Err(no_operator("*", a, b)),
            }
        }
        (Binary::Remainder, Value::Text(_), _) => Err(failure_with_hint(
            "formats by % are not supported",
            "join texts by +, and numbers by str(…)",
        )),
        (Binary::Add, Value::Text(_), other) | (Binary::Add, other, Value::Text(_)) => {
            Err(failure_with_hint(
                format!("a text and {} cannot be added", other.kind()),
                "write str(…) around what is not a text",
            ))
        }
        _ => Err(no_operator(sign(operator), a, b)),
    }
}

const fn sign(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Divide => "/",
        Binary::FloorDivide => "//",
        Binary::Remainder => "%",
        Binary::Power => "**",
    }
}

fn no_operator(sign: &str, a: &Value, b: &Value) -> Failure {
    let [a, b] = [a.kind(), b.kind()];
    failure(format!("{a} and {b} have no operator {sign}"))
}

fn too_large() -> Failure {
    failure("an integer is larger than 2^53")
}

fn no_division() -> Failure {
    failure("division by zero")
}

/// The result of two integers; `None` if it is no integer.
fn of_integers(operator: Binary, a: i64, b: i64) -> Result<Option<i64>, Failure> {
    let rest = |a: i64, b: i64| {
        let rest = a % b;
        if rest != 0 && (rest < 0) != (b < 0) {
            rest + b
        } else {
            rest
        }
    };
    let result = match operator {
        Binary::Add => Some(a + b),
        Binary::Subtract => Some(a - b),
        Binary::Multiply => a.checked_mul(b),
        Binary::Divide => return Ok(None),
        Binary::FloorDivide | Binary::Remainder if b == 0 => return Err(no_division()),
        Binary::FloorDivide => Some((a - rest(a, b)) / b),
        Binary::Remainder => Some(rest(a, b)),
        Binary::Power if b < 0 => return Ok(None),
        Binary::Power if matches!(a, -1..=1) => {
            a.checked_pow(u32::from(b % 2 == 1) + 2 * u32::from(b > 1))
        }
        Binary::Power => u32::try_from(b).ok().and_then(|b| a.checked_pow(b)),
    };
    result.map(Some).ok_or_else(too_large)
}

fn of_numbers(operator: Binary, a: f64, b: f64) -> Result<f64, Failure> {
    let divides = matches!(
        operator,
        Binary::Divide | Binary::FloorDivide | Binary::Remainder
    );
    if divides && b == 0.0 {
        return Err(no_division());
    }
    Ok(match operator {
        Binary::Add => a + b,
        Binary::Subtract => a - b,
        Binary::Multiply => a * b,
        Binary::Divide => a / b,
        Binary::FloorDivide => floor_and_rest(a, b).0,
        Binary::Remainder => floor_and_rest(a, b).1,
        Binary::Power if a == 0.0 && b < 0.0 => return Err(no_division()),
        Binary::Power => {
            let power = elementary::pow(a, b);
            if power.is_nan() && !a.is_nan() && !b.is_nan() {
                return Err(failure("a power of a negative number is complex"));
            }
            if power.is_infinite() && a.is_finite() && b.is_finite() {
                return Err(failure("a power is too large"));
            }
            power
        }
    })
}

/// The quotient rounded down, and the remainder with the sign of the divisor.
pub(super) fn floor_and_rest(a: f64, b: f64) -> (f64, f64) {
    let mut rest = a % b;
    let mut quotient = (a - rest) / b;
    if rest == 0.0 {
        rest = 0.0_f64.copysign(b);
    } else if (rest < 0.0) != (b < 0.0) {
        rest += b;
        quotient -= 1.0;
    }
    if quotient == 0.0 {
        return (0.0_f64.copysign(a / b), rest);
    }
    let floor = quotient.floor();
    // The quotient may be just below the whole number that it stands for.
    let floor = if quotient - floor > 0.5 {
        floor + 1.0
    } else {
        floor
    };
    (floor, rest)
}

/// The result of a comparison.
pub(super) fn compare(comparison: Comparison, a: &Value, b: &Value) -> Result<bool, Failure> {
    let ordered = |is: fn(Ordering) -> bool| a.order(b).map(|order| order.is_some_and(is));
    let identical = || match (a, b) {
        (Value::None | Value::Bool(_), _) | (_, Value::None | Value::Bool(_)) => {
            Ok(a.kind() == b.kind() && a.equals(b))
        }
        _ => Err(failure_with_hint(
            "`is` compares with None, True and False",
            "write == to compare values",
        )),
    };
    match comparison {
        Comparison::Equal => Ok(a.equals(b)),
        Comparison::Different => Ok(!a.equals(b)),
        Comparison::Less => ordered(Ordering::is_lt),
        Comparison::AtMost => ordered(Ordering::is_le),
        Comparison::Greater => ordered(Ordering::is_gt),
        Comparison::AtLeast => ordered(Ordering::is_ge),
        Comparison::In => contains(b, a),
        Comparison::NotIn => contains(b, a).map(|is| !is),
        Comparison::Is => identical(),
        Comparison::IsNot => identical().map(|is| !is),
    }
}

/// True if a list, a dictionary or a text contains a value.
fn contains(whole: &Value, part: &Value) -> Result<bool, Failure> {
    match (whole, part) {
        (Value::List(list), part) => Ok(list.items().iter().any(|item| item.equals(part))),
        (Value::Map(map), part) => {
            part.check_key()?;
            Ok(map.get(part).is_some())
        }
        (Value::Text(whole), Value::Text(part)) => Ok(whole.contains(&**part)),
        _ => Err(failure(format!(
            "{} contains no {}",
            whole.kind(),
            part.kind()
                .trim_start_matches("a ")
                .trim_start_matches("an ")
        ))),
    }
}

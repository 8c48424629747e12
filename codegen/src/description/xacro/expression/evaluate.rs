//! Evaluates the tree of an expression.

use std::rc::Rc;

use super::call::{Call, items};
use super::function::{self, global_value};
use super::method;
use super::operator::{binary, compare, unary};
use super::surroundings::Surroundings;
use super::tree::{Binary, Comparison, Each, Expression, Unary};
use super::value::{List, Value};
use crate::description::xacro::failure::{Failure, failure, failure_with_hint};
use crate::wording::{nearest, quoted};

/// The value of an expression.
pub(in crate::description::xacro) fn evaluate(
    expression: &Expression,
    surroundings: &mut dyn Surroundings,
) -> Result<Value, Failure> {
    let mut evaluator = Evaluator {
        surroundings,
        locals: Vec::new(),
    };
    evaluator.value(expression)
}

struct Evaluator<'s> {
    surroundings: &'s mut dyn Surroundings,
    /// The variables of comprehensions; the last one hides others.
    locals: Vec<(Rc<str>, Value)>,
}

impl Evaluator<'_> {
    fn value(&mut self, expression: &Expression) -> Result<Value, Failure> {
        self.surroundings.budget().enter(1)?;
        let value = self.inner(expression);
        self.surroundings.budget().leave(1);
        value
    }

    /// Each kind has a function of its own, so that nested expressions take little of the stack.
    fn inner(&mut self, expression: &Expression) -> Result<Value, Failure> {
        match expression {
            Expression::Constant(value) => Ok(value.clone()),
            Expression::Name(name) => self.name(name),
            Expression::Unary(operator, operand) => self.unary(*operator, operand),
            Expression::Binary(operator, operands) => self.binary(*operator, operands),
            Expression::And(operands) => self.choice(operands, true),
            Expression::Or(operands) => self.choice(operands, false),
            Expression::Compare(first, others) => self.comparisons(first, others),
            Expression::If(parts) => self.conditional(parts),
            Expression::List(items, is_tuple) => self.list(items, *is_tuple),
            Expression::Each(item, loops) => self.comprehension(item, loops),
            Expression::Member(owner, name) => self.member_of(owner, name),
            Expression::Index(parts) => self.index(parts),
            Expression::Slice(value, ends) => self.slice(value, ends),
            Expression::Call(function, values, named) => self.call(function, values, named),
        }
    }

    fn unary(&mut self, operator: Unary, operand: &Expression) -> Result<Value, Failure> {
        let operand = self.value(operand)?;
        unary(operator, &operand)
    }

    fn binary(&mut self, operator: Binary, operands: &[Expression; 2]) -> Result<Value, Failure> {
        let [a, b] = [self.value(&operands[0])?, self.value(&operands[1])?];
        binary(operator, [&a, &b], self.surroundings.budget())
    }

    /// The second operand if the first one is as true as `goes_on`, otherwise the first one.
    fn choice(&mut self, operands: &[Expression; 2], goes_on: bool) -> Result<Value, Failure> {
        let first = self.value(&operands[0])?;
        if first.is_true() == goes_on {
            self.value(&operands[1])
        } else {
            Ok(first)
        }
    }

    fn comparisons(
        &mut self,
        first: &Expression,
        others: &[(Comparison, Expression)],
    ) -> Result<Value, Failure> {
        let mut left = self.value(first)?;
        for (comparison, right) in others {
            let right = self.value(right)?;
            let steps = left.steps() + right.steps();
            self.surroundings.budget().spend(steps)?;
            if !compare(*comparison, &left, &right)? {
                return Ok(Value::Bool(false));
            }
            left = right;
        }
        Ok(Value::Bool(true))
    }

    fn conditional(&mut self, [test, value, other]: &[Expression; 3]) -> Result<Value, Failure> {
        let test = self.value(test)?;
        self.value(if test.is_true() { value } else { other })
    }

    fn list(&mut self, items: &[Expression], is_tuple: bool) -> Result<Value, Failure> {
        let items = items.iter().map(|item| self.value(item));
        let items = items.collect::<Result<_, _>>()?;
        List::new(items, is_tuple).map(Value::List)
    }

    fn comprehension(&mut self, item: &Expression, loops: &[Each]) -> Result<Value, Failure> {
        let mut found = Vec::new();
        self.each(item, loops, &mut found)?;
        Value::list(found)
    }

    fn member_of(&mut self, owner: &Expression, name: &str) -> Result<Value, Failure> {
        let owner = self.value(owner)?;
        self.member(&owner, name)
    }

    fn index(&mut self, parts: &[Expression; 2]) -> Result<Value, Failure> {
        let [value, index] = [self.value(&parts[0])?, self.value(&parts[1])?];
        let steps = value.steps() / 16 + index.steps();
        self.surroundings.budget().spend(steps)?;
        item(&value, &index)
    }

    fn name(&mut self, name: &str) -> Result<Value, Failure> {
        let mut locals = self.locals.iter().rev();
        if let Some((_, value)) = locals.find(|(known, _)| &**known == name) {
            return Ok(value.clone());
        }
        if let Some(value) = self.surroundings.property(name)? {
            return Ok(value);
        }
        if let Some(value) = global_value(name) {
            return Ok(value);
        }
        let what = format!("name {} is not defined", quoted(name));
        if let Some(home) = function::home(name) {
            return Err(failure_with_hint(what, format!("write {home}.{name}")));
        }
        if ["true", "false"].contains(&name) {
            return Err(failure_with_hint(what, "write True or False"));
        }
        let names = self.surroundings.names();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        Err(match nearest(name, &names) {
            Some(meant) => failure_with_hint(what, format!("did you mean {}?", quoted(meant))),
            None => failure(what),
        })
    }

    fn member(&mut self, owner: &Value, name: &str) -> Result<Value, Failure> {
        match owner {
            Value::Library(library) => function::member(*library, name),
            Value::Scope(scope) => {
                let found = self.surroundings.property_of(*scope, name)?;
                found.or_else(|| global_value(name)).ok_or_else(|| {
                    failure(format!("the namespace has no property {}", quoted(name)))
                })
            }
            Value::Map(map) if map.is_dotted => map
                .get(&name.into())
                .ok_or_else(|| no_key(map, &name.into())),
            other => Err(method::missing(other, name)),
        }
    }

    fn call(
        &mut self,
        function: &Expression,
        values: &[Expression],
        named: &[(Rc<str>, Expression)],
    ) -> Result<Value, Failure> {
        let owner = match function {
            Expression::Member(owner, name) => {
                let owner = self.value(owner)?;
                if !method::has(&owner, name) {
                    let function = self.member(&owner, name)?;
                    return self.run(&function, values, named);
                }
                Some((owner, name))
            }
            _ => None,
        };
        let Some((owner, name)) = owner else {
            let function = self.value(function)?;
            return self.run(&function, values, named);
        };
        let (values, named) = self.arguments(values, named)?;
        method::run(
            &owner,
            &mut Call {
                name,
                values,
                named,
                surroundings: self.surroundings,
            },
        )
    }

    fn run(
        &mut self,
        function: &Value,
        values: &[Expression],
        named: &[(Rc<str>, Expression)],
    ) -> Result<Value, Failure> {
        let Value::Function(function) = function else {
            return Err(failure(format!("{} cannot be called", function.kind())));
        };
        let (values, named) = self.arguments(values, named)?;
        function::run(*function, values, named, self.surroundings)
    }

    #[expect(clippy::type_complexity, reason = "the two lists of a call")]
    fn arguments(
        &mut self,
        values: &[Expression],
        named: &[(Rc<str>, Expression)],
    ) -> Result<(Vec<Value>, Vec<(Rc<str>, Value)>), Failure> {
        let values = values.iter().map(|value| self.value(value));
        let values = values.collect::<Result<_, _>>()?;
        let named = named
            .iter()
            .map(|(name, value)| Ok((Rc::clone(name), self.value(value)?)));
        Ok((values, named.collect::<Result<_, _>>()?))
    }

    /// The items of a comprehension.
    fn each(
        &mut self,
        item: &Expression,
        loops: &[Each],
        found: &mut Vec<Value>,
    ) -> Result<(), Failure> {
        let Some((first, inner)) = loops.split_first() else {
            found.push(self.value(item)?);
            return Ok(());
        };
        let values = self.value(&first.values)?;
        let values =
            items(&values).ok_or_else(|| failure(format!("{} has no items", values.kind())))?;
        let outer = self.locals.len();
        for value in values {
            self.surroundings.budget().spend(1)?;
            match &first.names[..] {
                [name] => self.locals.push((Rc::clone(name), value)),
                names => {
                    let parts = items(&value).filter(|parts| parts.len() == names.len());
                    let parts = parts
                        .ok_or_else(|| failure(format!("an item has not {} parts", names.len())))?;
                    self.locals.extend(names.iter().cloned().zip(parts));
                }
            }
            let mut is_kept = true;
            for test in &first.tests {
                is_kept = is_kept && self.value(test)?.is_true();
            }
            if is_kept {
                self.each(item, inner, found)?;
            }
            self.locals.truncate(outer);
        }
        Ok(())
    }

    fn slice(
        &mut self,
        value: &Expression,
        ends: &[Option<Expression>; 3],
    ) -> Result<Value, Failure> {
        let value = self.value(value)?;
        let mut bounds = [None; 3];
        for (bound, end) in bounds.iter_mut().zip(ends) {
            let Some(end) = end else { continue };
            let end = self.value(end)?;
            if !matches!(end, Value::None) {
                let integer = end.as_integer();
                *bound = Some(integer.ok_or_else(|| failure("an index is no integer"))?);
            }
        }
        let all = items(&value)
            .filter(|_| !matches!(value, Value::Map(_)))
            .ok_or_else(|| failure(format!("{} has no parts", value.kind())))?;
        self.surroundings.budget().spend(all.len())?;
        let part = part(&all, bounds)?;
        if let Value::List(list) = value {
            return List::new(part, list.is_tuple).map(Value::List);
        }
        let letters: Vec<_> = part.iter().map(Value::text).collect();
        Ok(letters.concat().into())
    }
}

/// The items from one index to another, with a step.
fn part(items: &[Value], [from, to, step]: [Option<i64>; 3]) -> Result<Vec<Value>, Failure> {
    let length = i64::try_from(items.len()).unwrap_or(i64::MAX);
    let step = step.unwrap_or(1);
    if step == 0 {
        return Err(failure("a slice has the step 0"));
    }
    let (least, most) = if step > 0 {
        (0, length)
    } else {
        (-1, length - 1)
    };
    let clamped = |end: Option<i64>, default: i64| match end {
        None => default,
        Some(end) if end < 0 => (end + length).clamp(least, most),
        Some(end) => end.clamp(least, most),
    };
    let (from, to) = if step > 0 {
        (clamped(from, least), clamped(to, most))
    } else {
        (clamped(from, most), clamped(to, least))
    };
    let mut found = Vec::new();
    let mut at = from;
    while (step > 0 && at < to) || (step < 0 && at > to) {
        let index = usize::try_from(at).unwrap_or_default();
        found.push(items[index].clone());
        at = at.saturating_add(step);
    }
    Ok(found)
}

/// The item of a list, a text or a dictionary.
fn item(value: &Value, index: &Value) -> Result<Value, Failure> {
    let integer = || {
        let integer = index.as_integer();
        integer.ok_or_else(|| failure(format!("{} is no index of a list", index.kind())))
    };
    match value {
        Value::Map(map) => map.get(index).ok_or_else(|| no_key(map, index)),
        Value::List(list) => {
            let (items, at) = (list.items(), integer()?);
            let found = method::position(at, items.len());
            found
                .map(|at| items[at].clone())
                .ok_or_else(|| method::beyond(at, items.len()))
        }
        Value::Text(text) => {
            let (length, at) = (text.chars().count(), integer()?);
            let letter = method::position(at, length).and_then(|at| text.chars().nth(at));
            letter
                .map(|letter| letter.to_string().into())
                .ok_or_else(|| method::beyond(at, length))
        }
        other => Err(failure(format!("{} has no items", other.kind()))),
    }
}

/// The error of a key that a dictionary lacks.
fn no_key(map: &super::value::Map, key: &Value) -> Failure {
    let entries = map.entries();
    let names = entries.iter().map(|(name, _)| name.text());
    let names: Vec<_> = names.collect();
    let names: Vec<&str> = names.iter().map(|name| &**name).collect();
    let what = format!("the dictionary has no key {}", key.literal());
    failure_with_hint(what, crate::wording::named(&key.text(), "keys", &names))
}

//! The functions that expressions may call, by their namespaces `python`, `math` and `xacro`.

use super::call::Call;
use super::elementary;
use super::operator::{binary, compare, floor_and_rest};
use super::surroundings::Surroundings;
use super::tree::{Binary, Comparison};
use super::value::{FunctionId, Library, Map, Value};
use crate::description::xacro::failure::{Failure, failure, failure_with_hint};
use crate::wording::{known, quoted};

/// A function with its name.
struct XacroFunction {
    name: &'static str,
    /// True if it needs no namespace.
    is_global: bool,
    run: Run,
}

type Run = fn(&mut Call<'_>) -> Result<Value, Failure>;

const fn global(name: &'static str, run: Run) -> XacroFunction {
    XacroFunction {
        name,
        is_global: true,
        run,
    }
}

const fn inner(name: &'static str, run: Run) -> XacroFunction {
    XacroFunction {
        name,
        is_global: false,
        run,
    }
}

/// Functions of Python itself.
const OF_PYTHON: [XacroFunction; 26] = [
    global("list", |call| {
        let items = optional_items(call)?;
        Value::list(items)
    }),
    global("dict", dict),
    global("map", map),
    global("len", |call| {
        let [value] = call.exactly()?;
        let items = call.items(&value)?;
        Value::count(items.len())
    }),
    global("str", |call| {
        let Some(value) = call.optional()? else {
            return Ok("".into());
        };
        call.surroundings.budget().spend(value.steps())?;
        let text = value.text();
        call.surroundings.budget().spend_text(text.len())?;
        Ok(Value::Text(text))
    }),
    global("float", float),
    global("int", int),
    global("bool", |call| {
        let value = call.optional()?;
        Ok(Value::Bool(value.is_some_and(|value| value.is_true())))
    }),
    global("min", |call| extreme(call, Comparison::Less)),
    global("max", |call| extreme(call, Comparison::Greater)),
    global("round", round),
    global("sorted", sorted),
    global("range", range),
    inner("abs", |call| {
        let [value] = call.exactly()?;
        match value.as_integer() {
            Some(integer) => Value::integer(integer.abs()),
            None => call.number(&value).map(|number| Value::Float(number.abs())),
        }
    }),
    inner("all", |call| {
        let [value] = call.exactly()?;
        let items = call.items(&value)?;
        Ok(Value::Bool(items.iter().all(Value::is_true)))
    }),
    inner("any", |call| {
        let [value] = call.exactly()?;
        let items = call.items(&value)?;
        Ok(Value::Bool(items.iter().any(Value::is_true)))
    }),
    inner("divmod", |call| {
        let [a, b] = call.exactly()?;
        let budget = call.surroundings.budget();
        let quotient = binary(Binary::FloorDivide, [&a, &b], budget)?;
        let rest = binary(Binary::Remainder, [&a, &b], budget)?;
        Value::tuple(vec![quotient, rest])
    }),
    inner("enumerate", |call| {
        let [value] = call.exactly()?;
        let items = call.items(&value)?.into_iter().enumerate();
        let pairs = items.map(|(at, item)| Value::tuple(vec![Value::count(at)?, item]));
        Value::list(pairs.collect::<Result<_, _>>()?)
    }),
    inner("isinstance", is_instance),
    inner("ord", |call| {
        let [value] = call.exactly()?;
        let text = call.text(&value)?;
        let mut letters = text.chars();
        match (letters.next(), letters.next()) {
            (Some(letter), None) => Value::integer(i64::from(u32::from(letter))),
            _ => Err(failure("ord needs a text of one letter")),
        }
    }),
    inner("repr", |call| {
        let [value] = call.exactly()?;
        call.surroundings.budget().spend(value.steps())?;
        let text = value.literal();
        call.surroundings.budget().spend_text(text.len())?;
        Ok(text.into())
    }),
    inner("reversed", |call| {
        let [value] = call.exactly()?;
        let mut items = call.items(&value)?;
        items.reverse();
        Value::list(items)
    }),
    inner("sum", |call| {
        let (values, start) = call.one_or_two()?;
        let items = call.items(&values)?;
        let start = start.unwrap_or(Value::Integer(0));
        let budget = call.surroundings.budget();
        items
            .iter()
            .try_fold(start, |sum, item| binary(Binary::Add, [&sum, item], budget))
    }),
    inner("tuple", |call| {
        let items = optional_items(call)?;
        Value::tuple(items)
    }),
    inner("zip", zip),
    inner("type", |_| {
        Err(failure_with_hint(
            "type is not supported",
            "write python.isinstance(value, str)",
        ))
    }),
];

/// Functions of Python's module `math`.
const OF_MATH: [XacroFunction; 26] = [
    global("sin", |call| number(call, elementary::sin)),
    global("cos", |call| number(call, elementary::cos)),
    global("tan", |call| number(call, elementary::tan)),
    global("asin", |call| within(call, [-1.0, 1.0], elementary::asin)),
    global("acos", |call| within(call, [-1.0, 1.0], elementary::acos)),
    global("atan", |call| number(call, elementary::atan)),
    global("atan2", |call| numbers(call, elementary::atan2)),
    global("sqrt", |call| within(call, [0.0, f64::INFINITY], f64::sqrt)),
    global("hypot", |call| numbers(call, elementary::hypot)),
    global("exp", |call| number(call, elementary::exp)),
    global("log", |call| {
        let (value, base) = call.one_or_two()?;
        let value = positive(call, &value)?;
        let Some(base) = base else {
            return Ok(Value::Float(elementary::ln(value)));
        };
        let base = positive(call, &base)?;
        if base == 1.0 {
            return Err(failure("a logarithm to the base 1 is undefined"));
        }
        Ok(Value::Float(elementary::ln(value) / elementary::ln(base)))
    }),
    global("log10", |call| {
        let [value] = call.exactly()?;
        let value = positive(call, &value)?;
        Ok(Value::Float(elementary::log10(value)))
    }),
    global("pow", |call| numbers(call, elementary::pow)),
    global("radians", |call| {
        number(call, |x| x * (std::f64::consts::PI / 180.0))
    }),
    global("degrees", |call| {
        number(call, |x| x * (180.0 / std::f64::consts::PI))
    }),
    global("fabs", |call| number(call, f64::abs)),
    global("floor", |call| whole(call, f64::floor)),
    global("ceil", |call| whole(call, f64::ceil)),
    global("trunc", |call| whole(call, f64::trunc)),
    global("copysign", |call| numbers(call, f64::copysign)),
    global("fmod", |call| {
        let [a, b] = call.exactly()?;
        let [a, b] = [call.number(&a)?, call.number(&b)?];
        if b == 0.0 || a.is_infinite() {
            return Err(failure("fmod is undefined here"));
        }
        Ok(Value::Float(a % b))
    }),
    global("remainder", |call| {
        numbers(call, |a, b| {
            let (quotient, rest) = floor_and_rest(a, b);
            let is_odd = quotient % 2.0 != 0.0;
            let half = (rest / b).abs();
            if half > 0.5 || (half == 0.5 && is_odd) {
                rest - b
            } else {
                rest
            }
        })
    }),
    global("isnan", |call| {
        let [value] = call.exactly()?;
        Ok(Value::Bool(call.number(&value)?.is_nan()))
    }),
    global("isinf", |call| {
        let [value] = call.exactly()?;
        Ok(Value::Bool(call.number(&value)?.is_infinite()))
    }),
    global("isfinite", |call| {
        let [value] = call.exactly()?;
        Ok(Value::Bool(call.number(&value)?.is_finite()))
    }),
    global("isqrt", |call| {
        let [value] = call.exactly()?;
        let value = call.integer(&value)?;
        let root = u64::try_from(value).map(u64::isqrt);
        let root = root.map_err(|_| failure("isqrt needs a number that is not negative"))?;
        Value::integer(i64::try_from(root).unwrap_or(i64::MAX))
    }),
];

/// Functions of xacro.
const OF_XACRO: [XacroFunction; 10] = [
    global("load_yaml", |call| {
        let [file] = call.exactly()?;
        let file = call.text(&file)?;
        call.surroundings.yaml(&file)
    }),
    global("abs_filename", |call| {
        let [file] = call.exactly()?;
        let file = call.text(&file)?;
        call.surroundings.full_path(&file)
    }),
    global("dotify", |call| {
        let [value] = call.exactly()?;
        match value {
            Value::Map(mut map) => {
                map.is_dotted = true;
                Ok(Value::Map(map))
            }
            other => Err(call.wrong_kind("a dictionary", &other)),
        }
    }),
    inner("arg", |call| {
        let [name] = call.exactly()?;
        let name = call.text(&name)?;
        call.surroundings.argument(&name)
    }),
    // Information for the person who runs xacro.
    inner("message", |_| Ok("".into())),
    inner("print_location", |_| Ok("".into())),
    inner("warning", |call| {
        warn(call)?;
        Ok("".into())
    }),
    // The tool goes on after it.
    inner("error", |call| {
        warn(call)?;
        Ok("".into())
    }),
    inner("fatal", |call| {
        let message = joined(call)?;
        Err(failure(message))
    }),
    inner("tokenize", tokenize),
];

/// Constants of the module `math`.
const CONSTANTS: [(&str, f64); 5] = [
    ("pi", std::f64::consts::PI),
    ("e", std::f64::consts::E),
    ("tau", std::f64::consts::TAU),
    ("inf", f64::INFINITY),
    ("nan", f64::NAN),
];

const LIBRARIES: [(&str, Library); 3] = [
    ("python", Library::Python),
    ("math", Library::Math),
    ("xacro", Library::Xacro),
];

fn functions(library: Library) -> &'static [XacroFunction] {
    match library {
        Library::Python => &OF_PYTHON,
        Library::Math => &OF_MATH,
        Library::Xacro => &OF_XACRO,
    }
}

/// The value of a name that needs no namespace.
pub(in crate::description::xacro) fn global_value(name: &str) -> Option<Value> {
    let mut libraries = LIBRARIES.into_iter();
    if let Some((_, library)) = libraries.find(|(known, _)| *known == name) {
        return Some(Value::Library(library));
    }
    let found = LIBRARIES.into_iter().find_map(|(_, library)| {
        let index = functions(library)
            .iter()
            .position(|function| function.is_global && function.name == name)?;
        Some(Value::Function(FunctionId { library, index }))
    });
    found.or_else(|| constant(name))
}

fn constant(name: &str) -> Option<Value> {
    let found = CONSTANTS.iter().find(|(known, _)| *known == name);
    found.map(|(_, value)| Value::Float(*value))
}

/// A function or a constant of a namespace.
pub(super) fn member(library: Library, name: &str) -> Result<Value, Failure> {
    let functions = functions(library);
    let index = functions.iter().position(|function| function.name == name);
    let found = index.map(|index| Value::Function(FunctionId { library, index }));
    let constant = || constant(name).filter(|_| library == Library::Math);
    found.or_else(constant).ok_or_else(|| {
        let mut libraries = LIBRARIES.iter();
        let own = libraries.find(|(_, known)| *known == library);
        let own = own.map_or("", |(name, _)| name);
        let names: Vec<&str> = functions.iter().map(|function| function.name).collect();
        failure_with_hint(
            format!("{own} has no {}", quoted(name)),
            known(name, "functions", &names),
        )
    })
}

/// The namespaces that have a function which needs one.
pub(super) fn home(name: &str) -> Option<&'static str> {
    let mut libraries = LIBRARIES.into_iter();
    let has = |(_, library): &(_, Library)| {
        let mut functions = functions(*library).iter();
        functions.any(|function| function.name == name)
    };
    libraries.find(has).map(|(home, _)| home)
}

/// Calls a function.
pub(super) fn run(
    function: FunctionId,
    values: Vec<Value>,
    named: Vec<(std::rc::Rc<str>, Value)>,
    surroundings: &mut dyn Surroundings,
) -> Result<Value, Failure> {
    let function = &functions(function.library)[function.index];
    (function.run)(&mut Call {
        name: function.name,
        values,
        named,
        surroundings,
    })
}

/// The items of the only argument; none without one.
fn optional_items(call: &mut Call<'_>) -> Result<Vec<Value>, Failure> {
    match call.optional()? {
        None => Ok(Vec::new()),
        Some(value) => call.items(&value),
    }
}

fn dict(call: &mut Call<'_>) -> Result<Value, Failure> {
    let mut entries = Vec::new();
    for value in std::mem::take(&mut call.values) {
        if let Value::Map(map) = &value {
            entries.extend(map.entries().iter().cloned());
            continue;
        }
        for item in call.items(&value)? {
            let pair: Result<[Value; 2], _> = call.items(&item)?.try_into();
            let [key, value] = pair.map_err(|_| failure("dict needs pairs of key and value"))?;
            entries.push((key, value));
        }
    }
    let named = std::mem::take(&mut call.named);
    entries.extend(
        named
            .into_iter()
            .map(|(name, value)| (Value::Text(name), value)),
    );
    call.surroundings.budget().spend(entries.len())?;
    Map::new(entries, false).map(Value::Map)
}

fn map(call: &mut Call<'_>) -> Result<Value, Failure> {
    let [function, values] = call.exactly()?;
    let Value::Function(function) = function else {
        return Err(call.wrong_kind("a function", &function));
    };
    let items = call.items(&values)?.into_iter();
    call.surroundings.budget().enter(1)?;
    let results = items.map(|item| run(function, vec![item], Vec::new(), call.surroundings));
    let results = results.collect::<Result<_, _>>();
    call.surroundings.budget().leave(1);
    Value::list(results?)
}

fn float(call: &mut Call<'_>) -> Result<Value, Failure> {
    let Some(value) = call.optional()? else {
        return Ok(Value::Float(0.0));
    };
    let Value::Text(text) = &value else {
        return call.number(&value).map(Value::Float);
    };
    let number = float_of(text);
    number
        .map(Value::Float)
        .ok_or_else(|| failure(format!("{} is not a number", quoted(text))))
}

/// The number that Python reads in a text.
pub(in crate::description::xacro) fn float_of(text: &str) -> Option<f64> {
    let word = text.trim();
    let digits = word.trim_start_matches(['+', '-']);
    let is_word = ["inf", "infinity", "nan"].contains(&&*digits.to_ascii_lowercase());
    let starts = digits.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    (is_word || starts).then(|| word.parse().ok()).flatten()
}

/// The integer that Python reads in a text.
pub(in crate::description::xacro) fn integer_of(text: &str) -> Option<i64> {
    let word = text.trim();
    let digits = word.strip_prefix(['+', '-']).unwrap_or(word);
    let is_decimal = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_decimal.then(|| word.parse().ok()).flatten()
}

fn int(call: &mut Call<'_>) -> Result<Value, Failure> {
    let Some(value) = call.optional()? else {
        return Ok(Value::Integer(0));
    };
    match &value {
        Value::Text(text) => {
            let integer = integer_of(text);
            let integer =
                integer.ok_or_else(|| failure(format!("{} is no integer", quoted(text))))?;
            Value::integer(integer)
        }
        other => whole_of(call.number(other)?.trunc()),
    }
}

/// The integer of a number without digits behind the point.
fn whole_of(number: f64) -> Result<Value, Failure> {
    if !number.is_finite() {
        return Err(failure("an infinite or undefined number is no integer"));
    }
    #[expect(clippy::cast_possible_truncation, reason = "saturates, and is checked")]
    Value::integer(number as i64)
}

fn extreme(call: &mut Call<'_>, better: Comparison) -> Result<Value, Failure> {
    call.unnamed()?;
    let values = std::mem::take(&mut call.values);
    let items = match &values[..] {
        [list] => call.items(list)?,
        _ => values,
    };
    let mut items = items.into_iter();
    let name = call.name;
    let first = items.next();
    let first = first.ok_or_else(|| failure(format!("{name} of nothing has no value")))?;
    items.try_fold(first, |best, item| {
        let is_better = compare(better, &item, &best)?;
        Ok(if is_better { item } else { best })
    })
}

fn round(call: &mut Call<'_>) -> Result<Value, Failure> {
    /// From here on, no digit of a number is cut.
    const MOST_DIGITS: i64 = 340;
    let (value, digits) = call.one_or_two()?;
    let number = call.number(&value)?;
    let Some(digits) = digits.filter(|digits| !matches!(digits, Value::None)) else {
        return match value.as_integer() {
            Some(integer) => Value::integer(integer),
            None => whole_of(number.round_ties_even()),
        };
    };
    let digits = call.integer(&digits)?;
    if digits < 0 {
        return Err(failure("round to tens is not supported"));
    }
    if let Some(integer) = value.as_integer() {
        return Value::integer(integer);
    }
    if digits > MOST_DIGITS || !number.is_finite() {
        return Ok(value);
    }
    let digits = usize::try_from(digits).unwrap_or_default();
    // Decimal digits are exact, and so is the choice at a tie.
    let rounded = format!("{number:.digits$}").parse();
    Ok(Value::Float(rounded.unwrap_or(number)))
}

fn sorted(call: &mut Call<'_>) -> Result<Value, Failure> {
    let [values] = call.exactly()?;
    let mut items = call.items(&values)?;
    let mut is_ordered = true;
    items.sort_by(|a, b| {
        let order = a.order(b).ok().flatten();
        is_ordered &= order.is_some();
        order.unwrap_or(std::cmp::Ordering::Equal)
    });
    if is_ordered {
        Value::list(items)
    } else {
        Err(failure("sorted needs values with an order"))
    }
}

fn range(call: &mut Call<'_>) -> Result<Value, Failure> {
    call.unnamed()?;
    let values = std::mem::take(&mut call.values);
    let ends = values.iter().map(|value| call.integer(value));
    let ends = ends.collect::<Result<Vec<i64>, _>>()?;
    let [from, to, step] = match ends[..] {
        [to] => [0, to, 1],
        [from, to] => [from, to, 1],
        [from, to, step] => [from, to, step],
        _ => return Err(call.wrong_count("1 to 3", ends.len())),
    };
    if step == 0 {
        return Err(failure("a range has the step 0"));
    }
    let distance = if step > 0 { to - from } else { from - to };
    let count = (distance.max(0) + step.abs() - 1) / step.abs();
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    call.surroundings.budget().spend(count)?;
    let mut items = Vec::with_capacity(count);
    let mut at = from;
    for _ in 0..count {
        items.push(Value::Integer(at));
        at += step;
    }
    Value::list(items)
}

fn is_instance(call: &mut Call<'_>) -> Result<Value, Failure> {
    let [value, of] = call.exactly()?;
    let kinds = match &of {
        Value::List(list) if list.is_tuple => list.items().clone(),
        other => vec![other.clone()],
    };
    let mut is_instance = false;
    for kind in &kinds {
        let Value::Function(FunctionId {
            library: Library::Python,
            index,
        }) = kind
        else {
            return Err(failure("isinstance needs a type, such as python.str"));
        };
        let names: &[&str] = match &value {
            Value::Bool(_) => &["bool", "int"],
            Value::Integer(_) => &["int"],
            Value::Float(_) => &["float"],
            Value::Text(_) => &["str"],
            Value::List(list) if list.is_tuple => &["tuple"],
            Value::List(_) => &["list"],
            Value::Map(_) => &["dict"],
            _ => &[],
        };
        is_instance |= names.contains(&OF_PYTHON[*index].name);
    }
    Ok(Value::Bool(is_instance))
}

fn zip(call: &mut Call<'_>) -> Result<Value, Failure> {
    call.unnamed()?;
    let values = std::mem::take(&mut call.values);
    let lists = values.iter().map(|value| call.items(value));
    let lists = lists.collect::<Result<Vec<_>, _>>()?;
    let length = lists.iter().map(Vec::len).min().unwrap_or(0);
    let rows =
        (0..length).map(|row| Value::tuple(lists.iter().map(|list| list[row].clone()).collect()));
    Value::list(rows.collect::<Result<_, _>>()?)
}

fn number(call: &mut Call<'_>, function: fn(f64) -> f64) -> Result<Value, Failure> {
    let [value] = call.exactly()?;
    let value = call.number(&value)?;
    let result = function(value);
    if result.is_nan() && !value.is_nan() {
        let name = call.name;
        return Err(failure(format!(
            "{name} of {value} is undefined, or not known to a digit"
        )));
    }
    if result.is_infinite() && value.is_finite() {
        return Err(failure(format!("{} of {value} is too large", call.name)));
    }
    Ok(Value::Float(result))
}

fn numbers(call: &mut Call<'_>, function: fn(f64, f64) -> f64) -> Result<Value, Failure> {
    let [a, b] = call.exactly()?;
    let [a, b] = [call.number(&a)?, call.number(&b)?];
    let result = function(a, b);
    if !result.is_finite() && a.is_finite() && b.is_finite() {
        let name = call.name;
        return Err(failure(format!("{name} of {a} and {b} is undefined")));
    }
    Ok(Value::Float(result))
}

/// A function of numbers within a range.
fn within(
    call: &mut Call<'_>,
    [least, most]: [f64; 2],
    function: fn(f64) -> f64,
) -> Result<Value, Failure> {
    let [value] = call.exactly()?;
    let value = call.number(&value)?;
    if value < least || value > most {
        return Err(failure(format!("{} of {value} is undefined", call.name)));
    }
    Ok(Value::Float(function(value)))
}

fn positive(call: &Call<'_>, value: &Value) -> Result<f64, Failure> {
    let number = call.number(value)?;
    if number > 0.0 || number.is_nan() {
        Ok(number)
    } else {
        Err(failure(format!("{} of {number} is undefined", call.name)))
    }
}

/// A function whose result is an integer.
fn whole(call: &mut Call<'_>, function: fn(f64) -> f64) -> Result<Value, Failure> {
    let [value] = call.exactly()?;
    whole_of(function(call.number(&value)?))
}

/// The arguments as the tool prints them.
fn joined(call: &mut Call<'_>) -> Result<String, Failure> {
    let steps = call.values.iter().map(Value::steps).sum();
    call.surroundings.budget().spend(steps)?;
    let texts: Vec<_> = call.values.iter().map(Value::text).collect();
    Ok(texts.join(" "))
}

fn warn(call: &mut Call<'_>) -> Result<(), Failure> {
    let message = joined(call)?;
    call.surroundings.warn(message);
    Ok(())
}

fn tokenize(call: &mut Call<'_>) -> Result<Value, Failure> {
    let mut separators: std::rc::Rc<str> = ",; ".into();
    let mut skips = true;
    for (name, value) in std::mem::take(&mut call.named) {
        match &*name {
            "sep" => separators = call.text(&value)?,
            "skip_empty" => skips = value.is_true(),
            _ => {
                return Err(failure(format!(
                    "tokenize has no argument {}",
                    quoted(&name)
                )));
            }
        }
    }
    let (text, second) = call.one_or_two()?;
    if let Some(second) = second {
        separators = call.text(&second)?;
    }
    let text = call.text(&text)?;
    call.surroundings.budget().spend(text.len())?;
    let words = text.split(|letter| separators.contains(letter));
    let words = words.filter(|word| !skips || !word.is_empty());
    Value::list(words.map(Value::from).collect())
}

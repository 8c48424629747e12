//! Methods of texts, lists and dictionaries.

use super::call::Call;
use super::operator::compare;
use super::tree::Comparison;
use super::value::{List, Map, Value};
use crate::description::xacro::failure::{Failure, failure, failure_with_hint};
use crate::wording::{known, quoted};

const OF_TEXTS: [&str; 24] = [
    "capitalize",
    "count",
    "endswith",
    "find",
    "format",
    "index",
    "isalpha",
    "isdigit",
    "isspace",
    "join",
    "lower",
    "lstrip",
    "removeprefix",
    "removesuffix",
    "replace",
    "rfind",
    "rsplit",
    "rstrip",
    "split",
    "splitlines",
    "startswith",
    "strip",
    "title",
    "upper",
];

const OF_LISTS: [&str; 3] = ["count", "index", "pop"];

const OF_MAPS: [&str; 4] = ["get", "items", "keys", "values"];

/// True if a value has a method with this name.
pub(super) fn has(value: &Value, name: &str) -> bool {
    methods(value).contains(&name)
}

fn methods(value: &Value) -> &'static [&'static str] {
    match value {
        Value::Text(_) => &OF_TEXTS,
        Value::List(_) => &OF_LISTS,
        Value::Map(_) => &OF_MAPS,
        _ => &[],
    }
}

/// The error of a method that does not exist.
pub(super) fn missing(value: &Value, name: &str) -> Failure {
    let what = format!("{} has no member {}", value.kind(), quoted(name));
    if let Value::Map(_) = value {
        return failure_with_hint(what, format!("write [{}]", quoted(name)));
    }
    match methods(value) {
        [] => failure(what),
        methods => failure_with_hint(what, known(name, "methods", methods)),
    }
}

/// Calls a method that exists.
pub(super) fn run(value: &Value, call: &mut Call<'_>) -> Result<Value, Failure> {
    match value {
        Value::Text(text) => of_text(text, call),
        Value::List(list) => of_list(list, call),
        Value::Map(map) => of_map(map, call),
        other => Err(missing(other, call.name)),
    }
}

fn of_text(text: &str, call: &mut Call<'_>) -> Result<Value, Failure> {
    call.surroundings.budget().spend_text(text.len())?;
    let found = |at: Option<usize>| match at {
        Some(at) => Value::count(text[..at].chars().count()),
        None => Ok(Value::Integer(-1)),
    };
    match call.name {
        "capitalize" => {
            let mut letters = text.chars();
            let first = letters.next().map(|first| first.to_uppercase().to_string());
            Ok((first.unwrap_or_default() + &letters.as_str().to_lowercase()).into())
        }
        "title" => {
            let mut is_inside = false;
            let mut out = String::new();
            for letter in text.chars() {
                if is_inside {
                    out.extend(letter.to_lowercase());
                } else {
                    out.extend(letter.to_uppercase());
                }
                is_inside = letter.is_alphabetic();
            }
            Ok(out.into())
        }
        "lower" => no_arguments(call).map(|()| text.to_lowercase().into()),
        "upper" => no_arguments(call).map(|()| text.to_uppercase().into()),
        "isalpha" => Ok(all(text, char::is_alphabetic)),
        "isdigit" => Ok(all(text, |letter| letter.is_ascii_digit())),
        "isspace" => Ok(all(text, char::is_whitespace)),
        "count" => {
            let part = one_text(call)?;
            Value::count(text.matches(&*part).count())
        }
        "find" => {
            let part = one_text(call)?;
            found(text.find(&*part))
        }
        "rfind" => {
            let part = one_text(call)?;
            found(text.rfind(&*part))
        }
        "index" => {
            let part = one_text(call)?;
            match text.find(&*part) {
                None => Err(failure(format!("{} is not in the text", quoted(&part)))),
                at => found(at),
            }
        }
        "startswith" => ends(call, |part| text.starts_with(part)),
        "endswith" => ends(call, |part| text.ends_with(part)),
        "removeprefix" => {
            let part = one_text(call)?;
            Ok(text.strip_prefix(&*part).unwrap_or(text).into())
        }
        "removesuffix" => {
            let part = one_text(call)?;
            Ok(text.strip_suffix(&*part).unwrap_or(text).into())
        }
        "replace" => {
            let [from, to] = call.exactly()?;
            let [from, to] = [call.text(&from)?, call.text(&to)?];
            let times = text.matches(&*from).count();
            call.surroundings
                .budget()
                .spend_text(times.saturating_mul(to.len()))?;
            Ok(text.replace(&*from, &to).into())
        }
        "strip" | "lstrip" | "rstrip" => stripped(text, call),
        "split" | "rsplit" => split(text, call),
        "splitlines" => Value::list(text.lines().map(Value::from).collect()),
        "join" => {
            let [list] = call.exactly()?;
            let items = call.items(&list)?;
            let texts = items.iter().map(|item| call.text(item));
            let texts = texts.collect::<Result<Vec<_>, _>>()?;
            let length: usize = texts.iter().map(|item| item.len() + text.len()).sum();
            call.surroundings.budget().spend_text(length)?;
            Ok(texts.join(text).into())
        }
        "format" => format(text, call),
        _ => Err(missing(&text.into(), call.name)),
    }
}

fn no_arguments(call: &mut Call<'_>) -> Result<(), Failure> {
    call.exactly::<0>().map(|_| ())
}

fn one_text(call: &mut Call<'_>) -> Result<std::rc::Rc<str>, Failure> {
    let [value] = call.exactly()?;
    call.text(&value)
}

/// True if there are letters and all are of a kind.
fn all(text: &str, is: impl Fn(char) -> bool) -> Value {
    Value::Bool(!text.is_empty() && text.chars().all(is))
}

/// True if a text has an end, or one of several in a tuple.
fn ends(call: &mut Call<'_>, has: impl Fn(&str) -> bool) -> Result<Value, Failure> {
    let [part] = call.exactly()?;
    let parts = match &part {
        Value::List(list) if list.is_tuple => list.items().clone(),
        other => vec![other.clone()],
    };
    let parts = parts.iter().map(|part| call.text(part));
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    Ok(Value::Bool(parts.iter().any(|part| has(part))))
}

fn stripped(text: &str, call: &mut Call<'_>) -> Result<Value, Failure> {
    let letters = if call.values.is_empty() {
        None
    } else {
        Some(one_text(call)?)
    };
    let is = |letter: char| match &letters {
        None => letter.is_whitespace(),
        Some(letters) => letters.contains(letter),
    };
    let text = if call.name == "rstrip" {
        text
    } else {
        text.trim_start_matches(is)
    };
    let text = if call.name == "lstrip" {
        text
    } else {
        text.trim_end_matches(is)
    };
    Ok(text.into())
}

fn split(text: &str, call: &mut Call<'_>) -> Result<Value, Failure> {
    let (separator, most) = if call.values.is_empty() {
        (None, None)
    } else {
        let (separator, most) = call.one_or_two()?;
        let separator = match separator {
            Value::None => None,
            other => Some(call.text(&other)?),
        };
        (separator, most)
    };
    call.surroundings.budget().spend(text.len())?;
    let most = most.map(|most| call.integer(&most)).transpose()?;
    let pieces = match most.and_then(|most| usize::try_from(most).ok()) {
        Some(most) => most + 1,
        None => usize::MAX,
    };
    let from_end = call.name == "rsplit";
    let words: Vec<&str> = match &separator {
        Some(separator) if separator.is_empty() => return Err(failure("a separator is empty")),
        Some(separator) if from_end => {
            let mut words: Vec<&str> = text.rsplitn(pieces, &**separator).collect();
            words.reverse();
            words
        }
        Some(separator) => text.splitn(pieces, &**separator).collect(),
        None if pieces == usize::MAX => text.split_whitespace().collect(),
        None => {
            return Err(failure_with_hint(
                "a limit of words without a separator is not supported",
                "name the separator: split(' ', 1)",
            ));
        }
    };
    Value::list(words.into_iter().map(Value::from).collect())
}

/// Replaces `{}`, `{0}` and `{name}`.
fn format(text: &str, call: &mut Call<'_>) -> Result<Value, Failure> {
    let mut out = String::new();
    let mut rest = text;
    let mut next = 0;
    while let Some(at) = rest.find(['{', '}']) {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some(after) = rest.strip_prefix("{{").or(rest.strip_prefix("}}")) {
            out.push_str(&rest[..1]);
            rest = after;
            continue;
        }
        let end = rest.find('}').filter(|_| rest.starts_with('{'));
        let end = end.ok_or_else(|| failure("a brace in a format has no other"))?;
        let field = &rest[1..end];
        let value = if field.is_empty() {
            next += 1;
            call.values.get(next - 1)
        } else if let Ok(index) = field.parse::<usize>() {
            call.values.get(index)
        } else if field.contains([':', '!', '.', '[']) {
            return Err(failure_with_hint(
                format!("the format {} is not supported", quoted(field)),
                "use round(…)",
            ));
        } else {
            let mut named = call.named.iter();
            let named = named.find(|(name, _)| &**name == field);
            named.map(|(_, value)| value)
        };
        let value =
            value.ok_or_else(|| failure(format!("the format has no value {}", quoted(field))))?;
        call.surroundings.budget().spend(value.steps())?;
        out.push_str(&value.text());
        rest = &rest[end + 1..];
    }
    out.push_str(rest);
    call.surroundings.budget().spend_text(out.len())?;
    Ok(out.into())
}

fn of_list(list: &List, call: &mut Call<'_>) -> Result<Value, Failure> {
    call.surroundings.budget().spend(list.items().len())?;
    match call.name {
        "count" => {
            let [value] = call.exactly()?;
            let items = list.items();
            Value::count(items.iter().filter(|item| item.equals(&value)).count())
        }
        "index" => {
            let [value] = call.exactly()?;
            let items = list.items();
            let mut found = None;
            for (at, item) in items.iter().enumerate() {
                if compare(Comparison::Equal, item, &value)? {
                    found = Some(at);
                    break;
                }
            }
            let missing = || failure(format!("the list has no {}", value.literal()));
            Value::count(found.ok_or_else(missing)?)
        }
        "pop" if list.is_tuple => Err(failure("a tuple cannot change")),
        _ => {
            let at = if call.values.is_empty() {
                -1
            } else {
                let [at] = call.exactly()?;
                call.integer(&at)?
            };
            let length = list.items().len();
            let at = position(at, length).ok_or_else(|| beyond(at, length))?;
            Ok(list.items_mut().remove(at))
        }
    }
}

/// The index of an item, counted from the end if it is negative.
pub(super) fn position(at: i64, length: usize) -> Option<usize> {
    let length = i64::try_from(length).ok()?;
    let at = if at < 0 { at + length } else { at };
    usize::try_from(at).ok().filter(|_| at < length)
}

/// The error of an index without an item.
pub(super) fn beyond(at: i64, length: usize) -> Failure {
    failure(format!("the index {at} is beyond the {length} items"))
}

fn of_map(map: &Map, call: &mut Call<'_>) -> Result<Value, Failure> {
    call.surroundings.budget().spend(map.entries().len())?;
    match call.name {
        "get" => {
            let (key, other) = call.one_or_two()?;
            key.check_key()?;
            Ok(map.get(&key).or(other).unwrap_or(Value::None))
        }
        "keys" => {
            no_arguments(call)?;
            Value::list(map.entries().iter().map(|(key, _)| key.clone()).collect())
        }
        "values" => {
            no_arguments(call)?;
            let values = map
                .entries()
                .iter()
                .map(|(_, value)| value.clone())
                .collect();
            Value::list(values)
        }
        _ => {
            no_arguments(call)?;
            let pairs = map.entries();
            let pairs = pairs
                .iter()
                .map(|(key, value)| Value::tuple(vec![key.clone(), value.clone()]));
            Value::list(pairs.collect::<Result<_, _>>()?)
        }
    }
}

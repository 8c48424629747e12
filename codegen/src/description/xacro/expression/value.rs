//! Values of expressions: those of Python, as far as descriptions of robots use them.

use std::cell::{Ref, RefCell, RefMut};
use std::cmp::Ordering;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::fmt::Write;
use std::rc::Rc;

use crate::description::xacro::failure::{Failure, failure};

/// Largest integer. Beyond it, numbers of 64 bits skip integers, and none of a robot is as large.
pub(in crate::description::xacro) const LARGEST_INTEGER: i64 = 1 << 53;

/// Maximum depth of lists in lists.
const MOST_NESTED: usize = 40;

/// Maximum number of items of a list, with those of the lists in it. Lists share their items, so that without it few
/// of them could stand for very many.
const MOST_PARTS: usize = 100_000;

/// The number of a scope of properties.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) struct ScopeId(pub(in crate::description::xacro) usize);

/// A namespace of functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) enum Library {
    Math,
    Python,
    Xacro,
}

/// A function of a namespace, by its place in the table of its functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::xacro) struct FunctionId {
    pub(super) library: Library,
    pub(super) index: usize,
}

/// A value.
#[derive(Clone, Debug)]
pub(in crate::description::xacro) enum Value {
    None,
    Bool(bool),
    Integer(i64),
    Float(f64),
    Text(Rc<str>),
    List(List),
    Map(Map),
    Function(FunctionId),
    Library(Library),
    /// The properties of an included file with a namespace.
    Scope(ScopeId),
}

/// A list or a tuple; copies share their items.
#[derive(Clone, Debug)]
pub(in crate::description::xacro) struct List {
    items: Rc<RefCell<Vec<Value>>>,
    pub(in crate::description::xacro) is_tuple: bool,
    extent: Extent,
}

/// A dictionary, in the order of its keys' definition; copies share their entries.
#[derive(Clone, Debug)]
pub(in crate::description::xacro) struct Map {
    entries: Rc<RefCell<Vec<(Value, Value)>>>,
    /// True if `map.key` means `map["key"]`, as in dictionaries of YAML files.
    pub(in crate::description::xacro) is_dotted: bool,
    extent: Extent,
}

/// Depth and number of parts of a list, when it was made.
#[derive(Clone, Copy, Debug)]
struct Extent {
    depth: usize,
    parts: usize,
}

impl List {
    pub(in crate::description::xacro) fn new(
        items: Vec<Value>,
        is_tuple: bool,
    ) -> Result<Self, Failure> {
        Ok(Self {
            extent: extent(items.iter())?,
            items: Rc::new(RefCell::new(items)),
            is_tuple,
        })
    }

    pub(in crate::description::xacro) fn items(&self) -> Ref<'_, Vec<Value>> {
        self.items.borrow()
    }

    pub(super) fn items_mut(&self) -> RefMut<'_, Vec<Value>> {
        self.items.borrow_mut()
    }
}

impl Map {
    /// A dictionary; of entries with equal keys, the last one counts.
    pub(in crate::description::xacro) fn new(
        entries: Vec<(Value, Value)>,
        is_dotted: bool,
    ) -> Result<Self, Failure> {
        let extent = extent(entries.iter().flat_map(|(key, value)| [key, value]))?;
        let mut kept: Vec<(Value, Value)> = Vec::with_capacity(entries.len());
        let mut places: HashMap<String, usize> = HashMap::new();
        for (key, value) in entries {
            key.check_key()?;
            // Equal numbers are one key, whatever their types.
            let word = key.as_number().map_or_else(|| key.literal(), digits);
            match places.entry(word) {
                Entry::Occupied(place) => kept[*place.get()].1 = value,
                Entry::Vacant(place) => {
                    place.insert(kept.len());
                    kept.push((key, value));
                }
            }
        }
        Ok(Self {
            entries: Rc::new(RefCell::new(kept)),
            is_dotted,
            extent,
        })
    }

    pub(in crate::description::xacro) fn entries(&self) -> Ref<'_, Vec<(Value, Value)>> {
        self.entries.borrow()
    }

    /// The value of a key. Dictionaries in a dotted one are dotted, too.
    pub(in crate::description::xacro) fn get(&self, key: &Value) -> Option<Value> {
        let entries = self.entries();
        let (_, value) = entries.iter().find(|(known, _)| known.equals(key))?;
        let mut value = value.clone();
        if let Value::Map(inner) = &mut value {
            inner.is_dotted |= self.is_dotted;
        }
        Some(value)
    }
}

impl Value {
    /// An error for a value that cannot be a key of a dictionary: a list or a dictionary, or a tuple with one.
    pub(super) fn check_key(&self) -> Result<(), Failure> {
        match self {
            Self::List(list) if list.is_tuple => list.items().iter().try_for_each(Self::check_key),
            Self::List(_) | Self::Map(_) => Err(failure(format!(
                "{} cannot be a key of a dictionary",
                self.kind()
            ))),
            _ => Ok(()),
        }
    }
}

/// The extent of a list with these items.
fn extent<'v>(items: impl Iterator<Item = &'v Value>) -> Result<Extent, Failure> {
    let mut extent = Extent { depth: 1, parts: 1 };
    for item in items {
        let inner = item.extent();
        extent.depth = extent.depth.max(inner.depth + 1);
        extent.parts = extent.parts.saturating_add(inner.parts);
    }
    if extent.depth > MOST_NESTED || extent.parts > MOST_PARTS {
        return Err(failure(format!(
            "a list is nested more than {MOST_NESTED} deep, or has more than {MOST_PARTS} items"
        )));
    }
    Ok(extent)
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl Value {
    /// An integer within the largest one.
    pub(in crate::description::xacro) fn integer(value: i64) -> Result<Self, Failure> {
        if value.unsigned_abs() > LARGEST_INTEGER.unsigned_abs() {
            return Err(failure("an integer is larger than 2^53"));
        }
        Ok(Self::Integer(value))
    }

    /// The number of items of a list, a dictionary or a text.
    pub(in crate::description::xacro) fn count(count: usize) -> Result<Self, Failure> {
        Self::integer(i64::try_from(count).unwrap_or(i64::MAX))
    }

    pub(in crate::description::xacro) fn list(items: Vec<Self>) -> Result<Self, Failure> {
        List::new(items, false).map(Self::List)
    }

    pub(in crate::description::xacro) fn tuple(items: Vec<Self>) -> Result<Self, Failure> {
        List::new(items, true).map(Self::List)
    }

    fn extent(&self) -> Extent {
        match self {
            Self::List(list) => list.extent,
            Self::Map(map) => map.extent,
            Self::Text(text) => Extent {
                depth: 0,
                parts: text.len() / 64 + 1,
            },
            _ => Extent { depth: 0, parts: 1 },
        }
    }

    /// Steps to print or compare it.
    pub(in crate::description::xacro) fn steps(&self) -> usize {
        self.extent().parts
    }

    /// The name of its type, for messages.
    pub(in crate::description::xacro) const fn kind(&self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Bool(_) => "a boolean",
            Self::Integer(_) => "an integer",
            Self::Float(_) => "a number",
            Self::Text(_) => "a text",
            Self::List(list) if list.is_tuple => "a tuple",
            Self::List(_) => "a list",
            Self::Map(_) => "a dictionary",
            Self::Function(_) => "a function",
            Self::Library(_) | Self::Scope(_) => "a namespace",
        }
    }

    /// True if it counts as true in a condition.
    pub(in crate::description::xacro) fn is_true(&self) -> bool {
        match self {
            Self::None => false,
            Self::Bool(value) => *value,
            Self::Integer(value) => *value != 0,
            Self::Float(value) => *value != 0.0,
            Self::Text(text) => !text.is_empty(),
            Self::List(list) => !list.items().is_empty(),
            Self::Map(map) => !map.entries().is_empty(),
            Self::Function(_) | Self::Library(_) | Self::Scope(_) => true,
        }
    }

    /// The integer of a boolean or an integer.
    pub(in crate::description::xacro) fn as_integer(&self) -> Option<i64> {
        match self {
            Self::Bool(value) => Some(i64::from(*value)),
            Self::Integer(value) => Some(*value),
            _ => None,
        }
    }

    /// The number of a boolean, an integer or a float.
    pub(in crate::description::xacro) fn as_number(&self) -> Option<f64> {
        match self {
            Self::Float(value) => Some(*value),
            #[expect(
                clippy::cast_precision_loss,
                reason = "integers beyond 2^53 do not exist here"
            )]
            other => other.as_integer().map(|value| value as f64),
        }
    }

    /// Python's `==`.
    pub(in crate::description::xacro) fn equals(&self, other: &Self) -> bool {
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number()) {
            return a == b;
        }
        match (self, other) {
            (Self::None, Self::None) => true,
            (Self::Text(a), Self::Text(b)) => a == b,
            (Self::List(a), Self::List(b)) => {
                let (items, others) = (a.items(), b.items());
                a.is_tuple == b.is_tuple
                    && items.len() == others.len()
                    && items.iter().zip(others.iter()).all(|(a, b)| a.equals(b))
            }
            (Self::Map(a), Self::Map(b)) => {
                let (entries, others) = (a.entries(), b.entries());
                let has = |(key, value): &(Self, Self)| {
                    let mut others = others.iter();
                    others.any(|(other, found)| other.equals(key) && found.equals(value))
                };
                entries.len() == others.len() && entries.iter().all(has)
            }
            (Self::Function(a), Self::Function(b)) => a == b,
            (Self::Library(a), Self::Library(b)) => a == b,
            (Self::Scope(a), Self::Scope(b)) => a == b,
            _ => false,
        }
    }

    /// Python's order of numbers, texts and lists; `None` with NaN, and an error for other pairs.
    pub(in crate::description::xacro) fn order(
        &self,
        other: &Self,
    ) -> Result<Option<Ordering>, Failure> {
        if let (Some(a), Some(b)) = (self.as_number(), other.as_number()) {
            return Ok(a.partial_cmp(&b));
        }
        match (self, other) {
            (Self::Text(a), Self::Text(b)) => Ok(Some(a.cmp(b))),
            (Self::List(a), Self::List(b)) if a.is_tuple == b.is_tuple => {
                let (items, others) = (a.items(), b.items());
                let different = items.iter().zip(others.iter()).find(|(a, b)| !a.equals(b));
                match different {
                    Some((a, b)) => a.order(b),
                    None => Ok(Some(items.len().cmp(&others.len()))),
                }
            }
            _ => Err(failure(format!(
                "{} and {} have no order",
                self.kind(),
                other.kind()
            ))),
        }
    }

    /// Python's `str`.
    pub(in crate::description::xacro) fn text(&self) -> Rc<str> {
        match self {
            Self::Text(text) => Rc::clone(text),
            other => other.literal().into(),
        }
    }

    /// Python's `repr`.
    pub(in crate::description::xacro) fn literal(&self) -> String {
        match self {
            Self::None => "None".to_owned(),
            Self::Bool(true) => "True".to_owned(),
            Self::Bool(false) => "False".to_owned(),
            Self::Integer(value) => value.to_string(),
            Self::Float(value) => digits(*value),
            Self::Text(text) => quoted(text),
            Self::List(list) => {
                let items: Vec<String> = list.items().iter().map(Self::literal).collect();
                match (list.is_tuple, &items[..]) {
                    (false, items) => format!("[{}]", items.join(", ")),
                    (true, [only]) => format!("({only},)"),
                    (true, items) => format!("({})", items.join(", ")),
                }
            }
            Self::Map(map) => {
                let entries = map.entries();
                let entries = entries.iter().map(|(key, value)| {
                    let (key, value) = (key.literal(), value.literal());
                    format!("{key}: {value}")
                });
                format!("{{{}}}", entries.collect::<Vec<_>>().join(", "))
            }
            Self::Function(_) => "<built-in function>".to_owned(),
            Self::Library(_) | Self::Scope(_) => "<namespace>".to_owned(),
        }
    }
}

/// A number with Python's digits: the fewest that are read as the same number, with an exponent below 1e-4 and from
/// 1e16 on.
pub(super) fn digits(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() {
            "nan".to_owned()
        } else if value > 0.0 {
            "inf".to_owned()
        } else {
            "-inf".to_owned()
        };
    }
    let scientific = format!("{value:e}");
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if value == 0.0 || (-4..16).contains(&exponent) {
        let plain = value.to_string();
        if plain.contains('.') {
            plain
        } else {
            plain + ".0"
        }
    } else {
        let sign = if exponent < 0 { '-' } else { '+' };
        format!("{mantissa}e{sign}{:02}", exponent.abs())
    }
}

/// A text in Python's quotes.
fn quoted(text: &str) -> String {
    let quote = if text.contains('\'') && !text.contains('"') {
        '"'
    } else {
        '\''
    };
    let mut out = String::from(quote);
    for letter in text.chars() {
        match letter {
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '\r' => out.push_str("\\r"),
            '\\' => out.push_str("\\\\"),
            letter if letter == quote => out.extend(['\\', letter]),
            letter if letter.is_ascii_control() => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\x{:02x}", u32::from(letter));
            }
            letter => out.push(letter),
        }
    }
    out.push(quote);
    out
}

//! Values of expressions, as Python computes them.

use std::collections::HashMap;

use super::super::budget::{Budget, FEW_LEVELS};
use super::super::failure::{Failure, failure};
use super::evaluate;
use super::parse::{is_name, parse};
use super::surroundings::Surroundings;
use super::value::{Map, ScopeId, Value};

/// Some properties.
struct Properties {
    budget: Budget,
    values: HashMap<String, Value>,
}

impl Surroundings for Properties {
    fn budget(&mut self) -> &mut Budget {
        &mut self.budget
    }

    fn property(&mut self, name: &str) -> Result<Option<Value>, Failure> {
        Ok(self.values.get(name).cloned())
    }

    fn property_of(&mut self, _: ScopeId, _: &str) -> Result<Option<Value>, Failure> {
        Ok(None)
    }

    fn names(&self) -> Vec<String> {
        self.values.keys().cloned().collect()
    }

    fn argument(&mut self, name: &str) -> Result<Value, Failure> {
        Ok(format!("argument {name}").into())
    }

    fn yaml(&mut self, _: &str) -> Result<Value, Failure> {
        Err(failure("no files"))
    }

    fn full_path(&mut self, file: &str) -> Result<Value, Failure> {
        Ok(format!("/package/{file}").into())
    }

    fn warn(&mut self, _: String) {}
}

fn evaluated(text: &str) -> Result<Value, Failure> {
    let inner = vec![("mass".into(), Value::Float(1.5))];
    let inner = Map::new(inner, false).unwrap();
    let limits = Map::new(vec![("arm".into(), Value::Map(inner))], true).unwrap();
    let values = [
        ("length", Value::Float(0.5)),
        ("count", Value::Integer(3)),
        ("name", "left arm".into()),
        ("limits", Value::Map(limits)),
    ];
    let mut properties = Properties {
        budget: Budget::new(FEW_LEVELS),
        values: values
            .into_iter()
            .map(|(name, value)| (name.to_owned(), value))
            .collect(),
    };
    parse(text).and_then(|expression| evaluate(&expression, &mut properties))
}

/// The value as Python's `repr` prints it.
fn shown(text: &str) -> String {
    match evaluated(text) {
        Ok(value) => value.literal(),
        Err(failure) => panic!("{text}: {failure:?}"),
    }
}

/// The message of an error.
fn refused(text: &str) -> String {
    match evaluated(text) {
        Ok(value) => panic!("{text} is {}", value.literal()),
        Err(Failure::Mistake(mistake)) => match mistake.hint {
            Some(hint) => format!("{}; {hint}", mistake.what),
            None => mistake.what,
        },
        Err(Failure::Reported) => panic!("{text}: reported"),
    }
}

/// Asserts that the values are those that Python 3.11 printed for the same texts.
fn check(values: &[(&str, &str)]) {
    for (text, printed) in values {
        assert_eq!(shown(text), *printed, "{text}");
    }
}

#[test]
fn numbers_print_as_in_python() {
    check(&[
        ("1", "1"),
        ("1.0", "1.0"),
        ("1e5", "100000.0"),
        ("1e16", "1e+16"),
        ("1e22", "1e+22"),
        ("123456789012345680.0", "1.2345678901234568e+17"),
        ("0.0001", "0.0001"),
        ("0.00001", "1e-05"),
        ("1.5e-7", "1.5e-07"),
        ("1e-300", "1e-300"),
        ("0.1 + 0.2", "0.30000000000000004"),
        ("-0.0", "-0.0"),
        ("1_000", "1000"),
        ("0x1F", "31"),
        (".5", "0.5"),
        ("5.", "5.0"),
        ("inf", "inf"),
        ("-inf", "-inf"),
        ("nan", "nan"),
    ]);
}

#[test]
fn operators_bind_as_in_python() {
    check(&[
        ("1 + 2 * 3", "7"),
        ("(1 + 2) * 3", "9"),
        ("2 ** 3 ** 2", "512"),
        ("-2 ** 2", "-4"),
        ("2 ** -1", "0.5"),
        ("-7 // 2", "-4"),
        ("7 // -2.0", "-4.0"),
        ("-7 % 3", "2"),
        ("7.5 % -2", "-0.5"),
        ("0.7 // 0.1", "6.0"),
        ("1 / 3", "0.3333333333333333"),
        ("4 / 2", "2.0"),
        ("1 - 2 - 3", "-4"),
        ("not 1 == 2", "True"),
        ("1 < 2 < 3", "True"),
        ("1 < 3 < 2", "False"),
        ("1 if 0 else 2 if 0 else 3", "3"),
        ("0 or 'a' and 'b'", "'b'"),
        ("'' or 0.0", "0.0"),
        ("True + True", "2"),
        ("1 == 1.0 == True", "True"),
        ("'a' in 'cab'", "True"),
        ("2 not in [1, 3]", "True"),
        ("None is None", "True"),
        ("1 is not None", "True"),
        ("+ - + 1", "-1"),
        ("2 * length ** 2", "0.5"),
    ]);
}

#[test]
fn texts_and_lists_are_those_of_python() {
    check(&[
        ("'a' + \"b\" 'c'", "'abc'"),
        ("'ab' * 2", "'abab'"),
        ("\"it's\"", "\"it's\""),
        (r"'\n\t\x41\\'", "'\\n\\tA\\\\'"),
        (
            "[1, 2.0, 'a', None, (1,), ()]",
            "[1, 2.0, 'a', None, (1,), ()]",
        ),
        ("(1, 2) + (3,)", "(1, 2, 3)"),
        ("[[1, 2], [3]][0][-1]", "2"),
        ("'abcdef'[1:4]", "'bcd'"),
        ("[0, 1, 2, 3][::-1]", "[3, 2, 1, 0]"),
        ("[0, 1, 2, 3][-3:9]", "[1, 2, 3]"),
        ("[i * i for i in range(4) if i % 2]", "[1, 9]"),
        ("[a + b for a, b in [(1, 2), (3, 4)]]", "[3, 7]"),
        ("[(i, j) for i in range(2) for j in range(i)]", "[(1, 0)]"),
        ("dict(a=1, b=[2])", "{'a': 1, 'b': [2]}"),
        ("dict([('a', 1), ('a', 2)])", "{'a': 2}"),
        ("dict(a=1)['a']", "1"),
        ("dict(a=1).get('b', 7)", "7"),
        ("[k for k in dict(a=1, b=2)]", "['a', 'b']"),
        ("limits.arm.mass + limits['arm']['mass']", "3.0"),
        ("'a b  c'.split()", "['a', 'b', 'c']"),
        ("'a b  c'.split(' ')", "['a', 'b', '', 'c']"),
        ("'1,2,3'.split(',', 1)", "['1', '2,3']"),
        ("'{} {1} {x} {{}}'.format(1, 2, x='y')", "'1 2 y {}'"),
        ("' ab '.strip() + '.'", "'ab.'"),
        ("'xxaxx'.strip('x')", "'a'"),
        ("name.replace(' ', '_').upper()", "'LEFT_ARM'"),
        ("', '.join(['a', 'b'])", "'a, b'"),
        ("[3, 1, 2].index(1)", "1"),
        ("[3, 1, 2].pop(0)", "3"),
        ("[1, 2] == [1.0, 2]", "True"),
        ("(1, 2) < (1, 3)", "True"),
    ]);
}

#[test]
fn functions_are_those_of_python() {
    check(&[
        ("len('abc') + len([1, 2]) + len(dict(a=1))", "6"),
        ("str(1.50) + str(True)", "'1.5True'"),
        ("int('42') + int(-2.7)", "40"),
        ("float('1e-3')", "0.001"),
        ("max(1, 2.5) + min([4, 3])", "5.5"),
        ("round(2.5), round(3.5), round(2.675, 2)", "(2, 4, 2.67)"),
        ("round(-0.5)", "0"),
        ("python.abs(-3), math.fabs(-3)", "(3, 3.0)"),
        ("range(2, 10, 3)", "[2, 5, 8]"),
        ("list(map(float, '1 2'.split()))", "[1.0, 2.0]"),
        ("python.sum([1, 2, 3.5])", "6.5"),
        ("sorted([3, 1, 2])", "[1, 2, 3]"),
        (
            "python.list(python.zip([1, 2], 'ab'))",
            "[(1, 'a'), (2, 'b')]",
        ),
        ("python.isinstance(1.0, (int, float))", "True"),
        ("python.isinstance('a', python.str)", "True"),
        ("pi", "3.141592653589793"),
        ("math.pi / 2", "1.5707963267948966"),
        ("radians(180)", "3.141592653589793"),
        ("degrees(pi)", "180.0"),
        ("sin(pi / 6)", "0.49999999999999994"),
        ("cos(radians(90))", "6.123233995736766e-17"),
        ("atan2(1, -1)", "2.356194490192345"),
        ("sqrt(2) * 2 ** 0.5", "2.0000000000000004"),
        ("floor(-1.5), ceil(1.2), trunc(-1.7)", "(-2, 2, -1)"),
        ("hypot(3, 4)", "5.0"),
        ("fmod(-7, 3)", "-1.0"),
        ("xacro.arg('type')", "'argument type'"),
        ("xacro.abs_filename('a.yaml')", "'/package/a.yaml'"),
        ("xacro.dotify(dict(a=dict(b=1))).a.b", "1"),
        ("xacro.tokenize('a, b;c')", "['a', 'b', 'c']"),
        ("xacro.warning('careful')", "''"),
    ]);
}

#[test]
fn mistakes_have_reasons() {
    for (text, message) in [
        ("", "the expression is empty"),
        ("1 +", "the expression ends too early"),
        ("(1", "\")\" is missing at the end"),
        ("1 2", "unexpected \"2\""),
        ("a = 1", "unexpected \"=\"; write == to compare"),
        ("1 if 2", "`if` has no `else`"),
        (
            "lenght",
            "name \"lenght\" is not defined; did you mean \"length\"?",
        ),
        ("abs(1)", "name \"abs\" is not defined; write python.abs"),
        ("true", "name \"true\" is not defined; write True or False"),
        ("1 / 0", "division by zero"),
        (
            "'a' + 1",
            "a text and an integer cannot be added; write str(…) around what is not a text",
        ),
        (
            "'%d' % 1",
            "formats by % are not supported; join texts by +, and numbers by str(…)",
        ),
        ("[1][1]", "the index 1 is beyond the 1 items"),
        (
            "limits['leg']",
            "the dictionary has no key 'leg'; keys: \"arm\"",
        ),
        (
            "dict(a=1).a",
            "a dictionary has no member \"a\"; write [\"a\"]",
        ),
        (
            "name.__class__",
            "a text has no member \"__class__\"; known methods: capitalize, count, endswith, find, format, index, isalpha, isdigit, isspace, join, lower, lstrip, removeprefix, removesuffix, replace, rfind, rsplit, rstrip, split, splitlines, startswith, strip, title and upper",
        ),
        (
            "limits in limits",
            "a dictionary cannot be a key of a dictionary",
        ),
        (
            "limits.get((1, [2]))",
            "a list cannot be a key of a dictionary",
        ),
        ("sqrt(-1)", "sqrt of -1 is undefined"),
        ("(-8) ** 0.5", "a power of a negative number is complex"),
        ("1 < 'a'", "an integer and a text have no order"),
        ("lambda: 1", "functions by `lambda` are not supported"),
        ("f'{name}'", "texts with the prefix f are not supported"),
        ("'open", "a text in quotes does not end"),
        ("1 & 2", "the operator & is not supported; write `and`"),
        (
            "python.isinstance(1, 2)",
            "isinstance needs a type, such as python.str",
        ),
        ("int('1.5')", "\"1.5\" is no integer"),
        ("len(1)", "len needs a list, not an integer"),
        ("sin()", "sin takes 1 arguments and has 0"),
        ("xacro.fatal('stop', 1)", "stop 1"),
        ("open('/etc/passwd')", "name \"open\" is not defined"),
        ("__import__('os')", "name \"__import__\" is not defined"),
    ] {
        assert_eq!(refused(text), message, "{text}");
    }
}

#[test]
fn hostile_expressions_end_with_an_error() {
    for (text, message) in [
        (
            "'a' * 10 ** 9",
            "the file expands to more than a robot can have",
        ),
        (
            "range(10 ** 9)",
            "the file expands to more than a robot can have",
        ),
        (
            "[0] * 10 ** 15",
            "the file expands to more than a robot can have",
        ),
        ("10 ** 10 ** 10", "an integer is larger than 2^53"),
        ("2 ** 53 + 1", "an integer is larger than 2^53"),
        ("9999999999999999999999", "an integer is larger than 2^53"),
        ("10.0 ** 400", "a power is too large"),
        (
            "len([0 for a in range(10000) for b in range(10000)])",
            "the file expands to more than a robot can have",
        ),
        (
            "len([[0] * 1000] * 1000)",
            "a list is nested more than 40 deep, or has more than 100000 items",
        ),
    ] {
        assert!(
            refused(text).starts_with(message),
            "{text}: {}",
            refused(text)
        );
    }
    let deep = format!("{}1{}", "(".repeat(1000), ")".repeat(1000));
    let message = "an expression is nested more than 40 deep";
    assert_eq!(refused(&deep), message);
    assert_eq!(refused(&"-".repeat(5000)), message);
    assert_eq!(refused(&format!("[{}]", "[".repeat(1000))), message);
    let message = "an expression has more than 400 operations and values";
    assert_eq!(refused(&format!("1{}", "+1".repeat(500_000))), message);
}

#[test]
fn names_are_words_that_python_does_not_use() {
    for name in ["a", "_a1", "größe"] {
        assert!(is_name(name), "{name}");
    }
    for name in ["", "1a", "a b", "a-b", "a.b", "if", "None", "class"] {
        assert!(!is_name(name), "{name}");
    }
}

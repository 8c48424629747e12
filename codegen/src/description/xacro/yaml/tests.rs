//! Values of YAML files, as PyYAML reads them.

use super::super::expression::value::Value;
use super::super::failure::{Failure, failure};
use super::read;

fn evaluate(text: &str) -> Result<Value, Failure> {
    match text {
        "pi/2" => Ok(Value::Float(std::f64::consts::FRAC_PI_2)),
        text => text
            .parse()
            .map(Value::Float)
            .map_err(|_| failure("no number")),
    }
}

/// The value as Python's `repr` prints it.
fn shown(text: &str) -> String {
    match read(text, &mut evaluate) {
        Ok(value) => value.literal(),
        Err((line, failure)) => panic!("{text}: line {line}: {failure:?}"),
    }
}

/// The message of an error, after its line.
fn refused(text: &str) -> String {
    match read(text, &mut evaluate) {
        Ok(value) => panic!("{text} is {}", value.literal()),
        Err((line, Failure::Mistake(mistake))) => format!("{line}: {}", mistake.what),
        Err((_, Failure::Reported)) => panic!("{text}: reported"),
    }
}

#[test]
fn scalars_have_the_types_of_pyyaml() {
    for (text, value) in [
        ("1", "1"),
        ("-7", "-7"),
        ("010", "8"),
        ("0x10", "16"),
        ("1_000", "1000"),
        ("1.0", "1.0"),
        (".5", "0.5"),
        ("-1.5e-3", "-0.0015"),
        // PyYAML wants a point, and a sign in the exponent.
        ("1e-5", "'1e-5'"),
        ("1.0e5", "'1.0e5'"),
        (".inf", "inf"),
        ("yes", "True"),
        ("Off", "False"),
        ("true", "True"),
        ("~", "None"),
        ("", "None"),
        ("a b # c", "'a b'"),
        ("a#b", "'a#b'"),
        ("'it''s'", "\"it's\""),
        ("\"a\\tb\"", "'a\\tb'"),
        ("'1.0'", "'1.0'"),
        ("0 0 1", "'0 0 1'"),
        ("!degrees 180", "3.141592653589793"),
        ("!radians pi/2", "1.5707963267948966"),
        ("!millimeters 5", "0.005"),
    ] {
        assert_eq!(shown(text), value, "{text}");
    }
}

#[test]
fn mappings_and_sequences_nest() {
    let text = "%YAML 1.1\n---\n# limits\njoints:\n  - name: a\n    limits: {lower: -1.5, upper: !degrees 90}\n\
                \x20   axis: [0, 0,\n      1]\n  -\n    name: b\n  - [x, {y: 2}]\nempty:\nlist:\n- 1\n- - 2\n  - 3\n\"q: r\": 's: t'\nurl: a:b\n";
    assert_eq!(
        shown(text),
        "{'joints': [{'name': 'a', 'limits': {'lower': -1.5, 'upper': 1.5707963267948966}, 'axis': [0, 0, 1]}, \
         {'name': 'b'}, ['x', {'y': 2}]], 'empty': None, 'list': [1, [2, 3]], 'q: r': 's: t', 'url': 'a:b'}"
    );
    assert_eq!(shown("a: 1\nb: 2\na: 3"), "{'a': 3, 'b': 2}");
}

#[test]
fn anchors_are_shared_and_merged() {
    assert_eq!(
        shown("a: &x\n  m: 1\n  n: 2\nb: *x\nc:\n  <<: *x\n  n: 3\nd: &y 5\ne: [*y, *y]"),
        "{'a': {'m': 1, 'n': 2}, 'b': {'m': 1, 'n': 2}, 'c': {'m': 1, 'n': 3}, 'd': 5, 'e': [5, 5]}"
    );
    // A file of a few lines that stands for a billion items.
    let lines = (1..12)
        .map(|k| format!("a{k}: &a{k} [{}]\n", format!("*a{}, ", k - 1).repeat(10)))
        .collect::<Vec<_>>()
        .concat();
    assert!(refused(&format!("a0: &a0 1\n{lines}")).contains("has more than 100000 items"),);
}

#[test]
fn what_is_not_supported_is_an_error() {
    for (text, message) in [
        ("a: 1\n\tb: 2", "2: a tab is no indentation: write spaces"),
        ("a: 1\n   b: 2", "2: a scalar continues in a second line"),
        ("  a: 1\nb: 2", "2: the indentation fits no line above"),
        ("a: |\n  b", "2: a scalar continues in a second line"),
        ("a: |", "1: texts of several lines are not supported"),
        ("a: 1\nb", "2: \"b\" has no key"),
        ("a: !!float 1", "1: the tag \"!!float\" is not supported"),
        ("a: *b", "1: there is no anchor \"b\""),
        ("a: [1, 2", "1: \"]\" is missing"),
        ("a: 'b", "1: a text in quotes does not end in its line"),
        ("a: 1\n---\nb: 2", "2: the file has a second document"),
        ("a: [1] 2", "1: unexpected \"2\""),
    ] {
        assert_eq!(refused(text), message, "{text}");
    }
    let deep = "[".repeat(100_000);
    assert_eq!(refused(&deep), "1: mappings are nested too deeply");
    let deep = (0..1000)
        .map(|k| format!("{}a:\n", " ".repeat(k)))
        .collect::<Vec<_>>()
        .concat();
    assert!(refused(&deep).contains("nested too deeply"));
}

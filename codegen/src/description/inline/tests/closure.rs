//! Errors of loops.

use super::{errors_in, fine};
use crate::closure::Closure;
use crate::description::{Axis, Step};

/// The errors of a loop between existing links.
fn errors_in_loop(text: &str) -> String {
    errors_in(&format!("{text}\nlink a; joint j: revolute(z); link b;"))
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn loops_join_two_links() {
    let item = fine(
        "struct Arm;\nlink a; joint j: revolute(z); link b;\n\
         loop pin: revolute(-z) { from: a, to: b, at: xyz(1, 2, 3) rx(0.5), to_at: rz(0.1) }\n\
         loop cross: universal(x, [0.0, 0.6, 0.8]) { from: b, to: a }\n\
         loop bar: rod(0.25) { from: a, to: b }\n\
         loop ball: spherical { to: b, from: a }",
    );
    let loops = item.description.unwrap().loops;
    let [pin, cross, bar, ball] = &loops[..] else {
        panic!("{loops:?}");
    };
    assert!(matches!(pin.closure, Closure::Revolute));
    let axes = |k: usize| loops[k].axes.map(|axis| axis.map(|entry| entry.value));
    assert_eq!(axes(0), [[0.0, 0.0, -1.0]; 2]);
    assert!(
        matches!(
            pin.at[..],
            [Step::Translate([x, ..]), Step::Rotate(Axis::X, angle)]
                if x.value == 1.0 && angle.value == 0.5
        ),
        "{:?}",
        pin.at
    );
    assert!(matches!(pin.to_at[..], [Step::Rotate(Axis::Z, _)]));
    assert!(matches!(cross.closure, Closure::Universal));
    assert_eq!(axes(1), [[1.0, 0.0, 0.0], [0.0, 0.6, 0.8]]);
    assert_eq!(bar.closure.length().map(|length| length.value), Some(0.25));
    assert!(matches!(ball.closure, Closure::Spherical));
    assert_eq!([&ball.from.text, &ball.to.text], ["a", "b"]);
}

#[test]
fn errors_of_loops_show_the_syntax() {
    assert_eq!(
        errors_in_loop("loop p revolute(z) { from: a, to: b }"),
        "2:8: expected `:` after loop \"p\"\n  \
         hint: write loop pin: revolute(z) { from: coupler, to: rocker }\n"
    );
    assert_eq!(
        errors_in_loop("loop p: revolut(z) { from: a, to: b }"),
        "2:9: loop \"p\" has the unknown type \"revolut\"\n  hint: did you mean \"revolute\"? known \
         types: fixed, revolute, prismatic, cylindrical, universal, planar, translation, spherical and \
         rod\n"
    );
    assert_eq!(
        errors_in_loop("loop p: revolute { from: a, to: b }"),
        "2:9: loop \"p\" has no axis\n  hint: write revolute(z)\n"
    );
    assert_eq!(
        errors_in_loop("loop p: universal(x) { from: a, to: b }"),
        "2:20: loop \"p\" has no second axis\n  hint: write universal(x, y)\n"
    );
    assert_eq!(
        errors_in_loop("loop p: spherical(x) { from: a, to: b }"),
        "2:19: loop \"p\" is spherical and has no axis\n"
    );
    assert_eq!(
        errors_in_loop("loop p: rod { from: a, to: b }"),
        "2:9: loop \"p\" has no length\n  hint: write rod(0.3)\n"
    );
    assert_eq!(
        errors_in_loop("loop p: rod(0) { from: a, to: b }"),
        "2:13: the length of loop \"p\" is not positive: 0\n  \
         hint: write spherical to join two points\n"
    );
    assert_eq!(
        errors_in_loop("loop p: fixed { to: b, form: a }"),
        "2:24: loop \"p\" has the unknown key \"form\"\n  \
         hint: did you mean \"from\"? known keys: from, to, at and to_at\n\
         2:6: loop \"p\" has no link `from`\n  hint: name it, from: rocker\n"
    );
    assert_eq!(
        errors_in_loop("loop p: revolute(z, y) { from: a, to: b }"),
        "2:19: expected `)` after the axes of loop \"p\"\n"
    );
    assert_eq!(
        errors_in_loop("loop p: fixed { from: a, to: b } loop p: fixed { from: a, to: b }"),
        "2:39: there is another loop \"p\"\n"
    );
}

#[test]
fn an_axis_of_another_length_is_a_warning() {
    let item = fine(
        "struct Arm;\nlink a; joint j: revolute(z); link b;\n\
         loop pin: revolute([0.0, 3.0, 4.0]) { from: a, to: b }",
    );
    let warnings = item.description.unwrap().warnings;
    let messages: Vec<&str> = warnings.iter().map(|warning| &*warning.message).collect();
    assert_eq!(
        messages,
        ["the axis of loop \"pin\" has length 5, and is normalised"]
    );
}

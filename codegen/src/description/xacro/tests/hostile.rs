//! Files that would take all time, memory or stack.

use super::{errors, expand, read, robot};
use crate::description::changed::changed;

#[test]
fn endless_files_end_with_an_error() {
    let deep = "macros, files or expressions are nested too deeply";
    for (elements, message) in [
        (
            "<xacro:macro name=\"m\"><xacro:m/></xacro:macro><xacro:m/>",
            deep,
        ),
        (
            "<xacro:macro name=\"m\"><xacro:m/><xacro:m/></xacro:macro><xacro:m/>",
            deep,
        ),
        (
            "<xacro:macro name=\"m\" params=\"n\"><l/><xacro:if value=\"${n}\"><xacro:m n=\"${n - 1}\"/>\
             <xacro:m n=\"${n - 1}\"/></xacro:if></xacro:macro><xacro:m n=\"40\"/>",
            "the file expands to more than a robot can have",
        ),
        (
            "<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\" value=\"${a}\"/><l a=\"${a}\"/>",
            "property \"a\" is defined by itself",
        ),
        (
            "<xacro:property name=\"p\"><xacro:insert_block name=\"p\"/></xacro:property><xacro:insert_block name=\"p\"/>",
            deep,
        ),
    ] {
        let found = errors(elements);
        assert!(found.contains(message), "{elements}: {found}");
        assert!(found.lines().count() < 10, "{found}");
    }
    let chain = (1..20_000)
        .map(|k| {
            format!(
                "<xacro:property name=\"a{k}\" value=\"${{a{} + 1}}\"/>",
                k - 1
            )
        })
        .collect::<Vec<_>>()
        .concat();
    assert!(errors(&format!("{chain}<l a=\"${{a19999}}\"/>")).contains(deep));
    let doubled = (1..40)
        .map(|k| {
            format!(
                "<xacro:property name=\"a{k}\" value=\"${{a{0} + a{0}}}\"/>",
                k - 1
            )
        })
        .collect::<Vec<_>>()
        .concat();
    let text =
        format!("<xacro:property name=\"a0\" value=\"${{'x'}}\"/>{doubled}<l a=\"${{a39}}\"/>");
    assert!(errors(&text).contains("the file expands to more than a robot can have"));
    let nested = (1..46)
        .map(|k| {
            format!(
                "<xacro:property name=\"a{k}\" value=\"${{[a{0}, a{0}]}}\"/>",
                k - 1
            )
        })
        .collect::<Vec<_>>()
        .concat();
    let text =
        format!("<xacro:property name=\"a0\" value=\"${{[]}}\"/>{nested}<l a=\"${{a45}}\"/>");
    assert!(errors(&text).contains("a list is nested more than 40 deep"));
    let elements = format!("{}{}", "<a>".repeat(5000), "</a>".repeat(5000));
    assert!(errors(&elements).contains("nested too deeply"));
}

#[test]
fn entities_are_not_replaced() {
    let text = format!(
        "<!DOCTYPE r [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]>{}",
        robot("<link name=\"&c;\"/>")
    );
    let (found, errors) = read(&text);
    assert_eq!(errors, "");
    assert_eq!(found.unwrap().links[0].name.text, "&c;");
}

const FILE: &str = "<xacro:arg name=\"n\" default=\"2\"/><xacro:property name=\"a\" value=\"${[1, 2.5][0] * -2 ** 2}\"/>\
    <xacro:macro name=\"m\" params=\"x:=^|${a} y:='b c' *o **p\"><link name=\"${y}_$(arg n)\"><xacro:insert_block name=\"o\"/>\
    <xacro:if value=\"${x &lt; 3 and 'b' in y}\"><xacro:insert_block name=\"p\"/></xacro:if></link></xacro:macro>\
    <xacro:m y=\"${dict(k='b')['k'].upper().lower()}\"><o/><p><q a=\"${[i for i in range(3)]}\"/></p></xacro:m>";

#[test]
fn random_changes_never_panic() {
    assert_eq!(
        expand(FILE),
        "<link name=\"b_2\"><o/><q a=\"[0, 1, 2]\"/></link>"
    );
    let bytes = b"<>/\"'=&;$#{}()[]:.,*+-%^|\\ \n\x00\xc3\xa4azxm09eE_!";
    for text in changed(&robot(FILE), bytes, 0x9e37_79b9_7f4a_7c15).take(4000) {
        let _ = read(&text);
    }
}

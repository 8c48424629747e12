//! Hostile texts: too large, nested too deep, truncated, changed at random.

use super::{ARM, errors};
use crate::description::changed::changed;

#[test]
fn hostile_files_are_refused_quickly() {
    let nested = |depth: usize| {
        let open = "<a>".repeat(depth);
        let close = "</a>".repeat(depth);
        format!("<robot name=\"r\"><link name=\"a\"/>{open}{close}</robot>")
    };
    assert_eq!(errors(&nested(100_000)), "");
    assert!(errors(&nested(100_000)[..200_000]).contains("the file ends in the middle"));
    assert_eq!(
        errors(&"<a>".repeat(1_000_001)),
        "error: arm.urdf:1:3000001: the file has more than 1000000 elements and attributes\n"
    );
    let attributes = (0..129)
        .map(|i| format!(" a{i}=\"\""))
        .collect::<Vec<_>>()
        .concat();
    assert_eq!(
        errors(&format!("<robot\n{attributes}/>")),
        "error: arm.urdf:1:1: an element has more than 128 attributes\n"
    );
    let namespaces = (0..65)
        .map(|i| format!("<a xmlns:n{i}=\"u\">\n"))
        .collect::<Vec<_>>()
        .concat();
    assert_eq!(
        errors(&namespaces),
        "error: arm.urdf:65:1: the file declares more than 64 namespaces\n"
    );
    // Entities are never replaced, so their expansion takes no time.
    assert_eq!(
        errors(
            "<!DOCTYPE r [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]>\n\
             <robot name=\"&c;\"><link name=\"a\"/><link name=\"a\"/></robot>"
        ),
        "error: arm.urdf:2:47: there is another link \"a\"\n  hint: the other one is in line 2\n"
    );
    // The elements in a comment are not read.
    let comment = format!("<!-- {} -->", "<a = = =".repeat(500_000));
    assert_eq!(
        errors(&format!(
            "{comment}<robot name=\"r\"><link name=\"a\"/></robot>"
        )),
        ""
    );
}

#[test]
fn thousands_of_mistakes_are_counted() {
    let message = errors(&format!(
        "<robot name=\"r\">{}</robot>",
        "<link/>".repeat(5000)
    ));
    assert_eq!(message.lines().count(), 1001);
    assert!(message.ends_with("and 4000 more\n"));
}

#[test]
fn truncated_files_never_panic() {
    for end in (0..ARM.len()).filter(|end| ARM.is_char_boundary(*end)) {
        let message = errors(&ARM[..end]);
        assert_eq!(
            message.is_empty(),
            end >= ARM.trim_end().len(),
            "{end}: {message}"
        );
    }
}

#[test]
fn random_changes_never_panic() {
    let bytes = b"<>/\"'=&;!-[]?x0.- \n\t\xc3\xa4\x00:eE+$#{";
    for text in changed(ARM, bytes, 0x2545_f491_4f6c_dd1d).take(4000) {
        let _ = errors(&text);
    }
}

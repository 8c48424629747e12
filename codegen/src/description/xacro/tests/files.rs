//! Included files, packages and YAML files.

use std::fs;
use std::path::PathBuf;

use super::robot;
use crate::description::Given;
use crate::description::{Description, read_file_with};
use crate::error::Errors;

/// A temporary folder with these files.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("homogen-xacro-{}-{name}", std::process::id()));
    for (path, text) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// Reads a file of a folder with these files.
fn read_in(
    name: &str,
    file: &str,
    files: &[(&str, &str)],
    packages: &[(&str, &str)],
) -> (Option<Description>, String) {
    let folder = folder(name, files);
    let packages = packages.iter();
    let packages = packages.map(|(name, path)| ((*name).to_owned(), folder.join(path)));
    let given = Given {
        arguments: Vec::new(),
        packages: packages.collect(),
    };
    let mut errors = Errors::new();
    let robot = read_file_with(&folder.join(file), &given, None, &mut errors);
    fs::remove_dir_all(folder).unwrap();
    (robot, errors.to_string())
}

fn links(robot: &Description) -> Vec<&str> {
    robot.links.iter().map(|link| &*link.name.text).collect()
}

const PACKAGE: &str = "<package><name>arm_description</name></package>";

#[test]
fn files_are_included_from_folders_and_packages() {
    let (robot, errors) = read_in(
        "packages",
        "src/arm/urdf/arm.xacro",
        &[
            ("src/arm/package.xml", PACKAGE),
            (
                "src/arm/urdf/arm.xacro",
                &robot(
                    "<xacro:include filename=\"parts/*.xacro\"/><xacro:include filename=\"../common.xacro\"/>\
                     <xacro:include filename=\"$(find arm_description)/urdf/parts/b.xacro\" ns=\"n\"/>\
                     <xacro:include filename=\"$(find hand)/hand.xacro\"/><xacro:include filename=\"$(find tool)/t.xacro\"/>\
                     <xacro:include filename=\"no.xacro\" optional=\"true\"/>\
                     <xacro:hand/><xacro:n.b name=\"${n.size}\"/>",
                ),
            ),
            (
                "src/arm/urdf/parts/a.xacro",
                &robot("<xacro:macro name=\"a\"/>"),
            ),
            (
                "src/arm/urdf/parts/b.xacro",
                &robot(
                    "<xacro:macro name=\"b\" params=\"name\"><link name=\"b${name}\"/></xacro:macro>\
                     <xacro:property name=\"size\" value=\"5\"/>",
                ),
            ),
            (
                "src/arm/common.xacro",
                &robot("<link name=\"common\"/>\n<link/>"),
            ),
            (
                "src/hand/package.xml",
                "<package><name>hand</name></package>",
            ),
            (
                "src/hand/hand.xacro",
                &robot(
                    "<xacro:macro name=\"hand\"><xacro:property name=\"y\" value=\"${load_yaml('../arm/x.yaml')}\"/>\
                     </xacro:macro><link name=\"hand${xacro.load_yaml('mass.yaml').mass}\"/>",
                ),
            ),
            ("src/hand/mass.yaml", "mass: 1.5"),
            ("elsewhere/t.xacro", &robot("<link name=\"tool\"/>")),
        ],
        &[("tool", "elsewhere")],
    );
    assert_eq!(
        errors,
        "error: arm_description/common.xacro:3:1: a link has no attribute \"name\"\n"
    );
    assert_eq!(links(&robot.unwrap()), ["common", "hand1.5", "tool", "b5"]);
}

#[test]
fn the_sources_of_a_robot_are_known() {
    let files = [
        (
            "arm.xacro",
            &*robot(
                "<xacro:include filename=\"parts/link.xacro\"/><xacro:property name=\"y\" \
                 value=\"${xacro.load_yaml('parts/size.yaml')}\"/><link name=\"${y['name']}\"/>",
            ),
        ),
        (
            "parts/link.xacro",
            &robot(
                "<joint oddity=\"1\" name=\"j\" type=\"fixed\"><parent link=\"a\"/>\n<child link=\"b\"/></joint><link name=\"a\"/>",
            ),
        ),
        ("parts/size.yaml", "name: b"),
    ];
    let (found, errors) = read_in("sources", "arm.xacro", &files, &[]);
    assert_eq!(errors, "");
    let found = found.unwrap();
    assert_eq!(links(&found), ["a", "b"]);
    assert_eq!(
        found.source.included,
        ["parts/link.xacro", "parts/size.yaml"]
    );
    assert_eq!(found.source.beside.len(), 2);
    assert!(found.source.beside[1].ends_with("parts/size.yaml"));
    assert_eq!(
        found.source.errors().locate(&found.warnings[0]),
        "parts/link.xacro:2:8: attribute \"oddity\" of joint \"j\" is ignored"
    );
}

#[test]
fn arguments_belong_to_xacro_files() {
    let given = Given {
        arguments: vec![("a".to_owned(), "1".to_owned())],
        packages: Vec::new(),
    };
    let read = |name: &str, text: &str| {
        let folder = folder(name, &[("arm.urdf", text)]);
        let mut errors = Errors::new();
        let robot = read_file_with(&folder.join("arm.urdf"), &given, None, &mut errors);
        fs::remove_dir_all(folder).unwrap();
        (robot, errors.to_string())
    };
    let (_, errors) = read("urdf", "<robot name=\"r\"><link name=\"a\"/></robot>");
    assert!(
        errors.starts_with("error: arguments are given, but the file is not xacro\n"),
        "{errors}"
    );
    let (robot, errors) = read("unused", &robot("<link name=\"${'a'}\"/>"));
    assert_eq!(errors, "");
    let [warning] = &robot.unwrap().warnings[..] else {
        panic!("one warning");
    };
    assert_eq!(warning.message, "the file does not use the given \"a\"");
}

#[test]
fn files_that_cannot_be_read_are_errors() {
    let errors_of = |name: &str, elements: &str, others: &[(&str, &str)]| {
        let text = robot(elements);
        let mut files = vec![("arm.xacro", text.as_str())];
        files.extend(others);
        read_in(name, "arm.xacro", &files, &[]).1
    };
    let include = |file: &str| format!("<xacro:include filename=\"{file}\"/>");
    assert_eq!(
        errors_of("missing", &include("no.xacro"), &[]),
        "error: arm.xacro:2:1: cannot read \"no.xacro\": there is no such file\n"
    );
    for path in ["../a.xacro", "/etc/passwd", "a/../../b.xacro", "a/../../b*"] {
        let found = errors_of("outside", &include(path), &[]);
        assert!(
            found.contains("it is outside the package"),
            "{path}: {found}"
        );
    }
    assert!(
        errors_of("package", &include("$(find no_package)/a.xacro"), &[])
            .contains("package \"no_package\" is not found\n  hint: name its folder: packages(no_package = \"path\")")
    );
    assert!(
        errors_of("word", &include("$(find ../..)/a.xacro"), &[])
            .contains("\"../..\" is no name of a package")
    );
    let text = robot(&include("b.xacro"));
    let found = errors_of("loop", &include("b.xacro"), &[("b.xacro", &text)]);
    assert!(
        found.contains("b.xacro:1:1: macros, files or expressions are nested too deeply"),
        "{found}"
    );
    assert_eq!(
        errors_of("broken", &include("b.xacro"), &[("b.xacro", "<a><b></a>")]),
        "error: arm.xacro:2:1: b.xacro:1:7: </a> has no matching start tag\n  hint: close the open element by </b>\n"
    );
    assert_eq!(
        errors_of(
            "yaml",
            "<l a=\"${load_yaml('b.yaml')}\"/>",
            &[("b.yaml", "a: 1\n\tb: 2")]
        ),
        "error: arm.xacro:2:7: b.yaml:2: a tab is no indentation: write spaces in \"${load_yaml('b.yaml')}\"\n"
    );
}

//! Included files and meshes.

use std::fs;
use std::path::PathBuf;

use super::super::read;
use super::{joint, near};
use crate::description::{Description, read_file};
use crate::error::Errors;

/// A temporary folder with these files.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("homogen-mjcf-{}-{name}", std::process::id()));
    for (path, text) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// Reads the file `arm.xml` of a folder.
pub(super) fn read_in(name: &str, files: &[(&str, &str)]) -> (Option<Description>, String) {
    let folder = folder(name, files);
    let mut errors = Errors::new();
    let robot = read_file(&folder.join("arm.xml"), None, &mut errors);
    fs::remove_dir_all(folder).unwrap();
    (robot, errors.to_string())
}

#[test]
fn included_elements_replace_the_include() {
    let (robot, errors) = read_in(
        "nested",
        &[
            (
                "arm.xml",
                "<mujoco><include file=\"parts/settings.xml\"/><worldbody><body name=\"a\"><include file=\"parts/fore.xml\"/>\
                 <body name=\"c\"/></body></worldbody></mujoco>",
            ),
            (
                "parts/settings.xml",
                "<mujoco model=\"other\"><compiler angle=\"radian\"/></mujoco>",
            ),
            (
                "parts/fore.xml",
                "<mujocoinclude><body name=\"b\">\n<include file=\"joint.xml\"/></body></mujocoinclude>",
            ),
            (
                "parts/joint.xml",
                "<x><joint name=\"j\" ref=\"1\"/>\n<joint oddity=\"1\"/></x>",
            ),
        ],
    );
    let robot = robot.unwrap();
    assert_eq!(errors, "");
    let links: Vec<&str> = robot.links.iter().map(|link| &*link.name.text).collect();
    assert_eq!(links, ["world", "a", "b.j", "b", "c"]);
    assert_eq!(robot.name.text, "arm");
    near(
        super::pose(&joint(&robot, "j").origin).0[0][0],
        1.0_f64.cos(),
    );
    let source = &robot.source;
    assert_eq!(
        source.included,
        ["parts/settings.xml", "parts/fore.xml", "parts/joint.xml"]
    );
    assert_eq!(source.beside.len(), 3);
    assert_eq!(
        source.errors().locate(&robot.warnings[0]),
        "parts/joint.xml:2:8: attribute \"oddity\" of the <joint> of the <x> is ignored"
    );
}

#[test]
fn files_that_cannot_be_included_are_errors() {
    let errors_of = |name: &str, file: &str, others: &[(&str, &str)]| {
        let text = format!("<mujoco>\n<include file=\"{file}\"/></mujoco>");
        let mut files = vec![("arm.xml", text.as_str())];
        files.extend(others);
        read_in(name, &files).1
    };
    let hint = "\n  hint: write a path inside the folder of the first file\n";
    assert_eq!(
        errors_of("missing", "no.xml", &[]),
        format!("error: arm.xml:2:1: cannot include \"no.xml\": there is no such file{hint}")
    );
    for path in ["../a.xml", "/etc/passwd", "a/../../b.xml", ".."] {
        let wanted = format!(
            "error: arm.xml:2:1: cannot include \"{path}\": it is outside the folder{hint}"
        );
        assert_eq!(errors_of("outside", path, &[]), wanted);
    }
    assert!(errors_of("itself", "arm.xml", &[]).contains("\"arm.xml\" is included twice"));
    let other = ("b.xml", "<a>\n <include file=\"b.xml\"/></a>");
    assert!(
        errors_of("loop", "b.xml", &[other])
            .starts_with("error: b.xml:2:2: \"b.xml\" is included twice")
    );
    let other = ("b.xml", "<a><b></a>");
    assert!(errors_of("broken", "b.xml", &[other]).starts_with("error: b.xml:1:"));
    let mut errors = Errors::new();
    assert!(
        read(
            "<mujoco><include file=\"a\"/></mujoco>",
            "<stdin>",
            None,
            None,
            &mut errors
        )
        .is_none()
    );
    assert!(
        errors
            .to_string()
            .contains("cannot include \"a\": a text without a file has no folder"),
        "{errors}"
    );
}

/// A tetrahedron of volume 1/6.
pub(super) const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

#[test]
fn meshes_are_opened_only_if_their_mass_is_needed() {
    let robot = |inertial: &str| {
        format!(
            "<mujoco><compiler meshdir=\"meshes\"/><asset><mesh\nfile=\"part.obj\" scale=\"2 2 2\"/></asset><worldbody>\
             <body name=\"a\"><geom type=\"mesh\" mesh=\"part\" density=\"3\"/>{inertial}</body></worldbody></mujoco>"
        )
    };
    let (found, errors) = read_in(
        "mesh",
        &[("arm.xml", &robot("")), ("meshes/part.obj", TETRAHEDRON)],
    );
    assert_eq!(errors, "");
    let found = found.unwrap();
    near(super::inertial(&found, "a").mass.value, 4.0);
    assert!(found.source.beside[0].ends_with("meshes/part.obj"));
    let (_, errors) = read_in("no-mesh", &[("arm.xml", &robot(""))]);
    assert!(
        errors.contains("cannot compute the mass of a geom of body \"a\" from mesh \"part\": "),
        "{errors}"
    );
    assert!(
        errors.contains("part.obj: there is no such file"),
        "{errors}"
    );
    let explicit = "<inertial pos=\"0 0 0\" mass=\"1\"/>";
    assert_eq!(read_in("explicit", &[("arm.xml", &robot(explicit))]).1, "");
}

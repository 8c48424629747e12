//! Models of other files.

use std::fs;
use std::path::PathBuf;

use super::{is_at, joint, link, with};
use crate::description::Given;
use crate::description::{Description, read_file_with};
use crate::error::Errors;

/// A temporary folder with these files.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("homogen-sdf-{}-{name}", std::process::id()));
    for (path, text) in files {
        let path = folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// Reads a file of a folder.
fn read_in(name: &str, file: &str, files: &[(&str, &str)]) -> (Option<Description>, String) {
    let folder = folder(name, files);
    let given = Given {
        packages: vec![("named".to_owned(), folder.join("elsewhere"))],
        ..Given::default()
    };
    let mut errors = Errors::new();
    let robot = read_file_with(&folder.join(file), &given, None, &mut errors);
    fs::remove_dir_all(folder).unwrap();
    (robot, errors.to_string())
}

const CONFIG: &str = "<model><name>hand</name><sdf version=\"1.4\">old.sdf</sdf><sdf version=\"1.9\">hand.sdf</sdf></model>";

fn hand() -> String {
    with(&link("palm", "<pose>0 0 0.1 0 0 0</pose>"))
}

/// An arm that includes a model.
fn arm(include: &str, child: &str) -> String {
    with(&format!(
        "{}<include>{include}</include><joint name=\"j\" type=\"fixed\"><parent>a</parent><child>{child}</child></joint>",
        link("a", "")
    ))
}

#[test]
fn a_model_is_found_beside_the_file_and_beside_its_folder() {
    let by_name = "<uri>model://hand</uri><pose>0 1 0 0 0 0</pose><name>left</name>";
    let by_path = by_name.replace("model://hand", "hand/hand.sdf");
    for (case, file, at, include) in [
        ("beside", "arm.sdf", "hand", by_name),
        ("around", "arm/model.sdf", "hand", by_name),
        ("path", "arm.sdf", "hand", &*by_path),
        (
            "package",
            "arm.sdf",
            "elsewhere",
            &by_name.replace("model://hand", "model://named"),
        ),
    ] {
        let (robot, errors) = read_in(
            case,
            file,
            &[
                (file, &arm(include, "left::palm")),
                (&format!("{at}/model.config"), CONFIG),
                (&format!("{at}/hand.sdf"), &hand()),
            ],
        );
        assert_eq!(errors, "", "{case}");
        let robot = robot.unwrap();
        is_at(&joint(&robot, "j").origin, [0.0, 1.0, 0.1], [1.0, 0.0, 0.0]);
        assert_eq!(robot.source.beside.len(), 1);
    }
}

#[test]
fn a_model_may_be_included_several_times_or_merged() {
    let two = "<uri>model://hand</uri><name>left</name></include><include><uri>model://hand</uri><name>right</name>\
               <pose>0 2 0 0 0 0</pose>";
    let text = arm(two, "left::palm").replace(
        "</model>",
        "<joint name=\"k\" type=\"fixed\"><parent>left::palm</parent>\
        <child>right::palm</child></joint></model>",
    );
    let (robot, errors) = read_in(
        "twice",
        "arm.sdf",
        &[("arm.sdf", &text), ("hand/model.sdf", &hand())],
    );
    assert_eq!(errors, "");
    is_at(
        &joint(&robot.unwrap(), "k").origin,
        [0.0, 2.0, 0.0],
        [1.0, 0.0, 0.0],
    );

    let merged = arm(
        "<uri>model://hand</uri><pose relative_to=\"a\">1 0 0 0 0 0</pose>",
        "palm",
    )
    .replace("<include>", "<include merge=\"true\">");
    let (robot, errors) = read_in(
        "merged",
        "arm.sdf",
        &[("arm.sdf", &merged), ("hand/model.sdf", &hand())],
    );
    assert_eq!(errors, "");
    let robot = robot.unwrap();
    assert_eq!(robot.links[1].name.text, "palm");
    is_at(&joint(&robot, "j").origin, [1.0, 0.0, 0.1], [1.0, 0.0, 0.0]);
}

#[test]
fn places_in_included_files_name_them() {
    let bad = hand().replace("<mass>1", "\n<mass>x");
    let (_, errors) = read_in(
        "bad",
        "arm.sdf",
        &[
            ("arm.sdf", &arm("<uri>model://hand</uri>", "arm::palm")),
            ("hand/model.sdf", &bad),
        ],
    );
    assert!(
        errors.starts_with("error: hand/model.sdf:2:7: the <mass> of the inertial of link \"arm::palm\" is not a number: \"x\""),
        "{errors}"
    );
}

#[test]
fn models_elsewhere_are_errors() {
    for (uri, message) in [
        (
            "model://absent",
            "cannot include \"model://absent\": there is no such file",
        ),
        (
            "../secret.sdf",
            "cannot include \"../secret.sdf\": it is outside the folder",
        ),
        (
            "/etc/passwd",
            "cannot include \"/etc/passwd\": it is outside the folder",
        ),
        (
            "model://../x",
            "cannot include \"model://../x\": it is outside the folder",
        ),
        (
            "https://example.org/x",
            "cannot include \"https://example.org/x\": it is not a file of this machine",
        ),
    ] {
        let text = arm(&format!("<uri>{uri}</uri>"), "a");
        let (robot, errors) = read_in("elsewhere", "arm.sdf", &[("arm.sdf", &text)]);
        assert!(robot.is_none() && errors.contains(message), "{errors}");
    }
}

#[test]
fn a_model_that_includes_itself_is_an_error() {
    let hand = with(&format!(
        "{}<include><uri>model://hand</uri></include>",
        link("palm", "")
    ));
    let (_, errors) = read_in(
        "itself",
        "arm.sdf",
        &[
            ("arm.sdf", &arm("<uri>model://hand</uri>", "arm::palm")),
            ("hand/model.sdf", &hand),
        ],
    );
    assert!(
        errors.contains("the model \"arm\" includes itself"),
        "{errors}"
    );
}

/// Each file includes the next one twice.
#[test]
fn models_that_grow_without_bound_are_errors() {
    let mut files = vec![("arm.sdf".to_owned(), arm("<uri>model://m0</uri>", "a"))];
    for k in 0..40 {
        let include = |name: &str| {
            format!(
                "<include><name>{name}</name><uri>model://m{}</uri></include>",
                k + 1
            )
        };
        let text = with(&format!(
            "{}{}{}",
            link("a", ""),
            include("x"),
            include("y")
        ));
        files.push((format!("m{k}/model.sdf"), text));
    }
    files.push(("m40/model.sdf".to_owned(), with(&link("a", ""))));
    let files: Vec<(&str, &str)> = files
        .iter()
        .map(|(path, text)| (&**path, &**text))
        .collect();
    let (_, errors) = read_in("bomb", "arm.sdf", &files);
    assert!(errors.contains("100000 frames"), "{errors}");
}

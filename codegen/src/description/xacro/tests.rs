//! Expansions of files. Expected texts are those of ROS's tool.

mod elements;
mod files;
mod hostile;

use super::expanded;
use crate::description::Given;
use crate::description::{Description, read_text};
use crate::error::Errors;

const NAMESPACE: &str = "xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";

/// A robot with these elements.
fn robot(elements: &str) -> String {
    format!("<robot name=\"r\" {NAMESPACE}>\n{elements}</robot>")
}

/// The expansion of a robot's elements, without line breaks between them, or the errors.
fn outcome(elements: &str, arguments: &[(&str, &str)]) -> Result<String, String> {
    let own = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
    let given = Given {
        arguments: arguments.iter().map(own).collect(),
        packages: Vec::new(),
    };
    let mut errors = Errors::new();
    let text = expanded(&robot(elements), "r.xacro", None, &given, &mut errors);
    let lines = text.map(|text| text.lines().map(str::trim).collect::<String>());
    match lines {
        Some(text) => {
            let inner = text.strip_prefix("<robot name=\"r\">").unwrap_or_default();
            Ok(inner
                .strip_suffix("</robot>")
                .unwrap_or_default()
                .to_owned())
        }
        None => Err(errors.to_string()),
    }
}

fn expand(elements: &str) -> String {
    outcome(elements, &[]).unwrap_or_else(|errors| panic!("{elements}\n{errors}"))
}

/// The errors of a robot's elements.
fn errors(elements: &str) -> String {
    match outcome(elements, &[]) {
        Ok(text) => panic!("{elements}\nexpands to {text}"),
        Err(errors) => errors,
    }
}

fn read(text: &str) -> (Option<Description>, String) {
    let mut errors = Errors::new();
    let found = read_text(text, "arm.urdf.xacro", None, &mut errors);
    (found, errors.to_string())
}

#[test]
fn a_robot_is_expanded_and_read() {
    let text = robot(
        "<xacro:property name=\"mass\" value=\"2\"/>\n<xacro:macro name=\"body\" params=\"name length:=0.5\">\n\
         <link name=\"${name}\"><inertial><mass value=\"${mass}\"/>\n\
         <inertia ixx=\"${mass * length**2 / 12}\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>\n\
         </xacro:macro>\n<xacro:body name=\"a\"/>\n<xacro:body name=\"b\" length=\"1\"/>\n\
         <joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/><axis xyz=\"0 0 1\"/>\n\
         <limit lower=\"${-pi / 2}\" upper=\"1.5708\" effort=\"1\" velocity=\"1\"/></joint>",
    );
    let (found, errors) = read(&text);
    assert_eq!(errors, "");
    let found = found.unwrap();
    let inertias = found.links.iter().map(|link| {
        let inertial = link.inertial.as_ref().unwrap();
        (inertial.mass.value, inertial.inertia[0].value)
    });
    let inertias: Vec<_> = inertias.collect();
    assert_eq!(inertias, [(2.0, 0.5 / 12.0), (2.0, 2.0 / 12.0)]);
    let limits = found.joints[0].limits.unwrap();
    assert_eq!(limits.lower, -std::f64::consts::FRAC_PI_2);
}

#[test]
fn errors_of_urdf_have_places_in_the_xacro_file() {
    let text = robot(
        "<xacro:property name=\"m\" value=\"heavy\"/>\n<xacro:macro name=\"body\" params=\"name\">\n\
         <link name=\"${name}\"><inertial>\n<mass value=\"${m}\"/>\n\
         <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1,5\"/></inertial></link>\n\
         </xacro:macro>\n<xacro:body name=\"a\"/>\n<link name=\"a\"/>",
    );
    assert_eq!(
        read(&text).1,
        "error: arm.urdf.xacro:5:14: the mass of link \"a\" is not a number: \"heavy\"\n\
         error: arm.urdf.xacro:6:55: izz of link \"a\" is not a number: \"1,5\"\n  \
         hint: write a decimal point, and spaces between numbers\n\
         error: arm.urdf.xacro:9:13: there is another link \"a\"\n  \
         hint: the other one is in line 4\n"
    );
}

//! Format of a file: by the ending of its name, and by its root element.

use super::xml::begins_with;

/// Format of a description's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileFormat {
    /// The Unified Robot Description Format.
    Urdf,
    /// URDF with the macros of ROS.
    Xacro,
    /// The format of MuJoCo.
    Mjcf,
    /// The format of Gazebo and Drake.
    Sdf,
    /// A table of Denavit and Hartenberg.
    Table,
}

impl FileFormat {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Urdf => "URDF",
            Self::Xacro => "xacro",
            Self::Mjcf => "MJCF",
            Self::Sdf => "SDF",
            Self::Table => "Denavit–Hartenberg table",
        }
    }

    /// The format of a file with this name; `None` if it is neither a table nor XML by its ending, and its text is not
    /// XML.
    pub(super) fn of(text: &str, file: &str) -> Option<Self> {
        let is_xml = || {
            let text = text.trim_start_matches('\u{feff}');
            text.trim_start().starts_with('<')
        };
        match file.rsplit_once('.') {
            Some((_, "dh")) => return Some(Self::Table),
            Some((_, "urdf" | "xml" | "xacro")) => {}
            _ if is_xml() => {}
            _ => return None,
        }
        Some(if is_mjcf(text) {
            Self::Mjcf
        } else if begins_with(text, "<sdf") {
            Self::Sdf
        } else if is_xacro(text, file) {
            Self::Xacro
        } else {
            Self::Urdf
        })
    }
}

/// True if the root element of a text is `<mujoco>`.
pub(super) fn is_mjcf(text: &str) -> bool {
    begins_with(text, "<mujoco")
}

/// Elements that only an unexpanded file of xacro has.
const ELEMENTS: [&str; 8] = [
    "<xacro:arg",
    "<xacro:property",
    "<xacro:macro",
    "<xacro:include",
    "<xacro:if",
    "<xacro:unless",
    "<xacro:call",
    "<xacro:element",
];

/// True if a file is to be expanded: its name ends in `.xacro`, or it declares the namespace of xacro and contains
/// elements or expressions of it. Files that the tool has expanded keep the declaration.
fn is_xacro(text: &str, file: &str) -> bool {
    let is_named = file
        .rsplit_once('.')
        .is_some_and(|(_, ending)| ending == "xacro");
    let contains = || {
        let mut elements = ELEMENTS.into_iter();
        elements.any(|element| text.contains(element)) || text.contains("${") || text.contains("$(")
    };
    is_named || (text.contains("xmlns:xacro") && contains())
}

#[cfg(test)]
mod tests {
    use super::FileFormat::{self, Mjcf, Sdf, Table, Urdf, Xacro};

    #[test]
    fn files_are_known_by_ending_and_root() {
        let namespace = |text: &str| format!("<robot xmlns:xacro=\"…\">{text}</robot>");
        let texts = [
            ("arm.dh", "<mujoco/>", Some(Table)),
            ("arm.txt", "a: revolute", None),
            ("arm.urdf", "", Some(Urdf)),
            ("arm.xml", "<mujoco/>", Some(Mjcf)),
            (
                "-",
                "\u{feff}<?xml version=\"1.0\"?>\n<!-- <robot> -->\n<mujoco model=\"a\">",
                Some(Mjcf),
            ),
            ("-", "<!DOCTYPE mujoco>\n<mujocoinclude>", Some(Mjcf)),
            (
                "-",
                "<!DOCTYPE r [<!ENTITY a \"b\">\n]><mujoco/>",
                Some(Mjcf),
            ),
            ("-", "<robot><mujoco/></robot>", Some(Urdf)),
            ("-", "<!-- <mujoco/>", Some(Urdf)),
            ("arm.xml", "shoulder <mujoco>", Some(Urdf)),
            ("arm.xml", "", Some(Urdf)),
            ("-", "shoulder <mujoco>", None),
            ("-", "<sdf version='1.4'/>", Some(Sdf)),
            (
                "-",
                "\u{feff}<?xml version=\"1.0\"?>\n<!-- a <robot> --><sdf>",
                Some(Sdf),
            ),
            ("-", "<robot name=\"sdf\"/>", Some(Urdf)),
            ("arm.xacro", "<robot/>", Some(Xacro)),
            (
                "arm.urdf",
                &namespace("<xacro:property name=\"a\" value=\"1\"/>"),
                Some(Xacro),
            ),
            ("arm.urdf", &namespace("<link name=\"${a}\"/>"), Some(Xacro)),
            // Expanded by the tool, with a call that it did not know.
            (
                "arm.urdf",
                &namespace("<link name=\"a\"/><xacro:imu/>"),
                Some(Urdf),
            ),
            (
                "arm.urdf",
                "<robot><link name=\"${a}\"/></robot>",
                Some(Urdf),
            ),
        ];
        for (file, text, format) in texts {
            assert_eq!(FileFormat::of(text, file), format, "{file}: {text}");
        }
    }
}

//! Projects to begin with around generated code: a crate, projects of C and C++ for CMake, a package for Python.
//!
//! In: the builder of a robot. Out: paths and texts, with the module whose warnings are to be reported. Paths are those
//! below the project's folder. No name of a description becomes code or a path.

use homogen_codegen::builder::Builder;
use homogen_codegen::error::Errors;
use homogen_codegen::module::Module;
use homogen_codegen::print::arrays::Order;
use homogen_codegen::print::c::cpp;
use homogen_codegen::template::filled;

/// A kind of project.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Project {
    /// A crate without dependencies, for `core` alone.
    Crate,
    /// A library in C99 with its `CMakeLists.txt`.
    Cmake,
    /// A header in C++17 with its `CMakeLists.txt`; the order is that of twists, wrenches and momenta.
    Cpp(Order),
    /// A package for Python without dependencies.
    Python,
}

impl Project {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Crate,
        Self::Cmake,
        Self::Cpp(Order::AngularFirst),
        Self::Python,
    ];

    /// Its words on the command line: `homogen new crate`.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Crate => "crate",
            Self::Cmake => "cmake",
            Self::Cpp(Order::AngularFirst) => "cmake --language cpp",
            Self::Cpp(Order::LinearFirst) => "cmake --language cpp --order linear-first",
            Self::Python => "python",
        }
    }

    /// Its files, and the module that they were printed from.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that the language does not have.
    pub fn files(self, builder: &Builder) -> Result<(Vec<(String, String)>, Module), Errors> {
        let module = match self {
            Self::Crate => builder.file_module()?,
            Self::Cmake => builder.c_module()?,
            Self::Cpp(_) => builder.cpp_module()?,
            Self::Python => builder.plain_python_module()?,
        };
        let robot = &module.about.robot;
        let (stem, folder) = (stem(robot), folder(robot));
        let words = [("@NAME@", &*folder), ("@FILE@", &*stem)];
        let of = |path: &str, text: &str| (path.to_owned(), filled(text, &words));
        let readme = |header: &str| {
            let words = [words[0], words[1], ("@HEADER@", header)];
            let text = filled(include_str!("project/README.md.in"), &words);
            ("README.md".to_owned(), text)
        };
        let files = match self {
            Self::Crate => {
                let code = builder.source(&module).to_string();
                vec![
                    of("Cargo.toml", include_str!("project/Cargo.toml.in")),
                    of("src/lib.rs", include_str!("project/lib.rs.in")),
                    ("src/robot.rs".to_owned(), code),
                ]
            }
            Self::Cmake => {
                let code = builder.c_files(&module, &format!("{stem}.h"));
                // The header is first.
                let sources: Vec<&str> = code[1..].iter().map(|(name, _)| &**name).collect();
                let cmake = concat!(
                    include_str!("project/c.cmake.in"),
                    include_str!("project/install.cmake.in")
                );
                let words = [words[0], words[1], ("@SOURCES@", &sources.join("\n  "))];
                let cmake = filled(cmake, &words);
                let head = [("CMakeLists.txt".to_owned(), cmake), readme(&code[0].0)];
                head.into_iter().chain(code).collect()
            }
            Self::Cpp(order) => {
                let header = format!("{stem}.hpp");
                let code = builder.cpp(&module, &header, order);
                let namespace = builder.cpp_namespace(&module);
                let cmake = concat!(
                    include_str!("project/cpp.cmake.in"),
                    include_str!("project/install.cmake.in")
                );
                let call = cpp::call(&module);
                let words = [
                    ("@CALL@", &*call),
                    ("@HEADER@", &header),
                    ("@NAMESPACE@", &namespace),
                ];
                let example = filled(include_str!("project/example.cpp.in"), &words);
                vec![
                    of("CMakeLists.txt", cmake),
                    readme(&header),
                    ("example.cpp".to_owned(), example),
                    (header, code),
                ]
            }
            Self::Python => {
                let code = builder.plain_python(&module, Order::LinearFirst);
                vec![
                    of("pyproject.toml", include_str!("project/pyproject.toml.in")),
                    (format!("{folder}/__init__.py"), code),
                ]
            }
        };
        Ok((files, module))
    }
}

/// The name of a file for a robot: lower case, and nothing that a shell or a file system would change.
#[must_use]
pub fn stem(robot: &str) -> String {
    let letters = robot.chars().take(40).map(|letter| match letter {
        'a'..='z' | '0'..='9' => letter,
        'A'..='Z' => letter.to_ascii_lowercase(),
        _ => '_',
    });
    let stem: String = letters.collect();
    match stem.trim_matches('_') {
        "" => "robot".to_owned(),
        stem => stem.to_owned(),
    }
}

/// The folder of a project, which is also its name: never a word that Rust, Python or CMake reserve.
#[must_use]
pub fn folder(robot: &str) -> String {
    let stem = stem(robot);
    if stem.starts_with(|letter: char| letter.is_ascii_digit()) {
        format!("robot_{stem}")
    } else {
        format!("{stem}_robot")
    }
}

#[cfg(test)]
mod tests {
    use super::{folder, stem};

    #[test]
    fn names_of_projects_are_not_code() {
        let robots = ["Panda", "2nd arm", "\"]\nx = 1", "機器", "../..", "class"];
        let stems = ["panda", "2nd_arm", "x___1", "robot", "robot", "class"];
        assert_eq!(robots.map(stem), stems);
        let folders = [
            "panda_robot",
            "robot_2nd_arm",
            "x___1_robot",
            "robot_robot",
            "robot_robot",
            "class_robot",
        ];
        assert_eq!(robots.map(folder), folders);
    }
}

//! Arguments of xacro files, and folders of packages, as the user gives them.

use std::path::{Path, PathBuf};

use crate::request::Request;

/// Arguments of a xacro file, and folders of packages.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// Names and values of arguments; they stand for environment variables, too.
    pub arguments: Vec<(String, String)>,
    /// Names and folders of ROS packages, for `$(find name)`.
    pub packages: Vec<(String, PathBuf)>,
}

impl Given {
    /// Those of a request; folders of packages are relative to `folder`.
    #[must_use]
    pub fn of(request: &Request, folder: &Path) -> Self {
        let arguments = request.arguments.iter();
        let packages = request.packages.iter();
        Self {
            arguments: arguments
                .map(|(name, value)| (name.text.clone(), value.clone()))
                .collect(),
            packages: packages
                .map(|(name, path)| (name.text.clone(), folder.join(path)))
                .collect(),
        }
    }
}

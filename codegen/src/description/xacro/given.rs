//! What the user gives for a xacro file.

use std::path::PathBuf;

/// Arguments of a xacro file, and folders of packages.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// Names and values of arguments; they stand for environment variables, too.
    pub arguments: Vec<(String, String)>,
    /// Names and folders of ROS packages, for `$(find name)`.
    pub packages: Vec<(String, PathBuf)>,
}

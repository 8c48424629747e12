//! What builds the package: Cargo's manifest, the project of Python, and a page to read first.
//!
//! In: the name of the module, the head of generated files. Out: texts. It never looks at a function.

use super::commented;
use super::described::Class;
use super::literals::string;

/// The manifest of the extension.
pub(super) fn cargo(module: &str, head: &[String]) -> String {
    let head = commented("#", head);
    format!(
        r#"{head}
[package]
name = "{module}"
version = "0.1.0"
edition = "2024"
rust-version = "1.89"
publish = false

[lib]
name = "_{module}"
crate-type = ["cdylib"]

[dependencies]
numpy = "0.30"
pyo3 = {{ version = "0.30", features = ["abi3-py310"] }}
rayon = "1.12"

# Finds what a processor has beyond its target, and compiles for that.
[target.'cfg(any(target_arch = "x86", target_arch = "x86_64"))'.dependencies]
pulp = {{ version = "0.22.3", default-features = false, features = ["x86-v3", "x86-v4"] }}

[profile.release]
strip = true

# It is no part of what lies around it.
[workspace]
"#
    )
}

/// The project.
pub(super) fn python(module: &str, head: &[String]) -> String {
    let head = commented("#", head);
    let module_name = string(&format!("{module}._{module}"));
    // Names of projects end in a letter or a digit.
    let project = module.trim_end_matches('_');
    format!(
        r#"{head}
[build-system]
requires = ["maturin>=1.9.4,<2"]
build-backend = "maturin"

[project]
name = "{project}"
version = "0.1.0"
description = "Kinematics and dynamics of one robot, as straight-line code"
readme = "README.md"
requires-python = ">=3.10"
dependencies = ["numpy>=1.22"]

[tool.maturin]
module-name = {module_name}
python-source = "python"
"#
    )
}

/// The page to read first.
pub(super) fn readme(class: &Class<'_>) -> String {
    let Class { module, name, .. } = class;
    let example = class.methods.first().map_or(String::new(), |method| {
        let arguments = method.arguments.iter();
        let arguments = arguments.map(|(_, last)| {
            let last: Vec<String> = last.iter().map(|length| format!(", {length}")).collect();
            format!("np.zeros((1000{}))", last.concat())
        });
        let arguments = arguments.collect::<Vec<_>>().join(", ");
        format!("robot.{}({arguments})\n", method.name)
    });
    format!(
        "# {module}

The functions of one robot for NumPy, written by `homogen python`.
To build it takes Rust 1.89 or later; `pip` fetches the rest.

```sh
pip install .
```

```python
import numpy as np
from {module} import {name}

robot = {name}()
{example}help({name})
```
"
    )
}

//! What a package for Python looks like: the class in Rust and the stub of a small robot.
//!
//! Text is pinned so that a change of it is read by somebody. What packages compute, `python/run.sh` tells.

use homogen_codegen::Function::{ForwardKinematics, InverseDynamics, InverseDynamicsDerivatives};
use homogen_codegen::{Builder, Function};

/// A file of the package of the two-link arm.
fn file(functions: &[Function], path: &str) -> String {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");
    let builder = Builder::from_urdf(robot).generate(functions.iter().copied());
    let package = builder.to_python("two_link");
    let package = package.unwrap_or_else(|errors| panic!("{errors}"));
    let mut files = package.files.into_iter();
    let found = files.find(|(other, _)| other == path);
    found.unwrap_or_else(|| panic!("{path} is written")).1
}

#[test]
fn the_class_of_two_links() {
    let functions = [InverseDynamics, InverseDynamicsDerivatives];
    insta::assert_snapshot!(file(&functions, "src/lib.rs"));
}

#[test]
fn the_stub_of_two_links() {
    let functions = [
        ForwardKinematics,
        InverseDynamics,
        InverseDynamicsDerivatives,
    ];
    insta::assert_snapshot!(file(&functions, "python/two_link/__init__.pyi"));
}

#[test]
fn the_functions_of_two_links() {
    insta::assert_snapshot!(file(&[InverseDynamics], "src/robot.rs"));
}

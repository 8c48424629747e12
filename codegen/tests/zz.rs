//! Counts.
use std::path::Path;
use homogen_codegen::Function;
use homogen_codegen::chain;
use homogen_codegen::description;
use homogen_codegen::error::Errors;
use homogen_codegen::plan::{plan, Programs};
use homogen_codegen::request::Request;
use homogen_codegen::space::FrameId;
#[test]
fn counts() {
    for (file, floating) in [("two_link.urdf", false), ("ur5_class.urdf", false), ("panda_class.urdf", false), ("quadruped.urdf", true)] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots").join(file);
        let mut errors = Errors::new();
        let d = description::read_file(&path, None, &mut errors).unwrap_or_else(|| panic!("{errors}"));
        let chain = chain::build(&d, &Request { floating, ..Request::default() }).unwrap_or_else(|e| panic!("{e}"));
        let programs = Programs::of(&chain);
        for f in [Function::InverseDynamics, Function::InverseDynamicsDerivatives, Function::InverseDynamicsHessian] {
            let p = plan(&programs, vec![f], FrameId::FIRST).unwrap_or_else(|e| panic!("{e}"));
            println!("{file} {} {:?}", f.name(), p.operation_count);
        }
    }
}

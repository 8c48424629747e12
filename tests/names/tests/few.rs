//! Twelve robots with arbitrary names: their files compile, link with each other, and pass their own tests.
//! `cargo run --release -p homogen-names` takes 300.

use std::path::Path;

use homogen_names::compilers::{c, cpp, is_here, python_texts, rust};
use homogen_names::files::Batch;

#[test]
fn twelve_robots_compile_and_pass_their_tests_in_every_language() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("few");
    let mut batch = Batch::of(0, 12, &folder);
    assert_eq!(batch.write(), []);
    rust(&batch, "2024").expect("Rust");
    let objects = c(&batch, "cc").expect("C");
    if is_here("c++") {
        cpp(&batch, "c++", &objects).expect("C++");
    } else {
        println!("not compiled with c++, which is missing");
    }
    let (refused, packages) = batch.write_python();
    assert_eq!(refused, []);
    if is_here("python3") {
        python_texts(&packages).expect("Python");
    } else {
        println!("not read by python3, which is missing");
    }
}

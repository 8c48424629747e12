//! Gives the module a stack as large as that of a program: elements may be nested deeply.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-link-arg-cdylib=-zstack-size=16777216");
}

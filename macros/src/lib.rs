//! Procedural macros of `homogen`: the derive and `chain!`.
//!
//! The engine is the ordinary library `homogen-codegen`. Users import the macros from `homogen`,
//! as `homogen::Robot` and `homogen::chain!`, which also has their documentation:
//!
//! ```
//! #[derive(homogen::Robot)]
//! #[robot(urdf = "../robots/two_link.urdf", generate(gravity))]
//! struct Arm;
//!
//! assert!(Arm.gravity(&[0.0, 0.0])[0] > 0.0_f64);
//! ```

use std::path::Path;

use homogen_codegen::front_end::{self, Kept};
use proc_macro::TokenStream;

/// Expansions are kept with what the compiler has made of this crate: for this engine, and until `cargo clean`.
fn kept() -> Kept<'static> {
    Kept {
        folder: Path::new(concat!(env!("OUT_DIR"), "/expansions")),
        engine: env!("HOMOGEN_ENGINE"),
        parse: |text| text.parse::<TokenStream>().ok().map(Into::into),
    }
}

#[doc = include_str!("derive.md")]
#[proc_macro_derive(Robot, attributes(robot))]
pub fn derive(input: TokenStream) -> TokenStream {
    front_end::derive(input.into(), Some(&kept())).into()
}

#[doc = include_str!("chain.md")]
#[proc_macro]
pub fn chain(input: TokenStream) -> TokenStream {
    front_end::chain(input.into(), Some(&kept())).into()
}

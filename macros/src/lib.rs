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

use proc_macro::TokenStream;

#[doc = include_str!("derive.md")]
#[proc_macro_derive(Robot, attributes(robot))]
pub fn derive(input: TokenStream) -> TokenStream {
    homogen_codegen::front_end::derive(input.into()).into()
}

#[doc = include_str!("chain.md")]
#[proc_macro]
pub fn chain(input: TokenStream) -> TokenStream {
    homogen_codegen::front_end::chain(input.into()).into()
}

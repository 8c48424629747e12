//! Text of functions of slices.

use super::{function, made, module, name, pretty, stub, with_runtime};
use crate::module::Module;
use crate::real::Real;
use crate::request::Request;

fn batched() -> Module {
    Module {
        batch: true,
        ..module(Real::Generic)
    }
}

#[test]
fn the_computation_is_inlined_and_both_methods_call_it() {
    let text = with_runtime(&batched());
    assert_eq!(
        function(&text, "gravity<"),
        "fn gravity<T: ::homogen::Scalar>(&self, q: &[T; 2]) -> [T; 2] {\n        \
         <Self as ::homogen::robot::Gravity<2, T>>::gravity(self, q)"
    );
    let batch = "fn gravity_batch<T: ::homogen::batch::Number>(
        &self,
        q: &[[T; 2]],
        results: &mut [[T; 2]],
    ) -> ::core::result::Result<(), ::homogen::batch::BatchError>
    where
        Self: ::core::marker::Sync,
    {
        ::homogen::batch::Batch::of(self).gravity(q, results)";
    assert!(text.contains(batch), "{text}");
    let (_, of_trait) = text.split_once("Gravity<2, T> for Pendulum {").expect("it");
    let head = "#[inline(always)]\n    fn gravity(&self, q: &[T; 2]) -> [T; 2] {\n        ";
    assert!(of_trait.contains(head), "{text}");
    let numbers = "let k = |number| ::homogen::Scalar::like(q[0], number);";
    assert!(of_trait.contains(numbers), "{text}");
    let robot = "impl ::homogen::robot::Batched for Pendulum {
    const INLINED: &'static [&'static ::core::primitive::str] = &[\"gravity\"];
}";
    assert!(text.contains(robot), "{text}");
}

#[test]
fn no_batches_without_a_request() {
    let text = with_runtime(&module(Real::Generic));
    assert!(
        !text.contains("_batch") && !text.contains("INLINED"),
        "{text}"
    );
}

#[test]
fn stubs_have_the_method_for_slices() {
    let request = Request {
        batch: true,
        functions: vec![vec![crate::function::Function::Gravity]],
        tip: Some(name("nowhere")),
        ..Request::default()
    };
    let text = pretty(&stub(&made(), &request, None));
    let batch =
        "pub fn gravity_batch<T: ::homogen::batch::Number, const N: ::core::primitive::usize>(";
    assert!(text.contains(batch), "{text}");
}

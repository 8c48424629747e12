//! What the bounds of errors take of the time of an expansion.
//!
//! In: an arm and a humanoid. Out: printed times, of all functions and of their bounds. It judges nothing.

use std::fs;
use std::time::{Duration, Instant};

use super::{accuracy_of, cheapest, expand, means, understand, wanted};
use crate::description::read_text;
use crate::error::Errors;
use crate::request::Request;

/// From the description to what is listed; what has been chosen is bounded once more, by itself.
#[test]
#[ignore = "measures: run it by itself"]
fn share_of_the_bounds_in_the_time_of_an_expansion() {
    for robot in ["robots/panda_class.urdf", "tests/robots/humanoid.urdf"] {
        let path = format!("{}/../{robot}", env!("CARGO_MANIFEST_DIR"));
        let text = fs::read_to_string(path).expect("it is in the repository");
        let mut errors = Errors::new();
        let description = read_text(&text, robot, None, &mut errors).expect("a robot");
        let request = Request::default();
        let start = Instant::now();
        let listing = expand(&description, &request).expect("all functions");
        let whole = start.elapsed();
        let chain = understand(&description, &request).expect("a tree");
        let mut bounds = Duration::ZERO;
        for (functions, frame) in wanted(&chain, &request) {
            let (asked, scalar) = (request.formulation, request.scalar);
            let Ok(found) = cheapest(request.processor, asked, &chain, &functions, frame, scalar)
            else {
                continue;
            };
            let start = Instant::now();
            accuracy_of(&found, &chain, &functions, means(&request));
            bounds += start.elapsed();
        }
        println!(
            "{robot}: {} joints, {} functions in {whole:.2?}, of which bounds {bounds:.2?}: {:.0} %",
            chain.joints.len(),
            listing.functions.len(),
            100.0 * bounds.as_secs_f64() / whole.as_secs_f64()
        );
    }
}

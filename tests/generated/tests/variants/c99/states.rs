//! States as bytes, and comparison of results.
//!
//! In: counts, a scalar type. Out: the same states on every machine; a failure if two results differ in a bit.

use std::array::from_fn;

use homogen_codegen::Real;
use homogen_tests::states::{NASTY, Random};

/// So many states, with numbers that are exact in both types.
pub fn everyday(numbers: usize, states: usize) -> Vec<f64> {
    let mut random = Random::new(17);
    let all = 0..numbers * states;
    all.map(|_| 4.0 * random.unit()).collect()
}

/// The same, with adverse numbers for a third of the entries of every third state.
pub fn nasty(numbers: usize, states: usize) -> Vec<f64> {
    let mut random = Random::new(18);
    let mut all = everyday(numbers, states);
    for state in all.chunks_exact_mut(numbers).skip(2).step_by(3) {
        for number in state {
            if random.chance(3) {
                *number = (*random.choose(&NASTY)).into();
            }
        }
    }
    all
}

/// Numbers in the machine's bytes of their type.
pub fn bytes(numbers: &[f64], real: Real) -> Vec<u8> {
    let mut bytes = Vec::new();
    for number in numbers {
        match real {
            #[expect(clippy::cast_possible_truncation, reason = "all of them are f32s")]
            Real::F32 => bytes.extend((*number as f32).to_ne_bytes()),
            Real::F64 | Real::Generic => bytes.extend(number.to_ne_bytes()),
        }
    }
    bytes
}

/// Fails at the first number whose bits differ; `size` is the count of numbers in a state. All NaN are equal, since
/// neither language specifies their bits.
pub fn same(found: &[u8], expected: &[u8], size: usize, real: Real, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let width = bytes(&[0.0], real).len();
    let states = found.chunks_exact(size * width);
    for (state, (found, expected)) in states.zip(expected.chunks_exact(size * width)).enumerate() {
        if found == expected {
            continue;
        }
        let numbers = found.chunks_exact(width).zip(expected.chunks_exact(width));
        for (number, (found, expected)) in numbers.enumerate() {
            let [found, expected] = [found, expected].map(|bytes| bits(bytes, real));
            let place = format!("{what}: number {number} of state {state}");
            assert!(found == expected, "{place}: {found:#x}, not {expected:#x}");
        }
    }
}

/// The numbers in bytes of double precision.
pub fn numbers(bytes: &[u8]) -> Vec<f64> {
    let numbers = bytes.chunks_exact(8);
    numbers
        .map(|bytes| f64::from_ne_bytes(from_fn(|k| bytes[k])))
        .collect()
}

/// The bits of a number, the same for every NaN.
fn bits(bytes: &[u8], real: Real) -> u64 {
    match real {
        Real::F32 => {
            let number = f32::from_ne_bytes(from_fn(|k| bytes[k]));
            if number.is_nan() {
                u64::MAX
            } else {
                number.to_bits().into()
            }
        }
        Real::F64 | Real::Generic => {
            let number = f64::from_ne_bytes(from_fn(|k| bytes[k]));
            if number.is_nan() {
                u64::MAX
            } else {
                number.to_bits()
            }
        }
    }
}

//! Random changes of texts, for tests of readers.
//!
//! The changes depend only on the text and the seed.

use homogen_random::Random;

/// Texts with one to six changes each: a byte replaced, a byte inserted, or up to eleven bytes removed.
pub fn changed(text: &str, bytes: &[u8], seed: u64) -> impl Iterator<Item = String> {
    let mut random = Random::new(seed);
    let mut random = move |below: usize| random.below(below);
    std::iter::repeat_with(move || {
        let mut text = text.as_bytes().to_vec();
        for _ in 0..=random(6) {
            let at = random(text.len());
            match random(3) {
                0 => text[at] = bytes[random(bytes.len())],
                1 => text.insert(at, bytes[random(bytes.len())]),
                _ => {
                    text.drain(at..(at + random(12)).min(text.len()));
                }
            }
        }
        String::from_utf8_lossy(&text).into_owned()
    })
}

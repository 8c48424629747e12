//! Texts changed at random, for readers that must survive all of them.
//!
//! In: a text, the bytes that may come into it, a seed. Out: as many changed texts as are taken, the
//! same for the same seed everywhere.

use homogen_random::Random;

/// Each with one to six changes: a byte replaced, a byte put in, or up to eleven in a row taken out.
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

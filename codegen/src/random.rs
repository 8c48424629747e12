//! Random numbers that are the same on every platform.
//!
//! In: a seed. Out: a sequence of numbers.

/// A sequence of numbers (splitmix64 of Steele, Lea and Flood, 2014), from a seed.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Between 0 and 1, of 32 bits.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let bits = u32::try_from((bits ^ (bits >> 31)) >> 32).unwrap_or(0);
        (f64::from(bits) + 0.5) / 4_294_967_296.0
    }
}

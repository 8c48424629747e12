//! Random numbers that are the same on every machine, for all tests and examples.
//!
//! In: a seed. Out: the sequence of SplitMix64 (Steele, Lea and Flood 2014), as bits, choices and
//! numbers. It has no dependencies, so that the tests of every crate can use it.

/// A random number generator.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// An integer in [0, `end`); nearly uniform, since `end` is small compared with 2⁶⁴.
    ///
    /// # Panics
    /// If `end` is 0.
    pub fn below(&mut self, end: usize) -> usize {
        let end = u64::try_from(end).expect("64 bits are enough");
        usize::try_from(self.bits() % end).expect("it is less than `end`")
    }

    /// True once in `one_in` times.
    pub fn chance(&mut self, one_in: usize) -> bool {
        self.below(one_in) == 0
    }

    /// A number in [−1, 1), a multiple of 2⁻²³.
    pub fn unit(&mut self) -> f64 {
        let [a, b, c, ..] = self.bits().to_be_bytes();
        f64::from(u32::from_be_bytes([0, a, b, c])) / f64::from(1_u32 << 23) - 1.0
    }

    /// A number in (−1, 1), an odd multiple of 2⁻²⁴, so never zero.
    pub fn odd(&mut self) -> f64 {
        self.unit() + 1.0 / f64::from(1_u32 << 24)
    }

    /// A nearly normal number with mean 0 and standard deviation 1: half the sum of twelve numbers in (−1, 1).
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.odd()).sum::<f64>() / 2.0
    }

    /// A number in [−1, 1), a multiple of 2⁻¹⁵.
    pub fn coarse(&mut self) -> f32 {
        let [a, b, ..] = self.bits().to_be_bytes();
        f32::from(u16::from_be_bytes([a, b])) / 32768.0 - 1.0
    }

    /// A random element of a slice.
    ///
    /// # Panics
    /// If the slice is empty.
    pub fn choose<'a, X>(&mut self, from: &'a [X]) -> &'a X {
        &from[self.below(from.len())]
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    #[test]
    fn the_sequence_is_the_published_one() {
        let mut random = Random::new(0);
        let first = [(); 3].map(|()| random.bits());
        let published = [
            0xe220_a839_7b1d_cdaf,
            0x6e78_9e6a_a1b9_65f4,
            0x06c4_5d18_8009_454f,
        ];
        assert_eq!(first, published);
    }

    #[test]
    fn numbers_are_the_leading_bits_of_the_sequence() {
        let seeded = || Random::new(0);
        let leading = f64::from(0x00e2_20a8_u32);
        assert_eq!(seeded().unit(), leading / 8_388_608.0 - 1.0);
        assert_eq!(seeded().odd(), (leading + 0.5) / 8_388_608.0 - 1.0);
        assert_eq!(
            f64::from(seeded().coarse()),
            f64::from(0xe220_u16) / 32768.0 - 1.0
        );
    }
}

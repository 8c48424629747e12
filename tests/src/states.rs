//! Random numbers and random states that are the same on every machine.
//!
//! In: a seed. Out: the sequence of SplitMix64 (Steele, Lea and Flood 2014), and states made of it.
//! All numbers of a state are multiples of 2⁻²¹ below 4, so that `f32` holds them exactly and a
//! function's error is not that of its arguments.

use std::array::from_fn;

use homogen::Scalar;

/// A generator of random numbers.
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

    /// A whole number below `end`, which is positive and small beside 2⁶⁴.
    ///
    /// # Panics
    /// Where `end` is 0.
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

    /// One of some things.
    ///
    /// # Panics
    /// Where there are none.
    pub fn choose<'a, X>(&mut self, from: &'a [X]) -> &'a X {
        &from[self.below(from.len())]
    }
}

/// A state of a robot with N joints.
#[derive(Clone, Copy, Debug)]
pub struct State<T, const N: usize> {
    /// Coordinates [rad or m].
    pub q: [T; N],
    /// Their rates.
    pub qd: [T; N],
    /// Their second rates.
    pub qdd: [T; N],
}

impl<const N: usize> State<f64, N> {
    /// A state with all entries in [−4, 4): every angle, and more than a turn.
    pub fn random(random: &mut Random) -> Self {
        let mut vector = || from_fn(|_| 4.0 * random.unit());
        Self {
            q: vector(),
            qd: vector(),
            qdd: vector(),
        }
    }

    /// The same state in another type of number.
    #[must_use]
    pub fn to<T: Scalar>(&self) -> State<T, N> {
        State {
            q: self.q.map(T::constant),
            qd: self.qd.map(T::constant),
            qdd: self.qdd.map(T::constant),
        }
    }
}

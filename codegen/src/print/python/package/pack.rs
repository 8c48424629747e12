//! Vectors: several numbers in a register. In a long function on arrays, compilers recognise vectors by chance, and
//! search for them for minutes.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::{Lanes, Number, is_moderate, of_any};
use crate::processor::Vectors;
use crate::real::{Real, sin_cos};

/// `L` numbers in a register of a processor.
#[derive(Clone, Copy)]
pub struct Pack<P, const L: usize> {
    /// Token that shows that the processor has the instructions; of size zero.
    processor: P,
    lanes: [Real; L],
}

impl<P: Vectors<L>, const L: usize> Pack<P, L> {
    /// Operations that are rare.
    #[inline(always)]
    fn one_by_one(self, operation: impl Fn(usize, Real) -> Real) -> Self {
        let mut lanes = self.lanes;
        for (lane, number) in lanes.iter_mut().enumerate() {
            *number = operation(lane, *number);
        }
        Self { lanes, ..self }
    }
}

macro_rules! operators {
    ($($name:ident $method:ident;)*) => {$(
        impl<P: Vectors<L>, const L: usize> $name for Pack<P, L> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let Self { processor, lanes } = self;
                Self { processor, lanes: processor.$method(lanes, other.lanes) }
            }
        }
    )*};
}
operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl<P: Vectors<L>, const L: usize> Neg for Pack<P, L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let Self { processor, lanes } = self;
        let lanes = processor.neg(lanes);
        Self { processor, lanes }
    }
}

impl<P: Vectors<L>, const L: usize> Number for Pack<P, L> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::filled(self.processor, value as Real)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let Self { processor, lanes } = self;
        let lanes = processor.sqrt(lanes);
        Self { processor, lanes }
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.one_by_one(|_, number| number.sign())
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let sine = self.one_by_one(|_, angle| angle.sin_cos().0);
        (sine, self.one_by_one(|_, angle| angle.sin_cos().1))
    }

    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sines, mut cosines) = (angles, angles);
        if let Some(first) = angles.first() {
            first.processor.sin_cos_all(&mut sines, &mut cosines);
        }
        (sines, cosines)
    }
}

/// Replaces angles by their sines and cosines, register by register.
#[inline(always)]
pub fn sines_and_cosines<P, const L: usize>(sines: &mut [Pack<P, L>], cosines: &mut [Pack<P, L>]) {
    for (sine, cosine) in sines.iter_mut().zip(cosines) {
        (sine.lanes, cosine.lanes) = of_lanes(sine.lanes);
    }
}

/// Sines and cosines of the angles in a register.
///
/// The code is straight if all angles are moderate; otherwise, after one branch, they are computed one by one.
#[inline(always)]
fn of_lanes<const L: usize>(angles: [Real; L]) -> ([Real; L], [Real; L]) {
    let mut moderate = true;
    for &angle in &angles {
        moderate &= is_moderate(angle);
    }
    if !moderate {
        return far(angles);
    }
    let (mut sines, mut cosines) = (angles, angles);
    for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
        (*sine, *cosine) = sin_cos(*sine);
    }
    (sines, cosines)
}

/// The same for angles of any size.
#[cold]
#[inline(never)]
fn far<const L: usize>(angles: [Real; L]) -> ([Real; L], [Real; L]) {
    let pairs = angles.map(of_any);
    (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
}

impl<P: Vectors<L>, const L: usize> Lanes for Pack<P, L> {
    const COUNT: usize = L;
    type Processor = P;

    #[inline(always)]
    fn filled(processor: P, number: Real) -> Self {
        let lanes = [number; L];
        Self { processor, lanes }
    }

    #[inline(always)]
    fn load<const N: usize>(states: &[[Real; N]], numbers: &mut [Self; N]) {
        if N < 4 || states.len() < L {
            load_each(states, numbers);
            return;
        }
        let processor = numbers[0].processor;
        for lane in (0..L).step_by(4) {
            for first in fours(N) {
                let row = |state: usize| four(&states[lane + state], first);
                let [a, b, c, d] = processor.turned([row(0), row(1), row(2), row(3)]);
                numbers[first].lanes[lane..lane + 4].copy_from_slice(&a);
                numbers[first + 1].lanes[lane..lane + 4].copy_from_slice(&b);
                numbers[first + 2].lanes[lane..lane + 4].copy_from_slice(&c);
                numbers[first + 3].lanes[lane..lane + 4].copy_from_slice(&d);
            }
        }
    }

    #[inline(always)]
    fn store<const N: usize>(numbers: &[Self; N], room: &mut [Real]) {
        if N < 4 || room.len() < L * N {
            store_each(numbers, room);
            return;
        }
        let processor = numbers[0].processor;
        for lane in (0..L).step_by(4) {
            for first in fours(N) {
                let row = |i: usize| four(&numbers[first + i].lanes, lane);
                let [a, b, c, d] = processor.turned([row(0), row(1), row(2), row(3)]);
                let at = lane * N + first;
                room[at..at + 4].copy_from_slice(&a);
                room[at + N..at + N + 4].copy_from_slice(&b);
                room[at + 2 * N..at + 2 * N + 4].copy_from_slice(&c);
                room[at + 3 * N..at + 3 * N + 4].copy_from_slice(&d);
            }
        }
    }
}

/// Loads the numbers of states one by one; the remaining lanes repeat the last state.
///
/// A separate function, as is the next: inlined, the compiler first checks all states and lanes for overlaps, which
/// takes a tenth of the time of an arm.
#[inline(never)]
fn load_each<P, const L: usize, const N: usize>(
    states: &[[Real; N]],
    numbers: &mut [Pack<P, L>; N],
) {
    for lane in 0..L {
        let state = &states[lane.min(states.len() - 1)];
        for (number, &entry) in numbers.iter_mut().zip(state) {
            number.lanes[lane] = entry;
        }
    }
}

/// Stores the numbers of the first lanes one by one.
#[inline(never)]
fn store_each<P, const L: usize, const N: usize>(numbers: &[Pack<P, L>; N], room: &mut [Real]) {
    for (i, number) in room.iter_mut().enumerate() {
        *number = numbers[i % N].lanes[i / N];
    }
}

/// Starts of groups of four; if the count is not a multiple of four, the last group overlaps the one before.
#[inline(always)]
fn fours(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(4).map(move |at| at.min(count - 4))
}

/// Four numbers of a list.
#[inline(always)]
fn four(numbers: &[Real], first: usize) -> [Real; 4] {
    [
        numbers[first],
        numbers[first + 1],
        numbers[first + 2],
        numbers[first + 3],
    ]
}

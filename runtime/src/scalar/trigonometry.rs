//! Sines and cosines of all joints at once, by this crate's own functions.
//!
//! In: the angles of a call \[rad\]. Out: their sines and cosines, with an error of less than a unit in
//! the last place for every finite angle.
//!
//! Neither the standard library nor `libm` is called, so that every platform gives the same digits; targets that
//! fuse products with sums differ in the last one. [`sin_cos_each`] calls the platform's functions instead, one by
//! one.
//!
//! With AVX-512, where a register holds a block of angles, they are inlined into each function of a robot. A call
//! would put angles, sines and all registers on the stack, up to a seventh of the time of a pose. They are also inlined
//! where the processor's instructions are chosen when the program runs.

use super::rounding::{OfTarget, Rounding};
pub use super::sin_cos_each;

pub mod double;
pub mod single;

/// The sines and the cosines of all angles \[rad\], within 0.9 units in the last place.
///
/// Straight-line, vectorised code if every magnitude is at most [`double::LIMIT`]; otherwise, after one branch
/// for all, angles are computed one by one. NaN and infinite angles give NaN.
#[cfg_attr(
    target_feature = "avx512f",
    expect(clippy::inline_always, reason = "a call puts all on the stack"),
    inline(always)
)]
#[cfg_attr(not(target_feature = "avx512f"), inline)]
#[must_use]
pub fn sin_cos_all_f64<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    inlined_f64::<OfTarget, N>(angles)
}

/// The same with the given rounding, always inlined.
#[expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]
#[inline(always)]
pub(super) fn inlined_f64<R: Rounding, const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let moderate = |all, angle: &f64| all & (angle.abs() <= double::LIMIT);
    if angles.iter().fold(true, moderate) {
        together(angles, double::sin_cos_moderate_by::<R>)
    } else {
        apart(&one_by_one(angles, double::sin_cos_by::<R>))
    }
}

/// The sines and the cosines of all angles \[rad\], within 0.92 units in the last place.
///
/// Straight-line, vectorised code if every magnitude is at most [`single::LIMIT`]; otherwise, after one branch
/// for all, angles are computed one by one. NaN and infinite angles give NaN.
/// No operation is in double precision.
#[cfg_attr(
    target_feature = "avx512f",
    expect(clippy::inline_always, reason = "a call puts all on the stack"),
    inline(always)
)]
#[cfg_attr(not(target_feature = "avx512f"), inline)]
#[must_use]
pub fn sin_cos_all_f32<const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    inlined_f32::<OfTarget, N>(angles)
}

/// The same with the given rounding, always inlined.
#[expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]
#[inline(always)]
pub(super) fn inlined_f32<R: Rounding, const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
    let moderate = |all, angle: &f32| all & (angle.abs() <= single::LIMIT);
    if angles.iter().fold(true, moderate) {
        together(angles, single::sin_cos_moderate_by::<R>)
    } else {
        apart(&one_by_one(angles, single::sin_cos_by::<R>))
    }
}

/// Applies `sin_cos`, which has no branch, to blocks of angles, so that the compiler vectorises it.
///
/// It vectorises loops of fixed length best: zeros fill the last block.
#[expect(
    clippy::inline_always,
    reason = "in a call of its own, lanes without an angle are computed as well"
)]
#[inline(always)]
fn together<T: Copy + Default, const N: usize>(
    angles: [T; N],
    sin_cos: impl Fn(T) -> (T, T),
) -> ([T; N], [T; N]) {
    let mut sines = [T::default(); N];
    let mut cosines = [T::default(); N];
    let (sine_blocks, last_sines) = sines.as_chunks_mut();
    let (cosine_blocks, last_cosines) = cosines.as_chunks_mut();
    let (blocks, last) = angles.as_chunks();
    for ((block, sines), cosines) in blocks.iter().zip(sine_blocks).zip(cosine_blocks) {
        (*sines, *cosines) = sin_cos_block(block, &sin_cos);
    }
    let mut block = [T::default(); BLOCK];
    copy(last, &mut block);
    let (block_sines, block_cosines) = sin_cos_block(&block, &sin_cos);
    copy(&block_sines, last_sines);
    copy(&block_cosines, last_cosines);
    (sines, cosines)
}

/// The lanes of a block: a multiple of those of a register; 1 without SIMD instructions.
const BLOCK: usize = if cfg!(any(
    target_feature = "sse2",
    target_feature = "neon",
    target_feature = "simd128"
)) {
    8
} else {
    1
};

/// Applies `sin_cos` to one block.
#[expect(
    clippy::inline_always,
    reason = "in a call of its own, lanes without an angle are computed as well"
)]
#[inline(always)]
fn sin_cos_block<T: Copy + Default>(
    angles: &[T; BLOCK],
    sin_cos: impl Fn(T) -> (T, T),
) -> ([T; BLOCK], [T; BLOCK]) {
    let mut sines = [T::default(); BLOCK];
    let mut cosines = [T::default(); BLOCK];
    for ((sine, cosine), angle) in sines.iter_mut().zip(&mut cosines).zip(angles) {
        (*sine, *cosine) = sin_cos(*angle);
    }
    (sines, cosines)
}

/// Copies up to the length of the shorter slice.
#[inline]
fn copy<T: Copy>(from: &[T], to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
}

/// The sines and the cosines of pairs, copied number by number.
///
/// A call returns its results in memory. If they were returned from there, the results that are computed without the
/// call would be stored in memory too. Copies keep those in registers: a tenth of the time of a pose where the sines
/// are inlined.
#[expect(clippy::inline_always, reason = "a call puts all on the stack")]
#[inline(always)]
fn apart<T: Copy + Default, const N: usize>(pairs: &[(T, T); N]) -> ([T; N], [T; N]) {
    let (mut sines, mut cosines) = ([T::default(); N], [T::default(); N]);
    for ((sine, cosine), pair) in sines.iter_mut().zip(&mut cosines).zip(pairs) {
        (*sine, *cosine) = *pair;
    }
    (sines, cosines)
}

/// Applies `sin_cos`, which may branch, to one angle after the other.
#[cold]
#[inline(never)]
fn one_by_one<T: Copy, const N: usize>(
    angles: [T; N],
    sin_cos: impl Fn(T) -> (T, T),
) -> [(T, T); N] {
    angles.map(sin_cos)
}

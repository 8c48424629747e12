//! Three-vectors and 3×3 blocks, as arrays.
//!
//! In: `[T; 3]` and rows `[[T; 3]; 3]`. Out: the vector algebra of the blocks of the 4×4 matrices, with the
//! paper's underscore operator (§ 2.1). Arrays have no frame; the typed matrices have.

use crate::scalar::{Real, Scalar};
use core::array::from_fn;

/// a · b.
#[inline]
#[must_use]
pub fn dot<T: Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
///
/// SPACELIB: `cross`.
#[inline]
#[must_use]
pub fn cross<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + b.
#[inline]
#[must_use]
pub fn add<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    from_fn(|i| a[i] + b[i])
}

/// a − b.
///
/// SPACELIB: `vect` (the vector from b to a).
#[inline]
#[must_use]
pub fn sub<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    from_fn(|i| a[i] - b[i])
}

/// s a.
#[inline]
#[must_use]
pub fn scale<T: Scalar>(s: T, a: [T; 3]) -> [T; 3] {
    a.map(|x| s * x)
}

/// −a.
#[inline]
#[must_use]
pub fn negate<T: Scalar>(a: [T; 3]) -> [T; 3] {
    a.map(|x| -x)
}

/// a bᵗ, as rows.
#[inline]
#[must_use]
pub fn outer<T: Scalar>(a: [T; 3], b: [T; 3]) -> [[T; 3]; 3] {
    from_fn(|i| from_fn(|j| a[i] * b[j]))
}

/// The skew-symmetric matrix v̲ with v̲ c = v × c, as rows (§ 2.1, the underscore operator).
///
/// SPACELIB: `vtom`, its 3×3 block.
///
/// ```
/// use homogen::vector::{cross, product, underscore};
/// let (v, c) = ([1.0, 2.0, 3.0], [0.5, -1.0, 2.0]);
/// assert_eq!(product(&underscore(v), c), cross(v, c));
/// ```
#[inline]
#[must_use]
pub fn underscore<T: Scalar>(v: [T; 3]) -> [[T; 3]; 3] {
    let zero = T::constant(0.0);
    [
        [zero, -v[2], v[1]],
        [v[2], zero, -v[0]],
        [-v[1], v[0], zero],
    ]
}

/// The vector of the skew-symmetric part ½(X − Xᵗ): the inverse of [`underscore`] on skew matrices
/// (§ 2.1, and ω̲̇ = ½(G − Gᵗ) of § 3.1).
///
/// SPACELIB: `mtov`, its 3×3 block.
#[inline]
#[must_use]
pub fn axial<T: Scalar>(x: &[[T; 3]; 3]) -> [T; 3] {
    let half = T::constant(0.5);
    [
        half * (x[2][1] - x[1][2]),
        half * (x[0][2] - x[2][0]),
        half * (x[1][0] - x[0][1]),
    ]
}

/// X v.
#[inline]
#[must_use]
pub fn product<T: Scalar>(x: &[[T; 3]; 3], v: [T; 3]) -> [T; 3] {
    x.map(|row| dot(row, v))
}

/// Xᵗ v.
#[inline]
#[must_use]
pub fn transposed_product<T: Scalar>(x: &[[T; 3]; 3], v: [T; 3]) -> [T; 3] {
    product(&transpose(x), v)
}

/// X Y.
#[inline]
#[must_use]
pub fn matrix_product<T: Scalar>(x: &[[T; 3]; 3], y: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let columns = transpose(y);
    x.map(|row| columns.map(|column| dot(row, column)))
}

/// Xᵗ.
#[inline]
#[must_use]
pub fn transpose<T: Scalar>(x: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    from_fn(|i| from_fn(|j| x[j][i]))
}

/// X + Y.
#[inline]
#[must_use]
pub fn matrix_sum<T: Scalar>(x: &[[T; 3]; 3], y: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    from_fn(|i| add(x[i], y[i]))
}

/// s X.
#[inline]
#[must_use]
pub fn matrix_scale<T: Scalar>(s: T, x: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    x.map(|row| scale(s, row))
}

/// The identity.
#[inline]
#[must_use]
pub fn identity<T: Scalar>() -> [[T; 3]; 3] {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

/// The determinant.
#[inline]
#[must_use]
pub fn determinant<T: Scalar>(x: &[[T; 3]; 3]) -> T {
    dot(x[0], cross(x[1], x[2]))
}

/// The largest magnitude; NaN is ignored, and zero is returned if there is no other number.
#[inline]
pub(crate) fn largest_magnitude<'a, T: Real + 'a>(entries: impl IntoIterator<Item = &'a T>) -> T {
    let entries = entries.into_iter();
    entries.fold(T::constant(0.0), |largest, x| largest.max(x.abs()))
}

/// ‖v‖, without overflow or underflow of squares; NaN or infinity if an entry is.
///
/// SPACELIB: `mod`.
#[inline]
#[must_use]
pub fn norm<T: Real, const N: usize>(v: [T; N]) -> T {
    let zero = T::constant(0.0);
    // The comparisons below would lose infinity and NaN.
    if let Some(x) = v.iter().find(|x| !x.is_finite()) {
        return x.abs();
    }
    let largest = largest_magnitude(&v);
    if largest == zero {
        return zero;
    }
    let sum = |v: [T; N]| v.iter().fold(zero, |sum, x| sum + *x * *x);
    let squares = sum(v);
    // Squares below the second bound have lost digits.
    if squares.is_finite() && squares * T::EPSILON * T::EPSILON > T::MIN_POSITIVE {
        squares.sqrt()
    } else {
        largest * sum(v.map(|x| x / largest)).sqrt()
    }
}

/// v / ‖v‖, or `None` for the zero vector and for entries that are not finite.
///
/// SPACELIB: `unitv`.
#[inline]
#[must_use]
pub fn unit<T: Real, const N: usize>(v: [T; N]) -> Option<[T; N]> {
    let zero = T::constant(0.0);
    let largest = largest_magnitude(&v);
    let length = norm(v);
    if length < T::MIN_POSITIVE && length > zero {
        // A subnormal length has few digits; that of a larger multiple of the vector has all of them.
        return unit(v.map(|x| x / largest));
    }
    (length > zero && v.iter().all(|x| x.is_finite())).then(|| {
        if length.is_finite() {
            v.map(|x| x / length)
        } else {
            let scaled = v.map(|x| x / largest);
            let length = norm(scaled);
            scaled.map(|x| x / length)
        }
    })
}

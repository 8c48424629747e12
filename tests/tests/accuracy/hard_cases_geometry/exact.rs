//! Vectors, rotations and screws in 256 bits.
//!
//! In: exact values. Out: the formulas of the paper in their plainest form, independent of the runtime.

use std::array::from_fn;

use homogen_tests::big::Big;

use crate::hard_cases_geometry::measure::Number;

/// A vector of three numbers.
pub type Vector = [Big; 3];
/// A matrix, row by row.
pub type Matrix = [[Big; 3]; 3];

/// Exact values of several numbers.
pub fn exact<T: Number, const K: usize>(v: [T; K]) -> [Big; K] {
    v.map(Number::big)
}

/// Exact values of a matrix.
pub fn exact_matrix<T: Number>(x: &[[T; 3]; 3]) -> Matrix {
    x.map(exact)
}

/// A matrix rounded to a type.
pub fn nearest_matrix<T: Number>(x: &Matrix) -> [[T; 3]; 3] {
    from_fn(|i| from_fn(|j| T::nearest(&x[i][j])))
}

/// a · b.
pub fn dot(a: &Vector, b: &Vector) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// ‖v‖.
pub fn norm(v: &Vector) -> Big {
    dot(v, v).sqrt()
}

/// a × b.
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    let entry = |j: usize, k: usize| &a[j] * &b[k] - &a[k] * &b[j];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

/// The sizes of the terms of a × b.
pub fn cross_size(a: &Vector, b: &Vector) -> Vector {
    let entry = |j: usize, k: usize| (&a[j] * &b[k]).abs() + (&a[k] * &b[j]).abs();
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

/// s v.
pub fn scale(s: &Big, v: &Vector) -> Vector {
    from_fn(|i| s * &v[i])
}

/// a + b.
pub fn add(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| &a[i] + &b[i])
}

/// a − b.
pub fn sub(a: &Vector, b: &Vector) -> Vector {
    from_fn(|i| &a[i] - &b[i])
}

/// v / ‖v‖.
pub fn unit(v: &Vector) -> Vector {
    scale(&(Big::one() / norm(v)), v)
}

/// X Y.
pub fn product(x: &Matrix, y: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|j| dot(&x[i], &from_fn(|k| y[k][j].clone()))))
}

/// Xᵗ.
pub fn transpose(x: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|j| x[j][i].clone()))
}

/// The largest entry of |X − Y|.
pub fn distance(x: &Matrix, y: &Matrix) -> Big {
    let differences = x.iter().flatten().zip(y.iter().flatten());
    differences.fold(Big::zero(), |most, (x, y)| most.max((x - y).abs()))
}

/// sin φ and 1 − cos φ, from half the angle.
pub fn sine_versine(phi: &Big) -> (Big, Big) {
    let (sine, cosine) = (phi / Big::new(2.0)).sin_cos();
    let double = Big::new(2.0) * &sine;
    (&double * cosine, double * sine)
}

/// φ − sin φ, by its series where the difference would cancel.
pub fn excess(phi: &Big) -> Big {
    if phi.abs() > Big::one() {
        return phi - phi.sin_cos().0;
    }
    let square = phi * phi;
    let mut term = phi * &square / Big::new(6.0);
    let mut sum = term.clone();
    let negligible = sum.abs() * Big::new(2_f64.powi(-250));
    let mut n = 4.0;
    while term.abs() > negligible {
        term = -(term * &square) / Big::new(n * (n + 1.0));
        sum = sum + &term;
        n += 2.0;
    }
    sum
}

/// R = I + u̲ sin φ + u̲² (1 − cos φ) for u of any length, with u̲² = u uᵗ − |u|² I.
pub fn rotation(u: &Vector, phi: &Big) -> Matrix {
    let (sine, versine) = sine_versine(phi);
    let [x, y, z] = scale(&sine, u);
    let zero = Big::zero;
    let skew = [[zero(), -&z, y.clone()], [z, zero(), -&x], [-y, x, zero()]];
    let diagonal = Big::one() - &versine * dot(u, u);
    let along = scale(&versine, u);
    from_fn(|i| {
        from_fn(|j| {
            let entry = &along[i] * &u[j] + &skew[i][j];
            if i == j { entry + &diagonal } else { entry }
        })
    })
}

/// t = b φ + u × b (1 − cos φ) + u × (u × b) (φ − sin φ), and the sizes of its terms.
pub fn translation(u: &Vector, b: &Vector, phi: &Big) -> (Vector, Vector) {
    let ((_, versine), excess) = (sine_versine(phi), excess(phi));
    let across = cross(u, b);
    let back = cross(u, &across);
    let t = add(
        &add(&scale(phi, b), &scale(&versine, &across)),
        &scale(&excess, &back),
    );
    let (u, b) = (u.each_ref().map(Big::abs), b.each_ref().map(Big::abs));
    let across = cross_size(&u, &b);
    let back = cross_size(&u, &across);
    let sum = add(&scale(&phi.abs(), &b), &scale(&versine, &across));
    (t, add(&sum, &scale(&excess.abs(), &back)))
}

/// The rotation nearest to a matrix with positive determinant: its polar factor, by Newton's iteration
/// X ← ½ (X + X⁻ᵗ), which converges quadratically (Higham 1986).
pub fn nearest_rotation(x: &Matrix) -> Matrix {
    let half = Big::new(0.5);
    (0..10).fold(x.clone(), |x, _| {
        // The rows of X⁻ᵗ times the determinant.
        let [a, b, c] = &x;
        let cofactors = [cross(b, c), cross(c, a), cross(a, b)];
        let inverse = Big::one() / dot(a, &cofactors[0]);
        from_fn(|i| scale(&half, &add(&x[i], &scale(&inverse, &cofactors[i]))))
    })
}

/// Axis and angle in [0, π] of a rotation, from the longest column of the quaternion's outer product.
pub fn axis_angle(r: &Matrix) -> (Vector, Big) {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = r;
    let one = Big::one;
    let columns = [
        [one() + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, one() + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, one() - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, one() - xx - yy + zz],
    ];
    let longest = (0..4)
        .max_by(|&i, &j| columns[i][i].partial_cmp(&columns[j][j]).expect("numbers"))
        .expect("four");
    let [w, v @ ..] = columns[longest].clone();
    let (w, v) = if w < Big::zero() {
        (-w, v.map(|x| -x))
    } else {
        (w, v)
    };
    let angle = Big::new(2.0) * norm(&v).atan2(&w);
    (unit(&v), angle)
}

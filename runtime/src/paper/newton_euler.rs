//! Φ = skew\[Ẇ J\] and Γ = skew\[W J\], solved for any six of their twelve numbers.
//!
//! In: the inertia of a body, and any six of the twelve numbers that determine the others. Out: all
//! twelve. Six dynamic numbers are the direct dynamics of a free body, six kinematic ones its inverse
//! dynamics.

use crate::error::{Error, finite};
use crate::matrix::vector::largest_magnitude;
use crate::matrix::{Acceleration, Action, Inertia, Momentum, Velocity};
use crate::scalar::Real;
use core::array::from_fn;

/// The velocity and momentum of a body from six of their twelve components: Γ = skew\[W J\] (26).
///
/// `kinematic` is ω_x, ω_y, ω_z, v_x, v_y, v_z (rad/s, m/s) and `dynamic` γ_x, γ_y, γ_z, ρ_x, ρ_y,
/// ρ_z (kg m²/s, kg m/s), all in the frame of `inertia`; `Some` is given, `None` is unknown.
///
/// SPACELIB: `dyn_eq`.
///
/// # Errors
///
/// [`Error::NotFinite`]; [`Error::Degenerate`] unless exactly six are given and they determine the
/// others. A body without inertia about an axis is degenerate.
pub fn momentum<T: Real>(
    inertia: &Inertia<T>,
    kinematic: [Option<T>; 6],
    dynamic: [Option<T>; 6],
) -> Result<(Velocity<T>, Momentum<T>), Error> {
    let (w, g) = solve(inertia, kinematic, dynamic)?;
    Ok((
        Velocity::new([w[0], w[1], w[2]], [w[3], w[4], w[5]]),
        Momentum::new([g[0], g[1], g[2]], [g[3], g[4], g[5]]),
    ))
}

/// The rate Ẇ and the wrench on a body at rest from six of their twelve components: Φ = skew\[Ẇ J\] (25).
///
/// `kinematic` is ω̇ and the acceleration of the pole (rad/s², m/s²) and `dynamic` c and f (N m, N),
/// all in the frame of `inertia`; `Some` is given, `None` is unknown.
/// For a moving body, Φ − skew\[W² J\] replaces Φ: [`action_in_motion`].
///
/// SPACELIB: `dyn_eq`.
///
/// # Errors
///
/// As [`momentum`].
///
/// ```
/// use homogen::{Inertia, newton_euler};
/// let tensor = [[0.3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.4]];
/// let body = Inertia::from_tensor_at_origin(2.0, [0.0; 3], &tensor);
/// // A hinge about z: the other components of Ẇ vanish, the torque about it is 8 N m.
/// let (zero, unknown) = (Some(0.0), None);
/// let (w_dot, phi) = newton_euler::action(
///     &body,
///     [zero, zero, unknown, zero, zero, zero],
///     [unknown, unknown, Some(8.0), unknown, unknown, unknown],
/// )
/// .unwrap();
/// assert!((w_dot.omega()[2] - 20.0_f64).abs() < 1e-13);
/// assert_eq!(phi.f(), [0.0; 3]);
/// ```
pub fn action<T: Real>(
    inertia: &Inertia<T>,
    kinematic: [Option<T>; 6],
    dynamic: [Option<T>; 6],
) -> Result<(Velocity<T>, Action<T>), Error> {
    let (w, phi) = solve(inertia, kinematic, dynamic)?;
    Ok((
        Velocity::new([w[0], w[1], w[2]], [w[3], w[4], w[5]]),
        Action::new([phi[0], phi[1], phi[2]], [phi[3], phi[4], phi[5]]),
    ))
}

/// The same for a body with velocity `w`: Φ = skew\[H J\] with H = Ẇ + W² (25), from any six of Ẇ and Φ.
///
/// SPACELIB: `dyn_eq`.
///
/// # Errors
///
/// As [`momentum`].
pub fn action_in_motion<T: Real>(
    inertia: &Inertia<T>,
    w: &Velocity<T>,
    kinematic: [Option<T>; 6],
    dynamic: [Option<T>; 6],
) -> Result<(Acceleration<T>, Action<T>), Error> {
    let square = inertia.action(&Acceleration::from_velocity_derivative(
        w,
        &Velocity::zero(),
    ));
    let [cx, cy, cz] = square.c();
    let [fx, fy, fz] = square.f();
    let offset = [cx, cy, cz, fx, fy, fz];
    let (w_dot, phi) = action(
        inertia,
        kinematic,
        from_fn(|i| dynamic[i].map(|x| x - offset[i])),
    )?;
    Ok((
        Acceleration::from_velocity_derivative(w, &w_dot),
        phi + square,
    ))
}

/// x and y of A x = y from six of their twelve numbers, with A the map of W to skew\[W J\].
fn solve<T: Real>(
    inertia: &Inertia<T>,
    kinematic: [Option<T>; 6],
    dynamic: [Option<T>; 6],
) -> Result<([T; 6], [T; 6]), Error> {
    let zero = T::constant(0.0);
    let (before, after) = (kinematic.iter(), dynamic.iter());
    let given = before.clone().chain(after.clone()).flatten();
    if given.clone().count() != 6 {
        return Err(Error::Degenerate {
            quantity: "a system without exactly six given components; their number",
            value: given.fold(0.0, |count, _| count + 1.0),
        });
    }
    finite("a given component", given)?;
    // (A, −1) (x; y) = 0: given columns go to the right-hand side, the six others are the system.
    let a = spatial_inertia(inertia);
    let coefficient = |i: usize, k: usize| match a[i].get(k) {
        Some(entry) => *entry,
        None if k == i + 6 => T::constant(-1.0),
        None => zero,
    };
    let mut system = [[zero; 7]; 6];
    let mut places = [0; 6];
    let mut sought = 0;
    for (k, known) in before.chain(after).enumerate() {
        for (i, row) in system.iter_mut().enumerate() {
            if let Some(value) = known {
                row[6] = row[6] - coefficient(i, k) * *value;
            } else {
                row[sought] = coefficient(i, k);
            }
        }
        if known.is_none() {
            places[sought] = k;
            sought += 1;
        }
    }
    let found = eliminate(system)?;
    let value = |k: usize, known: Option<T>| {
        let place = places.iter().zip(found).find(|(place, _)| **place == k);
        known.or(place.map(|(_, x)| x)).unwrap_or(zero)
    };
    Ok((
        from_fn(|i| value(i, kinematic[i])),
        from_fn(|i| value(i + 6, dynamic[i])),
    ))
}

/// The 6×6 matrix of W ↦ skew\[W J\], as rows; computed column by column.
fn spatial_inertia<T: Real>(inertia: &Inertia<T>) -> [[T; 6]; 6] {
    let columns: [[T; 6]; 6] = from_fn(|k| {
        let unit = |i: usize| T::constant(if i == k { 1.0 } else { 0.0 });
        let w = Velocity::new([unit(0), unit(1), unit(2)], [unit(3), unit(4), unit(5)]);
        let gamma = inertia.momentum(&w);
        let ([a, b, c], [d, e, f]) = (gamma.gamma(), gamma.rho());
        [a, b, c, d, e, f]
    });
    from_fn(|i| from_fn(|j| columns[j][i]))
}

/// Gauss–Jordan elimination with complete pivoting on rows and columns scaled to a largest entry 1.
fn eliminate<T: Real>(mut system: [[T; 7]; 6]) -> Result<[T; 6], Error> {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let scale: [T; 6] = from_fn(|j| {
        let scale = largest_magnitude(system.iter().map(|row| &row[j]));
        if scale > zero { scale } else { one }
    });
    for row in &mut system {
        for (entry, scale) in row.iter_mut().zip(&scale) {
            *entry = *entry / *scale;
        }
        let size = largest_magnitude(row.iter().take(6));
        if size > zero {
            *row = row.map(|x| x / size);
        }
    }
    let mut order: [usize; 6] = from_fn(|i| i);
    for k in 0..6 {
        let (mut p, mut q) = (k, k);
        for i in k..6 {
            for j in k..6 {
                if system[i][j].abs() > system[p][q].abs() {
                    (p, q) = (i, j);
                }
            }
        }
        let pivot = system[p][q];
        if pivot.abs() <= T::constant(64.0) * T::EPSILON || !pivot.is_finite() {
            return Err(Error::Degenerate {
                quantity: "a pivot of the system",
                value: pivot.to_f64(),
            });
        }
        system.swap(k, p);
        for row in &mut system {
            row.swap(k, q);
        }
        order.swap(k, q);
        let pivot_row = system[k].map(|x| x / pivot);
        for (i, row) in system.iter_mut().enumerate() {
            let factor = if i == k { zero } else { row[k] };
            *row = if i == k {
                pivot_row
            } else {
                from_fn(|j| row[j] - factor * pivot_row[j])
            };
        }
    }
    let mut x = [zero; 6];
    for (row, column) in system.iter().zip(order) {
        x[column] = row[6] / scale[column];
    }
    Ok(x)
}

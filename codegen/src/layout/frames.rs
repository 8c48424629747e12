//! Frames that make entries of the placements 0 or 1.
//!
//! In: a direction, a placement or an inertia. Out: the pose of the better frame in the given one.

use crate::expression::Term;
use crate::matrix::{Inertia, Pose, Rotation, Symmetric, Vector};

/// Squared sine of the angle between two axes below which no common normal is used: its foot is so far away that digits
/// are lost there, and for an angle of some 1e-16 all of them. Six degrees.
const NEARLY_PARALLEL: f64 = 0.01;

/// The frame with x along the common normal of z and the z of `next`, and with its origin at the foot of that normal.
pub(super) fn common_normal<'g>(next: &Pose<Term<'g>>) -> Pose<Term<'g>> {
    let direction = next.rotation.column(2);
    let graph = direction.x().graph();
    let zero = graph.constant(0.0);
    let [x, y, cosine] = direction.0;
    let to = next.translation;
    if x.is_zero() && y.is_zero() {
        // Parallel axes: the normal points to the next axis; its foot may be anywhere.
        let normal = Vector([to.x(), to.y(), zero]).normalized();
        return normal.map_or_else(
            || Pose::identity(graph),
            |normal| Pose::rotation(about_z_towards(normal)),
        );
    }
    let square = x * x + y * y;
    let apart = square
        .value()
        .is_some_and(|square| square.to_f64() >= NEARLY_PARALLEL);
    // z × z' = (−y, x, 0); the foot is where the distance of the two lines is least.
    let normal = Vector([-y, x, zero]).normalized().filter(|_| apart);
    let Some(normal) = normal else {
        return Pose::identity(graph);
    };
    let along = to.z() - cosine * direction.dot(to);
    let foot = Vector([zero, zero, along / square]);
    Pose {
        rotation: about_z_towards(normal),
        translation: foot,
    }
}

/// The rotation about z that maps x to a direction of the xy plane.
fn about_z_towards(direction: Vector<Term<'_>>) -> Rotation<Term<'_>> {
    Rotation::about_z((direction.y(), direction.x()))
}

/// The rotation about z that makes q_y zero or, if the centre of mass is on the axis, J_xy. `None` if it is zero
/// already, or if it depends on a run-time parameter.
pub(super) fn towards_mass_center<'g>(inertia: &Inertia<Term<'g>>) -> Option<Pose<Term<'g>>> {
    let [x, y, _] = inertia.q.0;
    let Symmetric([xx, yy, _, xy, ..]) = inertia.second;
    let zero = x.graph().constant(0.0);
    for entry in [x, y, xx, yy, xy] {
        entry.value()?;
    }
    let direction = if !(x.is_zero() && y.is_zero()) {
        Vector([x, y, zero])
    } else if !xy.is_zero() {
        half(Vector([xx - yy, xy + xy, zero]).normalized()?)
    } else {
        return None;
    };
    let direction = direction.normalized()?;
    Some(Pose::rotation(about_z_towards(direction)))
}

/// The bisector of x and a direction of the xy plane: tan ψ/2 = s / (1 + c), or (1 − c) / s where 1 + c would cancel.
fn half(direction: Vector<Term<'_>>) -> Vector<Term<'_>> {
    let [cosine, sine, zero] = direction.0;
    let one = zero.graph().constant(1.0);
    let negative = |term: Term<'_>| term.value().is_some_and(|value| value.to_f64() < 0.0);
    match (negative(cosine), negative(sine)) {
        (false, _) => Vector([one + cosine, sine, zero]),
        (true, false) => Vector([sine, one - cosine, zero]),
        (true, true) => Vector([-sine, cosine - one, zero]),
    }
}

/// Sine and cosine of an angle about z, and the rotation without it.
pub(super) type Split<'g> = ((Term<'g>, Term<'g>), Rotation<Term<'g>>);

/// Splits a rotation about z off the right side of a placement, to be added to q, if that leaves fewer products:
/// R = R' Rz(β). Returns sine and cosine of β, and R'.
pub(super) fn split_offset(rotation: Rotation<Term<'_>>) -> Option<Split<'_>> {
    let simple = |entry: Term<'_>| {
        entry
            .value()
            .is_some_and(|value| value.is_zero() || value.is_one() || (-value).is_one())
    };
    if rotation.0.iter().flatten().all(|&entry| simple(entry)) {
        return None;
    }
    let [[xx, xy, xz], _, [zx, zy, _]] = rotation.0;
    let (sine, cosine) = if xz.is_zero() {
        (-xy, xx)
    } else {
        let zero = xz.graph().constant(0.0);
        let direction = Vector([zx, zy, zero]).normalized()?;
        (direction.x(), direction.y())
    };
    if sine.is_zero() || cosine.is_zero() {
        return None;
    }
    Some((
        (sine, cosine),
        rotation * Rotation::about_z((-sine, cosine)),
    ))
}

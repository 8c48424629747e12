//! Points, lines and planes.
//!
//! In: points (m), directions, lines and planes. Out: angles, distances, intersections and projections.
//! Parallel or coincident input, to rounding, is an error with the quantity that vanishes; finite input
//! never gives NaN.

use crate::error::{Error, finite};
use crate::matrix::vector::{add, cross, dot, norm, scale, sub, unit};
use crate::scalar::Real;

/// A line: a point of it (m) and its unit vector.
///
/// SPACELIB: `LINE`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Line<T> {
    point: [T; 3],
    direction: [T; 3],
}

/// A plane: the points p with n · p = d, n its unit normal and d its distance from the origin (m),
/// positive along n.
///
/// SPACELIB: `PLANE`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Plane<T> {
    normal: [T; 3],
    offset: T,
}

/// The closest points of two lines.
///
/// SPACELIB: the results of `intersection`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Approach<T> {
    /// The point of the first line (m).
    pub first: [T; 3],
    /// The point of the second line (m).
    pub second: [T; 3],
    /// Their distance (m): 0 where the lines meet.
    pub distance: T,
}

impl<T: Real> Line<T> {
    /// The line through `point` (m) along `direction`, of any length.
    ///
    /// SPACELIB: `linepvect`.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`]; [`Error::Degenerate`] for the zero vector.
    pub fn from_point_and_direction(point: [T; 3], direction: [T; 3]) -> Result<Self, Error> {
        finite("a coordinate of the point", &point)?;
        Ok(Self {
            point,
            direction: unit_or_refuse("the direction of the line", direction)?,
        })
    }

    /// The line from `a` to `b` (m).
    ///
    /// SPACELIB: `line2p`.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`]; [`Error::Degenerate`] for one point given twice.
    pub fn through(a: [T; 3], b: [T; 3]) -> Result<Self, Error> {
        Self::from_point_and_direction(a, sub(b, a))
    }

    /// The given point (m).
    #[inline]
    #[must_use]
    pub const fn point(&self) -> [T; 3] {
        self.point
    }

    /// The unit vector.
    #[inline]
    #[must_use]
    pub const fn direction(&self) -> [T; 3] {
        self.direction
    }

    /// The point of the line that is nearest to `point` (m).
    ///
    /// SPACELIB: `projponl`.
    #[inline]
    #[must_use]
    pub fn project(&self, point: [T; 3]) -> [T; 3] {
        let along = dot(self.direction, sub(point, self.point));
        add(self.point, scale(along, self.direction))
    }

    /// The distance of `point` from the line (m).
    ///
    /// SPACELIB: `projponl`, its distance.
    #[inline]
    #[must_use]
    pub fn distance(&self, point: [T; 3]) -> T {
        norm(cross(self.direction, sub(point, self.point)))
    }

    /// The closest points of this line and `other`; their intersection if they meet.
    ///
    /// SPACELIB: `intersection`.
    ///
    /// # Errors
    ///
    /// [`Error::Degenerate`] for lines that are parallel to rounding.
    pub fn approach(&self, other: &Self) -> Result<Approach<T>, Error> {
        let normal = cross(self.direction, other.direction);
        let square = dot(normal, normal);
        let sine = norm(normal);
        refuse_parallel("the sine of the angle between the lines", sine)?;
        let between = sub(other.point, self.point);
        // n × d₂ is perpendicular to the second line and to the common normal.
        let along_first = dot(between, cross(other.direction, normal)) / square;
        let along_second = dot(between, cross(self.direction, normal)) / square;
        Ok(Approach {
            first: add(self.point, scale(along_first, self.direction)),
            second: add(other.point, scale(along_second, other.direction)),
            distance: (dot(between, normal) / sine).abs(),
        })
    }
}

impl<T: Real> Plane<T> {
    /// The plane through `point` (m) with a normal of any length.
    ///
    /// SPACELIB: `plane2`.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`]; [`Error::Degenerate`] for the zero vector.
    pub fn from_point_and_normal(point: [T; 3], normal: [T; 3]) -> Result<Self, Error> {
        finite("a coordinate of the point", &point)?;
        let normal = unit_or_refuse("the normal of the plane", normal)?;
        Ok(Self {
            normal,
            offset: dot(normal, point),
        })
    }

    /// The plane through three points (m); its normal is that of a, b, c counted anticlockwise.
    ///
    /// SPACELIB: `plane`.
    ///
    /// # Errors
    ///
    /// [`Error::NotFinite`]; [`Error::Degenerate`] for points that lie on one line to rounding.
    pub fn through(a: [T; 3], b: [T; 3], c: [T; 3]) -> Result<Self, Error> {
        let first = unit_or_refuse("the distance of the first two points", sub(b, a))?;
        let second = unit_or_refuse("the distance of the first and third points", sub(c, a))?;
        let normal = cross(first, second);
        refuse_parallel("the sine of the angle at the first point", norm(normal))?;
        Self::from_point_and_normal(a, normal)
    }

    /// The unit normal n.
    #[inline]
    #[must_use]
    pub const fn normal(&self) -> [T; 3] {
        self.normal
    }

    /// d of n · p = d (m).
    #[inline]
    #[must_use]
    pub const fn offset(&self) -> T {
        self.offset
    }

    /// The distance of `point` from the plane (m), negative on the side away from the normal.
    ///
    /// SPACELIB: `distpp`.
    #[inline]
    #[must_use]
    pub fn distance(&self, point: [T; 3]) -> T {
        dot(self.normal, point) - self.offset
    }

    /// The point of the plane that is nearest to `point` (m).
    ///
    /// SPACELIB: `project`.
    #[inline]
    #[must_use]
    pub fn project(&self, point: [T; 3]) -> [T; 3] {
        sub(point, scale(self.distance(point), self.normal))
    }

    /// The line in which two planes meet; its point is the one nearest to the origin.
    ///
    /// SPACELIB: `inters2pl`.
    ///
    /// # Errors
    ///
    /// [`Error::Degenerate`] for planes that are parallel to rounding.
    pub fn intersection(&self, other: &Self) -> Result<Line<T>, Error> {
        let direction = cross(self.normal, other.normal);
        refuse_parallel("the sine of the angle between the planes", norm(direction))?;
        let weighted = sub(
            scale(self.offset, other.normal),
            scale(other.offset, self.normal),
        );
        let point = cross(weighted, direction).map(|x| x / dot(direction, direction));
        Line::from_point_and_direction(point, direction)
    }

    /// The point in which a line meets the plane (m).
    ///
    /// SPACELIB: `interslpl`.
    ///
    /// # Errors
    ///
    /// [`Error::Degenerate`] for a line that is parallel to the plane to rounding.
    pub fn intersection_with_line(&self, line: &Line<T>) -> Result<[T; 3], Error> {
        let sine = dot(self.normal, line.direction);
        refuse_parallel("the sine of the angle between line and plane", sine)?;
        let along = -self.distance(line.point) / sine;
        Ok(add(line.point, scale(along, line.direction)))
    }
}

/// The angle between two vectors of any length, in \[0, π\] rad; 0 where one of them is zero.
///
/// Computed by atan2 of the lengths of vector and scalar product, which is accurate at small angles, unlike acos.
///
/// SPACELIB: `angle`.
#[must_use]
pub fn angle<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    match (unit(a), unit(b)) {
        (Some(a), Some(b)) => norm(cross(a, b)).atan2(dot(a, b)),
        _ => T::constant(0.0),
    }
}

/// The distance of two points (m).
///
/// SPACELIB: `dist`.
#[inline]
#[must_use]
pub fn distance<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    norm(sub(b, a))
}

/// The point at `fraction` of the way from `a` to `b` (m): a (1 − fraction) + b fraction.
///
/// SPACELIB: `intermediate`.
#[inline]
#[must_use]
pub fn intermediate<T: Real>(a: [T; 3], b: [T; 3], fraction: T) -> [T; 3] {
    add(scale(T::constant(1.0) - fraction, a), scale(fraction, b))
}

/// The point half way from `a` to `b` (m).
///
/// SPACELIB: `middle`.
#[inline]
#[must_use]
pub fn middle<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    intermediate(a, b, T::constant(0.5))
}

/// The unit vector along `v`, or an error with the name of the quantity.
fn unit_or_refuse<T: Real>(quantity: &'static str, v: [T; 3]) -> Result<[T; 3], Error> {
    finite(quantity, &v)?;
    unit(v).ok_or(Error::Degenerate {
        quantity,
        value: 0.0,
    })
}

/// Rejects an angle whose sine is zero to rounding.
pub(super) fn refuse_parallel<T: Real>(quantity: &'static str, sine: T) -> Result<(), Error> {
    if sine.abs() <= T::constant(4.0) * T::EPSILON {
        return Err(Error::Degenerate {
            quantity,
            value: sine.to_f64(),
        });
    }
    Ok(())
}

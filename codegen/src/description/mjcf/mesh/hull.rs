//! Convex hull of the vertices of a mesh.
//!
//! In: points. Out: triangles that face outwards, as indices of the points. Quickhull: a hull grows by the farthest of
//! the points outside a face. Points in the plane of a face are not outside it. The side of a point is decided in
//! `f64`, and in 106 bits where that is uncertain, which is exact for coordinates in single precision of like size.

use std::collections::HashMap;

use crate::description::spatial::{cross, dot, exactly, minus};

type Point = [f64; 3];

/// A face of the hull so far.
struct Face {
    /// Counterclockwise, seen from outside.
    corners: [usize; 3],
    /// The face across the edge from corner k to corner k + 1.
    neighbors: [usize; 3],
    /// Points outside this face; each point outside the hull is in one list.
    outside: Vec<usize>,
    is_removed: bool,
}

/// The hull so far.
struct Hull<'p> {
    points: &'p [Point],
    faces: Vec<Face>,
}

/// The triangles of the convex hull; an error if the points are in a plane.
pub(super) fn hull(points: &[Point]) -> Result<Vec<[usize; 3]>, String> {
    let first = simplex(points).ok_or("its vertices are in a plane")?;
    let mut hull = Hull {
        points,
        faces: Vec::new(),
    };
    let [a, b, c, d] = first;
    for (corners, neighbors) in [
        ([a, b, c], [3, 1, 2]),
        ([d, c, b], [2, 0, 3]),
        ([d, a, c], [3, 0, 1]),
        ([d, b, a], [1, 0, 2]),
    ] {
        hull.faces.push(Face {
            corners,
            neighbors,
            outside: Vec::new(),
            is_removed: false,
        });
    }
    hull.distribute((0..points.len()).collect(), 0);
    let mut waiting: Vec<usize> = (0..hull.faces.len()).collect();
    while let Some(face) = waiting.pop() {
        if hull.faces[face].is_removed {
            continue;
        }
        let Some(point) = hull.farthest(face) else {
            continue;
        };
        let before = hull.faces.len();
        hull.add(point, face)?;
        waiting.extend(before..hull.faces.len());
    }
    let faces = hull.faces.iter().filter(|face| !face.is_removed);
    Ok(faces.map(|face| face.corners).collect())
}

/// Four points that are not in a plane, the last one below the triangle of the others.
fn simplex(points: &[Point]) -> Option<[usize; 4]> {
    let largest = |size: &dyn Fn(usize) -> f64| {
        let of = (0..points.len()).map(|point| (size(point), point));
        let most = of.max_by(|(a, at), (b, bt)| a.total_cmp(b).then(bt.cmp(at)));
        most.map(|(_, point)| point)
    };
    let square = |vector: Point| vector.iter().map(|entry| entry * entry).sum::<f64>();
    let a = largest(&|point| -points[point][0])?;
    let b = largest(&|point| square(difference(points[point], points[a])))?;
    let along = difference(points[b], points[a]);
    let c = largest(&|point| square(product(along, difference(points[point], points[a]))))?;
    let height = |point: usize| volume([points[a], points[b], points[c]], points[point]).0;
    let d = largest(&|point| height(point).abs())?;
    let has_height = |&d: &usize| side([points[a], points[b], points[c]], points[d]) != 0.0;
    let d = Some(d)
        .filter(has_height)
        .or_else(|| (0..points.len()).find(has_height))?;
    let is_above = side([points[a], points[b], points[c]], points[d]) > 0.0;
    Some(if is_above { [a, c, b, d] } else { [a, b, c, d] })
}

impl Hull<'_> {
    /// True if a point is strictly outside a face.
    fn sees(&self, point: usize, face: usize) -> bool {
        let corners = self.faces[face].corners.map(|corner| self.points[corner]);
        side(corners, self.points[point]) > 0.0
    }

    /// Adds points to the lists of the faces from `first` on; points inside the hull are dropped.
    fn distribute(&mut self, points: Vec<usize>, first: usize) {
        for point in points {
            let seen = (first..self.faces.len()).find(|&face| self.sees(point, face));
            if let Some(face) = seen {
                self.faces[face].outside.push(point);
            }
        }
    }

    /// The farthest point outside a face.
    fn farthest(&self, face: usize) -> Option<usize> {
        let face = &self.faces[face];
        let corners = face.corners.map(|corner| self.points[corner]);
        let height = |point: usize| volume(corners, self.points[point]).0;
        let outside = face.outside.iter().copied();
        outside.max_by(|&a, &b| height(a).total_cmp(&height(b)).then(b.cmp(&a)))
    }

    /// Extends the hull to a point outside a face.
    fn add(&mut self, point: usize, face: usize) -> Result<(), String> {
        const FAILED: &str = "its convex hull cannot be computed";
        self.faces[face].is_removed = true;
        let mut removed = vec![face];
        // The edges of the hole: from, to, and the face beyond.
        let mut edges = Vec::new();
        let mut at = 0;
        while let Some(&face) = removed.get(at) {
            at += 1;
            for k in 0..3 {
                let beyond = self.faces[face].neighbors[k];
                if self.faces[beyond].is_removed {
                    continue;
                }
                if self.sees(point, beyond) {
                    self.faces[beyond].is_removed = true;
                    removed.push(beyond);
                } else {
                    let corners = self.faces[face].corners;
                    edges.push((corners[k], corners[(k + 1) % 3], beyond));
                }
            }
        }
        let first = self.faces.len();
        // New faces by the corner at which their edge begins, and at which it ends.
        let mut starts = HashMap::new();
        let mut ends = HashMap::new();
        for (new, &(from, to, _)) in edges.iter().enumerate() {
            let is_new = starts.insert(from, first + new).is_none();
            if !is_new || ends.insert(to, first + new).is_some() {
                return Err(FAILED.to_owned());
            }
        }
        for (new, (from, to, beyond)) in edges.into_iter().enumerate() {
            let next = starts.get(&to).copied();
            let (Some(next), Some(&before)) = (next, ends.get(&from)) else {
                return Err(FAILED.to_owned());
            };
            let of_beyond = self.faces[beyond].corners;
            let shared = (0..3).find(|&k| of_beyond[k] == to && of_beyond[(k + 1) % 3] == from);
            let shared = shared.ok_or(FAILED)?;
            self.faces[beyond].neighbors[shared] = first + new;
            self.faces.push(Face {
                corners: [from, to, point],
                neighbors: [beyond, next, before],
                outside: Vec::new(),
                is_removed: false,
            });
        }
        for face in removed {
            let points = std::mem::take(&mut self.faces[face].outside);
            self.distribute(points, first);
        }
        Ok(())
    }
}

fn difference(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn product(a: Point, b: Point) -> Point {
    let entry = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

/// Six times the signed volume of the tetrahedron over a triangle, positive in front of it, and the sum of the absolute
/// values of its terms.
fn volume([a, b, c]: [Point; 3], point: Point) -> (f64, f64) {
    let (ab, ac, ap) = (difference(b, a), difference(c, a), difference(point, a));
    let normal = product(ab, ac);
    let sum = (0..3).map(|k| normal[k] * ap[k]).sum();
    let size = |i: usize, j: usize| (ab[i] * ac[j]).abs() + (ab[j] * ac[i]).abs();
    let sizes = [size(1, 2), size(2, 0), size(0, 1)];
    (sum, (0..3).map(|k| sizes[k] * ap[k].abs()).sum())
}

/// Positive for a point in front of a triangle, negative behind it, and 0 in its plane.
fn side(triangle: [Point; 3], point: Point) -> f64 {
    /// Rounding errors of the volume, relative to the sum of its terms: less than 8 units of rounding.
    const ROUNDING: f64 = 1e-15;
    /// The same in 106 bits; products of differences in single precision are exact there.
    const RESIDUE: f64 = 1e-29;
    let (found, size) = volume(triangle, point);
    if found.abs() > ROUNDING * size {
        return found;
    }
    let [a, b, c] = triangle.map(|corner| corner.map(exactly));
    let point = point.map(exactly);
    let normal = cross(minus(b, a), minus(c, a));
    let found = dot(normal, minus(point, a)).to_f64();
    if found.abs() > RESIDUE * size {
        found
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Volume within triangles.
    fn inside(points: &[Point], faces: &[[usize; 3]]) -> f64 {
        let parts = faces.iter().map(|face| {
            let [a, b, c] = face.map(|corner| points[corner]);
            volume([[0.0; 3], a, b], c).0 / 6.0
        });
        parts.sum()
    }

    /// Checks that no point is outside, that each edge has two faces, and returns the number of faces and the volume.
    fn checked(points: &[Point]) -> (usize, f64) {
        let faces = hull(points).unwrap();
        let mut edges = std::collections::HashSet::new();
        for face in &faces {
            let corners = face.map(|corner| points[corner]);
            assert!(points.iter().all(|point| side(corners, *point) <= 0.0));
            for k in 0..3 {
                assert!(edges.insert((face[k], face[(k + 1) % 3])), "{face:?}");
            }
        }
        assert!(edges.iter().all(|&(from, to)| edges.contains(&(to, from))));
        (faces.len(), inside(points, &faces))
    }

    #[test]
    fn a_grid_has_the_hull_of_its_corners() {
        // Most points are in the planes of faces, and many on their edges.
        let mut points = Vec::new();
        for k in 0_u8..125 {
            let entry = |digit: u8| f64::from(digit % 5) / 4.0 - 0.3;
            points.push([entry(k), entry(k / 5) * 2.0, entry(k / 25) * 3.0]);
        }
        let (_, volume) = checked(&points);
        assert!((volume - 6.0).abs() < 1e-14, "{volume}");
    }

    #[test]
    fn points_on_a_sphere_are_all_corners() {
        let points: Vec<Point> = (0..500)
            .map(|k| {
                let k = f64::from(k);
                let (height, angle) = ((2.0 * k + 1.0) / 500.0 - 1.0, 2.4 * k);
                let radius = (1.0 - height * height).sqrt();
                [radius * angle.cos(), radius * angle.sin(), height]
            })
            .collect();
        let (faces, volume) = checked(&points);
        assert_eq!(faces, 2 * 500 - 4);
        let ball = 4.0 / 3.0 * std::f64::consts::PI;
        assert!(volume < ball && volume > 0.97 * ball, "{volume}");
    }

    #[test]
    fn points_that_nearly_are_in_a_plane_are_told_apart() {
        let grain = f64::from(f32::EPSILON);
        let mut points = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        points.push([0.25, 0.25, -1.0]);
        points.push([0.25, 0.25, grain]);
        points.push([0.5, 0.25, grain]);
        points.push([0.5, 0.5, 0.0]);
        checked(&points);
        let faces = hull(&points).unwrap();
        for raised in [4, 5] {
            assert!(faces.iter().flatten().any(|corner| *corner == raised));
        }
    }

    #[test]
    fn points_in_a_plane_are_an_error() {
        for points in [
            vec![],
            vec![[1.0; 3]; 5],
            vec![[0.0; 3], [0.1; 3], [0.2; 3], [0.7; 3]],
            vec![
                [0.1, 0.3, 0.5],
                [0.7, 0.3, 0.5],
                [0.2, 0.3, 0.9],
                [0.4, 0.3, 0.8],
            ],
        ] {
            assert_eq!(hull(&points).unwrap_err(), "its vertices are in a plane");
        }
    }
}

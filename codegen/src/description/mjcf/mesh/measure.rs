//! Volume, centre of mass and inertia tensor of a mesh.
//!
//! Sums over the faces in `f64`, as in MuJoCo: a mesh describes a body to a few digits, so more precision has no use.
//! Volumes are those of pyramids over the faces, with the apex at the centre of the surface, and then at the centre of
//! mass.

use std::collections::HashSet;

use super::{InertiaMethod, Mesh};
use crate::description::mjcf::assets::MeshInertia;
use crate::description::spatial::exactly;

/// Areas \[m²\] and volumes \[m³\] below this are zero.
const NOTHING: f64 = 1e-15;

type Point = [f64; 3];

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Centroid of a triangle, and its area times its normal; a zero vector for a degenerate triangle.
fn triangle([a, b, c]: [Point; 3]) -> (Point, Point) {
    let middle = [0, 1, 2].map(|k| (a[k] + b[k] + c[k]) / 3.0);
    let ([bx, by, bz], [cx, cy, cz]) = (minus(b, a), minus(c, a));
    let cross = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
    if dot(cross, cross).sqrt() < NOTHING {
        return (middle, [0.0; 3]);
    }
    (middle, cross.map(|entry| entry / 2.0))
}

/// True if two faces run along an edge in the same direction; degenerate faces are ignored.
pub(super) fn twice_used(mesh: &Mesh) -> bool {
    let key = |corner: usize| mesh.corners[corner].map(|entry| (entry + 0.0).to_bits());
    let mut edges = HashSet::new();
    let faces = mesh.faces.iter().filter(|face| {
        let (_, area) = triangle(face.map(|corner| mesh.corners[corner]));
        dot(area, area).sqrt() > NOTHING.sqrt()
    });
    let mut all = faces.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    all.any(|edge| !edges.insert(edge.map(key)))
}

impl Mesh {
    /// Transforms vertices to the frame of the mesh, and scales them; `reversed` reverses the faces.
    pub(super) fn place(
        &mut self,
        origin: Point,
        [w, x, y, z]: [f64; 4],
        scale: Point,
        reversed: bool,
    ) {
        let length = (w * w + x * x + y * y + z * z).sqrt();
        let [w, x, y, z] = if length > 0.0 {
            [w, x, y, z].map(|entry| entry / length)
        } else {
            [1.0, 0.0, 0.0, 0.0]
        };
        // The axes of the frame: the columns of the quaternion's rotation matrix.
        let axes = [
            [
                w * w + x * x - y * y - z * z,
                2.0 * (x * y + w * z),
                2.0 * (x * z - w * y),
            ],
            [
                2.0 * (x * y - w * z),
                w * w - x * x + y * y - z * z,
                2.0 * (y * z + w * x),
            ],
            [
                2.0 * (x * z + w * y),
                2.0 * (y * z - w * x),
                w * w - x * x - y * y + z * z,
            ],
        ];
        for corner in &mut self.corners {
            let from_origin = minus(*corner, origin);
            let rotated = axes.map(|axis| dot(axis, from_origin));
            *corner = [0, 1, 2].map(|k| rotated[k] * scale[k]);
        }
        if reversed {
            for face in &mut self.faces {
                face.swap(1, 2);
            }
        }
    }

    /// The triangles relative to a point.
    fn triangles(&self, from: Point) -> impl Iterator<Item = [Point; 3]> {
        let seen = move |face: &[usize; 3]| face.map(|corner| minus(self.corners[corner], from));
        self.faces.iter().map(seen)
    }

    /// The inertia at density 1.
    pub(super) fn measured(&self, method: InertiaMethod) -> Result<MeshInertia, String> {
        let weight = |middle: Point, area: Point| match method {
            InertiaMethod::Shell => dot(area, area).sqrt(),
            InertiaMethod::Legacy => (dot(middle, area) / 3.0).abs(),
            InertiaMethod::Exact | InertiaMethod::Convex => dot(middle, area) / 3.0,
        };
        let (mut total, mut sum) = (0.0, [0.0; 3]);
        for corners in self.triangles([0.0; 3]) {
            let (middle, area) = triangle(corners);
            let area = dot(area, area).sqrt();
            total += area;
            sum = [0, 1, 2].map(|k| sum[k] + area * middle[k]);
        }
        if total < NOTHING {
            return Err("it has no area".to_owned());
        }
        let apex = sum.map(|entry| entry / total);
        let (mut total, mut sum) = (0.0, [0.0; 3]);
        for corners in self.triangles(apex) {
            let (middle, area) = triangle(corners);
            let weight = weight(middle, area);
            total += weight;
            // The centre of a pyramid is at a quarter of its height above the base.
            sum = [0, 1, 2].map(|k| sum[k] + weight * (0.75 * middle[k]));
        }
        if total < NOTHING {
            let reason = if total < 0.0 {
                "its volume is negative: its faces are oriented inwards"
            } else {
                "it has no volume; inertia=\"shell\" uses its area"
            };
            return Err(reason.to_owned());
        }
        let center = [0, 1, 2].map(|k| apex[k] + sum[k] / total);
        let (measure, tensor) = self.moments(center, method, weight);
        if measure < NOTHING {
            return Err("it has no volume about its centre".to_owned());
        }
        Ok(MeshInertia {
            measure: exactly(measure),
            center: center.map(exactly),
            tensor: tensor.map(|row| row.map(exactly)),
            corners: Vec::new(),
        })
    }

    /// The volume or area, and the tensor about a point.
    fn moments(
        &self,
        about: Point,
        method: InertiaMethod,
        weight: impl Fn(Point, Point) -> f64,
    ) -> (f64, [Point; 3]) {
        let parts = if method == InertiaMethod::Shell {
            12.0
        } else {
            20.0
        };
        let mut total = 0.0;
        // ∫ r rᵗ
        let mut second = [[0.0; 3]; 3];
        for [a, b, c] in self.triangles(about) {
            let (middle, area) = triangle([a, b, c]);
            let weight = weight(middle, area);
            total += weight;
            for i in 0..3 {
                for j in 0..3 {
                    let sums = [a[i] + b[i] + c[i], a[j] + b[j] + c[j]];
                    let own = a[i] * a[j] + b[i] * b[j] + c[i] * c[j];
                    second[i][j] += weight / parts * (own + sums[0] * sums[1]);
                }
            }
        }
        let trace = second[0][0] + second[1][1] + second[2][2];
        let entry = |i: usize, j: usize| {
            if i == j {
                trace - second[i][i]
            } else {
                -second[i][j]
            }
        };
        (total, [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box with sides of 0.4, 0.6 and 1, a corner of which is the origin.
    fn block() -> Mesh {
        let corners = (0..8).map(|k| {
            let bit = |bit: usize, size: f64| if k & bit == 0 { 0.0 } else { size };
            [bit(1, 0.4), bit(2, 0.6), bit(4, 1.0)]
        });
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        Mesh {
            corners: corners.collect(),
            faces: sides
                .into_iter()
                .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
                .collect(),
        }
    }

    fn near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() < 1e-14, "{found} and {wanted}");
    }

    #[test]
    fn a_box_is_a_box() {
        let [x, y, z] = [0.4_f64, 0.6, 1.0];
        for method in [InertiaMethod::Exact, InertiaMethod::Legacy] {
            let measured = block().measured(method).unwrap();
            let volume = x * y * z;
            near(measured.measure.to_f64(), volume);
            for (center, side) in measured.center.into_iter().zip([x, y, z]) {
                near(center.to_f64(), side / 2.0);
            }
            let moments = [y * y + z * z, x * x + z * z, x * x + y * y];
            for (i, row) in measured.tensor.into_iter().enumerate() {
                for (j, entry) in row.into_iter().enumerate() {
                    let wanted = if i == j {
                        volume * moments[i] / 12.0
                    } else {
                        0.0
                    };
                    near(entry.to_f64(), wanted);
                }
            }
        }
        let shell = block().measured(InertiaMethod::Shell).unwrap();
        near(shell.measure.to_f64(), 2.0 * (x * y + y * z + z * x));
    }

    #[test]
    fn a_mesh_is_moved_and_scaled() {
        let mut mesh = block();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        // A quarter rotation about z, and a mirror.
        mesh.place(
            [0.4, 0.0, 0.0],
            [half, 0.0, 0.0, half],
            [2.0, -1.0, 1.0],
            true,
        );
        let measured = mesh.measured(InertiaMethod::Exact).unwrap();
        near(measured.measure.to_f64(), 0.48);
        let center = measured.center.map(crate::expression::Double::to_f64);
        near(center[0], 0.6);
        near(center[1], -0.2);
        near(center[2], 0.5);
    }

    #[test]
    fn faces_must_look_outwards() {
        assert!(!twice_used(&block()));
        let mut rotated = block();
        rotated.faces[3].swap(0, 1);
        assert!(twice_used(&rotated));
        let mut inside = block();
        inside.faces.iter_mut().for_each(|face| face.swap(0, 1));
        let Err(reason) = inside.measured(InertiaMethod::Exact) else {
            panic!("it is inside out");
        };
        assert!(reason.contains("negative"), "{reason}");
        near(
            inside
                .measured(InertiaMethod::Legacy)
                .unwrap()
                .measure
                .to_f64(),
            0.24,
        );
    }
}

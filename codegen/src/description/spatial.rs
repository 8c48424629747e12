//! Poses and inertias in 106 bits.

use crate::description::{Axis, Number, Step, number};
use crate::error::Place;
use crate::expression::Double;

pub(crate) type DoubleVector = [Double; 3];
pub(crate) type DoubleMatrix = [[Double; 3]; 3];

/// Pose of a frame relative to another.
#[derive(Clone, Copy)]
pub(crate) struct Pose {
    /// Columns are the axes of the frame.
    pub(crate) rotation: DoubleMatrix,
    pub(crate) position: DoubleVector,
}

/// Mass, centre of mass, and inertia tensor about it.
#[derive(Clone, Copy)]
pub(crate) struct Solid {
    pub(crate) mass: Double,
    pub(crate) center: DoubleVector,
    pub(crate) tensor: DoubleMatrix,
}

/// The exact value of an `f64`.
pub(crate) fn exactly(value: f64) -> Double {
    Double::from(value)
}

/// A number of the description; rounding residues below 106 bits become exactly 0.
pub(crate) fn to_number(value: Double, place: Place) -> Number {
    let value = if value.is_zero() { Double::ZERO } else { value };
    number::computed(value, place)
}

pub(crate) fn dot(a: DoubleVector, b: DoubleVector) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: DoubleVector, b: DoubleVector) -> DoubleVector {
    let entry = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

pub(crate) fn minus(a: DoubleVector, b: DoubleVector) -> DoubleVector {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(crate) fn plus(a: DoubleVector, b: DoubleVector) -> DoubleVector {
    std::array::from_fn(|k| a[k] + b[k])
}

pub(crate) fn times(a: DoubleVector, factor: Double) -> DoubleVector {
    a.map(|entry| entry * factor)
}

fn applied(matrix: &DoubleMatrix, vector: DoubleVector) -> DoubleVector {
    matrix.map(|row| dot(row, vector))
}

fn transposed(matrix: &DoubleMatrix) -> DoubleMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}

fn product(a: &DoubleMatrix, b: &DoubleMatrix) -> DoubleMatrix {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

/// The matrix with these entries on its diagonal.
pub(crate) fn diagonal(entries: DoubleVector) -> DoubleMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { entries[i] } else { Double::ZERO }))
}

/// The rotation matrix of a quaternion x, y, z, w of any length but 0.
pub(crate) fn of_quaternion([x, y, z, w]: [Double; 4]) -> DoubleMatrix {
    let two = exactly(2.0) / (x * x + y * y + z * z + w * w);
    let one = exactly(1.0);
    [
        [
            one - two * (y * y + z * z),
            two * (x * y - z * w),
            two * (x * z + y * w),
        ],
        [
            two * (x * y + z * w),
            one - two * (x * x + z * z),
            two * (y * z - x * w),
        ],
        [
            two * (x * z - y * w),
            two * (y * z + x * w),
            one - two * (x * x + y * y),
        ],
    ]
}

/// A quaternion x, y, z, w of a rotation, of any length, computed from its largest entry.
pub(crate) fn quaternion(r: &DoubleMatrix) -> [Double; 4] {
    let one = exactly(1.0);
    let squares = [
        one + r[0][0] - r[1][1] - r[2][2],
        one - r[0][0] + r[1][1] - r[2][2],
        one - r[0][0] - r[1][1] + r[2][2],
        one + r[0][0] + r[1][1] + r[2][2],
    ];
    // Row k is the quaternion times 4 times its entry k.
    let [x, y, z] = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
    let [xy, yz, zx] = [r[1][0] + r[0][1], r[2][1] + r[1][2], r[0][2] + r[2][0]];
    let rows = [
        [squares[0], xy, zx, x],
        [xy, squares[1], yz, y],
        [zx, yz, squares[2], z],
        [x, y, z, squares[3]],
    ];
    let mut largest = 0;
    for k in 1..4 {
        if (squares[k] - squares[largest]).sign().to_f64() > 0.0 {
            largest = k;
        }
    }
    rows[largest]
}

impl Pose {
    pub(crate) fn identity() -> Self {
        Self {
            rotation: diagonal([exactly(1.0); 3]),
            position: [Double::ZERO; 3],
        }
    }

    /// The product of elementary motions.
    pub(crate) fn of(steps: &[Step]) -> Self {
        steps
            .iter()
            .fold(Self::identity(), |pose, step| match step {
                Step::Translate(offset) => Self {
                    position: pose.point(offset.map(|entry| entry.exact())),
                    ..pose
                },
                Step::Rotate(axis, angle) => pose.rotated(&about(*axis, angle.exact())),
                Step::Quaternion(entries) => {
                    pose.rotated(&of_quaternion(entries.map(|entry| entry.exact())))
                }
            })
    }

    fn rotated(self, rotation: &DoubleMatrix) -> Self {
        Self {
            rotation: product(&self.rotation, rotation),
            ..self
        }
    }

    /// Coordinates of a point of the frame, in the other frame.
    pub(crate) fn point(&self, point: DoubleVector) -> DoubleVector {
        plus(applied(&self.rotation, point), self.position)
    }

    /// Coordinates of a direction of the frame, in the other frame.
    pub(crate) fn direction(&self, direction: DoubleVector) -> DoubleVector {
        applied(&self.rotation, direction)
    }

    /// A tensor of the frame, in the axes of the other frame.
    pub(crate) fn tensor(&self, tensor: &DoubleMatrix) -> DoubleMatrix {
        product(
            &product(&self.rotation, tensor),
            &transposed(&self.rotation),
        )
    }
}

fn about(axis: Axis, angle: Double) -> DoubleMatrix {
    let (s, c) = angle.sin_cos();
    let (zero, one) = (Double::ZERO, exactly(1.0));
    match axis {
        Axis::X => [[one, zero, zero], [zero, c, -s], [zero, s, c]],
        Axis::Y => [[c, zero, s], [zero, one, zero], [-s, zero, c]],
        Axis::Z => [[c, -s, zero], [s, c, zero], [zero, zero, one]],
    }
}

/// The inverse placement: the steps in reverse order, each inverted.
pub(crate) fn inverse(steps: &[Step]) -> Vec<Step> {
    let negated = |number: Number| Number {
        value: -number.value,
        rest: -number.rest,
        ..number
    };
    let steps = steps.iter().rev();
    let backwards = steps.map(|step| match step {
        Step::Translate(offset) => Step::Translate(offset.map(negated)),
        Step::Rotate(axis, angle) => Step::Rotate(*axis, negated(*angle)),
        Step::Quaternion([x, y, z, w]) => {
            Step::Quaternion([negated(*x), negated(*y), negated(*z), *w])
        }
    });
    backwards.collect()
}

/// The inertia of several solids together.
pub(crate) fn together(solids: &[Solid]) -> Solid {
    let mut mass = Double::ZERO;
    let mut moment = [Double::ZERO; 3];
    for solid in solids {
        mass = mass + solid.mass;
        moment = plus(moment, times(solid.center, solid.mass));
    }
    let center = moment.map(|entry| entry / mass);
    let mut tensor = diagonal([Double::ZERO; 3]);
    for solid in solids {
        let arm = minus(solid.center, center);
        let square = dot(arm, arm);
        for i in 0..3 {
            for j in 0..3 {
                let across = if i == j { square } else { Double::ZERO } - arm[i] * arm[j];
                tensor[i][j] = tensor[i][j] + solid.tensor[i][j] + solid.mass * across;
            }
        }
    }
    Solid {
        mass,
        center,
        tensor,
    }
}

/// Principal moments and axes (columns) of a symmetric tensor, by Jacobi rotations.
pub(crate) fn principal(tensor: &DoubleMatrix) -> (DoubleVector, DoubleMatrix) {
    /// Each sweep squares the off-diagonal entries: ten suffice for 106 bits.
    const SWEEPS: usize = 20;
    /// 2⁻¹⁰³: rounding errors of off-diagonal entries, relative to the diagonal.
    const NOTHING: f64 = f64::from_bits((1023 - 103) << 52);
    let (mut d, mut axes) = (*tensor, Pose::identity().rotation);
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let size = |i: usize, j: usize| d[i][j].to_f64().abs();
            if size(p, q) <= NOTHING * (size(p, p) + size(q, q)) {
                continue;
            }
            // The smaller root t of t² + 2 h t − 1 = 0.
            let h = (d[q][q] - d[p][p]) / (exactly(2.0) * d[p][q]);
            let root = (h * h + exactly(1.0)).sqrt();
            let sign = if h.to_f64() < 0.0 { -1.0 } else { 1.0 };
            let t = exactly(sign) / (exactly(sign) * h + root);
            let c = exactly(1.0) / (t * t + exactly(1.0)).sqrt();
            let s = t * c;
            let mut rotation = Pose::identity().rotation;
            (
                rotation[p][p],
                rotation[q][q],
                rotation[p][q],
                rotation[q][p],
            ) = (c, c, s, -s);
            d = product(&product(&transposed(&rotation), &d), &rotation);
            axes = product(&axes, &rotation);
        }
    }
    ([0, 1, 2].map(|k| d[k][k]), axes)
}

/// The entries of a tensor as numbers of the description: xx, xy, xz, yy, yz, zz.
pub(crate) fn entries(tensor: &DoubleMatrix, place: Place) -> [Number; 6] {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = *tensor;
    [xx, xy, xz, yy, yz, zz].map(|entry| to_number(entry, place))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Any tensor, however close its moments are, is restored from its principal moments and axes.
    #[test]
    fn tensors_are_made_of_principal_moments() {
        for [a, b, c, d, e, f] in [
            [1.0, 0.0, 0.0, 2.0, 0.0, 3.0],
            [1.0, 0.5, 0.0, 1.0, 0.0, 3.0],
            [2.0, 0.3, -0.2, 2.0, 0.1, 2.0],
            [0.3, 1e-9, 0.0, 0.3, 1e-12, 0.3],
            [0.033_671_58, -1e-3, 2e-4, 0.027_663_24, 3e-5, 7.68e-4],
            [0.0; 6],
        ] {
            let tensor = [[a, b, c], [b, d, e], [c, e, f]].map(|row| row.map(exactly));
            let (moments, axes) = principal(&tensor);
            let frame = Pose {
                rotation: axes,
                position: [Double::ZERO; 3],
            };
            let again = frame.tensor(&diagonal(moments));
            for (again, entry) in again.iter().flatten().zip(tensor.iter().flatten()) {
                let off = (*again - *entry).to_f64().abs();
                assert!(off < 1e-29, "{off}");
            }
        }
    }

    #[test]
    fn a_rotation_is_that_of_its_quaternion() {
        for entries in [
            [0.1, -0.2, 0.3, 0.9],
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 3.0, 0.1, 0.0],
            [0.5, -0.5, 2.0, -0.5],
        ] {
            let rotation = of_quaternion(entries.map(exactly));
            let again = of_quaternion(quaternion(&rotation));
            for (again, entry) in again.iter().flatten().zip(rotation.iter().flatten()) {
                assert!((*again - *entry).to_f64().abs() < 1e-29);
            }
        }
    }
}

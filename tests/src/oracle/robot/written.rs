//! Numbers as they were written, in 256 bits.
//!
//! In: offsets, angles, axes and inertias. Out: their matrices, with exact right angles where the digits mean them.

use homogen_codegen::description::{Axis, Inertial, Number, Step};

use super::Reader;
use crate::big::Big;
use crate::oracle::matrix::Matrix;

impl Reader<'_> {
    pub(super) fn gravity(&self) -> Matrix {
        let down = [0.0, 0.0, -9.81].map(Big::new);
        let given = self.request.gravity.as_ref();
        let a = given.map_or(down, |entries| entries.each_ref().map(big));
        Matrix::screw(&[(); 3].map(|()| Big::zero()), &a)
    }

    pub(super) fn placement(&self, steps: &[Step]) -> Matrix {
        steps.iter().fold(Matrix::identity(), |placement, step| {
            &placement
                * &match step {
                    Step::Translate(t) => Matrix::translation(&t.each_ref().map(big)),
                    Step::Rotate(axis, angle) => rotation(*axis, self.sin_cos(angle)),
                    Step::Quaternion(entries) => by_quaternion(&self.quaternion(entries)),
                }
        })
    }

    /// Sine and cosine: exactly those of a right angle if the angle is one, rounded to the digits that are written.
    fn sin_cos(&self, angle: &Number) -> (Big, Big) {
        let quarters = (angle.value * core::f64::consts::FRAC_2_PI).round();
        let written = angle.resolution > 0.0;
        let right = Big::pi() * Big::new(quarters / 2.0);
        let away = (Big::new(angle.value) - right).abs().to_f64();
        // Half of the last digit, plus the rounding of reading and printing in binary.
        let open = angle.resolution / 2.0 * (1.0 + 1e-9) + angle.value.abs() * f64::EPSILON;
        let is_right = quarters != 0.0 && angle.resolution <= 0.01 && away <= open;
        if !is_right || (written && self.request.exact) {
            return big(angle).sin_cos();
        }
        let sine = |quarters: f64| match quarters.rem_euclid(4.0) {
            0.0 => Big::zero(),
            1.0 => Big::one(),
            2.0 => Big::zero(),
            _ => -Big::one(),
        };
        (sine(quarters), sine(quarters + 1.0))
    }

    /// A quaternion: exactly that of right angles if it is one, rounded to the digits that are written.
    fn quaternion(&self, entries: &[Number; 4]) -> [Big; 4] {
        let half = Big::new(0.5);
        let roots = [Big::zero(), half.clone(), half.sqrt(), Big::one()];
        let meant = entries.each_ref().map(|entry| {
            let size = big(entry).abs();
            // Half of the last digit, the rounding of reading, and that of a computation before.
            let rounded = (1.0 + 1e-9) * entry.resolution / 2.0 + size.to_f64() * f64::EPSILON;
            let enough = if entry.resolution > 0.01 {
                0.0
            } else {
                rounded
            };
            let computed = if entry.resolution > 0.0 {
                4.0 * f64::EPSILON
            } else {
                0.0
            };
            let is_near = |root: &&Big| {
                let away = (&size - *root).abs().to_f64();
                let is_zero = root.to_f64() == 0.0;
                away == 0.0 || away < computed || (!is_zero && away <= enough)
            };
            let root = roots.iter().find(is_near)?;
            Some(if entry.value < 0.0 {
                -root.clone()
            } else {
                root.clone()
            })
        });
        let all: Option<Vec<Big>> = meant.into_iter().collect();
        let is_rotation = |entries: &Vec<Big>| {
            let square = entries.iter().fold(Big::zero(), |sum, x| sum + x * x);
            let sizes: Vec<f64> = entries.iter().map(|x| x.abs().to_f64()).collect();
            let largest = sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
            (square - Big::one()).abs().to_f64() < 1e-60
                && sizes.iter().all(|size| *size == 0.0 || *size == largest)
        };
        let right = all.filter(|all| is_rotation(all) && !self.request.exact);
        right
            .and_then(|right| right.try_into().ok())
            .unwrap_or_else(|| {
                entries.each_ref().map(|entry| {
                    let is_large = entries.iter().any(|entry| entry.value.abs() >= 0.5);
                    let residue = entry.resolution > 0.0
                        && entry.value.abs() < 4.0 * f64::EPSILON
                        && is_large;
                    if residue && !self.request.exact {
                        Big::zero()
                    } else {
                        big(entry)
                    }
                })
            })
    }

    /// M J Mᵗ, where J = ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
    pub(super) fn inertia(&self, link: &str) -> Matrix {
        let mut links = self.description.links.iter();
        let link = links.find(|known| known.name.text == link);
        let Some(Inertial {
            origin,
            mass,
            inertia,
            ..
        }) = link.and_then(|link| link.inertial.as_ref())
        else {
            return Matrix::zero();
        };
        let [xx, xy, xz, yy, yz, zz] = inertia.each_ref().map(big);
        let half = (&xx + &yy + &zz) / Big::new(2.0);
        let nothing = Big::zero;
        let central = Matrix([
            [&half - xx, -&xy, -&xz, nothing()],
            [-xy, &half - yy, -&yz, nothing()],
            [-xz, -yz, half - zz, nothing()],
            [nothing(), nothing(), nothing(), big(mass)],
        ]);
        let placement = self.placement(origin);
        &(&placement * &central) * &placement.transposed()
    }
}

pub(super) fn big(number: &Number) -> Big {
    Big::new(number.value) + Big::new(number.rest)
}

/// The unit vector of a direction.
pub(super) fn axis(written: &[Number; 3]) -> [Big; 3] {
    let axis = written.each_ref().map(big);
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    axis.map(|entry| entry / square.sqrt())
}

/// R = 1 + (2 w v̲ + 2 v̲²) / (v² + w²) of a quaternion v, w.
fn by_quaternion(entries: &[Big; 4]) -> Matrix {
    let nothing = [(); 3].map(|()| Big::zero());
    let square = entries.iter().fold(Big::zero(), |sum, x| sum + x * x);
    let [x, y, z, w] = entries.clone();
    let v = Matrix::screw(&[x, y, z], &nothing);
    let twice = Big::new(2.0) / &square;
    &(&Matrix::identity() + &v.times(&(&twice * &w))) + &(&v * &v).times(&twice)
}

/// R, 0; 0, 1 of a rotation about a coordinate axis.
fn rotation(axis: Axis, (sine, cosine): (Big, Big)) -> Matrix {
    let (j, k) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    let mut matrix = Matrix::identity();
    matrix.0[j][k] = -&sine;
    matrix.0[k][j] = sine;
    matrix.0[j][j] = cosine.clone();
    matrix.0[k][k] = cosine;
    matrix
}

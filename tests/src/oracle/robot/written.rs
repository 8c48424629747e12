//! Numbers as they were written, in 256 bits.
//!
//! In: offsets, angles, axes and inertias. Out: matrices of them, with the sines of a right angle where one is meant.

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
                }
        })
    }

    /// Sine and cosine: exactly those of a right angle where one rounds to the digits that stand there.
    fn sin_cos(&self, angle: &Number) -> (Big, Big) {
        let quarters = (angle.value * core::f64::consts::FRAC_2_PI).round();
        let written = angle.resolution > 0.0;
        let right = Big::pi() * Big::new(quarters / 2.0);
        let away = (Big::new(angle.value) - right).abs().to_f64();
        // Half of the last digit, and what reading and printing in binary round.
        let open = angle.resolution / 2.0 * (1.0 + 1e-9) + angle.value.abs() * f64::EPSILON;
        let is_right = quarters != 0.0 && angle.resolution <= 0.01 && away <= open;
        if !is_right || (written && self.request.exact) {
            return big(angle).sin_cos();
        }
        let turn = |quarters: f64| match quarters.rem_euclid(4.0) {
            0.0 => Big::zero(),
            1.0 => Big::one(),
            2.0 => Big::zero(),
            _ => -Big::one(),
        };
        (turn(quarters), turn(quarters + 1.0))
    }

    /// M J Mᵗ of ∫rrᵗdm = ½ Tr(I) − I about the centre of mass (16), (17).
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

/// A direction with length 1.
pub(super) fn axis(written: &[Number; 3]) -> [Big; 3] {
    let axis = written.each_ref().map(big);
    let square = axis.iter().fold(Big::zero(), |sum, x| sum + x * x);
    axis.map(|entry| entry / square.sqrt())
}

/// R, 0; 0, 1 of a turn about a coordinate axis.
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

//! Conditioning of the mass matrix.
//!
//! In: a robot in matrices and a state. Out: the smallest pivot of its mass matrix, relative to the diagonal entry.

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;

use super::dense::Dense;

/// Lever arm, relative to the robot's size, below which a joint counts as carrying no mass.
const NO_ARM: f64 = 1e-6;

/// Inertia below which a joint counts as carrying none, in any units [kg m²].
const NEGLIGIBLE: f64 = 1e-40;

/// The smallest pivot of the mass matrix, relative to its diagonal entry: 1 for a diagonal matrix, 0 for a singular
/// one, or if a joint carries no mass.
#[must_use]
pub fn pivot(dense: &Dense, arguments: &Arguments) -> f64 {
    let count = arguments[Variable::Qd].len();
    let matrix = frame_0::evaluate(&dense.robot, Function::MassMatrix, 0, arguments);
    let mut rows: Vec<Vec<Big>> = matrix.chunks(count).map(<[Big]>::to_vec).collect();
    let arm = NO_ARM * dense.reach;
    let negligible = Big::new(dense.mass * arm * arm + NEGLIGIBLE);
    let mut least: f64 = 1.0;
    for k in 0..count {
        let entry = &matrix[k * count + k];
        if *entry <= negligible || rows[k][k] <= Big::zero() {
            return 0.0;
        }
        least = least.min((&rows[k][k] / entry).to_f64());
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = &row[k] / &above[k][k];
            for (entry, of_pivot) in row.iter_mut().zip(&above[k]) {
                *entry = &*entry - &factor * of_pivot;
            }
        }
    }
    least
}

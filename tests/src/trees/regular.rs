//! Whether accelerations can be asked of a robot at all.
//!
//! In: a robot in matrices and a state. Out: how much elimination leaves of its mass matrix. It
//! decides nothing.

use homogen_codegen::Function;
use homogen_codegen::space::Variable;

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;

use super::dense::Dense;

/// A joint that all mass is nearer to than this part of the reach counts as carrying none.
const NO_ARM: f64 = 1e-6;

/// What no inertia is smaller than [kg m²], in whatever units a file is written.
const NOTHING: f64 = 1e-40;

/// The least that elimination leaves of a diagonal entry of the mass matrix, beside that entry: 1 of a
/// diagonal matrix, 0 of a singular one, or where a joint carries nothing.
#[must_use]
pub fn pivot(dense: &Dense, arguments: &Arguments) -> f64 {
    let count = arguments[Variable::Qd].len();
    let matrix = frame_0::evaluate(&dense.robot, Function::MassMatrix, 0, arguments);
    let mut rows: Vec<Vec<Big>> = matrix.chunks(count).map(<[Big]>::to_vec).collect();
    let arm = NO_ARM * dense.reach;
    let nothing = Big::new(dense.mass * arm * arm + NOTHING);
    let mut least: f64 = 1.0;
    for k in 0..count {
        let entry = &matrix[k * count + k];
        if *entry <= nothing || rows[k][k] <= Big::zero() {
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

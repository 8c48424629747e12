//! What a function costs when it is computed as the paper writes it: dense 4×4 matrices in frame 0,
//! every product multiplied out, nothing known to be zero.
//!
//! In: a function and how many joints it is about. Out: multiplications and additions. It is the
//! yardstick printed beside a price, and takes the sines and cosines and all constant matrices as
//! given.

use crate::function::Function;

/// Operations of dense matrices.
#[derive(Clone, Copy, Default)]
struct Tally {
    mul: usize,
    add: usize,
}

impl Tally {
    /// Products, products with a number, and sums of 4×4 matrices.
    const fn of(products: usize, scalings: usize, sums: usize) -> Self {
        Self {
            mul: 64 * products + 16 * scalings,
            add: 48 * products + 16 * sums,
        }
    }

    const fn and(self, mul: usize, add: usize) -> Self {
        Self {
            mul: self.mul + mul,
            add: self.add + add,
        }
    }

    const fn plus(self, other: Self) -> Self {
        self.and(other.mul, other.add)
    }

    const fn times(self, count: usize) -> Self {
        Self {
            mul: self.mul * count,
            add: self.add * count,
        }
    }
}

/// M₀ᵢ = M₀,ᵢ₋₁ · placement · (1 + L sin q + L² (1 − cos q)).
const POSE: Tally = Tally::of(2, 2, 2);
/// L₍₀₎ = M L M⁻¹.
const SCREW: Tally = Tally::of(2, 0, 0);
/// W₀ᵢ = W₀,ᵢ₋₁ + L q̇.
const VELOCITY: Tally = Tally::of(0, 1, 1);
/// H₀ᵢ = H₀,ᵢ₋₁ + L q̈ + L² q̇² + 2 W₀,ᵢ₋₁ L q̇.
const ACCELERATION: Tally = Tally::of(2, 3, 3);
/// J₍₀₎ = M J Mᵗ.
const INERTIA: Tally = Tally::of(2, 0, 0);
/// Φ = skew\[(H − H_g) J\] added to what is outboard, and L ⊗ Φ.
const ACTION: Tally = Tally::of(1, 0, 3).and(6, 5);

/// Multiplications and additions of a function of `joints` joints, of which `path` lead to the
/// frame that it is of. Divisions count as multiplications.
#[must_use]
pub fn dense(function: Function, joints: usize, path: usize) -> (usize, usize) {
    let tally = tally(function, joints, path);
    (tally.mul, tally.add)
}

fn tally(function: Function, joints: usize, path: usize) -> Tally {
    let kinematic = POSE.plus(SCREW);
    match function {
        Function::ForwardKinematics => POSE.times(path).plus(Tally::of(1, 0, 0)),
        Function::SpatialJacobian => kinematic.times(path),
        // And back to the frame, or the pole to its origin.
        Function::BodyJacobian | Function::GeometricJacobian => {
            kinematic.plus(SCREW).times(path).plus(Tally::of(1, 0, 0))
        }
        Function::Velocity => kinematic.plus(VELOCITY).times(path),
        Function::Acceleration => kinematic.plus(VELOCITY).plus(ACCELERATION).times(path),
        Function::InverseDynamics | Function::Bias => {
            let moving = kinematic.plus(VELOCITY).plus(ACCELERATION);
            moving.plus(INERTIA).plus(ACTION).times(joints)
        }
        Function::Gravity => kinematic.plus(INERTIA).plus(ACTION).times(joints),
        Function::MassMatrix => {
            // A composite J and L J a column, and Tr(Lᵢ J Lₘᵗ) an entry.
            let column = kinematic.plus(INERTIA).plus(Tally::of(1, 0, 1));
            column.times(joints).plus(
                Tally::default()
                    .and(16, 15)
                    .times(joints * (joints + 1) / 2),
            )
        }
        Function::ForwardDynamics => {
            // M, the bias, a dense factorisation and one solve.
            let (cubes, squares) = (joints.pow(3) / 6, joints.pow(2));
            tally(Function::MassMatrix, joints, path)
                .plus(tally(Function::Bias, joints, path))
                .and(cubes + squares, cubes + squares)
        }
        Function::MassMatrixInverse => {
            let cubes = joints.pow(3);
            tally(Function::MassMatrix, joints, path).and(cubes, cubes)
        }
    }
}

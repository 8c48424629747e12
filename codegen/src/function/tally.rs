//! Cost of a function by dense 4×4 matrices in frame 0, with every product multiplied out and no known zeros.
//!
//! In: numbers of products, and of joints. Out: multiplications and additions, which comments print beside the operation
//! count for comparison. Sines, cosines and constant matrices are not counted.

/// Operations of dense matrices.
#[derive(Clone, Copy, Default)]
pub(super) struct Tally {
    pub(super) mul: usize,
    pub(super) add: usize,
}

impl Tally {
    /// Cost of products, of products with a number, and of sums of 4×4 matrices.
    pub(super) const fn of(products: usize, scalings: usize, sums: usize) -> Self {
        Self {
            mul: 64 * products + 16 * scalings,
            add: 48 * products + 16 * sums,
        }
    }

    pub(super) const fn and(self, mul: usize, add: usize) -> Self {
        Self {
            mul: self.mul + mul,
            add: self.add + add,
        }
    }

    pub(super) const fn plus(self, other: Self) -> Self {
        self.and(other.mul, other.add)
    }

    pub(super) const fn times(self, count: usize) -> Self {
        Self {
            mul: self.mul * count,
            add: self.add * count,
        }
    }
}

/// L̇ = W L − L W.
pub(super) const SCREW_RATE: Tally = Tally::of(2, 0, 1);
/// M₀ᵢ = M₀,ᵢ₋₁ · placement · (1 + L sin q + L² (1 − cos q)).
pub(super) const POSE: Tally = Tally::of(2, 2, 2);
/// L₍₀₎ = M L M⁻¹.
pub(super) const SCREW: Tally = Tally::of(2, 0, 0);
/// W₀ᵢ = W₀,ᵢ₋₁ + L q̇.
pub(super) const VELOCITY: Tally = Tally::of(0, 1, 1);
/// H₀ᵢ = H₀,ᵢ₋₁ + L q̈ + L² q̇² + 2 W₀,ᵢ₋₁ L q̇.
pub(super) const ACCELERATION: Tally = Tally::of(2, 3, 3);
/// J₍₀₎ = M J Mᵗ.
pub(super) const INERTIA: Tally = Tally::of(2, 0, 0);
/// Φ = skew\[(H − H_g) J\], its addition to the wrench of outboard links, and L ⊗ Φ.
pub(super) const ACTION: Tally = Tally::of(1, 0, 3).and(6, 5);
/// A pose and its screw.
pub(super) const KINEMATIC: Tally = POSE.plus(SCREW);
/// Pose, screw, velocity and acceleration.
pub(super) const MOVING: Tally = KINEMATIC.plus(VELOCITY).plus(ACCELERATION);

/// Number of joints of the robot, of those that lead to the frame of the function, of requested frames, of collision
/// spheres, and of their pairs.
#[derive(Clone, Copy)]
pub(super) struct Size {
    pub(super) joints: usize,
    pub(super) path: usize,
    pub(super) frames: usize,
    pub(super) spheres: usize,
    pub(super) pairs: usize,
}

/// Screws of frame 0, changed to another frame or reference point.
pub(super) fn screws_elsewhere(size: Size) -> Tally {
    let column = KINEMATIC.plus(SCREW);
    column.times(size.path).plus(Tally::of(1, 0, 0))
}

/// Time derivatives of screws of frame 0, changed to a moving frame or reference point.
pub(super) fn screw_rates_elsewhere(size: Size) -> Tally {
    let against = Tally::of(0, 0, 1);
    let column = (KINEMATIC.plus(VELOCITY))
        .plus(SCREW_RATE.plus(against))
        .plus(SCREW);
    column.times(size.path).plus(Tally::of(1, 0, 0))
}

/// Torques and forces of a motion.
pub(super) fn torques(size: Size) -> Tally {
    MOVING.plus(INERTIA).plus(ACTION).times(size.joints)
}

//! The functions that can be generated.
//!
//! A shared noun: which there are, what their arguments and results can be. What is known of one
//! function stands in its own file, and `table` tells it to every stage and every door.

mod acceleration;
mod bias;
mod body_jacobian;
mod dense;
mod forward_dynamics;
mod forward_kinematics;
mod geometric_jacobian;
mod gravity;
mod inverse_dynamics;
mod mass_matrix;
mod mass_matrix_inverse;
mod spatial_jacobian;
mod table;
mod units;
mod velocity;

/// A function of the state of a robot with N joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// M₀,tip.
    ForwardKinematics,
    /// Columns L₁…L_N in frame 0, pole at its origin.
    SpatialJacobian,
    /// Columns L₁…L_N in the frame of the tip, pole at its origin.
    BodyJacobian,
    /// Columns in the axes of frame 0, pole at the origin of the tip.
    GeometricJacobian,
    /// W₀,tip₍₀₎.
    Velocity,
    /// H₀,tip₍₀₎, without gravity.
    Acceleration,
    /// Joint forces and torques that produce q̈.
    InverseDynamics,
    /// Inverse dynamics at rest.
    Gravity,
    /// Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.
    Bias,
    /// The joint-space inertia matrix.
    MassMatrix,
    /// Joint accelerations that forces and torques produce.
    ForwardDynamics,
    /// The inverse of the joint-space inertia matrix.
    MassMatrixInverse,
}

/// An argument of a generated function: an array of N numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    /// Joint coordinates [rad or m].
    Q,
    /// Their rates [rad/s or m/s].
    Qd,
    /// Their second rates [rad/s² or m/s²].
    Qdd,
    /// Joint torques and forces \[N m or N\].
    Tau,
}

/// The shape of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A pose: 12 entries, row by row of the upper 3×4 block (r_xx, r_xy, r_xz, t_x, …).
    Pose,
    /// A velocity matrix: ω_x, ω_y, ω_z, v_x, v_y, v_z.
    Velocity,
    /// An acceleration matrix: 12 entries, row by row of the upper 3×4 block (G, a).
    Acceleration,
    /// N screws, each u_x, u_y, u_z, b_x, b_y, b_z.
    Screws,
    /// N numbers.
    Vector,
    /// N rows of N numbers, row by row.
    Matrix,
}

impl Function {
    /// All of them, in the order of the documentation.
    pub const ALL: [Self; 12] = [
        Self::ForwardKinematics,
        Self::SpatialJacobian,
        Self::BodyJacobian,
        Self::GeometricJacobian,
        Self::Velocity,
        Self::Acceleration,
        Self::InverseDynamics,
        Self::Gravity,
        Self::Bias,
        Self::MassMatrix,
        Self::ForwardDynamics,
        Self::MassMatrixInverse,
    ];
}

impl Argument {
    /// Its name in generated code and in state files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "qd",
            Self::Qdd => "qdd",
            Self::Tau => "tau",
        }
    }
}

impl Shape {
    /// How many numbers it holds for a robot with `joints` joints.
    #[must_use]
    pub const fn len(self, joints: usize) -> usize {
        match self {
            Self::Pose | Self::Acceleration => 12,
            Self::Velocity => 6,
            Self::Screws => 6 * joints,
            Self::Vector => joints,
            Self::Matrix => joints * joints,
        }
    }
}

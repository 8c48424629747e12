//! Controllers for any robot with the functions that they need.
//!
//! In: the controller's model of a robot, a state, and a desired motion. Out: torques. Controllers have no state and
//! do not allocate.

use std::array::from_fn;

use homogen::robot::{
    Bias, ForwardKinematics, GeometricJacobian, GeometricJacobianRate, InverseDynamics,
    MassMatrixInverse,
};
use homogen::{Pose, Screw, vector};
use nalgebra::{Cholesky, SMatrix, SVector};

use crate::motion::Desired;

/// Gains of an error [1/s²] and of its rate [1/s].
#[derive(Clone, Copy, Debug)]
pub struct Gains {
    /// k_p.
    pub stiffness: f64,
    /// k_d.
    pub damping: f64,
}

impl Gains {
    /// Gains with critical damping, for a natural frequency [rad/s].
    #[must_use]
    pub const fn critical(frequency: f64) -> Self {
        Self {
            stiffness: frequency * frequency,
            damping: 2.0 * frequency,
        }
    }
}

/// Computed torque: τ that gives the robot the acceleration q̈_d + k_d ė + k_p e.
pub fn computed_torque<R, const N: usize>(
    robot: &R,
    q: &[f64; N],
    qd: &[f64; N],
    [q_d, qd_d, qdd_d]: &Desired<N>,
    gains: Gains,
) -> [f64; N]
where
    R: InverseDynamics<N>,
{
    let Gains { stiffness, damping } = gains;
    let wanted = from_fn(|i| qdd_d[i] + damping * (qd_d[i] - qd[i]) + stiffness * (q_d[i] - q[i]));
    robot.inverse_dynamics(q, qd, &wanted)
}

/// The desired motion of the end effector, in the axes of frame 0; angular parts first.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// M₀,tip.
    pub pose: Pose<f64>,
    /// ω and the velocity of the tip's origin [rad/s, m/s].
    pub velocity: [f64; 6],
    /// Their rates [rad/s², m/s²].
    pub acceleration: [f64; 6],
}

/// Added to the diagonal of Λ⁻¹, so that Λ is finite where the arm is singular [1/kg, 1/(kg m²)].
const LEAST_MOBILITY: f64 = 1e-6;

/// Operational-space control (Khatib, "A unified approach for motion and force control of robot manipulators", 1987):
/// the end effector follows its task, and the redundant joints move to the configuration `rest_configuration` without
/// accelerating the end effector.
///
/// # Panics
/// If the state or a number of the robot is NaN.
pub fn operational_space<R, const N: usize>(
    robot: &R,
    q: &[f64; N],
    qd: &[f64; N],
    task: &Task,
    rest_configuration: &[f64; N],
    gains: Gains,
) -> [f64; N]
where
    R: ForwardKinematics<N>
        + GeometricJacobian<N>
        + GeometricJacobianRate<N>
        + MassMatrixInverse<N>
        + Bias<N>,
{
    let Gains { stiffness, damping } = gains;
    let jacobian = columns(&robot.geometric_jacobian(q));
    let rate = columns(&robot.geometric_jacobian_rate(q, qd));
    let inverse = robot.mass_matrix_inverse(q);
    let inverse = SMatrix::<f64, N, N>::from_fn(|i, j| inverse[i][j]);
    let [q_now, qd_now, q_rest] =
        [q, qd, rest_configuration].map(|entries| SVector::<f64, N>::from(*entries));

    let error = SVector::<f64, 6>::from(apart(&robot.forward_kinematics(q), &task.pose));
    let [velocity, acceleration] = [task.velocity, task.acceleration].map(SVector::<f64, 6>::from);
    let wanted = acceleration + damping * (velocity - jacobian * qd_now) + stiffness * error;

    // Λ⁻¹ = J M⁻¹ Jᵗ.
    let mobility = jacobian * inverse * jacobian.transpose();
    let floor = SMatrix::<f64, 6, 6>::identity() * LEAST_MOBILITY;
    let inertia = Cholesky::new(mobility + floor).expect("a mobility is not negative");
    let pull = |toward: SVector<f64, 6>| jacobian.transpose() * inertia.solve(&toward);
    // Torques towards the configuration, without the part that accelerates the end effector.
    let free = stiffness * (q_rest - q_now) - damping * qd_now;
    let torque = pull(wanted - rate * qd_now) + free - pull(jacobian * (inverse * free));
    let bias = robot.bias(q, qd);
    from_fn(|i| torque[i] + bias[i])
}

/// Screws as the columns of a matrix, angular parts first.
fn columns<const N: usize>(screws: &[Screw<f64>; N]) -> SMatrix<f64, 6, N> {
    SMatrix::from_fn(|i, j| {
        let (u, b) = (screws[j].u(), screws[j].b());
        if i < 3 { u[i] } else { b[i - 3] }
    })
}

/// The displacement between two frames: a rotation vector (up to third-order terms) and a translation \[m\].
#[must_use]
pub fn apart(from: &Pose<f64>, to: &Pose<f64>) -> [f64; 6] {
    let axis = |pose: &Pose<f64>, k: usize| pose.rotation().map(|row| row[k]);
    let products = [0, 1, 2].map(|k| vector::cross(axis(from, k), axis(to, k)));
    let rotation = from_fn::<f64, 3, _>(|i| 0.5 * products.iter().map(|v| v[i]).sum::<f64>());
    let (here, there) = (from.translation(), to.translation());
    from_fn(|i| {
        if i < 3 {
            rotation[i]
        } else {
            there[i - 3] - here[i - 3]
        }
    })
}

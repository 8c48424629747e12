//! The states of the tests, on the board and on the host.
//!
//! In: a table of seven columns; an arm with fewer joints uses the first ones. Out: [`states`]. The first [`TRUSTED`]
//! are realistic; the others are extreme or invalid, and have the results of IEEE arithmetic in the same time.

/// Number of joints of the arm.
pub const JOINTS: usize = match usize::from_str_radix(env!("JOINTS"), 10) {
    Ok(joints) => joints,
    Err(_) => panic!("`build.rs` sets JOINTS to the number of joints"),
};

/// A number for each joint.
pub type Joints = [f32; JOINTS];

/// Number of states.
pub const STATES: usize = 11;

/// Number of leading states within the limits of an arm.
pub const EVERYDAY: usize = 4;

/// Number of leading states whose errors are measured.
pub const TRUSTED: usize = 7;

/// A state of the arm, and its target.
#[derive(Clone, Copy, Debug)]
pub struct State {
    /// Coordinates \[rad\].
    pub q: Joints,
    /// Rates [rad/s].
    pub qd: Joints,
    /// Accelerations [rad/s²].
    pub qdd: Joints,
    /// Torques \[N m\].
    pub tau: Joints,
    /// Target coordinates \[rad\] and rates [rad/s].
    pub target: [Joints; 2],
}

/// All states.
#[must_use]
pub fn states() -> [State; STATES] {
    TABLE.map(|[q, qd, qdd, tau, place, rate]| State {
        q: first(&q),
        qd: first(&qd),
        qdd: first(&qdd),
        tau: first(&tau),
        target: [first(&place), first(&rate)],
    })
}

/// The first numbers of a row, one for each joint.
fn first(row: &[f32; 7]) -> Joints {
    let mut joints = [0.0; JOINTS];
    for (joint, value) in joints.iter_mut().zip(row) {
        *joint = *value;
    }
    joints
}

/// q, q̇, q̈, τ; the target's q, q̇.
#[rustfmt::skip]
static TABLE: [[[f32; 7]; 6]; STATES] = [
    // somewhere, moving
    [
        [0.615, 1.209, 1.476, 2.212, 1.199, 2.112, -2.355],
        [-0.138, 1.773, 0.596, 1.604, -1.547, -0.124, -1.014],
        [0.438, 0.739, -4.869, -2.833, -2.205, 4.163, 2.657],
        [-20.424, 17.829, -21.674, 7.047, -22.398, -29.894, 22.284],
        [-1.453, -1.423, 2.412, 1.862, -1.053, 2.307, 0.196],
        [0.356, -0.590, 0.882, 0.381, 0.933, 0.787, -0.402],
    ],
    // somewhere, moving
    [
        [-0.694, -1.670, -1.771, -2.174, -0.993, 0.516, -2.483],
        [0.712, -0.648, -0.760, 1.274, -0.077, -0.737, -0.075],
        [2.047, -4.430, 4.751, -4.771, 2.498, 3.449, -4.819],
        [17.264, -8.029, 4.711, -29.455, -27.196, -19.145, 27.311],
        [-1.517, 1.279, 2.148, 2.210, -0.778, -0.726, 0.124],
        [0.551, -0.784, 0.497, 0.594, 0.719, -0.927, 0.892],
    ],
    // somewhere, moving
    [
        [-2.044, -0.796, 0.554, 2.090, -0.800, 2.121, 0.226],
        [-0.750, -0.733, -1.290, -1.687, -1.405, 0.757, 1.987],
        [-3.385, -4.514, 4.867, 0.335, -0.941, -2.627, 0.940],
        [19.578, -2.660, -4.695, -26.658, 24.964, -28.037, -0.386],
        [1.692, -1.847, 1.158, 2.249, 0.652, 1.440, -1.967],
        [-0.131, -0.702, 0.689, -0.410, -0.094, 0.999, 0.705],
    ],
    // somewhere, moving
    [
        [2.380, -0.232, -0.059, 1.148, -0.105, -1.045, -0.481],
        [-1.414, -0.492, 1.954, 1.839, 0.508, -0.003, -0.646],
        [-4.109, -2.277, 2.820, 3.674, -1.387, 2.860, 2.749],
        [11.676, 9.841, 15.578, -8.194, 12.268, -13.149, -0.859],
        [1.349, 0.954, -1.031, 2.228, 0.748, 0.403, -2.442],
        [0.094, -0.499, 0.343, -0.074, 0.633, 0.295, 0.595],
    ],
    // at rest at zero
    [
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ],
    // at speed
    [
        [-5.127, 4.378, 6.196, -3.969, -4.729, 5.278, 2.468],
        [37.667, 95.224, 91.303, 3.628, 5.868, -66.765, 67.324],
        [874.763, -45.522, 382.851, 439.373, 460.707, -656.346, 560.743],
        [161.691, 331.112, -158.416, 247.474, 549.409, 273.733, 440.829],
        [-2.362, -1.700, -0.295, 0.751, -1.405, 0.930, 0.654],
        [-0.916, -0.057, -0.548, -0.892, -0.733, -0.365, -0.637],
    ],
    // many turns
    [
        [-912.693, 864.378, 1426.964, 1969.132, -899.729, 2057.278, 2219.468],
        [37.667, 95.224, 91.303, 3.628, 5.868, -66.765, 67.324],
        [874.763, -45.522, 382.851, 439.373, 460.707, -656.346, 560.743],
        [161.691, 331.112, -158.416, 247.474, 549.409, 273.733, 440.829],
        [-2.362, -1.700, -0.295, 0.751, -1.405, 0.930, 0.654],
        [-0.916, -0.057, -0.548, -0.892, -0.733, -0.365, -0.637],
    ],
    // subnormal
    [
        [1e-40, 1e-40, 1e-40, 1e-40, 1e-40, 1e-40, 1e-40],
        [-1e-42, -1e-42, -1e-42, -1e-42, -1e-42, -1e-42, -1e-42],
        [1e-45, 1e-45, 1e-45, 1e-45, 1e-45, 1e-45, 1e-45],
        [1e-40, 1e-40, 1e-40, 1e-40, 1e-40, 1e-40, 1e-40],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ],
    // huge
    [
        [1e30, 1e30, 1e30, 1e30, 1e30, 1e30, 1e30],
        [-1e30, -1e30, -1e30, -1e30, -1e30, -1e30, -1e30],
        [1e30, 1e30, 1e30, 1e30, 1e30, 1e30, 1e30],
        [1e38, 1e38, 1e38, 1e38, 1e38, 1e38, 1e38],
        [-1e30, -1e30, -1e30, -1e30, -1e30, -1e30, -1e30],
        [1e30, 1e30, 1e30, 1e30, 1e30, 1e30, 1e30],
    ],
    // infinite
    [
        [f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY],
        [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
        [f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY],
        [f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY, f32::INFINITY],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    ],
    // not a number
    [
        [-1.227, -1.857, -0.139, -0.479, 0.447, 0.361, -1.049],
        [1.613, -1.997, -0.378, -0.886, -0.360, -1.540, 1.325],
        [f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN],
        [f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN, f32::NAN],
        [-0.252, -0.928, 0.227, -0.810, 0.090, -0.321, 0.162],
        [0.917, 0.637, -0.162, 0.626, 0.285, -0.261, -0.716],
    ],
];

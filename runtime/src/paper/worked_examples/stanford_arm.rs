//! The Stanford arm: R R P R R R (Part II, worked examples).
//!
//! In: q₁, q₂, q₄, q₅, q₆ in rad, q₃ in m, and their rates. Out: the arm as a [`Chain`], and closed
//! forms of M, of all L₍₀₎, and of W and H̃ of its third body. The dynamics have no short closed form.
//!
//! Two misprints of the preprint are corrected. The first entry of L₂,₃₍₀₎ is C₁S₂, printed as C₁S₁: the
//! third joint translates along z₂ = (C₁S₂, S₁S₂, C₂). In the listing of the inverse dynamics the inertia
//! of body i is transformed to frame 0 by M₀,ᵢ, printed as M₀,ᵢ₋₁: see [`crate::open_chain::inertias`].

use crate::matrix::vector::{add, cross, scale};
use crate::matrix::{Acceleration, Inertia, Pose, Screw, Velocity};
use crate::robot::chain::{Chain, Frame};
use crate::robot::joint::Joint;
use crate::scalar::Scalar;

/// The height of the shoulder above the base \[m\].
pub const SHOULDER: f64 = 0.412;

/// The distance from the first axis to the boom, along the second axis \[m\].
pub const OFFSET: f64 = 0.154;

/// The distance from the wrist to the tool, along the last axis \[m\].
pub const TOOL: f64 = 0.263;

/// The arm, its frames on the joints' own axes, parallel to the base at q = 0 but for the second and
/// the fifth one; gravity along −z.
///
/// Geometry: R. P. Paul, Stanford AIM-177, 1972. Masses, centres and moments: R. P. Paul, *Robot
/// Manipulators*, 1981, tables 6.4 to 6.6, which go back to A. K. Bejczy, JPL TM 33-669, 1974; moved
/// to the centres of mass.
#[must_use]
pub fn chain() -> Chain<6, 1> {
    let along = Screw::prismatic([0.0, 0.0, 1.0]);
    let about = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]);
    let body = |mass, center, [xx, yy, zz, yz]: [f64; 4]| {
        let tensor = [[xx, 0.0, 0.0], [0.0, yy, yz], [0.0, yz, zz]];
        Inertia::from_tensor_at_center_of_mass(mass, center, &tensor)
    };
    let upper = body(
        9.29,
        [0.0, -0.1105, -0.0175],
        [0.159_72, 0.068_155, 0.141_57, 0.017_965],
    );
    let carriage = body(
        5.01,
        [0.0, 0.0, -0.1054],
        [0.052_343, 0.044_343, 0.018, 0.0],
    );
    let boom = body(4.25, [0.0, 0.0, -0.6447], [0.743_54, 0.743_54, 0.006, 0.0]);
    let forearm = body(
        1.08,
        [0.0, -0.0054, -0.0092],
        [0.001_677_1, 0.000_908_59, 0.000_968_51, 5.3654e-5],
    );
    let wrist = body(
        0.63,
        [0.0, -0.0566, 0.0],
        [0.000_981_76, 0.0004, 0.000_981_76, 0.0],
    );
    let hand = body(
        0.51,
        [0.0, 0.0, 0.1554],
        [0.000_683_93, 0.000_683_93, 0.0003, 0.0],
    );
    let at = |rotation, translation| Pose::new(rotation, translation);
    Chain::new(
        [
            Joint::new("waist", None, at(LEVEL, [0.0, 0.0, SHOULDER]), about, upper),
            Joint::new(
                "shoulder",
                Some(0),
                at(FORWARD, [0.0, OFFSET, 0.0]),
                about,
                carriage,
            ),
            Joint::new("boom", Some(1), at(BACK, [0.0; 3]), along, boom),
            Joint::new("forearm", Some(2), at(LEVEL, [0.0; 3]), about, forearm),
            Joint::new("wrist", Some(3), at(FORWARD, [0.0; 3]), about, wrist),
            Joint::new("hand", Some(4), at(BACK, [0.0; 3]), about, hand),
        ],
        [Frame::new("tool", Some(5), at(LEVEL, [0.0, 0.0, TOOL]))],
        [0.0, 0.0, -9.81],
    )
}

/// No rotation.
const LEVEL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// −90° about x: z of the new frame is y of the old one.
const FORWARD: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]];

/// 90° about x.
const BACK: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

/// M₀,₃: R = (x₂, y₁, z₂) with x₂ = (C₁C₂, S₁C₂, −S₂), y₁ = (−S₁, C₁, 0), z₂ = (C₁S₂, S₁S₂, C₂), and
/// t = d₂ y₁ + q₃ z₂ above the shoulder.
#[must_use]
pub fn boom_pose<T: Scalar>(q: &[T; 6]) -> Pose<T> {
    let Axes { x_2, y_1, z_2, .. } = Axes::at(q);
    let boom = add(
        scale(T::constant(OFFSET), y_1),
        add(scale(q[2], z_2), shoulder()),
    );
    let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = [x_2, y_1, z_2];
    Pose::new([[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]], boom)
}

/// M₀,tool: the boom, then the wrist, a rotation by Euler's angles q₄, q₅, q₆ about z, y, z.
#[must_use]
pub fn tool_pose<T: Scalar>(q: &[T; 6]) -> Pose<T> {
    let ([_, _, _, s_4, s_5, s_6], [_, _, _, c_4, c_5, c_6]) = T::sin_cos_all(*q);
    let tool = T::constant(TOOL);
    let hand = [c_4 * s_5, s_4 * s_5, c_5];
    let wrist = Pose::new(
        [
            [
                c_4 * c_5 * c_6 - s_4 * s_6,
                -(c_4 * c_5 * s_6) - s_4 * c_6,
                hand[0],
            ],
            [
                s_4 * c_5 * c_6 + c_4 * s_6,
                c_4 * c_6 - s_4 * c_5 * s_6,
                hand[1],
            ],
            [-(s_5 * c_6), s_5 * s_6, hand[2]],
        ],
        scale(tool, hand),
    );
    boom_pose(q) * wrist
}

/// L₀,₁₍₀₎ … L₅,₆₍₀₎.
///
/// With h the height of the shoulder and P the centre of the wrist: (z; 0), (y₁; −h x₁), (0; z₂), and
/// (u; P × u) with u = z₂, C₄ y₁ − S₄ x₂, and C₄S₅ x₂ + S₄S₅ y₁ + C₅ z₂ for the wrist.
/// The third one begins with C₁S₂ (printed C₁S₁).
#[must_use]
pub fn screws<T: Scalar>(q: &[T; 6]) -> [Screw<T>; 6] {
    let Axes {
        x_1, x_2, y_1, z_2, ..
    } = Axes::at(q);
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    let ([_, _, _, s_4, s_5, _], [_, _, _, c_4, c_5, _]) = T::sin_cos_all(*q);
    let wrist = boom_pose(q).translation();
    let at_wrist = |u: [T; 3]| Screw::new(u, cross(wrist, u));
    let z_4 = add(scale(c_4, y_1), scale(-s_4, x_2));
    let z_5 = add(
        add(scale(c_4 * s_5, x_2), scale(s_4 * s_5, y_1)),
        scale(c_5, z_2),
    );
    [
        Screw::new([zero, zero, one], [zero; 3]),
        Screw::new(y_1, scale(T::constant(-SHOULDER), x_1)),
        Screw::new([zero; 3], z_2),
        at_wrist(z_2),
        at_wrist(z_4),
        at_wrist(z_5),
    ]
}

/// W₀,₃₍₀₎: ω = (−S₁ q̇₂, C₁ q̇₂, q̇₁), v₀ = q̇₃ z₂ − h q̇₂ x₁ [rad/s, m/s].
#[must_use]
pub fn boom_velocity<T: Scalar>(q: &[T; 6], qd: &[T; 6]) -> Velocity<T> {
    let Axes { x_1, z_2, .. } = Axes::at(q);
    let ([s_1, ..], [c_1, ..]) = T::sin_cos_all(*q);
    let h = T::constant(SHOULDER);
    Velocity::new(
        [-(s_1 * qd[1]), c_1 * qd[1], qd[0]],
        add(scale(qd[2], z_2), scale(-(h * qd[1]), x_1)),
    )
}

/// H̃₀,₃₍₀₎, the acceleration of the boom at q̈ = 0 [rad/s², m/s²].
///
/// ω̇ = −q̇₁q̇₂ x₁ and
/// a₀ = 2 q̇₂q̇₃ C₂ x₁ + 2 q̇₁ (q̇₃ S₂ − h q̇₂) y₁ + q̇₂ (h q̇₂ − 2 q̇₃ S₂) z.
#[must_use]
pub fn boom_bias_acceleration<T: Scalar>(q: &[T; 6], qd: &[T; 6]) -> Acceleration<T> {
    let Axes { x_1, y_1, .. } = Axes::at(q);
    let ([_, s_2, ..], [_, c_2, ..]) = T::sin_cos_all(*q);
    let (zero, two, h) = (T::constant(0.0), T::constant(2.0), T::constant(SHOULDER));
    let a = add(
        add(
            scale(two * qd[1] * qd[2] * c_2, x_1),
            scale(two * qd[0] * (qd[2] * s_2 - h * qd[1]), y_1),
        ),
        [zero, zero, qd[1] * (h * qd[1] - two * qd[2] * s_2)],
    );
    Acceleration::from_parts(
        scale(-(qd[0] * qd[1]), x_1),
        boom_velocity(q, qd).omega(),
        a,
    )
}

/// Unit vectors in frame 0.
struct Axes<T> {
    x_1: [T; 3],
    x_2: [T; 3],
    y_1: [T; 3],
    z_2: [T; 3],
}

impl<T: Scalar> Axes<T> {
    fn at(q: &[T; 6]) -> Self {
        let zero = T::constant(0.0);
        let ([s_1, s_2, ..], [c_1, c_2, ..]) = T::sin_cos_all(*q);
        Self {
            x_1: [c_1, s_1, zero],
            x_2: [c_1 * c_2, s_1 * c_2, -s_2],
            y_1: [-s_1, c_1, zero],
            z_2: [c_1 * s_2, s_1 * s_2, c_2],
        }
    }
}

/// The centre of the shoulder \[m\].
fn shoulder<T: Scalar>() -> [T; 3] {
    [0.0, 0.0, SHOULDER].map(T::constant)
}
